//! The scripts of a book as they travel: without the comments that tell their authors what they do, and without the
//! programming languages that it does not use.

use mdbook_renderer::config::Config;
use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::Path;
use std::{fs, io};

/// How each language begins in mdBook's script that colours programs, a line for each.
const LANGUAGE: &str = "hljs.registerLanguage(\"";

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

/// Leaves out of the script that colours programs all languages but those of the `pages`, three quarters of it, and names
/// it by what is left.
pub(crate) fn keep_languages(site: &Path, pages: &mut BTreeMap<String, String>) -> io::Result<()> {
    let mut files =
        fs::read_dir(site)?.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned());
    let Some(name) = files.find(|name| name.starts_with("highlight-") && name.ends_with(".js")) else {
        return Ok(());
    };
    let classes = pages.values().flat_map(|html| html.split("class=\"language-").skip(1));
    let used: Vec<&str> = classes.filter_map(|rest| rest.split(['"', ' ', ',']).next()).collect();
    let kept = with_languages(&fs::read_to_string(site.join(&name))?, &used);
    let mut hasher = DefaultHasher::new();
    kept.hash(&mut hasher);
    let fresh = format!("highlight-{:08x}.js", hasher.finish() >> 32);
    pages.values_mut().for_each(|html| *html = html.replace(&name, &fresh));
    fs::remove_file(site.join(name))?;
    fs::write(site.join(fresh), kept)
}

/// The script with the languages that are `used`, by name or alias, and those that these name in their turn.
fn with_languages(script: &str, used: &[&str]) -> String {
    let name = |line: &str| line.strip_prefix(LANGUAGE)?.split('"').next().map(|name| format!("\"{name}\""));
    let aliases =
        |line: &str| line.split_once("aliases:[")?.1.split_once(']').map(|(list, _)| list.to_owned());
    let is_used = |line: &str| {
        let names = name(line).into_iter().chain(aliases(line)).collect::<String>();
        used.iter().any(|used| names.contains(&format!("\"{used}\"")))
    };
    let mut kept: Vec<(&str, bool)> =
        script.lines().map(|line| (line, !line.starts_with(LANGUAGE) || is_used(line))).collect();
    loop {
        let is_named = |line: &str| {
            let by = |own: &&(&str, bool)| own.1 && own.0.starts_with(LANGUAGE) && own.0 != line;
            name(line).is_some_and(|name| kept.iter().filter(by).any(|(own, _)| own.contains(&name)))
        };
        let Some(place) = kept.iter().position(|(line, is_kept)| !is_kept && is_named(line)) else { break };
        kept[place].1 = true;
    }
    kept.iter().filter(|(_, is_kept)| *is_kept).map(|(line, _)| format!("{line}\n")).collect()
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
    use super::{with_languages, without_comments};

    #[test]
    fn the_languages_of_the_pages_are_kept_and_what_they_name() {
        let language = |name: &str, rest: &str| format!("hljs.registerLanguage(\"{name}\",{{{rest}}});\n");
        let [rust, shell, bash, sql, ini] = [
            ("rust", "aliases:[\"rs\"]"),
            ("shell", "aliases:[\"console\"],subLanguage:\"bash\""),
            ("bash", "aliases:[\"sh\"],keywords:\"rust\""),
            ("sql", "keywords:\"toml\""),
            ("ini", "aliases:[\"toml\"]"),
        ]
        .map(|(name, rest)| language(name, rest));
        let script = format!("/* BSD */\nvar hljs;\n{rust}{shell}{bash}{sql}{ini}");
        assert_eq!(with_languages(&script, &["rs"]), format!("/* BSD */\nvar hljs;\n{rust}"));
        let some = with_languages(&script, &["console", "toml"]);
        assert_eq!(some, format!("/* BSD */\nvar hljs;\n{rust}{shell}{bash}{ini}"));
    }

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
