//! The figures of the chapter "The spinning coin".

use crate::{Axis, Outcome, Plot, log_steps};
use drawing::kit::Marker;
use drawing::space::{Camera, Curve, Hiding, Solid, Stage, View};
use drawing::{Drawing, Hue, Rect, Side, Stroke, at};
use mechanics::InvalidQuantity;
use mechanics::rolling::{DiskParameters, MomentFactors};
use mechanics::scenes::spinning_coin::SpinningCoin;
use nalgebra::Vector3;
use std::f64::consts::FRAC_PI_2;

/// The disc of the text at a tilt.
fn disc(tilt: f64) -> Result<SpinningCoin, InvalidQuantity> {
    let (mass, radius, gravity) = (0.4, 0.0375, 9.81);
    SpinningCoin::new(DiskParameters { mass, radius, moments: MomentFactors::DISK, gravity }, tilt)
}

/// The coin with the circle of its contact.
pub(crate) fn coin_circle(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 500.0, 360.0).titled(
        "The coin and the circle of its contact",
        "A coin that leans on a table, its centre above the middle of a circle drawn on the table. Its lowest point touches the circle. The angular velocity points from the contact through the \
         centre, along axis 2; axis 3 points down through the coin along its normal; Omega points straight up from the centre. The tilt alpha, drawn at the contact, is the angle between the coin and the table, the lean theta that between axis 2 and the upright.",
    );
    let tilt = 0.5_f64;
    let (sin, cos) = tilt.sin_cos();
    let centre = Vector3::new(0.0, 0.0, sin);
    let second = Vector3::new(0.0, -cos, sin);
    let contact = centre - second;
    let normal = Vector3::new(0.0, sin, cos);
    let mut stage = Stage::new(Camera::new(View {
        target: [0.0, 0.0, 0.45],
        azimuth: 0.35,
        elevation: 0.34,
        distance: 9.0,
        centre: at(250.0, 195.0),
        scale: 112.0,
    })?);
    stage.ground([-1.5, -1.5], [1.5, 1.5], 0.0, 3.0)?;
    stage.curve(Curve::circle([0.0; 3], Vector3::z(), cos)?, Stroke::Outline, Hue::Pink)?;
    stage.solid(Solid::disc(centre, normal, 1.0, 0.05)?, Hue::Blue)?;
    let axis = Curve::segment(centre, centre + second * 1.6)?;
    stage.arrow(axis.hiding(Hiding::Ignored), Stroke::Vector, drawing::kit::Heads::End, Hue::Orange)?;
    stage.label(
        centre + second * 1.6,
        Side::Left,
        r"$\boldsymbol{\omega}$, axis $\hat{\mathbf{2}}$",
        Hue::Orange,
    )?;
    let third = Curve::segment(centre, centre - normal * 0.45)?;
    stage.arrow(third.hiding(Hiding::Dashed), Stroke::Vector, drawing::kit::Heads::End, Hue::Ink)?;
    stage.label_shifted(
        centre - normal * 0.45,
        at(4.0, 3.0),
        Side::Right,
        r"$\hat{\mathbf{3}}$",
        Hue::Ink,
    )?;
    let upright = Curve::segment(centre, centre + Vector3::z() * 1.15)?;
    stage.arrow(upright.hiding(Hiding::Ignored), Stroke::Vector, drawing::kit::Heads::End, Hue::Ink)?;
    stage.label(centre + Vector3::z() * 1.15, Side::Right, r"$\boldsymbol{\Omega}$", Hue::Ink)?;
    stage.angle(centre, Vector3::z(), second, 0.62, "", Hue::Ink)?;
    stage.label_shifted(centre + Vector3::z() * 0.62, at(4.0, -2.0), Side::Right, r"$\theta$", Hue::Ink)?;
    // The tilt, between the line across the table and the one up the coin.
    let across = Curve::segment(contact, [0.0, 0.12, 0.0])?;
    stage.curve(across.hiding(Hiding::Ignored), Stroke::Reference, Hue::Muted)?;
    let up_the_coin = Curve::segment(contact, centre)?;
    stage.curve(up_the_coin.hiding(Hiding::Ignored), Stroke::Reference, Hue::Muted)?;
    let tilted = Curve::between(contact, -Vector3::y(), second, 0.62)?;
    stage.curve(tilted.hiding(Hiding::Ignored), Stroke::Outline, Hue::Ink)?;
    let middle = Vector3::new(0.0, -(0.5 * tilt).cos(), (0.5 * tilt).sin());
    stage.label(contact + middle * 0.62, Side::Left, r"$\alpha$", Hue::Ink)?;
    stage.dot(contact, 4.5, Hue::Pink)?;
    stage.label_shifted(contact, at(4.0, 2.0), Side::Right, "contact", Hue::Pink)?;
    stage.write(&mut drawing);
    Ok(drawing)
}

