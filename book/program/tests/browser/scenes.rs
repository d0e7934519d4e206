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
use driver::{Browser, Page};
use live::{Form, Kind, Moment, Player, Room, Scene};
use pages::scenes::SCENES;
use serde_json::{Value, json};
use std::env;
use std::sync::OnceLock;

const WIDE: [u32; 2] = [1280, 900];
const PHONE: [u32; 2] = [360, 800];

/// Opens a page in so many tabs, which all stay open. A browser has six connections to a server.
pub(crate) fn open_tabs(address: &str, count: usize) {
    if let Some(mut browser) = Browser::open("tabs") {
        (0..count).for_each(|_| browser.page(WIDE).go(address));
    }
}

/// What the tests ask of a page, before its own scripts run.
const EYES: &str = r#"
addEventListener('DOMContentLoaded', () => {
  window.svgs = [...document.querySelectorAll('figure.scene .drawing > svg')];
  window.stills = svgs.map(lines);
});
window.lines = (svg) => [...svg.children].map((node) => node.outerHTML);
window.seen = (figure) => svgs.find((svg) => figure.contains(svg) && svg.getClientRects().length > 0);
// Whether two drawings are the same up to a fiftieth of a pixel, and if not the first line that differs.
window.unlike = (one, other) => {
  const number = /-?\d+(\.\d+)?/g;
  if (one.length !== other.length) return `${one.length} elements and ${other.length}`;
  // A curve may be drawn with a point more or less: the functions of two machines differ in the last bit. An element
  // may hold several curves, each of which is compared with its own.
  const curves = (line) => {
    const node = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    const parts = (/ d="([^"]*)"/.exec(line)?.[1] ?? '').split(/(?=[Mm])/);
    const ends = parts.map((part, k) => {
      node.setAttribute('d', parts.slice(0, k + 1).join(''));
      return node.getTotalLength();
    });
    return ends.map((end, k) => {
      const start = ends[k - 1] ?? 0;
      return { length: end - start, at: (part) => node.getPointAtLength(start + part * (end - start)) };
    });
  };
  const isAlong = (x, y) => [...Array(50).keys()].every((k) => {
    const [p, q] = [x.at((k + 0.5) / 50), y.at((k + 0.5) / 50)];
    return Math.hypot(p.x - q.x, p.y - q.y) < 1;
  });
  const isNear = (a, b) => {
    if (a.replace(/ d="[^"]*"/, '') !== b.replace(/ d="[^"]*"/, '')) return false;
    const [x, y] = [curves(a), curves(b)];
    const isLike = (one, other) => Math.abs(one.length - other.length) < 0.005 * one.length + 0.02 && isAlong(one, other);
    return x.length === y.length && x.every((one, k) => isLike(one, y[k]));
  };
  return one.map((line, index) => [line, other[index]]).find(([a, b]) => {
    const [x, y] = [a, b].map((line) => (line.match(number) ?? []).map(Number));
    const isSame = a.replace(number, '') === b.replace(number, '') && x.every((value, k) => Math.abs(value - y[k]) < 0.0201);
    return !isSame && !isNear(a, b);
  })?.join('\n') ?? '';
};
window.still = (figure) => stills[svgs.indexOf(seen(figure))];
window.drawn = (figure) => lines(seen(figure));
window.asked = 0;
const ask = requestAnimationFrame.bind(window);
window.requestAnimationFrame = (act) => { asked += 1; return ask(act); };
window.frames = async (count) => { for (let k = 0; k < count; k += 1) await new Promise(ask); };
window.shifted = [];
new PerformanceObserver((list) => {
  for (const { node } of list.getEntries().flatMap((entry) => entry.sources)) {
    const isBlock = node?.nodeType === 1 && !node.closest('dd, output, math');
    if (isBlock && node.parentElement.closest('figure.scene')) shifted.push(`${node.nodeName} ${node.className}`);
  }
}).observe({ type: 'layout-shift', buffered: true });
"#;

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

/// The scenes of the book, their pages, and a script's name for their figure.
fn scenes() -> Vec<(&'static Scene, String, String)> {
    let found: Vec<_> = SCENES
        .iter()
        .map(|(chapter, scene)| {
            let figure = format!("document.getElementById('scene-{}')", scene.name);
            (*scene, format!("{}{chapter}/index.html", address()), figure)
        })
        .collect();
    assert!(!found.is_empty());
    found
}

/// Opens a page, goes to its scene and waits until that is awake.
fn wake(page: &mut Page<'_>, page_address: &str, figure: &str) {
    page.go(page_address);
    page.get(&format!("{figure}.scrollIntoView({{ behavior: 'instant' }})"));
    page.wait(&format!("{figure}.classList.contains('awake')"));
}

/// The same, and stops it.
fn wake_still(page: &mut Page<'_>, page_address: &str, figure: &str) {
    page.prefer("prefers-reduced-motion", "reduce");
    wake(page, page_address, figure);
    page.settle();
}

