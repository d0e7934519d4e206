//! Euler's disk: a coin that sinks as it squeezes a film of air.

use crate::frames::InvalidFrames;
use crate::integrate::{Failure, Taylor, TaylorStep};
use crate::quantity::{InvalidQuantity, Rule, Shown};
use crate::rolling::{RollingSeries, anchor, contact, sin_cos_tilt};
use nalgebra::Complex;
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt;
use std::ops::ControlFlow;

/// A motion is given up after so many series, unless the caller says otherwise.
const MOST_SERIES: usize = 100_000;
/// A looser tolerance, in radii and √(a/g), would be no number of the motion at all.
const LOOSEST_TOLERANCE: f64 = 1.0;
/// How many times faster than rolling the film's damping is at the end of the motion.
const MOST_DAMPING: f64 = 1000.0;

/// A disc or hoop that rolls on its edge without slipping and is slowed by the film of air under it.
///
/// The film takes the torque `K m a² √(g/a) ω/sin³ β` about both axes in the plane of the disc, where β is its tilt from lying
/// flat (`eq:film-torque`). Nothing is assumed to be slow: it wobbles as it sinks.
///
/// In this model the disk never lies flat. The film's rate of damping, `K/(½k sin³ β)` in √(g/a), outgrows that of steady rolling,
/// `1/√(½k sin β)`; soon all turning has died out, and the disk creeps on as in glue, β̇ = −β³/K, for ever. The motion is over when
/// damping is a thousand times faster than rolling would be, at `sin β = (K/1000√(½k))^(2/5)`: for the toy an eighth of a
/// milliradian, with its high edge nine micrometres up.
///
/// ```
/// use mechanics::scenes::spinning_coin::EulersDisk;
/// // The steel disc of the toy shops, 0.4 kg and 37.5 mm, in air.
/// let disk = EulersDisk::in_air(0.4, 0.0375, 9.81, 1.78e-5)?;
/// let start = disk.steady(0.1)?;
/// let frames = disk.sample(&start, &[0.0, 30.0, 60.0], 1e-13)?;
/// // On the average the cube of the tilt falls in proportion to the time: 95.4 s to the end.
/// let expected = 0.1 * (1.0 - 60.0 / 95.37_f64).cbrt();
/// assert!((frames[2].tilt / expected - 1.0).abs() < 0.02);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EulersDisk {
    radius: f64,
    gravity: f64,
    factor: f64,
    film: f64,
}

/// The disk at one instant. Axis 1 is level, in its plane; axis 2 runs up the steepest line of its plane; axis 3 is its upward
/// normal.
///
/// Axes 1 and 3 are those of a rolling wheel ([`crate::scenes::rolling_wheel`]) the other way round: of one and the same motion β̇, ω₃ and
/// φ are −θ̇, −n and −ψ there, and the headings differ by half a turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sinking {
    /// The tilt β from lying flat, rad, between 0 and π.
    pub tilt: f64,
    /// Its rate, rad/s: the angular velocity about axis 1.
    pub tilt_rate: f64,
    /// The angular velocity about axis 2, rad/s.
    pub across: f64,
    /// The angular velocity about axis 3, rad/s.
    pub along: f64,
    /// The heading ψ of axis 1 from x, rad.
    pub heading: f64,
    /// The angle φ through which the disk has turned about axis 3 relative to the frame of the axes, rad.
    pub spin: f64,
    /// x and y of the point of contact, m.
    pub contact: [f64; 2],
}

impl Sinking {
    /// The eight numbers that an integrator steps: β, ω₁, ω₂, ω₃, ψ, φ, x, y. The angle φ comes before the place; many write it last.
    pub fn to_array(&self) -> [f64; 8] {
        let [x, y] = self.contact;
        [self.tilt, self.tilt_rate, self.across, self.along, self.heading, self.spin, x, y]
    }

    /// From an integrator's eight numbers.
    pub fn from_array([tilt, tilt_rate, across, along, heading, spin, x, y]: [f64; 8]) -> Self {
        Self { tilt, tilt_rate, across, along, heading, spin, contact: [x, y] }
    }
}

