//! A ball that slides, and rolls: on a cloth, on a table that turns, inside an upright cylinder. Chapter "The ball".
//!
//! A ball has a radius a and a moment `I = k m a²`, the same about every axis. Its mass makes no difference to the
//! motion, so no scene asks for it. What touches is one point, and nothing there resists a spin about the normal.
//!
//! | place | axes of the room | motion |
//! |---|---|---|
//! | a cloth ([`Cloth`]) | z up, origin where the centre is at time zero | [`Shot`]: sliding, then rolling |
//! | a table that turns ([`Turntable`]) | z along its axis, which is the normal, x down its slope, origin on the axis at the height of the centre | [`TurntableRoll`] |
//! | a hole ([`Hole`]) | z up along its axis, x to where the centre is at time zero, at the height of the origin | [`HoleRoll`] |

mod cloth;
mod hole;
mod solid;
mod turntable;

pub use cloth::{Cloth, ClothParameters, Cue, Shot, ShotStart};
pub use hole::{Hole, HoleParameters, HoleRoll, HoleStart};
pub use solid::{Ball, BallParameters, BallState};
pub use turntable::{Circle, Turntable, TurntableParameters, TurntableRoll, TurntableStart};
