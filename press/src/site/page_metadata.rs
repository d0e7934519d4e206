//! What a page says of itself to those who have not opened it (search engines, previews of links), and which edition
//! it belongs to.

use crate::book;
use crate::site::licence::Licence;
use html::{Edits, escaped};
use std::path::Path;
use std::{fs, io};

/// What is said on all pages.
pub(crate) struct SiteMetadata<'a> {
    /// The title of the book.
    pub(crate) book: &'a str,
    /// Who wrote it; may be empty.
    pub(crate) authors: &'a str,
    /// Version and commit; may be empty.
    pub(crate) edition: &'a str,
    /// The address of the site, with a slash at its end, if it is known.
    pub(crate) address: Option<&'a str>,
    /// What one may do with it, if it says so.
    pub(crate) licence: Option<&'a Licence>,
    /// The picture of the site, below its root, if it has one.
    pub(crate) picture: Option<&'a str>,
}

/// The most that a description says, characters.
const LONGEST: usize = 200;
/// A paragraph of fewer characters is a remark.
const SHORTEST: usize = 40;

/// The page `html`, which stands at `path` below the root of the site, with what it says of itself: the description and
/// what previews of links show in the head, and the spans of the theme with the classes `edition`, `licence` and, in
/// words on the title page, `rights`.
pub(crate) fn with_metadata(html: &str, path: &str, site: &SiteMetadata<'_>) -> String {
    let found = html::named(html, &["meta", "title", "main", "h1", "p", "span"]);
    let mut edits = Edits::default();
    if let Some(description) = found.iter().find(|element| element.get("name") == Some("description")) {
        let main = found.iter().find(|element| element.name == "main");
        let headed = main.and_then(|main| found.iter().find(|title| title.name == "h1" && main.holds(title)));
        let texts = found
            .iter()
            .skip_while(|element| headed.is_none_or(|title| element.start_tag.end < title.whole.end));
        let mut texts = texts.filter(|element| element.name == "p" && element.get("class").is_none());
        let words = texts.find_map(|text| first_words(&html[text.inside.clone()]));
        let words = words.as_deref().unwrap_or(description.get("content").unwrap_or_default());
        let title = found.iter().find(|element| element.name == "title");
        let title =
            title.map_or_else(|| site.book.to_owned(), |title| html::words(&html[title.inside.clone()]));
        let mut head = format!("<meta name=\"description\" content=\"{}\">", escaped(words));
        if !site.authors.is_empty() {
            head += &format!("\n        <meta name=\"author\" content=\"{}\">", escaped(site.authors));
        }
        let mut property = |name: &str, content: &str| {
            head += &format!("\n        <meta property=\"og:{name}\" content=\"{}\">", escaped(content));
        };
        property("type", "article");
        property("site_name", site.book);
        property("title", &title);
        property("description", words);
        if let Some(address) = site.address {
            property("url", &format!("{address}{path}"));
            if let Some(picture) = site.picture {
                property("image", &format!("{address}{picture}"));
                head += "\n        <meta name=\"twitter:card\" content=\"summary_large_image\">";
            }
            head += &format!("\n        <link rel=\"canonical\" href=\"{address}{path}\">");
        }
        edits.replace(description.whole.clone(), head);
    }
    let edition = if site.edition.is_empty() { String::new() } else { format!(" {}", escaped(site.edition)) };
    let words = site.licence.map_or(String::new(), |licence| escaped(&licence.words));
    let address = site.licence.and_then(|licence| licence.address(&"../".repeat(path.matches('/').count())));
    let link = match address {
        Some(address) => format!(" · <a rel=\"license\" href=\"{}\">{words}</a>", escaped(&address)),
        None if words.is_empty() => String::new(),
        None => format!(" · {words}"),
    };
    for span in found.iter().filter(|element| element.name == "span") {
        match span.get("class") {
            Some("edition") => edits.replace(span.whole.clone(), &*edition),
            Some("licence") => edits.replace(span.whole.clone(), &*link),
            Some("rights") => edits.replace(span.whole.clone(), &*words),
            _ => {}
        }
    }
    edits.applied(html)
}

/// Leads from the foot of every page of a finished site, its span with the class `downloads`, to files in the root,
/// each with what it is called.
pub(crate) fn add_downloads(site: &Path, downloads: &[(&str, &str)]) -> io::Result<()> {
    for page in book::files(site)?.iter().filter(|name| name.ends_with(".html")) {
        let up = "../".repeat(page.matches('/').count());
        let link = |(name, file): &(&str, &str)| format!(" · <a href=\"{up}{file}\">{name}</a>");
        let links: String = downloads.iter().map(link).collect();
        let html = fs::read_to_string(site.join(page))?;
        let mut edits = Edits::default();
        for span in html::named(&html, &["span"]).iter().filter(|span| span.is("span", "downloads")) {
            edits.replace(span.whole.clone(), &*links);
        }
        fs::write(site.join(page), edits.applied(&html))?;
    }
    Ok(())
}

