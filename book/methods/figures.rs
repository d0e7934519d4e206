//! The figures of the chapter "Methods".

use drawing::kit::{self, Marker};
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Hue, Rect, Side, Stroke, at};
use figures::{Axis, Cause, Figure, Look, Outcome, Plot, Room, figures, in_both, linear_steps, log_steps};
use mechanics::InvalidQuantity;
use mechanics::attitude::rotation_between;
use mechanics::euler::{self, Turning};
use mechanics::free_rotation::FreeTop;
use mechanics::geometric::{Splitting, commutator_free};
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::{Dop853, rk4};
use mechanics::scenes::pinned_hoop::{Pin, Pinning, PinningParameters, Shape};
use nalgebra::{UnitQuaternion, Vector2, Vector3};
use std::f64::consts::{PI, SQRT_2, TAU};
use std::ops::ControlFlow;

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] = figures![
    method_polhodes,
    method_circle,
    method_amplitude,
    method_order,
    method_steps,
    method_zigzag,
    method_long_run,
    free_body::two_turns,
    free_body::tip_path
];

#[path = "figures/free_body.rs"]
pub(crate) mod free_body;

/// A tolerance that every step meets, so that the length limit alone sets the steps of DOP853.
const LOOSE: f64 = 1e12;

/// The book of the chapter, and its motion.
fn book() -> Result<(PrincipalMoments, Turning), InvalidQuantity> {
    let omega_body = Vector3::new(0.7, 0.9, 0.5);
    let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body };
    Ok((PrincipalMoments::new(1.0, 1.6, 2.1)?, start))
}

