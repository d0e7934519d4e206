//! What is said of a top without following it: between which tilts it nods, how long a nod takes, and how fast it goes round
//! steadily. Judged in 32 digits: the tilts by bisection in the squared tangent of half the tilt, the nod by the
//! arithmetic-geometric mean, the steady rates by their quadratic.

use crate::long::{Long, PI, long, off_angle};
use crate::search::{Case, Draw, keeps_its_promise, worse};
use crate::top::{WAYS, made, upright, way};
use mechanics::euler::Turning;
use mechanics::scenes::top::{Top, TopParameters};
use std::f64::consts;

/// What the documentation promises of the tilts, of the nod and of the steady rates, relative.
const OF_TILTS: f64 = 1e-15;
const OF_NODS: f64 = 4e-16;
const OF_STEADY: f64 = 1e-15;
/// What 32 digits leave of a difference, of its parts, since a product of two such numbers is good to 2⁻¹⁰⁴, which is 5e-32; and
/// from how many times as large parts on it is a small one.
const DIGITS: f64 = 4e-32;
const SMALL: f64 = 1e15;
/// The square of a tilt that counts as none.
const NONE: f64 = 1e-60;

/// The nodding in `s = tan² ½θ`, whose rate obeys `ṡ² = ¼(1 + s)P(s)` with `P = 4s(e + fs) − (B + As)²(1 + s)`. In units of I₁ the
/// momentum about the vertical is ½(A + B), that about the axis ½(A − B), and twice the energy of the motion across the axis
/// would be e upright and f hanging.
#[derive(Clone, Copy)]
struct Nodding {
    momenta: [Long; 2],  // A, B
    energies: [Long; 2], // f, e
    start: Long,         // s
    speed: Long,         // P at the start
    lost: f64,           // how many times as large the parts of B and e are
}

/// Where it turns: s at the least tilt, 1/s at the greatest, and what P is between them, `(s − s₁)(s₂ − s)(G/s₂ + N s₂)` over s₂.
struct Turns {
    ends: [Long; 2],
    factors: [Long; 2], // G = A²s₂ and N = B²/s₁
}

/// Two tangents, as opposite and adjacent side.
type Tangents = [(Long, Long); 2];

impl Nodding {
    fn new(top: &TopParameters, start: &Turning) -> Self {
        let (q, w, l) = (start.world_from_body, start.omega_body, long);
        let (up, down) = (l(q.w) * q.w + l(q.k) * q.k, l(q.i) * q.i + l(q.j) * q.j);
        let length = up + down;
        // sin θ along the body's axes 1 and 2, times ½ length.
        let (sin, cos) = (l(q.k) * q.i - l(q.w) * q.j, l(q.w) * q.i + l(q.k) * q.j);
        let (rise, momentum) =
            ((sin * w.y - cos * w.x) * 2.0 / length, (cos * w.y + sin * w.x) * 2.0 / length);
        let (above, below) = (up * 2.0 / length, down * 2.0 / length);
        let a = l(top.axial) * w.z / top.transverse;
        let beta = l(top.mass) * top.arm * top.gravity * 2.0 / top.transverse;
        let across = l(w.x) * w.x + l(w.y) * w.y;
        let opened = long(2.0) / above; // 1 + s
        let (difference, energy) = (momentum - a * below, across - beta * below);
        let turning = ((cos * w.y).abs() + (sin * w.x).abs()) * 2.0 / length;
        let lost =
            |parts: Long, rest: Long| if rest == long(0.0) { 0.0 } else { (parts / rest).abs().rounded() };
        Self {
            momenta: [momentum + a * above, difference],
            energies: [across + beta * above, energy],
            start: below / above,
            speed: rise * rise * opened * opened * opened,
            lost: lost(turning + (a * below).abs(), difference) + lost(across + beta * below, energy),
        }
    }

    /// The same in 1/s: upside down.
    fn turned(self) -> Self {
        let Self { momenta: [a, b], energies: [f, e], start, speed, lost } = self;
        let speed = speed / (start * start * start);
        Self { momenta: [b, a], energies: [e, f], start: long(1.0) / start, speed, lost }
    }

