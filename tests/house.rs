//! The walls of the house: what may use what, in the library and between the crates.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, io};

/// The workspace, where it lies now.
fn root() -> PathBuf {
    env::var_os("CARGO_MANIFEST_DIR").expect("Cargo sets it").into()
}

/// Every file of Rust below a folder, in the order of their names.
fn sources(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            found.extend(sources(&path)?);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}

/// The floors of the library from the ground up: the folders and files right below `src`, and the names by which
/// `lib.rs` shows what they hold.
const FLOORS: [&[&str]; 7] = [
    &[
        "numbers",
        "clock",
        "elementary",
        "lanes",
        "quantity",
        "two_part",
        "InvalidQuantity",
        "Rule",
        "measure",
        "sweep",
    ],
    &["special", "conical", "elliptic", "faddeeva"],
    &["integrate"],
    &["error", "Error"],
    &["bodies", "attitude", "euler", "free_rotation", "geometric", "inertia", "rolling"],
    &["scenes"],
    &["motion", "Motion"],
];

/// The names that code takes from a module: the first of a path, and all in a list of imports.
fn taken<'a>(code: &'a str, module: &str) -> impl Iterator<Item = &'a str> {
    let no_name = |c: char| !c.is_alphanumeric() && c != '_';
    code.split(module).skip(1).flat_map(move |rest| {
        let end = if rest.starts_with('{') { rest.find(';') } else { rest.find(no_name) };
        rest[..end.unwrap_or(rest.len())].split(no_name).filter(|name| !name.is_empty())
    })
}

#[test]
fn every_floor_of_the_library_uses_what_is_below_it_and_no_scene_another() {
    let src = root().join("src");
    let mut read = 0;
    for file in sources(&src).unwrap() {
        let below = file.strip_prefix(&src).unwrap().to_str().unwrap().replace('\\', "/");
        let own = below.split(['/', '.']).next().unwrap();
        let Some(floor) = FLOORS.iter().position(|names| names.contains(&own)) else {
            assert_eq!(own, "lib", "{below} stands on no floor");
            continue;
        };
        let text = fs::read_to_string(&file).unwrap();
        let code: Vec<&str> = text.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
        let code = code.join("\n");
        for name in taken(&code, "crate::") {
            let from = FLOORS.iter().position(|names| names.contains(&name));
            assert!(from.is_none_or(|from| from <= floor), "{below} uses {name}, which stands above it");
            read += 1;
        }
        if let Some(scene) = below.strip_prefix("scenes/").and_then(|below| below.split(['/', '.']).next()) {
            for other in taken(&code, "scenes::") {
                assert_eq!(other, scene, "{below}: a scene uses no other");
            }
        }
    }
    assert!(read > 100, "only {read} imports");
}

#[test]
fn the_library_uses_no_crate_of_ours_and_the_press_none_of_the_book() {
    let said = Command::new(env!("CARGO"))
        .args(["metadata", "--no-deps", "--offline", "--format-version=1"])
        .current_dir(root())
        .output()
        .unwrap();
    let metadata: serde_json::Value = serde_json::from_slice(&said.stdout).unwrap();
    let press = root().join("press");
    let text = |value: &serde_json::Value| value.as_str().unwrap_or_default().to_owned();
    let packages = metadata["packages"].as_array().unwrap();
    for package in packages {
        let folder = PathBuf::from(text(&package["manifest_path"])).parent().unwrap().to_owned();
        for dependency in package["dependencies"].as_array().unwrap() {
            let Some(path) = dependency["path"].as_str() else { continue };
            let name = format!("{} uses {}", package["name"], dependency["name"]);
            assert!(folder != root(), "{name}");
            assert!(!folder.starts_with(&press) || Path::new(path).starts_with(&press), "{name}");
        }
    }
    assert!(packages.len() > 8);
    // Nor does a file of the press take in one from outside.
    for file in sources(&press).unwrap() {
        let depth = file.strip_prefix(&press).unwrap().components().count() - 1;
        for line in fs::read_to_string(&file).unwrap().lines() {
            if ["include_", "#[path"].iter().any(|way| line.contains(way)) {
                assert!(line.matches("../").count() <= depth, "{}: {line}", file.display());
            }
        }
    }
}

