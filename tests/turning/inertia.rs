//! Moments of bodies by adding up their mass.

use super::{ROUNDING, attitude, between, turning, vector};
use approx::assert_relative_eq;
use mechanics::InvalidQuantity;
use mechanics::free_rotation::FreeSymmetricTop;
use mechanics::inertia::{Body, Cylinder, InertiaTensor, PrincipalMoments, Ring, Spheroid, SymmetricMoments};
use mechanics::scenes::air_drag::{Drag, DraggedTop, DraggedTopParameters};
use nalgebra::{Matrix3, Rotation3, Vector3};
use std::f64::consts::TAU;

/// Gauss's rule with three points on −1..1, exact for polynomials to degree five: all that these shapes need.
const GAUSS: [(f64, f64); 3] =
    [(-0.774_596_669_241_483_4, 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];

/// Points and weights of a body: the weights are proportional to the mass.
type Elements = Vec<(f64, Vector3<f64>)>;

fn gauss(from: f64, to: f64) -> impl Iterator<Item = (f64, f64)> {
    let [middle, half] = [0.5 * (from + to), 0.5 * (to - from)];
    GAUSS.into_iter().map(move |(x, weight)| (weight * half, middle + half * x))
}

/// Eight directions round the axis: sums of squares of sines and cosines come out exactly.
fn around() -> impl Iterator<Item = (f64, f64)> {
    (0..8).map(|n| (0.3 + TAU * f64::from(n) / 8.0).sin_cos())
}

fn tube(inner: f64, outer: f64, height: f64) -> Elements {
    let mut elements = Vec::new();
    for (weight_r, r) in gauss(inner, outer) {
        for (weight_z, z) in gauss(-0.5 * height, 0.5 * height) {
            for (sin, cos) in around() {
                elements.push((weight_r * weight_z * r, Vector3::new(r * cos, r * sin, z)));
            }
        }
    }
    elements
}

fn spheroid(equator: f64, pole: f64) -> Elements {
    let mut elements = Vec::new();
    for (weight_r, r) in gauss(0.0, 1.0) {
        for (weight, direction) in shell_directions() {
            let point = direction.component_mul(&Vector3::new(equator, equator, pole)) * r;
            elements.push((weight_r * r * r * weight, point));
        }
    }
    elements
}

fn shell_directions() -> Elements {
    let mut elements = Vec::new();
    for (weight, z) in gauss(-1.0, 1.0) {
        let across = (1.0 - z * z).sqrt();
        elements.extend(around().map(|(sin, cos)| (weight, Vector3::new(across * cos, across * sin, z))));
    }
    elements
}

fn block(edges: [f64; 3]) -> Elements {
    let [a, b, c] = edges.map(|edge| 0.5 * edge);
    let mut elements = Vec::new();
    for (weight_x, x) in gauss(-a, a) {
        for (weight_y, y) in gauss(-b, b) {
            elements.extend(
                gauss(-c, c).map(|(weight, z)| (weight_x * weight_y * weight, Vector3::new(x, y, z))),
            );
        }
    }
    elements
}

/// The inertia about `point` of `mass` spread over the elements: `∫(r²1 − r rᵀ) dm`.
fn inertia(mass: f64, elements: &Elements, point: &Vector3<f64>) -> Matrix3<f64> {
    let total: f64 = elements.iter().map(|(weight, _)| weight).sum();
    let sum: Matrix3<f64> = elements
        .iter()
        .map(|(weight, position)| {
            let r = position - point;
            (Matrix3::from_diagonal_element(r.norm_squared()) - r * r.transpose()) * *weight
        })
        .sum();
    sum * (mass / total)
}

/// Every shape of the library with the elements that it is made of.
fn shapes(random: &mut fastrand::Rng) -> Result<Vec<(f64, Body, Elements)>, InvalidQuantity> {
    let mut length = || between(random, 0.1, 10.0);
    let [a, b, c, mass] = [length(), length(), length(), length()];
    let hoop = around().map(|(sin, cos)| (1.0, Vector3::new(a * cos, a * sin, 0.0))).collect();
    let shell = shell_directions().into_iter().map(|(weight, n)| (weight, n * a)).collect();
    let disc: Elements = gauss(0.0, a)
        .flat_map(|(weight, r)| {
            around().map(move |(sin, cos)| (weight * r, Vector3::new(r * cos, r * sin, 0.0)))
        })
        .collect();
    let ring = Ring { inner_radius: a, outer_radius: a + b, height: c };
    let rod = Cylinder { radius: 0.1 * b, height: 10.0 * a };
    Ok(vec![
        (mass, Body::hoop(mass, a)?, hoop),
        (mass, Body::ring(mass, ring)?, tube(a, a + b, c)),
        (mass, Body::thin_disk(mass, a)?, disc),
        (mass, Body::cylinder(mass, Cylinder { radius: a, height: b })?, tube(0.0, a, b)),
        (mass, Body::cylinder(mass, rod)?, tube(0.0, 0.1 * b, 10.0 * a)),
        (mass, Body::sphere(mass, a)?, spheroid(a, a)),
        (mass, Body::shell(mass, a)?, shell),
        (mass, Body::cuboid(mass, [a, b, c])?, block([a, b, c])),
        (mass, Body::spheroid(mass, Spheroid { equatorial_radius: a, polar_radius: b })?, spheroid(a, b)),
    ])
}

#[test]
fn inertia_about_any_point_and_along_any_axes_is_the_sum_over_the_mass() {
    let mut random = fastrand::Rng::with_seed(35);
    for _ in 0..50 {
        for (mass, body, elements) in shapes(&mut random).unwrap() {
            let point = vector(&mut random, 10.0);
            let about = body.about(&point).unwrap();
            let sum = inertia(mass, &elements, &point);
            assert_relative_eq!(*about.matrix(), sum, epsilon = ROUNDING * sum.amax());

            let other_from_body = attitude(&mut random).to_rotation_matrix();
            let turned: Elements =
                elements.iter().map(|(weight, r)| (*weight, other_from_body * r)).collect();
            let sum = inertia(mass, &turned, &Vector3::zeros());
            assert_relative_eq!(
                *InertiaTensor::principal(body.moments()).rotated(&other_from_body).matrix(),
                sum,
                epsilon = ROUNDING * sum.amax()
            );
        }
    }
}

#[test]
fn a_matrix_that_is_summed_over_the_mass_gives_back_the_moments_and_their_axes() {
    let mut random = fastrand::Rng::with_seed(78);
    for (mass, body, mut elements) in shapes(&mut random).unwrap() {
        let turn = attitude(&mut random);
        elements.iter_mut().for_each(|(_, r)| *r = turn * *r);
        let total: f64 = elements.iter().map(|(weight, _)| weight).sum();
        let tensor = InertiaTensor::new(inertia(mass, &elements, &Vector3::zeros())).unwrap();
        let axes = tensor.principal_axes().unwrap();
        let mut expected = body.moments().to_array();
        expected.sort_by(f64::total_cmp);
        for (n, moment) in axes.moments.to_array().into_iter().enumerate() {
            // The squares of the distances from the axis.
            let axis = axes.present_from_principal * Vector3::ith(n, 1.0);
            let squares: f64 = elements.iter().map(|(weight, r)| weight * axis.cross(r).norm_squared()).sum();
            assert_relative_eq!(moment, squares * mass / total, epsilon = ROUNDING * expected[2]);
            assert_relative_eq!(moment, expected[n], epsilon = ROUNDING * expected[2]);
        }
    }
}

#[test]
fn a_ring_of_balls_is_symmetric_to_rounding_wherever_its_axis_points() {
    let mut random = fastrand::Rng::with_seed(79);
    let mut uneven = 0;
    for count in [3, 5, 6, 7, 12, 100, 10_000] {
        for _ in 0..20 {
            let (mass, size, radius) = (0.2, 0.01, between(&mut random, 0.05, 10.0));
            let ball = Body::sphere(mass, size).unwrap();
            let turn = attitude(&mut random);
            let about_centre = |n: i32| {
                let (sin, cos) = (TAU * f64::from(n) / f64::from(count)).sin_cos();
                *ball.about(&(turn * Vector3::new(radius * cos, radius * sin, 0.0))).unwrap().matrix()
            };
            let tensor = InertiaTensor::new((0..count).map(about_centre).sum()).unwrap();
            let moments = tensor.principal_axes().unwrap().moments;
            let SymmetricMoments { transverse, axial } = moments.as_symmetric().unwrap();
            let own = 0.4 * size * size;
            let square = radius * radius;
            let total = mass * f64::from(count);
            assert_relative_eq!(transverse, total * (own + 0.5 * square), max_relative = ROUNDING);
            assert_relative_eq!(axial, total * (own + square), max_relative = ROUNDING);
            // And what goes on with them has equal ones.
            let start = turning(&mut random, 5.0);
            let top = FreeSymmetricTop::new(moments, start).unwrap();
            let (drag, omega_body) = (Drag::isotropic(0.1), start.omega_body);
            let dragged = DraggedTop::new(DraggedTopParameters { moments, drag, omega_body }).unwrap();
            let even = PrincipalMoments::symmetric(transverse, axial).unwrap();
            assert_eq!([top.moments(), dragged.moments()], [even; 2]);
            uneven += i32::from(moments != even);
        }
    }
    assert!(uneven > 50, "{uneven}");
    // To 1e-14 of the largest, and no further; and it is the mean.
    let mean = PrincipalMoments::new(1.0, 1.0 + 1.6e-14, 1.99).unwrap().as_symmetric().unwrap();
    assert_relative_eq!(mean.transverse - 1.0, 0.8e-14, epsilon = f64::EPSILON);
    for (about_2, is_even) in [(1.0 + 1.9e-14, true), (1.0 - 1.9e-14, true), (1.0 + 2.1e-14, false)] {
        assert_eq!(PrincipalMoments::new(1.0, about_2, 1.99).unwrap().as_symmetric().is_ok(), is_even);
    }
}

#[test]
fn angular_momentum_is_the_sum_of_r_cross_v() {
    let mut random = fastrand::Rng::with_seed(36);
    for (mass, body, elements) in shapes(&mut random).unwrap() {
        let omega = vector(&mut random, 5.0);
        let total: f64 = elements.iter().map(|(weight, _)| weight).sum();
        let momentum: Vector3<f64> =
            elements.iter().map(|(weight, r)| r.cross(&omega.cross(r)) * (weight * mass / total)).sum();
        let energy: f64 = elements
            .iter()
            .map(|(weight, r)| 0.5 * omega.cross(r).norm_squared() * weight * mass / total)
            .sum();
        let size = momentum.norm();
        assert_relative_eq!(body.moments().angular_momentum(&omega), momentum, epsilon = ROUNDING * size);
        assert_relative_eq!(body.moments().kinetic_energy(&omega), energy, max_relative = ROUNDING);
        assert_relative_eq!(
            body.moments().angular_velocity(&momentum),
            omega,
            epsilon = 1e-12 * omega.norm()
        );
    }
}

#[test]
fn three_moments_are_accepted_exactly_if_a_body_can_have_them() {
    let mut random = fastrand::Rng::with_seed(38);
    let (mut accepted, mut refused) = (0, 0);
    for _ in 0..10_000 {
        let [a, b, c] = std::array::from_fn(|_| between(&mut random, 0.1, 10.0));
        let possible = a + b >= c && b + c >= a && c + a >= b;
        let found = PrincipalMoments::new(a, b, c);
        assert_eq!(found.is_ok(), possible, "{a} {b} {c}");
        if possible {
            accepted += 1;
        } else {
            refused += 1;
        }
        // A flat body is at the very edge, and stays a body whatever its sums round to.
        assert!(PrincipalMoments::new(a, b, a + b).is_ok() && PrincipalMoments::new(a + b, b, a).is_ok());
    }
    assert!(accepted > 1000 && refused > 1000);
}

#[test]
fn a_tensor_gives_the_momentum_that_the_masses_have() {
    // A few points of mass: Σ m r × (ω × r), beside the tensor of the same points about the same centre.
    let mut random = fastrand::Rng::with_seed(77);
    for _ in 0..100 {
        let mut drawn = || Vector3::from_fn(|_, _| 2.0 * random.f64() - 1.0);
        let omega = drawn();
        let body = Body::cuboid(1.3, [0.4, 0.9, 0.7]).unwrap();
        let turn = Rotation3::new(drawn());
        let tensor = InertiaTensor::principal(body.moments()).rotated(&turn);
        // Eight points at ±s of the sides have the moments of a uniform brick, with s = side/√12.
        let mut momentum = Vector3::zeros();
        for corner in 0..8 {
            let sign = |bit: i32| if corner >> bit & 1 == 0 { 1.0 } else { -1.0 };
            let point = Vector3::new(0.4 * sign(0), 0.9 * sign(1), 0.7 * sign(2)) / 12.0_f64.sqrt();
            let point = turn * point;
            momentum += point.cross(&omega.cross(&point)) * (1.3 / 8.0);
        }
        assert_relative_eq!(tensor.angular_momentum(&omega), momentum, epsilon = 1e-15);
    }
}
