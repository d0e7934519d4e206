//! The scripts of a book as they travel: without the comments that tell their authors what they do.

use mdbook_renderer::config::Config;
use std::path::Path;
use std::{fs, io};

/// Leaves out the comments of the scripts that book.toml names; mdBook may have put a hash into their names.
pub(crate) fn lighten(site: &Path, config: &Config) -> io::Result<()> {
    for script in config.html_config().unwrap_or_default().additional_js {
        let (Some(folder), Some(stem)) = (script.parent(), script.file_stem()) else { continue };
        let stem = stem.to_string_lossy();
        for entry in fs::read_dir(site.join(folder))? {
            let entry = entry?;
            let name = entry.file_name().to_string_lossy().into_owned();
            let hash = name.strip_prefix(&*stem).and_then(|rest| rest.strip_suffix(".js"));
            if hash.is_some_and(|hash| hash.is_empty() || hash.starts_with('-')) {
                fs::write(entry.path(), without_comments(&fs::read_to_string(entry.path())?))?;
            }
        }
    }
    Ok(())
}

/// A script without the lines that are comments as a whole. One with text over several lines, in which such a line
/// might be no comment, stays as it is.
fn without_comments(script: &str) -> String {
    if script.lines().any(|line| line.matches('`').count() % 2 == 1) {
        return script.to_owned();
    }
    let (mut out, mut is_inside) = (String::with_capacity(script.len()), false);
    for line in script.lines() {
        let text = line.trim();
        let begins = !is_inside && text.starts_with("/*");
        if is_inside || begins {
            let end = text.find("*/");
            match end.map(|end| &text[end + 2..]) {
                Some("") | None => {}
                Some(_) if begins => out.extend([line, "\n"]), // code stands behind it
                Some(_) => return script.to_owned(),
            }
            is_inside = end.is_none();
        } else if !text.starts_with("//") {
            out.extend([line, "\n"]);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::without_comments;

    #[test]
    fn lines_that_are_comments_are_left_out_and_no_code() {
        let script =
            "// a\n/** b */\nlet c = 2 // d\n  * 3;\n/* e\n * f\n */\n/* g */ h();\nlet i = \"// j\";\n";
        let light = "let c = 2 // d\n  * 3;\n/* g */ h();\nlet i = \"// j\";\n";
        assert_eq!(without_comments(script), light);
        for kept in ["let a = `\n// b\n`;\n// c\n", "/* a\n*/ b();\n// c\n"] {
            assert_eq!(without_comments(kept), kept);
        }
    }
}
