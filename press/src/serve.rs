//! `cargo book serve`: the site for the browser of who writes it, made anew when something changes.
//!
//! A page is sent as it lies in the folder, with a line of script that loads it again after the next build. What is
//! being made at the moment is waited for.

mod http;
mod watch;

use crate::mdbook::{self, For};
use crate::read::disk::from_disk;
use crate::site::preprocess::FINISHER;
use crate::site::wasm::{Module, Modules};
use crate::site::{postprocess, publish, rustdoc};
use crate::{Book, fault};
use anyhow::{Context as _, Result, bail};
use http::Site;
use std::net::{TcpListener, ToSocketAddrs};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::{Arc, Once};
use std::thread::JoinHandle;
use std::{fs, io, thread};
use watch::{PAUSE, Watcher};

/// Where and how the book is served, as one asks for it of mdBook.
#[derive(Debug, clap::Args)]
pub(crate) struct Options {
    /// The name or address that it is served at
    #[arg(short = 'n', long, default_value = "localhost")]
    hostname: String,
    #[arg(short, long, default_value_t = 3000)]
    port: u16,
    /// The folder in which the site is made
    #[arg(short, long, value_name = "FOLDER")]
    dest_dir: Option<String>,
    /// Opens it in the browser
    #[arg(short, long)]
    open: bool,
}

/// Serves the book in `root` until it is stopped.
///
/// # Errors
/// If it cannot begin: what is asked for is nonsense, or the port is taken.
pub(crate) fn run(root: &Path, options: &Options, book: &Book) -> Result<()> {
    // Before anything is built, which takes a while.
    let listeners = listeners(options)?;
    let made = Made { root, book, folder: mdbook::destination(root, options.dest_dir.as_deref())? };
    let site = Arc::new(Site::new(vec![made.folder.join("html"), made.folder.join("kept")]));
    for listener in listeners {
        let site = Arc::clone(&site);
        thread::spawn(move || http::answer(&listener, &site));
    }
    let address = format!("http://{}:{}", options.hostname, options.port);
    eprintln!("Printing the pages");
    let mut watcher = Watcher::new(mdbook::made_of(root)?);
    let mut is_first = true;
    let mut is_kept = false;
    let mut press = mdbook::this_program(); // Cargo has just compiled it
    let mut compiler = None;
    loop {
        // The pages at once, without what takes long to make and does not change with a sentence.
        let is_shown = site.while_built(|| report(made.build(press.as_deref(), For::Hasty)));
        if is_first {
            eprintln!("The book is at {address}; it follows your edits until you press Ctrl+C");
            if options.open {
                open(&address);
            }
            is_first = false;
        }
        if is_shown && !(is_kept && made.is_current()) {
            is_kept = has_built_rest(&made, press.as_deref(), &site, &watcher, &mut compiler);
        }
        let changed = watcher.wait();
        let first = changed.iter().map(|file| file.strip_prefix(root).unwrap_or(file).display()).next();
        let first = first.map(|file| file.to_string()).unwrap_or_default();
        let more = if changed.len() > 1 { format!(" and {} more", changed.len() - 1) } else { String::new() };
        eprintln!("Changed: {first}{more}");
        if changed.iter().any(|file| !is_text(file)) {
            eprintln!(
                "Whether tests, and numbers on the pages, still hold is not looked at here: `cargo test` says"
            );
        }
        press = (is_shown && changed.iter().all(|file| is_text(file))).then(|| FINISHER.to_owned());
    }
}

/// Who compiles a module.
type Compiler = JoinHandle<Result<Module>>;

/// Builds what a hasty build has left out; whether it is there. An edit waits for no module: one is compiled to its end
/// by `compiler`, meanwhile. What the pages show already needs no second look before the rest is there.
fn has_built_rest(
    made: &Made<'_>,
    press: Option<&str>,
    site: &Site,
    watcher: &Watcher,
    compiler: &mut Option<Compiler>,
) -> bool {
    let start = || {
        let modules = made.modules();
        thread::spawn(move || {
            let built = modules.made(For::Author, 1);
            if let Ok(Module::Missing(Some(why))) = &built {
                static SAID: Once = Once::new();
                SAID.call_once(|| eprintln!("{why}"));
            }
            built
        })
    };
    loop {
        while !compiler.get_or_insert_with(start).is_finished() {
            if watcher.has_changed() {
                return false;
            }
            thread::sleep(PAUSE);
        }
        let is_compiled = matches!(compiler.take().map(JoinHandle::join), Some(Ok(Ok(_))));
        let has_more = || matches!(made.modules().made(For::Author, 0), Ok(Module::Stale));
        if !is_compiled || !has_more() {
            break;
        }
    }
    let is_there = !watcher.has_changed() && site.while_built(|| report(made.build(press, For::Author)));
    if is_there {
        eprintln!("Everything is there, the documentation of the library too");
    }
    is_there
}

