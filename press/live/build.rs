//! Finds the scenes, `book/*/scene.rs` in the order of SUMMARY.md, and sets the formulas of their labels.

#[path = "../src/library.rs"]
mod library;
#[path = "../src/pages.rs"]
mod pages;

use std::collections::BTreeSet;
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
    let known = library::known_as(&name);
    let (mut modules, mut entries, mut list, mut symbols) =
        (String::new(), String::new(), String::new(), String::new());
    for chapter in pages::chapters(&fs::read_to_string(summary)?) {
        let file = root.join("book").join(&chapter).join("scene.rs");
        let Ok(mut source) = fs::read_to_string(&file) else {
            println!("cargo::rerun-if-changed={}", root.join("book").join(&chapter).display());
            continue;
        };
        println!("cargo::rerun-if-changed={}", file.display());
        // A chapter may have the name of the library, or of a module of this crate.
        let module = format!("chapter_{}", pages::in_rust(&chapter));
        writeln!(modules, "#[path = {file:?}]\nmod {module};")?;
        let (name, place) = (pages::constant(&chapter), list.lines().count());
        let entry =
            format!("Entry {{ place: {place}, chapter: {chapter:?}, scene: &super::{module}::SCENE }}");
        writeln!(
            entries,
            "    /// The scene of the chapter `{chapter}`.\n    pub static {name}: super::Entry = super::{entry};"
        )?;
        writeln!(list, "    &entries::{name},")?;
        // Its parts, if it has some: book/laundromat/scene/drum.rs.
        let parts = file.with_extension("");
        if parts.is_dir() {
            println!("cargo::rerun-if-changed={}", parts.display());
            for part in fs::read_dir(parts)? {
                source += &fs::read_to_string(part?.path())?;
            }
        }
        let formulas: BTreeSet<&str> =
            labels(&source).flat_map(|label| label.split('$').skip(1).step_by(2)).collect();
        let table = drawing::symbols_of(formulas)?;
        writeln!(symbols, "    pub(crate) static {name}: &[drawing::Symbol] = {table};")?;
    }
    let text = format!(
        "{known}\n{modules}\n/// The scenes, one by one: a program that names one of them holds no other.\npub mod entries {{\n{entries}}}\n\n\
         static ENTRIES: &[&Entry] = &[\n{list}];\n\n\
         /// The formulas of the labels of each scene.\nmod symbols {{\n{symbols}}}\n"
    );
    fs::write(Path::new(&env::var("OUT_DIR")?).join("scenes.rs"), text)?;
    Ok(())
}

/// The raw strings of a source, in which labels are written, without those in comments.
fn labels(source: &str) -> impl Iterator<Item = &str> {
    let code = source.lines().map(|line| line.split("//").next().unwrap_or_default());
    code.flat_map(|line| line.split("r\"").skip(1)).filter_map(|rest| rest.split('"').next())
}
