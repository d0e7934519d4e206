//! Files over HTTP, for a browser on this machine. Each connection has a thread and is asked once: browsers open some
//! that they may not need, and nobody should wait behind those. That is why connections are our own; a library reads
//! the requests.

use httparse::{EMPTY_HEADER, Request, Status};
use percent_encoding::percent_decode_str;
use std::io::{self, Read, Write};
use std::net::{IpAddr, TcpListener, TcpStream};
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::{Duration, SystemTime, UNIX_EPOCH};
use std::{fs, thread};

/// Where a page asks which build is the newest.
const NEWS: &str = "/__news";

/// How long something is waited for that is just being made.
const PATIENCE: Duration = Duration::from_secs(60);
/// The longest head of a request, bytes.
const LONGEST: usize = 1 << 16;

/// The folders of the site, and what happens to it.
pub(super) struct Site {
    /// What is not in the first may be in the next.
    folders: Vec<PathBuf>,
    state: Mutex<State>,
    changed: Condvar,
}

#[derive(Clone, Copy)]
struct State {
    is_being_built: bool,
    /// Larger by one after each build. It begins with the time, because pages of an earlier run may still be open.
    count: u64,
}

impl Site {
    /// A site that is not built yet.
    pub(super) fn new(folders: Vec<PathBuf>) -> Self {
        let count = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |time| time.as_secs());
        Self { folders, state: Mutex::new(State { is_being_built: true, count }), changed: Condvar::new() }
    }

    /// Where a path lies, or would.
    fn place(&self, below: &Path) -> PathBuf {
        let mut places = self.folders.iter().map(|folder| folder.join(below));
        places.clone().find(|place| place.exists()).or(places.next()).unwrap_or_default()
    }

    /// Has it built by `build`, and tells the pages, also where it has failed: they then show why.
    pub(super) fn while_built<T>(&self, build: impl FnOnce() -> T) -> T {
        self.set(|state| state.is_being_built = true);
        let outcome = build();
        self.set(|state| *state = State { is_being_built: false, count: state.count + 1 });
        outcome
    }

    fn set(&self, change: impl FnOnce(&mut State)) {
        change(&mut self.state.lock().unwrap_or_else(PoisonError::into_inner));
        self.changed.notify_all();
    }

    /// Waits for a state of which `is_it` is true, as long as `patience`; the state then.
    fn wait(&self, patience: Duration, is_it: impl Fn(&State) -> bool) -> State {
        let state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let waited = self.changed.wait_timeout_while(state, patience, |state| !is_it(state));
        *waited.unwrap_or_else(PoisonError::into_inner).0
    }
}

/// Answers whoever asks, for ever.
pub(super) fn answer(listener: &TcpListener, site: &Arc<Site>) {
    for stream in listener.incoming().flatten() {
        let site = Arc::clone(site);
        thread::spawn(move || {
            let _ = one(&stream, &site); // a browser that has gone away misses nothing
        });
    }
}

fn one(stream: &TcpStream, site: &Site) -> io::Result<()> {
    stream.set_read_timeout(Some(PATIENCE))?;
    let Some(Asked { method, address, host }) = request(stream)? else {
        return send(stream, "400 Bad Request", TEXT, b"this is no request", true);
    };
    if stream.local_addr()?.ip().is_loopback() && !is_own(&host) {
        return send(stream, "403 Forbidden", TEXT, b"this is served to localhost alone", true);
    }
    if !matches!(&*method, "GET" | "HEAD") {
        return send(stream, "405 Method Not Allowed", TEXT, b"only for reading", true);
    }
    let path = address.split(['?', '#']).next().unwrap_or_default();
    if path == NEWS {
        let count = site.wait(Duration::ZERO, |_| true).count.to_string();
        return send(stream, "200 OK", TEXT, count.as_bytes(), method != "HEAD");
    }
    let Some(below) = below(path) else {
        return send(stream, "400 Bad Request", TEXT, b"no such address", true);
    };
    // Before the page is read, which may then be newer than its count and is loaded once more, but never older.
    let count = site.wait(Duration::ZERO, |_| true).count;
    let read = || {
        let file = site.place(&below);
        let file = if file.is_dir() && path.ends_with('/') { file.join("index.html") } else { file };
        fs::read(&file).map(|bytes| (kind(&file), bytes))
    };
    let found = read().or_else(|_| {
        site.wait(PATIENCE, |state| !state.is_being_built);
        read()
    });
    let (status, head, body) = match found {
        Ok((HTML, page)) => ("200 OK", HTML.to_owned(), with_script(page, count)),
        Ok((kind, bytes)) => ("200 OK", kind.to_owned(), bytes),
        Err(_) if site.place(&below).is_dir() => {
            ("302 Found", format!("{TEXT}\r\nLocation: {path}/"), Vec::new())
        }
        Err(_) => {
            let page = fs::read(site.place(Path::new("404.html")));
            let page = page.unwrap_or_else(|_| b"There is no such page.".to_vec());
            ("404 Not Found", HTML.to_owned(), with_script(page, count))
        }
    };
    send(stream, status, &head, &body, method != "HEAD")
}

