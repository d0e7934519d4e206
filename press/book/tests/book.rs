//! The built book: what mdBook and the press make of the pages, checked from outside.

#[path = "browser/scenes.rs"]
mod browser;
#[path = "book/contrast.rs"]
mod contrast;
#[path = "book/key.rs"]
mod key;
#[path = "../src/scenes.rs"]
mod scenes;
#[path = "book/vision.rs"]
mod vision;

use press::rendered::Rendered;
use std::collections::{BTreeMap, BTreeSet};
use std::io::{Read as _, Write as _};
use std::net::{TcpListener, TcpStream};
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

/// The figures as the build script has drawn them, and the scenes.
fn drawn() -> &'static Rendered {
    static DRAWN: OnceLock<Rendered> = OnceLock::new();
    DRAWN.get_or_init(|| {
        let drawn = Rendered::read(Path::new(env!("OUT_DIR"))).expect("they are there");
        Rendered { scenes: scenes::all().expect("they can be drawn"), ..drawn }
    })
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
    let script = fs::read_to_string(root().join("book/theme/numbers.js")).unwrap();
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
        let weight = packed(&html) + loaded + weight_of_fonts();
        assert!(loaded > 50_000 || !html.contains("<main"), "{}: it loads only {loaded}", path.display());
        assert!(weight < 500 * 1024, "{}: {weight} bytes on a first visit", path.display());
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
    assert_eq!(shown, 2 * drawn().scenes.len(), "each on its page and on print.html");
    // Without a compiler for it there is none, and where it is required there is no site then.
    let script = packed(&script("scenes").expect("the script of the scenes"));
    for (path, module) in modules {
        let (module, name) = (packed(&module), path.file_name().unwrap().display());
        eprintln!("{name}: {module} bytes, and its script: {script} bytes, both as they travel");
        assert!(module + script < 150 * 1024, "{name}: {module} + {script} bytes");
    }
}

#[test]
fn the_site_holds_no_programs_of_figures_and_scenes() {
    assert_eq!(
        files(site(), ".rs").into_iter().map(|(path, _)| path).collect::<Vec<_>>(),
        Vec::<PathBuf>::new()
    );
}

#[test]
fn the_search_finds_words_of_pages_and_is_small() {
    let (_, index) = files(site(), ".js")
        .into_iter()
        .find(|(path, _)| path.file_name().unwrap().to_string_lossy().starts_with("searchindex"))
        .expect("the index");
    assert!(packed(&index) < 250 * 1024, "{} bytes of index", packed(&index));
    assert!(index.contains("Dzhanibekov") && index.contains("ω0"), "words, names and letters");
    assert!(!index.contains("assert!") && !index.contains("ω 0"), "no code, no formula in pieces");
}

#[test]
fn every_page_asks_early_for_the_face_of_its_text() {
    for (path, html) in pages().iter().filter(|(_, html)| html.contains("<main")) {
        let early = html.split("<link rel=\"preload\" ").nth(1).and_then(|rest| rest.split('>').next());
        assert!(early.is_some_and(|link| link.contains("libertinus-serif-regular")), "{}", path.display());
    }
}

/// A small book in the workspace, for the real press and the real mdBook; the page `a.md` is the one given.
fn small_book(name: &str, page: &str) -> PathBuf {
    let folder = folder(name);
    fs::write(folder.join("LICENSE-CC-BY-4.0"), "licence").unwrap();
    fs::copy(root().join("book.toml"), folder.join("book.toml")).unwrap();
    copy(&root().join("book/theme"), &folder.join("book/theme"));
    // Every figure has to be shown somewhere, and every scene opens its chapter.
    let figures: String =
        drawn().figures.iter().map(|figure| format!("\n![A caption.]({})\n", figure.id)).collect();
    // The frontispiece leads to the chapters.
    let mut chapters: BTreeSet<&str> = drawn().figures.iter().map(|figure| figure.chapter.as_str()).collect();
    chapters.extend(drawn().scenes.iter().map(|scene| scene.chapter.as_str()));
    let mut summary = "- [A](a.md)\n- [Figures](figures.md)\n".to_owned();
    for chapter in chapters.iter().filter(|chapter| !chapter.is_empty()) {
        summary += &format!("- [{chapter}]({chapter}/index.md)\n");
        fs::create_dir_all(folder.join("book").join(chapter)).unwrap();
        let scenes = drawn().scenes.iter().filter(|scene| scene.chapter == *chapter);
        let scenes: String = scenes.map(|scene| format!("\n![A caption.](scene:{})\n", scene.name)).collect();
        fs::write(folder.join("book").join(chapter).join("index.md"), format!("# {chapter}\n{scenes}"))
            .unwrap();
    }
    fs::write(folder.join("book/SUMMARY.md"), summary).unwrap();
    fs::write(folder.join("book/a.md"), page).unwrap();
    fs::write(folder.join("book/figures.md"), format!("# Figures\n{figures}")).unwrap();
    folder
}

