//! The scene of the chapter "Frisbee and pencil": a body slows down, and its place on a map decides how it ends.

use live::prelude::*;
use mechanics::attitude::angle_between;
use mechanics::euler::Turning;
use mechanics::inertia::PrincipalMoments;
use mechanics::integrate::Dop853;
use mechanics::scenes::air_drag::{AxisTrend, Drag, DraggedTop, DraggedTopParameters};
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::LN_10;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "air-drag",
    title: "A body slows down in air",
    description: "A flat disc in the air above a floor, leaning; the path of its axis winds in towards the upright angular momentum L. Beside it a map of the ratio of the \
                  drags against the ratio of the moments, parted by a sloping line, with a dot for the disc. Below the map the angular momentum as an arrow, its part along \
                  the axis upwards: its tip follows a curve that comes to the origin upright.",
    question: "In the end a pencil turns end over end. Is this rotation faster than at the start, when it was only a slight wobble? And which dies first, the wobble or the \
               spin?",
    size: [[640.0, 470.0], [360.0, 532.0]],
    view: Some([-1.25, 0.3]),
    still: 10.0,
    controls: &[
        Control::log_slider("ratio", r"long to flat: moments $I_3/I_1$", RATIOS, "", 2.0),
        Control::log_slider("drag", r"drag across the axis and about it, $C_1/C_3$", DRAGS, "", 1.0),
        Control::slider(
            "lean",
            r"lean of the axis from $\boldsymbol{L}$ at the start",
            [0.0, 90.0, 0.5],
            "°",
            30.0,
        ),
    ],
    presets: &[
        preset("a disc, equal drags", &[]),
        preset("a Frisbee", &[("ratio", 2.0), ("drag", 10.0)]),
        preset("a rough rim", &[("ratio", 2.0), ("drag", 0.1)]),
        preset("neither flat nor long", &[("ratio", 1.0)]),
        preset("a pencil", &[("ratio", 0.0024), ("drag", 81.0), ("lean", 6.0)]),
        preset("a straw through it", &[("ratio", 0.0018), ("drag", 810.0), ("lean", 20.0)]),
    ],
    readings: &[
        reading("spin that is left", Form::Fixed(1), "%"),
        reading(r"lean of the axis from $\boldsymbol{L}$", Form::Fixed(1), "°"),
        reading(r"rate at which the wobble decays, $C_1/I_1$", Form::Fixed(3), "/s"),
        reading(r"rate at which the spin decays, $C_3/I_3$", Form::Fixed(3), "/s"),
        reading(r"turns of $\boldsymbol\omega$ about the axis, on board", Form::Fixed(1), ""),
        reading("energy lost, less what the air took", Form::Power(1), ""),
    ],
    symbols: formulas! {
        r"\boldsymbol{L}", r"\hat{\mathbf{3}}", r"\boldsymbol{\omega}", r"I_3/I_1", r"C_1/C_3"
    },
    start: |settings| Ok(Box::new(Slowing::new(settings)?)),
};

/// The map: I₃/I₁ to the right, C₁/C₃ upwards.
const RATIOS: [f64; 2] = [0.0015, 2.0];
const DRAGS: [f64; 2] = [0.05, 2000.0];
/// The quicker of the two decays, 1/s: air as thick as that takes.
const DECAY: f64 = 1.0 / 8.0;
/// How fast the axis goes round the angular momentum at the start, rad/s, L/I₁.
const ROUND: f64 = 1.2 * TAU;
/// From moment to moment of the path, s.
const STEP: f64 = 1.0 / 60.0;
/// For how long the path of the axis stays, s.
const TRAIL: f64 = 2.5;
/// Half the diagonal of the drawn body, units of the world.
const REACH: f64 = 1.15;
/// How long its axis is drawn, units of the world.
const TIP: f64 = 1.55;

/// A body that slows down, as it is seen in the room.
struct Slowing {
    top: DraggedTop,
    drag: Drag,
    ratio: f64,
    /// The angle between axis and angular momentum at the start, degrees.
    lean: f64,
    duration: f64,
    /// The states every [`STEP`], and what the air has taken of the energy by then.
    states: Vec<Turning>,
    taken: Vec<f64>,
}

