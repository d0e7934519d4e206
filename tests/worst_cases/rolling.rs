//! What wheel and disk share: how they are drawn, the equations of motion of a disc on its edge, and what a change of the
//! start makes.
//!
//! The judge was derived with the normal *upward*: its axes 1 and 3 are the library's, reversed, and its heading
//! differs by half a turn.

use crate::long::{Long, PI, long};
use crate::search::{Draw, worse};
use crate::taylor::{System, Term};
use mechanics::nalgebra::Complex;
use mechanics::rolling::{DiskParameters, MomentFactors, Rolling};

/// Hoop, disc, other flat bodies, and bodies that are not flat, of mass one.
pub(crate) fn parameters(draw: &mut Draw<'_>, least: f64) -> DiskParameters {
    let moments = match draw.below(4) {
        0 => draw.one_of(&[MomentFactors::DISK, MomentFactors::HOOP]),
        1 => MomentFactors::flat(draw.decades(least, 1.0)),
        _ => {
            let transverse = draw.decades(least, 10.0);
            MomentFactors { transverse, axial: transverse * draw.decades(1e-6, 2.0) }
        }
    };
    let (radius, gravity) =
        if draw.below(2) == 0 { (1.0, 1.0) } else { (draw.decades(1e-2, 1e2), draw.decades(1e-1, 1e3)) };
    DiskParameters { mass: 1.0, radius, moments, gravity }
}

/// A heading, a roll angle and a place, for a state.
pub(crate) fn placed(draw: &mut Draw<'_>, radius: f64, state: Rolling) -> Rolling {
    let [x, y] = [0, 1].map(|_| radius * draw.between(-3.0, 3.0));
    Rolling {
        heading: draw.between(-4.0, 4.0),
        roll_angle: draw.between(-4.0, 4.0),
        centre: Complex::new(x, y),
        ..state
    }
}

/// A disc or hoop on its edge, with its moments over ma², on a film or none; g/a in 1/s², the film's torque over m a²
/// in 1/s.
#[derive(Clone, Copy)]
pub(crate) struct Disc {
    pub(crate) transverse: f64,
    pub(crate) axial: f64,
    pub(crate) gravity_over_radius: Long,
    pub(crate) film: Long,
}

/// β, its rate, ω₂, ω₃, the heading ψ of axis 1, the turn φ about axis 3, and the contact over the radius.
pub(crate) type Numbers = [Long; 8];

/// The judge's numbers of a state, the place over the radius.
pub(crate) fn numbers(start: &Rolling, radius: f64) -> Numbers {
    let ((s, c), cos) = (long(start.heading).sin_cos(), long(start.tilt).sin_cos().1);
    let [x, y] = [start.centre.re, start.centre.im].map(|x| long(x) / radius);
    [
        long(start.tilt),
        -long(start.omega_1),
        long(start.omega_2),
        -long(start.omega_3),
        long(start.heading) + PI,
        -long(start.roll_angle),
        x - s * cos,
        y + c * cos,
    ]
}

/// And back: the numbers of [`Rolling`], the centre over the radius.
pub(crate) fn rolling(n: &Numbers) -> [Long; 8] {
    let (s, c) = n[4].sin_cos();
    let cos = n[0].sin_cos().1;
    [n[0], -n[1], n[2], -n[3], n[4] - PI, -n[5], n[6] - s * cos, n[7] + c * cos]
}

