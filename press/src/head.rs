//! What a page says of itself to those who have not opened it (search engines, previews of links), and which edition
//! it belongs to.

use crate::html::escaped;
use crate::licence::Licence;
use html5gum::{Token, Tokenizer};
use std::path::Path;
use std::{fs, io};

/// What is said on all pages.
pub(crate) struct Said<'a> {
    /// The title of the book.
    pub(crate) book: &'a str,
    /// Version and commit; may be empty.
    pub(crate) edition: &'a str,
    /// The address of the site, with a slash at its end, if it is known.
    pub(crate) address: Option<&'a str>,
    /// What one may do with it, if it says so.
    pub(crate) licence: Option<&'a Licence>,
    /// The picture of the site, below its root, if it has one.
    pub(crate) picture: Option<&'a str>,
}

/// Where the page's template takes a description, and where the edition.
const DESCRIPTION: &str = "<meta name=\"description\" content=\"";
const EDITION: &str = "<span class=\"edition\"></span>";
/// Where the licence stands: at the foot, and in words on the title page.
const LICENCE: &str = "<span class=\"licence\"></span>";
const RIGHTS: &str = "<span class=\"rights\"></span>";
/// Where links to the whole book in other forms go.
const DOWNLOADS: &str = "<span class=\"downloads\"></span>";
/// The most that a description says, characters.
const LONGEST: usize = 200;
/// A paragraph of fewer characters is a remark.
const SHORTEST: usize = 40;

/// The page `html`, which stands at `path` below the root of the site, with what it says of itself.
pub(crate) fn completed(html: &str, path: &str, said: &Said<'_>) -> String {
    let mut html = html.to_owned();
    if let Some(begin) = html.find(DESCRIPTION).map(|at| at + DESCRIPTION.len())
        && let Some(end) = html[begin..].find("\">").map(|at| begin + at)
    {
        let words = first_words(&html).unwrap_or_else(|| html[begin..end].to_owned());
        let title = between(&html, "<title>", "</title>").unwrap_or(said.book).to_owned();
        let mut head = format!("{words}\">\n");
        let mut property = |name: &str, content: &str| {
            head += &format!("        <meta property=\"og:{name}\" content=\"{content}\">\n");
        };
        property("type", "article");
        property("site_name", &escaped(said.book));
        property("title", &title);
        property("description", &words);
        if let Some(address) = said.address {
            property("url", &format!("{address}{path}"));
            if let Some(picture) = said.picture {
                property("image", &format!("{address}{picture}"));
                head += "        <meta name=\"twitter:card\" content=\"summary_large_image\">\n";
            }
            head += &format!("        <link rel=\"canonical\" href=\"{address}{path}\">\n");
        }
        html.replace_range(begin..end + 3, &head);
    }
    let edition = if said.edition.is_empty() { String::new() } else { format!(" {}", escaped(said.edition)) };
    let words = said.licence.map_or(String::new(), |licence| escaped(&licence.words));
    let address = said.licence.and_then(|licence| licence.address(&"../".repeat(path.matches('/').count())));
    let link = match address {
        Some(address) => format!(" · <a rel=\"license\" href=\"{}\">{words}</a>", escaped(&address)),
        None if words.is_empty() => String::new(),
        None => format!(" · {words}"),
    };
    html.replace(EDITION, &edition).replace(LICENCE, &link).replace(RIGHTS, &words)
}

/// Leads from the foot of every page of a finished site to files in its root, each with what it is called.
pub(crate) fn add_downloads(site: &Path, files: &[(&str, &str)]) -> io::Result<()> {
    fn add(folder: &Path, up: &str, files: &[(&str, &str)]) -> io::Result<()> {
        let link = |(name, file): &(&str, &str)| format!(" · <a href=\"{up}{file}\">{name}</a>");
        let links: String = files.iter().map(link).collect();
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            if path.is_dir() {
                add(&path, &format!("../{up}"), files)?;
            } else if path.extension().is_some_and(|ending| ending == "html") {
                let page = fs::read_to_string(&path)?;
                if page.contains(DOWNLOADS) {
                    fs::write(&path, page.replace(DOWNLOADS, &links))?;
                }
            }
        }
        Ok(())
    }
    add(site, "", files)
}

fn between<'a>(html: &'a str, start: &str, end: &str) -> Option<&'a str> {
    let rest = &html[html.find(start)? + start.len()..];
    rest.find(end).map(|at| &rest[..at])
}

