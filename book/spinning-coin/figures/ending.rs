//! How Euler's disk ends: four laws of loss, followed with nothing assumed to be slow.

use super::{LAWS, a_long_life, disc, going_down, law_ends, look};
use drawing::kit::Marker;
use drawing::{Drawing, Hue, Rect, Side, Stroke};
use figures::{Axis, Cause, Outcome, Plot, log_steps};
use mechanics::integrate::Dop853;
use mechanics::rolling::Rolling;
use mechanics::scenes::spinning_coin::{BrakedDisk, TiltReached};
use std::f64::consts::SQRT_2;

/// The speed of sound, m/s.
const SOUND: f64 = 343.0;

/// The toy, braked by one of the laws, and how it is on its way down from a tilt of 0.1 to others, rad.
fn followed(power: f64, tilts: &[f64]) -> Result<(BrakedDisk, Vec<TiltReached>), Cause> {
    let (down, start) = (going_down(power)?, disc(0.1)?);
    // It begins to sink as the law has it, so as not to wobble: sin α ∝ (t₀ − t)^s.
    let omega_1 = start.tilt().tan() / ((power + 1.0) * down.life());
    let disk = BrakedDisk::new(start.parameters(), a_long_life(power)?)?;
    let sunk =
        disk.sink(Rolling { omega_1, ..start.state() }, tilts, &Dop853::with_tolerances(1e-10, 1e-13)?)?;
    Ok((disk, sunk))
}

/// The exponent of the tilt in the time that is left, told by three tilts, along the way down.
pub(crate) fn four_exponents(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 400.0, 330.0).titled(
        "Four exponents, and where each is given up",
        "The exponent against the tilt, from a millionth to a tenth, on a logarithmic scale. Four curves lie on the dashed levels 1/3, 4/9, 1/2 and 2/3 from the right, where the motion \
         begins, and turn up one after the other: for p = 2 at some five thousandths, for p = 1/2 at some forty millionths. A dot below each marks where the law would fall with g.",
    );
    let tilt = Axis::log(1e-6, 0.1, 1).titled(r"tilt $\alpha$, rad");
    let exponent = Axis::linear(0.0, 1.0, 0.2).minor(0.05).titled("exponent of the tilt");
    let mut plot = Plot::new(&mut drawing, Rect::new(44.0, 34.0, 325.0, 246.0), tilt, exponent)?;
    for (power, name) in LAWS {
        let law = 1.0 / (power + 1.0);
        let (_, last) = law_ends(power)?;
        plot.reference((1e-6, law), (0.1, law), Stroke::Reference);
        // Twenty-four tilts for each halving; the exponent of each is told by it and those twelve before and after.
        let tilts: Vec<f64> = (1..)
            .map(|n| 0.1 / 2_f64.powf(f64::from(n) / 24.0))
            .take_while(|tilt| *tilt > 0.4 * last.tilt())
            .collect();
        let (_, sunk) = followed(power, &tilts)?;
        let values = sunk.windows(25).map(|those| {
            let [high, middle, low] = [those[0].time, those[12].time, those[24].time];
            let exponent = SQRT_2.ln() / ((middle - high) / (low - middle)).ln(); // eq:three-tilts
            (those[12].state.tilt, exponent)
        });
        let values: Vec<(f64, f64)> =
            values.take_while(|(_, exponent)| (0.0..1.0).contains(exponent)).collect();
        let top = *values.last().ok_or("no exponent")?;
        let (stroke, hue) = look(power);
        plot.curve(&format!("exponent-{power}"), values, stroke, hue);
        plot.markers(&[(last.tilt(), law)], Marker::Disc, Hue::Ink);
        let text = if power == 2.0 { format!("$p = {name}$") } else { format!("${name}$") };
        let side = if power > 1.0 { Side::Right } else { Side::Left };
        plot.label(top, side, &text, hue)?;
    }
    plot.label((6e-5, 0.17), Side::Over, "dots: the law falls with $g$", Hue::Ink)?;
    Ok(drawing)
}

/// What the table carries, and how fast the contact runs.
pub(crate) fn table_holds(id: &str) -> Outcome {
    Ok(Drawing::panels(id, vec![support("")?, contact("")?]))
}

