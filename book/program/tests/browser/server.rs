//! A small server of files for the tests in a browser.

use std::io::{BufRead, BufReader, Write as _};
use std::net::{TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::{fs, thread};

/// Serves a folder on this machine as long as the tests run, and gives its address.
pub(crate) fn serve(folder: PathBuf) -> String {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port is free");
    let address = format!("http://{}/", listener.local_addr().unwrap());
    thread::spawn(move || {
        for stream in listener.incoming().map_while(Result::ok) {
            let folder = folder.clone();
            thread::spawn(move || answer(stream, &folder));
        }
    });
    address
}

/// Answers one request: `GET /page.html?query HTTP/1.1`. A reader who has gone away hears nothing. With `alone=scene-top` the
/// text of the page is left out, but for that figure (or some): tests of a panel need not wait for a chapter to be laid out.
fn answer(mut stream: TcpStream, folder: &Path) {
    let mut line = String::new();
    let mut request = BufReader::new(&stream);
    let _ = request.read_line(&mut line);
    // What is not read before the connection is closed, the other side takes for a fault.
    let mut header = String::new();
    while request.read_line(&mut header).is_ok_and(|length| length > 2) {
        header.clear();
    }
    let path = line.split(['/', ' ', '?']).skip(2);
    let path: PathBuf = path.take_while(|part| *part != "HTTP" && !part.contains('=')).collect();
    let kind = match path.extension().and_then(|ending| ending.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css",
        Some("js") => "text/javascript",
        Some("svg") => "image/svg+xml",
        Some("woff2") => "font/woff2",
        _ => "application/octet-stream",
    };
    let (status, mut body) =
        fs::read(folder.join(path)).map_or(("404 Not Found", Vec::new()), |body| ("200 OK", body));
    if let Some((_, id)) = line.split_once("?alone=") {
        body = alone(&String::from_utf8_lossy(&body), id.split(' ').next().unwrap_or_default()).into_bytes();
    }
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\nCache-Control: max-age={}\r\nConnection: close\r\n\r\n",
        body.len(),
        if kind.starts_with("text/html") { 0 } else { 3600 } // scripts and fonts stay as they are
    );
    let _ = stream.write_all(&[head.into_bytes(), body].concat());
}

/// The page with nothing in its text but a scene, or some with commas between their names, and room below to scroll away.
fn alone(html: &str, ids: &str) -> String {
    let (head, text) = html.split_once("<main").expect("a text");
    let (text, foot) = text.split_once("</main>").expect("its end");
    let figures = ids.split(',').map(|id| {
        let start = text.find(&format!("<figure class=\"scene\" id=\"{id}\"")).expect("the scene");
        text[start..].split_inclusive("</figure>").next().expect("its end")
    });
    format!("{head}<main>{}<p style=\"height: 200vh\"></p></main>{foot}", figures.collect::<String>())
}
