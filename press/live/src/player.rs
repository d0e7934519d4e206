//! A scene in use: its settings, its motion, its picture. The module of the page is a thin wrapper of it.

use crate::Cause;
use crate::control::{BEHIND, KEPT, KEPT_PRESSED, Kind, OF_KEPT, PRESSED, Settings, place_of};
use crate::numbers::tied;
use crate::scene::{Moment, Motion, Run, Scene, Sound};
use crate::written::written;
use drawing::{Drawing, Point, Room, at, with_symbols};
use std::cmp::Ordering;
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
    /// From the hand to the place of the body that it holds.
    held: Point,
}

impl Player {
    /// A scene with the settings with which its page opens.
    pub fn new(scene: &'static Scene) -> Result<Self, Cause> {
        let values = scene.controls.iter().map(|control| control.start).collect();
        Self::with(scene, values)
    }

    /// A scene with these values of its controls, in their order. Behind them may stand earlier presses of buttons, five
    /// numbers each: 0, the button's place among the controls, and a [`Press`](crate::Press). And what is kept to compare,
    /// as far as it is not the same: 1, a control's place, its value, 0, 0; and presses of its buttons with a 2.
    ///
    /// # Errors
    /// What the scene says of settings to which it has no answer; and for values that no control can have.
    pub fn with(scene: &'static Scene, values: Vec<f64>) -> Result<Self, Cause> {
        let Some((_, behind)) = values.split_at_checked(scene.controls.len()) else {
            return Err(format!("{} values for {} controls", values.len(), scene.controls.len()).into());
        };
        let is_known = |own: &[f64]| {
            let Some(control) = scene.controls.get(own[1] as usize) else { return false };
            let is_press = matches!(control.kind, Kind::Button(Some(_))) && own[2] >= 0.0;
            own.iter().all(|x| x.is_finite())
                && (own[0] == KEPT || is_press && [PRESSED, KEPT_PRESSED].contains(&own[0]))
        };
        if behind.len() % BEHIND != 0 || !behind.chunks_exact(BEHIND).all(is_known) {
            return Err("these are no presses of a button".into());
        }
        let kept = behind.chunks_exact(BEHIND).filter(|own| own[0] == KEPT);
        let kept = kept.map(|own| (&scene.controls[own[1] as usize], &own[2]));
        for (control, value) in scene.controls.iter().zip(&values).chain(kept) {
            let distance = control.nearest(*value).map(|nearest| (nearest - value).abs());
            if distance.is_none_or(|distance| distance > 1e-9 * value.abs().max(1.0)) {
                return Err(format!("{}: {value} is out of range", control.name).into());
            }
        }
        let motion = (scene.start)(&Settings { controls: scene.controls, values: &values })?;
        let [azimuth, elevation] = scene.view.unwrap_or_default();
        let seen = Moment { time: scene.still, azimuth, elevation, room: Room::Wide };
        let (drawn, found, held) = (f64::NAN, Vec::new(), at(0.0, 0.0));
        Ok(Self { scene, values, motion, seen, drawn, found, held })
    }

    /// Takes over what the reader has measured in the same scene with other settings.
    pub fn keep(&mut self, before: &Self) {
        if self.scene.name == before.scene.name {
            self.held = before.held;
            self.found.clone_from(&before.found);
            self.motion.keep(&self.found);
        }
    }

