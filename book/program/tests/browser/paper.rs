//! The book on paper: nothing is cut off on A4, and a PDF holds what its reader looks for.

use super::access::{AUDIT, PAPER};
use super::driver::{self, Browser};
use crate::{folder, root, site};
use hayro_syntax::Pdf;
use hayro_syntax::object::{self as pdf, Array, Dict, Name};
use press::paper::{self, Paper, Solutions};
use serde_json::json;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;

#[test]
fn nothing_is_cut_off_on_a4() {
    let Some(mut browser) = Browser::open("paper") else {
        return;
    };
    let paper = Paper::read(root(), site(), None, Solutions::Whole).unwrap();
    let file = folder("paper").join("paper.html");
    fs::write(&file, paper.html(&format!("file://{}/", site().display()), &BTreeMap::new())).unwrap();
    let mut page = browser.page(PAPER);
    page.before_all(AUDIT);
    page.tell("Emulation.setEmulatedMedia", json!({ "media": "print" }));
    page.go(&format!("file://{}", file.display()));
    page.wait("document.fonts.status === 'loaded'");
    assert!(page.number("document.querySelectorAll('main math').length") > 5000.0);
    assert!(page.number("document.querySelector('main').clientWidth") == f64::from(PAPER[0]));
    let measure = format!("offPaper({})", PAPER[1]);
    let found = page.get(&measure);
    let found: Vec<&str> = found.as_array().unwrap().iter().filter_map(|fault| fault.as_str()).collect();
    assert!(found.is_empty(), "{} are cut off:\n{}", found.len(), found.join("\n"));
    // Panels of one figure have one scale.
    let scales = "[...document.querySelectorAll('.drawing.panels')].filter((row) => {
        const panels = [...row.querySelectorAll(':scope > svg.drawn')].filter((panel) => panel.getClientRects().length > 0);
        const scales = panels.map((panel) => panel.getBoundingClientRect().width / panel.viewBox.baseVal.width);
        return scales.length > 1 && Math.max(...scales) > 1.01 * Math.min(...scales);
    }).map((row) => row.closest('figure').id)";
    assert!(page.number("document.querySelectorAll('.drawing.panels').length") > 20.0);
    assert_eq!(page.get(scales), json!([]), "panels of different scales");
    // A section has the number by which references call it.
    let numbers = "(() => {
        let [chapter, section] = [0, 0];
        const numbers = new Map();
        for (const heading of document.querySelectorAll('main :is(.kicker, h1, h2, h3, h4)')) {
            const { counterReset, counterIncrement } = getComputedStyle(heading);
            chapter = Number(/chapter (-?\\d+)/.exec(counterReset)?.[1] ?? chapter);
            section = Number(/section (-?\\d+)/.exec(counterReset)?.[1] ?? section);
            section += Number(/section (-?\\d+)/.exec(counterIncrement)?.[1] ?? 0);
            numbers.set(heading.id, `${chapter}.${section}`);
        }
        return [...document.querySelectorAll('main a[href^=\"#\"]')]
            .map((link) => [/^§(\\d+\\.\\d+)/.exec(link.textContent)?.[1], link.hash.slice(1)])
            .filter(([said]) => said)
            .map(([said, id]) => [said, numbers.get(id), id]);
    })()";
    let numbers = page.get(numbers);
    let numbers = numbers.as_array().unwrap();
    assert!(numbers.len() > 300, "{}", numbers.len());
    let wrong: Vec<_> = numbers.iter().filter(|number| number[0] != number[1]).collect();
    assert!(wrong.is_empty(), "{} of {}: {wrong:?}", wrong.len(), numbers.len());
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
    let paper = Paper::read(root(), site(), None, Solutions::Whole).unwrap();
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
    // What answers a guess stands at the end of its page.
    let [asked, given] = ["href=\"#guess-", "id=\"guess-"].map(|mark| html.matches(mark).count());
    assert!(asked == given && asked == 31, "{asked} {given}");
    let first = &html[at("<h1 id=\"the-coin-toss\"")..];
    let first = &first[..first.find("</section>").unwrap()];
    assert!(first.find("href=\"#guess-1-the-coin-toss\"").unwrap() < first.find("id=\"scene-").unwrap());
    assert_eq!(first.rfind("<h2"), first.find("<h2 class=\"hints\">The guess"));
    // A page is named with the sheet on which it stands.
    let named = "“The middle axis”, p.\u{a0}<span class=\"on\" data-of=\"sec-middle-axis\">000</span></a>";
    assert!(html.contains(named));
}

