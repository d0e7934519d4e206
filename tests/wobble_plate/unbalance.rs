//! Pistons of any masses and places: what they leave, by Newton's law piston by piston and speck by speck.

use super::{between, elements, numbers, plate};
use approx::assert_relative_eq;
use mechanics::scenes::wobble_plate::{Engine, Piston, PistonParameters, Pistons, Plate, Unbalance};
use nalgebra::Vector3;
use std::f64::consts::TAU;

fn any_pistons(random: &mut fastrand::Rng) -> Vec<Piston> {
    let count = random.usize(0..7);
    (0..count)
        .map(|_| Piston {
            mass: between(random, 0.01, 10.0),
            distance: between(random, 0.01, 1.0),
            azimuth: TAU * random.f64(),
        })
        .collect()
}

/// Where a rod's end is, on the plane that contains the plate's steepest line and its level one.
fn end_of_rod(piston: &Piston, tilt: f64, phase: f64) -> Vector3<f64> {
    let (sin, cos) = piston.azimuth.sin_cos();
    let [x, y] = [piston.distance * cos, piston.distance * sin];
    // Perpendicular to the normal, (−sin α cos ωt, −sin α sin ωt, cos α).
    let (s, c) = phase.sin_cos();
    Vector3::new(x, y, tilt.sin() * (c * x + s * y) / tilt.cos())
}

/// Torque about the centre and force along the shaft that all the mass takes, by second differences of its places, for
/// a spin of 1 rad/s; and the kinetic energy of the pistons.
fn by_newton(numbers: [f64; 5], pistons: &[Piston], phase: f64) -> (Vector3<f64>, f64, f64) {
    let h = 1e-3;
    let [before, now, after] = [phase - h, phase, phase + h].map(|phase| {
        let rods = pistons.iter().map(|piston| (piston.mass, end_of_rod(piston, numbers[3], phase)));
        elements(numbers, phase).into_iter().chain(rods).collect::<Vec<_>>()
    });
    let specks = now.len() - pistons.len();
    let (mut torque, mut force, mut energy) = (Vector3::zeros(), 0.0, 0.0);
    for n in 0..now.len() {
        let (mass, place) = now[n];
        let acceleration = (before[n].1 + after[n].1 - 2.0 * place) / (h * h);
        torque += place.cross(&acceleration) * mass;
        if n >= specks {
            force += mass * acceleration.z;
            energy += 0.5 * mass * ((after[n].1 - before[n].1) / (2.0 * h)).norm_squared();
        }
    }
    (torque, force, energy)
}

#[test]
fn the_unbalance_of_any_pistons_is_what_newton_finds() {
    let mut random = fastrand::Rng::with_seed(461);
    for _ in 0..60 {
        let mut numbers = numbers(&mut random);
        numbers[2] *= 3.0; // thin, thick and too thick
        numbers[3] = 1.2 * random.f64();
        let (plate, pistons, spin) = (plate(numbers), any_pistons(&mut random), numbers[4]);
        let left = Unbalance::of(&plate, &pistons).unwrap();
        let size = plate.moments().to_array()[2]
            + pistons.iter().map(|p| p.mass * p.distance * p.distance).sum::<f64>() * plate.tilt().tan();
        let weight = pistons.iter().map(|p| p.mass * p.distance).sum::<f64>() * plate.tilt().tan();
        let [least, greatest] = left.torque_range(spin);
        let mut found = [f64::INFINITY, 0.0];
        let mut hardest: f64 = 0.0;
        let mut energies = Vec::new();
        for step in 0..200 {
            let phase = TAU * f64::from(step) / 200.0;
            let (torque, force, energy) = by_newton(numbers, &pistons, phase);
            assert_relative_eq!(left.torque(phase, 1.0), torque, epsilon = 1e-5 * size);
            found = [found[0].min(torque.norm()), found[1].max(torque.norm())];
            hardest = hardest.max(force.abs());
            energies.push(energy);
        }
        let square = spin * spin;
        assert_relative_eq!(greatest / square, found[1], epsilon = 1e-3 * size);
        // The least is met between two steps.
        assert!((least / square - found[0]).abs() < 2e-2 * size, "{least} {found:?}");
        assert_relative_eq!(left.greatest_force(spin) / square, hardest, epsilon = 1e-3 * weight.max(1e-9));
        // The energy swings by |Q|/2 tan²α about a quarter of Σ m r² tan²α, eq:uneven-energy.
        let tan2 = plate.tilt().tan().powi(2);
        let swing = energies.iter().fold(0.0, |most: f64, e| most.max(*e))
            - energies.iter().fold(f64::INFINITY, |least, e| least.min(*e));
        assert_relative_eq!(swing, 0.5 * left.backward.norm() * tan2, epsilon = 1e-3 * size * (1.0 + tan2));
    }
}

