//! Where a page is in the book: in the head that stays above it, and in the links to its neighbours, whose names alone
//! ("Exercises") say too little.

use crate::book::{part, slashed};
use html::{Edits, escaped, named};
use live::numbers::BLANK;
use mdbook_preprocessor::book::{Book, BookItem};
use std::collections::BTreeMap;

/// The place of a page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Trail {
    /// Its chapter, `4 The coin toss`, if it belongs to a numbered one, and the path of that chapter's first page.
    chapter: Option<(String, String)>,
    /// Its name in SUMMARY.md, if it is not the first page of a numbered chapter.
    page: Option<String>,
}

impl Trail {
    /// For a link: `4 The coin toss`, `Exercises · 4 The coin toss`, `Preface`.
    fn words(&self) -> String {
        let chapter = self.chapter.iter().map(|(name, _)| name);
        self.page.iter().chain(chapter).map(String::as_str).collect::<Vec<_>>().join(" · ")
    }
}

/// The trails of all pages, by their paths in the site.
pub(crate) fn trails(book: &Book) -> BTreeMap<String, Trail> {
    let mut trails = BTreeMap::new();
    collect(&book.items, None, &mut trails);
    trails
}

fn collect(items: &[BookItem], above: Option<&(String, String)>, trails: &mut BTreeMap<String, Trail>) {
    for item in items {
        let BookItem::Chapter(chapter) = item else { continue };
        let Some(path) = chapter.path.as_ref().map(|path| slashed(&path.with_extension("html"))) else {
            collect(&chapter.sub_items, above, trails);
            continue;
        };
        let number = chapter.number.as_ref().map(|number| number.as_slice());
        let leaf = number.and_then(|number| part(number, &chapter.name));
        let own = number.filter(|_| leaf.is_none()).and_then(<[u32]>::first);
        let own = own.map(|number| (format!("{number}{BLANK}{}", chapter.name), path.clone()));
        let page = if own.is_some() { None } else { Some(chapter.name.clone()) };
        let trail = Trail { chapter: own.or_else(|| above.cloned()), page };
        collect(&chapter.sub_items, trail.chapter.as_ref(), trails);
        trails.insert(path, trail);
    }
}

/// The page at `path` with its place in the spans of the theme that have the class `trail`, and with the places of its
/// neighbours in the links to them.
pub(crate) fn with_trail(html: &str, path: &str, trails: &BTreeMap<String, Trail>) -> String {
    let mut edits = Edits::default();
    let up = "../".repeat(path.matches('/').count());
    for element in named(html, &["span", "a"]) {
        if element.is("span", "trail")
            && let Some(trail) = trails.get(path)
        {
            let mut words = String::new();
            if let Some((chapter, first)) = &trail.chapter {
                words += &format!(" › <a href=\"{up}{}\">{}</a>", escaped(first), escaped(chapter));
            }
            // The cover has the name of the book, which stands before it.
            let above = &html[..element.inside.start];
            let is_cover =
                |page: &str| above.ends_with(&format!("{}</a><span class=\"trail\">", escaped(page)));
            if let Some(page) = trail.page.as_ref().filter(|page| !is_cover(page)) {
                words += &format!(" › {}", escaped(page));
            }
            edits.insert(element.inside.end, words);
        }
        let is_neighbour = matches!(element.get("rel"), Some("prev" | "next" | "next prefetch"));
        let target =
            element.get("href").filter(|_| is_neighbour).and_then(|target| target.strip_prefix(&*up));
        let Some(trail) = target.and_then(|target| trails.get(target)) else { continue };
        let words = escaped(&trail.words());
        if let Some(title) = element.place("title") {
            edits.replace(title, format!("title=\"{words}\""));
        }
        if let Some(end) =
            html[element.inside.clone()].rfind("</span>").filter(|_| element.get("title").is_none())
        {
            let start = element.inside.start + end + "</span>".len();
            edits.replace(start..element.inside.end, format!(" {words}"));
        }
    }
    edits.applied(html)
}

#[cfg(test)]
mod tests {
    use super::*;
    use mdbook_preprocessor::book::{Chapter, SectionNumber};

    #[test]
    fn a_page_says_where_it_is_and_its_neighbours_whose_they_are() {
        let chapter = |name: &str, path: &str, number: Option<Vec<u32>>| {
            let mut chapter = Chapter::new(name, String::new(), path, Vec::new());
            chapter.number = number.map(SectionNumber::new);
            chapter
        };
        let mut coin = chapter("The coin & toss", "coin/index.md", Some(vec![4]));
        let exercises = chapter("Exercises", "coin/exercises.md", Some(vec![4, 1]));
        coin.sub_items.push(BookItem::Chapter(exercises));
        let preface = chapter("Preface", "preface.md", None);
        let book = Book::new_with_items(vec![BookItem::Chapter(preface), BookItem::Chapter(coin)]);
        let trails = trails(&book);
        let page = "<span class=\"trail\"></span><a rel=\"prev\" href=\"../preface.html\"><span>Previous</span> Preface</a>\
                    <a rel=\"next\" href=\"../coin/exercises.html\"><span>Next</span>\n Exercises</a>\
                    <a rel=\"next prefetch\" title=\"Exercises\" href=\"../coin/exercises.html\"><svg></svg></a>";
        let coin = "4\u{a0}The coin &amp; toss";
        assert_eq!(
            with_trail(page, "coin/index.html", &trails),
            format!(
                "<span class=\"trail\"> › <a href=\"../coin/index.html\">{coin}</a></span><a rel=\"prev\" href=\"../preface.html\"><span>Previous</span> Preface</a>\
                 <a rel=\"next\" href=\"../coin/exercises.html\"><span>Next</span> Exercises · {coin}</a>\
                 <a rel=\"next prefetch\" title=\"Exercises · {coin}\" href=\"../coin/exercises.html\"><svg></svg></a>"
            )
        );
        let place = with_trail(page, "coin/exercises.html", &trails);
        assert!(place.contains(&format!("{coin}</a> › Exercises</span>")), "{place}");
    }
}
