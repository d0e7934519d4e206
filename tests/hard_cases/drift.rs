//! Length of the quaternion, energy and attitude over many periods of a tumbling hoop.

use crate::{FEW_ULPS, assert_slope, data, number, numbers};
use mechanics::euler::{self, Turning};
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::{Dop853, rk4, rk4_step};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// The hoop pinned at 60° and its motion after so many periods and three tenths.
struct Tumbling {
    moments: PrincipalMoments,
    start: Turning,
    period: f64,
    rows: Vec<Row>,
}

struct Row {
    periods: f64,
    t: f64,
    omega: Vector3<f64>,
    attitude: Quaternion<f64>,
}

/// How far a state is from the truth.
#[derive(Debug)]
struct Errors {
    length: f64,   // |q| − 1
    energy: f64,   // relative
    attitude: f64, // of the normed quaternion, either sign
}

impl Tumbling {
    fn read() -> Self {
        let file = &data()["tumbling"];
        let [a, b, c] = numbers(&file["moments"]);
        let start = Turning {
            world_from_body: UnitQuaternion::identity(),
            omega_body: numbers::<3>(&file["omega"]).into(),
        };
        let rows = file["rows"].as_array().expect("a list").iter().map(|row| {
            let [w, x, y, z] = numbers(&row["attitude"]);
            Row {
                periods: row["periods"].as_f64().expect("a number"),
                t: number(&row["t"]),
                omega: numbers::<3>(&row["omega"]).into(),
                attitude: Quaternion::new(w, x, y, z),
            }
        });
        let moments = PrincipalMoments::new(a, b, c).expect("a body");
        Self { moments, start, period: number(&file["period"]), rows: rows.collect() }
    }

    /// The rows up to a number of periods.
    fn up_to(&self, periods: f64) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(move |row| row.periods <= periods)
    }

    fn rates(&self) -> impl FnMut(f64, &[f64; 7]) -> [f64; 7] {
        euler::turning_rates(self.moments, |_, _| Vector3::zeros())
    }

    fn energy(&self, state: &[f64; 7]) -> f64 {
        let omega = Vector3::new(state[4], state[5], state[6]);
        0.5 * omega.dot(&self.moments.angular_momentum(&omega))
    }

    fn errors(&self, state: &[f64; 7], row: &Row) -> Errors {
        let q = Quaternion::new(state[0], state[1], state[2], state[3]);
        let normed = q / q.norm();
        Errors {
            length: q.norm() - 1.0,
            energy: self.energy(state) / self.energy(&self.start.to_array()) - 1.0,
            attitude: (normed - row.attitude).norm().min((normed + row.attitude).norm()),
        }
    }

    fn by_rk4(&self, row: &Row, steps_per_period: f64) -> Errors {
        let steps = (steps_per_period * row.t / self.period).round() as usize;
        self.errors(&rk4(self.rates(), 0.0, self.start.to_array(), row.t, steps).unwrap(), row)
    }

    fn by_dop853(&self, row: &Row, tolerance: f64) -> Errors {
        let solver = Dop853::new(tolerance).unwrap();
        let end = solver.solve(self.rates(), 0.0, self.start.to_array(), row.t).unwrap();
        self.errors(&end.state, row)
    }
}

#[test]
fn closed_form_keeps_attitude_length_and_energy_for_a_hundred_million_periods() {
    let hoop = Tumbling::read();
    let top = FreeTop::new(hoop.moments, hoop.start).unwrap();
    assert!((top.period().unwrap() / hoop.period - 1.0).abs() < FEW_ULPS);
    for row in &hoop.rows {
        let now = top.at(row.t).unwrap();
        assert!((now.omega_body - row.omega).norm() < FEW_ULPS, "{:e} periods", row.periods);
        let errors = hoop.errors(&now.to_array(), row);
        let worst = errors.length.abs().max(errors.energy.abs()).max(errors.attitude);
        assert!(worst < FEW_ULPS, "{:e} periods: {errors:?}", row.periods);
    }
    assert!(hoop.rows.last().is_some_and(|row| row.periods == 1e8));
}

#[test]
fn rk4_shrinks_the_quaternion_and_loses_energy_in_proportion_to_the_time() {
    let hoop = Tumbling::read();
    let errors: Vec<(f64, Errors)> =
        hoop.up_to(1e3).map(|row| (row.periods + 0.3, hoop.by_rk4(row, 40.0))).collect();
    assert_eq!(errors.len(), 4);
    let series = |of: fn(&Errors) -> f64| -> Vec<(f64, f64)> {
        errors.iter().map(|(periods, errors)| (*periods, of(errors))).collect()
    };
    assert_slope("length against time", &series(|errors| -errors.length), 1.0, 0.07);
    assert_slope("energy against time", &series(|errors| -errors.energy), 1.0, 0.12);
    let Errors { length, energy, attitude } = &errors[3].1;
    assert!((-2.5e-3..-1.2e-3).contains(length) && (-6e-3..-2.5e-3).contains(energy));
    assert!(*attitude > 0.5, "after 1000 periods the attitude should be lost, and is off by {attitude}");
}

