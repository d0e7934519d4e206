//! `cargo book`: what one can ask of the press by hand.

use crate::assets::Rendered;
use crate::mdbook;
use crate::mdbook::For;
use crate::paper;
use crate::paper::Paper;
use crate::read::disk::from_disk;
use crate::site::{check, page_metadata, publish};
use crate::{new, serve};
use clap::{CommandFactory as _, FromArgMatches as _, Parser};
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::{env, fs};

// The comments that document it are what `cargo book help` says.
/// The book: shown, checked, printed
#[derive(Debug, Parser)]
#[command(name = "cargo book", bin_name = "cargo book")]
enum Order {
    /// The book in the browser, following your edits
    Serve(serve::Options),
    /// The site, in target/book/html
    Build {
        /// The folder in which the site becomes a folder `html`
        #[arg(short, long, value_name = "FOLDER")]
        dest_dir: Option<String>,
        /// With links to its PDF and its EPUB, which lie in it (needs Chromium)
        #[arg(long)]
        paper: bool,
    },
    /// Tests the snippets of all pages
    Test,
    /// Says what is wrong with the pages, fast
    Check,
    /// Every figure as a standalone SVG file
    Figures { folder: PathBuf },
    /// The whole book for paper, its solutions at the end, or a handout of one chapter (needs Chromium)
    Pdf {
        /// A chapter, by its folder or number, and the file to write; by default the whole book, into target/book
        #[arg(value_name = "CHAPTER or FILE.pdf", num_args = 0..=2)]
        what: Vec<String>,
        /// The handout with the solutions of the chapter
        #[arg(long)]
        solutions: bool,
    },
    /// The whole book for readers of EPUBs
    Epub {
        #[arg(value_name = "FILE.epub", value_parser = epub_file)]
        file: Option<PathBuf>,
    },
    /// A book of three pages that is yours to change; it depends on this press, where it lies
    New {
        folder: PathBuf,
        /// It depends on the press in this repository
        #[arg(long, value_name = "URL")]
        git: Option<String>,
    },
}

fn epub_file(name: &str) -> Result<PathBuf, String> {
    if name.ends_with(".epub") {
        Ok(name.into())
    } else {
        Err("the name of an EPUB ends with .epub".to_owned())
    }
}

/// Runs one command on the book under `root`, which shows what is `drawn`; `Err` holds what to print before
/// exiting with status 1.
///
/// # Errors
/// A message for the reader, complete.
pub fn run(root: &Path, arguments: &[String], drawn: &Rendered) -> Result<(), String> {
    let help = ["help".to_owned()];
    let arguments = if arguments.is_empty() { &help } else { arguments };
    let own = drawn.book.commands;
    if let Some(command) = own.iter().find(|command| command.name == arguments[0]) {
        return (command.run)(root, &arguments[1..]);
    }
    let more: String = own.iter().map(|own| format!("  {:<8} {}\n", own.name, own.help)).collect();
    let more = if own.is_empty() { more } else { format!("Of this book:\n{more}") };
    let said = Order::command().after_help(more);
    let said = said.try_get_matches_from([&["cargo book".to_owned()], arguments].concat());
    let order = match said.and_then(|said| Order::from_arg_matches(&said)) {
        Ok(order) => order,
        Err(help) if !help.use_stderr() => {
            say(help.to_string().trim_end());
            return Ok(());
        }
        Err(error) => return Err(error.to_string().trim_end().to_owned()),
    };
    match order {
        Order::Serve(options) => serve::run(root, &options, &drawn.book),
        Order::Build { dest_dir, paper } => build(root, dest_dir.as_deref(), paper),
        Order::Test => {
            // Of a page that it cannot read mdBook tells no line.
            from_disk(root).map_err(|faults| faults.to_string())?;
            mdbook::test(root)
        }
        Order::Check => {
            let pages = check::check(root, drawn).map_err(|faults| faults.to_string())?;
            say(&format!(
                "{pages} pages, {} figures, {} scenes: nothing wrong; `cargo book test` runs the snippets",
                drawn.figures.len(),
                drawn.scenes.len()
            ));
            Ok(())
        }
        Order::Figures { folder } => {
            let count =
                drawn.write_all(&folder).map_err(|error| format!("error: {}: {error}", folder.display()))?;
            say(&format!("{count} figures in {}", folder.display()));
            Ok(())
        }
        Order::Pdf { what, solutions } => pdf(root, what, solutions),
        Order::Epub { file } => epub(root, file.as_deref()),
        Order::New { folder, git } => {
            let folder = env::current_dir().map_err(|error| format!("error: {error}"))?.join(folder);
            new::book(root, &folder, git.as_deref())
                .map_err(|error| format!("error: {}: {error}", folder.display()))?;
            say(&format!("a book in {}: `cargo book serve` there shows it", folder.display()));
            Ok(())
        }
    }
}

