//! Lines of sight and where they pass through a solid.

use super::vector::Vec3;
use arrayvec::ArrayVec;

/// A straight line with a direction, origin + t·direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ray {
    pub(super) origin: Vec3,
    pub(super) direction: Vec3,
}

impl Ray {
    /// The point at the parameter t.
    pub(super) fn at(&self, t: f64) -> Vec3 {
        self.origin + self.direction * t
    }
}

/// The parameters between which a ray is inside a solid; of a surface without thickness both are the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Span {
    pub(super) enter: f64,
    pub(super) leave: f64,
}

/// Where a ray is inside a solid, in order: a hole makes two of one.
pub(super) type Spans = ArrayVec<Span, 2>;

impl Span {
    /// The whole ray, both ways.
    pub(super) const ALL: Self = Self { enter: f64::NEG_INFINITY, leave: f64::INFINITY };

    /// What two spans have in common.
    pub(super) fn common(self, other: Self) -> Option<Self> {
        let (enter, leave) = (self.enter.max(other.enter), self.leave.min(other.leave));
        (enter < leave).then_some(Self { enter, leave })
    }

    /// What is left of the span when another is taken out of it: up to two pieces.
    pub(super) fn without(self, other: Option<Self>) -> Spans {
        let Some(hole) = other.and_then(|other| self.common(other)) else { return Spans::from_iter([self]) };
        let before = Self { enter: self.enter, leave: hole.enter };
        let after = Self { enter: hole.leave, leave: self.leave };
        [before, after].into_iter().filter(|piece| piece.enter < piece.leave).collect()
    }
}

/// Where offset + slope·t lies between −half and half.
pub(super) fn slab(offset: f64, slope: f64, half: f64) -> Option<Span> {
    let [first, second] = [(-half - offset) / slope, (half - offset) / slope];
    if first.is_finite() && second.is_finite() {
        Some(Span { enter: first.min(second), leave: first.max(second) })
    } else {
        (offset.abs() <= half).then_some(Span::ALL)
    }
}

/// Where a·t² + 2·b·t + c is negative, for a ≥ 0.
pub(super) fn below_zero(a: f64, b: f64, c: f64) -> Option<Span> {
    let roots = roots(a, b, c);
    match roots[..] {
        [first, second] => Some(Span { enter: first.min(second), leave: first.max(second) }),
        _ if a <= 0.0 && b == 0.0 => (c < 0.0).then_some(Span::ALL),
        _ => None,
    }
}

/// The real roots of a·t² + 2·b·t + c, none of them by a difference of nearly equal numbers.
pub(super) fn roots(a: f64, b: f64, c: f64) -> ArrayVec<f64, 2> {
    let discriminant = b * b - a * c;
    if discriminant.is_nan() || discriminant < 0.0 {
        return ArrayVec::new();
    }
    let larger = -(b + discriminant.sqrt().copysign(b));
    [larger / a, c / larger].into_iter().filter(|root| root.is_finite()).collect()
}

/// The zeros between 0 and 1 of a polynomial of second degree with these values at 0, 1/2 and 1.
pub(super) fn zeros(start: f64, middle: f64, end: f64) -> impl Iterator<Item = f64> {
    let square = 2.0 * (start + end) - 4.0 * middle;
    let half_slope = 0.5 * (4.0 * middle - 3.0 * start - end);
    // By far the most have none: the polynomial lies between its coefficients in Bernstein's form.
    let between = 2.0 * middle - 0.5 * (start + end);
    let is_above = start > 0.0 && between > 0.0 && end > 0.0;
    let is_below = start < 0.0 && between < 0.0 && end < 0.0;
    let found = if is_above || is_below { ArrayVec::new() } else { roots(square, half_slope, start) };
    found.into_iter().filter(|root| (0.0..=1.0).contains(root))
}

#[cfg(test)]
mod tests {
    use super::roots;

    #[test]
    fn roots_keep_their_digits() {
        // (t − 1e-9)(t − 1): the small root by the school formula has seven wrong digits.
        let found = roots(1.0, -0.5 * (1.0 + 1e-9), 1e-9);
        assert!(found.iter().any(|root| (root / 1e-9 - 1.0).abs() < 1e-14), "{found:?}");
        assert_eq!(roots(0.0, 1.0, -4.0)[..], [2.0], "a straight line has one");
        assert!(roots(1.0, 0.0, 1.0).is_empty() && roots(0.0, 0.0, 1.0).is_empty());
        assert!(roots(f64::NAN, 0.0, 1.0).is_empty());
    }
}
