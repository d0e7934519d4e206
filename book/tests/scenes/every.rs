//! What holds for every scene, whatever a reader does with it.

use crate::hand::{labels, words};
use drawing::{Drawing, Point, Rect, at};
use fastrand::Rng;
use live::{Form, Kind, Moment, Player, Room, Scene};
use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Settings that are tried in each scene.
const TRIALS: u32 = 150;
/// How far from its frame the ink of a label may reach, px: not at all, but for rounding.
const SLACK: f64 = 0.01;

fn all() -> Vec<&'static Scene> {
    let scenes: Vec<_> = pages::scenes::SCENES.iter().map(|(_, scene)| *scene).collect();
    assert!(!scenes.is_empty());
    scenes
}

fn is_name(name: &str) -> bool {
    let sound =
        |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit());
    name.split('-').all(sound)
}

/// A value of a control, at one of its ends as often as between them.
fn any(kind: Kind, random: &mut Rng) -> f64 {
    let between = |from: f64, to: f64, random: &mut Rng| match random.u8(0..4) {
        0 => from,
        1 => to,
        _ => from + (to - from) * random.f64(),
    };
    match kind {
        Kind::Slider { from, to, step, .. } => {
            let steps = between(0.0, ((to - from) / step).floor(), random).round();
            if random.u8(0..6) == 0 && from <= 0.0 && to >= 0.0 {
                (-from / step).round() * step + from
            } else {
                from + steps * step
            }
        }
        Kind::LogSlider { from, to, .. } => {
            10_f64.powf(between(from.log10(), to.log10(), random)).clamp(from, to)
        }
        Kind::Choice(choices) => random.usize(0..choices.len()) as f64,
        Kind::Switch => f64::from(random.bool()),
        Kind::Button(_) => [-1.0, 0.0, 10.0 * random.f64()][random.usize(0..3)],
        Kind::Kept => TAU * random.f64(),
    }
}

fn settings(scene: &Scene, random: &mut Rng) -> Vec<f64> {
    let one_changed = random.bool(); // most readers change one thing at a time
    let which = random.usize(0..scene.controls.len());
    let value = |(place, control): (usize, &live::Control)| {
        if one_changed && place != which { control.start } else { any(control.kind, random) }
    };
    scene.controls.iter().enumerate().map(value).collect()
}

/// Holds a picture to what any picture must be.
fn is_sound(drawing: &Drawing, size: [f64; 2], of: &str, view_is_turned: bool) {
    let elements = drawing.to_elements().unwrap_or_else(|flaw| panic!("{of}: {flaw}"));
    assert!(elements.lines().count() > 3, "{of}: nothing to see");
    assert!(!elements.contains("NaN") && !elements.contains("inf"), "{of}");
    let frame = Rect::new(0.0, 0.0, size[0], size[1]).grown(SLACK);
    for label in labels(drawing) {
        let ink = label.bounds;
        let inside = frame.left <= ink.left
            && ink.right <= frame.right
            && frame.top <= ink.top
            && ink.bottom <= frame.bottom;
        assert!(inside || view_is_turned, "{of}: a label, `{}`, is cut off: {ink:?}", words(label));
    }
}

