//! Mathematics that has been set: what the typesetter makes of a formula, or a table of such for a program without one.

use std::borrow::Cow;
use std::cell::Cell;

thread_local! {
    static TABLE: Cell<Option<&'static [Symbol]>> = const { Cell::new(None) };
}

/// A formula that has been set: everything in ems of the label's size, y upwards from the baseline.
#[derive(Debug, Clone, PartialEq)]
pub struct Symbol {
    /// The formula, as it stands between `$` signs.
    pub source: Cow<'static, str>,
    /// The room that it takes along its line.
    pub width: f64,
    /// How far its ink reaches up.
    pub high: f64,
    /// How far its ink reaches up at its lowest: negative below the baseline.
    pub low: f64,
    /// Its signs.
    pub glyphs: Cow<'static, [Glyph]>,
    /// Its rules: left, bottom, width, height.
    pub rules: Cow<'static, [[f64; 4]]>,
}

/// A sign of a formula.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Glyph {
    /// Its outline in font units: 0 move, 1 line, 2 quadratic, 3 cubic, 4 close, each followed by its coordinates.
    pub outline: &'static [i16],
    /// Where its ink begins and ends, font units.
    pub left: i16,
    /// See [`left`](Self::left).
    pub right: i16,
    /// Font units of an em.
    pub units_per_em: f64,
    /// Where it stands, ems.
    pub x: f64,
    /// See [`x`](Self::x).
    pub y: f64,
    /// Its size, ems: below 1 in scripts.
    pub scale: f64,
}

/// Does some work in which labels may use the formulas of a table and no others, so that it draws the same with and
/// without a typesetter.
pub fn with_symbols<T>(table: &'static [Symbol], work: impl FnOnce() -> T) -> T {
    let before = TABLE.replace(Some(table));
    let done = work();
    TABLE.set(before);
    done
}

/// The table that labels may use, if they may use no other formula.
pub(super) fn table() -> Option<&'static [Symbol]> {
    TABLE.get()
}
