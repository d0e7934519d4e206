//! `cargo book serve`: the site for the browser of who writes it, made anew when something changes.
//!
//! A page is sent as it lies in the folder, with a line of script that loads it again after the next build. What is
//! being made at the moment is waited for.

mod http;
mod watch;

use crate::api;
use crate::mdbook::{self, For};
use crate::module::{self, Module};
use http::Site;
use std::io;
use std::net::{TcpListener, ToSocketAddrs};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::thread;
use tiny_http::Server;
use watch::Watcher;

/// What one can ask for.
#[derive(Debug, PartialEq, Eq)]
struct Order {
    host: String,
    port: u16,
    folder: String,
    open: bool,
}

impl Order {
    fn read(arguments: &[String]) -> Result<Self, String> {
        let mut order =
            Self { host: "localhost".to_owned(), port: 3000, folder: "target/book".to_owned(), open: false };
        let mut rest = arguments.iter();
        while let Some(argument) = rest.next() {
            let (name, within) = match argument.split_once('=') {
                Some((name, value)) if name.starts_with("--") => (name, Some(value.to_owned())),
                _ => (argument.as_str(), None),
            };
            let mut value = || {
                within.clone().or_else(|| rest.next().cloned()).ok_or(format!("error: {name} names nothing"))
            };
            match name {
                "-o" | "--open" => order.open = true,
                "-n" | "--hostname" => order.host = value()?,
                "-d" | "--dest-dir" => order.folder = value()?,
                "-p" | "--port" => {
                    let port = value()?;
                    order.port = port.parse().map_err(|_| format!("error: `{port}` is no port"))?;
                }
                _ => return Err(format!("error: `cargo book serve` takes no argument `{argument}`")),
            }
        }
        Ok(order)
    }
}

/// Serves the book in `root` until it is stopped.
///
/// # Errors
/// If it cannot begin: what is asked for is nonsense, or the port is taken.
pub(crate) fn run(root: &Path, arguments: &[String]) -> Result<(), String> {
    let order = Order::read(arguments)?;
    // Before anything is built, which takes a while.
    let servers = servers(&order)?;
    let site = Arc::new(Site::new(root.join(&order.folder).join("html")));
    for server in servers {
        let site = Arc::clone(&site);
        thread::spawn(move || http::answer(&server, &site));
    }
    let address = format!("http://{}:{}", order.host, order.port);
    eprintln!("Printing the pages");
    let mut watcher = Watcher::new(mdbook::made_of(root)?);
    let mut is_first = true;
    loop {
        let whole = build(root, &order.folder, &site);
        if is_first {
            eprintln!("The book is at {address}; it follows your edits until you press Ctrl+C");
            if order.open {
                open(&address);
            }
            is_first = false;
        }
        if !whole && !watcher.has_changed() {
            // What the pages show already needs no second look before the rest is there.
            site.while_built(|| report(mdbook::build(root, Some(&order.folder), For::Author)));
        }
        let (changed, more) = watcher.wait();
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        eprintln!("Changed: {}{more}", changed.strip_prefix(root).unwrap_or(&changed).display());
    }
}

/// Builds the pages, with all that takes no time; whether that is everything.
fn build(root: &Path, folder: &str, site: &Site) -> bool {
    let is_current = api::is_current(root) && !matches!(module::found(root, For::Author), Ok(Module::Stale));
    let for_whom = if is_current { For::Author } else { For::Hasty };
    let is_built = site.while_built(|| report(mdbook::build(root, Some(folder), for_whom)));
    is_current || !is_built
}

fn report(outcome: Result<(), String>) -> bool {
    outcome.map_err(|message| eprintln!("{message}")).is_ok()
}

/// Where it is listened: `localhost` may be two addresses.
fn servers(order: &Order) -> Result<Vec<Server>, String> {
    let place = format!("{}:{}", order.host, order.port);
    let cannot = |error: io::Error| match error.kind() {
        io::ErrorKind::AddrInUse => format!(
            "error: something else is served at {place} already; `cargo book serve -p {}` takes another port",
            order.port.checked_add(1).unwrap_or(3000)
        ),
        _ => format!("error: nothing can be served at {place}: {error}"),
    };
    let mut found = Vec::new();
    let mut failed = None;
    for address in place.to_socket_addrs().map_err(cannot)? {
        match TcpListener::bind(address) {
            Ok(listener) => {
                let server = Server::from_listener(listener, None);
                found.push(server.map_err(|error| cannot(io::Error::other(error)))?);
            }
            Err(error) if error.kind() == io::ErrorKind::AddrInUse => return Err(cannot(error)),
            Err(error) => failed = Some(error),
        }
    }
    match failed {
        Some(error) if found.is_empty() => Err(cannot(error)),
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

    fn order(arguments: &str) -> Result<Order, String> {
        Order::read(&arguments.split_whitespace().map(str::to_owned).collect::<Vec<_>>())
    }

    #[test]
    fn host_port_and_folder_are_asked_for_as_of_mdbook() {
        let usual = order("").unwrap();
        assert_eq!((usual.host.as_str(), usual.port, usual.open), ("localhost", 3000, false));
        let other = order("-o -p 3001 --hostname=0.0.0.0 -d a/b").unwrap();
        assert_eq!((other.host.as_str(), other.port, other.folder.as_str()), ("0.0.0.0", 3001, "a/b"));
        assert!(other.open);
        for (wrong, said) in [("-p", "-p names nothing"), ("-p x", "`x` is no port"), ("a", "argument `a`")] {
            assert!(order(wrong).unwrap_err().contains(said), "{wrong}");
        }
    }

    #[test]
    fn a_port_that_is_taken_is_said_before_anything_is_built() {
        let taken = TcpListener::bind("127.0.0.1:0").unwrap();
        let port = taken.local_addr().unwrap().port();
        let said = run(Path::new("."), &["-n".into(), "127.0.0.1".into(), "-p".into(), port.to_string()]);
        assert!(said.unwrap_err().contains(&format!("`cargo book serve -p {}`", port + 1)));
    }
}
