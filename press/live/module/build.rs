//! Makes a function of each snippet with live numbers, in the order of SUMMARY.md: of all chapters, or of the
//! one that is named by `BOOK_CHAPTER`, and lists the scenes likewise.

#[path = "../../src/answers.rs"]
mod answers;
#[path = "../../src/library.rs"]
mod library;
#[path = "../../src/markdown.rs"]
mod markdown;
#[path = "../../src/pages.rs"]
mod pages;
#[path = "../../src/printed.rs"]
mod printed;

use answers::Live;
use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(&env::var("CARGO_MANIFEST_DIR")?).join("../../..").canonicalize()?;
    let read = |path: &str| {
        println!("cargo::rerun-if-changed={}", root.join(path).display());
        fs::read_to_string(root.join(path))
    };
    for source in
        ["answers", "library", "markdown", "pages", "printed"].map(|file| format!("../../src/{file}.rs"))
    {
        println!("cargo::rerun-if-changed={source}");
    }
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=BOOK_CHAPTER");
    println!("cargo::rerun-if-env-changed=BOOK_ROOT"); // Cargo looks after files by their place
    let chapter = env::var("BOOK_CHAPTER").ok();
    let out = PathBuf::from(env::var("OUT_DIR")?);
    let (mut functions, mut list, mut count) = (String::new(), String::new(), 0);
    let name = library::name(&read("Cargo.toml")?).ok_or("Cargo.toml names no package")?;
    let known = library::known_as(&name);
    for (page, _) in pages::links(&read("book/SUMMARY.md")?) {
        let file = format!("book/{page}");
        // Each function stands in the lines of its snippet, so that the compiler names these.
        let mut own = String::new();
        for (line, code) in answers::snippets(&read(&file)?) {
            let place = format!("{file}:{line}");
            let (found, faults) = answers::answers(&code);
            count += 1;
            if chapter.as_ref().is_some_and(|chapter| page.split('/').next() != Some(chapter)) {
                continue;
            }
            let number = count - 1;
            faults.iter().for_each(|(n, fault)| println!("cargo::error={file}:{}: {fault}", line + 1 + n));
            let live: Vec<String> = found.live.iter().map(described).collect();
            let printed: Vec<&str> = found.values.iter().map(|value| value.numbers).collect();
            own += &"\n".repeat((line - 1).saturating_sub(own.lines().count()));
            writeln!(
                own,
                "fn snippet_{number}(live: &[f64]) -> Result<(), String> {{ (|| {{\n{} }})().map_err(|error| error.to_string()) }}",
                answers::body(&code).trim_end()
            )?;
            writeln!(
                list,
                "    Snippet {{ number: {number}, place: {place:?}, live: &[{}], printed: &{printed:?}, checks: {}, body: snippet_{number} }},",
                live.join(", "),
                found.checks.len(),
            )?;
        }
        if !own.is_empty() {
            let path = out.join(&file);
            fs::create_dir_all(path.parent().ok_or("a page has a folder")?)?;
            fs::write(&path, own)?;
            writeln!(functions, "include!({path:?});")?;
        }
    }
    let scenes = match &chapter {
        None => "live::scenes()".to_owned(),
        Some(chapter) if root.join("book").join(chapter).join("scene.rs").is_file() => {
            let entry = pages::constant(chapter);
            format!("static ONE: &[&live::Entry] = &[&live::entries::{entry}];\n    ONE")
        }
        Some(_) => "&[]".to_owned(),
    };
    let text = format!(
        "{known}\n/// The scenes.\npub fn scenes() -> &'static [&'static live::Entry] {{\n    {scenes}\n}}\n\n{functions}/// The snippets with live numbers, in the order of the book.\npub static SNIPPETS: &[Snippet] = &[\n{list}];\n"
    );
    fs::write(out.join("snippets.rs"), text)?;
    Ok(())
}

fn described(live: &Live<'_>) -> String {
    let Live { name, literal, least, most, whole, .. } = live;
    format!(
        "Live {{ name: {name:?}, value: {literal}_f64, least: {least:?}, most: {most:?}, whole: {whole} }}"
    )
}
