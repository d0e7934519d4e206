//! The figures of the pages without a number: the cover, the frontispiece, the key of the colours and the map of the
//! chapters.

#[path = "cover.rs"]
mod cover;

use drawing::kit::{Heads, head};
use drawing::space::{Camera, Curve, Finish, Hiding, Solid, Stage, View};
use drawing::{Drawing, Fill, Hue, Point, Role, Room, Shape as Form, Side, Stroke, at};
use figures::{Cause, Figure, Outcome, figures, in_both, linear_steps};
use mechanics::euler::Turning;
use mechanics::free_rotation::FreeSymmetricTop;
use mechanics::inertia::{Body, PrincipalMoments};
use mechanics::integrate::{Dop853, Taylor};
use mechanics::rolling::{DiskParameters, MomentFactors};
use mechanics::scenes::air_drag::{Drag, DraggedTop, DraggedTopParameters};
use mechanics::scenes::ball::{Ball, BallParameters, Turntable, TurntableParameters, TurntableStart};
use mechanics::scenes::coin_toss::{Toss, TossParameters};
use mechanics::scenes::laundromat::{Machine, MachineParameters, Shaft};
use mechanics::scenes::pinned_hoop::{Pin, Pinning, PinningParameters, Shape};
use mechanics::scenes::rolling_wheel::Wheel;
use mechanics::scenes::space_station::{Blow, Station, StationParameters};
use mechanics::scenes::spinning_coin::SpinningCoin;
use mechanics::scenes::top::{Release, Top, TopParameters};
use nalgebra::{Complex, UnitQuaternion, Vector3};
use std::f64::consts::{FRAC_PI_2, TAU};

/// All figures of these pages.
pub(crate) const FIGURES: &[Figure] = figures![cover::cover, frontispiece, colours, chapters_map];

/// Draws what is on one stage.
type Scene = fn(&mut Stage) -> Result<(), Cause>;

/// The height of the floor of all scenes.
const FLOOR: f64 = -1.0;

/// Eleven small scenes on floors of one size, one for each chapter about a thing that spins, each a link to it.
pub(crate) fn frontispiece(id: &str) -> Outcome {
    let scenes: [(&str, &str, &str, Scene); 11] = [
        ("laundromat", "1 Laundromat", "A drum; its shaft spirals out to a circle.", laundromat),
        (
            "turning",
            "2 How a body turns",
            "A plate in the air, its axis and its angular velocity on either side of its angular momentum.",
            turning,
        ),
        (
            "wobble-plate",
            "3 Wobble plate",
            "A tilted plate on a shaft that turns; its angular momentum leans.",
            wobble_plate,
        ),
        ("coin-toss", "4 Coin toss", "A coin at five moments of its flight.", coin_toss),
        (
            "space-station",
            "5 Space station",
            "A ring with spokes, its axis on a cone about the angular momentum.",
            space_station,
        ),
        ("air-drag", "6 Frisbee and pencil", "A disc whose axis spirals in towards the upright.", air_drag),
        (
            "pinned-hoop",
            "7 Pinned hoop",
            "A hoop that tumbles about a pinned point of its rim, at three moments.",
            pinned_hoop,
        ),
        ("top", "8 Top under gravity", "A top that leans; its tip draws loops.", top),
        (
            "rolling-wheel",
            "9 Rolling wheel",
            "A disc that rolls and wobbles on a floor along a wavy track, at three moments.",
            rolling_wheel,
        ),
        (
            "spinning-coin",
            "10 Spinning coin",
            "A coin that leans on a table and rolls round a circle.",
            spinning_coin,
        ),
        ("ball", "11 The ball", "A ball on a table that turns, and the circle on which it rolls.", ball),
    ];
    let draw = |(chapter, name, words, scene): (&str, &str, &str, Scene)| -> Outcome {
        let mut drawing =
            Drawing::new("", 290.0, 260.0).titled(name, words).linked(&format!("{chapter}/index.html"));
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0; 3],
            azimuth: -1.25,
            elevation: 0.45,
            distance: 9.0,
            centre: at(145.0, 140.0),
            scale: 70.0,
        })?);
        stage.ground([-1.6, -1.2], [1.6, 1.2], FLOOR, 0.4)?;
        scene(&mut stage)?;
        stage.write(&mut drawing);
        Ok(drawing)
    };
    let panels = scenes.into_iter().map(draw).collect::<Result<Vec<_>, Cause>>()?;
    Ok(Drawing::panels(id, panels))
}

