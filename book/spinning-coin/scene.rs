//! The scene of the chapter "The spinning coin": ink on its rim, and how near it comes to sound.

use live::prelude::*;
use mechanics::InvalidQuantity;
use mechanics::rolling::{DiskParameters, MomentFactors};
use mechanics::scenes::spinning_coin::{Loss, SpinDown, SpinningCoin};
use nalgebra::{UnitQuaternion, Vector3};

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "spinning-coin",
    title: "A spinning coin with ink on its rim",
    description: "A coin with a head on its face leans on a table. Its lowest point has run most of the way round a circle on the table, and ink marks that way on the table \
                  and the same length on the rim. Beside it the circle and the rim are rolled out side by side, each with its ink. Below, against the tilt, the rates of \
                  contact and head.",
    question: "The contact has run once round its circle and is back: how does the head stand now, upright, turned with the contact, or against it? And as the coin goes \
               down, ever faster: does its contact reach the speed of sound?",
    size: [[660.0, 440.0], [380.0, 600.0]],
    view: Some([-FRAC_PI_2, 0.8]),
    still: 5.6,
    controls: &[
        Control::log_slider("tilt", r"tilt from lying flat, $\alpha$", [1e-5, 1.5], "rad", 0.6),
        Control::choice(
            "loss",
            r"what it loses, in proportion to $\alpha^{-p}$",
            &["nothing", r"$p = 2$", r"$p = 5/4$", r"$p = 1$", r"$p = 1/2$"],
        ),
        Control::choice("coin", "what spins", &["disc", "hoop"]),
    ],
    presets: &[
        preset("45°", &[("tilt", 0.785)]),
        preset("nearly upright", &[("tilt", 1.5)]),
        preset("nearly flat", &[("tilt", 0.05)]),
        preset("sinking on a film of air", &[("tilt", 0.1), ("loss", 1.0)]),
        preset("sinking by rolling friction", &[("tilt", 0.1), ("loss", 4.0)]),
    ],
    readings: &[
        reading(r"tilt $\alpha$", Form::Digits(3), "rad"),
        reading(r"rate of the contact, $\Omega$", Form::Digits(3), "rad/s"),
        reading("rate of the head", Form::Digits(3), "rad/s"),
        reading("whir", Form::Fixed(1), "Hz"),
        reading("contact, in speeds of sound", Form::Digits(2), ""),
        reading("rounds so far", Form::Fixed(2), ""),
        reading("head turned so far", Form::Fixed(1), "°"),
        reading("real time gone", Form::Digits(3), "s"),
        reading("real time left", Form::Digits(3), "s"),
        reading("slip: the lengths of ink differ by", Form::Power(1), "radii"),
    ],
    symbols: formulas! {
        r"p = 2", r"p = 5/4", r"p = 1", r"p = 1/2", r"\alpha", r"2\pi a\cos\alpha", r"2\pi a", r"\omega_z"
    },
    start: |settings| Ok(Box::new(Spinning::new(settings)?)),
};

/// The toy of the shops: its mass, kg, and radius, m, on Earth; and the speed of sound, m/s.
const MASS: f64 = 0.4;
const RADIUS: f64 = 0.0375;
const GRAVITY: f64 = 9.81;
const SOUND: f64 = 343.0;
/// The powers p of the losses, with which the coin lives for so long, s, from this tilt, rad.
const POWERS: [f64; 4] = [2.0, 1.25, 1.0, 0.5];
const NAMES: [&str; 4] = [r"$p = 2$", r"$p = 5/4$", r"$p = 1$", r"$p = 1/2$"];
const LIFE: (f64, f64) = (100.0, 0.1);
/// The film: how long it shows a round, s, and how many; and on the way down, how long a tenth of the time left, s.
const ROUND: f64 = 6.0;
const ROUNDS: f64 = 4.0;
const DECADE: f64 = 6.0;
/// Thickness of the coin and, if it is a hoop, its inner radius, in radii.
const THICK: f64 = 0.06;
const INNER: f64 = 0.87;

/// A coin, and how it goes down.
struct Spinning {
    parameters: DiskParameters,
    start: SpinningCoin,
    /// The law by which it goes down, its place in [`POWERS`], and the time left at which it asks for free fall, s.
    down: Option<(SpinDown, usize, f64)>,
    /// On the way down: the angle by which the head has turned, rad, at equal steps of the film.
    head: Vec<[f64; 1]>,
}

