//! What a scene is.

use crate::control::{Control, Settings};
use crate::{Axis, Cause, Graph};
use drawing::space::{Camera, View};
use drawing::{Drawing, Flaw, Point, Rect, Room, Symbol};
use std::f64::consts::FRAC_PI_2;

/// A live scene: everything about it that does not move.
#[derive(Debug, Clone, Copy)]
pub struct Scene {
    /// The file that holds it: `file!()`.
    pub file: &'static str,
    /// Its name: `turning` for `scene:turning`.
    pub name: &'static str,
    /// A short title, for those who cannot see it.
    pub title: &'static str,
    /// What its still shows, for those who cannot see it.
    pub description: &'static str,
    /// What it asks: a sentence or two, with formulas between `$` signs.
    pub question: &'static str,
    /// Its size on a page and on a phone (at most 400 px wide), px.
    pub size: [[f64; 2]; 2],
    /// Where the eye stands at first, azimuth and elevation in rad, if a reader can turn the view.
    pub view: Option<[f64; 2]>,
    /// The time that the still shows, s of the scene.
    pub still: f64,
    /// What a reader can change.
    pub controls: &'static [Control],
    /// Settings that the text talks about.
    pub presets: &'static [Preset],
    /// Numbers that stand beside the picture.
    pub readings: &'static [Reading],
    /// The formulas of its labels, set: [`formulas![r"\omega"]`](crate::formulas).
    pub symbols: &'static [Symbol],
    /// Computes the motion for some settings. An error is words for the reader: what has no answer there, and why.
    pub start: fn(&Settings<'_>) -> Result<Box<dyn Motion>, Cause>,
}

/// Settings with a name. What is not mentioned goes back to its start.
#[derive(Debug, Clone, Copy)]
pub struct Preset {
    /// The words on its button.
    pub words: &'static str,
    /// Names of controls and their values.
    pub settings: &'static [(&'static str, f64)],
}

/// A row of [`Scene::presets`]: the words on its button, and names of controls with their values.
pub const fn preset(words: &'static str, settings: &'static [(&'static str, f64)]) -> Preset {
    Preset { words, settings }
}

/// A number that is shown and goes with the motion.
#[derive(Debug, Clone, Copy)]
pub struct Reading {
    /// What it is: words, with formulas between `$` signs.
    pub words: &'static str,
    /// How it is written.
    pub form: Form,
    /// Its unit, as printed; empty for pure numbers.
    pub unit: &'static str,
}

/// A row of [`Scene::readings`]: what it is, how it is written, and its unit.
pub const fn reading(words: &'static str, form: Form, unit: &'static str) -> Reading {
    Reading { words, form, unit }
}

/// How a number is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// With so many digits after the point.
    Fixed(usize),
    /// With so many digits in all: with a power of ten where it is smaller than a thousandth, or has more
    /// before its point.
    Digits(usize),
    /// With a power of ten and so many digits: a drift.
    Power(usize),
}

/// The motion for some settings. Times are seconds of the scene.
pub trait Motion {
    /// How long it runs, and how fast.
    fn run(&self) -> Run;

    /// Draws what stands behind all else and is the same at every time, from wherever one looks: the axes of a plot and the
    /// curves that do not move. A page draws it once for each setting, which saves time where there is much of it.
    ///
    /// # Errors
    /// As for [`draw`](Self::draw).
    fn draw_behind(&self, _room: Room, _drawing: &mut Drawing) -> Result<(), Cause> {
        Ok(())
    }

    /// Draws a moment.
    ///
    /// # Errors
    /// What the library or the kit says; the page shows it in place of the words.
    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause>;

    /// The numbers beside the picture, in the order of [`Scene::readings`].
    fn readings(&self, time: f64) -> Result<Vec<f64>, Cause>;

    /// What happens, in a sentence or two: the answer to the question for these settings. It is read aloud to those
    /// who cannot see when settings change, so it should not change with every moment.
    fn words(&self, time: f64) -> String;

    /// The least elevation from which it can be looked at, rad: the slider of the view ends there.
    fn lowest_eye(&self) -> f64 {
        -FRAC_PI_2
    }

    /// What is heard at a time, if a reader asks for it; a scene that ever sounds does so at its still.
    fn sound(&self, _time: f64) -> Option<Sound> {
        None
    }

    /// The angles at a time, rad, that are to be the same when a reader changes a setting then, each with the name of the
    /// [`Kept`](crate::Kind::Kept) control by which the scene turns it.
    fn kept(&self, _time: f64) -> Result<Vec<(&'static str, f64)>, Cause> {
        Ok(Vec::new())
    }

    /// What a reader has measured who has watched from a time to another: numbers that mean something to this scene.
    fn found(&self, _from: f64, _to: f64) -> Option<[f64; 3]> {
        None
    }

    /// Takes over what was measured with other settings, to be shown beside what is.
    fn keep(&mut self, _found: &[[f64; 3]]) {}

    /// Where a hand can take hold of something, in the picture of a moment, px.
    fn grips(&self, _moment: &Moment) -> Vec<Point> {
        Vec::new()
    }

    /// Where a hand can take hold of a body itself, in the picture that was drawn last, and how far around, px: without a
    /// mark, as one would. For [`drag`](Self::drag) they are behind the grips.
    fn bodies(&self, _moment: &Moment) -> Vec<(Point, f64)> {
        Vec::new()
    }

    /// The settings that follow when the grip of this index is drawn to a point: names of controls and values, which
    /// are brought into their range.
    fn drag(&self, _grip: usize, _to: Point, _moment: &Moment) -> Vec<(&'static str, f64)> {
        Vec::new()
    }
}

/// A tone with overtones: what moves strikes or passes something so often.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sound {
    /// How often, Hz: by the true clock of what is shown, however the scene is slowed.
    pub frequency: f64,
    /// How loud, from 0, silence, to 1.
    pub loudness: f64,
}

