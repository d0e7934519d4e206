//! What is left to chance: when the hand closes, and where the normal is seen.

use super::{coin, leaning, tossed};
use drawing::kit::{self, Heads};
use drawing::{Drawing, Fill, Hue, Point, Role, Side, Stroke, at};
use figures::{Cause, Outcome, Room, in_both, linear_steps};
use mechanics::scenes::coin_toss::{Face, ratio_for_probability};
use std::f64::consts::TAU;

/// Which face is up during some precessions, and two windows of 2.6 of them that begin at different moments.
pub(crate) fn catch_window(id: &str) -> Outcome {
    let (probability, window, whole) = (0.6, 2.6, 2.0);
    let toss = tossed(1.0, ratio_for_probability(coin()?, probability)?)?;
    let period = TAU / toss.precession_rate();
    let edge = toss.first_edge().ok_or("it goes over")? / period;
    // How long the face is up between two moments, in precessions.
    let up = |from: f64, to: f64| -> Result<f64, Cause> {
        let count = 4000;
        let mut sum = 0.0;
        for step in 0..count {
            let time = from + (to - from) * (f64::from(step) + 0.5) / f64::from(count);
            sum += if toss.face(time * period)? == Face::Same { 1.0 } else { 0.0 };
        }
        Ok(sum * (to - from) / f64::from(count))
    };
    let windows = [(1.0 - edge, "begins with the face"), (1.25, "begins later")];
    let shares = windows.map(|(from, _)| -> Result<[f64; 3], Cause> {
        Ok([up(from, from + whole)?, up(from + whole, from + window)?, up(from, from + window)?])
    });
    let shares = shares.into_iter().collect::<Result<Vec<_>, Cause>>()?;
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(580.0, 340.0), 220.0).titled(
            "Windows of 2.6 precessions",
            "A strip of time, four precessions long and some more. In each the face H is up for six tenths and the face T for four tenths. Above and below the strip two windows of 2.6 \
             precessions, each divided into two whole precessions and a rest. The upper window begins just when H appears: the whole ones show H for \
             1.2, and all 0.6 of the rest show it. The lower window begins later: the whole ones show H for 1.2 again, the rest for less.",
        );
        let (left, unit) = room.of((12.0, 132.0), (8.0, 77.0));
        let x = |time: f64| left + unit * (time + edge);
        let (top, bottom) = (92.0, 126.0);
        for turn in 0..5 {
            let turn = f64::from(turn);
            for (from, to, hue, name) in [
                (turn - edge, turn + edge, Hue::Blue, "H"),
                (turn + edge, turn + 1.0 - edge, Hue::Muted, "T"),
            ] {
                let to = to.min(4.0 - edge + 0.3);
                if to <= from {
                    continue;
                }
                let cell = [at(x(from), top), at(x(to), top), at(x(to), bottom), at(x(from), bottom)];
                drawing.polygon(cell.to_vec(), Fill::Face, hue);
                drawing.polyline(&[&cell[..], &cell[..1]].concat(), Stroke::Outline, hue);
                let middle = at(0.5 * (x(from) + x(to)), 0.5 * (top + bottom));
                drawing.label_on_face(middle, Side::Over, name, hue)?;
            }
        }
        for (row, ((from, name), share)) in windows.iter().zip(&shares).enumerate() {
            // One window above the strip, one below it; what is said of each lies outwards.
            let (near, level, out) =
                if row == 0 { (top, top - 22.0, -1.0) } else { (bottom, bottom + 22.0, 1.0) };
            for end in [*from, from + whole, from + window] {
                drawing.line(at(x(end), near), at(x(end), level + 5.0 * out), Stroke::Dotted, Hue::Ink);
            }
            for (begin, end, part, words) in [
                (*from, from + whole, share[0], room.of("two whole ones: H for", "H for")),
                (from + whole, from + window, share[1], room.of("rest: H for", "")),
            ] {
                let [a, b] = [begin, end].map(|time| at(x(time), level));
                kit::dimension(&mut drawing, a, b, Heads::Both, Hue::Ink);
                let text = format!("{words} ${part:.1}$").trim().to_owned();
                drawing.label(a.towards(b, 0.5) + at(0.0, 18.0 * out), Side::Over, &text, Hue::Ink)?;
            }
            let sum = format!("{name}: H for ${:.1}$ of ${window}$", share[2]);
            drawing.label(at(x(from + 0.5 * window), level + 44.0 * out), Side::Over, &sum, Hue::Muted)?;
        }
        Ok(drawing)
    })
}

/// The paths of the tip of a pin on the coin, seen from above, for four directions of the momentum.
pub(crate) fn pin_paths(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 300.0, 290.0).titled(
        "Paths of a pin’s tip, seen from above",
        "A circle, and in it three ellipses and a line that all pass through its middle. The ellipses lie to the right of the middle. That for 30 \
         degrees stays inside, that for 45 degrees touches the circle on the right, that for 60 degrees is wider, and touches it above and \
         below. For 90 degrees the path is the upright diameter.",
    );
    let (centre, radius) = (at(140.0, 144.0), 122.0);
    drawing.circle(centre, radius, Role::Line(Stroke::Dotted, Hue::Muted));
    for (degrees, stroke, hue) in [
        (30.0, Stroke::Outline, Hue::Ink),
        (45.0, Stroke::Curve, Hue::Ink),
        (60.0, Stroke::Curve, Hue::Muted),
        (90.0, Stroke::Curve, Hue::Muted),
    ] {
        let toss = leaning(degrees)?;
        let period = TAU / toss.precession_rate();
        let path = linear_steps(0.0, period, 240)
            .map(|time| Ok(toss.normal(time)?).map(|tip| centre + at(tip.x, -tip.y) * radius))
            .collect::<Result<Vec<Point>, Cause>>()?;
        drawing.polyline(&path, stroke, hue);
    }
    drawing.dot(centre, 3.5, Hue::Ink);
    for (place, text, hue) in [
        (at(0.52, 0.0), "$30°$", Hue::Ink),
        (at(0.433, -0.775), "$60°$", Hue::Muted),
        (at(-0.16, 0.0), "$90°$", Hue::Muted),
    ] {
        drawing.label(centre + place * radius, Side::Over, text, hue)?;
    }
    drawing.label(centre + at(1.0, 0.0) * radius, Side::Right, "$45°$", Hue::Ink)?;
    Ok(drawing)
}
