//! The live scenes of the book: what a reader changes, and what is drawn then.
//!
//! Each chapter keeps its scene in its own folder, in `scene.rs`: a [`Scene`] that says what it asks, what can be
//! changed and what is shown, and a [`Motion`] that the library computes for some settings, drawn with the shapes of
//! the figures. The build script finds and compiles those files. The picture on the page before a scene wakes (and on
//! paper) and the one that moves are drawn by the same code, here and in a browser.
//!
//! | module | holds |
//! |---|---|
//! | `scene` | what a scene is |
//! | `control` | what a reader can change |
//! | `graph` | plots in a scene |
//! | `written` | numbers as they are shown |
//! | `player` | a scene in use, which the module of the page wraps |

mod control;
mod graph;
mod numbers;
mod player;
mod scene;
mod written;

// A module for each scene, and `entries`, `ENTRIES` and `symbols`: the build script reads them off the files.
include!(concat!(env!("OUT_DIR"), "/scenes.rs"));

pub use control::{Control, Kind, Settings};
pub use drawing::Axis;
pub use drawing::Room;
pub use graph::{Graph, point_at, value_at};
pub use player::Player;
pub use scene::{Form, Moment, Motion, Preset, Reading, Run, Scene};
pub use written::{tied, written};

use std::error::Error;

/// Why something has no answer: whatever the library or the kit says.
pub type Cause = Box<dyn Error + Send + Sync>;

/// A scene in the book.
#[derive(Debug)]
pub struct Entry {
    /// Which scene of the book it is, from 0 on.
    pub place: usize,
    /// The folder of its chapter.
    pub chapter: &'static str,
    /// The scene.
    pub scene: &'static Scene,
}

/// The scenes of the book, in its order.
pub fn scenes() -> &'static [&'static Entry] {
    ENTRIES
}

/// The scene of this name, if the book has one.
pub fn scene(name: &str) -> Option<&'static Scene> {
    scenes().iter().map(|entry| entry.scene).find(|scene| scene.name == name)
}
