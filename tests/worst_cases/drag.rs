//! A symmetric body that spins down in air, against the solution of its linear equations in 32 digits, which is put to
//! the test against the equations by series.

use crate::long::{Long, long};
use crate::search::{Case, Draw, keeps_its_promise, worse};
use crate::taylor::System;
use mechanics::inertia::PrincipalMoments;
use mechanics::scenes::air_drag::{Drag, DraggedTop, DraggedTopParameters};
use nalgebra::Vector3;

const EPS: f64 = f64::EPSILON;

struct Body {
    moments: [f64; 2],
    drag: [f64; 2],
    omega: [f64; 3],
}

impl Body {
    fn draw(draw: &mut Draw<'_>) -> Self {
        let across = draw.one_of(&[1.0, 3.0]) * draw.binary_unit(120);
        let ratio = match draw.below(4) {
            0 => draw.beside(1.0),
            1 => draw.beside(2.0).min(2.0),
            _ => draw.decades(1e-6, 2.0),
        };
        // From none to so much that the body stands at once; and equal decays.
        let mut coefficient = || across * if draw.below(4) == 0 { 0.0 } else { draw.decades(1e-20, 10.0) };
        let mut drag = [coefficient(), coefficient()];
        if draw.below(3) == 0 {
            drag[1] = draw.beside(drag[0] * ratio);
        }
        let omega = std::array::from_fn(|_| draw.signed(1e-6, 10.0));
        Self { moments: [across, across * ratio], drag, omega }
    }

    fn top(&self) -> Option<DraggedTop> {
        let ([across, along], [transverse, axial]) = (self.moments, self.drag);
        let moments = PrincipalMoments::symmetric(across, along).ok()?;
        let (drag, omega_body) = (Drag { transverse, axial }, Vector3::from(self.omega));
        DraggedTop::new(DraggedTopParameters { moments, drag, omega_body }).ok()
    }

    /// The decays and the first rate of the wobble.
    fn rates(&self) -> [Long; 3] {
        let ([a, c], [transverse, axial]) = (self.moments.map(long), self.drag.map(long));
        [transverse / a, axial / c, long(self.omega[2]) * (c - a) / a]
    }

    /// How far the wobble has gone round in the body, and what of the spin is left.
    fn phase(&self, time: f64) -> (Long, Long) {
        let [_, axial, rate] = self.rates();
        let x = axial * time;
        let left = (-x).exp();
        // 1 − e^{−x}, by its series where it is a small difference.
        let gone = if x < long(0.25) {
            x * (1..26).rev().fold(long(1.0), |sum, n| long(1.0) - x * sum / f64::from(n + 1))
        } else {
            long(1.0) - left
        };
        let fraction = if x == long(0.0) { long(1.0) } else { gone / x };
        (rate * time * fraction, left)
    }

    fn omega_at(&self, time: f64) -> [Long; 3] {
        let ((phase, left), [transverse, _, _]) = (self.phase(time), self.rates());
        let (sin, cos) = phase.sin_cos();
        let across = (-(transverse * time)).exp();
        let [x, y, z] = self.omega.map(long);
        [across * (x * cos - y * sin), across * (x * sin + y * cos), left * z]
    }

    fn said(&self, time: f64) -> String {
        format!("I {:?} C {:?} ω {:?} t {time:?}", self.moments, self.drag, self.omega)
    }
}

#[test]
fn the_judge_of_the_drag_solves_eulers_equations() {
    keeps_its_promise("the judge of the drag", 100, &["any"], |draw| {
        let body = Body::draw(draw);
        body.top()?;
        let (mut system, states @ [x, y, z]) = System::new();
        let ([a, c], [transverse, axial]) = (body.moments.map(long), body.drag.map(long));
        let [yz, zx] = [(y, z), (z, x)].map(|(p, q)| system.product(p, q));
        let coupling = (c - a) / a;
        system.rate(x, &[(-transverse / a, x), (-coupling, yz)]);
        system.rate(y, &[(-transverse / a, y), (coupling, zx)]);
        system.rate(z, &[(-axial / c, z)]);
        let quickest = 10.0 + body.rates()[..2].iter().map(|rate| rate.rounded()).fold(0.0, f64::max);
        let time = draw.decades(1e-3, 20.0) / quickest;
        let truth = system.sample(&body.omega.map(long), &[long(time)]).remove(0);
        let found = body.omega_at(time);
        let error =
            states.iter().enumerate().map(|(n, _)| (truth[n] - found[n]).abs().rounded()).fold(0.0, worse);
        Some(Case { ratio: error / 1e-27, way: "any", said: format!("{}: {error:e}", body.said(time)) })
    });
}

