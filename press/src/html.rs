//! Text as HTML.

use live::numbers::tied;

/// Text in which nothing is markup any more.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// The same, its numbers tied to their units.
pub(crate) fn prose(text: &str) -> String {
    escaped(&tied(text))
}
