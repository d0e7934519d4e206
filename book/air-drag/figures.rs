//! The figures of the chapter "Frisbee and pencil".

use drawing::kit::{Heads, Marker, arrow, dimension, head};
use drawing::space::{Camera, Curve, Solid, Stage, View};
use drawing::{Drawing, Hue, Rect, Side, Stroke, at};
use figures::{Axis, Cause, Figure, Outcome, Plot, figures, linear_steps};
use mechanics::InvalidQuantity;
use mechanics::euler::Turning;
use mechanics::inertia::{Body, Cylinder, PrincipalMoments};
use mechanics::integrate::Dop853;
use mechanics::scenes::air_drag::{Drag, DraggedTop, DraggedTopParameters};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, LN_2, TAU};

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] = figures![
    two_clocks,
    two_slopes,
    drag_stills,
    tangent,
    spin_tangent,
    wobble_turns,
    in_room::air_pull,
    in_room::axis_path,
    map::fates,
    four_paths
];

#[path = "figures/in_room.rs"]
pub(crate) mod in_room;
#[path = "figures/map.rs"]
pub(crate) mod map;

/// A body with I₁ = 1 and a ratio of the moments, under the same drag about all axes.
fn body(ratio: f64, drag: f64, omega_body: Vector3<f64>) -> Result<DraggedTop, InvalidQuantity> {
    let (moments, drag) = (PrincipalMoments::symmetric(1.0, ratio)?, Drag::isotropic(drag));
    DraggedTop::new(DraggedTopParameters { moments, drag, omega_body })
}

/// The pencil of the stills: radius and half its length.
const PENCIL: (f64, f64) = (0.14, 1.15);

/// One body of the stills.
struct Thrown {
    name: &'static str,
    moments: PrincipalMoments,
    /// The angle between axis and angular momentum at the start, rad.
    lean: f64,
    /// The drag across the axis over that about it, C₁/C₃.
    face: f64,
    /// By which factor the spin falls from one still to the next.
    factor: f64,
    flat: bool,
}

impl Thrown {
    /// The two bodies of the chapter.
    fn both() -> Result<[Self; 2], InvalidQuantity> {
        let (radius, half) = PENCIL;
        let rod = Body::cylinder(1.0, Cylinder { radius, height: 2.0 * half })?.moments();
        let disc = Body::thin_disk(1.0, 1.0)?.moments();
        let degree = TAU / 360.0;
        // The Frisbee's wobble halves from still to still, eq:tangent-power with a face that counts ten times.
        let halves = 0.5_f64.powf(1.0 / 19.0);
        // eq:stick-drag for a stick eight times as long as thick.
        let face = half * half / (3.0 * radius * radius * ((half / radius).ln() - 0.66));
        Ok([
            Self {
                name: "Frisbee",
                moments: disc,
                lean: 30.0 * degree,
                face: 10.0,
                factor: halves,
                flat: true,
            },
            Self { name: "pencil", moments: rod, lean: 6.0 * degree, face, factor: 0.1, flat: false },
        ])
    }

    /// Its axis in the room from each of four moments on, through most of one round about the angular momentum, which
    /// is upright at the start; and the part of the spin that is left.
    fn stills(&self) -> Result<Vec<(Vec<Turning>, f64)>, Cause> {
        let [across, _, along] = self.moments.to_array();
        // L = 1 at the start, and a drag under which it makes hundreds of rounds, chosen so that no small circle has
        // its gap at the left or the right end, where an arrowhead covers most of it.
        let omega_body = Vector3::new(self.lean.sin() / across, 0.0, self.lean.cos() / along);
        let axial = 8e-4 * along / across / self.face;
        let drag = Drag { transverse: self.face * axial, axial };
        let top = DraggedTop::new(DraggedTopParameters { moments: self.moments, drag, omega_body })?;
        let upright =
            UnitQuaternion::rotation_between(&self.moments.angular_momentum(&omega_body), &Vector3::z())
                .ok_or("L is not opposite to z")?;
        let thrown = top.thrown(upright, &Dop853::new(1e-9)?)?;
        (0..4)
            .map(|still| {
                let left = self.factor.powi(still);
                let time = -left.ln() * along / drag.axial;
                let momentum = self.moments.angular_momentum(&top.at(time)?).norm();
                let round = TAU * across / momentum;
                let times: Vec<f64> = linear_steps(time, time + 0.92 * round, 90).collect();
                Ok((thrown.sample(&times)?, left))
            })
            .collect()
    }
}

