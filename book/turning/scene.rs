//! The scene of the chapter "How a body turns": a plate is thrown, and its wobbles are counted.

use live::prelude::*;
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeSymmetricTop;
use mechanics::inertia::PrincipalMoments;
use nalgebra::{UnitQuaternion, Vector3};

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "turning",
    title: "A wobbling plate",
    description: "A flat round plate in the air above a floor, leaning, with a stripe painted from its middle to its rim. The angular momentum L points straight up; the \
                  axis of the plate and the angular velocity omega lean away from it on opposite sides, each on a circle. Beside it the plane of the three arrows. Below, \
                  the swings of the axis to the right and to the left against time, with a line at each passage of the stripe.",
    question: "While the plate turns once, how often does its axis swing to the right and back? And when it has grown into a long can?",
    size: [[640.0, 480.0], [380.0, 436.0]],
    view: Some([-1.35, 0.36]),
    still: 0.0,
    controls: &[
        Control::slider("spin", r"spin about the axis, $\omega_3$", [0.0, MOST, 0.1], "rad/s", 10.0),
        Control::slider("across", r"spin about a diameter, $\omega_1$", [0.0, MOST, 0.1], "rad/s", 4.0),
        Control::slider("ratio", r"ratio of the moments, $I_3/I_1$", [0.02, 2.0, 0.01], "", 2.0),
        Control::choice("shape", "body", &["a cylinder", "a spheroid"]),
        Control::choice("camera", "camera", &["in the room", "on the body"]),
        Control::switch("cones", "rolling cones", false),
    ],
    presets: &[
        preset("a careless throw", &[]),
        preset("a careful one", &[("across", 1.0)]),
        preset("a wild one", &[("across", 12.0)]),
        preset("its cones", &[("cones", 1.0)]),
        preset("a ball", &[("ratio", 1.0), ("shape", 1.0)]),
        preset("a can like a ball", &[("ratio", 1.0)]),
        preset("a pencil", &[("ratio", 0.02), ("across", 3.0)]),
    ],
    readings: &[
        reading("wobbles", Form::Fixed(2), ""),
        reading("turns about its axis", Form::Fixed(2), ""),
        reading(r"wobbles a turn, $\Lambda/\omega_3$", Form::Fixed(2), ""),
        reading(r"angle of axis and $\boldsymbol{L}$", Form::Fixed(1), "°"),
        reading(r"angle of axis and $\boldsymbol{\omega}$", Form::Fixed(1), "°"),
        reading(r"drift of $\boldsymbol{L}$", Form::Power(1), ""),
        reading(r"drift of the energy $T$", Form::Power(1), ""),
    ],
    symbols: formulas! {
        r"\boldsymbol{L}", r"\boldsymbol{\omega}", r"\hat{\mathbf{3}}", r"\boldsymbol{L}/I_1",
        r"-\sigma\,\hat{\mathbf{3}}", r"\omega_1"
    },
    start: |settings| Ok(Box::new(Throw::new(settings)?)),
};

/// The greatest spin, rad/s.
const MOST: f64 = 15.0;
/// How long a throw is watched, s, and how slowly: seconds of it in a second of the reader.
const DURATION: f64 = 4.0;
const PACE: f64 = 0.25;
/// Lengths of the arrows in the room, in sizes of the body.
const LENGTHS: [f64; 3] = [1.85, 1.6, 1.3];
/// How long the cones are along their sides.
const SIDE: f64 = 1.4;
/// Points of a curve for a wobble.
const POINTS: f64 = 40.0;

/// A body with an axis of symmetry in the air. Its moment about a diameter is 1 kg·m².
struct Throw {
    top: FreeSymmetricTop,
    ratio: f64,
    is_round: bool,
    on_board: bool,
    with_cones: bool,
}

