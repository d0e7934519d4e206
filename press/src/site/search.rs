//! The index of the site's search, made anew from the finished pages.
//!
//! mdBook's own holds every number of every drawing, all code, and formulas with a space between any two of their
//! letters. This one holds what is read: headings, text, captions, and formulas within a text as one reads them (`ω₀²`, which `ω0` finds). The form
//! is elasticlunr's, so that mdBook's scripts search it; only what they cut off at both ends of a word, anything but
//! Latin letters, is kept, so that `ω` is a word. Solutions and hints are not found, but their exercises.

use anyhow::{Context as _, Result};
use elasticlunr::lang::{English, Language};
use elasticlunr::{IndexBuilder, Pipeline};
use html::{StartTag, Token, attribute, text, tokens};
use mdbook_renderer::RenderContext;
use mdbook_renderer::book::BookItem;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::{fs, io};
use unicode_normalization::UnicodeNormalization;

const BEGINNING: &str = "window.search = Object.assign(window.search, JSON.parse('";
const END: &str = "'));";

/// How much longer than it is a section counts whose page has no number: the bibliography comes after the chapters.
const LOOKED_UP: u64 = 16;

/// What the anchors of parts begin with that are not searched: solutions; tables of symbols and the ledger, whose words
/// are those of the chapters; what is said to teachers of the chapters, and to programmers of the house.
const NOT_SEARCHED: [&str; 6] =
    ["sol-", "sec-symbols-", "sec-ledger-", "sec-teaching-", "sec-notes", "sec-house-"];

/// A part of a page under one heading.
#[derive(Debug, Default, PartialEq, Eq)]
struct Section {
    id: String,
    title: String,
    text: String,
    /// Numbers that its equations have in the source.
    sources: Vec<String>,
}

impl Section {
    /// What comes first in an exercise is how hard it is, and for how long, in words that all exercises share.
    fn is_exercise_without_text(&self) -> bool {
        self.id.starts_with("ex-") && self.text.trim().is_empty()
    }
}

/// Names the index that mdBook has written, if it has, by what is on the pages, which name it: a browser keeps it as
/// long as nothing has changed. mdBook names it by what it has found itself.
pub(crate) fn rename(site: &Path, pages: &mut BTreeMap<String, String>) -> io::Result<Option<PathBuf>> {
    let mut files =
        fs::read_dir(site)?.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned());
    let Some(name) = files.find(|name| name.starts_with("searchindex") && name.ends_with(".js")) else {
        return Ok(None);
    };
    let mut hasher = DefaultHasher::new();
    pages.hash(&mut hasher);
    let fresh = format!("searchindex-{:08x}.js", hasher.finish() >> 32);
    pages.values_mut().for_each(|html| *html = html.replace(&name, &fresh));
    fs::rename(site.join(name), site.join(&fresh))?;
    Ok(Some(site.join(fresh)))
}

/// Writes the index of the finished `pages` in the place of mdBook's.
pub(crate) fn write(file: &Path, context: &RenderContext, pages: &BTreeMap<String, String>) -> Result<()> {
    let settings = unpacked(&fs::read_to_string(file)?);
    let settings = settings.with_context(|| format!("{} is not mdBook's", file.display()))?;
    Ok(fs::write(file, packed(&index(context, pages, settings)?))?)
}

/// The JSON in the script that mdBook writes.
fn unpacked(script: &str) -> Option<Value> {
    let json = script.strip_prefix(BEGINNING)?.strip_suffix(END)?;
    serde_json::from_str(&json.replace("\\'", "'").replace("\\\\", "\\")).ok()
}

fn packed(json: &Value) -> String {
    let json = json.to_string().replace('\\', "\\\\").replace('\'', "\\'");
    format!("{BEGINNING}{json}{END}")
}

