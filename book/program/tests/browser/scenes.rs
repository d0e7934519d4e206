//! The live scenes of the built book in a real browser, with real mouse, fingers and keys.

#[path = "access.rs"]
mod access;
#[path = "driver.rs"]
mod driver;
#[path = "firefox.rs"]
mod firefox;
#[path = "numbers.rs"]
mod numbers;
#[path = "paper.rs"]
mod paper;
#[path = "server.rs"]
mod server;

use super::site;
use driver::{Browser, Page, is_night};
use live::{Control, Form, Kind, Moment, Player, Room, Scene};
use pages::scenes::SCENES;
use serde_json::{Value, json};
use std::env;
use std::ops::{Deref, DerefMut};
use std::sync::OnceLock;

const WIDE: [u32; 2] = [1280, 900];
const PHONE: [u32; 2] = [360, 800];

/// Opens a page in so many tabs, which all stay open. A browser has six connections to a server.
pub(crate) fn open_tabs(address: &str, count: usize) {
    if let Some(mut browser) = Browser::open("tabs") {
        for _ in 0..count {
            let mut page = browser.page(WIDE);
            page.go(address);
            std::mem::forget(page); // its end would close it
        }
    }
}

/// What the tests ask of a page, before its own scripts run.
const EYES: &str = include_str!("eyes.js");

/// A browser; `None`, and said so, where there is none or where no compiler could build the module of the pages.
fn open(name: &str) -> Option<Browser> {
    if !site().join("live-turning.js").is_file() {
        assert!(env::var_os("CI").is_none(), "CI has to have the module of the pages");
        eprintln!("skipped: there is no module, see `BOOK_WASM_RUSTC`");
        return None;
    }
    Browser::open(name)
}

/// The address of the site, served once for all tests.
fn address() -> &'static str {
    static ADDRESS: OnceLock<String> = OnceLock::new();
    ADDRESS.get_or_init(|| server::serve(site().to_owned()))
}

/// A scene of the book, the address of its page, and a script's name for its figure.
struct Place {
    scene: &'static Scene,
    address: String,
    figure: String,
}

fn scenes() -> Vec<Place> {
    let place = |(page, scene): &(&str, &'static Scene)| Place {
        scene,
        address: format!("{}{page}{}.html", address(), if page.contains('/') { "" } else { "/index" }),
        figure: format!("document.getElementById('scene-{}')", scene.name),
    };
    assert!(!SCENES.is_empty());
    SCENES.iter().map(place).collect()
}

/// That of a name.
fn named(name: &str) -> Place {
    scenes().into_iter().find(|place| place.scene.name == name).expect("a scene of this name")
}

/// That of the laundromat.
fn drum() -> Place {
    named("laundromat")
}

impl Place {
    /// A new page for it, with the eyes of the tests, that is still empty.
    fn empty<'a>(&self, browser: &'a mut Browser, size: [u32; 2]) -> Shown<'a> {
        let mut page = browser.page(size);
        page.before_all(EYES);
        Shown { page, scene: self.scene, figure: self.figure.clone() }
    }

    /// Opens an address of its page, goes to the scene and waits until that is awake.
    fn wake(&self, shown: &mut Shown<'_>, address: &str) {
        shown.go(address);
        shown.come_near();
        shown.wait(&format!("{}.classList.contains('awake')", self.figure));
    }

    /// Its page, with the scene awake.
    fn awake<'a>(&self, browser: &'a mut Browser) -> Shown<'a> {
        let mut shown = self.empty(browser, WIDE);
        self.wake(&mut shown, &self.address);
        shown
    }

    /// The scene on its page, from which the text is left out, for a reader who asks for calm: it stands still.
    fn still<'a>(&self, browser: &'a mut Browser, size: [u32; 2], hash: &str) -> Shown<'a> {
        self.calm(browser, size, &format!("{}?alone=scene-{}{hash}", self.address, self.scene.name))
    }

    /// An address of its page for a reader who asks for calm, and all that is folded open.
    fn calm<'a>(&self, browser: &'a mut Browser, size: [u32; 2], address: &str) -> Shown<'a> {
        let mut shown = self.empty(browser, size);
        shown.prefer("prefers-reduced-motion", "reduce");
        self.wake(&mut shown, address);
        shown.get(&format!(
            "{}.querySelectorAll('details').forEach((fold) => {{ fold.open = true; }})",
            self.figure
        ));
        shown.settle();
        shown
    }
}

/// A scene on its page.
struct Shown<'a> {
    page: Page<'a>,
    scene: &'static Scene,
    figure: String,
}

impl<'a> Deref for Shown<'a> {
    type Target = Page<'a>;

    fn deref(&self) -> &Page<'a> {
        &self.page
    }
}

impl<'a> DerefMut for Shown<'a> {
    fn deref_mut(&mut self) -> &mut Page<'a> {
        &mut self.page
    }
}

impl Shown<'_> {
    /// A script's name for a part of the figure.
    fn part(&self, selector: &str) -> String {
        format!("{}.querySelector('{selector}')", self.figure)
    }

    /// The text of a part.
    fn says(&mut self, selector: &str) -> String {
        let part = self.part(selector);
        self.text(&format!("{part}.textContent"))
    }

    /// Clicks on a part by a script, wherever it is.
    fn click(&mut self, selector: &str) {
        let part = self.part(selector);
        self.get(&format!("{part}.click()"));
        self.settle();
    }

    fn come_near(&mut self) {
        let figure = &self.figure;
        let scroll = format!("{figure}.scrollIntoView({{ behavior: 'instant' }})");
        self.get(&scroll);
    }

    /// Goes where no scene is in sight.
    fn go_to_the_end(&mut self) {
        self.get("scrollTo({ top: document.body.scrollHeight, behavior: 'instant' })");
    }

    fn time(&mut self) -> f64 {
        let part = self.part(".time");
        self.number(&format!("{part}.valueAsNumber"))
    }

    /// Waits until the time goes on.
    fn wait_for_motion(&mut self) {
        let (time, part) = (self.time(), self.part(".time"));
        self.wait(&format!("{part}.valueAsNumber !== {time}"));
    }

    /// Waits until the button for playing says so.
    fn wait_for_button(&mut self, word: &str) {
        let part = self.part(".play");
        self.wait(&format!("{part}.textContent === '{word}'"));
    }

    /// How the picture differs from the still, a script that says nothing if it does not.
    fn change(&self) -> String {
        format!("unlike(still({0}), drawn({0}))", self.figure)
    }

    fn wait_for_change(&mut self) {
        let change = self.change();
        self.wait(&format!("{change} !== ''"));
    }

    /// Holds the page to asking for no frame.
    fn asks_for_no_frame(&mut self, why: &str) {
        self.get("frames(5)");
        let asked = self.get("asked");
        self.get("frames(20)");
        assert_eq!(self.get("asked"), asked, "{} asks for frames {why}", self.scene.name);
    }

    /// Of many controls a few are seen at first.
    fn presets_stand_above_the_picture_and_a_few_controls_are_seen(&mut self) {
        let (name, figure) = (self.scene.name, &self.figure);
        let top =
            |selector: &str| format!("{figure}.querySelector('{selector}').getBoundingClientRect().top");
        let [question, presets, drawing] = [".question", ".presets", ".drawing"].map(top);
        let rows = format!(
            "[...{figure}.querySelectorAll('.controls .control')].filter((row) => row.checkVisibility() && !row.querySelector('.kept')).length"
        );
        assert_eq!(self.get(&format!("{question} < {presets} && {presets} < {drawing}")), true, "{name}");
        // To keep a motion is asked below the others, and always seen.
        let is_counted = |control: &&Control| control.kind != Kind::Kept && **control != Control::KEEP;
        let own = self.scene.controls.iter().filter(is_counted).count();
        let rows = self.number(&rows) as usize;
        assert!(if own > 5 { rows <= 4 } else { rows == own }, "{name}: {rows} of {own}");
    }

    fn has_no_faults(&mut self) {
        assert_eq!(self.console(), Vec::<String>::new(), "{}", self.scene.name);
    }

    /// Sets a scene by the page's address, and stops at a time.
    fn set(&mut self, settings: &[(&str, f64)], time: f64) {
        let all: String = settings.iter().map(|(name, value)| format!("{name}={value}&")).collect();
        let hash = format!("#scene-{}?{all}t={time}", self.scene.name);
        // The scene hears of it first, and draws before the frame that is waited for.
        self.get(&format!(
            "new Promise((done) => {{ \
             const next = () => requestAnimationFrame(() => setTimeout(done)); \
             if (location.hash === '{hash}') return next(); \
             addEventListener('hashchange', next, {{ once: true }}); \
             location.hash = '{hash}'; }})"
        ));
    }

    /// The values of the controls as the figure's own link gives them.
    fn values(&mut self) -> Vec<f64> {
        let link = self.part(".share a");
        self.get(&format!("{link}.dispatchEvent(new Event('pointerdown'))"));
        let link = self.text(&format!("{link}.getAttribute('href')"));
        set_by(self.scene, &link)
    }

    /// Holds what the page says beside the picture to what the library says here.
    fn agrees(&mut self) {
        let show = format!("shows({})", self.figure);
        agree(self.scene, &self.page.get(&show));
    }
}

