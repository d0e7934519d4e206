//! The scene of the chapter "The coin toss": a coin in slow motion beside the path of its normal on a sphere.

pub(super) use coin::draw_coin;
use live::prelude::*;
use mechanics::InvalidQuantity;
use mechanics::inertia::PrincipalMoments;
use mechanics::scenes::coin_toss::{Flight, FlightParameters, Toss, TossParameters};
use nalgebra::{UnitQuaternion, Vector3};
use std::sync::LazyLock;
use tosses::{TOSSES, Tosses};

#[path = "scene/coin.rs"]
mod coin;
#[path = "scene/tosses.rs"]
mod tosses;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "coin-toss",
    title: "A tossed coin and the path of its normal",
    description: "At the left a coin in the air, seen from straight above: tails is up, the normal 3 of heads points away to the right, as does the angular momentum L. \
                  Beside it a sphere with its equator: the tip of the normal goes round L on a circle through the pole, of which the part above the equator is blue and the \
                  part below grey. Below, the height of the normal through one precession, which dips below zero in the middle, and a curve of the probability of the same \
                  face against the angle theta L between the normal and L, with a dot for this toss.",
    question: "A thumb tumbles the coin 38 times a second. How fast must it twist the coin as well, if heads, and nothing but heads, is to be seen from above?",
    size: [[640.0, 520.0], [380.0, 600.0]],
    view: Some([-0.55, 0.42]),
    still: 0.0366,
    controls: &[
        Control::slider("tumble", r"tumble, $\omega_1$", [0.0, MOST, 0.5], "rad/s", 240.0),
        Control::slider("twist", r"twist, $\omega_3$", [0.0, MOST, 0.5], "rad/s", 60.0),
        Control::choice("hand", "tossed by", &["a hand", "a steady hand", "a machine"])
            .when("toss", [0.0, f64::MAX]),
        Control::button("toss", "Toss five thousand"),
        Control::slider("ratio", r"thick to thin: moments $I_3/I_1$", [0.5, 2.0, 0.01], "", 2.0),
        Control::choice("camera", "the coin is seen", &["from straight above", "from the side"]),
    ],
    presets: &[
        preset("no twist", &[("twist", 0.0)]),
        preset("a quarter", &[]),
        preset("the threshold", &[("twist", 120.0)]),
        preset("never tails", &[("twist", 144.0)]),
        preset("the mean tosser", &[("twist", 19.0)]),
        preset("a thick puck", &[("ratio", 1.0), ("twist", 144.0)]),
    ],
    readings: &[
        reading(r"height of the normal, $n_z$", Form::Fixed(3), ""),
        reading("precessions", Form::Fixed(2), ""),
        reading(r"part of the circle above, $p$", Form::Fixed(4), ""),
        reading("tosses", Form::Fixed(0), ""),
        reading("part that were heads", Form::Fixed(4), ""),
        reading(r"drift of $\boldsymbol{L}$", Form::Power(1), ""),
    ],
    symbols: formulas![r"\boldsymbol{L}", r"\hat{\mathbf{3}}", r"n_z", r"\theta_L", r"p"],
    start: |settings| Ok(Box::new(Throw::new(settings)?)),
};

/// The greatest tumble and twist, rad/s.
const MOST: f64 = 300.0;
/// The coin is thrown at 2.4 m/s and caught where it was thrown.
const FLIGHT: FlightParameters = FlightParameters { speed: 2.4, gravity: 9.81, catch_height: 0.0 };
/// A precession takes this long for the reader, s.
const SLOW: f64 = 1.6;
/// At full speed the toss is seen anew every so often, s.
const AGAIN: f64 = 1.2;
/// What the eye takes for one instant, s, and how many images of the coin stand for it.
const BLINK: f64 = 0.02;
const IMAGES: u32 = 6;
/// Probability of the same face against `θ_L`, degrees: the twists divide the curve most finely where it leaves one.
static PROBABILITIES: LazyLock<Vec<(f64, f64)>> = LazyLock::new(|| {
    let coin = |ratio: f64| -> Result<_, InvalidQuantity> {
        let moments = PrincipalMoments::symmetric(1.0, 2.0)?;
        let toss = Toss::new(TossParameters { moments, omega_1: 1.0, omega_3: 0.5 * ratio })?;
        Ok((toss.momentum_angle().to_degrees(), toss.same_face_probability()))
    };
    let steps = (0..=60).map(|k| 1.0 - (f64::from(k) / 60.0).powi(2));
    [(0.0, 1.0)].into_iter().chain(steps.filter_map(|ratio| coin(ratio).ok())).collect()
});