/// Stills of both bodies, the time running to the right or down.
fn stills(size: (f64, f64), cell: (f64, f64), down: bool) -> Outcome {
    let mut drawing = Drawing::new("", size.0, size.1).titled(
        "A Frisbee calms down, a pencil tumbles",
        "Four pictures of each. The Frisbee begins with its axis thirty degrees off the upright angular \
         momentum; in each next picture, with hardly less spin, the circle of its axis is half as large, until it \
         all but lies flat. The pencil begins nearly upright, with a small circle; in each next picture, with a \
         tenth of the spin, it leans more, until it turns end over end.",
    );
    for (row, body) in Thrown::both()?.into_iter().enumerate() {
        for (still, (states, left)) in body.stills()?.into_iter().enumerate() {
            let (column, row) = if down { (row, still) } else { (still, row) };
            let middle = at(cell.0 * (column as f64 + 0.5), 24.0 + cell.1 * (row as f64 + 0.5));
            let mut stage = Stage::new(Camera::new(View {
                target: [0.0; 3],
                azimuth: -FRAC_PI_2,
                elevation: 0.32,
                distance: 9.0,
                centre: middle,
                scale: 50.0,
            })?);
            let axis = states[0].axis_3_world();
            let solid = if body.flat {
                Solid::disc([0.0; 3], axis, 1.0, 0.12)?
            } else {
                Solid::rod(axis * -PENCIL.1, axis * PENCIL.1, PENCIL.0)?
            };
            stage.solid(solid, Hue::Blue)?;
            let reach = if body.flat { 1.1 } else { PENCIL.1 };
            let path = states.iter().map(|state| state.axis_3_world() * reach);
            let ring = Curve::smooth(path)?;
            let momentum = states[0].angular_momentum_world(&body.moments).normalize();
            if 50.0 * reach * axis.cross(&momentum).norm() > 8.0 {
                stage.arrow(ring, Stroke::Outline, Heads::End, Hue::Ink)?;
            } else {
                stage.curve(ring, Stroke::Outline, Hue::Ink)?; // smaller than the head of an arrow
            }
            stage.vector([0.0; 3], momentum * 1.45, Hue::Green)?;
            if body.flat {
                stage.vector([0.0; 3], axis * reach, Hue::Ink)?;
            }
            stage.write(&mut drawing);
            let decimals = usize::from(left < 0.01);
            let percent = format!("{:.decimals$} %", 100.0 * left);
            let name = if still == 0 { format!("spin {percent}") } else { percent };
            let below = if body.flat && !down { 60.0 } else { 76.0 };
            drawing.label(middle + at(0.0, below), Side::Over, &name, Hue::Ink)?;
            if still == 0 {
                drawing.label(middle + at(4.0, -70.0), Side::Right, r"$\boldsymbol{L}$", Hue::Green)?;
                drawing.label(middle + at(-74.0, -64.0), Side::Right, body.name, Hue::Ink)?;
            }
        }
    }
    Ok(drawing)
}

/// Stills of a Frisbee and a pencil as they slow down.
pub(crate) fn drag_stills(id: &str) -> Outcome {
    let wide = stills((660.0, 380.0), (162.0, 170.0), false)?;
    let narrow = stills((330.0, 740.0), (164.0, 176.0), true)?;
    Ok(Drawing::panels(id, vec![wide]).with_narrow(narrow))
}

/// The spin and the wobble part of the angular velocity, shrinking.
pub(crate) fn two_clocks(id: &str) -> Outcome {
    let panel = |name: &str, [title, description, says]: [&str; 3], ratio: f64, step: f64| -> Outcome {
        let mut drawing = Drawing::new("", 240.0, 372.0).titled(title, description);
        let top = body(ratio, 1.0, Vector3::new(0.6, 0.0, 1.0))?;
        let parts = |time: f64| -> Result<(f64, f64), InvalidQuantity> {
            let omega = top.at(time)?;
            Ok((omega.x.hypot(omega.y), omega.z))
        };
        let across = Axis::linear(0.0, 0.6, 0.2).titled(r"wobble part $\omega_\perp/\omega_{3,0}$");
        let along = Axis::linear(0.0, 1.0, 0.2).titled(r"spin part $\omega_3/\omega_{3,0}$");
        let mut plot = Plot::new(&mut drawing, Rect::new(52.0, 34.0, 156.0, 260.0), across, along)?;
        let tips = linear_steps(0.0, 12.0, 1200).map(parts).collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve(name, tips, Stroke::Orbit, Hue::Orange);
        for (count, time) in ["", "$T$", "$2T$"].into_iter().enumerate() {
            let tip = parts(step * count as f64)?;
            let [from, to] = [plot.at((0.0, 0.0)), plot.at(tip)];
            arrow(plot.drawing(), from, to, Hue::Orange);
            // On the side to which the path bulges.
            let side = if ratio > 1.0 { Side::AboveLeft } else { Side::BelowRight };
            if count > 0 {
                plot.label(tip, side, time, Hue::Ink)?;
            }
        }
        plot.label(parts(0.0)?, Side::Right, r"$\boldsymbol{\omega}$", Hue::Orange)?;
        drawing.label(at(130.0, 360.0), Side::Over, says, Hue::Ink)?;
        Ok(drawing)
    };
    let flat = panel(
        "flat",
        [
            "The two parts of the angular velocity of a disc",
            "Arrows from the origin show the angular velocity at three moments, equally far apart, its wobble part \
             to the right and its spin part upwards. They shrink and turn towards the upright; their tips \
             lie on a curve that reaches the origin upright.",
            "flat: the wobble dies first",
        ],
        2.0,
        0.9,
    )?;
    let long = panel(
        "long",
        [
            "The two parts of the angular velocity of a thick rod",
            "The same arrows for a rod: they shrink and turn away from the upright; their tips lie on a \
             curve that reaches the origin level.",
            "long: the spin dies first",
        ],
        0.5,
        0.5,
    )?;
    Ok(Drawing::panels(id, vec![flat, long]))
}

