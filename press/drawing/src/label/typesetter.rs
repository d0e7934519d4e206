//! Sets formulas, and writes them as a table for programs without a typesetter.

use super::symbol::{Glyph, Symbol};
use super::{flaw, font, layout, tex};
use crate::flaw::Flaw;
use std::fmt::Write as _;

/// Sets a formula of a label.
pub(super) fn set(formula: &str) -> Result<Symbol, String> {
    let set = layout::set(&tex::parse(formula)?, 0)?;
    let sign = |&(glyph, x, y, scale): &(&'static font::Glyph, f64, f64, f64)| Glyph {
        outline: glyph.outline,
        left: glyph.left,
        right: glyph.right,
        units_per_em: f64::from(font::UNITS_PER_EM),
        x,
        y,
        scale,
    };
    let glyphs = set.glyphs.iter().map(sign).collect();
    let source = formula.to_owned().into();
    Ok(Symbol { source, width: set.width, high: set.high, low: set.low, glyphs, rules: set.rules.into() })
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
