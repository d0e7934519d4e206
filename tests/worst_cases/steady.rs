//! What the unbalanced drum does in the long run: its circle, its peak, its modes, and the locked motion.

use crate::linear::carried;
use crate::long::{Long, long};
use crate::search::{Case, Draw, keeps_its_promise, worse};
use mechanics::scenes::laundromat::{LockedState, Machine, MachineParameters};

/// The documented error.
const UNITS: f64 = 8.0 * f64::EPSILON;
/// The same of the slope of the torque, of its largest term.
const SLOPE_UNITS: f64 = 12.0 * f64::EPSILON;

/// A machine of any size, and ω₀², Γ and b to 32 digits.
struct Subject {
    machine: Machine,
    stiffness: Long,
    damping: Long,
    offset: Long,
}

fn subject(draw: &mut Draw<'_>) -> Subject {
    let drum_mass = if draw.below(4) == 0 { 0.0 } else { draw.decades(1e-6, 1e6) };
    let load_mass = draw.decades(1e-6, 1e6);
    let load_radius = draw.decades(1e-3, 1e3);
    let stiffness = draw.decades(1e-6, 1e9);
    let mass = long(drum_mass) + load_mass;
    let rate = (long(stiffness) / mass).sqrt();
    let critical = (mass * rate * 2.0).rounded();
    let damping = match draw.below(5) {
        0 => 0.0,
        1 => draw.beside(critical),
        2 => draw.beside(critical * std::f64::consts::FRAC_1_SQRT_2),
        _ => critical * draw.decades(1e-12, 1e12),
    };
    let spin = if draw.below(2) == 0 {
        draw.beside(rate.rounded())
    } else {
        rate.rounded() * draw.decades(1e-9, 1e9)
    };
    let spin = spin * draw.one_of(&[-1.0, 1.0]);
    let parameters = MachineParameters { drum_mass, load_mass, load_radius, stiffness, damping, spin };
    Subject {
        machine: Machine::new(parameters).expect("a machine"),
        stiffness: long(stiffness) / mass,
        damping: long(damping) / mass,
        offset: long(load_mass) * load_radius / mass,
    }
}

/// The largest relative error of some numbers.
fn worst(pairs: &[(f64, Long)]) -> f64 {
    let relative = |&(ours, truth): &(f64, Long)| truth.off(ours);
    pairs.iter().map(relative).fold(0.0, worse)
}

#[test]
fn every_number_of_the_steady_circle_has_its_digits() {
    keeps_its_promise("steady circle", 20_000, &["at resonance", "elsewhere"], |draw| {
        let Subject { machine, stiffness, damping, offset } = subject(draw);
        let Ok(steady) = machine.steady() else { return None };
        if machine.spin() == 0.0 {
            return None; // nothing goes round
        }
        let spin = long(machine.spin());
        let detuning = stiffness - spin * spin;
        let size = (detuning * detuning + damping * damping * spin * spin).sqrt();
        let radius = offset * spin * spin / size;
        let drag = damping * spin;
        // Z = bΩ²/(κ + iΓΩ), and Z + b = b (ω₀² + iΓΩ)/(κ + iΓΩ).
        let amplitude = [radius * detuning / size, -radius * drag / size];
        let square = size * size;
        let centre = [
            (stiffness * detuning + drag * drag) / square * offset,
            (detuning - stiffness) * drag / square * offset,
        ];
        let near = |ours: [f64; 2], truth: [Long; 2]| {
            let away = (truth[0] - ours[0]).rounded().hypot((truth[1] - ours[1]).rounded());
            away / truth[0].rounded().hypot(truth[1].rounded())
        };
        let (ours, ours_centre) = (steady.amplitude(), steady.centre_of_mass_amplitude());
        let centre_radius = (centre[0] * centre[0] + centre[1] * centre[1]).sqrt();
        let torque = radius * radius * spin * machine.parameters().damping;
        let (sin, cos) = long(steady.phase()).sin_cos();
        let off_phase =
            ((sin * detuning - cos * drag) / size).abs().rounded() / steady.phase().abs().max(1e-300);
        let mut numbers = vec![(steady.radius(), radius), (steady.centre_of_mass_radius(), centre_radius)];
        if machine.damping_rate() > 0.0 {
            numbers.extend([(steady.motor_torque(), torque), (steady.motor_power(), torque * spin)]);
        }
        // dτ/dΩ, from the square of D and its derivative, of the size of the largest of its three terms.
        let of_square = [drag * damping, -spin * detuning * 2.0].map(|part| torque * 2.0 * part / square);
        let terms = [torque * 5.0 / spin, -of_square[0], -of_square[1]];
        let slope = (terms[0] + terms[1] + terms[2] - steady.motor_torque_slope()).abs().rounded();
        let largest = terms.map(|term| term.abs().rounded()).into_iter().fold(0.0, f64::max);
        let off_slope = if largest > 0.0 { slope / largest } else { slope } * (UNITS / SLOPE_UNITS);
        let circles = [near([ours.re, ours.im], amplitude), near([ours_centre.re, ours_centre.im], centre)];
        let error = [worst(&numbers), off_phase, off_slope].into_iter().chain(circles).fold(0.0, worse);
        let way = if detuning.abs() < stiffness * 1e-3 { "at resonance" } else { "elsewhere" };
        Some(Case { ratio: error / UNITS, way, said: format!("{machine:?}: {steady:?}") })
    });
}