impl EulersDisk {
    /// A disk of `radius`, m, with the moments `k m a²` about its axis and half of it about a diameter (k = ½ for a disc, 1 for a
    /// hoop), under `gravity`, m/s², with the film's number K, zero or more, which has no unit (`eq:film-torque`).
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule.
    pub fn new(radius: f64, factor: f64, gravity: f64, film: f64) -> Result<Self, InvalidQuantity> {
        InvalidQuantity::check_positive("radius", radius, "m")?;
        InvalidQuantity::check_positive("moment factor k", factor, "")?;
        InvalidQuantity::require(factor <= 1.0, "moment factor k", factor, "", Rule::AtMost(1.0))?;
        InvalidQuantity::check_positive("gravity", gravity, "m/s²")?;
        InvalidQuantity::check_not_negative("film number K", film, "")?;
        Ok(Self { radius, gravity, factor, film })
    }

    /// A uniform disc of `mass`, kg, and `radius`, m, under `gravity`, m/s², in a gas of `viscosity`, Pa·s: the film's number
    /// is then `πμa/4m · √(a/g)`, for which a steadily sinking disc loses the power `πμga²/β²` of Moffatt (2000).
    ///
    /// # Errors
    /// [`InvalidQuantity`] if a number breaks its rule.
    pub fn in_air(mass: f64, radius: f64, gravity: f64, viscosity: f64) -> Result<Self, InvalidQuantity> {
        InvalidQuantity::check_positive("mass", mass, "kg")?;
        InvalidQuantity::check_positive("radius", radius, "m")?;
        InvalidQuantity::check_positive("gravity", gravity, "m/s²")?;
        InvalidQuantity::check_not_negative("viscosity", viscosity, "Pa·s")?;
        let film = 0.25 * PI * viscosity * radius / mass * (radius / gravity).sqrt();
        Self::new(radius, 0.5, gravity, film)
    }

    /// The film's number K.
    pub fn film(&self) -> f64 {
        self.film
    }

    /// The steady motion about a centre at rest at this tilt, rad, as it would be without the film (`eq:coin-rate`). The centre is above
    /// the origin and axis 1 along x, so that the contact is at (0, −a cos β).
    ///
    /// # Errors
    /// [`InvalidQuantity`] unless the tilt is more than zero and less than π/2.
    pub fn steady(&self, tilt: f64) -> Result<Sinking, InvalidQuantity> {
        InvalidQuantity::check_positive("tilt from lying flat", tilt, "rad")?;
        let rule = Rule::LessThan(FRAC_PI_2);
        InvalidQuantity::require(tilt < FRAC_PI_2, "tilt from lying flat", tilt, "rad", rule)?;
        let (sin, cos) = tilt.sin_cos();
        let turn_rate = (2.0 * self.gravity / (self.factor * self.radius * sin)).sqrt();
        Ok(Sinking {
            tilt,
            tilt_rate: 0.0,
            across: turn_rate * sin,
            along: 0.0,
            heading: 0.0,
            spin: 0.0,
            contact: [0.0, -self.radius * cos], // the level part of axis 2 lies along y
        })
    }

    /// The rates of the eight numbers of [`Sinking`], for [`crate::integrate::Dop853`] (`eq:film-rates`). Infinite or NaN for a
    /// flat disk.
    pub fn rates(&self, _time: f64, state: &[f64; 8]) -> [f64; 8] {
        let &[tilt, w1, w2, w3, heading, ..] = state;
        let (sin, cos) = tilt.sin_cos();
        let (a, c) = (0.5 * self.factor, self.factor);
        let o3 = w2 * cos / sin;
        let rate = (self.gravity / self.radius).sqrt();
        let film = self.film * rate / (sin * sin * sin);
        let along_path = self.radius * (o3 - w3);
        let (s, h) = heading.sin_cos();
        [
            w1,
            (a * w2 * o3 - (c + 1.0) * w2 * w3 - rate * rate * cos - film * w1) / (a + 1.0),
            (c * w1 * w3 - a * w1 * o3 - film * w2) / a,
            w1 * w2 / (c + 1.0),
            w2 / sin,
            w3 - o3,
            along_path * h,
            along_path * s,
        ]
    }

    /// The energy over the mass, m²/s², with the table as zero of height.
    pub fn energy_over_mass(&self, state: &Sinking) -> f64 {
        let (a, c) = (0.5 * self.factor, self.factor);
        let Sinking { tilt, tilt_rate, across, along, .. } = *state;
        let square = (1.0 + a) * tilt_rate * tilt_rate + a * across * across + (1.0 + c) * along * along;
        self.radius * (0.5 * self.radius * square + self.gravity * tilt.sin())
    }

