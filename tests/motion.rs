//! What all motions have in common: a list of times gives the states one by one, and is refused as one of them is.

use mechanics::euler::Turning;
use mechanics::free_rotation::{FreeSymmetricTop, FreeTop};
use mechanics::inertia::{Body, PrincipalMoments};
use mechanics::integrate::Taylor;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::air_drag::{Drag, DraggedTop, DraggedTopParameters};
use mechanics::scenes::ball::{
    Ball, BallParameters, Cloth, ClothParameters, Hole, HoleParameters, HoleStart, ShotStart, Turntable,
    TurntableParameters, TurntableStart,
};
use mechanics::scenes::coin_toss::{Toss, TossParameters};
use mechanics::scenes::laundromat::{LockedState, Machine, MachineParameters, Shaft};
use mechanics::scenes::rolling_wheel::Wheel;
use mechanics::scenes::space_station::{Blow, Station, StationParameters};
use mechanics::scenes::spinning_coin::{Loss, SpinDown, SpinningCoin};
use mechanics::scenes::top::{Release, Top, TopParameters};
use mechanics::{InvalidQuantity, Motion};
use nalgebra::{UnitQuaternion, Vector3};
use std::fmt::{Debug, Display};

/// Asks a motion for lists of many lengths, of times from a range, with times among them that are beyond the reach of
/// what is computed at once, or refused; says how many were answered and refused.
fn ask<M: Motion<State: Debug, Error: Display>>(
    motion: &M,
    [first, last]: [f64; 2],
    same: impl Fn(&M::State, &M::State) -> bool,
) -> [usize; 2] {
    let mut random = fastrand::Rng::with_seed(19);
    let mut counts = [0; 2];
    for length in [0, 1, 31, 32, 33, 100, 600] {
        for odd in [last, 1e40, -1e40, f64::NAN] {
            let mut times: Vec<f64> = (0..length).map(|_| first + (last - first) * random.f64()).collect();
            if let Some(time) = times.get_mut(length / 2) {
                *time = odd;
            }
            let singles: Result<Vec<M::State>, M::Error> =
                times.iter().map(|&time| motion.at(time)).collect();
            match (motion.sample(&times), singles) {
                (Ok(many), Ok(singles)) => {
                    counts[0] += 1;
                    assert_eq!(many.len(), length);
                    for ((one, other), time) in singles.iter().zip(&many).zip(&times) {
                        assert!(same(one, other), "{one:?} {other:?} at {time:e}");
                    }
                }
                (many, singles) => {
                    counts[1] += 1;
                    let [many, one] =
                        [many.err(), singles.err()].map(|error| error.map(|error| error.to_string()));
                    assert_eq!(many, one, "{length} times, {odd} among them");
                }
            }
        }
    }
    counts
}

/// To the last bit: one time and many are computed by the same lines.
fn exactly<M: Motion<State: Debug + PartialEq, Error: Display>>(motion: &M, span: [f64; 2]) {
    let [answered, refused] = ask(motion, span, |one, other| one == other);
    assert!(answered >= 7 && refused >= 6, "{answered} {refused}");
}

/// To rounding: of many, an exponential comes from elsewhere.
fn nearly<M: Motion<State = Shaft, Error = InvalidQuantity>>(motion: &M, span: [f64; 2]) {
    let [answered, refused] = ask(motion, span, |one, other| {
        let (gap, speed) = ((one.position - other.position).norm(), (one.velocity - other.velocity).norm());
        gap < 1e-13 * one.position.norm().max(1e-3) && speed < 1e-13 * one.velocity.norm().max(1e-3)
    });
    assert!(answered >= 7 && refused >= 6, "{answered} {refused}");
}

fn turning(w1: f64, w2: f64, w3: f64) -> Turning {
    let world_from_body = UnitQuaternion::from_euler_angles(0.4, -0.9, 2.2);
    Turning { world_from_body, omega_body: Vector3::new(w1, w2, w3) }
}

#[test]
fn tops_under_gravity() {
    let top = Top::new(TopParameters { mass: 0.1, arm: 0.04, transverse: 2e-4, axial: 5e-5, gravity: 9.81 })
        .unwrap();
    for (tilt, precession, spin) in [(0.5, 0.0, 150.0), (0.1, 1.0, 30.0), (0.0, 0.0, 30.0), (2.0, 3.0, 0.0)] {
        exactly(&top.let_go(Release { tilt, tilt_rate: 0.1, precession, spin }).unwrap(), [-300.0, 300.0]);
    }
}