/// How long a motion runs, and how fast.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Run {
    /// How long, s of the scene.
    pub duration: f64,
    /// Seconds of the scene that pass in a second of the reader.
    pub pace: f64,
    /// Whether it begins again at its end.
    pub repeats: bool,
}

/// A moment, and how it is looked at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// The time, s of the scene.
    pub time: f64,
    /// Where the eye stands, rad; see [`View`].
    pub azimuth: f64,
    /// See [`azimuth`](Self::azimuth).
    pub elevation: f64,
    /// The page or the phone.
    pub room: Room,
}

impl Moment {
    /// A camera where the reader has put it: it looks at a target in the world from a distance, both in units of the
    /// world; the target lands in `centre`, and a unit there is `scale` px long. See [`View`].
    pub fn camera(
        &self,
        target: impl Into<[f64; 3]>,
        distance: f64,
        centre: Point,
        scale: f64,
    ) -> Result<Camera, Flaw> {
        let Self { azimuth, elevation, .. } = *self;
        Camera::new(View { target: target.into(), azimuth, elevation, distance, centre, scale })
    }

    /// A plot whose frame on a page and on a phone is given by its left edge, its top, its width and its height, px.
    ///
    /// # Errors
    /// As for [`Graph::new`].
    pub fn graph<'a>(
        &self,
        drawing: &'a mut Drawing,
        frames: [[f64; 4]; 2],
        x: Axis<'_>,
        y: Axis<'_>,
    ) -> Result<Graph<'a>, Cause> {
        let [left, top, width, height] = self.room.of(frames[0], frames[1]);
        Graph::new(drawing, Rect::new(left, top, width, height), x, y)
    }

    /// The same moment, seen from a fixed azimuth and elevation, rad.
    #[must_use]
    pub fn seen_from(&self, azimuth: f64, elevation: f64) -> Self {
        Self { azimuth, elevation, ..*self }
    }

    /// The direction from the target to the eye, of length 1.
    pub fn towards_eye(&self) -> [f64; 3] {
        let ((sin, cos), (up, across)) = (self.azimuth.sin_cos(), self.elevation.sin_cos());
        [cos * across, sin * across, up]
    }

    /// How far a direction points to the right on the page.
    pub fn rightward(&self, direction: impl Into<[f64; 3]>) -> f64 {
        let ((sin, cos), [x, y, _]) = (self.azimuth.sin_cos(), direction.into());
        y * cos - x * sin
    }
}
