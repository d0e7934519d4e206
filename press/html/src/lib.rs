//! HTML, written, read and edited. What no edit touches stays as it is, byte for byte.
//!
//! The press reads each page of a site some twenty times, so this must be fast. It is a crate of its own so that it alone is
//! optimised, and the press is compiled quickly. [`Tokens`] settles what is generic in the reader; else the press would
//! compile that again, slow.

use html5gum::{DefaultEmitter, StringReader, Tokenizer};
pub use html5gum::{StartTag, Token};
use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::ops::Range;

/// Text in which nothing is markup any more.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Code with places where a line may end: before a dot, and behind a bracket, a comma, an underscore or a slash.
pub fn breakable(code: &str) -> String {
    let mut out = String::with_capacity(2 * code.len());
    let mut letters = code.chars().peekable();
    while let Some(c) = letters.next() {
        let is_call = c == '.' && letters.peek().is_some_and(|next| next.is_alphabetic());
        out += if is_call { "<wbr>" } else { "" };
        out.push(c);
        out += if "([,_/".contains(c) { "<wbr>" } else { "" };
    }
    out
}

/// An element and where its parts stand in the HTML that holds it.
#[derive(Debug, Clone)]
pub struct Element {
    /// Its name, in lower case.
    pub name: String,
    /// The value of each attribute, and its place from the name to the closing quote.
    attributes: BTreeMap<String, (String, Range<usize>)>,
    /// Its start tag.
    pub start_tag: Range<usize>,
    /// What is between its tags.
    pub inside: Range<usize>,
    /// The element with its tags.
    pub whole: Range<usize>,
}

impl Element {
    /// The value of an attribute.
    pub fn get(&self, attribute: &str) -> Option<&str> {
        self.attributes.get(attribute).map(|(value, _)| value.as_str())
    }

    /// Where an attribute with its value stands.
    pub fn place(&self, attribute: &str) -> Option<Range<usize>> {
        self.attributes.get(attribute).map(|(_, place)| place.clone())
    }

    /// Whether an element has this name and, among its classes, this one.
    pub fn is(&self, name: &str, class: &str) -> bool {
        self.name == name && self.get("class").is_some_and(|all| all.split(' ').any(|one| one == class))
    }

    /// Whether another element stands between its tags.
    pub fn holds(&self, other: &Self) -> bool {
        self.inside.start <= other.whole.start && other.whole.end <= self.inside.end
    }
}

/// What HTML consists of, in its order: tags, texts, comments.
#[derive(Debug)]
pub struct Tokens<'a>(Tokenizer<StringReader<'a>, DefaultEmitter<usize>>);

impl Iterator for Tokens<'_> {
    type Item = Token<usize>;

    fn next(&mut self) -> Option<Token<usize>> {
        self.0.next().map(|Ok(token)| token)
    }
}

/// What some HTML consists of.
pub fn tokens(html: &str) -> Tokens<'_> {
    let mut emitter = DefaultEmitter::new_with_span();
    emitter.naively_switch_states(true); // what stands in a script or a style sheet is no HTML
    Tokens(Tokenizer::new_with_emitter(html, emitter))
}

/// Bytes of a token as text.
pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// The value of an attribute of a tag.
pub fn attribute(tag: &StartTag<usize>, name: &str) -> Option<String> {
    tag.attributes.get(name.as_bytes()).map(|value| text(value))
}

/// The elements of HTML that have no end tag.
pub const VOID: [&str; 13] =
    ["area", "base", "br", "col", "embed", "hr", "img", "input", "link", "meta", "source", "track", "wbr"];

/// The elements whose start tags are `wanted`, in the order of these.
pub fn elements(html: &str, wanted: &dyn Fn(&StartTag<usize>) -> bool) -> Vec<Element> {
    let mut found: Vec<Element> = Vec::new();
    // The names of the elements that are open, and which of them are in `found`.
    let mut open: Vec<(Vec<u8>, Option<usize>)> = Vec::new();
    for token in tokens(html) {
        match token {
            Token::StartTag(tag) => {
                let end = tag.span.end;
                let wanted = wanted(&tag).then(|| {
                    found.push(Element {
                        name: text(&tag.name),
                        attributes: attributes(html, &tag),
                        start_tag: tag.span.start..end,
                        inside: end..end,
                        whole: tag.span.start..end,
                    });
                    found.len() - 1
                });
                let is_void = VOID.iter().any(|name| name.as_bytes() == &**tag.name);
                if !tag.self_closing && !is_void {
                    open.push((tag.name.0, wanted));
                }
            }
            Token::EndTag(tag) => {
                // What is still open within an element ends with it.
                let Some(from) = open.iter().rposition(|(name, _)| *name == *tag.name) else { continue };
                for (depth, (_, place)) in open.drain(from..).enumerate() {
                    if let Some(place) = place {
                        found[place].inside.end = tag.span.start;
                        found[place].whole.end = if depth == 0 { tag.span.end } else { tag.span.start };
                    }
                }
            }
            _ => {}
        }
    }
    for place in open.into_iter().filter_map(|(_, place)| place) {
        (found[place].inside.end, found[place].whole.end) = (html.len(), html.len());
    }
    found
}

fn attributes(html: &str, tag: &StartTag<usize>) -> BTreeMap<String, (String, Range<usize>)> {
    let of = |(key, value): (&html5gum::HtmlString, &html5gum::Spanned<html5gum::HtmlString>)| {
        // The reader counts a quote behind a value, also where there is none.
        let (start, mut end) = (value.span.start, value.span.end);
        if !value.is_empty() && !html[..end].ends_with(['"', '\'']) {
            end -= 1;
        }
        (text(key), (text(value), start..end))
    };
    tag.attributes.iter().map(of).collect()
}

