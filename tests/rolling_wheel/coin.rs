//! The spinning coin, a wheel whose centre rests: equations (91) and (95) to (97) by the whole body with its contact
//! force, which knows neither that the centre rests nor how the axes turn.

use super::whole_body::{State, arm, axle, frame, placed, solve};
use super::{GRAVITY, MASS, RADIUS, parameters};
use crate::common::any;
use approx::assert_relative_eq;
use mechanics::integrate::Dop853;
use mechanics::rolling::MomentFactors;
use mechanics::scenes::spinning_coin::SpinningCoin;
use nalgebra::{Complex, Matrix3, Vector3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Disc, hoop, something between and two that are not flat, at many tilts.
fn coins() -> impl Iterator<Item = (MomentFactors, SpinningCoin)> {
    let round = |transverse: f64, axial: f64| MomentFactors { transverse, axial };
    [
        (MomentFactors::DISK, 0.1),
        (MomentFactors::DISK, 0.9),
        (MomentFactors::HOOP, 0.5),
        (MomentFactors::flat(0.7), 1.4),
        (round(0.6, 0.4), 0.3),
        (round(0.3, 0.55), 1.1),
    ]
    .into_iter()
    .map(|(moments, tilt)| (moments, SpinningCoin::new(parameters(moments), tilt).expect("a coin")))
}

/// The whole body at `times`, begun as the coin says.
fn rolled(moments: MomentFactors, coin: &SpinningCoin, times: &[f64]) -> Vec<State> {
    let start = placed(FRAC_PI_2 - coin.tilt(), 0.0, coin.omega().into(), Complex::new(0.0, 0.0));
    let rates = |_: f64, state: &State| solve(moments, state).0;
    Dop853::new(1e-13).unwrap().sample(any(rates), 0.0, start, times).unwrap().0
}

/// A dozen moments of one round of the contact.
fn round(coin: &SpinningCoin) -> Vec<f64> {
    (0..=12).map(|n| TAU / coin.turn_rate() * f64::from(n) / 12.0).collect()
}

/// The axes 1, 2, 3 as they are seen on the moving coin: 3 the axle, 2 from the lowest point to the centre.
fn seen(state: &State) -> Matrix3<f64> {
    let third = axle(state);
    let second = arm(&third) / -RADIUS;
    Matrix3::from_columns(&[second.cross(&third), second, third])
}

#[test]
fn eq91_the_axes_of_the_rolling_coin_turn_about_the_upright() {
    for (moments, coin) in coins() {
        let h = 1e-4 / coin.turn_rate();
        for time in round(&coin).into_iter().skip(1) {
            let [before, now, after] =
                <[State; 3]>::try_from(rolled(moments, &coin, &[time - h, time, time + h]))
                    .unwrap()
                    .map(|s| seen(&s));
            // The angular velocity of the axes is half the sum of e × ė.
            let rates = (after - before) / (2.0 * h);
            let turn: Vector3<f64> = (0..3)
                .map(|i| now.column(i).cross(&rates.column(i)) * 0.5)
                .fold(Vector3::zeros(), |a, b| a + b);
            let (sin, cos) = (FRAC_PI_2 - coin.tilt()).sin_cos();
            let stated = Vector3::new(0.0, coin.turn_rate() * cos, -coin.turn_rate() * sin);
            assert_relative_eq!(now.transpose() * turn, stated, epsilon = 1e-6 * coin.turn_rate());
        }
    }
}

#[test]
fn eq95_and_eq97_the_support_turns_the_momentum() {
    for (moments, coin) in coins() {
        // L of the body, in the room, from its moments about any diameter and about the axle.
        let momentum = |state: &State| {
            let (omega, n) = (Vector3::new(state[10], state[11], state[12]), axle(state));
            let MomentFactors { transverse, axial } = moments;
            (omega * transverse + n * n.dot(&omega) * (axial - transverse)) * (MASS * RADIUS * RADIUS)
        };
        let h = 1e-4 / coin.turn_rate();
        for time in round(&coin).into_iter().skip(1) {
            let states = rolled(moments, &coin, &[time - h, time, time + h]);
            let [before, now, after] = <[State; 3]>::try_from(states).unwrap();
            let rate = (momentum(&after) - momentum(&before)) / (2.0 * h);
            let torque = arm(&axle(&now)).cross(&solve(moments, &now).1);
            let size = MASS * GRAVITY * RADIUS;
            assert_relative_eq!(rate, torque, epsilon = 1e-6 * size);
            let sine = (FRAC_PI_2 - coin.tilt()).sin();
            assert_relative_eq!(torque, seen(&now).column(0) * (size * sine), epsilon = 1e-8 * size);
            let stated = seen(&now).column(1) * coin.angular_momentum().y;
            assert_relative_eq!(momentum(&now), stated, epsilon = 1e-9 * stated.norm());
        }
        // (97): after one round of that rate it stands as it stood; the heading is that of the start.
        let end = rolled(moments, &coin, &[TAU / coin.turn_rate()])[0];
        assert_relative_eq!(seen(&end), frame(FRAC_PI_2 - coin.tilt(), 0.0), epsilon = 1e-8);
        let stated = GRAVITY / (moments.transverse * RADIUS * coin.tilt().sin());
        assert_relative_eq!(coin.turn_rate().powi(2), stated, max_relative = 1e-13);
    }
}

#[test]
fn eq96_a_coin_whose_centre_rests_is_held_up_by_its_weight_and_needs_no_friction() {
    for (moments, coin) in coins() {
        // The force is unknown; nine equations find it, at the start and all along a round.
        for state in rolled(moments, &coin, &round(&coin)) {
            let (_, force) = solve(moments, &state);
            let weight = MASS * GRAVITY;
            assert_relative_eq!(force, Vector3::z() * weight, epsilon = 1e-9 * weight);
            // Along axes 2 and 3, as (96) has it.
            let (sin, cos) = (FRAC_PI_2 - coin.tilt()).sin_cos();
            let along = seen(&state).transpose() * force;
            assert_relative_eq!(along, Vector3::new(0.0, cos, -sin) * weight, epsilon = 1e-8 * weight);
            assert!(state[0].hypot(state[1]) < 1e-9 * RADIUS, "the centre has moved");
        }
    }
}