impl Throw {
    /// The angular momentum stands upright; the axis leans to the right at first.
    fn new(settings: &Settings<'_>) -> Result<Self, Cause> {
        let ratio = settings.of("ratio")?;
        let moments = PrincipalMoments::symmetric(1.0, ratio)?;
        let omega_body = Vector3::new(settings.of("across")?, 0.0, settings.of("spin")?);
        let momentum = moments.angular_momentum(&omega_body);
        let upright = UnitQuaternion::rotation_between(&momentum, &Vector3::z()).unwrap_or_default();
        let to_the_right = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), PI + 0.35);
        let world_from_body = to_the_right * upright;
        let top = FreeSymmetricTop::new(moments, Turning { world_from_body, omega_body })?;
        let [is_round, on_board] = [settings.choice("shape")? == 1, settings.choice("camera")? == 1];
        Ok(Self { top, ratio, is_round, on_board, with_cones: settings.is_on("cones")? })
    }

    /// Spin about a diameter and about the axis, rad/s.
    fn rates(&self) -> [f64; 2] {
        let omega = self.top.start().omega_body;
        [omega.x, omega.z]
    }

    /// Wobbles in a turn about the axis.
    fn wobbles_a_turn(&self) -> f64 {
        self.top.precession_rate() / self.rates()[1]
    }

    /// Radius and half the height of the body, which fits into a sphere of radius 1.05.
    fn form(&self) -> [f64; 2] {
        let [flat, height] = [2.0 / self.ratio - 1.0, 0.05];
        if self.is_round {
            // I₃/I₁ = 2/(1 + c²) of a spheroid with the axes 1, 1, c
            let polar = flat.sqrt().max(height);
            let radius = 1.05 / polar.max(1.0);
            [radius, radius * polar]
        } else {
            // I₃/I₁ = 2/(1 + h²/3) of a cylinder of radius 1 and height h
            let half = (0.5 * (3.0 * flat).sqrt()).max(0.5 * height);
            let radius = 1.05 / half.hypot(1.0);
            [radius, radius * half]
        }
    }

    /// The stripe from the middle of the upper face over the rim, in the half plane at an angle about the axis.
    fn stripe(&self, angle: f64) -> Vec<Vector3<f64>> {
        let [radius, half] = self.form();
        let (sin, cos) = angle.sin_cos();
        let place = |[out, up]: [f64; 2]| Vector3::new(-cos * out, -sin * out, up);
        if self.is_round {
            let angles = linear_steps(0.0, PI, 24).map(f64::sin_cos);
            angles.map(|(s, c)| place([radius * s, half * c])).collect()
        } else {
            [[0.0, half], [radius, half], [radius, -half], [0.0, -half]].map(place).to_vec()
        }
    }

    /// The arrows L, ω and 3̂ as the camera has them, at the lengths at which they are drawn; those that are there.
    fn arrows(&self, now: &Turning) -> Vec<(Vector3<f64>, Hue)> {
        let body_from_world = now.world_from_body.inverse();
        let momentum = body_from_world * self.top.angular_momentum_world();
        let found = [(momentum, Hue::Green), (now.omega_body, Hue::Orange), (Vector3::z(), Hue::Ink)];
        let arrows = found.into_iter().zip(LENGTHS);
        let arrows =
            arrows.filter_map(|((vector, hue), length)| Some((vector.try_normalize(1e-12)? * length, hue)));
        let seen = |vector| if self.on_board { vector } else { now.world_from_body * vector };
        arrows.map(|(vector, hue)| (seen(vector), hue)).collect()
    }

    fn draw_body(&self, stage: &mut Stage, now: &Turning) -> Result<(), Flaw> {
        let seen = if self.on_board { UnitQuaternion::identity() } else { now.world_from_body };
        let [radius, half] = self.form();
        let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| seen * axis);
        let solid = if self.is_round {
            Solid::ellipsoid([0.0; 3], [x, y, z], [radius, radius, half])?
        } else {
            Solid::disc([0.0; 3], z, radius, 2.0 * half)?
        };
        if self.with_cones {
            return stage.solid(solid.finish(Finish::Ghost), Hue::Blue);
        }
        stage.solid(solid, Hue::Blue)?;
        for quarter in 0..4 {
            let (stroke, hue) =
                if quarter == 0 { (Stroke::Curve, Hue::Pink) } else { (Stroke::Outline, Hue::Blue) };
            let points = self.stripe(f64::from(quarter) * FRAC_PI_2);
            let points: Vec<_> = points.into_iter().map(|point| seen * point).collect();
            if self.is_round {
                stage.curve(Curve::smooth(points)?.hiding(Hiding::Omitted), stroke, hue)?;
            } else {
                for ends in points.windows(2) {
                    stage.curve(Curve::segment(ends[0], ends[1])?.hiding(Hiding::Omitted), stroke, hue)?;
                }
            }
        }
        Ok(())
    }

    /// The cone that ω draws in the body and the one that it draws in the room, which touch along ω.
    fn draw_cones(&self, stage: &mut Stage, arrows: &[(Vector3<f64>, Hue)]) -> Result<(), Flaw> {
        let [(momentum, _), (omega, _), (axis, _)] = arrows else { return Ok(()) };
        let [in_body, in_room] =
            [self.top.omega_angle(), (self.top.omega_angle() - self.top.momentum_angle()).abs()];
        let can_be_drawn = |angle: &f64| (0.01..FRAC_PI_2 - 0.01).contains(angle);
        if can_be_drawn(&in_room) {
            stage.solid(Solid::cone([0.0; 3], *momentum, in_room, SIDE)?, Hue::Green)?;
        }
        if can_be_drawn(&in_body) {
            let cone = Solid::cone([0.0; 3], *axis, in_body, SIDE)?;
            stage.solid(if self.ratio > 1.0 { cone.finish(Finish::Glass) } else { cone }, Hue::Blue)?;
        }
        let contact = Curve::segment([0.0; 3], omega.normalize() * SIDE)?.hiding(Hiding::Ignored);
        stage.curve(contact, Stroke::Curve, Hue::Orange)
    }

    /// The body and its arrows in the room or as it sees them.
    fn draw_room(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let now = self.top.at(moment.time)?;
        let (centre, scale) = moment.room.of((at(205.0, 182.0), 97.0), (at(116.0, 148.0), 63.0));
        let mut stage = Stage::new(moment.camera([0.0, 0.0, 0.35], 8.0, centre, scale)?);
        if !self.on_board {
            stage.ground([-1.2, -0.9], [1.2, 0.9], -1.1, 0.3)?;
        }
        self.draw_body(&mut stage, &now)?;
        let arrows = self.arrows(&now);
        if self.with_cones {
            self.draw_cones(&mut stage, &arrows)?;
        }
        let upright = if self.on_board { Hue::Ink } else { Hue::Green };
        for &(arrow, hue) in arrows.iter().filter(|(_, hue)| *hue != upright) {
            let radius = arrow.x.hypot(arrow.y);
            if radius > 0.02 {
                let circle = Curve::circle([0.0, 0.0, arrow.z], Vector3::z(), radius)?;
                stage.curve(circle.hiding(Hiding::Omitted), Stroke::Outline, hue)?;
            }
        }
        // The upright one has its name beyond its tip, those that go round it on the outside of their circles.
        for (arrow, hue) in arrows {
            let line = Curve::segment([0.0; 3], arrow)?;
            let line = if self.with_cones { line.hiding(Hiding::Ignored) } else { line };
            stage.arrow(line, Stroke::Vector, Heads::End, hue)?;
            let name = match hue {
                Hue::Green => r"$\boldsymbol{L}$",
                Hue::Orange => r"$\boldsymbol{\omega}$",
                _ => r"$\hat{\mathbf{3}}$",
            };
            if hue == upright {
                stage.named_vector(arrow * 0.99, arrow, name, hue)?;
            } else {
                let middle = stage.camera().on_page(Vector3::z() * arrow.z)?;
                let way = stage.camera().on_page(arrow)? - middle;
                let aside = if way.length() > 1.0 { way.unit() * 13.0 } else { at(13.0, 0.0) };
                stage.label_shifted(arrow, aside, Side::Over, name, hue)?;
            }
        }
        stage.write(drawing);
        Ok(())
    }

    /// The plane of the three arrows, which goes along with the body: ω and L/I₁, whose length is Λ.
    fn draw_plane(&self, room: Room, drawing: &mut Drawing) -> Result<(), Cause> {
        let [across, spin] = self.rates();
        let plane = plane(room);
        let mut graph = plane.on(drawing)?;
        let [origin, omega, momentum] =
            [(0.0, 0.0), (across, spin), (across, self.ratio * spin)].map(|values| graph.at(values));
        let drawing = graph.drawing();
        drawing.line(momentum, omega, Stroke::Reference, Hue::Orange);
        for (tip, hue) in [(momentum, Hue::Green), (omega, Hue::Orange)] {
            if (tip - origin).length() > 1.0 {
                kit::arrow(drawing, origin, tip, hue);
            }
            kit::grip(drawing, tip, hue);
        }
        // Names to the right of the tips, those of near tips moved apart, and none on the axis below.
        let gap = momentum.y - omega.y;
        let apart = 0.5 * (26.0 - gap.abs()).max(0.0) * if gap > 0.0 { 1.0 } else { -1.0 };
        let above_axis = (12.0 - (plane.frame.bottom - momentum.y.max(omega.y) - apart.abs())).max(0.0);
        for (tip, aside, text, hue) in [
            (momentum, apart, r"$\boldsymbol{L}/I_1$", Hue::Green),
            (omega, -apart, r"$\boldsymbol{\omega}$", Hue::Orange),
        ] {
            let beside = tip + at(0.0, aside - above_axis);
            drawing.label_set(beside, Side::Right, 11.0, 14.0, text, Role::Text(hue))?;
        }
        if gap.abs() > 56.0 {
            let middle = momentum.towards(omega, 0.5);
            drawing.label(middle, Side::Right, r"$-\sigma\,\hat{\mathbf{3}}$", Hue::Orange)?;
        }
        Ok(())
    }

    /// How far the axis is to the right, and when the stripe has gone round once more.
    fn draw_swing(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let window = moment.room.of(DURATION, 0.5 * DURATION);
        let from = window * (moment.time / window).floor().clamp(0.0, DURATION / window - 1.0);
        let frame = moment.room.of(Rect::new(40.0, 394.0, 580.0, 44.0), Rect::new(40.0, 346.0, 322.0, 44.0));
        let time = Axis::linear(from, from + window, 0.5).titled("time, s");
        let mut graph = Graph::new(drawing, frame, time, Axis::linear(-1.0, 1.0, 2.0))?;
        let [_, spin] = self.rates();
        let is_turning = spin > 0.0;
        if is_turning {
            let turn = TAU / spin;
            for k in (from / turn).ceil() as u32..=((from + window) / turn).floor() as u32 {
                graph.upright(f64::from(k) * turn, Stroke::Curve, Hue::Pink);
            }
        }
        let lean = self.top.momentum_angle().sin();
        let aside = |time: f64| Ok::<_, Cause>(self.top.axis_world(time)?.x / lean.max(1e-12));
        if lean > 1e-9 {
            let count = (POINTS * (window * self.top.precession_rate() / TAU).max(1.0)).ceil();
            let values = linear_steps(from, from + window, count as u32);
            let values = values.map(|time| Ok((time, aside(time)?))).collect::<Result<Vec<_>, Cause>>()?;
            graph.curve(values, Stroke::Curve, Hue::Ink);
        } else {
            graph.level(0.0, Stroke::Curve, Hue::Ink);
        }
        let now = if lean > 1e-9 { aside(moment.time)? } else { 0.0 };
        graph.dot((moment.time, now), 4.5, Hue::Ink);
        let above = frame.top - 14.0;
        let swings = "the axis swings right and left: wobbles";
        drawing.note(at(frame.left, above), Side::Right, swings, Hue::Ink)?;
        if is_turning {
            let turns = moment.room.of("a line for each turn about the axis", "turns");
            drawing.note(at(frame.right, above), Side::Left, turns, Hue::Pink)?;
        }
        Ok(())
    }
}

