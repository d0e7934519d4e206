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
#![doc = ""]
#![doc = include_str!("../DIALECT.md")]

pub mod assets;
pub mod book;
pub mod command;
pub mod fault;
pub mod paper;
pub mod print;
pub mod read;
pub mod site;

mod colours;
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
    /// Its live scenes, each with where it stands: `turning` opens that chapter, `turning/middle-axis` is on that page.
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
