//! The press as a program: called by mdBook as preprocessor (`book`) and renderer (`book finish`), and by people as
//! `cargo book`. It is a package of its own, so that a figure which is drawn again compiles only this file.

mod scenes;

use press::rendered::Rendered;
use press::{command, finish, preprocess};
use std::io::{self, IsTerminal, Read};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

/// Where the build script has put the figures.
const DRAWN: &str = env!("OUT_DIR");

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &[String]) -> Result<(), String> {
    let mut drawn = Rendered::read(Path::new(DRAWN)).map_err(|error| format!("error: {error}"))?;
    let command = arguments.first().map(String::as_str);
    if command != Some("finish") {
        drawn.scenes = scenes::all().map_err(|error| format!("error: {error}"))?;
    }
    match command {
        None if !io::stdin().is_terminal() => answer(drawn),
        Some("supports") => Ok(()), // html and test; book.toml names them
        Some("finish") => finish::run(io::stdin().lock(), &drawn).map_err(|failed| failed.to_string()),
        _ => command::run(&root(), arguments, &drawn),
    }
}

/// Answers mdBook's request on standard input; without one, somebody has typed `cargo book` alone.
fn answer(drawn: Rendered) -> Result<(), String> {
    let mut request = Vec::new();
    io::stdin().lock().read_to_end(&mut request).map_err(|error| format!("error: {error}"))?;
    if request.is_empty() {
        return command::run(&root(), &[], &drawn);
    }
    preprocess::run(request.as_slice(), io::stdout().lock(), drawn).map_err(|failed| failed.to_string())
}

/// The project's root: the nearest folder upwards with a book.toml, else the one that Cargo runs the press of.
fn root() -> PathBuf {
    let here = env::current_dir().unwrap_or_default();
    let package = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let found = here.ancestors().find(|folder| folder.join("book.toml").is_file());
    let root = found.or_else(|| package.ancestors().nth(2)).unwrap_or(&here);
    fs::canonicalize(root).unwrap_or_else(|_| root.to_owned())
}
