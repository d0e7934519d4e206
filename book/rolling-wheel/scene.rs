//! The scene of the chapter "The rolling wheel": a wheel on its circle is kicked.

use live::prelude::*;
use mechanics::rolling::{MomentFactors, Rolling};
use nalgebra::{Complex, Vector3};
use rolled::{Course, GRAVITY, MASS, RADIUS, Rolled, WEIGHTS, is_flat};

#[path = "scene/closing.rs"]
pub(super) mod closing;
#[path = "scene/rolled.rs"]
mod rolled;
#[path = "scene/tongue.rs"]
pub(super) mod tongue;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "rolling-wheel",
    title: "A wheel on its circle, kicked",
    description: "A disc leans inward and rolls round on a table. Its contact leaves a track beside the circle on which it would roll undisturbed. Beside it a map of \
                  circles and leans, with a shaded tongue of unstable ones and a dot for this one, and the potential of the lean, in which a marble rolls below the level of \
                  the energy.",
    question: "A disc rolls round a small circle and is nudged. Is it safer nearly upright, or leaning well over? And why do the \
               circles shrink when something slows the disc?",
    size: [[660.0, 440.0], [380.0, 550.0]],
    view: Some([-1.3, 0.6]),
    still: 2.35,
    controls: &[
        Control::slider("circle", r"radius of the centre's circle, $b/a$", [-0.2, 4.0, 0.01], "", 1.0),
        Control::slider("lean", r"lean, $\theta$", [0.0, 60.0, 0.1], "°", 28.0),
        Control::slider("push", r"strength of the kick, $\dot\theta$", [-3.0, 3.0, 0.05], "rad/s", 1.0),
        Control { start: 0.0, ..Control::adding("kick", "Kick", &["push"]) },
        Control::KEEP,
        Control::choice("wheel", "wheel", &["disc", "hoop", "weights on the axle"]),
        Control::slider("reach", "how far out the weights are, in radii", [0.2, 2.0, 0.01], "", 1.0)
            .when("wheel", [2.0, 2.0]),
        Control::slider("loss", r"loss, $\Gamma$", [0.0, 0.5, 0.01], "1/s", 0.0),
        Control::kept("heading"),
        Control::kept("roll"),
    ],
    presets: &[
        preset("leaning by 12°", &[("lean", 12.0), ("circle", 0.8), ("push", 0.1)]),
        preset("leaning by 26°", &[("lean", 26.0), ("circle", 0.8), ("push", 0.1)]),
        preset("the same, a strong kick", &[("lean", 26.0), ("circle", 0.8), ("push", 1.0)]),
        preset("a wide circle", &[("lean", 10.0), ("circle", 4.0), ("push", 0.3)]),
        preset("slowing down: the spiral", &[("lean", 9.0), ("circle", 4.0), ("push", 0.0), ("loss", 0.1)]),
        preset(
            "weights on the axle",
            &[("wheel", 2.0), ("reach", 1.87), ("lean", 22.0), ("circle", 4.0), ("push", 0.1)],
        ),
        preset("beyond the axis", &[("lean", 60.0), ("circle", -0.05), ("push", 0.5)]),
    ],
    readings: &[
        reading(r"lean $\theta$", Form::Fixed(1), "°"),
        reading("times round the circle", Form::Fixed(2), ""),
        reading("wobbles since the kick", Form::Fixed(2), ""),
        reading("friction it needs now", Form::Fixed(2), ""),
        reading(r"change of the energy, $E/E_0 - 1$", Form::Power(1), ""),
        reading(r"change of Chaplygin's $A$ and $B$", Form::Power(1), ""),
    ],
    symbols: formulas![r"b/a", r"\theta", r"\boldsymbol{L}", r"\boldsymbol{\tau}", r"V", r"mga", r"E"],
    start: |settings| Ok(Box::new(Rolled::new(settings)?)),
};

/// How much of the track is drawn heavy, s.
const RECENT: f64 = 3.0;
/// A track that reaches further from its middle, in radii, is not shown whole: the eye goes with the wheel.
const MOST_REACH: f64 = 7.0;
/// No arrow is longer, in radii.
const LONGEST: f64 = 2.5;
/// Half its thickness, in radii.
const HALF: f64 = 0.045;

