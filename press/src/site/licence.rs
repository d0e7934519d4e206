//! What one may do with the book. It says what book.toml says, and claims nothing by itself.
//!
//! ```toml
//! [preprocessor.press]
//! licence = "Text and figures: CC BY 4.0"
//! licence-url = "LICENSE-CC-BY-4.0" # an address, or a file of the project, which goes into the site
//! ```

use mdbook_preprocessor::config::Config;
use std::path::Path;
use std::{fs, io};

/// The words at the foot of every page, on the title page of paper and in an EPUB.
const WORDS: &str = "preprocessor.press.licence";
/// Where its text stands.
const PLACE: &str = "preprocessor.press.licence-url";

/// A licence, in words and with the place of its text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Licence {
    pub(crate) words: String,
    place: Option<String>,
}

impl Licence {
    /// The licence that book.toml names.
    ///
    /// # Errors
    /// If a key holds no text, or a place stands there without words.
    pub(crate) fn read(config: &Config) -> Result<Option<Self>, String> {
        let text = |key| {
            let value = config.get::<String>(key);
            value.map_err(|error| format!("{key} of book.toml is a text ({error:#})"))
        };
        match (text(WORDS)?, text(PLACE)?) {
            (Some(words), place) => Ok(Some(Self { words, place })),
            (None, None) => Ok(None),
            (None, Some(_)) => {
                Err(format!("{PLACE} of book.toml is the place of a licence that {WORDS} does not name"))
            }
        }
    }

    /// Where a page of the site finds the text, if it lies `up` (`../`) below the root.
    pub(crate) fn address(&self, up: &str) -> Option<String> {
        let place = self.place.as_deref()?;
        Some(if is_remote(place) { place.to_owned() } else { format!("{up}{}", file(place)) })
    }

    /// Copies the text into the site, if it is a file of the project.
    pub(crate) fn add(&self, site: &Path, root: &Path) -> io::Result<()> {
        let Some(place) = self.place.as_deref().filter(|place| !is_remote(place)) else { return Ok(()) };
        let copied = fs::copy(root.join(place), site.join(file(place)));
        copied
            .map(drop)
            .map_err(|error| io::Error::other(format!("{PLACE} of book.toml names {place}: {error}")))
    }
}

fn is_remote(place: &str) -> bool {
    place.starts_with("https://") || place.starts_with("http://")
}

/// The name of the file in the site. A server tells a browser by its ending what it is, and one without is downloaded.
fn file(place: &str) -> String {
    let name = place.rsplit('/').next().unwrap_or(place);
    let is_told = [".txt", ".html", ".pdf"].iter().any(|ending| name.ends_with(ending));
    if is_told { name.to_owned() } else { format!("{name}.txt") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn licence(table: &str) -> Result<Option<Licence>, String> {
        Licence::read(&format!("[preprocessor.press]\n{table}").parse().unwrap())
    }

    #[test]
    fn the_licence_is_what_book_toml_says() {
        assert_eq!(licence(""), Ok(None));
        let address = |place: &str| {
            let table = format!("licence = \"L\"\nlicence-url = \"{place}\"");
            licence(&table).unwrap().unwrap().address("../").unwrap()
        };
        assert_eq!(address("LICENSE-CC-BY-4.0"), "../LICENSE-CC-BY-4.0.txt");
        assert_eq!(address("legal/terms.html"), "../terms.html");
        assert_eq!(address("https://example.org/l"), "https://example.org/l");
        assert_eq!(licence("licence = \"All rights reserved\"").unwrap().unwrap().address(""), None);
        assert!(
            licence("licence = 4")
                .unwrap_err()
                .starts_with("preprocessor.press.licence of book.toml is a text")
        );
        assert!(licence("licence-url = \"L\"").unwrap_err().contains("does not name"));
    }
}
