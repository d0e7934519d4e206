//! The walls of the library: which room of `src` may use which.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The rooms, and for each the rooms that it may use beside itself. `wide` is the other side of `sample` and knows the
/// motions that it computes.
const ROOMS: [(&str, &[&str]); 9] = [
    ("numbers", &[]),
    ("special", &["numbers"]),
    ("integrate", &["numbers"]),
    ("error", &["numbers", "integrate"]),
    ("bodies", &["numbers", "special", "integrate", "error", "wide"]),
    ("scenes", &["numbers", "special", "integrate", "error", "bodies", "wide"]),
    ("wide", &["numbers", "special", "integrate", "bodies", "scenes"]),
    ("measure", &[]),
    ("sweep", &[]),
];

/// The room of each module that `lib.rs` shows at the root.
fn room(module: &str) -> &str {
    match module {
        "quantity" | "two_part" | "InvalidQuantity" | "Rule" => "numbers",
        "conical" | "elliptic" | "faddeeva" => "special",
        "attitude" | "euler" | "free_rotation" | "geometric" | "inertia" | "rolling" => "bodies",
        "Error" => "error",
        other => other,
    }
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let files = files.into_iter().filter(|path| path.extension().is_some_and(|ending| ending == "rs"));
    files.chain(folders.iter().flat_map(|folder| sources(folder))).collect()
}

/// Every file of the library but its root, as its path below `src`, without the tests and comments in it.
fn library() -> Vec<(String, String)> {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let name = |path: &Path| path.strip_prefix(&src).unwrap().to_string_lossy().replace('\\', "/");
    let code = |path: &Path| {
        let text = fs::read_to_string(path).unwrap();
        let text = text.split("#[cfg(test)]").next().unwrap_or_default();
        text.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n")
    };
    let files = sources(&src).into_iter().filter(|path| !path.ends_with("lib.rs"));
    files.map(|path| (name(&path), code(&path))).collect()
}

/// What a file names behind a prefix such as `crate::`, one name for each place.
fn named<'a>(code: &'a str, prefix: &str) -> Vec<&'a str> {
    let word = |rest: &'a str| rest.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or("");
    code.split(prefix)
        .skip(1)
        .flat_map(|rest| match rest.strip_prefix('{') {
            Some(list) => {
                list.split('}').next().unwrap_or("").split(',').map(|name| word(name.trim())).collect()
            }
            None => vec![word(rest)],
        })
        .collect()
}

#[test]
fn every_room_uses_only_what_lies_below_it() {
    let mut uses = 0;
    for (file, code) in library() {
        let here = file.split(['/', '.']).next().unwrap();
        let (_, allowed) =
            ROOMS.iter().find(|(name, _)| *name == here).unwrap_or_else(|| panic!("{file} has no room"));
        for name in named(&code, "crate::") {
            let used = room(name);
            assert!(
                used == here || allowed.contains(&used),
                "{file} uses {name}, which is no room below {here}"
            );
            uses += 1;
        }
    }
    assert!(uses > 100);
}

#[test]
fn no_scene_uses_another() {
    for (file, code) in library() {
        let Some(rest) = file.strip_prefix("scenes/") else { continue };
        let own = rest.split(['/', '.']).next().unwrap();
        for name in named(&code, "scenes::") {
            assert_eq!(name, own, "{file}");
        }
    }
}

#[test]
fn only_sample_asks_for_wide_registers() {
    let mut kernels = 0;
    for (file, code) in library().iter().filter(|(file, _)| !file.starts_with("wide/")) {
        // Names that are imported from there count as well: a `use` ends with its semicolon.
        let imports = code.split("use crate::wide").skip(1).filter_map(|rest| rest.split(';').next());
        let names: Vec<&str> = imports
            .flat_map(|list| list.split(['{', '}', ',', ' ', ':', '\n']))
            .filter(|name| name.starts_with(char::is_uppercase))
            .collect();
        let mut function = "";
        for line in code.lines().filter(|line| !line.starts_with("use ")) {
            if let Some((_, rest)) = line.split_once("fn ") {
                function = rest.split(['(', '<']).next().unwrap();
            }
            let mut called = line.split(|c: char| !c.is_alphanumeric() && c != '_');
            if line.contains("wide::") || called.any(|word| names.contains(&word)) {
                // The solver of a rolling disk takes its series from there: without it, the plain one.
                let is_series = line.trim_start().starts_with("&Lanes(");
                assert!(function == "sample" || is_series, "{file}: {line}");
                kernels += 1;
            }
        }
    }
    assert!(kernels > 8, "{kernels}");
}

#[test]
fn comments_fit_a_screen() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut long = Vec::new();
    for path in
        ["src", "tests", "benches", "press", "book"].iter().flat_map(|folder| sources(&root.join(folder)))
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

/// Licences that ask for no more than their text and a name.
const PERMISSIVE: [&str; 7] =
    ["MIT", "Apache-2.0", "Zlib", "BSD-3-Clause", "0BSD", "Unlicense", "Unicode-3.0"];

/// Whether an expression such as `(MIT OR Apache-2.0) AND Unicode-3.0` can be met with these licences. Parentheses
/// stand about lists of choices only.
fn can_be_met(expression: &str, licences: &[&str]) -> bool {
    let plain = expression.replace(['(', ')'], "").replace('/', " OR ");
    plain.split(" AND ").all(|part| part.split(" OR ").any(|licence| licences.contains(&licence.trim())))
}

#[test]
fn what_is_built_may_be_used_and_comes_from_one_place() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let registry = "source = \"registry+https://github.com/rust-lang/crates.io-index\"";
    for lock in ["Cargo.lock", "benches/peers/Cargo.lock"] {
        let text = fs::read_to_string(root.join(lock)).unwrap();
        for line in text.lines().filter(|line| line.starts_with("source")) {
            assert_eq!(line, registry, "{lock}");
        }
    }

    let said = |program: &str, arguments: &[&str]| {
        let out = Command::new(program).args(arguments).current_dir(root).output().ok()?;
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
