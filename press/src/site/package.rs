//! What Cargo says of the package in the project's root: `cargo metadata` has read its manifest.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

/// The package in the project's root.
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
        let answer = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
            .args(["metadata", "--no-deps", "--format-version", "1", "--manifest-path"])
            .arg(&manifest)
            .stdin(Stdio::null())
            .stderr(Stdio::null())
            .output()
            .ok()?;
        let metadata: Value = serde_json::from_slice(&answer.stdout).ok()?;
        let mut packages = metadata["packages"].as_array()?.iter();
        let package =
            packages.find(|package| package["manifest_path"].as_str().map(Path::new) == Some(&manifest))?;
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_package_is_what_cargo_says_of_it() {
        let folder = env::temp_dir().join(format!("press-package-{}", std::process::id()));
        fs::create_dir_all(folder.join("src")).unwrap();
        assert!(Package::read(&folder).is_none());
        fs::write(folder.join("Cargo.toml"), "[package]\n").unwrap();
        assert!(Package::read(&folder).is_none());
        let manifest = "[workspace]\n[workspace.package]\nversion = \"1.2.4\"\n[package]\nname = \"two-words\"\nversion.workspace = true\n";
        fs::write(folder.join("Cargo.toml"), manifest).unwrap();
        fs::write(folder.join("src/main.rs"), "").unwrap();
        let program = Package::read(&folder).unwrap();
        assert!(program.name == "two-words" && program.version == "1.2.4" && program.library.is_none());
        fs::write(folder.join("src/lib.rs"), "").unwrap();
        let library = Package::read(&folder).unwrap().library.unwrap();
        assert!(library.name == "two_words" && library.sources.ends_with("src"), "{library:?}");
        fs::remove_dir_all(folder).unwrap();
    }
}
