//! The figures of the chapter "Frisbee and pencil".

use drawing::kit::{Heads, Marker, arrow, head};
use drawing::space::{Camera, Curve, Solid, Stage, View};
use drawing::{Drawing, Hue, Rect, Side, Stroke, at};
use figures::{Axis, Cause, Figure, Outcome, Plot, figures, in_both, linear_steps, log_steps};
use mechanics::InvalidQuantity;
use mechanics::euler::Turning;
use mechanics::inertia::{Body, Cylinder, PrincipalMoments, Spheroid, SymmetricMoments};
use mechanics::integrate::Dop853;
use mechanics::scenes::air_drag::{Drag, DraggedTop, DraggedTopParameters};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// All figures of this chapter.
pub(crate) const FIGURES: &[Figure] =
    figures![drag_stills, two_clocks, tangent, spin_tangent, wobble_turns, axis_path, fates];

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
            stage.arrow(Curve::smooth(path)?, Stroke::Outline, Heads::End, Hue::Blue)?;
            let momentum = states[0].angular_momentum_world(&body.moments).normalize();
            stage.vector([0.0; 3], momentum * 1.45, Hue::Green)?;
            if body.flat {
                stage.vector([0.0; 3], axis * reach, Hue::Blue)?;
            }
            stage.write(&mut drawing);
            let decimals = usize::from(left < 0.01);
            let percent = format!("{:.decimals$} %", 100.0 * left);
            let name = if still == 0 { format!("{}, spin {percent}", body.name) } else { percent };
            let below = if body.flat && !down { 60.0 } else { 76.0 };
            drawing.label(middle + at(0.0, below), Side::Over, &name, Hue::Ink)?;
            if still == 0 {
                drawing.label(middle + at(4.0, -70.0), Side::Right, r"$\boldsymbol{L}$", Hue::Green)?;
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
    let panel =
        |name: &str, [title, description, says]: [&str; 3], ratio: f64, wobble: f64, step: f64| -> Outcome {
            let mut drawing = Drawing::new("", 240.0, 372.0).titled(title, description);
            let top = body(ratio, 1.0, Vector3::new(wobble, 0.0, 1.0))?;
            let parts = |time: f64| -> Result<(f64, f64), InvalidQuantity> {
                let omega = top.at(time)?;
                Ok((omega.x.hypot(omega.y), omega.z))
            };
            let across = Axis::linear(0.0, 0.6, 0.2).titled(r"wobble part $\omega_\perp/\omega_{3,0}$");
            let along = Axis::linear(0.0, 1.0, 0.2).titled(r"spin part $\omega_3/\omega_{3,0}$");
            let mut plot = Plot::new(&mut drawing, Rect::new(52.0, 34.0, 156.0, 260.0), across, along)?;
            let tips =
                linear_steps(0.0, 12.0, 1200).map(parts).collect::<Result<Vec<_>, InvalidQuantity>>()?;
            plot.curve(name, tips, Stroke::Curve, Hue::Orange);
            for count in 0..3 {
                let [from, to] = [plot.at((0.0, 0.0)), plot.at(parts(step * f64::from(count))?)];
                arrow(plot.drawing(), from, to, Hue::Orange);
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
        0.6,
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
        0.6,
        0.5,
    )?;
    Ok(Drawing::panels(id, vec![flat, long]))
}

/// The tangent of the angle against time, on a logarithmic scale.
pub(crate) fn tangent(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 340.0).titled(
        "Tangent of the angle against time",
        "The tangent of the angle between the angular velocity and the body's axis on a logarithmic scale, \
         against time times C over I1, from 0 to 6. Three straight lines from 0.3: for a thin disc falling \
         by a factor of twenty, for a ball level, for a thick rod rising by a factor of four hundred.",
    );
    let time = Axis::linear(0.0, 6.0, 1.0).minor(0.2).titled(r"time $Ct/I_1$");
    let value = Axis::log(1e-3, 1e3, 1).titled(r"$\tan\theta$");
    let mut plot = Plot::new(&mut drawing, Rect::new(48.0, 34.0, 330.0, 252.0), time, value)?;
    plot.level(1.0, Stroke::Reference);
    for (ratio, place, side, name) in [
        (2.0, 3.4, Side::BelowLeft, r"thin disc, $I_3 = 2I_1$"),
        (1.0, 5.0, Side::Below, "ball"),
        (0.5, 3.6, Side::AboveLeft, r"rod, $I_3 = \tfrac12I_1$"),
    ] {
        let top = body(ratio, 1.0, Vector3::new(0.3, 0.0, 1.0))?;
        let values = linear_steps(0.0, 6.0, 60)
            .map(|t| Ok((t, top.axis_angle(t)?.tan())))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve(&format!("ratio-{ratio}"), values, Stroke::Curve, Hue::Orange);
        plot.label((place, top.axis_angle(place)?.tan()), side, name, Hue::Orange)?;
    }
    plot.label((6.0, 1.0), Side::AboveLeft, r"$\theta = 45°$", Hue::Muted)?;
    Ok(drawing)
}

