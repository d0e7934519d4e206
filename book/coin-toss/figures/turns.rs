//! Euler's three turns, one after the other.

use super::halves_in;
use drawing::kit::Heads;
use drawing::space::{Camera, Curve, Hiding, Stage, View};
use drawing::{Drawing, Hue, Side, Stroke, at};
use figures::Outcome;
use nalgebra::{UnitQuaternion, Vector3};

/// The coin after one, two and three of Euler's turns.
pub(crate) fn euler_turns(id: &str) -> Outcome {
    let about = |axis: Vector3<f64>, angle: f64| UnitQuaternion::from_scaled_axis(axis * angle);
    let [phi, alpha, chi] = [0.96, 0.55, 0.9];
    let first = about(Vector3::z(), phi);
    let second = first * about(Vector3::x(), alpha);
    let third = second * about(Vector3::z(), chi);
    let mut panels = Vec::new();
    for (turn, (attitude, name, words)) in [
        (
            first,
            r"1: by $\varphi$ about $\hat{\mathbf{z}}$",
            "The coin lies flat. Its axis 1 has been turned from the direction x by the angle phi to the direction n, its axis 3 points up.",
        ),
        (
            second,
            r"2: by $\alpha$ about $\hat{\boldsymbol{n}}$",
            "Axis 1 is still the level direction n. The coin has been tilted about it, so that axis 3 leans from the vertical by the angle alpha.",
        ),
        (
            third,
            r"3: by $\chi$ about $\hat{\mathbf{3}}$",
            "Axis 3 is where it was. In the face of the coin axis 1 has been turned from n by the angle chi.",
        ),
    ]
    .into_iter()
    .enumerate()
    {
        let mut drawing = Drawing::new("", 184.0, 250.0).titled(name, words);
        let mut stage = Stage::new(Camera::new(View {
            target: [0.0, 0.0, 0.2],
            azimuth: 0.6,
            elevation: 0.42,
            distance: 9.0,
            centre: at(90.0, 122.0),
            scale: 56.0,
        })?);
        halves_in(&mut stage, &attitude)?;
        let [one, three] = [Vector3::x(), Vector3::z()].map(|axis| attitude * axis);
        let line = first * Vector3::x();
        let pale = |stage: &mut Stage, tip: Vector3<f64>| -> Result<(), drawing::Flaw> {
            stage.curve(Curve::segment([0.0; 3], tip)?.hiding(Hiding::Dashed), Stroke::Reference, Hue::Muted)
        };
        stage.named_vector([0.0; 3], three * 1.45, r"$\hat{\mathbf{3}}$", Hue::Ink)?;
        let tip = if turn < 2 { r"$\hat{\mathbf{1}} = \hat{\boldsymbol{n}}$" } else { r"$\hat{\mathbf{1}}$" };
        stage.named_vector([0.0; 3], one * 1.4, tip, Hue::Ink)?;
        // From where to where the axis has moved.
        let (from, to, radius, letter) = match turn {
            0 => (Vector3::x(), one, 1.18, r"$\varphi$"),
            1 => (Vector3::z(), three, 1.0, r"$\alpha$"),
            _ => (line, one, 1.18, r"$\chi$"),
        };
        pale(&mut stage, from * 1.4)?;
        let other = [r"$\hat{\mathbf{x}}$", r"$\hat{\mathbf{z}}$", r"$\hat{\boldsymbol{n}}$"][turn];
        let side = [Side::BelowLeft, Side::Above, Side::Below][turn];
        stage.label(from * 1.4, side, other, Hue::Muted)?;
        let short = from.lerp(&to, 0.93); // its head stays clear of the axis
        let arc = Curve::between([0.0; 3], from, short, radius)?.hiding(Hiding::Ignored);
        stage.arrow(arc, Stroke::Outline, Heads::End, Hue::Ink)?;
        let middle = (from + to).normalize() * radius;
        let side = [Side::Below, Side::Above, Side::BelowRight][turn];
        stage.label(middle, side, letter, Hue::Ink)?;
        stage.write(&mut drawing);
        drawing.label(at(90.0, 232.0), Side::Over, name, Hue::Ink)?;
        panels.push(drawing);
    }
    Ok(Drawing::panels(id, panels))
}
