//! Tables, of a page and of the library: the points of a column of numbers stand below one another.

use super::Printer;
use crate::read::items::{Cell, Mention, Table, Words};
use crate::read::tables;
use dialect::markdown::options;
use live::numbers::{BLANK, tied};
use pulldown_cmark::{Event, Parser};
use std::fmt::Write as _;

/// The verdicts that have a square.
const VERDICTS: [&str; 3] = ["right", "slip", "wrong"];

/// The longest word that may stand in a column of numbers, in the place of one.
const LONGEST: usize = 16;

impl Printer<'_, '_> {
    /// A table that the library gives.
    pub(super) fn library_table(&mut self, name: &str, caption: &Words<'_>, offset: usize) -> Option<String> {
        let Some((_, text)) = self.drawn.tables.iter().find(|(known, _)| known == name) else {
            self.fault(offset, format!("the library gives no table `{name}`"));
            return None;
        };
        let events: Vec<_> = Parser::new_ext(text, options()).into_offset_iter().collect();
        let mut table = tables::read(&events);
        table.rows.iter_mut().flatten().flat_map(|cell| &mut cell.words).for_each(|word| word.1 = offset);
        Some(self.table(&table, caption))
    }

    /// A table as HTML, on as many lines as it has rows: no blank one, or Markdown would read on.
    pub(super) fn table(&mut self, table: &Table<'_>, caption: &Words<'_>) -> String {
        let caption = self.words_of(caption, "caption");
        let mut out = self.squares(table).unwrap_or_default();
        let _ =
            write!(out, "<div class=\"table-wrapper\">\n<table>\n<caption>{caption}</caption>\n<thead>\n");
        let columns = columns(table);
        for (n, row) in table.rows.iter().enumerate() {
            out.push_str("<tr>");
            for (cell, column) in row.iter().zip(&columns) {
                let (element, scope) = if n == 0 { ("th", " scope=\"col\"") } else { ("td", "") };
                let class = if column.is_some() { " class=\"number\"" } else { "" };
                let words = self.words_of(&cell.words, "table");
                let room = column.filter(|_| n > 0).map(|most| room(cell, most)).unwrap_or_default();
                let _ = write!(out, "<{element}{scope}{class}>{words}{room}</{element}>");
            }
            out.push_str(if n == 0 { "</tr>\n</thead>\n<tbody>\n" } else { "</tr>\n" });
        }
        out + "</tbody>\n</table>\n</div>\n"
    }

    /// Above a table of verdicts, whose rows begin with a number of the source and have a verdict in their third cell: a
    /// square for each row, which leads to the equation and has the first word of the verdict for its class.
    fn squares(&mut self, table: &Table<'_>) -> Option<String> {
        let mut squares = String::new();
        for row in table.rows.iter().skip(1) {
            let [number, verdict] = [0, 2].map(|n| row.get(n).map(first_text).unwrap_or_default());
            let number = number.strip_prefix("@source:")?.parse().ok()?;
            let target = self.mention(&Mention::Source(number), "", row[0].offset)?.target;
            let verdict =
                verdict.split(|c: char| !c.is_alphabetic()).next().filter(|word| VERDICTS.contains(word))?;
            let _ = write!(
                squares,
                "<a class=\"{verdict}\" href=\"{target}\" title=\"({number}) of the source: {verdict}\">{number}</a> "
            );
        }
        (!squares.is_empty()).then(|| format!("<p class=\"squares\">{squares}</p>\n"))
    }
}

/// A column of numbers: how many digits its cells have at most behind the point and in the power of ten.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct Column {
    decimals: usize,
    power: usize,
}

/// Each column of a table that holds numbers; `None` for any other.
fn columns(table: &Table<'_>) -> Vec<Option<Column>> {
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
fn room(cell: &Cell<'_>, most: Column) -> String {
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

/// The first text of a cell, outside of formulas.
fn first_text<'a>(cell: &'a Cell<'_>) -> &'a str {
    let mut texts = cell.words.iter().filter_map(|(event, _)| match event {
        Event::Text(text) => Some(text.as_ref()),
        _ => None,
    });
    texts.next().unwrap_or_default()
}

/// The digits of a number behind its point and in its power of ten; `None` if the text is none.
fn digits(text: &str) -> Option<Column> {
    let unsigned = |text: &str| text.trim_start_matches(['-', '−']).to_owned();
    let count = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit()).then_some(text.len());
    let number = unsigned(&tied(text.trim())).replace(BLANK, ""); // those between thousands
    let (mantissa, power) = number.split_once('e').unwrap_or((&number, ""));
    let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    count(whole).filter(|&length| length > 0)?;
    Some(Column { decimals: count(decimals)?, power: count(&unsigned(power))? })
}

fn is_word(text: &str) -> bool {
    text.chars().count() <= LONGEST && !text.contains(|c: char| c.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The room behind the cells of each column of numbers, shortened.
    fn set(rows: &str) -> Vec<Option<Vec<String>>> {
        let text = format!("| a | b |\n|---|---|\n{rows}");
        let events: Vec<_> = Parser::new_ext(&text, options()).into_offset_iter().collect();
        let table = tables::read(&events[1..]);
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
        assert_eq!(set("| 1 000.5 | 5 6 |\n| 12 345 | 7 |\n"), [rooms(&["", "<span\".0"]), None]);
        assert_eq!(set("| 200 turns | $1$ |\n| 7 | 2 |\n| 8 | 3 |\n"), [None, None]);
        let columns = set("| −4.77e−1 | none |\n| 2.2e-16 | 1 |\n");
        assert_eq!(columns, [rooms(&["<sup\"0", "<span\"0"]), None]);
    }
}
