//! Drives a headless Chromium by its own protocol: JSON over a pair of pipes, a NUL between messages.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Write as _};
use std::path::PathBuf;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};
use std::{env, fs, process, thread};

/// How long anything may take before it counts as never: nothing is measured by it.
const PATIENCE: Duration = Duration::from_secs(60);
/// How long a page may take to arrive: that of all pages weighs seven megabytes, and other browsers load beside it.
const ARRIVAL: Duration = Duration::from_secs(180);

/// Whether all is asked that can be asked, which takes too long at every change: `BOOK_NIGHT`.
pub(crate) fn is_night() -> bool {
    env::var_os("BOOK_NIGHT").is_some()
}

/// The browser that also prints; `None` where there is none, which in CI is a failure.
pub(crate) fn program() -> Option<PathBuf> {
    let found = press::paper::browser();
    if let Err(said) = &found {
        assert!(env::var_os("CI").is_none(), "CI has to have a browser: {said}");
        eprintln!("skipped: {said}");
    }
    found.ok()
}

/// A browser of one's own, which ends with it.
pub(crate) struct Browser {
    child: Child,
    input: ChildStdin,
    messages: Receiver<Value>,
    profile: PathBuf,
    asked: u64,
    /// What has happened in its pages: `(session, event)`.
    events: Vec<(String, Value)>,
    /// The session and the target of a page that nobody uses any more.
    idle: Option<(String, Value)>,
}

impl Browser {
    /// Starts it; `None` where there is none. The name is that of the test.
    pub(crate) fn open(name: &str) -> Option<Self> {
        let program = program()?;
        let profile = env::temp_dir().join(format!("book-{}-{name}", process::id()));
        // It speaks over the files 3 and 4: its own input and output, under other numbers.
        let mut child = Command::new("sh")
            .args(["-c", "exec \"$@\" 3<&0 4>&1 0</dev/null 1>/dev/null", "sh"])
            .arg(program)
            .args([
                "--headless",
                "--no-sandbox",
                "--disable-gpu",
                "--remote-debugging-pipe",
                "--no-first-run",
            ])
            .args(["--disable-background-networking", "--disable-component-update", "--disable-sync"])
            .args(["--force-device-scale-factor=1", "--hide-scrollbars", "--touch-events=enabled"])
            .arg(format!("--user-data-dir={}", profile.display()))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("Chromium starts");
        let output = BufReader::new(child.stdout.take().expect("a pipe"));
        let (sender, messages) = channel();
        thread::spawn(move || {
            for message in output.split(0).map_while(Result::ok) {
                let message = serde_json::from_slice(&message).expect("the browser writes JSON");
                if sender.send(message).is_err() {
                    return; // nobody listens any more
                }
            }
        });
        let input = child.stdin.take().expect("a pipe");
        Some(Self { child, input, messages, profile, asked: 0, events: Vec::new(), idle: None })
    }

    /// Asks for something and waits for the answer; `Err` is what the browser says against it.
    fn ask(&mut self, session: &str, method: &str, params: Value) -> Result<Value, String> {
        self.asked += 1;
        let mut message = json!({ "id": self.asked, "method": method });
        message["params"] = params;
        if !session.is_empty() {
            message["sessionId"] = session.into();
        }
        self.input.write_all(format!("{message}\0").as_bytes()).expect("the browser listens");
        loop {
            let mut message =
                self.messages.recv_timeout(PATIENCE).unwrap_or_else(|_| panic!("no answer to {method}"));
            if message["id"] == self.asked {
                let error = &message["error"]["message"];
                return error
                    .as_str()
                    .map_or_else(|| Ok(message["result"].clone()), |error| Err(error.to_owned()));
            }
            let session = message["sessionId"].as_str().unwrap_or_default().to_owned();
            self.events.push((session, message.take()));
        }
    }

