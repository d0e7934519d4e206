//! A judge of scenes that shares no code with the crate: solids as conditions on points, lines of sight walked in small
//! steps, an eye with its own arithmetic.

use drawing::space::{Camera, Solid, View};
use drawing::{Flaw, Point, at};

pub(crate) type Vector = [f64; 3];

pub(crate) fn sum(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn times(a: Vector, factor: f64) -> Vector {
    [a[0] * factor, a[1] * factor, a[2] * factor]
}

pub(crate) fn step(from: Vector, to: Vector) -> Vector {
    sum(to, times(from, -1.0))
}

pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn unit(a: Vector) -> Vector {
    times(a, 1.0 / dot(a, a).sqrt())
}

pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Random numbers that are the same on every machine (`SplitMix64`, Steele, Lea and Flood 2014).
pub(crate) struct Chance(pub(crate) u64);

impl Chance {
    pub(crate) fn number(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^= mixed >> 31;
        low + (high - low) * ((mixed >> 11) as f64 / (1_u64 << 53) as f64)
    }

    pub(crate) fn vector(&mut self, reach: f64) -> Vector {
        [self.number(-reach, reach), self.number(-reach, reach), self.number(-reach, reach)]
    }

    pub(crate) fn direction(&mut self) -> Vector {
        loop {
            let vector = self.vector(1.0);
            if (0.01..1.0).contains(&dot(vector, vector)) {
                return unit(vector);
            }
        }
    }

    /// Three perpendicular directions.
    pub(crate) fn axes(&mut self) -> [Vector; 3] {
        let first = self.direction();
        let second = unit(cross(first, [0.3, -0.5, 0.81]));
        [first, second, cross(first, second)]
    }
}

/// An eye, from the view's definition.
pub(crate) struct Eye {
    pub(crate) view: View,
    pub(crate) back: Vector,
    pub(crate) right: Vector,
    up: Vector,
}

impl Eye {
    pub(crate) fn new(view: View) -> Self {
        let (azimuth, elevation) = (view.azimuth, view.elevation);
        let back = [elevation.cos() * azimuth.cos(), elevation.cos() * azimuth.sin(), elevation.sin()];
        let right = unit(cross([0.0, 0.0, 1.0], back));
        Self { view, back, right, up: cross(back, right) }
    }

    pub(crate) fn camera(&self) -> Camera {
        Camera::new(self.view).expect("a sound view")
    }

    /// Where the eye is; for parallel lines of sight, a place far enough out on the line through the point.
    pub(crate) fn place(&self, point: Vector) -> Vector {
        if self.view.distance.is_finite() {
            sum(self.view.target, times(self.back, self.view.distance))
        } else {
            sum(point, times(self.back, 10.0))
        }
    }

    /// Where a point lands: its step across the line of sight, over its distance from the eye's plane.
    pub(crate) fn project(&self, point: Vector) -> Point {
        let far = step(self.view.target, point);
        let depth = if self.view.distance.is_finite() {
            (self.view.distance - dot(far, self.back)) / self.view.distance
        } else {
            1.0
        };
        let scale = self.view.scale / depth;
        self.view.centre + at(scale * dot(far, self.right), -scale * dot(far, self.up))
    }

    /// The end of the line of sight through a point of the page, well behind the scene, and where it begins.
    pub(crate) fn sight(&self, page: Point) -> (Vector, Vector) {
        let aside = (page - self.view.centre) * (1.0 / self.view.scale);
        let across = sum(times(self.right, aside.x), times(self.up, -aside.y));
        let through = sum(self.view.target, across);
        let place = self.place(through);
        (place, sum(place, times(step(place, through), 2.0)))
    }
}

/// A solid in the judge's own terms.
#[derive(Clone, Debug)]
pub(crate) enum Body {
    /// A cylinder with its ends' middles, its radius and that of its hole.
    Tube(Vector, Vector, f64, f64),
    /// Apex, axis, half-angle, length of the side, and the direction towards which half of it is cut away if it is.
    Cone(Vector, Vector, f64, f64, Option<Vector>),
    /// Centre, axes, semi-axes.
    Ellipsoid(Vector, [Vector; 3], Vector),
}

impl Body {
    pub(crate) fn solid(&self) -> Result<Solid, Flaw> {
        match *self {
            Self::Tube(from, to, radius, hole) => {
                let (axis, middle) = (step(from, to), times(sum(from, to), 0.5));
                let length = dot(axis, axis).sqrt();
                if hole > 0.0 {
                    Solid::ring(middle, axis, radius, hole, length)
                } else if length > radius {
                    Solid::rod(from, to, radius)
                } else {
                    Solid::disc(middle, axis, radius, length)
                }
            }
            Self::Cone(apex, axis, half_angle, length, None) => Solid::cone(apex, axis, half_angle, length),
            Self::Cone(apex, axis, half_angle, length, Some(open)) => {
                Solid::half_cone(apex, axis, half_angle, length, open)
            }
            Self::Ellipsoid(centre, axes, radii) => Solid::ellipsoid(centre, axes, radii),
        }
    }

    /// Whether a point is inside the material; of a cone, on which side of the shell (`None` beyond its ends).
    fn side(&self, point: Vector) -> Option<bool> {
        match *self {
            Self::Tube(from, to, radius, hole) => {
                let (axis, far) = (step(from, to), step(from, point));
                let part = dot(far, axis) / dot(axis, axis);
                let level = step(times(axis, part), far);
                let square = dot(level, level);
                Some((0.0..=1.0).contains(&part) && square <= radius * radius && square >= hole * hole)
            }
            Self::Cone(apex, axis, half_angle, length, open) => {
                let (axis, far) = (unit(axis), step(apex, point));
                let height = dot(far, axis);
                let aside = step(times(axis, height), far);
                let is_cut = |open| dot(aside, step(times(axis, dot(open, axis)), open)) >= 0.0;
                let within = (0.0..=length * half_angle.cos()).contains(&height) && !open.is_some_and(is_cut);
                within.then(|| height >= half_angle.cos() * dot(far, far).sqrt())
            }
            Self::Ellipsoid(centre, axes, radii) => {
                let far = step(centre, point);
                let square: f64 = (0..3).map(|index| (dot(far, axes[index]) / radii[index]).powi(2)).sum();
                Some(square <= 1.0)
            }
        }
    }

    /// The part of the way from one point to another at which the body is met, to one in so many steps.
    pub(crate) fn met(&self, from: Vector, to: Vector, steps: u32) -> Option<f64> {
        let mut before = None;
        (0..=steps).map(|index| f64::from(index) / f64::from(steps)).find(|&part| {
            let side = self.side(sum(from, times(step(from, to), part)));
            let met = match self {
                // A shell is met where the side changes.
                Self::Cone(..) => matches!((before, side), (Some(was), Some(is)) if was != is),
                _ => side == Some(true),
            };
            before = side;
            met
        })
    }
}

/// A body at random near the origin: a disc, a rod, a ring, a cone, an ellipsoid or half a cone.
pub(crate) fn some_body(kind: u32, chance: &mut Chance) -> Body {
    let centre = chance.vector(0.4);
    match kind % 6 {
        kind @ 0..=2 => {
            let (long, wide) = match kind {
                0 => (chance.number(0.05, 0.3), chance.number(0.5, 1.0)),
                1 => (chance.number(1.0, 1.8), chance.number(0.05, 0.3)),
                _ => (chance.number(0.1, 0.6), chance.number(0.5, 1.0)),
            };
            let axis = times(chance.direction(), 0.5 * long);
            let hole = if kind == 2 { wide * chance.number(0.5, 0.9) } else { 0.0 };
            Body::Tube(step(axis, centre), sum(centre, axis), wide, hole)
        }
        kind @ (3 | 5) => {
            let (axis, half_angle) = (chance.direction(), chance.number(0.2, 1.2));
            let length = chance.number(0.5, 1.3);
            Body::Cone(centre, axis, half_angle, length, (kind == 5).then(|| chance.direction()))
        }
        _ => {
            let radii = [chance.number(0.3, 1.0), chance.number(0.3, 1.0), chance.number(0.3, 1.0)];
            Body::Ellipsoid(centre, chance.axes(), radii)
        }
    }
}

/// A view at random, from 5 to 10 units away; sometimes from infinity.
pub(crate) fn some_view(chance: &mut Chance) -> View {
    let distance = if chance.number(0.0, 1.0) < 0.25 { f64::INFINITY } else { chance.number(5.0, 10.0) };
    View {
        target: chance.vector(0.2),
        azimuth: chance.number(-3.0, 3.0),
        elevation: chance.number(-0.2, 1.4),
        distance,
        centre: at(200.0, 200.0),
        scale: 100.0,
    }
}
