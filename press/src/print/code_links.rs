//! Where the library's comments name the equations of the book, and the links from there to the pages and back.

use crate::book::files;
use crate::read::items::LabelKind;
use crate::read::label_syntax;
use crate::site::rustdoc::FOLDER;
use html::{Edits, Token, tokens};
use std::collections::BTreeMap;
use std::path::Path;
use std::{fs, io};

/// Something of the library whose comment names an equation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct CodePlace {
    /// Rustdoc's page of the source file, below the folder of the library's documentation.
    page: String,
    line: usize,
    /// The function or type that the comment belongs to.
    item: String,
    /// What documents an item stands before what explains a line, and a module comes last.
    rank: u8,
}

impl CodePlace {
    /// Where it is, from the root of the site.
    pub(crate) fn target(&self) -> String {
        format!("{FOLDER}/{}#{}", self.page, self.line)
    }

    /// The function or type that names the equation.
    pub(crate) fn item(&self) -> &str {
        &self.item
    }

    /// What it is, for those who point at the link.
    pub(crate) fn words(&self) -> String {
        let file = self.page.trim_start_matches("src/").trim_end_matches(".html");
        format!("{} in {file}, line {}", self.item, self.line)
    }
}

/// Where the comments of the library name equations: the name of the equation → its places, one an item. `code` holds
/// files with their texts; those of the library lie in the folder `sources`.
pub(crate) fn places(
    library: &str,
    sources: &str,
    code: &[(String, String)],
) -> BTreeMap<String, Vec<CodePlace>> {
    let mut places: BTreeMap<String, Vec<CodePlace>> = BTreeMap::new();
    for (file, text) in code {
        let below = file.strip_prefix(sources).and_then(|file| file.strip_prefix('/'));
        let Some(file) = below.filter(|_| !sources.is_empty()) else { continue };
        let lines: Vec<&str> = text.lines().collect();
        for (index, line) in lines.iter().enumerate() {
            for (at, label) in label_syntax::cited(line) {
                let Some(item) = item(&lines, index).filter(|_| label.kind == LabelKind::Equation) else {
                    continue;
                };
                let comment = line[..at].find("//").map_or("", |start| &line[start..]);
                let rank = ["///", "// ", "//!"].iter().position(|start| comment.starts_with(start));
                let page = format!("src/{library}/{file}.html");
                let place = CodePlace { page, line: index + 1, item, rank: rank.unwrap_or(1) as u8 };
                let known = places.entry(label.name).or_default();
                if !known.iter().any(|other| (&other.page, &other.item) == (&place.page, &place.item)) {
                    known.push(place);
                }
            }
        }
    }
    places.values_mut().for_each(|places| places.sort_by_key(|place| place.rank));
    places
}

/// What the comment of a line belongs to: what it documents, or else the function that it stands in.
fn item(lines: &[&str], index: usize) -> Option<String> {
    let line = lines[index].trim_start();
    if line.starts_with("//!") {
        return Some("the module".to_owned());
    }
    if line.starts_with("///") {
        let mut below = lines[index..].iter().map(|line| line.trim_start());
        return below.find(|line| !line.starts_with("//") && !line.starts_with("#[")).and_then(named);
    }
    lines[..=index].iter().rev().find_map(|line| line.contains("fn ").then(|| named(line)).flatten())
}

/// The name that a line of Rust declares.
fn named(line: &str) -> Option<String> {
    const KEYWORDS: [&str; 8] = ["fn", "struct", "enum", "trait", "const", "static", "type", "mod"];
    let words: Vec<&str> =
        line.split(|c: char| !(c.is_alphanumeric() || c == '_')).filter(|word| !word.is_empty()).collect();
    let keyword = words.iter().position(|word| KEYWORDS.contains(word));
    let keyword = keyword.map(|at| if words.get(at + 1) == Some(&"fn") { at + 1 } else { at }); // const fn
    let field = words.iter().position(|word| !matches!(*word, "pub" | "crate" | "super" | "in"));
    let name = keyword.map(|at| at + 1).or(field)?;
    words.get(name).map(|word| (*word).to_owned())
}