struct Asked {
    method: String,
    address: String,
    /// What the browser calls this server.
    host: String,
}

/// Reads a request; `None` if it is none.
fn request(mut stream: impl Read) -> io::Result<Option<Asked>> {
    let mut head = Vec::new();
    let mut part = [0; 4096];
    while head.len() < LONGEST {
        let count = stream.read(&mut part)?;
        head.extend_from_slice(&part[..count]);
        let mut headers = [EMPTY_HEADER; 100];
        let mut request = Request::new(&mut headers);
        match request.parse(&head) {
            Ok(Status::Complete(_)) => {
                let mut hosts = request.headers.iter().filter(|one| one.name.eq_ignore_ascii_case("host"));
                let host = hosts.next().map_or(&[][..], |one| one.value);
                return Ok(request.method.zip(request.path).map(|(method, address)| Asked {
                    method: method.to_owned(),
                    address: address.to_owned(),
                    host: String::from_utf8_lossy(host).into_owned(),
                }));
            }
            Ok(Status::Partial) if count > 0 => {}
            _ => return Ok(None),
        }
    }
    Ok(None)
}

/// Whether a name is one that browsers on this machine use. Any other may be led here by whoever owns it, whose page
/// could then read what is served.
fn is_own(host: &str) -> bool {
    let port = host.rsplit_once(':').filter(|(_, port)| port.parse::<u16>().is_ok());
    let name = port.filter(|_| !host.ends_with(']')).map_or(host, |(name, _)| name);
    let address = name.trim_start_matches('[').trim_end_matches(']').parse::<IpAddr>();
    name.is_empty() || name.eq_ignore_ascii_case("localhost") || address.is_ok_and(|one| one.is_loopback())
}

fn send(mut stream: &TcpStream, status: &str, kind: &str, body: &[u8], with_body: bool) -> io::Result<()> {
    let length = body.len();
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {length}\r\nCache-Control: no-store\r\nConnection: close\r\n\r\n"
    );
    stream.write_all(head.as_bytes())?;
    if with_body { stream.write_all(body) } else { Ok(()) }
}

/// A page with what loads it again after the next build, once somebody looks at it. It asks now and then: a browser has
/// six connections to a server, and if each open page kept one, none would be left for the seventh.
fn with_script(mut page: Vec<u8>, count: u64) -> Vec<u8> {
    let script = format!(
        "<script>(async () => {{ for (;;) {{ await new Promise((go) => setTimeout(go, 300)); \
         if (!document.hidden && await fetch(\"{NEWS}\").then((it) => it.text(), () => \"{count}\") !== \"{count}\") \
         return location.reload(); }} }})();</script>\n"
    );
    page.extend(script.into_bytes()); // behind its end, which no browser minds
    page
}

/// The path in the site's folder that an address names; `None` if it leads out of it.
fn below(path: &str) -> Option<PathBuf> {
    let path = percent_decode_str(path.strip_prefix('/')?).decode_utf8().ok()?;
    let path = PathBuf::from(path.as_ref());
    path.components().all(|part| matches!(part, Component::Normal(_))).then_some(path)
}

const HTML: &str = "text/html; charset=utf-8";
const TEXT: &str = "text/plain; charset=utf-8";

