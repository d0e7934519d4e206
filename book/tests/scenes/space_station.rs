//! The scene of the chapter "The struck space station": its counters by a simulation, the second blow, its grips.

use drawing::{Hue, Point, Role, Room, Shape, at};
use live::{Moment, Player, Scene};
use mechanics::euler::{self, Turning};
use mechanics::inertia::Body;
use mechanics::integrate::Dop853;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::TAU;

const SPIN: f64 = 0.45;

fn scene() -> &'static Scene {
    pages::scenes::named("space-station").expect("the scene")
}

fn played(settings: &[(&str, f64)]) -> Player {
    Player::new(scene()).and_then(|player| player.changed(settings)).expect("settings with an answer")
}

fn preset(words: &str) -> Player {
    played(scene().presets.iter().find(|preset| preset.words.contains(words)).expect("a preset").settings)
}

/// The number of a reading that is written with digits after its point.
fn reading(player: &Player, name: &str, time: f64) -> f64 {
    let index =
        scene().readings.iter().position(|reading| reading.words.starts_with(name)).expect("a reading");
    let text = player.readings(time).expect("readings")[index].replace('−', "-");
    text.split('\u{a0}').next().and_then(|number| number.parse().ok()).unwrap_or_else(|| panic!("`{text}`"))
}

/// Turns that a direction makes about an axis, from one of some moments to the next; they lie close.
fn turns(directions: &[Vector3<f64>], axis: &Vector3<f64>) -> f64 {
    let across = |direction: &Vector3<f64>| direction - axis * direction.dot(axis);
    let step = |pair: &[Vector3<f64>]| {
        let [from, to] = [across(&pair[0]), across(&pair[1])];
        from.cross(&to).dot(axis).atan2(from.dot(&to))
    };
    directions.windows(2).map(step).sum::<f64>() / TAU
}

#[test]
fn a_simulation_counts_the_same() {
    let mut random = fastrand::Rng::with_seed(48);
    let moments = Body::hoop(4e5, 50.0).expect("a ring").moments();
    for _ in 0..8 {
        let (impulse, place) = (0.1 * f64::from(random.u32(4..=60)), f64::from(random.u32(20..=50)));
        let player = played(&[("impulse", impulse), ("place", place)]);
        let omega = Vector3::new(place * impulse * 1e6 / moments.to_array()[0], 0.0, SPIN);
        let start = Turning { world_from_body: UnitQuaternion::identity(), omega_body: omega };
        let time = 5.0 + 45.0 * random.f64();
        let times: Vec<f64> = (0..=600).map(|step| time * f64::from(step) / 600.0).collect();
        let rates = euler::turning_rates(moments, |_, _| Vector3::zeros());
        let sampled = Dop853::new(1e-11).expect("a solver").sample(rates, 0.0, start.to_array(), &times);
        let states = sampled.expect("a simulation").0;
        let states: Vec<Turning> = states.into_iter().map(Turning::from_array).collect();
        let momentum = start.angular_momentum_world(&moments).normalize();
        let seen = |what: fn(&Turning) -> Vector3<f64>| states.iter().map(what).collect::<Vec<_>>();
        let nods = turns(&seen(Turning::axis_3_world), &momentum);
        let on_board = turns(&seen(|state| state.omega_body), &Vector3::z());
        assert!((reading(&player, "nods", time) - nods).abs() < 0.006, "{nods}");
        assert!((reading(&player, r"turns of $", time) - on_board).abs() < 0.006, "{on_board}");
        // A mark goes round unevenly; over so long a time it has made as many turns to within a part of one.
        let mark = turns(&seen(|state| state.world_from_body * Vector3::y()), &momentum);
        assert!((reading(&player, "turns of the mark", time) - mark).abs() < 0.2, "{mark}");
    }
}

#[test]
fn two_waves_in_the_room_make_one_on_board() {
    let player = played(&[]);
    let turn = TAU / SPIN;
    assert_eq!(reading(&player, "nods", 4.0 * turn), 8.16);
    assert_eq!(reading(&player, r"turns of $", 4.0 * turn), 4.0);
    assert_eq!(reading(&player, "turns of the mark", 4.0 * turn), 4.16);
}