/// Sets a scene by the page's address, and stops at a time.
fn set(page: &mut Page<'_>, scene: &Scene, settings: &[(&str, f64)], time: f64) {
    let all: String = settings.iter().map(|(name, value)| format!("{name}={value}&")).collect();
    page.get(&format!("location.hash = '#scene-{}?{all}t={time}'", scene.name));
    page.settle();
    page.settle();
}

/// The values of the controls of a figure as its own link gives them, and the time.
fn settings(page: &mut Page<'_>, scene: &Scene, figure: &str) -> (Vec<f64>, f64) {
    let link = format!("{figure}.querySelector('.share a')");
    page.get(&format!("{link}.dispatchEvent(new Event('pointerdown'))"));
    let link = page.text(&format!("{link}.getAttribute('href')"));
    let named: Vec<(&str, f64)> = link
        .split_once('?')
        .expect("settings")
        .1
        .split('&')
        .map(|setting| setting.split_once('=').expect("a setting"))
        .map(|(name, value)| (name, value.parse().expect("a number")))
        .collect();
    let value =
        |name, start| named.iter().find(|(other, _)| *other == name).map_or(start, |(_, value)| *value);
    let values = scene.controls.iter().map(|control| value(control.name, control.start)).collect();
    (values, page.number(&format!("{figure}.querySelector('.time').valueAsNumber")))
}