#[test]
fn the_map_of_the_library_names_every_scene_and_no_chapter_that_is_gone() {
    let read = |file: &str| fs::read_to_string(root().join(file)).unwrap();
    let [library, scenes, summary] = ["src/lib.rs", "src/scenes/mod.rs", "book/SUMMARY.md"].map(read);
    let rows: Vec<&str> = library.lines().filter_map(|line| line.strip_prefix("//! | ")).skip(1).collect();
    for scene in scenes.lines().filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';')) {
        let named = format!("[`scenes::{scene}`]");
        assert!(rows.iter().any(|row| row.contains(&named)), "src/lib.rs: the map has no row for {named}");
    }
    for chapter in rows.iter().filter_map(|row| Some(row.split_once(" | ")?.0)) {
        let is_there = [format!("- [{chapter}]("), format!("- [{chapter}: ")];
        assert!(
            summary.lines().any(|line| is_there.iter().any(|start| line.starts_with(start))),
            "src/lib.rs: the map has a row for {chapter}, which is no chapter of book/SUMMARY.md"
        );
    }
}

/// Whether an example in a file's documentation asserts something.
fn asserts(path: &Path) -> bool {
    let text = fs::read_to_string(path).unwrap();
    let examples =
        text.lines().filter_map(|line| line.trim_start().strip_prefix("//")?.strip_prefix(['/', '!']));
    examples.into_iter().any(|line| line.trim_start().starts_with("assert"))
}

#[test]
fn every_public_module_shows_a_number_in_an_example() {
    let (mut modules, mut without) = (0, Vec::new());
    for file in sources(&root().join("src")).unwrap() {
        let text = fs::read_to_string(&file).unwrap();
        if text.contains("pub fn new(") && !asserts(&file) {
            without.push(format!("{}, where something is made", file.display()));
        }
        if !file.ends_with("mod.rs") && !file.ends_with("lib.rs") {
            continue;
        }
        let folder = file.parent().unwrap();
        for name in text.lines().filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';')) {
            let alone = folder.join(name).with_extension("rs");
            let parts = if alone.exists() { vec![alone] } else { sources(&folder.join(name)).unwrap() };
            modules += 1;
            if !parts.iter().any(|part| asserts(part)) {
                without.push(format!("the module {name}"));
            }
        }
    }
    assert!(without.is_empty(), "no example: {}", without.join("; "));
    assert!(modules > 20, "{modules}");
}

/// Cargo compiles nothing again where a checkout has moved together with its `target`.
#[test]
fn no_program_remembers_where_it_was_compiled() {
    for folder in ["src", "tests", "benches", "press", "book"] {
        for path in sources(&root().join(folder)).unwrap() {
            let text = fs::read_to_string(&path).unwrap();
            for place in ["MANIFEST_DIR", "TARGET_TMPDIR"] {
                let asked = format!("env!(\"CARGO_{place}\")");
                assert!(!text.contains(&asked), "{}: {asked}", path.display());
            }
        }
    }
}

