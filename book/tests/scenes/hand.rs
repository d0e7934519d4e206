//! A reader's hand: what tests do with a scene.

use drawing::Point;
use live::{Kind, Moment, Player, Room};

/// A scene in use.
pub(crate) struct Hand {
    player: Player,
    last: Moment,
}

impl Hand {
    /// A scene with some settings changed.
    pub(crate) fn with(name: &str, settings: &[(&str, f64)]) -> Self {
        let scene = pages::scenes::named(name).expect("no such scene");
        let player = Player::new(scene).and_then(|player| player.changed(settings)).unwrap();
        let [azimuth, elevation] = scene.view.unwrap_or_default();
        let mut hand = Self { player, last: Moment { time: 0.0, azimuth, elevation, room: Room::Wide } };
        hand.draw(scene.still, Room::Wide);
        hand
    }

    /// Draws a moment, as the eye of the scene first sees it.
    pub(crate) fn draw(&mut self, time: f64, room: Room) {
        self.last = Moment { time, room, ..self.last };
        self.player.draw(self.last).unwrap();
    }

    /// The words.
    pub(crate) fn words(&self) -> String {
        self.player.words(self.last.time)
    }

    /// The value of a control.
    pub(crate) fn value(&self, name: &str) -> f64 {
        let place = self.player.scene().controls.iter().position(|control| control.name == name).unwrap();
        self.player.values()[place]
    }

    /// One of the readings.
    pub(crate) fn reading(&self, time: f64, place: usize) -> f64 {
        self.player.numbers(time).unwrap()[place]
    }

    /// Touches a grip, which changes nothing by more than a step, then draws it a step aside: how far from the hand it
    /// stands then, px.
    pub(crate) fn draws(&mut self, grip: usize, step: Point) -> Point {
        let stands = self.player.grips()[grip];
        let before = self.player.values().to_vec();
        let touched = self.player.drag(grip, stands).unwrap();
        for ((control, touched), before) in self.player.scene().controls.iter().zip(touched).zip(&before) {
            let grain = if let Kind::Slider { step, .. } = control.kind { step } else { 0.0 };
            assert!((touched - before).abs() <= 1.0001 * grain, "a touch changes {}", control.name);
        }
        let to = stands + step;
        let values = self.player.drag(grip, to).unwrap();
        assert_ne!(values, before, "nothing has changed");
        self.player = Player::with(self.player.scene(), values).unwrap();
        self.player.draw(self.last).unwrap();
        self.player.grips()[grip] - to
    }
}
