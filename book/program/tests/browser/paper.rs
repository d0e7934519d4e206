//! The book on paper: nothing is cut off on A4, and a PDF holds what its reader looks for.

use super::driver::{self, Browser};
use crate::{folder, root, site};
use press::paper::{self, Paper};
use serde_json::json;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;

/// What A4 leaves for text between the margins of print.css, px.
const ROOM: [u32; 2] = [612, 963];

/// What reaches out of the text or is cut off within its own box, and what no page is high enough for.
const CUT_OFF: &str = r"(() => {
  const room = document.querySelector('main').getBoundingClientRect();
  const whole = 'math, svg, table, pre, figure, .equation, .formula, .note, .hint, p, li, td, th, h1, h2, h3, h4';
  return [...document.querySelectorAll('main :is(' + whole + ')')].flatMap((element) => {
    const box = element.getBoundingClientRect();
    if (box.width === 0) return [];
    const isWide = box.right > room.right + 1 || box.left < room.left - 1;
    const isOver = element.matches('pre, p, li, td, th, h1, h2, h3, h4') && element.scrollWidth > element.clientWidth + 1
      && getComputedStyle(element).display !== 'inline';
    const hides = getComputedStyle(element).overflowX !== 'visible' && !(element instanceof SVGElement);
    const isCut = hides && element.scrollWidth > element.clientWidth + 1;
    const isHigh = element.matches('svg, .equation, .figure') && box.height > HEIGHT;
    if (!isWide && !isCut && !isHigh && !isOver) return [];
    const place = element.closest('[id]')?.id ?? '';
    return [`${element.tagName} in ${place}: ${box.left - room.left} to ${box.right - room.left} of ${room.width},`
      + ` ${box.height} high: ${element.textContent.trim().slice(0, 60)}`];
  });
})()";

#[test]
fn nothing_is_cut_off_on_a4() {
    let Some(mut browser) = Browser::open("paper") else {
        return;
    };
    let paper = Paper::read(root(), site(), None, true).unwrap();
    let file = folder("paper").join("paper.html");
    fs::write(&file, paper.html(&format!("file://{}/", site().display()), &BTreeMap::new())).unwrap();
    let mut page = browser.page(ROOM);
    page.tell("Emulation.setEmulatedMedia", json!({ "media": "print" }));
    page.go(&format!("file://{}", file.display()));
    page.wait("document.fonts.status === 'loaded'");
    assert!(page.number("document.querySelectorAll('main math').length") > 5000.0);
    assert!(page.number("document.querySelector('main').clientWidth") == f64::from(ROOM[0]));
    let measure = CUT_OFF.replace("HEIGHT", &ROOM[1].to_string());
    let found = page.get(&measure);
    let found: Vec<&str> = found.as_array().unwrap().iter().filter_map(|fault| fault.as_str()).collect();
    assert!(found.is_empty(), "{} are cut off:\n{}", found.len(), found.join("\n"));
    // It would be seen.
    for wrong in [
        "<pre style='white-space: pre'>WIDE</pre>",
        "<p style='white-space: nowrap'>WIDE</p>",
        "<svg width='700' height='9'></svg>",
    ] {
        let wrong = json!(format!("<section>{}</section>", wrong.replace("WIDE", &"wide".repeat(40))));
        page.get(&format!("document.querySelector('main').insertAdjacentHTML('beforeend', {wrong})"));
        assert!(!page.get(&measure).as_array().unwrap().is_empty(), "{wrong}");
        page.get("document.querySelector('main > section:last-child').remove()");
    }
}

