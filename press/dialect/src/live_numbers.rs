//! Numbers that a reader may change in the page: `let spin = 30.0; // live: 0..60 rad/s`.
//!
//! A snippet with such a mark is printed with fields for its numbers, and the module of the pages holds the same text
//! as a function of them, which answers with what the snippet prints and with what its assertions find.

use crate::{expected_output, markdown};
use std::collections::BTreeSet;

/// What opens the mark of a live number.
const MARK: &str = "// live:";
/// How many digits behind its point a number may have that a reader changes: those that the page's script keeps.
const MOST_DECIMALS: usize = 12;
/// The assertions that the page knows how to show.
const ASSERTIONS: [&str; 6] =
    ["assert", "assert_eq", "assert_ne", "assert_relative_eq", "assert_abs_diff_eq", "assert_ulps_eq"];
const FORM: &str = "a live number is written `let spin = 30.0; // live: 0..60 rad/s`, with `step 0.5` before the unit \
                    if it has to be";

/// A number that a reader may change.
#[derive(Debug, Clone, PartialEq)]
pub struct Live<'a> {
    /// What the `let` binds.
    pub name: &'a str,
    /// The line up to the number, the number, and the line behind it up to the mark.
    pub before: &'a str,
    /// See [`before`](Self::before).
    pub literal: &'a str,
    /// See [`before`](Self::before).
    pub after: &'a str,
    /// How far it goes, and how far a step goes.
    pub least: f64,
    /// See [`least`](Self::least).
    pub most: f64,
    /// See [`least`](Self::least).
    pub step: f64,
    /// Its unit in words, or none.
    pub unit: &'a str,
    /// Whether it counts: `5` and not `5.0`.
    pub whole: bool,
}

/// A statement that prints its value.
#[derive(Debug, Clone, PartialEq)]
pub struct Value<'a> {
    /// The expression that has the value.
    pub code: &'a str,
    /// The numbers, as the snippet prints them.
    pub numbers: &'a str,
    /// The unit of the last of them, or none.
    pub unit: &'a str,
}

/// What of a snippet answers.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Answers<'a> {
    /// The numbers that a reader may change.
    pub live: Vec<Live<'a>>,
    /// What it prints.
    pub values: Vec<Value<'a>>,
    /// What each assertion says, in words.
    pub checks: Vec<String>,
    /// Comments that may be false when a reader has changed a number.
    pub remarks: Vec<Remark<'a>>,
}

/// A comment that tells of the numbers of the text.
#[derive(Debug, Clone, PartialEq)]
pub struct Remark<'a> {
    /// Its words, as they stand in the code.
    pub words: &'a str,
    /// What makes it doubtful.
    pub of: Of<'a>,
}

/// What makes a comment doubtful.
#[derive(Debug, Clone, PartialEq)]
pub enum Of<'a> {
    /// A change of one of these live numbers.
    Numbers(Vec<&'a str>),
    /// That the assertion with this place among those of the snippet fails.
    Check(usize),
}

/// Whether a line carries the mark of a live number, or what looks like it.
pub fn is_marked(line: &str) -> bool {
    live(line).is_some()
}

/// The live number of a line, if it has the mark; `Err` says what is wrong with it, or with what looks like it.
pub fn live(line: &str) -> Option<Result<Live<'_>, String>> {
    match line.split_once(MARK) {
        Some((code, range)) => Some(read(code.trim_end(), range.trim())),
        None => is_near_miss(line).then(|| Err(FORM.to_owned())),
    }
}

/// Whether a comment gives a range to the word "live": `// Live: 0..2`, `// m; live: 0..2`.
fn is_near_miss(line: &str) -> bool {
    let comment = expected_output::comment(line).to_ascii_lowercase();
    comment.match_indices("live").any(|(at, word)| {
        let behind = comment[at + word.len()..].trim_start();
        !comment[..at].ends_with(char::is_alphanumeric)
            && (behind.starts_with(':')
                || expected_output::number(behind).is_some_and(|end| behind[end..].starts_with("..")))
    })
}

