//! A round body that rolls on its edge without slipping: what the wheel and the spinning coin share.
//!
//! Axes: x, y in the table, z up. Axis 1 of the disk's frame is level, in its plane; axis 2 runs up the steepest line
//! of its plane, from the contact to the centre; axis 3 = 1 × 2 is its normal, inward and down when it leans inward.
//! The frame follows heading and lean and does not roll with the disk. By the right-hand rule about axis 3 **a disk
//! with negative ω₃ rolls along axis 1**, its centre at `−aω₃`; a positive ω₃ rolls against it.
//!
//! The lean θ is the angle of the plane from the upright, the tilt α = π/2 − θ that from lying flat. The tilt is what a
//! state holds: near flat, where the motion hangs on it, it has all its digits; a lean near the upright is good to
//! 1e-16.
//!
//! ```
//! use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};
//! use mechanics::scenes::rolling_wheel::Wheel;
//! // A bicycle wheel that leans by 20° touches the table beside its centre, by a sin θ.
//! let wheel = Rolling { tilt: 70_f64.to_radians(), omega_3: -15.0, ..Rolling::UPRIGHT };
//! assert_eq!(format!("{:.1} cm", 100.0 * (wheel.contact(0.34) - wheel.centre).norm()), "11.6 cm");
//! // It rolls forwards, along its axis 1, which now lies along x.
//! let (mass, radius, gravity, moments) = (1.0, 0.34, 9.81, MomentFactors::HOOP);
//! let rates = Wheel::new(DiskParameters { mass, radius, moments, gravity })?.rates(0.0, &wheel.to_array());
//! assert_eq!(format!("{:.1} m/s", rates[6]), "5.1 m/s");
//! # Ok::<(), mechanics::InvalidQuantity>(())
//! ```

mod disk;
mod motion;
mod series;
mod state;

pub(crate) use disk::Disk;
pub use disk::{DiskParameters, MomentFactors};
pub(crate) use series::{Placed, RollingSeries, anchor, contact};
pub use state::Rolling;
pub(crate) use state::sin_cos_lean;
