//! A coin with an edge: which directions lie under the edge, and how often it lands on it.

use super::leaning;
use drawing::kit::{self, Heads, Marker};
use drawing::{Drawing, Fill, Hue, Point, Rect, Role, Side, Stroke, at};
use figures::{Axis, Cause, Outcome, Plot, linear_steps};
use mechanics::InvalidQuantity;
use mechanics::inertia::Cylinder;
use mechanics::scenes::coin_toss::edge_at_random;
use std::f64::consts::PI;

/// Thickness over diameter of the coin that lands on its edge in a third of all attitudes, and of the one that does so
/// in a third of a tumble.
fn thirds() -> [f64; 2] {
    [1.0 / 8_f64.sqrt(), 1.0 / 3_f64.sqrt()]
}

/// A coin of a diameter of 2 with a thickness over diameter.
fn coin(ratio: f64) -> Cylinder {
    Cylinder { radius: 1.0, height: 2.0 * ratio }
}

/// Both coins in the sphere of all directions.
pub(crate) fn edge_band(id: &str) -> Outcome {
    let [area, arc] = thirds();
    let left = in_its_sphere(
        area,
        "a third of the sphere",
        "A coin seen from the side, flat, in a circle through its four corners: the sphere of all directions. \
         The edge of the coin cuts a band out of it, whose height is a third of the height of the sphere. The \
         thickness is 0.354 of the diameter.",
    )?;
    let right = in_its_sphere(
        arc,
        "a third of the circle",
        "A thicker coin, drawn in the same way, 0.577 of its diameter thick. The two arcs of the circle within \
         the band are together a third of the circle, and the band is half as high as the sphere.",
    )?;
    Ok(Drawing::panels(id, vec![left, right]))
}

/// A coin, flat, in the sphere through its corners.
fn in_its_sphere(ratio: f64, name: &str, description: &str) -> Outcome {
    let mut drawing = Drawing::new("", 280.0, 290.0).titled(name, description);
    let (centre, radius) = (at(140.0, 124.0), 98.0);
    let half = edge_at_random(coin(ratio))?.asin();
    let arc = |from: f64, to: f64| {
        linear_steps(from, to, 40).map(|turn| centre + Point::polar(radius, turn)).collect::<Vec<_>>()
    };
    let [right, left] = [arc(-half, half), arc(PI - half, PI + half)];
    drawing.polygon(right.iter().chain(&left).copied().collect(), Fill::Ground, Hue::Pink);
    let corners = [right[0], right[40], left[0], left[40]];
    drawing.polygon(corners.to_vec(), Fill::Face, Hue::Blue);
    for (from, to) in [(corners[1], corners[2]), (corners[3], corners[0])] {
        drawing.line(from, to, Stroke::Outline, Hue::Blue);
    }
    drawing.line(corners[0], corners[1], Stroke::Outline, Hue::Blue);
    drawing.line(corners[2], corners[3], Stroke::Outline, Hue::Blue);
    drawing.circle(centre, radius, Role::Line(Stroke::Outline, Hue::Muted));
    for side in [&right, &left] {
        drawing.polyline(side, Stroke::Curve, Hue::Pink);
    }
    drawing.line(centre, corners[1], Stroke::Reference, Hue::Ink);
    drawing.line(centre, centre + at(radius, 0.0), Stroke::Reference, Hue::Ink);
    kit::angle(&mut drawing, centre, 46.0, 0.0, half, Heads::None, Hue::Ink);
    drawing.label_on_face(centre + Point::polar(50.0, 0.5 * half), Side::Right, r"$\beta$", Hue::Ink)?;
    drawing.dot(centre, 3.5, Hue::Ink);
    drawing.label(centre + at(0.0, -0.8 * radius), Side::Over, "heads", Hue::Muted)?;
    drawing.label(centre + at(0.0, 0.8 * radius), Side::Over, "tails", Hue::Muted)?;
    drawing.label(centre + at(-radius - 4.0, 0.0), Side::Left, "edge", Hue::Pink)?;
    drawing.label(at(140.0, 252.0), Side::Over, name, Hue::Ink)?;
    drawing.label(at(140.0, 274.0), Side::Over, &format!("$h/2a = {ratio:.3}$"), Hue::Ink)?;
    Ok(drawing)
}

/// How often a coin lands on its edge: against its thickness, and against the twist of the toss.
pub(crate) fn edge_chance(id: &str) -> Outcome {
    Ok(Drawing::panels(id, vec![against_thickness()?, against_angle()?]))
}

/// Thickness over diameter of an American nickel, 1.95 mm by 21.21 mm.
const NICKEL: f64 = 1.95 / 21.21;

