//! A wheel that wobbles: half a wobble is enough.

use super::{placed, wheel};
use drawing::kit::{Heads, Marker};
use drawing::space::{Camera, Curve, Finish, Hiding, Solid, Stage, View};
use drawing::{Drawing, Fill, Hue, Rect, Side, Stroke, at};
use figures::{Axis, Cause, Outcome, Plot, in_both, linear_steps};
use mechanics::integrate::Taylor;
use mechanics::rolling::{MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::Wobble;
use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::FRAC_PI_2;

/// A disc that is kicked on its circle, and the first moment at which its lean is largest.
fn reversal(lean: f64, b: f64, kick: f64) -> Result<(Wobble, f64), Cause> {
    let disc = wheel(MomentFactors::DISK)?;
    let start = Rolling { omega_1: kick, ..disc.steady(lean, b)?.state() };
    let wobble = disc.wobble(start, &Taylor::new(1e-16)?)?;
    // By bisection.
    let (mut before, mut turns) = (0.0, 0.5 * wobble.period());
    for _ in 0..50 {
        let middle = 0.5 * (before + turns);
        *(if wobble.at(middle)?.omega_1 > 0.0 { &mut before } else { &mut turns }) = middle;
    }
    Ok((wobble, turns))
}

/// The track of the contact over eleven wobbles, half of the first of them heavy.
pub(crate) fn contact_track(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 340.0, 340.0).titled(
        "Track of the contact of a wobbling disc",
        "Seen from above, a track that goes round a circle several times in eleven equal waves, so that its rounds cross one another. Half of a wave is drawn heavy, from a place farthest out to one farthest in.",
    );
    let (wobble, turns) = reversal(0.55, 1.6, 0.3)?;
    let period = wobble.period();
    let track = |from: f64, to: f64, count: u32| -> Result<Vec<(f64, f64)>, Cause> {
        let times: Vec<f64> = linear_steps(from, to, count).collect();
        let states = wobble.sample(&times)?;
        Ok(states.iter().map(|state| state.contact(1.0)).map(|place| (place.re, place.im)).collect())
    };
    let mut plot = Plot::plane(&mut drawing, at(125.0, 165.0), 50.0, 4.0)?;
    plot.curve("all", track(turns, turns + 11.0 * period, 4400)?, Stroke::Orbit, Hue::Pink);
    let half = track(turns, turns + 0.5 * period, 200)?;
    let ends = [half[0], half[200]];
    plot.curve("half", half, Stroke::Curve, Hue::Pink);
    plot.markers(&ends, Marker::Disc, Hue::Pink);
    plot.label((0.94, 0.0), Side::Over, "eleven wobbles", Hue::Ink)?;
    plot.label((0.94, -0.35), Side::Over, "from half of one", Hue::Ink)?;
    Ok(drawing)
}

