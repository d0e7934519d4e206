//! The data of an SVG path, in few characters.

use crate::label::Segment;
use crate::point::Point;

/// Hundredths of a pixel, which cannot be seen.
const FINENESS: f64 = 100.0;

/// Lines through `points`.
pub(crate) fn lines(points: &[Point]) -> String {
    let mut trace = Trace::default();
    for (index, &point) in points.iter().enumerate() {
        trace.draw(if index == 0 { 'm' } else { 'l' }, &[point]);
    }
    trace.data
}

/// The outline of letters.
pub(crate) fn outline(segments: &[Segment]) -> String {
    let mut trace = Trace::default();
    for segment in segments {
        match *segment {
            Segment::Move(end) => trace.draw('m', &[end]),
            Segment::Line(end) => trace.draw('l', &[end]),
            Segment::Quadratic(control, end) => trace.draw('q', &[control, end]),
            Segment::Cubic(first, second, end) => trace.draw('c', &[first, second, end]),
            Segment::Close => trace.close(),
        }
    }
    trace.data
}

/// Every place is rounded as a step from where the path began, and written as a step from the place before: errors do
/// not add up, and a letter that stands twice is written twice alike, which packs well.
#[derive(Debug, Default)]
struct Trace {
    data: String,
    /// Where the path began.
    origin: Option<Point>,
    /// Where the pen is, and where it last came down, as steps from there.
    pen: [i64; 2],
    down: [i64; 2],
    letter: char,
    /// Whether the last number has a point, so that the point of the next one tells where it begins.
    is_broken: bool,
}

impl Trace {
    /// Draws through points of control to the last of `points`.
    fn draw(&mut self, letter: char, points: &[Point]) {
        let hundredths = |value: f64| (value * FINENESS).round() as i64;
        let Some(origin) = self.origin else {
            let start = points[points.len() - 1];
            self.origin = Some(start);
            self.data.push('M');
            self.numbers(&[hundredths(start.x), hundredths(start.y)]);
            self.letter = 'M';
            return;
        };
        let mut steps = Vec::with_capacity(6);
        let mut place = self.pen;
        for &point in points {
            let step = point - origin;
            place = [hundredths(step.x), hundredths(step.y)];
            steps.extend([place[0] - self.pen[0], place[1] - self.pen[1]]);
        }
        self.pen = place;
        if letter == 'm' {
            self.down = place;
        }
        if letter != self.letter || letter == 'm' {
            self.data.push(letter);
            self.letter = letter;
        }
        self.numbers(&steps);
    }

    fn close(&mut self) {
        self.data.push('z');
        self.pen = self.down;
        self.letter = 'z';
    }

    fn numbers(&mut self, hundredths: &[i64]) {
        for &value in hundredths {
            let number = short(value);
            let is_apart = number.starts_with('-') || self.is_broken && number.starts_with('.');
            if self.data.ends_with(|c: char| c.is_ascii_digit()) && !is_apart {
                self.data.push(' ');
            }
            self.is_broken = number.contains('.');
            self.data.push_str(&number);
        }
    }
}

/// A number of hundredths, without zeros that say nothing.
fn short(hundredths: i64) -> String {
    let sign = if hundredths < 0 { "-" } else { "" };
    let (whole, part) = (hundredths.abs() / 100, hundredths.abs() % 100);
    let whole = if whole == 0 && part != 0 { String::new() } else { whole.to_string() };
    let part = format!("{part:02}");
    match part.trim_end_matches('0') {
        "" => format!("{sign}{whole}"),
        digits => format!("{sign}{whole}.{digits}"),
    }
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
        let third: Vec<Point> = (0..=300).map(|n| at(f64::from(n) / 3.0, 0.0)).collect();
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
    fn the_same_letter_elsewhere_is_written_alike() {
        let letter = |x: f64, y: f64| {
            let place = |dx: f64, dy: f64| at(x + dx, y + dy);
            outline(&[
                Segment::Move(place(0.0, 0.0)),
                Segment::Cubic(place(0.333, 0.2), place(1.277, 2.0), place(2.0, 2.0)),
                Segment::Quadratic(place(3.0, 3.0), place(4.0, 4.0)),
                Segment::Close,
                Segment::Move(place(1.0, 1.0)),
                Segment::Line(place(1.5, 1.5)),
                Segment::Close,
            ])
        };
        let behind_start = |data: &str| data[data.find('c').unwrap()..].to_owned();
        assert_eq!(behind_start(&letter(0.0, 0.0)), "c.33.2 1.28 2 2 2q1 1 2 2zm1 1l.5.5z");
        assert_eq!(behind_start(&letter(7.126, 3.333)), behind_start(&letter(0.0, 0.0)));
    }
}
