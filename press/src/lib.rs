//! The press: prints the book.
//!
//! It is an mdBook preprocessor (Markdown in our dialect → Markdown with MathML, numbers, figures), an mdBook
//! renderer that finishes and checks the site, and the `cargo book` command. A book calls [`main`] and says in a
//! [`Book`] what it has.
//!
//! # What happens to a page
//!
//! | room | what it does |
//! |---|---|
//! | [`read`] | finds the pages, and what stands on them |
//! | [`print`](mod@print) | formulas, figures, references, panels: the page as mdBook reads it |
//! | [`site`] | what is done before mdBook renders and after: modules of scenes, search, links, documentation, checks |
//! | [`paper`] | the site as PDF and EPUB |
//! | `serve` | the site while it is written |
//! | [`command`], `new` | what people type |
//!
//! Each uses what stands above it here, and what is below them all: [`fault`], [`book`] (pages), [`assets`] (figures,
//! tables, scenes), `html`, `colours`, `mdbook`.
//!
//! # The dialect of the pages
//!
//! | write | get |
//! |---|---|
//! | `$r_0$`, `$$…$$` in a paragraph of its own | mathematics, as MathML, in the colours of its letters; `\$` is a dollar |
//! | `[words]{.spin}` | words in the colour of a quantity: body, spin, momentum, contact, force |
//! | `$$…$$ {#eq:steady-radius}` | an equation with a number, chapter first: (1.9), and behind a sign what the library has of it |
//! | `… {#eq:steady-radius source=19}` | the same, with the source's number and the anchor `#source-19` |
//! | `… {#eq:r source="12 13" corrected}` | two numbers of the source; the equation corrects it |
//! | `![Caption.](fig:machine)` in a paragraph of its own | the figure, with number and caption |
//! | `words[^name]`, and `[^name]: The note.` somewhere below | a note in the margin, with maths and references |
//! | `![Caption.](fig:machine)[^name]` | the same, on a figure |
//! | `![Caption.](scene:turning)` in a paragraph of its own | the live scene of the chapter, above its first equation |
//! | `[set the spin to three](scene:turning?spin=3&kick=0)` | a link that sets the scene, on the page of the scene |
//! | a Markdown table, and right below it a paragraph `Table: what it holds.` | a table with its caption |
//! | `![Caption.](table:methods)` in a paragraph of its own | a table that the library gives |
//! | `![Caption.](table:exercises)` in a paragraph of its own | how many exercises each chapter has, of which grade, and their minutes |
//! | `let r = wheel.rate(); // → 4.317 rad/s` in a snippet | a number that the test holds to every digit shown |
//! | `## Title {#sec:motion}` | a section that can be referred to |
//! | `## Title {#ex:peak}` | an exercise with a number; it holds a hint in `<details>` |
//! | `## {#sol:peak}` | its solution, titled and linked both ways; on the site it unfolds below its exercise |
//! | `**Answer.** 5 m`, the first paragraph of a solution | what unfolds as the answer |
//! | a table whose rows begin with `@source:19` and have a verdict in their third cell | the table below a square for each row, with the verdict's first word as its class |
//! | `- {#cite:key "Name 1999"} …` | an entry of the bibliography |
//! | `@eq:steady-radius`, `@fig:machine`, `@scene:turning`, `@ex:peak`, `@sol:peak`, `@sec:motion` | a link with number or title |
//! | `@source:19` | a link to the equation that has this number in the source |
//! | `@cite:key` | a link with the entry's short name |
//!
//! Labels are made of lower-case letters, digits and hyphens, and are unique in the whole book. Counters run
//! through all pages of a numbered chapter; equations, figures, scenes and exercises can stand in numbered chapters
//! only. Notes are numbered on each page and stand behind the outermost block that refers to them. In a
//! numbered chapter the title of a page stands below `Chapter 4`, or a link to the first page of its chapter. Sections
//! of the second level are counted through the chapter, and a reference says the number, `§4.2`; its title shows to those
//! who point at it.
//!
//! Two tables of `conventions.md` say which letters stand for which coloured quantity, in the whole book and in
//! single chapters. A table below a heading `{#sec:symbols-one}`, on any page, has the colours of the chapter `one`.
//! A formula is tied to the punctuation, bracket, ending or unit beside it, and a number to its unit. In round
//! brackets the number of an equation has none of its own: `(@eq:x)` is printed as (1.9), and `(see @eq:x)` as (see
//! Eq. 1.9).
//!
//! In a table a column of numbers is set with their points below one another. (At least two cells are numbers, the
//! rest dashes or short words.) There and in captions and notes `1.6e-8` is printed as 1.6·10⁻⁸.
//!
//! # Snippets
//!
//! All of a snippet is tested; its page shows what a reader would type. Lines behind `# ` are hidden, and the
//! assertions that a snippet ends with are folded below it, with the comments right above them, if they take up more
//! than three lines and stand below something else.
//!
//! A number behind `// → ` is an output. The test rounds the value of the statement to as many digits and refuses
//! any other: what a `let` at the beginning of the statement binds, or the statement itself if it has one line. The
//! value is an `f64`, an integer, a pair or an array; several numbers stand with commas between, `// → 1.2, 3.4`,
//! and any words may follow. Very large and small ones are written `1.2e-5`.
//!
//! # Faults
//!
//! All faults of a run are reported, each as `error: book/page.md:80: …`, and nothing is built.
//! `mdbook build`, `mdbook test` and `cargo book check` send the pages through the same function, so they
//! find the same faults:
//!
//! - labels: one that is unknown or defined twice (also one that a comment in `src/` or `tests/` cites), an
//!   id that stands on a page twice, an unknown, doubled or unused figure, a citation without entry, an entry
//!   that nothing cites;
//! - scenes: one that is unknown or that no page shows, that stands on a page of another chapter or below an
//!   equation, that starts where none of its controls can stand; a link to settings that it does not have, or
//!   from another page;
//! - colours: words in a colour that there is not; a colour or letter of the tables of conventions that is none;
//! - mathematics: LaTeX that is not understood or nested too deeply, a blank line inside `$$`, a stray `$`,
//!   display mathematics that shares its paragraph, mathematics in a heading;
//! - characters that the faces of text, code or mathematics lack: they hold what `font/characters.txt` lists;
//! - links: a dead link or anchor, a link without words or target, a reference `[x][y]` that is
//!   defined nowhere, a link or a figure that Markdown does not read as one;
//! - notes: a footnote that is defined nowhere or twice, or referred to twice or never, that holds more than a
//!   paragraph of words, or hangs on a heading or another note;
//! - headings: none, a second title, a level left out, a heading without words, attributes other than an id;
//! - code: a fence without language, one that is not closed or not tested, a snippet of more than 25 visible
//!   lines or with a line too long for the page, a printed number that is none or belongs to no statement, a
//!   live number without a range that holds it, or to which nothing answers, what only looks like either
//!   (`// -> 7.0`, `// about → 7.0`, `// Live: 0..2`), text indented into a code block;
//! - exercises without hint or solution;
//! - tables without a caption, or with a column that has no name, or in a list; a caption of no table;
//! - raw HTML: elements and attributes other than the few that load, run and style nothing, elements that are
//!   not closed where they were opened, end tags that close nothing, mathematics or references inside;
//! - mdBook's directives `{{#…}}`, control characters, and characters that turn the direction of the text;
//! - pages: one that SUMMARY.md names twice, or that does not exist or is not UTF-8, one that SUMMARY.md
//!   does not name, one outside of the folder or with a name that the site needs; a link to a folder, which may
//!   lead round in a circle;
//! - numbers of the source: one that two equations claim, and one without a row in the ledger.