/// What is seen at a time of the film.
struct Now {
    coin: SpinningCoin,
    /// Rounds of the contact since the start, and the angle by which the head has turned, rad.
    rounds: f64,
    head: f64,
    /// Real time that is gone and, if there is an end, left, s.
    gone: f64,
    left: f64,
}

/// The way down of such a coin by a law of loss, from any tilt.
fn law(start: SpinningCoin, power: f64) -> Result<SpinDown, InvalidQuantity> {
    let (life, tilt) = LIFE;
    let from = SpinningCoin::new(start.parameters(), tilt)?;
    let unit = SpinDown::new(from, Loss::new(1.0, power)?)?.life();
    SpinDown::new(start, Loss::new(unit / life, power)?)
}

impl Spinning {
    fn new(settings: &Settings<'_>) -> Result<Self, Cause> {
        let moments = [MomentFactors::DISK, MomentFactors::HOOP][settings.choice("coin")?];
        let parameters = DiskParameters { mass: MASS, radius: RADIUS, moments, gravity: GRAVITY };
        let start = SpinningCoin::new(parameters, settings.of("tilt")?)?;
        let down = match settings.choice("loss")? {
            0 => None,
            which => {
                let down = law(start, POWERS[which - 1])?;
                Some((down, which - 1, down.time_left_at_free_fall().min(down.life())))
            }
        };
        let mut spinning = Self { parameters, start, down, head: Vec::new() };
        spinning.head = spinning.head_on_the_way()?;
        Ok(spinning)
    }

    /// The time left at a time of the film, s.
    fn left(down: &SpinDown, end: f64, time: f64) -> f64 {
        (down.life() * 10_f64.powf(-time / DECADE)).clamp(end, down.life())
    }

    /// The integral of the head's rate over the way down, by Simpson's rule over equal steps of the film.
    fn head_on_the_way(&self) -> Result<Vec<[f64; 1]>, InvalidQuantity> {
        let Some((down, _, end)) = &self.down else { return Ok(Vec::new()) };
        let (count, mut turned) = (500, vec![[0.0]]);
        let step = self.run().duration / f64::from(count);
        // Of the time that is left the film takes so much in a second.
        let rate = |time: f64| {
            let left = Self::left(down, *end, time);
            Ok(down.with_time_left(left)?.figure_rate() * left * 10_f64.ln() / DECADE)
        };
        let mut before = rate(0.0)?;
        for k in 0..count {
            let from = f64::from(k) * step;
            let (middle, after) = (rate(from + 0.5 * step)?, rate(from + step)?);
            turned.push([turned[turned.len() - 1][0] + step * (before + 4.0 * middle + after) / 6.0]);
            before = after;
        }
        Ok(turned)
    }

    fn at(&self, time: f64) -> Result<Now, InvalidQuantity> {
        let Some((down, _, end)) = &self.down else {
            let coin = self.start;
            let rounds = time / ROUND;
            let gone = rounds * TAU / coin.turn_rate();
            let head = coin.figure_rate() * gone;
            return Ok(Now { coin, rounds, head, gone, left: f64::NAN });
        };
        let left = Self::left(down, *end, time);
        let [head] = interpolated(&self.head, time / self.run().duration * (self.head.len() - 1) as f64);
        let rounds = down.gone_round(left)? / TAU;
        Ok(Now { coin: down.with_time_left(left)?, rounds, head, gone: down.life() - left, left })
    }

    /// How the coin stands: as it is or, on the way down, as a lamp shows it that flashes once a round.
    fn attitude(&self, now: &Now) -> UnitQuaternion<f64> {
        match self.down {
            None => now.coin.attitude(now.rounds),
            Some(_) => now.coin.attitude(0.0) * UnitQuaternion::from_axis_angle(&Vector3::z_axis(), now.head),
        }
    }
}

/// From the centre to the lowest point of a coin of radius one.
fn lowest(attitude: &UnitQuaternion<f64>) -> Vector3<f64> {
    let normal = attitude * Vector3::z();
    (normal * normal.z - Vector3::z()).normalize()
}

/// Where the parts of the picture stand.
fn stage(room: Room) -> Rect {
    room.of(Rect::new(4.0, 4.0, 400.0, 432.0), Rect::new(4.0, 4.0, 372.0, 258.0))
}

fn lengths(room: Room) -> Rect {
    room.of(Rect::new(430.0, 30.0, 216.0, 130.0), Rect::new(20.0, 280.0, 340.0, 130.0))
}

