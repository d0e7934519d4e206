//! A head, as coins carry it.

/// The profile of a head, to the right and up, on a coin of radius one.
const HEAD: [(f64, f64); 19] = [
    (0.12, -0.64),
    (0.12, -0.44),
    (0.24, -0.41),
    (0.33, -0.36),
    (0.34, -0.26),
    (0.31, -0.20),
    (0.35, -0.13),
    (0.32, -0.06),
    (0.45, -0.01),
    (0.33, 0.20),
    (0.32, 0.32),
    (0.24, 0.48),
    (0.04, 0.60),
    (-0.20, 0.55),
    (-0.37, 0.36),
    (-0.41, 0.10),
    (-0.30, -0.14),
    (-0.26, -0.36),
    (-0.36, -0.64),
];

/// The outline of a head on a coin of radius one, upright and in profile: a smooth line through the points of the
/// profile, but straight across the neck.
pub fn portrait() -> Vec<(f64, f64)> {
    let last = HEAD.len() - 1;
    let steps = 6;
    let mut outline = Vec::new();
    for n in 0..last {
        let [before, from, to, after] = [n.saturating_sub(1), n, n + 1, (n + 2).min(last)].map(|n| HEAD[n]);
        for step in 0..=steps {
            let part = f64::from(step) / f64::from(steps);
            let (square, cube) = (part * part, part * part * part);
            let between = |before: f64, from: f64, to: f64, after: f64| {
                from * (2.0 * cube - 3.0 * square + 1.0)
                    + 0.5 * (to - before) * (cube - 2.0 * square + part)
                    + to * (3.0 * square - 2.0 * cube)
                    + 0.5 * (after - from) * (cube - square)
            };
            outline
                .push((between(before.0, from.0, to.0, after.0), between(before.1, from.1, to.1, after.1)));
        }
    }
    outline
}