/// A way that is drawn in full, whatever stands before it.
fn seen(points: impl IntoIterator<Item = Vector3<f64>>) -> Result<Curve, Cause> {
    Ok(Curve::smooth(points)?.hiding(Hiding::Ignored))
}

fn laundromat(stage: &mut Stage) -> Result<(), Cause> {
    let machine = Machine::new(MachineParameters {
        drum_mass: 4.0,
        load_mass: 1.0,
        load_radius: 1.0,
        stiffness: 5.0,
        damping: 1.5,
        spin: 2.0,
    })?;
    let motion = machine.transient(Shaft::AT_REST)?;
    let end = 14.6;
    let place = |time: f64| -> Result<Vector3<f64>, Cause> {
        let shaft = motion.at(time)?.position;
        Ok(Vector3::new(shaft.re, shaft.im, FLOOR + 0.55))
    };
    let path = linear_steps(0.0, end, 500).map(place).collect::<Result<Vec<_>, Cause>>()?;
    let (now, load) = (place(end)?, machine.load_direction(end));
    stage.solid(Solid::ring(now, Vector3::z(), 1.1, 1.04, 0.7)?.finish(Finish::Glass), Hue::Blue)?;
    stage.solid(Solid::sphere(now + Vector3::new(load.re, load.im, 0.0) * 0.9, 0.15)?, Hue::Blue)?;
    stage.curve(seen(path)?, Stroke::Outline, Hue::Ink)?;
    stage.dot_in_front(now, 2.5, Hue::Ink)?;
    Ok(())
}

/// A symmetric body with its angular momentum upright.
fn upright(ratio: f64, omega_body: Vector3<f64>) -> Result<FreeSymmetricTop, Cause> {
    let moments = PrincipalMoments::symmetric(1.0, ratio)?;
    let momentum = moments.angular_momentum(&omega_body);
    let world_from_body =
        UnitQuaternion::rotation_between(&momentum, &Vector3::z()).ok_or("L is not opposite")?;
    Ok(FreeSymmetricTop::new(moments, Turning { world_from_body, omega_body })?)
}

fn turning(stage: &mut Stage) -> Result<(), Cause> {
    let top = upright(2.0, Vector3::new(1.1, 0.0, 1.3))?;
    let round = TAU / top.precession_rate();
    let start = 0.7 + 0.25 * round; // the axis leans to the side
    let now = top.at(start)?;
    let way = linear_steps(start, start + 0.85 * round, 120)
        .map(|time| Ok(top.at(time)?.axis_3_world() * 1.45))
        .collect::<Result<Vec<_>, Cause>>()?;
    stage.solid(Solid::disc([0.0; 3], now.axis_3_world(), 1.0, 0.06)?, Hue::Blue)?;
    stage.arrow(seen(way)?, Stroke::Outline, Heads::End, Hue::Ink)?;
    stage.vector([0.0; 3], now.axis_3_world() * 1.45, Hue::Ink)?;
    stage.vector([0.0; 3], [0.0, 0.0, 1.7], Hue::Green)?;
    stage.vector([0.0; 3], now.omega_world() * (1.4 / now.omega_world().norm()), Hue::Orange)?;
    Ok(())
}

fn wobble_plate(stage: &mut Stage) -> Result<(), Cause> {
    let tilt = UnitQuaternion::from_scaled_axis(Vector3::new(0.0, -0.45, 0.0));
    let moments = Body::thin_disk(1.0, 1.0)?.moments();
    let momentum = tilt * moments.angular_momentum(&(tilt.inverse() * Vector3::z()));
    stage.solid(Solid::disc([0.0; 3], tilt * Vector3::z(), 1.0, 0.08)?, Hue::Blue)?;
    stage.solid(Solid::rod([0.0, 0.0, FLOOR], [0.0, 0.0, 1.0], 0.05)?, Hue::Muted)?;
    stage.vector([0.0, 0.0, 1.0], [0.0, 0.0, 1.75], Hue::Orange)?;
    stage.turning([0.0, 0.0, 1.35], [0.0, 0.0, 1.0], 0.25, Hue::Orange)?;
    stage.vector([0.0; 3], momentum.normalize() * 1.6, Hue::Green)?;
    Ok(())
}

