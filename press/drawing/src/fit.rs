//! Cubic Bézier curves in place of many short lines.
//!
//! A circle of 200 px is some hundred lines, or six curves: a page that moves writes, reads and paints a fraction of the text.
//! It is our own because a scene has a dozen circles to fit at each frame: kurbo, which does it in general, takes 0.2 ms for
//! one of them, and all else in a picture takes 0.4.

use crate::point::Point;

/// How far a curve may pass by a point of its polyline, px. The polyline itself may lie [`TOLERANCE`](crate::TOLERANCE) from
/// what it stands for. With [`BOW`], all in all it is less than 0.08 px, which nobody sees.
const NEAR: f64 = 0.03;
/// How much further a curve may be from a line between two points, px: as far as a smooth curve would bow out there.
const BOW: f64 = 0.02;
/// How much the square of a miss along the curve counts beside that of one across it: little, as there a point may slide.
const SLIDING: f64 = 1e-3;
/// The angle from which on a turn is a corner, rad. A circle of 1 px turns less at each point.
const CORNER: f64 = 0.5;
/// How far the polyline may turn before a curve is tried, rad. Curves that turn further are seldom near enough.
const ROUND: f64 = 1.1;
/// Fewer lines are shorter to write than a curve.
const FEWEST: usize = 3;

/// A step of a path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Step {
    /// A straight line to a point.
    Line(Point),
    /// A cubic Bézier curve: its two points of control, and where it ends.
    Curve([Point; 3]),
}

/// Steps from the first of the points to the last: straight between corners and where points are far apart, and curves where
/// the polyline bends little by little.
pub(crate) fn fit(points: &[Point]) -> Vec<Step> {
    let mut steps = Vec::new();
    if points.len() <= FEWEST {
        steps.extend(points.iter().skip(1).map(|&point| Step::Line(point)));
        return steps;
    }
    let line = Polyline::new(points);
    let (mut first, mut turned) = (0, 0.0);
    for index in 1..points.len() - 1 {
        let turn = line.turns[index];
        turned += turn;
        if !(turn < CORNER && turned < ROUND) {
            line.fit(first, index, &mut steps);
            (first, turned) = (index, 0.0);
        }
    }
    line.fit(first, points.len() - 1, &mut steps);
    steps
}

/// A polyline.
struct Polyline<'a> {
    points: &'a [Point],
    /// How far each point is from the first along it, px.
    way: Vec<f64>,
    /// By how much it turns at each point, rad; none at its ends, and no number where it rests.
    turns: Vec<f64>,
}

impl<'a> Polyline<'a> {
    fn new(points: &'a [Point]) -> Self {
        let (mut way, mut turns) = (vec![0.0; points.len()], vec![0.0; points.len()]);
        let mut before = Point::default();
        for index in 1..points.len() {
            let chord = points[index] - points[index - 1];
            let length = chord.length();
            way[index] = way[index - 1] + length;
            let direction = chord * (1.0 / length);
            if index > 1 {
                // As large as the angle where it is small, and larger than a corner's where it is not.
                turns[index - 1] = (direction - before).length();
            }
            before = direction;
        }
        Self { points, way, turns }
    }

    /// Steps from one point to another, without corners between: one curve if it is near enough, else those of either half.
    fn fit(&self, from: usize, to: usize, steps: &mut Vec<Step>) {
        if self.is_straight(from, to) {
            steps.push(Step::Line(self.points[to]));
        } else if to - from < FEWEST {
            steps.extend(self.points[from + 1..=to].iter().map(|&point| Step::Line(point)));
        } else if let Some(curve) = self.curve(from, to) {
            steps.push(Step::Curve(curve));
        } else {
            let middle = usize::midpoint(from, to);
            self.fit(from, middle, steps);
            self.fit(middle, to, steps);
        }
    }

    /// Whether one line from a point to another passes all points between them.
    fn is_straight(&self, from: usize, to: usize) -> bool {
        let (start, chord) = (self.points[from], self.points[to] - self.points[from]);
        let length = chord.length();
        let passes = |&point: &Point| {
            let step = point - start;
            cross(chord, step).abs() <= NEAR * length && (0.0..=length * length).contains(&dot(chord, step))
        };
        self.points[from + 1..to].iter().all(passes)
    }

