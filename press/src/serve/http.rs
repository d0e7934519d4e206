//! Files over HTTP, for a browser on this machine. Each connection has a thread and is asked once: browsers open some
//! that they may not need, and nobody should wait behind those.

use httparse::{EMPTY_HEADER, Request, Status};
use percent_encoding::percent_decode_str;
use std::io::{self, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::Duration;
use std::{fs, thread};

/// Where a page asks whether there is a newer one.
const NEWS: &str = "/__news";
/// What makes it ask.
const SCRIPT: &str = "<script>new EventSource(\"/__news\").onmessage = () => location.reload();</script>\n";

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
    /// How often it was built.
    count: u64,
}

impl Site {
    /// A site that is not built yet.
    pub(super) fn new(folders: Vec<PathBuf>) -> Self {
        Self { folders, state: Mutex::new(State { is_being_built: true, count: 0 }), changed: Condvar::new() }
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
    let Some((method, address)) = request(stream)? else {
        return send(stream, "400 Bad Request", TEXT, b"this is no request", true);
    };
    if !matches!(&*method, "GET" | "HEAD") {
        return send(stream, "405 Method Not Allowed", TEXT, b"only for reading", true);
    }
    let path = address.split(['?', '#']).next().unwrap_or_default();
    if path == NEWS {
        return news(stream, site);
    }
    let Some(below) = below(path) else {
        return send(stream, "400 Bad Request", TEXT, b"no such address", true);
    };
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
        Ok((HTML, page)) => ("200 OK", HTML.to_owned(), with_script(page)),
        Ok((kind, bytes)) => ("200 OK", kind.to_owned(), bytes),
        Err(_) if site.place(&below).is_dir() => {
            ("302 Found", format!("{TEXT}\r\nLocation: {path}/"), Vec::new())
        }
        Err(_) => {
            let page = fs::read(site.place(Path::new("404.html")));
            let page = page.unwrap_or_else(|_| b"There is no such page.".to_vec());
            ("404 Not Found", HTML.to_owned(), with_script(page))
        }
    };
    send(stream, status, &head, &body, method != "HEAD")
}

/// The method and the address of a request; `None` if it is none.
fn request(mut stream: impl Read) -> io::Result<Option<(String, String)>> {
    let mut head = Vec::new();
    let mut part = [0; 4096];
    while head.len() < LONGEST {
        let count = stream.read(&mut part)?;
        head.extend_from_slice(&part[..count]);
        let mut headers = [EMPTY_HEADER; 100];
        let mut request = Request::new(&mut headers);
        match request.parse(&head) {
            Ok(Status::Complete(_)) => {
                return Ok(request.method.map(str::to_owned).zip(request.path.map(str::to_owned)));
            }
            Ok(Status::Partial) if count > 0 => {}
            _ => return Ok(None),
        }
    }
    Ok(None)
}

/// Tells when there is something new; asks now and then whether anybody still listens.
fn news(mut stream: &TcpStream, site: &Site) -> io::Result<()> {
    let count = site.wait(Duration::ZERO, |_| true).count;
    let mut tell = |words: &str| stream.write_all(words.as_bytes());
    tell(
        "HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\nCache-Control: no-store\r\nConnection: close\r\n\r\n",
    )?;
    while site.wait(Duration::from_secs(15), |state| state.count > count).count == count {
        tell(": nothing new\n\n")?;
    }
    tell("data: new\n\n")
}

fn send(mut stream: &TcpStream, status: &str, kind: &str, body: &[u8], with_body: bool) -> io::Result<()> {
    let length = body.len();
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {length}\r\nCache-Control: no-store\r\nConnection: close\r\n\r\n"
    );
    stream.write_all(head.as_bytes())?;
    if with_body { stream.write_all(body) } else { Ok(()) }
}

/// A page with what loads it again.
fn with_script(mut page: Vec<u8>) -> Vec<u8> {
    let end = page.windows(7).rposition(|window| window == b"</body>").unwrap_or(page.len());
    page.splice(end..end, SCRIPT.bytes());
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

    fn asked(address: std::net::SocketAddr, request: &str) -> String {
        let mut stream = TcpStream::connect(address).unwrap();
        stream
            .write_all(format!("{request} HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n").as_bytes())
            .unwrap();
        let mut said = String::new();
        stream.read_to_string(&mut said).unwrap();
        said
    }

    #[test]
    fn pages_are_sent_and_loaded_again_after_a_build() {
        let folder = std::env::temp_dir().join(format!("press-http-{}", std::process::id()));
        fs::create_dir_all(folder.join("a b")).unwrap();
        fs::write(folder.join("index.html"), "<body>Home</body>").unwrap();
        fs::write(folder.join("404.html"), "<body>Lost</body>").unwrap();
        fs::write(folder.join("a b/index.html"), "A").unwrap();
        fs::write(folder.join("a.css"), "p {}").unwrap();
        fs::create_dir_all(folder.join("kept/api")).unwrap();
        fs::write(folder.join("kept/api/index.html"), "API").unwrap();
        let site = Arc::new(Site::new(vec![folder.clone(), folder.join("kept")]));
        site.while_built(|| ());
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = listener.local_addr().unwrap();
        let served = Arc::clone(&site);
        thread::spawn(move || answer(&listener, &served));

        let home = asked(address, "GET /?x=1");
        assert!(home.starts_with("HTTP/1.1 200 OK") && home.contains("text/html"), "{home}");
        assert!(home.ends_with(&format!("<body>Home{SCRIPT}</body>")), "{home}");
        assert!(asked(address, "GET /a.css").ends_with("\r\n\r\np {}"));
        assert!(asked(address, "HEAD /a.css").ends_with("\r\n\r\n"));
        assert!(asked(address, "GET /a%20b").contains("Location: /a%20b/"));
        assert!(asked(address, "GET /api/").contains("\r\n\r\nAPI<script>"));
        assert!(asked(address, "GET /a%20b/").contains("\r\n\r\nA<script>"));
        assert!(
            asked(address, "GET /b.html").starts_with("HTTP/1.1 404")
                && asked(address, "GET /b.html").contains("Lost")
        );
        for outside in ["/../x", "/%2e%2e/x", "//etc/passwd"] {
            assert!(asked(address, &format!("GET {outside}")).starts_with("HTTP/1.1 400"), "{outside}");
        }
        assert!(asked(address, "POST /").starts_with("HTTP/1.1 405"));

        assert!(asked(address, "GET").starts_with("HTTP/1.1 400"));

        // Connections that nobody uses, as browsers open them, hold up nobody.
        let idle: Vec<_> = (0..20).map(|_| TcpStream::connect(address).unwrap()).collect();
        let all: Vec<_> = (0..20).map(|_| thread::spawn(move || asked(address, "GET /a.css"))).collect();
        all.into_iter().for_each(|one| assert!(one.join().unwrap().ends_with("p {}")));
        drop(idle);

        // A page that is being made is waited for, and who has one hears of the next.
        let reader = thread::spawn(move || asked(address, "GET /__news"));
        thread::sleep(Duration::from_millis(100));
        let late = site.while_built(|| {
            let late = thread::spawn(move || asked(address, "GET /late.html"));
            thread::sleep(Duration::from_millis(100));
            fs::write(folder.join("late.html"), "Late").unwrap();
            late
        });
        assert!(late.join().unwrap().contains("Late"));
        assert!(reader.join().unwrap().ends_with("data: new\n\n"));
        fs::remove_dir_all(folder).unwrap();
    }
}
