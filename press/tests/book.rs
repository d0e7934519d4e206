//! The built book: what mdBook and the press make of the pages, checked from outside.

#[path = "book/contrast.rs"]
mod contrast;

use std::collections::BTreeSet;
use std::fs;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the press lies in the workspace")
}

/// mdBook, found or installed; its progress goes to standard error, where a waiting reader sees it.
fn program() -> &'static Path {
    static PROGRAM: OnceLock<PathBuf> = OnceLock::new();
    PROGRAM.get_or_init(|| press::mdbook::locate(root()).expect("mdBook can be found or installed"))
}

/// One run of it.
fn mdbook(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(program())
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::null())
        .output()
        .expect("mdBook runs")
}

/// A folder for one test, emptied; inside the workspace, so that Cargo finds the press from there.
fn folder(name: &str) -> PathBuf {
    let folder = root().join("target/tests").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// The site, built once for all tests that read it.
fn site() -> &'static Path {
    static SITE: OnceLock<PathBuf> = OnceLock::new();
    SITE.get_or_init(|| {
        let folder = folder("site");
        let built = mdbook(root(), &["build", "-d", folder.to_str().unwrap()]);
        assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
        folder.join("html")
    })
}

/// Every file below `folder` with the given ending, and its text.
fn files(folder: &Path, ending: &str) -> Vec<(PathBuf, String)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.append(&mut files(&path, ending));
        } else if path.to_str().unwrap().ends_with(ending) {
            let text = fs::read_to_string(&path).unwrap();
            found.push((path, text));
        }
    }
    found
}

/// The pages of the site, without what rustdoc wrote.
fn pages() -> Vec<(PathBuf, String)> {
    let pages: Vec<_> = files(site(), ".html")
        .into_iter()
        .filter(|(path, _)| !path.starts_with(site().join("api")))
        .collect();
    assert!(pages.len() >= 22, "only {} pages", pages.len());
    pages
}

/// The values of an attribute in a page, wherever it stands.
fn attributes<'a>(html: &'a str, name: &str) -> Vec<&'a str> {
    let mark = format!(" {name}=\"");
    html.match_indices(&mark).filter_map(|(at, _)| html[at + mark.len()..].split('"').next()).collect()
}

#[test]
fn no_label_is_left_unresolved() {
    for (path, html) in pages() {
        let prose = without(&without(&html, "<pre", "</pre>"), "<code", "</code>");
        for mark in ["{#", "@eq:", "@fig:", "@ex:", "@sec:", "@sol:", "@cite:", "@source:", "$$"] {
            assert!(!prose.contains(mark), "{} still holds {mark}", path.display());
        }
    }
}

fn without(html: &str, start: &str, end: &str) -> String {
    let mut out = String::new();
    let mut rest = html;
    while let Some(at) = rest.find(start) {
        out.push_str(&rest[..at]);
        rest = rest[at..].find(end).map_or("", |stop| &rest[at + stop + end.len()..]);
    }
    out + rest
}

#[test]
fn nothing_is_loaded_from_a_network() {
    for (path, html) in pages() {
        for tag in ["<link", "<script", "<img", "<iframe", "<use", "<image"] {
            for (at, _) in html.match_indices(tag) {
                let element = html[at..].split('>').next().unwrap();
                assert!(
                    !element.contains("=\"http") && !element.contains("=\"//"),
                    "{}: {element}",
                    path.display()
                );
            }
        }
    }
    let sheets = files(site(), ".css");
    assert!(sheets.len() > 3);
    for (path, css) in sheets {
        assert!(
            !css.contains("url(http") && !css.contains("url(\"http") && !css.contains("@import"),
            "{}",
            path.display()
        );
    }
}

