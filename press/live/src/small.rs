//! Small scenes: a motion in one function.

use crate::Cause;
use crate::scene::{Moment, Motion, Run};
use drawing::Drawing;

/// The motion of a small scene, which needs no type of its own: what [`Scene::start`](crate::Scene::start) has computed,
/// and two functions that read and draw it. It begins as `Ok(Box::new(Small { of: …, … }))`.
pub struct Small<T> {
    /// How long it runs, and how fast.
    pub run: Run,
    /// What happens: see [`Motion::words`].
    pub words: String,
    /// What has been computed.
    pub of: T,
    /// The numbers beside the picture at a time, which is one of the run.
    pub readings: fn(&T, f64) -> Result<Vec<f64>, Cause>,
    /// Draws a moment.
    pub draw: fn(&T, &Moment, &mut Drawing) -> Result<(), Cause>,
}

impl<T> Motion for Small<T> {
    fn run(&self) -> Run {
        self.run
    }

    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let time = moment.time.clamp(0.0, self.run.duration);
        (self.draw)(&self.of, &Moment { time, ..*moment }, drawing)
    }

    fn readings(&self, time: f64) -> Result<Vec<f64>, Cause> {
        (self.readings)(&self.of, time.clamp(0.0, self.run.duration))
    }

    fn words(&self, _time: f64) -> String {
        self.words.clone()
    }
}
