//! What the judges of wheel and disk share: the equations of motion of a disc on its edge, and what an ulp of the start makes.

use crate::long::{Long, long};
use crate::taylor::{System, Term};

/// A disc or hoop on its edge, with moments `k m a²` and half of it, on a film or none; g/a in 1/s², the film's torque over m a² in 1/s.
#[derive(Clone, Copy)]
pub(crate) struct Disc {
    pub(crate) k: f64,
    pub(crate) gravity_over_radius: Long,
    pub(crate) film: Long,
}

/// β, its rate, ω₂, ω₃, the heading ψ of axis 1, the turn φ about axis 3, and the contact over the radius.
pub(crate) type Numbers = [Long; 8];

impl Disc {
    /// The motion from a start, at times that run from zero in one direction. Momentum about the contact with axes that follow the
    /// heading and the tilt β from lying flat: axis 1 level, 3 the upward normal, ω₃ − ω₂ cot β = φ̇. Nothing if
    /// the judge gives up.
    pub(crate) fn motion(&self, start: &Numbers, times: &[Long]) -> Option<Vec<Numbers>> {
        let &Self { k, gravity_over_radius: gravity, film } = self;
        let (mut system, terms): (System, [Term; 12]) = System::new();
        let [tilt, w1, w2, w3, heading, spin, x, y, sin, cos, cos_heading, sin_heading] = terms;
        let (one, half) = (long(1.0), long(0.5 * k));
        let turn = system.quotient(w2, sin); // of the heading
        let o3 = system.product(turn, cos);
        let (w2_o3, w2_w3) = (system.product(w2, o3), system.product(w2, w3));
        let (w1_o3, w1_w3, w1_w2) = (system.product(w1, o3), system.product(w1, w3), system.product(w1, w2));
        let square = system.product(sin, sin);
        let cube = system.product(square, sin);
        let (drag1, drag2) = (system.quotient(w1, cube), system.quotient(w2, cube));
        let run = system.sum(&[(one, o3), (-one, w3)]); // the contact's, over the radius
        system.rate(tilt, &[(one, w1)]);
        let over = one / (one + half);
        system.rate(
            w1,
            &[
                (half * over, w2_o3),
                (-(one + k) * over, w2_w3),
                (-gravity * over, cos),
                (-film * over, drag1),
            ],
        );
        system.rate(w2, &[(long(2.0), w1_w3), (-one, w1_o3), (-film / half, drag2)]);
        system.rate(w3, &[(one / (one + k), w1_w2)]);
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
        let samples = system.attempt(&begin, times)?;
        Some(samples.into_iter().map(|sample| std::array::from_fn(|i| sample[i])).collect())
    }

    /// The numbers at a time, and by how much each changes if the first four of the start, and the time, change by a unit in the last
    /// place: of their own, or of `least` where that is larger. Nothing if the judge gives up.
    pub(crate) fn with_conditioning(
        &self,
        start: &Numbers,
        time: f64,
        least: [f64; 4],
    ) -> Option<(Numbers, [f64; 8])> {
        let ulp = f64::EPSILON;
        let after = long(time) * (long(1.0) + ulp);
        let mut samples = self.motion(start, &[long(time), after])?;
        let (later, truth) = (samples.remove(1), samples.remove(0));
        let mut change: [f64; 8] = std::array::from_fn(|i| (later[i] - truth[i]).abs().rounded());
        // Two draws of signs, so that no two changes cancel twice.
        for signs in [[1.0, 1.0, 1.0, 1.0], [1.0, -1.0, 1.0, -1.0]] {
            let mut moved = *start;
            for i in 0..4 {
                moved[i] = moved[i] + ulp * signs[i] * least[i].max(start[i].rounded().abs());
            }
            let there = self.motion(&moved, &[long(time)])?.remove(0);
            for i in 0..8 {
                change[i] += (there[i] - truth[i]).abs().rounded();
            }
        }
        Some((truth, change))
    }
}
