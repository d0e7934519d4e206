//! An angle that grows at a constant rate.

use super::elementary::{ROUNDABLE, sin_cos_quarters};
use crate::two_part::TwoPart;

/// An angle that grows at a constant rate, in quarter turns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Clock {
    quarters_per_time: TwoPart,
}

impl Clock {
    /// From the rate in radians per unit of time.
    pub(crate) fn from_rate(rate: TwoPart) -> Self {
        Self { quarters_per_time: rate / (TwoPart::PI * 0.5) }
    }

    /// From the rate in quarter turns per unit of time.
    pub(crate) fn from_quarters(quarters_per_time: TwoPart) -> Self {
        Self { quarters_per_time }
    }

    /// The rate, in quarter turns per unit of time.
    pub(crate) fn quarters_per_time(&self) -> f64 {
        self.quarters_per_time.rounded()
    }

    /// Up to which time, of either sign, many angles can be reduced at once.
    pub(crate) fn reach(&self) -> f64 {
        ROUNDABLE / self.quarters_per_time.rounded().abs()
    }

    /// The angle at a time, high and low part.
    #[inline(always)]
    pub(crate) fn at(&self, time: f64) -> (f64, f64) {
        let (high, low) = self.quarters_per_time.parts();
        let (product, rest) = TwoPart::product(high, time).parts();
        (product, rest + low * time)
    }

    /// Sine and cosine of the angle at a time within reach; at any time for `ONE`.
    #[inline(always)]
    pub(crate) fn sin_cos<const ONE: bool>(&self, time: f64) -> (f64, f64) {
        let (high, low) = self.at(time);
        sin_cos_quarters::<ONE>(high, low)
    }
}

#[cfg(test)]
mod tests {
    use super::Clock;
    use crate::two_part::TwoPart;
    use std::f64::consts::TAU;

    #[test]
    fn a_clock_keeps_its_phase_for_a_billion_turns() {
        // At whole turns, 2πn over a rate that is no round number, the phase is zero but for the rounding of the time.
        let rate = 0.3 * TAU;
        let clock = Clock::from_rate(TwoPart::from(rate));
        for n in [1_u64, 1_000, 1_000_000, 1_000_000_000, 1_000_000_000_000] {
            let time = n as f64 / 0.3;
            // What is left over, from whole numbers: rate · time as an exact product less 2πn in two parts.
            let rest = TwoPart::product(rate, time) - TwoPart::PI * (2.0 * n as f64);
            let (sin, _) = clock.sin_cos::<false>(time);
            let expected = rest.rounded().sin();
            assert!((sin - expected).abs() < 2e-16 * (1.0 + rest.rounded().abs()), "{n}: {sin} {expected}");
        }
        assert!(clock.reach() > 1e14);
    }
}
