//! The snippets whose numbers a reader may change: at the numbers of the text they answer what the page
//! prints, at others what is true there.

use live::limit;
use live::snippet::Snippet;
use snippets::SNIPPETS;
use std::collections::BTreeMap;

/// What is printed, what the assertions find, and the words of an error.
fn answers(snippet: &Snippet, live: &[f64]) -> (Vec<String>, String, Option<String>) {
    let watched = limit::watch(format!("{}: the snippet with {live:?}", snippet.place));
    let lines = snippet.run(live);
    drop(watched);
    let of = |mark: char| lines.iter().filter_map(move |line| line.strip_prefix(mark).map(str::to_owned));
    let checks: String =
        lines.iter().filter_map(|line| line.chars().next()).filter(|c| "+-?".contains(*c)).collect();
    assert_eq!((of('=').count(), checks.len()), (snippet.printed.len(), snippet.checks), "{}", snippet.place);
    (of('=').collect(), checks, of('!').next())
}

/// The snippet of a page that has these live numbers.
fn of(page: &str, names: &[&str]) -> &'static Snippet {
    let found = SNIPPETS.iter().find(|snippet| {
        snippet.place.starts_with(page) && snippet.live.iter().map(|live| live.name).eq(names.iter().copied())
    });
    found.unwrap_or_else(|| panic!("{page} has no snippet with {names:?}"))
}

/// What the page would print of a number, among what a snippet prints.
#[track_caller]
fn prints(snippet: &Snippet, live: &[f64], at: usize, expected: f64) {
    let (printed, _, _) = answers(snippet, live);
    let found: f64 = printed[at].parse().expect("a number");
    let decimals = printed[at].split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let last = 10_f64.powi(-i32::try_from(decimals).unwrap());
    assert!(
        (found - expected).abs() <= 0.5001 * last,
        "{} with {live:?}: {found}, not {expected}",
        snippet.place
    );
}

#[test]
fn with_the_numbers_of_the_text_a_snippet_answers_what_the_page_prints() {
    let mut chapters: BTreeMap<&str, usize> = BTreeMap::new();
    for snippet in SNIPPETS {
        let live: Vec<f64> = snippet.live.iter().map(|live| live.value).collect();
        let (printed, checks, error) = answers(snippet, &live);
        assert_eq!((printed, error), (snippet.printed.iter().map(|&text| text.to_owned()).collect(), None));
        assert_eq!(checks, "+".repeat(snippet.checks), "{}", snippet.place);
        *chapters.entry(snippet.place.split('/').nth(1).unwrap()).or_default() += 1;
    }
    assert!(chapters.len() >= 9, "{chapters:?}");
    for (chapter, count) in chapters {
        assert!(count >= 2, "book/{chapter}: {count} snippet with live numbers, of at least two");
    }
}

#[test]
fn no_number_that_can_be_set_makes_a_snippet_panic_or_run_for_ever() {
    let mut random = fastrand::Rng::with_seed(14);
    for snippet in SNIPPETS {
        let mut reds = vec![false; snippet.checks];
        for n in 0..(1 << snippet.live.len()) + 200 {
            let place = |at: usize, random: &mut fastrand::Rng| match n >> snippet.live.len() {
                0 => f64::from(n >> at & 1), // every corner
                _ => random.f64(),
            };
            let live = snippet.live.iter().enumerate().map(|(at, live)| {
                let value = live.least + (live.most - live.least) * place(at, &mut random);
                if live.whole { value.round() } else { value }
            });
            let (printed, checks, error) = answers(snippet, &live.collect::<Vec<_>>());
            assert!(printed.iter().all(|text| error.is_some() || !text.is_empty()), "{}", snippet.place);
            reds.iter_mut().zip(checks.chars()).for_each(|(red, check)| *red |= check == '-');
        }
        // One can see something: a number, or a law that ends.
        assert!(!snippet.printed.is_empty(), "{} prints nothing", snippet.place);
        assert!(reds.contains(&true), "nothing in {} ever fails", snippet.place);
    }
}