/// Copies a folder with all that is in it.
fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for name in names(from) {
        let (from, to) = (from.join(&name), to.join(&name));
        if from.is_dir() {
            copy(&from, &to);
        } else {
            fs::copy(from, to).unwrap();
        }
    }
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
    let built = book(&folder, &["build"]);
    assert!(built.status.success(), "{}", said(&built));
    assert!(site.join("a.html").is_file() && site.join("fonts").is_dir());

    // A fault that the preprocessor finds, whether the book is built, tested or checked.
    fs::write(folder.join("book/a.md"), "# A\n\nSee @eq:nothing.\n").unwrap();
    let fault = "error: book/a.md:3: no page defines the label eq:nothing\n";
    let tested = book(&folder, &["test"]);
    assert!(!tested.status.success() && said(&tested).contains(fault), "{}", said(&tested));
    assert!(site.join("a.html").is_file(), "a test touches no site");
    assert!(press::check::check(&folder, drawn()).unwrap_err().to_string().starts_with(fault));
    let built = book(&folder, &["build"]);
    assert!(!built.status.success() && said(&built).contains(fault), "{}", said(&built));
    assert_eq!(names(&folder.join("target/book")), BTreeSet::new());
}

#[test]
fn a_fault_of_the_finished_site_leaves_none() {
    let folder = small_book("bad-theme", GOOD);
    fs::create_dir_all(folder.join("book/theme")).unwrap();
    fs::write(folder.join("book/theme/head.hbs"), "<script src=\"https://example.org/x.js\"></script>\n")
        .unwrap();
    let built = book(&folder, &["build"]);
    let fault = "error: book/a.md: <script> loads https://example.org/x.js from a network";
    assert!(!built.status.success() && said(&built).contains(fault), "{}", said(&built));
    assert_eq!(names(&folder.join("target/book")), BTreeSet::new());
}

#[cfg(unix)]
#[test]
fn a_site_is_whole_or_absent_whenever_its_build_is_killed() {
    use std::os::unix::process::CommandExt as _;
    let folder = small_book("killed", GOOD);
    let site = folder.join("target/book/html");
    assert!(book(&folder, &["build"]).status.success());
    let whole = files_of(&site);
    let mut absent = 0;
    for part in 0..12 {
        fs::remove_dir_all(folder.join("target/book")).unwrap();
        let mut build = Command::new(env!("CARGO_BIN_EXE_book"))
            .arg("build")
            .current_dir(&folder)
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .process_group(0)
            .spawn()
            .unwrap();
        // With all that it has started, when so many files are there, or when it is done.
        let made = || count(&folder.join("target/book"));
        while build.try_wait().unwrap().is_none() && made() <= whole.len() * part / 10 {}
        let group = format!("-{}", build.id());
        let _ = Command::new("kill").args(["-KILL", "--", &group]).stderr(Stdio::null()).status();
        build.wait().unwrap();
        absent += usize::from(!site.exists());
        assert!(!site.exists() || files_of(&site) == whole, "part {part}: {} files", files_of(&site).len());
    }
    assert!(absent > 4, "only {absent} of the builds were killed in the middle");
    assert!(book(&folder, &["build"]).status.success() && files_of(&site) == whole);
    assert_eq!(names(&folder.join("target/book")), BTreeSet::from(["html".to_owned()]));
}

/// How many files lie in a folder whose content comes and goes.
fn count(folder: &Path) -> usize {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    entries.map(|path| if path.is_dir() { count(&path) } else { 1 }).sum()
}

