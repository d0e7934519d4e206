//! The pages in Firefox, which sets formulas otherwise than Chromium. It is driven by its own protocol, Marionette:
//! JSON over a socket, each message behind its length.

use super::site;
use serde_json::{Value, json};
use std::io::{Read as _, Write as _};
use std::net::TcpStream;
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use std::{env, fs, process, thread};

const PATIENCE: Duration = Duration::from_secs(60);

/// A Firefox with one page, which ends with its test.
struct Firefox {
    child: Child,
    profile: PathBuf,
    stream: TcpStream,
    asked: u64,
}

impl Firefox {
    /// Starts it; `None` where there is none, which in CI is a failure.
    fn open() -> Option<Self> {
        let profile = env::temp_dir().join(format!("book-firefox-{}", process::id()));
        fs::create_dir_all(&profile).expect("a folder");
        fs::write(profile.join("user.js"), "user_pref(\"marionette.port\", 0);\n").expect("a file"); // any that is free
        let start = |name: &str| {
            let mut program = Command::new(name);
            program.args(["--headless", "--marionette", "--no-remote", "--profile"]).arg(&profile);
            program.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn().ok()
        };
        let Some(child) = ["firefox-esr", "firefox"].into_iter().find_map(start) else {
            assert!(env::var_os("CI").is_none(), "CI has to have Firefox");
            eprintln!("skipped: there is no Firefox on PATH");
            return None;
        };
        let begun = Instant::now();
        let stream = loop {
            let port = fs::read_to_string(profile.join("MarionetteActivePort")).unwrap_or_default();
            if let Some(stream) =
                port.parse().ok().and_then(|port: u16| TcpStream::connect(("127.0.0.1", port)).ok())
            {
                break stream;
            }
            assert!(begun.elapsed() < PATIENCE, "Firefox does not listen");
            thread::sleep(Duration::from_millis(50));
        };
        stream.set_read_timeout(Some(PATIENCE)).expect("a time");
        let mut firefox = Self { child, profile, stream, asked: 0 };
        firefox.message(); // it says who it is
        firefox.ask("WebDriver:NewSession", &json!({}));
        Some(firefox)
    }

    fn message(&mut self) -> Value {
        let mut length = String::new();
        let mut byte = [0];
        loop {
            self.stream.read_exact(&mut byte).expect("Firefox answers");
            if byte == *b":" {
                break;
            }
            length.push(char::from(byte[0]));
        }
        let mut message = vec![0; length.parse().expect("a length")];
        self.stream.read_exact(&mut message).expect("Firefox answers");
        serde_json::from_slice(&message).expect("Firefox writes JSON")
    }

    fn ask(&mut self, command: &str, params: &Value) -> Value {
        self.asked += 1;
        let message = json!([0, self.asked, command, params]).to_string();
        write!(self.stream, "{}:{message}", message.len()).expect("Firefox listens");
        let answer = self.message();
        assert!(answer[2].is_null(), "{command}: {answer}");
        answer[3]["value"].clone()
    }
}

impl Drop for Firefox {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
        let _ = fs::remove_dir_all(&self.profile);
    }
}

/// The words that are indices: how many there are, and those that are not smaller than what they stand at.
const WORDS: &str = "
    const size = (element) => parseFloat(getComputedStyle(element).fontSize);
    const scripts = [...document.querySelectorAll('msub, msup, msubsup')];
    const words = scripts.flatMap((script) => [...script.children].slice(1)
        .flatMap((index) => [...index.querySelectorAll('mtext'), ...(index.matches('mtext') ? [index] : [])])
        .map((word) => [word.textContent, size(word) / size(script)]));
    return [words.length, words.filter(([, ratio]) => !(ratio < 0.85)).map(([word, ratio]) => `${word}: ${ratio}`)];";

#[test]
fn words_are_small_as_indices_in_firefox() {
    let Some(mut firefox) = Firefox::open() else { return };
    for (page, least) in [("symbols.html", 30), ("coin-toss/index.html", 8), ("rolling-wheel/index.html", 10)]
    {
        let address = format!("file://{}", site().join(page).display());
        firefox.ask("WebDriver:Navigate", &json!({ "url": address }));
        let found = firefox.ask("WebDriver:ExecuteScript", &json!({ "script": WORDS, "args": [] }));
        assert!(found[0].as_u64() >= Some(least), "{page}: {found}");
        assert_eq!(
            found[1],
            json!([]),
            "{page}: a word that is an index is as large as the letter at which it stands"
        );
    }
}
