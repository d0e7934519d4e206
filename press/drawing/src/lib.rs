//! Shapes and labels with roles instead of colours, written as SVG.
//!
//! A [`Drawing`] is a display list: polylines, polygons, circles, arcs and labels in the order in which they
//! are painted, each with a [`Role`] (an axis, a curve in the hue of the body, a face, …). Nothing in it is a
//! colour. The page's style sheet, `press/theme/figures.css`, says what each role looks like in light and dark
//! themes and on paper.
//!
//! Coordinates are pixels of a figure at its full size, x to the right and y **downwards**. Angles are in
//! radians and counter-clockwise **as seen on the page**, from the direction to the right, so that drawn
//! angles turn like those of the text.
//!
//! A figure of panels is [`Drawing::panels`], one that needs another layout on a phone has [`Drawing::with_narrow`].
//! What dashes mean is said at [`Stroke`], what hues mean at [`Hue`].
//!
//! Solids, a camera and hidden lines live in a module of their own, [`space`], on top of the same display list.
//!
//! ```
//! use drawing::{Drawing, Hue, Role, Side, Stroke, at};
//! let mut drawing = Drawing::new("fig:orbit", 200.0, 120.0).titled("An orbit", "A circle about a fixed point.");
//! drawing.circle(at(100.0, 60.0), 40.0, Role::Line(Stroke::Orbit, Hue::Blue));
//! drawing.label(at(100.0, 60.0), Side::Below, r"radius $r_0 = b\,\Omega^2/D$", Hue::Ink)?;
//! assert!(drawing.to_svg()?.starts_with("<svg"));
//! assert!(drawing.label(at(0.0, 0.0), Side::Below, r"$\unheard$", Hue::Ink).is_err());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod axis;
mod clip;
mod drawing;
mod fit;
mod flaw;
mod ink;
pub mod kit;
mod label;
mod layout;
mod look;
mod point;
mod role;
mod sample;
mod shape;
mod simplify;
pub mod space;
mod style;
mod svg;
mod trace;

pub use axis::{Axes, Axis, Scale};
pub use clip::clip;
pub use drawing::Drawing;
pub use flaw::Flaw;
pub use ink::MARGIN;
pub use label::{Glyph, Label, Piece, Segment, Side, Symbol, with_symbols};
#[cfg(feature = "typesetter")]
pub use label::{symbols_of, tex_commands};
pub use layout::{GAP, NARROW, PANEL, Room};
pub use look::Look;
pub use point::{Point, Rect, at};
pub use role::{Fill, Hue, Role, Stroke};
pub use sample::{interpolated, linear_steps, log_steps};
pub use shape::{Item, Shape};
pub use simplify::{TOLERANCE, simplify};