/// The two clocks of the example by hand, as the slopes of two straight lines.
pub(crate) fn two_slopes(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 300.0).titled(
        "Two clocks are two slopes",
        "Two components of the angular velocity on a logarithmic scale against time, from 0 to 60 seconds. The spin falls along a straight \
         line from 20 radians a second, the rotation across the axis along one half as steep from 2. The gap between the lines, the \
         tangent of the angle, is a tenth at the start, 0.4 at 40 seconds, and goes on closing.",
    );
    // I₃ = ½I₁, one coefficient for all axes, a spin that is halved in 10 s.
    let top = body(0.5, 0.05 * LN_2, Vector3::new(2.0, 0.0, 20.0))?;
    let time = Axis::linear(0.0, 60.0, 20.0).minor(10.0).titled("time, s");
    let value = Axis::log(0.1, 100.0, 1).titled("rad/s, logarithmic scale");
    let mut plot = Plot::new(&mut drawing, Rect::new(44.0, 36.0, 276.0, 212.0), time, value)?;
    type Part = fn(&Vector3<f64>) -> f64;
    let parts: [(&str, Stroke, Part); 2] =
        [("spin", Stroke::Heavy, |omega| omega.z), ("across", Stroke::Curve, |omega| omega.x.hypot(omega.y))];
    for (name, stroke, part) in parts {
        let values = linear_steps(0.0, 60.0, 60)
            .map(|t| Ok((t, part(&top.at(t)?))))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve(name, values, stroke, Hue::Orange);
    }
    for (t, name) in [(1.5, r"$\tan\theta = 0.1$"), (40.0, "$0.4$")] {
        let omega = top.at(t)?;
        let [from, to] = [omega.z, omega.x.hypot(omega.y)].map(|value| plot.at((t, value)));
        dimension(plot.drawing(), from.towards(to, 0.08), from.towards(to, 0.92), Heads::Both, Hue::Muted);
        let (place, side) = if t < 10.0 { (from.towards(to, 0.74), Side::Right) } else { (to, Side::Below) };
        plot.drawing().label(place, side, name, Hue::Muted)?;
    }
    plot.label((16.0, 11.0), Side::AboveRight, r"spin $\omega_3$, slope $-C_3/I_3$", Hue::Orange)?;
    plot.label((28.0, 0.62), Side::BelowLeft, r"across, $\omega_\perp$,", Hue::Orange)?;
    plot.label((28.0, 0.34), Side::BelowLeft, r"slope $-C_1/I_1$", Hue::Orange)?;
    Ok(drawing)
}

