//! The top under gravity, against Euler's equations with the weight and the quaternion's by series of 32 digits.

use crate::long::{Long, long};
use crate::search::{Case, Draw, keeps_its_promise, worse};
use crate::taylor::System;
use mechanics::euler::Turning;
use mechanics::scenes::top::{Top, TopMotion, TopParameters};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// What the documentation promises, of the largest rate and in radians.
const PROMISE: f64 = 4e-15;
pub(crate) const WAYS: [&str; 4] = ["slow", "fast", "steady", "on the separatrix"];

struct Judge {
    system: System,
    start: [Long; 7],
}

impl Judge {
    fn new(top: &TopParameters, start: &Turning) -> Self {
        let (mut system, [w1, w2, w3, q0, q1, q2, q3]) = System::new();
        let [one, three, mass, arm, gravity] =
            [top.transverse, top.axial, top.mass, top.arm, top.gravity].map(long);
        let (weight, turn) = (mass * arm * gravity / one * 2.0, (one - three) / one);
        let product = |system: &mut System, a, b| system.product(a, b);
        let [yz, wx, xz, wy] =
            [(q2, q3), (q0, q1), (q1, q3), (q0, q2)].map(|(a, b)| product(&mut system, a, b));
        let [w23, w31] = [(w2, w3), (w3, w1)].map(|(a, b)| product(&mut system, a, b));
        system.rate(w1, &[(turn, w23), (weight, yz), (weight, wx)]);
        system.rate(w2, &[(-turn, w31), (-weight, xz), (weight, wy)]);
        system.rate(w3, &[]);
        system.turn([q0, q1, q2, q3], [w1, w2, w3]);
        let (q, w) = (start.world_from_body, start.omega_body);
        // Of length one to 32 digits.
        let length = [q.w, q.i, q.j, q.k].map(|x| long(x) * x).into_iter().sum::<Long>().sqrt();
        let [q0, q1, q2, q3] = [q.w, q.i, q.j, q.k].map(|x| long(x) / length);
        Self { system, start: [long(w.x), long(w.y), long(w.z), q0, q1, q2, q3] }
    }

    fn after(&self, time: Long) -> Option<[Long; 7]> {
        self.system.attempt(&self.start, &[time])?.remove(0).try_into().ok()
    }
}

/// The errors of ω beside a size, and the angle of the attitude, rad.
fn errors(found: &Turning, size: f64, truth: &[Long; 7]) -> (f64, f64) {
    if !found.to_array().iter().all(|number| number.is_finite()) {
        return (f64::INFINITY, f64::INFINITY);
    }
    let [w1, w2, w3, a, b, c, d] = *truth;
    let omega =
        [w1, w2, w3].iter().zip(&found.omega_body).map(|(&w, &f)| (w - f).abs().rounded()).fold(0.0, worse);
    let q = found.world_from_body;
    let [w, x, y, z] = [q.w, q.i, q.j, q.k].map(long);
    // The imaginary part of the inverse of the truth times what was found.
    let off = [a * x - b * w - c * z + d * y, a * y - c * w - d * x + b * z, a * z - d * w - b * y + c * x];
    let angle = 2.0 * off.iter().map(|&x| x * x).sum::<Long>().sqrt().rounded();
    (omega / size, angle)
}

/// The start of a top with I₁ = 1: its weight's torque, I₃, tilt, own turn, and ω.
struct Drawn {
    weight: f64,
    axial: f64,
    tilt: f64,
    angles: [f64; 2],
    omega: [f64; 3],
}

fn drawn(draw: &mut Draw<'_>) -> Drawn {
    let axial = draw.one_of(&[1.0, 1.9, 0.03, 1e-4, 0.4]);
    let weight = match draw.below(6) {
        0 => 0.0,
        1 => draw.decades(1e-12, 1e3),
        _ => draw.between(0.1, 3.0),
    };
    // Near the spin that makes it sleep, or any.
    let sleeping = 2.0 * f64::sqrt(weight) / axial;
    let spin = match draw.below(7) {
        0..=2 => draw.beside(sleeping),
        3 => 0.0,
        _ => draw.signed(1e-3, 30.0),
    };
    let a = axial * spin;
    let tilt = match draw.below(6) {
        // The judge follows all states to 1e-31: of a smaller tilt it has too few digits.
        0 => draw.signed(1e-13, 1e-1).abs(),
        1 => std::f64::consts::PI - draw.signed(1e-12, 1e-1).abs(),
        _ => draw.between(0.0, std::f64::consts::PI),
    };
    let (sin, cos) = tilt.sin_cos();
    let angles = [0, 1].map(|_| if draw.below(2) == 0 { 0.0 } else { draw.between(-3.0, 3.0) });
    let mut omega = [0.0, 0.0, spin];
    match draw.below(6) {
        // Let go.
        0 => {}
        // Nearly steady.
        1 | 2 => {
            let root = (a * a - 4.0 * weight * cos).sqrt();
            let precession = if root.is_nan() {
                0.0
            } else if a == 0.0 {
                (weight / -cos).max(0.0).sqrt()
            } else if draw.below(2) == 0 {
                2.0 * weight / (a + root.copysign(a))
            } else {
                (a + root.copysign(a)) / (2.0 * cos)
            };
            if precession.abs() < 100.0 {
                omega[1] = precession * sin;
            }
            if draw.below(3) > 0 {
                omega[0] = draw.signed(1e-20, 1e-1);
            }
        }
        // Passing beside the vertical: L about it is L about the axis, or minus that.
        3 => {
            let above = if draw.below(2) == 0 { a * (1.0 - cos) } else { -a * (1.0 + cos) };
            if sin > 1e-10 && (above / sin).abs() < 1e3 {
                omega[1] = draw.beside(above / sin);
            }
            omega[0] = match draw.below(3) {
                0 => 0.0,
                // With the energy of an upright at rest.
                1 => {
                    let square = 2.0 * weight * (1.0 - cos) - omega[1] * omega[1];
                    draw.beside(square.max(0.0).sqrt())
                }
                _ => draw.signed(1e-3, 3.0),
            };
        }
        _ => {
            omega[0] = draw.signed(1e-6, 10.0);
            omega[1] = draw.signed(1e-6, 10.0);
        }
    }
    // From the axes of tilt to those of the body.
    let (s, c) = angles[1].sin_cos();
    let [x, y, z] = omega;
    Drawn { weight, axial, tilt, angles, omega: [x * c + y * s, y * c - x * s, z] }
}