#[test]
fn every_scene_can_be_named_and_set() {
    let mut names = BTreeSet::new();
    for scene in all() {
        assert!(is_name(scene.name) && names.insert(scene.name), "{}", scene.name);
        for words in [scene.title, scene.description, scene.question] {
            assert!(!words.trim().is_empty(), "{}", scene.name);
        }
        assert!(!scene.controls.is_empty() && scene.controls.len() <= 12, "{}", scene.name);
        let mut own = BTreeSet::from(["t", "azimuth", "elevation", "time"]);
        for control in scene.controls {
            let of = format!("{}: {}", scene.name, control.name);
            assert!(is_name(control.name) && own.insert(control.name), "{of}");
            assert_eq!(control.nearest(control.start), Some(control.start), "{of}");
            match control.kind {
                Kind::Slider { from, to, step, .. } => {
                    let steps = (to - from) / step;
                    assert!(
                        from < to && step > 0.0 && (steps - steps.round()).abs() < 1e-6,
                        "{of}: {steps} steps"
                    );
                }
                Kind::LogSlider { from, to, .. } => assert!(0.0 < from && from < to, "{of}"),
                Kind::Choice(choices) => assert!(choices.len() > 1, "{of}"),
                Kind::Switch | Kind::Button(_) | Kind::Kept => {}
            }
        }
        let start = Player::new(scene).unwrap_or_else(|cause| panic!("{}: {cause}", scene.name));
        for preset in scene.presets {
            let set = start.changed(preset.settings);
            let of = format!("{}: {}", scene.name, preset.words);
            let set = set.unwrap_or_else(|cause| panic!("{of}: {cause}"));
            for (control, value) in scene.controls.iter().zip(set.values()) {
                let own = preset.settings.iter().find(|(name, _)| *name == control.name);
                assert!(own.is_none_or(|(_, own)| (own - value).abs() < 1e-9), "{of}: {}", control.name);
            }
        }
        for wrong in [vec![f64::NAN; scene.controls.len()], vec![1e300; scene.controls.len()], Vec::new()] {
            assert!(Player::with(scene, wrong).is_err(), "{}", scene.name);
        }
    }
}

/// All that a page shows at some moments of a scene.
fn shown(player: &mut Player) -> Vec<String> {
    let [azimuth, elevation] = player.scene().view.unwrap_or_default();
    let duration = player.run().duration;
    let mut all = vec![player.words(0.0)];
    for part in [0.0, 0.11, 0.3, 0.7, 1.0] {
        let time = part * duration;
        let drawing = player.draw(Moment { time, azimuth, elevation, room: Room::Wide }).expect("a picture");
        all.push(drawing.to_elements().expect("no flaw"));
        all.extend(player.readings(time).expect("readings"));
    }
    all
}

#[test]
fn what_stands_behind_is_the_same_in_every_picture() {
    for scene in all() {
        let mut player = Player::new(scene).expect("it begins");
        let [azimuth, elevation] = scene.view.unwrap_or_default();
        let alike = |player: &mut Player, part: f64, room: Room| {
            let moment = Moment { time: part * player.run().duration, azimuth, elevation, room };
            let whole = player.draw(moment).expect("a picture").to_elements().expect("no flaw");
            let behind = player.behind(room).expect("what stands behind");
            let elements = behind + &player.elements(moment).expect("a picture");
            assert_eq!(elements, whole, "{} at {moment:?}", scene.name);
        };
        for (part, room) in [(0.3, Room::Wide), (0.7, Room::Wide), (0.7, Room::Narrow), (0.2, Room::Wide)] {
            alike(&mut player, part, room);
        }
        for settings in scene.presets.iter().map(|preset| preset.settings) {
            alike(&mut player.changed(settings).expect("an answer"), 0.1, Room::Wide);
        }
    }
}

#[test]
fn a_control_does_something_unless_it_says_what_it_waits_for() {
    for scene in all() {
        let start = Player::new(scene).expect("it begins");
        for (place, control) in scene.controls.iter().enumerate() {
            let of = format!("{}: {}", scene.name, control.name);
            let other = match control.kind {
                Kind::Slider { from, to, .. } | Kind::LogSlider { from, to, .. } => {
                    let middle = from + 0.37 * (to - from);
                    if (control.start - middle).abs() < 0.1 * (to - from) { to } else { middle }
                }
                _ => 1.0 - control.start.max(0.0),
            };
            let changes = |settings: &[(&str, f64)]| {
                let mut before = start.changed(settings).expect("an answer");
                let after = before.changed(&[(control.name, other)]);
                after.map_or(true, |mut after| shown(&mut before) != shown(&mut after))
            };
            let Some((waits_for, [from, to])) = control.when else {
                assert!(changes(&[]), "{of} does nothing");
                continue;
            };
            assert!(changes(&[(waits_for, from)]), "{of} does nothing");
            let governing = scene.controls.iter().position(|control| control.name == waits_for);
            let governing = governing.expect("it waits for a control");
            assert!(
                governing != place && !(from..=to).contains(&scene.controls[governing].start)
                    || matches!(scene.controls[governing].kind, Kind::Choice(_)),
                "{of} waits for nothing"
            );
            let dead = match scene.controls[governing].kind {
                Kind::Choice(choices) => (0..choices.len()).map(|choice| choice as f64).collect(),
                _ => vec![-1.0],
            };
            for value in dead.into_iter().filter(|value| !(from..=to).contains(value)) {
                assert!(!changes(&[(waits_for, value)]), "{of} does something at {waits_for} = {value}");
            }
        }
    }
}

