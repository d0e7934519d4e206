//! The list of figures, read from the text of `book/*/figures.rs` and its parts; the build script
//! uses it.

/// A figure as it stands in the text of its chapter.
#[derive(Debug, PartialEq)]
pub(crate) struct Found {
    /// Its label on the page, as in `fig:two-clocks`.
    pub(crate) id: String,
    /// The function that draws it, as in `two_clocks`.
    pub(crate) function: String,
    /// The line that names it.
    pub(crate) line: usize,
}

/// The name under which the figures of pages without a number stand, those of `book/figures.rs`.
#[cfg_attr(test, allow(dead_code, reason = "the build script asks for it"))]
pub(crate) const FRONT: &str = "figures";

/// The file that draws the figures of a chapter, as seen from the folder `book`.
#[cfg_attr(test, allow(dead_code, reason = "the build script asks for it"))]
pub(crate) fn file(chapter: &str) -> String {
    if chapter == FRONT { "figures.rs".into() } else { format!("{chapter}/figures.rs") }
}

/// The figures of a file: every function `pub(crate) fn two_clocks(…) -> Outcome` is the figure `fig:two-clocks`.
///
/// # Errors
/// The line and the fault of each function whose name makes no id.
pub(crate) fn figures(source: &str) -> Result<Vec<Found>, Vec<(usize, String)>> {
    let (mut found, mut faults) = (Vec::new(), Vec::new());
    for (index, text) in source.lines().enumerate() {
        let Some((function, rest)) =
            text.strip_prefix("pub(crate) fn ").and_then(|text| text.split_once('('))
        else {
            continue;
        };
        let line = index + 1;
        if !rest.contains("-> Outcome") {
            continue;
        }
        let sound = |part: &str| part.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit());
        if function.split('_').all(|part| !part.is_empty() && sound(part)) {
            let id = format!("fig:{}", function.replace('_', "-"));
            found.push(Found { id, function: function.into(), line });
        } else {
            let rule =
                "the name of a figure is lower-case letters and digits, with single underscores between";
            faults.push((line, format!("{function}: {rule}")));
        }
    }
    if faults.is_empty() { Ok(found) } else { Err(faults) }
}

/// The tables of a file: every function `pub(crate) fn methods() -> String` is the table `methods`.
pub(crate) fn tables(source: &str) -> impl Iterator<Item = &str> {
    source
        .lines()
        .filter_map(|line| line.strip_prefix("pub(crate) fn ")?.split_once("() -> String"))
        .map(|(name, _)| name)
}

#[cfg(test)]
mod tests {
    use super::{Found, figures, tables};

    #[test]
    fn every_function_that_gives_a_text_is_a_table() {
        let source = "fn row() -> String {\npub(crate) fn step_sizes() -> String {\npub(crate) fn f(x: f64) -> String {\n";
        assert_eq!(tables(source).collect::<Vec<_>>(), ["step_sizes"]);
    }

    #[test]
    fn every_function_that_draws_is_a_figure_of_its_name() {
        let source = "//! Figures.\nfn helper(id: &str) -> Outcome {\npub(crate) fn two_clocks(id: &str) -> Outcome {\n\
                      pub(crate) fn data() -> Result<(), Cause> {\npub(crate) fn drag2(id: &str) -> Outcome {\n";
        let found = |id: &str, function: &str, line| Found { id: id.into(), function: function.into(), line };
        assert_eq!(
            figures(source),
            Ok(vec![found("fig:two-clocks", "two_clocks", 3), found("fig:drag2", "drag2", 5)])
        );
        for name in ["Gimbal", "two__bodies", "_top", "top_", "kreisel_ä"] {
            let faults = figures(&format!("\npub(crate) fn {name}(id: &str) -> Outcome {{"));
            let [(2, fault)] = &faults.expect_err("no id")[..] else { panic!("one fault in line 2") };
            assert!(fault.starts_with(&format!("{name}: the name of a figure is ")), "{fault}");
        }
    }
}
