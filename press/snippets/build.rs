//! Writes a module for each page that `book/SUMMARY.md` names, with the page as its documentation.

use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let package = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
    let root = package.ancestors().nth(2).ok_or("the workspace is two folders up")?;
    let summary = root.join("book/SUMMARY.md");
    println!("cargo::rerun-if-changed=build.rs\ncargo::rerun-if-changed={}", summary.display());
    let text = fs::read_to_string(summary)?;
    let pages = text.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    let mut modules = String::new();
    for page in std::iter::once("README.md".to_owned()).chain(pages.map(|page| format!("book/{page}"))) {
        let name =
            page.trim_start_matches("book/").trim_end_matches(".md").to_lowercase().replace(['/', '-'], "_");
        writeln!(
            modules,
            "#[doc = include_str!({:?})]\nmod {} {{}}",
            root.join(&page),
            name.trim_end_matches("_index")
        )?;
    }
    fs::write(Path::new(&env::var("OUT_DIR")?).join("pages.rs"), modules)?;
    Ok(())
}
