//! Tables: their cells, and how a column of numbers is set.

use crate::numbers::with_power;
use crate::page::{Cell, Table, Words};
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
            Event::Start(Tag::TableCell) => cell = Some(Cell { offset: range.start, words: Vec::new() }),
            Event::End(TagEnd::TableCell) => {
                if let (Some(row), Some(cell)) = (table.rows.last_mut(), cell.take()) {
                    row.push(cell);
                }
            }
            event => {
                if let Some(cell) = &mut cell {
                    cell.words.push((event.clone(), range.start));
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
) -> Option<(Words<'a>, Range<usize>)> {
    let Some((Event::Start(Tag::Paragraph), range)) = events.first() else {
        return None;
    };
    let first = text[range.clone()].strip_prefix(CAPTION)?;
    let words = events[1..].iter().map(|(event, range)| (event.clone(), range.start));
    let mut words: Words<'a> =
        words.take_while(|(event, _)| !matches!(event, Event::End(TagEnd::Paragraph))).collect();
    if let Some((Event::Text(text), _)) = words.first_mut()
        && !first.trim().is_empty()
    {
        *text = text[CAPTION.len().min(text.len())..].to_owned().into();
    }
    Some((words, range.clone()))
}

/// A column of numbers: how many digits its cells have at most behind the point and in the power of ten.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Column {
    decimals: usize,
    power: usize,
}

/// Each column of a table that holds numbers; `None` for any other.
pub(crate) fn columns(table: &Table<'_>) -> Vec<Option<Column>> {
    let count = table.rows.first().map_or(0, Vec::len);
    let column = |n: usize| {
        let cells = table.rows.iter().skip(1).filter_map(|row| row.get(n)).map(plain);
        let (mut numbers, mut most) = (0, Column::default());
        for cell in cells {
            match cell.as_deref().map(digits) {
                Some(Some(Column { decimals, power })) => {
                    numbers += 1;
                    most = Column { decimals: most.decimals.max(decimals), power: most.power.max(power) };
                }
                // A dash, or a word such as "none".
                Some(None) if cell.as_ref().is_some_and(|word| is_word(word)) => {}
                _ => return None,
            }
        }
        (numbers > 1).then_some(most)
    };
    (0..count).map(column).collect()
}

/// The room that is left behind a cell so that its point stands below the others, as HTML: digits that it lacks,
/// and those that its power of ten lacks.
pub(crate) fn room(cell: &Cell<'_>, most: Column) -> String {
    let text = plain(cell).unwrap_or_default();
    let own = match digits(&text) {
        Some(own) => own,
        None if text.chars().count() == 1 => Column::default(), // a dash
        None => most,
    };
    let missing = most.decimals.saturating_sub(own.decimals);
    let point = if own.decimals == 0 && missing > 0 { "." } else { "" };
    let digits = format!("{point}{}", "0".repeat(missing));
    let power = if own.power > 0 { "0".repeat(most.power.saturating_sub(own.power)) } else { String::new() };
    let pad = |element: &str, digits: &str| match digits {
        "" => String::new(),
        digits => format!("<{element} class=\"pad\" data-pad=\"{digits}\"></{element}>"),
    };
    pad("span", &digits) + &pad("sup", &power)
}

/// The text of a cell that is nothing but text.
fn plain(cell: &Cell<'_>) -> Option<String> {
    let pieces = cell.words.iter().map(|(event, _)| match event {
        Event::Text(text) => Some(text.as_ref()),
        _ => None,
    });
    pieces.collect()
}

/// The digits of a number behind its point and in its power of ten; `None` if the text is none.
fn digits(text: &str) -> Option<Column> {
    let unsigned = |text: &str| text.trim_start_matches(['-', '−']).to_owned();
    let count = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit()).then_some(text.len());
    let number = unsigned(text.trim());
    let (mantissa, power) = number.split_once('e').unwrap_or((&number, ""));
    let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    count(whole).filter(|&length| length > 0)?;
    Some(Column { decimals: count(decimals)?, power: count(&unsigned(power))? })
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
                let power = with_power(mantissa, &format!("{}{digits}", if negative { "−" } else { "" }));
                out.push_str(power.strip_prefix("1·").unwrap_or(&power));
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
    use crate::markdown::options;
    use pulldown_cmark::Parser;

    /// The room behind the cells of each column of numbers, shortened.
    fn set(rows: &str) -> Vec<Option<Vec<String>>> {
        let text = format!("| a | b |\n|---|---|\n{rows}");
        let events: Vec<_> = Parser::new_ext(&text, options()).into_offset_iter().collect();
        let table = read(&events[1..]);
        let short = |html: String| {
            html.replace(" class=\"pad\" data-pad=", "").replace("\"></span>", "").replace("\"></sup>", "")
        };
        let columns = columns(&table).into_iter().enumerate().map(|(n, column)| {
            column.map(|most| table.rows[1..].iter().map(|row| short(room(&row[n], most))).collect())
        });
        columns.collect()
    }

    #[test]
    fn the_points_of_a_column_of_numbers_stand_below_one_another() {
        let rooms = |rooms: &[&str]| Some(rooms.iter().map(|&room| room.to_owned()).collect::<Vec<_>>());
        let columns = set("| 1 | a |\n| 2.25 | 1 |\n| – | 2 |\n| none | 3 |\n| −0.5 | 4 |\n");
        assert_eq!(columns, [rooms(&["<span\".00", "", "<span\".00", "", "<span\"0"]), rooms(&[""; 5])]);
        assert_eq!(set("| 200 turns | $1$ |\n| 7 | 2 |\n| 8 | 3 |\n"), [None, None]);
        let columns = set("| −4.77e−1 | none |\n| 2.2e-16 | 1 |\n");
        assert_eq!(columns, [rooms(&["<sup\"0", "<span\"0"]), None]);
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
