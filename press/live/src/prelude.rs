//! What a scene uses, in one line: `use live::prelude::*;`.

pub use crate::{
    Axis, Cause, Control, Form, Graph, Moment, Motion, Plot, Preset, Press, Reading, Run, Scene, Settings,
    Small, Sound, cover_from, formulas, nearest, nice_step, preset, reading,
};
pub use drawing::kit::{self, Heads, Marker};
pub use drawing::space::{Camera, Curve, Finish, Hiding, Solid, Stage};
pub use drawing::{
    Drawing, Fill, Flaw, Hue, Item, Look, Point, Rect, Role, Room, Shape, Side, Stroke, at, interpolated,
    linear_steps, log_steps,
};
pub use std::f64::consts::{FRAC_PI_2, PI, TAU};
