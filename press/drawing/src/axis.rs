//! Axes of plots: where values go, and where ticks stand.

use crate::flaw::Flaw;
use crate::point::{Point, Rect, at};

/// A scale of a plot, from the value at its beginning to that at its end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// The value at its beginning: left or below.
    pub from: f64,
    /// The value at its end: right or above.
    pub to: f64,
    /// Whether equal distances are equal ratios.
    pub logarithmic: bool,
}

impl Scale {
    /// Which part of the scale leads to a value: 0 at its beginning, 1 at its end. It is no finite number for a value
    /// that has no place there.
    pub fn part(&self, value: f64) -> f64 {
        self.part_to(self.place(value))
    }

    /// The value at a part of the scale.
    pub fn value(&self, part: f64) -> f64 {
        let [from, to] = self.ends();
        let place = from + part * (to - from);
        if self.logarithmic { 10_f64.powf(place) } else { place }
    }

    /// Where a value stands: on a logarithmic scale at its power of ten.
    fn place(&self, value: f64) -> f64 {
        if self.logarithmic { value.log10() } else { value }
    }

    fn ends(&self) -> [f64; 2] {
        [self.place(self.from), self.place(self.to)]
    }

    fn part_to(&self, place: f64) -> f64 {
        let [from, to] = self.ends();
        (place - from) / (to - from)
    }
}

/// The axes of a plot: what the places of its curves mean.
#[derive(Debug, Clone, PartialEq)]
pub struct Axes {
    /// The rectangle of the plot, px; the axes run along its lower and its left edge.
    pub frame: Rect,
    /// The scale from left to right.
    pub x: Scale,
    /// The scale from below to above.
    pub y: Scale,
    /// The names of the curves that are drawn over them.
    pub curves: Vec<String>,
}

impl Axes {
    /// Axes without curves.
    pub fn new(frame: Rect, x: Scale, y: Scale) -> Self {
        Self { frame, x, y, curves: Vec::new() }
    }

    /// Where a pair of values lies, px.
    ///
    /// ```
    /// use drawing::{Axes, Axis, Rect, at};
    /// let (x, y) = (Axis::linear(0.0, 4.0, 1.0), Axis::log(0.01, 100.0, 1));
    /// let axes = Axes::new(Rect::new(50.0, 20.0, 400.0, 200.0), x.scale, y.scale);
    /// assert_eq!(axes.point((1.0, 1.0)), at(150.0, 120.0));
    /// assert_eq!(axes.values(at(250.0, 120.0)), (2.0, 1.0));
    /// ```
    pub fn point(&self, (x, y): (f64, f64)) -> Point {
        let frame = self.frame;
        at(frame.left + self.x.part(x) * frame.width(), frame.bottom - self.y.part(y) * frame.height())
    }

    /// The pair of values that lies at a point, px.
    pub fn values(&self, point: Point) -> (f64, f64) {
        let frame = self.frame;
        let part = (frame.bottom - point.y) / frame.height();
        (self.x.value((point.x - frame.left) / frame.width()), self.y.value(part))
    }
}

/// An axis of a plot: its scale, its ticks and its title.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis<'a> {
    /// Its scale.
    pub scale: Scale,
    /// Its title; empty for none. That of an x axis stands below its right end, that of a y axis above its upper end.
    pub title: &'a str,
    /// The distances of major and of minor ticks: differences of values, or numbers of decades.
    step: f64,
    minor: Option<f64>,
    words: Words<'a>,
}

/// What stands at the major ticks.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Words<'a> {
    Numbers,
    Nothing,
    Marks(&'a [(f64, &'a str)]),
}

impl<'a> Axis<'a> {
    /// A linear axis with a major tick every `step`.
    pub const fn linear(from: f64, to: f64, step: f64) -> Self {
        Self::new(Scale { from, to, logarithmic: false }, step)
    }

    /// A logarithmic axis with a major tick every `decades` powers of ten, and minor ones at the other powers, or else
    /// between.
    pub const fn log(from: f64, to: f64, decades: u32) -> Self {
        let axis = Self::new(Scale { from, to, logarithmic: true }, decades as f64);
        if decades > 1 { axis.minor(1.0) } else { axis }
    }

    const fn new(scale: Scale, step: f64) -> Self {
        Self { scale, title: "", step, minor: None, words: Words::Numbers }
    }

    /// The axis with minor ticks every `step`: a difference, or a number of decades.
    #[must_use]
    pub const fn minor(self, step: f64) -> Self {
        Self { minor: Some(step), ..self }
    }

    /// The axis with its title.
    #[must_use]
    pub const fn titled(self, title: &'a str) -> Self {
        Self { title, ..self }
    }