/// The tangent of the angle against the spin that is left.
pub(crate) fn spin_tangent(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 340.0).titled(
        "Tangent of the angle against the spin that is left",
        "The tangent of the angle, divided by that at the start, against the spin divided by that at the \
         start, from 0 to 1. All curves end at one, one. For a thin disc it is the straight line through \
         the origin; for a ratio of the moments of one and a half a square root; for a ball level at one; \
         for a ratio of a half it rises without limit as the spin goes to zero.",
    );
    let spin = Axis::linear(0.0, 1.0, 0.2).minor(0.05).titled(r"spin that is left $\omega_3/\omega_{3,0}$");
    let value = Axis::linear(0.0, 2.0, 0.5).minor(0.1).titled(r"$\tan\theta/\tan\theta_0$");
    let mut plot = Plot::new(&mut drawing, Rect::new(48.0, 34.0, 330.0, 252.0), spin, value)?;
    for ratio in [2.0, 1.5, 1.0, 0.5] {
        let top = body(ratio, 1.0, Vector3::new(1.0, 0.0, 1.0))?;
        // Evenly spaced in the spin: its logarithm is the time.
        let values = linear_steps(1e-4, 1.0, 300)
            .map(|left| {
                let time = -left.ln() * ratio;
                Ok((top.at(time)?.z, top.axis_angle(time)?.tan()))
            })
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve(&format!("ratio-{ratio}"), values, Stroke::Curve, Hue::Orange);
    }
    plot.label((0.47, 0.4), Side::BelowRight, r"$I_3/I_1 = 2$", Hue::Orange)?;
    plot.label((0.2, 0.47), Side::AboveLeft, r"$\tfrac32$", Hue::Orange)?;
    plot.label((0.62, 1.0), Side::Above, "$1$", Hue::Orange)?;
    plot.label((0.4, 1.6), Side::AboveRight, r"$\tfrac12$", Hue::Orange)?;
    Ok(drawing)
}

/// How many turns the spiral of the wobble makes in all.
const TURNS: f64 = 3.3;

/// The angular velocity across the axis, as seen from the body: a spiral with a finite number of turns.
pub(crate) fn wobble_turns(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 400.0).titled(
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
    let mut plot = Plot::new(&mut drawing, Rect::new(52.0, 34.0, 310.0, 310.0), x, y)?;
    let times: Vec<f64> = linear_steps(0.0, 12.0 / drag, 4000).collect();
    let values: Vec<(f64, f64)> = top.sample(&times)?.into_iter().map(|omega| (omega.x, omega.y)).collect();
    // The direction of arrival, from the number of turns.
    let (sin, cos) = (TAU * top.total_body_turns()).sin_cos();
    plot.reference((0.0, 0.0), (cos, sin), Stroke::Reference);
    plot.curve("spiral", values.iter().copied(), Stroke::Curve, Hue::Orange);
    plot.markers(&[(1.0, 0.0)], Marker::Disc, Hue::Orange);
    plot.label((0.98, 0.02), Side::AboveLeft, "start", Hue::Orange)?;
    plot.label((1.05 * cos, 1.05 * sin), Side::Over, "arrives from here", Hue::Muted)?;
    let [before, here] = [38, 44].map(|index| plot.at(values[index]));
    head(&mut drawing, here, here - before, 1.0, Hue::Orange);
    Ok(drawing)
}