#[test]
fn drifts_of_rk4_go_with_the_fifth_power_of_the_step_one_more_than_its_order() {
    let hoop = Tumbling::read();
    let row = &hoop.rows[1]; // ten periods
    let errors: Vec<(f64, Errors)> =
        [30.0, 40.0, 60.0, 80.0, 120.0].map(|steps| (1.0 / steps, hoop.by_rk4(row, steps))).into();
    let series = |of: fn(&Errors) -> f64| -> Vec<(f64, f64)> {
        errors.iter().map(|(step, errors)| (*step, of(errors))).collect()
    };
    assert_slope("length against step", &series(|errors| -errors.length), 5.0, 0.15);
    assert_slope("energy against step", &series(|errors| -errors.energy), 5.0, 0.2);
}

#[test]
fn one_step_of_rk4_and_of_euler_changes_the_length_of_a_steadily_turning_quaternion_as_predicted() {
    // q̇ = ½ω q is a rotation in the plane of q and its quarter turn: with x = ωh/2 the methods multiply by polynomials in ix.
    let moments = PrincipalMoments::new(1.0, 2.0, 2.5).unwrap();
    let mut rates = euler::turning_rates(moments, |_, _| Vector3::zeros());
    let start = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0]; // ω = 2 about axis 3, so x = h
    for x in [0.5, 0.2, 0.1_f64] {
        let norm = |state: [f64; 7]| Quaternion::new(state[0], state[1], state[2], state[3]).norm();
        let by_rk4 = norm(rk4_step(&mut rates, 0.0, &start, x));
        assert!((by_rk4 - (1.0 - x.powi(6) / 72.0 + x.powi(8) / 576.0).sqrt()).abs() < FEW_ULPS);
        let slope = rates(0.0, &start);
        let by_euler = norm(std::array::from_fn(|n| start[n] + x * slope[n]));
        assert!((by_euler - (1.0 + x * x).sqrt()).abs() < FEW_ULPS);
    }
}

#[test]
fn attitude_is_lost_with_the_square_of_the_time_though_the_quaternion_is_normed() {
    let hoop = Tumbling::read();
    let errors: Vec<(f64, Errors)> =
        hoop.up_to(1e4).skip(1).map(|row| (row.periods + 0.3, hoop.by_dop853(row, 1e-9))).collect();
    let energy: Vec<(f64, f64)> = errors.iter().map(|(periods, errors)| (*periods, -errors.energy)).collect();
    assert_slope("energy by DOP853", &energy, 1.0, 0.05);
    let attitude: Vec<(f64, f64)> =
        errors.iter().map(|(periods, errors)| (*periods, errors.attitude)).collect();
    assert_slope("attitude by DOP853", &attitude, 2.0, 0.05);
    // After 1e4 periods a hundred-thousandth of the energy is gone, and a tenth of a radian and more of the attitude.
    let last = &errors[3].1;
    assert!(last.energy.abs() < 3e-5 && last.attitude > 0.05, "{last:?}");
    // A thousandth of the tolerance holds it, for twice the work.
    let finer = hoop.by_dop853(&hoop.rows[4], 1e-12);
    assert!((3e-5..1e-4).contains(&finer.attitude), "{finer:?}");
}

#[test]
fn forcing_energy_and_length_to_be_right_does_not_make_the_attitude_right() {
    let hoop = Tumbling::read();
    let row = &hoop.rows[3]; // a thousand periods
    let steps = (40.0 * row.t / hoop.period).round() as usize;
    let energy = hoop.energy(&hoop.start.to_array());
    let (mut rates, mut state) = (hoop.rates(), hoop.start.to_array());
    for n in 0..steps {
        let h = row.t / steps as f64;
        state = rk4_step(&mut rates, n as f64 * h, &state, h);
        let (length, excess) =
            (state[..4].iter().map(|q| q * q).sum::<f64>().sqrt(), hoop.energy(&state) / energy);
        state[..4].iter_mut().for_each(|q| *q /= length);
        state[4..].iter_mut().for_each(|w| *w /= excess.sqrt());
    }
    let errors = hoop.errors(&state, row);
    println!("{errors:?}");
    assert!(errors.length.abs() < 1e-14 && errors.energy.abs() < 1e-14, "{errors:?}");
    assert!(errors.attitude > 0.05, "{errors:?}");
}
