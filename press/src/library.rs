//! The one thing that the press has to know of a book's library: its name.
//!
//! The build scripts share this file: what they write calls the crate `library`, as the workspace's manifest does, by
//! the name that pages and figures know it by.

/// The name of the package in a manifest, as Rust and rustdoc write it.
pub(crate) fn name(manifest: &str) -> Option<String> {
    package(manifest).map(|name| name.replace('-', "_"))
}

/// The same, as Cargo writes it.
pub(crate) fn package(manifest: &str) -> Option<String> {
    let package = manifest.lines().map(str::trim).skip_while(|line| *line != "[package]").skip(1);
    let mut entries =
        package.take_while(|line| !line.starts_with('[')).filter_map(|line| line.split_once('='));
    let (_, value) = entries.find(|(key, _)| key.trim() == "name")?;
    value.split('"').nth(1).map(str::to_owned)
}

/// What makes the crate `library` known by its own name.
#[cfg_attr(not(test), allow(dead_code, reason = "for the build scripts alone"))]
pub(crate) fn known_as(name: &str) -> String {
    format!("extern crate library as {name};")
}

#[cfg(test)]
mod tests {
    use super::{known_as, name, package};

    #[test]
    fn the_library_is_the_package_of_the_manifest() {
        let manifest = "[workspace.dependencies]\nname = \"a\"\n[package]\nversion = \"1\"\nname = \"two-words\" # b\n[lib]\n";
        assert_eq!(name(manifest).as_deref(), Some("two_words"));
        assert_eq!(package(manifest).as_deref(), Some("two-words"));
        assert_eq!(name("[package]\n[lib]\nname = \"c\"\n"), None);
        assert_eq!(name("[workspace]\n"), None);
        assert_eq!(known_as("two_words"), "extern crate library as two_words;");
    }
}
