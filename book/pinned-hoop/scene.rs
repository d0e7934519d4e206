//! The scene of the chapter "The pinned hoop": a hoop is caught by a point of its rim, and waits before it turns over.

use live::prelude::*;
use mechanics::attitude::angle_between;
use mechanics::free_rotation::FreeTop;
use mechanics::scenes::pinned_hoop::{Pin, Pinning, PinningParameters, Shape};
use nalgebra::{UnitQuaternion, Vector3};
use std::cell::OnceCell;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "pinned-hoop",
    title: "A hoop, pinned at its rim",
    description: "A hoop that is pinned at A, with the upright angular momentum. Beside it a sphere in the axes of the hoop with the path of the momentum on it, a pendulum, \
                  and the plane of the hoop at the moment of the snap, with A a degree from the place at a quarter of the circle. Below, a plot against that degree, with a \
                  dot that climbs as time goes on.",
    question: "The pin catches the hoop a degree from the place where the rim is fastest, and makes a door of it. What becomes of this door? And what changes if the pin is \
               ten times more accurate: 89°, 89.9°, 89.99°?",
    size: [[640.0, 505.0], [360.0, 594.0]],
    view: Some([-0.9, 0.3]),
    still: 15.0,
    controls: &[
        Control::log_slider("gap", r"how far the pin is from a right angle, $90° - \theta$", GAPS, "°", 1.0),
        Control::switch("exact", r"exactly at $\theta = 90°$", false),
        Control::choice("shape", "what is pinned", &["a hoop", "a disc", "a ball"]),
    ],
    presets: &[
        preset("30°", &[("gap", 60.0)]),
        preset("60°", &[("gap", 30.0)]),
        preset("80°", &[("gap", 10.0)]),
        preset("89°", &[("gap", 1.0)]),
        preset("89.9°", &[("gap", 0.1)]),
        preset("89.99°", &[("gap", 0.01)]),
        preset("a ball at 60°", &[("gap", 30.0), ("shape", 2.0)]),
    ],
    readings: &[
        reading(r"times $\omega_1$ has reversed", Form::Fixed(0), ""),
        reading(r"angle between tangent $\hat{\mathbf{1}}$ and $\boldsymbol{L}_A$", Form::Fixed(1), "°"),
        reading("energy that the snap took", Form::Fixed(1), "%"),
        reading(r"drift of the energy $T$", Form::Power(1), ""),
        reading(r"drift of $\boldsymbol{L}_A$ in the room", Form::Power(1), ""),
    ],
    symbols: formulas! {
        r"90° - \theta", r"\boldsymbol{L}_A", r"\hat{\mathbf{1}}", r"\boldsymbol{\omega}", r"A",
        r"\hat{\mathbf{3}}", r"-\hat{\mathbf{2}}", r"2\chi", r"\theta", r"\boldsymbol{\omega}_0"
    },
    start: |settings| Ok(Box::new(Pinned::new(settings)?)),
};

/// How far from a right angle the pin can be, degrees.
const GAPS: [f64; 2] = [1e-4, 90.0];
/// A hand cannot pin the drawn rim more exactly, degrees.
const BY_HAND: f64 = 0.1;
/// For how long the path of the centre stays, s.
const TRAIL: f64 = 7.0;
/// How many points half a path has.
const POINTS: u32 = 120;

/// A body of mass, radius and spin one, pinned so many degrees from a right angle.
fn pinned(shape: Shape, gap: f64) -> Result<Pinning, Cause> {
    // Sine and cosine of 90° − gap; near a right angle everything hangs on the small one.
    let (cos, sin) = gap.to_radians().sin_cos();
    let pin = if gap == 90.0 { Pin::Angle(0.0) } else { Pin::Point { from_axis: sin, height: cos } };
    Ok(Pinning::new(PinningParameters { shape, mass: 1.0, radius: 1.0, spin: 1.0, pin })?)
}