/// Whether no program is made of a file.
fn is_text(file: &Path) -> bool {
    file.extension().is_some_and(|ending| ["md", "css", "hbs", "js"].iter().any(|text| ending == *text))
}

/// What the compiler prints does not pass through here.
const ELSEWHERE: &str = "If the library, a figure or a scene does not compile, the compiler says why where `cargo book serve` runs.";

/// Where the site lies: in `html`, and in `kept` what hasty builds leave out. It is made beside them, so that nobody
/// sees half a page.
struct Made<'a> {
    root: &'a Path,
    book: &'a Book,
    folder: PathBuf,
}

impl Made<'_> {
    /// The modules of the pages as they are now; of pages with faults there are none.
    fn modules(&self) -> Modules {
        let pages = from_disk(self.root).map(|(_, pages)| pages).unwrap_or_default();
        Modules::of(self.root, self.book, &pages)
    }

    /// Whether what a hasty build leaves out would be made as it is.
    fn is_current(&self) -> bool {
        rustdoc::is_current(self.root) && !matches!(self.modules().made(For::Author, 0), Ok(Module::Stale))
    }

    fn build(&self, press: Option<&str>, for_whom: For) -> Result<()> {
        let built = mdbook::build(press, self.root, &self.folder.join("next"), for_whom);
        let [html, next, old] = ["html", "next/html", "old"].map(|name| self.folder.join(name));
        let kept = self.folder.join("kept");
        let put = || {
            if let Err(error) = &built
                && !next.is_dir()
            {
                // The press itself did not come so far, or it would have said why.
                publish::say(&next, &format!("{}\n\n{ELSEWHERE}", fault::said(error)))?;
            }
            if for_whom == For::Author && built.is_ok() {
                publish::remove(&kept)?;
                fs::create_dir_all(&kept)?;
                for name in
                    [rustdoc::FOLDER, postprocess::PRINT].into_iter().filter(|name| next.join(name).exists())
                {
                    fs::rename(next.join(name), kept.join(name))?;
                }
            }
            if next.is_dir() {
                publish::remove(&old)?;
                if html.is_dir() {
                    fs::rename(&html, &old)?;
                }
                fs::rename(&next, &html)?; // also where it says why there is no book
            }
            publish::remove(&old)
        };
        let is_put: io::Result<()> = put();
        built.and(is_put.with_context(|| format!("nothing can be put into {}", html.display())))
    }
}

fn report(outcome: Result<()>) -> bool {
    outcome.map_err(|error| eprintln!("{}", fault::said(&error))).is_ok()
}

/// Where it is listened: `localhost` may be two addresses.
fn listeners(options: &Options) -> Result<Vec<TcpListener>> {
    let place = format!("{}:{}", options.hostname, options.port);
    let cannot = || format!("nothing can be served at {place}");
    let mut found = Vec::new();
    let mut failed = None;
    for address in place.to_socket_addrs().with_context(cannot)? {
        match TcpListener::bind(address) {
            Ok(listener) => found.push(listener),
            Err(error) if error.kind() == io::ErrorKind::AddrInUse => bail!(
                "something else is served at {place} already; `cargo book serve -p {}` takes another port",
                options.port.checked_add(1).unwrap_or(3000)
            ),
            Err(error) => failed = Some(error),
        }
    }
    match failed {
        Some(error) if found.is_empty() => Err(error).with_context(cannot),
        _ => Ok(found),
    }
}

/// Opens the reader's browser.
fn open(address: &str) {
    let (program, arguments): (&str, &[&str]) = if cfg!(target_os = "macos") {
        ("open", &[])
    } else if cfg!(windows) {
        ("cmd", &["/C", "start"])
    } else {
        ("xdg-open", &[])
    };
    let opened = Command::new(program)
        .args(arguments)
        .arg(address)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn();
    if opened.is_err() {
        eprintln!("`{program}` cannot be run: open {address} yourself");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_port_that_is_taken_is_said_before_anything_is_built() {
        let taken = TcpListener::bind("127.0.0.1:0").unwrap();
        let port = taken.local_addr().unwrap().port();
        let options = Options { hostname: "127.0.0.1".to_owned(), port, dest_dir: None, open: false };
        let said = run(Path::new("."), &options, &Book::default());
        assert!(said.unwrap_err().to_string().contains(&format!("`cargo book serve -p {}`", port + 1)));
    }
}
