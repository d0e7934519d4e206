//! An independent simulation: a free rigid body with a quaternion, and a force at its lowest point found at every
//! instant from nine linear equations: Newton's, Euler's, and that the material point of contact has no acceleration
//! but that of rolling on.

use super::{GRAVITY, MASS, RADIUS};
use mechanics::rolling::MomentFactors;
use nalgebra::{Complex, Matrix3, Quaternion, SMatrix, SVector, UnitQuaternion, Vector3};
use std::ops::AddAssign;

/// Centre (3), quaternion body to room (4), velocity (3), angular velocity in the room (3).
pub(crate) type State = [f64; 13];

fn vector(state: &State, from: usize) -> Vector3<f64> {
    Vector3::new(state[from], state[from + 1], state[from + 2])
}

/// The body's axis in the room.
pub(crate) fn axle(state: &State) -> Vector3<f64> {
    let q = UnitQuaternion::from_quaternion(Quaternion::new(state[3], state[4], state[5], state[6]));
    q * Vector3::z()
}

/// From the centre to the lowest point of the rim.
pub(crate) fn arm(axle: &Vector3<f64>) -> Vector3<f64> {
    let down = -Vector3::z();
    (down - axle * axle.dot(&down)).normalize() * RADIUS
}

/// Rates of the state, and the contact force, from the nine equations.
pub(crate) fn solve(moments: MomentFactors, state: &State) -> ([f64; 13], Vector3<f64>) {
    solve_slowed(moments, 0.0, state)
}

/// The same with the torque −s ma² ω on the body.
pub(crate) fn solve_slowed(moments: MomentFactors, slowing: f64, state: &State) -> ([f64; 13], Vector3<f64>) {
    let omega = vector(state, 10);
    solve_with(moments, 0.0, omega * (-slowing * MASS * RADIUS * RADIUS), state)
}

/// The same with a torque on the body, in the room, and with a flywheel in it whose momentum along the axle stays.
pub(crate) fn solve_with(
    moments: MomentFactors,
    flywheel: f64,
    torque: Vector3<f64>,
    state: &State,
) -> ([f64; 13], Vector3<f64>) {
    let (v, omega) = (vector(state, 7), vector(state, 10));
    let n = axle(state);
    let r = arm(&n);
    let MomentFactors { transverse, axial } = moments;
    let unit = MASS * RADIUS * RADIUS;
    let inertia = (Matrix3::identity() * transverse + n * n.transpose() * (axial - transverse)) * unit;
    let momentum = inertia * omega + n * flywheel;
    // The material point at the contact: v + ω × r = 0 for every point as it touches. Its derivative along the path of
    // the contact, where r is the lowest point of the moving disc: v̇ + ω̇ × r + ω × ṙ = 0, with ṙ from that of the
    // axle.
    let (down, n_rate) = (-Vector3::z(), omega.cross(&n));
    let towards = down - n * n.dot(&down);
    let towards_rate = -(n_rate * n.dot(&down) + n * n_rate.dot(&down));
    let unit_arm = towards.normalize();
    let r_rate = (towards_rate - unit_arm * unit_arm.dot(&towards_rate)) * (RADIUS / towards.norm());
    let cross = |a: &Vector3<f64>| a.cross_matrix();
    let mut matrix = SMatrix::<f64, 9, 9>::zeros();
    let mut given = SVector::<f64, 9>::zeros();
    // M v̇ − F = −M g z
    matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&(Matrix3::identity() * MASS));
    matrix.fixed_view_mut::<3, 3>(0, 6).copy_from(&-Matrix3::identity());
    given.fixed_rows_mut::<3>(0).copy_from(&Vector3::new(0.0, 0.0, -MASS * GRAVITY));
    // I ω̇ − r × F = −ω × L + τ  (inertia and flywheel turn with the body)
    matrix.fixed_view_mut::<3, 3>(3, 3).copy_from(&inertia);
    matrix.fixed_view_mut::<3, 3>(3, 6).copy_from(&-cross(&r));
    given.fixed_rows_mut::<3>(3).copy_from(&(torque - omega.cross(&momentum)));
    // v̇ − r × ω̇ = −ω × ṙ
    matrix.fixed_view_mut::<3, 3>(6, 0).copy_from(&Matrix3::identity());
    matrix.fixed_view_mut::<3, 3>(6, 3).copy_from(&-cross(&r));
    given.fixed_rows_mut::<3>(6).copy_from(&-omega.cross(&r_rate));
    let found = matrix.lu().solve(&given).expect("a force and accelerations");
    let part = |k: usize| found.fixed_rows::<3>(k).into_owned();
    let (acceleration, angular, force) = (part(0), part(3), part(6));
    let q = Quaternion::new(state[3], state[4], state[5], state[6]);
    let turn = Quaternion::from_imag(0.5 * omega) * q;
    let mut rates = [0.0; 13];
    rates[0..3].copy_from_slice(v.as_slice());
    rates[3..7].copy_from_slice(&[turn.w, turn.i, turn.j, turn.k]);
    rates[7..10].copy_from_slice(acceleration.as_slice());
    rates[10..13].copy_from_slice(angular.as_slice());
    (rates, force)
}

/// The axes 1, 2, 3 of the frame in the room for a lean and a heading.
pub(crate) fn frame(lean: f64, heading: f64) -> Matrix3<f64> {
    let first = Vector3::new(heading.cos(), heading.sin(), 0.0);
    let outward = Vector3::new(-heading.sin(), heading.cos(), 0.0);
    let second = -outward * lean.sin() + Vector3::z() * lean.cos();
    Matrix3::from_columns(&[first, second, first.cross(&second)])
}

/// The whole body in the state that lean, heading, the three components of ω along the frame and the place of the
/// centre say, rolling without slip.
pub(crate) fn placed(lean: f64, heading: f64, omega_frame: [f64; 3], centre: Complex<f64>) -> State {
    let axes = frame(lean, heading);
    let q = UnitQuaternion::from_matrix(&axes);
    let omega = axes * Vector3::from(omega_frame);
    let v = -omega.cross(&arm(&axes.column(2).into_owned()));
    let mut state = [0.0; 13];
    state[0..3].copy_from_slice(&[centre.re, centre.im, RADIUS * lean.cos()]);
    state[3..7].copy_from_slice(&[q.w, q.i, q.j, q.k]);
    state[7..10].add_assign_slice(v.as_slice());
    state[10..13].add_assign_slice(omega.as_slice());
    state
}

trait AddAssignSlice {
    fn add_assign_slice(&mut self, other: &[f64]);
}

impl AddAssignSlice for [f64] {
    fn add_assign_slice(&mut self, other: &[f64]) {
        for (a, b) in self.iter_mut().zip(other) {
            a.add_assign(*b);
        }
    }
}
