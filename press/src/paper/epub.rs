//! The book as an EPUB: the same sheets, each a file of XHTML.

use super::Paper;
use super::sheet::{Kind, Sheet};
use anyhow::{Context as _, Result};
use html::{StartTag, Token, VOID, attribute, escaped, text};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// Names that XML writes with capitals, where HTML does not care.
const CAPITALS: [&str; 12] = [
    "viewBox",
    "linearGradient",
    "radialGradient",
    "gradientUnits",
    "gradientTransform",
    "clipPath",
    "clipPathUnits",
    "spreadMethod",
    "preserveAspectRatio",
    "patternUnits",
    "textLength",
    "lengthAdjust",
];

const STYLE: &str = include_str!("epub.css");

const CONTAINER: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
    <container version=\"1.0\" xmlns=\"urn:oasis:names:tc:opendocument:xmlns:container\">\n<rootfiles>\
    <rootfile full-path=\"book/package.opf\" media-type=\"application/oebps-package+xml\"/></rootfiles>\n</container>\n";

impl Paper {
    /// Writes the whole book into `target`, its fonts and the colours of its figures taken from `site`.
    pub fn write_epub(&self, site: &Path, target: &Path) -> Result<()> {
        if let Some(folder) = target.parent() {
            fs::create_dir_all(folder)?;
        }
        let names: Vec<String> = (0..self.sheets.len()).map(|n| format!("page-{n:02}.xhtml")).collect();
        let bodies: Vec<String> = self.sheets.iter().map(Sheet::unfolded).collect();
        let places =
            bodies.iter().zip(&names).flat_map(|(body, name)| html::ids(body).map(move |id| (id, name)));
        let places: BTreeMap<String, &String> = places.collect();
        let mut archive = ZipWriter::new(File::create(target)?);
        // The type of the file comes first, and readable.
        add(&mut archive, "mimetype", b"application/epub+zip")?;
        add(&mut archive, "META-INF/container.xml", CONTAINER)?;
        let mut items = String::new();
        let mut spine = String::new();
        let title = format!(
            "<section class=\"title-page\">\n<h1>{}</h1>\n<p>{}</p>\n<p>{}</p>\n<p>{}</p>\n<p>{}</p>\n</section>\n",
            self.settings.title,
            self.settings.description,
            self.settings.authors,
            self.edition_in_words(),
            self.settings.licence,
        );
        add(&mut archive, "book/title.xhtml", self.document(&html::words(&self.settings.title), &title))?;
        for ((sheet, body), name) in self.sheets.iter().zip(&bodies).zip(&names) {
            let body = xhtml(body, |id| places.get(id).map(|place| format!("{place}#{id}")));
            let body = format!("<section class=\"{}\">\n{body}\n</section>\n", sheet.class());
            roxmltree::Document::parse(&body)
                .with_context(|| format!("“{}” is no XML", sheet.plain_title()))?;
            let page = self.document(&sheet.plain_title(), &body);
            let holds =
                [("mathml", "<math"), ("svg", "<svg")].into_iter().filter(|(_, mark)| page.contains(mark));
            let holds: Vec<&str> = holds.map(|(name, _)| name).collect();
            let holds =
                if holds.is_empty() { String::new() } else { format!(" properties=\"{}\"", holds.join(" ")) };
            add(&mut archive, &format!("book/{name}"), &page)?;
            let id = name.trim_end_matches(".xhtml");
            let _ = writeln!(
                items,
                "<item id=\"{id}\" href=\"{name}\" media-type=\"application/xhtml+xml\"{holds}/>"
            );
            let _ = writeln!(spine, "<itemref idref=\"{id}\"/>");
        }
        add(&mut archive, "book/style.css", STYLE.to_owned() + &roles(site)?)?;
        add(&mut archive, "book/contents.xhtml", self.navigation(&names))?;
        for (family, path) in fonts(site)? {
            add(&mut archive, &format!("book/fonts/{family}.woff2"), fs::read(path)?)?;
            let _ = writeln!(
                items,
                "<item id=\"font-{family}\" href=\"fonts/{family}.woff2\" media-type=\"font/woff2\"/>"
            );
        }
        for (n, (file, kind)) in self.pictures().into_iter().enumerate() {
            let place = site.join(&file);
            let bytes = fs::read(&place).with_context(|| place.display().to_string())?;
            add(&mut archive, &format!("book/{file}"), bytes)?;
            let _ = writeln!(items, "<item id=\"picture-{n}\" href=\"{file}\" media-type=\"image/{kind}\"/>");
        }
        add(&mut archive, "book/package.opf", self.package(&items, &spine))?;
        archive.finish()?;
        Ok(())
    }

    /// The pictures on its pages, each a file of the site, and what kind of image it is.
    fn pictures(&self) -> BTreeSet<(String, String)> {
        let images = self.sheets.iter().flat_map(|sheet| html::named(&sheet.html, &["img"]));
        let files = images.filter_map(|image| image.get("src").map(str::to_owned));
        let kind = |file: &str| match file.rsplit('.').next().unwrap_or_default().to_lowercase().as_str() {
            "jpg" => "jpeg".to_owned(),
            "svg" => "svg+xml".to_owned(),
            other => other.to_owned(),
        };
        files.map(|file| (file.clone(), kind(&file))).collect()
    }