/// Where a label stands beside a curve, and what it says: an error, a side, the words.
type Name = (f64, Side, &'static str);
/// Two places of a label, one in each of two plots.
type Places = [(f64, f64); 2];

/// A method with a fixed step for the free book.
#[derive(Clone, Copy, PartialEq)]
enum Fixed {
    Rk4,
    Dop853,
    CommutatorFree,
    Split(Splitting),
}

impl Fixed {
    /// Each with its name in the figure, its look, and its label.
    const ALL: [(Self, &'static str, Look, Name); 5] = [
        (Self::Rk4, "rk4", Look::RK4, (1e-5, Side::AboveLeft, "RK4")),
        (Self::Dop853, "dop853", Look::DOP853, (1e-12, Side::Left, "DOP853")),
        (Self::CommutatorFree, "cf4", Look::CF4, (1e-9, Side::Right, "CF4")),
        (Self::Split(Splitting::Strang), "strang", Look::STRANG, (1e-2, Side::AboveLeft, "Strang")),
        (Self::Split(Splitting::BlanesMoan), "blanes-moan", Look::BLANES_MOAN, (1e-10, Side::Right, "BM")),
    ];

    /// Evaluations, or turns, of one step.
    fn work(self) -> usize {
        match self {
            Self::Rk4 | Self::CommutatorFree => 4,
            Self::Dop853 => 12,
            Self::Split(splitting) => splitting.turns_per_step(),
        }
    }

    /// The seven numbers after so many equal steps.
    fn run(
        self,
        moments: &PrincipalMoments,
        start: [f64; 7],
        duration: f64,
        steps: usize,
    ) -> Result<[f64; 7], Cause> {
        let free = || euler::turning_rates(*moments, |_, _| Vector3::zeros());
        let turning = Turning::from_array(start);
        Ok(match self {
            Self::Rk4 => rk4(free(), 0.0, start, duration, steps)?,
            Self::Dop853 => {
                let h = duration / steps as f64;
                let solver = Dop853::new(LOOSE)?.with_first_step(h)?.with_max_step(h)?;
                solver.solve(free(), 0.0, start, duration)?.state
            }
            Self::CommutatorFree => {
                let free = |_: f64, _: &Turning| Vector3::zeros();
                commutator_free(moments, free, 0.0, turning, duration, steps)?.to_array()
            }
            Self::Split(splitting) => splitting.solve(moments, turning, duration, steps)?.to_array(),
        })
    }
}

/// The direction of the angular momentum, seen from the book, by Euler's method and by a splitting.
pub(crate) fn method_polhodes(id: &str) -> Outcome {
    let (moments, _) = book()?;
    let start = Vector3::new(1.0, 0.12, 0.0);
    let direction = |omega: &Vector3<f64>| moments.angular_momentum(omega).normalize();
    let h = 0.1;
    let mut omega = start;
    let mut outwards = vec![direction(&omega)];
    for _ in 1..=2000 {
        omega += euler::rates(&moments, &omega, &Vector3::zeros()) * h;
        outwards.push(direction(&omega));
    }
    let mut body = Turning { world_from_body: UnitQuaternion::identity(), omega_body: start };
    let mut round = vec![direction(&start)];
    for _ in 1..=500 {
        body = Splitting::Strang.solve(&moments, body, 0.4, 1)?;
        round.push(direction(&body.omega_body));
    }
    let mut spheres = Vec::new();
    for (path, look, name) in [
        (outwards, Look::EULER, "Euler’s method, 2000 steps"),
        (round, Look::STRANG, "Strang’s splitting, 500 steps"),
    ] {
        let mut drawing = Drawing::new("", 330.0, 330.0);
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0; 3],
            azimuth: 0.62,
            elevation: 0.3,
            distance: 9.0,
            centre: at(165.0, 158.0),
            scale: 104.0,
        })?);
        stage.solid(Solid::sphere([0.0; 3], 1.0)?, Hue::Blue)?;
        // L² = 2T I₂ on the sphere: L₁² (1/I₁ − 1/I₂) = L₃² (1/I₂ − 1/I₃), two great circles through axis 2.
        let [i1, i2, i3] = moments.to_array();
        let tilt = ((1.0 / i1 - 1.0 / i2) / (1.0 / i2 - 1.0 / i3)).sqrt().atan();
        for sign in [1.0, -1.0] {
            let side = Vector3::new(tilt.cos(), 0.0, sign * tilt.sin());
            let circle: Vec<Vector3<f64>> = linear_steps(0.0, 2.0 * PI, 240)
                .map(|angle| Vector3::y() * angle.cos() + side * angle.sin())
                .collect();
            stage.curve(Curve::smooth(circle)?, Stroke::Border, Hue::Ink)?;
        }
        stage.curve(Curve::smooth(path)?.hiding(Hiding::Pale), Stroke::Outline, look.hue)?;
        for (axis, tip, name) in [
            (Vector3::x(), 2.1, r"$\hat{\mathbf{1}}$"),
            (Vector3::y(), 1.32, r"$\hat{\mathbf{2}}$"),
            (Vector3::z(), 1.32, r"$\hat{\mathbf{3}}$"),
        ] {
            stage.named_vector(axis, axis * tip, name, Hue::Ink)?;
        }
        stage.write(&mut drawing);
        drawing.label(at(165.0, 312.0), Side::Over, name, look.hue)?;
        spheres.push(drawing);
    }
    Ok(Drawing::panels(id, spheres).titled(
        "The direction of the angular momentum in the book, by Euler’s method and by turns",
        "Two spheres with the axes 1, 2 and 3 of the book. On the first a curve begins near axis 1 and spirals outwards towards the separatrix of dashes and dots, which passes through axis 2 and which it does not reach. \
         On the second one closed curve about axis 1 that passes through the same starting point.",
    ))
}

