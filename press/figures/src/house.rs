//! The house as its code stands: the rooms of the library and who may import whom, what is really imported, and the
//! crates of the workspace. The figure `fig:house` draws it and `tests/house.rs` holds it, both from this one file.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::{fs, io};

/// The rooms of the library from the ground up, and for each the rooms that it may use beside itself: those that stand
/// before it.
pub const ROOMS: [(&str, &[&str]); 9] = [
    ("measure", &[]),
    ("sweep", &[]),
    ("numbers", &[]),
    ("special", &["numbers"]),
    ("integrate", &["numbers"]),
    ("error", &["numbers", "integrate"]),
    ("bodies", &["numbers", "special", "integrate"]),
    ("scenes", &["numbers", "special", "integrate", "error", "bodies"]),
    ("motion", &["numbers", "bodies", "scenes"]),
];

/// The room of each module that `lib.rs` shows at the root.
pub fn room(module: &str) -> &str {
    match module {
        "clock" | "elementary" | "lanes" | "quantity" | "two_part" | "InvalidQuantity" | "Rule" => "numbers",
        "conical" | "elliptic" | "faddeeva" | "gauss" => "special",
        "attitude" | "euler" | "free_rotation" | "geometric" | "inertia" | "rolling" => "bodies",
        "Error" => "error",
        other => other,
    }
}

/// Every file of Rust below a folder, in the order of their names.
///
/// # Errors
/// If a folder cannot be read.
pub fn sources(folder: &Path) -> io::Result<Vec<PathBuf>> {
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

/// A file of the library.
#[derive(Debug)]
pub struct Source {
    /// Its path below `src`.
    pub path: String,
    /// Its lines of code: without tests, comments and empty lines.
    pub code: String,
}

impl Source {
    /// The room that it stands in.
    pub fn room(&self) -> &str {
        self.path.split(['/', '.']).next().unwrap_or_default()
    }

    /// What it names behind `crate::`, one name for each place.
    pub fn imports(&self) -> Vec<&str> {
        named(&self.code, "crate::")
    }
}

/// Every file of the library of a workspace but its root.
///
/// # Errors
/// If one cannot be read.
pub fn library(root: &Path) -> io::Result<Vec<Source>> {
    let src = root.join("src");
    let files = sources(&src)?.into_iter().filter(|path| *path != src.join("lib.rs"));
    files
        .map(|path| {
            let below = path.strip_prefix(&src).unwrap_or(&path);
            Ok(Source {
                path: below.to_string_lossy().replace('\\', "/"),
                code: code(&fs::read_to_string(&path)?),
            })
        })
        .collect()
}

fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]").next().unwrap_or_default();
    let is_code = |line: &&str| !line.trim_start().starts_with("//") && !line.trim().is_empty();
    text.lines().filter(is_code).collect::<Vec<_>>().join("\n")
}

/// What a text names behind a prefix such as `crate::`, one name for each place; of a list, the first word of each of
/// its parts.
pub fn named<'a>(code: &'a str, prefix: &str) -> Vec<&'a str> {
    let word = |rest: &'a str| {
        rest.trim_start().split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap_or("")
    };
    let mut names = Vec::new();
    for rest in code.split(prefix).skip(1) {
        let Some(list) = rest.strip_prefix('{') else {
            names.push(word(rest));
            continue;
        };
        let (mut depth, mut begin) = (1, 0);
        for (at, sign) in list.char_indices() {
            depth += i32::from(sign == '{') - i32::from(sign == '}');
            if depth == 0 || (depth == 1 && sign == ',') {
                names.push(word(&list[begin..]));
                begin = at + 1;
            }
            if depth == 0 {
                break;
            }
        }
    }
    names.retain(|name| !name.is_empty());
    names
}

/// Which rooms use which: for each room its lines of code and what it imports.
pub fn rooms(library: &[Source]) -> BTreeMap<&str, (usize, BTreeSet<&str>)> {
    let mut rooms = BTreeMap::new();
    for source in library {
        let (lines, used): &mut (usize, BTreeSet<&str>) = rooms.entry(source.room()).or_default();
        *lines += source.code.lines().count();
        used.extend(source.imports().into_iter().map(room).filter(|used| *used != source.room()));
    }
    rooms
}

/// A crate of the workspace, as its manifest says.
#[derive(Debug, PartialEq)]
pub struct Crate {
    /// Its name.
    pub name: String,
    /// The crates of the workspace that it cannot do without.
    pub uses: BTreeSet<String>,
    /// Those that only its build script or its tests use.
    pub builds_with: BTreeSet<String>,
}

/// The name by which the press calls the package of the root.
const LIBRARY: &str = "library";

/// The manifests of a workspace, that of its root first.
///
/// # Errors
/// If the root's cannot be read.
pub fn manifests(root: &Path) -> io::Result<Vec<PathBuf>> {
    let text = fs::read_to_string(root.join("Cargo.toml"))?;
    let members = text.lines().find_map(|line| line.strip_prefix("members = ")).unwrap_or_default();
    let mut folders: Vec<&str> = members.split('"').skip(1).step_by(2).collect();
    folders.retain(|folder| *folder != ".");
    Ok([root.join("Cargo.toml")]
        .into_iter()
        .chain(folders.iter().map(|folder| root.join(folder).join("Cargo.toml")))
        .collect())
}

/// The crates of a workspace, each before those that it uses.
///
/// # Errors
/// If a manifest cannot be read, or crates use each other in a circle.
pub fn crates(root: &Path) -> io::Result<Vec<Crate>> {
    let texts = manifests(root)?.iter().map(fs::read_to_string).collect::<io::Result<Vec<_>>>()?;
    let mut left: Vec<Crate> = texts.iter().map(|text| manifest(text)).collect();
    // The press calls the package of the root by another name.
    let root = left[0].name.clone();
    for uses in left.iter_mut().flat_map(|one| [&mut one.uses, &mut one.builds_with]) {
        if uses.remove(LIBRARY) {
            uses.insert(root.clone());
        }
    }
    let names: BTreeSet<String> = left.iter().map(|one| one.name.clone()).collect();
    for one in &mut left {
        one.uses.retain(|name| names.contains(name));
        one.builds_with.retain(|name| names.contains(name) && !one.uses.contains(name));
    }
    let mut sorted = Vec::new();
    while !left.is_empty() {
        let uses = |one: &Crate, name: &String| one.uses.contains(name) || one.builds_with.contains(name);
        let free = left.iter().position(|one| !left.iter().any(|other| uses(other, &one.name)));
        let Some(free) = free else { return Err(io::Error::other("crates use each other in a circle")) };
        sorted.push(left.remove(free));
    }
    Ok(sorted)
}

/// The name and dependencies that a manifest states.
fn manifest(text: &str) -> Crate {
    let mut one = Crate { name: String::new(), uses: BTreeSet::new(), builds_with: BTreeSet::new() };
    let mut section = "";
    for line in text.lines() {
        let Some((key, value)) = line.split_once('=') else {
            section = if line.starts_with('[') { line } else { section };
            continue;
        };
        let name = key.trim().split('.').next().unwrap_or_default();
        match section {
            "[package]" if name == "name" => value.trim().trim_matches('"').clone_into(&mut one.name),
            "[dependencies]" => drop(one.uses.insert(name.to_owned())),
            "[build-dependencies]" | "[dev-dependencies]" => drop(one.builds_with.insert(name.to_owned())),
            _ => {}
        }
    }
    one
}
