//! The small scene of the page "A coin with an edge": two caps, the belt between them, and where the normal goes.

use super::coin_toss::draw_coin;
use live::prelude::*;
use mechanics::InvalidQuantity;
use mechanics::inertia::{Cylinder, PrincipalMoments};
use mechanics::scenes::coin_toss::{Landings, Toss, TossParameters, edge_at_random};
use nalgebra::Vector3;

pub(crate) const SCENE: Scene = Scene {
    file: file!(),
    name: "edge",
    title: "A thick coin, and on which side it lands",
    description: "At the left a thick coin in the air. Beside it a sphere with a cap for heads at the top, one for tails below, and a belt for the edge between them. The \
                  normal of the coin runs on a circle through both poles, blue in the cap of heads, pink in the belt and grey in the cap of tails. A bar below has three \
                  equal pieces, one for each side.",
    question: "How thick must a coin be to decide fairly among three? And does it stay fair if the thumb twists it a little?",
    size: [[640.0, 370.0], [380.0, 580.0]],
    view: None,
    still: 0.35,
    controls: &[
        Control::slider("thickness", r"thickness to diameter, $h/2a$", [0.02, 1.5, 0.001], "", 0.3),
        Control::slider("twist", r"twist to tumble, $\omega_3/\omega_1$", [0.0, 1.5, 0.01], "", 0.0),
    ],
    presets: &[
        preset("a nickel", &[("thickness", 0.092)]),
        preset("the nickel, twisted", &[("thickness", 0.092), ("twist", 0.55)]),
        preset("a third of the tumble", &[("thickness", 0.577)]),
        preset("a third of the sphere", &[("thickness", 0.354)]),
    ],
    readings: &[
        reading("heads, which was up", Form::Fixed(3), ""),
        reading("edge", Form::Fixed(3), ""),
        reading("tails", Form::Fixed(3), ""),
    ],
    symbols: formulas![],
    start: |settings| {
        let of = Tossed::new(settings)?;
        let run = Run { duration: 4.0 * of.period, pace: 1.0, repeats: true };
        let readings = |of: &Tossed, _| Ok(of.shares.to_vec());
        Ok(Box::new(Small { words: of.words(), of, run, readings, draw: Tossed::draw }))
    },
};

/// How fast it tumbles, rad/s, in slow motion; how many points its circle has.
const TUMBLE: f64 = 2.0;
const POINTS: u32 = 240;
/// The sides on which it can land, from the top of the sphere to its foot.
const SIDES: [(&str, Hue); 3] = [("heads", Hue::Blue), ("edge", Hue::Pink), ("tails", Hue::Muted)];

/// A piece of the circle of the normal, and the side on which the coin lands there: its place among [`SIDES`].
type Piece = (usize, Vec<Vector3<f64>>);

struct Tossed {
    toss: Toss,
    moments: PrincipalMoments,
    /// How often it lands on each side, and the height at which the belt ends on the sphere.
    shares: [f64; 3],
    border: f64,
    period: f64,
}

impl Tossed {
    fn new(settings: &Settings<'_>) -> Result<Self, Cause> {
        let [thickness, twist] = [settings.of("thickness")?, settings.of("twist")?];
        let coin = Cylinder { radius: 1.0, height: 2.0 * thickness };
        // Of a cylinder, the moment about a diameter for unit.
        let moments = PrincipalMoments::symmetric(1.0, 2.0 / (1.0 + coin.height * coin.height / 3.0))?;
        let toss = Toss::new(TossParameters { moments, omega_1: TUMBLE, omega_3: TUMBLE * twist })?;
        let Landings { same, edge, other } = toss.landings(coin)?;
        let period = TAU / toss.precession_rate();
        Ok(Self { toss, moments, shares: [same, edge, other], border: edge_at_random(coin)?, period })
    }

    /// The side that would be up: that of a normal of this height.
    fn side(&self, height: f64) -> usize {
        usize::from(height < self.border) + usize::from(height < -self.border)
    }

