//! A grip that a hand draws to where it stands for other settings stands there.

use crate::hand::{Hand, Settings};
use drawing::kit::GRIP;
use drawing::{Role, Shape, at};
use live::Room;

/// A scene, a time, its settings, a grip, and what is different where the hand draws it.
const CASES: &[(&str, f64, Settings, usize, Settings)] = &[
    ("air-drag", 3.0, &[("ratio", 0.5), ("drag", 3.0), ("lean", 40.0)], 0, &[("ratio", 0.3), ("drag", 5.0)]),
    ("air-drag", 3.0, &[("ratio", 0.5), ("drag", 3.0), ("lean", 40.0)], 1, &[("lean", 62.0)]),
    ("coin-toss", 0.03, &[], 0, &[("twist", 80.0)]),
    ("coin-toss", 0.03, &[], 0, &[("twist", 20.0)]),
    ("laundromat", 2.0, &[("spin", 17.3), ("kick", 1.234)], 0, &[("spin", 25.0)]),
    ("laundromat", 2.0, &[("spin", 17.3), ("kick", 1.234)], 1, &[("kick", 2.1)]),
    ("pinned-hoop", 5.0, &[("gap", 30.0)], 0, &[("gap", 60.0)]),
    ("pinned-hoop", 5.0, &[("gap", 30.0)], 0, &[("gap", 3.0)]),
    ("pinned-hoop", 5.0, &[("gap", 30.0)], 1, &[("gap", 0.1)]),
    ("rolling-wheel", 1.0, &[], 0, &[("lean", 33.0), ("circle", 1.4)]),
    ("space-station", 1.0, &[], 0, &[("place", 30.0)]),
    ("space-station", 1.0, &[], 1, &[("impulse", 7.5)]),
    ("space-station", 20.0, &[("fire", 9.0)], 0, &[("thruster", 120.5)]),
    ("space-station", 5.0, &[("fire", 9.0), ("camera", 1.0)], 0, &[("thruster", 300.0)]),
    ("space-station", 5.0, &[("fire", 9.0)], 1, &[("fire", 33.0)]),
    ("spinning-coin", 2.0, &[], 0, &[("tilt", 0.2)]),
    ("spinning-coin", 2.0, &[("loss", 3.0)], 0, &[("tilt", 0.1)]),
    ("top", 0.3, &[], 0, &[("tilt", 40.0)]),
    ("turning", 0.3, &[], 0, &[("across", 5.5), ("spin", 11.2)]),
    ("turning", 0.3, &[], 1, &[("ratio", 1.3)]),
    ("wobble-plate", 0.006, &[("mass", 1.0)], 0, &[("mass", 2.2)]),
    ("wobble-plate", 0.006, &[("mass", 1.0)], 1, &[("tilt", 37.5)]),
];

#[test]
fn what_can_be_held_looks_so_and_nothing_else_does() {
    for scene in pages::scenes::SCENES.iter().map(|(_, scene)| *scene) {
        for settings in [&[][..]].into_iter().chain(scene.presets.iter().map(|preset| preset.settings)) {
            let mut hand = Hand::with(scene.name, settings);
            for (part, room) in [(0.02, Room::Wide), (0.4, Room::Narrow), (0.9, Room::Wide)] {
                let drawing = hand.draw(part * hand.duration(), room);
                let marks = drawing.items().iter().filter_map(|item| match item.shape {
                    Shape::Circle { centre, radius } if radius == GRIP => {
                        matches!(item.role, Role::Line(..)).then_some(centre)
                    }
                    _ => None,
                });
                let (marks, grips) = (marks.collect::<Vec<_>>(), hand.grips());
                let of = format!("{} {settings:?} at {part}, {room:?}: {marks:?} and {grips:?}", scene.name);
                assert_eq!(marks.len(), grips.len(), "{of}");
                assert!(
                    grips.iter().all(|grip| marks.iter().any(|mark| (*mark - *grip).length() < 0.5)),
                    "{of}"
                );
            }
        }
    }
}

/// A scene, a time, its settings, and a control that is set when its body is pulled to where it stands for another value,
/// nearly: the picture of the wheel is drawn larger for a smaller track.
const BODIES: &[(&str, f64, Settings, &str, f64, f64)] = &[
    ("rolling-wheel", 0.0, &[("kick", -1.0)], "lean", 40.0, 0.15),
    ("rolling-wheel", 0.0, &[("kick", -1.0)], "lean", 12.0, 0.15),
    ("spinning-coin", 2.0, &[], "tilt", 1.1, 0.02),
    ("spinning-coin", 7.0, &[("coin", 1.0)], "tilt", 0.3, 0.02),
    ("top", 0.0, &[], "tilt", 55.0, 0.02),
    ("top", 0.0, &[("push", -3.0)], "tilt", 12.0, 0.02),
];

#[test]
fn a_body_follows_the_hand_from_wherever_it_is_taken_hold_of() {
    for &(name, time, settings, control, value, slack) in BODIES {
        for room in [Room::Wide, Room::Narrow] {
            let drawn = |settings: &[(&str, f64)]| {
                let mut hand = Hand::with(name, settings);
                hand.draw(time, room);
                hand
            };
            let other = [settings, &[(control, value)]].concat();
            let (mut hand, there) = (drawn(settings), drawn(&other));
            let (from, to, aside) = (hand.body(), there.body(), at(9.0, -6.0));
            let of = format!("{name}, {settings:?}, {control} to {value}, {room:?}");
            // A touch changes nothing.
            let before = hand.value(control);
            assert!(hand.pull(from + aside, from + aside), "{of}: nothing is held");
            assert!(
                (hand.value(control) - before).abs() < 1e-9,
                "{of}: a touch sets {}",
                hand.value(control)
            );
            assert!(hand.pull(from + aside, to + aside), "{of}: nothing is held");
            let off = (hand.value(control) / value - 1.0).abs();
            assert!(off < slack, "{of}: {}", hand.value(control));
            assert!(!hand.pull(at(-500.0, 0.0), to), "{of}: what is nowhere near is held");
        }
    }
}

#[test]
fn grips_follow_the_hand() {
    for &(name, time, settings, grip, other) in CASES {
        for room in [Room::Wide, Room::Narrow] {
            let drawn = |settings: &[(&str, f64)]| {
                let mut hand = Hand::with(name, settings);
                hand.draw(time, room);
                hand
            };
            let (mut hand, there) = (drawn(settings), drawn(&[settings, other].concat()));
            let to = there.grips()[grip];
            let of = format!("{name}, {settings:?}, grip {grip} to that of {other:?}, {room:?}");
            assert!((hand.grips()[grip] - to).length() > 5.0, "{of}: it stands there already");
            hand.draw_grip(grip, to);
            let off = (hand.grips()[grip] - to).length();
            assert!(off < 1.0, "{of}: {off} px from the hand");
        }
    }
}