/// Holds what the page says beside the picture to what the library says here.
fn agrees(page: &mut Page<'_>, scene: &'static Scene, figure: &str) {
    let (values, time) = settings(page, scene, figure);
    let said = page.text(&format!("{figure}.querySelector('.says').textContent"));
    let place = format!("{} at {values:?}, {time} s", scene.name);
    let player = match Player::with(scene, values) {
        Ok(player) => player,
        Err(error) => return assert_eq!(said, error.to_string(), "{place}"),
    };
    let words = player.words(time);
    assert!(alike(&said, &words), "{place}: {said:?}, not {words:?}");
    let shown =
        page.get(&format!("[...{figure}.querySelectorAll('.readings dd')].map((place) => place.innerHTML)"));
    let shown = shown.as_array().expect("readings");
    let own = player.readings(time).expect("readings");
    assert_eq!(shown.len(), own.len(), "{place}");
    for ((shown, own), reading) in shown.iter().zip(own).zip(scene.readings) {
        let shown = shown.as_str().expect("a text").replace("&nbsp;", "\u{a0}");
        // The functions of the two machines differ in the last bit, and so may the last digit that is shown.
        let (one, other) = (number(&shown), number(&own));
        let last = match reading.form {
            Form::Fixed(digits) => 1.01 * 10_f64.powi(-(digits as i32)),
            Form::Power(digits) | Form::Digits(digits) => {
                1.01 * 10_f64.powi(1 - digits as i32) * other.abs() + 1e-9
            }
        };
        assert!(
            shown == own || (one - other).abs() <= last,
            "{place}: {} is {shown}, not {own}",
            reading.words
        );
    }
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
    if scene == 0 { all.to_vec() } else { vec![all[(scene + control) % all.len()]] }
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
    for (scene, page_address, figure) in scenes() {
        let file = page_address.replace(address(), &format!("file://{}/", site().display()));
        for page_address in [page_address, file] {
            let is_file = page_address.starts_with("file:");
            let mut page = browser.page(WIDE);
            page.before_all(EYES);
            wake(&mut page, &page_address, &figure);
            page.wait(&format!("unlike(still({figure}), drawn({figure})) !== ''"));
            let time = page.number(&format!("{figure}.querySelector('.time').valueAsNumber"));
            page.wait(&format!("{figure}.querySelector('.time').valueAsNumber !== {time}"));
            assert_eq!(page.get("shifted"), json!([]), "{}: the page jumps", scene.name);
            // Off the screen it sleeps.
            page.get("scrollTo({ top: document.body.scrollHeight, behavior: 'instant' })");
            page.get("frames(5)");
            let asked = page.get("asked");
            page.get("frames(20)");
            assert_eq!(page.get("asked"), asked, "{} asks for frames in its sleep", scene.name);
            page.get(&format!("{figure}.scrollIntoView({{ behavior: 'instant' }})"));
            page.wait(&format!("asked > {asked}"));
            // A folder is a stranger to the fonts that lie in it: the browser says so, whatever the page does.
            let said = page.console().into_iter().filter(|line| !(is_file && line.contains(".woff2")));
            assert_eq!(said.collect::<Vec<_>>(), Vec::<String>::new(), "{}", scene.name);
            for request in page.happened("Network.requestWillBeSent") {
                let url = request["request"]["url"].as_str().unwrap_or_default().to_owned();
                let inside = ["data:", "blob:", address(), &format!("file://{}", site().display())];
                assert!(inside.iter().any(|start| url.starts_with(start)), "{} asks for {url}", scene.name);
            }
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
    assert_eq!(
        page.get("document.querySelectorAll('figure.scene.awake').length"),
        0,
        "the first page has none"
    );
    for (_, _, figure) in scenes() {
        page.get(&format!("{figure}.scrollIntoView({{ behavior: 'instant' }})"));
        page.wait(&format!("unlike(still({figure}), drawn({figure})) !== ''"));
    }
    assert_eq!(page.console(), Vec::<String>::new());
}

#[test]
fn modules_that_are_asked_for_at_once_come_to_their_own_scenes() {
    let Some(mut browser) = open("at-once") else { return };
    let mut page = browser.page(WIDE);
    page.before_all(EYES);
    // The first module is on its way for long.
    page.before_all(
        "window.print = () => {}; window.late = 0; const append = Element.prototype.append; \
         Element.prototype.append = function (node, ...more) { const act = () => append.call(this, node, ...more); \
         if (node?.src?.includes('/live-') && (late += 1) === 1) setTimeout(act, 500); else act(); }",
    );
    page.go(&format!("{}print.html", address()));
    let two: Vec<_> = scenes().into_iter().take(2).map(|(_, _, figure)| figure).collect();
    for figure in &two {
        page.get(&format!("document.body.prepend({figure})")); // both in sight
    }
    for figure in &two {
        page.wait(&format!("{figure}.classList.contains('awake')"));
    }
    assert_eq!(page.get("late"), 2);
    assert_eq!(page.console(), Vec::<String>::new());
}

#[test]
fn the_still_is_the_first_picture_and_what_is_printed() {
    let Some(mut browser) = open("still") else { return };
    for (scene, page_address, figure) in scenes() {
        for size in [WIDE, PHONE] {
            let mut page = browser.page(size);
            page.before_all(EYES);
            wake_still(&mut page, &page_address, &figure);
            assert_eq!(page.text(&format!("unlike(still({figure}), drawn({figure}))")), "", "{}", scene.name);
            assert_eq!(
                page.text(&format!("{figure}.querySelector('.play').textContent")),
                "Play",
                "{}",
                scene.name
            );
            page.get("frames(5)");
            let asked = page.get("asked");
            page.get("frames(20)");
            assert_eq!(page.get("asked"), asked, "{} moves though the reader has asked for calm", scene.name);
            // It plays when it is told to, and lies still on paper.
            act(&mut page, Means::Mouse, &format!("{figure}.querySelector('.play')"), 0.5, "");
            page.wait(&format!("unlike(still({figure}), drawn({figure})) !== ''"));
            page.get(&format!("addEventListener('beforeprint', () => (window.onPaper = unlike(still({figure}), drawn({figure}))))"));
            page.tell("Page.printToPDF", json!({}));
            page.wait("typeof onPaper === 'string'");
            assert_eq!(page.text("onPaper"), "", "{}: paper has the still", scene.name);
            page.wait(&format!("unlike(still({figure}), drawn({figure})) !== ''"));
        }
    }
}

#[test]
fn controls_answer_to_mouse_fingers_and_keys_as_the_library_does() {
    let Some(mut browser) = open("controls") else { return };
    for (turn, (scene, page_address, figure)) in scenes().into_iter().enumerate() {
        let mut page = browser.page(WIDE);
        page.before_all(EYES);
        wake_still(&mut page, &page_address, &figure);
        agrees(&mut page, scene, &figure);
        let run = Player::new(scene).unwrap().run();
        set(&mut page, scene, &[], (run.duration * 300.0).round() / 1000.0);
        for (index, control) in scene.controls.iter().enumerate() {
            for (means, part) in in_turn(turn, index) {
                let (before, _) = settings(&mut page, scene, &figure);
                let named = format!("{figure}.querySelector('.controls [name={}]')", control.name);
                let (element, key) = match control.kind {
                    Kind::Slider { to, .. } | Kind::LogSlider { to, .. } if before[index] >= to => {
                        (named, "ArrowLeft")
                    }
                    Kind::Slider { .. } | Kind::LogSlider { .. } => (named, "ArrowRight"),
                    Kind::Switch => (named, " "),
                    Kind::Button => (named, "Enter"),
                    Kind::Choice(choices) => {
                        let other = if means == Means::Keys {
                            before[index] as usize
                        } else {
                            (before[index] as usize + 1) % choices.len()
                        };
                        (
                            format!(
                                "{figure}.querySelectorAll('.controls [data-name={}]')[{other}]",
                                control.name
                            ),
                            "ArrowRight",
                        )
                    }
                };
                act(&mut page, means, &element, part, key);
                if control.kind == Kind::Button {
                    page.wait(&format!("{figure}.querySelector('.play').textContent === 'Pause'"));
                    page.get(&format!("{figure}.querySelector('.play').click()"));
                    page.settle();
                }
                let (after, _) = settings(&mut page, scene, &figure);
                assert_ne!(before[index], after[index], "{}: {} by {means:?}", scene.name, control.name);
                agrees(&mut page, scene, &figure);
            }
        }
        // Time and view, and the buttons beside them; the book's page is not turned by their keys.
        let others = [".time", ".view [name=azimuth]", ".view [name=elevation]"];
        let others = others.into_iter().filter(|selector| scene.view.is_some() || *selector == ".time");
        for (index, selector) in others.enumerate() {
            let element = format!("{figure}.querySelector('{selector}')");
            for (means, part) in in_turn(turn, index) {
                let before = page.number(&format!("{element}.valueAsNumber"));
                act(&mut page, means, &element, part, "ArrowRight");
                assert_ne!(
                    page.number(&format!("{element}.valueAsNumber")),
                    before,
                    "{}: {selector} by {means:?}",
                    scene.name
                );
                agrees(&mut page, scene, &figure);
            }
        }
        page.get(&format!("{figure}.querySelector('.reset').click()"));
        set(&mut page, scene, &[], 0.0);
        for (means, key) in [(Means::Mouse, ""), (Means::Touch, ""), (Means::Keys, "Enter")] {
            let (_, before) = settings(&mut page, scene, &figure);
            act(&mut page, means, &format!("{figure}.querySelector('.step')"), 0.5, key);
            let (_, after) = settings(&mut page, scene, &figure);
            assert!(
                (after - before - run.pace / 10.0).abs() < 1e-9 * run.pace,
                "{}: a step by {means:?}",
                scene.name
            );
            for word in ["Pause", "Play"] {
                act(&mut page, means, &format!("{figure}.querySelector('.play')"), 0.5, key);
                page.wait(&format!("{figure}.querySelector('.play').textContent === '{word}'"));
            }
        }
        for index in 0..scene.presets.len() {
            act(
                &mut page,
                Means::Mouse,
                &format!("{figure}.querySelectorAll('.presets button')[{index}]"),
                0.5,
                "",
            );
            agrees(&mut page, scene, &figure);
            let pressed =
                "[...{}.querySelectorAll('.presets button')].map((button) => button.ariaPressed === 'true')";
            let own: Vec<bool> = (0..scene.presets.len()).map(|other| other == index).collect();
            assert_eq!(page.get(&pressed.replace("{}", &figure)), json!(own), "{}: its preset", scene.name);
            let description =
                page.text(&format!("seen({figure}).closest('.drawing').querySelector('desc').textContent"));
            let said = page.text(&format!("{figure}.querySelector('.says').textContent"));
            let starts = scene.controls.iter().map(|control| (control.name, control.start));
            let starts: Vec<_> = starts.collect();
            let is_start = scene.presets[index].settings.iter().all(|setting| starts.contains(setting));
            assert_eq!(description == said, !is_start, "{}: {description}", scene.name);
        }
        act(&mut page, Means::Mouse, &format!("{figure}.querySelector('.reset')"), 0.5, "");
        let description = page.text(&format!("{figure}.querySelector('desc').textContent"));
        assert_eq!(description, scene.description, "{}", scene.name);
        // A motion that goes round plays on at its end, and one that stops there would begin again.
        page.get(&format!("{figure}.querySelector('.time').focus()"));
        page.key("End");
        page.settle();
        assert_eq!(
            page.text(&format!("{figure}.querySelector('.play').textContent")),
            "Again",
            "{}",
            scene.name
        );
        page.get(&format!("{figure}.querySelector('.reset').click()"));
        page.settle();
        let starts: Vec<f64> = scene.controls.iter().map(|control| control.start).collect();
        assert_eq!(settings(&mut page, scene, &figure).0, starts, "{}", scene.name);
        assert_eq!(
            page.text("location.pathname"),
            page_address[address().len() - 1..],
            "{}: the page was turned",
            scene.name
        );
        assert_eq!(page.console(), Vec::<String>::new(), "{}", scene.name);
    }
}

#[test]
fn hands_turn_the_view_and_draw_the_grips() {
    let Some(mut browser) = open("hands") else { return };
    for (scene, page_address, figure) in scenes() {
        let mut page = browser.page(WIDE);
        page.before_all(EYES);
        wake_still(&mut page, &page_address, &figure);
        let mut player = Player::new(scene).unwrap();
        let [azimuth, elevation] = scene.view.unwrap_or_default();
        player.draw(Moment { time: scene.still, azimuth, elevation, room: Room::Wide }).unwrap();
        let picture = format!("seen({figure})");
        let cursor = format!("getComputedStyle({figure}.querySelector('.drawing')).cursor");
        for (index, grip) in player.grips().into_iter().enumerate() {
            for means in [Means::Mouse, Means::Touch] {
                page.get(&format!("{figure}.querySelector('.reset').click()"));
                page.settle();
                place(&mut page, &picture, 0.5);
                let on_screen = |page: &mut Page<'_>, x: f64, y: f64| {
                    let point = page.get(&format!(
                        "(() => {{ const p = new DOMPoint({x}, {y}).matrixTransform({picture}.getScreenCTM()); return [p.x, p.y]; }})()"
                    ));
                    [0, 1].map(|k| point[k].as_f64().expect("a place"))
                };
                let from = on_screen(&mut page, grip.x, grip.y);
                if means == Means::Mouse {
                    page.mouse("mouseMoved", from);
                    assert_eq!(page.text(&cursor), "grab", "{}", scene.name);
                }
                // One way it may be at its end.
                for [x, y] in [[30.0, -20.0], [-60.0, 40.0]] {
                    let to = on_screen(&mut page, grip.x + x, grip.y + y);
                    match means {
                        Means::Mouse => page.drag(from, to),
                        _ => page.swipe(from, to),
                    }
                    page.settle();
                    if settings(&mut page, scene, &figure).0 != player.values() {
                        break;
                    }
                }
                let (values, _) = settings(&mut page, scene, &figure);
                assert_ne!(values, player.values(), "{}: grip {index} by {means:?}", scene.name);
                agrees(&mut page, scene, &figure);
            }
        }
        if scene.view.is_none() {
            continue;
        }
        // A corner, where no grip is. Across, a finger turns the view; up, it moves the page.
        let angle = format!("{figure}.querySelector('.view [name=azimuth]').valueAsNumber");
        for means in [Means::Mouse, Means::Touch] {
            let [x, y] = place(&mut page, &picture, 0.05);
            let before = page.number(&angle);
            match means {
                Means::Mouse => page.drag([x, y], [x + 80.0, y]),
                _ => page.swipe([x, y], [x + 80.0, y]),
            }
            page.settle();
            assert_ne!(page.number(&angle), before, "{}: by {means:?}", scene.name);
        }
        let [x, y] = place(&mut page, &picture, 0.05);
        let (before, scroll) = (page.number(&angle), page.number("scrollY"));
        page.swipe([x, y], [x, y - 120.0]);
        page.wait(&format!("scrollY !== {scroll}"));
        assert_eq!(page.number(&angle), before, "{}", scene.name);
        assert_eq!(page.console(), Vec::<String>::new(), "{}", scene.name);
    }
}

#[test]
fn a_link_sets_a_scene_and_a_scene_gives_its_link() {
    let Some(mut browser) = open("links") else { return };
    let mut links = 0;
    for (scene, page_address, figure) in scenes() {
        // The end of each slider, one after another, is the worst that a link can bring.
        let mut page = browser.page(WIDE);
        wake_still(&mut page, &page_address, &figure);
        for control in scene.controls {
            let ends = match control.kind {
                Kind::Slider { from, to, .. } | Kind::LogSlider { from, to, .. } => [from, to],
                Kind::Choice(choices) => [0.0, choices.len() as f64 - 1.0],
                Kind::Switch => [0.0, 1.0],
                Kind::Button => [-1.0, 0.0],
            };
            for value in ends {
                // At the beginning: later, an unstable motion shows how its rounding grew.
                set(&mut page, scene, &[(control.name, value)], 0.0);
                agrees(&mut page, scene, &figure);
                let (values, _) = settings(&mut page, scene, &figure);
                for (other, found) in scene.controls.iter().zip(values) {
                    let own = if other.name == control.name { value } else { other.start };
                    assert_eq!(found, own, "{}: {} for {}={value}", scene.name, other.name, control.name);
                }
            }
            // Beyond its ends a link finds the nearer one, and a button that was never pressed.
            let (beyond, least) = match control.kind {
                Kind::Slider { from, .. } => (from - 7.0, from),
                Kind::LogSlider { from, .. } => (0.0, from),
                Kind::Button => (-7.0, -1.0),
                Kind::Choice(_) | Kind::Switch => continue,
            };
            set(&mut page, scene, &[(control.name, beyond)], 0.0);
            let place = scene.controls.iter().position(|other| other.name == control.name).unwrap();
            assert_eq!(
                settings(&mut page, scene, &figure).0[place],
                least,
                "{}: {}",
                scene.name,
                control.name
            );
            agrees(&mut page, scene, &figure);
        }
        // A fresh page opens at the setting that another gave away, and at its scene.
        let first = &scene.controls[0];
        if let Kind::Slider { to: end, .. } | Kind::LogSlider { to: end, .. } = first.kind {
            let mut page = browser.page(WIDE);
            let address =
                format!("{page_address}#scene-{}?{}={end}&nothing=x&t=0.25", scene.name, first.name);
            wake_still(&mut page, &address, &figure);
            assert_eq!(settings(&mut page, scene, &figure).0[0], end, "{}", scene.name);
            assert_eq!(page.get(&format!("document.activeElement === {figure}")), true, "{}", scene.name);
            agrees(&mut page, scene, &figure);
        }
        // Links in the text, followed twice: the second time the page's address does not change.
        let mut page = browser.page(WIDE);
        wake_still(&mut page, &page_address, &figure);
        let text_links = format!(
            "[...document.querySelectorAll('main a[href*=\"#scene-{}?\"]')].filter((link) => !link.closest('.share'))",
            scene.name
        );
        for index in 0..page.number(&format!("{text_links}.length")) as usize {
            let link = format!("{text_links}[{index}]");
            for before in [".reset", ".presets button:last-child"] {
                page.get(&format!("{figure}.querySelector('{before}').click()"));
                page.settle(); // the words below the scene may come to take another line
                act(&mut page, Means::Mouse, &link, 0.5, "");
                page.get(&format!("{figure}.querySelector('.play').textContent === 'Pause' && {figure}.querySelector('.play').click()"));
                page.settle();
                let (values, _) = settings(&mut page, scene, &figure);
                let asked = page.text(&format!("new URL({link}.href).hash"));
                let named: Vec<_> = asked
                    .split_once('?')
                    .unwrap()
                    .1
                    .split('&')
                    .filter_map(|part| part.split_once('='))
                    .collect();
                // What it does not name is at its start, whatever the reader did before.
                for (control, value) in scene.controls.iter().zip(values) {
                    let own = named.iter().find(|(name, _)| *name == control.name);
                    let own = own.map_or(control.start, |(_, value)| value.parse().unwrap());
                    assert_eq!(value, own, "{}: {asked} after {before}: {}", scene.name, control.name);
                }
                agrees(&mut page, scene, &figure);
                links += 1;
            }
        }
    }
    assert!(links > 0, "no link of a text sets its scene");
}

#[test]
fn whatever_breaks_leaves_the_still_and_the_page() {
    let Some(mut browser) = open("broken") else { return };
    let (scene, page_address, figure) = scenes().swap_remove(0);
    let breaks = [
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
    ];
    for (what, script) in breaks {
        let mut page = browser.page(WIDE);
        page.before_all(EYES);
        page.before_all(script);
        if script.is_empty() {
            page.tell("Network.setBlockedURLs", json!({ "urls": ["*/live-*.js"] }));
        }
        page.go(&page_address);
        page.wait(&format!("{figure}.classList.contains('failed')"));
        assert_eq!(page.text(&format!("unlike(still({figure}), drawn({figure}))")), "", "{what}");
        assert_eq!(page.get(&format!("{figure}.classList.contains('awake')")), false, "{what}");
        assert!(
            page.text(&format!("{figure}.querySelector('.says').textContent")).contains("cannot move"),
            "{what}"
        );
        assert_eq!(
            page.text(&format!("getComputedStyle({figure}.querySelector('.says')).visibility")),
            "visible",
            "{what}"
        );
        let said: Vec<String> =
            page.console().into_iter().filter(|line| !line.contains("ERR_BLOCKED")).collect();
        assert_eq!(said.len(), 1, "{what}: {said:?}");
        assert_eq!(said[0].contains("no scene 999"), what == "a panic", "{what}: {said:?}");
        page.get("document.activeElement.blur()");
        page.key("ArrowRight"); // the book goes on
        page.wait(&format!("location.href !== '{page_address}'"));
    }
    // Without scripts there is no panel at all.
    let mut page = browser.page(WIDE);
    page.tell("Emulation.setScriptExecutionDisabled", json!({ "value": true }));
    page.go(&page_address);
    assert_eq!(page.text(&format!("getComputedStyle({figure}.querySelector('.panel')).display")), "none");
    assert!(
        page.number(&format!("{figure}.querySelector('svg').getBoundingClientRect().height")) > 100.0,
        "{}",
        scene.name
    );
}

#[test]
fn everything_that_can_be_operated_has_a_name_and_an_id_of_its_own() {
    let Some(mut browser) = open("names") else { return };
    for (scene, page_address, figure) in scenes() {
        let mut page = browser.page(WIDE);
        wake_still(&mut page, &page_address, &figure);
        let twice = "(() => { const ids = [...document.querySelectorAll('[id]')].map((node) => node.id); return ids.filter((id, index) => ids.indexOf(id) !== index); })()";
        assert_eq!(page.get(twice), json!([]), "{}", scene.name);
        let loud = format!("{figure}.querySelectorAll('output:not([aria-live=off])').length");
        assert_eq!(page.get(&loud), 0, "{}: a clock is read aloud", scene.name);
        let tree = page.tell("Accessibility.getFullAXTree", json!({}));
        let (mut found, mut named) = (0, 0);
        for node in tree["nodes"].as_array().expect("nodes") {
            let role = node["role"]["value"].as_str().unwrap_or_default();
            named += usize::from(
                role == "figure"
                    && node["name"]["value"].as_str().is_some_and(|name| name.starts_with("Scene ")),
            );
            if node["ignored"] != true
                && ["slider", "button", "radio", "checkbox", "link", "spinbutton"].contains(&role)
            {
                let name = node["name"]["value"].as_str().unwrap_or_default();
                assert!(!name.trim().is_empty(), "{}: {node}", scene.name);
                found += usize::from(role != "link");
            }
        }
        assert!(found >= scene.controls.len() + 4, "{}: only {found}", scene.name);
        assert_eq!(named, 1, "{}: its caption names it", scene.name);
    }
}

#[test]
fn a_scene_plays_whatever_a_busy_browser_tells_it_at_once() {
    let Some(mut browser) = open("batch") else { return };
    let (_, page_address, figure) = scenes().swap_remove(0);
    let mut page = browser.page(WIDE);
    page.before_all(EYES);
    // Each time it hears first that nothing is to be seen, and then what is true by now.
    page.before_all(
        "window.IntersectionObserver = class extends IntersectionObserver { constructor(act, options) { \
         const none = { isIntersecting: false, intersectionRatio: 0, intersectionRect: new DOMRect() }; \
         super((entries, own) => act([none, ...entries], own), options); } }",
    );
    wake(&mut page, &page_address, &figure);
    for _ in 0..2 {
        let time = page.number(&format!("{figure}.querySelector('.time').valueAsNumber"));
        page.wait(&format!("{figure}.querySelector('.time').valueAsNumber !== {time}"));
    }
    assert_eq!(page.console(), Vec::<String>::new());
}

#[test]
fn until_its_module_has_come_a_panel_is_seen_and_cannot_be_operated() {
    let Some(mut browser) = open("loading") else { return };
    let (_, page_address, figure) = scenes().swap_remove(0);
    let mut page = browser.page(WIDE);
    page.before_all(EYES);
    page.before_all(
        "const append = Element.prototype.append; Element.prototype.append = function (node, ...more) { \
         const act = () => append.call(this, node, ...more); \
         if (node?.src?.includes('/live-')) window.come = act; else act(); }",
    );
    page.go(&page_address);
    page.get(&format!("{figure}.scrollIntoView({{ behavior: 'instant' }})"));
    page.wait("window.come");
    let says = format!("{figure}.querySelector('.says')");
    let asleep = format!(
        "[...{figure}.querySelectorAll('.panel :is(input, button, a)')].every((node) => node.closest('[inert]'))"
    );
    assert!(page.text(&format!("{says}.textContent")).contains("is loading"));
    for selector in [".says", ".controls", ".presets"] {
        let part = format!("{figure}.querySelector('{selector}')");
        assert_eq!(
            page.get(&format!("{part}.checkVisibility({{ visibilityProperty: true }})")),
            true,
            "{selector}"
        );
    }
    assert_eq!(page.get(&asleep), true);
    page.get("come()");
    page.wait(&format!("{figure}.classList.contains('awake')"));
    page.settle();
    assert_eq!(page.get(&format!("{figure}.querySelector('[inert]')")), Value::Null);
    assert!(!page.text(&format!("{says}.textContent")).contains("loading"));
    assert_eq!(page.get("shifted"), json!([]), "the page jumps");
}

#[test]
fn settings_without_an_answer_stand_still_and_say_so() {
    let Some(mut browser) = open("trouble") else { return };
    let (scene, page_address, figure) =
        scenes().into_iter().find(|(scene, ..)| scene.name == "laundromat").expect("the drum");
    let mut page = browser.page(WIDE);
    page.before_all(EYES);
    wake(&mut page, &page_address, &figure);
    let play = format!("{figure}.querySelector('.play')");
    page.wait(&format!("{play}.textContent === 'Pause'"));
    let spin = |page: &mut Page<'_>, key: &str| {
        page.get(&format!("{figure}.querySelector('[name=spin]').focus()"));
        page.key(key);
        page.settle();
    };
    page.get(&format!("{figure}.querySelectorAll('[data-name=motor]')[2].click()"));
    spin(&mut page, "Home");
    let said = page.text(&format!("{figure}.querySelector('.says').textContent"));
    assert!(said.contains("turns nothing"), "{said}");
    assert_eq!(page.text(&format!("{play}.textContent")), "Play");
    assert_eq!(page.get(&format!("{play}.disabled")), true);
    page.get("frames(3)");
    let asked = page.get("asked");
    page.get("frames(10)");
    assert_eq!(page.get("asked"), asked, "{} asks for frames though nothing moves", scene.name);
    // With an answer it goes on.
    spin(&mut page, "End");
    page.wait(&format!("{play}.textContent === 'Pause' && !{play}.disabled"));
    let time = page.number(&format!("{figure}.querySelector('.time').valueAsNumber"));
    page.wait(&format!("{figure}.querySelector('.time').valueAsNumber !== {time}"));
    // While it plays a reader can ask for the time; and escape stops it.
    page.get("document.activeElement.blur()");
    let told = page.text(&format!("{figure}.querySelector('.time').ariaValueText"));
    page.wait(&format!("{figure}.querySelector('.time').ariaValueText !== '{told}'"));
    page.get(&format!("{play}.focus()"));
    page.key("Escape");
    page.wait(&format!("{play}.textContent === 'Play'"));
    assert_eq!(page.console(), Vec::<String>::new());
}

