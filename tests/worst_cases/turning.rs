//! The splittings: what they keep, of any body and at any step.

use crate::search::{Case, Draw, keeps_its_promise};
use mechanics::euler::Turning;
use mechanics::geometric::Splitting;
use mechanics::inertia::PrincipalMoments;
use nalgebra::{UnitQuaternion, Vector3};

/// Any body, turning at about one radian a second about any axis.
fn turning(draw: &mut Draw<'_>) -> Option<(PrincipalMoments, Turning)> {
    let [p, q, r] = [0, 1, 2].map(|_| draw.decades(1e-2, 1.0));
    let moments = PrincipalMoments::new(q + r, r + p, p + q).ok()?;
    let omega = Vector3::from_fn(|_, _| draw.between(-1.0, 1.0));
    let start = Turning {
        world_from_body: UnitQuaternion::from_scaled_axis(Vector3::from_fn(|_, _| draw.between(-2.0, 2.0))),
        omega_body: omega / omega.norm(),
    };
    Some((moments, start))
}

#[test]
fn splittings_keep_momentum_and_length_of_any_body_to_rounding() {
    keeps_its_promise("splittings", 3000, &["Blanes–Moan", "Strang"], |draw| {
        let (moments, start) = turning(draw)?;
        let (splitting, way) =
            draw.one_of(&[(Splitting::Strang, "Strang"), (Splitting::BlanesMoan, "Blanes–Moan")]);
        let (steps, duration) = (1 + draw.below(50), draw.signed(1e-3, 1e3));
        let end = splitting.solve(&moments, start, duration, steps).ok()?;
        let momentum = start.angular_momentum_world(&moments);
        let lost = (end.angular_momentum_world(&moments) - momentum).norm() / momentum.norm();
        let length = (end.world_from_body.coords.norm() - 1.0).abs();
        let turns = (steps * splitting.turns_per_step() + 2) as f64;
        // Three units in the last place for each turn.
        let said = format!("{moments:?}, {start:?}, {duration:?} s in {steps} steps: {lost:e} {length:e}");
        Some(Case { ratio: lost.max(length) / (f64::EPSILON * turns) / 3.0, way, said })
    });
}
