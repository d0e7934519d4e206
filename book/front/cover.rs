//! The drawing of the title page.

use drawing::kit;
use drawing::space::{Camera, Curve, Finish, Hiding, Solid, Stage, View};
use drawing::{Drawing, Fill, Flaw, Hue, Point, Room, Stroke, at};
use figures::{Cause, Outcome, in_both, linear_steps};
use mechanics::integrate::Taylor;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::{Wheel, Wobble};
use nalgebra::{Complex, Vector3};
use std::f64::consts::TAU;

/// The coin: its radius is one.
const THICKNESS: f64 = 0.1;
/// How many wobbles are on the floor; eleven of them close the rosette. How many wobbles ago the coin was at the ghosts.
const WOBBLES: f64 = 10.5;
const GHOSTS: [f64; 3] = [0.6, 2.35, 4.05];
/// Where the track begins, in wobbles, and by how much the head on the face is turned from the mark that stood lowest there, rad.
const BEGINS: f64 = 0.35;
const STAMPED: f64 = 3.9;
/// By how much the rosette is turned, so that the coin is in front, rad.
const TURN: f64 = 4.3;
/// The kick that makes it close, in √(g/a).
const KICK: f64 = 0.4837;

/// A coin that rolls and wobbles, and has drawn a rosette on a large floor.
pub(crate) fn cover(id: &str) -> Outcome {
    let wheel =
        Wheel::new(DiskParameters { mass: 1.0, radius: 1.0, moments: MomentFactors::DISK, gravity: 1.0 })?;
    let start = Rolling { omega_1: KICK, ..wheel.steady(0.25, 1.0)?.state() };
    let wobble = wheel.wobble(start, &Taylor::new(1e-14)?)?;
    in_both(|room| drawn(id, room, &wobble))
}

fn drawn(id: &str, room: Room, wobble: &Wobble) -> Outcome {
    let size = room.of((700.0, 350.0), (360.0, 330.0));
    let mut drawing = Drawing::new(id, size.0, size.1).titled(
        "A coin rolls over a large floor",
        "A coin leans as it rolls, with a head on its face. Behind it lies its track, a line that has run round ten loops \
         like the petals of a flower, the latest the heaviest; pale coins stand where it was before.",
    );
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.0],
        azimuth: -1.5,
        elevation: room.of(0.58, 0.74),
        distance: 17.0,
        centre: room.of(at(350.0, 176.0), at(180.0, 180.0)),
        scale: room.of(47.0, 37.0),
    })?);
    let half = room.of([5.4, 4.9], [5.0, 5.0]);
    stage.ground([-half[0], -half[1]], half, 0.0, room.of(0.45, 0.625))?;
    let period = wobble.period();
    let times: Vec<f64> = linear_steps(BEGINS * period, WOBBLES * period, 6000).collect();
    let states = wobble.sample(&times)?;
    // The middle of the rosette: the mean of whole wobbles that close it.
    let round = wobble.sample(&linear_steps(0.0, 11.0 * period, 4400).collect::<Vec<_>>())?;
    let middle = round.iter().map(|state| state.contact(1.0)).sum::<Complex<f64>>() / round.len() as f64;
    let foot = |state: &Rolling| {
        let place = (state.contact(1.0) - middle) * Complex::cis(TURN);
        Vector3::new(place.re, place.im, 0.0)
    };
    let last = states.len() - 1;
    // The older, the thinner.
    let parts = [0, 6 * last / 10, 9 * last / 10, last];
    let strokes = room
        .of([Stroke::Orbit, Stroke::Curve, Stroke::Heavy], [Stroke::Outline, Stroke::Orbit, Stroke::Curve]);
    for (ends, stroke) in parts.windows(2).zip(strokes) {
        let way = Curve::smooth(states[ends[0]..=ends[1]].iter().map(foot))?;
        stage.curve(way.hiding(Hiding::Omitted), stroke, Hue::Pink)?;
    }
    for ago in GHOSTS {
        let state = wobble.at((WOBBLES - ago) * period)?;
        let [centre, _, third] = placed(&state, foot(&state));
        stage.solid(Solid::disc(centre, third, 1.0, THICKNESS)?.finish(Finish::Ghost), Hue::Blue)?;
    }
    let now = states[last];
    let [centre, second, third] = placed(&now, foot(&now));
    stage.solid(Solid::disc(centre, third, 1.0, THICKNESS)?, Hue::Blue)?;
    face(&mut stage, centre, second, third, now.roll_angle)?;
    stage.dot_in_front(foot(&now), room.of(4.0, 3.5), Hue::Pink)?;
    // Its shadow, in a light from above, from the left and from behind the eye.
    let first = second.cross(&third);
    let shadow = linear_steps(0.0, TAU, 120).map(|angle| {
        let rim = centre + first * angle.cos() + second * angle.sin();
        stage.camera().on_page(rim + Vector3::new(0.55, 0.35, -1.0) * rim.z)
    });
    drawing.polygon(shadow.collect::<Result<Vec<Point>, Flaw>>()?, Fill::Ground, Hue::Ink);
    stage.write(&mut drawing);
    Ok(drawing)
}

/// The centre of a coin that stands on a point of the floor, and its axes 2 and 3.
fn placed(state: &Rolling, foot: Vector3<f64>) -> [Vector3<f64>; 3] {
    let (sin, cos) = state.lean().sin_cos();
    let heading = state.heading + TURN;
    let outward = Vector3::new(-heading.sin(), heading.cos(), 0.0);
    let second = Vector3::z() * cos - outward * sin;
    [foot + second, second, -outward * cos - Vector3::z() * sin]
}

/// What is stamped on the face that is seen: a head in a ring.
fn face(
    stage: &mut Stage,
    centre: Vector3<f64>,
    second: Vector3<f64>,
    third: Vector3<f64>,
    rolled: f64,
) -> Result<(), Cause> {
    let first = second.cross(&third);
    let (sin, cos) = (rolled + STAMPED).sin_cos();
    let [across, up] = [first * cos + second * sin, second * cos - first * sin];
    let eye = Vector3::new(0.15, -0.99, 0.5);
    let side = third.dot(&eye).signum();
    let on_face =
        |(u, v): (f64, f64)| centre + across * (u * side) + up * v + third * (0.5 * side * THICKNESS);
    let profile: Vec<Vector3<f64>> = kit::portrait().into_iter().map(on_face).collect();
    stage.patch(profile.clone(), Fill::Side, Hue::Blue)?;
    stage.curve(Curve::smooth(profile)?.hiding(Hiding::Omitted), Stroke::Outline, Hue::Blue)?;
    let ring = linear_steps(0.0, TAU, 120).map(|angle| on_face((0.86 * angle.cos(), 0.86 * angle.sin())));
    Ok(stage.curve(Curve::smooth(ring)?.hiding(Hiding::Omitted), Stroke::Outline, Hue::Blue)?)
}
