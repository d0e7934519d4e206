//! Tables: their cells, and how a column of numbers is set.

use crate::page::{Cell, Table};
use pulldown_cmark::{Event, Tag, TagEnd};
use std::ops::Range;

/// How the paragraph below a table begins that is its caption.
pub(crate) const CAPTION: &str = "Table: ";
/// The longest word that may stand in a column of numbers, in the place of one.
const LONGEST: usize = 16;

/// The table whose events these are, up to its end.
pub(crate) fn read<'a>(events: &[(Event<'a>, Range<usize>)]) -> Table<'a> {
    let mut table = Table::default();
    let mut cell = None;
    for (event, range) in events {
        match event {
            Event::End(TagEnd::Table) => break,
            Event::Start(Tag::TableHead | Tag::TableRow) => table.rows.push(Vec::new()),
            Event::Start(Tag::TableCell) => cell = Some(Cell { words: Vec::new(), offset: range.start }),
            Event::End(TagEnd::TableCell) => {
                if let (Some(row), Some(cell)) = (table.rows.last_mut(), cell.take()) {
                    row.push(cell);
                }
            }
            event => {
                if let Some(cell) = &mut cell {
                    cell.words.push(event.clone());
                }
            }
        }
    }
    table
}

/// The caption in the paragraph that these events begin with, if it is one: its words and its place.
pub(crate) fn caption<'a>(
    text: &str,
    events: &[(Event<'a>, Range<usize>)],
) -> Option<(Vec<Event<'a>>, Range<usize>)> {
    let Some((Event::Start(Tag::Paragraph), range)) = events.first() else {
        return None;
    };
    let first = text[range.clone()].strip_prefix(CAPTION)?;
    let words = events[1..].iter().map(|(event, _)| event.clone());
    let mut words: Vec<Event<'a>> =
        words.take_while(|event| !matches!(event, Event::End(TagEnd::Paragraph))).collect();
    if let Some(Event::Text(text)) = words.first_mut()
        && !first.trim().is_empty()
    {
        *text = text[CAPTION.len().min(text.len())..].to_owned().into();
    }
    Some((words, range.clone()))
}

/// For each column of numbers how many decimals its cells have at most; `None` for any other column.
pub(crate) fn decimals(table: &Table<'_>) -> Vec<Option<usize>> {
    let columns = table.rows.first().map_or(0, Vec::len);
    let column = |n: usize| {
        let cells = table.rows.iter().skip(1).filter_map(|row| row.get(n)).map(plain);
        let (mut numbers, mut most) = (0, 0);
        for cell in cells {
            match cell.as_deref().map(fraction) {
                Some(Some(fraction)) => {
                    numbers += 1;
                    most = most.max(fraction.len());
                }
                // A dash, or a word such as "none".
                Some(None) if cell.as_ref().is_some_and(|word| is_word(word)) => {}
                _ => return None,
            }
        }
        (numbers > 1).then_some(most)
    };
    (0..columns).map(column).collect()
}

/// What is left out behind a cell so that its decimal point stands below the others: `.00`.
pub(crate) fn padding(cell: &Cell<'_>, decimals: usize) -> String {
    let text = plain(cell).unwrap_or_default();
    let missing = match fraction(&text) {
        Some(fraction) => decimals - fraction.len(),
        None if text.chars().count() == 1 => decimals, // a dash
        None => 0,
    };
    let point = if missing == decimals && decimals > 0 { "." } else { "" };
    if missing == 0 { String::new() } else { format!("{point}{}", "0".repeat(missing)) }
}

/// The text of a cell that is nothing but text.
fn plain(cell: &Cell<'_>) -> Option<String> {
    let pieces = cell.words.iter().map(|event| match event {
        Event::Text(text) => Some(text.as_ref()),
        _ => None,
    });
    pieces.collect()
}

/// The decimals of a number, without the power of ten behind them; `None` if the text is none.
fn fraction(text: &str) -> Option<&str> {
    let unsigned = text.trim().trim_start_matches(['-', '−']);
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let (mantissa, power) = unsigned.split_once('e').unwrap_or((unsigned, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    (digits(whole)
        && (fraction.is_empty() || digits(fraction))
        && digits(power.trim_start_matches(['-', '−'])))
    .then_some(fraction)
}

fn is_word(text: &str) -> bool {
    text.chars().count() <= LONGEST && !text.contains(|c: char| c.is_ascii_digit())
}

/// HTML in which `1.6e8` is written as on paper, 1.6·10⁸, and `1e-3` as 10⁻³.
pub(crate) fn powers_of_ten(html: &str) -> String {
    let mut out = String::with_capacity(html.len());
    let mut rest = html;
    while let Some(at) = rest.find(|c: char| c.is_ascii_digit() || c == '<') {
        if rest[at..].starts_with('<') {
            let (tag, behind) = rest.split_at(rest[at..].find('>').map_or(rest.len(), |end| at + end + 1));
            out.push_str(tag);
            rest = behind;
            continue;
        }
        let glued = rest[..at].ends_with(|c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '#' | ';'));
        let end =
            at + rest[at..].find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(rest.len() - at);
        out.push_str(&rest[..at]);
        let mantissa = &rest[at..end];
        rest = &rest[end..];
        let power = rest.strip_prefix('e').filter(|_| !glued).and_then(|power| {
            let unsigned = power.strip_prefix(['-', '−']);
            let digits = unsigned.unwrap_or(power);
            let length = digits.bytes().take_while(u8::is_ascii_digit).count();
            let goes_on = digits[length..].starts_with(|c: char| c.is_alphanumeric());
            (length > 0 && !goes_on).then(|| (unsigned.is_some(), &digits[..length], &digits[length..]))
        });
        match power {
            Some((negative, digits, behind)) => {
                if mantissa != "1" {
                    out.push_str(&format!("{mantissa}·"));
                }
                out.push_str(&format!("10<sup>{}{digits}</sup>", if negative { "−" } else { "" }));
                rest = behind;
            }
            None => out.push_str(mantissa),
        }
    }
    out + rest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scan::options;
    use pulldown_cmark::Parser;

    /// The paddings of each column of numbers.
    fn set(rows: &str) -> Vec<Option<Vec<String>>> {
        let text = format!("| a | b |\n|---|---|\n{rows}");
        let events: Vec<_> = Parser::new_ext(&text, options()).into_offset_iter().collect();
        let table = read(&events[1..]);
        let columns = decimals(&table).into_iter().enumerate().map(|(n, decimals)| {
            decimals.map(|most| table.rows[1..].iter().map(|row| padding(&row[n], most)).collect())
        });
        columns.collect()
    }

    #[test]
    fn the_points_of_a_column_of_numbers_stand_below_one_another() {
        let columns = set("| 1 | a |\n| 2.25 | 1 |\n| – | 2 |\n| none | 3 |\n| −0.5 | 4 |\n");
        let numbers = [".00", "", ".00", "", "0"].map(str::to_owned).to_vec();
        assert_eq!(columns, [Some(numbers), Some(vec![String::new(); 5])]);
        assert_eq!(set("| 200 turns | $1$ |\n| 7 | 2 |\n| 8 | 3 |\n"), [None, None]);
        assert_eq!(
            set("| −4.77e−1 | none |\n| 2.2e-16 | 1 |\n"),
            [Some(vec![String::new(), "0".to_owned()]), None]
        );
    }

    #[test]
    fn powers_of_ten_are_written_as_on_paper() {
        let said =
            powers_of_ten("1e-3, −4.77e−1 and 1.6e8; v1e3 <a id=\"x-1e3\">&#1e3;</a> 2e 3 1.5 e2 0x1e3g");
        let sup = |power: &str| format!("10<sup>{power}</sup>");
        assert_eq!(
            said,
            format!(
                "{}, −4.77·{} and 1.6·{}; v1e3 <a id=\"x-1e3\">&#1e3;</a> 2e 3 1.5 e2 0x1e3g",
                sup("−3"),
                sup("−1"),
                sup("8")
            )
        );
    }
}
