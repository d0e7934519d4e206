//! Which edition of the book this is.

use crate::site::package::Package;
use std::path::Path;
use std::process::{Command, Stdio};

/// The version of a package and the commit, if git knows one: `0.2.0, 1f2e3d4c`, with `, changed` behind it if files
/// differ from the commit.
pub(crate) fn edition(root: &Path, package: Option<&Package>) -> String {
    let commit = git(root, &["rev-parse", "--short=8", "HEAD"]).map(|commit| {
        let is_changed = git(root, &["status", "--porcelain"]).is_some_and(|changes| !changes.is_empty());
        if is_changed { format!("{commit}, changed") } else { commit }
    });
    let version = package.map(|package| package.version.clone());
    version.into_iter().chain(commit).collect::<Vec<_>>().join(", ")
}

/// The day of the commit, `2026-11-22`, if git knows one.
pub(crate) fn day(root: &Path) -> Option<String> {
    git(root, &["show", "--no-patch", "--format=%cs", "HEAD"]).filter(|day| !day.is_empty())
}

/// What git answers; nothing where there is no git, or no repository.
fn git(root: &Path, arguments: &[&str]) -> Option<String> {
    let answer = Command::new("git").args(arguments).current_dir(root).stdin(Stdio::null()).output().ok()?;
    let words = String::from_utf8(answer.stdout).ok()?;
    answer.status.success().then(|| words.trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn an_edition_is_the_version_and_the_commit() {
        let folder = std::env::temp_dir().join(format!("press-edition-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        assert_eq!(edition(&folder, None), "");
        let version = "1.2.4".to_owned();
        let package = Package { name: String::new(), version, library: None, target: folder.clone() };
        assert_eq!(edition(&folder, Some(&package)), "1.2.4");
        let run = |arguments: &[&str]| git(&folder, arguments).unwrap();
        run(&["init", "--quiet"]);
        let name = ["-c", "user.name=A", "-c", "user.email=a@example.org"];
        run(&[&name[..], &["commit", "--quiet", "--allow-empty", "--message", "First"]].concat());
        let commit = run(&["rev-parse", "--short=8", "HEAD"]);
        assert_eq!(edition(&folder, Some(&package)), format!("1.2.4, {commit}"));
        fs::write(folder.join("new"), "").unwrap();
        assert_eq!(edition(&folder, None), format!("{commit}, changed"));
        fs::remove_dir_all(&folder).unwrap();
    }
}