    /// The coefficients of P, that of s⁰ first.
    fn coefficients(&self) -> [Long; 4] {
        let ([a, b], [f, e]) = (self.momenta, self.energies);
        let mixed = a * b * 2.0;
        [-(b * b), e * 4.0 - mixed - b * b, f * 4.0 - mixed - a * a, -(a * a)]
    }

    /// Whether the top comes to s. Near the start P is counted from there.
    fn comes_to(&self, s: Long) -> bool {
        let [c0, c1, c2, c3] = self.coefficients();
        let (s0, y) = (self.start, s - self.start);
        let value = if y.abs().rounded() < 0.5 * s0.rounded() {
            let (first, second) = ((c3 * s0 * 3.0 + c2 * 2.0) * s0 + c1, c3 * s0 * 3.0 + c2);
            ((c3 * y + second) * y + first) * y + self.speed
        } else {
            ((c3 * s + c2) * s + c1) * s + c0
        };
        value.rounded() >= 0.0
    }

    /// The last s to which it comes from the start, down with a factor below one or up: zero or infinity if none is the last.
    fn edge(&self, factor: f64) -> Long {
        let mut inside = self.start;
        let mut outside = loop {
            let next = inside * factor;
            if !self.comes_to(next) {
                break next;
            }
            if !(NONE..1.0 / NONE).contains(&next.rounded()) {
                return long(if factor < 1.0 { 0.0 } else { f64::INFINITY });
            }
            inside = next;
        };
        loop {
            let gap = (outside - inside).abs().rounded();
            if gap < 1e-26 * inside.rounded() {
                return inside;
            }
            let middle = if gap < inside.rounded().min(outside.rounded()) {
                (inside + outside) * 0.5
            } else {
                (inside * outside).sqrt()
            };
            if self.comes_to(middle) { inside = middle } else { outside = middle }
        }
    }

    /// The turns of a top that is not at rest at a pole; `start` is at most one.
    fn turns(&self) -> Turns {
        let [c0, c1, c2, c3] = self.coefficients();
        let none = long(0.0);
        let (least, over) = if self.start == none {
            // It goes through the pole: c₁ + c₂s + c₃s² = 0.
            let root = (c2 * c2 - c1 * c3 * 4.0).sqrt();
            (none, if c2 > none { c3 * -2.0 / (root + c2) } else { (root - c2) / (c1 * 2.0) })
        } else {
            let most = self.edge(256.0);
            (self.edge(1.0 / 256.0), if most.rounded().is_finite() { long(1.0) / most } else { none })
        };
        let factors =
            [if over > none { -(c3 / over) } else { c2 }, if least > none { -(c0 / least) } else { c1 }];
        Turns { ends: [least, over], factors }
    }

    /// The tangents of half the least and half the greatest tilt, as opposite and adjacent side, and the nod's period, if
    /// there is one, with how many times as large the parts of its square are.
    fn judged(&self) -> (Tangents, Option<(Long, f64)>) {
        let (none, one) = (long(0.0), long(1.0));
        let is_low = self.start > one; // or infinite, where it hangs
        let upright = if is_low { self.turned() } else { *self };
        let [_, c1, c2, c3] = upright.coefficients();
        let (sides, [h, gap]) = if c1 == none && (upright.start == none || c2 == none) {
            // At rest, at a pole or without weight; it oscillates if it would come back.
            ([(upright.start.sqrt(), one); 2], [-c2; 2])
        } else {
            let Turns { ends: [least, over], factors: [g, n] } = upright.turns();
            let factors = [(g + n * over) * (one + least), (g * least + n) * (one + over)];
            ([(least.sqrt(), one), (one, over.sqrt())], factors)
        };
        let sides = if is_low { [sides[1], sides[0]].map(|(sin, cos)| (cos, sin)) } else { sides };
        // β(u₃ − u₁) and β(u₃ − u₂), times four.
        let parts = upright.energies[0] * 4.0 - c3;
        let nod =
            (h > none && gap > none).then(|| (PI * 4.0 / mean(h.sqrt(), gap.sqrt()), (parts / h).rounded()));
        (sides, nod)
    }
}