fn coin_toss(stage: &mut Stage) -> Result<(), Cause> {
    let moments = Body::thin_disk(0.0075, 0.0122)?.moments();
    let toss = Toss::new(TossParameters { moments, omega_1: 1.0, omega_3: 0.25 })?;
    let round = TAU / toss.precession_rate();
    for (still, along) in linear_steps(-1.3, 1.3, 4).enumerate() {
        let normal = toss.normal(0.22 * still as f64 * round)?;
        let centre = Vector3::new(along, 0.0, 0.95 - 0.75 * along * along);
        let coin = Solid::disc(centre, normal, 0.48, 0.08)?;
        stage.solid(if still < 4 { coin.finish(Finish::Ghost) } else { coin }, Hue::Blue)?;
    }
    let path = linear_steps(-1.3, 1.3, 80).map(|along| Vector3::new(along, 0.0, 0.95 - 0.75 * along * along));
    stage.curve(seen(path)?, Stroke::Dotted, Hue::Muted)?;
    Ok(())
}

fn space_station(stage: &mut Stage) -> Result<(), Cause> {
    let (mass, radius) = (4e5, 50.0);
    let station = Station::new(StationParameters { body: Body::hoop(mass, radius)?, spin: 0.45 })?;
    let struck = station.struck(Blow { radius, impulse: 5e6 })?;
    let upright = UnitQuaternion::rotation_between(&struck.angular_momentum_world(), &Vector3::z())
        .ok_or("L is not opposite")?;
    let axis = |time: f64| Ok(upright * struck.at(time)?.axis_3_world() * 1.45);
    let now = upright * struck.at(0.0)?.world_from_body;
    stage.solid(Solid::ring([0.0; 3], now * Vector3::z(), 1.0, 0.84, 0.16)?, Hue::Blue)?;
    stage.solid(Solid::sphere([0.0; 3], 0.16)?, Hue::Blue)?;
    for quarter in 0..4 {
        let (sin, cos) = (FRAC_PI_2 * (f64::from(quarter) + 0.5)).sin_cos();
        let outwards = now * Vector3::new(cos, sin, 0.0);
        stage.solid(Solid::rod(outwards * 0.1, outwards * 0.88, 0.035)?, Hue::Blue)?;
    }
    // Once round, less a little: L/I₁ is the rate.
    let transverse = 0.5 * mass * radius * radius;
    let round = TAU * transverse / struck.angular_momentum_world().norm();
    let way = linear_steps(0.0, 0.85 * round, 120).map(axis).collect::<Result<Vec<_>, Cause>>()?;
    stage.arrow(seen(way)?, Stroke::Outline, Heads::End, Hue::Ink)?;
    stage.vector([0.0; 3], axis(0.0)?, Hue::Ink)?;
    stage.vector([0.0; 3], [0.0, 0.0, 1.7], Hue::Green)?;
    Ok(())
}

fn air_drag(stage: &mut Stage) -> Result<(), Cause> {
    let moments = PrincipalMoments::symmetric(1.0, 2.0)?;
    let omega_body = Vector3::new(3.6, 0.0, 4.0);
    let top = DraggedTop::new(DraggedTopParameters { moments, drag: Drag::isotropic(0.35), omega_body })?;
    let momentum = moments.angular_momentum(&omega_body);
    let upright = UnitQuaternion::rotation_between(&momentum, &Vector3::z()).ok_or("L is not opposite")?;
    let times: Vec<f64> = linear_steps(0.0, 6.0, 600).collect();
    let states = top.thrown(upright, &Dop853::new(1e-9)?)?.sample(&times)?;
    let way: Vec<_> = states.iter().map(|state| state.axis_3_world() * 1.4).collect();
    let (first, last) = (way[0], way[way.len() - 1]);
    stage.solid(Solid::disc([0.0; 3], last, 1.0, 0.12)?, Hue::Blue)?;
    stage.curve(seen(way)?, Stroke::Outline, Hue::Ink)?;
    stage.dot_in_front(first, 2.5, Hue::Ink)?;
    stage.vector([0.0; 3], last, Hue::Ink)?;
    Ok(())
}

