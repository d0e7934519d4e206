//! Length of the quaternion, energy and attitude over many periods of a tumbling hoop.

use super::{FEW_ULPS, assert_level, assert_slope, data, number, numbers};
use crate::common::any;
use mechanics::euler::{self, Turning};
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::{Dop853, rk4, rk4_step};
use nalgebra::{Matrix2, Quaternion, UnitQuaternion, Vector2, Vector3};

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
    momentum: f64, // of |L|, relative
    attitude: f64, // of the normed quaternion, either sign
}

/// What is brought back to its first value after every step, besides the length of the quaternion.
#[derive(Clone, Copy)]
enum Kept {
    Length,
    Energy,
    EnergyAndMomentum,
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

    /// Twice the energy and the square of the angular momentum.
    fn conserved(&self, omega: &Vector3<f64>) -> Vector2<f64> {
        let momentum = self.moments.angular_momentum(omega);
        Vector2::new(omega.dot(&momentum), momentum.norm_squared())
    }

    fn errors(&self, state: &[f64; 7], row: &Row) -> Errors {
        let omega = |state: &[f64; 7]| Vector3::new(state[4], state[5], state[6]);
        let now = self.conserved(&omega(state));
        let first = self.conserved(&self.start.omega_body);
        let q = Quaternion::new(state[0], state[1], state[2], state[3]);
        let normed = q / q.norm();
        Errors {
            length: q.norm() - 1.0,
            energy: now[0] / first[0] - 1.0,
            momentum: (now[1] / first[1]).sqrt() - 1.0,
            attitude: (normed - row.attitude).norm().min((normed + row.attitude).norm()),
        }
    }

    fn by_rk4(&self, row: &Row, steps_per_period: f64) -> Errors {
        let steps = (steps_per_period * row.t / self.period).round() as usize;
        self.errors(&rk4(self.rates(), 0.0, self.start.to_array(), row.t, steps).unwrap(), row)
    }

    /// The angular velocity after one of Newton's steps back to the first energy and |L|.
    fn restored(&self, omega: Vector3<f64>) -> Vector3<f64> {
        let missing = self.conserved(&self.start.omega_body) - self.conserved(&omega);
        // A step xω + yL changes the two by twice its products with their gradients, L and IL.
        let momentum = self.moments.angular_momentum(&omega);
        let gradient = self.moments.angular_momentum(&momentum);
        let slopes = Matrix2::new(
            momentum.dot(&omega),
            momentum.dot(&momentum),
            gradient.dot(&omega),
            gradient.dot(&momentum),
        );
        let parts = slopes.lu().solve(&(missing / 2.0)).expect("ω and L apart");
        omega + omega * parts[0] + momentum * parts[1]
    }

    /// By RK4, with what is conserved brought back after every step.
    fn by_rk4_restored(&self, row: &Row, steps_per_period: f64, kept: Kept) -> Errors {
        let steps = (steps_per_period * row.t / self.period).round() as usize;
        let h = row.t / steps as f64;
        let first = self.conserved(&self.start.omega_body);
        let (mut rates, mut state) = (self.rates(), self.start.to_array());
        for n in 0..steps {
            let mut now = Turning::from_array(rk4_step(&mut rates, n as f64 * h, &state, h)); // brings q to length one
            let omega = now.omega_body;
            match kept {
                Kept::Length => {}
                Kept::Energy => now.omega_body *= (first[0] / self.conserved(&omega)[0]).sqrt(),
                Kept::EnergyAndMomentum => {
                    now.omega_body = self.restored(self.restored(omega));
                }
            }
            state = now.to_array();
        }
        self.errors(&state, row)
    }

    fn by_dop853(&self, row: &Row, tolerance: f64) -> Errors {
        let solver = Dop853::new(tolerance).unwrap();
        let end = solver.solve(any(self.rates()), 0.0, self.start.to_array(), row.t).unwrap();
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
    let Errors { length, energy, attitude, .. } = &errors[3].1;
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
    // q̇ = ½ω q is a rotation in the plane of q and its quarter turn: with x = ωh/2 the methods multiply by
    // polynomials in ix.
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
    assert!((-2e-5..-5e-6).contains(&last.energy) && (0.07..0.2).contains(&last.attitude), "{last:?}");
    // A thousandth of the tolerance holds it, for twice the work.
    let finer = hoop.by_dop853(&hoop.rows[4], 1e-12);
    assert!((3e-5..1e-4).contains(&finer.attitude), "{finer:?}");
}

#[test]
fn with_the_energy_brought_back_the_attitude_is_lost_half_as_fast_and_with_the_momentum_too_in_proportion_to_the_time()
 {
    let hoop = Tumbling::read();
    let [length, energy, both] = [Kept::Length, Kept::Energy, Kept::EnergyAndMomentum]
        .map(|kept| [1, 2, 3].map(|row| hoop.by_rk4_restored(&hoop.rows[row], 40.0, kept)));
    for errors in energy.iter().chain(&both) {
        assert!(errors.length.abs() < 1e-15 && errors.energy.abs() < 1e-15, "{errors:?}");
    }
    for errors in &both {
        assert!(errors.momentum.abs() < 1e-15, "{errors:?}");
    }
    // What goes on drifting is |L|, in proportion to the time; from ten to a hundred periods the attitude's
    // error grows nearly a hundredfold.
    let drift = energy[2].momentum / energy[1].momentum;
    assert!((drift - 10.0).abs() < 0.1, "{drift}");
    let growth = energy[1].attitude / energy[0].attitude;
    assert!((70.0..100.0).contains(&growth), "{growth}");
    let gain = energy[1].attitude / length[1].attitude; // after a hundred periods
    assert!((0.45..0.7).contains(&gain), "{gain}");
    assert!(energy[2].attitude > 0.5, "after a thousand periods it is lost: {:?}", energy[2]);
    // With both, only the error along the motion is left: 0.06 rad after a thousand periods, half of that in
    // the quaternion.
    let series = [0, 1, 2].map(|n| (hoop.rows[n + 1].periods + 0.3, both[n].attitude));
    assert_slope("attitude with all three kept", &series, 1.0, 0.01);
    assert_level("attitude with all three kept", &series, |periods| 3.1e-5 * periods, 0.95..1.05);
}
