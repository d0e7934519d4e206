//! The letters of words, as a Rust table: for pictures that must look the same without the page's sans.

use crate::outline::outline;
use read_fonts::model::Font;
use std::error::Error;
use std::fmt::Write as _;

const FONT: &str = "font/open-sans.ttf";

pub(crate) fn write() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed={FONT}");
    let font = Font::new(std::fs::read(FONT)?, 0).ok_or("no font")?;
    // Apart, so that a module of live scenes carries no outlines.
    let mut advances = String::from("static ADVANCES: &[(char, u16)] = &[\n");
    let mut outlines = String::from("static OUTLINES: &[&[i16]] = &[\n");
    for character in ' '..='\u{ffff}' {
        let Some(glyph) = font.charmap().map_unicode(character) else {
            continue;
        };
        writeln!(advances, "({character:?}, {}),", font.glyph_metrics().h_advance(glyph))?;
        writeln!(outlines, "&{:?},", outline(&font, glyph)?)?;
    }
    let path = std::path::Path::new(&std::env::var("OUT_DIR")?).join("letters.rs");
    Ok(std::fs::write(path, advances + "];\n" + &outlines + "];\n")?)
}
