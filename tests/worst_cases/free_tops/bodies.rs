//! Bodies and angular velocities on every branch of the closed form, and beside the borders.

use super::PROMISE;
use super::judge::{Judge, errors};
use crate::long::{Long, long};
use crate::search::{Case, Draw, worse};
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

/// Three moments of a body, largest about one.
fn moments(draw: &mut Draw<'_>) -> [f64; 3] {
    let thin = draw.one_of(&[1e-1, 1e-3, 1e-8, 1e-15]);
    let [x, y] = [draw.decades(thin, 1.0), draw.decades(thin, 1.0)];
    let mut moments = match draw.below(14) {
        // Flat: the largest is the sum of the others.
        0 => [x, y, x + y],
        // Two nearly equal, or equal, or all three.
        1 => {
            let rod = draw.below(2) == 0;
            let equal = if draw.below(3) == 0 { 1.0 } else { draw.beside(1.0) };
            [1.0, equal, if rod { x * (1.0 + equal) } else { draw.between(1.0, 1.9) }]
        }
        2 => [1.0, draw.beside(1.0), draw.beside(1.0)],
        3 => [1.0; 3],
        _ => [x + y, x + 1.0, y + 1.0],
    };
    let shift = draw.below(6);
    moments.rotate_left(shift % 3);
    if shift > 2 {
        moments.swap(0, 1);
    }
    moments
}

/// An angular velocity about which something is special for such a body.
fn omega(draw: &mut Draw<'_>, moments: [f64; 3]) -> [f64; 3] {
    let mut axes = [0, 1, 2];
    axes.sort_by(|&i, &j| moments[i].total_cmp(&moments[j]));
    let [a, b, c] = axes;
    let mut omega = match draw.below(5) {
        // A given parameter k²: ω_a² I_a (I_b − I_a) = k² ω_c² I_c (I_c − I_b) where ω_b is zero; one is the
        // separatrix, and at one half the nome is exchanged.
        0 | 1 => {
            let parameter = match draw.below(4) {
                0 => draw.beside(0.5),
                1 | 2 => draw.beside(1.0),
                _ => draw.decades(1e-30, 1e30),
            };
            let mut omega = [0.0; 3];
            omega[c] = 1.0;
            let ratio = moments[c] * (moments[c] - moments[b]) / (moments[a] * (moments[b] - moments[a]));
            omega[a] = (parameter * ratio).sqrt();
            if omega[a].is_nan() || omega[a] > 1e3 {
                return [1.0, 1.0, 1.0];
            }
            if draw.below(2) == 0 {
                omega[b] = draw.signed(1e-6, 1.0);
            }
            omega
        }
        // Next to a principal axis.
        2 => {
            let mut omega = [0.0; 3];
            omega[draw.below(3)] = 1.0;
            for w in &mut omega {
                if *w == 0.0 {
                    *w = draw.signed(1e-95, 1e-3);
                }
            }
            omega
        }
        _ => std::array::from_fn(|_| draw.signed(1e-3, 1.0)),
    };
    for w in &mut omega {
        if draw.below(2) == 0 {
            *w = -*w;
        }
    }
    omega
}

/// Exactly on the separatrix: for whole a and c whose sum is a power of two the middle moment is b = (a² + c²)/(a +
/// c), and then `ω_a = ±ω_c`.
fn on_the_separatrix(draw: &mut Draw<'_>) -> ([f64; 3], [f64; 3]) {
    let (a, c) = draw.one_of(&[(3.0, 5.0), (1.0, 3.0), (7.0, 9.0), (5.0, 11.0), (15.0, 17.0), (13.0, 19.0)]);
    let b = (a * a + c * c) / (a + c);
    let outer = draw.signed(1e-30, 1.0);
    let (mut moments, mut omega) = ([a, b, c], [outer, draw.signed(1e-30, 1.0), outer]);
    if draw.below(2) == 0 {
        omega[2] = -outer;
    }
    let shift = draw.below(3);
    moments.rotate_left(shift);
    omega.rotate_left(shift);
    (moments, omega)
}

pub(super) fn attitude(draw: &mut Draw<'_>) -> UnitQuaternion<f64> {
    if draw.below(3) == 0 {
        return UnitQuaternion::identity();
    }
    let [w, i, j, k] = std::array::from_fn(|_| draw.between(-1.0, 1.0));
    UnitQuaternion::from_quaternion(Quaternion::new(w, i, j, k + 1e-9))
}

/// Units of moments and of rates, up to the ends of what is taken.
pub(super) fn scales(draw: &mut Draw<'_>) -> [f64; 2] {
    std::array::from_fn(|_| draw.binary_unit(160))
}

