//! A page in our dialect becomes a page that mdBook understands.

use crate::api;
use crate::book::{Page, relative, resolve};
use crate::fault::Faults;
use crate::labels::Registry;
use crate::maths::{Maths, Quantity};
use crate::page::{EquationLabel, Item, Kind, Label, Mention, Note, Placed, Table, Words};
use crate::places::{self, Place};
use crate::rendered::Rendered;
use crate::scan::{options, scan};
use crate::ties::{self, BLANK};
use crate::{answers, faces, module, panel, scenes, snippets, tables};
use pulldown_cmark::{CowStr, Event, Parser, Tag, html::push_html};
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// Renders all pages with what is `drawn`; the faults if there are any. `code` holds the files whose comments
/// cite labels, with their text.
///
/// # Errors
/// Every fault of every page, and every label that code cites and no page defines.
pub(crate) fn render(
    pages: &[Page],
    drawn: &Rendered,
    library: &str,
    code: &[(String, String)],
) -> Result<Vec<String>, Faults> {
    let mut faults = Faults::default();
    let scans: Vec<Vec<Placed<'_>>> = pages.iter().map(|page| scan(page, &mut faults)).collect();
    scenes::check(&drawn.scenes, &mut faults);
    let registry = Registry::build(pages, &scans, drawn, &mut faults);
    check_citations_in_code(&registry, code, &mut faults);
    let maths = Maths::new(pages, &mut faults);
    let places = places::places(library, code);
    let mut cited = Cited::new();
    let mut live = 0;
    let mut rendered = Vec::with_capacity(pages.len());
    for (index, (page, found)) in pages.iter().zip(&scans).enumerate() {
        let mut printer = Printer {
            page,
            index,
            registry: &registry,
            maths: &maths,
            drawn,
            library,
            places: &places,
            cited: &mut cited,
            notes: Vec::new(),
            live: &mut live,
            faults: &mut faults,
        };
        rendered.push(printer.page(found));
    }
    registry.check_citations(&cited, &mut faults);
    let titles: Vec<String> =
        pages.iter().zip(&scans).map(|(page, found)| short_title(page, found)).collect();
    for (page, text) in pages.iter().zip(&mut rendered) {
        *text = with_ways_back(std::mem::take(text), page, pages, &titles, &cited);
    }
    if faults.is_empty() { Ok(rendered) } else { Err(faults) }
}

/// Adds a fault for each label that a comment cites and no page defines.
fn check_citations_in_code(registry: &Registry, code: &[(String, String)], faults: &mut Faults) {
    for (file, text) in code {
        for (n, line) in text.lines().enumerate() {
            let Some(comment) = line.find("//").map(|at| &line[at..]) else {
                continue;
            };
            for (kind, name) in places::cited(comment) {
                if let Err(message) = registry.find(&Label { kind, name: name.to_owned() }) {
                    faults.add(file, n + 1, message);
                }
            }
        }
    }
}

/// Label → the pages that mention it, each once, by their order, and whether an id stands where the page does.
type Cited = BTreeMap<Label, Vec<(usize, bool)>>;