/// Steps by Euler's method and by the midpoint rule on a circle: one of each, and a turn of each.
pub(crate) fn method_circle(id: &str) -> Outcome {
    let rates = |y: Vector2<f64>| Vector2::new(-y.y, y.x);
    let middle = |y: Vector2<f64>, h: f64| y + 0.5 * h * rates(y);
    let by_euler = |y: Vector2<f64>, h: f64| y + h * rates(y);
    let by_midpoint = |y: Vector2<f64>, h: f64| y + h * rates(middle(y, h)); // eq:midpoint
    let pair = |y: Vector2<f64>| (y.x, y.y);
    let circle = |from, to| linear_steps(from, to, 400).map(|angle: f64| (angle.cos(), angle.sin()));

    let mut one = Drawing::new("", 330.0, 370.0).titled(
        "One step of 0.8 radian on a circle",
        "From a point of the circle Euler's step goes along the tangent and ends outside. Half-way along it an arrow shows the rate there, turned to the left; \
         the midpoint rule's step goes in that direction from the starting point and ends beside the circle, a little outside.",
    );
    let (h, start) = (0.8, Vector2::x());
    let (centre, [euler, mid, halfway]) =
        (at(-42.0, 294.0), [by_euler(start, h), by_midpoint(start, h), middle(start, h)]);
    let mut plot = Plot::plane(&mut one, centre, 250.0, 1.3)?;
    plot.curve("arc", circle(-0.12, 0.9), Look::EXACT.stroke, Look::EXACT.hue);
    for (end, look) in [(euler, Look::EULER), (mid, Look::MIDPOINT)] {
        plot.curve(&format!("{}-step", look.name), [pair(start), pair(end)], look.stroke, look.hue);
        plot.markers(&[pair(end)], look.marker, look.hue);
    }
    let rate = [plot.at(pair(halfway)), plot.at(pair(halfway + 0.3 * rates(halfway)))];
    kit::arrow(plot.drawing(), rate[0], rate[1], Hue::Muted);
    let ends = [plot.at(pair(start)), rate[0]];
    for end in ends {
        plot.drawing().dot(end, 3.5, Hue::Ink);
    }
    plot.label(pair(start), Side::Right, "$y_0$", Hue::Ink)?;
    plot.label(pair(halfway), Side::Right, "the middle", Hue::Ink)?;
    plot.label(pair(euler), Side::Right, "Euler", Look::EULER.hue)?;
    plot.label(pair(mid), Side::Above, "midpoint", Look::MIDPOINT.hue)?;
    one.label(at(150.0, 350.0), Side::Over, "(a) one step of 0.8 rad", Hue::Ink)?;

    let mut turn = Drawing::new("", 330.0, 370.0).titled(
        "Sixteen steps on the same circle",
        "Euler's steps spiral outwards and after one turn are three radii away. The midpoint rule's stay beside the circle.",
    );
    let h = TAU / 16.0;
    let mut paths = [vec![Vector2::x()], vec![Vector2::x()]];
    for n in 0..16 {
        let next = [by_euler(paths[0][n], h), by_midpoint(paths[1][n], h)];
        paths.iter_mut().zip(next).for_each(|(path, y)| path.push(y));
    }
    let mut plot = Plot::plane(&mut turn, at(160.0, 180.0), 54.0, 3.4)?;
    plot.curve("circle", circle(0.0, TAU), Look::EXACT.stroke, Look::EXACT.hue);
    for (path, name, look) in [(&paths[0], "euler", Look::EULER), (&paths[1], "midpoint", Look::MIDPOINT)] {
        let path: Vec<_> = path.iter().map(|&y| pair(y)).collect();
        plot.series(name, &path, look.marker, look.hue);
    }
    plot.label(pair(paths[0][9]), Side::BelowLeft, "Euler", Look::EULER.hue)?;
    plot.label((0.0, 0.0), Side::Over, "midpoint", Look::MIDPOINT.hue)?;
    turn.label(at(150.0, 350.0), Side::Over, "(b) sixteen steps, for one turn", Hue::Ink)?;
    Ok(Drawing::panels(id, vec![one, turn]))
}

/// By which factor one step changes the amplitude of an oscillator.
pub(crate) fn method_amplitude(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 334.0, 290.0).titled(
        "Factor by which one step changes the amplitude of an oscillator",
        "The factor from 0.4 to 1.6 against omega h from 0 to 7. Euler's method rises from one at once. RK4 stays near one up to 0.8, falls to one half at 2.45, and rises through one at \
         2.83. DOP853 stays near one up to 4, falls to 0.7 at 5.5 and rises through one just before 6.",
    );
    let swing = |_: f64, &[x, v]: &[f64; 2]| [v, -x];
    let product = Axis::linear(0.0, 7.0, 1.0).minor(0.2).titled(r"$z = \omega h$");
    let factor = Axis::linear(0.4, 1.6, 0.2).minor(0.05).titled("factor of the amplitude in one step");
    let mut plot = Plot::new(&mut drawing, Rect::new(44.0, 34.0, 276.0, 206.0), product, factor)?;
    plot.level(1.0, Stroke::Reference);
    plot.upright(2.0 * SQRT_2, Stroke::Dotted);
    let euler = linear_steps(0.0, 2.0, 200).map(|z| {
        let [x, v] = swing(0.0, &[1.0, 0.0]);
        (z, (1.0 + z * x).hypot(z * v))
    });
    plot.curve("euler", euler, Look::EULER.stroke, Look::EULER.hue);
    let by_rk4 = linear_steps(0.001, 3.6, 720)
        .map(|z| {
            let [x, v] = rk4(swing, 0.0, [1.0, 0.0], z, 1)?;
            Ok((z, x.hypot(v)))
        })
        .collect::<Result<Vec<_>, Cause>>()?;
    plot.curve("rk4", by_rk4, Look::RK4.stroke, Look::RK4.hue);
    let by_dop853 = linear_steps(0.001, 7.0, 1400)
        .map(|z| {
            let solver = Dop853::new(LOOSE)?.with_first_step(z)?.with_max_step(z)?;
            let [x, v] = solver.solve(swing, 0.0, [1.0, 0.0], z)?.state;
            Ok((z, x.hypot(v)))
        })
        .collect::<Result<Vec<_>, Cause>>()?;
    plot.curve("dop853", by_dop853, Look::DOP853.stroke, Look::DOP853.hue);
    plot.label((1.06, 1.3), Side::Right, "Euler", Look::EULER.hue)?;
    plot.label((1.82, 0.72), Side::Left, "RK4", Look::RK4.hue)?;
    plot.label((4.5, 0.85), Side::BelowLeft, "DOP853", Look::DOP853.hue)?;
    plot.label((2.0 * SQRT_2, 1.53), Side::Left, r"$2\sqrt{2}$", Hue::Muted)?;
    Ok(drawing)
}