#[test]
fn free_bodies() {
    let omegas = [[0.3, -0.5, 0.0], [0.3, 0.9, -0.1], [1.0, 1e-9, 0.0], [0.0, -0.8, 0.0], [0.0, 0.0, 0.0]];
    for [i1, i2, i3] in [[1.5, 0.5, 2.0], [3.0, 5.0, 6.0], [0.7, 0.7, 1.0], [0.7, 1.0, 0.7], [0.7; 3]] {
        for [w1, w2, w3] in omegas {
            let moments = PrincipalMoments::new(i1, i2, i3).unwrap();
            exactly(&FreeTop::new(moments, turning(w1, w2, w3)).unwrap(), [-100.0, 100.0]);
        }
    }
    // On the separatrix, whose motion has no period.
    let moments = PrincipalMoments::new(3.0, 5.0, 6.0).unwrap();
    exactly(&FreeTop::new(moments, turning(0.5, 0.1, 0.5)).unwrap(), [-100.0, 100.0]);
    let moments = PrincipalMoments::symmetric(0.25, 0.5).unwrap();
    exactly(&FreeSymmetricTop::new(moments, turning(0.3, -0.2, 1.0)).unwrap(), [-100.0, 100.0]);
    exactly(&Toss::new(TossParameters { moments, omega_1: 40.0, omega_3: 3.0 }).unwrap(), [0.0, 1.0]);
    let station = StationParameters { body: Body::hoop(4e5, 50.0).unwrap(), spin: 0.45 };
    let blow = Blow { radius: 50.0, impulse: 1.8e6 };
    exactly(&Station::new(station).unwrap().struck(blow).unwrap(), [0.0, 1000.0]);
    let omega_body = Vector3::new(3.0, 0.1, 1.0);
    for [transverse, axial] in [[0.0, 0.0], [1e-4, 0.0], [1e-4, 2e-4], [10.0, 1.0]] {
        let given = DraggedTopParameters { moments, drag: Drag { transverse, axial }, omega_body };
        exactly(&DraggedTop::new(given).unwrap(), [0.0, 1e4]);
    }
}

#[test]
fn washing_machines() {
    let machine = |damping: f64, spin: f64| {
        let (drum_mass, load_mass, load_radius, stiffness) = (0.0, 1.0, 1.0, 1.0);
        let given = MachineParameters { drum_mass, load_mass, load_radius, stiffness, damping, spin };
        Machine::new(given).unwrap()
    };
    let start = Shaft::from_array([0.3, -0.2, 0.1, 0.4]);
    // Light damping away from resonance and in it, critical and heavy.
    for (damping, spin) in [(0.01, 3.0), (0.5, -3.0), (0.01, 1.0), (2.0, 3.0), (5.0, 0.2)] {
        let machine = machine(damping, spin);
        nearly(&machine.transient(start).unwrap(), [-10.0, 100.0]);
        nearly(&machine.ramp(0.05, start).unwrap(), [-3.0, 100.0]);
        nearly(&machine.ramp(-0.05, start).unwrap(), [-3.0, 100.0]);
        exactly(&machine.rotor(0.1).unwrap().transient(start).unwrap(), [0.0, 50.0]);
        let beside = LockedState { radius: 1.0, radius_rate: 0.0 };
        exactly(&machine.locked(beside).unwrap(), [-1.0, 10.0]);
    }
}

#[test]
fn disks_that_roll() {
    let disc = DiskParameters { mass: 1.0, radius: 1.0, moments: MomentFactors::DISK, gravity: 1.0 };
    let wheel = Wheel::new(disc).unwrap();
    let start = Rolling { omega_1: -0.15, ..wheel.steady(0.5, 3.0).unwrap().state() };
    exactly(&wheel.wobble(start, &Taylor::new(1e-13).unwrap()).unwrap(), [-100.0, 100.0]);
    let spin_down = SpinDown::new(SpinningCoin::new(disc, 0.3).unwrap(), Loss::new(1e-3, 1.0).unwrap());
    exactly(&spin_down.unwrap(), [0.0, 10.0]);
}

#[test]
fn balls() {
    let (moment_factor, gravity) = (Ball::SOLID, 9.81);
    let ball = Ball::new(BallParameters { radius: 0.03, moment_factor }).unwrap();
    let cloth = Cloth::new(ClothParameters { ball, friction: 0.2, gravity }).unwrap();
    exactly(&cloth.shot(ShotStart { velocity: [2.0, 0.3], omega: [90.0, -40.0, 25.0] }).unwrap(), [0.0, 2.0]);
    for (rate, slope) in [(6.0, 0.1), (0.0, 0.1), (-1e-3, 0.0)] {
        let table = Turntable::new(TurntableParameters { ball, rate, slope, gravity }).unwrap();
        let start = TurntableStart { place: [0.2, -0.1], velocity: [0.3, 0.5], pivot: 4.0 };
        exactly(&table.roll(start).unwrap(), [-100.0, 100.0]);
    }
    let hole = Hole::new(HoleParameters { ball, radius: 0.08, gravity }).unwrap();
    exactly(&hole.roll(HoleStart { rate: 20.0, rise: -0.3, pivot: 2.0 }).unwrap(), [-100.0, 100.0]);
}
