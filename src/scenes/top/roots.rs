//! The turning points of a nod, from a start, without a difference of nearly equal numbers.
//!
//! All is in units of a rate, and of I₁ for momenta and energies: `a = I₃ω₃/I₁`, `β = 2mgl/I₁` (`eq:top-abbreviations`).

use crate::euler::Turning;
use crate::two_part::TwoPart;

/// The numbers of a start, exact to 30 digits.
#[derive(Debug, Clone, Copy)]
pub(super) struct Start {
    pub(super) a: TwoPart,
    pub(super) beta: TwoPart,
    pub(super) above: TwoPart,    // 1 + u
    pub(super) below: TwoPart,    // 1 − u
    pub(super) across: TwoPart,   // ω₁² + ω₂²
    pub(super) rise: TwoPart,     // du/dt
    pub(super) momentum: TwoPart, // b − au = φ̇ sin²θ
}

/// The roots `u₁ ≤ u₂ ≤ 1 ≤ u₃` of `eq:top-cubic` by their distances, each to nearly all digits of its own.
#[derive(Debug, Clone, Copy)]
pub(super) struct Roots {
    pub(super) whole: TwoPart,         // H = β(u₃ − u₁)
    pub(super) gap: TwoPart,           // β(u₃ − u₂)
    pub(super) nod: TwoPart,           // u₂ − u₁
    pub(super) under: [TwoPart; 2],    // u₀ − u₁, u₂ − u₀
    pub(super) over: TwoPart,          // β(u₃ − u₀)
    pub(super) above: [TwoPart; 2],    // 1 + u₁, 1 + u₂
    pub(super) below: [TwoPart; 2],    // 1 − u₁, 1 − u₂
    pub(super) above_third: TwoPart,   // β(1 + u₃)
    pub(super) below_third: TwoPart,   // β(u₃ − 1)
    pub(super) across: [TwoPart; 2],   // ω₁² + ω₂² at u₁ and u₂: α − βu
    pub(super) across_third: TwoPart,  // β(u₃ − α/β)
    pub(super) residues: [TwoPart; 3], // b + a, b − a, aα − βb
    pub(super) momentum: [TwoPart; 2], // b − au at u₁ and u₂
}

const ONE: f64 = 1.0;

fn number(value: f64) -> TwoPart {
    TwoPart::from(value)
}

impl Start {
    /// From the attitude and the angular velocity, in units of a rate.
    pub(super) fn new(start: &Turning, a: TwoPart, beta: TwoPart) -> Self {
        let q = start.world_from_body.quaternion();
        let [w1, w2, _]: [f64; 3] = start.omega_body.into();
        let product = TwoPart::product;
        let (up, down) = (product(q.w, q.w) + product(q.k, q.k), product(q.i, q.i) + product(q.j, q.j));
        let length = up + down; // one, but for rounding
        // sin θ e^{iψ} along the body's axes 1 and 2.
        let cos = (product(q.w, q.i) + product(q.k, q.j)) * 2.0 / length;
        let sin = (product(q.k, q.i) - product(q.w, q.j)) * 2.0 / length;
        Self {
            a,
            beta,
            above: up * 2.0 / length,
            below: down * 2.0 / length,
            across: product(w1, w1) + product(w2, w2),
            rise: sin * w2 - cos * w1,
            momentum: cos * w2 + sin * w1,
        }
    }

    /// The cubic `f₀ + f₁x + f₂x² + βx³` in `x = u − u₀`.
    pub(super) fn cubic(&self) -> [TwoPart; 3] {
        let Self { a, beta, above, below, across, rise, momentum } = *self;
        let height = (above - below) * 0.5; // u₀
        let first = a * momentum * 2.0 - height * across * 2.0 - beta * above * below;
        [rise * rise, first, height * beta * 2.0 - across - a * a]
    }

    /// Whether nothing nods.
    pub(super) fn is_steady(&self) -> bool {
        let [f0, f1, _] = self.cubic();
        f0.rounded() == 0.0 && f1.rounded() == 0.0
    }

    pub(super) fn residues(&self) -> [TwoPart; 3] {
        let Self { a, beta, above, below, across, momentum, .. } = *self;
        [momentum + a * above, momentum - a * below, a * across - beta * momentum]
    }

