//! The letters of words, as a Rust table: for pictures that must look the same without the page's sans.

use crate::outline::outline;
use read_fonts::model::Font;
use std::error::Error;
use std::fmt::Write as _;

const FONT: &str = "font/open-sans.ttf";

pub(crate) fn write() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed={FONT}");
    let font = Font::new(std::fs::read(FONT)?, 0).ok_or("no font")?;
    let mut out = String::from("static LETTERS: &[(char, u16, &[i16])] = &[\n");
    for character in ' '..='\u{ffff}' {
        let Some(glyph) = font.charmap().map_unicode(character) else {
            continue;
        };
        let advance = font.glyph_metrics().h_advance(glyph);
        writeln!(out, "({character:?}, {advance}, &{:?}),", outline(&font, glyph)?)?;
    }
    out.push_str("];\n");
    let path = std::path::Path::new(&std::env::var("OUT_DIR")?).join("letters.rs");
    Ok(std::fs::write(path, out)?)
}