/// Where the parts of the picture stand.
fn stage(room: Room) -> Rect {
    room.of(Rect::new(4.0, 4.0, 396.0, 432.0), Rect::new(4.0, 4.0, 372.0, 300.0))
}

fn map(room: Room) -> Plot<'static> {
    let frame = room.of(Rect::new(448.0, 36.0, 200.0, 150.0), Rect::new(42.0, 350.0, 132.0, 150.0));
    let x = Axis::linear(-0.5, 4.0, 1.0).titled(r"circle $b/a$");
    Plot { frame, x, y: Axis::linear(0.0, 60.0, 20.0).titled(r"lean $\theta$, °") }
}

impl Rolled {
    /// b/a and the lean, degrees, of a state: where it stands on the map. For a wheel that does not turn b is infinite.
    fn on_map(state: &Rolling) -> (f64, f64) {
        (state.omega_3 * state.tilt.sin() / state.omega_2, state.lean().to_degrees())
    }

    /// What of the table is shown: its middle, and how far it reaches, in radii.
    fn shown(&self, now: &Rolling) -> (Complex<f64>, f64) {
        let follows = self.reach > MOST_REACH;
        let around = now.contact(RADIUS) / RADIUS;
        let (middle, reach) = if follows { (around, 0.5 * MOST_REACH) } else { (self.middle, self.reach) };
        (middle, reach.max(1.8) + 0.25)
    }

    /// The camera, and where its eye is.
    fn camera(&self, moment: &Moment, now: &Rolling) -> Result<(Camera, Vector3<f64>), Flaw> {
        let (frame, (middle, reach)) = (stage(moment.room), self.shown(now));
        let distance = 12.0 + 2.0 * reach;
        let high = 2.0 * reach * 0.6_f64.sin() + 2.0;
        let target = Vector3::new(middle.re, middle.im, 0.55);
        let scale = (0.4 * frame.width() / reach).min(0.86 * frame.height() / high);
        let centre = frame.centre() + at(0.0, 0.02 * frame.height());
        let eye = target + Vector3::from(moment.towards_eye()) * distance;
        Ok((moment.camera(target, distance, centre, scale)?, eye))
    }

    fn draw_stage(&self, moment: &Moment, now: &Rolling, drawing: &mut Drawing) -> Result<(), Cause> {
        let (frame, (middle, reach), (camera, eye)) =
            (stage(moment.room), self.shown(now), self.camera(moment, now)?);
        let contact = now.contact(RADIUS) / RADIUS;
        // The track lies on the table, and the wheel stands on both.
        let mut table = Stage::new(camera);
        let half = reach - 0.2;
        let corner = |way: f64| [middle.re, middle.im].map(|x| x + way * half);
        table.ground(corner(-1.0), corner(1.0), 0.0, 1.0)?;
        // The circle on which the contact would run undisturbed.
        let circle = self.steady.map_or(0.0, |steady| (steady.contact_radius() / RADIUS).abs());
        if self.loss == 0.0 && circle > 0.0 && circle + middle.norm() < 1.2 * reach {
            table.curve(Curve::circle([0.0; 3], Vector3::z(), circle)?, Stroke::Reference, Hue::Muted)?;
        }
        table.write(drawing);
        if let Some(kept) = &self.kept {
            let is_on_table = |place: &&Complex<f64>| (**place - middle).norm() <= half;
            let track = kept.contacts.iter().take_while(is_on_table);
            let track = track.filter_map(|place| camera.on_page([place.re, place.im, 0.0]).ok());
            drawing.polyline(&track.collect::<Vec<_>>(), Stroke::Pale, Hue::Ink);
        }
        self.draw_track(moment.time, now, &camera, (middle, half), drawing);
        let mut stage = Stage::new(camera);
        self.draw_wheel(now, &eye, &frame, &mut stage)?;
        if let Some(kept) = &self.kept {
            let state = kept.at(moment.time.min(kept.duration()))?;
            let [_, second, third] = axes(&state);
            let foot = state.contact(RADIUS) / RADIUS;
            let rim = Curve::circle(Vector3::new(foot.re, foot.im, 0.0) + second, third, 1.0)?;
            stage.curve(rim.hiding(Hiding::Ignored), Stroke::Pale, Hue::Ink)?;
        }
        stage.dot_in_front([contact.re, contact.im, 0.0], 4.5, Hue::Pink)?;
        stage.write(drawing);
        Ok(())
    }