/// Error after a fixed time against the step.
pub(crate) fn method_order(id: &str) -> Outcome {
    let (moments, start) = book()?;
    let duration = 30.0;
    let exact = FreeTop::new(moments, start)?.at(duration)?;
    let mut runs = Vec::new();
    for (method, name, look, label) in Fixed::ALL {
        let mut values = Vec::new();
        for steps in log_steps(10.0, 30_000.0, 24) {
            let steps = steps.round();
            let end = method.run(&moments, start.to_array(), duration, steps as usize)?;
            let error = rotation_between(&Turning::from_array(end).world_from_body, &exact.world_from_body);
            values.push((duration / steps, error.max(1e-16)));
        }
        runs.push((values, name, look, label));
    }
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(580.0, 396.0), 380.0).titled(
            "Error against step for five methods",
            "Both scales are logarithmic: the step from 1e-3 to 10 seconds, and the error after 30 seconds from 1e-15 to 1. Strang's points lie on a line of slope two, RK4's, CF4's and Blanes and Moan's \
             on parallel lines of slope four, the last hundreds of times below the others, and DOP853's on a steep line of slope eight; a dashed line of each slope stands beside them. Below 1e-12 all end in a scattered plateau, which rises to the left.",
        );
        let step = Axis::log(1e-3, 10.0, 1).titled(r"step $h$, s");
        let error = Axis::log(1e-15, 10.0, 3).titled("error of the attitude after 30 s, rad");
        let frame = Rect::new(52.0, 34.0, room.of(510.0, 326.0), 300.0);
        let mut plot = Plot::new(&mut drawing, frame, step, error)?;
        for (values, name, look, (level, side, words)) in &runs {
            plot.series(name, values, look.marker, look.hue);
            // Beside the curve where it comes down to a level.
            let Some(pair) = values.windows(2).find(|pair| pair[1].1 <= *level) else { continue };
            let part = (pair[0].1 / level).ln() / (pair[0].1 / pair[1].1).ln();
            let clear = if *side == Side::Right { 1.15 } else { 1.0 }; // of the curve, which goes up to the right
            let place = (clear * pair[0].0 * (pair[1].0 / pair[0].0).powf(part), *level);
            plot.label(place, *side, words, look.hue)?;
        }
        for (order, words, (h, from), to) in [
            (2, "slope 2", (1.5e-3, 2e-6), 9e-3),
            (4, "slope 4", (7e-3, 3e-8), 2.5e-2),
            (8, "slope 8", (1.2, 3e-10), 4.0),
        ] {
            let end = (to, from * f64::powi(to / h, order));
            plot.reference((h, from), end, Stroke::Reference);
            let (place, side) = match order {
                2 => (end, Side::AboveLeft),
                4 => ((h, from), Side::Left),
                _ => ((h, from), Side::BelowRight),
            };
            plot.label(place, side, words, Hue::Muted)?;
        }
        Ok(drawing)
    })
}

