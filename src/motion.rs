//! What all motions have in common.

use crate::euler::Turning;
use crate::free_rotation::{FreeSymmetricTop, FreeTop};
use crate::quantity::InvalidQuantity;
use crate::rolling::Rolling;
use crate::scenes::{
    air_drag, ball, coin_toss, laundromat, rolling_wheel, space_station, spinning_coin, top,
};
use nalgebra::Vector3;

/// A motion whose state at any time is known at once: in closed form, or from a part that has been integrated when it
/// was made.
///
/// Each of them has methods of these names itself, so that this trait need not be imported, and says there how exact
/// they are. What has to be followed from its start at every call is no `Motion`
/// ([`ThrownTop`](air_drag::ThrownTop), [`Sinking`](spinning_coin::Sinking)): of that ask for all times in one call of
/// `sample`.
///
/// ```
/// use mechanics::{InvalidQuantity, Motion};
/// use mechanics::inertia::Body;
/// use mechanics::scenes::coin_toss::{Toss, TossParameters};
/// /// The mean of a number over many times of any motion.
/// fn mean<M: Motion>(motion: &M, times: &[f64], number: impl Fn(&M::State) -> f64) -> Result<f64, M::Error> {
///     let states = motion.sample(times)?;
///     Ok(states.iter().map(number).sum::<f64>() / times.len() as f64)
/// }
/// // A coin that tumbles without any twist shows each face for half of the time: its normal is level in the mean.
/// let moments = Body::thin_disk(0.0075, 0.0122)?.moments();
/// let toss = Toss::new(TossParameters { moments, omega_1: 100.0, omega_3: 0.0 })?;
/// let turn: Vec<f64> = (0..100).map(|n| 1e-4 * std::f64::consts::TAU * f64::from(n)).collect(); // s
/// assert!(mean(&toss, &turn, |state| state.axis_3_world().z)?.abs() < 1e-14);
/// # Ok::<(), InvalidQuantity>(())
/// ```
pub trait Motion {
    /// The state at a time.
    type State;
    /// Why there is none.
    type Error;

    /// The state at `time`, s.
    ///
    /// # Errors
    /// For a time that is not finite or at which the motion does not exist, as each motion says.
    fn at(&self, time: f64) -> Result<Self::State, Self::Error>;

    /// The states at `times`, s: those of [`Motion::at`] to rounding, often several at once.
    ///
    /// # Errors
    /// As [`Motion::at`], for the first time that it refuses.
    fn sample(&self, times: &[f64]) -> Result<Vec<Self::State>, Self::Error>;
}

/// The types below have methods `at` and `sample`, and so are motions.
macro_rules! motions {
    ($($motion:ty: $state:ty,)+) => {$(
        impl Motion for $motion {
            type State = $state;
            type Error = InvalidQuantity;

            fn at(&self, time: f64) -> Result<$state, InvalidQuantity> {
                <$motion>::at(self, time)
            }

            fn sample(&self, times: &[f64]) -> Result<Vec<$state>, InvalidQuantity> {
                <$motion>::sample(self, times)
            }
        }
    )+};
}

motions! {
    FreeTop: Turning,
    FreeSymmetricTop: Turning,
    coin_toss::Toss: Turning,
    space_station::StruckStation: Turning,
    air_drag::DraggedTop: Vector3<f64>,
    laundromat::Transient: laundromat::Shaft,
    laundromat::Ramp: laundromat::Shaft,
    laundromat::RotorMotion: laundromat::Shaft,
    laundromat::LockedMotion: laundromat::LockedState,
    rolling_wheel::Wobble: Rolling,
    spinning_coin::SpinDown: spinning_coin::SpinningCoin,
    top::TopMotion: Turning,
    ball::Shot: ball::BallState,
    ball::TurntableRoll: ball::BallState,
    ball::HoleRoll: ball::BallState,
}
