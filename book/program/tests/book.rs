//! The built book: what mdBook and the press make of the pages, checked from outside.

#[path = "browser/scenes.rs"]
mod browser;
#[path = "book/contrast.rs"]
mod contrast;
#[path = "book/key.rs"]
mod key;
#[path = "book/vision.rs"]
mod vision;

use pages::scenes::SCENES;
use std::collections::BTreeSet;
use std::io::Write as _;
use std::net::TcpListener;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::sync::{LazyLock, OnceLock};
use std::time::Duration;
use std::{env, fs, thread};

/// The workspace, where it lies now.
fn root() -> &'static Path {
    static ROOT: LazyLock<PathBuf> = LazyLock::new(|| {
        let package = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("Cargo sets it"));
        package.ancestors().nth(2).expect("the package lies two folders down").to_owned()
    });
    &ROOT
}

/// One run of `cargo book`.
fn book(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_book"))
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::null())
        .output()
        .expect("it runs")
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
        let built = book(root(), &["build", "-d", folder.to_str().unwrap()]);
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

/// The pages of the site, without what rustdoc wrote and the one for addresses without page, which needs no other file.
fn pages() -> Vec<(PathBuf, String)> {
    let pages: Vec<_> = files(site(), ".html")
        .into_iter()
        .filter(|(path, _)| !path.starts_with(site().join("api")) && !path.ends_with("404.html"))
        .collect();
    assert!(pages.len() >= 22, "only {} pages", pages.len());
    pages
}

/// The files and folders in a folder.
fn names(folder: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(folder).unwrap();
    entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect()
}

/// The addresses that a style sheet loads, as paths.
fn loads(sheet: &Path, css: &str) -> Vec<PathBuf> {
    let quoted = css.split("url(").skip(1).filter_map(|rest| rest.split(')').next());
    quoted.map(|address| sheet.parent().unwrap().join(address.trim_matches(['"', '\'']))).collect()
}

/// The text of a page outside of code, scripts and drawings, with a digit for each formula.
fn words(html: &str) -> String {
    let mut out = String::new();
    let mut rest = html;
    while let Some((text, tag)) = rest.split_once('<') {
        out.push_str(text);
        let name = tag.split([' ', '>']).next().unwrap_or_default();
        rest = match name {
            "pre" | "code" | "script" | "style" | "svg" | "math" => {
                out.push_str(if name == "math" { "0" } else { "" });
                tag.split_once(&format!("</{name}>")).expect("it is closed").1
            }
            _ => tag.split_once('>').expect("it is closed").1,
        };
    }
    out + rest
}

/// Whether a word is made of units of the SI, each perhaps with a prefix and a power.
fn is_unit(word: &str) -> bool {
    word.split(['/', '·']).all(|part| {
        let part = part.trim_end_matches(['²', '³', '⁻', '¹']);
        let base =
            |name: &str| ["g", "m", "s", "t", "N", "J", "W", "V", "K", "Pa", "Hz", "rad"].contains(&name);
        base(part)
            || ["h", "min", "%"].contains(&part)
            || part.strip_prefix(['n', 'µ', 'm', 'c', 'k', 'M', 'G']).is_some_and(base)
    })
}

#[test]
fn no_number_is_torn_from_its_unit_and_powers_of_ten_have_one_form() {
    let (mut tied, mut torn) = (0, Vec::new());
    for (path, html) in pages() {
        let text = words(&html);
        for (at, blank) in text.match_indices([' ', '\n', '\u{a0}']) {
            let behind = &text[at + blank.len()..];
            let end =
                behind.find(|c: char| !(c.is_alphanumeric() || "/·%⁻".contains(c))).unwrap_or(behind.len());
            if text[..at].ends_with(|c: char| c.is_ascii_digit()) && is_unit(&behind[..end]) {
                if blank == "\u{a0}" {
                    tied += 1;
                } else {
                    torn.push(format!("{}: {blank:?}{}", path.display(), &behind[..end]));
                }
            }
        }
        for other in ["×\u{202f}10", "× 10<", "×10<", "<mo>×</mo><mn>10</mn>"] {
            assert!(
                !html.contains(other),
                "{}: a power of ten is written 1.6·10⁸, not {other}",
                path.display()
            );
        }
    }
    assert!(torn.is_empty() && tied > 500, "{tied} tied, {} torn:\n{}", torn.len(), torn.join("\n"));
    let script = fs::read_to_string(root().join("press/theme/numbers.js")).unwrap();
    assert!(script.contains("·10<sup>") && !script.contains('×'), "the script writes them like the pages");
}