#[test]
fn the_angular_velocity_in_air_is_good_to_a_few_units_of_the_start_and_of_its_phase() {
    keeps_its_promise("drag", 4000, &["no drag", "drag across only", "early", "late"], |draw| {
        let body = Body::draw(draw);
        let top = body.top()?;
        let time = if draw.below(20) == 0 { 0.0 } else { draw.decades(1e-6, 1e12) };
        let (truth, (phase, left)) = (body.omega_at(time), body.phase(time));
        let (single, samples) = (top.at(time).ok()?, top.sample(&[time; 33]).ok()?);
        let error = |found: Vector3<f64>| {
            let worst = (0..3).map(|n| (truth[n] - found[n]).abs().rounded()).fold(0.0, worse);
            if found.iter().all(|x| x.is_finite()) { worst } else { f64::INFINITY }
        };
        let [one, many] = [single, samples[17]].map(error);
        let size = Vector3::from(body.omega).norm();
        // The phase is exact where nothing slows the spin; else it is rounded as the time is.
        let across = (-(body.rates()[0] * time)).exp().rounded();
        let rounded = if body.drag[1] == 0.0 { 0.0 } else { 2.0 * phase.abs().rounded() * across };
        let promise = (4.0 + rounded) * EPS * size;
        let way = match (body.drag, left.rounded() < 0.5) {
            ([0.0, 0.0], _) => "no drag",
            ([_, 0.0], _) => "drag across only",
            ([_, _], false) => "early",
            ([_, _], true) => "late",
        };
        let said = format!("{}: {one:e}, of many {many:e}", body.said(time));
        Some(Case { ratio: worse(one, many) / promise, way, said })
    });
}

#[test]
fn the_angle_of_the_axis_has_all_its_digits_however_small_it_is() {
    keeps_its_promise("angle in air", 2000, &["along the axis", "against the axis"], |draw| {
        let body = Body::draw(draw);
        let top = body.top()?;
        let time = draw.decades(1e-6, 1e6);
        let [x, y, z] = body.omega.map(long);
        let [transverse, axial, _] = body.rates();
        let tangent = (x * x + y * y).sqrt() * ((axial - transverse) * time).exp() / z.abs();
        if !(1e-290..1e140).contains(&tangent.rounded()) {
            return None;
        }
        let found = top.axis_angle(time).ok()?;
        let (way, found) = if z < long(0.0) {
            ("against the axis", std::f64::consts::PI - found)
        } else {
            ("along the axis", found)
        };
        // Compared by the tangent, and where that is large by the cotangent: dα = d(tan α)/(1 + tan² α).
        let off = if tangent.rounded() < 1.0 {
            let (sin, cos) = long(found).sin_cos();
            (sin - tangent * cos) / (tangent * tangent + 1.0).sqrt()
        } else {
            let (sin, cos) = long(found).sin_cos();
            (sin / tangent - cos) * tangent / (tangent * tangent + 1.0).sqrt()
        };
        let truth = tangent.rounded().atan();
        let error = off.abs().rounded();
        let size = if way == "along the axis" { truth } else { std::f64::consts::PI };
        let ratio = error / (4.0 * EPS * size);
        Some(Case { ratio, way, said: format!("{}: {found:e}, error {error:e}", body.said(time)) })
    });
}

#[test]
fn without_drag_no_phase_is_lost_in_a_million_million_seconds() {
    // What a rate of one part cost: 1.7e-12 at 1e6 s and 1e-6 at 1e12 s.
    let body = Body { moments: [3.0, 1.7], drag: [0.0, 0.0], omega: [0.4, -1.1, 2.3] };
    for time in [1e6, 1e9, 1e12] {
        let (found, truth) = (body.top().unwrap().at(time).unwrap(), body.omega_at(time));
        for (n, truth) in truth.into_iter().enumerate() {
            assert!((truth - found[n]).abs().rounded() < 1e-15, "{time:e}");
        }
    }
}