/// The index in place of the one in `search`, whose other settings stay.
fn index(context: &RenderContext, pages: &BTreeMap<String, String>, mut search: Value) -> Result<Value> {
    // Of the way to a section no word is asked for, as its title is a field; it is shown.
    let mut index = IndexBuilder::with_language(Box::new(Words(English::new())))
        .add_field_with_tokenizer("breadcrumbs", Box::new(|_| Vec::new()))
        .add_field("title")
        .add_field("body")
        .build();
    let mut addresses = Vec::new();
    let mut looked_up = Vec::new();
    for item in context.book.iter() {
        let BookItem::Chapter(chapter) = item else { continue };
        let Some(path) = &chapter.path else { continue };
        let path = path.with_extension("html").to_string_lossy().replace('\\', "/");
        let mut way = chapter.parent_names.clone();
        way.push(chapter.name.clone());
        let sections = pages.get(&path).map(|html| sections(html)).unwrap_or_default();
        let read = sections
            .into_iter()
            .filter(|section| !NOT_SEARCHED.iter().any(|label| section.id.starts_with(label)));
        for (n, section) in read.enumerate() {
            let way = if n == 0 { way.clone() } else { [way.clone(), vec![section.title.clone()]].concat() };
            let sources = section.sources.iter().map(|number| format!(" source {number}"));
            let title = section.title + &sources.collect::<String>();
            let number = addresses.len().to_string();
            index.add_doc(&number, [way.join(" » "), title, section.text]);
            if chapter.number.is_none() {
                looked_up.push(number);
            }
            addresses.push(format!("{path}#{}", section.id));
        }
    }
    let mut index = serde_json::to_value(&index)?;
    for number in looked_up {
        for field in ["title", "body"] {
            let length = &mut index["documentStore"]["docInfo"][&number][field];
            *length = json!(length.as_u64().unwrap_or_default() * LOOKED_UP);
        }
    }
    // mdBook shows the way, which ends with the title, and a part of the body.
    for shown in index["documentStore"]["docs"].as_object_mut().into_iter().flat_map(|all| all.values_mut()) {
        if let Some(shown) = shown.as_object_mut() {
            shown.retain(|field, _| field == "breadcrumbs" || field == "body");
        }
    }
    for field in ["breadcrumbs", "title", "body"] {
        shorten(&mut index["index"][field]["root"]);
    }
    search["doc_urls"] = json!(addresses);
    search["index"] = index;
    Ok(search)
}

/// Leaves out of the tree of words what nobody asks for: that no word ends at a letter, and all digits of weights but
/// the first. A weight is the root of how often a word stands in a section.
fn shorten(node: &mut Value) {
    let Some(node) = node.as_object_mut() else { return };
    let ends = node.get("df").and_then(Value::as_u64).unwrap_or_default() > 0;
    if !ends {
        node.remove("df");
        node.remove("docs");
    }
    for (letter, below) in node {
        match letter.as_str() {
            "df" => {}
            "docs" => {
                for weight in below.as_object_mut().into_iter().flat_map(|all| all.values_mut()) {
                    let tf = weight["tf"].as_f64().unwrap_or_default();
                    weight["tf"] = json!(tf.round() as u64);
                }
            }
            _ => shorten(below),
        }
    }
}

/// English as mdBook's scripts take it apart, but for their trimmer, the first filter, which leaves nothing of `ω`.
struct Words(English);

impl Language for Words {
    fn name(&self) -> String {
        self.0.name()
    }

    fn code(&self) -> String {
        self.0.code()
    }

    fn tokenize(&self, text: &str) -> Vec<String> {
        words(text)
    }

    fn make_pipeline(&self) -> Pipeline {
        let mut pipeline = self.0.make_pipeline();
        pipeline.queue.remove(0);
        pipeline
    }
}

/// The words of a text, in small letters: `störmer` also as `stormer`, `euler’s` also as `euler`.
fn words(text: &str) -> Vec<String> {
    let text = text.to_lowercase().replace('’', "'");
    let mut found = Vec::new();
    let is_part = |c: char| c.is_alphanumeric() && !HIGH.contains(c) || matches!(c, '.' | '_' | '\'');
    for word in text.split(|c: char| !is_part(c)) {
        let word = word.trim_matches(['.', '_', '\'']);
        let is_number = word.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
        let is_result = is_number && (word.len() > 5 || word.starts_with("0."));
        if word.is_empty() || word.len() > 40 || is_result {
            continue; // what is asked for by number are years, parts, formulas and exercises
        }
        for word in [Some(word), word.strip_suffix("'s")].into_iter().flatten() {
            let plain: String = word.chars().map(plain).collect();
            found.extend((plain != word).then_some(plain));
            found.push(word.to_owned());
        }
    }
    found
}

/// A letter without its accent, or the digit of an index.
fn plain(c: char) -> char {
    match c {
        'ø' => 'o',
        'ł' => 'l',
        '₀'..='₉' => c.nfkd().next().unwrap_or(c),
        _ => c.nfd().next().unwrap_or(c),
    }
}

/// What is written high or low in a formula, and how it is in a line of text.
const WRITTEN: &str = "0123456789+−=()n";
const HIGH: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ⁿ";
const LOW: &str = "₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₙ";