    /// The roots, if something nods.
    pub(super) fn roots(&self) -> Roots {
        let Self { a, beta, above, below, across, momentum, .. } = *self;
        let [f0, f1, f2] = self.cubic();
        let residues = self.residues();
        let [_, difference, _] = residues;
        // The middle of βu₁, βu₂, βu₃ lies below their mean if the third is further from it than the first.
        let third_is_far = value(&[f2, beta * f1, beta * beta * f0], number(f2.rounded() / -3.0)) < 0.0;
        let mut roots = if third_is_far {
            let over = largest_root([f2, beta * f1, beta * beta * f0]);
            let product = -(f0 / over);
            let [down, up] = pair((f1 - beta * product) / over, product); // u₁ − u₀, u₂ − u₀
            Roots {
                whole: over - beta * down,
                gap: over - beta * up,
                nod: up - down,
                under: [-down, up],
                over,
                above: [above + down, above + up],
                below: [below - down, below - up],
                above_third: beta * above + over,
                below_third: over - beta * below,
                across: [across - beta * down, across - beta * up],
                across_third: over - across,
                residues,
                momentum: [momentum - a * down, momentum - a * up],
            }
        } else {
            // The same cubic in y = 1 − u: −βy³ + c₂y² + c₁y − (b − a)²
            let excess = across - beta * below; // α − β
            let c1 = (excess - a * difference) * 2.0;
            let c2 = beta * 2.0 - excess - a * a;
            let square = difference * difference;
            let far = largest_root([-c2, -(beta * c1), beta * beta * square]); // β(1 − u₁)
            let product = -(square / far);
            let [third, second] = pair(-((c1 + beta * product) / far), product); // 1 − u₃, 1 − u₂
            let first = far / beta;
            Roots {
                whole: far - beta * third,
                gap: beta * (second - third),
                nod: first - second,
                under: [first - below, below - second],
                over: beta * (below - third),
                above: [number(2.0 * ONE) - first, number(2.0 * ONE) - second],
                below: [first, second],
                above_third: beta * (number(2.0 * ONE) - third),
                below_third: -(beta * third),
                across: [excess + far, excess + beta * second],
                across_third: -(excess + beta * third),
                residues,
                momentum: [difference + a * first, difference + a * second],
            }
        };
        // What would be a small difference follows from a residue: f(−1) = −(b + a)² and so on (eq:top-residues).
        let [b_plus_a, b_minus_a, third] = residues.map(|residue| residue * residue);
        if 2.0 * roots.above[0].rounded() < roots.above[1].rounded() {
            roots.above[0] = b_plus_a / (roots.above[1] * roots.above_third);
        }
        balance(&mut roots.below, &mut roots.below_third, beta, b_minus_a);
        balance(&mut roots.across, &mut roots.across_third, number(ONE), third);
        roots
    }
}

/// Of the distances `X₁`, `X₂` and `p` with `X₁X₂p = N²` the smaller of the last two from the larger; `scale` times X₂
/// compares with p.
fn balance(near: &mut [TwoPart; 2], far: &mut TwoPart, scale: TwoPart, square: TwoPart) {
    let [first, second] = *near;
    if scale.rounded() * second.rounded() >= far.rounded() {
        if second.rounded() > 0.0 {
            *far = square / (first * second);
        }
    } else {
        near[1] = square / (first * *far);
    }
}

/// The two solutions of `x² − Sx + P = 0` for `P ≤ 0`, the one that is not above zero first.
fn pair(sum: TwoPart, product: TwoPart) -> [TwoPart; 2] {
    let root = (sum * sum - product * 4.0).sqrt();
    if root.rounded() == 0.0 {
        return [number(0.0); 2];
    }
    if sum.rounded() > 0.0 {
        let up = (sum + root) * 0.5;
        [product / up, up]
    } else {
        let down = (sum - root) * 0.5;
        [down, product / down]
    }
}

/// `z³ + Az² + Bz + C`, rounded, and near a root to nearly all digits that it has there.
fn value([a, b, c]: &[TwoPart; 3], z: TwoPart) -> f64 {
    (((z + *a) * z + *b) * z + *c).rounded()
}

/// The largest solution of `z³ + Az² + Bz + C = 0`, whose solutions are real, if it is not near the next.
fn largest_root(coefficients: [TwoPart; 3]) -> TwoPart {
    let [a, b, _] = coefficients.map(TwoPart::rounded);
    let slope = |z: f64| (3.0 * z + 2.0 * a) * z + b;
    // No solution is beyond this one, and Newton's method comes down to the largest without passing it.
    let mut root = number((2.0 * (a * a - 3.0 * b).max(0.0).sqrt() - a) / 3.0);
    let mut last = f64::INFINITY;
    for _ in 0..STEPS {
        let step = value(&coefficients, root) / slope(root.rounded());
        if !step.is_finite() || step == 0.0 {
            break;
        }
        root = root - number(step);
        let size = step.abs();
        if size < ENOUGH * root.rounded().abs() || (size >= last && size < ROUNDING * root.rounded().abs()) {
            break;
        }
        last = size;
    }
    root
}

const STEPS: usize = 60;
/// The next step of Newton's method would be below 1e-33 of the root.
const ENOUGH: f64 = 1e-30;
/// A step that is no shorter than the last is rounding, if it is this short.
const ROUNDING: f64 = 1e-20;
