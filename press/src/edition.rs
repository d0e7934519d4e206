//! Which edition of the book this is.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

/// The version that the package in the project's root gives itself, and the commit, if git knows one:
/// `0.2.0, 1f2e3d4c`, with `, changed` behind it if files differ from the commit.
pub(crate) fn edition(root: &Path) -> String {
    let manifest = fs::read_to_string(root.join("Cargo.toml")).unwrap_or_default();
    let manifest: toml::Table = manifest.parse().unwrap_or_default();
    let of_workspace = manifest.get("workspace").and_then(|workspace| workspace.get("package"));
    let packages = [manifest.get("package"), of_workspace].into_iter().flatten();
    let mut versions = packages.filter_map(|package| package.get("version")?.as_str());
    let version = versions.next().map(str::to_owned);
    let commit = git(root, &["rev-parse", "--short=8", "HEAD"]).map(|commit| {
        let is_changed = git(root, &["status", "--porcelain"]).is_some_and(|changes| !changes.is_empty());
        if is_changed { format!("{commit}, changed") } else { commit }
    });
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

    #[test]
    fn a_folder_without_package_and_git_has_no_edition() {
        let folder = std::env::temp_dir().join(format!("press-edition-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        assert_eq!(edition(&folder), "");
        fs::write(folder.join("Cargo.toml"), "[package]\nversion = \"1.2.3\"\n").unwrap();
        assert_eq!(edition(&folder), "1.2.3");
        fs::write(
            folder.join("Cargo.toml"),
            "[workspace.package]\nversion = \"1.2.4\"\n[package]\nversion.workspace = true\n",
        )
        .unwrap();
        assert_eq!(edition(&folder), "1.2.4");
        let run = |arguments: &[&str]| git(&folder, arguments).unwrap();
        run(&["init", "--quiet"]);
        run(&["add", "."]);
        let name = ["-c", "user.name=A", "-c", "user.email=a@example.org"];
        run(&[&name[..], &["commit", "--quiet", "--message", "First"]].concat());
        let commit = run(&["rev-parse", "--short=8", "HEAD"]);
        assert_eq!(edition(&folder), format!("1.2.4, {commit}"));
        fs::write(folder.join("new"), "").unwrap();
        assert_eq!(edition(&folder), format!("1.2.4, {commit}, changed"));
        fs::remove_dir_all(&folder).unwrap();
    }
}
