//! Captions, notes, cells of tables and words of scenes: Markdown that the press itself makes HTML of.

use super::Printer;
use super::references::Reference;
use crate::colours;
use crate::print::nonbreaking;
use crate::read::items::{Item, PlacedItem, Words};
use crate::read::label_syntax;
use html::{breakable, escaped};
use live::numbers::{tied, with_power};
use pulldown_cmark::{CowStr, Event, Tag, html::push_html};
use std::collections::BTreeMap;
use std::fmt::Write as _;

impl Printer<'_, '_> {
    /// A caption or a note as HTML: Markdown's own handwriting, mathematics and references.
    pub(super) fn words_of(&mut self, words: &Words<'_>, what: &str) -> String {
        let mut out = String::new();
        let mut printed: Vec<Event<'_>> = Vec::new();
        let mut before = String::new(); // as it is written, without its mathematics
        let mut taken = 0; // of the next text, by what stands before it
        let tags = coloured(words);
        for (n, &(ref event, offset)) in words.iter().enumerate() {
            let next = match words.get(n + 1) {
                Some((Event::Text(text), _)) => text,
                _ => "",
            };
            let html = match event {
                Event::InlineMath(tex) => match self.maths.inline_html(tex, &self.folder(offset)) {
                    Ok(mathml) => {
                        let last = match printed.last_mut() {
                            Some(Event::InlineHtml(html)) => html,
                            _ => &mut CowStr::from(""),
                        };
                        let (head, tail) = nonbreaking::around(last, next);
                        let (kept, head) = last.split_at(last.len() - head);
                        let formula = nonbreaking::tied(head, &mathml, &next[..tail]);
                        *last = CowStr::from(kept.to_owned());
                        taken = tail;
                        Event::InlineHtml(CowStr::from(formula))
                    }
                    Err(fault) => {
                        self.fault(offset, format!("in the {what}, {}", fault.message));
                        continue;
                    }
                },
                Event::Text(_) if let Some((tag, length)) = tags.get(&n) => {
                    taken = *length;
                    Event::InlineHtml(CowStr::from(tag.clone()))
                }
                Event::Text(text) => {
                    let html = self.mentions_in(&text[std::mem::take(&mut taken)..], &before, offset);
                    before.push_str(text);
                    Event::InlineHtml(CowStr::from(powers_of_ten(&html)))
                }
                Event::Start(Tag::Link { dest_url, .. }) if dest_url.starts_with("scene:") => {
                    Event::InlineHtml(CowStr::from(self.setting(&dest_url["scene:".len()..], offset)))
                }
                Event::Code(code) => {
                    Event::InlineHtml(CowStr::from(format!("<code>{}</code>", breakable(&escaped(code)))))
                }
                Event::SoftBreak => Event::Text(CowStr::from(" ")),
                Event::FootnoteReference(name) => Event::InlineHtml(CowStr::from(self.note_mark(name))),
                other => other.clone(),
            };
            printed.push(html);
        }
        push_html(&mut out, printed.into_iter());
        out.trim().to_owned()
    }

    /// Text as HTML, with its mentions as links; `before` is what stands before it.
    fn mentions_in(&mut self, text: &str, before: &str, offset: usize) -> String {
        let (mut out, mut done) = (String::new(), 0);
        // What is wrong with them is said where the page is read.
        for PlacedItem { range, item } in label_syntax::mentions(text, &(0..text.len()), false, |_, _| {}) {
            let Item::Mention(mention) = item else { continue };
            out.push_str(&escaped(&tied(&text[done..range.start])));
            let before = format!("{before}{}", &text[..range.start]);
            match self.mention(&mention, &before, offset) {
                Some(Reference { words, target, title }) => {
                    let title =
                        if title.is_empty() { title } else { format!(" title=\"{}\"", escaped(&title)) };
                    let _ = write!(out, "<a href=\"{target}\"{title}>{}</a>", escaped(&words));
                }
                None => out.push_str(&escaped(&text[range.clone()])),
            }
            done = range.end;
        }
        out + &escaped(&tied(&text[done..]))
    }
}

/// The tags in the places of the brackets of `[words]{.role}`, and how many bytes of the next text belong to them.
fn coloured(words: &Words<'_>) -> BTreeMap<usize, (String, usize)> {
    let (mut tags, mut open) = (BTreeMap::new(), Vec::new());
    for (n, (event, _)) in words.iter().enumerate() {
        match (event, words.get(n + 1)) {
            (Event::Text(text), _) if text.as_ref() == "[" => open.push(n),
            (Event::Text(text), next) if text.as_ref() == "]" => {
                let Some((start, (Event::Text(behind), _))) = open.pop().zip(next) else { continue };
                let role =
                    behind.strip_prefix("{.").and_then(|rest| rest.split_once('}')).map(|(role, _)| role);
                if let Some((role, class)) = role.and_then(|role| Some((role, colours::class_of(role).ok()?)))
                {
                    tags.insert(start, (format!("<span class=\"{class}\">"), 0));
                    tags.insert(n, ("</span>".to_owned(), "{.}".len() + role.len()));
                }
            }
            _ => {}
        }
    }
    tags
}

/// HTML in which `1.6e8` is written as on paper, 1.6·10⁸, and `1e-3` as 10⁻³.
fn powers_of_ten(html: &str) -> String {
    let mut out = String::with_capacity(html.len());
    let mut rest = html;
    while let Some(at) = rest.find(|c: char| c.is_ascii_digit() || c == '<') {
        if rest[at..].starts_with('<') {
            let (tag, behind) = rest.split_at(rest[at..].find('>').map_or(rest.len(), |end| at + end + 1));
            out.push_str(tag);
            rest = behind;
            continue;
        }
        let glued = rest[..at].ends_with(|c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '#' | ';'));
        let end =
            at + rest[at..].find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(rest.len() - at);
        out.push_str(&rest[..at]);
        let mantissa = &rest[at..end];
        rest = &rest[end..];
        let power = rest.strip_prefix('e').filter(|_| !glued).and_then(|power| {
            let sign = power.len() - power.strip_prefix(['-', '−']).unwrap_or(power).len();
            let digits = power[sign..].bytes().take_while(u8::is_ascii_digit).count();
            let (power, behind) = power.split_at(sign + digits);
            (digits > 0 && !behind.starts_with(char::is_alphanumeric)).then_some((power, behind))
        });
        match power {
            Some((power, behind)) => {
                out.push_str(&with_power(mantissa, power));
                rest = behind;
            }
            None => out.push_str(mantissa),
        }
    }
    out + rest
}

#[cfg(test)]
mod tests {
    use super::powers_of_ten;

    #[test]
    fn powers_of_ten_are_written_as_on_paper() {
        let said =
            powers_of_ten("1e-3, −4.77e−1 and 1.6e8; v1e3 <a id=\"x-1e3\">&#1e3;</a> 2e 3 1.5 e2 0x1e3g");
        let sup = |power: &str| format!("10<sup>{power}</sup>");
        assert_eq!(
            said,
            format!(
                "{}, −4.77·{} and 1.6·{}; v1e3 <a id=\"x-1e3\">&#1e3;</a> 2e 3 1.5 e2 0x1e3g",
                sup("−3"),
                sup("−1"),
                sup("8")
            )
        );
    }
}
