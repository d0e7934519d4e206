//! Any wheel: its two moments, and where its circles lead when it is braked.

use super::{edge, wheel};
use drawing::kit::Marker;
use drawing::{Drawing, Fill, Hue, Rect, Side, Stroke};
use figures::{Axis, Cause, Outcome, Plot, linear_steps, log_steps};
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
        plot.curve(&format!("tip-{degrees}"), joined, Stroke::Curve, Hue::Blue);
        plot.label(place, Side::Over, &format!("${degrees}°$"), Hue::Blue)?;
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

/// Where gentle loss leads from straight rolling, from spinning upright, and from the edge of the tongue.
pub(crate) fn ways_down(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 390.0, 360.0).titled(
        "Where gentle loss leads",
        "The lean, from 0 to 80 degrees, against the radius of the centre’s circle over a, from 0.01 to 100 on a logarithmic scale, with the shaded tongue of a disc. Three lines come from the \
         right, from straight rolling, and climb to the left over the tongue; three come from the left, from spinning upright, go out to a third of a radius and turn back. Between the two sheaves thin lines \
         begin on the edge of the tongue. No line leads into it. A full motion from one degree first runs along its line and then swings about it.",
    );
    let b = Axis::log(0.01, 100.0, 1).titled("radius of the centre’s circle $b/a$");
    let lean = Axis::linear(0.0, 80.0, 20.0).minor(5.0).titled(r"lean $\theta$, degrees");
    let mut plot = Plot::new(&mut drawing, Rect::new(40.0, 34.0, 325.0, 272.0), b, lean)?;
    let disc = wheel(MomentFactors::DISK)?;
    let shown = |&(b, lean): &(f64, f64)| (0.01..=100.0).contains(&b) && lean <= 80.0;
    let border: Vec<_> = edge(&disc)?.into_iter().filter(shown).collect();
    let ends = [plot.at((100.0, 0.0)), plot.at((0.01, 0.0))];
    let corners = border.iter().map(|&corner| plot.at(corner)).chain(ends).collect();
    plot.drawing().polygon(corners, Fill::Ground, Hue::Orange);
    plot.curve("edge", border, Stroke::Border, Hue::Orange);
    for (name, degrees, b) in [
        ("straight-1", 1.0, 100.0),
        ("straight-3", 3.0, 100.0),
        ("straight-10", 10.0, 100.0),
        ("spin-1", 1.0, 0.01),
        ("spin-10", 10.0, 0.01),
        ("spin-30", 30.0, 0.01),
    ] {
        let found = way(&disc, f64::to_radians(degrees), b)?;
        plot.curve(name, found.into_iter().filter(shown), Stroke::Curve, Hue::Blue);
    }
    for (name, degrees, side) in
        [("edge-10", 10.0, 0), ("edge-15", 15.0, 0), ("edge-18", 18.0, 1), ("edge-13", 13.0, 1)]
    {
        let lean = f64::to_radians(degrees);
        let edges = disc.unstable_circles(lean)?.ok_or("no tongue at this lean")?;
        // A hair outside, where the circle is stable.
        let b = edges[side] * [1.0 - 1e-6, 1.0 + 1e-6][side];
        plot.curve(name, way(&disc, lean, b)?.into_iter().filter(shown), Stroke::Orbit, Hue::Blue);
    }
    // The full motion.
    let start = disc.steady(f64::to_radians(1.0), 40.0)?.state();
    let rates = disc.slowed_rates(0.03);
    let times: Vec<f64> = linear_steps(0.0, 27.0, 2700).collect();
    let (path, _) = Dop853::new(1e-10)?.sample(rates, 0.0, start.to_array(), &times)?;
    let full = path.iter().map(|state| {
        let now = Rolling::from_array(*state);
        (now.omega_3 * now.lean().cos() / now.omega_2, now.lean().to_degrees())
    });
    plot.curve("full", full.filter(shown), Stroke::Orbit, Hue::Pink);
    plot.label((0.28, 5.0), Side::Over, "unstable", Hue::Ink)?;
    plot.label((7.0, 46.0), Side::Over, "full motion", Hue::Pink)?;
    Ok(drawing)
}