fn rates(room: Room) -> Plot<'static> {
    let frame = room.of(Rect::new(474.0, 214.0, 172.0, 174.0), Rect::new(64.0, 442.0, 296.0, 110.0));
    let x = Axis::log(1e-7, 1.6, 2).titled(r"tilt $\alpha$, rad");
    Plot { frame, x, y: Axis::log(1e-4, 1e5, 3).titled("rate, rad/s") }
}

/// What the eye looks at, and from how far.
const TARGET: Vector3<f64> = Vector3::new(0.0, 0.0, 0.4);
const DISTANCE: f64 = 9.0;

fn camera(moment: &Moment) -> Result<Camera, Flaw> {
    moment.camera(TARGET, DISTANCE, stage(moment.room).centre(), moment.room.of(132.0, 82.0))
}

impl Spinning {
    fn draw_stage(&self, moment: &Moment, now: &Now, drawing: &mut Drawing) -> Result<(), Cause> {
        let (frame, camera) = (stage(moment.room), camera(moment)?);
        let eye = TARGET + Vector3::from(moment.towards_eye()) * DISTANCE;
        let (sin, cos) = now.coin.tilt().sin_cos();
        let centre = Vector3::new(0.0, 0.0, sin);
        let attitude = self.attitude(now);
        let normal = attitude * Vector3::z();
        let contact = centre + lowest(&attitude);
        let mut stage = Stage::new(camera);
        stage.ground([-1.25, -1.25], [1.25, 1.25], 0.0, 0.25)?;
        stage.curve(Curve::circle([0.0; 3], Vector3::z(), cos.max(1e-3))?, Stroke::Pale, Hue::Pink)?;
        let is_hoop = self.parameters.moments == MomentFactors::HOOP;
        let solid = if is_hoop {
            Solid::ring(centre, normal, 1.0, INNER, THICK)?
        } else {
            Solid::disc(centre, normal, 1.0, THICK)?
        };
        stage.solid(solid, Hue::Blue)?;
        draw_head(&mut stage, centre, attitude, normal.dot(&(eye - centre)), is_hoop)?;
        // What has touched since the round began, where it lies on the table and where it is on the rim now.
        let (begun, reached) = match self.down {
            None => (now.rounds.floor(), now.rounds),
            Some(_) => (0.0, 1.0),
        };
        let stands = now.coin.attitude(reached);
        // What lies on the table at a time, in rounds, and on the rim, as the coin is shown.
        let touch = |rounds: f64| {
            let then = now.coin.attitude(rounds);
            let touching = lowest(&then);
            let on_rim = then.inverse() * touching * 1.003 + Vector3::z() * (0.5 * THICK);
            (Vector3::new(touching.x, touching.y, 0.0), centre + self.as_shown(&stands, &attitude) * on_rim)
        };
        let ink = |from: f64, to: f64| {
            let count = (90.0 * (to - from).min(1.0)).ceil().max(2.0) as u32;
            linear_steps(from, to, count).map(touch).unzip::<_, _, Vec<_>, Vec<_>>()
        };
        let is_long =
            |points: &[Vector3<f64>]| points.windows(2).all(|pair| (pair[1] - pair[0]).norm() > 1e-7);
        let (table, rim) = ink(begun, reached);
        // Of the rim, what the next round will not ink either.
        let (_, rest) = ink(begun + 1.0, begun + 1.0 / cos);
        for (points, hue) in [(&rest, Hue::Blue), (&table, Hue::Pink), (&rim, Hue::Pink)] {
            if is_long(points) {
                stage.curve(Curve::smooth(points.iter().copied())?, Stroke::Curve, hue)?;
            }
        }
        stage.dot(table[0], 3.4, Hue::Ink)?;
        stage.dot(rim[0], 3.4, Hue::Ink)?;
        stage.dot_in_front(contact, 5.0, Hue::Pink)?;
        stage.write(drawing);
        let how = match self.down {
            None => format!("slowed down {} times", few(ROUND * self.start.turn_rate() / TAU)),
            Some(_) => "seen by a lamp that flashes once a round".into(),
        };
        let place = at(frame.left + 8.0, moment.room.of(frame.top + 12.0, frame.bottom - 4.0));
        Ok(drawing.note(place, Side::Right, &how, Hue::Muted)?)
    }