/// The files of a site, each with its length.
fn files_of(site: &Path) -> BTreeMap<String, usize> {
    let mut found = BTreeMap::new();
    all(site, "", &mut found);
    found.into_iter().map(|(name, bytes)| (name, bytes.len())).collect()
}

#[test]
fn the_site_goes_where_book_toml_says_but_not_among_the_pages() {
    let folder = small_book("build-dir", GOOD);
    let config = fs::read_to_string(folder.join("book.toml")).unwrap();
    let to = |place: &str| {
        let config = config.replace("build-dir = \"target/book\"", &format!("build-dir = \"{place}\""));
        fs::write(folder.join("book.toml"), config).unwrap();
        book(&folder, &["build"])
    };
    let built = to("out");
    let told = format!("The site is in {}", folder.join("out/html").display());
    assert!(built.status.success() && said(&built).contains(&told), "{}", said(&built));
    assert!(folder.join("out/html/a.html").is_file() && !folder.join("target/book").exists());
    for place in ["book", "book/out", "./book"] {
        let built = to(place);
        let told = format!("the site cannot go into {place}, because the pages lie there");
        assert!(!built.status.success() && said(&built).contains(&told), "{}", said(&built));
    }
}

/// `cargo book serve`, which ends with its test.
struct Server(Child);

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// What the server at an address says to a browser that asks for a page, once it is there.
fn page(address: (&str, u16), path: &str) -> String {
    for _ in 0..600 {
        if let Ok(mut stream) = TcpStream::connect(address) {
            let mut said = String::new();
            stream.set_read_timeout(Some(Duration::from_secs(120))).unwrap();
            write!(stream, "GET {path} HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n").unwrap();
            stream.read_to_string(&mut said).unwrap();
            return said;
        }
        thread::sleep(Duration::from_millis(100));
    }
    panic!("nobody answers");
}

/// Waits for something that is about to happen.
fn until(is_it: impl Fn() -> bool) {
    for _ in 0..600 {
        if is_it() {
            return;
        }
        thread::sleep(Duration::from_millis(100));
    }
    panic!("it does not happen");
}

