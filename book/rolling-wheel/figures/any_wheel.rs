//! Any wheel: its two moments, and where its circles lead when it is braked.

use super::{draw_tongue, edge, wheel};
use drawing::kit::{self, Marker};
use drawing::{Drawing, Fill, Hue, Rect, Room, Side, Stroke, at};
use figures::{Axis, Cause, Outcome, Plot, in_both, linear_steps, log_steps};
use mechanics::integrate::Dop853;
use mechanics::rolling::{MomentFactors, Rolling};
use mechanics::scenes::rolling_wheel::Wheel;

/// The leans, degrees, whose wheels are joined, with the places of their labels.
const TIPS: [(f64, (f64, f64)); 3] = [(20.0, (1.17, 1.5)), (25.0, (1.08, 0.34)), (30.0, (1.15, 0.115))];

/// The wheels of the table: moments, name and its side.
const WHEELS: [([f64; 2], &str, Side); 7] = [
    ([0.5, 1.0], "hoop", Side::AboveLeft),
    ([0.3823, 0.7619], "bicycle", Side::AboveLeft),
    ([0.25, 0.5], "coin", Side::AboveLeft),
    ([0.05, 0.1], "hub", Side::AboveLeft),
    ([1.0 / 3.0, 0.5], "thick disc", Side::Right),
    ([0.4, 0.4], "ball", Side::Right),
    ([2.0, 0.5], "weights", Side::Below),
];

/// The potential on the edge of the tongue, and what a loss makes of it.
pub(crate) fn ledge(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 330.0, 290.0).titled(
        "A ledge, and what a loss makes of it",
        "Two potentials against the lean. One falls from the right, is level where a marble lies at 15 degrees, and falls on towards the upright. The other, after a loss, is lower, the more so the larger the lean: it has a \
         hollow to the right of the ledge, where the marble lies now.",
    );
    let disc = wheel(MomentFactors::DISK)?;
    let lean = f64::to_radians(15.0);
    let [_, outer] = disc.unstable_circles(lean)?.ok_or("no tongue at this lean")?;
    let start = disc.steady(lean, outer)?.state();
    let slower = Rolling { omega_2: 0.97 * start.omega_2, omega_3: 0.97 * start.omega_3, ..start };
    let level = disc.potential(&disc.constants(&start), start.tilt);
    let well = |state: &Rolling| {
        let constants = disc.constants(state);
        move |degrees: f64| {
            let tilt = std::f64::consts::FRAC_PI_2 - degrees.to_radians();
            1e3 * (disc.potential(&constants, tilt) - level)
        }
    };
    let across = Axis::linear(0.0, 30.0, 10.0).minor(2.0).titled(r"lean $\theta$, degrees");
    let height = Axis::linear(-20.0, 20.0, 10.0).minor(2.0).titled(r"potential $V$, in $mga/1000$");
    let mut plot = Plot::new(&mut drawing, Rect::new(46.0, 34.0, 262.0, 206.0), across, height)?;
    let (before, after) = (well(&start), well(&slower));
    plot.curve(
        "level",
        linear_steps(0.0, 30.0, 300).map(|lean| (lean, before(lean))),
        Stroke::Curve,
        Hue::Muted,
    );
    plot.curve(
        "tilted",
        linear_steps(0.0, 30.0, 300).map(|lean| (lean, after(lean))),
        Stroke::Heavy,
        Hue::Ink,
    );
    let hollow = linear_steps(15.0, 30.0, 2000).min_by(|one, other| after(*one).total_cmp(&after(*other)));
    let hollow = hollow.ok_or("a range of leans")?;
    for (lean, height) in [(15.0, before(15.0)), (hollow, after(hollow))] {
        let place = plot.at((lean, height)) - at(0.0, 6.5);
        plot.drawing().disc(place, 5.0, Hue::Blue);
    }
    plot.label((1.0, 9.0), Side::Right, "level: the edge", Hue::Muted)?;
    plot.label((1.0, 5.6), Side::Right, "of the tongue", Hue::Muted)?;
    plot.label((9.0, -16.0), Side::Right, "tilted by a loss", Hue::Ink)?;
    Ok(drawing)
}

