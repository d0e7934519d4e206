//! Exercises as their page shows them: grade and minutes at the head, and below each its answer and its solution, which
//! unfold in place. The page of solutions has them whole, for paper and for those who read them in a row.

use crate::read::exercise_times::GRADES;
use html::{Edits, Element, elements, named, words};
use std::collections::BTreeMap;
use std::ops::Range;

/// How an answer begins: the first paragraph of a solution.
pub(crate) const ANSWER: &str = "<strong>Answer.</strong>";

/// The solutions of a page by the names of their exercises: what stands below each heading.
type Solutions<'a> = BTreeMap<String, &'a str>;

/// The page at `path` with its exercises opened up; `pages` are all pages of the site.
pub(crate) fn with_solutions(html: &str, path: &str, pages: &BTreeMap<String, String>) -> String {
    let exercises = sections(html, "ex-");
    if exercises.is_empty() {
        return html.to_owned();
    }
    let beside = path.rsplit_once('/').map_or(String::new(), |(folder, _)| format!("{folder}/"));
    let mut near = pages.iter().filter(|(page, _)| {
        *page != path && page.strip_prefix(&*beside).is_some_and(|name| !name.contains('/'))
    });
    let solutions = near.find_map(|(page, html)| {
        let found: Solutions<'_> =
            sections(html, "sol-").into_iter().map(|(name, place)| (name, &html[place])).collect();
        (!found.is_empty()).then(|| (&page[beside.len()..], found))
    });
    let mut edits = Edits::default();
    let lines = named(html, &["p"]);
    for (name, place) in exercises {
        let own = lines.iter().filter(|line| place.start <= line.whole.start && line.whole.end <= place.end);
        let grade = own.clone().find(|line| {
            let inside = &html[line.inside.clone()];
            GRADES.iter().any(|grade| inside.starts_with(&format!("<em>{grade} · ")))
        });
        if let Some(grade) = grade {
            edits.replace(grade.start_tag.clone(), "<p class=\"grade\">");
        }
        let solution = solutions.as_ref().and_then(|(page, all)| Some((*page, *all.get(&name)?)));
        if let Some((page, solution)) = solution {
            for line in own.filter(|line| line.is("p", "turn")) {
                edits.remove(line.whole.clone());
            }
            edits.insert(place.end, unfolding(solution, page));
        }
    }
    edits.applied(html)
}

/// Headings whose ids begin with `kind`: the rest of each id, and the place between the heading and the next.
fn sections(html: &str, kind: &str) -> Vec<(String, Range<usize>)> {
    let found = named(html, &["h2", "main"]);
    let Some(main) = found.iter().find(|element| element.name == "main") else { return Vec::new() };
    let headings: Vec<&Element> =
        found.iter().filter(|heading| heading.name == "h2" && main.holds(heading)).collect();
    let end = |n: usize| headings.get(n + 1).map_or(main.inside.end, |next| next.whole.start);
    let named = headings.iter().enumerate().filter_map(|(n, heading)| {
        Some((heading.get("id")?.strip_prefix(kind)?.to_owned(), heading.whole.end..end(n)))
    });
    named.collect()
}

/// The answer and the rest of a solution, folded. Its anchors and its live numbers stay on its own `page`.
fn unfolding(solution: &str, page: &str) -> String {
    let clean = without_anchors(solution, page);
    let fold = |name: &str, inside: &str| {
        format!("<details class=\"unfolding\"><summary>{name}</summary>{inside}</details>\n")
    };
    let answers = named(&clean, &["p"]);
    let Some(answer) = answers.iter().find(|line| clean[line.inside.clone()].starts_with(ANSWER)) else {
        return fold("Solution", &clean);
    };
    let mut edits = Edits::default();
    edits.remove(answer.whole.clone());
    let rest = edits.applied(&clean);
    let said = format!("<p>{}</p>", clean[answer.inside.start + ANSWER.len()..answer.inside.end].trim());
    fold("Answer", &said) + &if words(&rest).is_empty() { String::new() } else { fold("Solution", &rest) }
}

/// A solution without what another page cannot have: ids, fields for live numbers, and links to the page it is taken from
/// that do not name this page.
fn without_anchors(solution: &str, page: &str) -> String {
    let drawings = named(solution, &["svg"]);
    let mut edits = Edits::default();
    for element in elements(solution, &|_| true) {
        if element.is("p", "turn") || element.is("div", "answers") || element.is("details", "origin") {
            edits.remove(element.whole.clone());
        } else if !drawings.iter().any(|drawing| drawing.holds(&element)) {
            if let Some(id) = element.place("id") {
                edits.remove(id);
            }
            if let (Some(target), Some(place)) = (element.get("href"), element.place("href"))
                && target.starts_with('#')
            {
                edits.replace(place, format!("href=\"{page}{target}\""));
            }
        }
    }
    edits.applied(solution)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_exercise_opens_its_answer_and_its_solution() {
        let exercises = "<main><h1>E</h1><h2 id=\"ex-a\">A</h2><p class=\"turn\"><a href=\"s.html#sol-a\">S</a></p>\n\
                         <p><em>Check · 5 minutes · no pen</em></p><p>Why?</p><h2 id=\"ex-b\">B</h2><p>How?</p></main>";
        let solutions = "<main><h2 id=\"sol-a\">A</h2><p class=\"turn\">back</p><p><strong>Answer.</strong> 5 <a href=\"#eq-x\">m</a></p>\
                         <div class=\"equation\" id=\"eq-x\">x</div><svg><g id=\"clip\"></g></svg><div class=\"answers\"><input id=\"i\"></div>\
                         <h2 id=\"sol-b\">B</h2><p>So.</p></main>";
        let pages = BTreeMap::from(
            [
                ("t/e.html", exercises),
                ("t/s.html", solutions),
                ("u/s.html", "<main><h2 id=\"sol-a\"></h2></main>"),
            ]
            .map(|(page, html)| (page.to_owned(), html.to_owned())),
        );
        let fold = |name: &str, inside: &str| {
            format!("<details class=\"unfolding\"><summary>{name}</summary>{inside}</details>\n")
        };
        let expected = format!(
            "<main><h1>E</h1><h2 id=\"ex-a\">A</h2>\n<p class=\"grade\"><em>Check · 5 minutes · no pen</em></p><p>Why?</p>{}{}\
             <h2 id=\"ex-b\">B</h2><p>How?</p>{}</main>",
            fold("Answer", "<p>5 <a href=\"s.html#eq-x\">m</a></p>"),
            fold("Solution", "<div class=\"equation\" >x</div><svg><g id=\"clip\"></g></svg>"),
            fold("Solution", "<p>So.</p>"),
        );
        assert_eq!(with_solutions(exercises, "t/e.html", &pages), expected);
        let alone = BTreeMap::from([("t/e.html".to_owned(), exercises.to_owned())]);
        assert!(
            with_solutions(exercises, "t/e.html", &alone).contains("<p class=\"turn\">"),
            "no solutions, no folds"
        );
    }
}
