//! Writes a module for each page that `book/SUMMARY.md` names, with the page as its documentation, and puts a check in
//! the place of each number that a page prints.

#[path = "../src/library.rs"]
mod library;
#[path = "../src/printed.rs"]
mod printed;

use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let package = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
    let out = PathBuf::from(env::var("OUT_DIR")?);
    let root = package.ancestors().nth(2).ok_or("the workspace is two folders up")?;
    let [summary, manifest, readme] =
        ["book/SUMMARY.md", "Cargo.toml", "README.md"].map(|path| root.join(path));
    println!("cargo::rerun-if-env-changed=BOOK_ROOT"); // what is written names pages by their place
    for read in [
        Path::new("build.rs"),
        Path::new("../src/library.rs"),
        Path::new("../src/printed.rs"),
        &summary,
        &manifest,
    ] {
        println!("cargo::rerun-if-changed={}", read.display());
    }
    let name = library::name(&fs::read_to_string(manifest)?).ok_or("Cargo.toml names no package")?;
    let known = library::known_as(&name);
    let text = fs::read_to_string(summary)?;
    let pages = text.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    let mut modules = String::new();
    let readme = readme.is_file().then(|| "README.md".to_owned());
    for page in readme.into_iter().chain(pages.map(|page| format!("book/{page}"))) {
        let name =
            page.trim_start_matches("book/").trim_end_matches(".md").to_lowercase().replace(['/', '-'], "_");
        let mut path = root.join(&page);
        println!("cargo::rerun-if-changed={}", path.display());
        let text = fs::read_to_string(&path)?;
        let tested = printed::tested(&text, &page, &known);
        if tested != text {
            path = out.join(&page);
            fs::create_dir_all(path.parent().ok_or("a page has a folder")?)?;
            fs::write(&path, tested)?;
        }
        writeln!(modules, "#[doc = include_str!({path:?})]\nmod {} {{}}", name.trim_end_matches("_index"))?;
    }
    fs::write(out.join("pages.rs"), modules)?;
    Ok(())
}