#[test]
fn the_site_holds_the_fonts_that_it_asks_for_and_their_licences() {
    let mut asked = BTreeSet::new();
    for (sheet, css) in files(site(), ".css") {
        if !sheet.starts_with(site().join("api")) {
            let found = loads(&sheet, &css).into_iter().filter(|path| path.extension().is_some());
            asked.extend(
                found.map(|path| fs::canonicalize(&path).unwrap_or_else(|_| panic!("no {}", path.display()))),
            );
        }
    }
    let folder = fs::canonicalize(site().join("fonts")).unwrap();
    let fonts = names(&folder).into_iter().map(|name| folder.join(name));
    let (texts, fonts): (Vec<_>, BTreeSet<_>) = {
        let (fonts, texts) = fonts.partition::<Vec<_>, _>(|path| path.extension().unwrap() == "woff2");
        (texts, fonts.into_iter().collect())
    };
    assert_eq!(asked, fonts, "a style sheet asks for each font, and each is there");
    let licences =
        texts.iter().find(|path| path.to_string_lossy().contains("LICENCES")).expect("the licences");
    let licences = fs::read_to_string(licences).unwrap();
    for family in
        ["Libertinus Serif", "Open Sans", "Book Code", "Book Math", "SIL OPEN FONT LICENSE", "Apache License"]
    {
        assert!(licences.contains(family), "{family}");
    }
    assert!(site().join("LICENSE-CC-BY-4.0.txt").is_file(), "the ending says that it can be read");
    let page = fs::read_to_string(site().join("coin-toss/index.html")).unwrap();
    let link = "<a rel=\"license\" href=\"../LICENSE-CC-BY-4.0.txt\">Text and figures: CC BY 4.0</a>";
    assert!(page.contains(link), "book.toml says so");

    assert!(weight_of_fonts() < 120 * 1024, "{} bytes of fonts", weight_of_fonts());
}

/// All of them, of which no page shows more.
fn weight_of_fonts() -> u64 {
    let folder = site().join("fonts");
    let fonts = names(&folder).into_iter().filter(|name| name.ends_with(".woff2"));
    fonts.map(|name| fs::metadata(folder.join(name)).unwrap().len()).sum()
}

/// What a text weighs on its way to a reader.
fn packed(text: &str) -> u64 {
    let mut packed = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
    packed.write_all(text.as_bytes()).unwrap();
    packed.finish().unwrap().len() as u64
}

#[test]
fn no_page_keeps_its_reader_waiting() {
    for (path, html) in pages() {
        if path == site().join("print.html") {
            continue; // all pages in one
        }
        let attributes = ["<link rel=\"stylesheet\"", "<script src=\""];
        let tags = attributes.iter().flat_map(|start| html.split(start).skip(1));
        let files = tags.map(|rest| {
            let rest = rest
                .split_once("href=\"")
                .filter(|(before, _)| !before.contains('>'))
                .map_or(rest, |(_, rest)| rest);
            path.parent().unwrap().join(rest.split('"').next().unwrap())
        });
        let loaded: u64 = files.map(|file| fs::read_to_string(&file).map_or(0, |text| packed(&text))).sum();
        // A module comes when its scene is near.
        let module = html.split("data-module=\"").nth(1).and_then(|rest| rest.split('"').next());
        let module =
            module.map_or(0, |name| packed(&fs::read_to_string(site().join(name)).expect("a module")));
        let weight = packed(&html) + loaded + module + weight_of_fonts();
        assert!(loaded > 50_000 || !html.contains("<main"), "{}: it loads only {loaded}", path.display());
        assert!(weight < 480_000, "{}: {weight} bytes on a first visit", path.display());
    }
}

/// A script of the site, by the beginning of its name.
fn script(name: &str) -> Option<String> {
    let is_it = |path: &Path| path.file_name().unwrap().to_string_lossy().starts_with(name);
    files(site(), ".js").into_iter().find(|(path, _)| is_it(path)).map(|(_, text)| text)
}

#[test]
fn scenes_weigh_little_and_no_page_waits_for_them() {
    let mut shown = 0;
    let modules: Vec<_> = files(site(), ".js")
        .into_iter()
        .filter(|(path, _)| path.file_name().unwrap().to_string_lossy().starts_with("live-"))
        .collect();
    for (path, html) in pages() {
        shown += html.matches("<figure class=\"scene\"").count();
        let figures = html.split("<figure class=\"scene\"").skip(1);
        let tags = figures.filter_map(|rest| rest.split('>').next());
        let moving = tags.filter(|tag| tag.contains(" data-module=\"live-")).count();
        let panels = html.matches("<div class=\"panel\">").count();
        assert!(moving == panels && (moving == 0 || !modules.is_empty()), "{}", path.display());
        assert!(!html.contains("<script src=\"live-"), "{}: a script asks for it", path.display());
    }
    assert_eq!(shown, 2 * SCENES.len(), "each on its page and on print.html");
    // Without a compiler for it there is none, and where it is required there is no site then.
    let script = packed(&script("scenes").expect("the script of the scenes"));
    for (path, module) in modules {
        let (module, name) = (packed(&module), path.file_name().unwrap().display());
        eprintln!("{name}: {module} bytes, and its script: {script} bytes, both as they travel");
        assert!(module + script < 178_000, "{name}: {module} + {script} bytes");
    }
}

#[test]
fn an_address_without_page_shows_all_chapters_and_needs_no_other_file() {
    let page = fs::read_to_string(site().join("404.html")).expect("a page");
    assert!(page.matches("<li><a href=").count() > 15 && page.contains("laundromat/index.html"));
    assert!(!page.contains("src=") && !page.contains("<link"), "it would be looked for in the wrong folder");
}