/// A text set high or low, if all of it can be.
fn shifted(text: &str, into: &str) -> Option<String> {
    let shifted = |c| WRITTEN.chars().zip(into.chars()).find(|(written, _)| *written == c).map(|(_, to)| to);
    text.chars().map(shifted).collect()
}

/// A part of a formula in a line of text, from its own parts.
fn in_line(name: &str, parts: &[String]) -> String {
    let closed = |text: &str| {
        let is_sum = text.chars().any(|c| "+−-/=".contains(c));
        if is_sum { format!("({text})") } else { text.to_owned() }
    };
    let low = |text: &str| shifted(text, LOW).unwrap_or_else(|| text.to_owned());
    let high = |text: &str| match text {
        "′" | "″" | "˙" | "*" | "°" => text.to_owned(),
        _ => shifted(text, HIGH).unwrap_or_else(|| format!("^{}", closed(text))),
    };
    match (name, parts) {
        ("mfrac", [above, below]) => format!("{}/{}", closed(above), closed(below)),
        ("msqrt", _) => format!("√{}", closed(&parts.concat())),
        ("msub", [base, index]) => base.to_owned() + &low(index),
        ("msup", [base, power]) => base.to_owned() + &high(power),
        ("msubsup", [base, index, power]) => base.to_owned() + &low(index) + &high(power),
        _ => parts.concat(),
    }
}

/// The letter or digit that one types for one of a mathematical alphabet.
fn upright(c: char) -> char {
    let is_mathematical = matches!(c, '\u{1d400}'..='\u{1d7ff}');
    if is_mathematical { c.nfkc().next().unwrap_or(c) } else { c }
}

/// What is no text, or none of its place.
const LEFT_OUT: [&str; 8] = ["svg", "pre", "script", "style", "button", "template", "nav", "details"];
const LEFT_OUT_CLASSES: [&str; 8] =
    ["save", "note-mark", "note-number", "turn", "code", "citing", "panel", "answers"];
/// Elements within a line: there is no space where they begin and end.
const IN_LINE: [&str; 12] =
    ["a", "abbr", "b", "code", "del", "em", "i", "span", "strong", "sub", "sup", "math"];

/// The sections of a built page.
fn sections(html: &str) -> Vec<Section> {
    let mut reader = Reader::default();
    for token in tokens(html) {
        match token {
            Token::StartTag(tag) => reader.start(&tag),
            Token::EndTag(tag) => reader.end(&text(&tag.name)),
            Token::String(words) => reader.text(&text(&words)),
            _ => {}
        }
    }
    for section in &mut reader.sections {
        for text in [&mut section.title, &mut section.text] {
            *text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        }
    }
    reader.sections
}

#[derive(Debug, Default)]
struct Reader {
    sections: Vec<Section>,
    in_main: bool,
    in_heading: bool,
    /// The open elements of a formula and their parts so far.
    maths: Vec<(String, Vec<String>)>,
    /// The element that is left out, and how often it is open.
    left_out: Option<(String, u32)>,
    /// How long the text of the section was where the open cell of a table begins.
    cell: Option<usize>,
}

impl Reader {
    fn start(&mut self, tag: &StartTag<usize>) {
        let name = text(&tag.name);
        self.in_main |= name == "main";
        if !self.in_main {
            return;
        }
        let attribute = |key: &str| attribute(tag, key);
        if let Some((open, depth)) = &mut self.left_out {
            *depth += u32::from(*open == name && !tag.self_closing);
            return;
        }
        if let Some(number) = attribute("id").as_deref().and_then(|id| id.strip_prefix("source-")) {
            self.sections.last_mut().into_iter().for_each(|section| section.sources.push(number.to_owned()));
        }
        let class = attribute("class").unwrap_or_default();
        let is_displayed = name == "math" && attribute("display").as_deref() == Some("block");
        if LEFT_OUT.contains(&&*name)
            || is_displayed
            || name == "em" && self.sections.last().is_some_and(Section::is_exercise_without_text)
            || class.split(' ').any(|class| LEFT_OUT_CLASSES.contains(&class))
        {
            self.left_out = (!tag.self_closing).then_some((name, 1));
            self.text(" ");
        } else if matches!(&*name, "h1" | "h2" | "h3")
            && let Some(id) = attribute("id")
        {
            self.in_heading = true;
            self.sections.push(Section { id, ..Section::default() });
        } else {
            if (name == "math" || !self.maths.is_empty()) && !tag.self_closing {
                self.maths.push((name.clone(), Vec::new()));
            }
            self.space(&name);
            if name == "td" {
                self.cell = self.sections.last().map(|section| section.text.len());
            }
        }
    }