/// A coin as it is thrown. Its moment about a diameter is 1 kg·m².
struct Throw {
    /// None if it does not turn.
    toss: Option<Toss>,
    moments: PrincipalMoments,
    tumble: f64,
    twist: f64,
    duration: f64,
    from_above: bool,
    /// The path of the tip of the normal: heads, then tails.
    paths: [Vec<Vector3<f64>>; 2],
    tosses: Tosses,
    /// What others gave before: angles between normal and momentum, degrees, and the part that showed heads.
    former: Vec<(f64, f64)>,
}

impl Throw {
    fn new(settings: &Settings<'_>) -> Result<Self, Cause> {
        let [tumble, twist] = [settings.of("tumble")?, settings.of("twist")?];
        let moments = PrincipalMoments::symmetric(1.0, settings.of("ratio")?)?;
        let turns = tumble > 0.0 || twist > 0.0;
        let parameters = TossParameters { moments, omega_1: tumble, omega_3: twist };
        let toss = if turns { Some(Toss::new(parameters)?) } else { None };
        let mut throw = Self {
            toss,
            moments,
            tumble,
            twist,
            duration: Flight::new(FLIGHT)?.duration(),
            from_above: settings.choice("camera")? == 0,
            paths: [Vec::new(), Vec::new()],
            tosses: Tosses::default(),
            former: Vec::new(),
        };
        throw.paths = throw.paths()?;
        if let Some(pressed) = settings.pressed("toss")? {
            let hand = (settings.choice("hand")?, pressed, throw.duration);
            throw.tosses = Tosses::new(hand, |time| throw.caught(time))?;
        }
        Ok(throw)
    }

    /// How long a precession takes, s; none for a coin whose normal stands still.
    fn period(&self) -> Option<f64> {
        self.toss.filter(|_| self.tumble > 0.0).map(|toss| TAU / toss.precession_rate())
    }

    fn pace(&self) -> f64 {
        self.period().map_or(0.1, |period| (period / SLOW).min(1.0))
    }

    /// The angle between the normal at the start and the angular momentum, rad.
    fn angle(&self) -> f64 {
        self.toss.map_or(0.0, |toss| toss.momentum_angle())
    }

    /// The direction of the angular momentum, which lies in the plane of x and z.
    fn momentum(&self) -> Vector3<f64> {
        let (sin, cos) = self.angle().sin_cos();
        Vector3::new(sin, 0.0, cos)
    }

    fn attitude(&self, time: f64) -> Result<UnitQuaternion<f64>, InvalidQuantity> {
        self.toss.map_or(Ok(UnitQuaternion::identity()), |toss| Ok(toss.at(time)?.world_from_body))
    }

    fn height(&self, time: f64) -> Result<f64, InvalidQuantity> {
        self.toss.map_or(Ok(1.0), |toss| toss.normal_height(time))
    }

    /// The part of the time for which heads shows.
    fn probability(&self) -> f64 {
        self.toss.map_or(1.0, |toss| toss.same_face_probability())
    }

    fn paths(&self) -> Result<[Vec<Vector3<f64>>; 2], InvalidQuantity> {
        let (Some(toss), Some(period)) = (self.toss, self.period()) else {
            return Ok([Vec::new(), Vec::new()]);
        };
        let edge = toss.first_edge().unwrap_or(0.5 * period);
        let path = |from: f64, to: f64| {
            if to - from < 1e-9 * period {
                return Ok(Vec::new());
            }
            let points = 6 + (64.0 * (to - from) / period) as u32;
            linear_steps(from, to, points).map(|time| toss.normal(time)).collect()
        };
        Ok([path(-edge, edge)?, path(edge, period - edge)?])
    }

