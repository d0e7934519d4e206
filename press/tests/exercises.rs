//! The exercises of every chapter: enough of them, graded, from what takes minutes to what takes an evening.

use press::book::{Page, from_disk};
use std::env;
use std::path::PathBuf;

/// The grades, in the order in which a page has them, and how many minutes each may take.
const GRADES: [(&str, [f64; 2]); 3] =
    [("Check", [2.0, 15.0]), ("Problem", [10.0, 60.0]), ("Project", [60.0, 600.0])];

/// How many a page has at least.
const LEAST: usize = 10;

fn pages(name: &str) -> Vec<Page> {
    let package = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("Cargo sets it"));
    let pages = from_disk(&package.join("..")).expect("a book without faults").1;
    pages.into_iter().filter(|page| page.path.ends_with(name)).collect()
}

/// The sections of a page: their headings, with their labels, and what stands below.
fn sections(text: &str) -> Vec<(&str, &str)> {
    text.split("\n## ").skip(1).filter_map(|section| section.split_once('\n')).collect()
}

/// The grade of an exercise, as its place among the grades, and its minutes.
fn effort(line: &str) -> Option<(usize, f64)> {
    let (grade, time) = line.strip_prefix('*')?.strip_suffix('*')?.split_once(" · ")?;
    let (number, unit) = time.split_once(' ')?;
    let minutes = match unit {
        "minutes" => 1.0,
        "hour" | "hours" => 60.0,
        _ => return None,
    };
    Some((GRADES.iter().position(|(name, _)| *name == grade)?, minutes * number.parse::<f64>().ok()?))
}

#[test]
fn every_chapter_has_exercises_of_all_grades_in_their_order() {
    let (mut faults, mut chapters) = (Vec::new(), 0);
    for page in pages("/exercises.md") {
        let exercises = sections(&page.text);
        let mut grades = Vec::new();
        for (heading, below) in &exercises {
            let first = below.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
            let Some((grade, minutes)) = effort(first) else {
                faults.push(format!("{}: `{heading}` has no grade, but `{first}`", page.file));
                continue;
            };
            let [least, most] = GRADES[grade].1;
            if !(least..=most).contains(&minutes) {
                let name = GRADES[grade].0;
                faults.push(format!(
                    "{}: `{heading}`, a {name}, takes {minutes} minutes, not {least} to {most}",
                    page.file
                ));
            }
            if !below.contains("<details>") {
                faults.push(format!("{}: `{heading}` has no hint", page.file));
            }
            grades.push((grade, *heading));
        }
        if exercises.len() < LEAST {
            faults.push(format!("{}: {} exercises, of at least {LEAST}", page.file, exercises.len()));
        }
        for (grade, (name, _)) in GRADES.iter().enumerate() {
            if !grades.iter().any(|(own, _)| *own == grade) {
                faults.push(format!("{}: no exercise is a {name}", page.file));
            }
        }
        if let Some(pair) = grades.windows(2).find(|pair| pair[0].0 > pair[1].0) {
            faults.push(format!("{}: `{}` stands behind harder ones", page.file, pair[1].1));
        }
        chapters += 1;
    }
    assert!(chapters >= 11, "only {chapters} chapters");
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn every_solution_runs_a_program_and_says_what_it_teaches() {
    let (mut faults, mut solutions) = (Vec::new(), 0);
    for page in pages("/solutions.md") {
        for (heading, below) in sections(&page.text) {
            solutions += 1;
            for wanted in ["```rust", "The lesson: "] {
                if !below.contains(wanted) {
                    faults.push(format!("{}: `{heading}` has no `{wanted}`", page.file));
                }
            }
        }
    }
    assert!(solutions >= 110, "only {solutions} solutions");
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn a_course_of_some_weeks_adds_up_the_minutes_of_its_exercises() {
    let mut minutes = std::collections::BTreeMap::new();
    for page in pages("/exercises.md") {
        for (heading, below) in sections(&page.text) {
            let label =
                heading.split("{#").nth(1).and_then(|rest| rest.split('}').next()).unwrap_or_default();
            let line = below.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
            minutes.insert(label.to_owned(), effort(line).expect("every exercise has a grade").1);
        }
    }
    let teaching = pages("teaching.md").remove(0).text;
    let mut weeks = 0;
    for row in teaching.lines() {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        if !row.starts_with("| ") || cells[1].parse::<u32>().is_err() {
            continue;
        }
        let labels: Vec<&str> = cells[3].split(", ").map(|word| word.trim_start_matches('@')).collect();
        let sum: f64 = labels.iter().map(|label| minutes[*label]).sum();
        assert_eq!(cells[4].parse(), Ok(sum), "book/teaching.md: the minutes of the row {row}");
        weeks += 1;
    }
    assert_eq!(weeks, 12 + 6);
}