/// Holds what a page shows beside a picture, `shows` of `eyes.js`, to what the library says here; the library's scene.
fn agree(scene: &'static Scene, shown: &Value) -> Option<Player> {
    let text = |place: usize| shown[place].as_str().expect("a text");
    let (values, time, said) = (set_by(scene, text(0)), shown[1].as_f64().expect("a time"), text(2));
    let place = format!("{} at {values:?}, {time} s", scene.name);
    let player = match Player::with(scene, values) {
        Ok(player) => player,
        Err(error) => {
            assert_eq!(said, error.to_string(), "{place}");
            return None;
        }
    };
    let words = player.words(time);
    assert!(alike(said, &words), "{place}: {said:?}, not {words:?}");
    let shown = shown[3].as_array().expect("readings");
    assert_eq!(shown.len(), scene.readings.len(), "{place}");
    // Firefox rounds the time of its slider in the 15th digit, and just there a kick may be given.
    let around = [0.0, -1e-14, 1e-14].map(|part| player.readings(time * (1.0 + part)).expect("readings"));
    for (index, reading) in scene.readings.iter().enumerate() {
        let shown = shown[index].as_str().expect("a text").replace("&nbsp;", "\u{a0}");
        let is_right = |own: &String| {
            // The functions of the two machines differ in the last bit, and so may the last digit that is shown.
            let (one, other) = (number(&shown), number(own));
            let last = match reading.form {
                Form::Fixed(digits) => 1.01 * 10_f64.powi(-(digits as i32)),
                Form::Power(digits) | Form::Digits(digits) => {
                    1.01 * 10_f64.powi(1 - digits as i32) * other.abs() + 1e-9
                }
            };
            shown == *own || (one - other).abs() <= last
        };
        let is_any_right = around.iter().any(|own| is_right(&own[index]));
        assert!(is_any_right, "{place}: {} is {shown}, not {}", reading.words, around[0][index]);
    }
    Some(player)
}

/// The values of a scene's controls that a link sets, and earlier presses behind them.
fn set_by(scene: &Scene, link: &str) -> Vec<f64> {
    let settings = link.split_once('?').expect("settings").1;
    let named: Vec<(&str, &str)> = settings.split('&').filter_map(|part| part.split_once('=')).collect();
    let value = |control: &Control| {
        let own = named.iter().rfind(|(name, _)| *name == control.name);
        own.map_or(control.start, |(_, value)| value.parse().expect("a number"))
    };
    let mut values: Vec<f64> = scene.controls.iter().map(value).collect();
    for (place, control) in scene.controls.iter().enumerate() {
        let mut presses: Vec<_> = named.iter().filter(|(name, _)| *name == control.name).collect();
        presses.pop(); // the last is the value
        for (_, press) in presses {
            let mut all = press.split(',').map(|number| number.parse().expect("a number"));
            values.extend([
                0.0,
                place as f64,
                all.next().unwrap(),
                all.next().unwrap_or(0.0),
                all.next().unwrap_or(0.0),
            ]);
        }
        let kept = named.iter().rfind(|(name, _)| name.strip_prefix("kept.") == Some(control.name));
        if let Some((_, value)) = kept {
            values.extend([1.0, place as f64, value.parse().expect("a number"), 0.0, 0.0]);
        }
    }
    values
}

/// Whether two texts are the same but for the last digit of their numbers.
fn alike(one: &str, other: &str) -> bool {
    let words = |text: &str| text.replace(|letter: char| letter.is_ascii_digit(), "");
    let numbers = |text: &str| {
        let parts = text.split(|letter: char| !letter.is_ascii_digit() && letter != '.');
        parts.filter_map(|part| part.replace('.', "").parse::<i64>().ok()).collect::<Vec<_>>()
    };
    let near = numbers(one).into_iter().zip(numbers(other)).all(|(one, other)| (one - other).abs() <= 1);
    one == other || words(one) == words(other) && numbers(one).len() == numbers(other).len() && near
}

/// A reading as a number; NaN for words.
fn number(reading: &str) -> f64 {
    let plain =
        reading.replace('−', "-").replace("·10<sup>", "e").replace("10<sup>", "1e").replace("</sup>", "");
    let end = plain.find(|letter: char| !"-.e0123456789".contains(letter)).unwrap_or(plain.len());
    plain[..end].parse().unwrap_or(f64::NAN)
}

/// Where an element, or its first line, stands in the window after it has been scrolled to, at a part of its width.
fn place(page: &mut Page<'_>, element: &str, part: f64) -> [f64; 2] {
    let place = page.get(&format!(
        "(() => {{ const e = {element}; e.scrollIntoView({{ block: 'center', behavior: 'instant' }}); \
         const [b] = e.getClientRects(); return [b.left + {part} * b.width, b.top + b.height / 2]; }})()"
    ));
    let place: Vec<f64> = place.as_array().expect("a place").iter().filter_map(Value::as_f64).collect();
    [place[0], place[1]]
}

/// How a reader reaches a control.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Means {
    Mouse,
    Touch,
    Keys,
}

/// By which means, and where on it, a control is operated: the first scene or page answers to all of them, in the
/// others each control has its turn, since all are made alike.
fn in_turn(scene: usize, control: usize) -> Vec<(Means, f64)> {
    let all = [(Means::Mouse, 0.8), (Means::Touch, 0.3), (Means::Keys, 0.0)];
    one_of(scene, control, &all)
}

/// Of the cases of a control one, another in each scene and for each control; all of them in the first scene, and at night.
fn one_of<T: Copy>(scene: usize, control: usize, cases: &[T]) -> Vec<T> {
    if scene == 0 || is_night() || cases.is_empty() {
        return cases.to_vec();
    }
    vec![cases[(scene + control) % cases.len()]]
}

/// Clicks, taps, or strikes a key on an element.
fn act(page: &mut Page<'_>, means: Means, element: &str, part: f64, key: &str) {
    let at = place(page, element, part);
    match means {
        Means::Mouse => page.drag(at, at),
        Means::Touch => page.swipe(at, at),
        Means::Keys => {
            page.get(&format!("{element}.focus({{ preventScroll: true }})"));
            page.key(key);
        }
    }
    page.settle();
}

