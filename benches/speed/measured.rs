//! The committed measurements: how they are written, read, and put into tables.

use std::fmt::Write as _;

/// One line of `measured.csv`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Measurement {
    /// The name of the problem.
    pub problem: String,
    /// Whose code it is.
    pub contestant: String,
    /// The method.
    pub method: String,
    /// Its tolerance, step or the like.
    pub setting: String,
    /// The error.
    pub error: f64,
    /// Evaluations of the rates in one run, where they are counted.
    pub evaluations: Option<usize>,
    /// The time of one run, s: the median over the rounds.
    pub seconds: f64,
    /// The quartiles of that time, s.
    pub quartiles: [f64; 2],
}

/// The columns of the file.
pub(crate) const COLUMNS: &str =
    "problem,contestant,method,setting,error,evaluations,seconds,lower quartile,upper quartile";

/// The errors for which the tables say how long they take to reach.
pub(crate) const GOALS: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];

/// How the library is called when it is compiled for the very processor it runs on.
pub(crate) const NATIVE: &str = "mechanics native";

impl Measurement {
    /// The line of the file, without its end.
    pub(crate) fn line(&self) -> String {
        let Self {
            problem,
            contestant,
            method,
            setting,
            error,
            evaluations,
            seconds,
            quartiles: [low, high],
        } = self;
        let evaluations = evaluations.map_or_else(String::new, |count| count.to_string());
        format!(
            "{problem},{contestant},{method},{setting},{error:.3e},{evaluations},{seconds:.3e},{low:.3e},{high:.3e}"
        )
    }
}

/// The measurements of a file; lines with `#` describe the machine, the first other line names the columns.
///
/// # Errors
/// What line is wrong.
pub(crate) fn parse(text: &str) -> Result<Vec<Measurement>, String> {
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    if lines.next() != Some(COLUMNS) {
        return Err(format!("the first line must be `{COLUMNS}`"));
    }
    lines.map(|line| parse_line(line).ok_or_else(|| format!("nine columns expected in `{line}`"))).collect()
}

fn parse_line(line: &str) -> Option<Measurement> {
    let [problem, contestant, method, setting, error, evaluations, seconds, low, high] =
        line.split(',').collect::<Vec<_>>()[..]
    else {
        return None;
    };
    Some(Measurement {
        problem: problem.into(),
        contestant: contestant.into(),
        method: method.into(),
        setting: setting.into(),
        error: error.parse().ok()?,
        evaluations: if evaluations.is_empty() { None } else { Some(evaluations.parse().ok()?) },
        seconds: seconds.parse().ok()?,
        quartiles: [low.parse().ok()?, high.parse().ok()?],
    })
}

/// The best that can be had: pairs of error and cost of which no other is better in both, the largest error first.
pub(crate) fn front(pairs: impl IntoIterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut pairs: Vec<(f64, f64)> =
        pairs.into_iter().filter(|(error, cost)| error.is_finite() && cost.is_finite()).collect();
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut best = f64::INFINITY;
    pairs.retain(|&(_, cost)| {
        let better = cost < best;
        best = best.min(cost);
        better
    });
    pairs.reverse();
    pairs
}

/// The cost at which an error is reached, between two settings in proportion on logarithmic scales; `None` if
/// it never is. The front is that of [`front`].
pub(crate) fn cost_to_reach(front: &[(f64, f64)], goal: f64) -> Option<f64> {
    let after = front.iter().position(|&(error, _)| error <= goal)?;
    let (error, cost) = front[after];
    let Some(&(coarse, cheap)) = after.checked_sub(1).and_then(|before| front.get(before)) else {
        return Some(cost); // the cheapest setting is good enough
    };
    let part = (coarse / goal).ln() / (coarse / error.max(f64::MIN_POSITIVE)).ln();
    Some(cheap * (cost / cheap).powf(part))
}

/// Contestants with their methods, in the order in which they first appear.
pub(crate) fn methods<'a>(rows: &'a [Measurement], problem: &str) -> Vec<(&'a str, &'a str)> {
    let mut found = Vec::new();
    for row in rows.iter().filter(|row| row.problem == problem) {
        let name = (row.contestant.as_str(), row.method.as_str());
        if !found.contains(&name) {
            found.push(name);
        }
    }
    found
}

