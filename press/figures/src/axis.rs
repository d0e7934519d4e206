//! Axes as plotters asks for them.

use drawing::{Axis, Flaw};
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::coord::types::RangedCoordf64;
use std::ops::Range;

/// The ticks of an axis. For plotters its values are the parts of its length, from 0 to 1, so that all scales are
/// linear: the logarithmic ones of plotters label ticks `9.99e-5`.
#[derive(Clone)]
pub(crate) struct Ticks {
    major: Vec<(f64, String)>,
    minor: Vec<f64>,
}

impl Ticks {
    pub(crate) fn of(axis: &Axis<'_>) -> Result<Self, Flaw> {
        let major = axis.ticks()?;
        let is_free = |part: &f64| {
            (-1e-9..=1.0 + 1e-9).contains(part) && major.iter().all(|(other, _)| (part - other).abs() >= 5e-4)
        };
        let minor = axis.minor_ticks().into_iter().filter(is_free).collect();
        Ok(Self { major, minor })
    }
}

impl Ranged for Ticks {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, part: &f64, limits: (i32, i32)) -> i32 {
        RangedCoordf64::from(self.range()).map(part, limits)
    }

    fn range(&self) -> Range<f64> {
        0.0..1.0
    }

    /// Where major ticks stand, or else the minor ones.
    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.weight().allow_light_points() {
            return self.minor.clone();
        }
        self.major.iter().map(|&(part, _)| part).collect()
    }
}

impl ValueFormatter<f64> for Ticks {
    fn format_ext(&self, part: &f64) -> String {
        self.major.iter().find(|tick| tick.0 == *part).map_or(String::new(), |(_, label)| label.clone())
    }
}