impl Slowing {
    fn new(settings: &Settings<'_>) -> Result<Self, Cause> {
        let (ratio, lean) = (settings.of("ratio")?, settings.of("lean")?);
        let moments = PrincipalMoments::symmetric(1.0, ratio)?;
        // C₁/I₁ over C₃/I₃; the larger of the two rates is DECAY.
        let clocks = settings.of("drag")? * ratio;
        let drag =
            Drag { transverse: DECAY * clocks.min(1.0), axial: DECAY * ratio * (1.0 / clocks).min(1.0) };
        let (sin, cos) = if lean == 90.0 { (1.0, 0.0) } else { lean.to_radians().sin_cos() };
        let omega_body = Vector3::new(ROUND * sin, 0.0, ROUND * cos / ratio);
        let top = DraggedTop::new(DraggedTopParameters { moments, drag, omega_body })?;
        let duration = (1.3 * LN_10 / top.alignment_rate().abs()).clamp(24.0, 50.0);
        let upright = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), -lean.to_radians());
        let times: Vec<f64> = (0..=(duration / STEP) as u32 + 2).map(|n| STEP * f64::from(n)).collect();
        let states = top.thrown(upright, &Dop853::new(1e-9)?)?.sample(&times)?;
        let power = |state: &Turning| -top.torque_body(&state.omega_body).dot(&state.omega_body);
        let powers: Vec<f64> = states.iter().map(power).collect();
        Ok(Self { top, drag, ratio, lean, duration, taken: added_up(&powers), states })
    }

    /// The state at a time: from the last one in the table on.
    fn state(&self, time: f64) -> Result<Turning, Cause> {
        let before = self.before(time);
        let Turning { world_from_body, omega_body } = self.states[before];
        if omega_body.norm() == 0.0 {
            return Ok(self.states[before]);
        }
        let parameters = DraggedTopParameters { moments: self.top.moments(), drag: self.drag, omega_body };
        let top = DraggedTop::new(parameters)?;
        let rest = (time - STEP * before as f64).max(0.0);
        Ok(top.thrown(world_from_body, &Dop853::new(1e-9)?)?.at(rest)?)
    }

    /// The place in the table of the last moment before a time.
    fn before(&self, time: f64) -> usize {
        ((time / STEP) as usize).min(self.states.len().min(self.taken.len()) - 1)
    }

    /// The angular momentum's parts across the axis and along it, of its size at the start.
    fn parts(&self, time: f64) -> Result<(f64, f64), Cause> {
        let momentum = self.top.moments().angular_momentum(&self.top.at(time)?) / ROUND;
        Ok((momentum.xy().norm(), momentum.z))
    }

    /// When the tangent of the lean is a tenth, or ten times, what it was.
    fn settled(&self) -> Option<f64> {
        let settles = self.top.axis_trend() != AxisTrend::Unchanged;
        Some(LN_10 / self.top.alignment_rate().abs()).filter(|time| settles && *time < 1e3)
    }

    /// What has become of the energy but for what the air has taken, of all of it: rounding, if all is right.
    fn unaccounted(&self, time: f64) -> Result<f64, Cause> {
        let energy = |state: &Turning| self.top.moments().kinetic_energy(&state.omega_body);
        // The air's share since the last moment in the table, by Simpson's rule.
        let (before, now) = (self.before(time), self.state(time)?);
        let rest = (time - STEP * before as f64).max(0.0);
        let middle = self.top.at(time - 0.5 * rest)?;
        let power = |omega: &Vector3<f64>| -self.top.torque_body(omega).dot(omega);
        let ends = power(&self.states[before].omega_body) + power(&now.omega_body);
        let taken = self.taken[before] + rest / 6.0 * (ends + 4.0 * power(&middle));
        let start = energy(&self.states[0]);
        Ok((energy(&now) + taken) / start - 1.0)
    }

    /// The part of the spin that is left at a time.
    fn left(&self, time: f64) -> Result<f64, Cause> {
        let [start, now] = [0.0, time].map(|time| self.top.at(time));
        Ok(if self.lean == 90.0 { 0.0 } else { now?.z / start?.z })
    }

    /// The body, its radius and its height: a cylinder with its ratio of moments is √(6(I₁/I₃ − ½)) radii high.
    fn body(&self, axis: Vector3<f64>) -> Result<(Solid, f64, f64), Cause> {
        let height = (6.0 * (1.0 / self.ratio - 0.5)).max(0.0).sqrt();
        let radius = REACH / 1.0_f64.hypot(0.5 * height);
        let high = (height * radius).max(0.1);
        Ok((Solid::disc([0.0; 3], axis, radius, high)?, radius, high))
    }

    fn draw_body(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let now = self.state(moment.time)?;
        let axis = now.axis_3_world();
        let distance = 9.0;
        let (centre, scale) = moment.room.of((at(170.0, 238.0), 100.0), (at(180.0, 172.0), 82.0));
        let mut stage = Stage::new(moment.camera([0.0; 3], distance, centre, scale)?);
        stage.ground([-1.2, -1.2], [1.2, 1.2], -1.5, 0.4)?;
        let (solid, radius, high) = self.body(axis)?;
        stage.solid(solid, Hue::Blue)?;
        // A mark on the face that is seen; a long body spins too fast for one.
        let above = distance * Vector3::from(moment.towards_eye()).dot(&axis);
        let face = 0.5 * high.copysign(above);
        if self.ratio > 0.7 && above.abs() > 0.5 * high {
            let corner = |angle: f64, reach: f64| {
                let (sin, cos) = angle.sin_cos();
                let corner = Vector3::new(reach * radius * cos, reach * radius * sin, face);
                <[f64; 3]>::from(now.world_from_body * corner)
            };
            let rim = (-6..=6).map(|n| corner(0.035 * f64::from(n), 0.98));
            let hub = (-6..=6).rev().map(|n| corner(0.035 * f64::from(n), 0.55));
            stage.patch(rim.chain(hub), Fill::Solid, Hue::Blue)?;
        }
        let begin = self.before((moment.time - TRAIL).max(0.0));
        let path = self.states[begin..=self.before(moment.time)].iter().map(Turning::axis_3_world);
        let path: Vec<[f64; 3]> = path.chain([axis]).map(|tip| (tip * TIP).into()).collect();
        if path.len() > 2 && self.lean > 0.0 {
            stage.curve(Curve::smooth(path)?.hiding(Hiding::Pale), Stroke::Curve, Hue::Blue)?;
        }
        let momentum = now.angular_momentum_world(&self.top.moments()).normalize();
        let spin = now.omega_world().normalize();
        stage.named_vector([0.0; 3], momentum * 1.85, r"$\boldsymbol{L}$", Hue::Green)?;
        stage.vector([0.0; 3], axis * TIP, Hue::Ink)?;
        stage.vector([0.0; 3], spin * 1.3, Hue::Orange)?;
        // Names stand away from L, and only where the arrows can be told apart.
        let side = |arrow: &Vector3<f64>| {
            if moment.rightward(arrow - momentum) > 0.0 { Side::Right } else { Side::Left }
        };
        if angle_between(&axis, &momentum) > 0.12 {
            stage.label_shifted(axis * TIP, at(0.0, -10.0), side(&axis), r"$\hat{\mathbf{3}}$", Hue::Ink)?;
        }
        if angle_between(&spin, &axis).min(angle_between(&spin, &momentum)) > 0.08 {
            stage.label(spin * 1.3, side(&spin), r"$\boldsymbol{\omega}$", Hue::Orange)?;
        }
        stage.write(drawing);
        Ok(())
    }

    /// The map of fates, with the lines of equal spin that is left.
    fn draw_map(&self, room: Room, drawing: &mut Drawing) -> Result<(), Cause> {
        let mut map = map(room).on(drawing)?;
        let [from, to] = RATIOS;
        // Where C₁/I₁ is so many times C₃/I₃.
        let line = |times: f64| [(from, times / from), (to, times / to)];
        let lowest = DRAGS[0];
        map.area([(from, lowest), line(1.0)[0], line(1.0)[1], (to, lowest)], Fill::Ground, Hue::Muted);
        map.curve(line(1.0), Stroke::Border, Hue::Ink);
        // eq:tangent-power with two drags: a tenth of the tangent costs so much of the spin.
        for (left, name) in [(0.5, "50 %"), (0.9, "90 %")] {
            let line = line(1.0 + LN_10 / -f64::ln(left));
            map.curve(line, Stroke::Reference, Hue::Muted);
            at_end(&mut map, line[1], name)?;
        }
        at_end(&mut map, line(1.0)[1], "0")?;
        match room {
            Room::Wide => at_end(&mut map, (to, 80.0), "spin left")?,
            Room::Narrow => {
                at_end(&mut map, (to, 300.0), "spin")?;
                at_end(&mut map, (to, 80.0), "left")?;
            }
        }
        match room {
            Room::Wide => map.label((1.8, 900.0), Side::Left, "wobble dies", Hue::Ink)?,
            Room::Narrow => {
                map.label((1.8, 1100.0), Side::Left, "wobble", Hue::Ink)?;
                map.label((1.8, 330.0), Side::Left, "dies", Hue::Ink)?;
            }
        }
        map.label((0.0025, 0.3), Side::Right, "spin dies", Hue::Ink)?;
        map.grip((self.ratio, self.drag_ratio()), Hue::Pink);
        Ok(())
    }

    fn drag_ratio(&self) -> f64 {
        self.drag.transverse / self.drag.axial
    }

    /// The angular momentum as the body has it.
    fn draw_parts(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let mut graph = parts(moment.room).on(drawing)?;
        let curve =
            |to: f64| linear_steps(0.0, to, 120).map(|time| self.parts(time)).collect::<Result<Vec<_>, _>>();
        let start: Vec<(f64, f64)> = (0..=45).map(|n| (2.0 * f64::from(n)).to_radians().sin_cos()).collect();
        graph.curve(start, Stroke::Outline, Hue::Muted);
        graph.curve(curve(60.0)?, Stroke::Orbit, Hue::Green);
        graph.curve(curve(moment.time)?, Stroke::Curve, Hue::Green);
        if let Some(time) = self.settled() {
            let parts = self.parts(time)?;
            graph.curve([parts, (1.0, parts.1)], Stroke::Dotted, Hue::Muted);
            let place = graph.at(parts);
            graph.drawing().circle(place, 4.5, Role::Line(Stroke::Outline, Hue::Ink));
            let percent = format!("{:.0} %", 100.0 * self.left(time)?);
            graph.label((1.0, parts.1), Side::Right, &(percent + moment.room.of(" left", "")), Hue::Muted)?;
        }
        let [from, to] = [graph.at((0.0, 0.0)), graph.at(self.parts(moment.time)?)];
        if (to - from).length() > 1.0 {
            kit::arrow(graph.drawing(), from, to, Hue::Green);
        }
        graph.grip(self.parts(0.0)?, Hue::Pink);
        Ok(())
    }
}