/// The largest error of a state in parts of what is promised for this tolerance: by how much the numbers have `changed`, and
/// a [`change`] of them and of one in the units a, √(g/a) and rad, with that of the heading's way for the place.
fn part_of_allowed(
    parameters: &DiskParameters,
    [given, found]: [&Rolling; 2],
    truth: &Numbers,
    changed: &[f64; 8],
    tolerance: f64,
) -> (f64, usize) {
    let (radius, rate) = (parameters.radius, (parameters.gravity / parameters.radius).sqrt());
    let truth = rolling(truth);
    let scale = [1.0, rate, rate, rate, 1.0, 1.0, radius, radius];
    let turned = (truth[4] - given.heading).abs().rounded();
    // The centre is a cos α from the contact, so that a change of the tilt moves it too.
    let way_gone = changed[6].max(changed[7]) + changed[4] + changed[0];
    let given = given.to_array();
    let mut worst = (0.0, 0);
    for (i, found) in found.to_array().into_iter().enumerate() {
        let true_value = if i < 6 { truth[i] } else { truth[i] * radius };
        let size = scale[i].max(given[i].abs()).max(true_value.abs().rounded());
        // Near flat heading and roll angle whirl round together; one that has whirled back has the rounding of that.
        let whirls = truth[4].abs().rounded().max(truth[5].abs().rounded());
        let size = if i == 4 || i == 5 { size.max(whirls) } else { size };
        // A place has the rounding of the heading that led there.
        let (size, changed) =
            if i < 6 { (size, changed[i]) } else { (size + radius * turned, radius * way_gone) };
        let allowed = size * change(tolerance) + changed;
        let ratio = (true_value - found).abs().rounded() / allowed;
        if ratio.is_nan() || ratio > worst.0 {
            worst = (ratio, i);
        }
    }
    worst
}

/// The part by which a number may be off, or start and time changed: thirty units in the last place, or times a looser
/// tolerance.
fn change(tolerance: f64) -> f64 {
    30.0 * tolerance.max(f64::EPSILON)
}

impl Disc {
    /// Of this body, with the film's number.
    pub(crate) fn new(parameters: &DiskParameters, film: f64) -> Self {
        let DiskParameters { radius, moments: MomentFactors { transverse, axial }, gravity, .. } =
            *parameters;
        let gravity_over_radius = long(gravity) / radius;
        Self { transverse, axial, gravity_over_radius, film: gravity_over_radius.sqrt() * film }
    }

    /// The motion from a start, at times that run from zero in one direction. Nothing if the judge gives up.
    pub(crate) fn motion(&self, start: &Numbers, times: &[Long]) -> Option<Vec<Numbers>> {
        self.follow(start, times, |_, _| {})
    }

    /// The same; the time and the numbers where each step of the judge begins are told. Momentum about the contact with axes
    /// that follow the heading and the tilt β from lying flat: axis 1 level, 3 the upward normal, ω₃ − ω₂ cot β = φ̇.
    fn follow(
        &self,
        start: &Numbers,
        times: &[Long],
        mut begins: impl FnMut(Long, Numbers),
    ) -> Option<Vec<Numbers>> {
        let &Self { transverse, axial, gravity_over_radius: gravity, film } = self;
        let (mut system, terms): (System, [Term; 12]) = System::new();
        let [tilt, w1, w2, w3, heading, spin, x, y, sin, cos, cos_heading, sin_heading] = terms;
        let [one, transverse, axial] = [1.0, transverse, axial].map(long);
        let turn = system.quotient(w2, sin); // of the heading
        let o3 = system.product(turn, cos);
        let (w2_o3, w2_w3) = (system.product(w2, o3), system.product(w2, w3));
        let (w1_o3, w1_w3, w1_w2) = (system.product(w1, o3), system.product(w1, w3), system.product(w1, w2));
        let square = system.product(sin, sin);
        let cube = system.product(square, sin);
        let (drag1, drag2) = (system.quotient(w1, cube), system.quotient(w2, cube));
        let run = system.sum(&[(one, o3), (-one, w3)]); // the contact's, over the radius
        system.rate(tilt, &[(one, w1)]);
        let over = one / (one + transverse);
        system.rate(
            w1,
            &[
                (transverse * over, w2_o3),
                (-(one + axial) * over, w2_w3),
                (-gravity * over, cos),
                (-film * over, drag1),
            ],
        );
        system.rate(w2, &[(axial / transverse, w1_w3), (-one, w1_o3), (-film / transverse, drag2)]);
        system.rate(w3, &[(one / (one + axial), w1_w2)]);
        system.rate(heading, &[(one, turn)]);
        system.rate(spin, &[(one, w3), (-one, o3)]);
        let (dx, dy) = (system.product(run, cos_heading), system.product(run, sin_heading));
        system.rate(x, &[(one, dx)]);
        system.rate(y, &[(one, dy)]);
        let (s, c) = (system.product(w1, cos), system.product(w1, sin));
        system.rate(sin, &[(one, s)]);
        system.rate(cos, &[(-one, c)]);
        let (s, c) = (system.product(turn, cos_heading), system.product(turn, sin_heading));
        system.rate(cos_heading, &[(-one, c)]);
        system.rate(sin_heading, &[(one, s)]);
        let ((s, c), (sh, ch)) = (start[0].sin_cos(), start[4].sin_cos());
        let begin: Vec<Long> = start.iter().copied().chain([s, c, ch, sh]).collect();
        let own = |state: &[Long]| std::array::from_fn(|i| state[i]);
        let samples = system.follow(&begin, times, |time, state| begins(time, own(state)))?;
        Some(samples.iter().map(|sample| own(sample)).collect())
    }

