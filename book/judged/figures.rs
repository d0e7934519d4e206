//! The figures of the chapter "Judged by others": the committed numbers of other people beside the library's.

use drawing::kit::Marker;
use drawing::{Drawing, Hue, Rect, Role, Side, Stroke};
use figures::{Axis, Cause, Figure, Outcome, Plot, Room, figures, in_both, linear_steps};
use mechanics::euler::{Turning, rates};
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::rk4;
use nalgebra::{UnitQuaternion, Vector3};

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] = figures![judged_brick, judged_toutatis];

/// The least difference that a plot shows, degrees a second.
const LEAST: f64 = 1e-15;

/// The rows of a committed file, without their first `skip` cells.
fn rows(text: &str, skip: usize) -> Result<Vec<Vec<f64>>, Cause> {
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    let row = |line: &str| line.split(',').skip(skip).map(str::parse).collect();
    Ok(lines.map(row).collect::<Result<_, std::num::ParseFloatError>>()?)
}

/// The brick of the check-case, in units that do not matter, and its start.
fn brick() -> Result<(PrincipalMoments, Turning), Cause> {
    let moments = PrincipalMoments::new(0.001_894_22, 0.006_211_019, 0.007_194_665)?;
    let omega_body = Vector3::new(10.0, 20.0, 30.0).map(f64::to_radians);
    Ok((moments, Turning { world_from_body: UnitQuaternion::identity(), omega_body }))
}

/// How far a simulator's ω is from another one in any component, degrees a second, at each half second after the start.
fn apart(
    simulator: f64,
    mut omega: impl FnMut(f64) -> Result<Vector3<f64>, Cause>,
) -> Result<Vec<(f64, f64)>, Cause> {
    let rows = rows(include_str!("brick.csv"), 0)?;
    let own = rows.iter().filter(|row| row[0] == simulator && row[1] > 0.0);
    own.map(|row| {
        let said = Vector3::new(row[2], row[3], row[4]);
        Ok((row[1], (omega(row[1])?.map(f64::to_degrees) - said).amax().max(LEAST)))
    })
    .collect()
}

/// ω at each half second by the formula of two steps.
fn two_step(step: f64) -> Result<Vec<Vector3<f64>>, Cause> {
    let (moments, start) = brick()?;
    let rate = |omega: &Vector3<f64>| rates(&moments, omega, &Vector3::zeros());
    let mut omega = start.omega_body;
    let mut before = rate(&omega);
    let mut found = vec![omega];
    for _ in 0..60 {
        for _ in 0..(0.5 / step).round() as usize {
            let now = rate(&omega);
            omega += step * (1.5 * now - 0.5 * before); // eq:judged-two-step
            before = now;
        }
        found.push(omega);
    }
    Ok(found)
}

/// How far a simulator is from RK4 with the step that it has, 10 ms.
fn runge_kutta(simulator: f64) -> Result<Vec<(f64, f64)>, Cause> {
    let (moments, start) = brick()?;
    let rate =
        |_: f64, &[a, b, c]: &[f64; 3]| rates(&moments, &Vector3::new(a, b, c), &Vector3::zeros()).into();
    let first: [f64; 3] = start.omega_body.into();
    apart(simulator, |time| Ok(rk4(rate, 0.0, first, time, (100.0 * time).round() as usize)?.into()))
}