    fn end(&mut self, name: &str) {
        if let Some((open, depth)) = &mut self.left_out {
            *depth -= u32::from(open == name);
            if *depth == 0 {
                self.left_out = None;
            }
            return;
        }
        self.in_main &= name != "main";
        self.in_heading &= !matches!(name, "h1" | "h2" | "h3");
        if let Some((name, parts)) = self.maths.pop() {
            let words = in_line(&name, &parts);
            match self.maths.last_mut() {
                Some((_, parts)) => parts.push(words),
                None => self.text(&words),
            }
        }
        self.space(name);
        if name == "td" {
            self.end_cell();
        }
    }

    /// Takes back what stands in a cell if it is but a number: who looks for one knows its table.
    fn end_cell(&mut self) {
        if let (Some(begin), Some(section)) = (self.cell.take(), self.sections.last_mut())
            && section.text[begin..].chars().any(|c| c.is_ascii_digit())
            && !section.text[begin..].chars().any(char::is_alphabetic)
        {
            section.text.truncate(begin);
        }
    }

    /// Between blocks.
    fn space(&mut self, name: &str) {
        if self.maths.is_empty() && !IN_LINE.contains(&name) {
            self.text(" ");
        }
    }

    fn text(&mut self, text: &str) {
        if let (true, None, Some(section)) = (self.in_main, &self.left_out, self.sections.last_mut()) {
            let into = if self.in_heading { &mut section.title } else { &mut section.text };
            if let Some((name, parts)) = self.maths.last_mut() {
                if name != "mtext" && text.trim().is_empty() {
                    return; // between elements
                }
                let is_accent = |c: &char| "ˆ˜˙¨¯→\u{302}\u{303}\u{304}\u{307}\u{308}\u{20d7}".contains(*c);
                parts.push(text.chars().filter(|c| !is_accent(c)).map(upright).collect());
            } else {
                into.push_str(text);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_read_is_found_and_nothing_else() {
        let html = "<p>Menu</p>\
            <main><p class=\"kicker\">Chapter 1</p><h1 id=\"a\"><a href=\"#a\">A top</a></h1>\
            <p>So <math><msubsup><mi>ω</mi><mrow><mn>0</mn></mrow><mn>2</mn></msubsup><mo>=</mo><mfrac><mi>k</mi><mrow><mi>m</mi><mo>+</mo><mi>M</mi></mrow></mfrac></math>, <em>Stör</em>mer’s\
            <a class=\"note-mark\">1</a>.</p>\
            <figure><svg><svg><text>12</text></svg><text>13</text></svg>\
            <figcaption>It turns.</figcaption></figure>\
            <h2 id=\"ex-b\">B</h2><p><em>Problem</em></p><p>An <em>easy</em> one:</p><pre>let x;</pre>\
            <div><math display=\"block\"><mi>q</mi></math><a id=\"source-19\">source 19</a></div>\
            <table><tr><th>1</th></tr><tr><td>0.1 rad</td><td>−2.07·10<sup>4</sup></td></tr></table>\
            <ul><li>one<li>two</ul></main><p>Foot</p>";
        let [a, b] = sections(html).try_into().unwrap();
        assert_eq!((a.id.as_str(), a.title.as_str()), ("a", "A top"));
        assert_eq!(a.text, "So ω₀²=k/(m+M), Störmer’s. It turns.");
        assert_eq!(
            (b.text.as_str(), b.sources),
            ("An easy one: source 19 1 0.1 rad one two", vec!["19".to_owned()])
        );
    }

    #[test]
    fn a_word_is_found_as_people_write_it() {
        assert_eq!(
            words("Störmer’s ω₀²-axis"),
            ["stormer's", "störmer's", "stormer", "störmer", "ω0", "ω₀", "axis"]
        );
        assert_eq!(
            words("of 1869: (1.24), 0.15, 1.001523 e.g. ‘spin’"),
            ["of", "1869", "1.24", "e.g", "spin"]
        );
    }

    #[test]
    fn letters_of_formulas_are_those_of_the_keyboard() {
        assert_eq!("𝑳𝝎𝛀𝟑𝖨x𝐱ϕ".chars().map(upright).collect::<String>(), "LωΩ3Ixxϕ");
    }

    #[test]
    fn the_script_is_read_and_written() {
        let json = json!({"a": "it's \\ \"so\""});
        assert_eq!(unpacked(&packed(&json)), Some(json));
    }
}