pub(crate) fn made(draw: &mut Draw<'_>) -> Option<(TopParameters, Turning, TopMotion)> {
    let Drawn { weight, axial, tilt, angles, omega } = drawn(draw);
    let (rate, heavy) = (draw.binary_unit(40), draw.binary_unit(40));
    // So short an arm that the body is one whatever its axial moment is, but for the last bits of 2I₁.
    let arm = 2_f64.powi(-30);
    let parameters = TopParameters {
        mass: heavy,
        arm,
        transverse: heavy,
        axial: heavy * axial,
        gravity: weight * rate * rate / arm,
    };
    let half = 0.5 * tilt;
    let (sin, cos) = half.sin_cos();
    let ([s, c], [t, d]) = ([0.5 * (angles[0] + angles[1])].map(|x| [x.sin(), x.cos()])[0], {
        let x = 0.5 * (angles[0] - angles[1]);
        [x.sin(), x.cos()]
    });
    let q = Quaternion::new(cos * c, sin * d, sin * t, cos * s);
    let start = Turning {
        world_from_body: UnitQuaternion::new_unchecked(q),
        omega_body: Vector3::from(omega) * rate,
    };
    let motion = Top::new(parameters).ok()?.motion(&start).ok()?;
    Some((parameters, start, motion))
}

/// The way a motion goes, from its cubic `f₀ + f₁x + f₂x² + βx³` in 32 digits.
pub(crate) fn way(top: &TopParameters, start: &Turning) -> &'static str {
    let (q, w) = (start.world_from_body, start.omega_body);
    let l = long;
    let (up, down) = (l(q.w) * q.w + l(q.k) * q.k, l(q.i) * q.i + l(q.j) * q.j);
    let height = (up - down) / (up + down);
    let (sin, cos) = (
        (l(q.w) * q.i + l(q.k) * q.j) * 2.0 / (up + down),
        (l(q.k) * q.i - l(q.w) * q.j) * 2.0 / (up + down),
    );
    let (rise, momentum) = (cos * w.y - sin * w.x, sin * w.y + cos * w.x);
    let a = l(top.axial) * w.z / top.transverse;
    let beta = l(top.mass) * top.arm * top.gravity * 2.0 / top.transverse;
    let across = l(w.x) * w.x + l(w.y) * w.y;
    let f0 = rise * rise;
    let f1 = a * momentum * 2.0 - height * across * 2.0 - beta * (sin * sin + cos * cos);
    let f2 = height * beta * 2.0 - across - a * a;
    if f0.rounded() == 0.0 && f1.rounded() == 0.0 {
        return "steady";
    }
    let mean = -f2 / 3.0;
    let value = ((mean + f2) * mean + beta * f1) * mean + beta * beta * f0;
    if value.rounded() < 0.0 { "slow" } else { "fast" }
}

fn case(top: &TopParameters, start: &Turning, motion: &TopMotion, time: f64) -> Option<Case> {
    let mut way = way(top, start);
    if way == "fast" && motion.nod_period().is_none() {
        way = "on the separatrix";
    }
    let beta = 2.0 * top.mass * top.arm * top.gravity / top.transverse;
    // In a unit in which rates are about one; a power of two changes no digit.
    let largest = start.omega_body.norm().max(beta.sqrt());
    let rate = if largest > 0.0 { 2_f64.powi(largest.log2() as i32) } else { 1.0 };
    let scaled = |state: Turning| Turning { omega_body: state.omega_body / rate, ..state };
    let unit = TopParameters { gravity: top.gravity / rate / rate, ..*top };
    let truth = Judge::new(&unit, &scaled(*start)).after(long(time * rate))?;
    let fastest = truth[..3].iter().map(|w| w.rounded().powi(2)).sum::<f64>().sqrt();
    let size = fastest.max(largest / rate);
    let size = if size > 0.0 { size } else { 1.0 };
    let single = scaled(motion.at(time).unwrap());
    let many = scaled(motion.sample(&[time; 33]).unwrap()[17]);
    let (omega, angle) = errors(&single, size, &truth);
    let (omega_of_many, angle_of_many) = errors(&many, size, &truth);
    let worst = [omega, angle, omega_of_many, angle_of_many].into_iter().fold(0.0, worse);
    Some(Case {
        ratio: worst / PROMISE,
        way,
        said: format!(
            "{top:?} {:?} t {time:?}: ω {omega:e}, attitude {angle:e}; of many {omega_of_many:e}, {angle_of_many:e}; tilts {:?}",
            start.to_array(),
            motion.tilts(),
        ),
    })
}