/// The first paragraph of the text that says something, shortened, as the value of an attribute.
fn first_words(html: &str) -> Option<String> {
    let main = &html[html.find("<main>")?..];
    let text = &main[main.find("</h1>")?..];
    let mut paragraphs = text.split("<p>").skip(1).filter_map(|rest| rest.split("</p>").next()).map(plain);
    let words = paragraphs.find(|words| words.chars().count() >= SHORTEST)?;
    if words.chars().count() <= LONGEST {
        return Some(escaped(&words));
    }
    let end = words.char_indices().nth(LONGEST).map_or(words.len(), |(at, _)| at);
    let end = words[..end].rfind(' ').unwrap_or(end);
    Some(escaped(words[..end].trim_end_matches([',', ';', ':', '.'])) + " …")
}

/// The words of some HTML.
pub(crate) fn plain(html: &str) -> String {
    let mut words = String::new();
    for token in Tokenizer::new(html) {
        let Ok(token) = token;
        if let Token::String(text) = token {
            words += &String::from_utf8_lossy(&text);
        }
    }
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "<title>Tops &amp; coins</title>\n<meta name=\"description\" content=\"The book\">\n<main>\
                        <p>Chapter 1</p><h1>Tops</h1><p>Two pages.</p><p>A <em>top</em> \"stands\",\n and a coin does &amp; falls.</p><p>More</p></main>\
                        <footer>Tops<span class=\"edition\"></span></footer>";

    #[test]
    fn a_page_says_what_it_is_about_and_where_it_is() {
        let said = Said {
            book: "Tops",
            edition: "1.0, abc",
            address: None,
            picture: Some("preview.png"),
            licence: None,
        };
        let page = completed(PAGE, "tops/index.html", &said);
        assert!(
            page.contains(
                "name=\"description\" content=\"A top &quot;stands&quot;, and a coin does &amp; falls.\">"
            ),
            "{page}"
        );
        assert!(
            page.contains("og:title\" content=\"Tops &amp; coins\"")
                && page.contains("<footer>Tops 1.0, abc</footer>")
        );
        assert!(
            !page.contains("og:image") && !page.contains("canonical"),
            "an address is needed for these: {page}"
        );
        let page =
            completed(PAGE, "tops/index.html", &Said { address: Some("https://example.org/t/"), ..said });
        assert!(page.contains("og:image\" content=\"https://example.org/t/preview.png\""), "{page}");
        assert!(page.contains("canonical\" href=\"https://example.org/t/tops/index.html\""), "{page}");
    }

    #[test]
    fn a_page_claims_the_licence_that_book_toml_names_and_no_other() {
        let said = |table: &str, path: &str| {
            let config = format!("[preprocessor.press]\n{table}").parse().unwrap();
            let licence = Licence::read(&config).unwrap();
            let said =
                Said { book: "", edition: "", address: None, picture: None, licence: licence.as_ref() };
            completed(&format!("<p>{RIGHTS}</p>Tops{LICENCE}"), path, &said)
        };
        assert_eq!(said("", "a.html"), "<p></p>Tops");
        assert_eq!(said("licence = \"You & I\"", "a.html"), "<p>You &amp; I</p>Tops · You &amp; I");
        let link = "Tops · <a rel=\"license\" href=\"../L.txt\">You</a>";
        assert!(said("licence = \"You\"\nlicence-url = \"L\"", "a/b.html").ends_with(link));
    }

    #[test]
    fn every_page_leads_to_the_downloads_wherever_it_is() {
        let site = std::env::temp_dir().join(format!("press-downloads-{}", std::process::id()));
        fs::create_dir_all(site.join("tops")).unwrap();
        for page in ["index.html", "tops/index.html"] {
            fs::write(site.join(page), format!("<p>Tops{DOWNLOADS}</p>")).unwrap();
        }
        add_downloads(&site, &[("PDF", "tops.pdf"), ("EPUB", "tops.epub")]).unwrap();
        for (page, up) in [("index.html", ""), ("tops/index.html", "../")] {
            let links = format!(" · <a href=\"{up}tops.pdf\">PDF</a> · <a href=\"{up}tops.epub\">EPUB</a>");
            assert_eq!(fs::read_to_string(site.join(page)).unwrap(), format!("<p>Tops{links}</p>"));
        }
        fs::remove_dir_all(site).unwrap();
    }

    #[test]
    fn long_words_end_at_a_word() {
        let long = PAGE.replace("More", "").replace("falls.", &"falls, ".repeat(60));
        let said = Said { book: "Tops", edition: "", address: None, picture: None, licence: None };
        let page = completed(&long, "tops.html", &said);
        let words = between(&page, DESCRIPTION, "\">").unwrap();
        assert!(words.ends_with("falls …") && words.len() < LONGEST + 30, "{words}");
        assert!(page.ends_with("<footer>Tops</footer>"));
    }
}