#[test]
fn one_second_blow_stops_the_nod_and_another_leaves_nothing() {
    let words = preset("where it struck").words(0.0);
    assert!(words.contains("leaves no nod") && words.contains("2.8° away"), "{words}");
    let words = preset("after one nod").words(0.0);
    assert!(words.contains("leaves nothing"), "{words}");
    let later = preset("after one nod");
    assert_eq!(reading(&later, "drift", 20.0), 0.0);
    assert_eq!(reading(&later, "nods", 50.0), reading(&later, "nods", 20.0));
    // At a wrong moment it makes things worse.
    let words = played(&[("fire", 7.0)]).words(0.0);
    assert!(words.contains("a nod of 43.6°"), "{words}");
}

#[test]
fn extremes_say_so() {
    for (settings, said) in
        [([("impulse", 0.0)], "No blow"), ([("place", 0.0)], "drifts off at 4.50\u{a0}m/s")]
    {
        let player = played(&settings);
        assert!(player.words(0.0).contains(said), "{}", player.words(0.0));
        assert_eq!(reading(&player, "nods", 30.0), 0.0);
        assert_eq!(reading(&player, "turns of the mark", 4.0 * TAU / SPIN), 4.0);
    }
}

/// Draws grips to where they stand, which changes nothing, and to where they stand for other settings.
#[test]
fn grips_follow_the_hand() {
    let [azimuth, elevation] = scene().view.expect("a view");
    for (room, time, start, end) in [
        (Room::Wide, 1.0, vec![], vec![("place", 30.0)]),
        (Room::Narrow, 1.0, vec![], vec![("impulse", 7.5)]),
        (Room::Wide, 20.0, vec![("fire", 9.0)], vec![("thruster", 120.5)]),
        (Room::Narrow, 5.0, vec![("fire", 9.0), ("camera", 1.0)], vec![("thruster", 300.0)]),
        (Room::Wide, 5.0, vec![("fire", 9.0)], vec![("fire", 33.0)]),
    ] {
        let moment = Moment { time, azimuth, elevation, room };
        let drawn = |settings: &[(&str, f64)]| {
            let mut player = played(settings);
            player.draw(moment).expect("a picture");
            player
        };
        let from = drawn(&start);
        let to = drawn(&[start, end.clone()].concat());
        let grips = from.grips();
        for (grip, place) in grips.iter().enumerate() {
            let values = from.drag(grip, *place).expect("values");
            for (value, old) in values.iter().zip(from.values()) {
                assert!((value - old).abs() < 1e-9, "grip {grip}: {value} for {old}");
            }
        }
        // The grip that the change moves, but for those that go with it.
        let far = |grip: &usize| (to.grips()[*grip] - grips[*grip]).length();
        let moved = (0..grips.len()).filter(|grip| far(grip) > 5.0);
        let moved = if end[0].0 == "place" { moved.min() } else { moved.max() };
        let moved = moved.expect("a grip that moves");
        let hand: Point = to.grips()[moved] + at(0.3, 0.0);
        let values = from.drag(moved, hand).expect("values");
        let mut after = Player::with(scene(), values).expect("values in range");
        after.draw(moment).expect("a picture");
        let distance = (after.grips()[moved] - hand).length();
        assert!(distance < 1.0, "{end:?}: {distance} px from the hand");
    }
}

#[test]
fn an_axis_of_rotation_beyond_the_sky_is_pointed_to() {
    for room in [Room::Wide, Room::Narrow] {
        for impulse in [1.8, 4.0, 5.4, 9.0, 10.0] {
            let [azimuth, elevation] = scene().view.expect("a view");
            let mut player = played(&[("impulse", impulse)]);
            let drawing = player.draw(Moment { time: 5.0, azimuth, elevation, room }).expect("a picture");
            let (sky, radius) = room.of((at(508.0, 126.0), 98.0), (at(86.0, 462.0), 80.0));
            let names = drawing.items().iter().filter(|item| match &item.shape {
                Shape::Label(label) => {
                    item.role == Role::Text(Hue::Orange) && (label.bounds.centre() - sky).length() < radius
                }
                _ => false,
            });
            assert_eq!(names.count(), 1, "{impulse} MN·s, {room:?}");
        }
    }
}
