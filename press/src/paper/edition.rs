//! Which edition of the book this is.

use crate::book;
use crate::fault::Faults;
use std::path::Path;
use std::process::{Command, Stdio};

/// The version that the manifest tells, and the commit that is checked out.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Edition {
    /// `0.1.0`.
    pub version: Option<String>,
    /// The first digits of the commit's name, and its day.
    pub commit: Option<(String, String)>,
    /// Whether files have changed since.
    pub is_changed: bool,
}

impl Edition {
    /// That of the project in `root`; without git there is no commit.
    #[must_use]
    pub fn of(root: &Path) -> Self {
        let manifest = book::text(root, "Cargo.toml", &mut Faults::default());
        let manifest = manifest.and_then(|text| text.parse::<toml::Table>().ok()).unwrap_or_default();
        let version =
            |table: Option<&toml::Value>| Some(table?.get("package")?.get("version")?.as_str()?.to_owned());
        let alone = manifest.get("package").and_then(|package| package.get("version")?.as_str());
        let version = version(manifest.get("workspace")).or_else(|| alone.map(str::to_owned));
        let commit = git(root, &["rev-parse", "--short=10", "HEAD"]).filter(|commit| !commit.is_empty());
        let day = || git(root, &["show", "--no-patch", "--format=%cs", "HEAD"]).unwrap_or_default();
        let is_changed = commit.is_some()
            && git(root, &["status", "--porcelain", "--untracked-files=no"])
                .is_some_and(|files| !files.is_empty());
        Self { version, commit: commit.map(|commit| (commit, day())), is_changed }
    }

    /// `version 0.1.0, commit 9096a56f11 of 2026-11-22`.
    #[must_use]
    pub fn words(&self) -> String {
        let version = self.version.iter().map(|version| format!("version {version}"));
        let changed = if self.is_changed { ", with changes" } else { "" };
        let commit = self.commit.iter().map(|(commit, day)| format!("commit {commit} of {day}{changed}"));
        version.chain(commit).collect::<Vec<_>>().join(", ")
    }
}

/// What git says of the project; `None` if there is no git, or no history.
fn git(root: &Path, arguments: &[&str]) -> Option<String> {
    let said = Command::new("git").args(arguments).current_dir(root).stdin(Stdio::null()).output().ok()?;
    said.status.success().then(|| String::from_utf8_lossy(&said.stdout).trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edition_says_its_version_and_its_commit_if_there_is_one() {
        let version = Some("1.2.3".to_owned());
        let alone = Edition { version, ..Edition::default() };
        assert_eq!(alone.words(), "version 1.2.3");
        let commit = Some(("0123456789".to_owned(), "2026-11-22".to_owned()));
        let whole = Edition { commit, is_changed: true, ..alone };
        assert_eq!(whole.words(), "version 1.2.3, commit 0123456789 of 2026-11-22, with changes");
    }

    #[test]
    fn the_version_is_that_of_the_workspace() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        assert_eq!(Edition::of(root).version.as_deref(), Some(env!("CARGO_PKG_VERSION")));
    }
}