    /// A file of XHTML.
    fn document(&self, title: &str, body: &str) -> String {
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" \
             xmlns:epub=\"http://www.idpf.org/2007/ops\" lang=\"{language}\" xml:lang=\"{language}\">\n<head>\n\
             <title>{}</title>\n<link rel=\"stylesheet\" type=\"text/css\" href=\"style.css\"/>\n</head>\n<body>\n{body}</body>\n\
             </html>\n",
            escaped(title),
            language = self.settings.language,
        )
    }

    /// What a reader of EPUBs shows as contents.
    fn navigation(&self, names: &[String]) -> String {
        let mut lines = String::new();
        let mut open = false;
        for (sheet, name) in self.sheets.iter().zip(names) {
            let number = sheet.number.map_or(String::new(), |number| format!("{number}. "));
            let (number, words) = match (sheet.kind, sheet.is_leaf) {
                (Kind::Exercises, _) => (String::new(), "Exercises".to_owned()),
                (_, true) => (String::new(), sheet.plain_title()),
                (_, false) => (number, sheet.plain_title()),
            };
            let is_below = sheet.is_leaf && sheet.kind != Kind::Solutions;
            lines += match (is_below, open) {
                (true, false) => "<ol>\n",
                (true, true) => "</li>\n",
                (false, true) => "</li>\n</ol>\n</li>\n",
                (false, false) if lines.is_empty() => "",
                (false, false) => "</li>\n",
            };
            open = is_below;
            let _ = write!(lines, "<li><a href=\"{name}\">{}</a>", escaped(&(number + &words)));
        }
        lines += if open { "</li>\n</ol>\n</li>\n" } else { "</li>\n" };
        self.document(
            "Contents",
            &format!("<nav epub:type=\"toc\" id=\"toc\">\n<h1>Contents</h1>\n<ol>\n{lines}</ol>\n</nav>\n"),
        )
    }

    fn package(&self, items: &str, spine: &str) -> String {
        let day = self.day.as_deref().unwrap_or("2000-01-01");
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<package xmlns=\"http://www.idpf.org/2007/opf\" version=\"3.0\" \
             unique-identifier=\"id\" xml:lang=\"{language}\">\n<metadata xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n\
             <dc:identifier id=\"id\">urn:book:{}:{}</dc:identifier>\n<dc:title>{}</dc:title>\n\
             <dc:language>{language}</dc:language>\n<dc:creator>{}</dc:creator>\n<dc:description>{}</dc:description>\n\
             {rights}<dc:date>{day}</dc:date>\n\
             <meta property=\"dcterms:modified\">{day}T00:00:00Z</meta>\n</metadata>\n<manifest>\n\
             <item id=\"title\" href=\"title.xhtml\" media-type=\"application/xhtml+xml\"/>\n\
             <item id=\"contents\" href=\"contents.xhtml\" media-type=\"application/xhtml+xml\" properties=\"nav\"/>\n\
             <item id=\"style\" href=\"style.css\" media-type=\"text/css\"/>\n{items}</manifest>\n\
             <spine>\n<itemref idref=\"title\"/>\n<itemref idref=\"contents\"/>\n{spine}</spine>\n</package>\n",
            self.file_name(),
            self.edition.replace(", ", "-"),
            self.settings.title,
            self.settings.authors,
            self.settings.description,
            language = self.settings.language,
            rights = match self.settings.licence.as_str() {
                "" => String::new(),
                licence => format!("<dc:rights>{licence}</dc:rights>\n"),
            },
        )
    }
}

/// Adds a file without a date, packed if it is none of those that are packed already or have to be read as they are.
fn add(archive: &mut ZipWriter<File>, name: &str, bytes: impl AsRef<[u8]>) -> Result<()> {
    let is_packed = name != "mimetype" && !name.ends_with(".woff2");
    let method = if is_packed { CompressionMethod::Deflated } else { CompressionMethod::Stored };
    let options =
        SimpleFileOptions::default().last_modified_time(DateTime::default()).compression_method(method);
    archive.start_file(name, options)?;
    Ok(archive.write_all(bytes.as_ref())?)
}

/// What the roles of drawings look like: every figure that stands alone says it of all of them.
fn roles(site: &Path) -> Result<String> {
    let mut figures: Vec<_> =
        fs::read_dir(site.join("figures"))?.filter_map(|entry| Some(entry.ok()?.path())).collect();
    figures.sort();
    let Some(figure) = figures.iter().find(|path| path.extension().is_some_and(|ending| ending == "svg"))
    else {
        return Ok(String::new());
    };
    let drawn = fs::read_to_string(figure)?;
    let styles = html::named(&drawn, &["style"]);
    Ok(styles.first().map_or(String::new(), |style| drawn[style.inside.clone()].to_owned()))
}

