//! Small books: what the press makes of one, from its first fault to the site that plain mdBook prints of it, too.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{Read as _, Write as _};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;
use std::{env, fs, thread};

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

/// One run of `cargo book`.
fn book(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(BOOK).args(arguments).current_dir(folder).stdin(Stdio::null()).output().expect("it runs")
}

/// A folder for one test, emptied; inside the workspace, so that Cargo finds the press from there.
fn folder(name: &str) -> PathBuf {
    let folder = root().join("target/tests/small").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
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

/// A small book with the figure and the scene of the example; the page `a.md` is the one given.
fn small_book(name: &str, page: &str) -> PathBuf {
    let folder = folder(name);
    fs::copy(example().join("book.toml"), folder.join("book.toml")).unwrap();
    for (file, text) in [
        ("book/SUMMARY.md", "- [A](a.md)\n- [Figures](figures.md)\n- [Pendulum](pendulum/index.md)\n"),
        ("book/a.md", page),
        ("book/figures.md", "# Figures\n\n![A caption.](fig:period)\n"),
        ("book/pendulum/index.md", "# Pendulum\n\n![A caption.](scene:pendulum)\n"),
    ] {
        let file = folder.join(file);
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, text).unwrap();
    }
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
    let built = book(&folder, &["build"]);
    assert!(built.status.success(), "{}", said(&built));
    assert!(site.join("a.html").is_file() && site.join("fonts").is_dir());

    // A fault that the preprocessor finds, whether the book is built, tested or checked.
    fs::write(folder.join("book/a.md"), "# A\n\nSee @eq:nothing.\n").unwrap();
    let fault = "error: book/a.md:3: no page defines the label eq:nothing\n";
    let tested = book(&folder, &["test"]);
    assert!(!tested.status.success() && said(&tested).contains(fault), "{}", said(&tested));
    assert!(site.join("a.html").is_file(), "a test touches no site");
    let checked = book(&folder, &["check"]);
    assert!(!checked.status.success() && said(&checked).starts_with(fault), "{}", said(&checked));
    let built = book(&folder, &["build"]);
    assert!(!built.status.success() && said(&built).contains(fault), "{}", said(&built));
    assert_eq!(names(&folder.join("target/book")), BTreeSet::new());
}

#[test]
fn a_fault_of_the_finished_site_leaves_none() {
    let folder = small_book("bad-theme", GOOD);
    let config = fs::read_to_string(folder.join("book.toml")).unwrap();
    fs::write(folder.join("book.toml"), config.replace("# theme = ", "theme = ")).unwrap();
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
        let mut build = Command::new(BOOK)
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
    let server = Command::new(BOOK)
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
    // By another process: what this one writes cannot be run while some thread starts a third.
    let write =
        "echo '#!/bin/sh' | tee rustup > rustc; echo 'echo $* >> asked; exit 1' >> rustup; chmod 755 rust*";
    assert!(Command::new("sh").args(["-c", write]).current_dir(&programs).status().unwrap().success());
    let path = env::var_os("PATH").unwrap();
    let path = env::join_paths([programs].into_iter().chain(env::split_paths(&path))).unwrap();
    let mut command = Command::new(BOOK);
    command.args(arguments).current_dir(folder).env("PATH", path).stdin(Stdio::null());
    command.env("MDBOOK_PREPROCESSOR__PRESS__COMMAND", BOOK);
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
    // A workspace of its own, in which two tiny crates stand for the library and for all pages.
    let folder = small_book("tested", GOOD);
    for (name, below, more) in
        [("pendulum-snippets", "", "[workspace]\nmembers = [\"lib\"]\n"), ("pendulum", "lib", "")]
    {
        fs::create_dir_all(folder.join(below).join("src")).unwrap();
        let manifest = format!("[package]\nname = \"{name}\"\nedition = \"2024\"\n{more}");
        fs::write(folder.join(below).join("Cargo.toml"), manifest).unwrap();
        fs::write(folder.join(below).join("src/lib.rs"), "").unwrap();
    }
    for (sum, outcome) in [(4, "test result: ok. 1 passed"), (5, "snippets fail")] {
        fs::write(folder.join("src/lib.rs"), format!("//! ```\n//! assert_eq!(2 + 2, {sum});\n//! ```\n"))
            .unwrap();
        let run = Command::new(BOOK)
            .arg("test")
            .current_dir(&folder)
            .env("MDBOOK_PREPROCESSOR__PRESS__COMMAND", BOOK)
            .stdin(Stdio::null())
            .output()
            .unwrap();
        assert!(run.status.success() == (sum == 4) && said(&run).contains(outcome), "{}", said(&run));
    }
}

#[test]
fn the_example_is_printed_with_all_that_the_press_can_do() {
    let site = folder("example");
    let built = book(&example(), &["build", "-d", site.to_str().unwrap()]);
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
        ("clock/index.html", &["href=\"../pendulum/index.html#fig-period\"", "(2.1)", "41.1"]),
    ] {
        let html = page(name);
        wanted.iter().for_each(|text| assert!(html.contains(text), "{name} lacks {text}"));
    }
    assert!(site.join("api/pendulum/struct.Pendulum.html").is_file());
    for name in ["index.html", "about.html", "pendulum/index.html"] {
        let claims = ["Text and figures", "Creative Commons", "rel=\"license\""];
        assert!(
            !claims.iter().any(|claim| page(name).contains(claim)),
            "{name}: its book.toml names no licence"
        );
    }
    assert_eq!(files(&site, ".rs"), [], "programs are no part of a site");
    assert_eq!(files(&site, ".toml"), []);
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
    let mut ours = BTreeMap::new();
    all(&by_path, "", &mut ours);
    for entry in ["book", "src"] {
        let mut wanted = BTreeMap::new();
        all(&example().join(entry), &format!("/{entry}"), &mut wanted);
        wanted.retain(|name, _| !name.contains("/tests/"));
        assert!(wanted.iter().all(|(name, text)| ours.get(name) == Some(text)), "{entry}");
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