/// What stands at the end of a line of the map: so far from it that the body's dot does not cover it.
fn at_end(map: &mut Graph<'_>, value: (f64, f64), text: &str) -> Result<(), Cause> {
    let end = map.at(value);
    map.drawing().label_set(end, Side::Right, 8.0, 13.0, text, Role::Text(Hue::Muted))?;
    Ok(())
}

/// The map of fates.
fn map(room: Room) -> Plot<'static> {
    let frame = room.of(Rect::new(390.0, 34.0, 180.0, 150.0), Rect::new(44.0, 352.0, 90.0, 126.0));
    let y = Axis::log(DRAGS[0], DRAGS[1], 1).titled(r"$C_1/C_3$");
    Plot { frame, x: Axis::log(RATIOS[0], RATIOS[1], 1).titled(r"$I_3/I_1$"), y }
}

/// The plane of the angular momentum as the body has it.
fn parts(room: Room) -> Plot<'static> {
    let frame = room.of(Rect::new(390.0, 268.0, 150.0, 150.0), Rect::new(212.0, 376.0, 102.0, 102.0));
    let x = Axis::linear(0.0, 1.0, 0.5).titled(r"$\boldsymbol{L}$ across");
    Plot { frame, x, y: Axis::linear(0.0, 1.0, 0.5).titled(r"$\boldsymbol{L}$ along the axis") }
}