/// The arithmetic-geometric mean.
fn mean(mut a: Long, mut b: Long) -> Long {
    while (a - b).abs().rounded() > 1e-30 * a.rounded() {
        (a, b) = ((a + b) * 0.5, (a * b).sqrt());
    }
    a
}

/// By how much the tilts and the nod are off, of what is promised, the way the top goes, and what there is to say.
fn judge(draw: &mut Draw<'_>) -> Option<([f64; 2], &'static str, String)> {
    let (top, start, motion) = if draw.below(20) == 0 { upright(draw)? } else { made(draw)? };
    let (top, start) = (&top, &start);
    // In a unit in which rates are about one.
    let beta = 2.0 * top.mass * top.arm * top.gravity / top.transverse;
    let largest = start.omega_body.norm().max(beta.sqrt());
    let rate = if largest > 0.0 { 2_f64.powi(largest.log2() as i32) } else { 1.0 };
    let unit = TopParameters { gravity: top.gravity / rate / rate, ..*top };
    let scaled = Turning { omega_body: start.omega_body / rate, ..*start };
    let nodding = Nodding::new(&unit, &scaled);
    let (sides, nod) = nodding.judged();
    let tilts = motion.tilts();
    let [least, most] = [0, 1].map(|n| {
        let (sin, cos) = sides[n];
        let is_none = tilts[n] * tilts[n] < NONE && (sin * sin).rounded() < NONE * (cos * cos).rounded();
        if is_none { 0.0 } else { off_angle(sides[n], 0.5 * tilts[n]) }
    });
    let (period, lost) = match (nod, motion.nod_period()) {
        (Some((nod, lost)), Some(found)) => (nod.off(found * rate), lost),
        (None, None) => (0.0, 0.0),
        _ => (f64::INFINITY, 0.0),
    };
    let way = match way(top, start) {
        "fast" if motion.nod_period().is_none() => "on the separatrix",
        _ if nodding.lost.max(lost) > SMALL => "a small difference",
        way => way,
    };
    let said = format!(
        "{top:?} {:?}: tilts {tilts:?} {least:e} {most:e}, nod {:?} {period:e}, lost {:e} {lost:e}",
        start.to_array(),
        motion.nod_period(),
        nodding.lost,
    );
    let ratios =
        [worse(least, most) / (OF_TILTS + DIGITS * nodding.lost), period / (OF_NODS + DIGITS * lost)];
    Some((ratios, way, said))
}

fn ways() -> Vec<&'static str> {
    [&WAYS[..], &["a small difference"]].concat()
}

#[test]
fn the_tilts_between_which_any_top_nods_have_all_their_digits() {
    keeps_its_promise("tilts", 6000, &ways(), |draw| {
        let ([ratio, _], way, said) = judge(draw)?;
        Some(Case { ratio, way, said })
    });
}

#[test]
fn how_long_any_top_nods_has_all_its_digits() {
    keeps_its_promise("nod", 6000, &ways(), |draw| {
        let ([_, ratio], way, said) = judge(draw)?;
        Some(Case { ratio, way, said })
    });
}

/// A top with I₁ and I₃, and its weight's torque: its arm is so short that it is a body for any I₃ up to 2I₁.
fn weighed(draw: &mut Draw<'_>) -> Option<(TopParameters, Top)> {
    let (rate, heavy) = (draw.unit(12), draw.unit(12));
    let arm = 2_f64.powi(-30);
    let weight = if draw.below(10) == 0 { 0.0 } else { draw.decades(1e-6, 1e6) };
    let parameters = TopParameters {
        mass: heavy,
        arm,
        transverse: heavy,
        axial: heavy * draw.one_of(&[1.0, 1.9, 0.03, 1e-4, 0.4]),
        gravity: weight * rate * rate / arm,
    };
    Some((parameters, Top::new(parameters).ok()?))
}