/// A body that was pinned at time zero.
struct Pinned {
    body: Pinning,
    shape: Shape,
    gap: f64,
    top: FreeTop,
    /// The room's upright lies along the angular momentum.
    upright: UnitQuaternion<f64>,
    /// The period of its pendulum; none if it never turns over.
    period: Option<f64>,
    /// The path of the direction of L in the body over a period.
    path: Vec<Vector3<f64>>,
    /// How long it waits, s, against the gap, degrees; and where a reader has measured that.
    waits: Vec<(f64, f64)>,
    measured: Vec<(f64, f64)>,
    /// What does not move of the picture of the sphere, on a page and on a phone, once it has been drawn.
    sphere: [OnceCell<Vec<Item>>; 2],
}

impl Pinned {
    fn new(settings: &Settings<'_>) -> Result<Self, Cause> {
        let shape = [Shape::Hoop, Shape::Disk, Shape::Sphere][settings.choice("shape")?.min(2)];
        let gap = if settings.is_on("exact")? { 0.0 } else { settings.of("gap")? };
        let body = pinned(shape, gap)?;
        let top = body.free_motion()?;
        let upright = UnitQuaternion::rotation_between(&body.angular_momentum(), &Vector3::z())
            .unwrap_or_else(|| UnitQuaternion::from_axis_angle(&Vector3::x_axis(), PI));
        let period = top.period();
        let moments = body.moments_about_pin();
        let path = times_of_path(period.unwrap_or(0.0))
            .map(|time| Ok(moments.angular_momentum(&top.at(time)?.omega_body).normalize()));
        let path = path.collect::<Result<Vec<_>, Cause>>()?;
        let mut waits = Vec::new();
        if shape != Shape::Sphere {
            for n in 0..=40 {
                let gap = GAPS[0] * (89.0 / GAPS[0]).powf(f64::from(n) / 40.0);
                waits.extend(wait(shape, gap)?.map(|wait| (gap, wait)));
            }
        }
        let (measured, sphere) = Default::default();
        Ok(Self { body, shape, gap, top, upright, period, path, waits, measured, sphere })
    }

    fn is_flat(&self) -> bool {
        self.shape != Shape::Sphere
    }

    fn theta(&self) -> f64 {
        90.0 - self.gap
    }
}

/// The time from the snap to the moment when the tangent is passed: a quarter of the period.
fn wait(shape: Shape, gap: f64) -> Result<Option<f64>, Cause> {
    Ok(pinned(shape, gap)?.free_motion()?.period().map(|period| 0.25 * period))
}

/// Moments of a period, the closer together the faster ω moves: about a quarter of it and three quarters.
fn times_of_path(period: f64) -> impl Iterator<Item = f64> {
    let quarter = 0.25 * period;
    // As in the motion next to a balance: exponential steps, of a quarter second or so in the middle.
    let steep = (quarter / 3.0).max(1.0).ln() * 1.3 + 0.01;
    (0..=2 * POINTS).map(move |n| {
        let (half, part) = (f64::from(n / POINTS), f64::from(n % POINTS) / f64::from(POINTS));
        quarter * (1.0 + (steep * (2.0 * part - 1.0)).sinh() / steep.sinh() + 2.0 * half)
    })
}

/// The pendulum: its middle and its length, px.
fn pendulum(room: Room) -> (Point, f64) {
    room.of((at(268.0, 416.0), 46.0), (at(170.0, 344.0), 38.0))
}

/// The plane of the hoop at the snap: its centre and radius, px.
fn plane(room: Room) -> (Point, f64) {
    room.of((at(82.0, 420.0), 46.0), (at(56.0, 350.0), 36.0))
}

/// How long it waits, against how far the pin is from a right angle.
fn plot(room: Room, shape: Shape) -> Plot<'static> {
    let frame = room.of(Rect::new(412.0, 325.0, 200.0, 130.0), Rect::new(42.0, 460.0, 290.0, 88.0));
    let x = Axis::log(GAPS[0], 100.0, 2).titled(r"$90° - \theta$, degrees");
    let most = if shape == Shape::Disk { 90.0 } else { 60.0 };
    Plot { frame, x, y: Axis::linear(0.0, most, 0.5 * most).titled("wait, s") }
}

