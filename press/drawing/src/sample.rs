//! Where to sample a curve, and what lies between its samples.

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

/// What lies between samples, the first at place 0, the next at 1, and so on: on a straight line from one to the next, and
/// beyond the ends as at the ends.
///
/// # Panics
/// If there are none.
pub fn interpolated<const N: usize>(samples: &[[f64; N]], place: f64) -> [f64; N] {
    let last = samples.len().checked_sub(1).expect("no samples");
    let place = place.clamp(0.0, last as f64);
    let before = place as usize;
    let (one, other, part) = (samples[before], samples[last.min(before + 1)], place - before as f64);
    std::array::from_fn(|k| one[k] + part * (other[k] - one[k]))
}

#[cfg(test)]
mod tests {
    use super::interpolated;

    #[test]
    fn between_samples_lies_what_a_straight_line_says() {
        let samples = [[0.0, 5.0], [2.0, 5.0], [8.0, -1.0]];
        let expected = [
            (-1.0, [0.0, 5.0]),
            (0.0, [0.0, 5.0]),
            (0.75, [1.5, 5.0]),
            (1.5, [5.0, 2.0]),
            (2.0, [8.0, -1.0]),
            (7.0, [8.0, -1.0]),
        ];
        for (place, values) in expected {
            assert_eq!(interpolated(&samples, place), values, "{place}");
        }
        assert_eq!(interpolated(&samples[..1], 0.4), [0.0, 5.0]);
    }
}