    /// The track of the contact on a table with this middle and half this side: all of it pale, which stays as it is, and
    /// over it what is past, the last seconds heavy.
    fn draw_track(
        &self,
        time: f64,
        now: &Rolling,
        camera: &Camera,
        (middle, half): (Complex<f64>, f64),
        drawing: &mut Drawing,
    ) {
        let here = now.contact(RADIUS) / RADIUS;
        let place = |contact: Complex<f64>| {
            // Where the eye goes with the wheel, the table does: what lay beyond its edge is not seen.
            let aside = contact - middle;
            let is_on_table = aside.re.abs().max(aside.im.abs()) <= half;
            let seen = camera.on_page([contact.re, contact.im, 0.0]).ok().filter(|_| is_on_table);
            seen.unwrap_or(at(f64::NAN, f64::NAN))
        };
        let (recent, reached) = (self.count_to(time - RECENT), self.count_to(time));
        let way = |from: usize, to: usize| -> Vec<Point> {
            self.contacts[from - 1..to].iter().map(|&contact| place(contact)).collect()
        };
        // How a wheel goes on that is slowed is what a reader is to guess.
        let all = if self.loss == 0.0 { way(1, self.states.len()) } else { Vec::new() };
        let past = way(1, recent);
        let mut heavy = way(recent, reached);
        heavy.push(place(here));
        for (points, stroke) in [(all, Stroke::Pale), (past, Stroke::Orbit), (heavy, Stroke::Curve)] {
            for piece in points.split(|point| point.x.is_nan()) {
                drawing.polyline(piece, stroke, Hue::Pink);
            }
        }
    }

    /// The wheel with marks that show its turning, and its angular momentum.
    fn draw_wheel(
        &self,
        now: &Rolling,
        eye: &Vector3<f64>,
        frame: &Rect,
        stage: &mut Stage,
    ) -> Result<(), Cause> {
        let [first, second, third] = axes(now);
        let centre = now.centre / RADIUS;
        let centre = Vector3::new(centre.re, centre.im, now.tilt.sin());
        let side = third.dot(&(eye - centre)).signum();
        let face = centre + third * (side * HALF);
        let on_face = |radius: f64, angle: f64| {
            let (sin, cos) = (angle + now.roll_angle).sin_cos();
            face + (first * cos + second * sin) * radius
        };
        if self.which == 0 {
            stage.solid(Solid::disc(centre, third, 1.0, 2.0 * HALF)?, Hue::Blue)?;
            for quarter in [0.0, PI] {
                let arc = linear_steps(quarter, quarter + FRAC_PI_2, 24).map(|angle| on_face(0.82, angle));
                stage.patch([face].into_iter().chain(arc), Fill::Side, Hue::Blue)?;
            }
            let ring = Curve::circle(face, third, 0.82)?;
            stage.curve(ring.hiding(Hiding::Omitted), Stroke::Outline, Hue::Blue)?;
        } else {
            stage.solid(Solid::ring(centre, third, 1.0, 0.88, 2.0 * HALF)?, Hue::Blue)?;
            for spoke in 0..3 {
                let angle = PI * f64::from(spoke) / 3.0;
                let [from, to] = [0.0, PI].map(|half| on_face(0.88, angle + half) - third * (side * HALF));
                stage.curve(Curve::segment(from, to)?, Stroke::Outline, Hue::Blue)?;
            }
            stage.dot_in_front(on_face(0.94, 0.0), 3.0, Hue::Blue)?;
        }
        if self.which == WEIGHTS {
            let [one, other] = [-1.0, 1.0].map(|way| centre + third * (way * self.far));
            stage.solid(Solid::rod(one, other, 0.5 * HALF)?, Hue::Blue)?;
            for weight in [one, other] {
                stage.solid(Solid::sphere(weight, 0.17)?, Hue::Blue)?;
            }
        }
        // Its angular momentum, and what the table's push makes of it: the way that its tip goes.
        let in_room = |vector: Vector3<f64>| first * vector.x + second * vector.y + third * vector.z;
        let MomentFactors { transverse, axial } = self.wheel.parameters().moments;
        let momentum = |state: &Rolling| {
            Vector3::new(transverse * state.omega_1, transverse * state.omega_2, axial * state.omega_3)
        };
        let long = momentum(&self.start).norm();
        let arrow = in_room(momentum(now)) * (1.5 / long);
        if long > 0.0 && arrow.norm() > 0.1 {
            let tip = centre + arrow.cap_magnitude(LONGEST);
            named(stage, frame, [centre, tip], r"$\boldsymbol{L}$", Hue::Green)?;
            if self.loss == 0.0 {
                let torque = (-second).cross(&in_room(self.wheel.contact_force(now))) / (MASS * GRAVITY);
                if torque.norm() > 0.02 {
                    let end = tip + (torque * 3.0).cap_magnitude(0.5 * LONGEST);
                    named(stage, frame, [tip, end], r"$\boldsymbol{\tau}$", Hue::Purple)?;
                }
            }
        }
        Ok(())
    }