#[test]
fn who_is_served_a_book_with_a_fault_reads_it_at_every_address_and_then_the_page() {
    let folder = small_book("served", "# A\n\nSee <b>@eq:nothing.\n");
    // A port that is free now.
    let port = TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
    let address = ("127.0.0.1", port);
    let server = Command::new(env!("CARGO_BIN_EXE_book"))
        .args(["serve", "-n", address.0, "-p", &port.to_string()])
        .current_dir(&folder)
        .stdin(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .map(Server)
        .unwrap();
    let bad = page(address, "/a.html");
    let news = page(address, "/__news");
    fs::write(folder.join("book/a.md"), GOOD).unwrap();
    until(|| page(address, "/__news") != news);
    let good = page(address, "/a.html");
    // The page of all pages comes with the rest, and stays as it is while a sentence changes.
    let made = folder.join("target/book");
    until(|| made.join("kept/print.html").is_file());
    browser::open_tabs(&format!("http://{}:{port}/a.html", address.0), 8);
    fs::write(folder.join("book/a.md"), GOOD.replace("So ", "Thus ")).unwrap();
    until(|| page(address, "/a.html").contains("Thus "));
    let all = page(address, "/print.html");
    drop(server);
    assert!(all.starts_with("HTTP/1.1 200") && all.contains("So ") && !all.contains("Thus "));
    assert!(!made.join("html/print.html").exists() && !made.join("next/html").exists());
    assert!(bad.contains("book/a.md:3: `&lt;b&gt;` is not closed") && bad.contains("eq:nothing"), "{bad}");
    assert!(bad.starts_with("HTTP/1.1 404") && bad.contains("http-equiv=\"refresh\""), "it asks again");
    assert!(good.starts_with("HTTP/1.1 200") && good.contains("figures.html"), "{good}");
}

/// `cargo book` in a folder with scenes, where the compiler has no target for browsers, and a rustup that fails.
#[cfg(unix)]
fn without_target(folder: &Path, arguments: &[&str]) -> Command {
    let programs = folder.join("programs");
    fs::create_dir_all(&programs).unwrap();
    fs::create_dir_all(folder.join("press/live/module")).unwrap();
    // By another process: what this one writes cannot be run while some thread starts a third.
    let write =
        "echo '#!/bin/sh' | tee rustup > rustc; echo 'echo $* >> asked; exit 1' >> rustup; chmod 755 rust*";
    assert!(Command::new("sh").args(["-c", write]).current_dir(&programs).status().unwrap().success());
    let path = env::var_os("PATH").unwrap();
    let path = env::join_paths([programs].into_iter().chain(env::split_paths(&path))).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_book"));
    command.args(arguments).current_dir(folder).env("PATH", path).stdin(Stdio::null());
    command.env("MDBOOK_PREPROCESSOR__PRESS__COMMAND", env!("CARGO_BIN_EXE_book"));
    for name in ["BOOK_LIVE", "BOOK_WASM_RUSTC", "RUSTC"] {
        command.env_remove(name);
    }
    command
}

#[cfg(unix)]
#[test]
fn rustup_is_asked_once_for_what_scenes_need_and_where_it_fails_they_stand_still() {
    let folder = small_book("no-target", GOOD);
    let asked = || fs::read_to_string(folder.join("asked")).unwrap_or_default();
    let still = "the scenes of the pages stand still, because the compiler lacks the target";
    let once = "target add wasm32-unknown-unknown\n";
    let built = without_target(&folder, &["build"]).output().unwrap();
    assert!(built.status.success() && said(&built).contains(still), "{}", said(&built));
    assert_eq!(asked(), once);
    let built = without_target(&folder, &["build"]).env("BOOK_LIVE", "static").output().unwrap();
    assert!(built.status.success() && !said(&built).contains(still) && asked() == once, "nobody is asked");
    let built = without_target(&folder, &["build"]).env("BOOK_LIVE", "require").output().unwrap();
    assert!(!built.status.success() && said(&built).contains(still), "{}", said(&built));

    fs::remove_file(folder.join("asked")).unwrap();
    let port = TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
    let address = ("127.0.0.1", port);
    let server = without_target(&folder, &["serve", "-n", address.0, "-p", &port.to_string()])
        .stderr(fs::File::create(folder.join("said")).unwrap())
        .spawn()
        .map(Server)
        .unwrap();
    page(address, "/a.html");
    let is_complete = || fs::read_to_string(folder.join("said")).unwrap().matches("Everything").count();
    until(|| is_complete() == 1);
    for word in ["Thus ", "Hence "] {
        fs::write(folder.join("book/a.md"), GOOD.replace("So ", word)).unwrap();
        until(|| page(address, "/a.html").contains(word));
    }
    fs::write(folder.join("Cargo.toml"), "").unwrap(); // what belongs to a library is made anew
    fs::write(folder.join("book/a.md"), GOOD).unwrap();
    until(|| page(address, "/a.html").contains("So "));
    drop(server);
    let said = fs::read_to_string(folder.join("said")).unwrap();
    assert!(said.matches(still).count() == 1 && asked() == once, "{}\n{said}", asked());
}

/// All files of a built site.
fn all(folder: &Path, below: &str, found: &mut BTreeMap<String, Vec<u8>>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = format!("{below}/{}", path.file_name().unwrap().to_string_lossy());
        if path.is_dir() {
            all(&path, &name, found);
        } else {
            found.insert(name, fs::read(path).unwrap());
        }
    }
}