/// Prints a line; a reader who has closed the pipe does not want it.
fn say(line: &str) {
    let _ = writeln!(io::stdout(), "{line}");
}

/// Where the site for paper is built.
const PAPER: &str = "target/press/paper";

fn build(root: &Path, folder: Option<&str>, with_paper: bool) -> Result<(), String> {
    let folder = mdbook::destination(root, folder)?;
    let browser = with_paper.then(paper::browser).transpose()?;
    // It is made beside its place, to which it comes at once when it is whole.
    let (site, beside) = (folder.join("html"), folder.join("unfinished"));
    let cannot = |error: io::Error| format!("error: {}: {error}", folder.display());
    publish::withdraw(&site).and_then(|()| publish::remove(&beside)).map_err(cannot)?;
    let fresh = beside.join("html");
    let built = from_disk(root)
        .map_err(|faults| faults.to_string())
        .and_then(|_| mdbook::build(root, &beside, For::Readers))
        .and_then(|()| browser.map_or(Ok(()), |browser| add_paper(root, &browser, &fresh)))
        .and_then(|()| fs::rename(&fresh, &site).map_err(cannot));
    publish::remove(&beside).map_err(cannot)?;
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
    page_metadata::add_downloads(site, &[("PDF", &pdf), ("EPUB", &epub)]).map_err(cannot)
}

/// A chapter and a file, in any order, each at most once.
fn chapter_and_file(what: Vec<String>) -> Result<(Option<String>, Option<String>), String> {
    let (mut chapter, mut file) = (None, None);
    for word in what {
        let place = if word.ends_with(".pdf") { &mut file } else { &mut chapter };
        if let Some(first) = place.replace(word) {
            let second = place.as_deref().unwrap_or_default();
            return Err(format!("error: `cargo book pdf` takes `{first}` or `{second}`, not both"));
        }
    }
    Ok((chapter, file))
}

/// The site is built once more for paper, with stills in place of live scenes; the one in target/book stays as it is.
fn pdf(root: &Path, what: Vec<String>, solutions: bool) -> Result<(), String> {
    let (chapter, file) = chapter_and_file(what)?;
    let (_, pages) = from_disk(root).map_err(|faults| faults.to_string())?;
    let chapter = chapter.map(|asked| paper::chapter(&pages, &asked)).transpose()?;
    let browser = paper::browser()?;
    let cannot = |error: io::Error| format!("error: {error}");
    build_for_paper(root)?;
    let paper =
        Paper::read(root, &root.join(PAPER).join("html"), chapter.as_deref(), solutions).map_err(cannot)?;
    let name = match &chapter {
        Some(chapter) if solutions => format!("{chapter}-with-solutions"),
        Some(chapter) => chapter.clone(),
        None => paper.file_name(),
    };
    let target = match &file {
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

fn epub(root: &Path, file: Option<&Path>) -> Result<(), String> {
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

    #[test]
    fn a_pdf_is_ordered_by_chapter_and_file_in_any_order() {
        let asked = |words: &str| chapter_and_file(words.split_whitespace().map(str::to_owned).collect());
        let both = (Some("coin-toss".to_owned()), Some("a.pdf".to_owned()));
        assert_eq!(asked(""), Ok((None, None)));
        assert_eq!(asked("4"), Ok((Some("4".to_owned()), None)));
        assert_eq!(asked("a.pdf coin-toss").as_ref(), Ok(&both));
        assert_eq!(asked("coin-toss a.pdf"), Ok(both));
        for wrong in ["a b", "a.pdf b.pdf"] {
            let (first, second) = wrong.split_once(' ').unwrap();
            assert!(asked(wrong).unwrap_err().contains(&format!("`{first}` or `{second}`")), "{wrong}");
        }
    }

    #[test]
    fn an_order_that_is_none_is_named() {
        let said = |words: &str| {
            let words: Vec<String> = words.split_whitespace().map(str::to_owned).collect();
            run(Path::new(".."), &words, &Rendered::default()).unwrap_err()
        };
        for (wrong, named) in [
            ("chek", "unrecognized subcommand 'chek'"),
            ("check all", "unexpected argument 'all'"),
            ("pdf --solution", "unexpected argument '--solution'"),
            ("serve -p x", "invalid value 'x' for '--port <PORT>'"),
            ("figures", "<FOLDER>"),
            ("epub book.zip", "ends with .epub"),
        ] {
            assert!(said(wrong).starts_with("error: ") && said(wrong).contains(named), "{}", said(wrong));
        }
    }

    #[test]
    fn a_chapter_that_is_none_is_named_before_anything_is_built() {
        let said = run(Path::new("example"), &["pdf".to_owned(), "coin".to_owned()], &Rendered::default())
            .unwrap_err();
        assert!(
            said.starts_with("error: there is no chapter `coin`") && said.contains("\n   1  pendulum "),
            "{said}"
        );
    }
}