/// The steps of DOP853 along the motion of a hoop that waits and flips.
pub(crate) fn method_steps(id: &str) -> Outcome {
    let pin = Pin::Angle(89.9_f64.to_radians());
    let hoop =
        Pinning::new(PinningParameters { shape: Shape::Hoop, mass: 1.0, radius: 1.0, spin: 1.0, pin })?;
    let top = hoop.free_motion()?;
    let span = 150.0;
    let tangent = linear_steps(0.0, span, 1500)
        .map(|time| Ok((time, top.at(time)?.omega_body.x)))
        .collect::<Result<Vec<_>, Cause>>()?;
    let mut lengths = Vec::new();
    let moments = hoop.moments_about_pin();
    let rates = |_: f64, &[a, b, c]: &[f64; 3]| {
        euler::rates(&moments, &Vector3::new(a, b, c), &Vector3::zeros()).into()
    };
    Dop853::new(1e-9)?.solve_with(rates, 0.0, hoop.omega_after().into(), span, |step| {
        lengths.push((0.5 * (step.start() + step.end()), step.end() - step.start()));
        ControlFlow::Continue(())
    })?;
    lengths.pop(); // cut short by the end
    in_both(|room: Room| {
        let mut drawing = Drawing::new(id, room.of(580.0, 396.0), 340.0).titled(
            "The steps that DOP853 chooses for the hoop pinned at 89.9 degrees",
            "Two plots against the time from 0 to 150. Above, the component of omega along the tangent: a third, then minus a third from 28 to 84, then a third again. Below, the length of the steps on a logarithmic \
             scale from 0.1 to 10: about 1 during each flip, and up to four times as long while the hoop waits.",
        );
        let width = room.of(510.0, 326.0);
        let time = Axis::linear(0.0, span, 30.0).minor(10.0);
        let omega = Axis::linear(-0.4, 0.4, 0.4).minor(0.1).titled(r"$\omega_1$, in $\omega_0$");
        let frame = Rect::new(50.0, 34.0, width, 90.0);
        let mut plot = Plot::new(&mut drawing, frame, time.unlabelled(), omega)?;
        plot.level(0.0, Stroke::Reference);
        plot.curve("tangent", tangent.iter().copied(), Stroke::Curve, Hue::Orange);
        let length = Axis::log(0.1, 10.0, 1).titled(r"step, in $1/\omega_0$");
        let time = time.titled(r"time, in $1/\omega_0$");
        let mut plot = Plot::new(&mut drawing, Rect::new(50.0, 164.0, width, 130.0), time, length)?;
        plot.series("steps", &lengths, Look::DOP853.marker, Look::DOP853.hue);
        plot.label((40.0, 0.24), Side::Right, "a marker for each step", Look::DOP853.hue)?;
        Ok(drawing)
    })
}