#[test]
fn the_peak_has_its_digits_even_where_it_moves_off_to_infinity() {
    keeps_its_promise("peak", 20_000, &["nearly none", "none", "one"], |draw| {
        let Subject { machine, stiffness, damping, offset } = subject(draw);
        let below = stiffness * 2.0 - damping * damping;
        let there = below.rounded() > 0.0 && damping.rounded() > 0.0;
        let ratio = match machine.peak() {
            Some(peak) if there => {
                let spin = stiffness / (below * 0.5).sqrt();
                let radius = offset * stiffness / (damping * (stiffness - damping * damping * 0.25).sqrt());
                worst(&[(peak.spin, spin), (peak.radius, radius)]) / UNITS
            }
            None if !there => 0.0,
            _ => f64::INFINITY,
        };
        let near = below.rounded() < 1e-3 * stiffness.rounded();
        let way = match (there, near) {
            (true, true) => "nearly none",
            (true, false) => "one",
            (false, _) => "none",
        };
        Some(Case { ratio, way, said: format!("{machine:?}: {:?}", machine.peak()) })
    });
}

#[test]
fn the_rates_of_the_modes_have_their_digits_however_heavy_the_damping() {
    keeps_its_promise("modes", 20_000, &["creeping", "turning"], |draw| {
        let Subject { machine, stiffness, damping, .. } = subject(draw);
        // Of e^{iωt} less the spin: ν² − iΓν − ω₀² = 0.
        let below = stiffness - damping * damping * 0.25;
        let [first, second, ..] = machine.modes();
        let spin = machine.spin();
        let (ratio, way) = if below.rounded() > 0.0 {
            let turning = below.sqrt();
            let size = (turning.abs() + spin.abs()).rounded();
            let real = |frequency: f64, truth: Long| (truth + spin - frequency).abs().rounded() / size;
            let decay = damping * 0.5;
            let decays = [(first.frequency.im, decay), (second.frequency.im, decay)];
            let decays = if decay.rounded() > 0.0 { worst(&decays) } else { 0.0 };
            (
                [real(first.frequency.re, turning), real(second.frequency.re, -turning)]
                    .into_iter()
                    .fold(decays, worse),
                "turning",
            )
        } else {
            let fast = damping * 0.5 + (-below).sqrt();
            (worst(&[(first.frequency.im, fast), (second.frequency.im, stiffness / fast)]), "creeping")
        };
        Some(Case { ratio: ratio / UNITS, way, said: format!("{machine:?}: {first:?} {second:?}") })
    });
}