#[test]
fn scenes_wake_and_move_and_nothing_else_does() {
    let Some(mut browser) = open("wake") else { return };
    for (turn, place) in scenes().into_iter().enumerate() {
        let name = place.scene.name;
        let file = place.address.replace(address(), &format!("file://{}/", site().display()));
        // From a folder the first two, since all modules come alike.
        for page_address in [&place.address, &file].into_iter().take(if turn < 2 { 2 } else { 1 }) {
            let is_file = page_address.starts_with("file:");
            let mut shown = place.empty(&mut browser, WIDE);
            place.wake(&mut shown, page_address);
            shown.wait_for_change();
            shown.wait_for_motion();
            assert_eq!(shown.get("shifted"), json!([]), "{name}: the page jumps");
            // Off the screen it sleeps.
            shown.go_to_the_end();
            shown.asks_for_no_frame("in its sleep");
            let asked = shown.get("asked");
            shown.come_near();
            shown.wait(&format!("asked > {asked}"));
            // A folder is a stranger to the fonts that lie in it: the browser says so, whatever the page does.
            let said = shown.console().into_iter().filter(|line| !(is_file && line.contains(".woff2")));
            assert_eq!(said.collect::<Vec<_>>(), Vec::<String>::new(), "{name}");
            for request in shown.happened("Network.requestWillBeSent") {
                let url = request["request"]["url"].as_str().unwrap_or_default().to_owned();
                let inside = ["data:", "blob:", address(), &format!("file://{}", site().display())];
                assert!(inside.iter().any(|start| url.starts_with(start)), "{name} asks for {url}");
            }
            // What a reader who does not see is told: axe hears the rest.
            let twice = "(() => { const ids = [...document.querySelectorAll('[id]')].map((node) => node.id); return ids.filter((id, index) => ids.indexOf(id) !== index); })()";
            assert_eq!(shown.get(twice), json!([]), "{name}: an id occurs twice");
            // Which scene is heard, the library says.
            let sound = shown.part(".sound");
            let is_heard = Player::new(place.scene).unwrap().sound(place.scene.still).is_some();
            assert_eq!(shown.get(&format!("{sound} !== null")), is_heard, "{name}");
            shown.presets_stand_above_the_picture_and_a_few_controls_are_seen();
            let loud = format!("{}.querySelectorAll('output:not([aria-live=off])').length", place.figure);
            assert_eq!(shown.get(&loud), 0, "{name}: a clock is read aloud");
            let tree = shown.tell("Accessibility.getFullAXTree", json!({}));
            let caption = |node: &&Value| {
                let words = node["name"]["value"].as_str().unwrap_or_default();
                node["role"]["value"] == "figure" && words.starts_with("Scene ")
            };
            let named = tree["nodes"].as_array().expect("nodes").iter().filter(caption).count();
            let figures = shown.number("document.querySelectorAll('figure.scene').length");
            assert_eq!(named as f64, figures, "{name}: its caption names it");
        }
    }
}

#[test]
fn on_the_page_of_all_pages_each_scene_wakes_when_it_comes_near() {
    let Some(mut browser) = open("print") else { return };
    let mut page = browser.page(WIDE);
    page.before_all(EYES);
    page.before_all("window.print = () => {}");
    page.go(&format!("{}print.html", address()));
    page.get("frames(5)");
    assert_eq!(page.get("document.querySelectorAll('figure.scene').length"), scenes().len());
    let awake = page.get("document.querySelectorAll('figure.scene.awake').length");
    assert_eq!(awake, 0, "the first page has none");
    // By day some of them, since all wake alike, and each frame of so long a page takes half a second.
    for Place { scene, figure, .. } in scenes().into_iter().step_by(if is_night() { 1 } else { 6 }) {
        let mut shown = Shown { page, scene, figure };
        shown.come_near();
        shown.wait_for_change();
        page = shown.page;
    }
    assert_eq!(page.console(), Vec::<String>::new());
}

/// Lets a script decide when an element is appended that loads a module: `act` appends it.
fn on_modules(script: &str) -> String {
    format!(
        "const append = Element.prototype.append; Element.prototype.append = function (node, ...more) {{ \
         const act = () => append.call(this, node, ...more); \
         if (node?.src?.includes('/live-')) {{ {script} }} else act(); }}"
    )
}

#[test]
fn modules_that_are_asked_for_at_once_come_to_their_own_scenes() {
    let Some(mut browser) = open("at-once") else { return };
    let mut page = browser.page(WIDE);
    page.before_all(EYES);
    // The first module is on its way for long.
    page.before_all("window.print = () => {}; window.late = 0;");
    page.before_all(&on_modules("if ((late += 1) === 1) setTimeout(act, 500); else act();"));
    // Of two chapters, and both in sight.
    page.go(&format!("{}print.html?alone=scene-speeds,scene-clocks", address()));
    let two = ["speeds", "clocks"].map(|name| named(name).figure);
    for figure in &two {
        page.get(&format!("document.body.prepend({figure})"));
    }
    for figure in &two {
        page.wait(&format!("{figure}.classList.contains('awake')"));
    }
    assert_eq!(page.get("late"), 2);
    assert_eq!(page.console(), Vec::<String>::new());
}

#[test]
fn until_its_module_has_come_a_panel_is_seen_and_cannot_be_operated() {
    let Some(mut browser) = open("loading") else { return };
    let place = scenes().swap_remove(0);
    let mut shown = place.empty(&mut browser, WIDE);
    shown.before_all(&on_modules("window.come = act;"));
    shown.go(&place.address);
    shown.come_near();
    shown.wait("window.come");
    assert!(shown.says(".says").contains("is loading"));
    for selector in [".says", ".controls", ".presets"] {
        let is_seen = format!("{}.checkVisibility({{ visibilityProperty: true }})", shown.part(selector));
        assert_eq!(shown.get(&is_seen), true, "{selector}");
    }
    let figure = &place.figure;
    let asleep = format!(
        "[...{figure}.querySelectorAll('.panel :is(input, button:not(.cover), a)')].every((node) => node.closest('[inert]'))"
    );
    assert_eq!(shown.get(&asleep), true);
    shown.get("come()");
    shown.wait(&format!("{figure}.classList.contains('awake')"));
    shown.settle();
    assert_eq!(shown.get(&format!("{figure}.querySelector('[inert]')")), Value::Null);
    assert!(!shown.says(".says").contains("loading"));
    assert_eq!(shown.get("shifted"), json!([]), "the page jumps");
}

#[test]
fn the_still_is_the_first_picture_and_what_is_printed() {
    let Some(mut browser) = open("still") else { return };
    for (turn, place) in scenes().into_iter().enumerate() {
        let name = place.scene.name;
        for size in one_of(turn, 0, &[WIDE, PHONE]) {
            let mut shown = place.still(&mut browser, size, "");
            let change = shown.change();
            assert_eq!(shown.text(&change), "", "{name}");
            assert_eq!(shown.says(".play"), "Play", "{name}");
            shown.asks_for_no_frame("though the reader has asked for calm");
            // It plays when it is told to, and lies still on paper.
            let play = shown.part(".play");
            act(&mut shown, Means::Mouse, &play, 0.5, "");
            shown.wait_for_change();
            shown.get(&format!("addEventListener('beforeprint', () => (window.onPaper = {change}))"));
            // The first is printed; what a browser tells the others is the same.
            if turn == 0 {
                shown.tell("Page.printToPDF", json!({}));
                shown.wait("typeof onPaper === 'string'");
            } else {
                shown.get("dispatchEvent(new Event('beforeprint'))");
            }
            assert_eq!(shown.text("onPaper"), "", "{name}: paper has the still");
            if turn > 0 {
                shown.get("dispatchEvent(new Event('afterprint'))");
            }
            shown.wait_for_change();
        }
    }
}