#[test]
fn every_figure_has_a_title_a_description_and_a_number() {
    let mut shown = BTreeSet::new();
    for (path, html) in pages() {
        for figure in html.split("<figure").skip(1) {
            let figure = figure.split("</figure>").next().unwrap();
            let text = |tag: &str| {
                let inside = figure
                    .split(&format!("<{tag}"))
                    .nth(1)
                    .and_then(|rest| rest.split_once('>'))
                    .map(|(_, rest)| rest);
                inside
                    .and_then(|rest| rest.split(&format!("</{tag}>")).next())
                    .map_or(0, |text| text.trim().len())
            };
            assert!(
                text("title") > 5 && text("desc") > 40,
                "a figure of {} does not say what it shows",
                path.display()
            );
            let number = figure.split("Figure ").nth(1).and_then(|rest| rest.split_once('.'));
            let numbered = number.is_some_and(|(chapter, rest)| {
                chapter.parse::<u32>().is_ok() && rest.starts_with(|c: char| c.is_ascii_digit())
            });
            let name = attributes(figure, "id").first().copied().unwrap_or_default();
            assert!(numbered, "{}: the figure {name} has no number", path.display());
            assert!(figure.contains("role=\"img\""), "{}: the figure {name} has no role", path.display());
            shown.insert(attributes(figure, "id").first().copied().unwrap_or_default().to_owned());
        }
    }
    assert_eq!(shown.len(), press::figures::ALL.len());
}

#[test]
fn every_internal_link_and_anchor_is_alive() {
    let mut followed = 0;
    for (path, html) in pages() {
        if path.ends_with("404.html") {
            continue; // its links are relative to the site's address
        }
        for target in attributes(&html, "href") {
            if target.starts_with("http") || target.starts_with("data:") || target.is_empty() {
                continue;
            }
            let (file, anchor) = target.split_once('#').unwrap_or((target, ""));
            let there = if file.is_empty() { path.clone() } else { path.parent().unwrap().join(file) };
            assert!(there.is_file(), "{}: {target} leads nowhere", path.display());
            if !anchor.is_empty() {
                let text = fs::read_to_string(&there).unwrap();
                assert!(
                    text.contains(&format!("id=\"{anchor}\"")),
                    "{}: {target} has no anchor",
                    path.display()
                );
            }
            followed += 1;
        }
    }
    assert!(followed > 300, "only {followed} links");
}

#[test]
fn no_id_stands_twice_on_a_page() {
    for (path, html) in pages() {
        let ids = attributes(&html, "id");
        let distinct: BTreeSet<_> = ids.iter().collect();
        assert_eq!(ids.len(), distinct.len(), "{}", path.display());
    }
}

/// The equations of the source that the finished chapters derive; to be extended with each chapter.
const DERIVED: [RangeInclusive<u32>; 1] = [1..=98];

#[test]
fn each_equation_of_the_source_has_its_anchor_and_its_test() {
    let mut anchors: Vec<u32> = Vec::new();
    for (path, html) in pages() {
        if !path.ends_with("print.html") {
            let ids = attributes(&html, "id");
            anchors.extend(ids.iter().filter_map(|id| id.strip_prefix("source-")?.parse::<u32>().ok()));
        }
    }
    anchors.sort_unstable();
    let expected: Vec<u32> = DERIVED.into_iter().flatten().collect();
    assert_eq!(anchors, expected, "the pages derive other equations than `DERIVED` says");

    // `fn eq19_…`, or `fn eq39_and_eq01_…` for one that the source prints twice.
    let tests = files(&root().join("tests"), ".rs");
    let names: Vec<&str> = tests
        .iter()
        .flat_map(|(_, text)| text.split("#[test]\nfn ").skip(1))
        .filter_map(|rest| rest.split('(').next())
        .collect();
    for number in expected {
        let mark = format!("eq{number:02}_");
        assert!(names.iter().any(|name| name.contains(&mark)), "no test for ({number})");
    }
}

#[test]
fn the_site_holds_the_font_and_the_licences() {
    let font = fs::metadata(site().join("fonts/math.woff")).unwrap().len();
    assert!((20_000..600_000).contains(&font), "the font has {font} bytes");
    assert!(site().join("fonts/math-LICENCE.txt").is_file() && site().join("LICENSE-CC-BY-4.0").is_file());
    let sheets: String = files(site(), ".css").into_iter().map(|(_, css)| css).collect();
    assert!(sheets.contains("fonts/math.woff"));
}