/// The plane of the arrows: its frame on the page, spin about a diameter to the right and about the axis upwards.
fn plane(room: Room) -> Plot<'static> {
    let frame = room.of(Rect::new(450.0, 40.0, 130.0, 260.0), Rect::new(272.0, 84.0, 64.0, 128.0));
    let x = Axis::linear(0.0, MOST, 5.0).titled(r"$\omega_1$, rad/s");
    Plot { frame, x, y: Axis::linear(0.0, 2.0 * MOST, 10.0).titled(r"along $\hat{\mathbf{3}}$, rad/s") }
}

impl Motion for Throw {
    fn run(&self) -> Run {
        Run { duration: DURATION, pace: PACE, repeats: true }
    }

    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        self.draw_room(moment, drawing)?;
        self.draw_plane(moment.room, drawing)?;
        self.draw_swing(moment, drawing)
    }

    fn readings(&self, time: f64) -> Result<Vec<f64>, Cause> {
        let now = self.top.at(time)?;
        let [across, spin] = self.rates();
        // From the attitude and ω of this moment, against the start.
        let (start, momentum) =
            (self.top.angular_momentum_world(), now.angular_momentum_world(&self.top.moments()));
        let energy = 0.5 * now.omega_world().dot(&momentum);
        let drift = |now: f64, start: f64| if start > 0.0 { now / start } else { 0.0 };
        let wobbles = if across > 0.0 { self.top.precession_rate() * time / TAU } else { f64::NAN };
        Ok(vec![
            wobbles,
            spin * time / TAU,
            if spin > 0.0 && across > 0.0 { self.wobbles_a_turn() } else { f64::NAN },
            self.top.momentum_angle().to_degrees(),
            self.top.omega_angle().to_degrees(),
            drift((momentum - start).norm(), start.norm()),
            drift(energy - self.top.kinetic_energy(), self.top.kinetic_energy()),
        ])
    }

    fn words(&self, _time: f64) -> String {
        let [across, spin] = self.rates();
        let rate = self.top.precession_rate();
        if rate == 0.0 {
            return "Nothing turns. Give it a spin about its axis, and a little about a diameter.".into();
        }
        if across == 0.0 {
            return "A perfect throw: axis, ω and L are one line, and there is nothing to wobble.".into();
        }
        let period = TAU / rate;
        if spin == 0.0 {
            return format!(
                "No spin about its axis, so no turns to count: it tumbles about a diameter, once every \
                 {period:.2} s, whatever I₃/I₁ is. Here too ω and L are one line."
            );
        }
        let count = self.wobbles_a_turn();
        let mut words = format!(
            "The axis goes round {count:.2} times while the body turns once about it: a wobble every \
             {period:.2} s. "
        );
        words += &match self.ratio {
            1.0 => "All moments are equal, so L lies along ω and stands still with it: it turns about \
                    one fixed line, as a ball does, whatever it looks like."
                .into(),
            2.0 => {
                let more = if count > 2.1 { ", and more when it leans as far as this" } else { "" };
                format!(
                    "For a flat body L/I₁ reaches twice as high along the axis as ω does, and its length \
                     is the rate of the wobbles: two to one{more}. L lies between the axis and ω."
                )
            }
            ratio if ratio > 1.0 => format!(
                "L/I₁ reaches {ratio:.2} times as high along the axis as ω does, and lies between \
                 the axis and ω: a flat body."
            ),
            ratio => format!(
                "L/I₁ reaches only {ratio:.2} times as high along the axis as ω does, and ω has come \
                 between the axis and L: a long body."
            ),
        };
        let on_board = TAU / self.top.body_rate();
        if self.on_board && on_board.is_finite() {
            let sense = if on_board > 0.0 { "forwards" } else { "backwards" };
            words += &format!(
                " Seen from the body, ω goes round the axis once every {:.2} s, {sense}.",
                on_board.abs()
            );
        }
        if self.with_cones && self.ratio != 1.0 {
            let place = if self.ratio > 1.0 {
                "like a hula hoop round the green one"
            } else {
                "on the outside of the green one"
            };
            let rims = rate / self.top.body_rate().abs();
            words += &format!(
                " The blue cone, fixed in the body, rolls {place}, fixed in the room. Its rim is \
                 {rims:.2} times as long."
            );
        }
        words
    }

    fn grips(&self, moment: &Moment) -> Vec<Point> {
        let [across, spin] = self.rates();
        [spin, self.ratio * spin].map(|along| plane(moment.room).point((across, along))).to_vec()
    }

    fn drag(&self, grip: usize, to: Point, moment: &Moment) -> Vec<(&'static str, f64)> {
        let (across, along) = plane(moment.room).value(to);
        match grip {
            0 => vec![("across", across), ("spin", along)],
            _ if self.rates()[1] > 0.0 => vec![("ratio", along / self.rates()[1])],
            _ => Vec::new(),
        }
    }
}
