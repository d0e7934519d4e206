//! How the wheel of the scene rolls.

use live::prelude::*;
use mechanics::InvalidQuantity;
use mechanics::integrate::{Failure, Taylor, rk4};
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::{SteadyRolling, Wheel, Wobble};
use nalgebra::Complex;

/// The wheel: a disc, a hoop, or a hoop with weights, of this mass, kg, and radius, m, on Earth.
pub(super) const MASS: f64 = 1.0;
pub(super) const RADIUS: f64 = 0.3;
pub(super) const GRAVITY: f64 = 9.81;
/// How long the scene runs, s, and how far apart its track is known, s.
const DURATION: f64 = 20.0;
const STEP: f64 = 1.0 / 60.0;
/// A wheel that is slowed or falls is followed down to this tilt from lying flat, rad.
const FLAT: f64 = 0.05;
/// Between two states that are known the wheel turns its heading by no more, rad, or they are as close as this.
const TURN: f64 = 0.25;
const MOST_PARTS: f64 = 12.0;

/// The wheel with weights on its axle, among the three.
pub(super) const WEIGHTS: usize = 2;

/// The disc, 0, the hoop, 1, or, 2, a hoop with as much mass in two weights on its axle, so far out, in radii.
pub(super) fn wheel(which: usize, far: f64) -> Result<Wheel, InvalidQuantity> {
    let weighted = MomentFactors { transverse: 0.25 + 0.5 * far * far, axial: 0.5 };
    let moments = [MomentFactors::DISK, MomentFactors::HOOP, weighted][which];
    Wheel::new(DiskParameters { mass: MASS, radius: RADIUS, moments, gravity: GRAVITY })
}

/// The edge of the tongue on the map: b/a and leans, degrees, from the inner edge over the tip to the outer one.
pub(super) fn tongue(wheel: &Wheel) -> Vec<(f64, f64)> {
    let tip = wheel.safe_lean();
    // Closer together towards the upright and the tip, where the edges bend.
    let leans = (1..60).map(|k| f64::from(k) / 60.0).map(|part| tip * (1.0 - (1.0 - part * part).powi(2)));
    let edges = leans.filter_map(|lean| Some((wheel.unstable_circles(lean).ok()??, lean.to_degrees())));
    let edges: Vec<_> = edges.map(|(circles, lean)| (circles.map(|b| b / RADIUS), lean)).collect();
    let inner = edges.iter().map(|&([inner, _], lean)| (inner, lean));
    inner.chain(edges.iter().rev().map(|&([_, outer], lean)| (outer, lean))).collect()
}

/// How the motion is known.
pub(super) enum Course {
    /// It is steady.
    Steady,
    /// It is steady up to a kick, and wobbles from then on, from each kick in another way: when they came, s.
    Wobbling(Vec<(f64, Wobble)>),
    /// It was followed step by step, the states being [`STEP`] apart, until it lay flat at the time of the last.
    Followed(Vec<Rolling>),
}

/// A wheel, and how it rolls.
pub(super) struct Rolled {
    /// What is kept to compare.
    pub(super) kept: Option<Box<Self>>,
    pub(super) wheel: Wheel,
    pub(super) which: usize,
    /// How far out its weights are, if it has some, in radii.
    pub(super) far: f64,
    pub(super) tongue: Vec<(f64, f64)>,
    pub(super) lean: f64,
    pub(super) circle: f64,
    pub(super) push: f64,
    pub(super) loss: f64,
    /// When it is kicked, s: if its states are known step by step, at one of them.
    pub(super) kicks: Vec<f64>,
    /// The heading and the angle of the roll with which it begins.
    pub(super) turned: [f64; 2],
    pub(super) steady: Option<SteadyRolling>,
    /// The wobbling from a kick that may come at the beginning, if there is none.
    preview: Option<Wobble>,
    /// The leans between which the wobbling swings.
    pub(super) swung: [f64; 2],
    pub(super) course: Course,
    pub(super) start: Rolling,
    /// The states of the run and their times, s: [`STEP`] apart, and closer where it whirls.
    pub(super) states: Vec<(f64, Rolling)>,
    /// Where each touches the table, in radii; the middle of the track, and how far it reaches from there.
    pub(super) contacts: Vec<Complex<f64>>,
    pub(super) middle: Complex<f64>,
    pub(super) reach: f64,
    /// The smallest and the largest lean of the run, and the largest energy of the rate of lean, in mga.
    pub(super) swings: [f64; 2],
    pub(super) liveliest: f64,
}

/// What a wheel is, and how it begins: the names are those of [`Rolled`].
#[derive(Default)]
pub(super) struct Given {
    pub(super) which: usize,
    pub(super) far: f64,
    pub(super) lean: f64,
    pub(super) circle: f64,
    pub(super) push: f64,
    pub(super) loss: f64,
    pub(super) kicks: Vec<Press>,
    pub(super) turned: [f64; 2],
}