    /// A page of a size, px, to which nothing has been said yet: that of before, if there was one, as each new one is a process
    /// of its own that takes a fifth of a second to begin.
    pub(crate) fn page(&mut self, size: [u32; 2]) -> Page<'_> {
        let (session, target) = self.idle.take().unwrap_or_else(|| {
            let target = self.ask("", "Target.createTarget", json!({ "url": "about:blank" })).unwrap();
            let attach = json!({ "targetId": target["targetId"], "flatten": true });
            let attached = self.ask("", "Target.attachToTarget", attach).unwrap();
            let session = attached["sessionId"].as_str().unwrap().to_owned();
            for domain in ["Page", "Runtime", "Log", "Network"] {
                self.ask(&session, &format!("{domain}.enable"), json!({})).unwrap();
            }
            (session, target["targetId"].clone())
        });
        self.events.clear();
        let mut page = Page { browser: self, session, target, scripts: Vec::new() };
        page.resize(size);
        page
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        if thread::panicking() {
            let _ = self.child.kill();
        } else {
            let _ = self.ask("", "Browser.close", json!({}));
        }
        let _ = self.child.wait();
        let _ = fs::remove_dir_all(&self.profile);
    }
}

/// A page in a browser. At its end it is emptied, as a scene that nobody sees any more would go on moving, and forgets what it
/// was told, for whoever has it next.
pub(crate) struct Page<'a> {
    browser: &'a mut Browser,
    session: String,
    target: Value,
    /// What runs before all of its documents.
    scripts: Vec<Value>,
}

impl Drop for Page<'_> {
    fn drop(&mut self) {
        if thread::panicking() {
            return;
        }
        for script in std::mem::take(&mut self.scripts) {
            self.tell("Page.removeScriptToEvaluateOnNewDocument", json!({ "identifier": script }));
        }
        self.tell("Emulation.setEmulatedMedia", json!({ "media": "", "features": [] }));
        self.tell("Emulation.setScriptExecutionDisabled", json!({ "value": false }));
        self.tell("Network.setBlockedURLs", json!({ "urls": [] }));
        self.tell("Page.navigate", json!({ "url": "about:blank" }));
        self.browser.idle = Some((std::mem::take(&mut self.session), self.target.take()));
    }
}

