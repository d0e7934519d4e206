//! A lightly damped machine that speeds up, at many times at once.

use super::{LARGEST_EXPONENT, Swing, numbers};
use crate::quantity::InvalidQuantity;
use crate::scenes::laundromat::ramp::{self, Drum, Forced};
use crate::scenes::laundromat::{Ramp, Shaft};
use crate::two_part::TwoPart;
use crate::wide::faddeeva::upper_half;
use crate::wide::functions::{ROUNDABLE, at_full_width, exp, sin_cos_quarters};
use crate::wide::{BLOCK, in_blocks, sample};

/// The states of a drum that speeds up.
pub(crate) fn sample_ramp(motion: &Ramp, times: &[f64]) -> Result<Vec<Shaft>, InvalidQuantity> {
    let kernel = SpeedingUp::new(motion);
    let quick =
        |times: &[f64], states: &mut [Shaft]| kernel.as_ref().map_or(0, |kernel| kernel.fill(times, states));
    sample(times, Shaft::AT_REST, quick, |time| motion.at(time))
}

/// `eq:ramp-motion` for two roots apart.
#[derive(Debug, Clone, Copy)]
struct SpeedingUp {
    drum: Drum,
    mirrored: bool,
    spin_in_quarters: TwoPart,         // 2Ω/π
    acceleration_in_quarters: TwoPart, // α/π
    roots: [Root; 2],
    swing: Swing,
    earliest: f64,
    /// Before this the drum may still be in the resonance in which it starts.
    early: f64,
    reach: f64,
}

impl SpeedingUp {
    fn new(motion: &Ramp) -> Option<Self> {
        let Forced::Apart(roots) = &motion.late.forced else {
            return None;
        };
        let swing = Swing::new(&motion.free, motion.late.displacement, motion.late.velocity)?;
        let drum = motion.drum;
        let spin_in_quarters = TwoPart::from(2.0 * drum.spin) / TwoPart::PI;
        let acceleration_in_quarters = TwoPart::from(drum.acceleration) / TwoPart::PI;
        // The time at which the drum's angle has grown too large to be reduced.
        let by_acceleration = (0.25 * ROUNDABLE / acceleration_in_quarters.rounded()).sqrt();
        let by_spin = 0.25 * ROUNDABLE / spin_in_quarters.rounded().abs();
        let roots = roots.map(|root| Root::new(&drum, &root));
        Some(Self {
            drum,
            mirrored: motion.mirrored,
            spin_in_quarters,
            acceleration_in_quarters,
            earliest: roots[0].earliest().max(roots[1].earliest()),
            roots,
            early: motion.early_until(),
            reach: swing.reach.min(by_acceleration).min(by_spin),
            swing,
        })
    }

    fn fill(&self, times: &[f64], states: &mut [Shaft]) -> usize {
        let reached = |time: f64| (self.early..=self.reach).contains(&time.abs()) && time >= self.earliest;
        in_blocks(times, states, reached, |times, states| {
            let mut padded = [0.0; BLOCK];
            padded[..times.len()].copy_from_slice(times);
            let forced = at_full_width(
                #[inline(always)]
                || self.forced(&padded),
            );
            for (n, state) in states.iter_mut().enumerate() {
                let free = self.swing.at(times[n]);
                let [x, y, vx, vy] = std::array::from_fn(|i| forced[i][n] + free[i]);
                let sense = if self.mirrored { -1.0 } else { 1.0 };
                *state = Shaft::from_array([x, sense * y, vx, sense * vy]);
            }
            states.iter().all(Shaft::is_finite)
        })
    }

    /// x, y, ẋ, ẏ of what the force does.
    #[inline(always)]
    fn forced<const N: usize>(&self, times: &[f64; N]) -> [[f64; N]; 4] {
        let (mut load_cos, mut load_sin) = ([0.0; N], [0.0; N]);
        let mut sum = [[0.0; N]; 4];
        for n in 0..N {
            let time = times[n];
            let angle = (self.acceleration_in_quarters * time + self.spin_in_quarters) * time;
            let (high, low) = angle.parts();
            let (sin, cos) = sin_cos_quarters(high, low);
            (load_cos[n], load_sin[n]) = (cos, sin);
            let rate = self.drum.spin + self.drum.acceleration * time;
            sum[0][n] = cos;
            sum[1][n] = sin;
            sum[2][n] = -rate * sin - self.drum.damping * cos;
            sum[3][n] = rate * cos - self.drum.damping * sin;
        }
        for root in &self.roots {
            root.add(times, &load_cos, &load_sin, &mut sum);
        }
        sum.map(|list| list.map(|value| -self.drum.offset * value))
    }
}

