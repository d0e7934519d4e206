//! The mdBook renderer that runs after `html`: adds what mdBook does not know of, and checks the site.

use crate::assets::Rendered;
use crate::fault::{self, Faults, Lines};
use crate::mdbook::For;
use crate::print::code_links;
use crate::site::licence::Licence;
use crate::site::package::Package;
use crate::site::page_metadata::{self, SiteMetadata};
use crate::site::version_stamp::edition;
use crate::site::{
    exercises, links, look, not_found_page, publish, rustdoc, scripts, search, sidebar, solutions, theme,
    trails, wasm,
};
use anyhow::{Context as _, Error, Result, anyhow, ensure};
use html::{Edits, escaped};
use mdbook_renderer::RenderContext;
use std::collections::BTreeMap;
use std::io::Read;
use std::path::Path;
use std::{fs, io, thread};

/// The picture of the book that previews of links show: its file in the theme's folder, and in the site.
const PREVIEW: &str = "preview.png";
/// The page of all pages.
pub(crate) const PRINT: &str = "print.html";

/// Finishes and checks the site that mdBook has just rendered; `drawn` holds its figures.
///
/// # Errors
/// What is wrong with the site; there is none then.
pub(crate) fn run(input: impl Read, drawn: &Rendered) -> Result<()> {
    let mut context = RenderContext::from_json(input).context("this is no request of mdBook 0.5")?;
    let is_without_solutions = solutions::are_hidden(&context.config)?;
    let hidden = if is_without_solutions { solutions::leave_out(&mut context.book) } else { Vec::new() };
    let site = context.destination.with_file_name("html");
    ensure!(site.is_dir(), "there is no site beside {}", context.destination.display());
    let cannot = || format!("the site in {} cannot be finished", site.display());
    let unfinished = publish::put_aside(&site).with_context(cannot)?;
    match finished(&unfinished, &context, &hidden, drawn).with_context(cannot) {
        Ok(faults) if faults.is_empty() => fs::rename(&unfinished, &site).with_context(cannot),
        other => {
            let error = other.map_or_else(|error| error, Error::new);
            publish::fail(&site, &context.config, &fault::said(&error)).with_context(cannot)?;
            Err(error)
        }
    }
}

