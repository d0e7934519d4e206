//! Snippets: with the numbers of the equations that they cite, with the panel of their live numbers beside them, their
//! checks folded.

use super::Printer;
use crate::print::live_numbers_panel;
use crate::read::folded_assertions::{self, Folded};
use crate::read::snippets;
use crate::site::rustdoc;
use dialect::live_numbers;
use dialect::markdown::code_lines;

impl Printer<'_, '_> {
    /// A snippet with numbers for the labels that it cites, its checks folded, and what it uses of the library.
    pub(super) fn snippet(&mut self, code: &str, offset: usize) -> String {
        let mut shown = String::with_capacity(code.len());
        let mut done = 0;
        for (place, label) in snippets::cited_equations(code) {
            match self.registry.find(&label) {
                Ok(entry) => {
                    shown.push_str(&code[done..place.start]);
                    shown.push_str(&format!("({})", entry.number));
                    done = place.end;
                }
                Err(message) => self.fault(offset + place.start, message),
            }
        }
        shown.push_str(&code[done..]);
        let panel = self.panel(&shown);
        with_folded_checks(&without_ranges(&shown), panel.as_deref())
            + &rustdoc::uses(self.library, code).map_or(String::new(), |line| format!("\n\n{line}\n"))
    }

    /// The panel of a snippet that has live numbers.
    fn panel(&mut self, shown: &str) -> Option<String> {
        let lines: Vec<&str> = shown.lines().collect();
        let (answers, _) = live_numbers::answers(&lines);
        (!answers.live.is_empty() && !self.drawn.is_still).then(|| {
            *self.live += 1;
            live_numbers_panel::panel(
                &answers,
                *self.live - 1,
                self.page.path.split('/').next().unwrap_or_default(),
            )
        })
    }
}

/// A fenced block with the units of its live numbers, whose ranges only the panel beside it knows.
fn without_ranges(block: &str) -> String {
    let shown = |line: &str| match live_numbers::live(line) {
        Some(Ok(live)) => {
            let unit = if live.unit.is_empty() { String::new() } else { format!(" // {}", live.unit) };
            format!("{}{}{}{unit}\n", live.before, live.literal, live.after)
        }
        _ => format!("{line}\n"),
    };
    block.lines().map(shown).collect()
}

/// A fenced block with the panel of its live numbers beside it, and with its last assertions in a block of
/// their own that opens on demand if they are many.
fn with_folded_checks(block: &str, panel: Option<&str>) -> String {
    let beside = |block: &str| match panel {
        Some(panel) => format!("<div class=\"answering\">\n\n{block}\n\n{panel}\n</div>\n"),
        None => block.to_owned(),
    };
    let lines: Vec<&str> = block.lines().collect();
    let code = code_lines(&lines);
    let Some(Folded { from, count }) = folded_assertions::folded(&lines[code.clone()]) else {
        return beside(block);
    };
    let cut = code.start + from;
    let words = lines[0].trim_start_matches(['`', '~']).len();
    let fence = &lines[0][..lines[0].len() - words];
    if lines[code.end..] != [fence] {
        return beside(block); // in a list or a quotation, where a block cannot be cut in two
    }
    let (shown, hidden) = (lines[..cut].join("\n"), lines[cut..code.end].join("\n"));
    let noun = if count == 1 { "check" } else { "checks" };
    let shown = beside(&format!("{}\n{fence}", shown.trim_end()));
    format!(
        "{shown}\n\n<details class=\"checks\">\n<summary>{count} {noun}</summary>\n\n{}\n{hidden}\n{fence}\n\n</details>\n",
        lines[0],
    )
}