    /// From the coin as it stands to how it is shown: on the way down it is turned by what the head has turned.
    fn as_shown(&self, stands: &UnitQuaternion<f64>, shown: &UnitQuaternion<f64>) -> UnitQuaternion<f64> {
        if self.down.is_some() { *stands } else { *shown }
    }

    /// The circle on the table and the rim, both unrolled, with the ink on them; and the angle of the head.
    fn draw_lengths(&self, moment: &Moment, now: &Now, drawing: &mut Drawing) -> Result<(), Cause> {
        let Rect { left, top, right, .. } = lengths(moment.room);
        let cos = now.coin.tilt().cos();
        let inked = if self.down.is_some() { 1.0 } else { now.rounds.fract() };
        let long = right - left;
        let bar = |drawing: &mut Drawing, from: f64, to: f64, y: f64, fill: Fill, hue: Hue| {
            let corners = [(from, 0.0), (to, 0.0), (to, 14.0), (from, 14.0)];
            let corners = corners.map(|(x, down)| at(left + x * long, y + down)).to_vec();
            drawing.polygon(corners, fill, hue);
        };
        let rows = [
            (top + 8.0, cos, r"the circle on the table, $2\pi a\cos\alpha$"),
            (top + 52.0, 1.0, r"the rim, $2\pi a$"),
        ];
        for (y, whole, name) in rows {
            bar(drawing, 0.0, cos, y, Fill::Face, Hue::Pink);
            bar(drawing, 0.0, cos * inked, y, Fill::Solid, Hue::Pink);
            let end = at(left + whole * long, y);
            for x in [at(left, y), end] {
                drawing.line(x, x + at(0.0, 14.0), Stroke::Outline, Hue::Ink);
            }
            drawing.note(at(left, y - 4.0), Side::AboveRight, name, Hue::Ink)?;
        }
        // What is left over answers the guess.
        let before = drawing.items().len();
        let y = rows[1].0;
        bar(drawing, cos, 1.0, y, Fill::Side, Hue::Blue);
        let rest = 360.0 * (1.0 - cos);
        let text = if rest >= 0.05 {
            format!("left over: {rest:.1}°")
        } else {
            "left over: next to nothing".into()
        };
        let under = at(left + long, y + 18.0);
        drawing.note(under, Side::BelowLeft, &text, Hue::Blue)?;
        // The head's dial: then, now, and what a round adds.
        let dial = at(left + 26.0, y + 52.0);
        let radius = 24.0;
        drawing.circle(dial, radius, Role::Line(Stroke::Outline, Hue::Muted));
        let up = FRAC_PI_2;
        let wedge = TAU * (1.0 - cos);
        if wedge > 1e-3 {
            let begun = now.head - if self.down.is_some() { wedge } else { now.rounds.fract() * wedge };
            let angles = linear_steps(up + begun, up + begun + wedge, 40);
            let arc = angles.map(|angle| dial + Point::polar(radius, angle));
            drawing.polygon([dial].into_iter().chain(arc).collect(), Fill::Face, Hue::Blue);
        }
        kit::arrow(drawing, dial, dial + Point::polar(radius, up + now.head), Hue::Blue);
        let text = "the head turns by as much";
        drawing.label_set(dial + at(radius, 0.0), Side::Right, 8.0, 13.0, text, Role::Text(Hue::Blue))?;
        cover_from(drawing, before);
        Ok(())
    }

