//! The panel beside a snippet with live numbers: their fields, what the snippet prints, and what its assertions find.
//!
//! It is printed with the values of the text; the page's script keeps it true when a reader changes them.

use crate::book::script;
use dialect::live_numbers::{Answers, Live, Of, Remark, Value};
use html::{breakable, escaped};
use live::numbers::{tied, with_power};

/// The panel of the snippet with this number among those of the book.
pub(crate) fn panel(answers: &Answers<'_>, snippet: usize, chapter: &str) -> String {
    let live: String = answers
        .live
        .iter()
        .enumerate()
        .map(|(n, live)| field(live, &format!("answers-{snippet}-{n}")))
        .collect();
    let values: String = answers.values.iter().map(value).collect();
    let values = if values.is_empty() { values } else { format!("<dl>\n{values}</dl>\n") };
    let checks: String = answers
        .checks
        .iter()
        .map(|words| {
            format!(
                "<li class=\"holds\"><span class=\"sign\"></span><b>holds</b><span>: {}</span><span class=\"by\"></span></li>\n",
                escaped(&tied(words))
            )
        })
        .collect();
    let checks = if checks.is_empty() { checks } else { format!("<ul>\n{checks}</ul>\n") };
    let remarks: String = answers.remarks.iter().map(remark).collect();
    let note = match answers.remarks.is_empty() {
        true => "",
        false => {
            "<p class=\"note-of-text\" hidden>Comments that are struck out are about the numbers of the text.</p>\n"
        }
    };
    format!(
        "<div class=\"answers\" data-snippet=\"{snippet}\" data-module=\"{}\" role=\"group\" aria-label=\"Try other numbers\">\n\
         {live}{values}{checks}<p class=\"says\" role=\"status\"></p>\n{note}{remarks}\
         <button type=\"button\" class=\"reset\" disabled>Numbers of the text</button>\n</div>",
        script(chapter)
    )
}

/// What a reader changes a number with.
fn field(live: &Live<'_>, id: &str) -> String {
    let Live { name, literal, least, most, step, unit, .. } = live;
    let decimals = decimals(literal).max(decimals(&step.to_string()));
    let comma = if unit.is_empty() { "" } else { ", " };
    let unit = escaped(unit);
    let range = format!("min=\"{least}\" max=\"{most}\" step=\"{step}\" value=\"{literal}\"");
    format!(
        "<div class=\"number\"><label for=\"{id}\"><code>{name}</code></label><span><input type=\"number\" id=\"{id}\" \
         inputmode=\"decimal\" data-name=\"{name}\" data-decimals=\"{decimals}\" {range}>\
         <span class=\"unit\">{unit}</span></span>\
         <input type=\"range\" {range} aria-label=\"{name}{comma}{unit}\"></div>\n"
    )
}

/// A comment of the code that may be false when a number has been changed, for the script.
fn remark(remark: &Remark<'_>) -> String {
    let of = match &remark.of {
        Of::Numbers(names) => format!("data-of=\"{}\"", names.join(" ")),
        Of::Check(place) => format!("data-check=\"{place}\""),
    };
    format!("<i hidden {of} data-words=\"{}\"></i>\n", escaped(remark.words))
}

fn value(value: &Value<'_>) -> String {
    let Value { code, numbers, unit } = value;
    let gap = if unit.is_empty() { "" } else { "\u{a0}" };
    let (code, unit) = (breakable(&escaped(code)), escaped(unit));
    format!(
        "<div><dt><code>{code}</code></dt><dd><output data-value=\"{numbers}\">{}</output>{gap}{unit}</dd></div>\n",
        pretty(numbers)
    )
}

/// Numbers in the page's form: a true minus, and powers of ten.
fn pretty(numbers: &str) -> String {
    let one = |number: &str| match number.split_once('e') {
        Some((digits, power)) => with_power(digits, power),
        None => number.replace('-', "−"),
    };
    numbers.split(", ").map(one).collect::<Vec<_>>().join(", ")
}

/// How many digits a number has behind its point.
fn decimals(number: &str) -> usize {
    number.split_once('.').map_or(0, |(_, decimals)| decimals.len())
}