#[test]
fn round_values_of_a_slider_over_powers_of_ten_are_met_by_its_keys() {
    let Some(mut browser) = open("decades") else { return };
    for (scene, page_address, figure) in scenes() {
        for (place, control) in scene.controls.iter().enumerate() {
            let Kind::LogSlider { from, to, .. } = control.kind else { continue };
            let mut page = browser.page(WIDE);
            wake_still(&mut page, &page_address, &figure);
            let tenth = 10_f64.powf((0.5 * (from.log10() + to.log10())).round());
            for (start, key, end) in [
                (1.1 * tenth, "ArrowLeft", tenth),
                (tenth, "ArrowRight", 1.1 * tenth),
                (0.99 * tenth, "ArrowRight", tenth),
                (tenth, "ArrowLeft", 0.99 * tenth),
            ] {
                set(&mut page, scene, &[(control.name, start)], 0.0);
                page.get(&format!("{figure}.querySelector('.controls [name={}]').focus()", control.name));
                page.key(key);
                page.settle();
                let found = settings(&mut page, scene, &figure).0[place];
                assert!((found / end - 1.0).abs() < 1e-12, "{}: {key} from {start} to {found}", control.name);
            }
        }
    }
}

#[test]
fn a_link_is_copied_where_the_reader_stands_and_a_text_link_moves_no_picture_that_is_in_sight() {
    let Some(mut browser) = open("copy") else { return };
    let (scene, page_address, figure) =
        scenes().into_iter().find(|(scene, ..)| scene.name == "laundromat").expect("the drum");
    let mut page = browser.page(WIDE);
    page.before_all(EYES);
    page.before_all(
        "Object.defineProperty(navigator, 'clipboard', { value: { writeText: async (text) => { window.held = text; } } })",
    );
    wake(&mut page, &page_address, &figure);
    page.get(&format!("{figure}.querySelector('.presets button').click()"));
    page.settle(); // the words may take another line
    let share = format!("{figure}.querySelector('.share a')");
    let at = place(&mut page, &share, 0.5);
    let scroll = page.number("scrollY");
    page.drag(at, at);
    page.wait(&format!("{figure}.querySelector('.copied').textContent === 'copied'"));
    assert_eq!(page.get("held === location.href && location.hash.includes('spin=5&t=')"), true);
    assert_eq!(page.number("scrollY"), scroll);
    assert_eq!(page.text(&format!("{figure}.querySelector('.play').textContent")), "Pause", "it plays on");
    // A link of the text while the whole picture is in sight.
    page.get(&format!(
        "{figure}.querySelector('.drawing').scrollIntoView({{ block: 'end', behavior: 'instant' }})"
    ));
    page.settle();
    let scroll = page.number("scrollY");
    let link = format!("document.querySelector('main a[data-set][href*=\"#scene-{}?\"]')", scene.name);
    page.get(&format!("{link}.click()"));
    page.settle();
    assert_eq!(page.number("scrollY"), scroll);
    // From far down it leads to the picture, and one step back leads back.
    page.get("scrollTo({ top: document.body.scrollHeight, behavior: 'instant' })");
    page.settle();
    let below = page.number("scrollY");
    page.get("{ const link = [...document.querySelectorAll('main a[data-set]')].at(-1); link.click(); }");
    page.wait(&format!("scrollY < {below} - 500"));
    page.settle();
    page.get("history.back()");
    page.wait(&format!("Math.abs(scrollY - {below}) < 5"));
    assert_eq!(page.console(), Vec::<String>::new());
}

#[test]
fn whoever_asks_for_calm_sees_what_a_preset_is_about() {
    let Some(mut browser) = open("calm") else { return };
    let (scene, page_address, figure) =
        scenes().into_iter().find(|(scene, ..)| scene.name == "laundromat").expect("the drum");
    let mut page = browser.page(WIDE);
    wake_still(&mut page, &page_address, &figure);
    let place = scene.presets.iter().position(|preset| preset.words.contains("from rest")).expect("a preset");
    page.get(&format!("{figure}.querySelectorAll('.presets button')[{place}].click()"));
    page.settle();
    let [now, end] = ["valueAsNumber", "max"]
        .map(|what| page.number(&format!("Number({figure}.querySelector('.time').{what})")));
    assert!((now / end - 0.5).abs() < 1e-9, "at {now} of {end} s it is nearly at rest");
    agrees(&mut page, scene, &figure);
}