pub mod assets;
pub mod book;
pub mod command;
pub mod fault;
pub mod paper;
pub mod print;
pub mod read;
pub mod site;

mod colours;
mod html;
mod mdbook;
mod new;
mod serve;

use anyhow::Result;
use assets::Rendered;
use live::Scene;
use std::io::{self, IsTerminal, Read};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

/// What a book tells the press about itself.
#[derive(Debug, Clone, Copy, Default)]
pub struct Book {
    /// Its library, which is the package in the project's root, by the name that snippets use: `pendulum`.
    pub library: &'static str,
    /// The folders of its project in which comments of Rust files cite labels, that of the library's sources first.
    pub code: &'static [&'static str],
    /// The folder into which its build script has rendered figures and tables: `env!("OUT_DIR")`.
    pub drawn: &'static str,
    /// Its live scenes, each with the folder of its chapter.
    pub scenes: &'static [(&'static str, &'static Scene)],
    /// The package that has its snippets as tests, and that browsers run.
    pub snippets: &'static str,
    /// What else `cargo book` can do for it.
    pub commands: &'static [Command],
}

impl Book {
    /// A book that has its code in the folders `src` and `book`, and no commands of its own.
    pub const fn new(
        library: &'static str,
        drawn: &'static str,
        scenes: &'static [(&'static str, &'static Scene)],
        snippets: &'static str,
    ) -> Self {
        Self { library, code: &["src", "book"], drawn, scenes, snippets, commands: &[] }
    }
}

/// A command of a book's own: `cargo book measure`.
#[derive(Debug, Clone, Copy)]
pub struct Command {
    /// Its name.
    pub name: &'static str,
    /// What it does, in a line.
    pub help: &'static str,
    /// Does it, in the project's root, with the arguments behind the name; an error is words for the caller.
    pub run: fn(&Path, &[String]) -> Result<(), String>,
}

/// The press as a program: called by mdBook as preprocessor (without arguments) and renderer (`finish`), and by people
/// as `cargo book`.
pub fn main(book: &Book) -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    match run(book, &arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{}", fault::said(&error));
            ExitCode::FAILURE
        }
    }
}

fn run(book: &Book, arguments: &[String]) -> Result<()> {
    match arguments.first().map(String::as_str) {
        Some("supports") => Ok(()), // html and test; book.toml names them
        Some("finish") => site::postprocess::run(io::stdin().lock(), &Rendered::read(book)?),
        None if !io::stdin().is_terminal() => answer(book),
        _ => command::run(&root(), arguments, &Rendered::of(book)?),
    }
}

/// Answers mdBook's request on standard input; without one, somebody has typed `cargo book` alone.
fn answer(book: &Book) -> Result<()> {
    let mut request = Vec::new();
    io::stdin().lock().read_to_end(&mut request)?;
    let drawn = Rendered::of(book)?;
    if request.is_empty() {
        return command::run(&root(), &[], &drawn);
    }
    site::preprocess::run(request.as_slice(), io::stdout().lock(), drawn)
}

/// The project's root: the nearest folder upwards with a book.toml, from here or from the package that Cargo runs.
fn root() -> PathBuf {
    let here = env::current_dir().unwrap_or_default();
    let package = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let with_book = |folder: &&Path| folder.join("book.toml").is_file();
    let found = here.ancestors().find(with_book).or_else(|| package.ancestors().find(with_book));
    let root = found.unwrap_or(&here);
    fs::canonicalize(root).unwrap_or_else(|_| root.to_owned())
}