    /// The map of circles and leans, with the tongue.
    fn draw_map(&self, room: Room, drawing: &mut Drawing) -> Result<(), Cause> {
        let mut map = map(room).on(drawing)?;
        map.answer(|map| {
            let below = [(0.0, 0.0)].into_iter().chain(self.tongue.iter().copied()).chain([(4.0, 0.0)]);
            map.area(below, Fill::Face, Hue::Orange);
            map.curve(self.tongue.iter().copied(), Stroke::Border, Hue::Orange);
            map.label((2.4, 44.0), Side::Over, "stays small", Hue::Ink)?;
            let inside = map.at((2.2, 4.5));
            map.drawing().label_on_face(inside, Side::Over, "grows", Hue::Ink)
        })?;
        let leans = (0..=30).map(|k| 2.0 * f64::from(k));
        let border: Vec<(f64, f64)> = leans.map(|lean| (self.bound(lean.to_radians()), lean)).collect();
        let none = [(-0.5, 60.0), (-0.5, 0.0)].into_iter().chain(border.iter().copied());
        map.area(none, Fill::Ground, Hue::Ink);
        map.curve(border, Stroke::Border, Hue::Muted);
        Ok(())
    }

    /// This motion's way on the map, and where it is now.
    fn draw_way(&self, moment: &Moment, now: &Rolling, drawing: &mut Drawing) -> Result<(), Cause> {
        let mut map = map(moment.room).over(drawing);
        let past = self.states[..self.count_to(moment.time)].iter().map(|(_, state)| state);
        let (mut way, mut before) = (Vec::new(), now.omega_2);
        for state in past.chain([now]) {
            if before * state.omega_2 < 0.0 {
                way.push((f64::NAN, f64::NAN)); // straight on for an instant: out on one side, back on the other
            }
            before = state.omega_2;
            way.push(Self::on_map(state));
        }
        map.curve(way, Stroke::Orbit, Hue::Blue);
        if let Some(kept) = &self.kept {
            let state = kept.at(moment.time.min(kept.duration()))?;
            map.dot(Self::on_map(&state), 3.4, Hue::Muted);
        }
        map.dot(Self::on_map(now), 3.4, Hue::Blue);
        map.grip((self.circle, self.lean.to_degrees()), Hue::Ink);
        Ok(())
    }
}

/// A vector with its name, or without where the name would be cut off.
fn named(
    stage: &mut Stage,
    frame: &Rect,
    [from, to]: [Vector3<f64>; 2],
    name: &str,
    hue: Hue,
) -> Result<(), Cause> {
    if frame.grown(-20.0).contains(stage.camera().on_page(to)?) {
        stage.named_vector(from, to, name, hue)?;
    } else {
        stage.vector(from, to, hue)?;
    }
    Ok(())
}

/// Why circles get smaller.
const SLOWED: &str = "But it loses some of its turning, the weight wins, and as it sinks it goes round faster, on a \
                      smaller circle.";