impl Rolled {
    pub(super) fn new(settings: &Settings<'_>) -> Result<Self, Cause> {
        let given = Given {
            which: settings.choice("wheel")?,
            far: settings.of("reach")?,
            lean: settings.of("lean")?.to_radians(),
            circle: settings.of("circle")?,
            push: settings.of("push")?,
            loss: settings.of("loss")?,
            kicks: settings.presses("kick")?,
            turned: [settings.of("heading")?, settings.of("roll")?],
        };
        let kept = settings.kept(|settings| Ok(Box::new(Self::new(settings)?)));
        Ok(Self { kept, ..Self::of(given)? })
    }

    pub(super) fn of(given: Given) -> Result<Self, Cause> {
        let Given { which, far, lean, circle, push, loss, kicks, turned } = given;
        let wheel = wheel(which, far)?;
        let steady = wheel.steady(lean, circle * RADIUS).ok();
        let [heading, roll_angle] = turned;
        let rest = Rolling { tilt: FRAC_PI_2 - lean, heading, roll_angle, ..Rolling::UPRIGHT };
        let start = steady.map_or(rest, |steady| steady_at(&steady, turned, 0.0));
        // Each kick acts on the motion as it is then. Without one, what one at the beginning would do is shown.
        let (mut wobbles, mut is_known) = (Vec::<(f64, Wobble)>::new(), loss == 0.0 && steady.is_some());
        let given = if kicks.is_empty() { vec![[0.0, push, 0.0]] } else { kicks.clone() };
        for [time, push, _] in given.into_iter().filter(|kick| kick[1] != 0.0) {
            let Some(steady) = steady.filter(|_| is_known) else { break };
            let mut now = match wobbles.last() {
                Some((from, wobble)) => wobble_at(wobble, time - from)?,
                None => steady_at(&steady, turned, time),
            };
            now.omega_1 += push;
            match wheel.wobble(now, &Taylor::new(1e-13)?) {
                Ok(wobble) => wobbles.push((time, wobble)),
                Err(_) => is_known = kicks.is_empty(),
            }
        }
        let preview = if kicks.is_empty() { wobbles.pop().map(|(_, wobble)| wobble) } else { None };
        let course = match (is_known, wobbles.is_empty()) {
            (true, true) => Course::Steady,
            (true, false) => Course::Wobbling(wobbles),
            (false, _) => Course::Followed(followed(&wheel, start, loss, &kicks)),
        };
        let is_followed = matches!(course, Course::Followed(_));
        let on_step = |time: f64| if is_followed { (time / STEP).round() * STEP } else { time };
        let mut rolled = Self {
            kept: None,
            tongue: tongue(&wheel),
            wheel,
            which,
            far,
            lean,
            circle,
            push,
            loss,
            kicks: kicks.iter().map(|kick| on_step(kick[0])).collect(),
            turned,
            steady,
            preview,
            swung: [lean; 2],
            course,
            start,
            states: Vec::new(),
            contacts: Vec::new(),
            middle: Complex::ZERO,
            reach: 0.0,
            swings: [lean; 2],
            liveliest: 0.0,
        };
        let mut before = rolled.at(0.0)?;
        rolled.add(0.0, before);
        for k in 0..(rolled.duration() / STEP).round() as u32 {
            let after = rolled.at(f64::from(k + 1) * STEP)?;
            let parts = ((after.heading - before.heading).abs() / TURN).ceil().clamp(1.0, MOST_PARTS);
            for part in 1..=parts as u32 {
                let time = (f64::from(k) + f64::from(part) / parts) * STEP;
                rolled.add(time, rolled.at(time)?);
            }
            before = after;
        }
        rolled.measure();
        // What a kick would do is shown before it is given.
        for k in 0..=120 {
            let Some(wobble) = rolled.wobble() else { break };
            let state = wobble_at(wobble, wobble.period() * f64::from(k) / 120.0)?;
            rolled.widen(&state);
            let [low, high] = rolled.swung;
            rolled.swung = [low.min(state.lean()), high.max(state.lean())];
        }
        Ok(rolled)
    }

    /// The wobbling from the last kick on, or from one that may come at the beginning, if the lean swings.
    pub(super) fn wobble(&self) -> Option<&Wobble> {
        match &self.course {
            Course::Wobbling(wobbles) => wobbles.last().map(|(_, wobble)| wobble),
            _ => self.preview.as_ref(),
        }
    }

    fn add(&mut self, time: f64, state: Rolling) {
        self.states.push((time, state));
        self.contacts.push(state.contact(RADIUS) / RADIUS);
        self.widen(&state);
    }