fn read<'a>(code: &'a str, range: &'a str) -> Result<Live<'a>, String> {
    let (bound, value) = code.split_once(" = ").ok_or(FORM)?;
    let name = bound.trim_start().strip_prefix("let ").ok_or(FORM)?;
    let name = name.split(':').next().unwrap_or_default();
    let length = expected_output::number(value).ok_or(FORM)?;
    let is_name = !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || c == '_');
    if !is_name || !code.ends_with(';') {
        return Err(FORM.to_owned());
    }
    let (literal, after) = value.split_at(length);
    if !(after.starts_with(';') || after.starts_with("_f64.") || after.starts_with("_f64;")) {
        return Err(FORM.to_owned());
    }
    let (least, rest) = range.split_once("..").ok_or(FORM)?;
    let end = expected_output::number(rest).ok_or(FORM)?;
    let (most, rest) = rest.split_at(end);
    let of = |text: &str| text.parse::<f64>().map_err(|_| FORM.to_owned());
    let (literal_value, least, most) = (of(literal)?, of(least)?, of(most)?);
    let (step, unit) = match rest.strip_prefix(" step ") {
        Some(rest) => {
            let (step, unit) = rest.split_at(expected_output::number(rest).ok_or(FORM)?);
            (Some(of(step)?), unit)
        }
        None => (None, rest),
    };
    if !(unit.is_empty() || unit.starts_with(' ')) {
        return Err(FORM.to_owned());
    }
    let whole = !literal.contains(['.', 'e']) && !after.starts_with("_f64");
    let step = step.unwrap_or_else(|| nice((most - least) / 200.0, whole));
    let decimals = |number: &str| number.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    if !(least.is_finite() && most.is_finite()) {
        return Err(format!("the range of `{name}` ends at a number that is too large for a computer"));
    } else if least >= most {
        return Err(format!("the range of `{name}` is empty: it goes from below to above"));
    } else if !(least..=most).contains(&literal_value) {
        return Err(format!("`{name}` is {literal}, outside of its range, {least} to {most}"));
    } else if !(step > 0.0 && step <= most - least) {
        return Err(format!("the step of `{name}` does not lie between zero and its range"));
    } else if decimals(&step.to_string()).max(decimals(literal)) > MOST_DECIMALS {
        return Err(format!(
            "`{name}` or its step has more than {MOST_DECIMALS} digits behind the point: choose another unit"
        ));
    } else if whole && [least, most, step].iter().any(|value| value.fract() != 0.0) {
        return Err(format!(
            "`{name}` counts, and its range does not: write its value with a point, or whole numbers"
        ));
    }
    let before = &code[..code.len() - value.len()];
    Ok(Live { name, before, literal, after, least, most, step, unit: unit.trim(), whole })
}

/// The smallest of 1, 2, 5, 10, 20, … that is not below a value.
fn nice(value: f64, whole: bool) -> f64 {
    let below = 10_f64.powi(value.log10().floor() as i32);
    let found =
        [1.0, 2.0, 5.0, 10.0].map(|m| m * below).into_iter().find(|step| *step >= value * (1.0 - 1e-9));
    let found = found.unwrap_or(value);
    if whole { found.ceil() } else { found }
}

/// What answers in the code of a snippet; each fault with the number of its line.
pub fn answers<'a>(lines: &[&'a str]) -> (Answers<'a>, Vec<(usize, String)>) {
    let (mut found, mut faults) = (Answers::default(), Vec::new());
    for (n, line) in lines.iter().enumerate() {
        match live(line) {
            Some(Err(fault)) => faults.push((n, fault)),
            Some(Ok(live)) if found.live.iter().any(|known| known.name == live.name) => {
                faults.push((n, format!("`{}` is a live number of this snippet already", live.name)));
            }
            Some(Ok(live)) => found.live.push(live),
            None => {}
        }
        if let Some(Ok(printed)) = expected_output::read(lines, n) {
            found.values.push(Value {
                code: printed.value,
                numbers: printed.numbers,
                unit: unit(line, printed.numbers),
            });
        }
        for _ in assertions(line) {
            let own = comment_of(lines, n);
            let of = Of::Check(found.checks.len());
            found.remarks.extend(own.iter().map(|words| Remark { words, of: of.clone() }));
            found.checks.push(clause(&own.join(" ")));
        }
    }
    if found.live.is_empty() {
        return (found, faults);
    }
    found.remarks.extend(remarks(lines));
    if found.values.is_empty() && found.checks.is_empty() {
        faults
            .push((0, "nothing answers to the live numbers: print a value, or assert something".to_owned()));
    }
    let asserting = (0..lines.len()).filter(|n| assertions(lines[*n]).next().is_some());
    for (n, words) in asserting.zip(&found.checks) {
        if words.is_empty() {
            faults.push((
                n,
                "beside live numbers an assertion says in words what holds: a comment behind it, or above it"
                    .to_owned(),
            ));
        }
    }
    (found, faults)
}

