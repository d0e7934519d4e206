//! Axes: where values go, and where ticks stand.

use crate::failure::InvalidAxis;
use drawing::Scale;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::coord::types::RangedCoordf64;
use std::ops::Range;

/// An axis of a plot: its range, its scale, its ticks and its title.
///
/// On a logarithmic axis a value stands at its power of ten, so that all scales are linear: the logarithmic
/// ones of plotters label ticks `9.99e-5`.
#[derive(Clone)]
pub struct Axis {
    pub(crate) scale: Scale,
    pub(crate) title: Option<String>,
    places: RangedCoordf64,
    /// Ticks: where they stand on the scale, and the labels of the major ones.
    major: Vec<(f64, String)>,
    minor: Vec<f64>,
}

impl Axis {
    /// A linear axis with a major tick every `step`.
    ///
    /// # Errors
    /// [`InvalidAxis`] for an empty range, or a step that gives no ticks or more than a hundred.
    pub fn linear(from: f64, to: f64, step: f64) -> Result<Self, InvalidAxis> {
        // As many digits after the point as the step has.
        let digits = step.to_string().split_once('.').map_or(0, |(_, digits)| digits.len());
        Self::new(Scale { from, to, logarithmic: false }, step, |place| number(place, digits))
    }

    /// A logarithmic axis with a major tick every `decades` powers of ten, and minor ones at the other
    /// powers, or else between.
    ///
    /// # Errors
    /// [`InvalidAxis`] for a range that is empty or does not begin above zero.
    pub fn log(from: f64, to: f64, decades: u32) -> Result<Self, InvalidAxis> {
        let axis = Self::new(Scale { from, to, logarithmic: true }, f64::from(decades), power_of_ten)?;
        if decades > 1 {
            return Ok(axis.minor(1.0));
        }
        let Range { start, end } = axis.range();
        let between = |power: i32| (2..10).map(move |k| f64::from(power) + f64::from(k).log10());
        Ok(Self { minor: (start.floor() as i32..end.ceil() as i32).flat_map(between).collect(), ..axis })
    }

    fn new(scale: Scale, step: f64, label: impl Fn(f64) -> String) -> Result<Self, InvalidAxis> {
        let [from, to] = [scale.from, scale.to].map(|value| on_scale(scale, value));
        let sound = from.is_finite() && to.is_finite() && from < to;
        if !(sound && step > 0.0 && (to - from) / step <= 100.0) {
            return Err(InvalidAxis { from: scale.from, to: scale.to, step });
        }
        let mut axis =
            Self { scale, title: None, places: (from..to).into(), major: Vec::new(), minor: Vec::new() };
        axis.major = axis.multiples(step).map(|place| (place, label(place))).collect();
        Ok(axis)
    }

    /// The axis with minor ticks every `step`: a difference, or a number of decades.
    #[must_use]
    pub fn minor(self, step: f64) -> Self {
        Self { minor: self.multiples(step).take(1000).collect(), ..self }
    }

    /// The axis with its title. The title of an x axis stands below its right end, that of a y axis above its
    /// upper end.
    #[must_use]
    pub fn titled(self, title: &str) -> Self {
        Self { title: Some(title.into()), ..self }
    }

    /// The axis with these labelled ticks in place of numbers.
    #[must_use]
    pub fn marked(self, marks: &[(f64, &str)]) -> Self {
        let mark = |&(value, label): &(f64, &str)| (on_scale(self.scale, value), label.to_owned());
        Self { major: marks.iter().map(mark).collect(), ..self }
    }

    /// The axis with ticks but no numbers, for a panel that shares its numbers with the one below.
    #[must_use]
    pub fn unlabelled(self) -> Self {
        Self { major: self.major.into_iter().map(|(place, _)| (place, String::new())).collect(), ..self }
    }

    /// Where a value stands on the scale; none for what no such axis can show. Values far outside, which
    /// would leave the range of the whole numbers, come nearer: the plot cuts them at its frame anyway.
    pub(crate) fn place(&self, value: f64) -> Option<f64> {
        let (Range { start, end }, place) = (self.range(), on_scale(self.scale, value));
        let margin = 100.0 * (end - start);
        place.is_finite().then(|| place.clamp(start - margin, end + margin))
    }