#[test]
fn the_snippets_of_all_pages_run_in_plain_mdbook_test() {
    let tested = mdbook(root(), &["test"]);
    let said = String::from_utf8_lossy(&tested.stderr);
    assert!(tested.status.success(), "{said}");
    let passed = said
        .split("test result: ok. ")
        .nth(1)
        .and_then(|rest| rest.split(' ').next())
        .and_then(|n| n.parse().ok());
    assert!(passed.unwrap_or(0) >= 60, "{said}");
}

/// A small book in the workspace, for the real press and the real mdBook; the page `a.md` is the one given.
fn small_book(name: &str, page: &str) -> PathBuf {
    let folder = folder(name);
    fs::create_dir_all(folder.join("book/theme")).unwrap();
    fs::write(folder.join("LICENSE-CC-BY-4.0"), "licence").unwrap();
    fs::copy(root().join("book.toml"), folder.join("book.toml")).unwrap();
    for sheet in ["press.css", "figures.css"] {
        fs::copy(root().join("book/theme").join(sheet), folder.join("book/theme").join(sheet)).unwrap();
    }
    // Every figure has to be shown somewhere.
    let figures: String =
        press::figures::ALL.iter().map(|figure| format!("\n![A caption.]({})\n", figure.id)).collect();
    fs::write(folder.join("book/SUMMARY.md"), "- [A](a.md)\n- [Figures](figures.md)\n").unwrap();
    fs::write(folder.join("book/a.md"), page).unwrap();
    fs::write(folder.join("book/figures.md"), format!("# Figures\n{figures}")).unwrap();
    folder
}

/// What a run of mdBook says, on both channels.
fn said(run: &Output) -> String {
    String::from_utf8_lossy(&run.stderr).into_owned() + &String::from_utf8_lossy(&run.stdout)
}

/// The files and folders in a folder; none if there is no such folder.
fn names(folder: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect()
}

const GOOD: &str = "# A\n\n$$\nE = mc^2\n$$ {#eq:rest}\n\nSo @eq:rest says; see [figures](figures.md).\n";

#[test]
fn a_small_book_builds_and_after_a_fault_leaves_no_site() {
    let folder = small_book("good", GOOD);
    let site = folder.join("target/book/html");
    let built = mdbook(&folder, &["build"]);
    assert!(built.status.success(), "{}", said(&built));
    assert!(site.join("a.html").is_file() && site.join("fonts/math.woff").is_file());

    // A fault that the preprocessor finds, whether the book is built, tested or checked.
    fs::write(folder.join("book/a.md"), "# A\n\nSee @eq:nothing.\n").unwrap();
    let fault = "error: book/a.md:3: no page defines the label eq:nothing\n";
    let tested = mdbook(&folder, &["test"]);
    assert!(!tested.status.success() && said(&tested).contains(fault), "{}", said(&tested));
    assert!(site.join("a.html").is_file(), "a test touches no site");
    assert!(press::check::check(&folder).unwrap_err().to_string().starts_with(fault));
    let built = mdbook(&folder, &["build"]);
    assert!(!built.status.success() && said(&built).contains(fault), "{}", said(&built));
    assert_eq!(names(&folder.join("target/book")), BTreeSet::from(["press".to_owned()]));
}

#[test]
fn a_fault_of_the_finished_site_leaves_none() {
    let folder = small_book("bad-theme", GOOD);
    fs::create_dir_all(folder.join("theme")).unwrap();
    fs::write(folder.join("theme/head.hbs"), "<script src=\"https://example.org/x.js\"></script>\n").unwrap();
    let built = mdbook(&folder, &["build"]);
    let fault = "error: book/a.md: <script> loads https://example.org/x.js from a network";
    assert!(!built.status.success() && said(&built).contains(fault), "{}", said(&built));
    assert_eq!(names(&folder.join("target/book")), BTreeSet::from(["press".to_owned()]));
}

