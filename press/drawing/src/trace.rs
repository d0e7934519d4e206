//! The data of an SVG path, in few characters.

use crate::fit::{Step, fit};
use crate::label::Segment;
use crate::point::Point;
use crate::shape::Shape;
use arrayvec::ArrayVec;

/// Hundredths of a pixel, which cannot be seen.
const FINENESS: f64 = 100.0;

/// A polyline.
pub(crate) fn lines(points: &[Point]) -> String {
    let mut trace = Trace::default();
    trace.line(points);
    trace.finished()
}

/// Polylines and polygons, one after another. Polygons go round in one sense, so that where two overlap there is no hole.
pub(crate) fn all<'a>(shapes: impl Iterator<Item = &'a Shape>) -> String {
    let mut trace = Trace::default();
    for shape in shapes {
        match shape {
            Shape::Polyline(points) => trace.line(points),
            Shape::Polygon(points) => {
                let next = points.iter().cycle().skip(1);
                let doubled: f64 = points.iter().zip(next).map(|(a, b)| a.x * b.y - a.y * b.x).sum();
                if doubled < 0.0 {
                    trace.line(&points.iter().rev().copied().collect::<Vec<_>>());
                } else {
                    trace.line(points);
                }
                trace.close();
            }
            _ => {}
        }
    }
    trace.finished()
}

/// Where the outline of letters begins, and how it goes on from there: a letter that moves stays the same.
pub(crate) fn outline(segments: &[Segment]) -> (Point, String) {
    let start = segments.first().and_then(|segment| segment.points.first()).copied().unwrap_or_default();
    let mut trace = Trace { origin: Some(start), ..Trace::default() };
    for segment in segments {
        match segment.letter {
            'z' => trace.close(),
            letter => trace.draw(letter as u8, &segment.points),
        }
    }
    (start, trace.finished())
}

/// Every place is rounded as a step from where the path began, and written as a step from the place before: errors do
/// not add up, and a letter that stands twice is written twice alike, which packs well.
#[derive(Debug, Default)]
struct Trace {
    /// ASCII: bytes are written faster than letters.
    data: Vec<u8>,
    /// Where the path began.
    origin: Option<Point>,
    /// Where the pen is, and where it last came down, as steps from there.
    pen: [i64; 2],
    down: [i64; 2],
    letter: u8,
    /// Whether the last number has a point, so that the point of the next one tells where it begins.
    is_broken: bool,
}

impl Trace {
    /// Draws a polyline, with curves where they stand for many of its lines.
    fn line(&mut self, points: &[Point]) {
        if let Some(&start) = points.first() {
            self.draw(b'm', &[start]);
        }
        for step in fit(points) {
            match step {
                Step::Line(to) => self.draw(b'l', &[to]),
                Step::Curve(points) => self.draw(b'c', &points),
            }
        }
    }

    /// Draws through points of control to the last of `points`.
    fn draw(&mut self, letter: u8, points: &[Point]) {
        let hundredths = |value: f64| (value * FINENESS).round() as i64;
        let Some(origin) = self.origin else {
            let start = points[points.len() - 1];
            self.origin = Some(start);
            self.data.push(b'M');
            self.numbers(&[hundredths(start.x), hundredths(start.y)]);
            self.letter = b'M';
            return;
        };
        let mut steps = ArrayVec::<i64, 6>::new();
        let mut place = self.pen;
        for &point in points {
            let step = point - origin;
            place = [hundredths(step.x), hundredths(step.y)];
            steps.extend([place[0] - self.pen[0], place[1] - self.pen[1]]);
        }
        self.pen = place;
        if letter == b'm' {
            self.down = place;
        }
        if letter != self.letter || letter == b'm' {
            self.data.push(letter);
            self.letter = letter;
        }
        self.numbers(&steps);
    }

    fn close(&mut self) {
        self.data.push(b'z');
        self.pen = self.down;
        self.letter = b'z';
    }

    fn finished(self) -> String {
        text(self.data)
    }

    fn numbers(&mut self, hundredths: &[i64]) {
        for &value in hundredths {
            let (whole, part) = (value.unsigned_abs() / 100, value.unsigned_abs() % 100);
            let begins_with_point = whole == 0 && part != 0 && value > 0;
            let is_apart = value < 0 || self.is_broken && begins_with_point;
            if self.data.last().is_some_and(u8::is_ascii_digit) && !is_apart {
                self.data.push(b' ');
            }
            self.is_broken = part != 0;
            push_hundredths(&mut self.data, value);
        }
    }
}

