//! The headings of a page: one title, first, and below it no level left out.

use crate::fault::Reporter;
use crate::read::items::{Item, PlacedItem};

pub(crate) fn check(items: &[PlacedItem<'_>], report: &mut Reporter<'_>) {
    let mut above = 0;
    for placed in items {
        let Item::Heading { level, label, title, .. } = &placed.item else { continue };
        let mut fault = |message: String| report.fault(placed.range.start, message);
        let marks = |level: u8| "#".repeat(usize::from(level));
        match (above, *level) {
            (0, 1) => {}
            (0, _) => fault("a page begins with a title, `# …`".to_owned()),
            (_, 1) => fault("a second title: a page has one, and its sections begin with `##`".to_owned()),
            (_, level) if level > above + 1 => {
                fault(format!("the outline jumps from `{}` to `{}`", marks(above), marks(level)));
            }
            _ => {}
        }
        if title.is_empty() && label.is_none() {
            fault("the heading is empty".to_owned());
        }
        above = *level;
    }
    if above == 0 {
        report.fault(0, "the page has no title: it begins with `# …`");
    }
}