/// Finishes the site, in which nothing leads to pages that are `hidden`; what is wrong with it.
fn finished(site: &Path, context: &RenderContext, hidden: &[String], drawn: &Rendered) -> Result<Faults> {
    theme::remove_sources(site, &context.config)?;
    remove_programs(site)?;
    scripts::lighten(site, &context.config)?;
    drawn.write_all(&site.join("figures"))?;
    let package = Package::read(&context.root);
    let is_hasty = For::of(&context.config) == For::Hasty;
    if is_hasty {
        publish::remove(&site.join(PRINT))?;
    } else if let Some(package) = &package {
        rustdoc::add(site, &context.root, package)?;
    }
    let mut pages = complete_pages(site, context, package.as_ref(), hidden)?;
    look::gather(site, &context.config, &mut pages)?;
    scripts::keep_languages(site, &mut pages)?;
    wasm::add(site, &context.root, &pages)?;
    let index = search::rename(site, &mut pages)?;
    for (page, html) in &pages {
        fs::write(site.join(page), html)?;
    }
    // The words are collected while the links are checked.
    let mut found = thread::scope(|scope| {
        let index = index.as_ref().map(|file| scope.spawn(|| search::write(file, context, &pages)));
        let examined = links::examined(site, pages.keys().cloned())?;
        code_links::link_back(site, &examined.homes())?;
        let found = links::check(site, examined);
        let searched = index.map_or(Ok(()), |thread| {
            thread.join().unwrap_or_else(|_| Err(anyhow!("no index for the search can be made")))
        });
        searched.and(Ok(found?))
    })?;
    if is_hasty {
        let left_out = [format!("{}/", rustdoc::FOLDER), PRINT.to_owned()];
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
fn complete_pages(
    site: &Path,
    context: &RenderContext,
    package: Option<&Package>,
    hidden: &[String],
) -> Result<BTreeMap<String, String>> {
    let html = context.config.html_config().unwrap_or_default();
    let title = context.config.book.title.clone().unwrap_or_default();
    let picture =
        html.theme.as_ref().map(|theme| context.root.join(theme).join(PREVIEW)).filter(|file| file.is_file());
    if let Some(picture) = &picture {
        fs::copy(picture, site.join(PREVIEW))?;
    }
    let address = address(html.site_url.as_deref().unwrap_or("/"))?;
    let known = Some(&*address).filter(|address| address.starts_with("http"));
    let licence = Licence::read(&context.config)?;
    if let Some(licence) = &licence {
        licence.add(site, &context.root)?;
    }
    let metadata = SiteMetadata {
        book: &title,
        authors: &context.config.book.authors.join(", "),
        edition: &edition(&context.root, package),
        address: known,
        picture: picture.is_some().then_some(PREVIEW),
        licence: licence.as_ref(),
    };
    let doc = package.map(rustdoc::folder).unwrap_or_default();
    let trails = trails::trails(&context.book);
    let mut pages = BTreeMap::new();
    let copies = ["index.html", PRINT].map(str::to_owned);
    for page in copies.into_iter().chain(links::pages(context.book.iter())) {
        let file = site.join(&page);
        if file.is_file() {
            let mut html = page_metadata::with_metadata(&fs::read_to_string(file)?, &page, &metadata);
            html = rustdoc::with_links(&html, &page, &doc);
            html = trails::with_trail(&with_plain_pictures(&html), &page, &trails);
            if !hidden.is_empty() {
                html = solutions::unlinked(&html, &page, hidden);
            }
            pages.insert(page, html);
        }
    }
    let unfolded = |(page, html): (&String, &String)| {
        (
            page.clone(),
            look::with_kind(&sidebar::with_headings(&exercises::with_solutions(html, page, &pages))),
        )
    };
    pages = pages.iter().map(unfolded).collect();
    if let Some(address) = known {
        fs::write(site.join("sitemap.xml"), sitemap(address, pages.keys()))?;
    }
    let language = context.config.book.language.as_deref().unwrap_or("en");
    fs::write(site.join("404.html"), not_found_page::page(&title, language, &address, context.book.iter()))?;
    Ok(pages)
}

/// The page with each picture once: mdBook hangs a box without a name on it, and a copy that the box enlarges.
fn with_plain_pictures(html: &str) -> String {
    let found = html::named(html, &["label", "img"]);
    let mut edits = Edits::default();
    for label in found.iter().filter(|element| element.is("label", "checkbox-label")) {
        if let Some(picture) = found.iter().find(|element| element.name == "img" && label.holds(element)) {
            edits.replace(label.whole.clone(), &html[picture.whole.clone()]);
        }
    }
    edits.applied(html)
}

/// The figures and scenes of a chapter lie among its pages, so that mdBook has copied their programs and packages.
fn remove_programs(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() && path.join("Cargo.toml").is_file() {
            fs::remove_dir_all(path)?;
        } else if path.is_dir() {
            remove_programs(&path)?;
            if fs::read_dir(&path)?.next().is_none() {
                fs::remove_dir(path)?;
            }
        } else if path.extension().is_some_and(|ending| ending == "rs") || path.ends_with("Cargo.toml") {
            fs::remove_file(path)?;
        }
    }
    Ok(())
}

/// The address of the site, with a slash at its end.
fn address(site_url: &str) -> Result<String> {
    ensure!(
        ["https://", "http://", "/"].iter().any(|start| site_url.starts_with(start)),
        "output.html.site-url of book.toml is an address, https://example.org/notes/, or a path from the root of a server, \
         /notes/, and not `{site_url}`"
    );
    Ok(format!("{}/", site_url.trim_end_matches('/')))
}

/// The list of all pages for search engines. What is there twice is in it once.
fn sitemap<'a>(address: &str, pages: impl Iterator<Item = &'a String>) -> String {
    let own = pages.filter(|page| !matches!(page.as_str(), "index.html" | PRINT));
    let lines = own.map(|page| format!("<url><loc>{}</loc></url>\n", escaped(&format!("{address}{page}"))));
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<urlset xmlns=\"http://www.sitemaps.org/schemas/sitemap/0.9\">\n{}</urlset>\n",
        lines.collect::<String>()
    )
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_address_of_a_site_ends_with_a_slash() {
        for (given, whole) in [
            ("https://example.org/notes", "https://example.org/notes/"),
            ("https://example.org/notes/", "https://example.org/notes/"),
            ("/", "/"),
            ("/notes", "/notes/"),
        ] {
            assert_eq!(address(given).unwrap(), whole);
        }
        assert!(
            address("javascript:alert(1)").unwrap_err().to_string().contains("and not `javascript:alert(1)`")
        );
    }

    #[test]
    fn a_search_engine_hears_of_each_page_once() {
        let pages = ["a/index.html", "b.html", "index.html", PRINT].map(str::to_owned);
        let list = sitemap("https://example.org/a&b/", pages.iter());
        assert!(list.contains("<loc>https://example.org/a&amp;b/a/index.html</loc>"), "{list}");
        assert_eq!(list.matches("<loc>").count(), 2);
    }
}
