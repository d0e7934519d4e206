//! A struck station and a pinned body: what the blow leaves behind, in 32 digits.

use crate::long::{Long, long, off_angle};
use crate::search::{Case, keeps_its_promise, worse};
use mechanics::inertia::{Body, Cylinder, Spheroid};
use mechanics::scenes::pinned_hoop::{Pin, Pinning, PinningParameters, Shape};
use mechanics::scenes::space_station::{Blow, Station, StationParameters};

const EPS: f64 = f64::EPSILON;

#[test]
fn a_struck_station_leans_and_nods_to_a_few_units() {
    let ways = ["a nudge", "a blow", "a nudge, turning backwards", "a blow, turning backwards"];
    keeps_its_promise("struck station", 3000, &ways, |draw| {
        let (mass, size) = (draw.unit(15), draw.unit(12));
        let body = match draw.below(4) {
            0 => Body::hoop(mass, size),
            1 => Body::cylinder(mass, Cylinder { radius: size * draw.decades(1e-4, 1e3), height: size }),
            2 => Body::spheroid(mass, Spheroid { equatorial_radius: size, polar_radius: draw.beside(size) }),
            _ => Body::thin_disk(mass, size),
        };
        let body = body.ok()?;
        let spin = draw.one_of(&[-1.0, 1.0]) * draw.decades(1e-9, 1e9);
        let [across, _, along] = body.moments().to_array().map(long); // I₁ and I₃
        // From hardly to a blow that is all.
        let gained = spin * draw.signed(1e-12, 1e12);
        let (radius, impulse) = (size, gained * across.rounded() / size);
        let station = Station::new(StationParameters { body, spin }).ok()?;
        let struck = station.struck(Blow { radius, impulse }).ok()?;
        let omega = long(radius) * impulse / across;
        let spin = long(spin);
        let axis = off_angle((omega.abs(), spin.abs()), struck.axis_angle());
        let momentum = off_angle(((omega * across).abs(), (spin * along).abs()), struck.momentum_angle());
        let part = along / across * spin;
        let rates = [
            ((omega * omega + part * part).sqrt(), struck.nodding_rate()),
            (spin * (along - across) / across, struck.body_rate()),
            (omega, struck.added_rate()),
            (long(impulse) / mass, struck.centre_velocity().z),
        ];
        let rates = rates.map(|(truth, found)| truth.off(found));
        let error = rates.into_iter().fold(worse(axis, momentum), worse);
        let way = match (spin > long(0.0), omega.abs() > spin.abs()) {
            (true, false) => "a nudge",
            (true, true) => "a blow",
            (false, false) => "a nudge, turning backwards",
            (false, true) => "a blow, turning backwards",
        };
        Some(Case { ratio: error / (4.0 * EPS), way, said: format!("{struck:?}: off {error:e}") })
    });
}

#[test]
fn a_pinned_body_keeps_what_it_keeps_to_a_few_units() {
    keeps_its_promise("pinned body", 3000, &["by the angle", "by the point"], |draw| {
        let (shape, kappa) =
            draw.one_of(&[(Shape::Hoop, [1.0, 3.0]), (Shape::Disk, [1.0, 5.0]), (Shape::Sphere, [2.0, 7.0])]);
        let (mass, radius) = (draw.unit(15), draw.unit(15));
        let spin = draw.one_of(&[-1.0, 1.0]) * draw.decades(1e-9, 1e9);
        // By the angle anywhere; by the point next to the right angle and to the poles, on either side.
        let (pin, sin, cos, way) = if draw.below(2) == 0 {
            // Next to a right angle, next to where B or the point opposite stays at rest, and anywhere.
            let still = f64::atan2(kappa[1], kappa[0]);
            let angle = match draw.below(4) {
                0 => draw.beside(std::f64::consts::FRAC_PI_2),
                1 => draw.beside(still).min(std::f64::consts::PI),
                2 => (std::f64::consts::PI - draw.beside(still)).max(0.0),
                _ => draw.between(0.0, std::f64::consts::PI),
            };
            let (sin, cos) = long(angle).sin_cos();
            (Pin::Angle(angle), sin, cos, "by the angle")
        } else {
            let small = radius * draw.decades(1e-14, 0.7);
            let large = (radius * radius - small * small).sqrt();
            let [from_axis, height] = if draw.below(2) == 0 { [small, large] } else { [large, small] };
            let height = height * draw.one_of(&[-1.0, 1.0]);
            let length = (long(from_axis) * from_axis + long(height) * height).sqrt();
            let pin = Pin::Point { from_axis, height };
            (pin, long(from_axis) / length, long(height) / length, "by the point")
        };
        let pinning = Pinning::new(PinningParameters { shape, mass, radius, spin, pin }).ok()?;
        let kappa = long(kappa[0]) / kappa[1];
        let after = pinning.omega_after();
        let (before_1, before_2) = (sin * spin, -(cos * spin));
        let m = long(mass) * radius * radius;
        // I₁ = κma²/(1 − κ), and the energy ½I₁(ω₀ sin θ)²(1 − κ).
        let lost = kappa * m * before_1 * before_1 * 0.5;
        let (alpha, phi) = (pinning.axis_angle(), pinning.axis_shift());
        let velocity = pinning.centre_velocity().z;
        // Of two parts, of which the sum of the sizes counts.
        let [part_1, part_2] = [kappa * before_1 * radius, before_2 * radius];
        let of_parts =
            |truth: Long, found: f64| ((truth - found) / (part_1.abs() + part_2.abs())).abs().rounded();
        let errors = [
            of_parts(part_1 + part_2, pinning.velocity_of_b()),
            of_parts(part_1 - part_2, pinning.velocity_opposite_b()),
            (kappa * before_1).off(after.x),
            before_2.off(after.y),
            lost.off(pinning.energy_lost()),
            (kappa * before_1 * radius).off(velocity),
            off_angle((sin, cos), pinning.angle()),
            off_angle((cos.abs(), kappa * sin), alpha.abs()),
            off_angle(((long(1.0) - kappa) * sin * cos.abs(), kappa * sin * sin + cos * cos), phi.abs()),
        ];
        let error = errors.into_iter().fold(0.0, worse);
        let signs =
            alpha.is_sign_negative() == (cos < long(0.0)) && phi.is_sign_negative() == (cos < long(0.0));
        let error = if signs { error } else { f64::INFINITY };
        Some(Case { ratio: error / (6.0 * EPS), way, said: format!("{pinning:?}: off {errors:?}") })
    });
}