#[test]
fn a_sheet_of_answers_has_one_for_each_exercise_and_no_program() {
    let sheet = Paper::read(root(), site(), Some("air-drag"), Solutions::Answers).unwrap();
    let html = sheet.html("", &BTreeMap::new());
    let solutions = fs::read_to_string(root().join("book/air-drag/solutions.md")).unwrap();
    let answers = html.split("<strong>").skip(1).filter(|answer| answer.starts_with("6."));
    assert_eq!(answers.count(), solutions.matches("{#sol:").count());
    assert!(html.contains(">Answers") && !html.contains("<pre") && !html.contains("Solution"));
}

/// Of slides that are fitted: whether all fit at a size that one can read from afar, and hold nothing that is not drawn.
const SEEN: &str = "(() => {
    const faults = [];
    for (const [n, slide] of slides.entries()) {
        const fault = (what) => faults.push(`slide ${n + 1}: ${what}`);
        turn(n);
        const paper = slide.getBoundingClientRect();
        if (!isWithin(slide)) fault('more than fits');
        if (parseFloat(getComputedStyle(slide).fontSize) < 24) fault('small type');
        const parts = slide.querySelectorAll('h1, h2, p, li, math, svg.drawn, .number');
        for (const part of [...parts].filter((part) => part.getClientRects().length > 0)) {
            const box = part.getBoundingClientRect();
            const isOut = box.left < paper.left || box.right > paper.right || box.top < paper.top || box.bottom > paper.bottom - 30;
            if (isOut || box.width === 0) fault(`cut off: ${part.textContent.slice(0, 30)}`);
        }
        const drawn = [...slide.querySelectorAll('svg.drawn')].filter((svg) => svg.getClientRects().length > 0);
        const smallest = Math.min(...drawn.map((svg) => svg.getBoundingClientRect().width / svg.viewBox.baseVal.width));
        if (slide.matches('.picture') && !(drawn.length > 0 && smallest > 0.8)) fault(`${drawn.length} drawings at ${smallest}`);
    }
    return faults;
})()";

#[test]
fn every_chapter_with_a_guess_has_slides_that_load_nothing_and_are_seen_whole() {
    let Some(mut browser) = Browser::open("slides") else {
        return;
    };
    let book = Paper::read(root(), site(), None, Solutions::None).unwrap();
    let folder = folder("slides");
    let mut page = browser.page([1280, 720]);
    let mut faults = Vec::new();
    let mut chapters = 0;
    for entry in fs::read_dir(root().join("book")).unwrap().map(|entry| entry.unwrap()) {
        let text = fs::read_to_string(entry.path().join("index.md")).unwrap_or_default();
        if !text.contains("**Guess first.**") {
            continue;
        }
        chapters += 1;
        let name = entry.file_name().into_string().unwrap();
        let slides = book.slides(&root().join("target/press/theme"), &name).unwrap();
        for load in [" src=", " href=", "@import", "{{"] {
            assert!(!slides.contains(load), "{name}: {load}");
        }
        let mut targets = slides.split("url(").skip(1);
        assert!(targets.all(|target| target.starts_with("\"data:") || target.starts_with('#')), "{name}");
        let file = folder.join(format!("{name}.html"));
        fs::write(&file, slides).unwrap();
        page.go(&format!("file://{}#1", file.display())); // the address says which slide is seen
        page.wait("document.body.classList.contains('fitted')");
        let count = page.number("slides.length");
        let pictures = page.number("document.querySelectorAll('.picture').length");
        let figures =
            text.lines().filter(|line| line.starts_with("![") && line.contains("](fig:")).count().min(4);
        let has_scene = text.lines().any(|line| line.starts_with("![") && line.contains("](scene:"));
        // Every chapter has its title, the guess and its answer; what the notes put to the vote comes with a scene.
        let least = if has_scene { 10.0 } else { 3.0 + pictures };
        assert!((least..=14.0).contains(&count), "{name}: {count}");
        assert!(
            pictures >= (figures + usize::from(has_scene)) as f64,
            "{name}: {pictures} pictures of {figures}"
        );
        for key in ["End", "ArrowLeft"] {
            page.key(key);
        }
        let last = page.number("slides.findIndex((slide) => slide.checkVisibility())");
        assert_eq!(last, count - 2.0, "{name}: keys turn the slides");
        let found = page.get(SEEN);
        faults.extend(
            found.as_array().unwrap().iter().map(|fault| format!("{name}, {}", fault.as_str().unwrap())),
        );
    }
    assert!(chapters > 10 && faults.is_empty(), "{chapters} chapters:\n{}", faults.join("\n"));
}

