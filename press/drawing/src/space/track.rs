//! Lines in space, as points with what lies between them.

use super::vector::Vec3;
use arrayvec::ArrayVec;
use std::f64::consts::TAU;

/// Into how many chords a full turn is divided; one that is seen to be small, into fewer ([`Camera::chords`]).
///
/// [`Camera::chords`]: super::camera::Camera::chords
pub(super) const CHORDS: u32 = 180;

/// A line in space.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Track {
    pub(super) points: Vec<Vec3>,
    /// Whether the points belong to a smooth curve; otherwise straight lines lead from one to the next.
    pub(super) smooth: bool,
}

impl Track {
    /// A straight line.
    pub(super) fn segment(from: Vec3, to: Vec3) -> Self {
        Self { points: vec![from, to], smooth: false }
    }

    /// An arc about a centre, from `start` (a step from the centre, across the axis) over `sweep` about a unit axis, rad.
    pub(super) fn arc(centre: Vec3, axis: Vec3, start: Vec3, sweep: f64) -> Self {
        let aside = axis.cross(start);
        // An even number of chords, so that the middle is one of the points.
        let half = (0.5 * f64::from(CHORDS) * sweep.abs() / TAU).ceil().max(4.0) as u32;
        let points = turns(0.0, sweep, 2 * half).map(|(sin, cos)| centre + start * cos + aside * sin);
        Self { points: points.collect(), smooth: true }
    }

    /// A circle about a centre in so many chords; `first` and `second` are its radii in two perpendicular directions.
    pub(super) fn circle(centre: Vec3, [first, second]: [Vec3; 2], chords: u32) -> Self {
        let points = turns(0.0, TAU, chords).map(|(sin, cos)| centre + first * cos + second * sin);
        let mut points: Vec<Vec3> = points.collect();
        points[chords as usize] = points[0];
        Self { points, smooth: true }
    }

    /// How many chords it has.
    pub(super) fn chords(&self) -> usize {
        self.points.len().saturating_sub(1)
    }

    /// Whether it ends where it began.
    pub(super) fn closed(&self) -> bool {
        self.points.len() > 3 && self.points.first() == self.points.last()
    }

    /// The point at a parameter that counts chords.
    pub(super) fn at(&self, parameter: f64) -> Vec3 {
        let chord = (parameter.max(0.0) as usize).min(self.chords().saturating_sub(1));
        self.on_chord(chord, parameter - chord as f64)
    }

    /// The point at a fraction of a chord. On a smooth curve it lies on the cubic through the four nearest
    /// points, with the lengths of the chords as parameter.
    pub(super) fn on_chord(&self, chord: usize, part: f64) -> Vec3 {
        let (from, to) = (self.points[chord], self.points[chord + 1]);
        if part >= 1.0 {
            return to;
        }
        if !self.smooth || part <= 0.0 {
            return from.towards(to, part);
        }
        let nearest = self.neighbours(chord);
        let step = (to - from).length();
        let mut knots = [0.0; 4];
        let knots = &mut knots[..nearest.len()];
        for index in 1..nearest.len() {
            knots[index] = knots[index - 1] + (nearest[index].0 - nearest[index - 1].0).length();
        }
        let own = nearest.iter().position(|&(_, own)| own).unwrap_or(0);
        if knots.windows(2).any(|pair| pair[1] <= pair[0]) {
            return from.towards(to, part);
        }
        // In the middle of chords of one length, as most are.
        if let [(first, _), (second, _), (third, _), (fourth, _)] = nearest[..]
            && part == 0.5
            && own == 1
            && (knots[1] - step).abs().max((knots[3] - knots[2] - step).abs()) < 1e-9 * step
        {
            return (second + third) * 0.5625 - (first + fourth) * 0.0625;
        }
        let wanted = knots[own] + part * step;
        let mut sum = Vec3::ZERO;
        for (index, &(point, _)) in nearest.iter().enumerate() {
            let others = knots.iter().enumerate().filter(|&(other, _)| other != index);
            let weight: f64 = others.map(|(_, knot)| (wanted - knot) / (knots[index] - knot)).product();
            sum = sum + point * weight;
        }
        sum
    }

    /// Up to four points about a chord, in order; the one where the chord begins is marked.
    fn neighbours(&self, chord: usize) -> ArrayVec<(Vec3, bool), 4> {
        let chords = self.chords();
        let marked = |index: usize| (self.points[index], index == chord);
        if self.closed() {
            return [chord + chords - 1, chord, chord + 1, chord + 2]
                .map(|index| marked(index % chords))
                .into();
        }
        let first = chord.saturating_sub(1).min((chords + 1).saturating_sub(4));
        (first..=chords.min(first + 3)).map(marked).collect()
    }
}

/// Sine and cosine of the angles from one on over another in equal steps, each turned out of the one before: that costs a
/// fraction of what sines cost a browser, and after two hundred steps it is right to a part in 10¹³.
pub(super) fn turns(from: f64, sweep: f64, count: u32) -> impl Iterator<Item = (f64, f64)> {
    let (step_sin, step_cos) = (sweep / f64::from(count)).sin_cos();
    let mut now = from.sin_cos();
    (0..=count).map(move |_| {
        let (sin, cos) = now;
        now = (sin * step_cos + cos * step_sin, cos * step_cos - sin * step_sin);
        (sin, cos)
    })
}

#[cfg(test)]
mod tests {
    use super::{CHORDS, Track, Vec3};
    use std::f64::consts::FRAC_PI_2;

    #[test]
    fn between_its_points_a_circle_stays_a_circle() {
        let axis = Vec3([1.0, 2.0, -2.0]) * (1.0 / 3.0);
        let (first, second) = axis.companions();
        let quarter = Track::arc(Vec3::ZERO, axis, first, FRAC_PI_2);
        let circle = Track::circle(Vec3::ZERO, [first, second], CHORDS);
        for track in [&quarter, &circle] {
            let worst = (0..track.chords() * 10)
                .map(|tenth| (track.at(tenth as f64 / 10.0).length() - 1.0).abs())
                .fold(0.0, f64::max);
            assert!(worst < 1e-7, "{worst}"); // the chords themselves stay 1.5e-4 inside
        }
        assert!(circle.closed() && !quarter.closed());
        assert!((circle.at(90.0) + first).length() < 1e-14); // each point is turned out of the one before
        assert!((quarter.points[quarter.chords()] - second).length() < 1e-15);
        assert_eq!(Track::segment(first, second).at(0.25), first.towards(second, 0.25));
    }

    #[test]
    fn uneven_points_do_not_bend_the_curve() {
        let angles = [0.0, 0.01, 0.05, 0.06, 0.1, 0.16, 0.17_f64];
        let points = angles.iter().map(|angle| Vec3([angle.cos(), angle.sin(), 0.0])).collect();
        let track = Track { points, smooth: true };
        let worst =
            (0..60).map(|tenth| (track.at(f64::from(tenth) / 10.0).length() - 1.0).abs()).fold(0.0, f64::max);
        assert!(worst < 1e-6, "{worst}");
    }
}