/// The front of error against seconds of one contestant's method.
pub(crate) fn seconds_front(
    rows: &[Measurement],
    problem: &str,
    (contestant, method): (&str, &str),
) -> Vec<(f64, f64)> {
    let mine =
        |row: &&Measurement| row.problem == problem && row.contestant == contestant && row.method == method;
    front(rows.iter().filter(mine).map(|row| (row.error, row.seconds)))
}

/// The first line of the table of a problem, by which it is found on the page.
pub(crate) fn table_head(problem: &str) -> String {
    format!("| `{problem}`, ms to reach | 1e-3 | 1e-6 | 1e-9 | 1e-12 |")
}

/// The table of a problem in Markdown: milliseconds to reach each of [`GOALS`].
pub(crate) fn table(rows: &[Measurement], problem: &str) -> String {
    let mut text = format!("{}\n|---|---|---|---|---|\n", table_head(problem));
    for name in methods(rows, problem) {
        if name == (NATIVE, "RK4") {
            continue;
        }
        let front = seconds_front(rows, problem, name);
        let cells = GOALS.map(|goal| {
            cost_to_reach(&front, goal).map_or_else(|| "–".into(), |seconds| short(1e3 * seconds))
        });
        let _ = writeln!(text, "| {}, {} | {} |", name.0, name.1, cells.join(" | "));
    }
    text
}

/// The errors at which the library is set beside its fastest peer.
const RACES: [f64; 2] = [1e-6, 1e-9];

/// The first line of the table that says how far ahead the library is.
pub(crate) const AHEAD_HEAD: &str = "| times faster than the fastest peer, at error | 1e-6 | 1e-9 | native, 1e-6 | native, 1e-9 | that peer |";

/// How many times as long the fastest peer takes as the library's best method, in Markdown.
pub(crate) fn ahead(rows: &[Measurement], problems: &[&str]) -> String {
    let mut text = format!("{AHEAD_HEAD}\n|---|---|---|---|---|---|\n");
    for problem in problems {
        let fastest = |who: &dyn Fn(&str) -> bool, goal: f64| {
            let all = methods(rows, problem).into_iter().filter(|(contestant, _)| who(contestant));
            all.filter_map(|name| Some((cost_to_reach(&seconds_front(rows, problem, name), goal)?, name.0)))
                .min_by(|a, b| a.0.total_cmp(&b.0))
        };
        let (mut cells, mut peers) = (Vec::new(), Vec::new());
        for ours in ["mechanics", NATIVE] {
            for goal in RACES {
                let us = fastest(&|contestant| contestant == ours, goal);
                let them = fastest(&|contestant| contestant != "mechanics" && contestant != NATIVE, goal);
                cells.push(match (us, them) {
                    (Some((us, _)), Some((them, peer))) => {
                        if !peers.contains(&peer) {
                            peers.push(peer);
                        }
                        short(them / us)
                    }
                    (Some(_), None) => "no peer arrives".to_owned(),
                    (None, _) => "–".to_owned(),
                });
            }
        }
        let peers = if peers.is_empty() { "–".to_owned() } else { peers.join(", ") };
        let _ = writeln!(text, "| `{problem}` | {} | {peers} |", cells.join(" | "));
    }
    text
}

/// How the sentence begins that says between which factors the closed forms are ahead, up to its colon.
pub(crate) const FACTORS: &str = "Where there is a closed form they lie between ";

/// That sentence, from the problems that the library solves in closed form.
pub(crate) fn factors(rows: &[Measurement], problems: &[&str]) -> String {
    let closed = |problem: &&str| {
        rows.iter().any(|row| {
            (&*row.problem, &*row.contestant, &*row.method) == (*problem, "mechanics", "closed form")
        })
    };
    let table = ahead(rows, &problems.iter().copied().filter(closed).collect::<Vec<_>>());
    let cells = table.lines().filter(|line| line.starts_with("| `")).flat_map(|line| line.split('|'));
    let factors: Vec<f64> = cells.filter_map(|cell| cell.trim().parse().ok()).collect();
    let (least, most) =
        (factors.iter().copied().fold(f64::INFINITY, f64::min), factors.iter().copied().fold(0.0, f64::max));
    format!("{FACTORS}{least} and {most}:")
}