#[test]
fn an_epub_begins_with_its_type_and_every_page_of_it_is_xml() {
    let file = folder("epub").join("book.epub");
    Paper::read(root(), site(), None, Solutions::Whole).unwrap().write_epub(site(), &file).unwrap();
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
    for solutions in [Solutions::None, Solutions::Whole] {
        let handout = Paper::read(root(), crate::site(), Some("air-drag"), solutions).unwrap();
        fs::write(&page, handout.html(&site, &BTreeMap::new())).unwrap();
        paper::print(&browser, &page, &file, &profile).unwrap();
        pdfs.push(Handout::read(&fs::read(&file).unwrap()));
    }
    let [without, with] = [&pdfs[0], &pdfs[1]];
    let has = |pdf: &Handout, title: &str| pdf.outline.iter().any(|(_, words)| words.contains(title));
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
        assert!(pdf.outline.len() > 20 && pdf.pages > 10, "{:?}", pdf.outline);
        for name in &pdf.links {
            assert!(pdf.places.contains_key(name), "{name}");
        }
        assert!(pdf.links.len() > 30 && pdf.addresses.iter().all(|address| address.starts_with("http")));
        let at = |id: &str| pdf.places.get(id).copied().unwrap_or_else(|| panic!("no place of {id}"));
        let order = ["sec-drag-why", "sec-drag-decay", "sec-drag-room", "sec-drag-further"].map(at);
        assert!(order[0] < 4 && order[3] > 6 && order.is_sorted(), "{order:?} of {}", pdf.pages);
    }
    assert!(!has(without, "Solution") && has(with, "Solutions: Frisbee and pencil"));
    assert!(with.pages > without.pages);
}

/// What a reader finds in a PDF.
struct Handout {
    title: String,
    pages: usize,
    /// Depth and title of each entry.
    outline: Vec<(usize, String)>,
    /// Where links lead to, within and without.
    links: BTreeSet<String>,
    addresses: BTreeSet<String>,
    /// The page of each place, counted from one.
    places: BTreeMap<String, usize>,
}

impl Handout {
    fn read(bytes: &[u8]) -> Self {
        let pdf = Pdf::new(bytes.to_vec()).expect("a PDF");
        let catalog: Dict = pdf.xref().get(pdf.xref().root_id()).expect("a catalog");
        let mut outline = Vec::new();
        let mut left = vec![(0, catalog.get::<Dict>("Outlines").expect("an outline").get::<Dict>("First"))];
        while let Some((depth, entry)) = left.pop() {
            let Some(entry) = entry else { continue };
            outline.push((depth, words(entry.get::<pdf::String>("Title").expect("a title").as_bytes())));
            left.push((depth, entry.get("Next")));
            left.push((depth + 1, entry.get("First")));
        }
        let (mut links, mut addresses) = (BTreeSet::new(), BTreeSet::new());
        for page in pdf.pages().iter() {
            let notes = page.raw().get::<Array>("Annots").unwrap_or_default();
            for note in notes.iter::<Dict>() {
                links.extend(note.get::<Name>("Dest").map(|place| place.as_str().to_owned()));
                let address = note.get::<Dict>("A").and_then(|action| action.get::<pdf::String>("URI"));
                addresses.extend(address.map(|address| words(address.as_bytes())));
            }
        }
        Self {
            title: words(pdf.metadata().title.as_deref().expect("a title")),
            pages: pdf.pages().len(),
            outline,
            links,
            addresses,
            places: paper::numbers(bytes),
        }
    }
}

/// A string of a PDF, in Latin letters or UTF-16.
fn words(bytes: &[u8]) -> String {
    let Some(wide) = bytes.strip_prefix(b"\xfe\xff") else {
        return String::from_utf8(bytes.to_vec()).expect("ASCII");
    };
    let units: Vec<u16> = wide.chunks(2).map(|unit| u16::from_be_bytes([unit[0], unit[1]])).collect();
    String::from_utf16(&units).expect("UTF-16")
}
