//! A search for the case in which a promise is kept worst.

use std::collections::BTreeMap;

/// How many of the worst random cases of each way are walked on from, at most, and how many cases there are for each.
const WALKS: usize = 12;
const CASES_PER_WALK: usize = 20;
/// How far a walk steps at first, in the unit cube, and where it ends.
const FIRST_STEP: f64 = 0.2;
const LAST_STEP: f64 = 1e-7;

/// Numbers drawn one after the other, each from one coordinate of a point of the unit cube: a small step of
/// the point is a small step of the parameters.
pub(crate) struct Draw<'a> {
    point: &'a mut Vec<f64>,
    next: usize,
    random: &'a mut fastrand::Rng,
}

impl Draw<'_> {
    fn coordinate(&mut self) -> f64 {
        if self.next == self.point.len() {
            self.point.push(self.random.f64());
        }
        self.next += 1;
        self.point[self.next - 1]
    }

    /// Anything from `low` to `high`.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.coordinate()
    }

    /// Anything from `low` to `high`, every decade as likely as any other.
    pub(crate) fn decades(&mut self, low: f64, high: f64) -> f64 {
        let exponent = self.between(low.ln(), high.ln());
        exponent.exp().clamp(low, high)
    }

    /// The same with either sign, and sometimes zero.
    pub(crate) fn signed(&mut self, low: f64, high: f64) -> f64 {
        let size = self.decades(low, high);
        match self.below(9) {
            0 => 0.0,
            1..=4 => -size,
            _ => size,
        }
    }

    /// A unit of measurement: everyday ones, three decades to either side of one, and in a long search so many.
    pub(crate) fn unit(&mut self, decades: i32) -> f64 {
        let far = 10_f64.powi(if is_long() { decades } else { 3 });
        self.decades(1.0 / far, far)
    }

    /// The same as a power of two, with which a motion in another unit is the same to the last bit.
    pub(crate) fn binary_unit(&mut self, power: i32) -> f64 {
        let far = if is_long() { power } else { 10 };
        2_f64.powi(self.below(2 * far as usize + 1) as i32 - far)
    }

    /// A whole number below `count`.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        ((self.coordinate() * count as f64) as usize).min(count - 1)
    }

    /// One of these.
    pub(crate) fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    /// Near `value` on either side, by a part of it between one and a unit in the last place; sometimes the
    /// value itself.
    pub(crate) fn beside(&mut self, value: f64) -> f64 {
        let part = self.decades(f64::EPSILON, 1.0);
        match self.below(7) {
            0 => value,
            1..=3 => value * (1.0 - part),
            _ => value * (1.0 + part),
        }
    }
}

/// The larger of two errors; infinite if one of them is not a number, which `max` would pass over.
pub(crate) fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::INFINITY } else { a.max(b) }
}

/// What was found of one case.
pub(crate) struct Case {
    /// The error over what is promised; infinite for an answer that is not a number.
    pub(crate) ratio: f64,
    /// Which of the ways the case goes; each way that a test names has to be taken.
    pub(crate) way: &'static str,
    /// The parameters and what came out.
    pub(crate) said: String,
}

impl Case {
    /// A case that was refused, which no documentation says.
    pub(crate) fn refused(way: &'static str, said: String) -> Option<Self> {
        Some(Self { ratio: f64::INFINITY, way, said })
    }
}

/// How many times as long as usual to search, from the environment's `WORST_CASES`: 1 at every change, more at night.
fn longer() -> f64 {
    std::env::var("WORST_CASES").map_or(1.0, |factor| factor.parse().expect("a number"))
}

/// Whether this is a long search, which also draws what no scene can show.
pub(crate) fn is_long() -> bool {
    longer() > 1.0
}

/// Judges `count` random cases, times the environment's `WORST_CASES`, and walks on from the worst: the promise is kept
/// in the worst of all, and every one of these ways was taken, and no other. A draw that makes no case is `None`.
pub(crate) fn keeps_its_promise(
    name: &str,
    count: usize,
    named: &[&str],
    judge: impl Fn(&mut Draw<'_>) -> Option<Case>,
) {
    let longer = longer();
    let count = (count as f64 * longer).ceil() as usize;
    let mut random = fastrand::Rng::with_seed(
        name.bytes().fold(longer.to_bits(), |hash, byte| hash.wrapping_mul(31).wrapping_add(u64::from(byte))),
    );
    let mut ways = BTreeMap::new();
    let mut judged = |point: &mut Vec<f64>, random: &mut fastrand::Rng| {
        let case = judge(&mut Draw { point, next: 0, random })?;
        *ways.entry(case.way).or_insert(0) += 1;
        let ratio = if case.ratio.is_nan() { f64::INFINITY } else { case.ratio };
        Some(Case { ratio, ..case })
    };

    // The worst few of each way, so that one bad way does not hide another.
    let walks = (count / CASES_PER_WALK).clamp(1, WALKS);
    let mut worst: BTreeMap<&str, Vec<(Vec<f64>, Case)>> = BTreeMap::new();
    for _ in 0..count {
        let mut point = Vec::new();
        if let Some(case) = judged(&mut point, &mut random) {
            let found = worst.entry(case.way).or_default();
            let place = found.partition_point(|(_, other)| other.ratio >= case.ratio);
            found.insert(place, (point, case));
            found.truncate(walks);
        }
    }
    let tries = (count / walks / worst.len().max(1)).max(20);
    let mut found: Vec<(Vec<f64>, Case)> = worst.into_values().flatten().collect();
    for (point, case) in &mut found {
        let mut step = FIRST_STEP;
        for _ in 0..tries {
            let mut near = point.clone();
            let moved = random.usize(..near.len());
            for (n, coordinate) in near.iter_mut().enumerate() {
                if n == moved || random.f64() < 0.3 {
                    *coordinate = (*coordinate + step * (2.0 * random.f64() - 1.0)).clamp(0.0, 1.0);
                }
            }
            match judged(&mut near, &mut random) {
                Some(worse) if worse.ratio > case.ratio => {
                    (*point, *case) = (near, worse);
                    step = (2.0 * step).min(FIRST_STEP);
                }
                _ => step = (0.8 * step).max(LAST_STEP),
            }
        }
    }
    found.sort_by(|(_, a), (_, b)| b.ratio.total_cmp(&a.ratio));
    let mut shown: Vec<&str> = Vec::new();
    for (_, case) in &found {
        if !shown.contains(&case.way) {
            println!("{name}, {}: {:.3} of the promise at {}", case.way, case.ratio, case.said);
            shown.push(case.way);
        }
    }
    println!("{name}: {ways:?}");
    let taken: Vec<&str> = ways.keys().copied().collect();
    let mut named = named.to_vec();
    named.sort_unstable();
    assert_eq!(taken, named, "the ways that were taken");
    assert!(ways.values().all(|count| *count >= 20), "a way that was hardly taken: {ways:?}");
    let (_, worst) = &found[0];
    assert!(
        worst.ratio < 1.0,
        "{:.3} of the promise, with WORST_CASES={longer}: {}",
        worst.ratio,
        worst.said
    );
}