/// Makes links to the pages of the book of the labels that the library's documentation and sources name. `homes` says
/// on which page each id is.
pub(crate) fn link_back(site: &Path, homes: &BTreeMap<&str, &str>) -> io::Result<()> {
    let folder = site.join(FOLDER);
    let pages = if folder.is_dir() { files(&folder)? } else { Vec::new() };
    for page in pages.iter().filter(|name| name.ends_with(".html")) {
        let html = fs::read_to_string(folder.join(page))?;
        let linked = linked(&html, &"../".repeat(1 + page.matches('/').count()), homes);
        if linked != html {
            fs::write(folder.join(page), linked)?;
        }
    }
    Ok(())
}

/// A page of rustdoc with links to where `homes` has the labels that its text names.
fn linked(html: &str, up: &str, homes: &BTreeMap<&str, &str>) -> String {
    let mut edits = Edits::default();
    let mut inside = None; // the name of a link, or of what is no text
    for token in tokens(html) {
        match token {
            Token::StartTag(tag)
                if inside.is_none()
                    && matches!(&**tag.name, b"a" | b"script" | b"style" | b"title" | b"textarea") =>
            {
                inside = Some(tag.name);
            }
            Token::EndTag(tag) if inside.as_ref() == Some(&tag.name) => inside = None,
            Token::String(words) if inside.is_none() => {
                let start = words.span.start;
                for (at, label) in label_syntax::named(&html[start..words.span.end]) {
                    let (id, written) = (label.id(), label.written());
                    if let Some(page) = homes.get(id.as_str()) {
                        let link = format!("<a href=\"{up}{page}#{id}\">{written}</a>");
                        edits.replace(start + at..start + at + written.len(), link);
                    }
                }
            }
            _ => {}
        }
    }
    edits.applied(html)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_equation_leads_to_each_item_that_names_it() {
        let text = "/// The rate (`eq:rate`).\n#[must_use]\npub fn rate(&self) -> f64 {\n    self.top / 2.0 // eq:rate\n}\n\n\
                    pub(crate) const fn other() {\n    let x = 1; // eq:rate and eq:more\n}\n\
                    /// Its size, eq:more.\npub size: f64,\n";
        let code =
            [("src/tops/top.rs".to_owned(), text.to_owned()), ("tests/top.rs".to_owned(), text.to_owned())];
        let found = places("spin", "src", &code);
        let words = |name: &str| found[name].iter().map(CodePlace::words).collect::<Vec<_>>();
        assert_eq!(words("rate"), ["rate in spin/tops/top.rs, line 1", "other in spin/tops/top.rs, line 8"]);
        // What documents an item comes first.
        assert_eq!(words("more"), ["size in spin/tops/top.rs, line 10", "other in spin/tops/top.rs, line 8"]);
        assert_eq!(found["rate"][1].target(), "api/src/spin/tops/top.rs.html#8");
    }

    #[test]
    fn a_label_in_the_documentation_leads_back_to_its_page() {
        let homes = BTreeMap::from([("eq-rate", "tops/index.html")]);
        let html = "<title>eq:rate</title><a title=\"eq:rate\" href=x>eq:rate</a> <code>eq:rate</code>, eq:unknown. <script>eq:rate</script>eq:rate-";
        let link = "<a href=\"../../tops/index.html#eq-rate\">eq:rate</a>";
        assert_eq!(
            linked(html, "../../", &homes),
            format!(
                "<title>eq:rate</title><a title=\"eq:rate\" href=x>eq:rate</a> <code>{link}</code>, eq:unknown. <script>eq:rate</script>{link}-"
            )
        );
        assert_eq!(
            linked("<p>a &lt; b, eq:rate", "", &homes),
            "<p>a &lt; b, <a href=\"tops/index.html#eq-rate\">eq:rate</a>"
        );
    }
}