impl Pinned {
    /// The body in the room, with the pin in the origin.
    fn draw_body(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let (centre, scale) = moment.room.of((at(175.0, 165.0), 78.0), (at(180.0, 146.0), 66.0));
        let mut stage = Stage::new(moment.camera([0.0; 3], 12.0, centre, scale)?);
        let now = self.top.at(moment.time)?;
        let room = self.upright * now.world_from_body;
        let (centre, normal) = (room * self.body.centre(), room * Vector3::z());
        let solid = match self.shape {
            Shape::Hoop => Solid::ring(centre, normal, 1.0, 0.87, 0.12)?,
            Shape::Disk => Solid::disc(centre, normal, 1.0, 0.06)?,
            Shape::Sphere => Solid::sphere(centre, 1.0)?,
        };
        stage.solid(solid, Hue::Blue)?;
        let begin = (moment.time - TRAIL).max(0.0);
        let path = linear_steps(begin, moment.time, 40)
            .map(|time| Ok(self.upright * (self.top.at(time)?.world_from_body * self.body.centre())))
            .collect::<Result<Vec<Vector3<f64>>, Cause>>()?;
        if moment.time > 0.0 && self.gap < GAPS[1] {
            stage.curve(Curve::smooth(path)?.hiding(Hiding::Pale), Stroke::Curve, Hue::Blue)?;
        }
        stage.dot_in_front(centre, 3.0, Hue::Blue)?;
        let omega = room * now.omega_body;
        let rate = self.body.omega_after().norm();
        let side =
            |tip: Vector3<f64>, least| if moment.rightward(tip) > least { Side::Right } else { Side::Left };
        let (tangent, omega) = (room * Vector3::x() * 1.45, omega * (1.1 / rate));
        let arrows = [
            (Vector3::z() * 1.8, Side::Above, r"$\boldsymbol{L}_A$", Hue::Green),
            (tangent, side(tangent, 0.25), r"$\hat{\mathbf{1}}$", Hue::Ink),
            (omega, side(omega, -0.25), r"$\boldsymbol{\omega}$", Hue::Orange),
        ];
        for (tip, side, name, hue) in arrows {
            let arrow = Curve::segment([0.0; 3], tip)?.hiding(Hiding::Ignored);
            stage.arrow(arrow, Stroke::Vector, Heads::End, hue)?;
            stage.label(tip, side, name, hue)?;
        }
        stage.dot_in_front([0.0; 3], 5.0, Hue::Pink)?;
        stage.label_shifted([0.0; 3], at(0.0, 4.0), Side::BelowLeft, r"$A$", Hue::Pink)?;
        stage.write(drawing);
        Ok(())
    }

    /// L in the body, on the sphere of its length. But for the dot nothing in it moves.
    fn draw_sphere(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let cell = moment.room.of(&self.sphere[0], &self.sphere[1]);
        if cell.get().is_none() {
            let _ = cell.set(self.still_sphere(moment)?);
        }
        let mut over = Self::sphere_alone(moment)?;
        let omega = self.top.at(moment.time)?.omega_body;
        let direction = self.body.moments_about_pin().angular_momentum(&omega).normalize();
        over.dot(direction, moment.room.of(5.0, 4.5), Hue::Green)?;
        let mut dotted = Drawing::new("", 0.0, 0.0);
        over.write(&mut dotted);
        let dot = dotted.items().last();
        for Item { role, shape, .. } in cell.get().into_iter().flatten().chain(dot) {
            drawing.push(*role, shape.clone());
        }
        Ok(())
    }

    fn sphere_alone(moment: &Moment) -> Result<Stage, Cause> {
        let (centre, scale) = moment.room.of((at(498.0, 140.0), 88.0), (at(294.0, 338.0), 42.0));
        let mut stage = Stage::new(moment.seen_from(-1.0, 0.3).camera([0.0; 3], 8.0, centre, scale)?);
        stage.solid(Solid::sphere([0.0; 3], 1.0)?, Hue::Blue)?;
        Ok(stage)
    }

