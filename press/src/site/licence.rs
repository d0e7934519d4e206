//! What one may do with the book. It says what book.toml says, and claims nothing by itself.
//!
//! ```toml
//! [preprocessor.press]
//! licence = "Text and figures: CC BY 4.0"
//! licence-url = "LICENSE-CC-BY-4.0" # an address, or a file of the project, which goes into the site
//! ```

use anyhow::{Context as _, Result, bail};
use mdbook_preprocessor::config::Config;
use std::fs;
use std::path::Path;

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
    pub(crate) fn read(config: &Config) -> Result<Option<Self>> {
        let text =
            |key: &str| config.get::<String>(key).with_context(|| format!("{key} of book.toml is a text"));
        match (text(WORDS)?, text(PLACE)?) {
            (Some(words), place) => Ok(Some(Self { words, place })),
            (None, None) => Ok(None),
            (None, Some(_)) => {
                bail!("{PLACE} of book.toml is the place of a licence that {WORDS} does not name")
            }
        }
    }

    /// Where a page of the site finds the text, if it lies `up` (`../`) below the root.
    pub(crate) fn address(&self, up: &str) -> Option<String> {
        let place = self.place.as_deref()?;
        Some(if is_remote(place) { place.to_owned() } else { format!("{up}{}", file(place)) })
    }

    /// Copies the text into the site, if it is a file of the project.
    pub(crate) fn add(&self, site: &Path, root: &Path) -> Result<()> {
        let Some(place) = self.place.as_deref().filter(|place| !is_remote(place)) else { return Ok(()) };
        let copied = fs::copy(root.join(place), site.join(file(place)));
        copied.map(drop).with_context(|| format!("{PLACE} of book.toml names {place}"))
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
