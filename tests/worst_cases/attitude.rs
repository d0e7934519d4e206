//! Angles between vectors and between attitudes, however small, and principal axes.

use crate::long::{Long, long, off_angle};
use crate::search::{Case, Draw, keeps_its_promise, worse};
use mechanics::attitude::{angle_between, rotation_between};
use mechanics::inertia::{InertiaTensor, PrincipalAxes, PrincipalMoments};
use nalgebra::{Quaternion, Rotation3, UnitQuaternion, Vector3};

const EPS: f64 = f64::EPSILON;

fn dot<const N: usize>(a: [Long; N], b: [Long; N]) -> Long {
    a.into_iter().zip(b).map(|(x, y)| x * y).sum()
}

fn cross([a, b, c]: [Long; 3], [x, y, z]: [Long; 3]) -> [Long; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// Three numbers, and three that are the same but for a hair.
fn neighbours<const N: usize>(draw: &mut Draw<'_>) -> [[f64; N]; 2] {
    let a = std::array::from_fn(|_| draw.between(-1.0, 1.0));
    let hair = draw.decades(1e-17, 1.0);
    [a, a.map(|x| x + hair * draw.between(-1.0, 1.0))]
}

#[test]
fn an_angle_between_vectors_keeps_its_digits() {
    keeps_its_promise("angle between vectors", 4000, &["towards", "away"], |draw| {
        let [a, b] = neighbours::<3>(draw);
        let sign = draw.one_of(&[-1.0, 1.0]);
        let (to_a, to_b) = (draw.binary_unit(1000), sign * draw.binary_unit(1000));
        let found = angle_between(&(Vector3::from(a) * to_a), &(Vector3::from(b) * to_b));
        let (p, q) = (a.map(long), b.map(|x| long(x * to_b.signum())));
        let product = cross(p, q);
        let error = off_angle((dot(product, product).sqrt(), dot(p, q)), found);
        let way = if dot(p, q) > long(0.0) { "towards" } else { "away" };
        let said = format!("{a:?} · {to_a:e}, {b:?} · {to_b:e}: {found:?}, off {error:e}");
        Some(Case { ratio: error / (4.0 * EPS), way, said })
    });
    assert_eq!(angle_between(&Vector3::x(), &-Vector3::x()), std::f64::consts::PI);
    assert_eq!(angle_between(&Vector3::zeros(), &Vector3::x()), 0.0);
}

#[test]
fn a_rotation_between_attitudes_keeps_its_digits() {
    keeps_its_promise("rotation between attitudes", 4000, &["any"], |draw| {
        let [a, b] = neighbours::<4>(draw)
            .map(|[w, i, j, k]| UnitQuaternion::from_quaternion(Quaternion::new(w, i, j, k)));
        // A quaternion and its negative are one attitude.
        let b = if draw.below(2) == 0 { b } else { UnitQuaternion::new_unchecked(-b.into_inner()) };
        let found = rotation_between(&a, &b);
        let parts = |q: &UnitQuaternion<f64>| (long(q.w), [q.i, q.j, q.k].map(long));
        let ((w, u), (z, v)) = (parts(&a), parts(&b));
        let product = cross(u, v);
        let imaginary: [Long; 3] = std::array::from_fn(|n| w * v[n] - z * u[n] - product[n]);
        let error = off_angle((dot(imaginary, imaginary).sqrt(), (w * z + dot(u, v)).abs()), 0.5 * found);
        let said = format!("{a:?} {b:?}: {found:?}, off {error:e}");
        Some(Case { ratio: error / (4.0 * EPS), way: "any", said })
    });
}

#[test]
fn principal_axes_are_good_to_a_few_roundings_of_the_largest_moment() {
    keeps_its_promise("principal axes", 2000, &["flat", "with some thickness"], |draw| {
        // One in four is flat.
        let x = if draw.below(4) == 0 { 0.0 } else { draw.decades(1e-6, 1.0) };
        let y = if draw.below(2) == 0 { draw.beside(1.0) } else { draw.decades(1e-6, 1.0) };
        let way = if x == 0.0 { "flat" } else { "with some thickness" };
        let moments = PrincipalMoments::new(x + y, x + 1.0, y + 1.0).ok()?;
        let [roll, pitch, yaw] =
            std::array::from_fn(|_| if draw.below(3) == 0 { 0.0 } else { draw.signed(1e-12, 3.0) });
        let tensor =
            InertiaTensor::principal(moments).rotated(&Rotation3::from_euler_angles(roll, pitch, yaw));
        let PrincipalAxes { moments: found, present_from_principal: axes } = match tensor.principal_axes() {
            Ok(found) => found,
            Err(error) => {
                return Case::refused(way, format!("{moments:?}: {error}"));
            }
        };
        // I a = λ a and a·a = 1, in 32 digits; and the axes are right-handed.
        let largest = found.to_array()[2];
        let columns: [[Long; 3]; 3] =
            std::array::from_fn(|n| std::array::from_fn(|m| long(axes.matrix()[(m, n)])));
        let mut error: f64 = 0.0;
        for (n, (axis, moment)) in columns.into_iter().zip(found.to_array()).enumerate() {
            for row in 0..3 {
                let turned = (0..3).map(|m| axis[m] * tensor.matrix()[(row, m)]).sum::<Long>();
                error = worse(error, (turned - axis[row] * moment).abs().rounded() / largest);
            }
            for (m, other) in columns.into_iter().enumerate() {
                error = worse(error, (dot(axis, other) - f64::from(u8::from(m == n))).abs().rounded());
            }
        }
        let upright = dot(cross(columns[0], columns[1]), columns[2]) > long(0.0);
        let error = if upright { error } else { f64::INFINITY };
        let said = format!("{moments:?} {roll:?} {pitch:?} {yaw:?}: {error:e}");
        Some(Case { ratio: error / 5e-15, way, said })
    });
}
