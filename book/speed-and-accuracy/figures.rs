//! The figures of the report "Speed and accuracy": the committed measurements, drawn.

#[allow(dead_code, reason = "shared with the runner and the tests, which also write, and make tables")]
#[path = "../../benches/speed/measured.rs"]
mod measured;

use drawing::kit::{self, Marker};
use drawing::{Drawing, Fill, Hue, Label, Rect, Role, Shape, Side, Stroke, at};
use figures::{Axis, Cause, Figure, Look, Outcome, Plot, Room, figures, in_both, log_steps};
use measured::{Measurement, NATIVE, cost_to_reach, methods, parse, seconds_front};

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] = figures![speed_problems, speed_dots];

/// The problems, in the order of the report, with their words.
const PROBLEMS: [(&str, &str); 10] = [
    ("washer", "two hundred turns of a washing machine"),
    ("ramp", "a washing machine that passes its resonance"),
    ("hoop", "a thousand periods of the pinned hoop"),
    ("separatrix", "the pinned hoop beside its separatrix"),
    ("disk", "two hundred precessions of a rolling disk"),
    ("rest", "a disk that rolls to rest"),
    ("toss", "a tossed coin"),
    ("station", "a struck space station"),
    ("drag", "a disc that spins down in air"),
    ("top", "a thousand nods of a top"),
];

/// The others, with their markers; all are grey.
const PEERS: [(&str, Marker); 7] = [
    ("heyoka", Marker::Triangle),
    ("ivp", Marker::Disc),
    ("differential-equations", Marker::Square),
    ("ode_solvers", Marker::Diamond),
    ("diffsol", Marker::Ring),
    ("scipy", Marker::Cross),
    ("mujoco", Marker::Plus),
];

/// The type size of names in plots, px.
const TYPE: f64 = 13.0;

/// A contestant's method, and its errors with what they cost.
type Series = ((String, String), Vec<(f64, f64)>);

/// The committed measurements.
fn measurements() -> Result<Vec<Measurement>, Cause> {
    Ok(parse(include_str!("measured.csv"))?)
}

/// How a method is drawn: its marker and hue, and the name that stands beside it if it is the library's.
fn look(contestant: &str, method: &str) -> Result<(Marker, Hue, Option<String>), Cause> {
    if contestant != "mechanics" {
        let peer = PEERS.iter().find(|(name, _)| *name == contestant);
        let (_, marker) = peer.ok_or_else(|| format!("{contestant} has no marker"))?;
        return Ok((*marker, Hue::Muted, None));
    }
    // Half a wobble is a motion that is followed once, and then known.
    let look = Look::of(if method == "half a wobble" { "closed form" } else { method });
    let look = look.ok_or_else(|| format!("{method} has no look"))?;
    Ok((look.marker, look.hue, Some(method.to_owned())))
}

/// All methods on a problem, the library's last, over the others.
fn series(problem: &str) -> Result<Vec<Series>, Cause> {
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
            series.push(((name.0.to_owned(), name.1.to_owned()), values));
        }
    }
    series.sort_by_key(|((contestant, _), _)| contestant == "mechanics");
    Ok(series)
}

/// Puts a name beside a series where it touches nothing, if there is such a place.
fn name_series(plot: &mut Plot<'_>, values: &[(f64, f64)], name: &str, hue: Hue) -> Result<(), Cause> {
    let frame = plot.frame();
    let places: Vec<_> = values.iter().map(|&value| plot.at(value)).collect();
    let sides = [
        Side::Below,
        Side::BelowLeft,
        Side::Left,
        Side::Right,
        Side::BelowRight,
        Side::Above,
        Side::AboveLeft,
        Side::AboveRight,
    ];
    for gap in [4.0, 7.0, 12.0] {
        for side in sides {
            for &place in &places {
                let label = Label::new(name, TYPE)?.placed(place, side, gap);
                let room = label.bounds.grown(1.5);
                let inside = room.left > frame.left && room.right < frame.right + 2.0;
                let inside = inside && room.top > frame.top && room.bottom < frame.bottom;
                let is_line = |role: Role| !matches!(role, Role::Area(Fill::Face, _));
                let touched = plot.drawing().items().iter().filter(|item| is_line(item.role)).any(|item| {
                    match &item.shape {
                        Shape::Label(other) => other.bounds.overlaps(&room),
                        shape => {
                            let points = shape.points();
                            points.iter().any(|&point| room.contains(point))
                                || !drawing::clip(&points, &room).is_empty()
                        }
                    }
                });
                if inside && !touched {
                    plot.drawing().push(Role::Text(hue), Shape::Label(label));
                    return Ok(());
                }
            }
        }
    }
    Err(format!("there is no room for {name}").into())
}

