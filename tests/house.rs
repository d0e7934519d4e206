//! The walls of the library: which room of `src` may use which.

#[path = "../press/figures/src/house.rs"]
#[allow(unreachable_pub, reason = "there it is a public module")]
mod house;

use house::{ROOMS, Source, named, sources};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// The workspace, where it lies now.
fn root() -> PathBuf {
    env::var_os("CARGO_MANIFEST_DIR").expect("Cargo sets it").into()
}

fn library() -> Vec<Source> {
    house::library(&root()).expect("it can be read")
}

#[test]
fn every_room_uses_what_it_may_and_may_use_what_it_uses() {
    let library = library();
    let found = house::rooms(&library);
    let mut below = BTreeSet::new();
    for (room, allowed) in ROOMS {
        let (lines, used) = found.get(room).unwrap_or_else(|| panic!("the library has no room {room}"));
        let allowed: BTreeSet<&str> = allowed.iter().copied().collect();
        let forbidden: Vec<_> = used.difference(&allowed).collect();
        assert!(forbidden.is_empty(), "{room} uses {forbidden:?}, which the table does not permit");
        let idle: Vec<_> = allowed.difference(used).collect();
        assert!(idle.is_empty(), "the table permits {room} to use {idle:?}, and it does not");
        let above: Vec<_> = allowed.difference(&below).collect();
        assert!(above.is_empty(), "{room} may use {above:?}, which stand above it");
        assert!(*lines > 0);
        below.insert(room);
    }
    for source in &library {
        assert!(ROOMS.iter().any(|(room, _)| *room == source.room()), "{} has no room", source.path);
    }
    assert!(library.iter().map(|source| source.imports().len()).sum::<usize>() > 100);
}

#[test]
fn no_file_leaves_its_room_by_the_roof() {
    // `super::super::` would be an import that the scan does not see, where it climbs out of the room.
    for Source { path, code } in library() {
        let depth = path.split('/').count() - usize::from(path.ends_with("/mod.rs"));
        assert!(!code.contains(&"super::".repeat(depth)), "{path} climbs to the root: say `crate::`");
    }
}

#[test]
fn the_scan_sees_what_is_imported() {
    let code =
        "use crate::{error, bodies::{euler, turning},\n    numbers};\ncrate::special::f(); crate::sweep!()";
    assert_eq!(named(code, "crate::"), ["error", "bodies", "numbers", "special", "sweep"]);
    let library =
        [("bodies/a.rs", "crate::special::f();\ncrate::euler::g();"), ("bodies/b.rs", "crate::Rule")]
            .map(|(path, code)| Source { path: path.into(), code: code.into() });
    let rooms = house::rooms(&library);
    assert_eq!(rooms["bodies"], (3, BTreeSet::from(["numbers", "special"])));
}

#[test]
fn crates_that_users_compile_know_nothing_of_the_book() {
    let crates = house::crates(&root()).expect("they can be read");
    assert_eq!(crates.len(), house::manifests(&root()).expect("they can be read").len());
    let of = |name: &str| crates.iter().find(|one| one.name == name).expect("it is there");
    let names = |of: &BTreeSet<String>| of.iter().cloned().collect::<Vec<_>>().join(" ");
    for (name, uses, builds_with) in [
        ("mechanics", "", ""),
        ("drawing", "", ""),
        ("press", "", ""),
        ("figures", "drawing mechanics", ""),
        ("live", "drawing mechanics", ""),
        ("module", "drawing live mechanics", ""),
        ("snippets", "", "mechanics"),
        ("book", "live press", "figures module"),
    ] {
        let one = of(name);
        assert_eq!(
            (names(&one.uses).as_str(), names(&one.builds_with).as_str()),
            (uses, builds_with),
            "{name}"
        );
    }
}

#[test]
fn no_scene_uses_another() {
    for Source { path, code } in library() {
        let Some(rest) = path.strip_prefix("scenes/") else { continue };
        let own = rest.split(['/', '.']).next().unwrap();
        for name in named(&code, "scenes::") {
            assert_eq!(name, own, "{path}");
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

/// How many lines of a file's documentation are assertions of an example.
fn asserted(text: &str) -> usize {
    let documentation = |line: &str| {
        ["///", "//!"].iter().find_map(|sign| line.trim_start().strip_prefix(sign)).map(str::to_owned)
    };
    text.lines().filter_map(documentation).filter(|line| line.trim_start().starts_with("assert")).count()
}

#[test]
fn every_public_module_shows_a_number_in_an_example() {
    let src = root().join("src");
    let read = |path: &Path| fs::read_to_string(path).unwrap();
    let (mut modules, mut without) = (0, Vec::new());
    for file in sources(&src).unwrap() {
        let text = read(&file);
        if text.contains("pub fn new(") && asserted(&text) == 0 {
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
            if parts.iter().all(|part| asserted(&read(part)) == 0) {
                without.push(format!("the module {name}"));
            }
        }
    }
    assert!(asserted(&read(&src.join("lib.rs"))) > 0, "the library itself");
    assert!(without.is_empty(), "no example: {}", without.join("; "));
    assert!(modules > 20, "{modules}");
}

#[test]
fn comments_fit_a_screen() {
    let root = root();
    let mut long = Vec::new();
    for path in ["src", "tests", "benches", "press", "book"]
        .iter()
        .flat_map(|folder| sources(&root.join(folder)).unwrap())
    {
        for (number, line) in fs::read_to_string(&path).unwrap().lines().enumerate() {
            let is_text = line.trim_start().starts_with("//") && !line.contains("//! |");
            if is_text && line.chars().count() > 120 {
                long.push(format!("{}:{}", path.display(), number + 1));
            }
        }
    }
    assert!(long.is_empty(), "more than 120 characters: {}", long.join(" "));
}

/// Cargo compiles nothing again where a checkout has moved together with its `target`.
#[test]
fn no_program_remembers_where_it_was_compiled() {
    let root = root();
    let mut read = 0;
    for folder in ["src", "tests", "benches", "press", "book"] {
        for path in sources(&root.join(folder)).unwrap() {
            let text = fs::read_to_string(&path).unwrap();
            for place in ["MANIFEST_DIR", "TARGET_TMPDIR"] {
                let asked = format!("env!(\"CARGO_{place}\")");
                assert!(!text.contains(&asked), "{}: {asked}", path.display());
            }
            read += 1;
        }
    }
    assert!(read > 100, "only {read} files");
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
    for package in packages {
        let (name, licence) = (&package["name"], package["license"].as_str().unwrap_or_default());
        // mdBook makes the pages and is no part of the library: its licence asks that changes of its files be shown.
        let mdbook = name.as_str().is_some_and(|name| name.starts_with("mdbook-"));
        let allowed = if mdbook { &["MPL-2.0"][..] } else { &PERMISSIVE };
        assert!(can_be_met(licence, allowed), "{name}: {licence}");
    }
    assert!(can_be_met("(MIT OR GPL-3.0) AND Zlib", &PERMISSIVE));
    assert!(!can_be_met("MIT AND GPL-3.0", &PERMISSIVE) && !can_be_met("", &PERMISSIVE));
}