/// The unit behind the numbers that a line prints: what stands before the first comma.
fn unit<'a>(line: &'a str, numbers: &str) -> &'a str {
    let behind = line.split_once('→').map_or("", |(_, comment)| &comment[1 + numbers.len()..]);
    behind.split([',', ';']).next().unwrap_or_default().trim()
}

/// Where the assertions of a line begin and how long their names are.
fn assertions(line: &str) -> impl Iterator<Item = (usize, usize)> {
    let code = code(line);
    code.match_indices("!(").filter_map(move |(end, _)| {
        let start = code[..end].rfind(|c: char| !c.is_alphanumeric() && c != '_').map_or(0, |at| at + 1);
        ASSERTIONS.contains(&&code[start..end]).then_some((start, end - start))
    })
}

/// What the assertion that begins in a line says: the comment behind it, or else the one above it, line by line.
fn comment_of<'a>(lines: &[&'a str], at: usize) -> Vec<&'a str> {
    let end = (at..lines.len()).find(|n| code(lines[*n]).trim_end().ends_with(");"));
    if let Some((_, words)) = end.and_then(|end| lines[end].split_once("//")) {
        return vec![words.trim()];
    }
    let above = lines[..at].iter().rev().map(|line| line.trim_start());
    let mut above: Vec<&str> = above.map_while(|line| line.strip_prefix("//")).map(str::trim).collect();
    above.reverse();
    above
}

/// What of a line is no comment.
fn code(line: &str) -> &str {
    line.split("//").next().unwrap_or_default()
}

/// The names in some code.
fn names(code: &str) -> impl Iterator<Item = &str> {
    let words = code.split(|c: char| !c.is_alphanumeric() && c != '_');
    words.filter(|word| word.starts_with(|c: char| c.is_alphabetic() || c == '_'))
}

/// The comments that tell of numbers, at statements that come out otherwise when a live number is changed, or above
/// them; not those of assertions, which are asked.
fn remarks<'a>(lines: &[&'a str]) -> Vec<Remark<'a>> {
    let (mut found, mut known) = (Vec::new(), Vec::<(&str, BTreeSet<&str>)>::new());
    // Of the statement that goes on: what it binds, on what it depends, its comments, and how many braces are open.
    let (mut bound, mut of, mut comments, mut depth) = (Vec::new(), BTreeSet::new(), Vec::new(), 0_i32);
    let asserting = (0..lines.len()).filter(|n| assertions(lines[*n]).next().is_some());
    let asked: Vec<&str> = asserting.flat_map(|n| comment_of(lines, n)).collect();
    for (n, line) in lines.iter().enumerate() {
        let code = code(line).trim_end();
        let words = match expected_output::read(lines, n) {
            Some(Ok(printed)) => line.split_once(printed.numbers).map_or("", |(_, behind)| behind),
            _ => &line[code.len()..],
        };
        let words = words.trim_start().trim_start_matches('/').trim();
        if let Some(Ok(live)) = live(line) {
            of.insert(live.name);
        } else if tells_of_numbers(words) && !asked.contains(&words) {
            comments.push(words);
        }
        let sides =
            code.split_once(" = ").filter(|_| code.trim_start_matches(['#', ' ']).starts_with("let "));
        bound.extend(sides.into_iter().flat_map(|(left, _)| names(left)));
        for name in names(sides.map_or(code, |(_, right)| right)) {
            of.extend(
                known.iter().rfind(|(own, _)| *own == name).iter().flat_map(|(_, of)| of.iter().copied()),
            );
        }
        depth += code.matches('{').count() as i32 - code.matches('}').count() as i32;
        if depth <= 0 && code.ends_with([';', '}']) {
            known.extend(bound.drain(..).map(|name| (name, of.clone())));
            let of: Vec<&str> = std::mem::take(&mut of).into_iter().collect();
            let comments = comments.drain(..).filter(|_| !of.is_empty());
            found.extend(comments.map(|words| Remark { words, of: Of::Numbers(of.clone()) }));
        }
    }
    found
}

