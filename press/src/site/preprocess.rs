//! The mdBook preprocessor.

use crate::assets::Rendered;
use crate::book::from_mdbook;
use crate::mdbook::{self, For};
use crate::read::snippets;
use crate::site::package::{Package, cargo};
use crate::site::wasm::{Module, Modules};
use crate::site::{check, publish, solutions, theme};
use crate::{Book as OfBook, fault};
use anyhow::{Context as _, Result, bail};
use mdbook_preprocessor::PreprocessorContext;
use mdbook_preprocessor::book::{Book, BookItem};
use std::io::{self, BufWriter, Read, Write};
use std::path::Path;
use std::process::Stdio;
use std::{env, fs};

/// Where the finished press waits for mdBook to call it as a renderer, relative to the project's root: a
/// place that does not depend on Cargo's settings. book.toml names it.
pub(crate) const FINISHER: &str = "target/press/book";

/// Reads mdBook's request from `input` and writes the answer to `output`; the pages show what is `drawn`.
///
/// For the renderer `html` every page is rendered; for `test` the snippets of all pages are tested and the fences
/// relabelled, so that mdBook's own test run finds nothing more to do.
///
/// # Errors
/// The faults of the pages, or why else there is no book.
pub(crate) fn run(input: impl Read, output: impl Write, drawn: Rendered) -> Result<()> {
    let (context, mut book) = mdbook_preprocessor::parse_input(input)
        .context("this is no request of mdBook 0.5; `cargo book help` lists what else the press can do")?;
    let answer = answer(&context, &mut book, drawn);
    if let Err(error) = &answer
        && context.renderer == "html"
    {
        let site = context.root.join(&context.config.build.build_dir).join("html");
        let said = fault::said(error);
        publish::fail(&site, &context.config, &said)
            .with_context(|| format!("{said}\n{} cannot be taken away", site.display()))?;
    }
    answer?;
    let mut output = BufWriter::new(output);
    let written = serde_json::to_writer(&mut output, &book).map_err(io::Error::from);
    written.and_then(|()| output.flush()).context("mdBook does not take the answer")
}

/// Puts what mdBook is to print, or to test, in the place of the pages.
fn answer(context: &PreprocessorContext, book: &mut Book, mut drawn: Rendered) -> Result<()> {
    theme::install(&context.root).context("the theme cannot be put in its place")?;
    let source = context.config.book.src.to_string_lossy().replace('\\', "/");
    let pages = from_mdbook(book, &source);
    let is_test = context.renderer == "test";
    let without_solutions = !is_test && solutions::are_hidden(&context.config)?;
    let for_whom = For::of(&context.config);
    let compiled = Modules::of(&context.root, &drawn.book, &pages);
    let modules = if is_test { Module::Stale } else { compiled.made(for_whom, 0)? };
    drawn.is_still = matches!((&modules, for_whom), (Module::Missing(_), _) | (Module::Stale, For::Hasty));
    // What is wrong with the pages is said before anything is compiled.
    let mut texts = check::rendered(&pages, &context.root, &source, &drawn)?;
    if is_test {
        test_snippets(&context.root, &drawn.book)?;
        texts = pages.iter().map(|page| snippets::relabelled(&page.text)).collect();
    } else {
        // Before what may take minutes, in which Cargo may put another program in the place of this one.
        install_finisher(&context.root).with_context(|| format!("the press cannot be put at {FINISHER}"))?;
        match modules {
            // `cargo book serve` says it by itself, and once.
            Module::Missing(Some(why))
                if for_whom == For::Readers || mdbook::is_followed_by_mdbook(&context.config) =>
            {
                eprintln!("{why}");
            }
            Module::Stale if !drawn.is_still => {
                compiled.made(for_whom, usize::MAX)?;
            }
            _ => {}
        }
    }
    let title = context.config.book.title.clone().unwrap_or_default();
    replace(&mut book.items, &title, &mut texts.into_iter());
    if without_solutions {
        solutions::leave_out(book);
    }
    Ok(())
}

fn replace(items: &mut [BookItem], book: &str, texts: &mut impl Iterator<Item = String>) {
    for item in items {
        let BookItem::Chapter(chapter) = item else { continue };
        if chapter.source_path.is_some()
            && let Some(text) = texts.next()
        {
            // `Exercises` alone would be the name of many windows and search results.
            let title = chapter
                .parent_names
                .last()
                .map(|parent| format!("{{{{#title {} - {parent} - {book}}}}}", chapter.name));
            chapter.content = title.unwrap_or_default() + &text;
        }
        replace(&mut chapter.sub_items, book, texts);
    }
}

/// Runs the snippets of all pages and those of the library, as documentation tests.
fn test_snippets(root: &Path, book: &OfBook) -> Result<()> {
    eprintln!("Testing the snippets of all pages with `cargo test --doc`");
    let library = Package::of_library(root, book.library)
        .with_context(|| format!("no package of the project has a library called `{}`", book.library))?;
    let run = cargo(root)
        .args(["test", "--doc", "--package", &library.name, "--package", book.snippets])
        .stderr(Stdio::inherit())
        .output()
        .context("cargo cannot be run")?;
    // Standard output belongs to mdBook's protocol.
    let report = String::from_utf8_lossy(&run.stdout);
    if run.status.success() {
        for line in report.lines().filter(|line| line.starts_with("test result")) {
            eprintln!("{line}");
        }
        Ok(())
    } else {
        report.lines().for_each(|line| eprintln!("{}", named_by_its_page(line)));
        bail!("snippets fail: see above for page, line and value of each")
    }
}

/// The name of a snippet, without the folder of the copy that is tested. (The compiler's own words keep it: it counts
/// lines that rustdoc has put above.)
fn named_by_its_page(line: &str) -> String {
    match line.split_once("/out/") {
        Some((before, page)) if !before.contains("-->") => {
            let folder = before.rfind(' ').map_or(0, |blank| blank + 1);
            format!("{}{page}", &before[..folder])
        }
        _ => line.to_owned(),
    }
}

/// Puts this program where book.toml expects the renderer.
fn install_finisher(root: &Path) -> std::io::Result<()> {
    let program = env::current_exe()?;
    let place = root.join(FINISHER).with_extension(env::consts::EXE_EXTENSION);
    let stamp = |path: &Path| fs::metadata(path).and_then(|data| Ok((data.len(), data.modified()?))).ok();
    if place == program || (stamp(&program).is_some() && stamp(&place) == stamp(&program)) {
        return Ok(());
    }
    if let Some(folder) = place.parent() {
        fs::create_dir_all(folder)?;
    }
    let fresh = place.with_extension("new");
    let _ = fs::remove_file(&fresh);
    if fs::hard_link(&program, &fresh).is_err() {
        fs::copy(&program, &fresh)?;
    }
    fs::rename(fresh, place) // at once, for an mdBook that may be running the old one
}

#[cfg(test)]
mod tests {
    use super::named_by_its_page;

    #[test]
    fn a_snippet_is_named_by_its_page() {
        let said = "---- /a/build/snippets-1/out/book/b/index.md - page_1_b (line 18) stdout ----";
        assert_eq!(named_by_its_page(said), "---- book/b/index.md - page_1_b (line 18) stdout ----");
        for said in ["  --> /a/out/book/b.md:3:5", "test result: FAILED."] {
            assert_eq!(named_by_its_page(said), said);
        }
    }
}
