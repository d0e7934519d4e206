//! How methods look: one hue, marker and stroke for each, on every page.

use crate::kit::Marker;
use crate::role::{Hue, Stroke};

/// How a method is drawn, wherever it is: its name beside a curve, its hue, its marker, and its stroke where it
/// has no markers.
///
/// A hue stands for a family, a marker and a stroke for a method of it:
///
/// | hue | family | methods |
/// |---|---|---|
/// | ink | the exact motion | closed form ◆ heavy |
/// | teal | Runge–Kutta with equal steps | RK4 ●, midpoint ▲ short dashes, Euler ○ long dashes |
/// | ochre | step control | DOP853 ■, Taylor ▲ long dashes |
/// | grey | turns of the body | Strang ●, Blanes–Moan ◆ long dashes, CF4 ▲ short dashes |
///
/// None of these hues stands for a quantity.
///
/// ```
/// # use drawing::{Hue, Look, kit::Marker};
/// assert_eq!((Look::RK4.name, Look::RK4.hue, Look::RK4.marker), ("RK4", Hue::Teal, Marker::Disc));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Look {
    /// The name of the method, as a label.
    pub name: &'static str,
    /// Its colour.
    pub hue: Hue,
    /// The form of its points.
    pub marker: Marker,
    /// Its curve.
    pub stroke: Stroke,
}

impl Look {
    /// A formula, or what comes from one.
    pub const EXACT: Self = Self::new("closed form", Hue::Ink, Marker::Diamond, Stroke::Heavy);
    /// Euler's method.
    pub const EULER: Self = Self::new("Euler", Hue::Teal, Marker::Ring, Stroke::Second);
    /// The midpoint rule, a Runge–Kutta method of order two.
    pub const MIDPOINT: Self = Self::new("midpoint", Hue::Teal, Marker::Triangle, Stroke::Third);
    /// The classical Runge–Kutta method.
    pub const RK4: Self = Self::new("RK4", Hue::Teal, Marker::Disc, Stroke::Curve);
    /// The method of Dormand and Prince of order eight.
    pub const DOP853: Self = Self::new("DOP853", Hue::Ochre, Marker::Square, Stroke::Curve);
    /// Power series.
    pub const TAYLOR: Self = Self::new("Taylor", Hue::Ochre, Marker::Triangle, Stroke::Second);
    /// Strang's splitting.
    pub const STRANG: Self = Self::new("Strang", Hue::Muted, Marker::Disc, Stroke::Curve);
    /// The splitting of Blanes and Moan.
    pub const BLANES_MOAN: Self = Self::new("Blanes–Moan", Hue::Muted, Marker::Diamond, Stroke::Second);
    /// The commutator-free method of order four.
    pub const CF4: Self = Self::new("CF4", Hue::Muted, Marker::Triangle, Stroke::Third);

    /// All of them.
    pub const ALL: [Self; 9] = [
        Self::EXACT,
        Self::EULER,
        Self::MIDPOINT,
        Self::RK4,
        Self::DOP853,
        Self::TAYLOR,
        Self::STRANG,
        Self::BLANES_MOAN,
        Self::CF4,
    ];

    const fn new(name: &'static str, hue: Hue, marker: Marker, stroke: Stroke) -> Self {
        Self { name, hue, marker, stroke }
    }

    /// The look of the method with this name, as the library's table of methods has it.
    pub fn of(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|look| look.name == name)
    }
}

#[cfg(test)]
mod tests {
    use super::Look;

    #[test]
    fn no_look_is_like_another() {
        for (n, one) in Look::ALL.iter().enumerate() {
            for other in &Look::ALL[..n] {
                assert_ne!((one.hue, one.marker), (other.hue, other.marker), "{one:?}");
                assert_ne!((one.hue, one.stroke), (other.hue, other.stroke), "{one:?}");
            }
        }
    }
}