/// A curve with its name and its hue.
type Named<'a> = (&'a str, &'a [(f64, f64)], Hue);

/// The same Frisbee on board and in the room, and the small dance of its angular momentum.
pub(crate) fn axis_path(id: &str) -> Outcome {
    let moments = Body::thin_disk(0.175, 0.137)?.moments();
    let (drag, omega_body) = (Drag::isotropic(2e-3), Vector3::new(12.0, 0.0, 40.0));
    let top = DraggedTop::new(DraggedTopParameters { moments, drag, omega_body })?;
    // Stand so that the angular momentum is upright at the start.
    let momentum = moments.angular_momentum(&omega_body);
    let upright =
        UnitQuaternion::rotation_between(&momentum, &Vector3::z()).ok_or("L is not opposite to z")?;
    let times: Vec<f64> = linear_steps(0.0, 6.0, 6000).collect();
    let states = top.thrown(upright, &Dop853::new(1e-10)?)?.sample(&times)?;
    let pairs = |place: &dyn Fn(&Turning) -> (f64, f64)| states.iter().map(place).collect::<Vec<_>>();
    let omega =
        pairs(&|state| (state.omega_body.x / state.omega_body.z, state.omega_body.y / state.omega_body.z));
    let axis = pairs(&|state| (state.axis_3_world().x, state.axis_3_world().y));
    let momenta = pairs(&|state| {
        let direction = state.angular_momentum_world(&moments).normalize();
        (direction.x, direction.y)
    });
    let enlarged: Vec<(f64, f64)> = momenta.iter().map(|(x, y)| (1e3 * x, 1e3 * y)).collect();
    let panel =
        |[title, description, axis, name]: [&str; 4], reach: f64, minor: f64, curves: &[Named<'_>]| {
            let mut drawing = Drawing::new("", 212.0, 250.0).titled(title, description);
            let across = Axis::linear(-reach, reach, reach).minor(minor);
            let mut plot =
                Plot::new(&mut drawing, Rect::new(42.0, 34.0, 156.0, 156.0), across, across.titled(axis))?;
            for &(curve, values, hue) in curves {
                plot.curve(curve, values.iter().copied(), Stroke::Orbit, hue);
                plot.markers(&values[..1], Marker::Disc, hue);
            }
            drawing.label(at(120.0, 238.0), Side::Over, name, Hue::Ink)?;
            Ok::<Drawing, Cause>(drawing)
        };
    let board = panel(
        [
            "The angular velocity on board",
            "Seen along the Frisbee's axis. The angular velocity, divided by its spin part, begins at the \
             right, 0.3 from the middle, and spirals in about five times, counter-clockwise.",
            r"$\omega_2/\omega_3$ against $\omega_1/\omega_3$",
            r"on board: $\boldsymbol{\omega}$ about $\hat{\mathbf{3}}$",
        ],
        0.3,
        0.1,
        &[("omega", &omega, Hue::Orange)],
    )?;
    let room = panel(
        [
            "The axis in the room",
            "Seen along the angular momentum at the start. The tip of the axis begins at the left, 0.15 \
             from the middle, and spirals in about ten times, twice as often; the angular momentum is a \
             dot in the middle.",
            "$y$ against $x$",
            r"in the room: $\hat{\mathbf{3}}$ about $\boldsymbol{L}$",
        ],
        0.15,
        0.05,
        &[("axis", &axis, Hue::Blue), ("momentum-small", &momenta, Hue::Green)],
    )?;
    let close = panel(
        [
            "The middle of the room's picture, enlarged",
            "The direction of the angular momentum, in thousandths of a radian. It begins in the middle \
             and goes round a circle of a radius of 2.2, again and again.",
            "$y$ against $x$, thousandths",
            r"its middle, enlarged: $\boldsymbol{L}$",
        ],
        5.0,
        1.0,
        &[("momentum", &enlarged, Hue::Green)],
    )?;
    Ok(Drawing::panels(id, vec![board, room, close]))
}

