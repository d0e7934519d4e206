//! The motion of Euler's disk, by power series.

use super::film::EulersDisk;
use crate::error::Error;
use crate::integrate::{Taylor, TaylorStep};
use crate::quantity::{InvalidQuantity, Rule};
use crate::rolling::{Placed, Rolling, anchor, contact};
use nalgebra::Complex;
use std::ops::ControlFlow;

/// A looser tolerance, in radii and √(a/g), would be no number of the motion at all.
const LOOSEST_TOLERANCE: f64 = 1.0;
/// How many times faster than rolling the film's damping is at the end of the motion.
const MOST_DAMPING: f64 = 1000.0;

/// The motion of Euler's disk from a start, followed anew by each call of [`Sinking::at`] and [`Sinking::sample`].
///
/// ```
/// use mechanics::integrate::Taylor;
/// use mechanics::rolling::{DiskParameters, MomentFactors};
/// use mechanics::scenes::spinning_coin::EulersDisk;
/// let (mass, radius, gravity) = (0.4, 0.0375, 9.81); // the steel disc of the toy shops
/// let steel = DiskParameters { mass, radius, moments: MomentFactors::DISK, gravity };
/// let disk = EulersDisk::in_air(steel, 1.78e-5)?;
/// let sinking = disk.sinking(disk.steady(0.1)?, &Taylor::new(1e-13)?)?;
/// assert_eq!(format!("{:.2}°", sinking.at(10.0)?.tilt.to_degrees()), "5.52°");
/// # Ok::<(), mechanics::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sinking {
    disk: EulersDisk,
    start: Rolling,
    solver: Taylor,
}

impl EulersDisk {
    /// The motion from `start`, by a Taylor method whose tolerance, at most 1, is in radii and √(a/g). Its limit on the
    /// number of series holds for each call and for each direction of time; by default it is a hundred thousand, some
    /// fifteen thousand turns, and a second or two.
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number of `start` cannot be computed with, or the tolerance is too loose.
    pub fn sinking(&self, start: Rolling, solver: &Taylor) -> Result<Sinking, InvalidQuantity> {
        solver.check_at_most(LOOSEST_TOLERANCE)?;
        start.check()?;
        Ok(Sinking { disk: *self, start, solver: *solver })
    }

    /// How far y = ln tan(α/2) is from upright where damping has become so much faster than rolling.
    fn held_at(&self) -> f64 {
        let transverse = self.disk.parameters.moments.transverse;
        // K/I₁ sin³ α is so many times 1/√(I₁ sin α), and sin α is 1/cosh y.
        let sin = (self.disk.film / (MOST_DAMPING * transverse.sqrt())).powf(0.4);
        if sin < 1.0 { sin.recip().acosh() } else { 0.0 }
    }
}

impl Sinking {
    /// The disk at `time`, s, of either sign: as [`Sinking::sample`], which follows the motion once for many times.
    ///
    /// # Errors
    /// As [`Sinking::sample`].
    pub fn at(&self, time: f64) -> Result<Rolling, Error> {
        Ok(self.sample(&[time])?[0])
    }

    /// The disk at `times`, s, in any order and of either sign.
    ///
    /// An error is at most what a change of the start and of the time by a part 30 ε makes, and of the state anywhere on
    /// the way by 3 ε; and 30 ε of the numbers themselves and of one in the units a, √(g/a) and rad, where ε is the
    /// tolerance or 2.2e-16, whichever is larger. The place has in addition 30 ε radii for each radian by which the
    /// heading has gone on. Of heading and roll angle the larger counts for both. Back in time, where a film drives the
    /// disk, and with a looser tolerance than rounding, a number of a state that is smaller than one changes by such a
    /// part of those units.
    ///
    /// # Errors
    /// [`Error::Quantity`] for a time that is not finite, or after the end of the motion, which the message tells;
    /// [`Error::Integration`], with time and state in units of √(a/g), if the solver fails.
    pub fn sample(&self, times: &[f64]) -> Result<Vec<Rolling>, Error> {
        for &time in times {
            InvalidQuantity::check_time(time)?;
        }
        let mut states = vec![self.start; times.len()];
        let (mut onward, mut back): (Vec<usize>, Vec<usize>) =
            (0..times.len()).filter(|&i| times[i] != 0.0).partition(|&i| times[i] > 0.0);
        for order in [&mut onward, &mut back] {
            order.sort_by(|&i, &j| times[i].abs().total_cmp(&times[j].abs()));
            self.follow(times, order, &mut states)?;
        }
        Ok(states)
    }

    /// The states at the times of these places, which run away from zero in one direction.
    fn follow(&self, times: &[f64], order: &[usize], states: &mut [Rolling]) -> Result<(), Error> {
        let Some(&last) = order.last() else { return Ok(()) };
        let (series, state, placed) = Placed::new(&self.disk.disk, &self.start);
        let unit = placed.unit_of_time();
        // Only onward does the motion end.
        let held_at = self.disk.held_at();
        let is_over = |y: f64| times[last] > 0.0 && y.abs() >= held_at;
        let refused = |place: usize, end: f64| {
            let rule = Rule::NotAbove {
                what: "the end of the motion, where the film holds the disk fast",
                limit: end,
            };
            InvalidQuantity { quantity: "time", value: times[order[place]], unit: "s", rule }
        };
        if is_over(state[0]) {
            return Err(refused(0, 0.0).into());
        }
        let (mut here, mut facing, mut done) = (Complex::new(0.0, 0.0), Complex::new(1.0, 0.0), 0);
        let mut end = None;
        self.solver.solve_with(&series, 0.0, state, times[last] / unit, |step: &TaylorStep<'_, 8>| {
            if is_over(step.series()[0][0]) {
                end = Some(step.start() * unit);
                return ControlFlow::Break(());
            }
            let anchor = anchor(step.series(), here, facing);
            while let Some(time) = order.get(done).map(|&place| times[place] / unit) {
                if (time - step.end()) * step.length() > 0.0 {
                    break;
                }
                let state = step.at(time);
                let (contact, facing) = contact(anchor, &state);
                states[order[done]] = placed.in_room(&state, contact, facing);
                done += 1;
            }
            (here, facing) = contact(anchor, &step.last());
            ControlFlow::Continue(())
        })?;
        end.map_or(Ok(()), |end| Err(refused(done, end).into()))
    }
}