    fn still_sphere(&self, moment: &Moment) -> Result<Vec<Item>, Cause> {
        let (mut stage, room) = (Self::sphere_alone(moment)?, moment.room);
        if self.is_flat() {
            // The separatrix: L² = 2T I₁, two great circles through axis 1.
            let [i1, i2, i3] = self.body.moments_about_pin().to_array();
            let slope = (i3 * (i1 - i2) / (i2 * (i3 - i1))).sqrt();
            let across = (1.0 + slope * slope).sqrt().recip();
            for slope in [slope, -slope] {
                let point = |angle: f64| [angle.cos(), across * angle.sin(), slope * across * angle.sin()];
                let border = Curve::smooth(linear_steps(0.0, TAU, 120).map(point))?.hiding(Hiding::Omitted);
                stage.curve(border, Stroke::Border, Hue::Ink)?;
            }
        }
        if self.path.iter().any(|direction| (direction - self.path[0]).norm() > 1e-3) {
            stage.curve(Curve::smooth(self.path.iter().copied())?, Stroke::Curve, Hue::Green)?;
        }
        for (direction, name) in
            [(Vector3::x(), r"$\hat{\mathbf{1}}$"), (Vector3::z(), r"$\hat{\mathbf{3}}$")]
        {
            stage.named_vector(direction, direction * room.of(1.3, 1.35), name, Hue::Ink)?;
        }
        stage.dot(-Vector3::y(), 2.5, Hue::Ink)?;
        let name = r"$-\hat{\mathbf{2}}$";
        stage.label_shifted(-Vector3::y(), at(0.0, 2.0), Side::BelowRight, name, Hue::Ink)?;
        let mut drawing = Drawing::new("", 0.0, 0.0);
        stage.write(&mut drawing);
        let below = room.of(at(498.0, 262.0), at(294.0, 406.0));
        drawing.label(below, Side::Over, r"$\boldsymbol{L}_A$ in the body", Hue::Green)?;
        Ok(drawing.items().to_vec())
    }

    /// The pendulum inside a flat body: 2χ from its upright balance (eq:hoop-pendulum).
    fn draw_pendulum(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let (middle, length) = pendulum(moment.room);
        let below = middle + at(0.0, length + moment.room.of(26.0, 24.0));
        if !self.is_flat() {
            drawing.label(middle, Side::Over, "no pendulum", Hue::Muted)?;
            return Ok(());
        }
        let angle = |omega: &Vector3<f64>| 2.0 * (-omega.y).atan2(omega.x);
        let place = |angle: f64| middle + Point::polar(length, FRAC_PI_2 - angle);
        let (start, now) = (angle(&self.body.omega_after()), angle(&self.top.at(moment.time)?.omega_body));
        drawing.line(middle - at(0.0, length + 10.0), middle, Stroke::Reference, Hue::Muted);
        let swing = -(TAU - 2.0 * start);
        if swing < -0.98 * TAU {
            drawing.circle(middle, length, Role::Line(Stroke::Orbit, Hue::Orange));
        } else if swing < -1e-3 {
            drawing.arc(middle, length, FRAC_PI_2 - start, swing, Stroke::Orbit, Hue::Orange);
        }
        drawing.line(middle, place(now), Stroke::Vector, Hue::Ink);
        if now > 0.3 {
            kit::angle(drawing, middle, 0.45 * length, FRAC_PI_2, -now, Heads::End, Hue::Ink);
        }
        drawing.dot(middle, 3.0, Hue::Ink);
        drawing.disc(place(now), moment.room.of(8.0, 7.0), Hue::Orange);
        drawing.dot(place(start), 3.5, Hue::Pink);
        drawing.label(below, Side::Over, r"pendulum, $2\chi$", Hue::Muted)?;
        Ok(())
    }

