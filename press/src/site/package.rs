//! What Cargo says of the project's packages: `cargo metadata` has read their manifests.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

/// Cargo in this folder, with nothing to read.
pub(crate) fn cargo(folder: &Path) -> Command {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.current_dir(folder).stdin(Stdio::null());
    cargo
}

/// A package of the project.
#[derive(Debug, Clone)]
pub(crate) struct Package {
    /// Its name, as Cargo writes it.
    pub(crate) name: String,
    pub(crate) version: String,
    /// Its library, if it has one.
    pub(crate) library: Option<Library>,
    /// The folder of all that Cargo makes.
    pub(crate) target: PathBuf,
}

/// The library of a package.
#[derive(Debug, Clone)]
pub(crate) struct Library {
    /// Its name, as Rust and rustdoc write it.
    pub(crate) name: String,
    /// The folder of its sources.
    pub(crate) sources: PathBuf,
}

impl Package {
    /// The package in `root`, if there is one that Cargo can read.
    pub(crate) fn read(root: &Path) -> Option<Self> {
        let manifest = fs::canonicalize(root.join("Cargo.toml")).ok()?;
        Self::find(root, |package| package["manifest_path"].as_str().map(Path::new) == Some(&manifest))
    }

    /// The package whose library Rust calls `library`, in the workspace that `root` belongs to.
    pub(crate) fn of_library(root: &Path, library: &str) -> Option<Self> {
        let is_it = |target: &Value| target["kind"][0] == "lib" && target["name"] == library;
        Self::find(root, |package| package["targets"].as_array().is_some_and(|all| all.iter().any(is_it)))
    }

    fn find(root: &Path, is_it: impl Fn(&Value) -> bool) -> Option<Self> {
        let answer = cargo(root)
            .args(["metadata", "--no-deps", "--format-version", "1"])
            .stderr(Stdio::null())
            .output()
            .ok()?;
        let metadata: Value = serde_json::from_slice(&answer.stdout).ok()?;
        let package = metadata["packages"].as_array()?.iter().find(|package| is_it(package))?;
        let library = package["targets"].as_array()?.iter().find(|target| target["kind"][0] == "lib");
        let text = |value: &Value| value.as_str().map(str::to_owned);
        Some(Self {
            name: text(&package["name"])?,
            version: text(&package["version"])?,
            library: library.and_then(|target| {
                let sources = Path::new(target["src_path"].as_str()?).parent()?.to_owned();
                Some(Library { name: text(&target["name"])?, sources })
            }),
            target: text(&metadata["target_directory"])?.into(),
        })
    }
}