#[test]
fn plain_mdbook_prints_the_same_site() {
    let version = Command::new("mdbook").arg("--version").output();
    if !version.is_ok_and(|said| String::from_utf8_lossy(&said.stdout).contains("v0.5.")) {
        assert!(env::var_os("CI").is_none(), "`.ci/run` puts mdBook 0.5 on PATH");
        eprintln!("skipped: there is no mdBook 0.5 on PATH");
        return;
    }
    let folder = small_book("plain", GOOD);
    let site = folder.join("target/book/html");
    let mut sites = [BTreeMap::new(), BTreeMap::new()];
    assert!(book(&folder, &["build"]).status.success());
    all(&site, "", &mut sites[0]);
    let plain = Command::new("mdbook").arg("build").current_dir(&folder).output().unwrap();
    assert!(plain.status.success(), "{}", said(&plain));
    all(&site, "", &mut sites[1]);
    let tested = Command::new("mdbook").arg("test").current_dir(&folder).output().unwrap();
    assert!(tested.status.success(), "{}", said(&tested));
    // Only the name of the search's index may differ: in it is a sum over what mdBook's own index held.
    let [ours, theirs] = sites.map(|site| {
        let index = site.keys().find_map(|name| name.strip_prefix("/searchindex-")).unwrap().to_owned();
        let plain = |(name, bytes): (String, Vec<u8>)| {
            let is_text = [".html", ".js"].iter().any(|ending| name.ends_with(ending));
            let text = |bytes| String::from_utf8(bytes).unwrap().replace(&index, "INDEX").into_bytes();
            (name.replace(&index, "INDEX"), if is_text { text(bytes) } else { bytes })
        };
        site.into_iter().map(plain).collect::<BTreeMap<String, Vec<u8>>>()
    });
    assert!(ours.keys().eq(theirs.keys()) && ours.len() > 20);
    let differ: Vec<&String> = ours.keys().filter(|name| ours[*name] != theirs[*name]).collect();
    assert!(differ.is_empty(), "{differ:?}");
}

#[test]
fn cargo_book_build_names_the_line_of_a_page_that_mdbook_cannot_read() {
    let folder = small_book("unread", GOOD);
    fs::create_dir_all(folder.join("elsewhere/html")).unwrap();
    fs::remove_file(folder.join("book/figures.md")).unwrap();
    let arguments = ["build", "-d", "elsewhere"].map(str::to_owned);
    let failed = press::command::run(&folder, &arguments, drawn()).unwrap_err();
    assert_eq!(failed, "error: book/SUMMARY.md:2: there is no page book/figures.md\n1 fault");
    assert_eq!(names(&folder.join("elsewhere")), BTreeSet::new());
}

#[test]
fn a_book_without_its_solutions_has_none_and_nothing_leads_to_them() {
    let exercise = "# A\n\n## The drum {#ex:drum}\n\n*Check · 5 minutes*\n\nWhy? See @sol:drum.\n\n\
                    <details>\n<summary>Hint</summary>\n\nThink.\n\n</details>\n";
    let folder = small_book("without-solutions", exercise);
    let summary = fs::read_to_string(folder.join("book/SUMMARY.md")).unwrap();
    fs::write(folder.join("book/SUMMARY.md"), summary + "- [Answers](answers.md)\n").unwrap();
    fs::write(folder.join("book/answers.md"), "# Answers\n\n## {#sol:drum}\n\nBecause it turns.\n").unwrap();
    let site = folder.join("target/book/html");
    let page = || fs::read_to_string(site.join("a.html")).unwrap();
    let built = book(&folder, &["build"]);
    assert!(built.status.success(), "{}", said(&built));
    assert!(site.join("answers.html").is_file() && page().matches("answers.html#sol-drum").count() == 2);

    let config = fs::read_to_string(folder.join("book.toml")).unwrap();
    let with = |line: &str| {
        let config = config.replace("[preprocessor.press]\n", &format!("[preprocessor.press]\n{line}\n"));
        fs::write(folder.join("book.toml"), config).unwrap();
        book(&folder, &["build"])
    };
    let built = with("solutions = false");
    assert!(built.status.success(), "{}", said(&built));
    assert!(!site.join("answers.html").exists() && page().contains("The drum"));
    for (file, html) in files(&site, ".html") {
        assert!(!html.contains("answers.html") && !html.contains("Because it turns"), "{}", file.display());
    }
    let built = with("solutions = 3");
    assert!(
        said(&built).contains("preprocessor.press.solutions of book.toml is true or false"),
        "{}",
        said(&built)
    );
}