#[test]
fn every_scene_moves_and_has_a_still() {
    for scene in all() {
        let mut player = Player::new(scene).expect("it begins");
        let run = player.run();
        assert!(run.duration > 0.0 && run.pace > 0.0 && run.duration.is_finite(), "{}: {run:?}", scene.name);
        let [azimuth, elevation] = scene.view.unwrap_or_default();
        for room in [Room::Wide, Room::Narrow] {
            let mut picture = |part: f64| {
                let time = part * run.duration;
                player
                    .draw(Moment { time, azimuth, elevation, room })
                    .expect("it draws")
                    .to_elements()
                    .expect("no flaw")
            };
            assert_ne!(picture(0.13), picture(0.29), "{}", scene.name);
        }
        // The whole picture stays in sight above the controls: 58 % of a window 740 px high, where its type has 9 px.
        let [width, height] = scene.size[1];
        let has_room = width <= 400.0 && 13.0 * 0.58 * 740.0 / height >= 9.0;
        assert!(has_room, "{}: a phone has no room for {width} × {height} px", scene.name);
        let still = player.still().expect("a still");
        // On the least phone a drawing has 340 px; what is raised there is 8 px high, as in every figure.
        for part in still.all_parts() {
            let shrunk = if part.width() > 400.0 { 1.0 } else { (340.0 / part.width()).min(1.0) };
            for label in labels(part) {
                let is_read = label.size >= 13.0 && label.smallest * shrunk >= 8.0;
                assert!(is_read, "{}: `{}` is too small", scene.name, words(label));
            }
        }
        assert!(still.to_svg().is_ok());
    }
}

#[test]
fn no_settings_break_a_scene() {
    for scene in all() {
        let mut random = Rng::with_seed(14);
        let mut answered = 0;
        for trial in 0..TRIALS {
            let values = settings(scene, &mut random);
            let of = format!("{}, {values:?}", scene.name);
            let mut player = match Player::with(scene, values.clone()) {
                Ok(player) => player,
                Err(cause) => {
                    assert!(cause.to_string().len() > 20, "{of}: {cause}");
                    continue;
                }
            };
            answered += 1;
            let run = player.run();
            assert!(run.duration > 0.0 && run.duration < 1e5 && run.pace > 0.0, "{of}: {run:?}");
            for part in [0.0, random.f64(), 1.0] {
                let time = part * run.duration;
                let turned = trial % 3 == 0;
                let view = scene.view.map(|own| {
                    if turned {
                        [PI * (2.0 * random.f64() - 1.0), FRAC_PI_2 * (2.0 * random.f64() - 1.0)]
                    } else {
                        own
                    }
                });
                let [azimuth, elevation] = view.unwrap_or_default();
                let room = if random.bool() { Room::Wide } else { Room::Narrow };
                let of = format!("{of}, t = {time}, {room:?}, {azimuth} {elevation}");
                let drawing = player.draw(Moment { time, azimuth, elevation, room });
                let drawing = drawing.unwrap_or_else(|cause| panic!("{of}: {cause}"));
                is_sound(&drawing, room.of(scene.size[0], scene.size[1]), &of, turned);
                player.readings(time).unwrap_or_else(|cause| panic!("{of}: {cause}"));
                let words = player.words(time);
                assert!(
                    words.len() > 10 && !words.contains("NaN") && !words.contains("inf "),
                    "{of}: {words}"
                );
                for (index, grip) in player.grips().into_iter().enumerate() {
                    assert!(grip.x.is_finite() && grip.y.is_finite(), "{of}: {grip:?}");
                    let drawn =
                        |to: Point| player.drag(index, to).unwrap_or_else(|cause| panic!("{of}: {cause}"));
                    for far in [30.0, 1e4] {
                        assert!(drawn(grip + at(far, -far)).iter().all(|value| value.is_finite()), "{of}");
                    }
                    for (control, (drawn, before)) in
                        scene.controls.iter().zip(drawn(grip).iter().zip(&values))
                    {
                        let grain = match control.kind {
                            Kind::Slider { step, .. } => 1.001 * step,
                            Kind::LogSlider { .. } => 0.01 * before,
                            _ => 0.0,
                        };
                        let name = control.name;
                        assert!(
                            (drawn - before).abs() <= grain,
                            "{of}: a touch sets {name} from {before} to {drawn}"
                        );
                    }
                }
            }
        }
        assert!(answered > TRIALS / 2, "{}: {answered} of {TRIALS} settings have an answer", scene.name);
    }
}

