//! The drum with friction on board, from any start.

use crate::linear::carried;
use crate::long::long;
use crate::search::{Case, keeps_its_promise, worse};
use crate::transient::{Units, damping, start};
use mechanics::scenes::laundromat::{Machine, Shaft};
use nalgebra::Complex;

/// The documented error, in units in the last place of what the documentation names.
const UNITS: f64 = 20.0 * f64::EPSILON;

/// A machine with ω₀ = b = 1 in these units, and its shaft after a time, unless that is beyond the range of numbers.
fn judged(units: Units, [outer, inner, spin]: [f64; 3], start: Shaft, time: f64) -> Option<Case> {
    let machine: Machine = units.machine(outer, spin);
    // The damping in units of the machine's own, whose mass is one.
    let rotor = machine.rotor(inner * machine.total_mass() / units.time).expect("a rotor");
    let growth = rotor.growth() * units.time;
    if growth.abs() * time > 600.0 {
        return None; // a motion that is gone, or grown beyond the largest number
    }
    if spin == 0.0 && start == Shaft::AT_REST {
        return None; // no motion
    }
    let [none, one, w, g, i] = [0.0, 1.0, spin, outer, inner].map(long);
    let mut matrix = [[none; 6]; 6];
    // x, y, ẋ, ẏ, and the direction of the load.
    (matrix[0][2], matrix[1][3]) = (one, one);
    (matrix[2][0], matrix[3][1]) = (-one, -one);
    (matrix[2][2], matrix[3][3]) = (-g - i, -g - i);
    (matrix[2][1], matrix[3][0]) = (-i * w, i * w);
    (matrix[2][4], matrix[3][5]) = (w * w, w * w);
    (matrix[4][5], matrix[5][4]) = (-w, w);
    // What dies out keeps its digits if all that is left is multiplied by an exponential.
    let lift = long((-growth).max(0.0));
    for (i, row) in matrix.iter_mut().enumerate() {
        row[i] = row[i] + lift;
    }
    let [x, y, vx, vy] = start.to_array().map(long);
    let lowered = (-lift * time).exp();
    let truth = carried(&matrix, &[x, y, vx, vy, one, none], long(time)).map(|number| number * lowered);

    let ours = units
        .own(rotor.transient(units.si(start)).expect("a motion").at(time * units.time).expect("an answer"));
    let grown = 1.0 + spin * spin * time * (1.0 + time) * (growth * time).exp().max(1.0);
    let circle = machine.steady().map_or(grown, |steady| {
        let near = Complex::new(growth, 0.0).norm() < 0.25 && (spin.abs() - 1.0).abs() < 0.5;
        (steady.radius() / machine.offset()).min(if near { grown } else { f64::INFINITY })
    });
    let factor = (growth * time).exp();
    let [place, rate] = [start.position.norm() + circle, start.velocity.norm() + spin.abs() * circle];
    let turned = 1.0 + (spin.abs() + 1.0 + outer + inner) * time;
    // How long a velocity lasts: beside the growing root it makes a distance of |1 − e^{−dt}|/|d|, where the roots are d apart.
    let apart = (rotor.roots()[0] - rotor.roots()[1]) * units.time;
    let split = apart.norm();
    let lasts = time.min((1.0 + (-apart.re.abs() * time).exp()) / split).max(1.0);
    let size = circle + (place + (rate + place * (outer + inner)) * lasts) * factor;
    let mut ratio = 0.0_f64;
    for (n, ours) in ours.to_array().into_iter().enumerate() {
        let size = if n < 2 { size } else { size * (1.0 + spin.abs() + outer + inner) };
        ratio = worse(ratio, (truth[n] - ours).abs().rounded() / (size * turned) / UNITS);
    }
    let way = match (rotor.roots()[0] * units.time - Complex::new(0.0, spin)).norm() < 0.25 {
        true => "near resonance",
        false if split < 1.0 => "roots near each other",
        false if growth > 0.0 => "growing",
        false => "dying out",
    };
    let said = format!("{units:?}, Γ {outer:?}, Γᵢ {inner:?}, Ω {spin:?}, {start:?}, t {time:?}: {ours:?}");
    Some(Case { ratio, way, said })
}

#[test]
fn the_motion_with_friction_on_board_is_exact_to_units_of_the_circle_and_of_what_the_start_becomes() {
    let ways = ["near resonance", "roots near each other", "growing", "dying out"];
    keeps_its_promise("whirl", 1500, &ways, |draw| {
        let outer = damping(draw);
        // Any damping on board, or so much that both together are next to critical.
        let inner = if draw.below(2) == 0 { damping(draw) } else { (draw.beside(2.0) - outer).max(0.0) };
        let spin = match draw.below(3) {
            0 => draw.beside(1.0),
            1 => draw.signed(1e-3, 1e2),
            _ => draw.signed(1e-12, 1e-3),
        };
        let start = if draw.below(4) == 0 { Shaft::AT_REST } else { start(draw) };
        let units = Units::drawn(draw);
        let quickest = 1.0 + spin.abs() + outer + inner;
        let time = match draw.below(2) {
            0 => draw.decades(1e-3, 30.0) / quickest,
            _ => draw.decades(1e-3, 300.0),
        };
        judged(units, [outer, inner, spin], start, time)
    });
}

#[test]
fn a_circle_that_has_grown_and_roots_next_to_critical_damping_are_within_the_promise() {
    // From rest the start has nothing that could grow, but the circle has.
    let grown = judged(Units::SI, [0.0, 0.3, 3.0], Shaft::AT_REST, 100.0);
    let moving = Shaft { velocity: Complex::new(0.0, 0.92), ..Shaft::AT_REST };
    let critical = judged(Units::SI, [1.995_925_7, 0.0, 0.0], moving, 298.56);
    // Of roots that differ in how fast they turn alone a velocity makes twice the distance that it does of real ones.
    let thrown = Shaft {
        position: Complex::new(-0.074_309_505_750_253_15, -0.057_492_050_045_007_53),
        velocity: Complex::new(-4.250_568_820_471_983, -0.052_454_225_298_097_7),
    };
    let damping = [8.815_922_410_121_363e-5, 1.999_880_592_516_878_6, 0.0];
    let nearly_critical = judged(Units::SI, damping, thrown, 299.999_999_999_999_94);
    for case in [grown, critical, nearly_critical] {
        let case = case.expect("a motion");
        assert!(case.ratio < 1.0, "{:.3} of the promise: {}", case.ratio, case.said);
    }
}