/// What has been added up of a quantity by each moment, by Simpson's rule over pairs of steps.
fn added_up(values: &[f64]) -> Vec<f64> {
    let mut sums = vec![0.0];
    let mut sum = 0.0;
    for [a, b, c] in values.windows(3).step_by(2).filter_map(|three| <[f64; 3]>::try_from(three).ok()) {
        sums.push(sum + STEP * (5.0 * a + 8.0 * b - c) / 12.0);
        sum += STEP * (a + 4.0 * b + c) / 3.0;
        sums.push(sum);
    }
    sums
}

impl Motion for Slowing {
    fn run(&self) -> Run {
        Run { duration: self.duration, pace: 1.0, repeats: false }
    }

    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        self.draw_body(moment, drawing)?;
        if moment.room == Room::Wide {
            let below = at(170.0, 458.0);
            drawing.label(below, Side::Over, "in the room, arrows at one length", Hue::Muted)?;
        }
        self.draw_map(moment.room, drawing)?;
        self.draw_parts(moment, drawing)
    }

    fn readings(&self, time: f64) -> Result<Vec<f64>, Cause> {
        let now = self.state(time)?;
        let momentum = now.angular_momentum_world(&self.top.moments());
        Ok(vec![
            100.0 * self.left(time)?,
            angle_between(&now.axis_3_world(), &momentum).to_degrees(),
            self.drag.transverse,
            self.drag.axial / self.ratio,
            self.top.total_body_turns() * (1.0 - self.left(time)?), // eq:wobble-phase
            self.unaccounted(time)?,
        ])
    }

    fn words(&self, _time: f64) -> String {
        let degrees = self.lean;
        let Some((time, left)) = self.settled().and_then(|time| Some((time, self.left(time).ok()?))) else {
            return match degrees {
                0.0 => "It turns exactly about its axis and keeps to it, whatever its shape and the air: \
                        there is no wobble that could grow or die."
                    .into(),
                90.0 => "It turns exactly across its axis, end over end, and keeps to that: it has no spin \
                         to lose."
                    .into(),
                _ => format!(
                    "Wobble and spin die together. The axis stays at {degrees}° to the angular momentum \
                     until nothing turns."
                ),
            };
        };
        let percent = 100.0 * left;
        let left = match percent {
            1.0.. => format!("{percent:.0} % of the spin"),
            0.01..1.0 => format!("only {percent:.2} % of the spin"),
            _ => "next to nothing of the spin".into(),
        };
        if self.top.axis_trend() == AxisTrend::Aligning {
            return format!(
                "The wobble dies first, and the body settles on its axis: when {time:.0} s have brought the \
                 wobble down to a tenth, {left} is left."
            );
        }
        let (across, along) = self.parts(time).unwrap_or_default();
        let end = across.atan2(along).to_degrees();
        format!(
            "The spin dies first, and the body ends up tumbling: when its axis has gone from {degrees}° to \
             {end:.0}° from the angular momentum, after {time:.0} s, {left} is left."
        )
    }

    fn grips(&self, moment: &Moment) -> Vec<Point> {
        let (sin, cos) = self.lean.to_radians().sin_cos();
        vec![map(moment.room).point((self.ratio, self.drag_ratio())), parts(moment.room).point((sin, cos))]
    }

    fn drag(&self, grip: usize, to: Point, moment: &Moment) -> Vec<(&'static str, f64)> {
        if grip == 0 {
            let (ratio, drag) = map(moment.room).value(to);
            return vec![("ratio", ratio), ("drag", drag)];
        }
        let (across, along) = parts(moment.room).value(to);
        vec![("lean", across.max(0.0).atan2(along.max(0.0)).to_degrees())]
    }
}
