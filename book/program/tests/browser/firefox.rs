//! The pages in Firefox, which sets formulas otherwise than Chromium. It is driven by its own protocol, Marionette:
//! JSON over a socket, each message behind its length.

use super::access::{AUDIT, PHONE, names};
use super::driver::{Browser, is_night};
use super::{EYES, Place, address, agree, scenes, site};
use live::{Moment, Room};
use serde_json::{Value, json};
use std::collections::BTreeMap;
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
            program
                .args([
                    "--headless",
                    "--marionette",
                    "--remote-allow-system-access",
                    "--no-remote",
                    "--profile",
                ])
                .arg(&profile);
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

    /// The value of an expression in the page; a promise is waited for.
    fn get(&mut self, expression: &str) -> Value {
        let script = json!({ "script": format!("return {expression};"), "args": [] });
        self.ask("WebDriver:ExecuteScript", &script)
    }

    fn wait(&mut self, expression: &str) {
        let begun = Instant::now();
        while self.get(&format!("Boolean({expression})")) != true {
            assert!(begun.elapsed() < PATIENCE, "never: {expression}");
            thread::sleep(Duration::from_millis(10));
        }
    }

    /// The value of an expression in the browser itself.
    fn of_browser(&mut self, expression: &str) -> Value {
        self.ask("Marionette:SetContext", &json!({ "value": "chrome" }));
        let value = self.get(expression);
        self.ask("Marionette:SetContext", &json!({ "value": "content" }));
        value
    }

    /// Gives its pages a width, px; its window has none so small.
    fn be_as_wide_as(&mut self, width: u32) {
        self.ask("WebDriver:SetWindowRect", &json!({ "width": 1300, "height": 1000 }));
        self.of_browser(&format!("void (gBrowser.selectedBrowser.style.maxWidth = '{width}px')"));
    }

    /// The errors of the pages of the site. Of a formula that has come in part only it speaks too soon.
    fn errors(&mut self) -> Vec<String> {
        let found = self.of_browser(&format!(
            "Services.console.getMessageArray().filter((said) => said instanceof Ci.nsIScriptError \
             && !(said.flags & Ci.nsIScriptError.warningFlag) && said.sourceName.startsWith('{}') \
             && !said.message.includes('Invalid markup')).map((said) => said.message)",
            address()
        ));
        found.as_array().expect("errors").iter().map(Value::to_string).collect()
    }

    /// Holds a scene to waking, playing, and showing what the library shows, as it comes and with a preset.
    fn plays(&mut self, place: &Place) {
        let Place { scene, figure, .. } = place;
        let mut pictures = Vec::new();
        self.get("void (window.svgs = [...document.querySelectorAll('figure.scene .drawing > svg')])");
        self.get(&format!("{figure}.scrollIntoView({{ behavior: 'instant' }})"));
        self.wait(&format!("{figure}.classList.contains('awake')"));
        for preset in [false, true] {
            if preset {
                self.get(&format!("[...{figure}.querySelectorAll('.presets button')].at(-1).click()"));
                self.wait(&format!(
                    "{figure}.querySelector('.presets button:last-of-type').ariaPressed === 'true'"
                ));
            }
            let time = self.get(&format!("{figure}.querySelector('.time').valueAsNumber"));
            self.wait(&format!("{figure}.querySelector('.time').valueAsNumber !== {time}"));
            self.get(&format!("{figure}.querySelector('.play').click()"));
            self.wait(&format!("{figure}.querySelector('.play').textContent !== 'Pause'"));
            self.get("frames(3)");
            let shown = self.get(&format!("shows({figure})"));
            let Some(mut player) = agree(scene, &shown) else { panic!("{}: no picture", scene.name) };
            let [azimuth, elevation] = scene.view.unwrap_or_default();
            let time = shown[1].as_f64().expect("a time");
            let drawn = format!("drawn({figure}).filter((line) => !/^<(title|desc)/.test(line))");
            // Of two points of a line that lie equally far from its chord rounding keeps one: a moment later, the other.
            let mut changes = [0.0, 1e-12, -1e-12, 1e-11, -1e-11, 1e-10, -1e-10].into_iter().map(|moment| {
                let moment = Moment { time: time + moment, azimuth, elevation, room: Room::Narrow };
                let behind = player.behind(moment.room).expect("what stands behind");
                let own = behind + &player.elements(moment).expect("a picture");
                self.get(&format!("unlike(parsed({}), {drawn})", json!(own)))
            });
            let first = changes.next().expect("a comparison");
            let is_alike = first == "" || changes.any(|change| change == "");
            assert!(is_alike, "{} at {}: {first}", scene.name, shown[0]);
            pictures.push(self.get(&drawn));
        }
        assert_ne!(pictures[0], pictures[1], "{}: its preset", scene.name);
    }
}

impl Drop for Firefox {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
        let _ = fs::remove_dir_all(&self.profile);
    }
}