/// One round of the angular momentum by Strang's splitting with long steps, turn after turn: on the sphere, and along
/// axis 1.
pub(crate) fn method_zigzag(id: &str) -> Outcome {
    let (moments, body) = book()?;
    let start = Turning { omega_body: Vector3::new(1.0, 0.5, 0.35), ..body };
    let top = FreeTop::new(moments, start)?;
    let round = top.period().ok_or("the polhode closes")?;
    let direction = |body: &Turning| moments.angular_momentum(&body.omega_body).normalize();
    let exact = linear_steps(0.0, round, 240)
        .map(|time| Ok(direction(&top.at(time)?)))
        .collect::<Result<Vec<_>, Cause>>()?;

    let [i1, i2, i3] = moments.to_array();
    let steps = 6;
    let h = round / f64::from(steps);
    let (mut body, mut momentum) = (start, moments.angular_momentum(&start.omega_body));
    let (mut arcs, mut ends) = (Vec::new(), Vec::new());
    for _ in 0..steps {
        // eq:strang: three turns, each by the angle of eq:split-turn.
        for (axis, rate, stroke) in [
            (Vector3::x_axis(), 0.5 * (1.0 / i1 - 1.0 / i2), Stroke::Heavy),
            (Vector3::z_axis(), 1.0 / i3 - 1.0 / i2, Stroke::Orbit),
            (Vector3::x_axis(), 0.5 * (1.0 / i1 - 1.0 / i2), Stroke::Heavy),
        ] {
            let (from, angle) = (momentum, rate * momentum.dot(&axis) * h);
            let turned = |part: f64| UnitQuaternion::from_axis_angle(&axis, -part * angle) * from;
            arcs.push((linear_steps(0.0, 1.0, 24).map(|part| turned(part).normalize()).collect(), stroke));
            momentum = turned(1.0);
        }
        body = Splitting::Strang.solve(&moments, body, h, 1)?;
        if (momentum.normalize() - direction(&body)).norm() > 1e-12 {
            return Err("the arcs do not lead where the library's step does".into());
        }
        ends.push(momentum.normalize());
    }
    let arcs: Vec<(Vec<Vector3<f64>>, Stroke)> = arcs;

    let mut sphere = Drawing::new("", 280.0, 310.0).titled(
        "The direction of the angular momentum, turn by turn",
        "A sphere with the axes 1, 2 and 3 of the book. The exact path is a closed curve around axis 1. Strang's splitting goes round beside it in six steps of three arcs, turns about axis 1, axis 3 and axis 1, \
         and crosses the exact path again and again.",
    );
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0; 3],
        azimuth: 0.3,
        elevation: 0.3,
        distance: 9.0,
        centre: at(130.0, 160.0),
        scale: 90.0,
    })?);
    stage.solid(Solid::sphere([0.0; 3], 1.0)?, Hue::Blue)?;
    stage.curve(Curve::smooth(exact.iter().copied())?, Stroke::Curve, Look::EXACT.hue)?;
    for (arc, stroke) in &arcs {
        let stroke = if *stroke == Stroke::Heavy { Stroke::Curve } else { Stroke::Orbit };
        stage.curve(Curve::smooth(arc.iter().copied())?, stroke, Look::STRANG.hue)?;
    }
    for end in &ends {
        stage.dot(*end, 3.0, Look::STRANG.hue)?;
    }
    for (axis, tip, name) in [
        (Vector3::x(), 1.5, r"$\hat{\mathbf{1}}$"),
        (Vector3::y(), 1.32, r"$\hat{\mathbf{2}}$"),
        (Vector3::z(), 1.32, r"$\hat{\mathbf{3}}$"),
    ] {
        stage.named_vector(axis, axis * tip, name, Hue::Ink)?;
    }
    stage.write(&mut sphere);
    sphere.label(at(130.0, 296.0), Side::Over, "(a) on the sphere", Hue::Ink)?;

    let mut along = Drawing::new("", 300.0, 310.0).titled(
        "The same, seen along axis 1",
        "The same path and the same arcs, seen from the end of axis 1, enlarged. The exact path is an oval. A thick arc about axis 1, a part of a circle about the middle of the picture, leads off it, a thin one about axis 3, which is level, leads across it, \
         and another thick one leads back to a dot at the end of the step.",
    );
    let flat = |point: &Vector3<f64>| (point.y, point.z);
    let mut plot = Plot::plane(&mut along, at(145.0, 148.0), 178.0, 1.1)?;
    plot.curve("exact", exact.iter().map(flat), Look::EXACT.stroke, Look::EXACT.hue);
    for ((arc, stroke), place) in arcs.iter().zip(0..) {
        plot.curve(&format!("arc-{place}"), arc.iter().map(flat), *stroke, Look::STRANG.hue);
    }
    for (place, words) in [(4, "about axis 3"), (9, "about axis 1")] {
        let middle = arcs[place].0[12];
        let [foot, tip] = [0.72, 0.97].map(|part| flat(&(middle * part)));
        plot.reference(foot, tip, Stroke::Dotted);
        plot.label(flat(&(middle * 0.6)), Side::Over, words, Look::STRANG.hue)?;
    }
    let ends: Vec<_> = ends.iter().map(flat).collect();
    plot.markers(&ends, Marker::Disc, Look::STRANG.hue);
    plot.drawing().label(at(145.0, 148.0), Side::Over, r"$\hat{\mathbf{1}}$", Hue::Ink)?;
    along.label(at(145.0, 296.0), Side::Over, "(b) along axis 1", Hue::Ink)?;
    Ok(Drawing::panels(id, vec![sphere, along]))
}

/// Largest errors so far, against the time in rounds of the polhode.
struct Errors {
    energy: Vec<(f64, f64)>,
    attitude: Vec<(f64, f64)>,
}

/// Work for one round of the polhode in the figure below: evaluations, or turns.
const WORK: usize = 480;

