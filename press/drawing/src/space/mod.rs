//! Solids, curves and vectors in space, seen through a camera, with what is hidden drawn dashed or left out.
//!
//! A [`Stage`] collects [`Solid`]s, [`Curve`]s, arrows, points and labels in world coordinates and writes
//! them into a [`Drawing`](crate::Drawing) in the right order. The world is right-handed, z points up,
//! lengths have any unit; angles are in rad. Points and directions are anything that turns into `[f64; 3]`,
//! such as arrays and the vectors of nalgebra.
//!
//! **What is hidden.** Lines are hidden by solids, exactly: each solid knows in closed form the boundaries of
//! what it hides, and every line is divided there. What lies on a surface is seen from outside, with a
//! tolerance of 0.3 % of the solid's least thickness. Grounds and other lines hide nothing.
//!
//! **What is painted over what.** Solids are painted from back to front; which of two is in front is asked of
//! lines of sight that meet both. A rod that pierces other solids (a shaft through a plate, an axle through a
//! sphere) is divided where it enters and leaves them, so that the part in front covers them and they cover
//! the rest; a ring that is threaded is divided into sectors. Two solids that cut through each other in
//! another way, as two rods that cross in a point, are painted one over the other: lines remain right, areas
//! do not.
//!
//! **What is refused.** Everything is checked when it is given. A [`Flaw`](crate::Flaw) tells of a number that is infinite
//! or none, a direction without length, a length that is not positive, points that coincide, a label that cannot be set,
//! and of what lies behind the eye; what else is refused stands beside it.
//!
//! **What shows motion.** [`Stage::turning`] is an arrow that turns about an axis, [`Finish::Ghost`] a body
//! at another time, for stills; [`Stage::ground`] is a floor with its grid, [`Stage::patch`] a picture on a
//! face. A path of many turns about a sphere is heavy in front and pale behind with
//! [`Stroke::Curve`](crate::Stroke::Curve) and [`Hiding::Pale`].
//!
//! ```
//! use drawing::{Drawing, Hue, at, space::{Camera, Solid, Stage, View}};
//! let camera = Camera::new(View {
//!     target: [0.0; 3], azimuth: -1.2, elevation: 0.4, distance: 8.0, centre: at(150.0, 160.0), scale: 80.0,
//! })?;
//! let mut stage = Stage::new(camera);
//! let tilt = 0.6_f64;
//! stage.solid(Solid::disc([0.0; 3], [-tilt.sin(), 0.0, tilt.cos()], 1.0, 0.08)?, Hue::Blue)?;
//! stage.solid(Solid::rod([0.0, 0.0, -1.3], [0.0, 0.0, 1.2], 0.05)?.dashed(), Hue::Ink)?;
//! stage.named_vector([0.0, 0.0, 1.2], [0.0, 0.0, 1.8], r"$\boldsymbol\omega$", Hue::Orange)?;
//! let mut drawing = Drawing::new("fig:plate", 300.0, 300.0).titled("A plate", "A tilted plate on a shaft.");
//! stage.write(&mut drawing);
//! let svg = drawing.to_svg()?;
//! assert!(svg.contains("f-hidden f-ink"), "the shaft behind the plate is dashed");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod camera;
mod checks;
mod cone;
mod curve;
mod ellipsoid;
mod form;
mod hide;
mod ink;
mod marks;
mod order;
mod pierce;
mod ray;
mod rim;
mod solid;
mod stage;
mod track;
mod tube;
mod vector;

pub use camera::{Camera, View};
pub use curve::{Curve, Hiding};
pub use solid::{Finish, Solid};
pub use stage::Stage;
pub use vector::Place;