/// Whether a program stands far above the others.
fn is_slow(contestant: &str) -> bool {
    ["scipy", "mujoco"].contains(&contestant)
}

/// The time of a series at an error, between two settings in proportion on logarithmic scales.
fn time_at(values: &[(f64, f64)], error: f64) -> Option<f64> {
    let pair = values.windows(2).find(|pair| {
        let (low, high) = (pair[0].0.min(pair[1].0), pair[0].0.max(pair[1].0));
        low <= error && error <= high
    })?;
    let part = (error / pair[0].0).ln() / (pair[1].0 / pair[0].0).ln();
    Some(pair[0].1 * (pair[1].1 / pair[0].1).powf(part))
}

/// The region between the fastest and the slowest of the others, those that stand far above left out.
fn draw_band(plot: &mut Plot<'_>, series: &[Series]) {
    let others: Vec<_> = series
        .iter()
        .filter(|((contestant, _), _)| contestant != "mechanics" && !is_slow(contestant))
        .map(|(_, values)| values)
        .collect();
    let errors = || others.iter().flat_map(|values| values.iter().map(|value| value.0));
    let (least, most) = (errors().fold(1.0, f64::min), errors().fold(0.0, f64::max));
    let (mut below, mut above) = (Vec::new(), Vec::new());
    for error in log_steps(least, most, 120) {
        let times: Vec<f64> = others.iter().filter_map(|values| time_at(values, error)).collect();
        if !times.is_empty() {
            below.push(plot.at((error, times.iter().copied().fold(f64::INFINITY, f64::min))));
            above.push(plot.at((error, times.iter().copied().fold(0.0, f64::max))));
        }
    }
    below.extend(above.into_iter().rev());
    plot.drawing().polygon(below, Fill::Face, Hue::Muted);
}

/// Names in the plots: a problem, a contestant, a method, and the words beside its curve.
const NAMES: [(&str, &str, &str, &str); 9] = [
    ("washer", "mechanics", "closed form", "closed form"),
    ("washer", "mechanics", "DOP853", "DOP853"),
    ("washer", "scipy", "DOP853", "SciPy"),
    ("washer", "diffsol", "Tsitouras 5(4)", "diffsol"),
    ("hoop", "mechanics", "RK4", "RK4"),
    ("hoop", "mujoco", "engine with RK4", "MuJoCo"),
    ("disk", "mechanics", "half a wobble", "half a wobble"),
    ("rest", "mechanics", "Taylor", "Taylor"),
    ("station", "heyoka", "Taylor", "heyoka"),
];

/// Draws error against time on one problem: the others as a band of grey with a line for each, the library over it.
fn draw_problem(plot: &mut Plot<'_>, problem: &str, series: &[Series], named: bool) -> Result<(), Cause> {
    draw_band(plot, series);
    for ((contestant, method), values) in series {
        let (marker, mut hue, _) = look(contestant, method)?;
        let mut stroke = Stroke::Orbit;
        if contestant == "mechanics" {
            stroke = Look::of(method).map_or(Stroke::Heavy, |look| look.stroke);
        } else if !is_slow(contestant) {
            hue = Hue::Faint;
        }
        let name = format!("{problem} {contestant} {method}").replace([' ', '(', ')'], "-");
        if values.len() > 1 {
            plot.curve(&name, values.iter().copied(), stroke, hue);
        } else {
            plot.markers(values, marker, hue);
        }
    }
    if problem == "ramp" {
        // A digit costs 10^{1/p}, whatever one counts.
        for (order, words) in [(4.0, "order 4"), (8.0, "order 8")] {
            let (from, to) = ((1e-13, 0.3), (1e-7, 0.3 * 1e-6_f64.powf(1.0 / order)));
            plot.reference(from, to, Stroke::Reference);
            if named {
                let label = Label::new(words, TYPE)?.placed(plot.at(to), Side::Right, 4.0);
                plot.drawing().push(Role::Text(Hue::Muted), Shape::Label(label));
            }
        }
    }
    for (_, contestant, method, words) in NAMES.into_iter().filter(|name| named && name.0 == problem) {
        let found = series.iter().find(|((one, other), _)| one == contestant && other == method);
        let (_, values) = found.ok_or("a name without a curve")?;
        let (_, hue, _) = look(contestant, method)?;
        name_series(plot, values, words, hue)?;
    }
    Ok(())
}

