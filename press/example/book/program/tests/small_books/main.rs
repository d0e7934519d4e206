//! Small books: what the press makes of one, from its first fault to the site that plain mdBook prints of it, too.

mod served;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::{env, fs};

const BOOK: &str = env!("CARGO_BIN_EXE_pendulum-book");

/// The example, where it lies now.
fn example() -> PathBuf {
    let package = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("Cargo sets it"));
    package.ancestors().nth(2).expect("the package lies two folders down").to_owned()
}

/// The workspace.
fn root() -> PathBuf {
    let example = example();
    let workspace = |folder: &&Path| folder.join("Cargo.lock").is_file();
    example.ancestors().find(workspace).expect("a workspace has a lock file").to_owned()
}

/// `cargo book` in a folder. Scenes stand still, as each folder would compile their module, and all that it is made of,
/// for itself: a test that needs it takes [`live`].
fn program(folder: &Path) -> Command {
    let mut program = Command::new(BOOK);
    program.current_dir(folder).stdin(Stdio::null()).env("BOOK_LIVE", "static");
    program
}

/// The same with scenes that move, if anything here can compile them.
fn live(folder: &Path) -> Command {
    let mut program = program(folder);
    program.env("BOOK_LIVE", env::var_os("BOOK_LIVE").unwrap_or_else(|| "auto".into()));
    program
}

/// One run of `cargo book`.
fn book(folder: &Path, arguments: &[&str]) -> Output {
    program(folder).args(arguments).output().expect("it runs")
}

/// A folder for one test, emptied; inside the workspace, so that Cargo finds the press from there.
fn folder(name: &str) -> PathBuf {
    let folder = root().join("target/tests/small").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// A small book with the figure and the scene of the example; the page `a.md` is the one given.
fn small_book(name: &str, page: &str) -> PathBuf {
    let folder = folder(name);
    fs::copy(example().join("book.toml"), folder.join("book.toml")).unwrap();
    for (file, text) in [
        ("book/SUMMARY.md", "- [A](a.md)\n- [Figures](figures.md)\n- [Pendulum](pendulum/index.md)\n"),
        ("book/a.md", page),
        ("book/figures.md", "# Figures\n\n![A caption.](fig:swing)\n\n![A caption.](fig:period)\n"),
        ("book/pendulum/index.md", "# Pendulum\n\n![A caption.](scene:pendulum)\n"),
    ] {
        write(&folder.join(file), text);
    }
    folder
}

/// Writes a file of a small book, and the folders that it lies in.
fn write(file: &Path, text: &str) {
    fs::create_dir_all(file.parent().unwrap()).unwrap();
    fs::write(file, text).unwrap();
}

/// All files below a folder whose content may come and go, by their paths in it.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    for name in names(folder) {
        let path = folder.join(&name);
        if path.is_dir() {
            found.extend(files(&path).into_iter().map(|(below, bytes)| (format!("{name}/{below}"), bytes)));
        } else if let Ok(bytes) = fs::read(path) {
            found.insert(name, bytes);
        }
    }
    found
}

/// The files of a site, each with its length.
fn lengths(site: &Path) -> BTreeMap<String, usize> {
    files(site).into_iter().map(|(name, bytes)| (name, bytes.len())).collect()
}

/// What a run of mdBook says, on both channels.
fn said(run: &Output) -> String {
    String::from_utf8_lossy(&run.stderr).into_owned() + &String::from_utf8_lossy(&run.stdout)
}

/// The files and folders in a folder; none if there is no such folder.
fn names(folder: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned()).collect()
}

/// Builds a book, as it must be possible; what is said.
#[track_caller]
fn built(folder: &Path) -> String {
    let run = book(folder, &["build"]);
    assert!(run.status.success(), "{}", said(&run));
    said(&run)
}

/// Does what must fail with these words.
#[track_caller]
fn fails(folder: &Path, arguments: &[&str], words: &str) {
    let run = book(folder, arguments);
    assert!(!run.status.success() && said(&run).contains(words), "{}", said(&run));
}

const GOOD: &str = "# A\n\n$$\nE = mc^2\n$$ {#eq:rest}\n\nSo @eq:rest says; see [figures](figures.md).\n";