#[test]
fn a_book_for_paper_holds_every_page_and_its_solutions_last() {
    let paper = Paper::read(root(), site(), None, false).unwrap();
    let html = paper.html("", &BTreeMap::from([("sol-toss-harder".to_owned(), 417)]));
    let at = |words: &str| html.find(words).unwrap_or_else(|| panic!("no {words}"));
    let order = [
        "class=\"title-page\"",
        ">Contents<",
        "<h1 id=\"preface\"",
        "<h1 id=\"the-coin-toss\"",
        "<h2 class=\"page-title\" id=\"exercises-the-coin-toss\"",
        "<h1 id=\"bibliography\"",
        "<h1 id=\"appendix-solutions\"",
        "<h2 class=\"page-title\" id=\"solutions-the-laundromat\"",
        "<h2 class=\"page-title\" id=\"solutions-hard-cases\"",
    ];
    assert!(order.is_sorted_by_key(|words| at(words)), "{:?}", order.map(at));
    assert!(html.contains(&format!("version {}", env!("CARGO_PKG_VERSION"))));
    assert!(html.contains("Solution 4.1, page <span class=\"on\" data-of=\"sol-toss-harder\">417</span>"));
    // Every link leads to something on this paper, or to a network.
    let ids: BTreeSet<&str> =
        html.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    let body = html.split("<main>").nth(1).unwrap();
    for target in body.split("href=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
        let is_alive = target.strip_prefix('#').map_or(target.starts_with("http"), |id| ids.contains(id));
        assert!(is_alive, "{target}");
    }
    // Hints stand behind the exercises, each with its number.
    let exercises = &html[at("id=\"exercises-the-coin-toss\"")..];
    let exercises = &exercises[..exercises.find("</section>").unwrap()];
    let (text, hints) = exercises.split_once(">Hints<").unwrap();
    assert!(
        !text.contains("<details>") && hints.contains("<a class=\"number\" href=\"#ex-toss-harder\">4.1</a>")
    );
    let [asked, given] =
        [(text, "href=\"#hint-"), (hints, "id=\"hint-")].map(|(text, mark)| text.matches(mark).count());
    assert!(asked == given && asked >= 10, "{asked} {given}");
}

#[test]
fn an_epub_begins_with_its_type_and_every_page_of_it_is_xml() {
    let file = folder("epub").join("book.epub");
    Paper::read(root(), site(), None, true).unwrap().write_epub(site(), &file).unwrap();
    let bytes = fs::read(&file).unwrap();
    assert!(bytes.starts_with(b"PK\x03\x04") && &bytes[30..58] == b"mimetypeapplication/epub+zip");
    assert!((500_000..3_000_000).contains(&bytes.len()), "{}", bytes.len());
}

#[test]
fn a_handout_is_a_pdf_with_outline_and_links_and_its_places_are_read() {
    let Some(browser) = driver::program() else {
        return;
    };
    let folder = folder("handout");
    let [page, file, profile] = ["page.html", "handout.pdf", "profile"].map(|name| folder.join(name));
    let site = format!("file://{}/", site().display());
    let mut pdfs = Vec::new();
    for solutions in [false, true] {
        let handout = Paper::read(root(), crate::site(), Some("air-drag"), solutions).unwrap();
        fs::write(&page, handout.html(&site, &BTreeMap::new())).unwrap();
        paper::print(&browser, &page, &file, &profile).unwrap();
        pdfs.push(Pdf::read(&fs::read(&file).unwrap()));
    }
    let [without, with] = [&pdfs[0], &pdfs[1]];
    let has = |pdf: &Pdf, title: &str| pdf.outline.iter().any(|(_, words)| words.contains(title));
    for pdf in [without, with] {
        assert_eq!(pdf.title, "Frisbee and pencil – Things That Spin");
        assert_eq!(pdf.outline.iter().filter(|(depth, _)| *depth == 0).count(), 1, "{:?}", pdf.outline);
        assert!(
            has(pdf, "Frisbee and pencil") && has(pdf, "Exercises: Frisbee and pencil"),
            "{:?}",
            pdf.outline
        );
        let mut titles = pdf.outline.iter().map(|(_, words)| words.split_at_checked(words.len() / 2));
        assert!(!titles.any(|halves| halves.is_some_and(|(one, other)| one == other)), "{:?}", pdf.outline);
        assert!(pdf.outline.len() > 20 && pdf.pages.len() > 10, "{:?}", pdf.outline);
        for name in &pdf.links {
            assert!(pdf.places.contains_key(name), "{name}");
        }
        assert!(pdf.links.len() > 30 && pdf.addresses.iter().all(|address| address.starts_with("http")));
        assert_eq!(pdf.places, paper::numbers(&pdf.bytes));
    }
    assert!(!has(without, "Solution") && has(with, "Solutions: Frisbee and pencil"));
    assert!(with.pages.len() > without.pages.len());
}

