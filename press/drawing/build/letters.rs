//! The letters of words, as a Rust table: for pictures that must look the same without the page's sans.

use crate::outline::Outline;
use std::error::Error;
use std::fmt::Write as _;
use ttf_parser::Face;

const FONT: &str = "font/open-sans.ttf";

pub(crate) fn write() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed={FONT}");
    let data = std::fs::read(FONT)?;
    let face = Face::parse(&data, 0)?;
    let mut out = String::from("static LETTERS: &[(char, u16, &[i16])] = &[\n");
    for character in ' '..='\u{ffff}' {
        let Some(glyph) = face.glyph_index(character) else {
            continue;
        };
        let advance = face.glyph_hor_advance(glyph).ok_or("a glyph without advance")?;
        let mut outline = Outline::default();
        face.outline_glyph(glyph, &mut outline);
        writeln!(out, "({character:?}, {advance}, &{:?}),", outline.0)?;
    }
    out.push_str("];\n");
    let path = std::path::Path::new(&std::env::var("OUT_DIR")?).join("letters.rs");
    Ok(std::fs::write(path, out)?)
}