#[test]
fn pistons_that_are_alike_leave_what_the_engine_says() {
    let mut random = fastrand::Rng::with_seed(462);
    for count in 1..=9 {
        let numbers = numbers(&mut random);
        let (mass, distance) = (between(&mut random, 0.01, 10.0), between(&mut random, 0.01, 1.0));
        let alike = PistonParameters { count, mass, distance, rod: 0.2 };
        let engine = Engine::new(plate(numbers), Pistons::new(alike).unwrap());
        let pistons = (1..=count).map(|n| {
            let place = engine.contact(n, 0.0);
            Piston { mass, distance, azimuth: place.y.atan2(place.x) }
        });
        let left = Unbalance::of(&engine.plate(), &pistons.collect::<Vec<_>>()).unwrap();
        for n in 0..10 {
            let phase = 0.7 * f64::from(n);
            let torque = engine.frame_torque(phase, 3.0);
            let scale = left.torque_range(3.0)[1] + engine.plate().bearing_torque_rotating(3.0).norm();
            assert_relative_eq!(left.torque(phase, 3.0), torque, epsilon = 1e-13 * scale);
        }
        // The sums over roots of unity: the second harmonic for one and two, the first for one alone.
        let whole = f64::from(count) * mass * distance;
        assert_eq!(left.backward.norm() > 1e-12 * whole * distance, count < 3, "{count}");
        assert_eq!(left.along.norm() > 1e-12 * whole, count < 2, "{count}");
    }
}

/// The chapter's plate of any thickness.
fn usual(thickness: f64, tilt: f64) -> Plate {
    plate([2.0, 0.1, thickness, tilt, 0.0])
}

#[test]
fn faults_of_a_balanced_engine_leave_what_the_table_says() {
    for count in 3..=9_u32 {
        for thickness in [0.0, 0.1] {
            let (tilt, n) = (0.4, f64::from(count));
            let plate = usual(thickness, tilt);
            let distance = 0.07;
            let alike = PistonParameters { count, mass: 0.0, distance, rod: 0.2 };
            let mass = plate.balancing_mass(&Pistons::new(alike).unwrap()).unwrap();
            let even: Vec<Piston> =
                (0..count).map(|k| Piston { mass, distance, azimuth: TAU * f64::from(k) / n }).collect();
            let alone = plate.bearing_torque_rotating(1.0).norm();
            let push = mass * distance * tilt.tan();
            let spoilt = |spoil: &dyn Fn(&mut [Piston]), plate: &Plate| {
                let mut pistons = even.clone();
                spoil(&mut pistons);
                let left = Unbalance::of(plate, &pistons).unwrap();
                let [least, most] = left.torque_range(1.0).map(|torque| torque / alone);
                [least, most, left.greatest_force(1.0) / push]
            };
            let near = |found: [f64; 3], expected: [f64; 3]| {
                for (found, expected) in found.into_iter().zip(expected) {
                    assert_relative_eq!(found, expected, epsilon = 1e-13);
                }
            };
            let (part, angle) = (0.1, 0.2_f64);
            near(spoilt(&|_| (), &plate), [0.0; 3]);
            near(spoilt(&|all| all.iter_mut().for_each(|p| p.mass *= 1.0 + part), &plate), [part, part, 0.0]);
            near(spoilt(&|all| all[1].mass *= 1.0 + part, &plate), [0.0, 2.0 * part / n, part]);
            let off = 2.0 / n * angle.sin();
            near(spoilt(&|all| all[1].azimuth += angle, &plate), [off, off, 2.0 * (0.5 * angle).sin()]);
            // Another tilt, in parts of the torque that the plate has at that tilt.
            let steeper = usual(thickness, 0.5);
            let rest = 1.0 - (0.4_f64.cos() / 0.5_f64.cos()).powi(2);
            let [least, most, _] = spoilt(&|_| (), &steeper);
            let there = steeper.bearing_torque_rotating(1.0).norm() / alone;
            assert_relative_eq!(least / there, rest.abs(), epsilon = 1e-13);
            assert_relative_eq!(most / there, rest.abs(), epsilon = 1e-13);
        }
    }
}

