//! A new book: the example, in a workspace that depends on the press and holds no copy of it.

use crate::site::package::cargo;
use anyhow::{Context as _, Result, ensure};
use serde_json::Value;
use std::fs;
use std::path::Path;

macro_rules! files {
    ($($name:literal),* $(,)?) => {
        [$(($name, include_str!(concat!("../example/", $name)))),*]
    };
}

/// The files of the example but for its manifest, to which that of a workspace belongs.
const FILES: [(&str, &str); 18] = files![
    ".gitignore",
    "book.toml",
    "book/Cargo.toml",
    "book/SUMMARY.md",
    "book/about.md",
    "book/clock/index.md",
    "book/lib.rs",
    "book/pendulum/figures.rs",
    "book/pendulum/index.md",
    "book/pendulum/scene.rs",
    "book/program/Cargo.toml",
    "book/program/build.rs",
    "book/program/src/main.rs",
    "book/snippets/Cargo.toml",
    "book/snippets/build.rs",
    "book/snippets/src/lib.rs",
    "book/tables.rs",
    "src/lib.rs",
];
const MANIFEST: &str = include_str!("../example/Cargo.toml");
const WORKSPACE: &str = include_str!("new.toml");
/// The settings of Cargo for the book.
const SETTINGS: &str = r#"[alias]
# `cargo book serve`: the book in the browser. `cargo book` alone lists what else it does.
book = "run --bin pendulum-book --"

[env]
# Where the book lies. What is compiled remembers places in it, and is compiled again where the book has moved.
BOOK_ROOT = { value = "", relative = true }
"#;
/// The crates of the press, and how a book depends on them beside where they lie.
const CRATES: [(&str, &str, &str); 5] = [
    ("dialect", "dialect", ""),
    ("drawing", "drawing", ", default-features = false"),
    ("figures", "figures", ""),
    ("live", "live", ""),
    ("press", "", ""),
];

/// Writes a new book into `folder`, which depends on the press as the one in `root` does, or by the address `git` of
/// its repository.
///
/// # Errors
/// If the folder holds something, or something cannot be written; if Cargo does not say where the press lies.
pub(crate) fn book(root: &Path, folder: &Path, git: Option<&str>) -> Result<()> {
    let is_empty = !folder.exists() || fs::read_dir(folder)?.next().is_none();
    ensure!(is_empty, "the folder is not empty");
    let (by, place) = git.map_or_else(|| press(root), |address| Ok(("git", address.to_owned())))?;
    let dependency = |(name, below, more): (&str, &str, &str)| {
        let place =
            if by == "path" { Path::new(&place).join(below).display().to_string() } else { place.clone() };
        format!("{name} = {{ {by} = {}{more} }}\n", Value::from(place))
    };
    let manifest = format!("{}\n{MANIFEST}\n", CRATES.map(dependency).concat());
    let put = |name: &str, text: &str| {
        let file = folder.join(name);
        fs::create_dir_all(file.parent().unwrap_or(folder))?;
        fs::write(file, text)
    };
    for (name, text) in FILES {
        put(name, text)?;
    }
    put("Cargo.toml", &WORKSPACE.replace("PRESS\n", &manifest))?;
    put(".cargo/config.toml", SETTINGS)?;
    // The press is tried with these versions of what it uses.
    let workspace = answer(root, &["locate-project", "--workspace", "--message-format", "plain"])?;
    let lock = Path::new(workspace.trim()).with_file_name("Cargo.lock");
    if lock.is_file() {
        fs::copy(lock, folder.join("Cargo.lock"))?;
    }
    Ok(())
}

/// How the book in `root` depends on the press: by a path or by the address of a repository.
fn press(root: &Path) -> Result<(&'static str, String)> {
    let name = env!("CARGO_PKG_NAME");
    let said = answer(root, &["tree", "--package", name, "--depth", "0", "--prefix", "none", "--offline"])?;
    let place = said.split_once('(').and_then(|(_, rest)| rest.split(')').next());
    let place = place.context("cargo does not say where the press lies")?;
    Ok(match place.split_once('#') {
        Some((address, _)) => ("git", address.split('?').next().unwrap_or(address).to_owned()),
        None => ("path", place.to_owned()),
    })
}

/// What Cargo answers.
fn answer(root: &Path, arguments: &[&str]) -> Result<String> {
    Ok(String::from_utf8(cargo(root).args(arguments).output()?.stdout)?)
}