    /// The axis with these labelled ticks in place of numbers.
    #[must_use]
    pub const fn marked(self, marks: &'a [(f64, &'a str)]) -> Self {
        Self { words: Words::Marks(marks), ..self }
    }

    /// The axis with ticks but no numbers, for a panel that shares its numbers with the one below.
    #[must_use]
    pub const fn unlabelled(self) -> Self {
        Self { words: Words::Nothing, ..self }
    }

    /// The major ticks: the parts of the axis where they stand, and their labels.
    ///
    /// # Errors
    /// [`Flaw`] for a range that is empty, or does not begin above zero on a logarithmic axis, or a step that
    /// gives no ticks or more than a hundred.
    ///
    /// ```
    /// use drawing::Axis;
    /// let ticks = Axis::linear(-1.0, 1.0, 0.5).ticks()?;
    /// assert_eq!(ticks[0], (0.0, "−1.0".to_owned()));
    /// assert_eq!(ticks[2], (0.5, "0".to_owned()));
    /// assert_eq!(Axis::log(1e-3, 1.0, 3).ticks()?[0].1, "10^{−3}");
    /// assert!(Axis::log(0.0, 1.0, 1).ticks().is_err());
    /// # Ok::<(), drawing::Flaw>(())
    /// ```
    pub fn ticks(&self) -> Result<Vec<(f64, String)>, Flaw> {
        let [from, to] = self.scale.ends();
        let sound = from.is_finite() && to.is_finite() && from < to;
        if !(sound && self.step > 0.0 && (to - from) / self.step <= 100.0) {
            let Scale { from, to, .. } = self.scale;
            return Err(Flaw::new(format!(
                "axis from {from} to {to}, ticks every {}: it must end beyond its beginning, a logarithmic one begin \
                 above zero, and ticks be a positive distance apart that gives at most a hundred",
                self.step
            )));
        }
        if let Words::Marks(marks) = self.words {
            return Ok(marks
                .iter()
                .map(|&(value, label)| (self.scale.part(value), label.to_owned()))
                .collect());
        }
        // As many digits after the point as the step has.
        let digits = self.step.to_string().split_once('.').map_or(0, |(_, digits)| digits.len());
        let label = |place: f64| match self.words {
            Words::Numbers if self.scale.logarithmic => power_of_ten(place),
            Words::Numbers => number(place, digits),
            _ => String::new(),
        };
        Ok(self.multiples(self.step).map(|place| (self.scale.part_to(place), label(place))).collect())
    }

    /// The minor ticks: the parts of the axis where they stand.
    pub fn minor_ticks(&self) -> Vec<f64> {
        let [from, to] = self.scale.ends();
        let places: Vec<f64> = match self.minor {
            Some(step) => self.multiples(step).take(1000).collect(),
            None if self.scale.logarithmic => {
                let between = |power: i32| (2..10).map(move |k| f64::from(power) + f64::from(k).log10());
                (from.floor() as i32..to.ceil() as i32).flat_map(between).collect()
            }
            None => Vec::new(),
        };
        places.into_iter().map(|place| self.scale.part_to(place)).collect()
    }

    fn multiples(&self, step: f64) -> impl Iterator<Item = f64> + use<> {
        let [from, to] = self.scale.ends();
        let slack = 1e-9 * (to - from) / step;
        let (first, last) = ((from / step - slack).ceil() as i64, (to / step + slack).floor() as i64);
        (first..=last).map(move |k| k as f64 * step)
    }
}

/// A number as it stands at a tick: a true minus, and zero without decimals.
fn number(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    if text.trim_matches(['-', '0', '.']).is_empty() { "0".into() } else { text.replace('-', "−") }
}

/// A power of ten as it stands at a tick.
fn power_of_ten(power: f64) -> String {
    match power as i32 {
        0 => "1".into(),
        1 => "10".into(),
        power => format!("10^{{{}}}", power.to_string().replace('-', "−")),
    }
}

#[cfg(test)]
mod tests {
    use super::Axis;

    fn labels(axis: &Axis<'_>) -> Vec<String> {
        axis.ticks().expect("an axis").into_iter().map(|(_, label)| label).collect()
    }

    #[test]
    fn linear_ticks_are_short_and_true() {
        assert_eq!(labels(&Axis::linear(-1.0, 1.0, 0.5)), ["−1.0", "−0.5", "0", "0.5", "1.0"]);
        assert_eq!(labels(&Axis::linear(0.0, 0.3, 0.1)), ["0", "0.1", "0.2", "0.3"]);
        assert_eq!(labels(&Axis::linear(0.0, 60.0, 20.0)), ["0", "20", "40", "60"]);
        assert_eq!(Axis::linear(0.0, 1.0, 0.5).minor(0.1).minor_ticks().len(), 11);
    }

    #[test]
    fn log_ticks_are_powers_of_ten_with_eight_minor_ones_between() {
        let axis = Axis::log(1e-4, 100.0, 1);
        assert_eq!(labels(&axis), ["10^{−4}", "10^{−3}", "10^{−2}", "10^{−1}", "1", "10", "10^{2}"]);
        assert_eq!(axis.minor_ticks().len(), 6 * 8);
        assert_eq!(labels(&Axis::log(1e-16, 1.0, 4)), ["10^{−16}", "10^{−12}", "10^{−8}", "10^{−4}", "1"]);
        assert_eq!(Axis::log(1e-16, 1.0, 4).minor_ticks().len(), 17);
    }

    #[test]
    fn axes_that_cannot_be_are_refused() {
        for (axis, said) in [
            (Axis::linear(1.0, 1.0, 0.1), "axis from 1 to 1, ticks every 0.1: "),
            (Axis::log(0.0, 1.0, 1), "axis from 0 to 1, ticks every 1: "),
            (Axis::log(-1.0, 1.0, 1), "axis from -1 to 1, "),
            (Axis::linear(0.0, 1.0, 1e-3), "axis from 0 to 1, ticks every 0.001: "),
            (Axis::linear(0.0, f64::NAN, 1.0), "axis from 0 to NaN, "),
        ] {
            let flaw = axis.ticks().expect_err(said).to_string();
            assert!(flaw.starts_with(said), "{flaw}");
        }
    }
}
