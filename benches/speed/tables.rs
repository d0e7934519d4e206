//! The page's tables of the long run and of the limits, made from their data.

/// The cells of the lines of data that follow the line of columns.
fn rows(csv: &str) -> impl Iterator<Item = Vec<&str>> {
    csv.lines().filter(|line| !line.starts_with('#')).skip(1).map(|line| line.split(',').collect())
}

/// What is left after a million periods.
pub(crate) fn long_run(csv: &str) -> String {
    let mut text = String::from(
        "| after a million periods | attitude, rad | length − 1 | energy, relative | evaluations or turns |\n|---|---|---|---|---|\n",
    );
    for row in rows(csv) {
        let [method, setting, "1000000", work, length, energy, attitude] = row[..] else { continue };
        let name = if setting.is_empty() { method.to_owned() } else { format!("{method}, {setting}") };
        let lost = attitude.parse().map_or(true, |angle: f64| angle > 1.0);
        let attitude = match method {
            "closed form" => "the judge",
            _ if lost => "lost",
            _ => attitude,
        };
        let work = if work == "0" {
            "–".to_owned()
        } else {
            work.parse().map_or_else(|_| "?".into(), |count: f64| format!("{count:.1e}"))
        };
        // A minus sign, which does not let a line end behind it.
        let line = format!("| {name} | {attitude} | {length} | {energy} | {work} |\n").replace('-', "−");
        text.push_str(&line);
    }
    text
}

/// What a sample costs, and what it cannot do without.
pub(crate) fn limits(csv: &str) -> String {
    let mut text = String::from("| problem | what it computes | nanoseconds |\n|---|---|---|\n");
    for row in rows(csv) {
        let [what, kind, cost] = row[..] else { continue };
        let cost: f64 = cost.parse().unwrap_or(f64::NAN);
        let digits = if cost < 10.0 { 1 } else { 0 };
        text.push_str(&format!("| `{what}` | {kind} | {cost:.digits$} |\n"));
    }
    text
}