/// The readings that jump: a knob is turned, a kick is given, and methods go on by steps.
const JUMPING: [[&str; 2]; 5] = [
    ["knob", "knob"],
    ["laundromat", "force on the floor"],
    ["methods", "by Euler’s method"],
    ["methods", "by RK4"],
    ["methods", "by Strang’s splitting"],
];

#[test]
fn a_reading_is_the_same_a_moment_later() {
    let mut seen = BTreeSet::new();
    let mut random = Rng::with_seed(23);
    for scene in all() {
        let start = Player::new(scene).expect("it begins");
        let presets = scene.presets.iter().map(|preset| start.changed(preset.settings));
        let mut tried: Vec<_> = presets.collect::<Result<_, _>>().expect("answers");
        tried.extend((0..8).filter_map(|_| Player::with(scene, settings(scene, &mut random)).ok()));
        for player in tried {
            let duration = player.run().duration;
            // Where tables have their moments: whole parts of the run, and of a second.
            let parts = (1..400).map(|k| duration * f64::from(k) / 400.0);
            let seconds: Vec<_> =
                (0..400).map(|_| (1200.0 * duration * random.f64()).round() / 1200.0).collect();
            for time in parts.chain(seconds).filter(|time| *time < duration) {
                let [before, after] = [-1e-9, 1e-9].map(|later| player.numbers(time * (1.0 + later)));
                let (before, after) = (before.expect("readings"), after.expect("readings"));
                for ((before, after), reading) in before.iter().zip(after).zip(scene.readings) {
                    let last = match reading.form {
                        Form::Fixed(digits) => 10_f64.powi(-(digits as i32)),
                        Form::Digits(digits) => 10_f64.powi(1 - digits as i32) * after.abs() + 1e-12,
                        Form::Power(_) => continue, // of rounding
                    };
                    if (before - after).abs() > last {
                        seen.insert([scene.name, reading.words]);
                    }
                }
            }
        }
    }
    assert_eq!(seen, BTreeSet::from(JUMPING));
}

#[test]
fn labels_stand_on_no_other_where_the_text_leads() {
    let mut seen = BTreeSet::new();
    for scene in all() {
        let start = Player::new(scene).expect("it begins");
        let [azimuth, elevation] = scene.view.unwrap_or_default();
        for (preset, room) in
            scene.presets.iter().flat_map(|preset| [(preset, Room::Wide), (preset, Room::Narrow)])
        {
            let mut player = start.changed(preset.settings).expect("a motion");
            let duration = player.run().duration;
            for part in 0..=20 {
                let time = duration * f64::from(part) / 20.0;
                let drawing = player.draw(Moment { time, azimuth, elevation, room }).expect("a picture");
                let labels = labels(&drawing);
                for (place, label) in labels.iter().enumerate() {
                    let mut before = labels[..place].iter();
                    if let Some(other) = before.find(|other| label.bounds.overlaps(&other.bounds)) {
                        let both = [words(label), words(other)];
                        seen.insert(format!("{} {} {room:?}: {both:?}", scene.name, preset.words));
                    }
                }
            }
        }
    }
    assert!(seen.is_empty(), "{seen:#?}");
}
