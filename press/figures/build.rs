//! Lists the chapters and their figures, so that nobody has to: a module for `book/figures.rs` and for each
//! `book/*/figures.rs` in the order of SUMMARY.md, and an entry for each function in it, or in a module of its folder
//! `book/*/figures/`, that draws a figure. Likewise for the tables of `book/tables.rs`.

#[path = "../src/library.rs"]
mod library;
#[path = "src/list.rs"]
mod list;
#[path = "../src/pages.rs"]
mod pages;

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(&env::var("CARGO_MANIFEST_DIR")?).join("../..").canonicalize()?;
    let [summary, manifest] = ["book/SUMMARY.md", "Cargo.toml"].map(|path| root.join(path));
    println!("cargo::rerun-if-env-changed=BOOK_ROOT"); // what is written names files by their place
    for read in [&summary, &manifest] {
        println!("cargo::rerun-if-changed={}", read.display());
    }
    let name = library::name(&fs::read_to_string(manifest)?).ok_or("Cargo.toml names no package")?;
    let (mut modules, mut entries) = (String::new(), String::new());
    let mut places = BTreeMap::new();
    let fault = |place: &str, what: &str| println!("cargo::error={place}: {what}");
    let chapters = pages::chapters(&fs::read_to_string(summary)?);
    for folder in std::iter::once(list::FRONT).chain(chapters.iter().map(String::as_str)) {
        let file = list::file(folder);
        let path = root.join("book").join(&file);
        let Ok(source) = fs::read_to_string(&path) else {
            // A chapter without figures, until it has some.
            println!("cargo::rerun-if-changed={}", path.parent().unwrap_or(&root).display());
            continue;
        };
        println!("cargo::rerun-if-changed={}", path.display());
        // A chapter may have the name of the library, or of a module of this crate.
        let module = format!("chapter_{}", pages::in_rust(folder));
        writeln!(modules, "#[path = {path:?}]\nmod {module};")?;
        // Its parts, if it has some: book/laundromat/figures/ramp.rs is the module `ramp` of the figures there.
        let mut sources = vec![(file.clone(), module, source)];
        let file = Path::new(&file);
        let parts = path.with_extension("");
        if parts.is_dir() {
            println!("cargo::rerun-if-changed={}", parts.display());
            let mut paths = fs::read_dir(parts)?
                .map(|entry| Ok(entry?.path()))
                .collect::<Result<Vec<_>, std::io::Error>>()?;
            paths.sort();
            for part in paths {
                let name = part.file_stem().unwrap_or_default().to_string_lossy().into_owned();
                let module = format!("{}::{name}", sources[0].1);
                let file = file.with_extension("").join(format!("{name}.rs"));
                sources.push((file.display().to_string(), module, fs::read_to_string(part)?));
            }
        }
        for (file, module, source) in sources {
            let found = list::figures(&source).unwrap_or_else(|faults| {
                faults.iter().for_each(|(line, what)| fault(&format!("book/{file}:{line}"), what));
                Vec::new()
            });
            for list::Found { id, function, line } in found {
                let place = format!("book/{file}:{line}");
                if let Some(other) = places.insert(id.clone(), place.clone()) {
                    fault(&place, &format!("{id}: {other} has a figure of this name too"));
                }
                let draw = format!("{module}::{function}");
                writeln!(
                    entries,
                    "    Entry {{ id: {id:?}, chapter: {folder:?}, file: \"book/{file}\", line: {line}, draw: {draw} }},"
                )?;
            }
        }
    }
    let mut tables = String::new();
    let path = root.join("book/tables.rs");
    if let Ok(source) = fs::read_to_string(&path) {
        println!("cargo::rerun-if-changed={}", path.display());
        writeln!(modules, "#[path = {path:?}]\nmod tables;")?;
        for table in list::tables(&source) {
            writeln!(tables, "    ({:?}, tables::{table}),", table.replace('_', "-"))?;
        }
    }
    let text = format!(
        "{}\n{modules}\nconst ENTRIES: &[Entry] = &[\n{entries}];\n\nconst TABLES: &[Table] = &[\n{tables}];\n",
        library::known_as(&name)
    );
    fs::write(Path::new(&env::var("OUT_DIR")?).join("figures.rs"), text)?;
    Ok(())
}
