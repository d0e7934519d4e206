//! What many tossers count, against plain sums over the twist in a variable of their own, all on the scale of
//! logarithms.

use crate::search::{Case, keeps_its_promise, worse};
use mechanics::inertia::PrincipalMoments;
use mechanics::scenes::coin_toss::{TossCount, Tossers, TossersParameters};
use std::f64::consts::{PI, TAU};

/// The documented errors.
const OF_A_LIKELIHOOD: f64 = 1e-8;
const OF_A_PROBABILITY: f64 = 1e-8;

fn tossers(threshold: f64, mean: f64, spread: f64) -> Tossers {
    let moments = PrincipalMoments::symmetric(threshold, 1.0).expect("a coin");
    Tossers::new(TossersParameters { moments, mean, spread }).expect("people")
}

/// The logarithm of a sum of numbers that are given by theirs.
fn ln_sum(terms: &[f64]) -> f64 {
    let largest = terms.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    largest + terms.iter().map(|term| (term - largest).exp()).sum::<f64>().ln()
}

/// The logarithm of the part of a Gaussian beyond `z` standard deviations: an integral over the logarithm of what is
/// more than z.
fn ln_tail(z: f64) -> f64 {
    if z < 0.0 {
        return (-ln_tail(-z).exp()).ln_1p();
    }
    let step = 0.01;
    let from = -40.0 - z.ln_1p();
    let terms: Vec<f64> = (0..)
        .map(|n| from + step * f64::from(n))
        .take_while(|w| *w < 3.0)
        .map(|w| w - 0.5 * (z + w.exp()).powi(2))
        .collect();
    ln_sum(&terms) + (step / TAU.sqrt()).ln()
}

/// The logarithm of the mean of p^k (1 − p)^j, in units of its largest, by the trapezium rule in the variable t of
/// |s| = threshold/(1 + e⁻ᵗ): its ends are at infinity, where the integrand falls exponentially.
fn judge(threshold: f64, mean: f64, spread: f64, counted: TossCount) -> f64 {
    let times = |count: f64, ln: f64| if count == 0.0 { 0.0 } else { count * ln };
    let [same, other, all] = [f64::from(counted.same), f64::from(counted.other), counted.tosses()];
    let largest = times(same, (same / all).ln()) + times(other, (other / all).ln());
    // Less than the standard deviation in t of the narrower of the two peaks.
    let step = 0.5 * (4.0 * spread / threshold).min(0.01);
    let mut terms = Vec::new();
    for n in 0..(75.0 / step) as i32 {
        let t = -35.0 + step * f64::from(n);
        let [part, rest] = [1.0 / (1.0 + (-t).exp()), 1.0 / (1.0 + t.exp())];
        // arcsin x = π/2 − 2 arcsin √((1 − x)/2) for x = (s/threshold)².
        let less = 2.0 / PI * (0.5 * rest * (1.0 + part)).sqrt().asin();
        let likelihood = times(same, (-less).ln_1p()) + times(other, less.ln());
        for twist in [threshold * part, -threshold * part] {
            let bell = -0.5 * ((twist - mean) / spread).powi(2);
            terms.push(likelihood + bell + (part * rest).ln());
        }
    }
    let flipping = ln_sum(&terms) + (threshold * step / (spread * TAU.sqrt())).ln();
    let mut parts = vec![flipping];
    if other == 0.0 {
        parts.extend([mean, -mean].map(|mean| ln_tail((threshold - mean) / spread)));
    }
    ln_sum(&parts) - largest
}