/// Writes a number of hundredths, without zeros that say nothing. This is where most of the time of a moving
/// picture would go if it were done by `format!`.
fn push_hundredths(out: &mut Vec<u8>, hundredths: i64) {
    let mut digits = [0; 24]; // from the last to the first
    let mut first = digits.len();
    let mut put = |digit: u8| {
        first -= 1;
        digits[first] = digit;
    };
    let (mut whole, part) = (hundredths.unsigned_abs() / 100, (hundredths.unsigned_abs() % 100) as u8);
    if part != 0 {
        if part % 10 != 0 {
            put(b'0' + part % 10);
        }
        put(b'0' + part / 10);
        put(b'.');
    }
    if whole != 0 || part == 0 {
        loop {
            put(b'0' + (whole % 10) as u8);
            whole /= 10;
            if whole == 0 {
                break;
            }
        }
    }
    if hundredths < 0 {
        put(b'-');
    }
    out.extend_from_slice(&digits[first..]);
}

/// A number with two digits after the point, without zeros that say nothing.
pub(crate) fn number(value: f64) -> String {
    let mut out = Vec::new();
    let hundredths = (value * FINENESS).round() as i64;
    if hundredths.unsigned_abs() < 100 && hundredths != 0 {
        // With a zero before the point, as everywhere but in paths.
        let sign: &[u8] = if hundredths < 0 { b"-0" } else { b"0" };
        out.extend_from_slice(sign);
        push_hundredths(&mut out, hundredths.abs());
    } else {
        push_hundredths(&mut out, hundredths);
    }
    text(out)
}

/// Bytes of ASCII as a text.
fn text(ascii: Vec<u8>) -> String {
    String::from_utf8(ascii).expect("digits, signs and letters of SVG")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::point::at;

    #[test]
    fn steps_are_short_and_their_errors_do_not_add_up() {
        assert_eq!(
            lines(&[at(10.0, -0.5), at(10.004, 0.25), at(9.0, 0.25), at(9.0, 0.25)]),
            "M10-.5l0 .75-1 0 0 0"
        );
        let third: Vec<Point> = (0..=300).map(|n| at(f64::from(n) / 3.0, f64::from(n % 2))).collect();
        let data = lines(&third);
        let sum: f64 = data[1..]
            .replace(['l', '-'], " ")
            .split_whitespace()
            .step_by(2)
            .map(|x| x.parse::<f64>().unwrap())
            .sum();
        assert!((sum - 100.0).abs() < 1e-9, "{sum}");
    }

    #[test]
    fn many_lines_are_one_path() {
        let shapes = [
            Shape::Polyline(vec![at(1.0, 1.0), at(3.0, 1.0)]),
            Shape::Polygon(vec![at(5.0, 2.0), at(6.0, 2.0), at(6.0, 3.0)]),
            Shape::Polyline(vec![at(1.0, 4.0), at(1.0, 5.0)]),
        ];
        assert_eq!(all(shapes.iter()), "M1 1l2 0m2 1l1 0 0 1zm-4 2l0 1");
    }

    #[test]
    fn the_same_letter_elsewhere_is_written_alike() {
        let steps: [(char, &[[f64; 2]]); 7] = [
            ('m', &[[0.0, 0.0]]),
            ('c', &[[0.333, 0.2], [1.277, 2.0], [2.0, 2.0]]),
            ('q', &[[3.0, 3.0], [4.0, 4.0]]),
            ('z', &[]),
            ('m', &[[1.0, 1.0]]),
            ('l', &[[1.5, 1.5]]),
            ('z', &[]),
        ];
        let letter = |x: f64, y: f64| {
            let place = |points: &[[f64; 2]]| points.iter().map(|[dx, dy]| at(x + dx, y + dy)).collect();
            outline(&steps.map(|(letter, points)| Segment { letter, points: place(points) }))
        };
        assert_eq!(letter(0.0, 0.0), (at(0.0, 0.0), "m0 0c.33.2 1.28 2 2 2q1 1 2 2zm1 1l.5.5z".into()));
        assert_eq!(letter(7.126, 3.333), (at(7.126, 3.333), letter(0.0, 0.0).1));
    }
}