/// The lean of the tip over the plane of the two moments, with some wheels in it.
pub(crate) fn tip_of_shape(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 350.0).titled(
        "The tip of the tongue for wheels of any moments",
        "The moment I3 from 0.05 to 2 against I1 from 0.025 to 4, both on logarithmic scales. Curves join wheels with the same tip of the tongue, at 20, 25 and 30 degrees; \
         towards larger I1 the tip is higher. Above the straight line I3 = 2 I1, on which the flat wheels hoop, coin and wheel with a heavy hub lie and next to which lies the wheel of a \
         bicycle, there are no bodies. A thick disc and a ball lie a little to the right of the line, a disc with weights on its axle far to the right.",
    );
    let across = Axis::log(0.02, 4.0, 1).titled("$I_1$, about a diameter, in $ma^2$");
    let along = Axis::log(0.05, 2.0, 1).titled("$I_3$, about the axle, in $ma^2$");
    let mut plot = Plot::new(&mut drawing, Rect::new(48.0, 34.0, 320.0, 262.0), across, along)?;
    let corners = [(0.02, 0.05), (0.025, 0.05), (1.0, 2.0), (0.02, 2.0)].map(|corner| plot.at(corner));
    plot.drawing().polygon(corners.to_vec(), Fill::Ground, Hue::Ink);
    plot.reference((0.025, 0.05), (1.0, 2.0), Stroke::Reference);
    for (degrees, place) in TIPS {
        let tip = f64::to_radians(degrees);
        let joined = log_steps(0.05, 2.0, 120)
            .filter_map(|axial| {
                // The tip falls as I₃/I₁ grows: halve between the thinnest needle and a flat wheel.
                let lean = |ratio: f64| {
                    wheel(MomentFactors { transverse: axial / ratio, axial }).map(|wheel| wheel.safe_lean())
                };
                let (mut low, mut high) = (0.01, 2.0);
                if lean(high).ok()? > tip {
                    return None;
                }
                for _ in 0..50 {
                    let middle: f64 = 0.5 * (low + high);
                    *(if lean(middle).ok()? > tip { &mut low } else { &mut high }) = middle;
                }
                Some((axial / low, axial))
            })
            .filter(|&(across, _)| across <= 4.0);
        plot.curve(&format!("tip-{degrees}"), joined, Stroke::Curve, Hue::Muted);
        plot.label(place, Side::Over, &format!("${degrees}°$"), Hue::Muted)?;
    }
    for ([across, along], name, side) in WHEELS {
        plot.markers(&[(across, along)], Marker::Disc, Hue::Ink);
        plot.label((across, along), side, name, Hue::Ink)?;
    }
    plot.label((0.075, 0.8), Side::Over, "no bodies", Hue::Muted)?;
    Ok(drawing)
}

/// The way of circles of a braked wheel over the map, as b and lean in degrees, from a lean, rad, and a radius on: the
/// lean grows all the way, so it can be the variable.
fn way(wheel: &Wheel, mut lean: f64, mut b: f64) -> Result<Vec<(f64, f64)>, Cause> {
    let mut found = vec![(b, lean.to_degrees())];
    let slope = |lean: f64, b: f64| -> Result<f64, Cause> {
        let steady = wheel.steady(lean, b)?;
        let sinking = steady.sinking(-steady.omega());
        Ok(sinking.circle_rate / sinking.lean_rate)
    };
    while lean < 1.5 {
        let h = (0.01 * lean).min(0.01);
        let k1 = slope(lean, b)?;
        let k2 = slope(lean + 0.5 * h, b + 0.5 * h * k1)?;
        let k3 = slope(lean + 0.5 * h, b + 0.5 * h * k2)?;
        let k4 = slope(lean + h, b + h * k3)?;
        (lean, b) = (lean + h, b + h / 6.0 * (k1 + 2.0 * (k2 + k3) + k4));
        found.push((b, lean.to_degrees()));
    }
    Ok(found)
}

/// A curve with arrowheads along it, at some leans, degrees.
fn draw_way(plot: &mut Plot<'_>, name: &str, way: Vec<(f64, f64)>, heads: &[f64], hue: Hue) {
    for &lean in heads {
        if let Some(pair) = way.windows(2).find(|pair| pair[0].1 < lean && pair[1].1 >= lean) {
            let [from, to] = [plot.at(pair[0]), plot.at(pair[1])];
            kit::head(plot.drawing(), to, to - from, 0.8, hue);
        }
    }
    plot.curve(name, way, Stroke::Orbit, hue);
}

