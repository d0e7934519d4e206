//! Points and rectangles, in pixels, y downwards.

use std::ops::{Add, Mul, Neg, Sub};

/// A point of a drawing, or the step from one point to another, px; y points down the page.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Point {
    /// To the right, px.
    pub x: f64,
    /// Down, px.
    pub y: f64,
}

/// The point at (x, y), px.
pub const fn at(x: f64, y: f64) -> Point {
    Point { x, y }
}

impl Point {
    /// The step of this length in this direction, counter-clockwise on the page from the right, rad.
    pub fn polar(length: f64, angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        at(length * cos, -length * sin)
    }

    /// The length of the step, px.
    pub fn length(self) -> f64 {
        (self.x * self.x + self.y * self.y).sqrt()
    }

    /// Whether it has a place.
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }

    /// The direction of the step, counter-clockwise on the page from the right, rad.
    pub fn angle(self) -> f64 {
        (-self.y).atan2(self.x)
    }

    /// The step of length 1 in this direction; to the right if the step has no length.
    pub fn unit(self) -> Self {
        let length = self.length();
        if length > 0.0 { self * (1.0 / length) } else { at(1.0, 0.0) }
    }

    /// The step turned by a quarter, counter-clockwise on the page.
    pub const fn quarter_turned(self) -> Self {
        at(self.y, -self.x)
    }

    /// The point at the fraction `part` of the way to `other`.
    pub fn towards(self, other: Self, part: f64) -> Self {
        self + (other - self) * part
    }
}

impl Add for Point {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        at(self.x + other.x, self.y + other.y)
    }
}

impl Sub for Point {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        at(self.x - other.x, self.y - other.y)
    }
}

impl Mul<f64> for Point {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        at(self.x * factor, self.y * factor)
    }
}

impl Neg for Point {
    type Output = Self;
    fn neg(self) -> Self {
        at(-self.x, -self.y)
    }
}

/// An upright rectangle, px.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rect {
    /// The left edge.
    pub left: f64,
    /// The upper edge.
    pub top: f64,
    /// The right edge.
    pub right: f64,
    /// The lower edge.
    pub bottom: f64,
}

impl Rect {
    /// The rectangle with its upper left corner at (left, top).
    pub const fn new(left: f64, top: f64, width: f64, height: f64) -> Self {
        Self { left, top, right: left + width, bottom: top + height }
    }

    /// Its width, px.
    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    /// Its height, px.
    pub fn height(&self) -> f64 {
        self.bottom - self.top
    }

    /// Its centre.
    pub fn centre(&self) -> Point {
        at(0.5 * (self.left + self.right), 0.5 * (self.top + self.bottom))
    }

    /// The rectangle with every edge moved outwards by `margin`, px (inwards if negative).
    pub fn grown(&self, margin: f64) -> Self {
        Self {
            left: self.left - margin,
            top: self.top - margin,
            right: self.right + margin,
            bottom: self.bottom + margin,
        }
    }

    /// Moved by a step.
    pub fn moved(&self, step: Point) -> Self {
        Self {
            left: self.left + step.x,
            top: self.top + step.y,
            right: self.right + step.x,
            bottom: self.bottom + step.y,
        }
    }

    /// The smallest rectangle that holds both.
    pub fn union(&self, other: &Self) -> Self {
        Self {
            left: self.left.min(other.left),
            top: self.top.min(other.top),
            right: self.right.max(other.right),
            bottom: self.bottom.max(other.bottom),
        }
    }

    /// The smallest rectangle that holds all points; none without points.
    pub(crate) fn around(points: impl IntoIterator<Item = Point>) -> Option<Self> {
        let points = points.into_iter().map(|Point { x, y }| Self { left: x, top: y, right: x, bottom: y });
        points.reduce(|all, next| all.union(&next))
    }

    /// Whether the point is inside or on the edge.
    pub fn contains(&self, point: Point) -> bool {
        (self.left..=self.right).contains(&point.x) && (self.top..=self.bottom).contains(&point.y)
    }

    /// Whether the two have more than an edge in common.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }
}
