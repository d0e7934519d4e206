//! `cargo book`: what one can ask of the press by hand.

use crate::assets::Rendered;
use crate::mdbook::{self, For};
use crate::paper::{self, Paper, Solutions};
use crate::read::disk::from_disk;
use crate::site::{check, page_metadata, publish, theme};
use crate::{new, serve};
use anyhow::{Context as _, Error, Result, bail, ensure};
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
    /// The answers to the exercises of a chapter on a sheet, without the way there (needs Chromium)
    Answers {
        /// The chapter, by its folder or number, and the file to write
        #[arg(value_name = "CHAPTER or FILE.pdf", num_args = 1..=2, required = true)]
        what: Vec<String>,
    },
    /// A chapter as slides: its guess, scene, figures, equations, mistakes and votes, as a page or, if the file is a PDF, on paper
    Slides {
        /// The chapter, by its folder or number, and the file to write
        #[arg(value_name = "CHAPTER or FILE.html or FILE.pdf", num_args = 1..=2, required = true)]
        what: Vec<String>,
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

fn epub_file(name: &str) -> Result<PathBuf> {
    ensure!(name.ends_with(".epub"), "the name of an EPUB ends with .epub");
    Ok(name.into())
}

/// Runs one command on the book under `root`, which shows what is `drawn`.
pub fn run(root: &Path, arguments: &[String], drawn: &Rendered) -> Result<()> {
    let help = ["help".to_owned()];
    let arguments = if arguments.is_empty() { &help } else { arguments };
    let own = drawn.book.commands;
    if let Some(command) = own.iter().find(|command| command.name == arguments[0]) {
        return (command.run)(root, &arguments[1..]).map_err(Error::msg);
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
        Err(error) => bail!("{}", error.to_string().trim_end()),
    };
    match order {
        Order::Serve(options) => return serve::run(root, &options, &drawn.book),
        Order::Build { dest_dir, paper } => return build(root, dest_dir.as_deref(), paper),
        Order::Test => {
            from_disk(root)?; // of a page that it cannot read mdBook tells no line
            return mdbook::test(root);
        }
        Order::Check => {
            let pages = check::check(root, drawn)?;
            let (figures, scenes) = (drawn.figures.len(), drawn.scenes.len());
            say(&format!(
                "{pages} pages, {figures} figures, {scenes} scenes: nothing wrong; `cargo book test` runs the snippets"
            ));
        }
        Order::Figures { folder } => {
            say(&format!("{} figures in {}", drawn.write_all(&folder)?, folder.display()));
        }
        Order::Pdf { what, solutions } => {
            return pdf(root, what, if solutions { Solutions::Whole } else { Solutions::None });
        }
        Order::Answers { what } => return pdf(root, what, Solutions::Answers),
        Order::Slides { what } => return slides(root, what),
        Order::Epub { file } => {
            let paper = built_for_paper(root, None, Solutions::Whole)?;
            let target = target(root, file, || format!("{}.epub", paper.file_name()))?;
            paper.write_epub(&root.join(PAPER).join("html"), &target)?;
            say_size(&target)?;
        }
        Order::New { folder, git } => {
            let folder = env::current_dir()?.join(folder);
            new::book(root, &folder, git.as_deref()).with_context(|| folder.display().to_string())?;
            say(&format!("a book in {}: `cargo book serve` there shows it", folder.display()));
        }
    }
    Ok(())
}

/// Prints a line; a reader who has closed the pipe does not want it.
fn say(line: &str) {
    let _ = writeln!(io::stdout(), "{line}");
}

fn say_size(file: &Path) -> Result<()> {
    say(&format!("{} ({} KB)", file.display(), fs::metadata(file)?.len() / 1024));
    Ok(())
}

/// Where the site for paper is built.
const PAPER: &str = "target/press/paper";

fn build(root: &Path, folder: Option<&str>, with_paper: bool) -> Result<()> {
    let folder = mdbook::destination(root, folder)?;
    let browser = with_paper.then(paper::browser).transpose()?;
    // It is made beside its place, to which it comes at once when it is whole.
    let (site, beside) = (folder.join("html"), folder.join("unfinished"));
    let cannot = || folder.display().to_string();
    publish::withdraw(&site).and_then(|()| publish::remove(&beside)).with_context(cannot)?;
    let fresh = beside.join("html");
    let made = || {
        from_disk(root)?;
        mdbook::build(mdbook::this_program().as_deref(), root, &beside, For::Readers)?;
        if let Some(browser) = &browser {
            add_paper(root, browser, &fresh)?;
        }
        fs::rename(&fresh, &site).with_context(cannot)
    };
    let built = made();
    publish::remove(&beside).with_context(cannot)?;
    if built.is_ok() {
        say(&format!("The site is in {}", site.display()));
    }
    built
}

/// Puts the book on paper and for readers of EPUBs into its site, and leads to both from the foot of every page.
fn add_paper(root: &Path, browser: &Path, site: &Path) -> Result<()> {
    let book = built_for_paper(root, None, Solutions::Whole)?;
    let [pdf, epub] = ["pdf", "epub"].map(|kind| format!("{}.{kind}", book.file_name()));
    print(root, browser, &book, &site.join(&pdf))?;
    eprintln!("Writing the EPUB");
    book.write_epub(&root.join(PAPER).join("html"), &site.join(&epub))?;
    Ok(page_metadata::add_downloads(site, &[("PDF", &pdf), ("EPUB", &epub)])?)
}

/// A chapter and a file, in any order, each at most once.
fn chapter_and_file(what: Vec<String>) -> Result<(Option<String>, Option<PathBuf>)> {
    let (mut chapter, mut file) = (None, None);
    for word in what {
        let place = if [".pdf", ".html"].iter().any(|ending| word.ends_with(ending)) {
            &mut file
        } else {
            &mut chapter
        };
        if let Some(first) = place.replace(word) {
            let second = place.as_deref().unwrap_or_default();
            bail!("it takes `{first}` or `{second}`, not both");
        }
    }
    Ok((chapter, file.map(PathBuf::from)))
}

fn pdf(root: &Path, what: Vec<String>, solutions: Solutions) -> Result<()> {
    let (chapter, file) = chapter_and_file(what)?;
    let (_, pages) = from_disk(root)?;
    let chapter = chapter.map(|asked| paper::chapter(&pages, &asked)).transpose()?;
    ensure!(
        solutions != Solutions::Answers || chapter.is_some(),
        "`cargo book answers` asks for a chapter: `cargo book answers 1`"
    );
    let browser = paper::browser()?;
    // The whole book has its solutions always.
    let solutions = if chapter.is_none() { Solutions::Whole } else { solutions };
    let paper = built_for_paper(root, chapter.as_deref(), solutions)?;
    let target = target(root, file, || match &chapter {
        Some(chapter) => match solutions {
            Solutions::None => format!("{chapter}.pdf"),
            Solutions::Whole => format!("{chapter}-with-solutions.pdf"),
            Solutions::Answers => format!("{chapter}-answers.pdf"),
        },
        None => format!("{}.pdf", paper.file_name()),
    })?;
    print(root, &browser, &paper, &target)?;
    say_size(&target)
}

fn slides(root: &Path, what: Vec<String>) -> Result<()> {
    let (chapter, file) = chapter_and_file(what)?;
    let (_, pages) = from_disk(root)?;
    let chapter = chapter.context("`cargo book slides` asks for a chapter: `cargo book slides 1`")?;
    let chapter = paper::chapter(&pages, &chapter)?;
    let target = target(root, file, || format!("{chapter}-slides.html"))?;
    let browser =
        target.extension().is_some_and(|ending| ending == "pdf").then(paper::browser).transpose()?;
    let paper = built_for_paper(root, None, Solutions::None)?;
    let slides = paper.slides(&root.join(theme::FOLDER), &chapter)?;
    let [page, profile] = ["slides.html", "chromium"].map(|name| root.join(PAPER).join(name));
    let page = if browser.is_some() { &page } else { &target };
    fs::write(page, slides).with_context(|| page.display().to_string())?;
    browser.map_or(Ok(()), |browser| paper::print(&browser, page, &target, &profile))?;
    say_size(&target)
}

/// The file that somebody asks for, or one of this name where the site lies.
fn target(root: &Path, asked: Option<PathBuf>, name: impl FnOnce() -> String) -> Result<PathBuf> {
    match asked {
        Some(file) => Ok(env::current_dir()?.join(file)),
        None => Ok(mdbook::destination(root, None)?.join(name())),
    }
}

/// Prints what [`built_for_paper`] has left.
fn print(root: &Path, browser: &Path, paper: &Paper, target: &Path) -> Result<()> {
    let [page, first, profile] =
        ["paper.html", "paper.pdf", "chromium"].map(|name| root.join(PAPER).join(name));
    // The first print says on which page everything stands, the second one prints it.
    let mut numbers = BTreeMap::new();
    for (file, for_what) in [
        (&*first, "PDF 1 of 2, to see on which page everything stands"),
        (target, "PDF 2 of 2, with the numbers of the pages"),
    ] {
        eprintln!("Chromium prints {} pages of the book: {for_what}", paper.length());
        fs::write(&page, paper.html("html/", &numbers))?;
        paper::print(browser, &page, file, &profile)?;
        numbers = paper::numbers(&fs::read(file)?);
        if numbers.is_empty() {
            eprintln!(
                "This Chromium does not tell where its pages stand: their numbers are missing in the contents."
            );
        }
    }
    Ok(())
}

/// The site is built once more for paper, with stills in place of live scenes; the one in target/book stays as it is.
fn built_for_paper(root: &Path, chapter: Option<&str>, solutions: Solutions) -> Result<Paper> {
    let (_, pages) = from_disk(root)?;
    eprintln!("Printing the {} pages, for paper", pages.len());
    mdbook::build(mdbook::this_program().as_deref(), root, Path::new(PAPER), For::Paper)?;
    Paper::read(root, &root.join(PAPER).join("html"), chapter, solutions)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_order_that_is_none_is_named_before_anything_is_built() {
        for (wrong, named) in [
            ("chek", "unrecognized subcommand 'chek'"),
            ("check all", "unexpected argument 'all'"),
            ("pdf --solution", "unexpected argument '--solution'"),
            ("pdf a b", "takes `a` or `b`, not both"),
            ("pdf a.pdf b.pdf", "takes `a.pdf` or `b.pdf`, not both"),
            ("pdf coin c.pdf", "there is no chapter `coin`; there are\n      about"),
            ("pdf c.pdf coin", "there is no chapter `coin`; there are\n      about"),
            ("pdf 3", "\n   1  pendulum             The pendulum\n   2  clock "),
            ("serve -p x", "invalid value 'x' for '--port <PORT>'"),
            ("figures", "<FOLDER>"),
            ("answers", "<CHAPTER or FILE.pdf>"),
            ("answers a.pdf", "asks for a chapter"),
            ("epub book.zip", "ends with .epub"),
        ] {
            let words: Vec<String> = wrong.split_whitespace().map(str::to_owned).collect();
            let said = run(Path::new("example"), &words, &Rendered::default()).unwrap_err().to_string();
            assert!(said.contains(named), "{wrong}: {said}");
        }
        let (_, pages) = from_disk(Path::new("example")).unwrap();
        for (asked, name) in
            [("pendulum", "pendulum"), ("clock/", "clock"), ("2", "clock"), ("about", "about")]
        {
            assert_eq!(paper::chapter(&pages, asked).unwrap(), name);
        }
    }
}