#[test]
fn any_top_is_followed_to_rounding_for_some_nods() {
    keeps_its_promise("top", 600, &WAYS, |draw| {
        if draw.below(20) == 0 {
            let (top, start, motion) = upright(draw)?;
            return case(&top, &start, &motion, draw.signed(1e-3, 3.0));
        }
        let (top, start, motion) = made(draw)?;
        let beta = 2.0 * top.mass * top.arm * top.gravity / top.transverse;
        let quickest = start.omega_body.norm().max(beta.sqrt());
        let quickest = if quickest > 0.0 { quickest } else { 1.0 };
        let nods = motion.nod_period().filter(|period| *period * quickest < 800.0);
        let time = match (draw.below(20), nods) {
            (0, _) => 0.0,
            (1..10, Some(period)) => period * draw.between(-1.5, 1.5),
            _ => draw.signed(1e-3, 30.0) / quickest,
        };
        // Beside the separatrix the first fall is far away, and in the midst of it not even 32 digits tell when the next
        // one comes.
        let is_waiting =
            way(&top, &start) == "fast" && motion.nod_period().is_some_and(|nod| nod * quickest > 30.0);
        let time = match nods {
            Some(period) if is_waiting => time.clamp(-0.6 * period, 0.6 * period),
            _ => time,
        };
        case(&top, &start, &motion, time)
    });
}

/// On the separatrix itself: with whole numbers that let a top come up to rest upright.
pub(crate) fn upright(draw: &mut Draw<'_>) -> Option<(TopParameters, Turning, TopMotion)> {
    // From a level axis with I₁ = 1, mgl = ½m: b = a and an energy of mgl ask for φ̇ = a and θ̇² = β − a².
    let (a, rise, beta) =
        draw.one_of(&[(3.0, 4.0, 25.0), (0.0, 2.0, 4.0), (5.0, 12.0, 169.0), (1.0, 7.0, 50.0)]);
    let arm = 2_f64.powi(-30);
    let top = TopParameters { mass: 1.0, arm, transverse: 1.0, axial: 0.5, gravity: 0.5 * beta / arm };
    let rise = if draw.below(2) == 0 { rise } else { -rise };
    let start = Turning {
        world_from_body: UnitQuaternion::new_unchecked(Quaternion::new(0.5, 0.5, 0.5, 0.5)),
        omega_body: Vector3::new(rise, a, 2.0 * a),
    };
    let motion = Top::new(top).ok()?.motion(&start).ok()?;
    Some((top, start, motion))
}

/// What the documentation promises of the spin at which a top sleeps and of how fast it wakes, relative.
const OF_SLEEP: f64 = 4e-16;

#[test]
fn a_sleeper_and_how_fast_it_wakes_keep_their_digits_up_to_the_threshold() {
    keeps_its_promise("sleeper", 4000, &["sleeps", "wakes"], |draw| {
        let (mass, gravity, arm) =
            (draw.decades(1e-3, 1e3), draw.decades(1e-2, 1e2), draw.decades(1e-3, 1.0));
        let transverse = mass * arm * arm * (1.0 + draw.decades(1e-2, 1e2));
        let axial = (transverse - mass * arm * arm) * draw.between(0.01, 1.9);
        let parameters = TopParameters { mass, arm, transverse, axial, gravity };
        let top = Top::new(parameters).ok()?;
        let spin = draw.beside(top.sleeping_spin());
        let torque = long(mass) * gravity * arm;
        let threshold = (torque * transverse).sqrt() * 2.0 / axial;
        let a = long(axial) * spin / transverse;
        let square = torque * 2.0 / transverse * 2.0 - a * a;
        let found = top.growth_rate(spin).ok()?;
        let off = |truth: Long, found: f64| ((truth - found) / truth).abs().rounded();
        let (way, growth) = if square.rounded() > 0.0 {
            ("wakes", off(square.sqrt() * 0.5, found))
        } else {
            ("sleeps", if found == 0.0 { 0.0 } else { f64::INFINITY })
        };
        let sleeping = off(threshold, top.sleeping_spin());
        Some(Case {
            ratio: worse(growth, sleeping) / OF_SLEEP,
            way,
            said: format!("{parameters:?} at {spin:?}: growth {growth:e}, threshold {sleeping:e}"),
        })
    });
}
