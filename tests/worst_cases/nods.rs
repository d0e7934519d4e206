//! What is said of a top without following it: between which tilts it nods, how long a nod takes, and how fast it goes round
//! steadily. Judged in 32 digits: the tilts by bisection in the squared tangent of half the tilt, the nod by the
//! arithmetic-geometric mean, the steady rates by their quadratic.

use crate::long::{Long, PI, long, off_angle};
use crate::search::{Case, Draw, keeps_its_promise, worse};
use crate::top::{WAYS, made, upright, way};
use mechanics::euler::Turning;
use mechanics::scenes::top::{Top, TopMotion, TopParameters};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use std::f64::consts;

/// What the documentation promises of the tilts, of the nod and of the steady rates, relative.
const OF_TILTS: f64 = 1e-15;
const OF_NODS: f64 = 4e-16;
const OF_STEADY: f64 = 1e-15;
/// What 32 digits leave of a difference, of its parts, since a product of two such numbers is good to 2⁻¹⁰⁴, which is 5e-32; and
/// from how many times as large parts on it is a small one.
const DIGITS: f64 = 4e-32;
const SMALL: f64 = 1e15;
/// The square of half a tilt that counts as none.
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
    parts: [Long; 2],    // of the coefficients of s and s², added up
    lost: f64,           // how many times as large the parts of B are
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
        let parts = turning + (a * below).abs();
        let lost = if difference == long(0.0) { 0.0 } else { (parts / difference).abs().rounded() };
        let (sum, hanging) = (momentum + a * above, across + beta * above);
        let mixed = (sum * difference).abs() * 2.0;
        let first = (across + beta * below) * 4.0 + mixed + difference * difference;
        Self {
            momenta: [sum, difference],
            energies: [hanging, energy],
            parts: [first, hanging * 4.0 + mixed + sum * sum],
            start: below / above,
            speed: rise * rise * opened * opened * opened,
            lost,
        }
    }

    /// The same in 1/s: upside down.
    fn turned(self) -> Self {
        let Self { momenta: [a, b], energies: [f, e], start, speed, parts: [one, other], lost } = self;
        let speed = speed / (start * start * start);
        let start = long(1.0) / start;
        Self { momenta: [b, a], energies: [e, f], start, speed, parts: [other, one], lost }
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

    /// How many times as large the parts of what decides where P has a root are, at s over `unit`.
    fn lost_at(&self, s: Long, unit: Long) -> f64 {
        let terms = |coefficients: [Long; 4]| {
            let powers = [unit * unit * unit, s * unit * unit, s * s * unit, s * s * s];
            coefficients.into_iter().zip(powers).map(|(own, power)| (own * power).abs().rounded())
        };
        let [first, second] = self.parts;
        let none = long(0.0);
        terms([none, first, second, none]).sum::<f64>() / terms(self.coefficients()).fold(0.0, f64::max)
    }

    /// The tangents of half the least and half the greatest tilt, as opposite and adjacent side, and the nod's period, if
    /// there is one; each with how many times as large the parts of what decides it are.
    fn judged(&self) -> (Tangents, [f64; 2], Option<(Long, f64)>) {
        let (none, one) = (long(0.0), long(1.0));
        let is_low = self.start > one; // or infinite, where it hangs
        let upright = if is_low { self.turned() } else { *self };
        let [_, c1, c2, c3] = upright.coefficients();
        let (mut lost, mut opened) = ([0.0; 2], one);
        let (sides, [h, gap]) = if c1 == none && (upright.start == none || c2 == none) {
            // At rest, at a pole or without weight; it oscillates if it would come back.
            ([(upright.start.sqrt(), one); 2], [-c2; 2])
        } else {
            let Turns { ends: [least, over], factors: [g, n] } = upright.turns();
            let factors = [(g + n * over) * (one + least), (g * least + n) * (one + over)];
            if least > none {
                lost[0] = upright.lost_at(least, one);
            }
            if over > none {
                lost[1] = upright.lost_at(one, over);
            }
            opened = one + over;
            ([(least.sqrt(), one), (one, over.sqrt())], factors)
        };
        let sides = if is_low { [sides[1], sides[0]].map(|(sin, cos)| (cos, sin)) } else { sides };
        let lost = if is_low { [lost[1], lost[0]] } else { lost };
        // β(u₃ − u₁) and β(u₃ − u₂), times four.
        let all = upright.energies[0] * 4.0 - c3;
        let lost_by_nod = (all / h + upright.parts[0] * opened / gap).rounded();
        let nod = (h > none && gap > none).then(|| (PI * 4.0 / mean(h.sqrt(), gap.sqrt()), lost_by_nod));
        (sides, lost, nod)
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
    Some(judged(&top, &start, &motion))
}

fn judged(top: &TopParameters, start: &Turning, motion: &TopMotion) -> ([f64; 2], &'static str, String) {
    // In a unit in which rates are about one.
    let beta = 2.0 * top.mass * top.arm * top.gravity / top.transverse;
    let largest = start.omega_body.norm().max(beta.sqrt());
    let rate = if largest > 0.0 { 2_f64.powi(largest.log2() as i32) } else { 1.0 };
    let unit = TopParameters { gravity: top.gravity / rate / rate, ..*top };
    let scaled = Turning { omega_body: start.omega_body / rate, ..*start };
    let nodding = Nodding::new(&unit, &scaled);
    let (sides, lost_by_tilts, nod) = nodding.judged();
    let lost_by_tilts = lost_by_tilts.map(|lost| lost + nodding.lost);
    let tilts = motion.tilts();
    let [least, most] = [0, 1].map(|n| {
        let (sin, cos) = sides[n];
        let half = 0.5 * tilts[n]; // of which `NONE` speaks
        let is_none = half * half < NONE && (sin * sin).rounded() < NONE * (cos * cos).rounded();
        if is_none { 0.0 } else { off_angle(sides[n], half) }
    });
    let (period, lost) = match (nod, motion.nod_period()) {
        (Some((nod, lost)), Some(found)) => (nod.off(found * rate), lost),
        (None, None) => (0.0, 0.0),
        _ => (f64::INFINITY, 0.0),
    };
    let way = match way(top, start) {
        "fast" if motion.nod_period().is_none() => "on the separatrix",
        _ if lost_by_tilts.into_iter().fold(lost, f64::max) > SMALL => "a small difference",
        way => way,
    };
    let said = format!(
        "{top:?} {:?}: tilts {tilts:?} {least:e} {most:e}, nod {:?} {period:e}, lost {lost_by_tilts:?} {lost:e}",
        start.to_array(),
        motion.nod_period(),
    );
    let [least, most] = [(least, 0), (most, 1)].map(|(off, n)| off / (OF_TILTS + DIGITS * lost_by_tilts[n]));
    ([worse(least, most), period / (OF_NODS + DIGITS * lost)], way, said)
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

#[test]
fn where_small_differences_decide_between_which_tilts_a_top_nods_only_their_digits_are_lost() {
    // Mass and I₁, I₃, gravity; quaternion; angular velocity.
    let cases = [
        // How far its energy is from that of rest upright is ½I₁ a(b − a), but for a thousandth.
        (
            [0.015_625, 0.015_625, 1.969_950_114_515_572_7e33],
            [
                0.967_840_115_516_792_9,
                2.566_849_506_866_641_7e-13,
                -6.671_890_850_975_735e-14,
                0.251_566_116_153_270_57,
            ],
            [0.349_856_721_840_501_54, 0.627_526_484_367_593, 2_708_991_703_578.805_7],
        ),
        // The same, and the spin is the one that it needs to sleep, to 17 digits.
        (
            [3.814_697_265_625e-6, 1.144_409_179_687_5e-7, 137_299.780_576_492_2],
            [
                -0.648_849_542_182_507_8,
                2.534_057_675_281_050_2e-9,
                -1.253_052_626_332_137_3e-9,
                -0.760_916_731_061_651_7,
            ],
            [-6.199_598_273_322_566e-11, -1.562_205_086_870_350_7e-11, 0.753_865_255_100_196_5],
        ),
        // Only the latter.
        (
            [9.536_743_164_062_5e-7, 9.536_743_164_062_5e-11, 4.922_886_567_178_721e-24],
            [
                0.290_080_610_450_597_63,
                6.287_018_489_339_826e-11,
                2.925_494_218_850_721_6e-11,
                0.957_002_214_961_182_1,
            ],
            [6.998_704_404_449_228e-27, 6.261_174_780_015_277e-27, 1.354_222_343_972_339_1e-12],
        ),
        // Without weight, past the vertical at a distance that counts as none.
        (
            [68_719_476_736.0, 27_487_790_694.4, 0.0],
            [
                0.997_661_000_272_303_5,
                6.832_330_706_699_033e-14,
                4.681_250_324_328_944_5e-15,
                0.068_355_896_129_499_05,
            ],
            [-0.015_856_140_816_684_12, 0.0, 0.0],
        ),
    ];
    for ([transverse, axial, gravity], [w, i, j, k], omega) in cases {
        let arm = 2_f64.powi(-30);
        let top = TopParameters { mass: transverse, arm, transverse, axial, gravity };
        let world_from_body = UnitQuaternion::new_unchecked(Quaternion::new(w, i, j, k));
        let start = Turning { world_from_body, omega_body: Vector3::from(omega) };
        let motion = Top::new(top).and_then(|top| top.motion(&start)).expect("a motion");
        let (ratios, _, said) = judged(&top, &start, &motion);
        assert!(ratios.into_iter().all(|ratio| ratio < 1.0), "{ratios:?} of the promise: {said}");
    }
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