/// The tangent of the angle against time, on a logarithmic scale.
pub(crate) fn tangent(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 300.0).titled(
        "Tangent of the angle against time",
        "The tangent of the angle between the angular velocity and the body's axis on a logarithmic scale, \
         against time times C over I1, from 0 to 6. Three straight lines from 0.3: for a thin disc falling \
         by a factor of twenty, for a ball level, for a thick rod rising by a factor of four hundred.",
    );
    let time = Axis::linear(0.0, 6.0, 1.0).minor(0.2).titled(r"time $Ct/I_1$");
    let value = Axis::log(1e-2, 1e3, 1).titled(r"$\tan\theta$");
    let mut plot = Plot::new(&mut drawing, Rect::new(46.0, 34.0, 274.0, 212.0), time, value)?;
    plot.level(1.0, Stroke::Reference);
    for (ratio, place, side, name, hue) in [
        (2.0, 3.6, Side::BelowLeft, r"thin disc, $I_3 = 2I_1$", Hue::Ink),
        (1.0, 5.0, Side::Below, "ball", Hue::Muted),
        (0.5, 3.6, Side::AboveLeft, r"rod, $I_3 = \tfrac12I_1$", Hue::Faint),
    ] {
        let top = body(ratio, 1.0, Vector3::new(0.3, 0.0, 1.0))?;
        let values = linear_steps(0.0, 6.0, 60)
            .map(|t| Ok((t, top.axis_angle(t)?.tan())))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve(&format!("ratio-{ratio}"), values, Stroke::Curve, hue);
        let named = if hue == Hue::Ink { Hue::Ink } else { Hue::Muted };
        plot.label((place, top.axis_angle(place)?.tan()), side, name, named)?;
    }
    plot.label((0.1, 1.0), Side::AboveRight, r"$\theta = 45°$", Hue::Muted)?;
    Ok(drawing)
}

/// The tangent of the angle against the spin that is lost.
pub(crate) fn spin_tangent(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 330.0).titled(
        "Tangent of the angle against the spin that is lost",
        "The tangent of the angle, divided by that at the start, against the part of the spin that is lost, \
         from 0 at the left to 1. All curves begin at one. For a thin disc with equal coefficients it is a straight line down to \
         nothing at the right; for a Frisbee whose face counts ten times it falls at once; for a ball it stays at one; \
         for a ratio of a half it rises without limit. Dots on each curve mark equal steps of time, in each of which the spin is halved.",
    );
    let spin = Axis::linear(0.0, 1.0, 0.5)
        .minor(0.1)
        .titled(r"part of the spin that is lost, $1 - \omega_3/\omega_{3,0}$");
    let value = Axis::linear(0.0, 2.0, 0.5).minor(0.1).titled(r"$\tan\theta/\tan\theta_0$");
    let mut plot = Plot::new(&mut drawing, Rect::new(42.0, 34.0, 300.0, 230.0), spin, value)?;
    for (from, to) in [((0.0, 0.5), (0.5, 0.5)), ((0.5, 0.5), (0.5, 0.0))] {
        plot.reference(from, to, Stroke::Dotted);
    }
    for (name, ratio, face, stroke, hue) in [
        ("frisbee", 2.0, 10.0, Stroke::Heavy, Hue::Ink),
        ("ratio-2", 2.0, 1.0, Stroke::Curve, Hue::Ink),
        ("ratio-1", 1.0, 1.0, Stroke::Curve, Hue::Muted),
        ("ratio-0.5", 0.5, 1.0, Stroke::Curve, Hue::Faint),
    ] {
        let moments = PrincipalMoments::symmetric(1.0, ratio)?;
        let drag = Drag { transverse: face, axial: 1.0 };
        let omega_body = Vector3::new(1.0, 0.0, 1.0);
        let top = DraggedTop::new(DraggedTopParameters { moments, drag, omega_body })?;
        // When so much of the spin is left.
        let at_left = |left: f64| {
            let time = -left.ln() * ratio;
            Ok::<_, InvalidQuantity>((1.0 - top.at(time)?.z, top.axis_angle(time)?.tan()))
        };
        // Evenly spaced in the spin: its logarithm is the time.
        let values =
            linear_steps(1.0, 1e-4, 400).map(at_left).collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve(name, values, stroke, hue);
        for halvings in 1..=3 {
            let place = at_left(0.5_f64.powi(halvings))?;
            if place.1 < 2.0 {
                let place = plot.at(place);
                plot.drawing().dot(place, 2.6, hue);
            }
        }
    }
    plot.label((0.12, 0.12), Side::Right, "Frisbee", Hue::Ink)?;
    plot.label((0.56, 0.44), Side::AboveRight, "thin disc", Hue::Ink)?;
    plot.label((0.62, 1.0), Side::Below, "ball", Hue::Muted)?;
    plot.label((0.55, 1.5), Side::AboveLeft, r"rod, $I_3 = \tfrac12I_1$", Hue::Muted)?;
    Ok(drawing)
}

/// How many turns the spiral of the wobble makes in all.
const TURNS: f64 = 3.3;