/// The fonts of the site, by the names of their files without the digits that mdBook adds.
fn fonts(site: &Path) -> Result<BTreeMap<String, PathBuf>> {
    let mut fonts = BTreeMap::new();
    for entry in fs::read_dir(site.join("fonts"))? {
        let path = entry?.path();
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        if path.extension().is_some_and(|ending| ending == "woff2") {
            fonts.insert(name.rsplit_once('-').map_or(name.clone(), |(family, _)| family.to_owned()), path);
        }
    }
    Ok(fonts)
}

/// Attributes that MathML 3, which EPUB asks for, has on `mstyle` only.
const OF_STYLE: [&str; 2] = ["displaystyle", "scriptlevel"];

/// HTML as mdBook writes it, as XML; `place` gives the address of an id.
fn xhtml(html: &str, place: impl Fn(&str) -> Option<String>) -> String {
    let mut xml = String::with_capacity(html.len());
    // What of code is hidden goes.
    let mut hidden = 0_u32;
    // Whether an element of style stands around each of those that are open.
    let mut styled = Vec::new();
    for token in html::tokens(html) {
        match token {
            Token::StartTag(tag) => {
                let name = text(&tag.name);
                if hidden > 0 || attribute(&tag, "class").as_deref() == Some("boring") {
                    hidden += u32::from(!tag.self_closing);
                    continue;
                }
                let style = style(&name, &tag);
                let is_styled = !style.is_empty();
                xml += &style;
                start(&mut xml, &name, &tag, &place);
                if !tag.self_closing && !VOID.contains(&name.as_str()) {
                    styled.push(is_styled);
                } else if is_styled {
                    xml += "</mstyle>";
                }
            }
            Token::EndTag(tag) => {
                if hidden > 0 {
                    hidden -= 1;
                    continue;
                }
                let _ = write!(xml, "</{}>", capitals(&text(&tag.name)));
                if styled.pop() == Some(true) {
                    xml += "</mstyle>";
                }
            }
            Token::String(words) if hidden == 0 => xml += &escaped(&text(&words)),
            _ => {}
        }
    }
    xml
}

/// The element of style that has to stand around an element of mathematics.
fn style(name: &str, tag: &StartTag<usize>) -> String {
    if matches!(name, "math" | "mstyle") {
        return String::new();
    }
    let values = OF_STYLE.iter().filter_map(|key| Some((key, attribute(tag, key)?)));
    let attributes: String = values.map(|(key, value)| format!(" {key}=\"{}\"", escaped(&value))).collect();
    if attributes.is_empty() { attributes } else { format!("<mstyle{attributes}>") }
}

fn start(xml: &mut String, name: &str, tag: &StartTag<usize>, place: &impl Fn(&str) -> Option<String>) {
    let _ = write!(xml, "<{}", capitals(name));
    match name {
        "svg" => *xml += " xmlns=\"http://www.w3.org/2000/svg\"",
        "math" => *xml += " xmlns=\"http://www.w3.org/1998/Math/MathML\"",
        _ => {}
    }
    for (key, value) in &tag.attributes {
        let (key, mut value) = (text(key), text(value));
        let is_style = OF_STYLE.contains(&key.as_str()) && !matches!(name, "math" | "mstyle");
        let is_dead = key == "download" && !tag.attributes.contains_key(&b"href"[..]);
        if key.starts_with("data-") || is_style || is_dead {
            continue;
        }
        if let Some(found) = value.strip_prefix('#').filter(|_| key == "href").and_then(place) {
            value = found;
        }
        let _ = write!(xml, " {}=\"{}\"", capitals(&key), escaped(&value));
    }
    *xml += if tag.self_closing || VOID.contains(&name) { "/>" } else { ">" };
}

fn capitals(name: &str) -> &str {
    CAPITALS.into_iter().find(|written| written.eq_ignore_ascii_case(name)).unwrap_or(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn html_becomes_xml() {
        let html = "<p>a &amp; b<br><a href=\"#x\" data-set=\"q\">x</a> <a href=\"#y\">y</a>&nbsp;</p><svg viewbox=\"0 0 1 1\">\
                    <lineargradient gradientunits=\"u\" /></svg><code>a<span class=\"boring\">b<i>c</i></span>d</code>\
                    <math><mfrac displaystyle=\"true\"><mi>a</mi><mi>b</mi></mfrac></math><a class=\"save\" download>s</a>";
        let xml = xhtml(html, |id| (id == "x").then(|| "page-1.xhtml#x".to_owned()));
        assert_eq!(
            xml,
            "<p>a &amp; b<br/><a href=\"page-1.xhtml#x\">x</a> <a href=\"#y\">y</a>\u{a0}</p>\
             <svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1 1\"><linearGradient gradientUnits=\"u\"/></svg>\
             <code>ad</code><math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mstyle displaystyle=\"true\"><mfrac><mi>a</mi><mi>b</mi>\
             </mfrac></mstyle></math><a class=\"save\">s</a>"
        );
    }
}
