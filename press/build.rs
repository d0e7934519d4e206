//! Renders every figure of the book to SVG in Cargo's `OUT_DIR`.
//!
//! The library and the figures are build-dependencies, so Cargo runs this again exactly when their code has changed.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::{env, fs, process};

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    if let Err(error) = render() {
        eprintln!("error: {error}");
        process::exit(1);
    }
}

fn render() -> Result<(), Box<dyn std::error::Error>> {
    let out = PathBuf::from(env::var_os("OUT_DIR").ok_or("Cargo sets OUT_DIR")?);
    let figures = figures::all().map_err(|failures| {
        let lines: Vec<String> = failures.iter().map(ToString::to_string).collect();
        lines.join("\nerror: ")
    })?;
    let mut list = String::from(
        "/// Every figure, in the order in which the chapters list them.\npub const ALL: &[Figure] = &[\n",
    );
    for figure in figures {
        let name = figure.id.replace(':', "-");
        fs::write(out.join(format!("{name}.inline.svg")), &figure.svg)?;
        fs::write(out.join(format!("{name}.svg")), &figure.standalone)?;
        writeln!(
            list,
            "    Figure {{ id: {:?}, chapter: {:?}, title: {:?}, svg: include_str!(concat!(env!(\"OUT_DIR\"), \"/{name}.inline.svg\")), \
             standalone: include_str!(concat!(env!(\"OUT_DIR\"), \"/{name}.svg\")) }},",
            figure.id, figure.chapter, figure.title
        )?;
    }
    list.push_str("];\n");
    fs::write(out.join("figures.rs"), list)?;
    Ok(())
}