/// Axes 1, 2, 3 in the room.
fn axes(state: &Rolling) -> [Vector3<f64>; 3] {
    let ((sin, cos), (rise, level)) = (state.heading.sin_cos(), state.tilt.sin_cos());
    let outward = Vector3::new(-sin, cos, 0.0);
    let second = Vector3::z() * rise - outward * level;
    [Vector3::new(cos, sin, 0.0), second, -outward * rise - Vector3::z() * level]
}

impl Motion for Rolled {
    fn run(&self) -> Run {
        Run { duration: self.duration(), pace: 1.0, repeats: matches!(self.course, Course::Steady) }
    }

    fn draw_behind(&self, room: Room, drawing: &mut Drawing) -> Result<(), Cause> {
        self.draw_map(room, drawing)?;
        let (plot, kick) = (self.well(room), self.energy_of_rate(self.push));
        let mut well = plot.on(drawing)?;
        well.level(kick, Stroke::Reference, Hue::Muted);
        let end = well.at((plot.x.scale.to, kick));
        Ok(well.drawing().label(end + at(-6.0, 4.0), Side::BelowLeft, r"$E$", Hue::Muted)?)
    }

    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let now = self.at(moment.time)?;
        self.draw_stage(moment, &now, drawing)?;
        self.draw_way(moment, &now, drawing)?;
        self.draw_well(moment, &now, drawing);
        Ok(())
    }

    fn readings(&self, time: f64) -> Result<Vec<f64>, Cause> {
        let now = self.at(time)?;
        let wobbles = match &self.course {
            Course::Wobbling(wobbles) => {
                let last = wobbles.iter().rev().find(|(kicked, _)| *kicked <= time);
                last.map_or(0.0, |(kicked, wobble)| (time - kicked) / wobble.period())
            }
            Course::Steady => 0.0,
            Course::Followed(_) => f64::NAN,
        };
        // Its formula is that of a wheel that nothing slows.
        let friction = if self.loss == 0.0 && now.omega_2 != 0.0 {
            let [first, second, third] = axes(&now);
            let force = self.wheel.contact_force(&now);
            let force = first * force.x + second * force.y + third * force.z;
            force.xy().norm() / force.z
        } else {
            f64::NAN
        };
        let first = self.first(time)?;
        let energy = self.wheel.energy(&now) / self.wheel.energy(&first) - 1.0;
        let [before, after] = [first, now].map(|state| self.wheel.constants(&state));
        let change = (after.even - before.even).hypot(after.odd - before.odd) / before.even.hypot(before.odd);
        let change = if self.loss == 0.0 { change } else { f64::NAN }; // nothing keeps them then
        Ok(vec![
            now.lean().to_degrees(),
            (now.heading - self.turned[0]) / TAU,
            wobbles,
            friction,
            energy,
            change,
        ])
    }

    /// Neither the wheel nor its spokes leap when its circle is changed.
    fn kept(&self, time: f64) -> Result<Vec<(&'static str, f64)>, Cause> {
        let now = self.at(time)?;
        Ok(vec![("heading", now.heading), ("roll", now.roll_angle)])
    }

    fn words(&self, _time: f64) -> String {
        let what = ["disc", "hoop", "wheel"][self.which];
        let (lean, circle) = (self.lean.to_degrees(), self.circle);
        let Some(steady) = self.steady else {
            return if self.lean == 0.0 {
                "Upright and without speed the wheel goes round on no circle. It stands, until a kick \
                 fells it."
                    .into()
            } else {
                format!(
                    "No rate of turning holds a {what} that leans by {lean:.1}° with its centre {:.2} \
                     radii beyond the axis: it would have to be less than {:.3}. Let go at rest, it falls.",
                    -circle,
                    -self.bound(self.lean),
                )
            };
        };
        let round = TAU / steady.turn_rate();
        let on = format!("On this circle the {what} goes round in {round:.2} s.");
        let square = steady.wobble_square();
        let fate = if self.loss > 0.0 {
            format!("With no loss it would be {}stable there.", if square > 0.0 { "" } else { "un" })
        } else if square > 0.0 {
            format!("It is stable: small wobbles take {:.2} s each and stay small.", TAU / square.sqrt())
        } else {
            let rate = (-square).sqrt();
            format!(
                "It is unstable: what disturbs it grows at the rate {rate:.2}/s, e-fold in {:.2} s.",
                1.0 / rate
            )
        };
        let hole = self.slot();
        let kicked = match self.wobble() {
            _ if self.loss > 0.0 => self.spiral(),
            Some(wobble) => {
                let [low, high] = self.swung.map(degrees);
                let (before, after) = if self.is_thrown_over() {
                    ("This kick is too strong for that. ", ", and of the circle nothing is left".into())
                } else {
                    ("", format!(", {:.2} times in a round", TAU / wobble.heading_advance().abs()))
                };
                format!("{before}After the kick the lean swings between {low} and {high}{after}.")
            }
            None if self.push == 0.0 => "Nothing disturbs it: it rolls so for ever.".into(),
            None => "The kick fells it.".into(),
        };
        format!("{on} {fate} {kicked}{hole}")
    }

    fn grips(&self, moment: &Moment) -> Vec<Point> {
        let well = self.well(moment.room);
        vec![
            map(moment.room).point((self.circle, self.lean.to_degrees())),
            well.point((well.x.scale.to, self.energy_of_rate(self.push))),
        ]
    }

    /// The top of the wheel: it is tipped over.
    fn bodies(&self, moment: &Moment) -> Vec<(Point, f64)> {
        let seen = || {
            let now = self.at(moment.time)?;
            top(&self.camera(moment, &now)?.0, &now)
        };
        seen().map_or(Vec::new(), |place| vec![(place, 28.0)])
    }

    fn drag(&self, grip: usize, to: Point, moment: &Moment) -> Vec<(&'static str, f64)> {
        if grip == 2 {
            let Ok(now) = self.at(moment.time) else { return Vec::new() };
            let Ok((camera, _)) = self.camera(moment, &now) else { return Vec::new() };
            let leans = (0..=600).map(|k| (0.1 * f64::from(k)).to_radians());
            let lean = nearest([self.lean].into_iter().chain(leans), to, |lean| {
                top(&camera, &self.tipped(&now, lean))
            });
            return lean.map_or(Vec::new(), |lean| vec![("lean", lean.to_degrees())]);
        }
        if grip == 0 {
            let (circle, lean) = map(moment.room).value(to);
            return vec![("circle", circle), ("lean", lean)];
        }
        let (_, energy) = self.well(moment.room).value(to);
        let push = (energy.max(0.0) / self.energy_of_rate(1.0)).sqrt();
        vec![("push", if self.push < 0.0 { -push } else { push })]
    }
}

