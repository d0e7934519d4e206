//! The mdBook renderer that runs after `html`: adds what mdBook does not know of, and checks the site.

use crate::edition::edition;
use crate::fault::{Faults, Lines};
use crate::head::{self, Said};
use crate::mdbook::For;
use crate::preprocess::Failed;
use crate::rendered::Rendered;
use crate::{api, lost, module, outcome, places, search, site, solutions};
use mdbook_renderer::RenderContext;
use mdbook_renderer::config::Config;
use std::collections::BTreeMap;
use std::io::Read;
use std::path::Path;
use std::{fs, io, thread};

/// Files of the project that belong into the site.
const LICENCES: [&str; 1] = ["LICENSE-CC-BY-4.0"];
/// The picture of the book that previews of links show: its file in the theme's folder, and in the site.
const PREVIEW: &str = "preview.png";
/// The page of all pages.
pub(crate) const PRINT: &str = "print.html";

/// Finishes and checks the site that mdBook has just rendered; `drawn` holds its figures.
///
/// # Errors
/// [`Failed`], for the caller to report; there is no site then.
pub fn run(input: impl Read, drawn: &Rendered) -> Result<(), Failed> {
    let mut context = RenderContext::from_json(input)
        .map_err(|error| Failed::Other(format!("this is not a request of mdBook 0.5: {error:#}")))?;
    if solutions::are_hidden(&context.config).map_err(Failed::Other)? {
        solutions::leave_out(&mut context.book);
    }
    let site =
        context.destination.parent().map(|folder| folder.join("html")).filter(|folder| folder.is_dir());
    let Some(site) = site else {
        return Err(Failed::Other(format!("there is no site beside {}", context.destination.display())));
    };
    let cannot = |error: io::Error| {
        Failed::Other(format!("the site in {} cannot be finished: {error}", site.display()))
    };
    let unfinished = outcome::put_aside(&site).map_err(cannot)?;
    match finished(&unfinished, &context, drawn) {
        Ok(faults) if faults.is_empty() => outcome::bring_back(&unfinished, &site).map_err(cannot),
        other => {
            let failed = other.map_or_else(cannot, Failed::Faults);
            outcome::fail(&site, &context.config, &failed).map_err(cannot)?;
            Err(failed)
        }
    }
}

/// Finishes the site; what is wrong with it.
fn finished(site: &Path, context: &RenderContext, drawn: &Rendered) -> io::Result<Faults> {
    remove_sources_of_theme(site, &context.config)?;
    remove_programs(site)?;
    add(site, &context.root, drawn)?;
    let is_hasty = For::of(&context.config) == For::Hasty;
    if is_hasty {
        outcome::remove(&site.join(PRINT))?;
    } else {
        api::add(site, &context.root)?;
    }
    let mut pages = complete_pages(site, context)?;
    module::add(site, &context.root, &pages)?;
    let index = search::rename(site, &mut pages)?;
    for (page, html) in &pages {
        fs::write(site.join(page), html)?;
    }
    // The words are collected while the links are checked.
    let mut found = thread::scope(|scope| {
        let index = index.as_ref().map(|file| scope.spawn(|| search::write(file, context, &pages)));
        let examined = site::examined(site, pages.keys().cloned())?;
        places::link_back(site, &examined.homes())?;
        let found = site::check(site, examined);
        let searched = index.map_or(Ok(()), |thread| {
            thread.join().unwrap_or_else(|_| Err(io::Error::other("no index for the search can be made")))
        });
        searched.and(found)
    })?;
    if is_hasty {
        let left_out = [format!("{}/", api::FOLDER), PRINT.to_owned()];
        found.retain(|fault| !left_out.iter().any(|name| fault.clue.contains(name)));
    }
    let source = context.config.book.src.to_string_lossy().replace('\\', "/");
    let mut faults = Faults::default();
    for fault in found {
        let (file, line) = locate(&context.root, &source, &fault.page, &fault.clue);
        faults.add(&file, line, fault.message);
    }
    Ok(faults)
}

/// The pages of the book, by their paths in the site, each of which says now what it is, where it is and of which
/// edition. Helps those who ask for one that is not there.
fn complete_pages(site: &Path, context: &RenderContext) -> io::Result<BTreeMap<String, String>> {
    let html = context.config.html_config().unwrap_or_default();
    let title = context.config.book.title.clone().unwrap_or_default();
    let picture =
        html.theme.as_ref().map(|theme| context.root.join(theme).join(PREVIEW)).filter(|file| file.is_file());
    if let Some(picture) = &picture {
        fs::copy(picture, site.join(PREVIEW))?;
    }
    let address = html.site_url.as_deref().unwrap_or("/");
    let said = Said {
        book: &title,
        edition: &edition(&context.root),
        address: Some(address).filter(|address| address.starts_with("http")),
        picture: picture.is_some().then_some(PREVIEW),
    };
    let mut pages = BTreeMap::new();
    let copies = ["index.html", PRINT].map(str::to_owned);
    for page in copies.into_iter().chain(site::pages(context.book.iter())) {
        let file = site.join(&page);
        if file.is_file() {
            let html = head::completed(&fs::read_to_string(file)?, &page, &said);
            pages.insert(page, html);
        }
    }
    let language = context.config.book.language.as_deref().unwrap_or("en");
    fs::write(site.join("404.html"), lost::page(&title, language, address, context.book.iter()))?;
    Ok(pages)
}

/// The theme lies among the pages, so that mdBook has copied it once more, as it is before it goes into the site.
fn remove_sources_of_theme(site: &Path, config: &Config) -> io::Result<()> {
    let theme = config.html_config().and_then(|html| html.theme);
    let copied = theme.as_ref().and_then(|theme| theme.strip_prefix(&config.book.src).ok());
    match copied.map(|below| fs::remove_dir_all(site.join(below))) {
        Some(Err(error)) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

/// The figures and scenes of a chapter lie among its pages, so that mdBook has copied their programs.
fn remove_programs(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            remove_programs(&path)?;
            if fs::read_dir(&path)?.next().is_none() {
                fs::remove_dir(path)?;
            }
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            fs::remove_file(path)?;
        }
    }
    Ok(())
}

/// Adds figures and licences.
fn add(site_folder: &Path, root: &Path, drawn: &Rendered) -> io::Result<()> {
    drawn.write_all(&site_folder.join("figures"))?;
    for licence in LICENCES.iter().filter(|licence| root.join(licence).is_file()) {
        fs::copy(root.join(licence), site_folder.join(licence))?;
    }
    Ok(())
}

/// The Markdown file and the line that a fault of a built page comes from, as far as they can be told.
fn locate(root: &Path, source: &str, page: &str, clue: &str) -> (String, usize) {
    let markdown = format!("{source}/{}", page.replace(".html", ".md"));
    match fs::read_to_string(root.join(&markdown)) {
        Ok(text) if !clue.is_empty() => {
            let written = clue.replace(".html", ".md");
            let at = text.find(clue).or_else(|| text.find(&written));
            (markdown, at.map_or(0, |at| Lines::of(&text).at(at)))
        }
        Ok(_) => (markdown, 0),
        Err(_) => (page.to_owned(), 0),
    }
}
