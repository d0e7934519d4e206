//! The unbalanced drum at constant speed, from any start.

use crate::linear::carried;
use crate::long::{Long, long};
use crate::search::{Case, Draw, search};
use mechanics::scenes::laundromat::{Machine, Parameters, Shaft};
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

/// A machine with ω₀ = b = 1.
pub(crate) fn machine(damping: f64, spin: f64) -> Machine {
    let (drum_mass, load_mass, load_radius) = (0.0, 1.0, 1.0);
    let parameters = Parameters { drum_mass, load_mass, load_radius, stiffness: 1.0, damping, spin };
    Machine::new(parameters).expect("a machine")
}

/// x, y, ẋ, ẏ at a time, and what the free motion makes by then of one metre and of one metre a second, position and velocity.
struct Truth {
    state: [Long; 4],
    of_place: [f64; 2],
    of_rate: [f64; 2],
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
    let end = carried(&matrix, &[x, y, vx, vy, one, none, none, one, one, none], time);
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
    let worst = search("transient", 1500, |draw| {
        let damping = damping(draw);
        let spin = if draw.below(2) == 0 { draw.beside(1.0) } else { draw.signed(1e-3, 1e2) };
        let start = start(draw);
        let machine = machine(damping, spin);
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
        let motion = machine.transient(start).expect("a motion");
        let ours = motion.at(time).expect("an answer");
        let centre = motion.centre_of_mass(time).expect("an answer");
        let mut many = [Shaft::AT_REST];
        motion.fill(&[time], &mut many).expect("an answer");

        // The circles, or near resonance what they have become by then.
        let grown = 1.0 + spin * spin * time.abs() * (1.0 + time.abs());
        let [circle, its_centre] = machine.steady().map_or([grown; 2], |steady| {
            [steady.radius(), steady.centre_of_mass_radius()].map(|radius| radius.min(grown))
        });
        let [place, rate] = [start.position.norm() + circle, start.velocity.norm() + spin.abs() * circle];
        // The judge has no digits of what has died out.
        let carried = |i: usize| place * (truth.of_place[i] + 1e-9) + rate * (truth.of_rate[i] + 1e-9);
        // What a change of the time by a unit in its last place does.
        let later = |i: usize| (truth.state[i].rounded() * time).abs();
        let places = circle + carried(0) + later(2).max(later(3));
        let rates =
            spin.abs() * circle + carried(1) + damping * later(2).max(later(3)) + later(0).max(later(1));
        let (mut ratio, mut what) = (0.0_f64, "");
        let mut see = |name: &'static str, ours: f64, truth: Long, size: f64| {
            let away = (truth - ours).abs().rounded() / (size + truth.abs().rounded()) / UNITS;
            if !(away <= ratio) {
                (ratio, what) = (away, name);
            }
        };
        for (names, shaft) in
            [(["x", "y", "ẋ", "ẏ"], ours), (["many x", "many y", "many ẋ", "many ẏ"], many[0])]
        {
            for (i, size) in [places, places, rates, rates].into_iter().enumerate() {
                see(names[i], shaft.to_array()[i], truth.state[i], size);
            }
        }
        let (sin, cos) = (long(spin) * time).sin_cos();
        see("centre of mass", centre.re, truth.state[0] + cos, places + its_centre);
        see("centre of mass", centre.im, truth.state[1] + sin, places + its_centre);
        let said = format!("Γ {damping:?}, Ω {spin:?}, {start:?}, t {time:?}: {what}, {ours:?}");
        Some(Case { ratio, way: way(damping, spin, time), said })
    });
    worst.keeps_its_promise(&[
        "light, after",
        "light, before",
        "light near resonance, after",
        "light near resonance, before",
        "real roots, after",
        "real roots, before",
    ]);
}
