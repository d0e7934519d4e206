//! Writes a module for each page that `book/SUMMARY.md` names, with the page as its documentation, and puts a check in
//! the place of each number that a page prints.

#[path = "../src/library.rs"]
mod library;
#[path = "../src/markdown.rs"]
mod markdown;
#[path = "../src/pages.rs"]
mod pages;
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
    let sources =
        ["build.rs", "../src/library.rs", "../src/markdown.rs", "../src/pages.rs", "../src/printed.rs"]
            .map(Path::new);
    for read in sources.into_iter().chain([&*summary, &*manifest]) {
        println!("cargo::rerun-if-changed={}", read.display());
    }
    let name = library::name(&fs::read_to_string(manifest)?).ok_or("Cargo.toml names no package")?;
    let known = format!("use ::library as {name};"); // `extern crate` would shift the lines that rustc names
    let pages = pages::links(&fs::read_to_string(summary)?).into_iter();
    let mut modules = String::new();
    let readme = readme.is_file().then(|| "README.md".to_owned());
    let files = readme.into_iter().chain(pages.map(|(page, _)| format!("book/{page}")));
    for (n, page) in files.enumerate() {
        let name = pages::module(n, page.trim_start_matches("book/"));
        let mut path = root.join(&page);
        println!("cargo::rerun-if-changed={}", path.display());
        let text = fs::read_to_string(&path)?;
        let tested = printed::tested(&text, &page, &known);
        if tested != text {
            path = out.join(&page);
            fs::create_dir_all(path.parent().ok_or("a page has a folder")?)?;
            fs::write(&path, tested)?;
        }
        writeln!(modules, "#[doc = include_str!({path:?})]\nmod {name} {{}}")?;
    }
    fs::write(out.join("pages.rs"), modules)?;
    Ok(())
}
