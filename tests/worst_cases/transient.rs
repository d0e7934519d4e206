//! The unbalanced drum at constant speed, from any start.

use crate::linear::carried;
use crate::long::{Long, long};
use crate::search::{Case, Draw, is_long, keeps_its_promise, worse};
use mechanics::scenes::laundromat::{Machine, MachineParameters, Shaft};
use mechanics::{InvalidQuantity, Motion};
use nalgebra::Complex;

/// The documented error, in units in the last place of what the documentation names.
const UNITS: f64 = 10.0 * f64::EPSILON;

/// The damping rate of a machine with ω₀ = 1: any, or next to critical.
pub(crate) fn damping(draw: &mut Draw<'_>) -> f64 {
    match draw.below(3) {
        0 => draw.beside(2.0),
        1 => draw.decades(1e-12, 1e4),
        _ => 0.0,
    }
}

/// A start of any size and direction.
pub(crate) fn start(draw: &mut Draw<'_>) -> Shaft {
    Shaft::from_array(std::array::from_fn(|_| draw.signed(1e-3, 10.0)))
}

/// Units of mass, length and time, powers of two, so that a motion in other units is the same to the last bit.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Units {
    mass: f64,
    length: f64,
    pub(crate) time: f64,
}

impl Units {
    pub(crate) const SI: Self = Self { mass: 1.0, length: 1.0, time: 1.0 };

    pub(crate) fn drawn(draw: &mut Draw<'_>) -> Self {
        let mut power = || draw.binary_unit(30);
        Self { mass: power(), length: power(), time: power() }
    }

    /// A machine with ω₀ = b = 1 in these units.
    pub(crate) fn machine(&self, damping: f64, spin: f64) -> Machine {
        let parameters = MachineParameters {
            drum_mass: 0.5 * self.mass,
            load_mass: 0.5 * self.mass,
            load_radius: 2.0 * self.length,
            stiffness: self.mass / (self.time * self.time),
            damping: damping * self.mass / self.time,
            spin: spin / self.time,
        };
        Machine::new(parameters).expect("a machine")
    }

    /// A state in SI units, from one in these.
    pub(crate) fn si(&self, shaft: Shaft) -> Shaft {
        let speed = self.length / self.time;
        Shaft { position: shaft.position * self.length, velocity: shaft.velocity * speed }
    }

    /// A state in these units, from one in SI.
    pub(crate) fn own(&self, shaft: Shaft) -> Shaft {
        Units { length: self.length.recip(), time: self.time.recip(), ..*self }.si(shaft)
    }
}

/// x, y, ẋ, ẏ at a time, and what the free motion makes by then of one metre and of one metre a second, position and
/// velocity.
pub(crate) struct Truth {
    pub(crate) state: [Long; 4],
    pub(crate) of_place: [f64; 2],
    pub(crate) of_rate: [f64; 2],
}

impl Truth {
    /// What a place and a rate at the start have become, position and velocity. The judge has no digits of what
    /// has died out.
    pub(crate) fn carried(&self, [place, rate]: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|i| place * (self.of_place[i] + 1e-9) + rate * (self.of_rate[i] + 1e-9))
    }

    /// What a change of the time by a unit in its last place does: velocity and acceleration times the time.
    pub(crate) fn later(&self, time: f64, damping: f64) -> [f64; 2] {
        let [x, y, vx, vy] = self.state.map(|number| (number.rounded() * time).abs());
        [vx.max(vy), damping * vx.max(vy) + x.max(y)]
    }

    /// The largest error of one answer and of one among many, where so much is promised of numbers of these sizes, and
    /// what is off.
    pub(crate) fn worst(
        &self,
        answers: [Shaft; 2],
        [places, rates]: [f64; 2],
        units: f64,
    ) -> (f64, &'static str) {
        let names = [["x", "y", "ẋ", "ẏ"], ["sampled x", "sampled y", "sampled ẋ", "sampled ẏ"]];
        let mut worst = (0.0, "");
        for (names, shaft) in names.into_iter().zip(answers) {
            for (i, size) in [places, places, rates, rates].into_iter().enumerate() {
                let ratio = error(self.state[i], shaft.to_array()[i], size) / units;
                if worse(ratio, worst.0) > worst.0 {
                    worst = (worse(ratio, worst.0), names[i]);
                }
            }
        }
        worst
    }
}

/// The error of a number in parts of itself and of a size.
fn error(truth: Long, ours: f64, size: f64) -> f64 {
    (truth - ours).abs().rounded() / (size + truth.abs().rounded())
}

