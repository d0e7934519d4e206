//! Numbers that answer, in a real browser: what stands beside the code is what the same snippet says here.

use super::driver::Page;
use super::{Means, WIDE, act, address, alike, in_turn, open};
use live::snippet::Snippet;
use serde_json::{Value, json};
use snippets::SNIPPETS;
use std::collections::BTreeMap;

/// The snippets with live numbers and their places among all, page by page: `turning/index.html`.
fn pages() -> BTreeMap<String, Vec<(usize, &'static Snippet)>> {
    let mut pages: BTreeMap<_, Vec<_>> = BTreeMap::new();
    for snippet in SNIPPETS {
        let file = snippet.place.split(':').next().unwrap_or_default();
        let page = file.trim_start_matches("book/").replace(".md", ".html");
        pages.entry(page).or_default().push((snippet.number, snippet));
    }
    assert!(!pages.is_empty());
    pages
}

#[test]
fn numbers_answer_to_mouse_fingers_and_keys_as_the_library_does() {
    let Some(mut browser) = open("numbers") else { return };
    for (turn, (name, snippets)) in pages().into_iter().enumerate() {
        let page_address = format!("{}{name}", address());
        let mut page = browser.page(WIDE);
        page.go(&page_address);
        for (place, snippet) in snippets {
            let panel = format!("document.querySelector('.answers[data-snippet=\"{place}\"]')");
            for index in 0..snippet.live.len() {
                let number = format!("{panel}.querySelectorAll('.number')[{index}]");
                let range = format!("{number}.querySelector('input[type=range]')");
                for (means, _) in in_turn(turn, index) {
                    let [before, least] = ["value", "min"].map(|what| page.text(&format!("{range}.{what}")));
                    // Far from where it is: a whole number stays where it is under a finger near by.
                    let is_low =
                        page.get(&format!("2 * ({range}.value - {range}.min) < {range}.max - {range}.min"));
                    let part = if is_low == true { 0.9 } else { 0.1 };
                    act(
                        &mut page,
                        means,
                        &range,
                        part,
                        if before == least { "ArrowRight" } else { "ArrowLeft" },
                    );
                    page.wait(&format!("{range}.value !== {}", json!(before)));
                    let live = page.get(&format!(
                        "[...{panel}.querySelectorAll('.number input[type=number]')].map((field) => +field.value)"
                    ));
                    let live: Vec<f64> =
                        live.as_array().expect("numbers").iter().filter_map(Value::as_f64).collect();
                    let at = format!("{} with {live:?}", snippet.place);
                    let lines = snippet.run(&live);
                    let (printed, rest) = lines.split_at(snippet.printed.len());
                    let (checks, said) = rest.split_at(snippet.checks);
                    let classes = json!(
                        checks
                            .iter()
                            .map(|check| match &check[..1] {
                                "+" => "holds",
                                "-" => "fails",
                                "?" => "unread",
                                _ => panic!("{at}: {check}"),
                            })
                            .collect::<Vec<_>>()
                    );
                    page.wait(&format!(
                        "JSON.stringify([...{panel}.querySelectorAll('li')].map((node) => node.className)) === {}",
                        json!(classes.to_string())
                    ));
                    // The answer comes when the module has been loaded and has run.
                    let wrong = |page: &mut Page<'_>| {
                        let shown = page.get(&format!(
                            "[...{panel}.querySelectorAll('dd > output')].map((output) => output.textContent)"
                        ));
                        let pairs = printed.iter().zip(shown.as_array().expect("texts").clone());
                        let mut pairs = pairs.map(|(own, shown)| {
                            let own = pretty(own.trim_start_matches('='));
                            (if own.is_empty() { "–".to_owned() } else { own }, shown)
                        });
                        pairs.find(|(own, shown)| {
                            let shown = shown.as_str().unwrap_or_default();
                            !(alike(own, shown) || is_rounding(own) && is_rounding(shown))
                        })
                    };
                    let tries = (0..100).find(|_| {
                        let is_right = wrong(&mut page).is_none();
                        page.settle();
                        is_right
                    });
                    assert!(tries.is_some(), "{at}: {:?}", wrong(&mut page));
                    for (place, check) in checks.iter().enumerate() {
                        let by = page.text(&format!("{panel}.querySelectorAll('.by')[{place}].textContent"));
                        let own = pretty(&check[1..]);
                        let own = if own.is_empty() { own } else { format!(" ({own})") };
                        let is_sign = by.split(' ').count() == own.split(' ').count();
                        assert!(alike(&own, &by) || is_sign && own.contains("10−"), "{at}: {by}, not {own}");
                    }
                    let words = page.text(&format!("{panel}.querySelector('.says').textContent"));
                    assert_eq!(words.is_empty(), said.is_empty(), "{at}: {words}");
                }
            }
            let field = format!("{panel}.querySelector('.number input[type=number]')");
            page.get(&format!("({field}.value = 1e99, {field}.dispatchEvent(new Event('input')))"));
            page.wait(&format!("{panel}.querySelector('.says').textContent.includes(' goes from ')"));
            act(&mut page, Means::Mouse, &format!("{panel}.querySelector('.reset')"), 0.5, "");
            let shown = format!(
                "[...{panel}.querySelectorAll('dd > output')].every((output) => output.textContent === \
                 output.dataset.value.replaceAll('-', '−').replace(/e(−?\\d+)/g, '·10$1'))"
            );
            page.wait(&shown);
        }
        assert_eq!(page.text("location.href"), page_address, "the page was turned");
        assert_eq!(page.console(), Vec::<String>::new(), "{name}");
    }
}

