//! The math font's glyphs and measures, as the build script took them out of New Computer Modern Math, cut Book.

/// One glyph, in font units, y upwards.
#[derive(Debug)]
pub(super) struct Glyph {
    /// The character, or a number beyond Unicode for shapes without one.
    pub(super) key: u32,
    /// The key of the shape drawn for small sizes.
    pub(super) script: Option<u32>,
    pub(super) advance: u16,
    pub(super) low: i16,
    pub(super) high: i16,
    pub(super) left: i16,
    pub(super) right: i16,
    /// How far the top leans out to the right.
    pub(super) italic: i16,
    /// Where an accent is centred.
    pub(super) accent: i16,
    /// 0 move, 1 line, 2 quadratic, 3 cubic, 4 close, each followed by its coordinates.
    pub(super) outline: &'static [i16],
}

include!(concat!(env!("OUT_DIR"), "/math_font.rs"));

/// The glyph of a character or of a key beyond Unicode.
pub(super) fn glyph(key: u32) -> Option<&'static Glyph> {
    let index = GLYPHS.binary_search_by_key(&key, |glyph| glyph.key).ok()?;
    Some(&GLYPHS[index])
}

/// A measure of the font in units of the type size.
pub(super) fn em(units: i16) -> f64 {
    f64::from(units) / f64::from(UNITS_PER_EM)
}