fn truth(damping: f64, spin: f64, start: Shaft, time: f64) -> Truth {
    let [none, one, spin, damping] = [0.0, 1.0, spin, damping].map(long);
    let mut matrix = [[none; 10]; 10];
    // x, y, ẋ, ẏ, the two free motions, and the direction of the load.
    for (place, rate, force) in [(0, 2, Some(8)), (1, 3, Some(9)), (4, 5, None), (6, 7, None)] {
        matrix[place][rate] = one;
        (matrix[rate][place], matrix[rate][rate]) = (-one, -damping);
        if let Some(force) = force {
            matrix[rate][force] = spin * spin;
        }
    }
    (matrix[8][9], matrix[9][8]) = (-spin, spin);
    let [x, y, vx, vy] = start.to_array().map(long);
    let end = carried(&matrix, &[x, y, vx, vy, one, none, none, one, one, none], long(time));
    let size = |i: usize| end[i].abs().rounded();
    Truth {
        state: [end[0], end[1], end[2], end[3]],
        of_place: [size(4), size(5)],
        of_rate: [size(6), size(7)],
    }
}

/// Which form the library takes: by the roots −Γ/2 ± iω₁, and by how near iΩ is to one of them.
fn way(damping: f64, spin: f64, time: f64) -> &'static str {
    if damping >= 2.0 {
        return if time < 0.0 { "real roots, before" } else { "real roots, after" };
    }
    let turning = ((1.0 - 0.5 * damping) * (1.0 + 0.5 * damping)).sqrt();
    let near = Complex::new(0.5 * damping, spin.abs() - turning).norm() < 0.25;
    match (near, time < 0.0) {
        (false, false) => "light, after",
        (false, true) => "light, before",
        (true, false) => "light near resonance, after",
        (true, true) => "light near resonance, before",
    }
}

#[test]
fn the_transient_is_exact_to_units_of_the_circle_the_motion_and_what_the_start_makes_of_itself() {
    let ways = [
        "light, after",
        "light, before",
        "light near resonance, after",
        "light near resonance, before",
        "real roots, after",
        "real roots, before",
    ];
    keeps_its_promise("transient", 1500, &ways, |draw| {
        let damping = damping(draw);
        let spin = if draw.below(2) == 0 { draw.beside(1.0) } else { draw.signed(1e-3, 1e2) };
        let start = start(draw);
        let units = Units::drawn(draw);
        let machine = units.machine(damping, spin);
        // A few turns of what is quickest, either way, or of what is slow, or a million of them.
        let quickest = 1.0 + spin.abs() + damping;
        let time = match draw.below(3) {
            0 => draw.signed(1e-3, 30.0) / quickest,
            1 => draw.signed(1e-3, 30.0),
            _ => draw.decades(1.0, 1e7) / quickest,
        };
        if damping * time.abs() > 200.0 {
            return None; // a motion that is gone, or grown beyond the judge
        }
        let truth = truth(damping, spin, start, time);
        let motion = machine.transient(units.si(start)).expect("a motion");
        let then = time * units.time;
        let shaft = motion.at(then).expect("an answer");
        let centre = motion.centre_of_mass(then).expect("an answer") / units.length;
        let formed = machine.centre_of_mass(then, &shaft) / units.length;
        let sampled = motion.sample(&[then]).expect("an answer")[0];
        let (ours, sampled) = (units.own(shaft), units.own(sampled));

        // The circles, or near resonance what they have become by then.
        let grown = 1.0 + spin * spin * time.abs() * (1.0 + time.abs());
        let [circle, its_centre] = machine.steady().map_or([grown; 2], |steady| {
            [steady.radius(), steady.centre_of_mass_radius()].map(|radius| (radius / units.length).min(grown))
        });
        let [place, rate] = [start.position.norm() + circle, start.velocity.norm() + spin.abs() * circle];
        let ([carried, carried_rate], [later, later_rate]) =
            (truth.carried([place, rate]), truth.later(time, damping));
        let sizes = [circle + carried + later, spin.abs() * circle + carried_rate + later_rate];
        let (mut ratio, mut what) = truth.worst([ours, sampled], sizes, UNITS);
        // Of the centre of mass its own circle and velocity count, however large the shaft's; of the one that is formed
        // from the shaft one expects no more than its sum has.
        let (sin, cos) = (long(spin) * time).sin_cos();
        let [vx, vy] = [truth.state[2] - sin * spin, truth.state[3] + cos * spin];
        let moved = ((vx.abs() + vy.abs()) * time).abs().rounded();
        let start = [start.position.norm() + 1.0, start.velocity.norm() + spin.abs()];
        let around = its_centre + truth.carried(start)[0] + moved;
        for (name, ours, size) in
            [("shaft and load", formed, sizes[0] + 1.0), ("centre of mass", centre, around)]
        {
            let errors =
                [error(truth.state[0] + cos, ours.re, size), error(truth.state[1] + sin, ours.im, size)];
            let away = worse(errors[0], errors[1]) / UNITS;
            if worse(away, ratio) > ratio {
                (ratio, what) = (worse(away, ratio), name);
            }
        }
        let said = format!("{units:?}, Γ {damping:?}, Ω {spin:?}, {start:?}, t {time:?}: {what}, {ours:?}");
        Some(Case { ratio, way: way(damping, spin, time), said })
    });
}