/// Two answers for every coin.
fn against_thickness() -> Outcome {
    let mut drawing = Drawing::new("", 280.0, 310.0).titled(
        "Chance of the edge against the thickness",
        "The chance of the edge against thickness over diameter, from 0 to 1. Both curves begin at zero as \
         straight lines. The upper, for a coin in any attitude, reaches one third at 0.354; the lower, for a \
         coin that tumbles about a level axis, at 0.577. A nickel, at 0.092, has 0.092 and 0.058.",
    );
    let thickness = Axis::linear(0.0, 1.0, 0.2).minor(0.05).titled("thickness over diameter, $h/2a$");
    let chance = Axis::linear(0.0, 0.8, 0.2).minor(0.05).titled("chance of the edge");
    let mut plot = Plot::new(&mut drawing, Rect::new(44.0, 34.0, 222.0, 222.0), thickness, chance)?;
    plot.level(1.0 / 3.0, Stroke::Reference);
    let tumble = leaning(90.0)?;
    let arc = |ratio: f64| Ok::<_, InvalidQuantity>(tumble.landings(coin(ratio))?.edge);
    let area = |ratio: f64| edge_at_random(coin(ratio));
    let values = |of: &dyn Fn(f64) -> Result<f64, InvalidQuantity>| {
        linear_steps(0.0, 1.0, 100).map(|x| Ok((x, of(x)?))).collect::<Result<Vec<_>, InvalidQuantity>>()
    };
    plot.curve("arc", values(&arc)?, Stroke::Curve, Hue::Muted);
    plot.curve("area", values(&area)?, Stroke::Curve, Hue::Ink);
    let third = 1.0 / 3.0;
    for ratio in thirds() {
        plot.markers(&[(ratio, third)], Marker::Disc, Hue::Ink);
    }
    plot.markers(&[(NICKEL, area(NICKEL)?), (NICKEL, arc(NICKEL)?)], Marker::Disc, Hue::Ink);
    plot.label((0.13, 0.045), Side::Right, "nickel", Hue::Ink)?;
    plot.label((0.6, 0.53), Side::AboveLeft, "any attitude", Hue::Ink)?;
    plot.label((0.86, 0.225), Side::Over, "tumbled", Hue::Muted)?;
    plot.label((thirds()[0], third), Side::AboveLeft, "$0.354$", Hue::Ink)?;
    plot.label((thirds()[1], third), Side::BelowRight, "$0.577$", Hue::Ink)?;
    Ok(drawing)
}

/// The nickel, by the angle between its normal and L.
fn against_angle() -> Result<Drawing, Cause> {
    let mut drawing = Drawing::new("", 280.0, 310.0).titled(
        "Chance of the edge against theta L, for a nickel",
        "The chance that a nickel lands on its edge, against theta L from 40 to 90 degrees. It is zero up to 42.4 \
         degrees, rises to a sharp peak of 0.27 at 47.6 degrees, and falls to 0.058 at 90 degrees, a tumble. \
         The dashed curve of the limit of thin coins joins it on the right of the peak.",
    );
    let angle = Axis::linear(40.0, 90.0, 10.0).minor(5.0).titled(r"$\theta_L$, degrees");
    let chance = Axis::linear(0.0, 0.4, 0.1).minor(0.02).titled("chance of the edge, nickel");
    let mut plot = Plot::new(&mut drawing, Rect::new(44.0, 34.0, 222.0, 222.0), angle, chance)?;
    let sine = edge_at_random(coin(NICKEL))?;
    // The borders, where the curve has corners: the lowest normal, cos 2θ_L, is ±sin β.
    let [first, peak] = [sine, -sine].map(|lowest: f64| 0.5 * lowest.acos().to_degrees());
    let mut values = vec![(40.0, 0.0)];
    for (from, to) in [(first, peak), (peak, 90.0)] {
        for step in linear_steps(0.0, 1.0, 300) {
            let degrees = from + (to - from) * step * step; // dense where it sets out
            values.push((degrees, leaning(degrees)?.landings(coin(NICKEL))?.edge));
        }
    }
    let thin = linear_steps(0.0, 1.0, 300).map(|step| {
        let degrees = 45.3 + 44.7 * step * step;
        let chance = leaning(degrees)?.thin_edge(coin(NICKEL))?;
        Ok((degrees, chance.ok_or("its normal crosses the horizon")?))
    });
    let thin = thin.collect::<Result<Vec<_>, Cause>>()?;
    plot.curve("thin", thin, Stroke::DashedCurve, Hue::Muted);
    plot.curve("nickel", values, Stroke::Curve, Hue::Ink);
    let best = leaning(peak)?.landings(coin(NICKEL))?.edge;
    plot.label((peak, best), Side::Right, "dips to the border", Hue::Ink)?;
    plot.label((89.0, 0.07), Side::AboveLeft, "tumble", Hue::Ink)?;
    Ok(drawing)
}
