//! Sets formulas, and writes them as a table for programs without a typesetter.

use super::layout::{self, Set};
use super::symbol::{Glyph, Symbol};
use super::{flaw, tex};
use crate::flaw::Flaw;
use std::fmt::Write as _;

/// Sets a formula of a label.
pub(super) fn set(formula: &str) -> Result<Symbol, String> {
    let Set { width, high, low, glyphs, rules, .. } = layout::set(&tex::parse(formula)?, 0)?;
    let source = formula.to_owned().into();
    Ok(Symbol { source, width, high, low, glyphs: glyphs.into(), rules: rules.into() })
}

/// A table of formulas as Rust, to be compiled into a program that depends on this crate and has no typesetter: an
/// expression of the type `&'static [drawing::Symbol]`, for [`with_symbols`](super::with_symbols).
///
/// # Errors
/// [`Flaw`] for a formula that cannot be set.
///
/// ```
/// let table = drawing::symbols_of([r"\omega_3"])?;
/// assert!(table.starts_with("&[::drawing::Symbol { source: ::std::borrow::Cow::Borrowed(\"\\\\omega_3\")"));
/// # Ok::<(), drawing::Flaw>(())
/// ```
pub fn symbols_of<'a>(formulas: impl IntoIterator<Item = &'a str>) -> Result<String, Flaw> {
    let mut out = "&[".to_owned();
    for formula in formulas {
        let Symbol { width, high, low, glyphs, rules, .. } =
            set(formula).map_err(|why| flaw(formula, &why))?;
        let cow = "::std::borrow::Cow::Borrowed";
        let _ = write!(
            out,
            "::drawing::Symbol {{ source: {cow}({formula:?}), width: {width:?}, high: {high:?}, low: {low:?}, \
             rules: {cow}(&{rules:?}), glyphs: {cow}(&["
        );
        for Glyph { outline, left, right, units_per_em, x, y, scale } in glyphs.iter() {
            let _ = write!(
                out,
                "::drawing::Glyph {{ outline: &{outline:?}, left: {left}, right: {right}, \
                 units_per_em: {units_per_em:?}, x: {x:?}, y: {y:?}, scale: {scale:?} }}, "
            );
        }
        out += "]) },\n";
    }
    Ok(out + "]")
}
