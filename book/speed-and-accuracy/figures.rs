//! The figures of the report "Speed and accuracy": the committed measurements, drawn.

#[allow(dead_code, reason = "shared with the runner and the tests, which also write, and make tables")]
#[path = "../../benches/speed/measured.rs"]
mod measured;

use drawing::kit::{self, Marker};
use drawing::{Drawing, Hue, Label, Rect, Role, Shape, Side, Stroke, at};
use figures::{Axis, Cause, Figure, Look, Outcome, Plot, figures};
use measured::{Measurement, NATIVE, cost_to_reach, front, methods, parse, seconds_front};

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] =
    figures![speed_washer, speed_hoop, speed_problems, speed_dots, speed_work];

/// The problems, in the order of the report, with their words.
const PROBLEMS: [(&str, &str); 9] = [
    ("washer", "two hundred turns of a washing machine"),
    ("ramp", "a washing machine that passes its resonance"),
    ("hoop", "a thousand periods of the pinned hoop"),
    ("separatrix", "the pinned hoop beside its separatrix"),
    ("disk", "two hundred precessions of a rolling disk"),
    ("rest", "a disk that rolls to rest"),
    ("toss", "a tossed coin"),
    ("station", "a struck space station"),
    ("drag", "a disc that spins down in air"),
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
fn name_series(plot: &mut Plot<'_>, values: &[(f64, f64)], name: &str, hue: Hue) -> Result<bool, Cause> {
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
    for gap in [6.0, 10.0, 16.0, 24.0] {
        for side in sides {
            for &place in &places {
                let label = Label::new(name, TYPE)?.placed(place, side, gap);
                let room = label.bounds.grown(2.0);
                let inside = room.left > frame.left && room.right < frame.right + 8.0;
                let inside = inside && room.top > frame.top - 8.0 && room.bottom < frame.bottom;
                let touched = plot.drawing().items().iter().any(|item| match &item.shape {
                    Shape::Label(other) => other.bounds.overlaps(&room),
                    shape => {
                        let points = shape.points();
                        points.iter().any(|&point| room.contains(point))
                            || !drawing::clip(&points, &room).is_empty()
                    }
                });
                if inside && !touched {
                    plot.drawing().push(Role::Text(hue), Shape::Label(label));
                    return Ok(true);
                }
            }
        }
    }
    Ok(false)
}

/// Draws error against time on one problem into a frame, under names that begin with `prefix`.
fn draw_problem(
    drawing: &mut Drawing,
    frame: Rect,
    problem: &str,
    prefix: &str,
    titles: bool,
) -> Result<(), Cause> {
    let mut error = Axis::log(1e-16, 1.0, 4);
    let mut cost = Axis::log(1e-3, 1e5, 2);
    if titles {
        (error, cost) = (error.titled("largest error"), cost.titled("time, ms"));
    }
    let mut plot = Plot::new(drawing, frame, error, cost)?;
    let series = series(problem)?;
    for ((contestant, method), values) in &series {
        let (marker, hue, _) = look(contestant, method)?;
        let name = format!("{prefix}{contestant} {method}").replace([' ', '(', ')'], "-");
        plot.series(&name, values, marker, hue);
    }
    if prefix.is_empty() {
        return name_all(&mut plot, &series);
    }
    let title = Label::new(problem, 14.0)?.placed(at(frame.right, frame.top - 14.0), Side::Left, 0.0);
    plot.drawing().push(Role::Text(Hue::Ink), Shape::Label(title));
    name_all(&mut plot, &series)
}

fn name_all(plot: &mut Plot<'_>, series: &[Series]) -> Result<(), Cause> {
    for ((contestant, method), values) in series {
        if let (_, hue, Some(name)) = look(contestant, method)? {
            name_series(plot, values, &name, hue)?; // the key has it too
        }
    }
    Ok(())
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

/// Error against time on one problem, with the key.
fn alone(id: &str, problem: &str) -> Outcome {
    let (_, words) =
        PROBLEMS.into_iter().find(|(name, _)| *name == problem).ok_or("a problem of the report")?;
    let description = describe(&series(problem)?);
    let mut drawing =
        Drawing::new(id, 390.0, 440.0).titled(&format!("Error against time for {words}"), &description);
    draw_problem(&mut drawing, Rect::new(50.0, 34.0, 320.0, 230.0), problem, "", true)?;
    draw_key(&mut drawing, at(58.0, 326.0))?;
    Ok(drawing)
}

pub(crate) fn speed_washer(id: &str) -> Outcome {
    alone(id, "washer")
}

pub(crate) fn speed_hoop(id: &str) -> Outcome {
    alone(id, "hoop")
}

/// Error against time on all nine problems, on the same axes.
pub(crate) fn speed_problems(id: &str) -> Outcome {
    let mut panels = Vec::new();
    for (place, (problem, words)) in PROBLEMS.into_iter().enumerate() {
        let description = describe(&series(problem)?);
        let title = format!("Error against time for {words}");
        let mut drawing = Drawing::new("", 300.0, 270.0).titled(&title, &description);
        let frame = Rect::new(44.0, 44.0, 240.0, 180.0);
        draw_problem(&mut drawing, frame, problem, &format!("{problem} "), place == 0)?;
        panels.push(drawing);
    }
    let mut key = Drawing::new("", 390.0, 140.0).titled(
        "The markers of all programs",
        "The markers: the library’s closed form a blue diamond, DOP853 a pink square, RK4 an orange disc, Taylor a purple triangle; the other programs, all grey: heyoka triangles, ivp discs, differential-equations squares, ode_solvers diamonds, diffsol rings, scipy crosses, mujoco plus signs.",
    );
    draw_key(&mut key, at(20.0, 20.0))?;
    panels.push(key);
    Ok(Drawing::panels(id, panels))
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
    let ratio = Axis::log(0.5, 1e6, 1).titled("time, in that of the library’s best method");
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

/// The figure in words: who is how fast at what error.
fn describe(series: &[Series]) -> String {
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
    let rows = measurements()?;
    let mut panels = Vec::new();
    for (place, (problem, _)) in PROBLEMS.into_iter().enumerate() {
        let mut drawing = Drawing::new("", 206.0, 220.0);
        let frame = Rect::new(42.0, 44.0, 136.0, 130.0);
        let mut error = Axis::log(1e-12, 1.0, 4);
        let mut evaluations = Axis::log(1e3, 1e8, 1);
        if place == 0 {
            (error, evaluations) = (error.titled("largest error"), evaluations.titled("evaluations"));
        }
        let mut plot = Plot::new(&mut drawing, frame, error, evaluations)?;
        let mut fronts = Vec::new();
        for method in ["RK4", "DOP853"] {
            let (marker, hue, _) = look("mechanics", method)?;
            let mine = |row: &&Measurement| {
                row.problem == problem && row.contestant == "mechanics" && row.method == method
            };
            let pairs = rows.iter().filter(mine);
            let values = front(pairs.filter_map(|row| Some((row.error, row.evaluations? as f64))));
            plot.series(&format!("{problem}-{method}"), &values, marker, hue);
            fronts.push((method, values, hue));
        }
        for (method, values, hue) in fronts.iter().filter(|_| place == 0) {
            if !name_series(&mut plot, values, method, *hue)? {
                return Err(format!("there is no room for {method}").into());
            }
        }
        let title = Label::new(problem, 14.0)?.placed(at(frame.right, frame.top - 14.0), Side::Left, 0.0);
        drawing.push(Role::Text(Hue::Ink), Shape::Label(title));
        panels.push(drawing);
    }
    Ok(Drawing::panels(id, panels).titled(
        "Error against evaluations of the rates",
        "Nine plots with logarithmic scales, the error along x and the number of evaluations along y, one for each problem. In each the \
         number grows with every digit, for the Runge-Kutta method of order four by a factor of 1.8 and for DOP853 by about 1.3, so \
         that their curves cross or draw apart towards small errors. Next to the separatrix neither comes below an error of a thousandth.",
    ))
}