#[test]
fn the_likelihood_of_any_count_is_good_to_its_promise() {
    let ways = [
        "all the same",
        "all the other",
        "hardly any other",
        "any share",
        "fewer than half",
        "more than half",
    ];
    keeps_its_promise("people", 100, &ways, |draw| {
        let threshold = if draw.below(2) == 0 { 0.5 } else { draw.decades(0.5, 2.0) };
        let spread = draw.decades(1e-3, 1.0 / 3.0);
        let mean = match draw.below(3) {
            0 => 0.0,
            1 => draw.beside(threshold).min(1.0),
            _ => draw.between(-1.0, 1.0),
        };
        let tosses = draw.decades(1.0, 1e5).round();
        let (way, other) = match draw.below(6) {
            0 => ("all the same", 0.0),
            1 => ("all the other", tosses),
            2 => ("hardly any other", draw.decades(1.0, tosses.max(2.0)).floor().min(tosses)),
            3 => ("any share", (draw.between(0.0, 1.0) * tosses).round()),
            4 => ("fewer than half", (draw.between(0.5, 0.7) * tosses).round()),
            _ => ("more than half", (draw.between(0.3, 0.5) * tosses).round()),
        };
        let counted = TossCount { same: (tosses - other) as u32, other: other as u32 };
        let people = tossers(threshold, mean, spread);
        let (ours, truth) = (people.log_likelihood(&[counted]), judge(threshold, mean, spread, counted));
        let one = judge(threshold, mean, spread, TossCount { same: 1, other: 0 }).exp();
        let ratio = worse(
            (ours - truth).abs() / OF_A_LIKELIHOOD,
            (people.same_face_probability() - one).abs() / OF_A_PROBABILITY,
        );
        let said = format!("{people:?}, {counted:?}: {ours:?}, true {truth:?}; {one:?}");
        Some(Case { ratio, way, said })
    });
}

#[test]
fn likelihoods_meet_the_digits_of_a_quadrature_where_they_once_did_not() {
    // By mpmath with 30 digits, in the angle of the page's integral; a thin coin.
    for (mean, spread, same, other, truth) in [
        // A rounding error as large as the part of the people whose coin never flips counted as such people.
        (0.0, 0.01, 100, 0, -69.288_592_692_325_22),
        (0.0, 0.02, 50, 0, -34.603_740_441_882_33),
        (0.05, 0.01, 80, 0, -54.902_378_402_683_41),
        // The steps were too wide for a peak near the end.
        (0.0, 0.3, 99_999, 1, -20.840_280_766_564_966),
        (0.2, 0.05, 99_000, 1_000, -26.754_334_515_521_788),
        (0.0, 0.3, 99_000, 1_000, -11.256_022_426_105_454),
        (0.0, 0.3, 90_000, 10_000, -7.774_947_712_048_251_5),
        (0.0, 0.3, 9_900, 100, -10.095_264_453_298_603),
        // The peak lay beyond the nine standard deviations that were looked at.
        (0.0, 0.01, 55_000, 45_000, -177.163_010_406_939_38),
        (0.0, 0.01, 6_000, 4_000, -199.474_609_523_862_1),
        // All was below the smallest number.
        (0.0, 0.01, 43_000, 57_000, -984.274_634_783_515_7),
        (0.0, 0.3, 0, 2_000, -1_389.705_501_334_082_3),
        (0.0, 0.01, 0, 100_000, -69_316.693_003_903_79),
    ] {
        let ours = tossers(0.5, mean, spread).log_likelihood(&[TossCount { same, other }]);
        assert!((ours - truth).abs() < OF_A_LIKELIHOOD, "{same} {other}: {ours} {truth}");
    }
}

#[test]
fn no_count_is_impossible_and_none_is_infinitely_unlikely() {
    let extremes = [0, 1, 1000, u32::MAX];
    for mean in [0.0, 0.1, -5.0, 1e50] {
        for spread in [1e-50, 1e-12, 1e-3, 1.0, 1e50] {
            let people = tossers(0.5, mean, spread);
            let p = people.same_face_probability();
            assert!((0.5 - 1e-9..=1.0 + 1e-9).contains(&p), "{people:?}: {p}");
            for (same, other) in extremes.into_iter().flat_map(|same| extremes.map(|other| (same, other))) {
                let ours = people.log_likelihood(&[TossCount { same, other }]);
                assert!(ours.is_finite() && ours < 1e-5, "{people:?}, {same} {other}: {ours}");
            }
        }
    }
    // People who are all alike, however narrow the spread is said to be.
    let alike = tossers(0.5, 0.1, 1e-30).same_face_probability();
    assert!((alike - (0.5 + 0.04_f64.asin() / PI)).abs() < OF_A_PROBABILITY, "{alike}");
    // Nobody's logarithm is zero, and not minus zero.
    assert!(tossers(0.5, 0.0, 0.1).log_likelihood(&[]).is_sign_positive());
}