/// What a file holds, for the browser.
fn kind(file: &Path) -> &'static str {
    match file.extension().and_then(|ending| ending.to_str()).unwrap_or_default() {
        "html" => HTML,
        "css" => "text/css; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        "json" => "application/json",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "woff2" => "font/woff2",
        "pdf" => "application/pdf",
        "epub" => "application/epub+zip",
        "csv" | "md" | "txt" | "" => TEXT,
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is answered to whoever asks for something of a server that it calls `host`.
    fn asked_of(host: &str, address: std::net::SocketAddr, request: &str) -> String {
        let mut stream = TcpStream::connect(address).unwrap();
        let request = format!("{request} HTTP/1.1\r\nhost: {host}\r\nConnection: close\r\n\r\n");
        stream.write_all(request.as_bytes()).unwrap();
        let mut said = String::new();
        stream.read_to_string(&mut said).unwrap();
        said
    }

    fn asked(address: std::net::SocketAddr, request: &str) -> String {
        asked_of("localhost:3000", address, request)
    }

    #[test]
    fn pages_are_sent_and_loaded_again_after_a_build() {
        let folder = std::env::temp_dir().join(format!("press-http-{}", std::process::id()));
        fs::create_dir_all(folder.join("a b")).unwrap();
        fs::create_dir_all(folder.join("kept/api")).unwrap();
        for (file, text) in [
            ("index.html", "<body>Home</body>"),
            ("404.html", "<body>Lost</body>"),
            ("a b/index.html", "A"),
            ("a.css", "p {}"),
            ("kept/api/index.html", "API"),
        ] {
            fs::write(folder.join(file), text).unwrap();
        }
        let site = Arc::new(Site::new(vec![folder.clone(), folder.join("kept")]));
        site.while_built(|| ());
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = listener.local_addr().unwrap();
        let served = Arc::clone(&site);
        thread::spawn(move || answer(&listener, &served));

        let home = asked(address, "GET /?x=1");
        let count = |page: &str| page.rsplit("!== \"").next().unwrap().split('"').next().unwrap().to_owned();
        for (request, begin, words) in [
            ("GET /?x=1", "HTTP/1.1 200 OK\r\nContent-Type: text/html", "<body>Home</body><script>"),
            ("GET /a.css", "HTTP/1.1 200", "\r\n\r\np {}"),
            ("HEAD /a.css", "HTTP/1.1 200", "\r\n\r\n"),
            ("GET /a%20b", "HTTP/1.1 302", "Location: /a%20b/"),
            ("GET /a%20b/", "HTTP/1.1 200", "\r\n\r\nA<script>"),
            ("GET /api/", "HTTP/1.1 200", "\r\n\r\nAPI<script>"),
            ("GET /b.html", "HTTP/1.1 404", "Lost"),
            ("GET /../x", "HTTP/1.1 400", ""),
            ("GET /%2e%2e/x", "HTTP/1.1 400", ""),
            ("GET //etc/passwd", "HTTP/1.1 400", ""),
            ("POST /", "HTTP/1.1 405", ""),
            ("GET", "HTTP/1.1 400", ""),
        ] {
            let said = asked(address, request);
            assert!(said.starts_with(begin) && said.contains(words), "{request}: {said}");
            assert!(!request.starts_with("HEAD") || said.ends_with("\r\n\r\n"), "{said}");
        }
        for (host, begin) in [
            ("LOCALHOST:80", "HTTP/1.1 200"),
            ("127.0.0.1:3000", "HTTP/1.1 200"),
            ("[::1]:3000", "HTTP/1.1 200"),
            ("[::1]", "HTTP/1.1 200"),
            ("example.org", "HTTP/1.1 403"),
            ("localhost.example.org:3000", "HTTP/1.1 403"),
            ("192.0.2.1", "HTTP/1.1 403"),
        ] {
            assert!(asked_of(host, address, "GET /a.css").starts_with(begin), "{host}");
        }

        // Connections that nobody uses, as browsers open them, hold up nobody.
        let idle: Vec<_> = (0..20).map(|_| TcpStream::connect(address).unwrap()).collect();
        let all: Vec<_> = (0..20).map(|_| thread::spawn(move || asked(address, "GET /a.css"))).collect();
        all.into_iter().for_each(|one| assert!(one.join().unwrap().ends_with("p {}")));
        drop(idle);

        // A page that is being made is waited for, and who has one hears of the next.
        let news = || asked(address, "GET /__news").rsplit("\r\n\r\n").next().unwrap().to_owned();
        assert_eq!(news(), count(&home));
        let late = site.while_built(|| {
            let late = thread::spawn(move || asked(address, "GET /late.html"));
            thread::sleep(Duration::from_millis(100));
            fs::write(folder.join("late.html"), "Late").unwrap();
            late
        });
        assert!(late.join().unwrap().contains("Late"));
        assert_ne!(news(), count(&home));
        assert_eq!(news(), count(&asked(address, "GET /")));
        fs::remove_dir_all(folder).unwrap();
    }
}