#[test]
fn with_other_numbers_the_answers_are_those_of_the_equations() {
    // eq:steady-radius, with b = ma/(m + M).
    let laundromat = of("book/laundromat/index.md", &["load_mass", "damping", "spin"]);
    for [load, damping, spin] in [[5.0, 40.0, 12.0], [0.5, 300.0, 9.0], [20.0, 1.0, 80.0]] {
        let (square, rate) = (3000.0 / (28.0 + load), damping / (28.0 + load));
        let bracket: f64 = square - spin * spin;
        prints(laundromat, &[load, damping, spin], 0, spin / square.sqrt());
        prints(laundromat, &[load, damping, spin], 1, spin * spin / bracket.hypot(rate * spin));
    }
    // eq:mode-frequencies: Ω + ω₁.
    let polar = of("book/laundromat/polar.md", &["damping", "spin"]);
    prints(polar, &[300.0, 20.0], 0, 20.0 + 75_f64.sqrt());
    // Wobbles a turn are L/(I₁ω₃).
    let turning = of("book/turning/index.md", &["ratio", "spin", "careless"]);
    for [ratio, spin, careless] in [[2.0, 20.0, 30.0], [0.5, 40.0, 4.0]] {
        prints(turning, &[ratio, spin, careless], 2, careless.hypot(ratio * spin) / spin);
    }
    // eq:balancing-mass.
    let plate = of("book/wobble-plate/index.md", &["tilt", "distance", "spin"]);
    let needed = 2.0 * (0.1 * 40_f64.to_radians().cos() / 0.05).powi(2) / 8.0;
    prints(plate, &[40.0, 0.05, 200.0], 0, needed);
    // eq:ratio-for-bias of a thin coin.
    let coin = of("book/coin-toss/index.md", &["same", "tosses"]);
    prints(coin, &[0.6, 1e4], 0, 0.5 * (-(std::f64::consts::PI * 0.6).cos()).sqrt());
    prints(coin, &[0.6, 1e4], 2, 0.1 / (0.25_f64 / 1e4).sqrt());
    // eq:struck-rate: 2P/ma.
    let station = of("book/space-station/index.md", &["ship", "place", "spin"]);
    prints(station, &[144.0, 20.0, 0.2], 0, 2.0 * 7.2e6 * 20.0 / (4e5 * 2500.0));
    // eq:spin-decay.
    let drag = of("book/air-drag/index.md", &["ratio", "time"]);
    let moment = 0.7 * 0.175 * 0.137 * 0.137 / 4.0;
    prints(drag, &[0.7, 5.0], 0, 40.0 * (-5e-4_f64 / moment).exp());
    // eq:speed-of-b: both speeds are |cos θ ∓ ⅓ sin θ|.
    let hoop = of("book/pinned-hoop/index.md", &["theta"]);
    let (sin, cos) = 40_f64.to_radians().sin_cos();
    prints(hoop, &[40.0], 1, cos + sin / 3.0);
    // eq:waking-tilt and eq:waking-nod.
    let top = of("book/top/index.md", &["part"]);
    prints(top, &[0.6], 0, 2.0 * 0.6_f64.sqrt().acos().to_degrees());
    prints(top, &[0.6], 1, 2.0 * 0.6_f64.acos().to_degrees());
    // eq:steady-rolling of a hoop.
    let wheel = of("book/rolling-wheel/index.md", &["lean", "b"]);
    let rate = 2.0 * 9.81 * 0.9_f64.tan() / (4.0 * 0.5 + 0.3 * 0.9_f64.sin());
    prints(wheel, &[0.9, 0.5], 0, rate.sqrt());
    // eq:ball-final of a uniform ball.
    let ball = of("book/ball/index.md", &["speed", "roll", "friction"]);
    prints(ball, &[2.0, -3.0, 0.1], 2, (2.0 - 0.4 * 3.0) / 1.4);
    // eq:figure-rate: 2π(1 − cos α) in a round.
    let spinning = of("book/spinning-coin/index.md", &["tilt"]);
    prints(spinning, &[0.8], 0, std::f64::consts::TAU * (1.0 - 0.8_f64.cos()));
}

#[test]
fn an_assertion_that_fails_says_by_which_numbers() {
    let said = |snippet: &Snippet, live: &[f64]| {
        let lines = snippet.run(live);
        let found = lines.iter().find_map(|line| line.strip_prefix('-').map(str::to_owned));
        found.unwrap_or_else(|| panic!("{} with {live:?}: {lines:?}", snippet.place))
    };
    // Of eq:centre-of-mass-radius: b√(ω₀⁴ + Γ²Ω²)/√((ω₀² − Ω²)² + Γ²Ω²), and b = 1/60 m.
    let laundromat = of("book/laundromat/index.md", &["load_mass", "damping", "spin"]);
    let (drag, b): (f64, f64) = (3.0 * 12.0, 1.0 / 60.0);
    let centre = b * 100_f64.hypot(drag) / (100_f64 - 144.0).hypot(drag);
    assert_eq!(said(laundromat, &[2.0, 90.0, 12.0]), format!("{centre:.4} is not below {b:.4}"));
    let motor = of("book/laundromat/motor.md", &["damping", "stall_torque"]);
    assert_eq!(said(motor, &[45.0, 12.0]), "1 is not 3");
    let top = of("book/top/index.md", &["part"]);
    assert!(said(top, &[0.3]).ends_with(" is not above 10"));
}

#[test]
fn what_is_not_reached_is_said() {
    let laundromat = of("book/laundromat/index.md", &["load_mass", "damping", "spin"]);
    let (printed, checks, error) = answers(laundromat, &[0.1, 500.0, 30.0]);
    assert_eq!((printed[3].as_str(), &checks[1..]), ("", "?"));
    assert!(error.is_some_and(|said| said.contains("no peak")));
    assert!(laundromat.run(&[1.0]).last().is_some_and(|line| line.starts_with("!1 live numbers")));
}
