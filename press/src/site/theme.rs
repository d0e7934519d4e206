//! The look of the pages: the theme of the press, which it puts where book.toml has mdBook look for it.

use crate::book::files;
use crate::mdbook;
use anyhow::Result;
use mdbook_driver::config::Config;
use std::collections::BTreeSet;
use std::path::Path;
use std::{fs, io};

/// Where the theme goes, relative to the project's root. book.toml names it.
pub(crate) const FOLDER: &str = "target/press/theme";
/// The setting that names the files which are the book's own, and take the place of those of the theme.
const OWN: &str = "preprocessor.press.theme";

macro_rules! included {
    ($($name:literal),* $(,)?) => {
        [$(($name, include_bytes!(concat!("../../theme/", $name)) as &[u8])),*]
    };
}

/// All files of the theme.
const FILES: [(&str, &[u8]); 22] = included![
    "figures.css",
    "fonts/LICENCES.txt",
    "fonts/book-code.woff2",
    "fonts/book-math.woff2",
    "fonts/fonts.css",
    "fonts/libertinus-serif-italic.woff2",
    "fonts/libertinus-serif-regular.woff2",
    "fonts/libertinus-serif-semibold.woff2",
    "fonts/open-sans-italic.woff2",
    "fonts/open-sans-regular.woff2",
    "fonts/open-sans-semibold.woff2",
    "head.hbs",
    "index.hbs",
    "live.css",
    "maths.css",
    "numbers.css",
    "numbers.js",
    "page.css",
    "print.css",
    "scenes.js",
    "slides.css",
    "slides.js",
];

/// Writes the theme, with the book's own files over it, where it differs from what is there.
pub(crate) fn install(root: &Path) -> Result<()> {
    let settings = mdbook::settings(root)?;
    let folder = root.join(FOLDER);
    let mut kept = BTreeSet::new();
    let mut put = |name: &str, content: &[u8]| {
        let file = folder.join(name);
        kept.insert(file.clone());
        if fs::read(&file).is_ok_and(|known| known == content) {
            return Ok(());
        }
        fs::create_dir_all(file.parent().unwrap_or(&folder))?;
        fs::write(file, content)
    };
    let own = own(&settings).map(|own| root.join(own));
    for (name, content) in FILES {
        if !own.as_ref().is_some_and(|own| own.join(name).is_file()) {
            put(name, content)?;
        }
    }
    if let Some(own) = own {
        for name in files(&own)? {
            put(&name, &fs::read(own.join(&name))?)?;
        }
    }
    for name in files(&folder)? {
        if !kept.contains(&folder.join(&name)) {
            fs::remove_file(folder.join(name))?; // it was the book's own
        }
    }
    Ok(())
}

/// The book's own files may lie among the pages, so that mdBook has copied them once more.
pub(crate) fn remove_sources(site: &Path, config: &Config) -> io::Result<()> {
    let own = own(config);
    let copied = own.as_ref().and_then(|own| Path::new(own).strip_prefix(&config.book.src).ok());
    match copied.map(|below| fs::remove_dir_all(site.join(below))) {
        Some(Err(error)) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

fn own(config: &Config) -> Option<String> {
    config.get(OWN).ok().flatten()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_files_of_the_theme_come_with_the_press() {
        let known: BTreeSet<&str> = FILES.into_iter().map(|(name, _)| name).collect();
        let found = files(Path::new("theme")).unwrap();
        assert_eq!(known, found.iter().map(String::as_str).collect());
    }

    #[test]
    fn a_book_has_its_own_files_over_the_theme() {
        let root = std::env::temp_dir().join(format!("press-theme-{}", std::process::id()));
        let _ = fs::remove_dir_all(&root);
        fs::create_dir_all(root.join("look")).unwrap();
        fs::write(root.join("look/page.css"), "own").unwrap();
        fs::write(root.join("look/favicon.svg"), "<svg/>").unwrap();
        fs::write(root.join("book.toml"), "[book]\n[preprocessor.press]\ntheme = \"look\"\n").unwrap();
        install(&root).unwrap();
        let is = |name: &str| fs::read_to_string(root.join(FOLDER).join(name)).ok();
        assert_eq!((is("page.css").as_deref(), is("favicon.svg").as_deref()), (Some("own"), Some("<svg/>")));
        assert!(is("head.hbs").is_some_and(|text| !text.is_empty()));
        fs::write(root.join("book.toml"), "[book]\n").unwrap();
        install(&root).unwrap();
        assert_eq!(is("favicon.svg"), None);
        assert!(is("page.css").is_some_and(|text| text.len() > 1000));
        fs::remove_dir_all(root).unwrap();
    }
}
