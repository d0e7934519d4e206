//! `cargo book`: what one can ask of the press by hand.

use crate::disk::from_disk;
use crate::mdbook::{self, For};
use crate::paper::{self, Paper};
use crate::rendered::Rendered;
use crate::{check, head, new, outcome, serve};
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

const HELP: &str = "\
cargo book serve [--open] [-p PORT]     the book in the browser, following your edits (http://localhost:3000)
cargo book build [-d FOLDER] [--paper]  the site, in target/book/html; with links to its PDF and EPUB, which lie in it
cargo book test                         the snippets of all pages
cargo book check                        what is wrong with the pages, fast
cargo book figures FOLDER               every figure as a standalone SVG file
cargo book pdf [FILE.pdf]               the whole book for paper, its solutions at the end (needs Chromium)
cargo book pdf CHAPTER [--solutions] …  a handout of one chapter, by its folder or number; by default in target/book
cargo book epub [FILE.epub]             the whole book for readers of EPUBs
cargo book new FOLDER [--git URL]       a book of three pages that is yours to change; it depends on this press, where it lies or by git
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
        "serve" => serve::run(root, rest, &drawn.book).map_err(|message| format!("{message}\n\n{HELP}")),
        "build" => build(root, rest),
        "test" => {
            none_left(name, rest)?;
            // Of a page that it cannot read mdBook tells no line.
            from_disk(root).map_err(|faults| faults.to_string())?;
            mdbook::test(root)
        }
        "check" => {
            none_left(name, rest)?;
            let pages = check::check(root, drawn).map_err(|faults| faults.to_string())?;
            say(&format!(
                "{pages} pages, {} figures, {} scenes: nothing wrong; `cargo book test` runs the snippets",
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
        "epub" => epub(root, rest),
        "new" => {
            let (folder, git) = match rest {
                [folder] if !folder.starts_with('-') => (folder, None),
                [folder, git, address] if git == "--git" => (folder, Some(&**address)),
                [git, address, folder] if git == "--git" => (folder, Some(&**address)),
                _ => {
                    return Err(format!(
                        "error: `cargo book new` takes a folder, and perhaps --git URL\n\n{HELP}"
                    ));
                }
            };
            let folder = env::current_dir().map_err(|error| format!("error: {error}"))?.join(folder);
            new::book(root, &folder, git).map_err(|error| format!("error: {}: {error}", folder.display()))?;
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

/// Where the site for paper is built.
const PAPER: &str = "target/press/paper";

fn none_left(name: &str, rest: &[String]) -> Result<(), String> {
    match rest.first() {
        None => Ok(()),
        Some(extra) => Err(format!("error: `cargo book {name}` takes no argument `{extra}`\n\n{HELP}")),
    }
}

fn build(root: &Path, rest: &[String]) -> Result<(), String> {
    let (mut folder, mut with_paper) = (None, false);
    let mut rest = rest.iter();
    while let Some(argument) = rest.next() {
        match argument.as_str() {
            "--paper" => with_paper = true,
            "-d" | "--dest-dir" if rest.len() > 0 => folder = rest.next().map(String::as_str),
            one if one.starts_with("--dest-dir=") => folder = one.strip_prefix("--dest-dir="),
            wrong => return Err(format!("error: `cargo book build` takes no argument `{wrong}`\n\n{HELP}")),
        }
    }
    let folder = mdbook::destination(root, folder)?;
    let browser = with_paper.then(paper::browser).transpose()?;
    // It is made beside its place, to which it comes at once when it is whole.
    let (site, beside) = (folder.join("html"), folder.join("unfinished"));
    let cannot = |error: io::Error| format!("error: {}: {error}", folder.display());
    outcome::withdraw(&site).and_then(|()| outcome::remove(&beside)).map_err(cannot)?;
    let fresh = beside.join("html");
    let built = from_disk(root)
        .map_err(|faults| faults.to_string())
        .and_then(|_| mdbook::build(root, &beside, For::Readers))
        .and_then(|()| browser.map_or(Ok(()), |browser| add_paper(root, &browser, &fresh)))
        .and_then(|()| fs::rename(&fresh, &site).map_err(cannot));
    outcome::remove(&beside).map_err(cannot)?;
    if built.is_ok() {
        say(&format!("The site is in {}", site.display()));
    }
    built
}

/// Puts the book on paper and for readers of EPUBs into its site, and leads to both from the foot of every page.
fn add_paper(root: &Path, browser: &Path, site: &Path) -> Result<(), String> {
    let cannot = |error: io::Error| format!("error: {}: {error}", site.display());
    build_for_paper(root)?;
    let pages = root.join(PAPER).join("html");
    let book = Paper::read(root, &pages, None, true).map_err(cannot)?;
    let [pdf, epub] = ["pdf", "epub"].map(|kind| format!("{}.{kind}", book.file_name()));
    print(root, browser, &book, &site.join(&pdf))?;
    eprintln!("Writing the EPUB");
    book.write_epub(&pages, &site.join(&epub)).map_err(cannot)?;
    head::add_downloads(site, &[("PDF", &pdf), ("EPUB", &epub)]).map_err(cannot)
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

/// What `cargo book pdf` is asked for.
#[derive(Debug, Default, PartialEq, Eq)]
struct Order {
    chapter: Option<String>,
    solutions: bool,
    file: Option<PathBuf>,
}

impl Order {
    fn read(rest: &[String]) -> Result<Self, String> {
        let mut order = Self::default();
        for argument in rest {
            match argument.as_str() {
                "--solutions" => order.solutions = true,
                file if file.ends_with(".pdf") && order.file.is_none() => order.file = Some(file.into()),
                chapter
                    if !chapter.starts_with('-') && !chapter.ends_with(".pdf") && order.chapter.is_none() =>
                {
                    order.chapter = Some(chapter.to_owned());
                }
                other => {
                    return Err(format!("error: `cargo book pdf` takes no argument `{other}`\n\n{HELP}"));
                }
            }
        }
        Ok(order)
    }
}

/// The site is built once more for paper, with stills in place of live scenes; the one in target/book stays as it is.
fn pdf(root: &Path, rest: &[String]) -> Result<(), String> {
    let order = Order::read(rest)?;
    let (_, pages) = from_disk(root).map_err(|faults| faults.to_string())?;
    let chapter = order.chapter.map(|asked| paper::chapter(&pages, &asked)).transpose()?;
    let browser = paper::browser()?;
    let cannot = |error: io::Error| format!("error: {error}");
    build_for_paper(root)?;
    let paper = Paper::read(root, &root.join(PAPER).join("html"), chapter.as_deref(), order.solutions)
        .map_err(cannot)?;
    let name = match &chapter {
        Some(chapter) if order.solutions => format!("{chapter}-with-solutions"),
        Some(chapter) => chapter.clone(),
        None => paper.file_name(),
    };
    let target = match &order.file {
        Some(file) => env::current_dir().map_err(cannot)?.join(file),
        None => mdbook::destination(root, None)?.join(format!("{name}.pdf")),
    };
    print(root, &browser, &paper, &target)?;
    let size = fs::metadata(&target).map(|data| data.len()).map_err(cannot)?;
    say(&format!("{} ({} KB)", target.display(), size / 1024));
    Ok(())
}

/// Prints what `build_for_paper` has left.
fn print(root: &Path, browser: &Path, paper: &Paper, target: &Path) -> Result<(), String> {
    let cannot = |error: io::Error| format!("error: {error}");
    let [page, first, profile] =
        ["paper.html", "paper.pdf", "chromium"].map(|name| root.join(PAPER).join(name));
    // The first print says on which page everything stands, the second one prints it.
    let mut numbers = BTreeMap::new();
    for (file, for_what) in
        [(&*first, "to see on which page everything stands"), (target, "with the numbers of the pages")]
    {
        eprintln!("Chromium makes a PDF, {for_what}: the whole book takes it a minute or two");
        fs::write(&page, paper.html("html/", &numbers)).map_err(cannot)?;
        paper::print(browser, &page, file, &profile)?;
        numbers = paper::numbers(&fs::read(file).map_err(cannot)?);
        if numbers.is_empty() {
            eprintln!(
                "This Chromium does not tell where its pages stand: their numbers are missing in the contents."
            );
        }
    }
    Ok(())
}

fn epub(root: &Path, rest: &[String]) -> Result<(), String> {
    let file = match rest {
        [] => None,
        [file] if file.ends_with(".epub") => Some(file),
        _ => return Err(format!("error: `cargo book epub` takes one file, FILE.epub\n\n{HELP}")),
    };
    build_for_paper(root)?;
    let cannot = |error: io::Error| format!("error: {error}");
    let site = root.join(PAPER).join("html");
    let paper = Paper::read(root, &site, None, true).map_err(cannot)?;
    let target = match file {
        Some(file) => env::current_dir().map_err(cannot)?.join(file),
        None => mdbook::destination(root, None)?.join(format!("{}.epub", paper.file_name())),
    };
    paper.write_epub(&site, &target).map_err(cannot)?;
    let size = fs::metadata(&target).map(|data| data.len()).map_err(cannot)?;
    say(&format!("{} ({} KB)", target.display(), size / 1024));
    Ok(())
}

fn build_for_paper(root: &Path) -> Result<(), String> {
    from_disk(root).map_err(|faults| faults.to_string())?;
    eprintln!("Printing the pages once more, for paper");
    mdbook::build(root, Path::new(PAPER), For::Paper)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn order(arguments: &str) -> Result<Order, String> {
        Order::read(&arguments.split_whitespace().map(str::to_owned).collect::<Vec<_>>())
    }

    #[test]
    fn a_pdf_is_ordered_by_chapter_solutions_and_file_in_any_order() {
        let chapter = |name: &str| Some(name.to_owned());
        assert_eq!(order(""), Ok(Order::default()));
        assert_eq!(order("4"), Ok(Order { chapter: chapter("4"), ..Order::default() }));
        let all = Order { chapter: chapter("coin-toss"), solutions: true, file: Some("a.pdf".into()) };
        assert_eq!(order("--solutions a.pdf coin-toss").as_ref(), Ok(&all));
        assert_eq!(order("coin-toss a.pdf --solutions"), Ok(all));
        for (wrong, named) in [("--solution", "--solution"), ("a b", "b"), ("a.pdf b.pdf", "b.pdf")] {
            assert!(order(wrong).unwrap_err().contains(&format!("takes no argument `{named}`")), "{wrong}");
        }
    }

    #[test]
    fn a_chapter_that_is_none_is_named_before_anything_is_built() {
        let said =
            run(Path::new(".."), &["pdf".to_owned(), "coin".to_owned()], &Rendered::default()).unwrap_err();
        assert!(
            said.starts_with("error: there is no chapter `coin`") && said.contains("\n   4  coin-toss "),
            "{said}"
        );
    }
}