    /// The plane of the hoop at the snap.
    fn draw_plane(&self, room: Room, drawing: &mut Drawing) -> Result<(), Cause> {
        let (centre, radius) = plane(room);
        let theta = self.theta().to_radians();
        drawing.disc(centre, radius, Hue::Blue);
        if self.shape == Shape::Hoop {
            drawing.circle(centre, radius - 6.0, Role::Area(Fill::Page, Hue::Blue));
            drawing.circle(centre, radius - 6.0, Role::Line(Stroke::Outline, Hue::Blue));
        }
        let up = at(0.0, radius + 6.0);
        drawing.line(centre - up, centre + up, Stroke::Reference, Hue::Muted);
        let pin = self.pin(room);
        drawing.line(centre, pin, Stroke::Outline, Hue::Muted);
        if theta > 0.3 {
            kit::angle(drawing, centre, 0.4 * radius, FRAC_PI_2, -theta, Heads::End, Hue::Ink);
            let middle = centre + Point::polar(0.4 * radius, FRAC_PI_2 - 0.5 * theta);
            drawing.label_set(middle, Side::AboveRight, 1.0, 13.0, r"$\theta$", Role::PlainText(Hue::Ink))?;
        }
        // The axes at A: 2 to the centre, 1 along the tangent.
        let (first, second) = (Point::polar(1.0, PI - theta), Point::polar(1.0, -FRAC_PI_2 - theta));
        let long = 1.4 * radius;
        let omega = self.body.omega_after();
        let omega = (first * omega.x + second * omega.y) * long;
        let top = centre - at(0.0, radius);
        kit::arrow(drawing, top, top - at(0.0, 0.62 * long), Hue::Orange);
        drawing.label(top - at(0.0, 0.5 * long), Side::Left, r"$\boldsymbol{\omega}_0$", Hue::Orange)?;
        kit::arrow(drawing, pin, pin + omega, Hue::Orange);
        drawing.label(pin + omega, Side::Right, r"$\boldsymbol{\omega}$", Hue::Orange)?;
        kit::grip(drawing, pin, Hue::Pink);
        drawing.label(pin + at(1.0, 8.0), Side::Right, r"$A$", Hue::Pink)?;
        let below = centre + at(0.0, radius + room.of(20.0, 18.0));
        drawing.label(below, Side::Over, "the snap", Hue::Muted)?;
        Ok(())
    }

    /// Where A is drawn in the plane of the hoop.
    fn pin(&self, room: Room) -> Point {
        let (centre, radius) = plane(room);
        centre + Point::polar(radius, self.gap.to_radians())
    }

    /// How long it has waited; and once it has turned over, how long it would have waited elsewhere.
    fn draw_waits(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let mut graph = plot(moment.room, self.shape).on(drawing)?;
        if !self.is_flat() {
            graph.label((0.1, 30.0), Side::Over, "it never turns over", Hue::Muted)?;
            return Ok(());
        }
        if self.has_turned(moment.time) {
            graph.curve(self.waits.iter().copied(), Stroke::Curve, Hue::Blue);
            for (gap, name) in [(10.0, "80°"), (1.0, "89°"), (0.1, "89.9°"), (0.01, "89.99°")] {
                let place = (gap, wait(self.shape, gap)?.unwrap_or_default());
                graph.dot(place, 3.0, Hue::Blue);
                let (place, blue) = (graph.at(place), Role::Text(Hue::Blue));
                graph.drawing().label_set(place, Side::AboveRight, 8.0, 13.0, name, blue)?;
            }
        }
        for &place in &self.measured {
            graph.dot(place, 3.5, Hue::Pink);
        }
        if self.gap > 0.0 {
            graph.grip(self.on_plot(moment.time), Hue::Pink);
        }
        Ok(())
    }

    /// Where the pin stands in the plot: it climbs as long as the body waits.
    fn on_plot(&self, time: f64) -> (f64, f64) {
        (self.gap, self.period.map_or(0.0, |period| time.min(0.25 * period)))
    }

    /// Whether it has turned over by then, as the pendulum has passed its rest.
    fn has_turned(&self, time: f64) -> bool {
        self.period.is_some_and(|period| time >= 0.25 * period)
    }
}

