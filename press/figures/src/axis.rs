//! Axes: where values go, and where ticks stand.

use crate::failure::InvalidAxis;
use plotters::coord::ranged1d::Ranged;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::{IntoLogRange, LogCoord};

/// The coordinates of plotters are whole numbers: a thousandth of a pixel here.
const UNITS_PER_PIXEL: f64 = 1000.0;

/// A tick: its value, and its label if it is a major one.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tick {
    pub(crate) value: f64,
    pub(crate) label: Option<String>,
}

/// An axis of a plot: its range, its scale, its ticks and its title.
#[derive(Debug, Clone)]
pub struct Axis {
    from: f64,
    to: f64,
    logarithmic: bool,
    major: f64,
    minor: Option<f64>,
    marks: Vec<(f64, String)>,
    labelled: bool,
    pub(crate) title: Option<String>,
}

impl Axis {
    /// A linear axis with a major tick every `step`.
    ///
    /// # Errors
    /// [`InvalidAxis`] for an empty range, or a step that gives no ticks or more than a hundred.
    pub fn linear(from: f64, to: f64, step: f64) -> Result<Self, InvalidAxis> {
        Self::new(from, to, step, false)
    }

    /// A logarithmic axis with a major tick every `decades` powers of ten.
    ///
    /// # Errors
    /// [`InvalidAxis`] for a range that is empty or does not begin above zero.
    pub fn log(from: f64, to: f64, decades: u32) -> Result<Self, InvalidAxis> {
        if from.is_nan() || from <= 0.0 {
            return Err(InvalidAxis::NotPositive { from });
        }
        Self::new(from, to, f64::from(decades), true)
    }

    fn new(from: f64, to: f64, major: f64, logarithmic: bool) -> Result<Self, InvalidAxis> {
        if !(from.is_finite() && to.is_finite() && from < to) {
            return Err(InvalidAxis::Range { from, to });
        }
        let length = if logarithmic { (to / from).log10() } else { to - from };
        if !(major > 0.0 && length / major <= 100.0) {
            return Err(InvalidAxis::Step { step: major });
        }
        Ok(Self { from, to, logarithmic, major, minor: None, marks: Vec::new(), labelled: true, title: None })
    }

    /// The axis with minor ticks every `step` (linear axes; logarithmic ones have theirs by themselves). A step that is not
    /// positive, or that would give more than a thousand ticks, gives none.
    #[must_use]
    pub fn minor(self, step: f64) -> Self {
        let usable = step > 0.0 && (self.to - self.from) / step <= 1000.0;
        Self { minor: usable.then_some(step), ..self }
    }

    /// The axis with its title. The title of an x axis stands below its right end, that of a y axis above its upper end.
    #[must_use]
    pub fn titled(self, title: &str) -> Self {
        Self { title: Some(title.into()), ..self }
    }

    /// The axis with these labelled ticks in place of numbers.
    #[must_use]
    pub fn marked(self, marks: &[(f64, &str)]) -> Self {
        Self { marks: marks.iter().map(|&(value, label)| (value, label.to_owned())).collect(), ..self }
    }

    /// The axis with ticks but no numbers, for a panel that shares its numbers with the one below.
    #[must_use]
    pub fn unlabelled(self) -> Self {
        Self { labelled: false, ..self }
    }

    /// Where the axis begins.
    pub fn from(&self) -> f64 {
        self.from
    }

    /// Where the axis ends.
    pub fn to(&self) -> f64 {
        self.to
    }

    /// Where a value goes between the pixels `start` and `end`; NaN for what no such axis can show.
    pub(crate) fn place(&self, value: f64, start: f64, end: f64) -> f64 {
        if !value.is_finite() || (self.logarithmic && value <= 0.0) {
            return f64::NAN;
        }
        // Values far outside would leave the range of the whole numbers; the plot cuts them at its frame anyway.
        let limits = (0, ((end - start).abs() * UNITS_PER_PIXEL).round() as i32);
        let units = if self.logarithmic {
            let margin = (self.to / self.from).powi(4);
            let value = value.clamp(self.from / margin, self.to * margin);
            LogCoord::from((self.from..self.to).log_scale()).map(&value, limits)
        } else {
            let margin = 100.0 * (self.to - self.from);
            let value = value.clamp(self.from - margin, self.to + margin);
            RangedCoordf64::from(self.from..self.to).map(&value, limits)
        };
        start + f64::from(units) / UNITS_PER_PIXEL * (end - start).signum()
    }

    /// Major ticks with labels, then minor ones without, each in order.
    pub(crate) fn ticks(&self) -> Vec<Tick> {
        let major: Vec<(f64, String)> = if !self.marks.is_empty() {
            self.marks.clone()
        } else if self.logarithmic {
            self.decades(self.major as i32).map(|power| (10_f64.powi(power), power_of_ten(power))).collect()
        } else {
            let digits = decimals(self.major);
            self.multiples(self.major).map(|value| (value, number(value, digits))).collect()
        };
        let minor: Vec<f64> = match (self.logarithmic, self.minor) {
            (true, _) if self.major > 1.0 => self.decades(1).map(|power| 10_f64.powi(power)).collect(),
            (true, _) => {
                let first = self.from.log10().floor() as i32;
                let last = self.to.log10().ceil() as i32;
                let all =
                    (first..last).flat_map(|power| (2..10).map(move |k| f64::from(k) * 10_f64.powi(power)));
                all.filter(|value| (self.from..=self.to).contains(value)).collect()
            }
            (false, Some(step)) => self.multiples(step).collect(),
            (false, None) => Vec::new(),
        };
        let near = |a: f64, b: f64| (self.place(a, 0.0, 1000.0) - self.place(b, 0.0, 1000.0)).abs() < 0.5;
        let minor = minor.into_iter().filter(|&value| !major.iter().any(|&(other, _)| near(value, other)));
        let minor: Vec<Tick> = minor.map(|value| Tick { value, label: None }).collect();
        let label = |text| Some(if self.labelled { text } else { String::new() });
        major.into_iter().map(|(value, text)| Tick { value, label: label(text) }).chain(minor).collect()
    }

