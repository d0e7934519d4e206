//! The wobble plate: equations (34) to (45), (1) and (2), each by a route that shares no code with it.

mod engine;
mod plate;
mod unbalance;

use crate::common::between;
use mechanics::scenes::wobble_plate::{Engine, PistonParameters, Pistons, Plate, PlateParameters};
use nalgebra::Vector3;
use std::f64::consts::TAU;

const ROUNDING: f64 = 1e-13;

/// Mass, radius, thickness, tilt and spin of any plate.
fn numbers(random: &mut fastrand::Rng) -> [f64; 5] {
    let radius = between(random, 0.01, 10.0);
    [
        between(random, 0.01, 100.0),
        radius,
        radius * random.f64(),
        1.5 * random.f64(),
        between(random, 0.1, 1e3),
    ]
}

/// Elements of mass of a plate that stands in the room at a phase, with Gauss's points along radius and thickness and
/// equal steps round the axis, which add up all squares exactly. Built from the cylinder and two plain rotations.
fn elements([mass, radius, thickness, tilt, _]: [f64; 5], phase: f64) -> Vec<(f64, Vector3<f64>)> {
    const GAUSS: [(f64, f64); 3] =
        [(-0.774_596_669_241_483_4, 5.0), (0.0, 8.0), (0.774_596_669_241_483_4, 5.0)];
    let mut elements = Vec::new();
    for (place_r, weight_r) in GAUSS {
        for (place_z, weight_z) in GAUSS {
            for n in 0..8 {
                let r = 0.5 * radius * (1.0 + place_r);
                let (sin, cos) = (TAU * f64::from(n) / 8.0).sin_cos();
                let flat = Vector3::new(r * cos, r * sin, 0.5 * thickness * place_z);
                // Tilt about y so that the normal leans towards −x, then turn about z.
                let (s, c) = tilt.sin_cos();
                let tilted = Vector3::new(c * flat.x - s * flat.z, flat.y, s * flat.x + c * flat.z);
                let (s, c) = phase.sin_cos();
                let turned = Vector3::new(c * tilted.x - s * tilted.y, s * tilted.x + c * tilted.y, tilted.z);
                elements.push((weight_r * weight_z * r, turned));
            }
        }
    }
    let total: f64 = elements.iter().map(|(weight, _)| weight).sum();
    elements.iter().map(|(weight, place)| (weight * mass / total, *place)).collect()
}

/// `Σ r × (ω × r) dm` in the room.
fn summed_momentum(numbers: [f64; 5], phase: f64) -> Vector3<f64> {
    let omega = Vector3::new(0.0, 0.0, numbers[4]);
    elements(numbers, phase).iter().map(|(mass, r)| r.cross(&omega.cross(r)) * *mass).sum()
}

fn plate([mass, radius, thickness, tilt, _]: [f64; 5]) -> Plate {
    Plate::new(PlateParameters { mass, radius, thickness, tilt }).expect("a plate")
}

fn thin(mass: f64, radius: f64, tilt: f64) -> Plate {
    plate([mass, radius, 0.0, tilt, 0.0])
}

fn pistons(count: u32, mass: f64, distance: f64, rod: f64) -> Pistons {
    Pistons::new(PistonParameters { count, mass, distance, rod }).expect("pistons")
}

fn engine(random: &mut fastrand::Rng, count: u32) -> (Engine, f64, f64) {
    let pistons = pistons(count, between(random, 0.01, 10.0), between(random, 0.01, 1.0), random.f64());
    let numbers = numbers(random);
    (Engine::new(plate(numbers), pistons), numbers[4], TAU * random.f64())
}
