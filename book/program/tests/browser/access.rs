//! Access for all: what axe finds, what a phone or paper cuts off, what the keyboard reaches and in which order.
//!
//! `axe/axe.min.js` is axe-core 4.14.1 by Deque Systems, unmodified, its licence beside it. `audit.js` asks the rest.

use super::driver::{Browser, Page, is_night};
use super::{Place, address, named, site};
use crate::pages;
use serde_json::{Value, json};
use std::sync::Mutex;
use std::thread;

const AXE: &str = include_str!("axe/axe.min.js");
pub(super) const AUDIT: &str = include_str!("audit.js");
const OTHER_THEMES: [&str; 4] = ["rust", "coal", "navy", "ayu"];
pub(super) const PHONE: u32 = 320;
const WIDTHS: [u32; 3] = [1300, 768, PHONE];
/// Pages that have, together, all that a page can have: scenes and live numbers, notes, wide tables and programs,
/// exercises with hints, and words in every colour.
const CHOICE: [&str; 6] = [
    "space-station/index.html",
    "air-drag/index.html",
    "judged/index.html",
    "speed-and-accuracy/report.html",
    "coin-toss/exercises.html",
    "conventions.html",
];
/// The rules that other colours can break.
const OF_COLOUR: &str = "['color-contrast', 'link-in-text-block']";
/// How far the parts of a page may jump while it comes: the sum of what the browser calls layout shifts. Half of what is
/// commonly called good.
const MAX_SHIFT: f64 = 0.05;
/// An A4 page without its margins (`print.css`), px.
pub(super) const PAPER: [u32; 2] = [612, 963];

/// The addresses of all pages within the site, but the one of all pages.
pub(super) fn names() -> Vec<String> {
    let pages = pages().into_iter().map(|(path, _)| path.strip_prefix(site()).unwrap().display().to_string());
    let own = pages.filter(|name| !["print.html", "toc.html"].contains(&name.as_str()));
    own.chain(["404.html".to_owned()]).collect()
}

