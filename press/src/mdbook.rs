//! Finding mdBook, or installing it once.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, io};

/// The series that the press speaks with, and the version that is installed if there is none.
const SERIES: &str = "0.5.";
const VERSION: &str = "0.5.4";

/// What of it is optimised: where a build of the book spends its time. The rest, mostly the server, compiles
/// in half the time.
const OPTIMISED: [&str; 12] = [
    "elasticlunr-rs",
    "handlebars",
    "html5ever",
    "markup5ever",
    "mdbook-html",
    "memchr",
    "pest",
    "pulldown-cmark",
    "regex-automata",
    "serde_json",
    "sha2",
    "tendril",
];

/// The program `mdbook` of the right series: the one on PATH, else the one under `target/tools`, else a fresh
/// one there.
///
/// Installing takes some minutes and needs a network; it says so on standard error.
///
/// # Errors
/// If there is none and it cannot be installed.
pub fn locate(root: &Path) -> io::Result<PathBuf> {
    let tools = root.join("target").join("tools");
    let local = tools.join("bin").join("mdbook").with_extension(env::consts::EXE_EXTENSION);
    for candidate in [PathBuf::from("mdbook"), local.clone()] {
        if is_of_series(&candidate) {
            return Ok(candidate);
        }
    }
    eprintln!(
        "There is no mdBook {SERIES}x on this machine. Installing mdBook {VERSION} into target/tools: \
         some two to five minutes, once, and it needs a network."
    );
    let status =
        Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
            .args(["install", "mdbook", "--version", VERSION, "--locked", "--root"])
            .arg(&tools)
            .args(["--config", "profile.release.opt-level=0"])
            .args(OPTIMISED.iter().flat_map(|name| {
                ["--config".to_owned(), format!("profile.release.package.{name}.opt-level=2")]
            }))
            .current_dir(env::temp_dir()) // away from this workspace's settings
            .env_remove("CARGO_TARGET_DIR")
            .stdin(Stdio::null())
            .status()?;
    if status.success() && is_of_series(&local) {
        Ok(local)
    } else {
        Err(io::Error::other(format!(
            "mdBook {VERSION} could not be installed; `cargo install mdbook --version {VERSION}` may say more"
        )))
    }
}

fn is_of_series(program: &Path) -> bool {
    let output = Command::new(program).arg("--version").stdin(Stdio::null()).stderr(Stdio::null()).output();
    output.is_ok_and(|output| {
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        said.trim().trim_start_matches("mdbook").trim().trim_start_matches('v').starts_with(SERIES)
    })
}
