//! Snippets: with the numbers of the equations that they cite, with the panel of their live numbers beside them, their
//! checks folded.

use super::Printer;
use crate::print::live_numbers_panel;
use crate::read::folded_assertions;
use crate::read::folded_assertions::Folded;
use crate::read::items::{Label, LabelKind};
use crate::read::snippets;
use crate::site::rustdoc;
use dialect::live_numbers;
use dialect::markdown::code_lines;

impl Printer<'_, '_> {
    /// A snippet with numbers for the labels that it cites, its checks folded, and what it uses of the library.
    pub(super) fn snippet(&mut self, code: &str, offset: usize) -> String {
        let mut shown = String::with_capacity(code.len());
        let mut done = 0;
        for (place, name) in snippets::cited_labels(code, &(0..code.len())) {
            let label = Label { kind: LabelKind::Equation, name: name["eq:".len()..].to_owned() };
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_checks_are_folded_into_a_block_of_their_own() {
        let checks = "assert!(a);\nassert!(\n    a\n);\n# Ok(())";
        assert_eq!(
            with_folded_checks(&format!("```rust\n# use x;\nlet a = 1;\n\n{checks}\n```\n"), None),
            format!(
                "```rust\n# use x;\nlet a = 1;\n```\n\n<details class=\"checks\">\n<summary>2 checks</summary>\n\n\
                 ```rust\n{checks}\n```\n\n</details>\n"
            )
        );
        let few = "```rust\nlet a = 1;\nassert!(a);\n```\n";
        assert_eq!(with_folded_checks(few, None), few);
    }

    #[test]
    fn a_live_number_shows_its_unit_and_a_panel_beside_it() {
        let block = "```rust\nlet a = 1.0; // live: 0..2 m\nlet b = 2; // live: 0..2\nf(); // → 3\n```";
        let shown = without_ranges(block);
        assert_eq!(shown, "```rust\nlet a = 1.0; // m\nlet b = 2;\nf(); // → 3\n```\n");
        assert_eq!(
            with_folded_checks(&shown, Some("<div>P</div>")),
            format!("<div class=\"answering\">\n\n{shown}\n\n<div>P</div>\n</div>\n")
        );
    }
}