#[test]
fn who_serves_a_book_with_a_fault_reads_it_at_every_address() {
    let folder = small_book("served", "# A\n\nSee <b>@eq:nothing.\n");
    let site = folder.join("target/book/html");
    fs::create_dir_all(&site).unwrap();
    fs::write(site.join("a.html"), "an older page").unwrap();
    let built = Command::new(program())
        .arg("build")
        .current_dir(&folder)
        .env("MDBOOK_OUTPUT__HTML__LIVE_RELOAD_ENDPOINT", "reload") // as `mdbook serve` sets it
        .stdin(Stdio::null())
        .output()
        .unwrap();
    assert!(!built.status.success());
    assert_eq!(names(&site), ["404.html", "index.html"].map(str::to_owned).into());
    let page = fs::read_to_string(site.join("404.html")).unwrap();
    assert!(page.contains("book/a.md:3: `&lt;b&gt;` is not closed") && page.contains("eq:nothing"), "{page}");
    assert!(page.contains("http-equiv=\"refresh\""), "it asks again");
}

#[test]
fn cargo_book_build_names_the_line_of_a_page_that_mdbook_cannot_read() {
    let folder = small_book("unread", GOOD);
    fs::create_dir_all(folder.join("elsewhere/html")).unwrap();
    fs::remove_file(folder.join("book/figures.md")).unwrap();
    let arguments = ["build", "-d", "elsewhere"].map(str::to_owned);
    let failed = press::command::run(&folder, &arguments).unwrap_err();
    assert_eq!(failed, "error: book/SUMMARY.md:2: there is no page book/figures.md\n1 fault");
    assert_eq!(names(&folder.join("elsewhere")), BTreeSet::new());
}

#[test]
fn a_page_whose_snippets_nobody_tests_fails_build_and_test() {
    let folder = small_book("untested", "# A\n\n```rust\nassert!(false);\n```\n");
    fs::create_dir_all(folder.join("src")).unwrap();
    fs::write(folder.join("src/lib.rs"), "#[doc = include_str!(\"../book/figures.md\")]\n").unwrap();
    for command in ["build", "test"] {
        let run = mdbook(&folder, &[command]);
        let fault = "error: book/SUMMARY.md:1: the snippets of book/a.md would never run";
        assert!(!run.status.success() && said(&run).contains(fault), "{command}: {}", said(&run));
    }
}

#[test]
fn every_page_has_a_title_of_its_own() {
    let mut titles = BTreeSet::new();
    for (path, html) in pages() {
        let title = html.split("<title>").nth(1).and_then(|rest| rest.split("</title>").next());
        let is_copy = path == site().join("index.html"); // of the first page
        if let Some(title) = title.filter(|_| !is_copy) {
            assert!(titles.insert(title.to_owned()), "{}: {title}", path.display());
        }
    }
    assert!(titles.contains("Exercises - The coin toss - Things That Spin"), "{titles:?}");
}

#[test]
fn the_documentation_of_the_library_leads_to_its_sources() {
    let api = files(&site().join("api"), ".html");
    let leading =
        |html: &str| attributes(html, "href").iter().filter(|href| href.contains("src/mechanics/")).count();
    let links: usize = api.iter().map(|(_, html)| leading(html)).sum();
    assert!(links > 1000, "only {links}"); // that they are alive is for the press to say
    assert!(
        site().join("api/src/mechanics/lib.rs.html").is_file() && site().join("api/index.html").is_file()
    );
}

#[test]
fn the_figure_of_the_readme_is_the_books() {
    let committed = include_str!("../../book/speed-and-accuracy/hoop.svg");
    let drawn = press::figures::ALL.iter().find(|figure| figure.id == "fig:speed-hoop").expect("the figure");
    assert!(include_str!("../../README.md").contains("(book/speed-and-accuracy/hoop.svg)"));
    assert!(
        drawn.standalone == committed,
        "draw it again: cargo book figures FOLDER, and copy speed-hoop.svg"
    );
}
