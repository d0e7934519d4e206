//! Takes the glyphs and the measures that labels need out of the mathematics font and writes them as a Rust
//! table, so that the crate `drawing` needs neither the font nor a font parser.

#[cfg(feature = "typesetter")]
#[path = "build/font.rs"]
mod font;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo::rerun-if-changed=build");
    #[cfg(feature = "typesetter")]
    font::write()?;
    Ok(())
}