#[test]
fn no_two_pistons_balance_and_three_do_if_the_shaft_is_their_orthocentre() {
    let mut random = fastrand::Rng::with_seed(463);
    let plate = usual(0.0, 0.4);
    for _ in 0..200 {
        // Two without a force: something is left of every mass and place.
        let [mass, distance] = [(); 2].map(|()| between(&mut random, 0.01, 10.0));
        let (other, azimuth) = (between(&mut random, 0.01, 10.0), TAU * random.f64());
        let two = [
            Piston { mass, distance, azimuth },
            Piston { mass: other, distance: mass * distance / other, azimuth: azimuth + 0.5 * TAU },
        ];
        let left = Unbalance::of(&plate, &two).unwrap();
        assert!(left.along.norm() < 1e-12 * mass * distance);
        assert!(left.backward.norm() > 0.99 * mass * distance * distance);
    }
    // Three with their orthocentre on the shaft, by choosing equal products of any two places.
    for _ in 0..200 {
        let (first, product) = (0.02 + random.f64(), 0.01 + random.f64());
        let (x, y) = (-product / first, 0.1 + random.f64());
        let places = [[first, 0.0], [x, y], [x, -(product + x * x) / y]];
        let weight = |[x, y]: [f64; 2]| 1.0 / (x * x + y * y + product);
        let three =
            places.map(|[x, y]| Piston { mass: weight([x, y]), distance: x.hypot(y), azimuth: y.atan2(x) });
        let left = Unbalance::of(&plate, &three).unwrap();
        let whole: f64 = three.iter().map(|p| p.mass * p.distance * p.distance).sum();
        let arms: f64 = three.iter().map(|p| p.mass * p.distance).sum();
        assert!(left.backward.norm() < 1e-12 * whole && left.along.norm() < 1e-12 * arms);
        // With the same masses and the shaft beside it, something is left.
        let moved = three.map(|p| {
            let place = [p.distance * p.azimuth.cos() + 0.1, p.distance * p.azimuth.sin()];
            Piston { mass: p.mass, distance: place[0].hypot(place[1]), azimuth: place[1].atan2(place[0]) }
        });
        assert!(Unbalance::of(&plate, &moved).unwrap().along.norm() > 0.01 * arms);
    }
}

#[test]
fn a_body_that_is_too_tall_is_balanced_by_weights_at_every_tilt() {
    for thickness in [0.18, 0.25, 0.5] {
        for tilt in [0.1_f64, 0.7, 1.3] {
            let numbers = [2.0, 0.1, thickness, tilt, 1.0];
            let difference = 2.0 * (0.01 / 4.0 - thickness * thickness / 12.0);
            let weight = -difference / (2.0 * 0.1 * 0.1); // eq:rim-weights, on the rim
            let mut product: f64 = 0.0;
            let end = Vector3::new(tilt.cos(), 0.0, tilt.sin()) * 0.1;
            for (mass, place) in elements(numbers, 0.0).into_iter().chain([(weight, end), (weight, -end)]) {
                product += mass * place.x * place.z;
            }
            assert!(product.abs() < 1e-14 && weight > 0.0, "{product}");
        }
    }
}