/// The map of fates: moments along it, drag up it, the border, and where real and even bodies lie.
pub(crate) fn fates(id: &str) -> Outcome {
    in_both(|room| {
        let mut drawing = Drawing::new(id, room.of(420.0, 336.0), 400.0).titled(
            "Which bodies settle",
            "Both scales are logarithmic: along x the ratio of the moments, I3 over I1, from a thousandth to 2, \
             beyond which there are no bodies; along y the ratio of the drags, C1 over C3, from a tenth to a \
             thousand. The border is the falling straight line on which their product is one; above it bodies \
             settle, below it they tumble. Dashed lines beside it: one clock ten times as fast as the other. A \
             curve of all even spheroids in slow air runs from flat ones at the lower right, above the border, \
             through the ball, which is on it, to needles, below it and nearly along it. A pencil lies below \
             the border, a pencil with a straw and a Frisbee above it, a disc with a rough rim below.",
        );
        let moments = Axis::log(1e-3, 10.0, 1).titled(r"$I_3/I_1$");
        let drags = Axis::log(0.1, 1000.0, 1).titled(r"$C_1/C_3$");
        let frame = Rect::new(56.0, 34.0, room.of(340.0, 262.0), 306.0);
        let mut plot = Plot::new(&mut drawing, frame, moments, drags)?;
        plot.region((2.0, 0.1), (10.0, 1000.0), Hue::Muted);
        for (name, clocks, stroke) in [
            ("border", 1.0, Stroke::Border),
            ("ten", 10.0, Stroke::DashedCurve),
            ("tenth", 0.1, Stroke::DashedCurve),
        ] {
            let line = log_steps(1e-3, 10.0, 40).map(|ratio| (ratio, clocks / ratio));
            plot.curve(name, line, stroke, Hue::Muted);
        }
        let spheroid = |eta: f64| {
            let shape = Spheroid { equatorial_radius: 1.0, polar_radius: eta };
            let SymmetricMoments { transverse, axial } =
                Body::spheroid(1.0, shape)?.moments().as_symmetric()?;
            let drag = Drag::of_spheroid(shape, 1.0)?;
            Ok::<_, InvalidQuantity>((axial / transverse, drag.transverse / drag.axial))
        };
        let all = log_steps(1e-3, 44.0, 300).map(spheroid).collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve("spheroids", all, Stroke::Curve, Hue::Blue);
        plot.markers(&[spheroid(0.4)?], Marker::Disc, Hue::Blue);
        plot.label((1.45, 2.2), Side::Over, r"$\tfrac25$", Hue::Blue)?;
        for (eta, side, name) in
            [(1.0, Side::BelowLeft, "$1$"), (3.0, Side::BelowLeft, "$3$"), (10.0, Side::BelowLeft, "$10$")]
        {
            plot.markers(&[spheroid(eta)?], Marker::Disc, Hue::Blue);
            plot.label(spheroid(eta)?, side, name, Hue::Blue)?;
        }
        plot.markers(&[(1.0 / 417.2, 81.4)], Marker::Square, Hue::Ink);
        plot.label((1.0 / 360.0, 13.0), Side::Over, "pencil", Hue::Ink)?;
        for (place, side, name) in [
            ((1.0 / 549.0, 813.0), Side::Right, "straw"),
            ((2.0, 10.0), Side::Right, "Frisbee"),
            ((2.0, 0.1), Side::AboveRight, "rim"),
        ] {
            plot.markers(&[place], Marker::Square, Hue::Ink);
            plot.label(place, side, name, Hue::Ink)?;
        }
        plot.label((0.3, 300.0), Side::Over, "settle", Hue::Ink)?;
        plot.label((0.012, 0.6), Side::Over, "tumble", Hue::Ink)?;
        plot.label((4.5, 30.0), Side::Over, "no", Hue::Muted)?;
        plot.label((4.5, 18.0), Side::Over, "bodies", Hue::Muted)?;
        Ok(drawing)
    })
}