fn pinned_hoop(stage: &mut Stage) -> Result<(), Cause> {
    let pin = Pin::Angle(89.9_f64.to_radians());
    let hoop =
        Pinning::new(PinningParameters { shape: Shape::Hoop, mass: 1.0, radius: 1.0, spin: 1.0, pin })?;
    let upright = UnitQuaternion::rotation_between(&hoop.angular_momentum(), &Vector3::z())
        .ok_or("L is not opposite")?;
    let top = hoop.free_motion()?;
    let low = Vector3::new(0.0, 0.0, -0.2);
    for (time, finish) in [(22.0, Finish::Ghost), (26.0, Finish::Ghost), (30.0, Finish::Opaque)] {
        let room = upright * top.at(time)?.world_from_body;
        let (centre, axis) = (low + room * hoop.centre() * 0.8, room * Vector3::z());
        stage.solid(Solid::ring(centre, axis, 0.8, 0.7, 0.09)?.finish(finish), Hue::Blue)?;
    }
    let momentum = Curve::segment(low, low + Vector3::z() * 1.75)?;
    stage.arrow(momentum.hiding(Hiding::Ignored), Stroke::Vector, Heads::End, Hue::Green)?;
    stage.dot_in_front(low, 3.5, Hue::Pink)?;
    Ok(())
}

fn top(stage: &mut Stage) -> Result<(), Cause> {
    let toy = TopParameters { mass: 0.1, arm: 0.04, transverse: 2e-4, axial: 5e-5, gravity: 9.81 };
    let pushed = Release { tilt: 0.6, tilt_rate: 0.0, precession: -4.0, spin: 170.0 };
    let motion = Top::new(toy)?.let_go(pushed)?;
    let point = Vector3::new(0.0, 0.0, FLOOR);
    let duration = 3.4 * motion.nod_period().ok_or("it nods")?;
    let axis = |time: f64| -> Result<Vector3<f64>, Cause> { Ok(motion.at(time)?.axis_3_world()) };
    let track = linear_steps(0.0, duration, 400)
        .map(|time| Ok(point + axis(time)? * 1.9))
        .collect::<Result<Vec<_>, Cause>>()?;
    let now = axis(duration)?;
    stage.solid(Solid::disc(point + now * 1.0, now, 0.62, 0.16)?, Hue::Blue)?;
    stage.solid(Solid::rod(point, point + now * 1.9, 0.04)?, Hue::Blue)?;
    stage.curve(seen(track)?, Stroke::Outline, Hue::Ink)?;
    stage.dot_in_front(point, 3.5, Hue::Pink)?;
    Ok(())
}

fn rolling_wheel(stage: &mut Stage) -> Result<(), Cause> {
    let parameters = DiskParameters { mass: 1.0, radius: 1.0, moments: MomentFactors::DISK, gravity: 1.0 };
    let wheel = Wheel::new(parameters)?;
    let mut start = wheel.steady(0.55, 1.6)?.state();
    start.omega_1 = 0.3;
    let wobble = wheel.wobble(start, &Taylor::new(1e-14)?)?;
    let times: Vec<f64> = linear_steps(0.0, 2.6 * wobble.period(), 400).collect();
    let states = wobble.sample(&times)?;
    let scale = 0.52;
    let middle = states.iter().map(|state| state.contact(1.0)).sum::<Complex<f64>>() / states.len() as f64;
    let contact = |place: Complex<f64>| {
        let place = (place - middle) * scale;
        Vector3::new(place.re, place.im, FLOOR)
    };
    let track = states.iter().map(|state| contact(state.contact(1.0)));
    stage.curve(seen(track)?, Stroke::Curve, Hue::Pink)?;
    for (still, finish) in [(150, Finish::Ghost), (275, Finish::Ghost), (400, Finish::Opaque)] {
        let state = states[still];
        let foot = contact(state.contact(1.0));
        let centre = contact(state.centre) + Vector3::z() * (state.tilt.sin() * scale);
        let up = centre - foot;
        let axle = up.cross(&Vector3::z().cross(&up));
        stage.solid(Solid::disc(centre, axle, scale, 0.07)?.finish(finish), Hue::Blue)?;
        if still == 400 {
            stage.dot_in_front(foot, 3.5, Hue::Pink)?;
        }
    }
    Ok(())
}