/// The three rates against the tilt.
pub(crate) fn coin_rates(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 690.0, 372.0).titled(
        "Three rates against the tilt",
        "Both scales are logarithmic: along x the tilt from 1e-4 to 1 rad, along y rates in rad/s. The contact's rate falls from three thousand to thirty with the power minus one half of the tilt. The \
         figure's rate rises from 1e-5 to ten with the power three halves, and the instantaneous vertical rate lies above it, by a factor of two at small tilts.",
    );
    let tilt = Axis::log(1e-4, 1.0, 1)?.titled(r"tilt $\alpha$, rad");
    let rate = Axis::log(1e-5, 1e4, 2)?.titled("rate, rad/s");
    let mut plot = Plot::new(&mut drawing, Rect::new(60.0, 34.0, 470.0, 286.0), tilt, rate)?;
    type Rate = fn(&SpinningCoin) -> f64;
    let rates: [(&str, Rate, Hue, Stroke); 3] = [
        ("contact", SpinningCoin::turn_rate, Hue::Orange, Stroke::Curve),
        ("figure", SpinningCoin::figure_rate, Hue::Blue, Stroke::Curve),
        ("vertical", SpinningCoin::vertical_rate, Hue::Green, Stroke::Curve),
    ];
    for (name, of, hue, stroke) in rates {
        let values = log_steps(1e-4, 1.0, 200)
            .map(|tilt| Ok((tilt, of(&disc(tilt)?))))
            .collect::<Result<Vec<_>, InvalidQuantity>>()?;
        plot.curve(name, values, stroke, hue);
    }
    plot.label((1e-3, 2e3), Side::Right, r"contact, $\Omega$", Hue::Orange)?;
    plot.label((1e-2, 8e-3), Side::BelowRight, r"figure, $\Omega - \omega_\text{rel}$", Hue::Blue)?;
    plot.label((6e-3, 4e-2), Side::AboveLeft, r"at an instant, $\omega_z$", Hue::Green)?;
    Ok(drawing)
}

/// The Mach number of the contact against the tilt.
pub(crate) fn mach(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 690.0, 350.0).titled(
        "Mach number of the contact against the tilt",
        "Both scales are logarithmic: along x the tilt from 1e-6 to 1 rad, along y the speed of the contact over that of sound, a line falling with the power minus one half. It crosses one at \
         1.25e-5. A dot at 0.0025 and 0.07 is where the steady motion ends by Moffatt's law.",
    );
    let tilt = Axis::log(1e-6, 1.0, 1)?.titled(r"tilt $\alpha$, rad");
    let speed = Axis::log(1e-3, 10.0, 1)?.titled("speed of the contact over that of sound");
    let mut plot = Plot::new(&mut drawing, Rect::new(60.0, 34.0, 560.0, 262.0), tilt, speed)?;
    plot.level(1.0, Stroke::Reference);
    let number = |tilt: f64| Ok((tilt, disc(tilt)?.contact_speed() / 343.0));
    let values = log_steps(1e-6, 1.0, 200).map(number).collect::<Result<Vec<_>, InvalidQuantity>>()?;
    plot.curve("mach", values, Stroke::Curve, Hue::Orange);
    // Moffatt's law for 0.4 kg, as in the text.
    let rate: f64 = 2.0 * std::f64::consts::PI * 1.78e-5 * 0.0375 / 0.4;
    let left = ((2.0 / 9.0) * 0.0375 / 9.81 * rate.powf(1.0 / 3.0)).powf(3.0 / 5.0);
    plot.markers(&[number((rate * left).powf(1.0 / 3.0))?], Marker::Disc, Hue::Pink);
    let crossing = disc(0.1)?.tilt_for_contact_speed(343.0)?;
    plot.markers(&[(crossing, 1.0)], Marker::Ring, Hue::Orange);
    plot.label((3e-3, 9e-2), Side::AboveRight, "the end, by Moffatt's law", Hue::Pink)?;
    plot.label((3e-5, 1.0), Side::AboveRight, r"Mach 1 at $1.25\cdot10^{-5}$", Hue::Orange)?;
    Ok(drawing)
}

/// Relative error of the figure's rate by the obvious formula.
pub(crate) fn figure_error(id: &str) -> Outcome {
    let mut drawing = Drawing::new(id, 680.0, 340.0).titled(
        "Error of the figure's rate by one minus the sine",
        "Both scales are logarithmic: along x the tilt from 1e-9 to 1, along y the relative error. By one minus the sine of the lean it rises from 1e-16 with the power minus two and reaches one at \
         1e-8.",
    );
    let mut naive = Vec::new();
    for tilt in log_steps(1e-9, 1.0, 72) {
        let coin = disc(tilt)?;
        let found = coin.turn_rate() * (1.0 - (FRAC_PI_2 - tilt).sin());
        naive.push((tilt, (found / coin.figure_rate() - 1.0).abs().max(1e-17)));
    }
    let tilt = Axis::log(1e-9, 1.0, 1)?.titled(r"tilt $\alpha$, rad");
    let error = Axis::log(1e-17, 10.0, 2)?.titled("relative error of the figure's rate");
    let mut plot = Plot::new(&mut drawing, Rect::new(66.0, 34.0, 592.0, 252.0), tilt, error)?;
    plot.series("naive", &naive, Marker::Disc, Hue::Orange);
    plot.label((1e-5, 1e-4), Side::Right, r"by $\Omega\,(1 - \sin\theta)$", Hue::Orange)?;
    Ok(drawing)
}