/// Whether a comment has a number in it, in digits or as a word, but for that of an equation: `(3.12)`.
fn tells_of_numbers(comment: &str) -> bool {
    const WORDS: [&str; 12] =
        ["half", "twice", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "tenth"];
    comment.split([' ', ',', ';', ':']).any(|word| {
        let is_equation = word.starts_with('(') && word.contains('.') && word.ends_with(')');
        !is_equation && (word.contains(|c: char| c.is_ascii_digit()) || WORDS.contains(&word))
    })
}

/// A sentence as it stands behind a colon: no capital, but of a single letter or a name in capitals, and no full stop.
fn clause(sentence: &str) -> String {
    let sentence = sentence.trim_end_matches('.');
    let mut letters = sentence.chars();
    match (letters.next(), letters.clone().next()) {
        (Some(first), Some(second)) if second.is_lowercase() => first.to_lowercase().chain(letters).collect(),
        _ => sentence.to_owned(),
    }
}

/// The snippets of a page that have live numbers: the line of each fence, counted from one, and the code.
pub fn snippets(page: &str) -> Vec<(usize, Vec<&str>)> {
    let all = markdown::snippets(page).into_iter().map(|snippet| (snippet.line, snippet.code));
    all.filter(|(_, code)| code.iter().any(|line| is_marked(line))).collect()
}

/// A snippet as the body of a function of its `live` numbers, which tells `record` what it prints and finds.
pub fn body(lines: &[&str]) -> String {
    let (mut body, mut live_count, mut values, mut checks) = (String::new(), 0, 0, 0);
    for (n, line) in lines.iter().enumerate() {
        let line = match line.trim() {
            "#" => "",
            _ => line.strip_prefix("# ").unwrap_or(line),
        };
        let mut code = line.to_owned();
        if let Some(Ok(live)) = live(line) {
            let number = match live.whole {
                true => format!("record::whole({}, live[{live_count}])", live.literal),
                false => format!("live[{live_count}]"),
            };
            let after = live.after.trim_start_matches("_f64");
            code = format!("{}{number}{after}", live.before);
            live_count += 1;
        } else if let Some(Ok(printed)) = expected_output::read(lines, n) {
            let kept = if printed.bare { "" } else { printed.code };
            code = format!("{kept} record::printed({values}, &({}), {:?});", printed.value, printed.numbers);
            values += 1;
        }
        let starts: Vec<usize> =
            assertions(&code).map(|(start, length)| start + length + "!(".len()).collect();
        for (back, start) in starts.iter().enumerate().rev() {
            code.insert_str(*start, &format!("{}; ", checks + back));
        }
        checks += starts.len();
        body.push_str(&code);
        body.push('\n');
    }
    if !lines.iter().any(|line| line.trim_start_matches("# ").starts_with("Ok::<")) {
        body.push_str("Ok::<(), std::convert::Infallible>(())\n");
    }
    body
}