fn ball(stage: &mut Stage) -> Result<(), Cause> {
    let ball = Ball::new(BallParameters { radius: 0.35, moment_factor: Ball::SOLID })?;
    let table = Turntable::new(TurntableParameters { ball, rate: 3.5, slope: 0.0, gravity: 9.81 })?;
    let roll = table.roll(TurntableStart { place: [0.9, 0.1], velocity: [-0.1, 0.75], pivot: 0.0 })?;
    let period = roll.period().ok_or("the table is at rest")?;
    let down = Vector3::new(0.0, 0.0, FLOOR);
    let track = linear_steps(0.0, period, 120)
        .map(|time| roll.at(time).map(|state| state.centre + down))
        .collect::<Result<Vec<_>, _>>()?;
    stage.curve(Curve::smooth(track)?.hiding(Hiding::Dashed), Stroke::Curve, Hue::Pink)?;
    stage.turning(down, Vector3::z(), 0.3, Hue::Orange)?;
    let centre = roll.at(0.8 * period)?.centre + down + Vector3::z() * ball.radius();
    stage.solid(Solid::sphere(centre, ball.radius())?, Hue::Blue)?;
    stage.dot_in_front(centre - Vector3::z() * ball.radius(), 3.5, Hue::Pink)?;
    Ok(())
}

fn spinning_coin(stage: &mut Stage) -> Result<(), Cause> {
    let coin = SpinningCoin::new(
        DiskParameters { mass: 0.4, radius: 0.0375, moments: MomentFactors::DISK, gravity: 9.81 },
        0.45,
    )?;
    let (sin, cos) = coin.tilt().sin_cos();
    let (centre, down) = (Vector3::new(0.0, 0.0, sin), Vector3::new(0.0, 0.0, FLOOR));
    let second = Vector3::new(cos * 0.94, cos * 0.34, sin);
    let normal = Vector3::new(-sin * 0.94, -sin * 0.34, cos);
    let circle = Curve::circle(down, Vector3::z(), cos)?;
    stage.curve(circle.hiding(Hiding::Dashed), Stroke::Curve, Hue::Pink)?;
    stage.solid(Solid::disc(centre + down, normal, 1.0, 0.06)?, Hue::Blue)?;
    stage.vector(centre + down, centre + down + Vector3::z() * 1.4, Hue::Orange)?;
    stage.turning(centre + down + Vector3::z() * 0.95, Vector3::z(), 0.25, Hue::Orange)?;
    stage.dot_in_front(centre - second + down, 3.5, Hue::Pink)?;
    Ok(())
}