    /// A curve from one point to another that passes those between; none if it is not near enough.
    fn curve(&self, from: usize, to: usize) -> Option<[Point; 3]> {
        // A point belongs to the part of the curve that is its part of the way along the polyline.
        let scale = 1.0 / (self.way[to] - self.way[from]);
        let curve = self.least_squares(from, to, scale);
        let turn = |index: usize| self.turns[index.clamp(from + 1, to - 1)];
        let is_near = (from..to).all(|index| {
            let (here, chord) = (self.points[index], self.points[index + 1] - self.points[index]);
            let (before, length) = (self.way[index] - self.way[from], self.way[index + 1] - self.way[index]);
            let aside = |part: f64| cross(chord, curve.at((before + part * length) * scale) - here).abs();
            // Asked at the quarters, as an S crosses the line in its middle. There a circle is three quarters of its bow away.
            let bow = (length * (turn(index) + turn(index + 1)) * (0.75 / 16.0)).min(BOW);
            [0.0, 1.0].iter().all(|&part| aside(part) <= NEAR * length)
                && [0.25, 0.75].iter().all(|&part| aside(part) <= (NEAR + bow) * length)
        });
        let [_, near_start, near_end, end] = curve.0;
        is_near.then_some([near_start, near_end, end])
    }

    /// The curve from one point to another with the least squares of its distances from those between: across the polyline,
    /// and with little weight along it.
    fn least_squares(&self, from: usize, to: usize, scale: f64) -> Curve {
        let (start, end) = (self.points[from], self.points[to]);
        // The normal equations for the two points of control, in blocks.
        let (mut blocks, mut right) = ([Metric::default(); 3], [Point::default(); 2]);
        for index in from + 1..to {
            let [first, second, third, fourth] = weights((self.way[index] - self.way[from]) * scale);
            let metric = Metric::across(self.points[index + 1] - self.points[index - 1]);
            let miss = metric.times(self.points[index] - start * first - end * fourth);
            for (block, weight) in blocks.iter_mut().zip([second * second, second * third, third * third]) {
                block.add(&metric, weight);
            }
            right = [right[0] + miss * second, right[1] + miss * third];
        }
        // near_start = a⁻¹(r − b·near_end), and (c − b·a⁻¹·b)·near_end = s − b·a⁻¹·r.
        let [a, b, c] = blocks;
        let inverse = a.inverse();
        let mut schur = c;
        schur.add(&b.sandwich(&inverse), -1.0);
        let near_end = schur.inverse().times(right[1] - b.times(inverse.times(right[0])));
        let near_start = inverse.times(right[0] - b.times(near_end));
        Curve([start, near_start, near_end, end])
    }
}

/// A symmetric matrix of two rows: xx, xy, yy.
#[derive(Debug, Clone, Copy, Default)]
struct Metric([f64; 3]);

impl Metric {
    /// What counts a step across a direction whole, and one along it little.
    fn across(direction: Point) -> Self {
        let Point { x, y } = direction * (1.0 / direction.length());
        Self([y * y + SLIDING * x * x, (SLIDING - 1.0) * x * y, x * x + SLIDING * y * y])
    }

    fn add(&mut self, other: &Self, weight: f64) {
        self.0.iter_mut().zip(other.0).for_each(|(own, other)| *own += weight * other);
    }

    fn times(&self, step: Point) -> Point {
        let [xx, xy, yy] = self.0;
        Point { x: xx * step.x + xy * step.y, y: xy * step.x + yy * step.y }
    }

    fn inverse(&self) -> Self {
        let [xx, xy, yy] = self.0;
        let scale = 1.0 / (xx * yy - xy * xy);
        Self([yy * scale, -xy * scale, xx * scale])
    }

    /// self · inner · self.
    fn sandwich(&self, inner: &Self) -> Self {
        let [xx, xy, yy] = self.0;
        let (first, second) = (Point { x: xx, y: xy }, Point { x: xy, y: yy });
        let (one, other) = (inner.times(first), inner.times(second));
        Self([dot(first, one), dot(first, other), dot(second, other)])
    }
}

/// A cubic Bézier curve: where it begins, its two points of control, and where it ends.
struct Curve([Point; 4]);

impl Curve {
    fn at(&self, part: f64) -> Point {
        let ([a, b, c, d], [first, second, third, fourth]) = (self.0, weights(part));
        a * first + b * second + c * third + d * fourth
    }
}

/// What each of the four points counts at a part of a curve.
fn weights(part: f64) -> [f64; 4] {
    let rest = 1.0 - part;
    [rest * rest * rest, 3.0 * part * rest * rest, 3.0 * part * part * rest, part * part * part]
}

fn dot(a: Point, b: Point) -> f64 {
    a.x * b.x + a.y * b.y
}

