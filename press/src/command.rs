//! `cargo book`: what one can ask of the press by hand.

use crate::book::from_disk;
use crate::rendered::Rendered;
use crate::{check, mdbook, new, outcome};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

const HELP: &str = "\
cargo book serve [--open] [-p PORT] …   the book in the browser, following your edits (http://localhost:3000)
cargo book build [-d FOLDER]            the site, in target/book/html
cargo book test                         the snippets of all pages
cargo book check                        what is wrong with the pages, fast
cargo book figures FOLDER               every figure as a standalone SVG file
cargo book pdf [FILE]                   the book as a PDF (needs Chromium); by default target/book/things-that-spin.pdf
cargo book new FOLDER                   a book of three pages that is yours to change, with this press
cargo book measure [OPTION …]           runs the library beside its peers, for the report \"Speed and accuracy\"; --help says more";

/// Runs one command on the book under `root`, which shows what is `drawn`; `Err` holds what to print before
/// exiting with status 1.
///
/// # Errors
/// A message for the reader, complete.
pub fn run(root: &Path, arguments: &[String], drawn: &Rendered) -> Result<(), String> {
    let (name, rest) =
        arguments.split_first().map_or(("help", &[][..]), |(name, rest)| (name.as_str(), rest));
    match name {
        "serve" | "build" | "test" => with_mdbook(root, name, rest),
        "check" => {
            none_left(name, rest)?;
            let pages = check::check(root, drawn).map_err(|faults| faults.to_string())?;
            say(&format!(
                "{pages} pages, {} figures, {} scenes: nothing wrong",
                drawn.figures.len(),
                drawn.scenes.len()
            ));
            Ok(())
        }
        "figures" => {
            let [folder] = rest else {
                return Err(format!("`cargo book figures` takes one folder\n\n{HELP}"));
            };
            let folder = PathBuf::from(folder);
            let count =
                drawn.write_all(&folder).map_err(|error| format!("error: {}: {error}", folder.display()))?;
            say(&format!("{count} figures in {}", folder.display()));
            Ok(())
        }
        "pdf" => pdf(root, rest),
        "new" => {
            let [folder] = rest else {
                return Err(format!("`cargo book new` takes one folder\n\n{HELP}"));
            };
            let folder = env::current_dir().map_err(|error| format!("error: {error}"))?.join(folder);
            new::book(root, &folder).map_err(|error| format!("error: {}: {error}", folder.display()))?;
            say(&format!("a book in {}: `cargo book serve` there shows it", folder.display()));
            Ok(())
        }
        "measure" => measure(root, rest),
        "help" | "--help" | "-h" => {
            say(HELP);
            Ok(())
        }
        other => Err(format!("error: `cargo book {other}` does not exist\n\n{HELP}")),
    }
}

/// Prints a line; a reader who has closed the pipe does not want it.
fn say(line: &str) {
    let _ = writeln!(io::stdout(), "{line}");
}

fn none_left(name: &str, rest: &[String]) -> Result<(), String> {
    match rest.first() {
        None => Ok(()),
        Some(extra) => Err(format!("error: `cargo book {name}` takes no argument `{extra}`\n\n{HELP}")),
    }
}

fn with_mdbook(root: &Path, name: &str, rest: &[String]) -> Result<(), String> {
    // Of a page that it cannot read mdBook tells no line.
    let outcome = from_disk(root).map_err(|faults| faults.to_string()).and_then(|_| {
        let mdbook = mdbook::locate(root).map_err(|error| format!("error: {error}"))?;
        let status = Command::new(mdbook)
            .arg(name)
            .args(rest)
            .current_dir(root)
            .status()
            .map_err(|error| format!("error: mdBook cannot be run: {error}"))?;
        if status.success() { Ok(()) } else { Err(format!("`mdbook {name}` failed")) }
    });
    if name == "build" && outcome.is_err() {
        let site = root.join(destination(rest).unwrap_or("target/book")).join("html");
        outcome::remove(&site).map_err(|error| format!("error: {}: {error}", site.display()))?;
    }
    outcome
}

/// The folder that `-d FOLDER` names.
fn destination(arguments: &[String]) -> Option<&str> {
    let at = arguments.iter().position(|argument| argument == "-d" || argument == "--dest-dir");
    let behind = at.and_then(|at| arguments.get(at + 1)).map(String::as_str);
    behind.or_else(|| arguments.iter().find_map(|argument| argument.strip_prefix("--dest-dir=")))
}

/// The peers are a package of their own, outside the workspace, so that nothing else ever builds them.
fn measure(root: &Path, rest: &[String]) -> Result<(), String> {
    let status = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(["run", "--quiet", "--release", "--locked"])
        .args(["--manifest-path", "benches/peers/Cargo.toml", "--target-dir", "target/peers", "--"])
        .args(rest)
        .current_dir(root)
        .status()
        .map_err(|error| format!("error: Cargo cannot be run: {error}"))?;
    if status.success() { Ok(()) } else { Err("nothing was measured".to_owned()) }
}

fn pdf(root: &Path, rest: &[String]) -> Result<(), String> {
    let target = match rest {
        [] => root.join("target/book/things-that-spin.pdf"),
        [file] => env::current_dir().map_err(|error| format!("error: {error}"))?.join(file),
        _ => return Err(format!("`cargo book pdf` takes at most one file\n\n{HELP}")),
    };
    let browser = chromium().ok_or(
        "error: `cargo book pdf` needs Chromium or Chrome, and neither is on PATH; \
         or open print.html in any browser and print it",
    )?;
    with_mdbook(root, "build", &[])?;
    let page = root.join("target/book/html/print.html");
    let profile = root.join("target/press/chromium");
    let output = Command::new(browser)
        .args([
            "--headless",
            "--disable-gpu",
            "--no-first-run",
            "--disable-background-networking",
            "--no-sandbox",
        ])
        .args(["--no-pdf-header-footer", "--generate-pdf-document-outline", "--virtual-time-budget=10000"])
        .arg(format!("--user-data-dir={}", profile.display()))
        .arg(format!("--print-to-pdf={}", target.display()))
        .arg(format!("file://{}", page.display()))
        .stdin(Stdio::null())
        .output()
        .map_err(|error| format!("error: Chromium cannot be run: {error}"))?;
    let size = fs::metadata(&target).map(|data| data.len()).unwrap_or(0);
    if output.status.success() && size > 0 {
        say(&format!("{} ({} KB)", target.display(), size / 1024));
        Ok(())
    } else {
        Err(format!("error: Chromium printed nothing:\n{}", String::from_utf8_lossy(&output.stderr)))
    }
}

/// The first browser on PATH that can print.
fn chromium() -> Option<PathBuf> {
    let names = ["chromium", "chromium-browser", "google-chrome", "chrome", "msedge"];
    names.into_iter().map(PathBuf::from).find(|name| {
        Command::new(name)
            .arg("--version")
            .stdin(Stdio::null())
            .output()
            .is_ok_and(|output| output.status.success())
    })
}