    /// The part of the contact force that holds the disk up, over its weight; negative where it would leave the table.
    pub fn support_over_weight(&self, state: &Sinking) -> f64 {
        let acceleration = self.rates(0.0, &state.to_array())[1];
        let (sin, cos) = state.tilt.sin_cos();
        1.0 + self.radius / self.gravity * (acceleration * cos - state.tilt_rate * state.tilt_rate * sin)
    }

    /// The disk at `times`, s, which must run from 0 in one direction, by a Taylor method of order sixteen whose last terms are as
    /// small as `tolerance`, from 1e-17 to 1 (in radii and in √(a/g)).
    ///
    /// An error is at most 30 times what a change of the start and of the time by a part ε makes, and of 30 ε of the numbers themselves
    /// and of one in the units a, √(g/a) and rad, where ε is the tolerance or 2.2e-16, whichever is larger; the place has in addition 30 ε
    /// radii for each radian by which the heading has gone on. Back in time a film drives the disk, and a change of numbers smaller than
    /// one is one of ε of those units.
    ///
    /// # Errors
    /// As [`EulersDisk::fill`], except for the lengths.
    pub fn sample(&self, start: &Sinking, times: &[f64], tolerance: f64) -> Result<Vec<Sinking>, NoSinking> {
        let mut frames = vec![*start; times.len()];
        self.fill(start, times, tolerance, &mut frames).map_err(|error| match error {
            InvalidFrames::Time { error, .. } => error,
            InvalidFrames::Length { .. } => unreachable!("one frame for each time"),
        })?;
        Ok(frames)
    }

    /// As [`EulersDisk::sample`], into `frames`, without allocating.
    ///
    /// A motion of more than a hundred thousand series, some fifteen thousand turns, is given up, in a fraction of a second;
    /// [`EulersDisk::fill_by`] sets another limit.
    ///
    /// # Errors
    /// [`InvalidFrames::Length`] if there are not as many frames as times; else [`InvalidFrames::Time`] with [`NoSinking`] for a
    /// start or times that cannot be used, a tolerance that cannot be kept, a time after the end of the motion, or if the
    /// integration fails.
    pub fn fill(
        &self,
        start: &Sinking,
        times: &[f64],
        tolerance: f64,
        frames: &mut [Sinking],
    ) -> Result<(), InvalidFrames<NoSinking>> {
        let solver = Taylor::new(tolerance).map(|solver| solver.with_max_expansions(MOST_SERIES));
        let refused = |error: InvalidQuantity| InvalidFrames::Time { index: 0, error: error.into() };
        self.fill_by(start, times, &solver.map_err(refused)?, frames)
    }