/// The words of a paragraph that says something, shortened.
fn first_words(html: &str) -> Option<String> {
    let words = html::words(html);
    let end = match words.char_indices().nth(LONGEST) {
        _ if words.chars().count() < SHORTEST => return None,
        None => return Some(words),
        Some((end, _)) => words[..end].rfind(' ').unwrap_or(end),
    };
    Some(words[..end].trim_end_matches([',', ';', ':', '.']).to_owned() + " …")
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "<title>Tops &amp; coins</title>\n<meta name=\"description\" content=\"The book\">\n<main>\
                        <p>Chapter 1</p><h1>Tops</h1><p>Two pages.</p><p>A <em>top</em> \"stands\",\n and a coin does &amp; falls.</p><p>More</p></main>\
                        <footer>Tops<span class=\"edition\"></span></footer>";
    const SITE: SiteMetadata<'_> = SiteMetadata {
        book: "Tops",
        authors: "A & B",
        edition: "1.0, abc",
        address: None,
        picture: Some("preview.png"),
        licence: None,
    };

    #[test]
    fn a_page_says_what_it_is_about_and_where_it_is() {
        let description =
            "name=\"description\" content=\"A top &quot;stands&quot;, and a coin does &amp; falls.\">";
        let title = "og:title\" content=\"Tops &amp; coins\"";
        let author = "<meta name=\"author\" content=\"A &amp; B\">";
        let image = "og:image\" content=\"https://example.org/t/preview.png\"";
        let canonical = "canonical\" href=\"https://example.org/t/tops/index.html\"";
        for address in [None, Some("https://example.org/t/")] {
            let page = with_metadata(PAGE, "tops/index.html", &SiteMetadata { address, ..SITE });
            for (words, is_there) in [
                (description, true),
                (title, true),
                (author, true),
                ("<footer>Tops 1.0, abc</footer>", true),
                (image, address.is_some()),
                (canonical, address.is_some()),
            ] {
                assert_eq!(page.contains(words), is_there, "{words}: {page}");
            }
        }
        // Long words end at a word.
        let long = PAGE.replace("More", "").replace("falls.", &"falls, ".repeat(60));
        let page = with_metadata(&long, "tops.html", &SiteMetadata { edition: "", ..SITE });
        let found = html::named(&page, &["meta"]);
        let words = found[0].get("content").unwrap();
        assert!(words.ends_with("falls …") && words.len() < LONGEST + 30, "{words}");
        assert!(page.ends_with("<footer>Tops</footer>"));
    }

    #[test]
    fn a_page_claims_the_licence_that_book_toml_names_and_no_other() {
        let page = "<p><span class=\"rights\"></span></p>Tops<span class=\"licence\"></span>";
        let read = |table: &str| Licence::read(&format!("[preprocessor.press]\n{table}").parse().unwrap());
        for (words, place, path, expected) in [
            ("You & I", "", "a.html", "<p>You &amp; I</p>Tops · You &amp; I"),
            ("L", "LICENSE", "a/b.html", "<p>L</p>Tops · <a rel=\"license\" href=\"../LICENSE.txt\">L</a>"),
            (
                "L",
                "legal/terms.html",
                "a.html",
                "<p>L</p>Tops · <a rel=\"license\" href=\"terms.html\">L</a>",
            ),
            (
                "L",
                "https://example.org",
                "a/b.html",
                "<p>L</p>Tops · <a rel=\"license\" href=\"https://example.org\">L</a>",
            ),
        ] {
            let place = if place.is_empty() { String::new() } else { format!("licence-url = \"{place}\"") };
            let licence = read(&format!("licence = \"{words}\"\n{place}")).unwrap();
            assert_eq!(
                with_metadata(page, path, &SiteMetadata { licence: licence.as_ref(), ..SITE }),
                expected
            );
        }
        assert_eq!(read("").unwrap(), None);
        assert_eq!(with_metadata(page, "a.html", &SITE), "<p></p>Tops");
        for (table, words) in
            [("licence = 4", "licence of book.toml is a text"), ("licence-url = \"L\"", "does not name")]
        {
            assert!(read(table).unwrap_err().to_string().contains(words), "{words}");
        }
    }

    #[test]
    fn every_page_leads_to_the_downloads_wherever_it_is() {
        let site = std::env::temp_dir().join(format!("press-downloads-{}", std::process::id()));
        fs::create_dir_all(site.join("tops")).unwrap();
        let pages = [("index.html", ""), ("tops/index.html", "../")];
        for (page, _) in pages {
            fs::write(site.join(page), "<p>Tops<span class=\"downloads\"></span></p>").unwrap();
        }
        add_downloads(&site, &[("PDF", "tops.pdf"), ("EPUB", "tops.epub")]).unwrap();
        for (page, up) in pages {
            let links = format!(" · <a href=\"{up}tops.pdf\">PDF</a> · <a href=\"{up}tops.epub\">EPUB</a>");
            assert_eq!(fs::read_to_string(site.join(page)).unwrap(), format!("<p>Tops{links}</p>"));
        }
        fs::remove_dir_all(site).unwrap();
    }
}
