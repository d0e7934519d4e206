//! mdBook as a library: what `mdbook build` and `mdbook test` do, for those who have not installed it. It reads
//! book.toml and calls the press as the program does, so that both print the same site.

use anyhow::{Context as _, Result, ensure};
use mdbook_driver::MDBook;
use mdbook_driver::config::Config;
use std::env;
use std::fmt::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::Once;
use tracing::field::{Field, Visit};
use tracing::level_filters::LevelFilter;
use tracing::span::{Attributes, Id, Record};
use tracing::{Event, Level, Metadata, Subscriber};

/// For whom a site is built.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum For {
    /// Whoever publishes it: all of it.
    Readers,
    /// Whoever looks at it while it is written: a fault is shown in its place.
    Author,
    /// The same, who wants to see it at once: without what takes long to make anew. The rest follows.
    Hasty,
    /// Whoever prints it: with stills of the scenes.
    Paper,
}

/// Where the press finds it in the settings that mdBook hands on.
const SETTING: &str = "preprocessor.press.for";
/// What mdBook runs to have the pages printed.
const COMMAND: &str = "preprocessor.press.command";

impl For {
    /// Its name in the settings that mdBook hands on.
    fn name(self) -> String {
        format!("{self:?}").to_lowercase()
    }

    /// For whom mdBook builds with these settings.
    pub(crate) fn of(config: &Config) -> Self {
        let named: Option<String> = config.get(SETTING).ok().flatten();
        let all = [Self::Author, Self::Hasty, Self::Paper];
        let found = all.into_iter().find(|one| named.as_ref() == Some(&one.name()));
        found.unwrap_or(if is_followed_by_mdbook(config) { Self::Author } else { Self::Readers })
    }
}

/// Whether `mdbook serve` follows edits of the book.
pub(crate) fn is_followed_by_mdbook(config: &Config) -> bool {
    config.contains_key("output.html.live-reload-endpoint")
}

/// This program, which is current since Cargo has just run it, as a command for mdBook.
pub(crate) fn this_program() -> Option<String> {
    Some(format!("\"{}\"", env::current_exe().ok()?.to_str()?))
}

/// Builds the site in `root`, in the folder `html` below `destination`, by a `press` that is known to be current, in
/// place of that which book.toml has Cargo look after.
pub(crate) fn build(press: Option<&str>, root: &Path, destination: &Path, for_whom: For) -> Result<()> {
    let built = settings(root).and_then(|mut settings| {
        settings.build.build_dir = root.join(destination);
        if let Some(press) = press {
            settings.set(COMMAND, press)?;
        }
        settings.set(SETTING, for_whom.name())?;
        if matches!(for_whom, For::Author | For::Hasty) {
            settings.set("output.html.site-url", "/")?; // for the page that is shown in place of a missing one
        }
        MDBook::load_with_config(root, settings)?.build()
    });
    built.context("the book was not built")
}

/// The files and folders that a change in asks for a new site: those that `mdbook serve` watches, and Cargo's.
pub(crate) fn made_of(root: &Path) -> Result<Vec<PathBuf>> {
    let settings = settings(root)?;
    let mut parts = vec![settings.book.src];
    parts.extend(settings.build.extra_watch_dirs);
    parts.extend(["book.toml", "Cargo.toml", "Cargo.lock"].map(PathBuf::from));
    Ok(parts.into_iter().map(|part| root.join(part)).collect())
}

/// Where the site goes, in a folder `html`: below `asked`, or below the folder that book.toml names.
pub(crate) fn destination(root: &Path, asked: Option<&str>) -> Result<PathBuf> {
    let settings = settings(root)?;
    let named = asked.map_or(settings.build.build_dir, PathBuf::from);
    let (folder, pages) = (root.join(&named), root.join(settings.book.src));
    let is_among_pages = folder.components().collect::<PathBuf>().starts_with(&pages);
    ensure!(!is_among_pages, "the site cannot go into {}, because the pages lie there", named.display());
    Ok(folder)
}

/// Tests the snippets of all pages.
pub(crate) fn test(root: &Path) -> Result<()> {
    let tested = settings(root).and_then(|mut settings| {
        if let Some(press) = this_program() {
            settings.set(COMMAND, press)?;
        }
        MDBook::load_with_config(root, settings)?.test(Vec::new())
    });
    tested.context("the test of the book failed")
}

/// What book.toml and the environment say.
pub(crate) fn settings(root: &Path) -> Result<Config> {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let _ = tracing::subscriber::set_global_default(Warnings);
    });
    let mut settings = Config::from_disk(root.join("book.toml"))?;
    settings.update_from_env()?;
    Ok(settings)
}

/// Prints what mdBook warns of.
struct Warnings;

impl Subscriber for Warnings {
    fn enabled(&self, metadata: &Metadata<'_>) -> bool {
        *metadata.level() <= Level::WARN
    }

    fn max_level_hint(&self) -> Option<LevelFilter> {
        Some(LevelFilter::WARN)
    }

    fn event(&self, event: &Event<'_>) {
        let mut message = Message(String::new());
        event.record(&mut message);
        let level = if *event.metadata().level() == Level::ERROR { "error" } else { "warning" };
        eprintln!("{level}: {}", message.0);
    }

    fn new_span(&self, _: &Attributes<'_>) -> Id {
        Id::from_u64(1)
    }

    fn record(&self, _: &Id, _: &Record<'_>) {}
    fn record_follows_from(&self, _: &Id, _: &Id) {}
    fn enter(&self, _: &Id) {}
    fn exit(&self, _: &Id) {}
}

struct Message(String);

impl Visit for Message {
    fn record_debug(&mut self, field: &Field, value: &dyn fmt::Debug) {
        if field.name() == "message" {
            let _ = write!(self.0, "{value:?}");
        }
    }
}