impl Motion for Pinned {
    fn run(&self) -> Run {
        let duration =
            self.period.filter(|_| self.is_flat()).map_or(44.0, |period| (1.25 * period).clamp(24.0, 400.0));
        Run { duration, pace: 3.0, repeats: false }
    }

    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        self.draw_body(moment, drawing)?;
        self.draw_sphere(moment, drawing)?;
        self.draw_plane(moment.room, drawing)?;
        self.draw_pendulum(moment, drawing)?;
        self.draw_waits(moment, drawing)
    }

    fn readings(&self, time: f64) -> Result<Vec<f64>, Cause> {
        let now = self.top.at(time)?;
        let moments = self.body.moments_about_pin();
        let energy = |omega: &Vector3<f64>| moments.kinetic_energy(omega);
        let momentum = now.angular_momentum_world(&moments);
        let start = self.body.angular_momentum();
        let turned = match self.period {
            Some(period) if self.is_flat() => (2.0 * time / period + 0.5).floor(),
            _ => 0.0,
        };
        let taken = self.body.energy_lost();
        Ok(vec![
            turned,
            angle_between(&(now.world_from_body * Vector3::x()), &momentum).to_degrees(),
            100.0 * taken / (taken + energy(&self.body.omega_after())),
            energy(&now.omega_body) / energy(&self.body.omega_after()) - 1.0,
            (momentum - start).norm() / start.norm(),
        ])
    }

    fn words(&self, time: f64) -> String {
        let theta = self.theta();
        if self.gap == GAPS[1] {
            return "A lies on the axis and was at rest: the body turns on as if nothing had happened."
                .into();
        }
        if !self.is_flat() {
            let rate = self.body.angular_momentum().norm() / self.body.moments_about_pin().to_array()[0];
            return format!(
                "A ball has two equal moments about A, so no axis is a middle one, and it never turns over: \
                 its centre goes round the angular momentum once in {:.0} s.",
                TAU / rate
            );
        }
        let (Some(period), Ok(Some(nearer))) = (self.period, wait(self.shape, 0.1 * self.gap)) else {
            return "Exactly at 90° it turns about the tangent, its middle axis, for ever: the pendulum \
                    stands on its head. No pin is that exact."
                .into();
        };
        let wait = 0.25 * period;
        let digits = (2.0 - self.gap.log10().floor()).clamp(0.0, 6.0) as usize;
        let shown = format!("{theta:.digits$}");
        let shown = shown.trim_end_matches('0').trim_end_matches('.');
        if self.gap > 30.0 {
            return format!(
                "Pinned at {shown}°, it turns nearly about its diameter through A and only nods, once in \
                 {:.1} s.",
                0.5 * period
            );
        }
        if !self.has_turned(time) {
            return format!(
                "Pinned at {shown}°, it is a door, with the tangent at A for a hinge. For how long? Let it run."
            );
        }
        format!(
            "Pinned at {shown}°, it turns over after {wait:.1} s and then every {:.1} s. Ten times as near \
             to 90° it would wait {:.1} s longer: each tenfold growth of the tilt of its pendulum takes as \
             long as the last.",
            0.5 * period,
            nearer - wait
        )
    }

    /// The body, the gap and the wait, if it has turned over meanwhile.
    fn found(&self, from: f64, to: f64) -> Option<[f64; 3]> {
        let wait = self.period.filter(|_| self.is_flat()).map(|period| 0.25 * period);
        wait.filter(|wait| from < *wait && *wait <= to)
            .map(|wait| [f64::from(self.shape as u8), self.gap, wait])
    }

    fn keep(&mut self, found: &[[f64; 3]]) {
        let own = f64::from(self.shape as u8);
        let of_own = found.iter().filter(|[shape, ..]| *shape == own);
        self.measured = of_own.map(|&[_, gap, wait]| (gap, wait)).collect();
    }

    fn grips(&self, moment: &Moment) -> Vec<Point> {
        let mut grips = vec![self.pin(moment.room)];
        if self.is_flat() && self.gap > 0.0 {
            grips.push(plot(moment.room, self.shape).point(self.on_plot(moment.time)));
        }
        grips
    }

    fn drag(&self, grip: usize, to: Point, moment: &Moment) -> Vec<(&'static str, f64)> {
        let stands = self.grips(moment).get(grip).is_some_and(|stands| (to - *stands).length() < 0.01);
        if stands {
            return Vec::new();
        }
        let gap = if grip == 0 {
            let aside = to - plane(moment.room).0;
            (-aside.y).atan2(aside.x.abs()).to_degrees().max(BY_HAND)
        } else {
            plot(moment.room, self.shape).value(to).0
        };
        vec![("gap", gap), ("exact", 0.0)]
    }
}