/// Puts a question to all things, in a browser for each core, and fails with all that is answered.
fn ask_all<T: Send>(name: &str, things: Vec<T>, ask: impl Fn(&mut Page<'_>, T) -> Vec<String> + Sync) {
    assert!(things.len() >= 10);
    let queue = Mutex::new(things.into_iter());
    let next = || queue.lock().unwrap().next();
    let work = |worker: usize| {
        let mut faults = Vec::new();
        let Some(mut browser) = Browser::open(&format!("{name}-{worker}")) else { return faults };
        let mut page = browser.page([WIDTHS[0], 900]);
        page.before_all(AUDIT);
        page.before_all("window.print = () => {}; localStorage.setItem('mdbook-theme', 'light')");
        while let Some(thing) = next() {
            faults.append(&mut ask(&mut page, thing));
        }
        faults
    };
    let cores = thread::available_parallelism().map_or(1, usize::from).min(4);
    let faults: Vec<String> = thread::scope(|scope| {
        let workers: Vec<_> = (0..cores).map(|worker| scope.spawn(move || work(worker))).collect();
        workers.into_iter().flat_map(|worker| worker.join().expect("the browser answers")).collect()
    });
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

/// Opens a page of the site in a width, with its scenes awake and nothing that moves. How far its parts jumped while it came,
/// as the browser measures it.
fn open(page: &mut Page<'_>, name: &str, width: u32) -> f64 {
    page.tell("Emulation.setEmulatedMedia", json!({ "media": "screen" }));
    page.prefer("prefers-reduced-motion", "reduce");
    page.resize([width, 900]);
    page.go(&format!("{}{name}", address()));
    page.get("document.fonts.ready.then(() => true)");
    page.settle();
    let shift = page.number("shift");
    let chapter = name.split('/').next().unwrap_or_default();
    if name.ends_with("/index.html") && site().join(format!("live-{chapter}.js")).is_file() {
        let figure = "document.querySelector('figure.scene')";
        page.get(&format!("{figure}?.scrollIntoView({{ behavior: 'instant' }})"));
        page.wait(&format!("!{figure} || {figure}.classList.contains('awake')"));
        page.get("scrollTo({ top: 0, behavior: 'instant' })");
    }
    page.get("{ const calm = document.createElement('style'); calm.textContent = '* { transition: none !important }'; document.head.append(calm) }");
    page.settle();
    shift
}

/// What is wrong if the parts of a page jump while it comes.
fn jumps(place: &str, shift: f64) -> Option<String> {
    (shift >= MAX_SHIFT).then(|| format!("{place}: its parts jump by {shift:.3} while it comes"))
}

/// The faults that an expression of `audit.js` finds, each with a place.
fn faults(page: &mut Page<'_>, place: &str, expression: &str) -> Vec<String> {
    let found = page.get(expression);
    let found = found.as_array().unwrap_or_else(|| panic!("{place}: {expression} is no list"));
    found.iter().map(|fault| format!("{place}: {}", fault.as_str().unwrap_or_default())).collect()
}

#[test]
fn axe_finds_nothing_and_nothing_is_cut_off_or_covered() {
    // Every page once: as wide as a screen, and then as narrow as the smallest phone; its colours at night, as axe takes most
    // of its time for those. A choice of pages at all widths, and on paper; each in another theme, and at night in all of them,
    // as is always the page with words in every colour.
    let mut tasks: Vec<(String, u32)> = Vec::new();
    for width in WIDTHS {
        tasks.extend(CHOICE.map(|name| (name.to_owned(), width)));
    }
    assert!(tasks.iter().all(|(name, _)| site().join(name).is_file()), "a page of the choice is gone");
    tasks.extend(
        names().into_iter().filter(|name| !CHOICE.contains(&name.as_str())).map(|name| (name, PHONE)),
    );
    let in_margins = Mutex::new(0.0);
    ask_all("axe", tasks, |page, (name, width)| {
        let first = if CHOICE.contains(&name.as_str()) { width } else { WIDTHS[0] };
        let shift = open(page, &name, first);
        let place = format!("{name}, light, {first} px");
        let mut found: Vec<String> = jumps(&place, shift).into_iter().collect();
        if first == WIDTHS[0] {
            // The margin is there beside the text, without the list of pages. The next page has it again.
            page.get("document.getElementById('mdbook-sidebar-toggle-anchor')?.checked && document.getElementById('mdbook-sidebar-toggle').click()");
            page.get("localStorage.removeItem('mdbook-sidebar')");
            page.settle();
            let beside = "[...document.querySelectorAll('.figure.margin')].filter((figure) => getComputedStyle(figure).float === 'right').length";
            *in_margins.lock().unwrap() += page.number(beside);
            found.append(&mut faults(page, &place, "crowded()"));
            page.resize([width, 900]);
            page.settle();
        }
        page.get(&format!("{AXE}; true"));
        let place = format!("{name}, light, {width} px");
        let is_all = CHOICE.contains(&name.as_str()) || is_night();
        found.append(&mut faults(
            page,
            &place,
            &format!("audit([], {})", if is_all { "[]" } else { OF_COLOUR }),
        ));
        found.append(&mut faults(page, &place, "untold()"));
        found.append(&mut faults(page, &place, "disordered()"));
        if width == PHONE {
            found.append(&mut faults(page, &place, "wide()"));
        }
        if CHOICE.contains(&name.as_str()) {
            // Other themes have other colours and nothing else.
            let at = WIDTHS.iter().position(|&own| own == width).expect("a width");
            let turn = CHOICE.iter().position(|own| *own == name).expect("a page of the choice");
            let is_in_all = is_night() || turn == CHOICE.len() - 1;
            for (index, theme) in OTHER_THEMES.iter().enumerate().skip(at).step_by(WIDTHS.len()) {
                if !is_in_all && index != turn % OTHER_THEMES.len() {
                    continue;
                }
                page.get(&format!("document.getElementById('mdbook-theme-{theme}').click()"));
                page.wait(&format!("document.documentElement.classList.contains('{theme}')"));
                page.settle();
                let place = format!("{name}, {theme}, {width} px");
                found.append(&mut faults(page, &place, &format!("audit({OF_COLOUR}, [])")));
            }
            page.tell("Emulation.setEmulatedMedia", json!({ "media": "print" }));
            page.resize(PAPER);
            page.settle();
            found.append(&mut faults(page, &format!("{name}, A4"), &format!("offPaper({})", PAPER[1])));
        }
        found
    });
    assert!(*in_margins.lock().unwrap() > 20.0, "small figures stand in the margin");
}

/// Goes on by the tabulator until the page ends, and gives what had the focus: its name and where it is.
fn by_keys(page: &mut Page<'_>, place: &str) -> Vec<(String, String)> {
    let mut visited = Vec::new();
    let mut found = Vec::new();
    // From the beginning, wherever the page has been scrolled.
    page.get("{ const first = document.createElement('button'); document.body.prepend(first); first.focus(); first.remove(); }");
    loop {
        page.key("Tab");
        let focused = page.get("focused()");
        if focused.is_null() {
            break;
        }
        let text = |name: &str| focused[name].as_str().unwrap_or_default().to_owned();
        let here = (text("name"), text("place"));
        if visited.first() == Some(&here) {
            break; // round to the beginning, as there is no window about the page
        }
        for fault in focused["faults"].as_array().into_iter().flatten().filter_map(Value::as_str) {
            found.push(format!("{place}: {}: {fault}", text("name")));
        }
        visited.push(here);
        assert!(visited.len() < 2000, "{place}: the keyboard does not come out of the page");
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
    visited
}

#[test]
fn the_keyboard_reaches_everything_in_the_order_of_the_page() {
    let Some(mut browser) = Browser::open("keyboard") else { return };
    let mut page = browser.page([WIDTHS[0], 900]);
    page.before_all(AUDIT);
    // Of one scene, since all panels are made alike: that of a short page.
    let places = [named("space-station")];
    for Place { scene, address: page_address, figure } in places {
        let name = &page_address[address().len()..];
        for width in [WIDTHS[0], PHONE] {
            open(&mut page, name, width);
            let place = format!("{name}, {width} px");
            let visited = by_keys(&mut page, &place);
            // Where one is, each place once: the way past the menu, the chapters, the menu, the text, the foot.
            let mut places: Vec<&str> = visited.iter().map(|(_, place)| place.as_str()).collect();
            places.dedup();
            let in_text = ["figure.scene", ".answers"];
            let mut outer: Vec<&str> = places.into_iter().filter(|place| !in_text.contains(place)).collect();
            outer.dedup();
            let all = ["page", "#mdbook-sidebar", "#mdbook-menu-bar", "main", ".foot"];
            let own = all.iter().copied().filter(|part| width > 1000 || *part != "#mdbook-sidebar");
            assert_eq!(outer, own.collect::<Vec<_>>(), "{place}");
            for id in ["#mdbook-sidebar-toggle", "#mdbook-theme-toggle", "#mdbook-search-toggle"] {
                assert!(visited.iter().any(|(name, _)| name == id), "{place}: {id} is not reached");
            }
            // Of the choices of one kind the keyboard reaches the chosen one, and the others by arrows.
            let is_awake = page.get(&format!("{figure}.classList.contains('awake')")) == true;
            let steps = visited.iter().filter(|(_, place)| place == "figure.scene").count();
            let least = if is_awake { scene.controls.len() + 4 } else { 0 };
            assert!(steps >= least, "{place}: {steps} steps through the scene");
        }
        // The menu by keys.
        open(&mut page, name, WIDTHS[0]);
        for (id, opened) in [
            ("mdbook-sidebar-toggle", "document.documentElement.classList.contains('sidebar-visible')"),
            ("mdbook-theme-toggle", "document.getElementById('mdbook-theme-list').style.display === 'block'"),
            (
                "mdbook-search-toggle",
                "!document.getElementById('mdbook-search-wrapper').classList.contains('hidden')",
            ),
        ] {
            for key in ["Enter", " "] {
                page.get(&format!("document.getElementById('{id}').focus()"));
                let before = page.get(opened);
                page.key(key);
                page.wait(&format!("({opened}) !== {before}"));
                // The index, once it is there, takes the focus to the field.
                page.wait("!document.querySelector('#mdbook-searchbar-outer.searching')");
            }
        }
    }
    // On a phone a wide formula, table or program is scrolled by keys, which do not turn the page.
    open(&mut page, "turning/index.html", PHONE);
    let place = page.text("location.href");
    page.wait("document.querySelector('main [tabindex=\"0\"]')");
    page.get("document.querySelector('main [tabindex=\"0\"]').focus()");
    page.key("ArrowRight");
    page.wait("document.activeElement.scrollLeft > 0");
    assert_eq!(page.text("location.href"), place, "the page was turned");
}
