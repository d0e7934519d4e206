//! The figures of the report "Speed and accuracy": the committed measurements, drawn.

#[allow(dead_code, reason = "shared with the runner and the tests, which also write, and make tables")]
#[path = "../../benches/speed/measured.rs"]
pub(crate) mod measured;

use crate::{Axis, Cause, Outcome, Plot};
use drawing::kit::Marker;
use drawing::{Drawing, Hue, Rect, Side, Stroke, at};
use measured::{Measurement, NATIVE, front, methods, parse, seconds_front};

/// A contestant's method, and its errors with what they cost.
type Series<'a> = ((&'a str, &'a str), Vec<(f64, f64)>);

/// The committed measurements.
pub(crate) fn measurements() -> Result<Vec<Measurement>, Cause> {
    Ok(parse(include_str!("measured.csv"))?)
}

/// How a method is drawn: its label, marker and hue.
fn look((contestant, method): (&str, &str)) -> (String, Marker, Hue) {
    match (contestant, method) {
        ("mechanics", "DOP853") => ("DOP853".into(), Marker::Disc, Hue::Blue),
        ("mechanics", "RK4") => ("RK4".into(), Marker::Square, Hue::Orange),
        ("mechanics", "closed form" | "half a wobble") => (method.into(), Marker::Diamond, Hue::Green),
        ("mechanics", "Taylor") => (method.into(), Marker::Triangle, Hue::Pink),
        ("mechanics", _) => (method.into(), Marker::Ring, Hue::Purple),
        ("heyoka", _) => (contestant.into(), Marker::Triangle, Hue::Muted),
        ("ivp", _) => (contestant.into(), Marker::Disc, Hue::Muted),
        ("differential-equations" | "mujoco", _) => (contestant.into(), Marker::Square, Hue::Muted),
        ("ode_solvers", _) => (contestant.into(), Marker::Diamond, Hue::Muted),
        _ => (contestant.into(), Marker::Ring, Hue::Muted),
    }
}

/// The powers of ten between which all values lie, with room for a label at the lowest.
fn decades(values: impl Iterator<Item = f64> + Clone) -> (f64, f64) {
    let (least, most) = (values.clone().fold(f64::INFINITY, f64::min), values.fold(0.0, f64::max));
    (10.0_f64.powf((least.log10() - 0.2).floor()), 10.0_f64.powf(most.log10().ceil()))
}

/// Places for labels near the wished ones, in the same order, at least `gap` apart, between two bounds.
fn spread(wished: &[f64], gap: f64, (from, to): (f64, f64)) -> Vec<f64> {
    let mut places = wished.to_vec();
    let mut free = from;
    for place in &mut places {
        *place = place.max(free);
        free = *place + gap;
    }
    let mut free = to;
    for place in places.iter_mut().rev() {
        *place = place.min(free);
        free = *place - gap;
    }
    places
}

pub(crate) fn speed_washer(id: &str) -> Outcome {
    time(id, "washer", "two hundred turns of a washing machine")
}

pub(crate) fn speed_ramp(id: &str) -> Outcome {
    time(id, "ramp", "a washing machine that passes its resonance")
}

pub(crate) fn speed_hoop(id: &str) -> Outcome {
    time(id, "hoop", "a thousand periods of the pinned hoop")
}

pub(crate) fn speed_separatrix(id: &str) -> Outcome {
    time(id, "separatrix", "the pinned hoop beside its separatrix")
}

pub(crate) fn speed_disk(id: &str) -> Outcome {
    time(id, "disk", "two hundred precessions of a rolling disk")
}

pub(crate) fn speed_rest(id: &str) -> Outcome {
    time(id, "rest", "a disk that rolls to rest")
}

pub(crate) fn speed_toss(id: &str) -> Outcome {
    time(id, "toss", "a tossed coin")
}

pub(crate) fn speed_station(id: &str) -> Outcome {
    time(id, "station", "a struck space station")
}

pub(crate) fn speed_drag(id: &str) -> Outcome {
    time(id, "drag", "a disc that spins down in air")
}

