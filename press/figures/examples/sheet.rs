//! Writes every figure of the book into a folder, to be looked at: `cargo run -p figures --example sheet -- DIR`.
//!
//! `DIR/sheet.html` shows them as a page would, in its light or dark theme as the browser prefers; beside it
//! lies each figure as an SVG file of its own.

use std::error::Error;
use std::fs;
use std::path::PathBuf;

const STYLE: &str = include_str!("../../../book/theme/figures.css");

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).ok_or("which folder shall the figures go to?")?);
    fs::create_dir_all(&folder)?;
    let mut page = format!(
        "<!doctype html><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\"><title>Figures</title>\n\
         <style>:root {{ color-scheme: light dark; --bg: light-dark(#fff, hsl(226, 23%, 11%)); --fg: light-dark(#000, #bcbdd0); }}\n\
         body {{ background: var(--bg); color: var(--fg); font: 16px \"Open Sans\", sans-serif; max-width: 750px; margin: 0 auto; }}\n\
         figure {{ margin: 1.5em 0; }}\n{STYLE}</style>\n"
    );
    let figures = figures::all()
        .map_err(|failures| failures.iter().map(|failure| format!("\n{failure}")).collect::<String>())?;
    for figure in figures {
        fs::write(folder.join(format!("{}.svg", figure.id.replace(':', "-"))), &figure.standalone)?;
        page +=
            &format!("<h2>{}</h2>\n<figure id=\"{}\">\n{}\n</figure>\n", figure.id, figure.id, figure.svg);
        println!("{} {} bytes", figure.id, figure.svg.len());
    }
    fs::write(folder.join("sheet.html"), page)?;
    Ok(())
}