#[test]
fn a_small_book_builds_and_after_a_fault_leaves_no_site() {
    let folder = small_book("good", GOOD);
    let site = folder.join("target/book/html");
    built(&folder);
    assert!(site.join("a.html").is_file() && site.join("fonts").is_dir());

    // A fault that the preprocessor finds, whether the book is built, tested or checked.
    write(&folder.join("book/a.md"), "# A\n\nSee @eq:nothing.\n");
    let fault = "error: book/a.md:3: no page defines the label eq:nothing\n";
    fails(&folder, &["test"], fault);
    assert!(site.join("a.html").is_file(), "a test touches no site");
    fails(&folder, &["check"], fault);
    fails(&folder, &["build"], fault);
    assert_eq!(names(&folder.join("target/book")), BTreeSet::new());
}

#[test]
fn a_fault_of_the_finished_site_leaves_none() {
    let folder = small_book("bad-theme", GOOD);
    let config = fs::read_to_string(folder.join("book.toml")).unwrap();
    write(&folder.join("book.toml"), &config.replace("# theme = ", "theme = "));
    write(&folder.join("book/theme/head.hbs"), "<script src=\"https://example.org/x.js\"></script>\n");
    fails(&folder, &["build"], "error: book/a.md: <script> loads https://example.org/x.js from a network");
    assert_eq!(names(&folder.join("target/book")), BTreeSet::new());
}

#[cfg(unix)]
#[test]
fn a_picture_stands_on_its_page_and_goes_into_an_epub() {
    let folder = small_book("picture", "# A\n\n![A cat](cat.png)\n");
    fails(&folder, &["check"], "book/a.md:3: there is no picture cat.png: its path is");
    write(&folder.join("book/cat.png"), "any bytes");
    built(&folder);
    let page = fs::read_to_string(folder.join("target/book/html/a.html")).unwrap();
    assert!(page.contains("<p><img src=\"cat.png\" alt=\"A cat\"></p>"), "{page}");
    assert!(book(&folder, &["epub", "b.epub"]).status.success());
    let epub = fs::read(folder.join("b.epub")).unwrap();
    assert!(epub.windows(12).any(|name| name == b"book/cat.png"));
}

#[test]
fn a_site_is_whole_or_absent_whenever_its_build_is_killed() {
    use std::os::unix::process::CommandExt as _;
    let folder = small_book("killed", GOOD);
    let site = folder.join("target/book/html");
    built(&folder);
    let whole = lengths(&site);
    let mut absent = 0;
    for part in 0..12 {
        fs::remove_dir_all(folder.join("target/book")).unwrap();
        let mut build = program(&folder)
            .arg("build")
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .process_group(0)
            .spawn()
            .unwrap();
        // With all that it has started, when so many files are there, or when it is done.
        let made = || files(&folder.join("target/book")).len();
        while build.try_wait().unwrap().is_none() && made() <= whole.len() * part / 10 {}
        let group = format!("-{}", build.id());
        let _ = Command::new("kill").args(["-KILL", "--", &group]).stderr(Stdio::null()).status();
        build.wait().unwrap();
        absent += usize::from(!site.exists());
        assert!(!site.exists() || lengths(&site) == whole, "part {part}: {} files", lengths(&site).len());
    }
    assert!(absent > 4, "only {absent} of the builds were killed in the middle");
    built(&folder);
    assert_eq!(lengths(&site), whole);
    assert_eq!(names(&folder.join("target/book")), BTreeSet::from(["html".to_owned()]));
}

