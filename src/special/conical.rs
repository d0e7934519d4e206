//! Conical functions: Legendre's equation as a rolling disk has it, with a complex index.
//!
//! The solutions of `(1 − X²) n″ − 2X n′ − a n = 0` for `a` up to 2 on −1 < X < 1 (`eq:legendre`): an even and an odd
//! one, with their slopes. The index is complex for `a` above 1/4, as for every flat disk; below it is real, with the
//! same series. Near the ends they grow like a logarithm of the gap `1 − |X|`, which is therefore an argument of its
//! own. Power series about 0 and about the ends, matched at ½ (*Digital Library of Mathematical Functions*, §14.20 and
//! §15.8).

/// The largest `a` that a rolling disk has, whose moments nearly vanish; then they lose a digit, and more for larger
/// ones.
const LARGEST: f64 = 2.0;
/// Terms after which both series have converged to rounding at |X| = ½.
const TERMS: usize = 34;

/// The even and the odd solution for one `a`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conical {
    even: [f64; TERMS],
    odd: [f64; TERMS],
    regular: [f64; TERMS],
    beside_logarithm: [f64; TERMS],
    even_from_end: [f64; 2],
    odd_from_end: [f64; 2],
}

/// Values and slopes of the two solutions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConicalValues {
    /// The even solution, 1 at X = 0.
    pub even: f64,
    /// Its slope.
    pub even_slope: f64,
    /// The odd solution, of slope 1 at X = 0.
    pub odd: f64,
    /// Its slope.
    pub odd_slope: f64,
}

impl Conical {
    /// The solutions for this `a`, more than zero and at most 2.
    ///
    /// # Panics
    /// If `a` is not in that range: the series from the ends nearly cancel for larger ones.
    ///
    /// ```
    /// use mechanics::conical::Conical;
    /// // (1 − X²)(e o′ − e′ o) = 1 everywhere: Wronski's determinant.
    /// let disc = Conical::new(4.0 / 3.0);
    /// for x in [-0.99_f64, -0.3, 0.5, 0.9999] {
    ///     let gap = 1.0 - x.abs();
    ///     let v = disc.at(x, gap);
    ///     let determinant = v.even * v.odd_slope - v.even_slope * v.odd;
    ///     assert!((gap * (2.0 - gap) * determinant - 1.0).abs() < 1e-13);
    /// }
    /// ```
    #[must_use]
    pub fn new(a: f64) -> Self {
        assert!(
            a > 0.0 && a <= LARGEST,
            "a of the conical functions is {a}; it must be more than 0 and at most 2"
        );
        let series = |next: &dyn Fn(f64) -> f64| {
            let mut terms = [1.0; TERMS];
            for j in 1..TERMS {
                terms[j] = terms[j - 1] * next((j - 1) as f64);
            }
            terms
        };
        let even = series(&|j| (2.0 * j * (2.0 * j + 1.0) + a) / ((2.0 * j + 1.0) * (2.0 * j + 2.0)));
        let odd = series(&|j| ((2.0 * j + 1.0) * (2.0 * j + 2.0) + a) / ((2.0 * j + 2.0) * (2.0 * j + 3.0)));
        let regular = series(&|j| (j * (j + 1.0) + a) / ((j + 1.0) * (j + 1.0)));
        let mut beside_logarithm = [0.0; TERMS];
        for j in 0..TERMS - 1 {
            let m = j as f64;
            beside_logarithm[j + 1] = (beside_logarithm[j] * (m * (m + 1.0) + a)
                + (2.0 * m + 1.0) * regular[j]
                - 2.0 * (m + 1.0) * regular[j + 1])
                / ((m + 1.0) * (m + 1.0));
        }
        let mut conical =
            Self { even, odd, regular, beside_logarithm, even_from_end: [0.0; 2], odd_from_end: [0.0; 2] };
        // Match values and slopes at ½, where both kinds of series hold.
        let centre = conical.about_centre(0.5);
        let [p, p_slope, q, q_slope] = conical.near_end(0.5);
        let determinant = p * q_slope - p_slope * q;
        let solve = |value: f64, slope: f64| {
            [(value * q_slope - slope * q) / determinant, (p * slope - p_slope * value) / determinant]
        };
        conical.even_from_end = solve(centre.even, centre.even_slope);
        conical.odd_from_end = solve(centre.odd, centre.odd_slope);
        conical
    }

    /// Both solutions at `x` between −1 and 1, where `gap` is `1 − |x|`, more exact than `x` itself can give it near
    /// the ends. Each to 4 units in its last place about the centre, |X| ≤ ½, and to 30 towards the ends. NaN or
    /// infinite outside.
    #[must_use]
    pub fn at(&self, x: f64, gap: f64) -> ConicalValues {
        if x.abs() <= 0.5 {
            return self.about_centre(x);
        }
        let [p, p_slope, q, q_slope] = self.near_end(gap);
        let combine = |[a, b]: [f64; 2]| [a * p + b * q, a * p_slope + b * q_slope];
        let ([even, even_slope], [odd, odd_slope]) =
            (combine(self.even_from_end), combine(self.odd_from_end));
        let sign = x.signum();
        ConicalValues { even, even_slope: sign * even_slope, odd: sign * odd, odd_slope }
    }

    fn about_centre(&self, x: f64) -> ConicalValues {
        let square = x * x;
        let (mut even, mut even_slope, mut odd, mut odd_slope) = (0.0, 0.0, 0.0, 0.0);
        for j in (0..TERMS).rev() {
            let order = (2 * j) as f64;
            even = even * square + self.even[j];
            odd = odd * square + self.odd[j];
            odd_slope = odd_slope * square + (order + 1.0) * self.odd[j];
            if j > 0 {
                even_slope = even_slope * square + order * self.even[j];
            }
        }
        ConicalValues { even, even_slope: even_slope * x, odd: odd * x, odd_slope }
    }

    /// Regular and logarithmic solution at `1 − |X| = gap`, with their slopes in X for positive X.
    fn near_end(&self, gap: f64) -> [f64; 4] {
        let xi = 0.5 * gap;
        let (mut p, mut p_rate, mut g, mut g_rate) = (0.0, 0.0, 0.0, 0.0);
        for j in (0..TERMS).rev() {
            p = p * xi + self.regular[j];
            g = g * xi + self.beside_logarithm[j];
            if j > 0 {
                p_rate = p_rate * xi + j as f64 * self.regular[j];
                g_rate = g_rate * xi + j as f64 * self.beside_logarithm[j];
            }
        }
        let logarithm = xi.ln();
        let (q, q_rate) = (p * logarithm + g, p_rate * logarithm + p / xi + g_rate);
        [p, -0.5 * p_rate, q, -0.5 * q_rate]
    }
}