/// The elements with one of these names.
pub fn named(html: &str, names: &[&str]) -> Vec<Element> {
    elements(html, &|tag| names.iter().any(|name| name.as_bytes() == &**tag.name))
}

/// All ids, in the order of their elements.
pub fn ids(html: &str) -> impl Iterator<Item = String> {
    tokens(html).filter_map(|token| match token {
        Token::StartTag(tag) => attribute(&tag, "id"),
        _ => None,
    })
}

/// The words of some HTML, without its tags.
pub fn words(html: &str) -> String {
    let texts = tokens(html).filter_map(|token| match token {
        Token::String(words) => Some(text(&words)),
        _ => None,
    });
    texts.collect::<String>().split_whitespace().collect::<Vec<_>>().join(" ")
}

/// What is to be changed in some HTML.
#[derive(Debug, Default)]
pub struct Edits(Vec<(Range<usize>, String)>);

impl Edits {
    /// Puts other HTML in a place.
    pub fn replace(&mut self, place: Range<usize>, by: impl Into<String>) {
        self.0.push((place, by.into()));
    }

    /// Puts HTML before what stands at a place.
    pub fn insert(&mut self, at: usize, html: impl Into<String>) {
        self.replace(at..at, html);
    }

    /// Takes away what stands in a place.
    pub fn remove(&mut self, place: Range<usize>) {
        self.replace(place, "");
    }

    /// The HTML with all changes. A change within a place that is replaced goes with it.
    pub fn applied(mut self, html: &str) -> String {
        self.0.sort_by_key(|(place, _)| (place.start, !place.is_empty(), Reverse(place.end)));
        let mut out = String::with_capacity(html.len());
        let mut done = 0;
        for (place, by) in self.0 {
            if place.start >= done {
                out += &html[done..place.start];
                out += &by;
                done = place.end;
            }
        }
        out + &html[done..]
    }
}

/// HTML whose links lead nowhere where `is_dead` says so of their targets: they are only words then. A line that does
/// nothing but lead to a solution, or to a hint, loses the link, and goes with its last one.
pub fn unlinked(html: &str, is_dead: impl Fn(&str) -> bool) -> String {
    let found = named(html, &["a", "p"]);
    let lines: Vec<&Element> = found.iter().filter(|element| element.is("p", "turn")).collect();
    let (mut edits, mut alive) = (Edits::default(), Vec::new());
    for link in found.iter().filter(|element| element.name == "a") {
        let (Some(target), Some(place)) = (link.get("href"), link.place("href")) else { continue };
        if !is_dead(target) {
            alive.push(link);
        } else if lines.iter().any(|line| line.holds(link)) {
            edits.remove(link.whole.clone());
        } else if link.attributes.len() == 1 {
            edits.remove(link.start_tag.clone());
            edits.remove(link.inside.end..link.whole.end);
        } else {
            edits.remove(place);
        }
    }
    for line in lines.iter().filter(|line| !alive.iter().any(|link| line.holds(link))) {
        edits.remove(line.whole.clone());
    }
    edits.applied(html)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_know_their_places() {
        let html = "<p class='a b' id=x>A <b>b<br>c</p><script>\"<p>\"</script><P hidden>d";
        let parts = |element: &Element| {
            [&element.start_tag, &element.inside, &element.whole].map(|part| &html[part.clone()])
        };
        let found = named(html, &["p", "b"]);
        assert_eq!(
            parts(&found[0]),
            ["<p class='a b' id=x>", "A <b>b<br>c", "<p class='a b' id=x>A <b>b<br>c</p>"]
        );
        assert_eq!(parts(&found[1]), ["<b>", "b<br>c", "<b>b<br>c"]);
        assert_eq!(parts(&found[2]), ["<P hidden>", "d", "<P hidden>d"]);
        assert!(found.len() == 3 && found[0].holds(&found[1]) && !found[1].holds(&found[0]));
        assert!(found[0].is("p", "b") && !found[0].is("p", "a b"));
        let places = ["class", "id"].map(|key| &html[found[0].place(key).unwrap()]);
        assert_eq!((found[0].get("id"), places), (Some("x"), ["class='a b'", "id=x"]));
        assert_eq!(ids(html).collect::<Vec<_>>(), ["x"]);
        assert_eq!(words("<p>A &amp; <i>b</i>\n c</p>"), "A & b c");
    }

    #[test]
    fn edits_leave_the_rest_as_it_is() {
        let mut edits = Edits::default();
        edits.replace(3..4, "D");
        edits.remove(5..9);
        edits.replace(6..7, "lost");
        edits.insert(5, "[");
        edits.insert(0, ">");
        assert_eq!(edits.applied("abcdefghijk"), ">abcDe[jk");
    }

    #[test]
    fn a_dead_link_is_its_words_and_a_line_without_links_goes() {
        let html = "<p class=\"turn\"><a href=\"s.html#a\">Solution</a></p>\n<p>See <a href=\"s.html\">all</a>, \
                    <a class=\"x\" href=\"s.html\">one</a> and <a href=\"b.html\">b</a>.</p><p class=\"turn\"><a href=\"s.html\">S</a> \
                    <a href=\"#h\">H</a></p>";
        assert_eq!(
            unlinked(html, |target| target.starts_with("s.html")),
            "\n<p>See all, <a class=\"x\" >one</a> and <a href=\"b.html\">b</a>.</p><p class=\"turn\"> <a href=\"#h\">H</a></p>"
        );
    }
}