    /// The same with a solver of one's own, and its limits.
    ///
    /// # Errors
    /// As [`EulersDisk::fill`].
    pub fn fill_by(
        &self,
        start: &Sinking,
        times: &[f64],
        solver: &Taylor,
        frames: &mut [Sinking],
    ) -> Result<(), InvalidFrames<NoSinking>> {
        if times.len() != frames.len() {
            return Err(InvalidFrames::Length { times: times.len(), frames: frames.len() });
        }
        let refused = |index: usize, error: NoSinking| InvalidFrames::Time { index, error };
        solver.check_at_most(LOOSEST_TOLERANCE).map_err(|error| refused(0, error.into()))?;
        let state = self.state(start).map_err(|error| refused(0, error.into()))?;
        let end = times.last().copied().unwrap_or(0.0);
        let mut before = 0.0;
        for (index, &time) in times.iter().enumerate() {
            let onward = (time - before) * end.signum() >= 0.0;
            if !(time.is_finite() && onward) {
                return Err(refused(index, NoSinking::Time { time }));
            }
            before = time;
        }

        let series = RollingSeries { across: 0.5 * self.factor, along: self.factor, drag: self.film };
        let unit = (self.radius / self.gravity).sqrt();
        let [x, y] = start.contact;
        let origin = Complex::new(x, y);
        let (mut here, mut facing, mut done) = (Complex::new(0.0, 0.0), Complex::cis(start.heading), 0);
        while done < times.len() && times[done] == 0.0 {
            frames[done] = *start;
            done += 1;
        }
        // Where damping would be so much faster than rolling, in √(g/a), a motion onward is over.
        let over = |y: f64, now: f64| {
            let rolling = sin_cos_tilt(y).0.powf(2.5) * (0.5 * self.factor).sqrt();
            let held = end > 0.0 && self.film > MOST_DAMPING * rolling;
            held.then(|| NoSinking::Over { time: now * unit, tilt: tilt(y) })
        };
        let mut ended = over(state[0], 0.0);
        if let Some(error) = ended {
            return Err(refused(done, error));
        }
        let outcome = solver.solve_with(&series, 0.0, state, end / unit, |step: &TaylorStep<'_, 8>| {
            ended = over(step.series()[0][0], step.start());
            if ended.is_some() {
                return ControlFlow::Break(());
            }
            let anchor = anchor(step.series(), here, facing);
            while let Some(time) = times.get(done).map(|time| time / unit) {
                if (time - step.end()) * step.length() > 0.0 {
                    break;
                }
                let state = step.at(time);
                let (place, _) = contact(anchor, &state);
                frames[done] = self.sinking(&state, origin + place * self.radius, unit);
                done += 1;
            }
            (here, facing) = contact(anchor, &step.last());
            ControlFlow::Continue(())
        });
        match (outcome, ended) {
            (Ok(_), None) => Ok(()),
            (Ok(_), Some(error)) => Err(refused(done, error)),
            (Err(failure), _) => Err(refused(done, NoSinking::Integration(failure))),
        }
    }

    /// The state of [`RollingSeries`].
    fn state(&self, start: &Sinking) -> Result<[f64; 8], InvalidQuantity> {
        InvalidQuantity::check_positive("tilt from lying flat", start.tilt, "rad")?;
        let rule = Rule::LessThan(PI);
        InvalidQuantity::require(start.tilt < PI, "tilt from lying flat", start.tilt, "rad", rule)?;
        for (name, value, unit) in [
            ("rate of the tilt", start.tilt_rate, "rad/s"),
            ("angular velocity about axis 2", start.across, "rad/s"),
            ("angular velocity about axis 3", start.along, "rad/s"),
            ("heading", start.heading, "rad"),
            ("spin", start.spin, "rad"),
            ("position of the contact", start.contact[0], "m"),
            ("position of the contact", start.contact[1], "m"),
        ] {
            InvalidQuantity::check(name, value, unit)?;
        }
        let unit = (self.radius / self.gravity).sqrt();
        let over = unit / start.tilt.sin();
        Ok([
            (0.5 * start.tilt).tan().ln(),
            start.tilt_rate * over,
            start.across * over,
            start.along * unit,
            start.heading,
            start.spin,
            0.0,
            0.0,
        ])
    }

    fn sinking(
        &self,
        &[y, u, o, w, heading, spin, ..]: &[f64; 8],
        contact: Complex<f64>,
        unit: f64,
    ) -> Sinking {
        let sin = sin_cos_tilt(y).0 / unit;
        Sinking {
            tilt: tilt(y),
            tilt_rate: u * sin,
            across: o * sin,
            along: w / unit,
            heading,
            spin,
            contact: [contact.re, contact.im],
        }
    }
}

/// β from y.
fn tilt(y: f64) -> f64 {
    2.0 * y.exp().atan()
}

/// Why a disk's motion cannot be followed.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum NoSinking {
    /// A number of the start breaks its rule.
    Quantity(InvalidQuantity),
    /// A time is not finite, or does not follow the one before it.
    Time {
        /// The time, s.
        time: f64,
    },
    /// A time after the end of the motion, when the film has stopped all turning.
    Over {
        /// When it ended, s; zero if the film held the disk from the start.
        time: f64,
        /// The tilt at the end, rad.
        tilt: f64,
    },
    /// The integration stopped. Time and state are its own, in √(a/g).
    Integration(Failure),
}

impl From<InvalidQuantity> for NoSinking {
    fn from(error: InvalidQuantity) -> Self {
        Self::Quantity(error)
    }
}

impl fmt::Display for NoSinking {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Quantity(error) => error.fmt(out),
            Self::Time { time } => write!(
                out,
                "time {} s must be finite, and the times must run from 0 s in one direction",
                Shown(*time)
            ),
            Self::Over { time, tilt } => write!(
                out,
                "the motion ends at {} s, where at a tilt of {} rad the film holds the disk fast",
                Shown(*time),
                Shown(*tilt)
            ),
            Self::Integration(failure) => failure.fmt(out),
        }
    }
}

impl Error for NoSinking {}
