//! The exercises of every chapter: enough of them, graded, from what takes minutes to what takes an evening.

use press::book::Page;
use press::read::disk::from_disk;
use press::read::exercise_times::{GRADES, graded};
use std::collections::BTreeMap;
use std::env;
use std::ops::Range;
use std::path::PathBuf;

/// How many minutes an exercise of each grade may take.
const MINUTES: [[f64; 2]; GRADES.len()] = [[2.0, 15.0], [10.0, 60.0], [60.0, 600.0]];

/// How many a page has at least; on measurements and on other people's numbers there are fewer.
const LEAST: usize = 10;
const FEWER: [(&str, usize); 2] = [("speed-and-accuracy/", 8), ("judged/", 7)];

fn pages(name: &str) -> Vec<Page> {
    let package = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("Cargo sets it"));
    let pages = from_disk(&package.join("../..")).expect("a book without faults").1;
    pages.into_iter().filter(|page| page.path.ends_with(name)).collect()
}

/// The sections of a page: their headings, with their labels, and what stands below.
fn sections(text: &str) -> impl Iterator<Item = (&str, &str)> {
    text.split("\n## ").skip(1).filter_map(|section| section.split_once('\n'))
}

/// The first line with words.
fn first_line(below: &str) -> &str {
    below.lines().find(|line| !line.trim().is_empty()).unwrap_or_default()
}