/// What the two rates are at a tilt; those of the bound where there are none, and whether there are any. The second is
/// infinite for a level axis.
fn steady(top: &TopParameters, tilt: Long, is_level: bool, spin: f64) -> ([Long; 2], bool) {
    let (one, weight) = (long(top.transverse), long(top.mass) * top.arm * top.gravity);
    let momentum = long(top.axial) * spin;
    let cos = if is_level { long(0.0) } else { (PI * 0.5 - tilt).sin_cos().0 };
    let under = momentum * momentum - one * weight * cos * 4.0;
    let root = if under < long(0.0) { long(0.0) } else { under.sqrt() };
    let sum = if spin < 0.0 { momentum - root } else { momentum + root };
    ([weight * 2.0 / sum, sum / (one * cos * 2.0)], under >= long(0.0))
}

/// By how much a rate is outside the truths that are to be had with a tilt that is wrong by its rounding, relative.
fn outside(truths: &[Long], found: f64) -> f64 {
    let (mut low, mut high) = (truths[0], truths[0]);
    for &truth in truths {
        (low, high) = (if truth < low { truth } else { low }, if truth > high { truth } else { high });
    }
    if !found.is_finite() {
        f64::INFINITY
    } else if long(found) < low {
        low.off(found)
    } else if long(found) > high {
        high.off(found)
    } else {
        0.0
    }
}

#[test]
fn the_rates_of_steady_precession_are_those_of_the_quadratic() {
    let ways = ["none", "near the bound", "level", "slow and fast", "hanging", "without weight", "at rest"];
    keeps_its_promise("steady precession", 20000, &ways, |draw| {
        let (parameters, top) = weighed(draw)?;
        let right = consts::FRAC_PI_2;
        let tilt = match draw.below(7) {
            0 => draw.decades(1e-20, 1e-1),
            1 => consts::PI - draw.decades(1e-15, 1e-1),
            2 => draw.beside(right),
            3 => draw.one_of(&[0.0, right, right.next_up(), consts::PI]),
            _ => draw.between(0.0, consts::PI),
        };
        let bound = 2.0 * f64::sqrt((top.weight_torque() * parameters.transverse * tilt.cos()).max(0.0))
            / parameters.axial;
        let scale = f64::sqrt(top.weight_torque() / parameters.transverse)
            + f64::from(u8::from(top.weight_torque() == 0.0));
        let spin = draw.one_of(&[-1.0, 1.0])
            * match draw.below(4) {
                0 => draw.signed(1e-8, 1e8) * scale,
                1 => 0.0,
                _ => draw.beside(bound),
            };
        let is_level = (tilt - right).abs() < 4.0 * f64::EPSILON;
        let answer = top.steady_precession(tilt, spin);
        let said = format!("{parameters:?} at {tilt:?} with {spin:?}: {answer:?}");
        if spin == 0.0 && (is_level || parameters.gravity == 0.0) {
            let ratio = if answer.is_err() { 0.0 } else { f64::INFINITY };
            return Some(Case { ratio, way: "at rest", said });
        }
        let Ok(answer) = answer else { return Case::refused("slow and fast", said) };
        let rounding = long(tilt) * f64::EPSILON;
        let near = [long(tilt), long(tilt) - rounding, long(tilt) + rounding]
            .map(|tilt| steady(&parameters, tilt, is_level, spin));
        let (may, must) = (near.iter().any(|found| found.1), near.iter().all(|found| found.1));
        let Some(found) = answer else {
            return Some(Case { ratio: if must { f64::INFINITY } else { 0.0 }, way: "none", said });
        };
        let slow = outside(&near.map(|truths| truths.0[0]), found.slow);
        let fast = match found.fast {
            Some(fast) if !is_level => outside(&near.map(|truths| truths.0[1]), fast),
            None if is_level => 0.0,
            _ => f64::INFINITY,
        };
        let ratio = if may { worse(slow, fast) / OF_STEADY } else { f64::INFINITY };
        let way = match () {
            () if parameters.gravity == 0.0 => "without weight",
            () if is_level => "level",
            () if tilt > right => "hanging",
            () if spin.abs() < 1.001 * bound => "near the bound",
            () => "slow and fast",
        };
        Some(Case { ratio, way, said: format!("{said}: {slow:e} {fast:e}") })
    });
}
