//! What a build leaves behind: the folder `html` holds a whole site or does not exist, whatever ends the build, so that
//! a script which does not look at the exit code has nothing to publish. The site of before goes first, and the new one
//! comes at once. Two things are not in our hands. What does not compile never runs, and leaves the whole site
//! of before. And plain `mdbook build` renders in that very folder.

use crate::mdbook::For;
use html::escaped;
use mdbook_preprocessor::config::Config;
use std::path::{Path, PathBuf};
use std::{fs, io};

/// Puts aside the site that mdBook has just rendered, until it is finished; where it is now.
pub(crate) fn put_aside(site: &Path) -> io::Result<PathBuf> {
    let unfinished = site.with_file_name("html-unfinished");
    remove(&unfinished)?;
    fs::rename(site, &unfinished)?;
    Ok(unfinished)
}

/// Takes a site away at once, then removes it.
pub(crate) fn withdraw(site: &Path) -> io::Result<()> {
    let old = site.with_file_name("html-old");
    remove(&old)?;
    if site.exists() {
        fs::rename(site, &old)?;
    }
    remove(&old)
}

/// Takes the site away after a build that failed. Who looks at it while it is served sees the reason
/// instead, at every address, until the next build.
pub(crate) fn fail(site: &Path, config: &Config, reason: &str) -> io::Result<()> {
    remove(&site.with_file_name("html-unfinished"))?;
    withdraw(site)?;
    match For::of(config) {
        For::Author | For::Hasty => say(site, reason),
        For::Readers | For::Paper => Ok(()),
    }
}

/// Puts the reason into a folder, in the place of a site.
pub(crate) fn say(site: &Path, reason: &str) -> io::Result<()> {
    fs::create_dir_all(site)?;
    ["index.html", "404.html"].iter().try_for_each(|name| fs::write(site.join(name), page(reason)))
}

/// Removes a file, or a folder with all that is in it; what does not exist is nothing to remove.
pub(crate) fn remove(path: &Path) -> io::Result<()> {
    let removed = if path.is_dir() { fs::remove_dir_all(path) } else { fs::remove_file(path) };
    match removed {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

/// A page that says why there is no book, and asks every two seconds whether there is one now.
fn page(reason: &str) -> String {
    let reason = escaped(reason);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en-GB\">\n<meta charset=\"utf-8\">\n<meta http-equiv=\"refresh\" content=\"2\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>The book was not built</title>\n\
         <h1>The book was not built</h1>\n<pre style=\"white-space: pre-wrap\">\n{reason}\n</pre>\n</html>\n"
    )
}
