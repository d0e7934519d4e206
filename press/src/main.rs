//! The press as a program: called by mdBook as preprocessor (`press`) and renderer (`press finish`), and by people as
//! `cargo book`.

use press::{command, finish, preprocess};
use std::io::{self, IsTerminal, Read};
use std::path::Path;
use std::process::ExitCode;
use std::{env, fs};

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let outcome = match arguments.first().map(String::as_str) {
        None if !io::stdin().is_terminal() => answer(),
        Some("supports") => Ok(()), // html and test; book.toml names them
        Some("finish") => finish::run(io::stdin().lock()).map_err(|failed| failed.to_string()),
        _ => command::run(&root(), &arguments),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// Answers mdBook's request on standard input; without one, somebody has typed `cargo book` alone.
fn answer() -> Result<(), String> {
    let mut request = Vec::new();
    io::stdin().lock().read_to_end(&mut request).map_err(|error| format!("error: {error}"))?;
    if request.is_empty() {
        return command::run(&root(), &[]);
    }
    preprocess::run(request.as_slice(), io::stdout().lock()).map_err(|failed| failed.to_string())
}

/// The project's root: the nearest folder upwards with a book.toml, else the one in which the press was built.
fn root() -> std::path::PathBuf {
    let built = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."));
    let here = env::current_dir().ok();
    let found =
        here.as_deref().and_then(|here| here.ancestors().find(|folder| folder.join("book.toml").is_file()));
    fs::canonicalize(found.unwrap_or(built)).unwrap_or_else(|_| built.to_path_buf())
}
