//! Where to sample a curve.

/// `count` + 1 values from `from` to `to` in equal steps, both ends included.
pub fn linear_steps(from: f64, to: f64, count: u32) -> impl Iterator<Item = f64> {
    (0..=count)
        .map(move |k| if k == count { to } else { from + (to - from) * f64::from(k) / f64::from(count) })
}

/// `count` + 1 values from `from` to `to` in equal ratios, both ends included; both must be positive.
pub fn log_steps(from: f64, to: f64, count: u32) -> impl Iterator<Item = f64> {
    (0..=count)
        .map(move |k| if k == count { to } else { from * (to / from).powf(f64::from(k) / f64::from(count)) })
}
