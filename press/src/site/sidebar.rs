//! The headings of a page in its sidebar, before the page is all there.
//!
//! mdBook's script adds them when it has seen the whole page. Until then the list below them would stand higher, and
//! jump. So each page brings a copy, which the theme shows until mdBook's own comes.

use html::{Edits, Element, named};
use std::fmt::Write as _;

/// The page with its headings in the template of the theme that has the class `headings`.
pub(crate) fn with_headings(html: &str) -> String {
    let found = named(html, &["template", "main", "h2", "h3", "a"]);
    let Some(template) = found.iter().find(|element| element.is("template", "headings")) else {
        return html.to_owned();
    };
    let mut edits = Edits::default();
    edits.insert(template.inside.end, list(html, &found));
    edits.applied(html)
}

/// The list as mdBook's script builds it; nothing where there are no headings. What stands below a third level is
/// folded there at first.
fn list(html: &str, found: &[Element]) -> String {
    let main = found.iter().find(|element| element.name == "main");
    let headings = found.iter().filter_map(|element| {
        let level = element.name.strip_prefix('h')?.parse::<usize>().ok()?;
        let link = found.iter().find(|link| link.is("a", "header") && element.holds(link))?;
        main?.holds(element).then_some((level, element.get("id")?, &html[link.inside.clone()]))
    });
    let mut out = String::new();
    // The elements that are open, and the level of each.
    let mut open: Vec<(usize, &str)> = Vec::new();
    for (level, id, words) in headings {
        while let Some((_, end)) = open.pop_if(|(own, end)| *own > level || *own == level && *end == "</li>")
        {
            out += end;
        }
        for own in open.last().map_or(2, |(own, _)| own + 1)..=level {
            out += "<ol class=\"section\">";
            open.push((own, "</ol>"));
        }
        let _ = write!(
            out,
            "<li class=\"header-item expanded\"><span class=\"chapter-link-wrapper\"><a href=\"#{id}\" \
             class=\"header-in-summary\">{words}</a></span>"
        );
        open.push((level, "</li>"));
    }
    out.extend(open.iter().rev().map(|(_, end)| *end));
    if out.is_empty() { out } else { format!("<div class=\"on-this-page\">{out}</div>") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_stand_in_the_template_as_they_are_nested() {
        let head = |level: usize, id: &str| {
            format!("<h{level} id=\"{id}\"><a class=\"header\" href=\"#{id}\">{id}</a></h{level}>")
        };
        let page = |headings: &[(usize, &str)]| {
            let main: String = headings.iter().map(|(level, id)| head(*level, id)).collect();
            format!("<template class=\"headings\"></template><main><h1 id=\"t\">T</h1>{main}</main>")
        };
        let listed = |headings: &[(usize, &str)]| {
            let page = with_headings(&page(headings));
            let list = page.split("</template>").next().unwrap();
            let items = list.replace(" class=\"header-item expanded\"", "").replace(" class=\"section\"", "");
            items.split_once("<div class=\"on-this-page\">").map(|(_, list)| {
                let spans = list.replace("<span class=\"chapter-link-wrapper\">", "").replace("</span>", "");
                spans.replace(" class=\"header-in-summary\"", "").replace("</div>", "")
            })
        };
        let link = |id: &str| format!("<a href=\"#{id}\">{id}</a>");
        let [a, b, c] = ["a", "b", "c"].map(link);
        assert_eq!(
            listed(&[(2, "a"), (3, "b"), (2, "c")]),
            Some(format!("<ol><li>{a}<ol><li>{b}</li></ol></li><li>{c}</li></ol>"))
        );
        assert_eq!(
            listed(&[(3, "a"), (2, "b")]),
            Some(format!("<ol><ol><li>{a}</li></ol><li>{b}</li></ol>"))
        );
        assert_eq!(listed(&[]), None);
        assert_eq!(with_headings("<main></main>"), "<main></main>");
    }
}