    fn multiples(&self, step: f64) -> impl Iterator<Item = f64> + use<> {
        let Range { start, end } = self.range();
        let slack = 1e-9 * (end - start) / step;
        let (first, last) = ((start / step - slack).ceil() as i64, (end / step + slack).floor() as i64);
        (first..=last).map(move |k| k as f64 * step)
    }
}

/// Where a value stands on a scale.
fn on_scale(scale: Scale, value: f64) -> f64 {
    if scale.logarithmic { value.log10() } else { value }
}

/// The values of an axis are for plotters its places.
impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, place: &f64, limits: (i32, i32)) -> i32 {
        self.places.map(place, limits)
    }

    fn range(&self) -> Range<f64> {
        self.places.range()
    }

    /// Where major ticks stand, or else the minor ones.
    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if !hint.weight().allow_light_points() {
            return self.major.iter().map(|&(place, _)| place).collect();
        }
        let Range { start, end } = self.range();
        let inside = |&place: &f64| (start - 1e-9..=end + 1e-9).contains(&place);
        let near =
            |place: f64| self.major.iter().any(|&(other, _)| (place - other).abs() < 5e-4 * (end - start));
        self.minor.iter().copied().filter(|place| inside(place) && !near(*place)).collect()
    }
}

impl ValueFormatter<f64> for Axis {
    fn format_ext(&self, place: &f64) -> String {
        self.major.iter().find(|tick| tick.0 == *place).map_or(String::new(), |(_, label)| label.clone())
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
    use crate::failure::InvalidAxis;
    use plotters::coord::ranged1d::{BoldPoints, Ranged, ValueFormatter};

    fn majors(axis: &Axis) -> Vec<String> {
        axis.key_points(BoldPoints(0)).iter().map(|place| axis.format_ext(place)).collect()
    }

    fn minors(axis: &Axis) -> usize {
        axis.key_points(0).len()
    }

    #[test]
    fn linear_ticks_are_short_and_true() -> Result<(), InvalidAxis> {
        assert_eq!(majors(&Axis::linear(-1.0, 1.0, 0.5)?), ["−1.0", "−0.5", "0", "0.5", "1.0"]);
        assert_eq!(majors(&Axis::linear(0.0, 0.3, 0.1)?), ["0", "0.1", "0.2", "0.3"]);
        assert_eq!(majors(&Axis::linear(0.0, 60.0, 20.0)?), ["0", "20", "40", "60"]);
        assert_eq!(minors(&Axis::linear(0.0, 1.0, 0.5)?.minor(0.1)), 8);
        Ok(())
    }

    #[test]
    fn log_ticks_are_powers_of_ten_with_eight_minor_ones_between() -> Result<(), InvalidAxis> {
        let axis = Axis::log(1e-4, 100.0, 1)?;
        assert_eq!(majors(&axis), ["10^{−4}", "10^{−3}", "10^{−2}", "10^{−1}", "1", "10", "10^{2}"]);
        assert_eq!(minors(&axis), 6 * 8);
        assert_eq!(majors(&Axis::log(1e-16, 1.0, 4)?), ["10^{−16}", "10^{−12}", "10^{−8}", "10^{−4}", "1"]);
        assert_eq!(minors(&Axis::log(1e-16, 1.0, 4)?), 12);
        Ok(())
    }

    #[test]
    fn axes_that_cannot_be_are_refused() {
        let refused = |from, to, step| Some(InvalidAxis { from, to, step });
        assert_eq!(Axis::linear(1.0, 1.0, 0.1).err(), refused(1.0, 1.0, 0.1));
        assert_eq!(Axis::log(0.0, 1.0, 1).err(), refused(0.0, 1.0, 1.0));
        assert_eq!(Axis::linear(0.0, 1.0, 1e-3).err(), refused(0.0, 1.0, 1e-3));
        assert!(Axis::linear(0.0, f64::NAN, 1.0).is_err() && Axis::log(-1.0, 1.0, 1).is_err());
    }
}
