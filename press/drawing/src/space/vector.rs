//! Vectors of three components.

use std::ops::{Add, Mul, Neg, Sub};

/// A point or a direction of the world: an array, or a vector of nalgebra.
pub trait Place: Into<[f64; 3]> {}

impl<T: Into<[f64; 3]>> Place for T {}

/// A vector or a point of the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Vec3(pub(super) [f64; 3]);

impl Vec3 {
    /// The origin.
    pub(super) const ZERO: Self = Self([0.0; 3]);

    pub(super) fn dot(self, other: Self) -> f64 {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        a * x + b * y + c * z
    }

    pub(super) fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    pub(super) fn square(self) -> f64 {
        self.dot(self)
    }

    pub(super) fn length(self) -> f64 {
        self.square().sqrt()
    }

    /// The vector of length 1 in this direction; none if the vector has no length.
    pub(super) fn unit(self) -> Option<Self> {
        let largest = self.0.into_iter().fold(0.0, |most: f64, component| most.max(component.abs()));
        if !(largest > 0.0 && largest.is_finite()) {
            return None;
        }
        // Divided first by its largest component, so that neither tiny nor huge vectors lose their length.
        let scaled = self.map(|component| component / largest);
        Some(scaled * (1.0 / scaled.length()))
    }

    /// What is left of the vector when its part along a unit vector is taken away.
    pub(super) fn across(self, axis: Self) -> Self {
        self - axis * self.dot(axis)
    }

    /// Two unit vectors that form a right-handed triad with this unit vector, which is the third.
    pub(super) fn companions(self) -> (Self, Self) {
        let [x, y, z] = self.0.map(f64::abs);
        let aside = if x <= y && x <= z {
            Self([1.0, 0.0, 0.0])
        } else if y <= z {
            Self([0.0, 1.0, 0.0])
        } else {
            Self([0.0, 0.0, 1.0])
        };
        let second = self.cross(aside);
        let second = second * (1.0 / second.length());
        (second.cross(self), second)
    }

    /// The point at the fraction `part` of the way to `other`.
    pub(super) fn towards(self, other: Self, part: f64) -> Self {
        self + (other - self) * part
    }

    fn map(self, change: impl Fn(f64) -> f64) -> Self {
        Self(self.0.map(change))
    }
}

impl Add for Vec3 {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a + x, b + y, c + z])
    }
}

impl Sub for Vec3 {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Vec3 {
    type Output = Self;
    fn neg(self) -> Self {
        self.map(|component| -component)
    }
}

impl Mul<f64> for Vec3 {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        self.map(|component| component * factor)
    }
}

#[cfg(test)]
mod tests {
    use super::Vec3;

    #[test]
    fn companions_complete_a_right_handed_triad() {
        for axis in [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [-0.3, 2.0, 0.1], [1.0, -1.0, 1.0], [1e-300, 0.0, 0.0]]
        {
            let third = Vec3(axis).unit().expect("a direction");
            let (first, second) = third.companions();
            assert!((first.cross(second) - third).length() < 1e-15, "{axis:?}");
            assert!((first.length() - 1.0).abs() < 1e-15 && first.dot(third).abs() < 1e-15);
        }
        assert_eq!(Vec3::ZERO.unit(), None);
        assert_eq!(Vec3([f64::NAN, 0.0, 0.0]).unit(), None);
    }
}