    /// Finds the middle of the track, and how far it reaches from there.
    fn measure(&mut self) {
        let (mut low, mut high) =
            (Complex::new(f64::INFINITY, f64::INFINITY), -Complex::new(f64::INFINITY, f64::INFINITY));
        for place in &self.contacts {
            low = Complex::new(low.re.min(place.re), low.im.min(place.im));
            high = Complex::new(high.re.max(place.re), high.im.max(place.im));
        }
        self.middle = (low + high) * 0.5;
        self.reach = self.contacts.iter().map(|place| (place - self.middle).norm()).fold(0.0, f64::max);
    }

    /// Counts a state among those between which the lean swings.
    fn widen(&mut self, state: &Rolling) {
        let [low, high] = self.swings;
        self.swings = [low.min(state.lean()), high.max(state.lean())];
        self.liveliest = self.liveliest.max(self.energy_of_rate(state.omega_1));
    }

    /// How long the run is, s.
    pub(super) fn duration(&self) -> f64 {
        match &self.course {
            Course::Followed(states) => ((states.len() - 1) as f64 * STEP).max(1.0),
            _ => DURATION,
        }
    }

    /// How many of the states come before a time, s, or at it; at least one.
    pub(super) fn count_to(&self, time: f64) -> usize {
        self.states.partition_point(|(own, _)| *own <= time).max(1)
    }

    /// The energy of a rate of lean, in mga: ½(1 + I₁)θ̇² a/g.
    pub(super) fn energy_of_rate(&self, rate: f64) -> f64 {
        let swinging = Rolling { omega_1: rate, ..Rolling::UPRIGHT };
        (self.wheel.energy(&swinging) - self.wheel.energy(&Rolling::UPRIGHT)) / (MASS * GRAVITY * RADIUS)
    }

    /// The state at a time, s.
    pub(super) fn at(&self, time: f64) -> Result<Rolling, Cause> {
        match &self.course {
            Course::Wobbling(wobbles) if wobbles[0].0 <= time => {
                let (from, wobble) = &wobbles[wobbles.partition_point(|(from, _)| *from <= time) - 1];
                wobble_at(wobble, time - from)
            }
            Course::Followed(states) => {
                let last = states.len() - 1;
                let before = ((time / STEP + 1e-9) as usize).min(last); // that of a step, whatever is rounded
                let since = time - before as f64 * STEP;
                if before == last || since <= 0.0 {
                    return Ok(states[before]);
                }
                let now = rolled_on(&self.wheel, self.loss, &states[before], since);
                Ok(now.ok().filter(|now| !is_flat(now)).unwrap_or(states[before + 1]))
            }
            _ => Ok(self.steady.map_or(self.start, |steady| steady_at(&steady, self.turned, time))),
        }
    }
}

/// A wobbling at a time, s. (Compiled once: each call would have a copy of it in the page's module.)
#[inline(never)]
fn wobble_at(wobble: &Wobble, time: f64) -> Result<Rolling, Cause> {
    Ok(wobble.at(time)?)
}

/// The steady motion at a time, s, that begins with a heading and an angle of the roll.
#[inline(never)]
fn steady_at(steady: &SteadyRolling, [heading, roll]: [f64; 2], time: f64) -> Rolling {
    let state = steady.state();
    let heading = heading + steady.turn_rate() * time;
    let centre = state.centre * Complex::cis(heading);
    Rolling { heading, roll_angle: roll + steady.relative_spin() * time, centre, ..state }
}

/// Whether the wheel has fallen.
pub(super) fn is_flat(state: &Rolling) -> bool {
    state.tilt.min(PI - state.tilt) < FLAT
}

/// The state after a time of one [`STEP`] at most, s.
fn rolled_on(wheel: &Wheel, loss: f64, state: &Rolling, time: f64) -> Result<Rolling, Failure> {
    let rates = wheel.slowed_rates(loss);
    Ok(Rolling::from_array(rk4(rates, 0.0, state.to_array(), time, 10)?))
}

/// The motion step by step, [`STEP`] apart, with kicks at times of some strengths, to the end of the run or until the
/// wheel lies flat, where it comes to rest.
fn followed(wheel: &Wheel, mut now: Rolling, loss: f64, kicks: &[Press]) -> Vec<Rolling> {
    let mut states = Vec::new();
    for k in 0..(DURATION / STEP).round() as u32 {
        let given = kicks.iter().filter(|kick| (kick[0] / STEP).round() == f64::from(k));
        now.omega_1 += given.map(|kick| kick[1]).sum::<f64>();
        states.push(now);
        // What has no next state has fallen through the table.
        let next = rolled_on(wheel, loss, &now, STEP).ok().filter(|next| !is_flat(next));
        let Some(next) = next else {
            let tilt = if now.tilt < FRAC_PI_2 { 0.9 * FLAT } else { PI - 0.9 * FLAT };
            states.push(Rolling { tilt, omega_1: 0.0, omega_2: 0.0, omega_3: 0.0, ..now });
            return states;
        };
        now = next;
    }
    states.push(now);
    states
}