#[test]
fn controls_answer_to_mouse_fingers_and_keys_as_the_library_does() {
    let Some(mut browser) = open("controls") else { return };
    for (turn, place) in scenes().into_iter().enumerate() {
        let (scene, figure) = (place.scene, &place.figure);
        let mut shown = place.still(&mut browser, WIDE, "");
        shown.agrees();
        let run = Player::new(scene).unwrap().run();
        shown.set(&[], (run.duration * 300.0).round() / 1000.0);
        for (index, control) in scene.controls.iter().enumerate() {
            for (means, part) in in_turn(turn, index) {
                if let Some((other, [from, _])) = control.when {
                    let part =
                        shown.part(&format!(".controls :is([name={0}], [data-name={0}])", control.name));
                    let is_off = format!("{part}.disabled");
                    let waits = set_by(scene, &format!("?{other}=-1"));
                    let place = scene.controls.iter().position(|own| own.name == other).unwrap();
                    let kind = scene.controls[place].kind;
                    let off =
                        if matches!(kind, Kind::Button(_)) { waits[place] } else { f64::from(from < 1.0) };
                    shown.set(&[(other, off)], 0.0);
                    assert_eq!(shown.get(&is_off), true, "{}: {} is of no use", scene.name, control.name);
                    shown.set(&[(other, from)], (run.duration * 300.0).round() / 1000.0);
                    assert_eq!(shown.get(&is_off), false, "{}: {} is of use", scene.name, control.name);
                }
                let before = shown.values();
                let named = shown.part(&format!(".controls [name={}]", control.name));
                let (element, key) = match control.kind {
                    Kind::Slider { to, .. } | Kind::LogSlider { to, .. } if before[index] >= to => {
                        (named, "ArrowLeft")
                    }
                    Kind::Slider { .. } | Kind::LogSlider { .. } => (named, "ArrowRight"),
                    Kind::Switch => (named, " "),
                    Kind::Button(_) => (named, "Enter"),
                    Kind::Kept => continue,
                    Kind::Choice(choices) => {
                        let next = usize::from(means != Means::Keys);
                        let other = (before[index] as usize + next) % choices.len();
                        let all =
                            format!("{figure}.querySelectorAll('.controls [data-name={}]')", control.name);
                        (format!("{all}[{other}]"), "ArrowRight")
                    }
                };
                act(&mut shown, means, &element, part, key);
                if matches!(control.kind, Kind::Button(_)) {
                    shown.wait_for_button("Pause");
                    shown.click(".play");
                }
                let after = shown.values();
                assert_ne!(before[index], after[index], "{}: {} by {means:?}", scene.name, control.name);
                shown.agrees();
            }
        }
        // Time and view, and the buttons beside them; the book's page is not turned by their keys.
        shown.set(&[], (run.duration * 300.0).round() / 1000.0);
        let others = [".time", ".view [name=azimuth]", ".view [name=elevation]"];
        let others = others.into_iter().filter(|selector| scene.view.is_some() || *selector == ".time");
        for (index, selector) in others.enumerate() {
            let element = shown.part(selector);
            let value = format!("{element}.valueAsNumber");
            for (means, part) in in_turn(turn, index) {
                let before = shown.number(&value);
                act(&mut shown, means, &element, part, "ArrowRight");
                assert_ne!(shown.number(&value), before, "{}: {selector} by {means:?}", scene.name);
                shown.agrees();
            }
        }
        shown.click(".reset");
        shown.set(&[], 0.0);
        let [step, play] = [".step", ".play"].map(|selector| shown.part(selector));
        for (means, key) in [(Means::Mouse, ""), (Means::Touch, ""), (Means::Keys, "Enter")] {
            let before = shown.time();
            act(&mut shown, means, &step, 0.5, key);
            let off = shown.time() - before - run.pace / 10.0;
            assert!(off.abs() < 1e-9 * run.pace, "{}: a step by {means:?}", scene.name);
            for word in ["Pause", "Play"] {
                act(&mut shown, means, &play, 0.5, key);
                shown.wait_for_button(word);
            }
        }
        let starts: Vec<_> = scene.controls.iter().map(|control| (control.name, control.start)).collect();
        for (index, preset) in scene.presets.iter().enumerate() {
            let buttons = format!("{figure}.querySelectorAll('.presets button')");
            act(&mut shown, Means::Mouse, &format!("{buttons}[{index}]"), 0.5, "");
            shown.agrees();
            let pressed = format!("[...{buttons}].map((button) => button.ariaPressed === 'true')");
            let own: Vec<bool> = (0..scene.presets.len()).map(|other| other == index).collect();
            assert_eq!(shown.get(&pressed), json!(own), "{}: its preset", scene.name);
            let description =
                shown.text(&format!("seen({figure}).closest('.drawing').querySelector('desc').textContent"));
            let is_start = preset.settings.iter().all(|setting| starts.contains(setting));
            assert_eq!(description == shown.says(".says"), !is_start, "{}: {description}", scene.name);
        }
        let reset = shown.part(".reset");
        act(&mut shown, Means::Mouse, &reset, 0.5, "");
        assert_eq!(shown.says("desc"), scene.description, "{}", scene.name);
        // A motion that goes round plays on at its end, and one that stops there would begin again.
        let time = shown.part(".time");
        shown.get(&format!("{time}.focus()"));
        shown.key("End");
        shown.settle();
        assert_eq!(shown.says(".play"), "Again", "{}", scene.name);
        shown.click(".reset");
        let starts: Vec<f64> = starts.into_iter().map(|(_, start)| start).collect();
        assert_eq!(shown.values(), starts, "{}", scene.name);
        let page = place.address[address().len() - 1..].to_owned();
        assert_eq!(shown.text("location.pathname"), page, "{}: the page was turned", scene.name);
        shown.has_no_faults();
    }
}

#[test]
fn hands_turn_the_view_and_draw_the_grips() {
    let Some(mut browser) = open("hands") else { return };
    let drawn = |shown: &mut Shown<'_>, means: Means, from: [f64; 2], to: [f64; 2]| {
        match means {
            Means::Mouse => shown.drag(from, to),
            _ => shown.swipe(from, to),
        }
        shown.settle();
    };
    for (turn, place_of) in scenes().into_iter().enumerate() {
        let scene = place_of.scene;
        let mut shown = place_of.still(&mut browser, WIDE, "");
        let mut player = Player::new(scene).unwrap();
        let [azimuth, elevation] = scene.view.unwrap_or_default();
        player.draw(Moment { time: scene.still, azimuth, elevation, room: Room::Wide }).unwrap();
        let picture = format!("seen({})", place_of.figure);
        let cursor = format!("getComputedStyle({}).cursor", shown.part(".drawing"));
        for (index, grip) in player.grips().into_iter().enumerate() {
            for means in one_of(turn, index, &[Means::Mouse, Means::Touch]) {
                shown.click(".reset");
                place(&mut shown, &picture, 0.5);
                let on_screen = |shown: &mut Shown<'_>, x: f64, y: f64| {
                    let point = shown.get(&format!(
                        "(() => {{ const p = new DOMPoint({x}, {y}).matrixTransform({picture}.getScreenCTM()); return [p.x, p.y]; }})()"
                    ));
                    [0, 1].map(|k| point[k].as_f64().expect("a place"))
                };
                let from = on_screen(&mut shown, grip.x, grip.y);
                if means == Means::Mouse {
                    shown.mouse("mouseMoved", from);
                    assert_eq!(shown.text(&cursor), "move", "{}", scene.name);
                }
                // One way it may be at its end.
                let moved = [[30.0, -20.0], [-60.0, 40.0]].into_iter().any(|[x, y]| {
                    let to = on_screen(&mut shown, grip.x + x, grip.y + y);
                    drawn(&mut shown, means, from, to);
                    shown.values() != player.values()
                });
                assert!(moved, "{}: grip {index} by {means:?}", scene.name);
                shown.agrees();
            }
        }
        if scene.view.is_none() {
            continue;
        }
        // A corner, where no grip is. Across, a finger turns the view; up, it moves the page.
        let angle = format!("{}.valueAsNumber", shown.part(".view [name=azimuth]"));
        for means in one_of(turn, 0, &[Means::Mouse, Means::Touch]) {
            let [x, y] = place(&mut shown, &picture, 0.05);
            let before = shown.number(&angle);
            drawn(&mut shown, means, [x, y], [x + 80.0, y]);
            assert_ne!(shown.number(&angle), before, "{}: by {means:?}", scene.name);
        }
        let [x, y] = place(&mut shown, &picture, 0.05);
        let (before, scroll) = (shown.number(&angle), shown.number("scrollY"));
        shown.swipe([x, y], [x, y - 120.0]);
        shown.wait(&format!("scrollY !== {scroll}"));
        assert_eq!(shown.number(&angle), before, "{}", scene.name);
        shown.has_no_faults();
    }
}

