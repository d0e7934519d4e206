//! What a reader can change.

use crate::scene::Form;
use crate::{Cause, written};

/// Something that a reader can change. Its value is a number, whatever it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Control {
    /// Its name in links and presets, lower-case with hyphens: `spin`.
    pub name: &'static str,
    /// What stands beside it: words, with formulas between `$` signs.
    pub words: &'static str,
    /// What kind of thing it is.
    pub kind: Kind,
    /// Its value when the page opens.
    pub start: f64,
    /// If it does something only while another control is between two values: that one's name, and the two.
    pub when: Option<(&'static str, [f64; 2])>,
}

/// The kinds of controls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// A slider, from a value to a value, both included, in steps from the first.
    Slider {
        /// The least value.
        from: f64,
        /// The greatest value.
        to: f64,
        /// The step.
        step: f64,
        /// The unit, as printed: `rad/s`, `°`; empty for pure numbers.
        unit: &'static str,
    },
    /// A slider over powers of ten: equal ways are equal ratios. Its value has three digits.
    LogSlider {
        /// The least value, above zero.
        from: f64,
        /// The greatest value.
        to: f64,
        /// The unit, as printed.
        unit: &'static str,
    },
    /// One of several; the value is its place in the list.
    Choice(&'static [&'static str]),
    /// On (1) or off (0).
    Switch,
    /// A button. Its value is the scene's time at which it was pressed last, s, or −1. If its presses add up, each with
    /// what went before it: the controls, two at most, that say how strong a press is.
    Button(Option<&'static [&'static str]>),
    /// An angle, rad, that no reader sets: the scene turns by it, so that nothing leaps when another control is changed.
    /// See [`Motion::kept`](crate::Motion::kept).
    Kept,
}

/// A press of a button: the scene's time, s, and how strong it was by the controls that say so, or zeros.
pub type Press = [f64; 3];

/// What stands behind the values of the controls, five numbers each: what it is, the place of a control, and a press of
/// this button before its last or, of what is kept to compare, the value of this control or such a press.
pub(crate) const BEHIND: usize = 5;
pub(crate) const PRESSED: f64 = 0.0;
pub(crate) const KEPT: f64 = 1.0;
pub(crate) const KEPT_PRESSED: f64 = 2.0;

/// What stands before the name of a control of which the kept value is meant: `kept.spin`.
pub(crate) const OF_KEPT: &str = "kept.";

impl Control {
    /// A slider.
    pub const fn slider(
        name: &'static str,
        words: &'static str,
        [from, to, step]: [f64; 3],
        unit: &'static str,
        start: f64,
    ) -> Self {
        Self { name, words, kind: Kind::Slider { from, to, step, unit }, start, when: None }
    }

    /// A slider over powers of ten.
    pub const fn log_slider(
        name: &'static str,
        words: &'static str,
        [from, to]: [f64; 2],
        unit: &'static str,
        start: f64,
    ) -> Self {
        Self { name, words, kind: Kind::LogSlider { from, to, unit }, start, when: None }
    }

    /// A choice; the first is taken when the page opens.
    pub const fn choice(name: &'static str, words: &'static str, choices: &'static [&'static str]) -> Self {
        Self { name, words, kind: Kind::Choice(choices), start: 0.0, when: None }
    }

    /// A switch.
    pub const fn switch(name: &'static str, words: &'static str, is_on: bool) -> Self {
        Self { name, words, kind: Kind::Switch, start: if is_on { 1.0 } else { 0.0 }, when: None }
    }

    /// A button.
    pub const fn button(name: &'static str, words: &'static str) -> Self {
        Self { name, words, kind: Kind::Button(None), start: -1.0, when: None }
    }

    /// A button whose presses add up, and the controls that say how strong each is.
    pub const fn adding(name: &'static str, words: &'static str, strengths: &'static [&'static str]) -> Self {
        Self { kind: Kind::Button(Some(strengths)), ..Self::button(name, words) }
    }

    /// An angle that the scene keeps.
    pub const fn kept(name: &'static str) -> Self {
        Self { name, words: "", kind: Kind::Kept, start: 0.0, when: None }
    }

    /// A switch by which a reader keeps the present motion, to be drawn pale beside that with other settings: see
    /// [`Settings::kept`]. Presets and links may name what is kept: `kept=1&kept.spin=20`, the rest as it is.
    pub const KEEP: Self = Self::switch("kept", "keep this motion, to compare", false);

    /// The same, of no effect but while another control is between two values: a reader cannot move it then.
    pub const fn when(self, other: &'static str, between: [f64; 2]) -> Self {
        Self { when: Some((other, between)), ..self }
    }

    /// Its unit, as printed; empty for pure numbers, and for what is no slider.
    pub fn unit(&self) -> &'static str {
        match self.kind {
            Kind::Slider { unit, .. } | Kind::LogSlider { unit, .. } => unit,
            _ => "",
        }
    }

    /// A value of a slider with its unit, as HTML: as many digits as its step has, or three that count.
    pub fn shown(&self, value: f64) -> String {
        let digits = match self.kind {
            Kind::Slider { step, .. } => {
                step.to_string().split_once('.').map_or(0, |(_, digits)| digits.len())
            }
            Kind::LogSlider { .. } => (2.0 - value.log10().floor()).clamp(0.0, 15.0) as usize,
            _ => 0,
        };
        written(value, Form::Fixed(digits), self.unit())
    }

    /// The nearest value that the control can have; none for what is no number.
    pub fn nearest(&self, value: f64) -> Option<f64> {
        let nearest = match self.kind {
            Kind::Slider { from, to, step, .. } => {
                let stepped = from + ((value.clamp(from, to) - from) / step).round() * step;
                // -10 and 82 steps of 0.1 are -1.8, whatever is lost in between.
                (stepped * 1e9).round() / 1e9
            }
            Kind::LogSlider { from, to, .. } => value.clamp(from, to),
            Kind::Choice(choices) => value.round().clamp(0.0, choices.len() as f64 - 1.0),
            Kind::Switch => f64::from(value != 0.0),
            Kind::Button(_) => value.max(-1.0),
            Kind::Kept => value,
        };
        nearest.is_finite().then_some(nearest)
    }
}

