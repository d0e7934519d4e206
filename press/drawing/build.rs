//! Takes the glyphs and the measures that labels need out of the fonts and writes them as Rust tables, so that the
//! crate `drawing` needs neither the fonts nor a font parser.

#[cfg(feature = "typesetter")]
#[path = "build/font.rs"]
mod font;
#[path = "build/letters.rs"]
mod letters;
#[path = "build/outline.rs"]
mod outline;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo::rerun-if-changed=build");
    letters::write()?;
    #[cfg(feature = "typesetter")]
    font::write()?;
    Ok(())
}