    /// The scene with other values at a time, as [`with`](Self::with): what it [keeps](crate::Motion::kept) is the same
    /// there, so that nothing leaps under the hand, unless it is what the hand has turned.
    ///
    /// # Errors
    /// As for [`with`](Self::with).
    pub fn continued(&self, values: Vec<f64>, time: f64) -> Result<Self, Cause> {
        let player = Self::with(self.scene, values.clone())?;
        let [before, after] = [self, &player].map(|own| own.motion.kept(time.min(own.run().duration)));
        let mut turned = Vec::new();
        for ((name, before), (_, after)) in before?.into_iter().zip(after?) {
            let gap = (before - after + 0.5 * TAU).rem_euclid(TAU) - 0.5 * TAU;
            let place = place_of(self.scene.controls, name)?;
            let value = values[place];
            if gap.abs() > 1e-5 && value == self.values[place] {
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

    /// The least elevation from which it can be looked at, rad.
    pub fn lowest_eye(&self) -> f64 {
        self.motion.lowest_eye()
    }

    /// The picture of a moment.
    pub fn draw(&mut self, moment: Moment) -> Result<Drawing, Cause> {
        let mut drawing = self.sheet(moment.room);
        self.draw_behind(moment.room, &mut drawing)?;
        self.draw_front(moment, &mut drawing)?;
        Ok(drawing)
    }

    /// The elements of what stands behind the picture at every moment, one a line.
    pub fn behind(&self, room: Room) -> Result<String, Cause> {
        let mut behind = self.sheet(room);
        self.draw_behind(room, &mut behind)?;
        Ok(behind.to_elements()?)
    }

    /// The elements of the picture of a moment, one a line, without what is [`behind`](Self::behind) it.
    pub fn elements(&mut self, moment: Moment) -> Result<String, Cause> {
        let mut front = self.sheet(moment.room);
        self.draw_front(moment, &mut front)?;
        Ok(front.to_elements()?)
    }

    /// An empty drawing in the size of the scene.
    fn sheet(&self, room: Room) -> Drawing {
        let [width, height] = room.of(self.scene.size[0], self.scene.size[1]);
        let id = format!("scene-{}{}", self.scene.name, room.of("", "-narrow"));
        Drawing::new(&id, width, height).framed()
    }

    fn draw_behind(&self, room: Room, drawing: &mut Drawing) -> Result<(), Cause> {
        with_symbols(self.scene.symbols, || self.motion.draw_behind(room, drawing))
    }

    fn draw_front(&mut self, moment: Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let moment = Moment { elevation: moment.elevation.max(self.lowest_eye()), ..moment };
        let new = self.motion.found(self.drawn, moment.time).filter(|found| !self.found.contains(found));
        self.found.extend(new);
        (self.seen, self.drawn) = (moment, moment.time);
        let behind = drawing.items().len();
        with_symbols(self.scene.symbols, || self.motion.draw(&moment, drawing))?;
        drawing.part_labels(behind);
        Ok(())
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

    /// What is heard at a time.
    pub fn sound(&self, time: f64) -> Option<Sound> {
        self.motion.sound(time)
    }

    /// The grips of the picture that was drawn last, px.
    pub fn grips(&self) -> Vec<Point> {
        self.motion.grips(&self.seen)
    }

    /// Where a hand can take hold of a body in the picture that was drawn last, and how far around, px.
    pub fn bodies(&self) -> Vec<(Point, f64)> {
        self.motion.bodies(&self.seen)
    }

    /// What a hand takes hold of at a point, px: the nearest grip within reach, or else a body, whose places stand behind
    /// those of the grips.
    pub fn hold(&mut self, hand: Point, reach: f64) -> Option<usize> {
        let grips = self.grips().into_iter().map(|grip| (grip, reach));
        let all = grips.chain(self.bodies()).enumerate();
        let near = all.map(|(index, (place, reach))| (index, place, (place - hand).length() / reach));
        let count = self.grips().len();
        let held = near.filter(|(.., distance)| *distance <= 1.0).min_by(|one, other| {
            (one.0 >= count, one.2).partial_cmp(&(other.0 >= count, other.2)).unwrap_or(Ordering::Equal)
        });
        let (index, place, _) = held?;
        self.held = if index < count { at(0.0, 0.0) } else { place - hand };
        Some(index)
    }

    /// The values of all controls when a grip of the picture that was drawn last is drawn to a point.
    ///
    /// # Errors
    /// If the scene names a control that it does not have.
    pub fn drag(&self, grip: usize, to: Point) -> Result<Vec<f64>, Cause> {
        let to = if grip < self.grips().len() { to } else { to + self.held };
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
        let own = name.strip_prefix(OF_KEPT);
        let place = place_of(scene.controls, own.unwrap_or(name))?;
        match scene.controls[place].nearest(*value) {
            Some(nearest) if own.is_some() => values.extend([KEPT, place as f64, nearest, 0.0, 0.0]),
            Some(nearest) => values[place] = nearest,
            None => {}
        }
    }
    Ok(values)
}