#[test]
fn the_site_goes_where_book_toml_says_but_not_among_the_pages() {
    let folder = small_book("build-dir", GOOD);
    let config = fs::read_to_string(folder.join("book.toml")).unwrap();
    let to = |place: &str| {
        let place = format!("build-dir = \"{place}\"");
        write(&folder.join("book.toml"), &config.replace("build-dir = \"target/book\"", &place));
    };
    to("out");
    let told = format!("The site is in {}", folder.join("out/html").display());
    assert!(built(&folder).contains(&told));
    assert!(folder.join("out/html/a.html").is_file() && !folder.join("target/book").exists());
    for place in ["book", "book/out", "./book"] {
        to(place);
        let told = format!("the site cannot go into {place}, because the pages lie there");
        fails(&folder, &["build"], &told);
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
    // Of the example, as one module is compiled for it then, and not another for this test.
    let (folder, example) = (folder("plain"), example());
    let [ours, theirs] = ["ours", "theirs"].map(|name| folder.join(name));
    assert!(live(&example).args(["build", "-d"]).arg(&ours).status().unwrap().success());
    // As `cargo book` is called there: the workspace has other books. (By its package alone the press would be compiled again.)
    let command = "cargo run --manifest-path ../../Cargo.toml --bin pendulum-book --";
    let mdbook = |arguments: &[&str]| {
        let mut program = Command::new("mdbook");
        program.args(arguments).current_dir(&example);
        program.env("MDBOOK_PREPROCESSOR__PRESS__COMMAND", command).output().unwrap()
    };
    let plain = mdbook(&["build", "-d", theirs.to_str().unwrap()]);
    assert!(plain.status.success(), "{}", said(&plain));
    let [ours, theirs] = [ours, theirs].map(|site| files(&site.join("html")));
    let tested = mdbook(&["test"]);
    assert!(tested.status.success(), "{}", said(&tested));
    // Only the name of the search's index may differ: in it is a sum over what mdBook's own index held.
    let [ours, theirs] = [ours, theirs].map(|site| {
        let index = site.keys().find_map(|name| name.strip_prefix("searchindex-")).unwrap().to_owned();
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
    let failed = book(&folder, &["build", "-d", "elsewhere"]);
    assert_eq!(said(&failed), "error: book/SUMMARY.md:2: there is no page book/figures.md\n1 fault\n");
    assert_eq!(names(&folder.join("elsewhere")), BTreeSet::new());
}

#[test]
fn a_book_without_its_solutions_has_none_and_nothing_leads_to_them() {
    let exercise = "# A\n\n## The drum {#ex:drum}\n\n*Check · 5 minutes*\n\nWhy? See @sol:drum.\n\n\
                    <details>\n<summary>Hint</summary>\n\nThink.\n\n</details>\n";
    let folder = small_book("without-solutions", exercise);
    let summary = fs::read_to_string(folder.join("book/SUMMARY.md")).unwrap();
    write(&folder.join("book/SUMMARY.md"), &(summary + "- [Answers](answers.md)\n"));
    write(&folder.join("book/answers.md"), "# Answers\n\n## {#sol:drum}\n\nBecause it turns.\n");
    let site = folder.join("target/book/html");
    let page = || fs::read_to_string(site.join("a.html")).unwrap();
    built(&folder);
    assert!(site.join("answers.html").is_file() && page().matches("answers.html#sol-drum").count() == 1);
    let unfolds =
        page().split("<summary>Solution</summary>").any(|rest| rest.trim_start().starts_with("<p>Because"));
    assert!(unfolds, "it unfolds below its exercise: {}", page());

    let config = fs::read_to_string(folder.join("book.toml")).unwrap();
    let set = |line: &str| {
        let line = format!("[preprocessor.press]\n{line}\n");
        write(&folder.join("book.toml"), &config.replace("[preprocessor.press]\n", &line));
    };
    set("solutions = false");
    built(&folder);
    assert!(!site.join("answers.html").exists() && page().contains("The drum"));
    for (file, html) in files(&site).into_iter().filter(|(name, _)| name.ends_with(".html")) {
        let html = String::from_utf8(html).unwrap();
        assert!(!html.contains("answers.html") && !html.contains("Because it turns"), "{file}");
    }
    set("solutions = 3");
    fails(&folder, &["build"], "preprocessor.press.solutions of book.toml is true or false");
}

#[test]
fn mdbook_test_runs_the_snippets_and_says_which_fails() {
    // A workspace of its own, in which two tiny crates stand for the library and for all pages.
    let folder = small_book("tested", GOOD);
    for (name, below, more) in
        [("pendulum-snippets", "", "[workspace]\nmembers = [\"lib\"]\n"), ("pendulum", "lib", "")]
    {
        let manifest = format!("[package]\nname = \"{name}\"\nedition = \"2024\"\n{more}");
        write(&folder.join(below).join("Cargo.toml"), &manifest);
        write(&folder.join(below).join("src/lib.rs"), "");
    }
    let test =
        || program(&folder).arg("test").env("MDBOOK_PREPROCESSOR__PRESS__COMMAND", BOOK).output().unwrap();
    for (sum, outcome) in [(4, "test result: ok. 1 passed"), (5, "snippets fail")] {
        let snippet = format!("//! ```\n//! assert_eq!(2 + 2, {sum});\n//! ```\n");
        write(&folder.join("src/lib.rs"), &snippet);
        let run = test();
        assert!(run.status.success() == (sum == 4) && said(&run).contains(outcome), "{}", said(&run));
    }
    write(&folder.join("lib/Cargo.toml"), "[package]\nname = \"pendulum\"\n[lib]\nname = \"swing\"\n");
    let run = test();
    let told = "no package of the project has a library called `pendulum`";
    assert!(!run.status.success() && said(&run).contains(told), "{}", said(&run));
}

#[test]
fn the_example_is_printed_with_all_that_the_press_can_do() {
    let site = folder("example");
    let built = live(&example()).args(["build", "-d"]).arg(&site).output().unwrap();
    assert!(built.status.success(), "{}", said(&built));
    let site = site.join("html");
    let page = |name: &str| fs::read_to_string(site.join(name)).expect(name);
    for (name, wanted) in [
        (
            "pendulum/index.html",
            &[
                "<math",
                "id=\"eq-pendulum-period\"",
                "(1.2)",
                "id=\"fig-period\"",
                "Figure 1.1",
                "class=\"note\"",
                "id=\"scene-pendulum\"",
                "// → 2.146 s",
                "api/pendulum/struct.Pendulum.html",
                "api/src/pendulum/lib.rs.html#",
            ][..],
        ),
        ("about.html", &["href=\"pendulum/index.html#eq-pendulum-period\"", "(1.2)", "The Pendulum"]),
        (
            "404.html",
            &["<base href=\"/\">", "href=\"pendulum/index.html\"", "href=\"about.html\">About this book"],
        ),
        ("clock/index.html", &["href=\"../pendulum/index.html#fig-period\"", "(2.1)", "41.1"]),
    ] {
        let html = page(name);
        wanted.iter().for_each(|text| assert!(html.contains(text), "{name} lacks {text}"));
    }
    assert!(site.join("api/pendulum/struct.Pendulum.html").is_file());
    for (name, bytes) in files(&site) {
        let ending = name.rsplit('.').next().unwrap();
        assert!(!["rs", "toml"].contains(&ending), "{name}: programs are no part of a site");
        let html = String::from_utf8_lossy(&bytes);
        let claims = ["Text and figures", "Creative Commons", "rel=\"license\""];
        let is_claimed =
            ending == "html" && !name.starts_with("api/") && claims.iter().any(|claim| html.contains(claim));
        assert!(!is_claimed, "{name}: its book.toml names no licence");
    }
}

#[test]
fn a_new_book_depends_on_the_press_and_holds_no_copy_of_it() {
    let folder = folder("new");
    let by_path = folder.join("by-path");
    let run = book(&example(), &["new", by_path.to_str().unwrap()]);
    assert!(run.status.success(), "{}", said(&run));
    assert_eq!(
        names(&by_path),
        BTreeSet::from(
            [".cargo", ".gitignore", "Cargo.lock", "Cargo.toml", "book", "book.toml", "src"]
                .map(str::to_owned)
        )
    );
    // All files of the example are there, and Cargo understands the whole.
    for entry in ["book", "src"] {
        let (ours, mut wanted) = (files(&by_path.join(entry)), files(&example().join(entry)));
        wanted.retain(|name, _| !name.contains("tests/"));
        assert_eq!(ours, wanted, "{entry}");
    }
    let resolved = Command::new(env!("CARGO"))
        .args(["tree", "--offline", "--workspace"])
        .current_dir(&by_path)
        .stdin(Stdio::null())
        .output()
        .unwrap();
    assert!(resolved.status.success(), "{}", said(&resolved));
    let again = book(&example(), &["new", by_path.to_str().unwrap()]);
    assert!(said(&again).contains("the folder is not empty"), "{}", said(&again));

    let by_git = folder.join("by-git");
    let address = "https://example.org/spin.git";
    let run = book(&example(), &["new", by_git.to_str().unwrap(), "--git", address]);
    assert!(run.status.success(), "{}", said(&run));
    let manifest = fs::read_to_string(by_git.join("Cargo.toml")).unwrap();
    assert!(
        manifest.contains(&format!("press = {{ git = \"{address}\" }}\n"))
            && !manifest.contains("path = \"/"),
        "{manifest}"
    );
}