/// Where gentle loss leads from straight rolling, from spinning upright, and from the edge of the tongue.
pub(crate) fn ways_down(id: &str) -> Outcome {
    let disc = wheel(MomentFactors::DISK)?;
    // The full motion.
    let start = disc.steady(f64::to_radians(1.0), 40.0)?.state();
    let times: Vec<f64> = linear_steps(0.0, 27.0, 2700).collect();
    let (path, _) = Dop853::new(1e-10)?.sample(disc.slowed_rates(0.03), 0.0, start.to_array(), &times)?;
    let full: Vec<(f64, f64)> = path
        .iter()
        .map(|state| {
            let now = Rolling::from_array(*state);
            (now.omega_3 * now.lean().cos() / now.omega_2, now.lean().to_degrees())
        })
        .collect();
    in_both(|room| map_of_ways(id, room, &disc, &full))
}

fn map_of_ways(id: &str, room: Room, disc: &Wheel, full: &[(f64, f64)]) -> Outcome {
    let frame = room.of(Rect::new(40.0, 52.0, 435.0, 316.0), Rect::new(40.0, 52.0, 325.0, 272.0));
    let mut drawing = Drawing::new(id, frame.right + 25.0, frame.bottom + 52.0).titled(
        "Where gentle loss leads",
        "The lean, from 0 to 80 degrees, against the radius of the centre’s circle over a, from 0.01 to 100 on a logarithmic scale, with the shaded tongue of a disc. Three lines come from the \
         right, from straight rolling, and climb to the left over the tongue; three come from the left, from spinning upright, go out to a third of a radius and turn back. Between the two sheaves thin lines \
         begin on the edge of the tongue. Arrows on all of them point up. No line leads into the tongue. A full motion from one degree, drawn heavy, first runs along its line and then swings about it, with dots at equal times.",
    );
    let b = Axis::log(0.01, 100.0, 1).titled("radius of the centre’s circle $b/a$");
    let lean = Axis::linear(0.0, 80.0, 20.0).minor(5.0).titled(r"lean $\theta$, degrees");
    let mut plot = Plot::new(&mut drawing, frame, b, lean)?;
    let shown = |&(b, lean): &(f64, f64)| (0.01..=100.0).contains(&b) && lean <= 80.0;
    draw_tongue(&mut plot, edge(disc)?, [0.01, 100.0]);
    for (name, degrees, b, heads) in [
        ("straight-1", 1.0, 100.0, &[20.0, 60.0][..]),
        ("straight-3", 3.0, 100.0, &[15.0]),
        ("straight-10", 10.0, 100.0, &[25.0, 55.0]),
        ("spin-1", 1.0, 0.01, &[8.0]),
        ("spin-10", 10.0, 0.01, &[20.0]),
        ("spin-30", 30.0, 0.01, &[40.0, 70.0]),
    ] {
        let found = way(disc, f64::to_radians(degrees), b)?.into_iter().filter(shown).collect();
        draw_way(&mut plot, name, found, heads, Hue::Muted);
    }
    for (name, degrees, side) in
        [("edge-10", 10.0, 0), ("edge-15", 15.0, 0), ("edge-18", 18.0, 1), ("edge-13", 13.0, 1)]
    {
        let lean = f64::to_radians(degrees);
        let edges = disc.unstable_circles(lean)?.ok_or("no tongue at this lean")?;
        // A hair outside, where the circle is stable.
        let b = edges[side] * [1.0 - 1e-6, 1.0 + 1e-6][side];
        let found = way(disc, lean, b)?.into_iter().filter(shown).collect();
        draw_way(&mut plot, name, found, &[[38.0, 33.0][side]], Hue::Faint);
    }
    let full: Vec<(f64, f64)> = full.iter().copied().filter(shown).collect();
    let dots: Vec<(f64, f64)> = full.iter().step_by(200).copied().collect();
    plot.curve("full", full, Stroke::Curve, Hue::Ink);
    plot.markers(&dots, Marker::Disc, Hue::Ink);
    plot.label((0.3, 6.0), Side::Over, "unstable", Hue::Ink)?;
    plot.label((4.0, 50.0), Side::Right, "full motion", Hue::Ink)?;
    plot.label((4.0, 45.5), Side::Right, r"a dot every $2\sqrt{a/g}$", Hue::Ink)?;
    plot.label((0.25, 80.0), Side::Above, "Euler’s disk", Hue::Ink)?;
    plot.label((100.0, 17.0), Side::AboveLeft, "rolls straight", Hue::Muted)?;
    plot.label(
        room.of((0.012, 22.0), (0.0115, 6.2)),
        Side::Right,
        room.of("spins upright", "spins"),
        Hue::Muted,
    )?;
    Ok(drawing)
}