impl Page<'_> {
    /// Asks the browser for something in this page.
    pub(crate) fn tell(&mut self, method: &str, params: Value) -> Value {
        let answer = self.browser.ask(&self.session, method, params);
        answer.unwrap_or_else(|error| panic!("{method}: {error}"))
    }

    /// Runs a script at the beginning of each document that is opened from now on.
    pub(crate) fn before_all(&mut self, script: &str) {
        let added = self.tell("Page.addScriptToEvaluateOnNewDocument", json!({ "source": script }));
        self.scripts.push(added["identifier"].clone());
    }

    /// Gives it another size, px.
    pub(crate) fn resize(&mut self, [width, height]: [u32; 2]) {
        let size = json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": false });
        self.tell("Emulation.setDeviceMetricsOverride", size);
    }

    /// Sets what the reader has asked for: `prefers-reduced-motion`, `reduce`.
    pub(crate) fn prefer(&mut self, name: &str, value: &str) {
        self.tell("Emulation.setEmulatedMedia", json!({ "features": [{ "name": name, "value": value }] }));
    }

    /// Goes to an address, and waits until all of it is there.
    pub(crate) fn go(&mut self, address: &str) {
        let gone = self.tell("Page.navigate", json!({ "url": address }));
        assert!(gone["errorText"].is_null(), "{address}: {gone}");
        let has_come = format!("location.href === {} && document.readyState === 'complete'", json!(address));
        self.wait_for(&has_come, ARRIVAL);
    }

    /// The value of an expression in the page; a promise is waited for.
    pub(crate) fn get(&mut self, expression: &str) -> Value {
        let run = json!({ "expression": expression, "returnByValue": true, "awaitPromise": true });
        let got = self.tell("Runtime.evaluate", run);
        let fault = &got["exceptionDetails"];
        assert!(fault.is_null(), "{expression}: {fault}");
        got["result"]["value"].clone()
    }

    /// A text of the page.
    pub(crate) fn text(&mut self, expression: &str) -> String {
        let value = self.get(expression);
        value.as_str().unwrap_or_else(|| panic!("{expression} is {value}")).to_owned()
    }

    /// A number of the page.
    pub(crate) fn number(&mut self, expression: &str) -> f64 {
        let value = self.get(expression);
        value.as_f64().unwrap_or_else(|| panic!("{expression} is {value}"))
    }

    /// Waits until an expression is true.
    pub(crate) fn wait(&mut self, expression: &str) {
        self.wait_for(expression, PATIENCE);
    }

    fn wait_for(&mut self, expression: &str, patience: Duration) {
        let begun = Instant::now();
        while self.get(&format!("Boolean({expression})")) != true {
            assert!(begun.elapsed() < patience, "never: {expression}");
            thread::sleep(Duration::from_millis(10));
        }
    }

    /// Waits until the page has shown its present state and one more.
    pub(crate) fn settle(&mut self) {
        let twice = "requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done)))";
        self.get(&format!("new Promise((done) => {twice})"));
    }

    /// Moves, presses or releases the mouse at a point of the window.
    pub(crate) fn mouse(&mut self, kind: &str, [x, y]: [f64; 2]) {
        let button = if kind == "mouseMoved" { "none" } else { "left" };
        let buttons = u8::from(kind == "mousePressed");
        let event =
            json!({ "type": kind, "x": x, "y": y, "button": button, "buttons": buttons, "clickCount": 1 });
        self.tell("Input.dispatchMouseEvent", event);
    }

    /// Draws the mouse from a point to another; a click, if they are the same.
    pub(crate) fn drag(&mut self, from: [f64; 2], to: [f64; 2]) {
        self.mouse("mouseMoved", from);
        self.mouse("mousePressed", from);
        for part in [0.25, 0.5, 0.75, 1.0] {
            let [x, y] = [0, 1].map(|k| from[k] + part * (to[k] - from[k]));
            let event = json!({ "type": "mouseMoved", "x": x, "y": y, "button": "left", "buttons": 1 });
            self.tell("Input.dispatchMouseEvent", event);
        }
        self.mouse("mouseReleased", to);
    }

    /// Draws a finger from a point to another; a tap, if they are the same.
    pub(crate) fn swipe(&mut self, from: [f64; 2], to: [f64; 2]) {
        let at = |[x, y]: [f64; 2]| json!([{ "x": x, "y": y, "id": 1 }]);
        self.tell("Input.dispatchTouchEvent", json!({ "type": "touchStart", "touchPoints": at(from) }));
        for part in [0.25, 0.5, 0.75, 1.0].into_iter().filter(|_| from != to) {
            let point = at([0, 1].map(|k| from[k] + part * (to[k] - from[k])));
            self.tell("Input.dispatchTouchEvent", json!({ "type": "touchMove", "touchPoints": point }));
        }
        self.tell("Input.dispatchTouchEvent", json!({ "type": "touchEnd", "touchPoints": [] }));
    }

    /// Strikes a key: `ArrowRight`, `Enter`, or a space.
    pub(crate) fn key(&mut self, key: &str) {
        let (code, text) = match key {
            "Enter" => (13, "\r"),
            " " => (32, " "),
            "Tab" => (9, ""),
            "End" => (35, ""),
            "Home" => (36, ""),
            "Escape" => (27, ""),
            "ArrowLeft" => (37, ""),
            "ArrowRight" => (39, ""),
            _ => panic!("nobody knows the key {key}"),
        };
        let name = if key == " " { "Space" } else { key };
        let mut event = json!({ "type": "keyDown", "key": key, "code": name, "text": text });
        event["windowsVirtualKeyCode"] = code.into();
        self.tell("Input.dispatchKeyEvent", event.clone());
        event["type"] = "keyUp".into();
        self.tell("Input.dispatchKeyEvent", event);
    }

    /// What has happened since the page was made: the parameters of all events of a kind.
    pub(crate) fn happened(&mut self, method: &str) -> Vec<Value> {
        self.tell("Runtime.evaluate", json!({ "expression": "0" })); // reads what has come in
        let own = self
            .browser
            .events
            .iter()
            .filter(|(session, event)| *session == self.session && event["method"] == method);
        own.map(|(_, event)| event["params"].clone()).collect()
    }

    /// What stands in the console, faults among it.
    pub(crate) fn console(&mut self) -> Vec<String> {
        let kinds = ["Runtime.consoleAPICalled", "Runtime.exceptionThrown", "Log.entryAdded"];
        kinds.iter().flat_map(|kind| self.happened(kind)).map(|event| event.to_string()).collect()
    }
}
