//! A tilted plate on a shaft, and the pistons that it drives. Chapter "The wobble plate".
//!
//! The shaft lies along z and turns with the angular velocity ω; the phase is ωt. The rotating axes are `x' = (cos ωt,
//! sin ωt, 0)`, `y' = z × x'` and z. The plate's normal is `cos α z − sin α x'` (`eq:plate-axes`). Nothing here has a
//! state: every quantity is a function of the phase. A phase or spin that is not finite gives NaN, and so
//! may a spin beyond 1e150 rad/s, whose square is beyond the largest number.

mod engine;
mod pistons;
mod plate;
mod unbalance;

pub use engine::Engine;
pub use pistons::{PistonParameters, Pistons};
pub use plate::{LargestMomentumAngle, Plate, PlateParameters};
pub use unbalance::{Piston, Unbalance};

use nalgebra::Vector3;

/// Components along x', y', z as components in the room at a phase, rad.
///
/// ```
/// use mechanics::scenes::wobble_plate::{Plate, PlateParameters, in_room};
/// let plate = PlateParameters { mass: 2.0, radius: 0.1, thickness: 0.0, tilt: 15_f64.to_radians() };
/// let momentum = Plate::new(plate)?.angular_momentum_rotating(100.0);
/// // A quarter turn later what leaned along −x leans along −y.
/// let turned = in_room(&momentum, 90_f64.to_radians());
/// assert_eq!(format!("{:.3} kg·m²/s", turned.y), "-0.125 kg·m²/s");
/// # Ok::<(), mechanics::InvalidQuantity>(())
/// ```
#[must_use]
pub fn in_room(rotating: &Vector3<f64>, phase: f64) -> Vector3<f64> {
    let (sin, cos) = phase.sin_cos();
    Vector3::new(rotating.x * cos - rotating.y * sin, rotating.x * sin + rotating.y * cos, rotating.z)
}