#[test]
fn mdbook_test_runs_the_snippets_and_says_which_fails() {
    // A workspace of its own, so that a tiny crate stands for all pages.
    let folder = small_book("tested", GOOD);
    fs::create_dir_all(folder.join("src")).unwrap();
    fs::write(folder.join("Cargo.toml"), "[package]\nname = \"snippets\"\nedition = \"2024\"\n[workspace]\n")
        .unwrap();
    for (sum, outcome) in [(4, "test result: ok. 1 passed"), (5, "snippets fail")] {
        fs::write(folder.join("src/lib.rs"), format!("//! ```\n//! assert_eq!(2 + 2, {sum});\n//! ```\n"))
            .unwrap();
        let run = Command::new(env!("CARGO_BIN_EXE_book"))
            .arg("test")
            .current_dir(&folder)
            .env("MDBOOK_PREPROCESSOR__PRESS__COMMAND", env!("CARGO_BIN_EXE_book"))
            .stdin(Stdio::null())
            .output()
            .unwrap();
        assert!(run.status.success() == (sum == 4) && said(&run).contains(outcome), "{}", said(&run));
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
    let links: usize = api.iter().map(|(_, html)| html.matches("/src/mechanics/").count()).sum();
    assert!(links > 1000, "only {links}"); // that they are alive is for the press to say
    assert!(
        site().join("api/src/mechanics/lib.rs.html").is_file() && site().join("api/index.html").is_file()
    );
}

#[test]
fn each_entry_of_the_bibliography_leads_back_to_where_it_is_cited() {
    let page = fs::read_to_string(site().join("bibliography.html")).expect("a page");
    let (entries, back) = (page.matches("class=\"cite\"").count(), page.matches("class=\"citing\"").count());
    assert!(entries > 60 && back == entries, "{back} of {entries}");
    assert!(page.contains("<a href=\"coin-toss/index.html#from-bartos-2023-"), "to the very words"); // alive, says the press
}

#[test]
fn an_address_without_page_shows_all_chapters_and_needs_no_other_file() {
    let page = fs::read_to_string(site().join("404.html")).expect("a page");
    assert!(page.matches("<li><a href=").count() > 15 && page.contains("laundromat/index.html"));
    assert!(!page.contains("src=") && !page.contains("<link"), "it would be looked for in the wrong folder");
}

#[test]
fn equations_lead_to_the_code_that_names_them_and_back() {
    let to_code: usize = pages().iter().map(|(_, html)| html.matches("\"code: ").count()).sum();
    let back: usize =
        files(&site().join("api"), ".html").iter().map(|(_, html)| html.matches(".html#eq-").count()).sum();
    assert!(to_code > 200 && back > 400, "{to_code} links to the code, {back} back");
    let page = fs::read_to_string(site().join("laundromat/index.html")).expect("a page");
    let equation = page.split("id=\"eq-natural-frequency\"").nth(1).expect("the equation");
    let marks = equation.split("class=\"code\">").nth(1).expect("its code");
    let target = marks.split('"').nth(1).expect("a link"); // that it is alive is for the press to say
    let file = target.trim_start_matches("../").split('#').next().expect("a file");
    let code = fs::read_to_string(site().join(file)).expect("the code");
    assert!(code.contains("laundromat/index.html#eq-natural-frequency"), "{file}");
}

#[test]
fn every_page_says_what_it_is_about_and_of_which_edition_it_is() {
    let mut descriptions = BTreeSet::new();
    let copies = ["index.html", "print.html", "toc.html"].map(|copy| site().join(copy));
    let pages: Vec<_> = pages().into_iter().filter(|(path, _)| !copies.contains(path)).collect();
    for (path, html) in &pages {
        let description = html
            .split("property=\"og:description\" content=\"")
            .nth(1)
            .and_then(|rest| rest.split('"').next());
        let description = description.unwrap_or_else(|| panic!("{} has none", path.display()));
        assert!(description.len() > 20, "{}: {description}", path.display());
        descriptions.insert(description.to_owned());
        assert!(html.contains(concat!("Things That Spin ", env!("CARGO_PKG_VERSION"))), "{}", path.display());
    }
    assert!(
        pages.len() > 40 && descriptions.len() * 10 > pages.len() * 9,
        "{} of {}",
        descriptions.len(),
        pages.len()
    );
}

#[test]
fn the_figure_of_the_readme_is_the_books() {
    let committed = include_str!("../../../book/speed-and-accuracy/hoop.svg");
    let drawn = drawn().figures.iter().find(|figure| figure.id == "fig:speed-hoop").expect("the figure");
    assert!(include_str!("../../../README.md").contains("(book/speed-and-accuracy/hoop.svg)"));
    assert!(
        drawn.standalone == committed,
        "draw it again: cargo book figures FOLDER, and copy speed-hoop.svg"
    );
}