/// The formulas of a page: their words, whether they stand alone and how wide they are, and the size of each of their letters.
const FORMULAS: &str = "[...document.querySelectorAll('main math')]
    .filter((math) => !math.closest('figure.scene, .answers') && math.getClientRects().length > 0)
    .map((math) => {
        const letters = [...math.querySelectorAll('mi, mn, mo, mtext')].filter((letter) => letter.getClientRects().length > 0);
        const sizes = letters.map((letter) => parseFloat(getComputedStyle(letter).fontSize));
        return [math.textContent, math.getAttribute('display') === 'block', math.getBoundingClientRect().width, sizes];
    })";
/// How much wider a formula may be in another browser, px and of its width: they space dots and operators otherwise.
const SPACING: [f64; 2] = [6.0, 0.1];
/// Smaller than this, px, Firefox makes no index of an index.
const SMALLEST: f64 = 10.67;

/// What is wrong with a page that is open: what is cut off, out of order, untold, or a formula that is no MathML.
const FAULTS: &str = "[...wide(), ...disordered(), ...untold(),
    ...[...document.querySelectorAll('msub, msup, mfrac, mover, munder, mroot')].filter((math) => math.children.length !== 2).map(named)]";

/// The formulas of all pages as Chromium sets them on a phone.
fn formulas_in_chromium(names: &[String]) -> BTreeMap<String, Value> {
    let Some(mut browser) = Browser::open("formulas") else { return BTreeMap::new() };
    let mut page = browser.page([PHONE, 900]);
    page.before_all(AUDIT);
    let measure = |name: &String| {
        page.go(&format!("{}{name}", address()));
        page.get("document.fonts.ready.then(() => wide().length)"); // all that folds is open
        (name.clone(), page.get(FORMULAS))
    };
    names.iter().map(measure).collect()
}

/// How formulas differ in two browsers.
fn unlike(one: &Value, other: &Value) -> Vec<String> {
    let all = |formulas: &Value| formulas.as_array().expect("formulas").clone();
    let (one, other) = (all(one), all(other));
    if one.len() != other.len() {
        return vec![format!("{} formulas and {}", one.len(), other.len())];
    }
    let sizes = |formula: &Value| -> Vec<f64> {
        formula[3].as_array().expect("sizes").iter().filter_map(Value::as_f64).collect()
    };
    let is_size = |(one, other): (&f64, &f64)| (one - other).abs() < 0.1 || one.max(*other) <= SMALLEST;
    let is_like = |one: &Value, other: &Value| {
        let [width, expected] = [one, other].map(|formula| formula[2].as_f64().expect("a width"));
        let is_wide = one[1] == true && (width - expected).abs() > SPACING[0] + SPACING[1] * expected;
        let (one, other) = (sizes(one), sizes(other));
        !is_wide && one.len() == other.len() && one.iter().zip(&other).all(is_size)
    };
    let pairs = one.iter().zip(&other).filter(|(one, other)| !is_like(one, other));
    pairs.map(|(one, other)| format!("{one}, and in Chromium {other}")).collect()
}

#[test]
fn every_page_and_every_scene_is_in_firefox_what_it_is_in_chromium() {
    let names = names();
    assert!(names.len() > 60);
    let Some(mut firefox) = Firefox::open() else { return };
    let (_, site) = (address(), site());
    let is_live = site.join("live-turning.js").is_file();
    let faults: Vec<String> = thread::scope(|scope| {
        let chromium = scope.spawn(|| formulas_in_chromium(&names));
        let mut faults = Vec::new();
        let mut formulas = BTreeMap::new();
        firefox.be_as_wide_as(PHONE);
        for name in &names {
            let fault = |what: &str| format!("{name}: {what}");
            let page = format!("{}{name}", address());
            firefox.ask("WebDriver:Navigate", &json!({ "url": page }));
            firefox.get(&format!("(() => {{ {AUDIT}; window.named = named; {EYES}; }})()"));
            assert_eq!(firefox.get("innerWidth"), PHONE, "the phone is narrow");
            let found = firefox.get(&format!("document.fonts.ready.then(() => {FAULTS})"));
            faults.extend(found.as_array().expect("faults").iter().filter_map(Value::as_str).map(fault));
            formulas.insert(name, firefox.get(FORMULAS));
            for (turn, place) in scenes().iter().enumerate() {
                // By day every third, since all are moved by one script.
                if is_live && place.address == page && (turn % 3 == 0 || is_night()) {
                    firefox.plays(place);
                }
            }
        }
        faults.extend(firefox.errors());
        let chromium = chromium.join().expect("Chromium answers");
        assert!(formulas.values().filter_map(|all| all.as_array().map(Vec::len)).sum::<usize>() > 5000);
        for (name, own) in &formulas {
            let expected = chromium.get(*name).into_iter();
            faults
                .extend(expected.flat_map(|other| unlike(own, other)).map(|what| format!("{name}: {what}")));
        }
        faults
    });
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}
