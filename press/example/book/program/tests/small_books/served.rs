//! Small books that are served while they are written, and what is said of scenes where nothing can move them.

use crate::{BOOK, GOOD, program, said, small_book, write};
use std::io::{Read as _, Write as _};
use std::net::{TcpListener, TcpStream};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;
use std::{env, fs, thread};

/// `cargo book serve`, which ends with its test.
struct Server(Child);

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Has the book served, at a port that is free now.
fn serve(command: &mut Command) -> (Server, u16) {
    let port = TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
    let command = command.args(["serve", "-n", "127.0.0.1", "-p", &port.to_string()]);
    (Server(command.spawn().unwrap()), port)
}

/// What the server says to a browser that asks for a page, once it is there.
fn page(port: u16, path: &str) -> String {
    for _ in 0..3000 {
        if let Ok(mut stream) = TcpStream::connect(("127.0.0.1", port)) {
            let mut said = String::new();
            stream.set_read_timeout(Some(Duration::from_secs(120))).unwrap();
            write!(stream, "GET {path} HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n").unwrap();
            stream.read_to_string(&mut said).unwrap();
            return said;
        }
        thread::sleep(Duration::from_millis(100));
    }
    panic!("nobody answers");
}

/// Waits for something that is about to happen, five minutes at most: beside it other tests compile.
fn until(is_it: impl Fn() -> bool) {
    for _ in 0..3000 {
        if is_it() {
            return;
        }
        thread::sleep(Duration::from_millis(100));
    }
    panic!("it does not happen");
}

#[test]
fn who_is_served_a_book_with_a_fault_reads_it_at_every_address_and_then_the_page() {
    let folder = small_book("served", "# A\n\nSee <b>@eq:nothing.\n");
    let (server, port) = serve(program(&folder).stderr(Stdio::null()));
    let bad = page(port, "/a.html");
    let news = page(port, "/__news");
    write(&folder.join("book/a.md"), GOOD);
    until(|| page(port, "/__news") != news);
    let good = page(port, "/a.html");
    // The page of all pages comes with the rest, and stays as it is while a sentence changes.
    let made = folder.join("target/book");
    until(|| made.join("kept/print.html").is_file());
    write(&folder.join("book/a.md"), &GOOD.replace("So ", "Thus "));
    until(|| page(port, "/a.html").contains("Thus "));
    let all = page(port, "/print.html");
    drop(server);
    assert!(all.starts_with("HTTP/1.1 200") && all.contains("So ") && !all.contains("Thus "));
    assert!(!made.join("html/print.html").exists() && !made.join("next/html").exists());
    assert!(bad.contains("book/a.md:3: `&lt;b&gt;` is not closed") && bad.contains("eq:nothing"), "{bad}");
    assert!(bad.starts_with("HTTP/1.1 404") && bad.contains("http-equiv=\"refresh\""), "it asks again");
    assert!(good.starts_with("HTTP/1.1 200") && good.contains("figures.html"), "{good}");
}

/// `cargo book` in a folder with scenes, where the compiler has no target for browsers, and a rustup that fails.
#[cfg(unix)]
fn without_target(folder: &Path) -> Command {
    let programs = folder.join("programs");
    fs::create_dir_all(&programs).unwrap();
    // By another process: what this one writes cannot be run while some thread starts a third.
    let write =
        "echo '#!/bin/sh' | tee rustup > rustc; echo 'echo $* >> asked; exit 1' >> rustup; chmod 755 rust*";
    assert!(Command::new("sh").args(["-c", write]).current_dir(&programs).status().unwrap().success());
    let path = env::var_os("PATH").unwrap();
    let path = env::join_paths([programs].into_iter().chain(env::split_paths(&path))).unwrap();
    let mut command = program(folder);
    command.env("PATH", path);
    command.env("MDBOOK_PREPROCESSOR__PRESS__COMMAND", BOOK);
    for name in ["BOOK_LIVE", "BOOK_WASM_RUSTC", "RUSTC"] {
        command.env_remove(name);
    }
    command
}

#[cfg(unix)]
#[test]
fn rustup_is_asked_once_for_what_scenes_need_and_where_it_fails_they_stand_still() {
    let folder = small_book("no-target", GOOD);
    let asked = || fs::read_to_string(folder.join("asked")).unwrap_or_default();
    let still = "the scenes of the pages stand still, because the compiler lacks the target";
    let once = "target add wasm32-unknown-unknown\n";
    // Whether the book is built with this wish, and whether it is said that scenes stand still.
    for (wish, is_built, is_said) in [("auto", true, true), ("static", true, false), ("require", false, true)]
    {
        let built = without_target(&folder).arg("build").env("BOOK_LIVE", wish).output().unwrap();
        let outcome = (built.status.success(), said(&built).contains(still));
        assert_eq!(outcome, (is_built, is_said), "{wish}: {}", said(&built));
        assert!(asked() == once || wish == "require", "{}", asked());
    }

    fs::remove_file(folder.join("asked")).unwrap();
    let log = fs::File::create(folder.join("said")).unwrap();
    let (server, port) = serve(without_target(&folder).stderr(log));
    page(port, "/a.html");
    let is_complete = || fs::read_to_string(folder.join("said")).unwrap().matches("Everything").count();
    until(|| is_complete() == 1);
    for word in ["Thus ", "Hence "] {
        write(&folder.join("book/a.md"), &GOOD.replace("So ", word));
        until(|| page(port, "/a.html").contains(word));
    }
    write(&folder.join("Cargo.toml"), ""); // what belongs to a library is made anew
    write(&folder.join("book/a.md"), GOOD);
    until(|| page(port, "/a.html").contains("So "));
    drop(server);
    let said = fs::read_to_string(folder.join("said")).unwrap();
    assert!(said.matches(still).count() == 1 && asked() == once, "{}\n{said}", asked());
}
