//! The style sheets and scripts of the theme in the site: at addresses that say what they are, the sheets as one.

use crate::site::theme;
use html::{Edits, named};
use mdbook_renderer::config::Config;
use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::{fs, io};

/// Joins the sheets of the theme in the order of book.toml, and moves its scripts beside those of mdBook. Pages load
/// them from there, also the list of chapters for those without scripts.
pub(crate) fn gather(site: &Path, config: &Config, pages: &mut BTreeMap<String, String>) -> io::Result<()> {
    let html = config.html_config().unwrap_or_default();
    let mut sheets = Vec::new();
    let mut joined = String::new();
    for sheet in of_theme(site, &html.additional_css) {
        joined += &fs::read_to_string(site.join(&sheet))?;
        sheets.push(sheet);
    }
    let mut moved = Vec::new();
    if !sheets.is_empty() {
        let joined = lightened(&joined);
        let mut hasher = DefaultHasher::new();
        joined.hash(&mut hasher);
        let name = format!("css/look-{:08x}.css", hasher.finish() >> 32);
        fs::write(site.join(&name), joined)?;
        moved.push((sheets.remove(0), name));
    }
    for script in of_theme(site, &html.additional_js) {
        let name = script.rsplit('/').next().unwrap_or_default().to_owned();
        fs::copy(site.join(&script), site.join(&name))?;
        moved.push((script, name));
    }
    let gathered = |html: &str| {
        let lines =
            html.split_inclusive('\n').filter(|line| !sheets.iter().any(|sheet| line.contains(sheet)));
        moved.iter().fold(lines.collect::<String>(), |html, (from, to)| html.replace(from, to))
    };
    pages.values_mut().for_each(|html| *html = gathered(html));
    let list = site.join("toc.html");
    if list.is_file() {
        fs::write(&list, gathered(&fs::read_to_string(&list)?))?;
    }
    let Some(folder) = theme::FOLDER.split('/').next().map(|top| site.join(top)) else { return Ok(()) };
    if folder.is_dir() { fs::remove_dir_all(folder) } else { Ok(()) }
}

/// A style sheet without what only its authors need: comments and indentation, a third of what travels.
fn lightened(sheet: &str) -> String {
    let (mut out, mut rest) = (String::with_capacity(sheet.len()), sheet);
    while let Some(at) = rest.find(['"', '\'', '/']) {
        // Up to the end of a text or a comment, or just beyond a stroke that begins none.
        let (kept, end) = match &rest[at..] {
            comment if comment.starts_with("/*") => (at, comment.find("*/").map(|end| at + end + 2)),
            stroke if stroke.starts_with('/') => (at + 1, Some(at + 1)),
            text => {
                let end = text[1..].find(&text[..1]).map(|end| at + end + 2);
                (end.unwrap_or(rest.len()), end)
            }
        };
        out += &rest[..kept];
        rest = end.map_or("", |end| &rest[end..]);
    }
    out += rest;
    out.lines().map(str::trim).filter(|line| !line.is_empty()).flat_map(|line| [line, "\n"]).collect()
}

/// What can stand in the margin.
const BESIDE: [&str; 7] = ["note", "figure", "grade", "scene", "answers", "citing", "table-wrapper"];

/// The page with a class for its text: `cover` if the heading of that name is its only one, which on the page of all pages it
/// is not, `plain` if nothing stands in its margin. A style sheet that finds this out by itself does so for each element that comes.
pub(crate) fn with_kind(html: &str) -> String {
    let found = named(html, &["main", "h1", "aside", "div", "figure", "p", "span"]);
    let Some(main) = found.iter().find(|element| element.name == "main") else { return html.to_owned() };
    let mut inside = found.iter().filter(|element| main.holds(element));
    let is_beside = |class: &str| BESIDE.contains(&class);
    let headings = found.iter().filter(|element| element.name == "h1" && main.holds(element));
    let class = if headings.map(|heading| heading.get("id")).eq([Some("sec-cover")]) {
        "cover"
    } else if inside.any(|element| element.get("class").unwrap_or_default().split(' ').any(is_beside)) {
        return html.to_owned();
    } else {
        "plain"
    };
    let mut edits = Edits::default();
    edits.insert(main.start_tag.end - 1, format!(" class=\"{class}\""));
    edits.applied(html)
}

/// Those of the files that are the theme's, as they lie in the site: mdBook may have put a hash into their names.
fn of_theme(site: &Path, files: &[PathBuf]) -> Vec<String> {
    let here = |file: &PathBuf| {
        let folder = file.parent().filter(|folder| *folder == Path::new(theme::FOLDER))?;
        let [stem, ending] = [file.file_stem()?, file.extension()?].map(|part| part.to_string_lossy());
        let names = fs::read_dir(site.join(folder)).ok()?.flatten();
        let is_it = |name: &String| {
            let hash = name.strip_prefix(&*stem).and_then(|rest| rest.strip_suffix(&format!(".{ending}")));
            hash.is_some_and(|hash| hash.is_empty() || hash.starts_with('-'))
        };
        let name = names.map(|entry| entry.file_name().to_string_lossy().into_owned()).find(is_it)?;
        Some(format!("{}/{name}", theme::FOLDER))
    };
    files.iter().filter_map(here).collect()
}

#[cfg(test)]
mod tests {
    use super::{lightened, with_kind};

    #[test]
    fn a_sheet_travels_without_comments_and_blanks_at_its_edges() {
        let sheet = "/* Of a\n   book. */\n\na { /* b */\n    content: \"/* c */\" / '*/';\n    d: url(e/f); }\n/* open";
        assert_eq!(lightened(sheet), "a {\ncontent: \"/* c */\" / '*/';\nd: url(e/f); }\n");
    }

    #[test]
    fn a_page_says_that_it_is_the_cover_or_that_its_margin_is_empty() {
        let kind = |text: &str| {
            let page = with_kind(&format!("<body><p class=\"note\">head</p><main>{text}</main></body>"));
            page.split_once("<main").unwrap().1.split_once('>').unwrap().0.to_owned()
        };
        assert_eq!(kind("<h1 id=\"sec-cover\">Tops</h1><p>…</p>"), " class=\"cover\"");
        assert_eq!(kind("<h1>Tops</h1><p class=\"kicker\">…</p>"), " class=\"plain\"");
        assert_eq!(kind("<h1>Tops</h1><p>…</p><div class=\"figure margin\"></div>"), "");
        assert_eq!(kind("<h1 id=\"sec-cover\">Tops</h1><h1>One</h1><p class=\"grade\">…</p>"), "");
    }
}