    /// The rates against the tilt, the speed of sound, and where each law ends.
    fn draw_rates(&self, moment: &Moment, now: &Now, drawing: &mut Drawing) -> Result<(), Cause> {
        let mut graph = rates(moment.room).on(drawing)?;
        type Rate = fn(&SpinningCoin) -> f64;
        let rates: [(Rate, Hue); 3] = [
            (SpinningCoin::vertical_rate, Hue::Orange),
            (SpinningCoin::figure_rate, Hue::Blue),
            (SpinningCoin::turn_rate, Hue::Pink),
        ];
        graph.level(SOUND / RADIUS, Stroke::Reference, Hue::Muted);
        graph.upright(now.coin.tilt(), Stroke::Dotted, Hue::Muted);
        for (of, hue) in rates {
            let values: Vec<(f64, f64)> = log_steps(1e-7, 10_f64.powf(0.19), 60)
                .map(|tilt| Ok((tilt, of(&SpinningCoin::new(self.parameters, tilt)?))))
                .collect::<Result<_, InvalidQuantity>>()?;
            graph.curve(values, Stroke::Curve, hue);
        }
        for (which, power) in POWERS.into_iter().enumerate() {
            let down = law(SpinningCoin::new(self.parameters, LIFE.1)?, power)?;
            let last = down.with_time_left(down.time_left_at_free_fall())?;
            let end = (last.tilt(), last.turn_rate());
            graph.dot(end, 3.0, Hue::Ink);
            if self.down.is_some_and(|(_, own, _)| own == which) {
                graph.label(end, Side::Below, NAMES[which], Hue::Ink)?;
            }
        }
        for (of, hue) in rates {
            graph.dot((now.coin.tilt(), of(&now.coin)), 4.5, hue);
        }
        graph.label((0.15, SOUND / RADIUS), Side::AboveLeft, "Mach 1", Hue::Muted)?;
        graph.label((4e-3, 3e1), Side::Over, "contact", Hue::Pink)?;
        graph.label((0.08, 6e-3), Side::Over, "head", Hue::Blue)?;
        graph.label((2e-3, 3e-3), Side::AboveLeft, r"$\omega_z$", Hue::Orange)?;
        graph.grip((self.start.tilt(), self.start.turn_rate()), Hue::Ink);
        Ok(())
    }
}

/// Draws the head on the face of a coin that is seen from a height above its middle: on the upper one, and through the
/// other its outline. A hoop has a patch where the top of the head would be.
fn draw_head(
    stage: &mut Stage,
    centre: Vector3<f64>,
    attitude: UnitQuaternion<f64>,
    height: f64,
    is_hoop: bool,
) -> Result<(), Cause> {
    let half = 0.5 * THICK;
    let place = |(u, v): (f64, f64)| centre + attitude * Vector3::new(u, v, half.copysign(height));
    if height.abs() <= half {
        return Ok(()); // only the rim is seen
    }
    if is_hoop {
        let arc = |radius: f64| (-4..=4).map(move |n| Point::polar(radius, FRAC_PI_2 + 0.04 * f64::from(n)));
        let patch = arc(1.0).chain(arc(INNER).collect::<Vec<_>>().into_iter().rev());
        stage.patch(patch.map(|point| place((point.x, -point.y))), Fill::Solid, Hue::Blue)?;
        return Ok(());
    }
    let outline = kit::portrait();
    let closed = outline.iter().chain(&outline[..1]).map(|&point| place(point));
    if height > 0.0 {
        stage.patch(closed.clone(), Fill::Side, Hue::Blue)?;
    }
    let stroke = if height > 0.0 { Stroke::Outline } else { Stroke::Pale };
    stage.curve(Curve::smooth(closed)?.hiding(Hiding::Ignored), stroke, Hue::Blue)?;
    Ok(())
}