/// A machine and a start of any size at all, and times near enough to be reached or not.
pub(crate) fn hostile(draw: &mut Draw<'_>) -> Option<(Machine, Shaft, [f64; 40])> {
    let parameters = MachineParameters {
        drum_mass: draw.decades(1e-50, 1e50),
        load_mass: draw.decades(1e-50, 1e50),
        load_radius: draw.decades(1e-50, 1e50),
        stiffness: draw.decades(1e-50, 1e50),
        damping: draw.signed(1e-50, 1e50).abs(),
        spin: draw.signed(1e-50, 1e50),
    };
    let machine = Machine::new(parameters).ok()?;
    let start = Shaft::from_array(std::array::from_fn(|_| draw.signed(1e-50, 1e50)));
    // Where the motion has grown or died by hundreds of powers of e, or been through many turns, or neither.
    let scale = match draw.below(4) {
        0 => 1.0 / machine.damping_rate().max(1e-60),
        1 => 1.0 / machine.natural_frequency(),
        2 => 1.0 / machine.spin().abs().max(1e-60),
        _ => draw.decades(1e-50, 1e50),
    };
    let times = std::array::from_fn(|_| draw.signed(1e-3, 2e3) * scale);
    Some((machine, start, times))
}

/// Zero if a sample is refused, for the first time that `at` refuses, or is all finite as `at` is; else infinite. And
/// whether it is refused.
pub(crate) fn agreement(
    motion: &impl Motion<State = Shaft, Error = InvalidQuantity>,
    times: &[f64],
) -> (f64, &'static str) {
    let singles: Result<Vec<Shaft>, _> = times.iter().map(|&time| motion.at(time)).collect();
    let (agree, way) = match (singles, motion.sample(times)) {
        (Ok(singles), Ok(sampled)) => {
            let mut numbers = singles.iter().chain(&sampled).flat_map(Shaft::to_array);
            (sampled.len() == times.len() && numbers.all(f64::is_finite), "answered")
        }
        (singles, sampled) => (singles.err() == sampled.err(), "refused"),
    };
    (if agree { 0.0 } else { f64::INFINITY }, way)
}

#[test]
fn no_transient_answers_with_what_is_no_number_and_a_sample_refuses_what_one_does() {
    if !is_long() {
        return; // machines of no scene: for the night
    }
    keeps_its_promise("hostile transient", 30_000, &["answered", "refused"], |draw| {
        let (machine, start, times) = hostile(draw)?;
        let motion = machine.transient(start).expect("a motion");
        let (ratio, way) = agreement(&motion, &times);
        Some(Case { ratio, way, said: format!("{machine:?}, {start:?}, {times:?}") })
    });
}

#[test]
fn a_natural_frequency_that_is_no_double_is_in_phase_after_a_billion_seconds() {
    let machine = MachineParameters { stiffness: 2.0, ..Units::SI.machine(0.0, 0.25).parameters() };
    let machine = Machine::new(MachineParameters { load_radius: 0.0, ..machine }).expect("a machine");
    let motion = machine.transient(Shaft::from_array([1.0, 0.0, 0.0, 0.0])).expect("a motion");
    for time in [1e9, 999_999_937.0, 123_456_789.0] {
        let cos = (long(2.0).sqrt() * time).sin_cos().1;
        let ours = motion.at(time).expect("an answer").position.re;
        assert!((cos - ours).abs().rounded() < 4e-15, "{ours} for {cos:?}");
        let naive = (2.0_f64.sqrt() * time).cos();
        assert!((cos - naive).abs().rounded() > 1e-10, "the rounded root should be out of phase");
    }
}

#[test]
fn a_tiny_motion_is_followed_back_until_it_is_huge() {
    // |v + ½Γz|² + ω₁²|z|² of the free motion that this is, long before the start, grows by e^Γ in a second.
    let size = |damping: f64, shaft: Shaft| {
        let [z, v] = [shaft.position, shaft.velocity].map(|part| part * 1e-200);
        ((v + z * (0.5 * damping)).norm_sqr() + (1.0 - 0.25 * damping * damping) * z.norm_sqr()).ln()
    };
    let tiny = Shaft::from_array([3e-45, -1e-45, 2e-45, 1e-45]);
    for (damping, spin, last) in [(1.0, 0.0, -1575.0), (1.0, 3.0, -1575.0), (0.2, 1.0, -7800.0)] {
        let parameters =
            MachineParameters { load_radius: 1e-45, ..Units::SI.machine(damping, spin).parameters() };
        let motion = Machine::new(parameters).unwrap().transient(tiny).unwrap();
        let at = |t: f64| size(damping, motion.at(t).unwrap());
        for back in [0.6, 0.8, 0.9, 0.95, 1.0] {
            let t = back * last;
            let grown = at(t - 2.0) - at(t);
            assert!((grown - 2.0 * damping).abs() < 1e-9, "Γ {damping}, Ω {spin}, t {t}: {grown}");
        }
        assert!(motion.at(1.1 * last).is_err());
    }
}