/// What a link to a page is called where there is little room: `Chapter 4`, `Chapter 4 · Exercises`, `Preface`.
fn short_title(page: &Page, items: &[Placed<'_>]) -> String {
    let title = || {
        items.iter().find_map(|placed| match &placed.item {
            Item::Heading { level: 1, plain, .. } => Some(plain.clone()),
            _ => None,
        })
    };
    match (page.chapter, &page.part) {
        (Some(chapter), None) => format!("Chapter {chapter}"),
        (Some(chapter), Some(part)) => format!("Chapter {chapter} · {part}"),
        (None, _) => title().unwrap_or_else(|| page.path.clone()),
    }
}

/// Stands behind the name of an entry of the bibliography until it is known which pages cite it.
const CITING: &str = "<!--citing:";

/// A page with links, at the end of each entry of the bibliography, to where the entry is cited.
fn with_ways_back(mut text: String, page: &Page, pages: &[Page], titles: &[String], cited: &Cited) -> String {
    while let Some(at) = text.find(CITING) {
        let Some(end) = text[at..].find("-->").map(|end| at + end) else { break };
        let label = Label { kind: Kind::Citation, name: text[at + CITING.len()..end].to_owned() };
        text.replace_range(at..end + 3, "");
        let link = |(order, &(index, has_id)): (usize, &(usize, bool))| {
            let target = relative(&page.path, &pages[index].path);
            let id = if has_id { format!("#from-{}-{order}", label.name) } else { String::new() };
            format!("[{}]({target}{id})", titles[index])
        };
        let links: Vec<String> = cited.get(&label).into_iter().flatten().enumerate().map(link).collect();
        if links.is_empty() {
            continue; // which is a fault
        }
        let end = ["\n- ", "\n\n"].iter().filter_map(|next| text[at..].find(next)).min();
        let end = text[..end.map_or(text.len(), |end| at + end)].trim_end().len();
        text.insert_str(end, &format!(" <span class=\"citing\">Cited in {}.</span>", links.join(", ")));
    }
    text
}

struct Printer<'a, 'f> {
    page: &'a Page,
    /// Its order among the pages.
    index: usize,
    registry: &'a Registry,
    maths: &'a Maths,
    drawn: &'a Rendered,
    library: &'a str,
    /// Where the library's comments name equations.
    places: &'a BTreeMap<String, Vec<Place>>,
    /// Every label that some page mentions.
    cited: &'f mut Cited,
    /// The notes of the page whose marks are printed, in their order.
    notes: Vec<String>,
    /// How many snippets with live numbers are printed.
    live: &'f mut usize,
    faults: &'f mut Faults,
}

impl Printer<'_, '_> {
    fn fault(&mut self, offset: usize, message: impl Into<String>) {
        self.page.reporter(self.faults).fault(offset, message);
    }

    /// The page with every item replaced; everything else stands as it was written.
    fn page(&mut self, items: &[Placed<'_>]) -> String {
        let text = &self.page.text;
        let mut out = String::with_capacity(text.len() * 4);
        let mut done = 0;
        for placed in items {
            let range = placed.range.clone();
            if range.start < done {
                // Inside something already replaced: a caption, which is printed by other means.
                if let Item::Link { target } = &placed.item {
                    self.check_link(target, range.start);
                }
                continue;
            }
            let replacement = match &placed.item {
                item @ Item::Heading { level: 1, .. } => {
                    let heading = self.item(item, range.start);
                    self.title(heading.as_deref().unwrap_or(&text[range.clone()])).or(heading)
                }
                item => self.item(item, range.start),
            };
            let Some(replacement) = replacement else {
                continue;
            };
            let (head, tail) = match &placed.item {
                Item::InlineMaths { .. } => ties::around(&text[done..range.start], &text[range.end..]),
                _ => (0, 0),
            };
            let (start, end) = (range.start - head, range.end + tail);
            out.push_str(&text[done..start]);
            out.push_str(&ties::tied(&text[start..range.start], &replacement, &text[range.end..end]));
            done = end;
        }
        out.push_str(&text[done..]);
        out
    }

    /// The title of a page of a numbered chapter, below the number of the chapter.
    fn title(&self, heading: &str) -> Option<String> {
        let chapter = self.page.chapter?;
        // Only the sections of a chapter's first page have numbers.
        let (class, part) = match &self.page.part {
            None => ("kicker", String::new()),
            Some(part) => ("kicker leaf", format!(" · {}", escaped(part))),
        };
        Some(format!(
            "<p class=\"{class}\" style=\"--chapter: {chapter}\">Chapter {chapter}{part}</p>\n\n{heading}"
        ))
    }

    fn item(&mut self, item: &Item<'_>, offset: usize) -> Option<String> {
        match item {
            Item::InlineMaths { tex } => self.inline(tex, offset + 1),
            Item::DisplayMaths { tex, label } => self.display(tex, label.as_ref(), offset),
            Item::Figure { label, caption } => self.figure(label, caption),
            Item::Scene { label, caption } => self.scene(label, caption, offset),
            Item::Setting(Some(setting)) => Some(self.setting(setting, offset)),
            Item::Setting(None) => Some("</a>".to_owned()),
            Item::Table { table, caption } => Some(self.table(table, caption)),
            Item::LibraryTable { name, caption } => self.library_table(name, caption, offset),
            Item::Heading { level, label: Some(label), title, .. } => self.heading(*level, label, title),
            Item::Mention(mention) => {
                let before = &self.page.text[..offset];
                let (words, target) = self.mention(mention, before, offset)?;
                Some(format!("{}[{words}]({target})", self.way_back(mention)))
            }
            Item::Coloured(Some(quantity)) => Some(format!("<span class=\"{}\">", quantity.class())),
            Item::Coloured(None) => Some("</span>".to_owned()),
            Item::Blank => Some(ties::BLANK.to_owned()),
            Item::NoteMark(name) => Some(self.note_mark(name)),
            Item::Note(note) => Some(self.note(note)),
            Item::NoteDefinition => Some(String::new()),
            Item::Snippet { code } => Some(self.snippet(code, offset)),
            Item::Citation { label, short } => Some(format!(
                "<span class=\"cite\" id=\"{}\">&#91;{}&#93;</span>{CITING}{}-->",
                label.id(),
                escaped(short),
                label.name
            )),
            Item::Link { target } => {
                self.check_link(target, offset);
                None
            }
            Item::Heading { label: None, .. } | Item::Hint | Item::Id(_) => None,
        }
    }

    /// A snippet with numbers for the labels that it cites, its checks folded, and what it uses of the library.
    fn snippet(&mut self, code: &str, offset: usize) -> String {
        let mut shown = String::with_capacity(code.len());
        let mut done = 0;
        for (place, name) in snippets::cited_labels(code, &(0..code.len())) {
            let label = Label { kind: Kind::Equation, name: name["eq:".len()..].to_owned() };
            match self.words(&label) {
                Ok((number, _)) => {
                    shown.push_str(&code[done..place.start]);
                    shown.push_str(&number);
                    done = place.end;
                }
                Err(message) => self.fault(offset + place.start, message),
            }
        }
        shown.push_str(&code[done..]);
        let panel = self.panel(&shown);
        snippets::with_folded_checks(&snippets::without_ranges(&shown), panel.as_deref())
            + &api::uses(self.library, code).map_or(String::new(), |line| format!("\n\n{line}\n"))
    }

    /// The panel of a snippet that has live numbers.
    fn panel(&mut self, shown: &str) -> Option<String> {
        let lines: Vec<&str> = shown.lines().collect();
        let (answers, _) = answers::answers(&lines);
        (!answers.live.is_empty() && !self.drawn.is_still).then(|| {
            *self.live += 1;
            panel::panel(&answers, *self.live - 1, self.page.path.split('/').next().unwrap_or_default())
        })
    }

    fn inline(&mut self, tex: &str, offset: usize) -> Option<String> {
        self.maths
            .inline(tex, self.maths.folder(&self.page.path, offset - 1))
            .map_err(|fault| self.fault(offset + fault.offset, fault.message))
            .ok()
    }

    fn display(&mut self, tex: &str, label: Option<&EquationLabel>, offset: usize) -> Option<String> {
        let converted = self.maths.display(tex, self.maths.folder(&self.page.path, offset));
        let mathml = converted.map_err(|fault| self.fault(offset + 2 + fault.offset, fault.message)).ok()?;
        let Some(EquationLabel { label, source, corrected }) = label else {
            return Some(format!("<div class=\"equation\"><div class=\"formula\">{mathml}</div></div>"));
        };
        let number = self.registry.find(label).map(|entry| entry.number.clone()).unwrap_or_default();
        let id = label.id();
        let mut marks = format!("<a class=\"number\" href=\"#{id}\">({number})</a>");
        for n in source {
            let (words, title) = if *corrected {
                ("corrects", format!("corrects equation ({n}) of the source"))
            } else {
                ("source", format!("equation ({n}) of the source"))
            };
            let _ = write!(
                marks,
                "<a class=\"source\" id=\"source-{n}\" href=\"#source-{n}\" title=\"{title}\">{words} {n}</a>"
            );
        }
        marks += &self.code(&label.name);
        Some(format!(
            "<div class=\"equation numbered\" id=\"{id}\"><div class=\"formula\">{mathml}</div><div class=\"marks\">{marks}</div></div>"
        ))
    }

    /// Links to the lines of the library that name an equation.
    fn code(&self, equation: &str) -> String {
        let Some(places) = self.places.get(equation) else { return String::new() };
        let up = "../".repeat(self.page.path.matches('/').count());
        let link = |(index, place): (usize, &Place)| {
            let (words, target) = (place.words(), place.target());
            // What is heard begins with what is seen, so that who speaks can name the link.
            let (text, name) = match index {
                0 if places.len() == 1 => ("code".to_owned(), "code".to_owned()),
                0 => ("code 1".to_owned(), "code 1".to_owned()),
                _ => ((index + 1).to_string(), format!("code {}", index + 1)),
            };
            format!("<a href=\"{up}{target}\" title=\"{words}\" aria-label=\"{name}: {words}\">{text}</a>")
        };
        let links: Vec<String> = places.iter().enumerate().map(link).collect();
        format!("<span class=\"code\">{}</span>", links.join(", "))
    }

    fn figure(&mut self, label: &Label, caption: &Words<'_>) -> Option<String> {
        let figure = self.drawn.figures.iter().find(|figure| figure.id == label.written())?;
        let number = self.registry.find(label).map(|entry| entry.number.clone()).unwrap_or_default();
        let number = match number.as_str() {
            "" => String::new(), // on a page that belongs to no chapter
            number => format!("<span class=\"number\">Figure {number}.</span> "),
        };
        let caption = self.words_of(caption, "caption");
        let up = "../".repeat(self.page.path.matches('/').count());
        let class = if figure.wide { "figure wide" } else { "figure" };
        Some(format!(
            "<figure class=\"{class}\" id=\"{}\">\n{}\n<figcaption>{number}{caption}\u{a0}\
             <a class=\"save\" href=\"{up}figures/{}\" download title=\"Save this figure as an SVG file\">SVG</a></figcaption>\n</figure>",
            label.id(),
            figure.svg.trim(),
            figure.file_name(),
        ))
    }

    /// A live scene: its question, its still, and the panel of its controls if there is a module that moves it.
    fn scene(&mut self, label: &Label, caption: &Words<'_>, offset: usize) -> Option<String> {
        let drawn = self.drawn;
        let place = drawn.scenes.iter().position(|scene| scene.name == label.name)?;
        let scene = &drawn.scenes[place];
        let number = self.registry.find(label).map(|entry| entry.number.clone()).unwrap_or_default();
        let caption = self.words_of(caption, "caption");
        let mut html = |words: &str| {
            let faces = words.split('$').step_by(2).map(|words| faces::Face::Text.check(words));
            if let Err((_, message)) = faces.collect::<Result<Vec<_>, _>>() {
                self.fault(offset, format!("in the scene, {message}"));
            }
            self.words_of(&scenes::words(words, offset), "scene")
        };
        let (id, question) = (label.id(), html(&scene.question));
        let panel = if drawn.is_still { String::new() } else { scenes::panel(scene, html) };
        let file = module::file(&scene.chapter);
        let module = if drawn.is_still { String::new() } else { format!(" data-module=\"{file}\"") };
        Some(format!(
            "<figure class=\"scene\" id=\"{id}\" data-scene=\"{place}\"{module} aria-labelledby=\"{id}-caption\">\n<p class=\"question\">{question}</p>\n\
             <div class=\"drawing\">{}</div>\n{panel}\
             <figcaption id=\"{id}-caption\"><span class=\"number\">Scene {number}.</span> {caption}</figcaption>\n</figure>",
            scene.svg.trim(),
        ))
    }

    /// The beginning of a link that sets the scene of the page: `turning?spin=3`.
    fn setting(&mut self, setting: &str, offset: usize) -> String {
        let (name, settings) = setting.split_once('?').unwrap_or((setting, ""));
        let label = Label { kind: Kind::Scene, name: name.to_owned() };
        let scene = self.drawn.scenes.iter().find(|scene| scene.name == name);
        let checked = match (self.registry.find(&label), scene) {
            (Ok(entry), Some(_)) if entry.page != self.page.path => {
                Err(format!("scene:{name} stands on another page: refer to it as @scene:{name}"))
            }
            (Ok(_), Some(scene)) => scenes::check_settings(scene, settings),
            (Err(message), _) => Err(message),
            (_, None) => Ok(()), // said where it should stand
        };
        if let Err(message) = checked {
            self.fault(offset, message);
        }
        format!("<a href=\"#{}\" data-set=\"{}\">", label.id(), escaped(settings))
    }

    /// A table that the library gives.
    fn library_table(&mut self, name: &str, caption: &Words<'_>, offset: usize) -> Option<String> {
        let Some((_, text)) = self.drawn.tables.iter().find(|(known, _)| known == name) else {
            self.fault(offset, format!("the library gives no table `{name}`"));
            return None;
        };
        let events: Vec<_> = Parser::new_ext(text, options()).into_offset_iter().collect();
        let mut table = tables::read(&events);
        table.rows.iter_mut().flatten().flat_map(|cell| &mut cell.words).for_each(|word| word.1 = offset);
        Some(self.table(&table, caption))
    }

    /// A table as HTML, on as many lines as it has rows: no blank one, or Markdown would read on.
    fn table(&mut self, table: &Table<'_>, caption: &Words<'_>) -> String {
        let caption = self.words_of(caption, "caption");
        let mut out =
            format!("<div class=\"table-wrapper\">\n<table>\n<caption>{caption}</caption>\n<thead>\n");
        let columns = tables::columns(table);
        for (n, row) in table.rows.iter().enumerate() {
            out.push_str("<tr>");
            for (cell, column) in row.iter().zip(&columns) {
                let (element, scope) = if n == 0 { ("th", " scope=\"col\"") } else { ("td", "") };
                let class = if column.is_some() { " class=\"number\"" } else { "" };
                let words = self.words_of(&cell.words, "table");
                let room = column.filter(|_| n > 0).map(|most| tables::room(cell, most)).unwrap_or_default();
                let _ = write!(out, "<{element}{scope}{class}>{words}{room}</{element}>");
            }
            out.push_str(if n == 0 { "</tr>\n</thead>\n<tbody>\n" } else { "</tr>\n" });
        }
        out + "</tbody>\n</table>\n</div>\n"
    }

    /// The mark of a note; the note itself stands behind the block.
    fn note_mark(&mut self, name: &str) -> String {
        self.notes.push(name.to_owned());
        let number = self.notes.len();
        format!(
            "<a class=\"note-mark\" id=\"noteref-{name}\" href=\"#note-{name}\" role=\"doc-noteref\">{number}</a>"
        )
    }

    fn note(&mut self, Note { name, words, .. }: &Note<'_>) -> String {
        let number = self.notes.iter().position(|mark| mark == name).map_or(0, |at| at + 1);
        let words = self.words_of(words, "note");
        format!(
            "\n\n<aside class=\"note\" id=\"note-{name}\" role=\"doc-footnote\" aria-label=\"Note {number}\"><a class=\"note-number\" \
             href=\"#noteref-{name}\" aria-label=\"{number}, back to the text\">{number}</a> {words}</aside>\n\n"
        )
    }

    /// A caption or a note as HTML: Markdown's own handwriting, mathematics and references.
    fn words_of(&mut self, words: &Words<'_>, what: &str) -> String {
        let mut out = String::new();
        let mut printed: Vec<Event<'_>> = Vec::new();
        let mut before = String::new(); // as it is written, without its mathematics
        let mut taken = 0; // of the next text, by the formula before it
        for (n, &(ref event, offset)) in words.iter().enumerate() {
            let next = match words.get(n + 1) {
                Some((Event::Text(text), _)) => text,
                _ => "",
            };
            let html = match event {
                Event::InlineMath(tex) => {
                    match self.maths.inline_html(tex, self.maths.folder(&self.page.path, offset)) {
                        Ok(mathml) => {
                            let last = match printed.last_mut() {
                                Some(Event::InlineHtml(html)) => html,
                                _ => &mut CowStr::from(""),
                            };
                            let (head, tail) = ties::around(last, next);
                            let (kept, head) = last.split_at(last.len() - head);
                            let formula = ties::tied(head, &mathml, &next[..tail]);
                            *last = CowStr::from(kept.to_owned());
                            taken = tail;
                            Event::InlineHtml(CowStr::from(formula))
                        }
                        Err(fault) => {
                            self.fault(offset, format!("in the {what}, {}", fault.message));
                            continue;
                        }
                    }
                }
                Event::Text(text) => {
                    let html = self.mentions_in(&text[std::mem::take(&mut taken)..], &before, offset);
                    before.push_str(text);
                    Event::InlineHtml(CowStr::from(tables::powers_of_ten(&html)))
                }
                Event::Start(Tag::Link { dest_url, .. }) if dest_url.starts_with("scene:") => {
                    Event::InlineHtml(CowStr::from(self.setting(&dest_url["scene:".len()..], offset)))
                }
                Event::SoftBreak => Event::Text(CowStr::from(" ")),
                Event::FootnoteReference(name) => Event::InlineHtml(CowStr::from(self.note_mark(name))),
                other => other.clone(),
            };
            printed.push(html);
        }
        push_html(&mut out, printed.into_iter());
        coloured(out.trim())
    }

    /// Text as HTML, with its mentions as links; `before` is what stands before it.
    fn mentions_in(&mut self, text: &str, before: &str, offset: usize) -> String {
        let mut out = String::new();
        let mut rest = text;
        while let Some(at) = rest.find('@') {
            out.push_str(&prose(&rest[..at]));
            let tail = &rest[at + 1..];
            let end = tail
                .find(|c: char| !(c.is_ascii_alphanumeric() || c == '-' || c == ':'))
                .unwrap_or(tail.len());
            let word = tail[..end].trim_end_matches([':', '-']);
            let mention = word.split_once(':').and_then(|(prefix, name)| match prefix {
                "source" => name.parse().ok().map(Mention::Source),
                _ => Kind::ALL
                    .into_iter()
                    .find(|kind| kind.prefix() == prefix)
                    .map(|kind| Mention::Label(Label { kind, name: name.to_owned() })),
            });
            let before = format!("{before}{}", &text[..text.len() - rest.len() + at]);
            match mention.and_then(|mention| self.mention(&mention, &before, offset)) {
                Some((words, target)) => {
                    let _ = write!(out, "<a href=\"{target}\">{}</a>", escaped(&words));
                }
                None => out.push_str(&escaped(&rest[at..=at + word.len()])),
            }
            rest = &tail[word.len()..];
        }
        out.push_str(&prose(rest));
        out
    }

    /// The words of a reference behind the text `before`, and where it leads.
    fn mention(&mut self, mention: &Mention, before: &str, offset: usize) -> Option<(String, String)> {
        let found = match mention {
            Mention::Source(number) => self.registry.find_source(*number).map(|entry| {
                (format!("source{BLANK}{number}"), entry.page.clone(), format!("source-{number}"))
            }),
            Mention::Label(label) => {
                let pages = self.cited.entry(label.clone()).or_default();
                if pages.last().is_none_or(|&(last, _)| last != self.index) {
                    pages.push((self.index, false));
                }
                self.words(label).map(|(words, page)| (words, page, label.id()))
            }
        };
        match found {
            Ok((words, page, id)) => {
                let words = ties::in_place(words, before);
                Some((words, format!("{}#{id}", relative(&self.page.path, &page))))
            }
            Err(message) => {
                self.fault(offset, message);
                None
            }
        }
    }

    /// An id for the way back from the bibliography, where a page first cites an entry.
    fn way_back(&mut self, mention: &Mention) -> String {
        let Mention::Label(label) = mention else { return String::new() };
        let order = self.cited.get(label).map_or(0, Vec::len);
        match self.cited.get_mut(label).and_then(|pages| pages.last_mut()) {
            Some((_, has_id @ false)) if label.kind == Kind::Citation => {
                *has_id = true;
                format!("<span id=\"from-{}-{}\"></span>", label.name, order - 1)
            }
            _ => String::new(),
        }
    }

    /// What a reference to `label` says, and on which page it is.
    fn words(&self, label: &Label) -> Result<(String, String), String> {
        let entry = self.registry.find(label)?;
        let words = match label.kind {
            Kind::Equation => format!("({})", entry.number),
            Kind::Figure if entry.number.is_empty() => {
                return Err(format!("{} has no number by which to refer to it", label.written()));
            }
            Kind::Figure => format!("Figure{BLANK}{}", entry.number),
            Kind::Scene => format!("Scene{BLANK}{}", entry.number),
            Kind::Exercise => format!("Exercise{BLANK}{}", entry.number),
            Kind::Solution => {
                let exercise =
                    self.registry.find(&Label { kind: Kind::Exercise, name: label.name.clone() })?;
                format!("Solution{BLANK}{}", exercise.number)
            }
            Kind::Section => format!("“{}”", entry.title),
            Kind::Citation => entry.title.replace(' ', BLANK),
        };
        Ok((words, entry.page.clone()))
    }

    fn heading(&self, level: u8, label: &Label, title: &str) -> Option<String> {
        let marks = "#".repeat(usize::from(level));
        let id = label.id();
        let partner = match label.kind {
            Kind::Exercise => Label { kind: Kind::Solution, name: label.name.clone() },
            Kind::Solution => Label { kind: Kind::Exercise, name: label.name.clone() },
            _ => return Some(format!("{marks} {title} {{#{id}}}")),
        };
        let exercise = if label.kind == Kind::Exercise { label } else { &partner };
        let entry = self.registry.find(exercise).ok()?.clone();
        let place = self.registry.find(&partner).ok()?; // its absence is reported with the labels
        let target = format!("{}#{}", relative(&self.page.path, &place.page), partner.id());
        let (kind, there) =
            if label.kind == Kind::Exercise { ("Exercise", "Solution") } else { ("Solution", "Exercise") };
        Some(format!(
            "{marks} {kind} {}. {} {{#{id}}}\n\n<p class=\"turn\"><a href=\"{target}\">{there} {}</a></p>\n",
            entry.number, entry.title, entry.number
        ))
    }

    /// A link to another page or to an anchor must lead somewhere.
    fn check_link(&mut self, target: &str, offset: usize) {
        if target.starts_with("http://") || target.starts_with("https://") || target.starts_with("mailto:") {
            return;
        }
        let (path, anchor) = target.split_once('#').unwrap_or((target, ""));
        let page = match path.strip_suffix(".html") {
            _ if path.is_empty() => Some(self.page.path.clone()),
            Some(stem) => resolve(&self.page.path, &format!("{stem}.md")), // as raw HTML may write it
            None => resolve(&self.page.path, path),
        };
        let Some(page) = page.filter(|page| self.registry.has_page(page)) else {
            self.fault(offset, format!("the link to `{target}` leads to no page of the book"));
            return;
        };
        if !anchor.is_empty() && !self.registry.has_anchor(&page, anchor) {
            self.fault(
                offset,
                format!("the link to `{target}` leads to a page without the anchor `#{anchor}`"),
            );
        }
    }
}

/// A run of text as HTML, its numbers tied to their units.
pub(crate) fn prose(text: &str) -> String {
    let mut tied = text.to_owned();
    for at in ties::blanks(text).into_iter().rev() {
        tied.replace_range(at..=at, BLANK);
    }
    escaped(&tied)
}

/// Text as HTML.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// HTML with its words `[words]{.role}` in the colours of their quantities.
fn coloured(html: &str) -> String {
    let mut out = String::with_capacity(html.len());
    let mut rest = html;
    while let Some((words, behind)) = rest.split_once("]{.") {
        let role = behind.split_once('}');
        let quantity = role.and_then(|(role, behind)| Some((Quantity::of_role(role).ok()?, behind)));
        match (words.rfind('['), quantity) {
            (Some(open), Some((quantity, behind))) => {
                let (before, words) = (&words[..open], &words[open + 1..]);
                out.push_str(&format!("{before}<span class=\"{}\">{words}</span>", quantity.class()));
                rest = behind;
            }
            _ => {
                out.push_str(words);
                out.push_str("]{.");
                rest = behind;
            }
        }
    }
    out + rest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rendered::Input;

    /// What becomes of one page, which is chapter 1.
    fn printed(text: &str) -> String {
        let page = Page::new("book", "a.md".to_owned(), Some(1), None, text.to_owned());
        let printed = render(&[page], &Rendered::default(), "", &[]);
        printed.unwrap_or_else(|faults| panic!("{:?}", faults.sorted())).remove(0)
    }

    /// The only formula of a text.
    fn maths(text: &str) -> String {
        let page = printed(&format!("# A\n\n{text}\n"));
        page[page.find("<math").unwrap()..page.find("</math>").unwrap() + "</math>".len()].to_owned()
    }

    #[test]
    fn the_marks_of_a_quotation_are_no_part_of_its_formula() {
        let quoted =
            printed("# A\n\n> [!NOTE]\n> So\n>\n> $$\n> a > b\n> = c\n> $$ {#eq:x}\n>\n> and $d\n> e$.\n");
        let plain = printed("# A\n\n$$\na > b\n= c\n$$ {#eq:x}\n\nand $d\ne$.\n");
        let maths = |text: &str| -> Vec<String> {
            text.split("<math")
                .skip(1)
                .filter_map(|rest| rest.split("</math>").next())
                .map(str::to_owned)
                .collect()
        };
        assert_eq!(maths(&plain).len(), 2);
        assert_eq!(maths(&quoted), maths(&plain));
    }

    #[test]
    fn a_page_comes_out_as_expected() {
        let page = "# A\n\n## Motion {#sec:motion}\n\n$$\na\n$$ {#eq:x source=19}\n\n$$\nb\n$$\n\n\
                    $$\nc\n$$ {#eq:y source=\"20 21\" corrected}\n\nSee @eq:y, @source:19, @sec:motion and `@eq:z`.\n";
        let expected = "<p class=\"kicker\" style=\"--chapter: 1\">Chapter 1</p>\n\n# A\n\n## Motion {#sec-motion}\n\n\
            <div class=\"equation numbered\" id=\"eq-x\"><div class=\"formula\"><math display=\"block\"><mi>a</mi></math></div>\
            <div class=\"marks\"><a class=\"number\" href=\"#eq-x\">(1.1)</a>\
            <a class=\"source\" id=\"source-19\" href=\"#source-19\" title=\"equation (19) of the source\">source 19</a></div></div>\n\n\
            <div class=\"equation\"><div class=\"formula\"><math display=\"block\"><mi>b</mi></math></div></div>\n\n\
            <div class=\"equation numbered\" id=\"eq-y\"><div class=\"formula\"><math display=\"block\"><mi>c</mi></math></div>\
            <div class=\"marks\"><a class=\"number\" href=\"#eq-y\">(1.2)</a>\
            <a class=\"source\" id=\"source-20\" href=\"#source-20\" title=\"corrects equation (20) of the source\">corrects 20</a>\
            <a class=\"source\" id=\"source-21\" href=\"#source-21\" title=\"corrects equation (21) of the source\">corrects 21</a></div></div>\n\n\
            See [(1.2)](a.md#eq-y), [source\u{a0}19](a.md#source-19), [“Motion”](a.md#sec-motion) and `@eq:z`.\n";
        assert_eq!(printed(page), expected);
    }

    #[test]
    fn words_have_the_colour_of_their_quantity() {
        let page = printed("# A\n\nThe [angular *momentum*]{.momentum}, [so] and [$x$]{.spin}.\n");
        let [momentum, spin] = ["momentum", "spin"].map(|role| format!("<span class=\"q-{role}\">"));
        let expected = format!(
            "The {momentum}angular *momentum*</span>, [so] and {spin}<math><mi>x</mi></math></span>."
        );
        assert!(page.contains(&expected), "{page}");
        let page = printed("# A\n\n| a |\n|---|\n| [$x$ *so*]{.spin}, [b] |\n\nTable: [L]{.momentum}].\n");
        let cell = format!("<td>{spin}<math><mi>x</mi></math> <em>so</em></span>, [b]</td>");
        let caption = format!("<caption>{momentum}L</span>].</caption>");
        assert!(page.contains(&cell) && page.contains(&caption), "{page}");
    }

    #[test]
    fn the_paragraph_below_a_formula_is_read_like_any_other() {
        let page = printed("# A\n\n$$\na\n$$\n\nSo [spin]{.spin} is 5 kg.\n");
        assert!(page.contains("So <span class=\"q-spin\">spin</span> is 5\u{a0}kg."), "{page}");
    }

    #[test]
    fn brackets_around_the_number_of_an_equation_are_its_own() {
        let page = printed(
            "# A\n\n$$\na\n$$ {#eq:x}\n\nBy @eq:x (@eq:x, as in @eq:x) and (so)\n@eq:x.[^a]\n\n[^a]: By (@eq:x) @eq:x.\n",
        );
        let [x, bare, word] = ["(1.1)", "1.1", "Eq.\u{a0}1.1"].map(|words| format!("[{words}](a.md#eq-x)"));
        assert!(page.contains(&format!("By {x} ({bare}, as in {word}) and (so)\n{x}.")), "{page}");
        let [x, bare] = ["(1.1)", "1.1"].map(|words| format!("<a href=\"a.md#eq-x\">{words}</a>"));
        assert!(page.contains(&format!("By ({bare}) {x}.")), "{page}");
    }

    #[test]
    fn a_formula_is_tied_to_what_stands_beside_it_in_text_tables_and_notes() {
        let page = printed(
            "# A\n\nSo ($x$), 5 kg, *$x$.*[^a]\n\n| a |\n|---|\n| ($x$) |\n\nTable: T.\n\n[^a]: So ($x$), 5 kg.\n",
        );
        let tied = |head: &str, tail: &str| {
            format!("<span class=\"tied\">{head}<math><mi>x</mi></math>{tail}</span>")
        };
        for expected in [
            format!("So {} 5\u{a0}kg, *{}*", tied("(", "),"), tied("", ".")),
            format!("<td>{}</td>", tied("(", ")")),
            format!("So {} 5\u{a0}kg.</aside>", tied("(", "),")),
        ] {
            assert!(page.contains(&expected), "{page}");
        }
    }

    #[test]
    fn a_table_has_a_caption_and_columns_of_numbers() {
        let page = "# A\n\n| what[^a] | it's |\n|---|---|\n| `a` | 1.25 |\n| @sec:x | 1e-3 |\n| b | – |\n\n\
                    Table: Words\nand *more*.[^b]\n\nEnd.\n\n[^a]: A.\n[^b]: B.\n\n## X {#sec:x}\n";
        let mark = |n: u8, name: &str| {
            format!(
                "<a class=\"note-mark\" id=\"noteref-{name}\" href=\"#note-{name}\" role=\"doc-noteref\">{n}</a>"
            )
        };
        let pad = |zeros: &str| format!("<span class=\"pad\" data-pad=\"{zeros}\"></span>");
        let expected = format!(
            "<div class=\"table-wrapper\">\n<table>\n<caption>Words and <em>more</em>.{}</caption>\n<thead>\n\
             <tr><th scope=\"col\">what{}</th><th scope=\"col\" class=\"number\">it’s</th></tr>\n</thead>\n<tbody>\n\
             <tr><td><code>a</code></td><td class=\"number\">1.25</td></tr>\n\
             <tr><td><a href=\"a.md#sec-x\">“X”</a></td><td class=\"number\">10<sup>−3</sup>{}</td></tr>\n\
             <tr><td>b</td><td class=\"number\">–{}</td></tr>\n</tbody>\n</table>\n</div>\n\n\n<aside ",
            mark(1, "b"),
            mark(2, "a"),
            pad(".00"),
            pad(".00")
        );
        let page = printed(page);
        assert!(page.contains(&expected), "{page}");
    }

    #[test]
    fn the_number_of_the_chapter_stands_above_the_title() {
        let print = |chapter, part: Option<&str>| {
            let text = "# A {#sec:a}\n".to_owned();
            let page = Page::new("book", "a.md".to_owned(), chapter, part.map(str::to_owned), text);
            render(&[page], &Rendered::default(), "", &[]).unwrap_or_default().remove(0)
        };
        let kicker = |class: &str, words: &str| {
            format!("<p class=\"{class}\" style=\"--chapter: 4\">{words}</p>\n\n# A {{#sec-a}}\n")
        };
        assert_eq!(print(Some(4), None), kicker("kicker", "Chapter 4"));
        assert_eq!(print(Some(4), Some("Exercises")), kicker("kicker leaf", "Chapter 4 · Exercises"));
        assert_eq!(print(None, None), "# A {#sec-a}\n");
    }

    #[test]
    fn a_scene_has_its_question_still_and_panel_and_links_that_set_it() {
        let control = |name: &str, words: &str, input, start| crate::rendered::Control {
            name: name.to_owned(),
            words: words.to_owned(),
            input,
            start,
            unit: "rad/s".to_owned(),
            shown: "SHOWN".to_owned(),
        };
        let scene = crate::rendered::Scene {
            name: "plate".to_owned(),
            chapter: "a.md".to_owned(),
            question: "Why $x$?".to_owned(),
            svg: "<svg></svg>".to_owned(),
            view: Some([-30.0, 20.0]),
            still: 0.5,
            controls: vec![
                control("spin", "spin, $x$", Input::Slider { from: -1.0, to: 4.0, step: 0.1 }, 2.0),
                control("drag", "drag", Input::LogSlider { from: 1e-3, to: 1.0 }, 0.01),
                control("camera", "camera", Input::Choice(vec!["room".to_owned(), "body".to_owned()]), 0.0),
                control("cones", "cones", Input::Switch, 1.0),
                control("kick", "Kick", Input::Button, -1.0),
            ],
            presets: vec![("a ball".to_owned(), "spin=1&drag=0.1".to_owned())],
            readings: vec!["wobbles".to_owned()],
        };
        let mut drawn = Rendered { scenes: vec![scene], ..Rendered::default() };
        let text = "# A\n\n![A *plate*.](scene:plate)\n\n[Set $x$](scene:plate?spin=3&kick=0).\n".to_owned();
        let page = Page::new("book", "a.md".to_owned(), Some(1), None, text);
        let print = |drawn: &Rendered| {
            let printed = render(std::slice::from_ref(&page), drawn, "", &[]);
            printed.unwrap_or_else(|faults| panic!("{:?}", faults.sorted())).remove(0)
        };
        let x = maths("$x$");
        let range = "<input type=\"range\" id=\"scene-plate-";
        let moving = print(&drawn);
        for part in [
            "<figure class=\"scene\" id=\"scene-plate\" data-scene=\"0\" data-module=\"live-a.md.js\" aria-labelledby=\"scene-plate-caption\">\n<p class=\"question\">Why ",
            "<div class=\"drawing\"><svg></svg></div>\n<div class=\"panel\">\n",
            &format!(
                "<label for=\"scene-plate-spin\">spin, {x}</label>{range}spin\" name=\"spin\" min=\"-1\" max=\"4\" \
                 step=\"0.1\" value=\"2\" data-start=\"2\" data-unit=\"rad/s\"><output for=\"scene-plate-spin\">SHOWN</output>"
            ),
            &format!("{range}drag\" name=\"drag\" min=\"-3\" max=\"0\" step=\"any\" value=\"-2\""),
            " data-log>",
            "<input type=\"radio\" name=\"scene-plate-camera\" value=\"0\" data-name=\"camera\" checked data-start> room",
            "<input type=\"radio\" name=\"scene-plate-camera\" value=\"1\" data-name=\"camera\"> body",
            "<input type=\"checkbox\" id=\"scene-plate-cones\" name=\"cones\" checked data-start> cones",
            "<button type=\"button\" class=\"press\" name=\"kick\" data-start=\"-1\">Kick</button>",
            "class=\"time\" id=\"scene-plate-time\" min=\"0\" max=\"1\" step=\"any\" value=\"0.5\"",
            "name=\"azimuth\" min=\"-180\" max=\"180\" step=\"any\" value=\"-30\"",
            "<div><dt>wobbles</dt><dd></dd></div>",
            "<button type=\"button\" data-set=\"spin=1&amp;drag=0.1\">a ball</button>",
            "<figcaption id=\"scene-plate-caption\"><span class=\"number\">Scene 1.1.</span> A <em>plate</em>.</figcaption>\n</figure>",
            &format!("<a href=\"#scene-plate\" data-set=\"spin=3&amp;kick=0\">Set {}</a>.", maths("$x$")),
        ] {
            assert!(moving.contains(part), "{part} in {moving}");
        }
        let figure = &moving[moving.find("<figure").unwrap()..moving.find("</figure>").unwrap()];
        assert!(!figure.contains("\n\n"), "Markdown would read on");
        drawn.is_still = true;
        let still = print(&drawn);
        assert!(
            !still.contains("panel") && !still.contains("data-module") && still.contains("<svg></svg>"),
            "{still}"
        );
    }

    #[test]
    fn a_note_of_a_caption_stands_below_the_figure() {
        let [svg, standalone] = [String::new(), String::new()];
        let figure = crate::rendered::Figure {
            id: "fig:x".to_owned(),
            chapter: "a".to_owned(),
            svg,
            standalone,
            wide: false,
        };
        let drawn = Rendered { figures: vec![figure], ..Rendered::default() };
        let text = "# A\n\n![It's so.](fig:x)[^a]\n\n[^a]: A.\n".to_owned();
        let page = Page::new("book", "a.md".to_owned(), Some(1), None, text);
        let printed = render(&[page], &drawn, "", &[]);
        let printed = printed.unwrap_or_else(|faults| panic!("{:?}", faults.sorted())).remove(0);
        let at = |words: &str| printed.find(words).unwrap_or_else(|| panic!("{words} in {printed}"));
        assert!(at("It’s so.<a class=\"note-mark\"") < at("</figcaption>"));
        assert!(at("</figure>") < at("<aside class=\"note\""));
    }

    #[test]
    fn a_note_stands_behind_the_block_that_refers_to_it() {
        let mark = |n: u8, name: &str| {
            format!(
                "<a class=\"note-mark\" id=\"noteref-{name}\" href=\"#note-{name}\" role=\"doc-noteref\">{n}</a>"
            )
        };
        let note = |n: u8, name: &str, words: &str| {
            format!(
                "<aside class=\"note\" id=\"note-{name}\" role=\"doc-footnote\" aria-label=\"Note {n}\"><a class=\"note-number\" \
                 href=\"#noteref-{name}\" aria-label=\"{n}, back to the text\">{n}</a> {words}</aside>"
            )
        };
        let page = "# A\n\n$$\na\n$$ {#eq:x}\n\nSo.[^b] More[^a]\nhere.\n\n[^a]: It's $x$.\n\n[^b]: From *b*\n    by @eq:x.\n\n\
                    - one[^c]\n- two\n\n> quoted[^d]\n\nEnd.\n\n[^c]: C.\n[^d]: D.\n";
        let printed = printed(page);
        let blocks: Vec<&str> =
            printed.split("\n\n").map(str::trim).filter(|block| !block.is_empty()).collect();
        let x = maths("$x$");
        assert_eq!(
            blocks[3..],
            [
                format!("So.{} More{}\nhere.", mark(1, "b"), mark(2, "a")),
                note(1, "b", "From <em>b</em> by <a href=\"a.md#eq-x\">(1.1)</a>."),
                note(2, "a", &format!("It’s <span class=\"tied\">{x}.</span>")),
                format!("- one{}\n- two", mark(3, "c")),
                note(3, "c", "C."),
                format!("> quoted{}", mark(4, "d")),
                note(4, "d", "D."),
                "End.".to_owned(),
            ]
        );
    }
}
