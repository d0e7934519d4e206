//! The crew's sky: what a camera at the hub sees.

use super::struck::Struck;
use live::prelude::*;
use nalgebra::Vector3;
use std::sync::LazyLock;

/// How long the shutter of the camera at the hub is open, s, and half its field of view, rad.
const EXPOSURE: f64 = 1.7;
const FIELD: f64 = 50.0 * TAU / 360.0;

/// The stars; the last one stood on the cross before the blow.
static STARS: LazyLock<Vec<Vector3<f64>>> =
    LazyLock::new(|| directions(170).into_iter().chain([Vector3::z()]).collect());

/// Directions spread evenly over the sky: steps of the golden angle, equal areas.
pub(super) fn directions(count: u32) -> Vec<Vector3<f64>> {
    let star = |k: u32| {
        let z = 1.0 - (2.0 * f64::from(k) + 1.0) / f64::from(count);
        let (sin, cos) = (2.399_963 * f64::from(k)).sin_cos();
        let across = (1.0 - z * z).sqrt();
        Vector3::new(across * cos, across * sin, z)
    };
    (0..count).map(star).collect()
}

/// What a camera at the hub sees that looks along axis 3: star trails, the pole about which they turn.
pub(super) fn draw_sky(
    station: &Struck,
    (sky, radius): (Point, f64),
    time: f64,
    drawing: &mut Drawing,
) -> Result<(), Cause> {
    let in_picture = |direction: &Vector3<f64>| {
        let scale = radius / ((1.0 + direction.z) * (0.5 * FIELD).tan());
        sky + at(direction.y, -direction.x) * scale
    };
    let steps = (0..=8).map(|step| time - EXPOSURE * f64::from(step) / 8.0);
    let attitudes = steps.map(|time| Ok(station.at(time)?.world_from_body.inverse()));
    let attitudes = attitudes.collect::<Result<Vec<_>, Cause>>()?;
    let inside = |point: Point| (point - sky).length() < radius - 2.0;
    let mut seen = Vec::new();
    for star in STARS.iter() {
        let now = attitudes[0] * star;
        if now.z < 0.5 || !inside(in_picture(&now)) {
            continue;
        }
        let trail = attitudes.iter().map(|body_from_world| in_picture(&(body_from_world * star)));
        let trail: Vec<Point> = trail.take_while(|point| inside(*point)).collect();
        drawing.polyline(&trail, Stroke::Outline, Hue::Ink);
        seen.push(trail[0]);
    }
    for star in seen {
        drawing.polyline(&[star, star], Stroke::Curve, Hue::Ink); // a dot: all of them are one element
    }
    let left = in_picture(&(attitudes[0] * Vector3::z()));
    if inside(left) {
        drawing.circle(left, 6.0, Role::Line(Stroke::Curve, Hue::Ink));
    }
    drawing.circle(sky, radius, Role::Line(Stroke::Outline, Hue::Muted));
    let now = station.at(time)?;
    let pole = in_picture(&now.omega_body.normalize());
    let momentum = in_picture(&(attitudes[0] * station.momentum(time).normalize()));
    let reach = (pole - sky).length();
    if reach > 3.0 && reach < radius - 4.0 {
        drawing.circle(sky, reach, Role::Line(Stroke::Outline, Hue::Orange));
    }
    for step in [at(5.0, 0.0), at(0.0, 5.0)] {
        drawing.line(sky - step, sky + step, Stroke::Vector, Hue::Blue);
    }
    if inside(momentum) {
        drawing.dot(momentum, 3.5, Hue::Green);
    }
    if inside(pole) {
        drawing.dot(pole, 4.0, Hue::Orange);
    } else {
        // Out of the field of view: there it would be.
        let way = (pole - sky).unit();
        let rim = sky + way * radius;
        kit::arrow(drawing, rim - way * 15.0, rim, Hue::Orange);
        let beside = rim - way * 15.0 + way.quarter_turned() * 13.0;
        let (name, role) = (r"$\boldsymbol{\omega}$", Role::Text(Hue::Orange));
        drawing.label_set(beside, Side::Over, 0.0, 14.0, name, role)?;
    }
    if reach > 16.0 {
        let outwards = (pole - sky).unit();
        let beyond = if reach < radius - 18.0 { 13.0 } else { -13.0 };
        for (place, name, hue, is_shown) in [
            (pole + outwards * beyond, r"$\boldsymbol{\omega}$", Hue::Orange, inside(pole)),
            (
                momentum + outwards.quarter_turned() * 12.0, // beside it: the cross and the star may lie on the line
                r"$\boldsymbol{L}$",
                Hue::Green,
                inside(momentum) && reach > 26.0,
            ),
            (sky - outwards * 15.0, r"$\hat{\mathbf{3}}$", Hue::Blue, true),
        ] {
            if is_shown {
                drawing.label_set(place, Side::Over, 0.0, 14.0, name, Role::Text(hue))?;
            }
        }
    }
    let title = sky - at(0.0, radius + 4.0);
    drawing.label_set(title, Side::Above, 4.0, 13.0, "the crew’s sky", Role::Text(Hue::Ink))?;
    Ok(())
}