/// The ticks of an axis of errors, without the last, which would stand where the next plot begins.
const MARKS: [(f64, &str); 2] = [(1e-16, "10^{−16}"), (1e-8, "10^{−8}")];

/// Error against time on all ten problems, in two rows of five, on a phone in five rows of two, on the same axes.
pub(crate) fn speed_problems(id: &str) -> Outcome {
    let all = PROBLEMS.iter().map(|(problem, words)| Ok((*problem, *words, series(problem)?)));
    let all = all.collect::<Result<Vec<_>, Cause>>()?;
    let mut text = String::from(
        "Ten plots on the same logarithmic scales, the largest error along x from 1e-16 to 1 and milliseconds along y from 1e-3 to 1e5. In each the \
         curves of the library's RK4 and DOP853 run through a grey band, that of the other programs, and sink towards large errors, RK4's more steeply. The formula is a single point far \
         below at the left. SciPy, and on the hoop MuJoCo, lie far above the band.",
    );
    for (_, words, series) in &all {
        text += &format!(" {words}:{}", describe(series));
    }
    in_both(|room: Room| {
        let columns = room.of(5_u8, 2);
        let last = at(f64::from(columns - 1), (all.len() as f64 / f64::from(columns)).ceil() - 1.0);
        let (size, step) =
            (room.of(at(110.0, 128.0), at(152.0, 84.0)), room.of(at(122.0, 162.0), at(168.0, 110.0)));
        let corner = room.of(at(50.0, 48.0), at(11.0, 46.0));
        let whole =
            corner + at(last.x * step.x, last.y * step.y) + size + room.of(at(8.0, 60.0), at(9.0, 34.0));
        let mut drawing =
            Drawing::new(id, whole.x, whole.y).titled("Error against time on ten problems", &text);
        for (place, (problem, _, series)) in (0_u8..).zip(&all) {
            let (column, row) = (f64::from(place % columns), f64::from(place / columns));
            let left = corner + at(column * step.x, row * step.y);
            let frame = Rect::new(left.x, left.y, size.x, size.y);
            let (mut error, mut time) = (Axis::log(1e-16, 1.0, 8), Axis::log(1e-3, 1e5, 2));
            if row < last.y || room == Room::Narrow {
                error = error.marked(&[]).minor(100.0);
            } else if column < last.x {
                error = error.marked(&MARKS);
            }
            if column > 0.0 || room == Room::Narrow {
                time = time.marked(&[]).minor(100.0);
            }
            if room == Room::Wide && place == 0 {
                time = time.titled("time, ms");
            }
            if room == Room::Wide && at(column, row) == last {
                error = error.titled("largest error");
            }
            let mut plot = Plot::new(&mut drawing, frame, error, time)?;
            draw_problem(&mut plot, problem, series, room == Room::Wide || *problem == "hoop")?;
            let title = Label::new(problem, room.of(14.0, TYPE))?;
            let title = title.placed(at(frame.right, frame.top - 9.0), Side::Left, 0.0);
            drawing.push(Role::Text(Hue::Ink), Shape::Label(title));
        }
        if room == Room::Narrow {
            for (words, point) in [
                ("time upwards, $10^{-3}$ to $10^5$ ms", at(11.0, 14.0)),
                ("largest error to the right, $10^{-16}$ to 1", at(11.0, whole.y - 14.0)),
            ] {
                let label = Label::new(words, TYPE)?.placed(point, Side::Right, 0.0);
                drawing.push(Role::Text(Hue::Muted), Shape::Label(label));
            }
        }
        Ok(drawing)
    })
}