#[test]
fn the_locked_motion_is_exact_to_units_of_what_takes_part() {
    keeps_its_promise("locked", 2000, &["creeps", "runs away", "swings"], |draw| {
        let Subject { machine, stiffness, damping, offset } = subject(draw);
        let Ok(steady) = machine.steady() else { return None };
        let natural = machine.natural_frequency();
        let start =
            [draw.signed(1e-3, 1e3) * offset.rounded(), draw.signed(1e-3, 1e3) * offset.rounded() * natural];
        let spin = long(machine.spin());
        let detuning = stiffness - spin * spin;
        let quickest = damping.rounded() + natural + spin.abs().rounded();
        let time = draw.signed(1e-3, 60.0) / draw.one_of(&[quickest, natural]);
        if quickest * time.abs() > 200.0 {
            return None;
        }
        // r̈ + Γṙ + κr is the force bΩ² cos φ₀ = r₀κ, which is constant; its size from the circle's law.
        let size = (detuning * detuning + damping * damping * spin * spin).sqrt();
        let push = offset * spin * spin * detuning / size;
        let (none, one) = (long(0.0), long(1.0));
        // In units of 1/ω₀, so that the rows of the matrix are alike.
        let rate = long(natural);
        let matrix = [
            [none, one, none],
            [-detuning / (rate * rate), -damping / rate, push / (rate * rate)],
            [none; 3],
        ];
        let free = [matrix[0], [matrix[1][0], matrix[1][1], none], [none; 3]];
        let at = rate * time;
        let truth = carried(&matrix, &[long(start[0]), long(start[1]) / rate, one], at);
        let basis = [carried(&free, &[one, none, none], at), carried(&free, &[none, one, none], at)];
        let motion = machine.locked(LockedState::from_array(start)).ok()?;
        let [r, r_dot] = motion.at(time).expect("an answer").to_array();
        // The judge has no digits of what has died out.
        let part = |i: usize, j: usize| basis[i][j].abs().rounded() + 1e-9;
        let radius = steady.radius();
        // A place counts for as much as the velocity with which it would be lost by damping.
        let place = start[0].abs() + radius;
        let speed = start[1].abs() / natural + place * damping.rounded() / natural;
        // What a change of the time, or of the damping, by a unit in the last place does.
        let grown = 1.0 + (damping * time).abs().rounded();
        let later = |i: usize| (truth[i] * at).abs().rounded();
        let places =
            radius + place * part(0, 0) + speed * part(1, 0) + truth[0].abs().rounded() * grown + later(1);
        let speeds = place * part(0, 1)
            + speed * part(1, 1)
            + truth[1].abs().rounded() * grown
            + quickest / natural * (later(1) + later(0));
        let errors =
            [(truth[0] - r).abs().rounded() / places, (truth[1] - r_dot / natural).abs().rounded() / speeds];
        let error = errors.into_iter().fold(0.0, worse);
        let way = match ((detuning - damping * damping * 0.25).rounded() > 0.0, detuning.rounded() > 0.0) {
            (true, _) => "swings",
            (false, true) => "creeps",
            (false, false) => "runs away",
        };
        let said = format!("{machine:?}, {start:?}, {time:?}: {r:?} {r_dot:?} for {truth:?}");
        Some(Case { ratio: error / UNITS, way, said })
    });
}

#[test]
fn the_slope_of_the_torque_keeps_its_promise_where_its_terms_cancel() {
    // Next to resonance two of its three terms are opposite. The slope and the largest term, by mpmath.
    let machine = Machine::new(MachineParameters {
        drum_mass: 0.002_746_595_663_207_259_6,
        load_mass: 0.614_743_554_234_777_8,
        load_radius: 0.032_215_148_685_852_44,
        stiffness: 68.066_918_242_017_01,
        damping: 3.344_643_605_995_881e-6,
        spin: -10.499_123_081_511_35,
    });
    let slope = machine.and_then(|machine| machine.steady()).expect("a circle").motor_torque_slope();
    let off = (slope - 129_999.773_795_811_95).abs();
    assert!(off < SLOPE_UNITS * 91_221.7, "{slope} is off by {off}");
}