#[test]
fn every_chapter_has_exercises_of_all_grades_in_their_order() {
    let (mut faults, mut chapters) = (Vec::new(), 0);
    for page in pages("/exercises.md") {
        chapters += 1;
        let mut fault = |words: String| faults.push(format!("{}: {words}", page.file));
        let mut grades = Vec::new();
        for (heading, below) in sections(&page.text) {
            let Some((grade, minutes)) = graded(first_line(below)) else {
                fault(format!("`{heading}` has no grade, but `{}`", first_line(below)));
                continue;
            };
            let [least, most] = MINUTES[grade];
            if !(least..=most).contains(&minutes) {
                fault(format!(
                    "`{heading}`, a {}, takes {minutes} minutes, not {least} to {most}",
                    GRADES[grade]
                ));
            }
            grades.push((grade, heading));
        }
        let least = FEWER.iter().find(|few| page.path.starts_with(few.0)).map_or(LEAST, |few| few.1);
        if grades.len() < least {
            fault(format!("{} exercises, of at least {least}", grades.len()));
        }
        for (grade, name) in GRADES.iter().enumerate() {
            if !grades.iter().any(|(own, _)| *own == grade) {
                fault(format!("no exercise is a {name}"));
            }
        }
        if let Some(pair) = grades.windows(2).find(|pair| pair[0].0 > pair[1].0) {
            fault(format!("`{}` stands behind harder ones", pair[1].1));
        }
    }
    assert!(chapters >= 11, "only {chapters} chapters");
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn every_solution_begins_with_its_answer_and_runs_a_program() {
    let (mut faults, mut solutions) = (Vec::new(), 0);
    for page in pages("/solutions.md") {
        for (heading, below) in sections(&page.text) {
            solutions += 1;
            if !first_line(below).starts_with("**Answer.** ") {
                faults.push(format!("{}: `{heading}` does not begin with `**Answer.** `", page.file));
            }
            if !below.contains("```rust") {
                faults.push(format!("{}: `{heading}` has no program", page.file));
            }
        }
    }
    assert!(solutions >= 110, "only {solutions} solutions");
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

/// The label of a heading: `ex:peak`.
fn label(heading: &str) -> &str {
    heading.split("{#").nth(1).and_then(|rest| rest.split('}').next()).unwrap_or_default()
}

/// The labels behind each `@`: `sec:ramp`.
fn references(text: &str) -> Vec<&str> {
    let end = |c: char| !c.is_alphanumeric() && c != ':' && c != '-';
    text.split('@').skip(1).filter_map(|rest| rest.split(end).next()).collect()
}

/// The plans of `teaching.md`: the label of each, how many rows it has, and whether it says the minutes at the board.
const PLANS: [(&str, usize, bool); 3] = [("four", 4, true), ("eight", 8, true), ("two", 6, false)];

/// The section of `teaching.md` that has a plan, and the cells of its rows.
fn plan<'a>(teaching: &'a str, name: &str) -> (&'a str, Vec<Vec<&'a str>>) {
    let label = format!("{{#sec:teaching-{name}}}");
    let section =
        teaching.split(&label).nth(1).and_then(|rest| rest.split("\n## ").next()).expect("a section");
    let rows = section.lines().filter(|row| row.starts_with("| "));
    let cells = rows.map(|row| row.split('|').map(str::trim).collect::<Vec<_>>());
    (section, cells.filter(|cells| cells[1].parse::<u32>().is_ok()).collect())
}

#[test]
fn a_course_of_some_weeks_adds_up_the_minutes_of_its_exercises() {
    let mut efforts = BTreeMap::new();
    for page in pages("/exercises.md") {
        for (heading, below) in sections(&page.text) {
            let effort = graded(first_line(below)).expect("every exercise has a grade");
            efforts.insert(label(heading).to_owned(), effort);
        }
    }
    let teaching = pages("teaching.md").remove(0).text;
    for (name, weeks, has_board) in PLANS {
        let (section, rows) = plan(&teaching, name);
        assert_eq!(rows.len(), weeks, "the rows of {name}");
        let (mut checks, mut problems, mut board) = (0.0, 0.0, 0.0);
        for cells in rows {
            let named: Vec<_> = references(cells[3]).into_iter().map(|label| efforts[label]).collect();
            let sum: f64 = named.iter().map(|(_, minutes)| minutes).sum();
            assert_eq!(cells[4].parse(), Ok(sum), "book/teaching.md: the minutes of the row {cells:?}");
            let mut effort = [0.0; GRADES.len()];
            named.iter().for_each(|(grade, minutes)| effort[*grade] += minutes);
            let parts = [cells.len() - 3, cells.len() - 2].map(|n| cells[n].parse::<f64>().expect("minutes"));
            assert_eq!(
                parts,
                [effort[0], effort[1]],
                "book/teaching.md: check and home of the row {cells:?}"
            );
            checks += effort[0];
            problems += effort[1];
            if has_board {
                let pages: f64 = cells[7].parse().expect("minutes at the board");
                board += pages;
                assert!(pages + effort[0] <= 180.0, "a week has two meetings of 90 minutes: {cells:?}");
            }
        }
        let meetings = f64::from(u32::try_from(weeks).expect("few")) * 180.0;
        let said = [
            format!(
                "The pages take {board} of the {meetings} minutes of the meetings, and the checks {checks} more."
            ),
            format!("The problems are {problems} minutes of homework in all."),
        ];
        for said in said.iter().filter(|_| has_board) {
            assert!(section.contains(said), "{name} of book/teaching.md does not say: {said}");
        }
    }
}

/// The text of the chapters in reading order, without their programs, exercises and solutions.
fn chapters() -> String {
    let tasks = ["/exercises.md", "/solutions.md"];
    let pages = pages(".md").into_iter().filter(|page| page.chapter.is_some());
    let pages = pages.filter(|page| !tasks.iter().any(|name| page.path.ends_with(name)));
    let plain = |page: Page| page.text.split("```").step_by(2).collect::<String>();
    pages.map(|page| format!("\n{}", plain(page))).collect()
}

/// Where a text defines a label, `sec:ramp` or `fig:drum`.
fn place(text: &str, label: &str) -> Option<usize> {
    let forms = [format!("{{#{label}}}"), format!("{{#{label} "), format!("]({label})")];
    forms.iter().find_map(|form| text.find(form))
}

/// The depth of the heading below which a place of a text stands, and where what stands below that ends.
fn section(text: &str, place: usize) -> (usize, usize) {
    let depth = |at: usize| text[at + 1..].bytes().take_while(|byte| *byte == b'#').count();
    let line = text[place..].find('\n').map_or(text.len(), |end| place + end);
    let own = depth(text[..line].rfind("\n#").expect("a heading"));
    let next = text[line..].match_indices("\n#").map(|(at, _)| line + at).find(|at| depth(*at) <= own);
    (own, next.unwrap_or(text.len()))
}

/// What the pages of a row cover: `@sec:a to @sec:b`, `*Title* as far as @sec:b`.
fn covered(text: &str, pages: &str) -> Vec<Range<usize>> {
    let range = |part: &str| {
        let title = part.split('*').nth(1);
        let titled = title.map(|title| text.find(&format!("\n# {title}")).expect("a chapter") + 1);
        let labelled = references(part).into_iter().map(|label| place(text, label).expect("a section"));
        let named: Vec<usize> = titled.into_iter().chain(labelled).collect();
        named[0]..section(text, named[named.len() - 1]).1
    };
    pages.split([',', ';']).map(range).collect()
}

#[test]
fn the_exercises_of_a_plan_need_what_was_read_before_them() {
    let text = chapters();
    let mut exercises = BTreeMap::new();
    for page in pages("/exercises.md") {
        for (heading, below) in sections(&page.text) {
            exercises.insert(label(heading).to_owned(), below.to_owned());
        }
    }
    let teaching = pages("teaching.md").remove(0).text;
    let (mut faults, mut checked) = (Vec::new(), 0);
    for (name, ..) in PLANS {
        let mut read = Vec::new();
        for cells in plan(&teaching, name).1 {
            read.extend(covered(&text, cells[2]));
            for exercise in references(&cells[3..].join(" ")) {
                for label in exercises.get(exercise).map_or(Vec::new(), |text| references(text)) {
                    let Some(place) = place(&text, label) else { continue };
                    checked += 1;
                    if !read.iter().any(|range| range.contains(&place)) && section(&text, place).0 > 1 {
                        faults
                            .push(format!("{name}, {} | {}: @{exercise} needs @{label}", cells[1], cells[2]));
                    }
                }
            }
        }
    }
    assert!(checked > 20, "only {checked} references");
    assert!(faults.is_empty(), "book/teaching.md:\n{}", faults.join("\n"));
}

#[test]
fn the_preface_counts_what_there_is() {
    let words = [
        "none", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven",
        "twelve", "thirteen", "fourteen", "fifteen",
    ];
    let chapters = pages("/index.md");
    let opens_with_a_scene = |page: &&Page| page.text.split("\n## ").next().unwrap().contains("](scene:");
    let scenes: Vec<&Page> = chapters.iter().filter(opens_with_a_scene).collect();
    for page in &scenes {
        for part in ["**Guess first.**", "\n## In ten lines"] {
            assert!(page.text.contains(part), "{} has a scene and no `{part}`", page.file);
        }
    }
    let preface = pages("preface.md").remove(0).text;
    let [all, moved, tried] = [chapters.len(), scenes.len(), pages("/exercises.md").len()];
    for said in [
        format!(
            "Each of the {} chapters about things that spin opens with a question and a scene",
            words[moved]
        ),
        if tried == all {
            format!("all {} chapters have exercises", words[all])
        } else {
            format!("{} of the {} chapters have exercises", words[tried], words[all])
        },
        format!("{} chapters at the end are about the computing", words[all - moved]),
    ] {
        let preface = preface.to_lowercase();
        assert!(preface.contains(&said.to_lowercase()), "book/preface.md does not say: {said}");
    }
}