/// Draws the markers of all methods with their names, in two columns, the library's above.
fn draw_key(drawing: &mut Drawing, corner: drawing::Point) -> Result<(), Cause> {
    let ours =
        [Look::EXACT, Look::DOP853, Look::RK4, Look::TAYLOR].map(|look| (look.name, look.marker, look.hue));
    let others = PEERS.map(|(name, marker)| (name, marker, Hue::Muted));
    for (place, (name, marker, hue)) in ours.into_iter().chain(others).enumerate() {
        let (column, row) = ((place % 2) as f64, (place / 2) as f64);
        let point = corner + at(180.0 * column, 20.0 * row);
        kit::marker(drawing, point, marker, hue);
        let label = Label::new(name, TYPE)?.placed(point, Side::Right, 10.0);
        drawing.push(Role::Text(hue), Shape::Label(label));
    }
    Ok(())
}

/// How many times as long as the library's best method everybody takes to reach an error of a millionth.
pub(crate) fn speed_dots(id: &str) -> Outcome {
    const RISE: f64 = 0.15;
    let goal = 1e-6;
    let rows = measurements()?;
    let mut drawing = Drawing::new(id, 390.0, 520.0);
    let count = PROBLEMS.len();
    let marks: Vec<_> =
        PROBLEMS.iter().enumerate().map(|(place, (problem, _))| ((count - place) as f64, *problem)).collect();
    let ratio = Axis::log(0.5, 1e6, 1).titled("time over that of the library’s best method");
    let problems = Axis::linear(0.4, count as f64 + 0.6, 1.0).marked(&marks);
    let frame = Rect::new(88.0, 16.0, 286.0, 316.0);
    let mut plot = Plot::new(&mut drawing, frame, ratio, problems)?;
    plot.upright(1.0, Stroke::Dotted);
    let mut text = String::new();
    for &(row, problem) in &marks {
        let all = methods(&rows, problem).into_iter().filter(|(contestant, _)| *contestant != NATIVE);
        let mut found: Vec<_> = all
            .filter_map(|name| Some((cost_to_reach(&seconds_front(&rows, problem, name), goal)?, name)))
            .collect();
        let is_ours = |contestant: &str| contestant == "mechanics";
        let ours = found.iter().filter(|(_, (contestant, _))| is_ours(contestant));
        let best = ours.map(|(seconds, _)| *seconds).min_by(f64::total_cmp).ok_or("the library arrives")?;
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        // The library above, the others below, each along a line.
        for (whose, ours, rise) in [("library", true, RISE), ("others", false, -RISE)] {
            let mine = found.iter().filter(|(_, (contestant, _))| is_ours(contestant) == ours);
            let values: Vec<_> = mine.map(|(seconds, _)| (seconds / best, row + rise)).collect();
            if values.is_empty() {
                plot.label((1.0, row), Side::Right, "nobody else arrives", Hue::Muted)?;
            }
            plot.curve(&format!("{problem}-{whose}"), values, Stroke::Orbit, Hue::Muted);
        }
        text += &format!(" {problem}:");
        for (seconds, (contestant, method)) in found {
            let (marker, hue, _) = look(contestant, method)?;
            let rise = if is_ours(contestant) { RISE } else { -RISE };
            plot.markers(&[(seconds / best, row + rise)], marker, hue);
            text += &format!(" {contestant}, {method} {:.3};", seconds / best);
        }
    }
    draw_key(&mut drawing, at(58.0, 396.0))?;
    Ok(drawing.titled(
        "Who needs how long for six digits",
        &format!("A row for each problem, a logarithmic scale of times from that of the library's best method upwards.{text}"),
    ))
}

/// A plot in words: who is how fast at what error.
fn describe(series: &[Series]) -> String {
    let mut text = String::new();
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