    /// What is caught after a time: the part of a precession, and whether heads shows.
    fn caught(&self, time: f64) -> Result<(f64, bool), InvalidQuantity> {
        let part = self.period().map_or(0.0, |period| (time / period).rem_euclid(1.0));
        Ok((part, self.height(time)? >= 0.0))
    }

    fn made(&self, time: f64) -> usize {
        self.tosses.made(time, self.pace())
    }

    /// The way of the tip of the normal, blue where heads shows and grey where tails does.
    fn draw_path(&self, stage: &mut Stage, size: f64, stroke: Stroke) -> Result<(), Flaw> {
        for (path, hue) in self.paths.iter().zip([Hue::Blue, Hue::Muted]) {
            if path.len() > 1 {
                stage.curve(Curve::smooth(path.iter().map(|tip| tip * size))?, stroke, hue)?;
            }
        }
        Ok(())
    }

    /// The coin in slow motion.
    fn draw_flight(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let attitude = self.attitude(moment.time)?;
        let normal = attitude * Vector3::z();
        let moment = &if self.from_above { moment.seen_from(-FRAC_PI_2, FRAC_PI_2) } else { *moment };
        let (centre, scale) = moment.room.of((at(212.0, 158.0), 84.0), (at(222.0, 126.0), 66.0));
        let mut stage = Stage::new(moment.camera([0.0; 3], 9.0, centre, scale)?);
        draw_coin(&self.moments, &mut stage, &attitude, &moment.towards_eye().into())?;
        self.draw_path(&mut stage, 1.4, Stroke::Outline)?;
        if self.toss.is_some() {
            stage.named_vector([0.0; 3], self.momentum() * 1.65, r"$\boldsymbol{L}$", Hue::Green)?;
        }
        stage.named_vector([0.0; 3], normal * 1.4, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
        stage.write(drawing);
        let (name, hue) = if normal.z >= 0.0 { ("heads", Hue::Blue) } else { ("tails", Hue::Muted) };
        let below = moment.room.of(at(212.0, 314.0), at(222.0, 244.0));
        drawing.label(below, Side::Left, "seen from above:", Hue::Ink)?;
        drawing.label(below, Side::Right, name, hue)?;
        Ok(())
    }

    /// The sphere with the equator and the path of the normal.
    fn draw_sphere(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let mut stage = Stage::new(sphere(moment)?);
        stage.solid(Solid::sphere([0.0; 3], 1.0)?, Hue::Blue)?;
        stage.curve(Curve::circle([0.0; 3], Vector3::z(), 1.0)?, Stroke::Reference, Hue::Ink)?;
        self.draw_path(&mut stage, 1.0, Stroke::Curve)?;
        stage.label([0.85, -0.52, 0.0], Side::Below, "equator", Hue::Muted)?;
        stage.dot([0.0, 0.0, 1.0], 3.5, Hue::Ink)?;
        stage.label([0.0, 0.0, 1.0], Side::AboveLeft, "start, flat", Hue::Muted)?; // L goes up to its right
        if self.toss.is_some() {
            let momentum = self.momentum();
            let tip = momentum * REACH;
            stage.vector(momentum, tip, Hue::Green)?;
            stage.dot(momentum, 3.5, Hue::Green)?;
            stage.label_shifted(tip, at(7.0, 0.0), Side::Right, r"$\boldsymbol{L}$", Hue::Green)?;
        }
        let normal = self.attitude(moment.time)? * Vector3::z();
        stage.dot(normal, 5.5, if normal.z >= 0.0 { Hue::Blue } else { Hue::Muted })?;
        stage.write(drawing);
        let tip = sphere(moment)?.on_page(self.momentum() * REACH)?;
        kit::grip(drawing, tip, Hue::Green);
        Ok(())
    }

    /// The same toss from the side and at full speed, where the eye sees several images of the coin at once.
    fn draw_full_speed(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let flight = Flight::new(FLIGHT)?;
        let (x, [hand, top]) = moment.room.of((40.0, [270.0, 48.0]), (40.0, [212.0, 40.0]));
        let highest = FLIGHT.speed * FLIGHT.speed / (2.0 * FLIGHT.gravity);
        let page_y = |time: f64| hand - (hand - top) * flight.height(time).clamp(0.0, highest) / highest;
        drawing.line(at(x, hand), at(x, top), Stroke::Dotted, Hue::Muted);
        drawing.line(at(x - 20.0, hand + 6.0), at(x + 20.0, hand + 6.0), Stroke::Axis, Hue::Ink);
        let slow = at(x + 18.0, page_y(moment.time));
        drawing.line(slow, slow + at(8.0, 0.0), Stroke::Vector, Hue::Ink);
        drawing.label_set(slow, Side::Right, 11.0, 13.0, "slow", Role::Text(Hue::Ink))?;
        let (clock, radius) = ((moment.time / self.pace()).rem_euclid(AGAIN), 15.0);
        for image in (0..IMAGES).rev() {
            let time = (clock - BLINK * f64::from(image) / f64::from(IMAGES)).clamp(0.0, self.duration);
            let normal = self.attitude(time)? * Vector3::z();
            // A circle seen along y: across the normal it has its radius, along it less.
            let thin = (radius * normal.y.abs()).max(1.5);
            let turn = normal.x.atan2(-normal.z);
            let shape = Shape::Ellipse { centre: at(x, page_y(time)), radii: (radius, thin), turn };
            let hue = if normal.z >= 0.0 { Hue::Blue } else { Hue::Muted };
            drawing.push(Role::Area(Fill::Side, hue), shape.clone());
            drawing.push(Role::Line(Stroke::Pale, hue), shape);
        }
        let below = at(x, hand + 24.0);
        Ok(drawing.note(below, Side::Over, "full speed", Hue::Ink)?)
    }

    /// The height of the normal through a precession, and at which parts of it coins were caught.
    fn draw_heights(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let frames = [[48.0, 364.0, 320.0, 104.0], [48.0, 474.0, 310.0, 80.0]];
        let x = Axis::linear(0.0, 1.0, 0.25).titled("part of a precession");
        let y = Axis::linear(-1.0, 1.0, 1.0).titled(r"height of the normal, $n_z$");
        let mut graph = moment.graph(drawing, frames, x, y)?;
        let made = self.made(moment.time);
        self.tosses.draw(&mut graph, made);
        graph.level(0.0, Stroke::Reference, Hue::Ink);
        let middle = self.angle().cos().powi(2);
        graph.level(middle, Stroke::Dotted, Hue::Green);
        let period = self.period().unwrap_or(1.0);
        let edge = self.toss.and_then(|toss| toss.first_edge()).map_or(0.5, |edge| edge / period);
        for (from, to, hue) in
            [(0.0, edge, Hue::Blue), (edge, 1.0 - edge, Hue::Muted), (1.0 - edge, 1.0, Hue::Blue)]
        {
            let wave = linear_steps(from, to, 32).map(|part| Ok((part, self.height(part * period)?)));
            graph.curve(wave.collect::<Result<Vec<_>, InvalidQuantity>>()?, Stroke::Curve, hue);
        }
        let (part, is_heads) = self.caught(moment.time)?;
        let hue = if is_heads { Hue::Blue } else { Hue::Muted };
        graph.dot((part, self.height(moment.time)?), 5.0, hue);
        let place = graph.at((0.5, middle));
        let drawing = graph.drawing();
        if middle < 0.92 {
            drawing.label_set(place, Side::Above, 3.0, 13.0, "its middle", Role::Text(Hue::Green))?;
        }
        if made > 0 {
            let above = moment.room.of(at(368.0, 348.0), at(358.0, 458.0));
            drawing.note(above, Side::Left, "bars: the catches", Hue::Muted)?;
        }
        Ok(())
    }

    /// The probability of the same face against `θ_L`, and what the tosses gave.
    fn draw_probability(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let mut graph = probability(moment.room).on(drawing)?;
        graph.area([(0.0, 0.5), (45.0, 0.5), (45.0, 1.0), (0.0, 1.0)], Fill::Ground, Hue::Blue);
        graph.answer(|graph| {
            graph.curve(PROBABILITIES.iter().copied(), Stroke::Curve, Hue::Blue);
            Ok(())
        })?;
        let angle = self.angle().to_degrees();
        for &former in self.former.iter().filter(|(former, _)| *former != angle) {
            graph.dot(former, 2.5, Hue::Pink);
        }
        graph.grip((angle, self.probability()), Hue::Ink);
        let made = self.made(moment.time);
        if made > 0 {
            let (heads, error) = (self.tosses.heads(made), 1.0 / f64::from(made as u32).sqrt());
            graph.curve([(angle, heads - error), (angle, heads + error)], Stroke::Curve, Hue::Pink);
            graph.dot((angle, heads), 3.5, Hue::Pink);
        }
        Ok(())
    }

    /// Tumble and twist that give the momentum another angle, and leave the rate of the precession if they can.
    fn turned_to(&self, angle: f64) -> Vec<(&'static str, f64)> {
        let [_, _, ratio] = self.moments.to_array();
        let (sin, cos) = angle.clamp(0.0, FRAC_PI_2).sin_cos();
        if self.toss.is_none() && angle < 0.02 {
            return Vec::new();
        }
        let rate = self.toss.map_or(120.0, |toss| toss.precession_rate());
        let rate = rate.min(MOST / sin.max(1e-9)).min(MOST * ratio / cos.max(1e-9));
        vec![("tumble", rate * sin), ("twist", rate * cos / ratio)]
    }
}

/// How far the arrow of the momentum reaches beyond the sphere.
const REACH: f64 = 1.4;

/// The eye that looks at the sphere.
fn sphere(moment: &Moment) -> Result<Camera, Flaw> {
    let (centre, scale) = moment.room.of((at(490.0, 160.0), 112.0), (at(92.0, 352.0), 70.0));
    moment.camera([0.0; 3], 9.0, centre, scale)
}

/// The plot of probabilities: its frame on the page, `θ_L` to the right and p upwards.
fn probability(room: Room) -> Plot<'static> {
    let frame = room.of(Rect::new(444.0, 364.0, 170.0, 104.0), Rect::new(262.0, 302.0, 100.0, 100.0));
    let x = Axis::linear(0.0, 90.0, 45.0).titled(r"$\theta_L$, degrees");
    Plot { frame, x, y: Axis::linear(0.5, 1.0, 0.25).titled(r"heads, $p$") }
}