/// Error against time on one problem: all contestants.
fn time(id: &str, problem: &str, words: &str) -> Outcome {
    let rows = measurements()?;
    let mut series = Vec::new();
    for name in methods(&rows, problem) {
        if name.0 == NATIVE {
            continue;
        }
        // Who is wrong by more than one has no answer.
        let values = seconds_front(&rows, problem, name).into_iter().filter(|(error, _)| *error < 1.0);
        let values: Vec<(f64, f64)> = values.map(|(error, seconds)| (error, 1e3 * seconds)).collect();
        if !values.is_empty() {
            series.push((name, values));
        }
    }
    let description = describe(&series);
    let mut drawing =
        Drawing::new(id, 680.0, 400.0).titled(&format!("Error against time for {words}"), &description);
    let all = series.iter().flat_map(|(_, values)| values).copied();
    let (least, most) = decades(all.clone().map(|(_, time)| time));
    let (_, coarsest) = decades(all.map(|(error, _)| error));
    let error = Axis::log(1e-16, coarsest.clamp(1e-2, 1.0), 4)?.titled("largest error");
    let cost = Axis::log(least, most, 1)?.titled("time, ms");
    let frame = Rect::new(62.0, 34.0, 440.0, 312.0);
    let mut plot = Plot::new(&mut drawing, frame, error, cost)?;
    // Peers lie beneath.
    series.sort_by_key(|((contestant, _), _)| *contestant == "mechanics");
    let mut ends = Vec::new();
    for (name, values) in &series {
        let (label, marker, hue) = look(*name);
        plot.series(&format!("{} {}", name.0, name.1).replace([' ', '(', ')'], "-"), values, marker, hue);
        let shown = values.iter().find(|&&value| plot.frame().grown(0.5).contains(plot.at(value)));
        if let Some(&end) = shown {
            ends.push((end, label, hue, name.1 == "closed form"));
        }
    }
    let (alone, ends): (Vec<_>, Vec<_>) = ends.into_iter().partition(|&(.., alone)| alone);
    for (end, label, hue, _) in alone {
        plot.label(end, Side::Right, &label, hue)?;
    }
    // Labels stand in a column, in the order of the ends of their curves, each with a line to its own.
    let mut ends: Vec<_> = ends.into_iter().map(|(end, label, hue, _)| (plot.at(end), label, hue)).collect();
    ends.sort_by(|a, b| a.0.y.total_cmp(&b.0.y));
    let wished: Vec<f64> = ends.iter().map(|(end, ..)| end.y).collect();
    let places = spread(&wished, 18.0, (frame.top, frame.bottom - 4.0));
    for ((end, label, hue), y) in ends.into_iter().zip(places) {
        let drawing = plot.drawing();
        let foot = at(frame.right + 14.0, y);
        drawing.line(end.towards(foot, 6.0 / (foot - end).length().max(12.0)), foot, Stroke::Dotted, hue);
        drawing.label(foot, Side::Right, &label, hue)?;
    }
    Ok(drawing)
}

/// The figure in words: who is how fast at what error.
fn describe(series: &[Series<'_>]) -> String {
    let mut text = String::from("Both scales are logarithmic, error along x and milliseconds along y.");
    for ((contestant, method), values) in series {
        if let (Some(first), Some(last)) = (values.first(), values.last()) {
            text += &if values.len() == 1 {
                format!(" {contestant}, {method}: error {:.0e} in {:.2} ms.", first.0, first.1)
            } else {
                format!(
                    " {contestant}, {method}: from error {:.0e} in {:.2} ms to {:.0e} in {:.2} ms.",
                    first.0, first.1, last.0, last.1
                )
            };
        }
    }
    text
}

/// Error against evaluations of the rates, for the library's steppers on all problems.
pub(crate) fn speed_work(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 680.0, 686.0).titled(
        "Error against evaluations of the rates",
        "Nine plots with logarithmic scales, the error along x and the number of evaluations along y, one for each problem. In each the \
         number grows with every digit, for the Runge-Kutta method of order four by a factor of 1.8 and for DOP853 by about 1.3, so \
         that their curves cross or draw apart towards small errors. Next to the separatrix neither comes below an error of a thousandth.",
    );
    let rows = measurements()?;
    let problems =
        ["washer", "ramp", "hoop", "separatrix", "disk", "rest", "toss", "station", "drag"];
    for (place, problem) in problems.into_iter().enumerate() {
        let (column, row) = ((place % 3) as f64, (place / 3) as f64);
        let frame = Rect::new(50.0 + 218.0 * column, 40.0 + 216.0 * row, 176.0, 150.0);
        let mut error = Axis::log(1e-12, 1.0, 4)?;
        let mut evaluations = Axis::log(1e3, 1e8, 1)?;
        if place == 8 {
            error = error.titled("largest error");
        }
        if place == 0 {
            evaluations = evaluations.titled("evaluations of the rates");
        }
        let mut plot = Plot::new(&mut drawing, frame, error, evaluations)?;
        for method in ["RK4", "DOP853"] {
            let (label, marker, hue) = look(("mechanics", method));
            let mine = |row: &&Measurement| row.problem == problem && row.contestant == "mechanics" && row.method == method;
            let pairs = rows.iter().filter(mine);
            let values = front(pairs.filter_map(|row| Some((row.error, row.evaluations? as f64))));
            plot.series(&format!("{problem}-{method}"), &values, marker, hue);
            if let (0, Some(&coarse), Some(&fine)) = (place, values.first(), values.last()) {
                let (end, side) = if method == "RK4" { (fine, Side::Above) } else { (coarse, Side::Below) };
                plot.label(end, side, &label, hue)?;
            }
        }
        let name = at(frame.right, frame.top + 2.0);
        plot.drawing().label(name, Side::Left, problem, Hue::Ink)?;
    }
    Ok(drawing)
}