impl Motion for Spinning {
    fn run(&self) -> Run {
        let duration = match &self.down {
            None => ROUND * ROUNDS,
            Some((down, _, end)) => (DECADE * (down.life() / end).log10()).max(1.0),
        };
        Run { duration, pace: 1.0, repeats: false }
    }

    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let now = self.at(moment.time)?;
        self.draw_stage(moment, &now, drawing)?;
        self.draw_lengths(moment, &now, drawing)?;
        self.draw_rates(moment, &now, drawing)
    }

    fn readings(&self, time: f64) -> Result<Vec<f64>, Cause> {
        let now = self.at(time)?;
        let coin = now.coin;
        Ok(vec![
            coin.tilt(),
            coin.turn_rate(),
            coin.figure_rate(),
            coin.turn_rate() / TAU,
            coin.contact_speed() / SOUND,
            now.rounds,
            now.head.to_degrees(),
            now.gone,
            now.left,
            self.slip(&now),
        ])
    }

    fn words(&self, _time: f64) -> String {
        let tilt = self.start.tilt();
        match &self.down {
            None => {
                let cos = tilt.cos();
                let slow = self.start.turn_rate() / self.start.figure_rate();
                if slow > 1e6 {
                    let (unit, name) = if slow < 1e9 { (1e6, "million") } else { (1e9, "billion") };
                    return format!(
                        "All but the whole rim rolls off on the table, and the head all but stands: the \
                         contact goes round {} {name} times while the head turns once.",
                        few(slow / unit)
                    );
                }
                format!(
                    "In a round the contact runs {:.3} radii along the table, and as far along the rim, \
                     which has {:.3}. The {} that are left over are the angle by which the head has \
                     turned. The contact goes round {} times while the head turns once.",
                    TAU * cos,
                    TAU,
                    angle(TAU * (1.0 - cos)),
                    few(slow),
                )
            }
            Some((down, which, end)) => {
                let name = ["2", "5/4", "1", "1/2"][*which];
                if *end >= down.life() {
                    return format!(
                        "With p = {name} this tilt is below the end of the law: sinking as it asks would be faster than falling."
                    );
                }
                let last = down.with_time_left(*end);
                let (tilt, mach) =
                    last.map_or((f64::NAN, f64::NAN), |last| (last.tilt(), last.contact_speed() / SOUND));
                let verdict = if mach < 1.0 {
                    "Sound is not reached"
                } else {
                    "By the law, sound has just been passed"
                };
                format!(
                    "With p = {name} it would lie flat after {} s. But {} before that, at a tilt of {} and \
                     Mach {mach:.2}, the law would have it fall faster than g, and holds no longer. \
                     {verdict}.",
                    few(down.life()),
                    seconds(*end),
                    small(tilt),
                )
            }
        }
    }

    /// The whir: how often the contact comes round.
    fn sound(&self, time: f64) -> Option<Sound> {
        let now = self.at(time).ok()?;
        Some(Sound { frequency: now.coin.turn_rate() / TAU, loudness: 0.6 })
    }

    /// The top of the coin, but on the way down, which begins at another tilt.
    fn bodies(&self, moment: &Moment) -> Vec<(Point, f64)> {
        let top =
            self.at(moment.time).map_err(Cause::from).and_then(|now| top(moment, &now.coin, now.rounds));
        top.ok().filter(|_| self.down.is_none()).map_or(Vec::new(), |top| vec![(top, 30.0)])
    }

    fn grips(&self, moment: &Moment) -> Vec<Point> {
        vec![rates(moment.room).point((self.start.tilt(), self.start.turn_rate()))]
    }

    fn drag(&self, grip: usize, to: Point, moment: &Moment) -> Vec<(&'static str, f64)> {
        if grip == 1 {
            let tilts = (1..=300).map(|k| 0.005 * f64::from(k));
            let tilt = nearest([self.start.tilt()].into_iter().chain(tilts), to, |tilt| {
                top(moment, &SpinningCoin::new(self.parameters, tilt)?, moment.time / ROUND)
            });
            return tilt.map_or(Vec::new(), |tilt| vec![("tilt", tilt)]);
        }
        vec![("tilt", rates(moment.room).value(to).0)]
    }
}

/// Where the top of a coin is seen after so many rounds.
fn top(moment: &Moment, coin: &SpinningCoin, rounds: f64) -> Result<Point, Cause> {
    let centre = Vector3::new(0.0, 0.0, coin.tilt().sin());
    Ok(camera(moment)?.on_page(centre - lowest(&coin.attitude(rounds)))?)
}

impl Spinning {
    /// The way of the contact along the table, by its speed, less that along the rim, by how the coin stands: in radii.
    fn slip(&self, now: &Now) -> f64 {
        if self.down.is_some() {
            return f64::NAN;
        }
        let on_rim = |rounds: f64| {
            let attitude = now.coin.attitude(rounds);
            let touching = attitude.inverse() * lowest(&attitude);
            touching.y.atan2(touching.x)
        };
        let along_table = now.coin.contact_speed() * now.gone / RADIUS;
        let slip = along_table - (on_rim(now.rounds) - on_rim(0.0));
        slip - TAU * (slip / TAU).round()
    }
}

/// A number in three digits, as it is written.
fn few(number: f64) -> String {
    match number.abs().log10().floor() {
        power if power < 2.0 => format!("{number:.*}", (2.0 - power).min(12.0) as usize),
        _ => format!("{number:.0}"),
    }
}

/// An angle, rad, as it is written.
fn angle(angle: f64) -> String {
    if angle < 1e-3 { small(angle) } else { format!("{}°", few(angle.to_degrees())) }
}

/// A small angle, rad, as it is written.
pub(super) fn small(angle: f64) -> String {
    if angle < 1e-3 { format!("{} µrad", few(1e6 * angle)) } else { format!("{} rad", few(angle)) }
}

/// A time, s, as it is written.
pub(super) fn seconds(time: f64) -> String {
    if time < 1e-3 { format!("{:.0} µs", 1e6 * time) } else { format!("{:.1} ms", 1e3 * time) }
}
