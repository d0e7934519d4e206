//! A reader's hand: what tests do with a scene.

use drawing::{Drawing, Label, Piece, Point, Shape};
use live::{Moment, Player, Press, Room, Scene, Sound};

/// Names of controls and their values.
pub(crate) type Settings = &'static [(&'static str, f64)];

/// A scene in use.
pub(crate) struct Hand {
    player: Player,
    last: Moment,
}

impl Hand {
    /// A scene with some settings changed, seen as its page first shows it.
    pub(crate) fn with(name: &str, settings: &[(&str, f64)]) -> Self {
        let scene = pages::scenes::named(name).expect("no such scene");
        Self::of(Player::new(scene).and_then(|player| player.changed(settings)).expect("an answer"))
    }

    /// A scene with a preset whose words contain these.
    pub(crate) fn preset(name: &str, words: &str) -> Self {
        let scene = pages::scenes::named(name).expect("no such scene");
        let preset = scene.presets.iter().find(|preset| preset.words.contains(words));
        Self::with(name, preset.expect("no such preset").settings)
    }

    /// The same after earlier presses of a button: times, and how strong each was.
    pub(crate) fn pressed(&self, button: &str, earlier: &[Press]) -> Self {
        let place = self.scene().controls.iter().position(|control| control.name == button);
        let place = place.expect("a button") as f64;
        let presses = earlier.iter().flat_map(|&[time, one, other]| [0.0, place, time, one, other]);
        let values = self.player.values().iter().copied().chain(presses).collect();
        Self::of(Player::with(self.scene(), values).expect("an answer"))
    }

    /// The same with a control set to another value at a time, by a hand that goes on.
    pub(crate) fn moved(&self, name: &str, value: f64, time: f64) -> Self {
        let values = self.player.changed(&[(name, value)]).expect("an answer").values().to_vec();
        Self::of(self.player.continued(values, time).expect("an answer"))
    }

    fn of(player: Player) -> Self {
        let [azimuth, elevation] = player.scene().view.unwrap_or_default();
        let last = Moment { time: player.scene().still, azimuth, elevation, room: Room::Wide };
        Self { player, last }
    }

    /// The same with some settings changed; what was measured before is kept.
    pub(crate) fn changed(&self, settings: &[(&str, f64)]) -> Self {
        Self::of(self.player.changed(settings).expect("an answer"))
    }

    /// What the page says of settings that have no answer.
    pub(crate) fn refusal(name: &str, settings: &[(&str, f64)]) -> String {
        let scene = pages::scenes::named(name).expect("no such scene");
        let refused = Player::new(scene).and_then(|player| player.changed(settings)).err();
        refused.unwrap_or_else(|| panic!("{name} has an answer to {settings:?}")).to_string()
    }

    pub(crate) fn scene(&self) -> &'static Scene {
        self.player.scene()
    }

    /// How long it runs, s of the scene.
    pub(crate) fn duration(&self) -> f64 {
        self.player.run().duration
    }

    /// Draws a moment, as the eye of the scene first sees it.
    pub(crate) fn draw(&mut self, time: f64, room: Room) -> Drawing {
        self.draw_from([self.last.azimuth, self.last.elevation], time, room)
    }

    /// Draws a moment, as it is seen from somewhere else.
    pub(crate) fn draw_from(&mut self, [azimuth, elevation]: [f64; 2], time: f64, room: Room) -> Drawing {
        self.last = Moment { time, azimuth, elevation, room };
        self.player.draw(self.last).expect("a picture")
    }

    /// What is heard at a time.
    pub(crate) fn sound(&self, time: f64) -> Option<Sound> {
        self.player.sound(time)
    }

    /// The words at the beginning.
    pub(crate) fn words(&self) -> String {
        self.player.words(0.0)
    }

    pub(crate) fn words_at(&self, time: f64) -> String {
        self.player.words(time)
    }

    /// The value of a control.
    pub(crate) fn value(&self, name: &str) -> f64 {
        let place = self.scene().controls.iter().position(|control| control.name == name);
        self.player.values()[place.expect("no such control")]
    }

    /// The number beside the picture whose words begin so.
    pub(crate) fn reading(&self, time: f64, words: &str) -> f64 {
        let place = self.scene().readings.iter().position(|reading| reading.words.starts_with(words));
        self.player.numbers(time).expect("readings")[place.unwrap_or_else(|| panic!("no reading {words}"))]
    }

    /// Where its grips stand in the picture that was drawn last, px.
    pub(crate) fn grips(&self) -> Vec<Point> {
        self.player.grips()
    }

    /// Where the first body can be taken hold of in the picture that was drawn last, px.
    pub(crate) fn body(&self) -> Point {
        self.bodies()[0]
    }

    /// Where its bodies can be taken hold of in the picture that was drawn last, px.
    pub(crate) fn bodies(&self) -> Vec<Point> {
        self.player.bodies().into_iter().map(|body| body.0).collect()
    }

    /// Takes hold of what is at a point, if anything is, draws it to another, and draws the same moment again.
    pub(crate) fn pull(&mut self, from: Point, to: Point) -> bool {
        let Some(held) = self.player.hold(from, 12.0) else { return false };
        self.draw_grip(held, to);
        true
    }

    /// Draws a grip to a point, and draws the same moment again.
    pub(crate) fn draw_grip(&mut self, grip: usize, to: Point) {
        let values = self.player.drag(grip, to).expect("values");
        self.player = Player::with(self.scene(), values).expect("an answer");
        self.player.draw(self.last).expect("a picture");
    }
}

/// The labels of a drawing.
pub(crate) fn labels(drawing: &Drawing) -> Vec<&Label> {
    let shapes = drawing.items().iter().map(|item| &item.shape);
    let labels = shapes.filter_map(|shape| match shape {
        Shape::Label(label) => Some(label),
        _ => None,
    });
    labels.collect()
}

/// The words of a label, with a sign for each formula.
pub(crate) fn words(label: &Label) -> String {
    let word = |piece: &Piece| match piece {
        Piece::Words { text, .. } => text.clone(),
        Piece::Outline(_) => "…".into(),
    };
    label.pieces.iter().map(word).collect()
}

/// The number behind some words of a text.
pub(crate) fn number_behind(text: &str, words: &str) -> f64 {
    let rest = text.split_once(words).unwrap_or_else(|| panic!("no `{words}` in {text}")).1.trim_start();
    let end = rest.find(|sign: char| !sign.is_ascii_digit() && sign != '.').unwrap_or(rest.len());
    rest[..end]
        .trim_end_matches('.')
        .parse()
        .unwrap_or_else(|_| panic!("no number behind `{words}` in {text}"))
}