/// `eq:ramp-integral` for one root, with its weight.
#[derive(Debug, Clone, Copy)]
struct Root {
    decay: f64,            // −Re λ
    passing: TwoPart,      // the time at which Faddeeva's argument crosses the real axis
    slope: f64,            // ½√α
    lift: f64,             // Re λ/√α
    left_behind: [f64; 4], // of what remains of the passing: x, y, ẋ, ẏ in the direction of its phase
    around: [f64; 4],      // and of Faddeeva's function times the load's direction
    phase_rate: TwoPart,   // quarter turns
    phase: TwoPart,
    passed: f64, // 1 if the passing lies before the start
}

impl Root {
    fn new(drum: &Drum, root: &ramp::Root) -> Self {
        let width = drum.acceleration.sqrt();
        let quarters = TwoPart::from(2.0) / TwoPart::PI;
        let ahead = root.turning - TwoPart::from(drum.spin);
        let passing = (ahead + TwoPart::from(root.decay)) / TwoPart::from(drum.acceleration);
        let phase = root.phase * quarters;
        // A phase that cannot be reduced is that of a passing beyond reach, or of one that damping leaves nothing of.
        let phase = if phase.rounded().abs() < ROUNDABLE { phase } else { TwoPart::from(0.0) };
        let position = root.weight * drum.scale();
        let around = numbers(position, position * root.lambda());
        Self {
            decay: root.decay,
            passing,
            slope: 0.5 * width,
            lift: -root.decay / width,
            left_behind: around.map(|number| 2.0 * number),
            around,
            phase_rate: root.turning * quarters,
            phase,
            passed: if root.passed { 1.0 } else { 0.0 },
        }
    }

    /// Before this time what would have to be taken away leaves the range of the exponential.
    fn earliest(&self) -> f64 {
        if self.passed == 0.0 {
            f64::NEG_INFINITY
        } else {
            self.passing.rounded() - LARGEST_EXPONENT / self.decay
        }
    }

    /// Adds the weighted S and λS to x, y, ẋ, ẏ.
    #[inline(always)]
    fn add<const N: usize>(
        &self,
        times: &[f64; N],
        load_cos: &[f64; N],
        load_sin: &[f64; N],
        sum: &mut [[f64; N]; 4],
    ) {
        let (passing, passing_low) = self.passing.parts();
        let (phase, phase_low) = self.phase.parts();
        let (mut re, mut im, mut side) = ([0.0; N], [0.0; N], [0.0; N]);
        for n in 0..N {
            let past = (times[n] - passing) - passing_low;
            side[n] = if past < 0.0 { 1.0 } else { -1.0 };
            re[n] = side[n] * (self.lift - self.slope * past);
            im[n] = self.slope * past.abs();
        }
        let [w_re, w_im] = upper_half(&[re, im]);
        for n in 0..N {
            let past = (times[n] - passing) - passing_low;
            let (around_re, around_im) = (
                side[n] * (w_re[n] * load_cos[n] - w_im[n] * load_sin[n]),
                side[n] * (w_re[n] * load_sin[n] + w_im[n] * load_cos[n]),
            );
            let (turned, turned_low) = (self.phase_rate * times[n]).parts();
            let (high, low) = (TwoPart::sum(turned, phase) + (turned_low + phase_low)).parts();
            let (sin, cos) = sin_cos_quarters(high, low);
            let counts = (0.5 - 0.5 * side[n]) - self.passed;
            let exponent = -self.lift * self.lift - self.decay * past;
            let size = counts * exp(if counts == 0.0 { 0.0 } else { exponent });
            let (left_re, left_im) = (size * cos, size * sin);
            for i in [0, 2] {
                let ([a, b], [c, d]) =
                    ([self.around[i], self.around[i + 1]], [self.left_behind[i], self.left_behind[i + 1]]);
                sum[i][n] += (a * around_re - b * around_im) + (c * left_re - d * left_im);
                sum[i + 1][n] += (a * around_im + b * around_re) + (c * left_im + d * left_re);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::SpeedingUp;
    use crate::scenes::laundromat::Shaft;
    use crate::wide::laundromat::tests::machine;

    #[test]
    fn a_light_machine_speeding_up_is_done_at_once_but_for_what_its_resonance_is_still_to_do() {
        let times: Vec<f64> = (0..640).map(|n| 0.3 * f64::from(n) - 96.0).collect();
        for (damping, spin, acceleration, expected) in
            [(0.0, 0.0, 0.02, 640), (0.5, 3.0, 0.02, 640), (1.5, -3.0, -0.02, 640), (0.0, 1.0, 1e-6, 0)]
        {
            let motion = machine(damping, spin).ramp(acceleration, Shaft::AT_REST).unwrap();
            let mut states = vec![Shaft::AT_REST; times.len()];
            let done = SpeedingUp::new(&motion).unwrap().fill(&times, &mut states);
            assert_eq!(done, expected, "{damping} {spin} {acceleration}");
        }
    }
}