/// Where a control stands among those of its scene.
pub(crate) fn place_of(controls: &[Control], name: &str) -> Result<usize, Cause> {
    let place = controls.iter().position(|control| control.name == name);
    place.ok_or_else(|| format!("the scene has no control `{name}`").into())
}

/// What a scene is set to. It answers with an error if the scene has no control of the name.
#[derive(Debug, Clone, Copy)]
pub struct Settings<'a> {
    pub(crate) controls: &'a [Control],
    pub(crate) values: &'a [f64],
}

impl Settings<'_> {
    /// The value of a control.
    pub fn of(&self, name: &str) -> Result<f64, Cause> {
        Ok(self.values[place_of(self.controls, name)?])
    }

    /// Which of several was chosen, from 0 on.
    pub fn choice(&self, name: &str) -> Result<usize, Cause> {
        Ok(self.of(name)? as usize)
    }

    /// Whether a switch is on.
    pub fn is_on(&self, name: &str) -> Result<bool, Cause> {
        Ok(self.of(name)? != 0.0)
    }

    /// When a button was pressed last, s of the scene.
    pub fn pressed(&self, name: &str) -> Result<Option<f64>, Cause> {
        Ok(Some(self.of(name)?).filter(|time| *time >= 0.0))
    }

    /// What a scene makes of the settings that the reader has kept to compare with the present ones; nothing if none
    /// are, or if they have no answer.
    pub fn kept<M>(&self, make: impl FnOnce(&Settings<'_>) -> Result<M, Cause>) -> Option<M> {
        let (present, behind) = self.values.split_at(self.controls.len());
        let keep = place_of(self.controls, Control::KEEP.name).ok().filter(|&place| present[place] != 0.0)?;
        let mut values = present.to_vec();
        values[keep] = 0.0;
        for own in behind.chunks_exact(BEHIND) {
            match own[0] {
                KEPT => values[own[1] as usize] = own[2],
                KEPT_PRESSED => values.extend([PRESSED, own[1], own[2], own[3], own[4]]),
                _ => {}
            }
        }
        make(&Settings { controls: self.controls, values: &values }).ok()
    }

    /// The presses of a button whose presses add up, in the order of their times. The last is as strong as the
    /// controls say now, those before it as strong as they were then.
    pub fn presses(&self, name: &str) -> Result<Vec<Press>, Cause> {
        let place = place_of(self.controls, name)?;
        let behind = self.values[self.controls.len()..].chunks_exact(BEHIND);
        let own = behind.filter(|press| press[..2] == [PRESSED, place as f64]);
        let mut presses: Vec<Press> = own.map(|press| [press[2], press[3], press[4]]).collect();
        if let (Some(time), Kind::Button(strengths)) = (self.pressed(name)?, self.controls[place].kind) {
            let mut press = [time, 0.0, 0.0];
            for (slot, strength) in press[1..].iter_mut().zip(strengths.unwrap_or_default()) {
                *slot = self.of(strength)?;
            }
            // Only a link can have it earlier than another. (To sort them all costs a page more bytes than this.)
            let place = presses.iter().rposition(|own| own[0] <= time).map_or(0, |before| before + 1);
            presses.insert(place, press);
        }
        Ok(presses)
    }
}
