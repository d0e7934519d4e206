//! The outline of a glyph, as a Rust table has it.

use read_fonts::model::Font;
use read_fonts::model::glyph::outline::{DrawMemory, DrawOptions, PathElement};
use read_fonts::types::GlyphId;
use std::error::Error;

/// The outline as numbers: 0 move, 1 line, 2 quadratic, 3 cubic, 4 close, each followed by its coordinates. A glyph
/// without ink has none.
pub(crate) fn outline(font: &Font, glyph: GlyphId) -> Result<Vec<i16>, Box<dyn Error>> {
    let glyph = font.outline_glyphs().get(glyph).ok_or("a glyph without outline")?;
    let mut path = Vec::<PathElement>::new();
    glyph.draw(&DrawOptions::new(), DrawMemory::Scratch, &mut path).map_err(|error| format!("{error:?}"))?;
    let mut numbers = Vec::new();
    for element in path {
        let (command, coordinates) = match element {
            PathElement::MoveTo { x, y } => (0, vec![x, y]),
            PathElement::LineTo { x, y } => (1, vec![x, y]),
            PathElement::QuadTo { cx0, cy0, x, y } => (2, vec![cx0, cy0, x, y]),
            PathElement::CurveTo { cx0, cy0, cx1, cy1, x, y } => (3, vec![cx0, cy0, cx1, cy1, x, y]),
            PathElement::Close => (4, Vec::new()),
        };
        numbers.push(command);
        numbers.extend(coordinates.iter().map(|value| value.round() as i16));
    }
    Ok(numbers)
}
