//! Live scenes and live numbers: what a reader changes in a page, and what is drawn and printed then.
//!
//! Each chapter keeps its scene in its own folder, in `scene.rs`: a [`Scene`] that says what it asks, what can be
//! changed and what is shown, and a [`Motion`] that the library computes for some settings, drawn with the shapes of
//! the figures. The picture on the page before a scene wakes (and on paper) and the one that moves are drawn by the
//! same code, here and in a browser.

mod control;
mod graph;
pub mod limit;
pub mod module;
pub mod numbers;
mod player;
pub mod prelude;
mod scene;
mod small;
pub mod snippet;
mod written;

#[doc(hidden)]
pub use approx;
pub use control::{Control, Kind, Press, Settings};
pub use drawing::{Axis, Room};
pub use formulas::formulas;
pub use graph::{Graph, Plot, cover_from, nearest, nice_step};
pub use player::Player;
pub use scene::{Form, Moment, Motion, Preset, Reading, Run, Scene, Sound, preset, reading};
pub use small::Small;
pub use written::written;

use std::error::Error;

/// Why something has no answer: whatever the library or the kit says.
pub type Cause = Box<dyn Error + Send + Sync>;