/// Five simulators: how far each is off at most, and how far from the rule that explains it.
pub(crate) fn judged_brick(id: &str) -> Outcome {
    let (moments, start) = brick()?;
    let top = FreeTop::new(moments, start)?;
    let stepped = |simulator: f64, step: f64| -> Result<Vec<(f64, f64)>, Cause> {
        let by_steps = two_step(step)?;
        apart(simulator, |time| Ok(by_steps[(2.0 * time).round() as usize]))
    };
    let late = apart(6.0, |time| Ok(top.at(time + 5e-4)?.omega_body))?;
    let most = |values: &[(f64, f64)]| values.iter().fold(LEAST, |most, value| most.max(value.1));
    let mut lines = Vec::new();
    for (simulator, name, explained) in [
        (6.0, "six", late),
        (2.0, "two", stepped(2.0, 0.01)?),
        (5.0, "five", stepped(5.0, 0.002)?),
        (4.0, "four", runge_kutta(4.0)?),
        (1.0, "one", runge_kutta(1.0)?),
    ] {
        let raw = apart(simulator, |time| Ok(top.at(time)?.omega_body))?;
        lines.push((name, most(&raw), most(&explained)));
    }
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(560.0, 396.0), 410.0).titled(
            "Five flight simulators, how far off, and what is left of it",
            "A slope graph on one logarithmic scale, from 1e-14 to 0.01 degree a second. At the left, from the closed form, simulator 6 is off by 5e-3, 2 by 1e-3, 5 by 5e-5, and 1 and 4 by 3e-10. At the \
             right, each from the rule that explains it: 6, a clock that is half a millisecond ahead, 2e-7; 2, Adams and Bashforth with 10 ms, 3e-8; 4 and 1, RK4 with 10 ms, 5e-11 and 8e-11; \
             5, Adams and Bashforth with 2 ms, 7e-14.",
        );
        let ends = [
            (0.0, room.of("from the closed form", "closed form")),
            (1.0, room.of("from the rule found", "rule found")),
        ];
        let side = Axis::linear(room.of(-0.17, -0.3), 1.0, 1.0).marked(&ends);
        let difference = Axis::log(1e-14, 1e-2, 3).titled("off by at most, °/s");
        let frame = Rect::new(56.0, 34.0, room.of(290.0, 170.0), 330.0);
        let mut plot = Plot::new(&mut drawing, frame, side, difference)?;
        for end in [0.0, 1.0] {
            plot.upright(end, Stroke::Dotted);
        }
        for (name, raw, explained) in &lines {
            let (stroke, hue) =
                if *name == "five" { (Stroke::Heavy, Hue::Ink) } else { (Stroke::Curve, Hue::Ink) };
            plot.curve(name, [(0.0, *raw), (1.0, *explained)], stroke, hue);
            plot.markers(&[(0.0, *raw), (1.0, *explained)], Marker::Disc, hue);
        }
        for ((_, raw, explained), (number, words)) in lines.iter().zip([
            ("6", "6: ½ ms ahead"),
            ("2", room.of("2: Adams–Bashforth, 10 ms", "2: two-step, 10 ms")),
            ("5", room.of("5: Adams–Bashforth, 2 ms", "5: two-step, 2 ms")),
            ("1, 4", "1, 4: RK4, 10 ms"),
        ]) {
            plot.label((0.0, *raw), Side::Left, number, Hue::Ink)?;
            plot.label((1.0, *explained), Side::Right, words, Hue::Ink)?;
        }
        Ok(drawing)
    })
}

/// The asteroid of the solution of 2013, in days.
fn toutatis() -> Result<FreeTop, Cause> {
    let moments = PrincipalMoments::new(3.0836, 3.235, 1.0)?;
    let omega_body = Vector3::new(14.51, 33.529, -98.709).map(f64::to_radians);
    Ok(FreeTop::new(moments, Turning { world_from_body: UnitQuaternion::identity(), omega_body })?)
}

/// What the radar saw of an asteroid that tumbles, and the closed form.
pub(crate) fn judged_toutatis(id: &str) -> Outcome {
    let top = toutatis()?;
    let looks = rows(include_str!("toutatis.csv"), 1)?;
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(580.0, 396.0), 330.0).titled(
            "The angular velocity of Toutatis, seen and computed",
            "Along x the day, from 22 to 40, along y the components of the angular velocity about the two short axes, from minus 80 to 60 degrees a day. Both computed curves, a heavy one and a thin one, swing to and fro between about minus and plus 38, \
             a quarter of a period apart, with a period of 5.4 days. Seventeen markers of each lie near their curves, most within six degrees a day; two of the first component, ringed, lie 44 off, on days 28 and 35.",
        );
        let day = Axis::linear(22.0, 40.0, 4.0).minor(1.0).titled("days since 9 November 1992");
        let rate = Axis::linear(-80.0, 60.0, 20.0).titled("degrees a day");
        let frame = Rect::new(50.0, 34.0, room.of(510.0, 326.0), 250.0);
        let mut plot = Plot::new(&mut drawing, frame, day, rate)?;
        let parts = [
            (0, "first", r"$\omega_1$", Marker::Disc, Stroke::Heavy, (31.24, 39.6)),
            (1, "second", r"$\omega_2$", Marker::Ring, Stroke::Orbit, (27.4, 36.4)),
        ];
        for (axis, name, text, marker, stroke, place) in parts {
            let omega = |day: f64| Ok::<f64, Cause>(top.at(day)?.omega_body[axis].to_degrees());
            let curve = linear_steps(22.0, 40.0, 240).map(|day| Ok((day, omega(day)?)));
            plot.curve(name, curve.collect::<Result<Vec<_>, Cause>>()?, stroke, Hue::Orange);
            let seen = looks.iter().filter(|look| look[0] < 100.0).map(|look| (look[0], look[4 + axis]));
            let seen: Vec<_> = seen.collect();
            plot.markers(&seen, marker, Hue::Orange);
            plot.label(place, Side::Above, text, Hue::Orange)?;
            for (day, rate) in seen {
                if (omega(day)? - rate).abs() > 20.0 {
                    let place = plot.at((day, rate));
                    plot.reference((day, rate), (day, omega(day)?), Stroke::Dotted);
                    plot.drawing().circle(place, 8.5, Role::Line(Stroke::Outline, Hue::Ink));
                    let words = format!("day {day:.0}");
                    let (place, side, gap) = if rate > 0.0 {
                        (plot.at((day, omega(day)?)), Side::Below, 24.0)
                    } else {
                        (place, Side::Right, 12.0)
                    };
                    plot.drawing().label_set(place, side, gap, 14.0, &words, Role::Text(Hue::Ink))?;
                }
            }
        }
        Ok(drawing)
    })
}