#[test]
fn the_version_and_its_day_are_the_same_wherever_they_stand() {
    let read = |file: &str| fs::read_to_string(root().join(file)).unwrap();
    let after = |text: &str, key: &str| {
        let mut lines = text.lines().filter_map(|line| line.strip_prefix(key));
        lines.next().unwrap_or_else(|| panic!("{key}")).trim_matches(['"', ' ']).to_owned()
    };
    let citation = read("CITATION.cff");
    let [version, day] = ["version:", "date-released:"].map(|key| after(&citation, key));
    assert_eq!(version, env!("CARGO_PKG_VERSION"));
    // Above it may stand what is not released yet.
    let changes = read("CHANGELOG.md");
    let released =
        changes.lines().filter(|line| line.starts_with("## ") && !line.starts_with("## Unreleased"));
    let newest = released.map(|line| &line[3..]).next().unwrap();
    assert!(newest.starts_with(&format!("{version}, {day}")), "{newest}");
    // The page tells people what the file tells programs.
    let page = read("book/cite.md");
    let [title, authors] = ["title:", "  - name:"].map(|key| after(&citation, key));
    let (name, rest) = title.split_once(": ").unwrap();
    let authors = format!("{{{authors}}}");
    for (field, value) in
        [("title", name), ("subtitle", rest), ("author", &authors), ("version", &version), ("date", &day)]
    {
        let line = format!("\n  {field:<8} = {{{value}}},\n");
        assert!(page.contains(&line), "book/cite.md lacks {line}");
    }
    assert!(page.contains(&format!("*{title}*, version {version} ({day}).")), "book/cite.md, in words");
    let plain = [format!("programs, version {version} ({day})}},\n"), format!(" = {{{}}},\n", &day[..4])];
    assert!(plain.iter().all(|words| page.contains(words)), "book/cite.md, for plain BibTeX: {plain:?}");
    let licences = citation.split("license:\n").nth(1).unwrap().lines();
    for licence in licences.map_while(|line| line.strip_prefix("  - ")) {
        let words = licence.replace("CC-BY-", "CC BY ").replace("Apache-", "Apache ");
        assert!(page.contains(&words), "book/cite.md does not name {words}");
    }
}

/// Licences that ask for no more than their text and a name.
const PERMISSIVE: [&str; 9] =
    ["MIT", "Apache-2.0", "ISC", "Zlib", "BSD-3-Clause", "0BSD", "Unlicense", "Unicode-3.0", "CC-BY-4.0"];

/// Whether an expression such as `(MIT OR Apache-2.0) AND Unicode-3.0` can be met with these licences. Parentheses
/// stand about lists of choices only.
fn can_be_met(expression: &str, licences: &[&str]) -> bool {
    let plain = expression.replace(['(', ')'], "").replace('/', " OR ");
    plain.split(" AND ").all(|part| part.split(" OR ").any(|licence| licences.contains(&licence.trim())))
}

#[test]
fn what_is_built_may_be_used_and_comes_from_one_place() {
    let root = root();
    let registry = "source = \"registry+https://github.com/rust-lang/crates.io-index\"";
    for lock in ["Cargo.lock", "benches/peers/Cargo.lock"] {
        let text = fs::read_to_string(root.join(lock)).unwrap();
        for line in text.lines().filter(|line| line.starts_with("source")) {
            assert_eq!(line, registry, "{lock}");
        }
    }

    let said = |program: &str, arguments: &[&str]| {
        let out = Command::new(program).args(arguments).current_dir(&root).output().ok()?;
        out.status.success().then(|| String::from_utf8(out.stdout).unwrap())
    };
    let version = said("rustc", &["-vV"]).unwrap();
    let host = version.lines().find_map(|line| line.strip_prefix("host: ")).unwrap();
    // Without the network, as all that was built is here; or with it, where more is asked for.
    let arguments = ["metadata", "--format-version=1", "--locked", "--filter-platform", host];
    let offline = [&arguments[..], &["--offline"]].concat();
    let Some(metadata) = said(env!("CARGO"), &offline).or_else(|| said(env!("CARGO"), &arguments)) else {
        eprintln!("skipped: cargo has not all packages here, and cannot ask for them");
        return;
    };
    let metadata: serde_json::Value = serde_json::from_str(&metadata).unwrap();
    let packages = metadata["packages"].as_array().unwrap();
    assert!(packages.len() > 50);
    // Those that are not ours.
    for package in packages.iter().filter(|package| !package["source"].is_null()) {
        let (name, licence) = (&package["name"], package["license"].as_str().unwrap_or_default());
        // mdBook makes the pages and is no part of the library: its licence asks that changes of its files be shown.
        let mdbook = name.as_str().is_some_and(|name| name.starts_with("mdbook-"));
        let allowed = if mdbook { &["MPL-2.0"][..] } else { &PERMISSIVE };
        assert!(can_be_met(licence, allowed), "{name}: {licence}");
    }
}