impl Motion for Throw {
    fn run(&self) -> Run {
        Run { duration: self.duration, pace: self.pace(), repeats: true }
    }

    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        self.draw_full_speed(moment, drawing)?;
        self.draw_flight(moment, drawing)?;
        self.draw_sphere(moment, drawing)?;
        self.draw_heights(moment, drawing)?;
        self.draw_probability(moment, drawing)
    }

    fn readings(&self, time: f64) -> Result<Vec<f64>, Cause> {
        let made = self.made(time);
        // From the attitude and ω of this moment, against the start.
        let drift = match self.toss {
            Some(toss) => {
                let [start, now] = [0.0, time].map(|time| toss.at(time));
                let [start, now] =
                    [start?, now?].map(|turning| turning.angular_momentum_world(&self.moments));
                (now - start).norm() / start.norm()
            }
            None => 0.0,
        };
        Ok(vec![
            (self.attitude(time)? * Vector3::z()).z,
            self.period().map_or(0.0, |period| time / period),
            self.probability(),
            f64::from(made as u32),
            if made > 0 { self.tosses.heads(made) } else { f64::NAN },
            drift,
        ])
    }

    fn words(&self, _time: f64) -> String {
        let Some(toss) = self.toss else {
            return "It does not turn at all: heads stays up, and up it stays.".into();
        };
        if self.tumble == 0.0 {
            return "Twist and no tumble: the normal stands still, L along it, and the circle is a \
                    point at the pole."
                .into();
        }
        let (lean, part) = (2.0 * self.angle().to_degrees(), 100.0 * self.probability());
        let lowest = toss.lowest_normal();
        let threshold = {
            let [_, _, axial] = self.moments.to_array();
            1.0 / axial
        };
        let mut words = if lowest == 0.0 {
            "Just twisted enough: the circle touches the equator, and the coin stands on edge for \
             an instant and goes back. Heads shows all the time."
                .into()
        } else if toss.keeps_its_face() {
            format!(
                "Twisted {:.2} times as fast as it tumbles, more than {threshold:.2} times: the normal \
                 leans over by {lean:.0}° at most, its circle clears the equator, and heads shows \
                 all the time.",
                self.twist / self.tumble
            )
        } else if self.twist == 0.0 {
            "Without twist it goes right over: the circle leads through both poles, and half of it lies \
             above the equator."
                .into()
        } else {
            format!(
                "Twisted {:.2} times as fast as it tumbles, less than {threshold:.2} times: the normal \
                 leans over by up to {lean:.0}°, and {part:.1} % of its circle is above the equator. \
                 It is never less than half, as the middle of a circle through the pole is never \
                 below the equator: here it is at the height {:.2}.",
                self.twist / self.tumble,
                self.angle().cos().powi(2)
            )
        };
        let made = self.made(f64::INFINITY);
        if made > 0 {
            let heads = 100.0 * self.tosses.heads(made);
            words += &format!(" Of {TOSSES} tosses {heads:.1} % show heads");
            words += if self.tosses.is_sure {
                ": a machine tosses the same toss each time, and there is no chance in it."
            } else if (heads - part).abs() > 3.0 {
                ": this hand is too sure of itself for chance to have its way."
            } else {
                ", as chance will have it to within 1.4 %."
            };
        }
        words
    }

    /// What five thousand tosses gave that differ by chance.
    fn found(&self, from: f64, to: f64) -> Option<[f64; 3]> {
        let all = TOSSES as usize;
        let is_new = self.made(from) < all && self.made(to) == all && !self.tosses.is_sure;
        is_new.then(|| [self.angle().to_degrees(), self.tosses.heads(all), 0.0])
    }

    fn keep(&mut self, found: &[[f64; 3]]) {
        self.former = found.iter().map(|&[angle, heads, _]| (angle, heads)).collect();
    }

    fn grips(&self, moment: &Moment) -> Vec<Point> {
        let mut grips = vec![probability(moment.room).point((self.angle().to_degrees(), self.probability()))];
        let tip = sphere(moment).and_then(|camera| camera.on_page(self.momentum() * REACH));
        grips.extend(tip.ok());
        grips
    }

    fn drag(&self, grip: usize, to: Point, moment: &Moment) -> Vec<(&'static str, f64)> {
        if grip == 0 {
            return self.turned_to(probability(moment.room).value(to).0.to_radians());
        }
        // The angle at which the tip of the momentum comes nearest to the hand.
        let Ok(camera) = sphere(moment) else { return Vec::new() };
        let tip = |angle: f64| Ok(camera.on_page(Vector3::new(angle.sin(), 0.0, angle.cos()) * REACH)?);
        let angle = self.angle();
        if tip(angle).is_ok_and(|tip| (tip - to).length() < 0.5) {
            return self.turned_to(angle);
        }
        let step = FRAC_PI_2 / 90.0;
        let coarse = nearest(linear_steps(0.0, FRAC_PI_2, 90), to, tip).unwrap_or(0.0);
        let fine = linear_steps((coarse - step).max(0.0), (coarse + step).min(FRAC_PI_2), 90);
        self.turned_to(nearest(fine, to, tip).unwrap_or(coarse))
    }
}