/// What each colour stands for, on a wheel that rolls round a circle.
pub(crate) fn colours(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 320.0).titled(
        "What the colours stand for",
        "A wheel, blue, leans inward as it rolls round. From its centre come its axes 1, 2 and 3 in the colour of the text, \
         its angular velocity omega in orange, and its angular momentum L in green, which lies nearer to the axle. A pink dot marks \
         the contact with the table, and from it the force of the table points up and inward, in purple.",
    );
    let (lean, b) = (0.5_f64, 1.0);
    let wheel =
        Wheel::new(DiskParameters { mass: 1.0, radius: 1.0, moments: MomentFactors::DISK, gravity: 1.0 })?;
    let steady = wheel.steady(lean, b)?;
    // Outward along y and up along z, as in the chapter of the wheel.
    let (sin, cos) = lean.sin_cos();
    let axes = [Vector3::x(), Vector3::new(0.0, -sin, cos), Vector3::new(0.0, -cos, -sin)];
    let centre = Vector3::new(0.0, b, cos);
    let contact = centre - axes[1];
    let in_room = |body: Vector3<f64>| axes[0] * body.x + axes[1] * body.y + axes[2] * body.z;
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.9, 0.7],
        azimuth: -1.1,
        elevation: 0.32,
        distance: 12.0,
        centre: at(190.0, 170.0),
        scale: 88.0,
    })?);
    stage.solid(Solid::ring(centre, axes[2], 1.0, 0.86, 0.12)?, Hue::Blue)?;
    for (axis, length, name) in [
        (axes[0], 1.3, r"$\hat{\mathbf{1}}$"),
        (axes[1], 1.35, r"$\hat{\mathbf{2}}$"),
        (axes[2], 0.8, r"$\hat{\mathbf{3}}$"),
    ] {
        stage.named_vector(centre, centre + axis * length, name, Hue::Ink)?;
    }
    let omega = in_room(steady.omega());
    let momentum = in_room(steady.angular_momentum());
    let force = Vector3::new(0.0, -steady.friction_needed(), 1.0);
    let mut named = |from: Vector3<f64>, way: Vector3<f64>, length: f64, side: Side, name: &str, hue: Hue| {
        let tip = from + way.normalize() * length;
        let arrow = Curve::segment(from, tip)?.hiding(Hiding::Ignored);
        stage.arrow(arrow, Stroke::Vector, Heads::End, hue)?;
        stage.label(tip, side, name, hue)?;
        Ok::<(), Cause>(())
    };
    named(centre, omega, 2.1, Side::Left, r"angular velocity $\boldsymbol{\omega}$", Hue::Orange)?;
    named(centre, momentum, 1.8, Side::Left, r"angular momentum $\boldsymbol{L}$", Hue::Green)?;
    named(contact, force, 0.55, Side::Right, "force", Hue::Purple)?;
    stage.dot_in_front(contact, 4.5, Hue::Pink)?;
    stage.label_shifted(contact, at(2.0, 6.0), Side::BelowRight, "contact", Hue::Pink)?;
    let rim = centre + axes[0] * 0.6 + axes[1] * 0.8;
    stage.label_shifted(rim, at(0.0, 0.0), Side::AboveRight, "body", Hue::Blue)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// Where a chapter stands on the map: its folder, its name there, and the column and the row of its box on a wide page
/// and on a phone.
type Place = (&'static str, &'static str, [f64; 2], [f64; 2]);

/// The chapters, and the corner of each box in columns and rows.
const CHAPTERS: [Place; 15] = [
    ("laundromat", "1 Laundromat", [0.0, 0.0], [0.0, 0.0]),
    ("turning", "2 How a body turns", [0.0, 3.0], [0.0, 1.0]),
    ("wobble-plate", "3 Wobble plate", [1.0, 0.0], [1.0, 2.0]),
    ("coin-toss", "4 Coin toss", [1.0, 1.0], [1.0, 3.0]),
    ("space-station", "5 Space station", [1.0, 2.0], [1.0, 4.0]),
    ("air-drag", "6 Frisbee and pencil", [1.0, 3.0], [1.0, 5.0]),
    ("rolling-wheel", "9 Rolling wheel", [1.0, 4.0], [1.0, 6.0]),
    ("spinning-coin", "10 Spinning coin", [2.0, 4.0], [2.0, 7.0]),
    ("ball", "11 The ball", [1.0, 5.0], [1.0, 8.0]),
    ("pinned-hoop", "7 Pinned hoop", [1.0, 6.0], [1.0, 9.0]),
    ("top", "8 Top under gravity", [2.0, 6.0], [2.0, 10.0]),
    ("methods", "12 Methods", [1.0, 7.0], [1.0, 11.0]),
    ("judged", "14 Judged by others", [2.0, 7.0], [2.0, 12.0]),
    ("speed-and-accuracy", "13 Speed and accuracy", [2.0, 8.0], [2.0, 13.0]),
    ("hard-cases", "15 Hard cases", [2.0, 9.0], [2.0, 14.0]),
];

/// Which chapter leads to which; what a chapter needs by way of another is left out.
const LEADS_TO: [(&str, &str); 13] = [
    ("turning", "wobble-plate"),
    ("turning", "coin-toss"),
    ("turning", "space-station"),
    ("turning", "air-drag"),
    ("turning", "rolling-wheel"),
    ("turning", "ball"),
    ("turning", "pinned-hoop"),
    ("turning", "methods"),
    ("rolling-wheel", "spinning-coin"),
    ("pinned-hoop", "top"),
    ("methods", "judged"),
    ("methods", "speed-and-accuracy"),
    ("methods", "hard-cases"),
];