#[test]
fn the_head_of_every_page_tells_what_it_is_about_and_what_is_needed_early() {
    let (mut titles, mut descriptions) = (BTreeSet::new(), BTreeSet::new());
    let copies = ["index.html", "print.html", "toc.html"].map(|copy| site().join(copy));
    let pages: Vec<_> = pages().into_iter().filter(|(path, _)| !copies.contains(path)).collect();
    for (path, html) in &pages {
        let path = path.display();
        let between = |start: &str, end: &str| {
            let found = html.split(start).nth(1).and_then(|rest| rest.split(end).next());
            found.unwrap_or_else(|| panic!("{path} has no {start}"))
        };
        let title = between("<title>", "</title>");
        assert!(titles.insert(title), "{path}: {title}");
        let description = between("property=\"og:description\" content=\"", "\"");
        assert!(description.len() > 20, "{path}: {description}");
        descriptions.insert(description);
        assert!(html.contains(concat!("Things That Spin ", env!("CARGO_PKG_VERSION"))), "{path}");
        assert!(between("<link rel=\"preload\" ", ">").contains("libertinus-serif-regular"), "{path}");
    }
    assert!(titles.contains("Exercises - The coin toss - Things That Spin"), "{titles:?}");
    let counts = [pages.len(), descriptions.len()];
    assert!(counts[0] > 40 && counts[1] * 10 > counts[0] * 9, "{counts:?}");
}

#[test]
fn the_search_finds_words_of_pages_and_is_small() {
    let index = script("searchindex").expect("the index");
    // It grows with the text of the book, all of which is on one page too.
    let text = fs::read_to_string(site().join("print.html")).expect("all pages");
    let [index_weight, text_weight] = [&index, &text].map(|text| packed(text));
    assert!(index_weight * 4 < text_weight, "{index_weight} bytes of index for {text_weight} of text");
    assert!(index.contains("Dzhanibekov") && index.contains("ω₀²"), "words, names and letters");
    assert!(
        !index.contains("use mechanics") && !index.contains("println!") && !index.contains("ω 0"),
        "no code, no formula in pieces"
    );
    assert!(files(site(), ".rs").is_empty(), "the site holds no programs of figures and scenes");
}

#[test]
fn equations_lead_to_the_code_that_names_them_and_citations_to_their_entries_and_back() {
    // That links are alive is for the press to say.
    let api = files(&site().join("api"), ".html");
    let count = |pages: &[(PathBuf, String)], link| -> usize {
        pages.iter().map(|(_, html)| html.matches(link).count()).sum()
    };
    let (to_code, back) =
        (count(&pages(), "<span class=\"code\">in the library: "), count(&api, ".html#eq-"));
    assert!(to_code > 150 && back > 400, "{to_code} links to the code, {back} back");
    assert!(count(&api, "/src/mechanics/") > 1000 && site().join("api/index.html").is_file());
    let page = fs::read_to_string(site().join("laundromat/index.html")).expect("a page");
    let equation = page.split("id=\"eq-natural-frequency\"").nth(1).expect("the equation");
    let marks = equation.split("class=\"code\">").nth(1).expect("its code");
    let file = marks.split('"').nth(1).and_then(|link| link.trim_start_matches("../").split('#').next());
    let code = fs::read_to_string(site().join(file.expect("a link"))).expect("the code");
    assert!(code.contains("laundromat/index.html#eq-natural-frequency"), "{file:?}");

    let page = fs::read_to_string(site().join("bibliography.html")).expect("a page");
    let (entries, back) = (page.matches("class=\"cite\"").count(), page.matches("class=\"citing\"").count());
    assert!(entries > 60 && back == entries, "{back} of {entries}");
    assert!(page.contains("<a href=\"coin-toss/index.html#from-bartos-2023-"), "to the very words");
}

#[test]
fn the_figure_of_the_readme_is_the_books() {
    let committed = include_str!("../../speed-and-accuracy/problems.svg");
    let drawn = fs::read_to_string(site().join("figures/speed-problems.svg")).expect("the figure");
    assert!(include_str!("../../../README.md").contains("(book/speed-and-accuracy/problems.svg)"));
    assert!(drawn == committed, "draw it again: cargo book figures FOLDER, and copy speed-problems.svg");
}

/// A program that is ended with its test.
struct Server(Child);

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[test]
fn a_served_book_is_read_in_more_tabs_than_a_browser_has_connections() {
    let folder = folder("tabs");
    let port = TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port().to_string();
    let said = folder.join("said");
    let _server = Command::new(env!("CARGO_BIN_EXE_book"))
        .args(["serve", "-n", "127.0.0.1", "-p", &port, "-d", folder.to_str().unwrap()])
        .current_dir(root())
        .env("BOOK_LIVE", "static")
        .stdin(Stdio::null())
        .stderr(fs::File::create(&said).unwrap())
        .spawn()
        .map(Server)
        .unwrap();
    while !fs::read_to_string(&said).unwrap().contains("The book is at") {
        thread::sleep(Duration::from_millis(50));
    }
    browser::open_tabs(&format!("http://127.0.0.1:{port}/preface.html"), 8);
}