#[test]
fn a_link_sets_a_scene_and_a_scene_gives_its_link() {
    let Some(mut browser) = open("links") else { return };
    let mut links = 0;
    for (turn, place) in scenes().into_iter().enumerate() {
        let scene = place.scene;
        // The end of each slider, one after another, is the worst that a link can bring.
        let mut shown = place.still(&mut browser, WIDE, "");
        for (index, control) in scene.controls.iter().enumerate() {
            // Beyond its ends a link finds the nearer one, and a button that was never pressed.
            let cases = match control.kind {
                Kind::Slider { from, to, .. } => vec![(from, from), (to, to), (from - 7.0, from)],
                Kind::LogSlider { from, to, .. } => vec![(from, from), (to, to), (0.0, from)],
                Kind::Choice(choices) => {
                    vec![(0.0, 0.0), (choices.len() as f64 - 1.0, choices.len() as f64 - 1.0)]
                }
                Kind::Switch => vec![(0.0, 0.0), (1.0, 1.0)],
                Kind::Button(_) => vec![(-1.0, -1.0), (0.0, 0.0), (-7.0, -1.0)],
                Kind::Kept => Vec::new(),
            };
            for (asked, given) in one_of(turn, index, &cases) {
                // At the beginning: later, an unstable motion shows how its rounding grew.
                shown.set(&[(control.name, asked)], 0.0);
                shown.agrees();
                let own = |other: &Control| if other.name == control.name { given } else { other.start };
                let expected: Vec<f64> = scene.controls.iter().map(own).collect();
                assert_eq!(shown.values(), expected, "{}: {}={asked}", scene.name, control.name);
            }
        }
        drop(shown);
        // A fresh page opens at the setting that another gave away, and at its scene.
        let first = &scene.controls[0];
        if let Kind::Slider { to: end, .. } | Kind::LogSlider { to: end, .. } = first.kind {
            let hash = format!("#scene-{}?{}={end}&nothing=x&t=0.25", scene.name, first.name);
            let mut shown = place.still(&mut browser, WIDE, &hash);
            assert_eq!(shown.values()[0], end, "{}", scene.name);
            let focused = format!("document.activeElement === {}", place.figure);
            assert_eq!(shown.get(&focused), true, "{}", scene.name);
            shown.agrees();
        }
        // Links in the text. The first is followed twice by the mouse: the second time the page's address does not change.
        let mut shown = place.calm(&mut browser, WIDE, &place.address);
        shown.get("document.querySelectorAll('main > details').forEach((fold) => { fold.open = true; })");
        let text_links = format!(
            "[...document.querySelectorAll('main a[href*=\"#scene-{}?\"]')].filter((link) => !link.closest('.share'))",
            scene.name
        );
        let count = shown.number(&format!("{text_links}.length")) as usize;
        // The press has checked what links name; here the first is followed, and one of the others.
        let others: Vec<usize> = (1..count).collect();
        for index in (0..count.min(1)).chain(one_of(turn, 0, &others)) {
            let link = format!("{text_links}[{index}]");
            for before in [".reset", ".presets button:last-child"].into_iter().skip(usize::from(index > 0)) {
                shown.click(before); // the words below the scene may come to take another line
                if index == 0 {
                    act(&mut shown, Means::Mouse, &link, 0.5, "");
                } else {
                    shown.get(&format!("{link}.click()"));
                    shown.settle();
                }
                if shown.says(".play") == "Pause" {
                    shown.click(".play");
                }
                // What it does not name is at its start, whatever the reader did before.
                let asked = shown.text(&format!("new URL({link}.href).hash"));
                assert_eq!(shown.values(), set_by(scene, &asked), "{}: {asked} after {before}", scene.name);
                shown.agrees();
                links += 1;
            }
        }
    }
    assert!(links > 0, "no link of a text sets its scene");
}

#[test]
fn whatever_breaks_leaves_the_still_and_the_page() {
    let Some(mut browser) = open("broken") else { return };
    let place = scenes().swap_remove(0);
    for (what, script) in [
        (
            "a corrupt module",
            "Object.defineProperty(window, 'spin', { set(take) { this.take = take; }, get() { return (text) => this.take(text.slice(0, 4000)); } })",
        ),
        (
            "no module in its file",
            "Object.defineProperty(window, 'spin', { set() {}, get() { return () => {}; } })",
        ),
        ("an old browser", "delete window.DecompressionStream"),
        (
            "a panic",
            "addEventListener('DOMContentLoaded', () => (document.querySelector('figure.scene').dataset.scene = 999))",
        ),
        ("no file", ""),
    ] {
        let mut shown = place.empty(&mut browser, WIDE);
        shown.before_all(script);
        if script.is_empty() {
            shown.tell("Network.setBlockedURLs", json!({ "urls": ["*/live-*.js"] }));
        }
        shown.go(&place.address);
        shown.wait(&format!("{}.classList.contains('failed')", place.figure));
        let change = shown.change();
        assert_eq!(shown.text(&change), "", "{what}");
        assert_eq!(shown.get(&format!("{}.classList.contains('awake')", place.figure)), false, "{what}");
        assert!(shown.says(".says").contains("cannot move"), "{what}");
        let visible = format!("getComputedStyle({}).visibility", shown.part(".says"));
        assert_eq!(shown.text(&visible), "visible", "{what}");
        let said: Vec<String> =
            shown.console().into_iter().filter(|line| !line.contains("ERR_BLOCKED")).collect();
        assert_eq!(said.len(), 1, "{what}: {said:?}");
        assert_eq!(said[0].contains("no scene 999"), what == "a panic", "{what}: {said:?}");
        shown.get("document.activeElement.blur()");
        shown.key("ArrowRight"); // the book goes on
        shown.wait(&format!("location.href !== '{}'", place.address));
    }
    // Without scripts there is no panel at all.
    let mut page = browser.page(WIDE);
    page.tell("Emulation.setScriptExecutionDisabled", json!({ "value": true }));
    page.go(&place.address);
    let figure = &place.figure;
    assert_eq!(page.text(&format!("getComputedStyle({figure}.querySelector('.panel')).display")), "none");
    assert!(page.number(&format!("{figure}.querySelector('svg').getBoundingClientRect().height")) > 100.0);
}

#[test]
fn a_scene_plays_whatever_a_busy_browser_tells_it_at_once() {
    let Some(mut browser) = open("batch") else { return };
    let place = scenes().swap_remove(0);
    let mut shown = place.empty(&mut browser, WIDE);
    // Each time it hears first that nothing is to be seen, and then what is true by now.
    shown.before_all(
        "window.IntersectionObserver = class extends IntersectionObserver { constructor(act, options) { \
         const none = { isIntersecting: false, intersectionRatio: 0, intersectionRect: new DOMRect() }; \
         super((entries, own) => act([none, ...entries], own), options); } }",
    );
    place.wake(&mut shown, &place.address);
    shown.wait_for_motion();
    shown.wait_for_motion();
    shown.has_no_faults();
}

#[test]
fn settings_without_an_answer_stand_still_and_say_so() {
    let Some(mut browser) = open("trouble") else { return };
    let mut shown = drum().awake(&mut browser);
    shown.wait_for_button("Pause");
    let [spin, play, time] = ["[name=spin]", ".play", ".time"].map(|selector| shown.part(selector));
    let strike = |shown: &mut Shown<'_>, element: &str, key: &str| {
        shown.get(&format!("{element}.focus()"));
        shown.key(key);
        shown.settle();
    };
    let figure = shown.figure.clone();
    shown.get(&format!("{figure}.querySelectorAll('[data-name=motor]')[2].click()"));
    strike(&mut shown, &spin, "Home");
    let said = shown.says(".says");
    assert!(said.contains("turns nothing"), "{said}");
    assert_eq!(shown.says(".play"), "Play");
    assert_eq!(shown.get(&format!("{play}.disabled")), true);
    shown.asks_for_no_frame("though nothing moves");
    // With an answer it goes on.
    strike(&mut shown, &spin, "End");
    shown.wait(&format!("{play}.textContent === 'Pause' && !{play}.disabled"));
    shown.wait_for_motion();
    // While it plays a reader can ask for the time; and escape stops it.
    shown.get("document.activeElement.blur()");
    let told = shown.text(&format!("{time}.ariaValueText"));
    shown.wait(&format!("{time}.ariaValueText !== '{told}'"));
    strike(&mut shown, &play, "Escape");
    shown.wait_for_button("Play");
    shown.has_no_faults();
}

#[test]
fn round_values_of_a_slider_over_powers_of_ten_are_met_by_its_keys() {
    let Some(mut browser) = open("decades") else { return };
    for place in scenes() {
        for (index, control) in place.scene.controls.iter().enumerate() {
            let Kind::LogSlider { from, to, .. } = control.kind else { continue };
            let mut shown = place.still(&mut browser, WIDE, "");
            let tenth = 10_f64.powf((0.5 * (from.log10() + to.log10())).round());
            for (start, key, end) in [
                (1.1 * tenth, "ArrowLeft", tenth),
                (tenth, "ArrowRight", 1.1 * tenth),
                (0.99 * tenth, "ArrowRight", tenth),
                (tenth, "ArrowLeft", 0.99 * tenth),
            ] {
                shown.set(&[(control.name, start)], 0.0);
                let slider = shown.part(&format!(".controls [name={}]", control.name));
                shown.get(&format!("{slider}.focus()"));
                shown.key(key);
                shown.settle();
                let found = shown.values()[index];
                assert!((found / end - 1.0).abs() < 1e-12, "{}: {key} from {start} to {found}", control.name);
            }
        }
    }
}

