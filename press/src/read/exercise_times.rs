//! How much time the exercises ask for, counted from the pages: the table `table:exercises`.

use crate::book::{Page, relative};
use crate::fault::Faults;
use std::mem;

/// The name of the table in `![Caption.](table:exercises)`.
pub(crate) const TABLE: &str = "exercises";
/// The grades of exercises, from what takes minutes to what takes an evening.
pub const GRADES: [&str; 3] = ["Check", "Problem", "Project"];

/// The exercises of one grade: how many, and their minutes together.
type Effort = [(u32, f64); GRADES.len()];

/// A row for each page that has exercises with a grade, `*Check · 5 minutes*` on a line of its own, and one for all.
/// The links are those of a page at the top of the book's folder.
pub(crate) fn table(pages: &[Page]) -> String {
    let mut text = "| chapter | exercises | checks | min | problems | min | projects | min | all, h |\n\
                    |---|---|---|---|---|---|---|---|---|\n"
        .to_owned();
    let mut all = Effort::default();
    for page in pages {
        let effort = effort(&page.text);
        if effort.iter().any(|(count, _)| *count > 0) {
            let first = pages.iter().find(|first| first.chapter == page.chapter).unwrap_or(page);
            let title = first.text.lines().find_map(|line| line.strip_prefix("# ")).unwrap_or(&page.path);
            let title = title.split(" {#").next().unwrap_or(title);
            let number = page.chapter.map(|number| format!("{number} ")).unwrap_or_default();
            let target = relative("", &page.path);
            text += &row(&format!("[{number}{title}]({target})"), &effort);
            for (sum, (count, minutes)) in all.iter_mut().zip(effort) {
                *sum = (sum.0 + count, sum.1 + minutes);
            }
        }
    }
    text + &row("all", &all)
}

fn row(name: &str, effort: &Effort) -> String {
    let count: u32 = effort.iter().map(|(count, _)| count).sum();
    let hours = effort.iter().map(|(_, minutes)| minutes).sum::<f64>() / 60.0;
    let cells: String = effort.iter().map(|(count, minutes)| format!(" {count} | {minutes:.0} |")).collect();
    format!("| {name} | {count} |{cells} {hours:.1} |\n")
}

/// The exercises of a page, by their grades.
fn effort(text: &str) -> Effort {
    let mut effort = Effort::default();
    for (grade, minutes) in text.lines().filter_map(graded) {
        effort[grade] = (effort[grade].0 + 1, effort[grade].1 + minutes);
    }
    effort
}

/// Adds a fault for each line below the heading of an exercise that looks like a grade, and would not be counted as one.
pub(crate) fn check(page: &Page, faults: &mut Faults) {
    let mut is_below = false;
    for (n, line) in page.text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        let is_below = mem::replace(&mut is_below, line.starts_with("## ") && line.contains("{#ex:"));
        let words = line.trim().strip_prefix('*').and_then(|line| line.strip_suffix('*')).unwrap_or_default();
        let like = words.contains(" · ") || GRADES.iter().any(|grade| words.starts_with(grade));
        if is_below && like && !words.contains('*') && graded(line).is_none() {
            let message =
                "a grade is `*Check · 5 minutes*`, `*Problem · 20 minutes*` or `*Project · 2 hours*`";
            faults.add(&page.file, n + 1, message);
        }
    }
}

/// The grade of an exercise, by its place among the grades, and its minutes, from the line that says both and may say
/// more: `*Check · 5 minutes · no pen*`.
pub fn graded(line: &str) -> Option<(usize, f64)> {
    let (grade, time) = line.trim().strip_prefix('*')?.strip_suffix('*')?.split_once(" · ")?;
    let (number, unit) = time.split(" · ").next()?.split_once(' ')?;
    let minutes = match unit {
        "minute" | "minutes" => 1.0,
        "hour" | "hours" => 60.0,
        _ => return None,
    };
    let grade = GRADES.iter().position(|name| *name == grade)?;
    Some((grade, minutes * number.parse::<f64>().ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exercises_are_counted_by_chapter_and_grade() {
        let page = |path: &str, chapter, text: &str| {
            Page::new("book", path.to_owned(), chapter, None, text.to_owned())
        };
        let exercises = "# Exercises\n\n## A {#ex:a}\n*Check · 5 minutes*\n\n## B {#ex:b}\n*Check · 10 minutes · needs [A](a.md)*\n\n\
                         ## C {#ex:c}\n*Project · 2 hours*\n\nNot *Check · 5 minutes* of a sentence.\n";
        let pages = [
            page("preface.md", None, "# Preface\n"),
            page("drum/index.md", Some(1), "# The drum {#sec:drum}\n"),
            page("drum/exercises.md", Some(1), exercises),
            page("coin/exercises.md", Some(2), "# The coin\n\n*Problem · 30 minutes*\n"),
        ];
        let table = table(&pages);
        let rows: Vec<&str> = table.lines().skip(2).collect();
        assert_eq!(
            rows,
            [
                "| [1 The drum](drum/exercises.md) | 3 | 2 | 15 | 0 | 0 | 1 | 120 | 2.2 |",
                "| [2 The coin](coin/exercises.md) | 1 | 0 | 0 | 1 | 30 | 0 | 0 | 0.5 |",
                "| all | 4 | 2 | 15 | 1 | 30 | 1 | 120 | 2.8 |",
            ]
        );
    }
}