/// What comes after a reversal of the lean is the mirror image of what came before.
pub(crate) fn mirrored_film(id: &str) -> Outcome {
    let (wobble, turns) = reversal(0.4, 3.0, 0.45)?;
    let period = wobble.period();
    let stills = [-0.78, -0.42, 0.0, 0.42, 0.78].map(|part| wobble.at(turns + part * period));
    let stills = stills.into_iter().collect::<Result<Vec<Rolling>, _>>()?;
    let times: Vec<f64> = linear_steps(-1.0, 1.0, 400).map(|part| turns + part * period).collect();
    let track = wobble.sample(&times)?;
    in_both(|room| {
        let size = room.of((520.0, 300.0), (400.0, 240.0));
        let mut drawing = Drawing::new(id, size.0, size.1).titled(
            "Before and after a reversal of the lean",
            "A disc in the middle of its wobble stands in an upright pane of glass, which cuts it along its steepest diameter. Two pale discs on the left show it at two moments before; two on the right at two moments \
             after. Those on the right are the mirror images of those on the left, and so is the track on the floor.",
        );
        // The mirror in the plane x = 0: axis 1 of the reversal along x, and the foot at the origin.
        let [origin, _, _, _] = placed(&stills[2]);
        let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), -stills[2].heading);
        let seen = |state: &Rolling| {
            let [foot, centre, second, axle] = placed(state);
            [turn * (foot - origin), turn * (centre - origin), turn * second, turn * axle]
        };
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0, -1.0, 0.4],
            azimuth: 1.38,
            elevation: 0.55,
            distance: 15.0,
            centre: room.of(at(260.0, 150.0), at(200.0, 125.0)),
            scale: room.of(48.0, 37.0),
        })?);
        stage.ground([-4.5, -4.0], [4.5, 1.5], 0.0, 0.5)?;
        let track = Curve::smooth(track.iter().map(|state| seen(state)[0]))?;
        stage.arrow(track.hiding(Hiding::Omitted), Stroke::Curve, Heads::End, Hue::Pink)?;
        for (still, state) in stills.iter().enumerate() {
            let [_, centre, _, axle] = seen(state);
            let disc = Solid::disc(centre, axle, 1.0, 0.07)?;
            stage.solid(if still == 2 { disc } else { disc.finish(Finish::Ghost) }, Hue::Blue)?;
        }
        let pane = [[0.0, -2.4, 0.0], [0.0, 1.1, 0.0], [0.0, 1.1, 1.75], [0.0, -2.4, 1.75], [0.0, -2.4, 0.0]];
        stage.patch(pane[..4].to_vec(), Fill::Ground, Hue::Ink)?;
        for side in pane.windows(2) {
            stage.curve(Curve::segment(side[0], side[1])?, Stroke::Outline, Hue::Muted)?;
        }
        for state in &stills {
            stage.dot_in_front(seen(state)[0], 3.4, Hue::Pink)?;
        }
        for (place, side, name) in [
            ([0.0, -2.4, 1.75], Side::Above, "mirror"),
            (seen(&stills[0])[0].into(), Side::Below, "before"),
            (seen(&stills[4])[0].into(), Side::Below, "after"),
        ] {
            stage.label_shifted(place, at(0.0, 4.0), side, name, Hue::Ink)?;
        }
        stage.write(&mut drawing);
        Ok(drawing)
    })
}

/// The potentials of two coins that roll straight, one too slow to stay upright: what an exercise asks to sketch.
pub(crate) fn two_wells(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 330.0).titled(
        "The potentials of a slow coin and of a fast one",
        "The potential above that of the upright, in thousandths of m g a, against the lean from minus 40 to 40 degrees. That of the fast coin is a single well with its bottom at the upright. That of \
         the slow one has a low top there and a well on either side, and is as high again as the top at 32.4 degrees on both sides, at dots on a dashed line.",
    );
    let disc = wheel(MomentFactors::DISK)?;
    // In speeds √(ga) of a euro coin, 0.338 m/s.
    let root = (9.81_f64 * 0.5 * 0.02325).sqrt();
    let height = |speed: f64, lean: f64| {
        let constants = disc.constants(&Rolling { omega_3: speed / root, ..Rolling::UPRIGHT });
        let at = |lean: f64| disc.potential(&constants, FRAC_PI_2 - lean);
        1e3 * (at(lean) - at(0.0))
    };
    let lean = Axis::linear(-40.0, 40.0, 20.0).minor(5.0).titled(r"lean $\theta$, degrees");
    let potential =
        Axis::linear(-15.0, 45.0, 15.0).minor(5.0).titled(r"$V$ above the upright, in $mga/1000$");
    let mut plot = Plot::new(&mut drawing, Rect::new(46.0, 34.0, 320.0, 246.0), lean, potential)?;
    plot.level(0.0, Stroke::Reference);
    let slow = 0.5 * root;
    for (name, speed, stroke, hue) in
        [("fast", 0.24, Stroke::Curve, Hue::Muted), ("slow", slow, Stroke::Heavy, Hue::Ink)]
    {
        let values =
            linear_steps(-40.0, 40.0, 400).map(|degrees| (degrees, height(speed, degrees.to_radians())));
        plot.curve(name, values, stroke, hue);
    }
    // Where the slow coin turns back, by bisection.
    let (mut inside, mut beyond) = (0.4, 0.7);
    for _ in 0..50 {
        let middle = 0.5 * (inside + beyond);
        *(if height(slow, middle) < 0.0 { &mut inside } else { &mut beyond }) = middle;
    }
    let turns = f64::to_degrees(inside);
    plot.markers(&[(-turns, 0.0), (turns, 0.0)], Marker::Disc, Hue::Ink);
    plot.label((turns, 0.0), Side::BelowRight, &format!("${turns:.1}°$"), Hue::Ink)?;
    plot.label((0.0, -8.0), Side::Over, "17 cm/s", Hue::Ink)?;
    plot.label((0.0, 22.0), Side::Over, "24 cm/s", Hue::Muted)?;
    Ok(drawing)
}