    fn multiples(&self, step: f64) -> impl Iterator<Item = f64> {
        let slack = 1e-9 * (self.to - self.from) / step;
        let first = (self.from / step - slack).ceil() as i64;
        let last = (self.to / step + slack).floor() as i64;
        (first..=last).map(move |k| k as f64 * step)
    }

    fn decades(&self, every: i32) -> impl Iterator<Item = i32> {
        let first = (self.from.log10() - 1e-9).ceil() as i32;
        let last = (self.to.log10() + 1e-9).floor() as i32;
        (first..=last).filter(move |power| power.rem_euclid(every) == 0)
    }
}

/// How many digits after the point the multiples of a step need.
fn decimals(step: f64) -> usize {
    (0..6)
        .find(|&digits| {
            let scaled = step * 10_f64.powi(digits);
            (scaled - scaled.round()).abs() < 1e-9 * scaled
        })
        .map_or(6, |digits| digits as usize)
}

/// A number as it stands at a tick: a true minus, and zero without decimals.
fn number(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    if text.trim_matches(['-', '0', '.']).is_empty() { "0".into() } else { text.replace('-', "−") }
}

/// A power of ten as it stands at a tick.
fn power_of_ten(power: i32) -> String {
    match power {
        0 => "1".into(),
        1 => "10".into(),
        _ => format!("10^{{{}}}", power.to_string().replace('-', "−")),
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, Tick};
    use crate::failure::InvalidAxis;

    fn majors(axis: &Axis) -> Vec<String> {
        axis.ticks().into_iter().filter_map(|tick| tick.label).collect()
    }

    #[test]
    fn linear_ticks_are_short_and_true() -> Result<(), InvalidAxis> {
        assert_eq!(majors(&Axis::linear(-1.0, 1.0, 0.5)?), ["−1.0", "−0.5", "0", "0.5", "1.0"]);
        assert_eq!(majors(&Axis::linear(0.0, 0.3, 0.1)?), ["0", "0.1", "0.2", "0.3"]);
        assert_eq!(majors(&Axis::linear(0.0, 60.0, 20.0)?), ["0", "20", "40", "60"]);
        let minor = Axis::linear(0.0, 1.0, 0.5)?.minor(0.1).ticks();
        assert_eq!(minor.iter().filter(|tick| tick.label.is_none()).count(), 8);
        Ok(())
    }

    #[test]
    fn log_ticks_are_powers_of_ten_with_eight_minor_ones_between() -> Result<(), InvalidAxis> {
        let axis = Axis::log(1e-4, 100.0, 1)?;
        assert_eq!(majors(&axis), ["10^{−4}", "10^{−3}", "10^{−2}", "10^{−1}", "1", "10", "10^{2}"]);
        let minor: Vec<Tick> = axis.ticks().into_iter().filter(|tick| tick.label.is_none()).collect();
        assert_eq!(minor.len(), 6 * 8);
        assert_eq!(majors(&Axis::log(1e-16, 1.0, 4)?), ["10^{−16}", "10^{−12}", "10^{−8}", "10^{−4}", "1"]);
        Ok(())
    }

    #[test]
    fn values_go_where_they_belong_to_a_thousandth_of_a_pixel() -> Result<(), InvalidAxis> {
        let linear = Axis::linear(-2.0, 3.0, 1.0)?;
        let log = Axis::log(1e-3, 1e2, 1)?;
        for step in 0..=1000 {
            let part = f64::from(step) / 1000.0;
            for (axis, value) in [(&linear, -2.0 + 5.0 * part), (&log, 10_f64.powf(-3.0 + 5.0 * part))] {
                assert!((axis.place(value, 40.0, 640.0) - (40.0 + 600.0 * part)).abs() < 2e-3);
                assert!((axis.place(value, 300.0, 20.0) - (300.0 - 280.0 * part)).abs() < 2e-3);
            }
        }
        assert!(log.place(0.0, 0.0, 1.0).is_nan() && linear.place(f64::NAN, 0.0, 1.0).is_nan());
        assert!(linear.place(1e300, 0.0, 100.0) > 1000.0 && log.place(1e300, 0.0, 100.0) > 300.0);
        Ok(())
    }

    #[test]
    fn axes_that_cannot_be_are_refused() {
        assert_eq!(Axis::linear(1.0, 1.0, 0.1).err(), Some(InvalidAxis::Range { from: 1.0, to: 1.0 }));
        assert_eq!(Axis::log(0.0, 1.0, 1).err(), Some(InvalidAxis::NotPositive { from: 0.0 }));
        assert_eq!(Axis::linear(0.0, 1.0, 1e-3).err(), Some(InvalidAxis::Step { step: 1e-3 }));
        assert!(Axis::linear(0.0, f64::NAN, 1.0).is_err());
    }
}
