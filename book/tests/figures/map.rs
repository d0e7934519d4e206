//! The map of the chapters shows what the chapters themselves say.

use super::{every_figure, labels, words};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::{env, fs};

/// The text of every page below a folder, with its path from there.
fn pages(folder: &Path, below: &str, found: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(folder.join(below)).expect("a folder of the book") {
        let path = entry.expect("an entry").path();
        let name = format!("{below}{}", path.file_name().expect("a name").to_string_lossy());
        if path.is_dir() {
            pages(folder, &format!("{name}/"), found);
        } else if name.ends_with(".md") {
            found.push((name, fs::read_to_string(&path).expect("a page")));
        }
    }
}

fn folder_of(page: &str) -> &str {
    page.split('/').next().unwrap_or_default()
}

/// The workspace, where it lies now.
fn root() -> PathBuf {
    PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("Cargo sets it")).join("..")
}

/// Chapter → the chapters that the line `You need …` of its first page leads to.
fn needs() -> BTreeMap<String, BTreeSet<String>> {
    let mut found = Vec::new();
    pages(&root().join("book"), "", &mut found);
    let home = |label: &str| {
        let defined = [format!("{{#{label}}}"), format!("{{#{label} ")];
        found.iter().find(|(_, text)| defined.iter().any(|label| text.contains(label))).map(|(page, _)| page)
    };
    let mut needs = BTreeMap::new();
    for (page, text) in found.iter().filter(|(page, _)| page.ends_with("/index.md")) {
        let chapter = folder_of(page);
        let line = text.lines().find(|line| line.starts_with("You need ")).unwrap_or_default();
        assert!(!line.is_empty(), "{page}: what does one need?");
        let labels = line.split('@').skip(1).map(|rest| {
            let end =
                rest.find(|c: char| !c.is_ascii_alphanumeric() && !":-".contains(c)).unwrap_or(rest.len());
            let label = rest[..end].trim_end_matches(':');
            folder_of(home(label).unwrap_or_else(|| panic!("{page}: no page defines {label}")))
        });
        let links = line.split("](../").skip(1).map(folder_of);
        let all: BTreeSet<String> =
            labels.chain(links).filter(|needed| *needed != chapter).map(str::to_owned).collect();
        needs.insert(chapter.to_owned(), all);
    }
    needs
}

/// What leads to a chapter in one step or more.
fn behind(chapter: &str, needs: &BTreeMap<String, BTreeSet<String>>) -> BTreeSet<String> {
    let direct = needs.get(chapter).into_iter().flatten();
    direct.flat_map(|one| behind(one, needs).into_iter().chain([one.clone()])).collect()
}

#[test]
fn the_map_of_the_chapters_shows_what_each_says_that_one_needs() {
    let needs = needs();
    assert!(needs.len() >= 13, "only {} chapters", needs.len());
    // No arrow for what is needed by way of another chapter.
    let mut wanted = BTreeSet::new();
    for (chapter, direct) in &needs {
        let by_way: BTreeSet<String> = direct.iter().flat_map(|one| behind(one, &needs)).collect();
        wanted.extend(direct.difference(&by_way).map(|one| format!("{one}-to-{chapter}")));
    }
    let map = every_figure().iter().find(|figure| figure.id == "fig:chapters-map").expect("the map");
    assert_eq!(map.drawing.all_parts().len(), 2, "for wide pages and for phones");
    for part in map.drawing.all_parts() {
        let drawn: BTreeSet<String> = part.items().iter().filter_map(|item| item.name.clone()).collect();
        assert_eq!(drawn, wanted, "{}", part.id());
    }
}

/// The folders of the chapters with their titles, in the order of the book.
fn chapters() -> Vec<(String, String)> {
    let summary = fs::read_to_string(root().join("book/SUMMARY.md")).expect("the summary");
    let line = |line: &str| {
        let (title, folder) = line.strip_prefix("- [")?.strip_suffix("/index.md)")?.split_once("](")?;
        Some((folder.to_owned(), title.to_lowercase()))
    };
    summary.lines().filter_map(line).collect()
}

/// Whether a picture with this name, `4 Coin toss`, is one of the chapter with this number and title.
fn names(name: &str, number: usize, title: &str) -> bool {
    name.split_once(' ')
        .is_some_and(|(own, words)| own == number.to_string() && title.contains(&words.to_lowercase()))
}

#[test]
fn the_map_has_a_box_for_each_chapter_with_its_number() {
    let map = every_figure().iter().find(|figure| figure.id == "fig:chapters-map").expect("the map");
    let chapters = chapters();
    for part in map.drawing.all_parts() {
        let boxes: Vec<String> = labels(part).into_iter().map(words).collect();
        for (number, (folder, title)) in (1..).zip(&chapters) {
            let has = boxes.iter().any(|name| names(name, number, title));
            assert!(has, "book/figures.rs: the map has no box `{number} …` for book/{folder}: {boxes:?}");
        }
        assert_eq!(boxes.len(), chapters.len(), "book/figures.rs: a box for what is no chapter: {boxes:?}");
    }
}

#[test]
fn the_frontispiece_gives_each_chapter_its_number() {
    let figure = every_figure().iter().find(|figure| figure.id == "fig:frontispiece").expect("the figure");
    let chapters = chapters();
    for picture in figure.drawing.parts() {
        let is_one = (1..).zip(&chapters).any(|(number, (_, title))| names(picture.title(), number, title));
        assert!(is_one, "book/figures.rs: no chapter has number and name of `{}`", picture.title());
    }
}