/// All that the module holds of the snippets of some pages: nothing else on them makes it old.
pub fn matter<'a>(pages: impl IntoIterator<Item = &'a str>) -> String {
    let snippets = pages.into_iter().flat_map(snippets);
    snippets.map(|(_, code)| code.join("\n")).collect::<Vec<_>>().join("\n\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    const CODE: [&str; 9] = [
        "# use x::f;",
        "let spin = 30.0; // live: 0..60 rad/s",
        "let tilt = 25_f64.to_radians(); // live: -5..90 step 0.5 degrees",
        "let count = 4; // live: 1..9",
        "f(spin, tilt); // → 4.317 rad/s, twice",
        "assert!(f(spin, tilt) > 4.0); // it is fast",
        "// Equation eq:x holds,",
        "// nearly.",
        "for n in 0..count { assert_eq!(n, n); assert_relative_eq!(1.0, g(n)); }",
    ];

    #[test]
    fn a_snippet_says_what_answers() {
        let (found, faults) = answers(&CODE);
        assert_eq!(faults, []);
        let live: Vec<_> = found
            .live
            .iter()
            .map(|n| (n.name, n.literal, n.least, n.most, n.step, n.unit, n.whole))
            .collect();
        assert_eq!(
            live,
            [
                ("spin", "30.0", 0.0, 60.0, 0.5, "rad/s", false),
                ("tilt", "25", -5.0, 90.0, 0.5, "degrees", false),
                ("count", "4", 1.0, 9.0, 1.0, "", true),
            ]
        );
        assert_eq!(found.values, [Value { code: "f(spin, tilt)", numbers: "4.317", unit: "rad/s" }]);
        assert_eq!(
            found.checks,
            ["it is fast", "equation eq:x holds, nearly", "equation eq:x holds, nearly"]
        );
    }

    #[test]
    fn comments_that_may_be_false_of_other_numbers_are_known() {
        let code = [
            "# use x::f;",
            "let drag = 3.0; // 11 s, whatever is changed",
            "let spin = 30.0; // live: 0..60 rad/s",
            "let count = 3; // live: 1..5",
            "// With three of them,",
            "let law = |x: f64| {",
            "    let y = 2.0 * x; // twice as much",
            "    y + spin",
            "};",
            "let both = law(1.0); // → 32.0 rad/s, of 30",
            "count + 1; // → 4 in all",
            "drag; // → 3.0, and not 4",
            "let spin = drag; // 3 again",
            "spin + 1.0; // → 4.0, one more than 3 (7.12)",
            "f(both); // (7.12)",
            "assert!(both > 31.0); // it is 32",
            "// It has two",
            "// sides.",
            "assert!(both > 31.0);",
        ];
        let (found, faults) = answers(&code);
        assert_eq!(faults, []);
        let of = |names: &[&'static str]| Of::Numbers(names.to_vec());
        let expected = [
            ("it is 32", Of::Check(0)),
            ("It has two", Of::Check(1)),
            ("sides.", Of::Check(1)),
            ("With three of them,", of(&["spin"])),
            ("twice as much", of(&["spin"])),
            ("rad/s, of 30", of(&["spin"])),
        ];
        let found: Vec<_> = found.remarks.into_iter().map(|remark| (remark.words, remark.of)).collect();
        assert_eq!(found, expected);
    }

    #[test]
    fn the_body_takes_its_numbers_and_records() {
        let page = format!("# A\n\n```rust\n{}\n```\n\n```rust\nlet a = 1;\n```\n", CODE.join("\n"));
        let found = snippets(&page);
        assert_eq!(found, [(3, CODE.to_vec())]);
        assert_eq!(
            body(&found[0].1),
            "use x::f;\nlet spin = live[0];\nlet tilt = live[1].to_radians();\nlet count = record::whole(4, live[2]);\n \
             record::printed(0, &(f(spin, tilt)), \"4.317\");\nassert!(0; f(spin, tilt) > 4.0); // it is fast\n\
             // Equation eq:x holds,\n// nearly.\n\
             for n in 0..count { assert_eq!(1; n, n); assert_relative_eq!(2; 1.0, g(n)); }\n\
             Ok::<(), std::convert::Infallible>(())\n"
        );
        let other = page.replace("# A", "# B").replace("let a", "let b");
        assert_eq!(matter([&*page]), matter([&*other]));
        assert_ne!(matter([&*page]), matter([&*page.replace("0..60", "0..61")]));
    }
}
