//! The snippets of all pages as Rust: for the build script of the crate that runs them.

use crate::live_numbers::{self, Live};
use crate::{expected_output, pages};
use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

/// Writes, into Cargo's `OUT_DIR`, what the macro `live::pages!` includes: `tested.rs` with the pages as documentation
/// tests, in which a check stands in the place of each number that a page prints, and `live.rs` with a function for
/// each snippet with live numbers, of all chapters or of the one that `BOOK_CHAPTER` names.
///
/// `folder` holds SUMMARY.md and its pages, as seen from the package.
pub fn write_snippets(folder: &str) -> ExitCode {
    match written(folder) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// A page as it stands on disk, and its name in messages: `book/turning/index.md`.
struct Page {
    path: PathBuf,
    name: String,
    text: String,
}

impl Page {
    fn read(path: &Path, root: &Path) -> Result<Self, Box<dyn Error>> {
        println!("cargo::rerun-if-changed={}", path.display());
        let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
        let name = path.strip_prefix(root).unwrap_or(path).to_string_lossy().replace('\\', "/");
        Ok(Self { path: path.to_owned(), name, text })
    }
}

fn written(folder: &str) -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=BOOK_CHAPTER");
    println!("cargo::rerun-if-env-changed=BOOK_ROOT"); // what is written names pages by their place
    let package = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
    let out = PathBuf::from(env::var("OUT_DIR")?);
    let folder = package.join(folder).canonicalize()?;
    let root = folder.parent().ok_or("the pages lie in a folder of the project")?;
    let summary = Page::read(&folder.join("SUMMARY.md"), root)?;
    let links = pages::links(&summary.text).into_iter();
    let book: Vec<Page> =
        links.map(|(page, _)| Page::read(&folder.join(page), root)).collect::<Result<_, _>>()?;
    let chapter = env::var("BOOK_CHAPTER").ok();
    if chapter.is_none() {
        fs::write(out.join("tested.rs"), tested(&book, &out)?)?;
    }
    let own = |page: &Page| {
        let below = Path::new(&page.name).components().nth(1);
        chapter.as_ref().is_none_or(|chapter| below.is_some_and(|folder| folder.as_os_str() == &**chapter))
    };
    fs::write(out.join("live.rs"), live(&book, own, &out)?)?;
    Ok(())
}

/// A module for each page, with the page as its documentation.
fn tested(pages: &[Page], out: &Path) -> Result<String, Box<dyn Error>> {
    let mut modules = String::new();
    for (n, page) in pages.iter().enumerate() {
        let tested = expected_output::tested(&page.text, &page.name);
        let path = if tested == page.text { page.path.clone() } else { copy(out, &page.name, &tested)? };
        writeln!(modules, "#[doc = include_str!({path:?})]\nmod {} {{}}", pages::module(n, &page.name))?;
    }
    Ok(modules)
}

/// A function for each snippet with live numbers, and the list of them.
fn live(pages: &[Page], is_own: impl Fn(&Page) -> bool, out: &Path) -> Result<String, Box<dyn Error>> {
    let (mut functions, mut list, mut count) = (String::new(), String::new(), 0);
    for page in pages {
        // Each function stands in the lines of its snippet, so that the compiler names these.
        let mut own = String::new();
        for (line, code) in live_numbers::snippets(&page.text) {
            let number = count;
            count += 1;
            if !is_own(page) {
                continue;
            }
            let place = format!("{}:{line}", page.name);
            let (found, faults) = live_numbers::answers(&code);
            for (n, fault) in faults {
                println!("cargo::error={}:{}: {fault}", page.name, line + 1 + n);
            }
            let live: Vec<String> = found.live.iter().map(described).collect();
            let printed: Vec<&str> = found.values.iter().map(|value| value.numbers).collect();
            own += &"\n".repeat((line - 1).saturating_sub(own.lines().count()));
            writeln!(
                own,
                "fn snippet_{number}(live: &[f64]) -> Result<(), String> {{ (|| {{\n{} }})().map_err(|error| error.to_string()) }}",
                live_numbers::body(&code).trim_end()
            )?;
            writeln!(
                list,
                "    Snippet {{ number: {number}, place: {place:?}, live: &[{}], printed: &{printed:?}, checks: {}, body: snippet_{number} }},",
                live.join(", "),
                found.checks.len(),
            )?;
        }
        if !own.is_empty() {
            writeln!(functions, "include!({:?});", copy(&out.join("live"), &page.name, &own)?)?;
        }
    }
    Ok(format!(
        "{functions}/// The snippets with live numbers, in the order of the book.\npub static SNIPPETS: &[Snippet] = &[\n{list}];\n"
    ))
}

fn described(live: &Live<'_>) -> String {
    let Live { name, literal, least, most, whole, .. } = live;
    format!(
        "Live {{ name: {name:?}, value: {literal}_f64, least: {least:?}, most: {most:?}, whole: {whole} }}"
    )
}

/// Writes what is made of a page below `out`; where it is.
fn copy(out: &Path, name: &str, text: &str) -> Result<PathBuf, Box<dyn Error>> {
    let path = out.join(name);
    fs::create_dir_all(path.parent().ok_or("a page has a folder")?)?;
    fs::write(&path, text)?;
    Ok(path)
}
