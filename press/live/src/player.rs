//! A scene in use: its settings, its motion, its picture. The module of the page is a thin wrapper of it.

use crate::Cause;
use crate::control::{EARLIER, Kind, Settings, place_of};
use crate::numbers::tied;
use crate::scene::{Moment, Motion, Run, Scene};
use crate::written::written;
use drawing::{Drawing, Point, Room, with_symbols};
use std::f64::consts::TAU;

/// A scene with its settings.
pub struct Player {
    scene: &'static Scene,
    values: Vec<f64>,
    motion: Box<dyn Motion>,
    /// The moment that was drawn last, and its time if one was.
    seen: Moment,
    drawn: f64,
    /// What the reader has measured, with these settings and before.
    found: Vec<[f64; 3]>,
}

impl Player {
    /// A scene with the settings with which its page opens.
    pub fn new(scene: &'static Scene) -> Result<Self, Cause> {
        let values = scene.controls.iter().map(|control| control.start).collect();
        Self::with(scene, values)
    }

    /// A scene with these values of its controls, in their order. Behind them may stand earlier presses of buttons, four
    /// numbers each: the button's place among the controls, and a [`Press`](crate::Press).
    ///
    /// # Errors
    /// What the scene says of settings to which it has no answer; and for values that no control can have.
    pub fn with(scene: &'static Scene, values: Vec<f64>) -> Result<Self, Cause> {
        let Some((_, earlier)) = values.split_at_checked(scene.controls.len()) else {
            return Err(format!("{} values for {} controls", values.len(), scene.controls.len()).into());
        };
        let is_press = |press: &[f64]| {
            let button = scene.controls.get(press[0] as usize).map(|control| control.kind);
            matches!(button, Some(Kind::Button(Some(_))))
                && press.iter().all(|x| x.is_finite())
                && press[1] >= 0.0
        };
        if earlier.len() % EARLIER != 0 || !earlier.chunks_exact(EARLIER).all(is_press) {
            return Err("these are no presses of a button".into());
        }
        for (control, value) in scene.controls.iter().zip(&values) {
            let distance = control.nearest(*value).map(|nearest| (nearest - value).abs());
            if distance.is_none_or(|distance| distance > 1e-9 * value.abs().max(1.0)) {
                return Err(format!("{}: {value} is out of range", control.name).into());
            }
        }
        let motion = (scene.start)(&Settings { controls: scene.controls, values: &values })?;
        let [azimuth, elevation] = scene.view.unwrap_or_default();
        let seen = Moment { time: scene.still, azimuth, elevation, room: Room::Wide };
        Ok(Self { scene, values, motion, seen, drawn: f64::NAN, found: Vec::new() })
    }

    /// Takes over what the reader has measured in the same scene with other settings.
    pub fn keep(&mut self, before: &Self) {
        if self.scene.name == before.scene.name {
            self.found.clone_from(&before.found);
            self.motion.keep(&self.found);
        }
    }

    /// The scene with other values at a time, as [`with`](Self::with): what it [keeps](crate::Motion::kept) is the same
    /// there, so that nothing leaps under the hand.
    ///
    /// # Errors
    /// As for [`with`](Self::with).
    pub fn continued(&self, values: Vec<f64>, time: f64) -> Result<Self, Cause> {
        let player = Self::with(self.scene, values.clone())?;
        let [before, after] = [self, &player].map(|own| own.motion.kept(time.min(own.run().duration)));
        let mut turned = Vec::new();
        for ((name, before), (_, after)) in before?.into_iter().zip(after?) {
            let gap = (before - after + 0.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
            let value = values[place_of(self.scene.controls, name)?];
            if gap.abs() > 1e-5 {
                turned.push((name, (1e5 * (value + gap).rem_euclid(TAU)).round() / 1e5)); // as a link gives it
            }
        }
        if turned.is_empty() {
            Ok(player)
        } else {
            Self::with(self.scene, changed(self.scene, values, &turned)?)
        }
    }

    /// The scene with some settings changed.
    ///
    /// # Errors
    /// As for [`with`](Self::with), and for names that the scene does not have.
    pub fn changed(&self, settings: &[(&str, f64)]) -> Result<Self, Cause> {
        let mut player = Self::with(self.scene, changed(self.scene, self.values.clone(), settings)?)?;
        player.keep(self);
        Ok(player)
    }

    /// The scene.
    pub fn scene(&self) -> &'static Scene {
        self.scene
    }