fn cross(a: Point, b: Point) -> f64 {
    a.x * b.y - a.y * b.x
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::point::at;
    use crate::simplify::{TOLERANCE, simplify};
    use std::f64::consts::TAU;

    /// The steps as a dense polyline; how far a place is from a polyline, px.
    fn dense(start: Point, steps: &[Step]) -> Vec<Point> {
        let mut places = vec![start];
        for step in steps {
            let from = places[places.len() - 1];
            match *step {
                Step::Line(to) => places.extend((1..=40).map(|n| from.towards(to, f64::from(n) / 40.0))),
                Step::Curve([first, second, to]) => places.extend((1..=200).map(|n| {
                    let part = f64::from(n) / 200.0;
                    let [a, b, c] = [(from, first), (first, second), (second, to)]
                        .map(|(one, other)| one.towards(other, part));
                    a.towards(b, part).towards(b.towards(c, part), part) // de Casteljau
                })),
            }
        }
        places
    }

    fn distance(line: &[Point], place: Point) -> f64 {
        let from = |pair: &[Point]| {
            let (chord, step) = (pair[1] - pair[0], place - pair[0]);
            let part = (dot(step, chord) / dot(chord, chord).max(1e-300)).clamp(0.0, 1.0);
            (step - chord * part).length()
        };
        line.windows(2).map(from).fold(f64::INFINITY, f64::min)
    }

    /// Sums of three waves across and down, with corners now and then: curves as a scene may draw.
    fn random_line(chance: &mut fastrand::Rng) -> Vec<Point> {
        let mut number = |reach: f64| reach * (2.0 * chance.f64() - 1.0);
        let waves: Vec<[f64; 5]> = (1..=3)
            .map(|n| {
                let size = 10f64.powf(1.5 + number(1.0)) / f64::from(n * n);
                [f64::from(n) * (1.0 + number(0.5)), size, number(3.0), size * number(1.0), number(3.0)]
            })
            .collect();
        let (jump, drift) = (number(60.0), number(20.0));
        let count = 300 + (number(1.0).abs() * 1200.0) as u32;
        let place = |n: u32| {
            let time = TAU * f64::from(n) / f64::from(count);
            let sum = |size: usize, phase: usize| -> f64 {
                waves.iter().map(|wave| wave[size] * (wave[0] * time + wave[phase]).cos()).sum()
            };
            let corner = if n > count / 3 { jump } else { 0.0 };
            at(sum(1, 2) + drift * time + corner, sum(3, 4) + corner * (time - TAU / 3.0))
        };
        (0..=count).map(place).collect()
    }

    #[test]
    fn curves_stay_beside_their_lines_and_are_few() {
        let mut chance = fastrand::Rng::with_seed(1990);
        let (mut lines, mut written) = (0, 0);
        for _ in 0..30 {
            let sought = random_line(&mut chance);
            let line = simplify(&sought, TOLERANCE);
            let steps = fit(&line);
            let curve = dense(line[0], &steps);
            assert!((curve[curve.len() - 1] - line[line.len() - 1]).length() < 1e-9);
            for (some, other) in [(&curve, &sought), (&sought, &curve)] {
                let worst = some.iter().map(|&place| distance(other, place)).fold(0.0, f64::max);
                assert!(worst < 4.0 * TOLERANCE, "{worst}");
            }
            lines += line.len() - 1;
            written += steps.iter().map(|step| if let Step::Curve(_) = step { 3 } else { 1 }).sum::<usize>();
        }
        assert!(written * 3 < lines * 2, "{lines} lines became {written} points");
    }

    #[test]
    fn a_circle_is_a_handful_of_curves_and_corners_stay_corners() {
        let circle = |radius: f64| -> Vec<Point> {
            let points: Vec<Point> =
                (0..=3600).map(|n| Point::polar(radius, TAU * f64::from(n) / 3600.0)).collect();
            simplify(&points, TOLERANCE)
        };
        for radius in [3.0, 20.0, 200.0, 600.0] {
            let steps = fit(&circle(radius));
            assert!(steps.len() <= 16, "{radius} px: {} steps", steps.len());
            for place in dense(at(radius, 0.0), &steps) {
                assert!((place.length() - radius).abs() < 0.07, "{radius} px: {place:?}");
            }
        }
        let zigzag: Vec<Point> = (0..20).map(|n| at(10.0 * f64::from(n), f64::from(n % 2))).collect();
        let hexagon: Vec<Point> = (0..=6).map(|n| Point::polar(50.0, TAU * f64::from(n) / 6.0)).collect();
        let twelve: Vec<Point> = (0..=12).map(|n| Point::polar(50.0, TAU * f64::from(n) / 12.0)).collect();
        for corners in [zigzag, hexagon, twelve] {
            let lines: Vec<Step> = corners[1..].iter().map(|&point| Step::Line(point)).collect();
            assert_eq!(fit(&corners), lines);
        }
        assert_eq!(fit(&[]), []);
        assert_eq!(fit(&[at(1.0, 2.0); 2]), [Step::Line(at(1.0, 2.0))]);
    }
}