#[test]
fn a_link_is_copied_where_the_reader_stands_and_a_text_link_moves_no_picture_that_is_in_sight() {
    let Some(mut browser) = open("copy") else { return };
    let drum = drum();
    let mut shown = drum.empty(&mut browser, WIDE);
    shown.before_all(
        "Object.defineProperty(navigator, 'clipboard', { value: { writeText: async (text) => { window.held = text; } } })",
    );
    drum.wake(&mut shown, &drum.address);
    shown.click(".presets button"); // the words may take another line
    let share = shown.part(".share a");
    let at = place(&mut shown, &share, 0.5);
    let scroll = shown.number("scrollY");
    shown.drag(at, at);
    let copied = shown.part(".copied");
    shown.wait(&format!("{copied}.textContent === 'copied'"));
    assert_eq!(shown.get("held === location.href && location.hash.includes('spin=5&t=')"), true);
    assert_eq!(shown.number("scrollY"), scroll);
    assert_eq!(shown.says(".play"), "Pause", "it plays on");
    // A link of the text while the whole picture is in sight.
    let drawing = shown.part(".drawing");
    shown.get(&format!("{drawing}.scrollIntoView({{ block: 'end', behavior: 'instant' }})"));
    shown.settle();
    let scroll = shown.number("scrollY");
    shown.get("document.querySelector('main a[data-set][href*=\"#scene-laundromat?\"]').click()");
    shown.settle();
    assert_eq!(shown.number("scrollY"), scroll);
    // From far down the picture comes to the reader, who stays; the same link once more leads to it, and one step back
    // leads back.
    shown.go_to_the_end();
    shown.settle();
    let below = shown.number("scrollY");
    let link = "[...document.querySelectorAll('main a[data-set]')].at(-1)";
    let click = format!("{{ const link = {link}; link.focus({{ preventScroll: true }}); link.click(); }}");
    let is_beside = format!("{drawing}.matches(':popover-open')");
    // The browser holds what is in sight, should words above it take another line.
    let line = format!("Math.round({link}.getBoundingClientRect().top)");
    let room = format!("{}.getBoundingClientRect().height", drum.figure);
    let (before, height) = (shown.number(&line), shown.number(&room));
    shown.get(&click);
    shown.wait(&is_beside);
    shown.settle();
    assert_eq!(shown.number(&line), before, "nothing moves");
    let off = shown.number(&room) - height;
    assert!(off.abs() < 0.1, "the room of the picture is kept, and {off} px more");
    assert_eq!(shown.get(&format!("document.activeElement === {link}")), true, "the keys go on from there");
    let rect = format!("{drawing}.getBoundingClientRect()");
    let is_whole = format!("{rect}.top >= 0 && {rect}.bottom <= innerHeight && {rect}.height > 100");
    assert_eq!(shown.get(&is_whole), true, "all of the picture is in sight");
    let asked = shown.text(&format!("{link}.hash"));
    assert_eq!(shown.values(), set_by(drum.scene, &asked));
    shown.wait_for_motion();
    shown.key("Escape");
    shown.wait(&format!("!({is_beside})"));
    assert_eq!(shown.number(&line), before);
    shown.get(&click); // the address is the same, and the picture is far away
    shown.wait(&is_beside);
    shown.get(&click);
    shown.wait(&format!("scrollY < {below} - 500 && !({is_beside})"));
    shown.has_no_faults();
}

#[test]
fn a_motion_is_kept_beside_another_by_the_hand_by_a_preset_and_by_a_link() {
    let Some(mut browser) = open("kept") else { return };
    let drum = drum();
    let mut shown = drum.still(&mut browser, WIDE, "");
    shown.set(&[("spin", 22.0), ("kick", 0.5)], 1.0);
    let pale = format!("seen({}).querySelectorAll('.f-pale').length", drum.figure);
    let before = shown.number(&pale);
    let [keep, damper] =
        ["[name=kept]", "[data-name=damper][value=\"1\"]"].map(|selector| shown.part(selector));
    act(&mut shown, Means::Keys, &keep, 0.5, " ");
    assert!(shown.number(&pale) > before + 2.0);
    assert_eq!(shown.says(".kept"), "pale: the same so far");
    act(&mut shown, Means::Mouse, &damper, 0.5, "");
    assert_eq!(shown.says(".kept"), "pale: the whole velocity");
    shown.agrees();
    let all = shown.values();
    let behind = &all[drum.scene.controls.len()..];
    let place = drum.scene.controls.iter().position(|control| control.name == "damper").unwrap() as f64;
    assert_eq!(behind, [1.0, place, 0.0, 0.0, 0.0], "the link has what is kept");
    let link = shown.text(&format!("{}.querySelector('.share a').hash", drum.figure));
    let picture = format!("drawn({})", drum.figure);
    let seen = shown.get(&picture);
    // A preset changes what is compared with it, the reset lets it go.
    shown.click(".presets button");
    assert_eq!(shown.get(&format!("{keep}.checked")), true);
    shown.click(".reset");
    assert_eq!(shown.get(&format!("{keep}.checked")), false);
    assert_eq!((shown.says(".kept").as_str(), shown.number(&pale)), ("", before));
    drop(shown);
    let mut fresh = drum.still(&mut browser, WIDE, &link);
    assert_eq!(fresh.says(".kept"), "pale: the whole velocity");
    assert_eq!(fresh.get(&picture), seen, "whoever is given the link sees both");
    let two = drum.scene.presets.iter().position(|preset| preset.words.contains("two dampers")).unwrap();
    fresh.click(&format!(".presets button:nth-of-type({})", two + 1));
    assert_eq!(fresh.says(".kept"), "pale: the whole velocity");
    fresh.has_no_faults();
}

#[test]
fn a_scene_is_heard_when_it_is_asked_to_and_while_it_plays_in_sight() {
    let Some(mut browser) = open("sound") else { return };
    for place in scenes() {
        let player = Player::new(place.scene).unwrap();
        if player.sound(place.scene.still).is_none() {
            continue;
        }
        let mut shown = place.empty(&mut browser, WIDE);
        shown.before_all(
            "window.tones = []; window.AudioContext = class extends AudioContext { \
               constructor() { super(); tones.push(this); this.ear = this.createAnalyser(); this.ear.fftSize = 32768; \
                 this.ear.smoothingTimeConstant = 0; this.ear.connect(super.destination); } \
               get destination() { return this.ear; } }",
        );
        place.wake(&mut shown, &place.address);
        let sound = shown.part(".sound");
        shown.wait_for_button("Pause");
        assert_eq!(shown.get(&format!("{sound}.ariaPressed")), "false");
        assert_eq!(shown.number("tones.length"), 0.0, "it is off until it is asked for");
        act(&mut shown, Means::Mouse, &sound, 0.5, "");
        assert_eq!(shown.get(&format!("{sound}.ariaPressed")), "true");
        let heard = format!("Number({sound}.dataset.hertz)");
        shown.wait(&format!("{heard} > 0"));
        let both = format!("[{heard}, {}.valueAsNumber]", shown.part(".time"));
        let both = shown.get(&both);
        let [heard_now, time] = [0, 1].map(|k| both[k].as_f64().expect("a number"));
        let own = player.sound(time).expect("a sound").frequency;
        assert!((heard_now / own - 1.0).abs() < 1e-9, "{}: {heard_now} and {own} Hz", place.scene.name);
        // What a small loudspeaker gives of it, dB as the analyser counts.
        shown.wait("tones[0].currentTime > 1.5");
        let level = shown.number(
            "(() => { const { ear, sampleRate } = tones[0], bins = new Float32Array(ear.frequencyBinCount); \
               ear.getFloatFrequencyData(bins); const first = Math.ceil(200 / sampleRate * ear.fftSize); \
               return 10 * Math.log10(bins.slice(first).reduce((sum, bin) => sum + 10 ** (bin / 10), 0)); })()",
        );
        assert!((-55.0..-25.0).contains(&level), "{}: {level} dB above 200 Hz", place.scene.name);
        shown.click(".play");
        assert_eq!(shown.number(&heard), 0.0, "{}: it is heard though it stands", place.scene.name);
        shown.click(".play");
        shown.wait(&format!("{heard} > 0"));
        shown.go_to_the_end();
        shown.wait(&format!("{heard} === 0"));
        shown.come_near();
        shown.wait(&format!("{heard} > 0"));
        shown.click(".sound");
        shown.wait("tones[0].state === 'closed'");
        assert_eq!(shown.get(&format!("{sound}.ariaPressed")), "false");
        shown.has_no_faults();
    }
}