fn support(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 290.0, 310.0).titled(
        "What the table carries",
        "The support, in weights, against the tilt, in units of that at which each law falls with g, from 0.4 to 10. By the law for p = 2, dashed, it goes down through zero at one. In the motions it dips \
         to 0.73 for p = 2, drawn heavy, and less for the others, and rises above one again; all stay above the bound, a fifth.",
    );
    let tilt = Axis::log(0.3, 10.0, 1).titled("tilt, 1 where the law falls with $g$");
    let weight = Axis::linear(0.0, 2.0, 0.5).minor(0.1).titled("support, in weights");
    let mut plot = Plot::new(&mut drawing, Rect::new(44.0, 34.0, 200.0, 226.0), tilt, weight)?;
    for (power, _) in LAWS {
        let (_, last) = law_ends(power)?;
        let tilts: Vec<f64> = log_steps(10.0, 0.45, 200).map(|part| part * last.tilt()).collect();
        let tilts: Vec<f64> = tilts.into_iter().filter(|tilt| *tilt < 0.09).collect();
        let (disk, sunk) = followed(power, &tilts)?;
        let weight = disk.parameters().mass * disk.parameters().gravity;
        let values =
            sunk.iter().map(|there| (there.state.tilt / last.tilt(), disk.support(&there.state).z / weight));
        let values: Vec<(f64, f64)> = values.take_while(|(_, support)| *support < 2.0).collect();
        let stroke = if power == 2.0 { Stroke::Heavy } else { Stroke::Pale };
        plot.curve(&format!("support-{power}"), values, stroke, Hue::Purple);
    }
    // The fall that slow sinking asks for goes like the tilt to the power 1 − 2/s (eq:sinking-fall).
    let law = log_steps(10.0, 1.0, 100).map(|part| (part, 1.0 - part.powf(-5.0)));
    plot.curve("law-support", law, Stroke::DashedCurve, Hue::Ink);
    plot.level(0.2, Stroke::Reference);
    plot.label((2.4, 0.2), Side::AboveRight, "a fifth", Hue::Muted)?;
    plot.label((1.25, 0.62), Side::Right, "the law", Hue::Ink)?;
    plot.label((0.55, 1.75), Side::Right, "(a) the motion, $p = 2$", Hue::Purple)?;
    Ok(drawing)
}

fn contact(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 290.0, 310.0).titled(
        "How fast the contact runs",
        "The speed of the contact, in speeds of sound, against the tilt, both logarithmic. The law of slow sinking, dashed, is one straight line for all losses and passes Mach 1 at twelve \
         millionths. The four motions leave it one after the other, p = 2 first, and turn down: none reaches Mach 1.",
    );
    let tilt = Axis::log(1e-6, 0.1, 1).titled(r"tilt $\alpha$, rad");
    let mach = Axis::log(0.01, 10.0, 1).titled("contact, in speeds of sound");
    let mut plot = Plot::new(&mut drawing, Rect::new(48.0, 34.0, 196.0, 226.0), tilt, mach)?;
    let steady = log_steps(1e-6, 0.1, 80)
        .map(|tilt| Ok((tilt, disc(tilt)?.contact_speed() / SOUND)))
        .collect::<Result<Vec<_>, Cause>>()?;
    plot.curve("steady", steady, Stroke::DashedCurve, Hue::Ink);
    plot.level(1.0, Stroke::Reference);
    for (power, _) in LAWS {
        let (_, last) = law_ends(power)?;
        let tilts: Vec<f64> = log_steps(0.09, 0.35 * last.tilt(), 250).collect();
        let (disk, sunk) = followed(power, &tilts)?;
        let values = sunk.iter().map(|there| {
            let turn = there.state.omega_2 / there.state.tilt.tan(); // eq:contact-run, with Ω = ω₂/sin α
            (there.state.tilt, disk.parameters().radius * turn / SOUND)
        });
        let values: Vec<(f64, f64)> = values.take_while(|(_, mach)| *mach > 0.01).collect();
        plot.curve(&format!("contact-{power}"), values, Stroke::Curve, Hue::Pink);
    }
    for (place, side, text) in [
        ((7e-3, 0.0145), Side::Over, "$p = 2$"),
        ((4.5e-4, 0.02), Side::Over, "$5/4$"),
        ((7.6e-5, 0.045), Side::Left, "$1$"),
        ((3.1e-6, 0.25), Side::Below, "$1/2$"),
    ] {
        plot.label(place, side, text, Hue::Pink)?;
    }
    plot.label((9e-3, 1.0), Side::AboveLeft, "Mach 1", Hue::Muted)?;
    plot.label((1e-2, 5.0), Side::Right, "(b)", Hue::Ink)?;
    Ok(drawing)
}
