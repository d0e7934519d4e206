//! Makes a function of each snippet with live numbers, in the order of SUMMARY.md: of all chapters, or of the
//! one that is named by `BOOK_CHAPTER`, and lists the scenes likewise.

#[path = "../../src/answers.rs"]
mod answers;
#[path = "../../src/library.rs"]
mod library;
#[path = "../../src/printed.rs"]
mod printed;

use answers::Live;
use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let root = Path::new(&env::var("CARGO_MANIFEST_DIR")?).join("../../..").canonicalize()?;
    let read = |path: &str| {
        println!("cargo::rerun-if-changed={}", root.join(path).display());
        fs::read_to_string(root.join(path))
    };
    for source in ["build.rs", "../../src/answers.rs", "../../src/library.rs", "../../src/printed.rs"] {
        println!("cargo::rerun-if-changed={source}");
    }
    println!("cargo::rerun-if-env-changed=BOOK_CHAPTER");
    println!("cargo::rerun-if-env-changed=BOOK_ROOT"); // Cargo looks after files by their place
    let chapter = env::var("BOOK_CHAPTER").ok();
    let (mut functions, mut list, mut count, mut broken) = (String::new(), String::new(), 0, Vec::new());
    let name = library::name(&read("Cargo.toml")?).ok_or("Cargo.toml names no package")?;
    let known = library::known_as(&name);
    let summary = read("book/SUMMARY.md")?;
    for page in summary.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
        let file = format!("book/{page}");
        for (line, code) in answers::snippets(&read(&file)?) {
            let place = format!("{file}:{line}");
            let (found, faults) = answers::answers(&code);
            count += 1;
            if chapter.as_ref().is_some_and(|chapter| page.split('/').next() != Some(chapter)) {
                continue;
            }
            let number = count - 1;
            broken.extend(faults.iter().map(|(n, fault)| format!("{file}:{}: {fault}", line + 1 + n)));
            let live: Vec<String> = found.live.iter().map(described).collect();
            let printed: Vec<&str> = found.values.iter().map(|value| value.numbers).collect();
            writeln!(
                functions,
                "fn snippet_{number}(live: &[f64]) -> Result<(), String> {{\n    (|| {{\n{}    }})()\n        \
                 .map_err(|error| error.to_string())\n}}\n",
                answers::body(&code)
            )?;
            writeln!(
                list,
                "    Snippet {{ number: {number}, place: {place:?}, live: &[{}], printed: &{printed:?}, checks: {}, body: snippet_{number} }},",
                live.join(", "),
                found.checks.len(),
            )?;
        }
    }
    for fault in &broken {
        println!("cargo::error={fault}");
    }
    let scenes = match &chapter {
        None => "live::scenes()".to_owned(),
        Some(chapter) if root.join("book").join(chapter).join("scene.rs").is_file() => {
            let entry = chapter.replace('-', "_").to_uppercase();
            format!("static ONE: &[&live::Entry] = &[&live::entries::{entry}];\n    ONE")
        }
        Some(_) => "&[]".to_owned(),
    };
    let text = format!(
        "{known}\n/// The scenes.\npub fn scenes() -> &'static [&'static live::Entry] {{\n    {scenes}\n}}\n\n{functions}/// The snippets with live numbers, in the order of the book.\npub static SNIPPETS: &[Snippet] = &[\n{list}];\n"
    );
    fs::write(Path::new(&env::var("OUT_DIR")?).join("snippets.rs"), text)?;
    Ok(())
}

fn described(live: &Live<'_>) -> String {
    let Live { name, literal, least, most, whole, .. } = live;
    format!(
        "Live {{ name: {name:?}, value: {literal}_f64, least: {least:?}, most: {most:?}, whole: {whole} }}"
    )
}
