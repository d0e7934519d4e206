//! A coin with its faces.

use live::prelude::*;
use mechanics::inertia::PrincipalMoments;
use nalgebra::{UnitQuaternion, Vector3};

/// Half the thickness of the coin that is drawn, if it is thin, in radii.
const HALF: f64 = 0.06;
/// The letters on its faces, as strokes along axes 1 and 2, in radii. That of tails reads well from below.
const HEADS: [[[f64; 2]; 2]; 3] =
    [[[-0.3, -0.42], [-0.3, 0.42]], [[0.3, -0.42], [0.3, 0.42]], [[-0.3, 0.0], [0.3, 0.0]]];
const TAILS: [[[f64; 2]; 2]; 2] = [[[0.0, -0.4], [0.0, 0.4]], [[-0.34, -0.4], [0.34, -0.4]]];

/// The coin of radius 1 about the origin as it is seen from a direction, in the hue of the face that is seen: that
/// which was up in the hue of the body, the other grey. Each has its letter.
pub(crate) fn draw_coin(
    moments: &PrincipalMoments,
    stage: &mut Stage,
    attitude: &UnitQuaternion<f64>,
    towards_eye: &Vector3<f64>,
) -> Result<(), Flaw> {
    // I₃/I₁ = 2/(1 + h²/3) of a cylinder of radius 1 and height h
    let [_, _, axial] = moments.to_array();
    let half = (0.5 * (3.0 * (2.0 / axial - 1.0)).sqrt()).max(HALF);
    let radius = 1.0_f64.min(1.2 / half.hypot(1.0));
    let (half, normal) = (half * radius, attitude * Vector3::z());
    let (face, hue, pen, letter) = if normal.dot(towards_eye) >= 0.0 {
        (half, Hue::Blue, Hue::Blue, &HEADS[..])
    } else {
        (-half, Hue::Muted, Hue::Ink, &TAILS[..])
    };
    stage.solid(Solid::disc([0.0; 3], normal, radius, 2.0 * half)?, hue)?;
    for stroke in letter {
        let [from, to] = stroke.map(|[x, y]| attitude * Vector3::new(x * radius, y * radius, face));
        stage.curve(Curve::segment(from, to)?.hiding(Hiding::Omitted), Stroke::Curve, pen)?;
    }
    Ok(())
}