#[test]
fn a_body_is_drawn_by_the_mouse_and_lets_the_page_scroll_beside_it() {
    let Some(mut browser) = open("bodies") else { return };
    for name in ["rolling-wheel", "spinning-coin", "top"] {
        let place_of = named(name);
        let mut shown = place_of.still(&mut browser, WIDE, "");
        let mut player = Player::new(place_of.scene).unwrap();
        let [azimuth, elevation] = place_of.scene.view.unwrap();
        player.draw(Moment { time: place_of.scene.still, azimuth, elevation, room: Room::Wide }).unwrap();
        let body = player.bodies()[0].0;
        let picture = format!("seen({})", place_of.figure);
        place(&mut shown, &picture, 0.5);
        let point = shown.get(&format!(
            "(() => {{ const p = new DOMPoint({}, {}).matrixTransform({picture}.getScreenCTM()); return [p.x, p.y]; }})()",
            body.x + 4.0,
            body.y + 3.0
        ));
        let from = [0, 1].map(|k| point[k].as_f64().expect("a place"));
        shown.mouse("mouseMoved", from);
        let cursor = format!("getComputedStyle({}).cursor", shown.part(".drawing"));
        assert_eq!(shown.text(&cursor), "move", "{name}");
        let before = shown.values();
        shown.drag(from, from);
        shown.settle();
        assert_eq!(shown.values(), before, "{name}: a touch changes something");
        for [x, y] in [[20.0, 30.0], [-40.0, -10.0]] {
            shown.swipe(from, [from[0] + x, from[1] + y]); // one way may lead along the same lean
            shown.settle();
        }
        let after = shown.values();
        let changed: Vec<_> = (0..before.len()).filter(|&k| before[k] != after[k]).collect();
        let names: Vec<_> = changed.iter().map(|&k| place_of.scene.controls[k].name).collect();
        let control = if name == "rolling-wheel" { "lean" } else { "tilt" };
        assert!(names.contains(&control), "{name}: {names:?}");
        shown.agrees();
        shown.has_no_faults();
    }
}

#[test]
fn a_tub_that_is_pulled_waits_for_the_hand_and_one_pull_adds_to_another() {
    let Some(mut browser) = open("pulls") else { return };
    let drum = drum();
    let mut shown = drum.still(&mut browser, WIDE, "");
    let picture = format!("seen({})", drum.figure);
    let time = format!("Number({}.value)", shown.part(".time"));
    for count in 1..=2 {
        let now = shown.number(&time);
        let values = shown.values();
        let mut player = Player::with(drum.scene, values).unwrap();
        let [azimuth, elevation] = drum.scene.view.unwrap();
        player.draw(Moment { time: now, azimuth, elevation, room: Room::Wide }).unwrap();
        let body = player.bodies()[0].0;
        place(&mut shown, &picture, 0.5);
        let point = shown.get(&format!(
            "(() => {{ const p = new DOMPoint({}, {}).matrixTransform({picture}.getScreenCTM()); return [p.x, p.y]; }})()",
            body.x, body.y
        ));
        let from = [0, 1].map(|k| point[k].as_f64().expect("a place"));
        let [before, after] = [shown.values(), {
            shown.swipe(from, [from[0] + 30.0, from[1] + 8.0]);
            shown.wait_for_button("Pause");
            shown.wait(&format!("{time} > {now}")); // it is let go, and goes on
            shown.click(".play");
            shown.settle();
            shown.values()
        }];
        let kick = drum.scene.controls.iter().position(|control| control.name == "kick").unwrap();
        assert_ne!(before[kick], after[kick]);
        assert!((after[kick] - now).abs() < 1e-5, "pulled at {now}, not at {}", after[kick]);
        assert_eq!(after.len(), drum.scene.controls.len() + 5 * (count - 1), "{after:?}");
        shown.agrees();
    }
    shown.has_no_faults();
}

#[test]
fn a_reader_who_asks_for_calm_sees_what_a_preset_is_about() {
    let Some(mut browser) = open("calm") else { return };
    let drum = drum();
    let mut shown = drum.still(&mut browser, WIDE, "");
    let place = drum.scene.presets.iter().position(|preset| preset.words.contains("from rest"));
    let place = place.expect("a preset") + 1;
    shown.click(&format!(".presets button:nth-of-type({place})"));
    let (now, time) = (shown.time(), shown.part(".time"));
    let end = shown.number(&format!("Number({time}.max)"));
    assert!((now / end - 0.5).abs() < 1e-9, "at {now} of {end} s it is nearly at rest");
    shown.agrees();
}

#[test]
fn arrow_keys_step_the_time_of_a_scene_and_turn_no_page() {
    let Some(mut browser) = open("arrows") else { return };
    for place in scenes().into_iter().take(3) {
        let pace = Player::new(place.scene).unwrap().run().pace;
        let mut shown = place.still(&mut browser, WIDE, "");
        let address = shown.text("location.pathname");
        for selector in [".play", ".step", ".reset", ".presets button", ".more summary", ".share a"] {
            let part = shown.part(selector);
            if shown.get(&format!("{part} === null")) == true {
                continue;
            }
            shown.set(&[], 0.5 * pace);
            shown.get(&format!("{part}.focus()"));
            for (key, way) in [("ArrowRight", 1.0), ("ArrowLeft", -1.0)] {
                let before = shown.time();
                shown.key(key);
                shown.settle();
                let off = shown.time() - before - 0.1 * way * pace;
                assert!(off.abs() < 1e-9, "{}: {key} on {selector}", place.scene.name);
            }
        }
        // A choice of the pace belongs to its list.
        let list = shown.part(".pace");
        shown.get(&format!("{list}.focus()"));
        shown.key("ArrowLeft");
        assert_eq!(shown.text("location.pathname"), address, "{}: the page was turned", place.scene.name);
        shown.has_no_faults();
    }
}

#[test]
fn nothing_moves_on_the_page_whatever_a_scene_is_set_to() {
    let Some(mut browser) = open("heights") else { return };
    let mut moved = Vec::new();
    for (turn, place) in scenes().into_iter().enumerate() {
        for size in one_of(turn, 0, &[[360, 740], [1366, 768]]) {
            let mut shown = place.still(&mut browser, size, "");
            let height = format!("Math.round({}.getBoundingClientRect().height)", place.figure);
            let before = shown.number(&height);
            let mut held = |shown: &mut Shown<'_>, what: &str| {
                let after = shown.number(&height);
                if after != before {
                    moved.push(format!("{} at {size:?}, {what}: {before} and {after} px", place.scene.name));
                }
            };
            for (index, preset) in place.scene.presets.iter().enumerate() {
                shown.click(&format!(".presets button:nth-of-type({})", index + 1));
                held(&mut shown, preset.words);
            }
            for (index, control) in place.scene.controls.iter().enumerate() {
                if let Kind::Slider { from, to, .. } | Kind::LogSlider { from, to, .. } = control.kind {
                    for value in one_of(turn, index, &[from, 0.5 * (from + to), to]) {
                        shown.set(&[(control.name, value)], 0.0);
                        held(&mut shown, control.name);
                    }
                }
            }
        }
    }
    assert!(moved.is_empty(), "{moved:#?}");
}