/// Which chapters need which.
pub(crate) fn chapters_map(id: &str) -> Outcome {
    in_both(|room| {
        let (step, pitch, size) = (room.of([230.0, 46.0], [46.0, 42.0]), 30.0, [168.0, 30.0]);
        let width = room.of(640.0, 330.0);
        let mut drawing = Drawing::new(id, width, pitch + room.of(10.0, 15.0) * step[1]).titled(
            "Which chapters need which",
            "Fifteen boxes, one for each chapter, and arrows from what is needed. The laundromat stands alone. From \
             chapter 2, How a body turns, arrows lead to chapters 3 to 7, 9, 11 and 12; from 9, the rolling wheel, to 10, the \
             spinning coin; from 12, Methods, to 13, 14 and 15; and from 7, the pinned hoop, to 8, the top under gravity.",
        );
        let corner = |chapter: &str| -> Result<Point, Cause> {
            let place = CHAPTERS.iter().find(|place| place.0 == chapter).ok_or("no such chapter")?;
            let [column, row] = room.of(place.2, place.3);
            Ok(at(10.0 + column * step[0], 10.0 + row * step[1]))
        };
        // The farthest first: what it shares with a nearer one is drawn once.
        let mut arrows = LEADS_TO
            .into_iter()
            .map(|(from, to)| Ok((corner(to)?.y - corner(from)?.y, from, to)))
            .collect::<Result<Vec<_>, Cause>>()?;
        arrows.sort_by(|one, other| other.0.abs().total_cmp(&one.0.abs()));
        let mut trunks: Vec<[Point; 2]> = Vec::new();
        for (_, from, to) in arrows {
            let (start, end) = (corner(from)?, corner(to)?);
            let middle = 0.5 * size[1];
            let way = if room == Room::Narrow {
                let trunk = start.x + 0.5 * step[0];
                vec![at(trunk, start.y + size[1]), at(trunk, end.y + middle), at(end.x, end.y + middle)]
            } else {
                let [out, end] = [at(start.x + size[0], start.y + middle), at(end.x, end.y + middle)];
                let trunk = 0.5 * (out.x + end.x);
                vec![out, at(trunk, out.y), at(trunk, end.y), end]
            };
            let count = way.len();
            let [fork, turn] = [way[count - 3], way[count - 2]];
            let lies_on = |point: Point, [one, other]: &[Point; 2]| {
                (point.x - one.x).abs() < 0.1 && (point.y - one.y) * (point.y - other.y) <= 0.0
            };
            let first =
                [turn, fork].iter().position(|point| trunks.iter().any(|trunk| lies_on(*point, trunk)));
            let way = &way[first.map_or(0, |place| count - 2 - place)..];
            trunks.push([fork, turn]);
            let tip = way[way.len() - 1];
            let direction = tip - way[way.len() - 2];
            let neck = tip - direction.unit() * 6.0;
            let line = way[..way.len() - 1].iter().copied().chain([neck]).collect();
            drawing.push(Role::Line(Stroke::Outline, Hue::Ink), Form::Polyline(line));
            drawing.name_curve(&format!("{from}-to-{to}"), 1);
            head(&mut drawing, tip, direction, 0.8, Hue::Ink);
        }
        for (chapter, name, ..) in CHAPTERS {
            let start = corner(chapter)?;
            let (right, bottom) = (start.x + size[0], start.y + size[1]);
            let corners = [start, at(right, start.y), at(right, bottom), at(start.x, bottom), start];
            drawing.polygon(corners[..4].to_vec(), Fill::Page, Hue::Ink);
            drawing.polygon(corners[..4].to_vec(), Fill::Ground, Hue::Ink);
            drawing.push(Role::Line(Stroke::Outline, Hue::Ink), Form::Polyline(corners.to_vec()));
            let middle = at(start.x + 0.5 * size[0], start.y + 0.5 * size[1]);
            drawing.label_set(middle, Side::Over, 0.0, 13.0, name, Role::PlainText(Hue::Ink))?;
        }
        Ok(drawing)
    })
}