    /// The values of its controls, in their order.
    pub fn values(&self) -> &[f64] {
        &self.values[..self.scene.controls.len()]
    }

    /// How long it runs, and how fast.
    pub fn run(&self) -> Run {
        self.motion.run()
    }

    /// The picture of a moment.
    pub fn draw(&mut self, moment: Moment) -> Result<Drawing, Cause> {
        let new = self.motion.found(self.drawn, moment.time).filter(|found| !self.found.contains(found));
        self.found.extend(new);
        (self.seen, self.drawn) = (moment, moment.time);
        let [width, height] = moment.room.of(self.scene.size[0], self.scene.size[1]);
        let id = format!("scene-{}{}", self.scene.name, moment.room.of("", "-narrow"));
        let mut drawing = Drawing::new(&id, width, height).framed();
        with_symbols(self.scene.symbols, || self.motion.draw(&moment, &mut drawing))?;
        drawing.part_labels();
        Ok(drawing)
    }

    /// The picture that stands on the page until the scene wakes, and on paper.
    pub fn still(&mut self) -> Result<Drawing, Cause> {
        let [azimuth, elevation] = self.scene.view.unwrap_or_default();
        let moment = |room| Moment { time: self.scene.still, azimuth, elevation, room };
        let [wide, narrow] = [Room::Wide, Room::Narrow].map(moment);
        let wide = self.draw(wide)?.titled(self.scene.title, self.scene.description);
        Ok(wide.with_narrow(self.draw(narrow)?))
    }

    /// The numbers beside the picture.
    ///
    /// # Errors
    /// What the scene says, and if it gives another number of readings than it has promised.
    pub fn numbers(&self, time: f64) -> Result<Vec<f64>, Cause> {
        let values = self.motion.readings(time)?;
        if values.len() != self.scene.readings.len() {
            return Err(format!("{} values for {} readings", values.len(), self.scene.readings.len()).into());
        }
        Ok(values)
    }

    /// The numbers beside the picture, as HTML.
    pub fn readings(&self, time: f64) -> Result<Vec<String>, Cause> {
        let values = self.numbers(time)?;
        let with_unit = self.scene.readings.iter().zip(values);
        Ok(with_unit.map(|(reading, value)| written(value, reading.form, reading.unit)).collect())
    }

    /// What happens, in words.
    pub fn words(&self, time: f64) -> String {
        tied(&self.motion.words(time))
    }

    /// The grips of the picture that was drawn last, px.
    pub fn grips(&self) -> Vec<Point> {
        self.motion.grips(&self.seen)
    }

    /// The values of all controls when a grip of the picture that was drawn last is drawn to a point.
    ///
    /// # Errors
    /// If the scene names a control that it does not have.
    pub fn drag(&self, grip: usize, to: Point) -> Result<Vec<f64>, Cause> {
        changed(self.scene, self.values().to_vec(), &self.motion.drag(grip, to, &self.seen))
    }
}

/// The values of a scene's controls with some changed, each brought into its range.
pub(crate) fn changed(
    scene: &Scene,
    mut values: Vec<f64>,
    settings: &[(&str, f64)],
) -> Result<Vec<f64>, Cause> {
    for (name, value) in settings {
        let place = place_of(scene.controls, name)?;
        if let Some(nearest) = scene.controls[place].nearest(*value) {
            values[place] = nearest;
        }
    }
    Ok(values)
}