#[test]
fn what_is_far_from_a_scene_that_plays_is_spared_and_stays_where_it_is() {
    let Some(mut browser) = open("far") else { return };
    // Where each part of the page begins and how high it is; and the end of the page.
    let boxes = "[...document.querySelectorAll('main > *')].flatMap((part) => { \
                 const box = part.getBoundingClientRect(); return [box.top + scrollY, box.height]; }) \
                 .concat(document.documentElement.scrollHeight)";
    let numbers = |shown: &mut Shown<'_>| -> Vec<f64> {
        shown.get(boxes).as_array().expect("boxes").iter().filter_map(Value::as_f64).collect()
    };
    for name in ["laundromat", "rolling-wheel", "clocks"] {
        let place = named(name);
        for size in [WIDE, PHONE] {
            let mut shown = place.empty(&mut browser, size);
            shown.prefer("prefers-reduced-motion", "reduce");
            place.wake(&mut shown, &place.address);
            shown.settle();
            let before = numbers(&mut shown);
            shown.click(".play");
            shown.wait_for_motion();
            let spared =
                |shown: &mut Shown<'_>| shown.number("document.querySelectorAll('main > .far').length");
            assert_eq!(spared(&mut shown), 0.0, "{name}: nobody has touched the page");
            shown.mouse("mouseMoved", [5.0, 5.0]);
            shown.settle();
            let after = numbers(&mut shown);
            assert_eq!(before.len(), after.len(), "{name}");
            let off = before.iter().zip(&after).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max);
            assert!(off < 0.5, "{name} at {size:?}: {off} px");
            assert!(spared(&mut shown) > 50.0, "{name}");
            // They are there when the reader comes.
            shown.go_to_the_end();
            shown.settle();
            let end = "document.querySelector('main > :last-child')";
            assert_eq!(shown.get(&format!("{end}.matches('.far')")), false, "{name}");
            assert!(spared(&mut shown) > 50.0, "{name}");
            let off = shown.number(&format!("{end}.getBoundingClientRect().bottom - innerHeight"));
            assert!(off < 0.0, "{name} at {size:?}: the end is {off} px too low");
            shown.has_no_faults();
        }
    }
}

#[test]
fn a_scene_says_how_fast_its_time_goes_and_can_be_slowed() {
    let Some(mut browser) = open("pace") else { return };
    let mut shown = drum().still(&mut browser, WIDE, "");
    let list = shown.part(".pace");
    let says = format!("{list}.selectedOptions[0].text");
    assert_eq!(shown.text(&says), "slowed 6.7 times");
    shown.set(&[], 0.0);
    shown.get(&format!("{list}.value = '0.5'"));
    assert_eq!(shown.text(&says), "slowed 13 times");
    shown.click(".step");
    assert!((shown.time() - 0.5 * 0.15 / 10.0).abs() < 1e-9);
    shown.set(&[("motor", 1.0)], 0.0);
    assert_eq!(shown.text(&says), "slowed 2 times");
    assert_eq!(shown.text(&format!("{list}.options[3].text")), "2 times as fast");
    // And so it plays.
    let rate = |shown: &mut Shown<'_>, value: f64| {
        shown.set(&[("motor", 1.0)], 0.0);
        shown.get(&format!("{list}.value = '{value}'"));
        shown.click(".play");
        shown.get("new Promise((done) => setTimeout(done, 1500))");
        shown.click(".play");
        shown.time()
    };
    let [slow, fast] = [0.25, 2.0].map(|value| rate(&mut shown, value));
    assert!(fast > 3.0 * slow && slow > 0.0, "{slow} and {fast} s");
    shown.has_no_faults();
}

#[test]
fn a_kick_adds_to_the_motion_as_it_is_and_a_slider_does_not_throw_the_body() {
    let Some(mut browser) = open("adds") else { return };
    for (name, button, controls) in [
        ("rolling-wheel", "kick", [("push", 0.4), ("lean", 30.0)]),
        ("laundromat", "kick", [("camera", 0.0), ("spin", 22.0)]),
        ("space-station", "fire", [("thruster", 90.0), ("impulse", 2.0)]),
    ] {
        let place = named(name);
        let mut shown = place.still(&mut browser, WIDE, "");
        shown.set(&[&controls[..], &[(button, 0.5)]].concat(), 0.8);
        let readings = format!(
            "[...{}.querySelectorAll('.readings dd')].map((dd) => dd.textContent).join()",
            place.figure
        );
        let (past, time) = (shown.text(&readings), shown.part(".time"));
        let seek = |shown: &mut Shown<'_>, to: f64| {
            shown.get(&format!("{time}.value = {to}; {time}.dispatchEvent(new Event('input'))"));
            shown.settle();
            shown.settle();
        };
        seek(&mut shown, 1.5);
        shown.get(&format!("{}.querySelector('[name={button}]').click()", place.figure));
        shown.wait_for_button("Pause");
        shown.click(".play");
        seek(&mut shown, 0.8);
        assert_eq!(shown.text(&readings), past, "{name}: the past has changed");
        seek(&mut shown, 2.5);
        shown.agrees();
        let (values, now) = (shown.values(), shown.text(&readings));
        assert_eq!(values.len(), place.scene.controls.len() + 5, "{name}: {values:?}");
        let once = Player::with(place.scene, values[..place.scene.controls.len()].to_vec()).unwrap();
        let both = Player::with(place.scene, values.clone()).unwrap();
        assert_ne!(
            once.readings(2.5).unwrap(),
            both.readings(2.5).unwrap(),
            "{name}: the first is forgotten"
        );
        // Whoever is given the link has both.
        let link = shown.text(&format!("{}.querySelector('.share a').hash", place.figure));
        drop(shown);
        let mut other = place.still(&mut browser, WIDE, &link);
        assert_eq!((other.values(), other.text(&readings)), (values, now), "{name}: {link}");
        other.has_no_faults();
    }
    // The stripes of the drum, and of a wheel that nobody has kicked, stay where they are.
    for (name, slider, settings) in
        [("laundromat", "spin", &[][..]), ("rolling-wheel", "lean", &[("kick", -1.0)])]
    {
        let place = named(name);
        let mut shown = place.still(&mut browser, WIDE, "");
        shown.set(settings, 6.0);
        let corners = format!(
            "[...seen({}).querySelectorAll('path.f-face')].slice(0, 4).map((node) => {{ \
             const box = node.getBBox(); return [box.x, box.y]; }}).flat()",
            place.figure
        );
        let places = |shown: &mut Shown<'_>| -> Vec<f64> {
            shown.get(&corners).as_array().expect("places").iter().filter_map(Value::as_f64).collect()
        };
        let before = places(&mut shown);
        let element = shown.part(&format!("[name={slider}]"));
        shown.get(&format!("{element}.focus()"));
        shown.key("ArrowRight");
        shown.settle();
        let after = places(&mut shown);
        assert_eq!(before.len(), after.len(), "{name}");
        let off = before.iter().zip(&after).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max);
        assert!(!before.is_empty() && off < 6.0, "{name}: {before:?} and {after:?}");
        shown.agrees();
    }
}

#[test]
fn the_answer_is_covered_until_a_reader_has_guessed_or_asks_for_it() {
    let Some(mut browser) = open("cover") else { return };
    let drum = drum();
    let fresh = |shown: &mut Shown<'_>| {
        shown.go("about:blank");
        drum.wake(shown, &drum.address);
        shown.settle();
    };
    let mut shown = drum.empty(&mut browser, WIDE);
    shown.prefer("prefers-reduced-motion", "reduce");
    let parts = [".says", ".readings dd", "[id*=-answer]"].map(|selector| shown.part(selector));
    let seen = parts.map(|part| format!("getComputedStyle({part}).visibility === 'visible'"));
    let is_seen = |shown: &mut Shown<'_>| [0, 1, 2].map(|k| shown.get(&seen[k]) == true);
    let guess = "document.querySelector('main > ol.guess button')";
    for act in [format!("{guess}.click()"), format!("{}.click()", shown.part(".cover"))] {
        fresh(&mut shown);
        assert_eq!(is_seen(&mut shown), [false; 3]);
        shown.tell("Emulation.setEmulatedMedia", json!({ "media": "print" }));
        assert!(is_seen(&mut shown)[2], "paper shows all");
        shown.tell("Emulation.setEmulatedMedia", json!({ "media": "" }));
        shown.get(&act);
        shown.settle();
        assert_eq!(is_seen(&mut shown), [true; 3], "{act}");
        let is_shown = format!("getComputedStyle({}).display", shown.part(".cover"));
        assert_eq!(shown.text(&is_shown), "none");
    }
    // A link names a setting that the text explains: whoever follows it sees all.
    fresh(&mut shown);
    shown.set(&[("spin", 5.0)], 0.0);
    assert_eq!(is_seen(&mut shown), [true; 3]);
    shown.tell("Emulation.setScriptExecutionDisabled", json!({ "value": true }));
    shown.go(&drum.address);
    shown.tell("Emulation.setScriptExecutionDisabled", json!({ "value": false }));
    assert!(is_seen(&mut shown)[2], "without a script nothing is hidden");
}