/// Which branch of the closed form a motion takes, found from its numbers alone; and k'² where there is one.
fn way(moments: [f64; 3], omega: [f64; 3]) -> (&'static str, f64) {
    let [a, b, c] = moments;
    let moving = omega.iter().filter(|&&w| w != 0.0).count();
    if a == b && b == c {
        return ("sphere", 1.0);
    }
    if a == b || b == c || c == a {
        let names = ["symmetric about 3", "symmetric about 1", "symmetric about 2"];
        return (names[[a == b, b == c, c == a].iter().position(|&equal| equal).unwrap()], 1.0);
    }
    if moving < 2 {
        return ("principal axis", 1.0);
    }
    let mut axes = [0, 1, 2];
    axes.sort_by(|&i, &j| moments[i].total_cmp(&moments[j]));
    let part = |axis: usize, other: usize| {
        let ([w, i], [_, j]) =
            ([omega[axis], moments[axis]].map(long), [omega[other], moments[other]].map(long));
        w * w * i * (i - j)
    };
    let [small, middle, large] = axes;
    let above = part(small, middle) + part(large, middle);
    if above == long(0.0) {
        return ("on the separatrix", 0.0);
    }
    let (inner, outer) = if above > long(0.0) { (small, large) } else { (large, small) };
    let [i, m, o] = [inner, middle, outer].map(|axis| long(moments[axis]));
    let up = part(inner, outer) + part(middle, outer);
    let down = part(middle, inner) + part(outer, inner);
    let parameter = up * (m - i) / ((m - o) * down);
    let complement = above * (o - i) / ((o - m) * down);
    let name = match (above > long(0.0), parameter <= long(0.5)) {
        (true, true) => "about the largest, slow",
        (true, false) => "about the largest, fast",
        (false, true) => "about the smallest, slow",
        (false, false) => "about the smallest, fast",
    };
    (name, complement.rounded())
}

pub(super) const WAYS: [&str; 10] = [
    "sphere",
    "symmetric about 1",
    "symmetric about 2",
    "symmetric about 3",
    "principal axis",
    "on the separatrix",
    "about the largest, slow",
    "about the largest, fast",
    "about the smallest, slow",
    "about the smallest, fast",
];

pub(super) struct Motion {
    pub(super) top: FreeTop,
    pub(super) start: Turning,
    pub(super) judge: Judge,
    pub(super) way: &'static str,
    pub(super) complement: f64,
    /// So many of the judge's units of time are a second.
    pub(super) rate: f64,
}

pub(super) fn motion(draw: &mut Draw<'_>) -> Option<Motion> {
    let (moments, omega) = if draw.below(12) == 0 {
        on_the_separatrix(draw)
    } else {
        let moments = moments(draw);
        (moments, if draw.below(20) == 0 { [0.0, 1.0, 0.0] } else { omega(draw, moments) })
    };
    let [heavy, rate] = scales(draw);
    let [i1, i2, i3] = moments.map(|moment| moment * heavy);
    let body = PrincipalMoments::new(i1, i2, i3).ok()?;
    let start = Turning { world_from_body: attitude(draw), omega_body: Vector3::from(omega) * rate };
    let top = FreeTop::new(body, start).ok()?;
    let (way, complement) = way(moments, omega);
    Some(Motion { top, start, judge: Judge::new(moments, omega), way, complement, rate })
}

impl Motion {
    /// A case from the time in the judge's units.
    pub(super) fn case(&self, time: f64, truth: &[Long; 7]) -> Case {
        let seconds = time / self.rate;
        let single = self.top.at(seconds).unwrap();
        let many = self.top.sample(&[seconds; 33]).unwrap();
        let scaled = |turning: &Turning| Turning { omega_body: turning.omega_body / self.rate, ..*turning };
        let start = scaled(&self.start);
        let (omega, angle) = errors(&scaled(&single), &start, truth);
        let (omega_of_many, angle_of_many) = errors(&scaled(&many[17]), &start, truth);
        let worst = [omega, angle, omega_of_many, angle_of_many].into_iter().fold(0.0, worse);
        Case {
            ratio: worst / PROMISE,
            way: self.way,
            said: format!(
                "{:?} {:?} {:?} t {seconds:?}: ω {omega:e}, attitude {angle:e}; of many {omega_of_many:e}, \
                 {angle_of_many:e}",
                self.top.moments().to_array(),
                self.start.omega_body.as_slice(),
                self.start.world_from_body.coords.as_slice(),
            ),
        }
    }
}