    /// The largest error of a state that was found in parts of what is promised for this tolerance; nothing if the judge
    /// gives up. Changes are by a part of the numbers' own, or with a looser tolerance than rounding, or if all are `in_units`,
    /// of one in the units a, √(g/a) and rad where that is larger.
    pub(crate) fn worst_part(
        &self,
        parameters: &DiskParameters,
        [given, found]: [&Rolling; 2],
        time: f64,
        tolerance: f64,
        in_units: bool,
    ) -> Option<(f64, usize)> {
        let (part, is_loose) = (change(tolerance), tolerance > f64::EPSILON);
        let (start, time) = (numbers(given, parameters.radius), long(time));
        let thirds = [time * (1.0 / 3.0), time * (2.0 / 3.0)];
        let [first, second, truth] =
            self.motion(&start, &[thirds[0], thirds[1], time])?.try_into().expect("three");
        // All that is passed from a little before the time to a little after it: a disc may whirl round in between.
        let largest = |begin: &Numbers, gone: Long, part: f64| -> Option<[f64; 8]> {
            let [early, late] = [-part, part].map(|part| time * (long(1.0) + part) - gone);
            let mut passed = Vec::new();
            let ends = self.follow(begin, &[early, late], |now, numbers| {
                if now.abs() > early.abs() {
                    passed.push(numbers);
                }
            })?;
            passed.extend(ends);
            let by = |i: usize| passed.iter().map(move |other| (other[i] - truth[i]).abs().rounded());
            Some(std::array::from_fn(|i| by(i).fold(0.0, worse)))
        };
        let rate = self.gravity_over_radius.sqrt().rounded();
        let least = if in_units || is_loose { [1.0, rate, rate, rate] } else { [0.0; 4] };
        // Two draws of signs, so that no two changes cancel twice. What is no small change is not in proportion to it either,
        // so it is tried both ways, and at all these times.
        let moved = |state: &Numbers, gone: Long, part: f64| -> Option<[f64; 8]> {
            let (sides, around) = if is_loose { (&[part, -part][..], part) } else { (&[part][..], 0.0) };
            let mut all = [0.0; 8];
            for signs in [[1.0, 1.0, 1.0, 1.0], [1.0, -1.0, 1.0, -1.0]] {
                for side in sides {
                    let mut begin = *state;
                    for i in 0..4 {
                        begin[i] = begin[i] + side * signs[i] * least[i].max(state[i].rounded().abs());
                    }
                    all = added(&all, &largest(&begin, gone, around)?);
                }
            }
            Some(all)
        };
        let now = long(0.0);
        let changed = added(&largest(&start, now, part)?, &moved(&start, now, part)?);
        let of_start = part_of_allowed(parameters, [given, found], &truth, &changed, tolerance);
        if of_start.0 < 1.0 {
            return Some(of_start);
        }
        // What the start does not explain may come from the way: where a disc gets up again, a change of the start has nearly
        // gone, and one on the way has not.
        let of_way = [(first, thirds[0]), (second, thirds[1])];
        let of_way = of_way.into_iter().filter_map(|(state, gone)| moved(&state, gone, 0.1 * part));
        let changed = of_way.fold(changed, |all, own| added(&all, &own));
        Some(part_of_allowed(parameters, [given, found], &truth, &changed, tolerance))
    }
}

fn added(one: &[f64; 8], other: &[f64; 8]) -> [f64; 8] {
    std::array::from_fn(|i| one[i] + other[i])
}