#[test]
fn what_is_typed_is_taken_as_it_can_be_and_what_tells_of_other_numbers_is_struck_out() {
    let Some(mut browser) = open("typed") else { return };
    let of = |page: &str, name: &str| {
        let own = |snippet: &&Snippet| {
            snippet.place.starts_with(page) && snippet.live.iter().any(|live| live.name == name)
        };
        SNIPPETS.iter().find(own).expect("the snippet")
    };
    for (name, number, typed, taken, says, struck) in [
        ("wobble-plate", "count", "3.7", "4", "count: it is taken as 4.", ""),
        (
            "wobble-plate",
            "count",
            "-9",
            "1",
            "count goes from 1 to 7: it is taken as 1.",
            "the frame is quiet",
        ),
        ("air-drag", "ratio", "0.5", "0.50", "", "With I₃/I₁ = 2 a thin disc"),
        ("laundromat", "load_mass", "1e6", "20.0", "load_mass goes from 0.1 to 20: it is taken as 20.", ""),
    ] {
        let snippet = of(&format!("book/{name}/index.md"), number);
        let mut page = browser.page(WIDE);
        page.go(&format!("{}{name}/index.html", address()));
        let panel = format!("document.querySelector('.answers[data-snippet=\"{}\"]')", snippet.number);
        let code = format!("{panel}.parentElement.querySelector('code').textContent");
        page.get(&format!("{panel}.scrollIntoView()"));
        let field = format!("{panel}.querySelector('[type=number][data-name={number}]')");
        page.get(&format!("({field}.value = '{typed}', {field}.dispatchEvent(new Event('input')))"));
        page.wait(&format!("{code}.includes('let {number} = {taken};')"));
        let place = snippet.live.iter().position(|live| live.name == number).expect("its place");
        let mut live: Vec<f64> = snippet.live.iter().map(|live| live.value).collect();
        live[place] = taken.parse().expect("a number");
        let lines = snippet.run(&live);
        let first = lines[0][1..].replace('-', "−");
        page.wait(&format!("{panel}.querySelector('dd > output').textContent === '{first}'"));
        page.wait(&format!("{panel}.querySelector('.says').textContent.includes('{says}')"));
        let all = "[...document.querySelectorAll('.of-text')].map((node) => node.textContent).join()";
        if struck.is_empty() {
            continue;
        }
        let seen = page.text(all);
        assert!(seen.contains(struck), "{name}: {seen}");
        assert_eq!(page.get(&format!("{panel}.querySelector('.note-of-text').hidden")), false, "{name}");
        page.get(&format!("{panel}.querySelector('.reset').click()"));
        page.wait(&format!("{all} === ''"));
        assert_eq!(page.get(&format!("{panel}.querySelector('.note-of-text').hidden")), true, "{name}");
        assert_eq!(page.console(), Vec::<String>::new(), "{name}");
    }
}

/// Words and numbers as the page shows them: a true minus, and powers of ten, without a one before them.
fn pretty(text: &str) -> String {
    let letters: Vec<char> = text.chars().collect();
    let mut out = String::new();
    for (place, letter) in letters.iter().enumerate() {
        let is_power = place > 0
            && letters[place - 1].is_ascii_digit()
            && letters.get(place + 1).is_some_and(|next| next.is_ascii_digit() || *next == '-');
        match letter {
            'e' if is_power => {
                let is_one = out.ends_with('1')
                    && !out[..out.len() - 1].ends_with(|c: char| c.is_ascii_digit() || c == '.');
                out.truncate(out.len() - usize::from(is_one));
                out += if is_one { "10" } else { "·10" };
            }
            '-' => out.push('−'),
            other => out.push(*other),
        }
    }
    out
}

/// Whether a number is what rounding leaves of nothing: another machine rounds otherwise.
fn is_rounding(number: &str) -> bool {
    number.rsplit_once("10−").is_some_and(|(_, power)| power.parse::<u32>().is_ok_and(|power| power >= 10))
}