/// A PDF as Chromium writes it, its objects by their numbers.
struct Pdf {
    bytes: Vec<u8>,
    title: String,
    /// The objects of its pages, in their order.
    pages: Vec<usize>,
    /// Depth and title of each entry.
    outline: Vec<(usize, String)>,
    /// Where links lead to, within and without.
    links: BTreeSet<String>,
    addresses: BTreeSet<String>,
    /// The page of each place, counted from one.
    places: BTreeMap<String, usize>,
}

impl Pdf {
    fn read(bytes: &[u8]) -> Self {
        let text: String = bytes.iter().map(|&byte| char::from(byte)).collect();
        let mut objects = BTreeMap::new();
        for part in text.split("\nendobj\n") {
            if let Some((before, body)) = part.split_once(" 0 obj\n")
                && let Ok(number) = before.rsplit('\n').next().unwrap().parse::<usize>()
            {
                objects.insert(number, body);
            }
        }
        let object =
            |number: usize| objects.get(&number).copied().unwrap_or_else(|| panic!("no object {number}"));
        let refers = |body: &str, key: &str| -> Option<usize> {
            let rest = body.split(&format!("/{key} ")).nth(1)?;
            rest.split(' ').next()?.parse().ok()
        };
        let trailer = text.rsplit("trailer").next().unwrap();
        let catalog = object(refers(trailer, "Root").unwrap());
        let mut pages = Vec::new();
        let mut left = vec![refers(catalog, "Pages").unwrap()];
        while let Some(node) = left.pop() {
            match object(node).split_once("/Kids [") {
                Some((_, kids)) => {
                    let kids = kids
                        .split(']')
                        .next()
                        .unwrap()
                        .split(" 0 R")
                        .filter_map(|kid| kid.trim().parse().ok());
                    left.extend(kids.collect::<Vec<usize>>().into_iter().rev());
                }
                None => pages.push(node),
            }
        }
        let mut outline = Vec::new();
        let mut left = vec![(0, refers(object(refers(catalog, "Outlines").expect("an outline")), "First"))];
        while let Some((depth, node)) = left.pop() {
            let Some(node) = node.map(object) else {
                continue;
            };
            outline.push((depth, string(node.split("/Title ").nth(1).unwrap())));
            left.push((depth, refers(node, "Next")));
            left.push((depth + 1, refers(node, "First")));
        }
        let places = object(refers(catalog, "Dests").expect("places")).split(']').filter_map(|place| {
            let (name, target) = place.split_once('/')?.1.split_once(" [")?;
            let page: usize = target.split(' ').next()?.parse().ok()?;
            Some((name.to_owned(), 1 + pages.iter().position(|it| *it == page).expect("a page")))
        });
        let places = places.collect();
        let notes: Vec<&str> =
            objects.values().copied().filter(|body| body.contains("/Subtype /Link")).collect();
        let link = |body: &&str| {
            body.split("/Dest /").nth(1).map(|rest| rest.split_whitespace().next().unwrap().to_owned())
        };
        let address =
            |body: &&str| body.split("/URI (").nth(1).map(|rest| rest.split(')').next().unwrap().to_owned());
        Self {
            bytes: bytes.to_vec(),
            title: string(object(refers(trailer, "Info").unwrap()).split("/Title ").nth(1).unwrap()),
            outline,
            links: notes.iter().filter_map(link).collect(),
            addresses: notes.iter().filter_map(address).collect(),
            places,
            pages,
        }
    }
}

/// A string of a PDF: `(in Latin letters)` or `<FEFF…>`, UTF-16 in hexadecimal digits.
fn string(written: &str) -> String {
    if let Some(digits) = written.strip_prefix('<') {
        let digits = digits.split('>').next().unwrap().as_bytes();
        let number = |digits: &[u8]| u16::from_str_radix(std::str::from_utf8(digits).unwrap(), 16).unwrap();
        let units: Vec<u16> = digits.chunks(4).skip(1).map(number).collect();
        return String::from_utf16(&units).unwrap();
    }
    written.trim_start_matches('(').split(")\n").next().unwrap().replace("\\(", "(").replace("\\)", ")")
}