impl Rolled {
    /// The state from which it has rolled undisturbed until a time: that just after the kick or, before it, the first.
    fn first(&self, time: f64) -> Result<Rolling, Cause> {
        match self.kicks.iter().rev().find(|kicked| **kicked <= time) {
            Some(kicked) => self.at(*kicked),
            None => Ok(self.states[0].1),
        }
    }

    /// What is said of a lower weight that would hang below the table.
    fn slot(&self) -> String {
        let hangs_below = |state: &Rolling| self.far * state.tilt.cos().abs() > state.tilt.sin();
        if self.which != WEIGHTS || !self.states.iter().any(|(_, state)| hangs_below(state)) {
            return String::new();
        }
        let limit = degrees((1.0 / self.far).atan());
        format!(" (Wherever it leans by more than {limit}, its lower weight is in a slot in the table.)")
    }

    /// Whether the kick is not a small one of a stable motion: the lean swings by more than a radian, or far wider
    /// than in a small wobble.
    fn is_thrown_over(&self) -> bool {
        let square = self.steady.map_or(0.0, |steady| steady.wobble_square());
        let width = self.swung[1] - self.swung[0];
        square > 0.0 && (width > 1.0 || width > 3.0 * self.push.abs() / square.sqrt() && self.kicks.len() < 2)
    }

    /// What becomes of the circle when something slows the wheel.
    fn spiral(&self) -> String {
        let (time, last) = self.states[self.states.len() - 1];
        if is_flat(&last) {
            format!("{SLOWED} After {time:.1} s it lies all but flat.")
        } else {
            let (circle, lean) = Self::on_map(&last);
            format!("{SLOWED} At the end it leans by {lean:.1}°, on a circle of {circle:.2} radii.")
        }
    }

