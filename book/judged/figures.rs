//! The figures of the chapter "Judged by others": the committed numbers of other people beside the library's.

use drawing::kit::Marker;
use drawing::{Drawing, Hue, Rect, Side, Stroke};
use figures::{Axis, Cause, Figure, Outcome, Plot, figures, linear_steps};
use mechanics::euler::{Turning, rates};
use mechanics::free_rotation::FreeTop;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::{Taylor, rk4};
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::Wheel;
use nalgebra::{Complex, UnitQuaternion, Vector3};
use std::f64::consts::FRAC_PI_2;

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] = figures![judged_brick, judged_toutatis, judged_coin];

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

/// How far a simulator's ω is from another one, degrees a second, at each half second after the start.
fn apart(
    simulator: f64,
    mut omega: impl FnMut(f64) -> Result<Vector3<f64>, Cause>,
) -> Result<Vec<(f64, f64)>, Cause> {
    let rows = rows(include_str!("brick.csv"), 0)?;
    let own = rows.iter().filter(|row| row[0] == simulator && row[1] > 0.0);
    own.map(|row| {
        let said = Vector3::new(row[2], row[3], row[4]);
        Ok((row[1], (omega(row[1])?.map(f64::to_degrees) - said).norm().max(LEAST)))
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

/// Five simulators beside the closed form, and beside what explains them.
pub(crate) fn judged_brick(id: &str) -> Outcome {
    let (moments, start) = brick()?;
    let top = FreeTop::new(moments, start)?;
    let (time, difference) = (Axis::linear(0.0, 30.0, 10.0).titled("time, s"), Axis::log(LEAST, 1.0, 3));
    let frame = Rect::new(56.0, 34.0, 290.0, 250.0);
    let mut raw = Drawing::new("", 390.0, 330.0);
    let mut plot = Plot::new(&mut raw, frame, time, difference.titled("from the closed form, °/s"))?;
    let looks = [
        (6.0, "six", Stroke::Curve, Hue::Orange, (30.4, 4e-3)),
        (2.0, "two", Stroke::Second, Hue::Pink, (30.4, 4e-4)),
        (5.0, "five", Stroke::Third, Hue::Purple, (30.4, 3e-5)),
        (4.0, "four", Stroke::Curve, Hue::Green, (30.4, 2e-9)),
        (1.0, "one", Stroke::Curve, Hue::Blue, (30.4, 8e-11)),
    ];
    for (simulator, name, stroke, hue, place) in looks {
        let values = apart(simulator, |time| Ok(top.at(time)?.omega_body))?;
        plot.curve(name, values, stroke, hue);
        plot.label(place, Side::Right, &format!("{simulator}"), hue)?;
    }
    let mut explained = Drawing::new("", 390.0, 330.0);
    let mut plot = Plot::new(&mut explained, frame, time, difference.titled("from what explains it, °/s"))?;
    let late = apart(6.0, |time| Ok(top.at(time + 5e-4)?.omega_body))?;
    let stepped = |simulator: f64, step: f64| -> Result<Vec<(f64, f64)>, Cause> {
        let by_steps = two_step(step)?;
        apart(simulator, |time| Ok(by_steps[(2.0 * time).round() as usize]))
    };
    for ((simulator, name, stroke, hue, _), (values, place)) in looks.into_iter().zip([
        (late, (30.4, 2e-7)),
        (stepped(2.0, 0.01)?, (30.4, 1.2e-8)),
        (stepped(5.0, 0.002)?, (30.4, 7e-14)),
        (runge_kutta(4.0)?, (30.4, 3e-10)),
        (runge_kutta(1.0)?, (30.4, 1e-11)),
    ]) {
        plot.curve(&format!("{name}-explained"), values, stroke, hue);
        plot.label(place, Side::Right, &format!("{simulator}"), hue)?;
    }
    Ok(Drawing::panels(id, vec![raw, explained]).titled(
        "Five flight simulators beside the closed form",
        "Two plots over 30 seconds, both with the same logarithmic scale of differences in angular velocity, from 1e-15 to 1 degree a second. In the first, from the closed form, simulators 1 and 4 lie \
         below 1e-9, 5 rises to 5e-5, 2 lies near 1e-3 and 6 near 5e-3. In the second, each from the rule that explains it, 6 has come down to 1e-7, 2 to 3e-8, 4 and 1 to 1e-10 and 5 to 1e-13.",
    ))
}

/// The asteroid of the solution of 2013, in days.
fn toutatis() -> Result<FreeTop, Cause> {
    let moments = PrincipalMoments::new(3.0836, 3.235, 1.0)?;
    let omega_body = Vector3::new(14.51, 33.529, -98.709).map(f64::to_radians);
    Ok(FreeTop::new(moments, Turning { world_from_body: UnitQuaternion::identity(), omega_body })?)
}

/// What the radar saw of an asteroid that tumbles, and the closed form.
pub(crate) fn judged_toutatis(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 330.0).titled(
        "The angular velocity of Toutatis, seen and computed",
        "Along x the day, from 22 to 40, along y the components of the angular velocity about the two short axes, from minus 80 to 60 degrees a day. Both computed curves swing to and fro between about minus and plus 38, \
         a quarter of a period apart, with a period of 5.4 days. Seventeen markers of each lie near their curves, most within six degrees a day; two of the first component lie 44 off, on days 28 and 35.",
    );
    let top = toutatis()?;
    let day = Axis::linear(22.0, 40.0, 4.0).titled("days since 9 November 1992");
    let rate = Axis::linear(-80.0, 60.0, 20.0).titled("degrees a day");
    let mut plot = Plot::new(&mut drawing, Rect::new(56.0, 34.0, 310.0, 250.0), day, rate)?;
    let looks = rows(include_str!("toutatis.csv"), 1)?;
    let parts = [
        (0, "first", r"$\omega_1$", Marker::Disc, Hue::Blue, Stroke::Curve, (31.24, 38.6)),
        (1, "second", r"$\omega_2$", Marker::Ring, Hue::Orange, Stroke::Second, (27.4, 36.4)),
    ];
    for (axis, name, text, marker, hue, stroke, place) in parts {
        let states =
            linear_steps(22.0, 40.0, 240).map(|day| Ok((day, top.at(day)?.omega_body[axis].to_degrees())));
        plot.curve(name, states.collect::<Result<Vec<_>, Cause>>()?, stroke, hue);
        let seen: Vec<_> =
            looks.iter().filter(|look| look[0] < 100.0).map(|look| (look[0], look[4 + axis])).collect();
        plot.markers(&seen, marker, hue);
        plot.label(place, Side::Above, text, hue)?;
    }
    Ok(drawing)
}

/// How EXUDYN comes near the library with ever smaller steps.
pub(crate) fn judged_coin(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 330.0).titled(
        "The contact of a rolling coin after half a second, by EXUDYN with several steps",
        "Both scales are logarithmic: along x the step from 1e-5 to 1e-2 seconds, along y the distance from the library, from 1e-9 to 1e-4 metres. Six markers lie on a dashed line of slope two, from 2e-9 m at 0.025 ms \
         to 3e-6 m at 1 ms. The value pinned in EXUDYN’s own test, a ring at 0.5 ms, lies on the same line.",
    );
    let (mass, radius, gravity) = (1.0, 0.01, 9.81);
    let coin = Wheel::new(DiskParameters { mass, radius, moments: MomentFactors::DISK, gravity })?;
    let (lean, spin) = (1_f64.to_radians(), 1800_f64.to_radians());
    let start = Rolling {
        tilt: FRAC_PI_2 - lean,
        omega_2: spin * lean.cos(),
        omega_3: -spin * lean.sin(),
        heading: FRAC_PI_2,
        centre: Complex::new(radius * lean.sin(), 0.0),
        ..Rolling::UPRIGHT
    };
    let contact = coin.wobble(start, &Taylor::new(1e-16)?)?.at(0.5)?.contact(radius);
    let step = Axis::log(1e-5, 1e-2, 1).titled("step, s");
    let apart = Axis::log(1e-9, 1e-4, 1).titled("from the library, m");
    let mut plot = Plot::new(&mut drawing, Rect::new(56.0, 34.0, 310.0, 250.0), step, apart)?;
    let found: Vec<_> = rows(include_str!("coin.csv"), 0)?
        .iter()
        .map(|row| (row[0], (Complex::new(row[1], row[2]) - contact).norm()))
        .collect();
    plot.reference((1e-5, 3.35e-10), (1e-2, 3.35e-4), Stroke::Reference);
    plot.series("exudyn", &found, Marker::Disc, Hue::Orange);
    // The test pins x alone.
    plot.markers(&[(5e-4, (0.002_004_099_927_340_136 - contact.re).abs())], Marker::Ring, Hue::Pink);
    plot.label((5.4e-4, 7e-7), Side::Right, "pinned in 2020", Hue::Pink)?;
    plot.label((6e-5, 3e-8), Side::AboveLeft, r"slope 2", Hue::Muted)?;
    Ok(drawing)
}