/// How a method fares over so many rounds.
fn errors(method: Fixed, rounds: usize) -> Result<Errors, Cause> {
    let (moments, start) = book()?;
    let top = FreeTop::new(moments, start)?;
    let round = top.period().ok_or("the polhode closes")?;
    let energy = moments.kinetic_energy(&start.omega_body);
    let parts = 5; // looks a round
    let steps = WORK / method.work() / parts;
    let mut state = start.to_array();
    let mut worst = (1e-17_f64, 1e-17_f64);
    let mut found = Errors { energy: Vec::new(), attitude: Vec::new() };
    for part in 1..=rounds * parts {
        state = method.run(&moments, state, round / parts as f64, steps)?;
        let body = Turning::from_array(state);
        let time = part as f64 / parts as f64;
        let exact = top.at(time * round)?.world_from_body;
        worst.0 = worst.0.max((moments.kinetic_energy(&body.omega_body) / energy - 1.0).abs());
        worst.1 = worst.1.max(rotation_between(&body.world_from_body, &exact));
        if part % parts == 0 && found.energy.last().is_none_or(|last| time >= 1.12 * last.0) {
            found.energy.push((time, worst.0));
            found.attitude.push((time, worst.1));
        }
    }
    Ok(found)
}

/// The four methods of the long run, with the places of their labels in the two plots.
const LONG_RUN: [(Fixed, &str, Look, Places); 4] = [
    (Fixed::Rk4, "rk4", Look::RK4, [(70.0, 4e-3), (2.0, 1.5e-3)]),
    (Fixed::Split(Splitting::Strang), "strang", Look::STRANG, [(1.5, 3e-4), (1.5, 1e-1)]),
    (Fixed::Dop853, "dop853", Look::DOP853, [(6.0, 4e-10), (60.0, 2e-6)]),
    (Fixed::Split(Splitting::BlanesMoan), "blanes-moan", Look::BLANES_MOAN, [(1.5, 3.5e-8), (3.0, 6e-6)]),
];

/// The name of a method where there is little room.
fn short(look: &Look) -> &'static str {
    if *look == Look::BLANES_MOAN { "BM" } else { look.name }
}

/// Errors of the energy and of the attitude against time.
pub(crate) fn method_long_run(id: &str) -> Outcome {
    let runs = LONG_RUN.map(|(method, name, look, places)| Ok((errors(method, 10_000)?, name, look, places)));
    let runs = runs.into_iter().collect::<Result<Vec<_>, Cause>>()?;
    let rounds = Axis::log(1.0, 1e4, 1).titled("time, in rounds");
    let frame = Rect::new(50.0, 34.0, 218.0, 250.0);
    let mut energy = Drawing::new("", 285.0, 330.0).titled(
        "Energy errors of four methods over ten thousand rounds",
        "Both scales are logarithmic: rounds from 1 to 10000, and the largest relative error of the energy so far. RK4 and DOP853 rise along straight lines of slope one, \
         those of the two splittings stay level.",
    );
    let error = Axis::log(1e-10, 1.0, 2).titled("(a) error of the energy so far");
    let mut plot = Plot::new(&mut energy, frame, rounds, error)?;
    for (errors, name, look, places) in &runs {
        plot.curve(&format!("{name}-energy"), errors.energy.iter().copied(), look.stroke, look.hue);
        plot.label(places[0], Side::Right, short(look), look.hue)?;
    }
    let mut attitude = Drawing::new("", 285.0, 330.0).titled(
        "Attitude errors of four methods over ten thousand rounds",
        "Both scales are logarithmic: rounds from 1 to 10000, and the largest error of the attitude so far, up to half a turn. RK4 and DOP853 rise with slope two, \
         the two splittings with slope one; Strang's begins highest and ends beside RK4 at half a turn, that of Blanes and Moan is the lowest in the end.",
    );
    let error = Axis::log(1e-8, 10.0, 2).titled("(b) error of the attitude so far, rad");
    let mut plot = Plot::new(&mut attitude, frame, rounds, error)?;
    plot.level(PI, Stroke::Reference);
    for (errors, name, look, places) in &runs {
        plot.curve(&format!("{name}-attitude"), errors.attitude.iter().copied(), look.stroke, look.hue);
        plot.label(places[1], Side::Right, short(look), look.hue)?;
    }
    Ok(Drawing::panels(id, vec![energy, attitude]))
}