    /// The circle of the normal, in pieces.
    fn pieces(&self) -> Result<Vec<Piece>, InvalidQuantity> {
        let mut pieces: Vec<Piece> = Vec::new();
        for time in linear_steps(0.0, self.period, POINTS) {
            let normal = self.toss.normal(time)?;
            let side = self.side(normal.z);
            if let Some((_, piece)) = pieces.last_mut() {
                piece.push(normal);
            }
            if pieces.last().is_none_or(|(last, _)| *last != side) {
                pieces.push((side, vec![normal]));
            }
        }
        Ok(pieces)
    }

    fn draw(&self, moment: &Moment, drawing: &mut Drawing) -> Result<(), Cause> {
        let room = moment.room;
        let (eye, normal) = (moment.seen_from(-1.1, 0.3), self.toss.normal(moment.time)?);
        let hue = |side: usize| SIDES[side].1;
        let centre = room.of(at(160.0, 148.0), at(190.0, 130.0));
        let mut stage = Stage::new(eye.camera([0.0; 3], 9.0, centre, 84.0)?);
        let attitude = self.toss.at(moment.time)?.world_from_body;
        draw_coin(&self.moments, &mut stage, &attitude, &eye.towards_eye().into())?;
        stage.vector([0.0; 3], normal * 1.5, Hue::Ink)?;
        stage.write(drawing);

        let centre = room.of(at(450.0, 148.0), at(190.0, 360.0));
        let mut stage = Stage::new(eye.camera([0.0; 3], 9.0, centre, 106.0)?);
        stage.solid(Solid::sphere([0.0; 3], 1.0)?, Hue::Blue)?;
        let width = (1.0 - self.border * self.border).sqrt();
        for height in [self.border, -self.border] {
            let circle = Curve::circle([0.0, 0.0, height], Vector3::z(), width)?;
            stage.curve(circle.hiding(Hiding::Pale), Stroke::Outline, Hue::Pink)?;
        }
        for (side, piece) in self.pieces()?.into_iter().filter(|(_, piece)| piece.len() > 1) {
            stage.curve(Curve::smooth(piece)?.hiding(Hiding::Pale), Stroke::Curve, hue(side))?;
        }
        stage.dot_in_front(normal, 5.5, hue(self.side(normal.z)))?;
        stage.write(drawing);

        // The shares, as pieces of a bar with marks at its thirds.
        let bar = room.of(Rect::new(40.0, 300.0, 560.0, 18.0), Rect::new(30.0, 510.0, 320.0, 18.0));
        let long = bar.right - bar.left;
        let mut from = bar.left;
        for (place, ((name, hue), share)) in SIDES.into_iter().zip(self.shares).enumerate() {
            let to = from + share * long;
            let corners = vec![at(from, bar.top), at(to, bar.top), at(to, bar.bottom), at(from, bar.bottom)];
            if share > 0.0 {
                drawing.polygon(corners, Fill::Solid, hue);
            }
            let below = at(bar.left + (place as f64 + 0.5) * long / 3.0, bar.bottom + 26.0);
            let words = format!("{name} {share:.3}");
            drawing.label_set(below, Side::Over, 0.0, 14.0, &words, Role::Text(hue))?;
            from = to;
        }
        for third in [1.0, 2.0].map(|k| at(bar.left + k * long / 3.0, bar.top - 5.0)) {
            drawing.line(third, third + at(0.0, 28.0), Stroke::Reference, Hue::Ink);
        }
        Ok(())
    }

    fn words(&self) -> String {
        let [heads, edge, tails] = self.shares;
        let any =
            format!("In any attitude, as likely as every other, its edge would have {:.3}.", self.border);
        if self.shares.iter().all(|share| (share - 1.0 / 3.0).abs() < 2e-3) {
            return format!("A fair coin for three, if it is thrown like this. {any}");
        }
        if tails == 0.0 {
            let side = if edge > 0.0 {
                "turns back within the belt, and tails never shows"
            } else {
                "never gets down to the belt"
            };
            return format!("Its normal {side}: the edge has {edge:.3}, heads {heads:.3}. {any}");
        }
        format!("Heads has {heads:.3}, the edge {edge:.3} and tails {tails:.3}. {any}")
    }
}