    /// b/a beyond which no circle exists at a lean (`eq:existence`).
    fn bound(&self, lean: f64) -> f64 {
        let MomentFactors { transverse, axial } = self.wheel.parameters().moments;
        -transverse * lean.sin() / (1.0 + axial)
    }

    /// The well: leans, degrees, and heights over the potential of the steady motion, in mga.
    fn well(&self, room: Room) -> Plot<'static> {
        let [low, high] = self.swings.map(f64::to_degrees);
        let (before, after) = ((0.4 * (high - low)).max(8.0), (0.6 * (high - low)).max(12.0));
        let step = match high - low + before + after {
            wide if wide > 75.0 => 45.0,
            wide if wide > 35.0 => 20.0,
            _ => 10.0,
        };
        let [from, to] = [((low - before) / step).floor() * step, ((high + after) / step).ceil() * step];
        let leans = Axis::linear(from.max(-90.0), to.min(90.0), step).titled(r"lean $\theta$, °");
        let level = self.energy_of_rate(self.push);
        let depth = self.liveliest.max(level).max(2e-3);
        let [low, high] = [(level - 1.3 * self.liveliest).min(-0.25 * depth), level + 0.8 * depth];
        let step = nice_step((high - low) / 3.0);
        let [low, high] = [(low / step).floor() * step, (high / step).ceil() * step];
        let y = Axis::linear(low, high, step).titled(r"potential $V$, in $mga$");
        let frame = room.of(Rect::new(448.0, 252.0, 200.0, 140.0), Rect::new(236.0, 350.0, 132.0, 150.0));
        Plot { frame, x: leans, y }
    }

    /// The potential of the lean as it is now, and the lean that rolls in it.
    fn draw_well(&self, moment: &Moment, now: &Rolling, drawing: &mut Drawing) {
        let plot = self.well(moment.room);
        let leans = plot.x.scale;
        let unit = MASS * GRAVITY * RADIUS;
        let constants = self.wheel.constants(now);
        // Heights are counted so that the energy stays at one level, whatever is lost.
        let is_kicked = now.omega_1 != 0.0 || !matches!(self.course, Course::Steady | Course::Wobbling(_));
        let kick = self.energy_of_rate(self.push);
        let level = if is_kicked { kick } else { 0.0 };
        let zero = self.wheel.energy(now) / unit - level;
        let height = |lean: f64| self.wheel.potential(&constants, FRAC_PI_2 - lean) / unit - zero;
        let values = linear_steps(leans.from, leans.to, 90)
            .map(|degrees| (degrees, height(degrees.to_radians().clamp(-1.57, 1.57))));
        let mut well = plot.over(drawing);
        well.curve(values, Stroke::Curve, Hue::Blue);
        let here = (now.lean().to_degrees(), height(now.lean()));
        well.curve([here, (here.0, level)], Stroke::Outline, Hue::Muted);
        well.dot(here, 5.0, Hue::Blue);
        well.grip((leans.to, kick), Hue::Ink);
    }
}

impl Rolled {
    /// A state as it would be with another lean of the steady motion, in the same direction.
    fn tipped(&self, now: &Rolling, lean: f64) -> Rolling {
        let other = self.wheel.steady(lean, self.circle * RADIUS).ok().zip(self.steady);
        let moved = other.map_or(Complex::ZERO, |(there, here)| there.state().centre - here.state().centre);
        Rolling {
            tilt: now.tilt + self.lean - lean,
            centre: now.centre + moved * Complex::cis(now.heading),
            ..*now
        }
    }
}

/// Where the top of the wheel is seen.
fn top(camera: &Camera, state: &Rolling) -> Result<Point, Cause> {
    let [_, second, _] = axes(state);
    let foot = state.contact(RADIUS) / RADIUS;
    Ok(camera.on_page(Vector3::new(foot.re, foot.im, 0.0) + second * 2.0)?)
}

/// An angle, rad, as it is written.
fn degrees(angle: f64) -> String {
    format!("{:.1}°", angle.to_degrees()).replace('-', "−")
}