/// Two significant digits, without an exponent.
fn short(value: f64) -> String {
    let magnitude = value.abs().max(f64::MIN_POSITIVE).log10().floor() as i32;
    let scale = 10.0_f64.powi(magnitude - 1);
    let rounded = (value / scale).round() * scale;
    // Rounding may have made one digit more: 0.0996 is 0.10.
    let magnitude = (rounded * (1.0 + 1e-9)).log10().floor() as i32;
    format!("{rounded:.*}", usize::try_from(1 - magnitude).unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::{COLUMNS, Measurement, ahead, cost_to_reach, factors, front, parse, short, table};

    #[test]
    fn the_front_leaves_out_what_is_beaten() {
        let pairs = [(1e-3, 1.0), (1e-6, 4.0), (1e-4, 5.0), (1e-9, 3.0), (f64::NAN, 0.1), (1e-12, 9.0)];
        assert_eq!(front(pairs), [(1e-3, 1.0), (1e-9, 3.0), (1e-12, 9.0)]);
        assert_eq!(front([]), []);
    }

    #[test]
    fn the_cost_of_an_error_lies_between_its_neighbours_on_logarithmic_scales() {
        let front = [(1e-2, 1.0), (1e-6, 100.0)];
        assert!((cost_to_reach(&front, 1e-4).unwrap() - 10.0).abs() < 1e-12);
        assert!((cost_to_reach(&front, 1e-5).unwrap() - 10.0 * 10.0_f64.sqrt()).abs() < 1e-12);
        assert_eq!(cost_to_reach(&front, 0.5), Some(1.0));
        assert_eq!(cost_to_reach(&front, 1e-7), None);
        assert_eq!(cost_to_reach(&[(0.0, 2.0)], 1e-12), Some(2.0));
        assert_eq!(cost_to_reach(&[], 1.0), None);
    }

    #[test]
    fn numbers_have_two_digits() {
        let all = [0.004_44, 0.0996, 0.35, 1.26, 9.96, 12.4, 431.0, 1000.0].map(short);
        assert_eq!(all, ["0.0044", "0.10", "0.35", "1.3", "10", "12", "430", "1000"]);
    }

    #[test]
    fn what_is_written_is_read_again_and_put_into_a_table() {
        let row = |setting: &str, error, seconds| Measurement {
            problem: "washer".into(),
            contestant: "somebody".into(),
            method: "RK4".into(),
            setting: setting.into(),
            error,
            evaluations: Some(80),
            seconds,
            quartiles: [0.5 * seconds, 2.0 * seconds],
        };
        let rows = [row("few steps", 1e-2, 1e-3), row("many steps", 1e-8, 1e-1)];
        let text = format!("# machine\n{COLUMNS}\n{}\n{}\n", rows[0].line(), rows[1].line());
        assert_eq!(parse(&text).unwrap(), rows);
        assert!(parse("error\n").is_err() && parse(&format!("{COLUMNS}\na,b\n")).is_err());
        let table = table(&rows, "washer");
        assert!(table.ends_with("|\n| somebody, RK4 | 2.2 | 22 | – | – |\n"), "{table}");
        let ours = Measurement { contestant: "mechanics".into(), ..row("", 1e-7, 1e-3) };
        let closed = Measurement { method: "closed form".into(), ..ours.clone() };
        let both = [rows.to_vec(), vec![closed]].concat();
        assert_eq!(factors(&both, &["washer"]), "Where there is a closed form they lie between 22 and 22:");
        let ahead = ahead(&[rows.to_vec(), vec![ours]].concat(), &["washer", "hoop"]);
        let expected = "|\n| `washer` | 22 | – | – | – | somebody |\n| `hoop` | – | – | – | – | – |\n";
        assert!(ahead.ends_with(expected), "{ahead}");
    }
}
