//! Renders the figures of the book as SVG, and tables of the library as Markdown, into Cargo's `OUT_DIR`.
//!
//! The library and the figures are build-dependencies, so Cargo runs this when their code has changed. It draws the
//! figures of those chapters again whose stamp has changed with it (`stamps.rs`).

mod stamps;

use std::error::Error;
use std::path::PathBuf;
use std::{env, fs, process};

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=BOOK_ROOT"); // the program knows its figures by their place
    if let Err(error) = render() {
        eprintln!("error: {error}");
        process::exit(1);
    }
}

fn render() -> Result<(), Box<dyn Error>> {
    let out = PathBuf::from(env::var_os("OUT_DIR").ok_or("Cargo sets OUT_DIR")?);
    let package = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").ok_or("Cargo sets CARGO_MANIFEST_DIR")?);
    let root = package.ancestors().nth(2).ok_or("the workspace is two folders up")?;
    for manifest in figures::house::manifests(root)? {
        println!("cargo::rerun-if-changed={}", manifest.display());
    }
    let stamps = stamps::Stamps::read(root)?;
    let list = out.join("figures.txt");
    // A line of the list: the chapter, the figure, the stamp with which it was drawn, where it goes on a page.
    let known = fs::read_to_string(&list).unwrap_or_default();
    let is_fresh = |line: &&str| {
        let words: Vec<&str> = line.split(' ').collect();
        matches!(words[..], [chapter, _, stamp, _] if stamp == stamps.of(chapter))
    };
    let mut lines: Vec<String> = known.lines().filter(is_fresh).map(str::to_owned).collect();
    let is_old = |chapter: &str| !lines.iter().any(|line| line.starts_with(&format!("{chapter} ")));
    let figures = figures::of(is_old).map_err(|failures| {
        let lines: Vec<String> = failures.iter().map(ToString::to_string).collect();
        lines.join("\nerror: ")
    })?;
    let _ = fs::remove_file(&list); // from here on the folder holds something else
    for figure in figures {
        let name = figure.id.trim_start_matches("fig:");
        fs::write(out.join(format!("{name}.inline.svg")), &figure.svg)?;
        fs::write(out.join(format!("{name}.svg")), &figure.standalone)?;
        let place = if figure.wide { "wide" } else { "column" };
        lines.push(format!("{} {} {} {place}", figure.chapter, figure.id, stamps.of(&figure.chapter)));
    }
    for old in fs::read_dir(&out)? {
        let old = old?.path();
        if old.extension().is_some_and(|ending| ending == "md") {
            fs::remove_file(old)?; // a table that may be gone
        }
    }
    for (name, table) in figures::tables() {
        fs::write(out.join(format!("{name}.md")), table)?;
    }
    fs::write(list, lines.join("\n"))?;
    Ok(())
}
