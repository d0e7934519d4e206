//! The unbalanced drum at constant speed, from any start.

use crate::long::{Long, long};
use crate::search::{Case, Draw, search};
use crate::taylor::System;
use mechanics::scenes::laundromat::{Machine, Parameters, Shaft};

/// Units in the last place that the documentation calls a few.
const FEW: f64 = 10.0 * f64::EPSILON;

/// A machine with ω₀ = b = 1, and a start.
fn machine(draw: &mut Draw<'_>) -> Option<(Machine, f64, f64, Shaft)> {
    let damping = match draw.below(3) {
        0 => draw.beside(2.0),
        1 => 0.0,
        _ => draw.decades(1e-12, 1e4),
    };
    let spin = if draw.below(2) == 0 { draw.beside(1.0) } else { draw.signed(1e-3, 1e2) };
    let start = Shaft::from_array(std::array::from_fn(|_| draw.signed(1e-3, 10.0)));
    let machine = Machine::new(Parameters {
        drum_mass: 0.0,
        load_mass: 1.0,
        load_radius: 1.0,
        stiffness: 1.0,
        damping,
        spin,
    });
    Some((machine.ok()?, damping, spin, start))
}

/// x, y, ẋ, ẏ at a time, by series.
fn judge(damping: f64, spin: f64, start: Shaft, time: f64) -> [Long; 4] {
    let (mut system, [x, y, vx, vy, c, s]) = System::new();
    let [one, spin, damping] = [1.0, spin, damping].map(long);
    system.rate(x, &[(one, vx)]);
    system.rate(y, &[(one, vy)]);
    system.rate(vx, &[(spin * spin, c), (-one, x), (-damping, vx)]);
    system.rate(vy, &[(spin * spin, s), (-one, y), (-damping, vy)]);
    system.rate(c, &[(-spin, s)]);
    system.rate(s, &[(spin, c)]);
    let [a, b, d, e] = start.to_array().map(long);
    let sample = system.sample(&[a, b, d, e, one, long(0.0)], &[long(time)]).remove(0);
    std::array::from_fn(|i| sample[i])
}

#[test]
fn the_transient_is_exact_to_a_few_units_of_the_largest_that_takes_part() {
    let worst = search("transient", 400, |draw| {
        let (machine, damping, spin, start) = machine(draw)?;
        // Long enough for a few turns of what is quickest, either way.
        let quickest = 1.0 + spin.abs() + damping;
        let time = draw.signed(1e-3, 30.0) / quickest;
        let truth = judge(damping, spin, start, time);
        let ours = machine.transient(start).ok()?.at(time).map_err(|error| println!("{error}")).ok()?;
        let error = |n: usize| (truth[n] - ours.to_array()[n]).abs().rounded();
        let size = |n: usize| truth[n].abs().rounded();
        let circle = machine.steady().map_or(0.0, |steady| steady.radius());
        let place =
            1.0 + circle.min(spin.abs() * time.abs() + 1.0) + start.position.norm() + size(0).max(size(1));
        let rate = 1.0 + spin.abs() * (1.0 + circle) + start.velocity.norm() + size(2).max(size(3));
        let ratio = (error(0).max(error(1)) / place).max(error(2).max(error(3)) / rate) / FEW;
        let way = match (damping < 2.0, (spin.abs() - 1.0).abs() < 0.25) {
            (true, true) => "light, near resonance",
            (true, false) => "light",
            (false, _) => "critical or heavy",
        };
        Some(Case {
            ratio, way, said: format!("Γ {damping:?}, Ω {spin:?}, {start:?}, t {time:?}: {ours:?}")
        })
    });
    worst.keeps_its_promise(&["light", "light, near resonance", "critical or heavy"]);
}
