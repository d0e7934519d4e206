//! A new book: the example, in a workspace that depends on the press and holds no copy of it.

use serde_json::Value;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;
use std::process::{Command, Stdio};

macro_rules! files {
    ($($name:literal),* $(,)?) => {
        [$(($name, include_str!(concat!("../example/", $name)))),*]
    };
}

/// The files of the example but for its manifest, to which that of a workspace belongs.
const FILES: [(&str, &str); 20] = files![
    ".gitignore",
    "book.toml",
    "book/Cargo.toml",
    "book/SUMMARY.md",
    "book/about.md",
    "book/clock/index.md",
    "book/figures.rs",
    "book/lib.rs",
    "book/pendulum/figures.rs",
    "book/pendulum/index.md",
    "book/pendulum/scene.rs",
    "book/program/Cargo.toml",
    "book/program/build.rs",
    "book/program/main.rs",
    "book/scenes.rs",
    "book/snippets/Cargo.toml",
    "book/snippets/build.rs",
    "book/snippets/lib.rs",
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

/// Writes a new book into `folder`, which depends on the press of the one in `root`: by its path, or by the address
/// `git` of its repository.
///
/// # Errors
/// If the folder holds something, or something cannot be written; if Cargo does not say where the press lies.
pub(crate) fn book(root: &Path, folder: &Path, git: Option<&str>) -> io::Result<()> {
    if folder.exists() && fs::read_dir(folder)?.next().is_some() {
        return Err(io::Error::new(ErrorKind::AlreadyExists, "the folder is not empty"));
    }
    let (press, workspace) = press(root)?;
    let dependency = |(name, below, more): (&str, &str, &str)| match git {
        Some(address) => format!("{name} = {{ git = {}{more} }}\n", Value::from(address)),
        None => {
            format!("{name} = {{ path = {}{more} }}\n", Value::from(&*press.join(below).to_string_lossy()))
        }
    };
    let workspace_manifest =
        WORKSPACE.replace("PRESS\n", &format!("{}\n{MANIFEST}\n", CRATES.map(dependency).concat()));
    let put = |name: &str, text: &str| {
        let file = folder.join(name);
        fs::create_dir_all(file.parent().unwrap_or(folder))?;
        fs::write(file, text)
    };
    for (name, text) in FILES {
        put(name, text)?;
    }
    put("Cargo.toml", &workspace_manifest)?;
    put(".cargo/config.toml", SETTINGS)?;
    // The press is tried with these versions of what it uses.
    if workspace.join("Cargo.lock").is_file() {
        fs::copy(workspace.join("Cargo.lock"), folder.join("Cargo.lock"))?;
    }
    Ok(())
}

/// Where the press of a book lies, and the workspace of that book.
fn press(root: &Path) -> io::Result<(std::path::PathBuf, std::path::PathBuf)> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let said = Command::new(cargo)
        .args(["metadata", "--format-version", "1", "--offline"])
        .current_dir(root)
        .stdin(Stdio::null())
        .stderr(Stdio::inherit())
        .output()?;
    let said: Value = serde_json::from_slice(&said.stdout)?;
    let packages = said["packages"].as_array().into_iter().flatten();
    let own = packages.filter(|package| package["name"] == env!("CARGO_PKG_NAME"));
    let manifest = own.filter_map(|package| package["manifest_path"].as_str()).next();
    let folder = manifest.and_then(|manifest| Path::new(manifest).parent());
    let folder = folder.ok_or_else(|| io::Error::other("cargo does not say where the press lies"))?;
    Ok((folder.to_owned(), said["workspace_root"].as_str().unwrap_or_default().into()))
}