/// The angular velocity across the axis, as seen from the body: a spiral with a finite number of turns.
pub(crate) fn wobble_turns(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 350.0).titled(
        "The angular velocity spirals in with a finite number of turns",
        "The component omega 2 against omega 1 in the body, both divided by omega 1 at the start. The \
         curve begins at one on the axis of omega 1, winds inwards counter-clockwise, as an arrowhead \
         shows, and reaches the origin along a dashed line after 3.3 turns in all.",
    );
    // As many turns in all: (I₃ − I₁) I₃ ω₃ / (2π I₁ C) with I₃ = 2 I₁.
    let drag = 2.0 / (TURNS * TAU);
    let top = body(2.0, drag, Vector3::new(1.0, 0.0, 1.0))?;
    let across = Axis::linear(-1.0, 1.0, 0.5).minor(0.1);
    let (x, y) = (across.titled(r"$\omega_1/\omega_{1,0}$"), across.titled(r"$\omega_2/\omega_{1,0}$"));
    let mut plot = Plot::new(&mut drawing, Rect::new(50.0, 34.0, 264.0, 264.0), x, y)?;
    let times: Vec<f64> = linear_steps(0.0, 12.0 / drag, 4000).collect();
    let values: Vec<(f64, f64)> = top.sample(&times)?.into_iter().map(|omega| (omega.x, omega.y)).collect();
    // The direction of arrival, from the number of turns.
    let (sin, cos) = (TAU * top.total_body_turns()).sin_cos();
    plot.reference((0.0, 0.0), (cos, sin), Stroke::Reference);
    plot.curve("spiral", values.iter().copied(), Stroke::Curve, Hue::Orange);
    plot.markers(&[(1.0, 0.0)], Marker::Disc, Hue::Orange);
    plot.label((0.98, 0.02), Side::AboveLeft, "start", Hue::Orange)?;
    // The end of each round, on the axis of ω₁.
    let rounds = values.windows(2).filter(|pair| pair[0].1 < 0.0 && pair[1].1 >= 0.0 && pair[1].0 > 0.0);
    for (count, pair) in rounds.take(2).enumerate() {
        let place = plot.at(pair[1]);
        plot.drawing().dot(place, 2.6, Hue::Orange);
        plot.label(pair[1], Side::Right, &(count + 1).to_string(), Hue::Ink)?;
    }
    plot.label((1.05 * cos, 1.05 * sin), Side::Over, "arrives from here", Hue::Muted)?;
    let [before, here] = [38, 44].map(|index| plot.at(values[index]));
    head(&mut drawing, here, here - before, 1.0, Hue::Orange);
    Ok(drawing)
}

/// Four bodies that come to rest, in the plane of their two rotations.
pub(crate) fn four_paths(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 330.0, 340.0).titled(
        "Four paths to rest",
        "The rotation across against the spin, both from 0 to 1. Four curves lead from the corner at the top right to the origin: one bulges to the upper left and arrives from above, one is straight, one \
         bulges to the lower right and arrives from the right, and one falls almost straight down first. Dots where half of the spin is gone.",
    );
    let spin = Axis::linear(0.0, 1.0, 0.5).minor(0.1).titled(r"spin $\omega_3/\omega_{3,0}$");
    let across = Axis::linear(0.0, 1.0, 0.5).minor(0.1).titled(r"across, $\omega_\perp/\omega_{3,0}$");
    let mut plot = Plot::new(&mut drawing, Rect::new(40.0, 36.0, 250.0, 250.0), spin, across)?;
    plot.reference((0.5, 0.0), (0.5, 1.0), Stroke::Dotted);
    for (name, clocks, place, side) in [
        ("half", 0.5, (0.25, 0.5), Side::AboveLeft),
        ("same", 1.0, (0.33, 0.33), Side::AboveLeft),
        ("twice", 2.0, (0.66, 0.4356), Side::BelowRight),
        ("twenty", 20.0, (0.93, 0.234), Side::BelowRight),
    ] {
        let moments = PrincipalMoments::symmetric(1.0, 1.0)?;
        let drag = Drag { transverse: clocks, axial: 1.0 };
        let omega_body = Vector3::new(1.0, 0.0, 1.0);
        let top = DraggedTop::new(DraggedTopParameters { moments, drag, omega_body })?;
        // When so much of the spin is left.
        let at_left = |left: f64| {
            let omega = top.at(-left.ln())?;
            Ok::<_, InvalidQuantity>((omega.z, omega.xy().norm()))
        };
        let values =
            linear_steps(1.0, 1e-4, 400).map(at_left).collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve(name, values, Stroke::Curve, Hue::Orange);
        plot.markers(&[at_left(0.5)?], Marker::Disc, Hue::Orange);
        plot.label(place, side, &format!("{clocks}").replace("0.5", "½"), Hue::Ink)?;
    }
    Ok(drawing)
}
