//! Every figure of the book: the house plot style, and the collection of `book/*/figures.rs`.
//!
//! A figure is a function that takes what the library computes and returns a [`Drawing`]. Each chapter keeps
//! its figures in its own folder, in `figures.rs` and, where they are many, in `figures/`; this crate finds and
//! compiles those files and gives them the plot style ([`Plot`], [`Axis`]) and the drawing kit. Another build
//! script calls [`of`] for the chapters whose code has changed.

mod axis;
mod canvas;
mod failure;
pub mod house;
#[path = "../../src/limit.rs"]
mod limit;
#[cfg(test)]
mod list; // of the build script
mod look;
mod plot;
mod room;
mod sample;

/// The name of a table that the library gives, and what writes it.
type Table = (&'static str, fn() -> String);

// A module for each chapter, `ENTRIES`, every figure in the order of the book, and `TABLES`: the build script reads
// them off the files.
include!(concat!(env!("OUT_DIR"), "/figures.rs"));

pub use drawing::{Axis, Drawing, Room};
pub use failure::Failure;
pub use look::Look;
pub use plot::Plot;
pub use room::in_both;
pub use sample::{linear_steps, log_steps};

use drawing::Flaw;
use std::error::Error;
use std::{panic, thread};

/// The width of a column of text, px.
const COLUMN: f64 = 660.0;

/// Why a figure could not be drawn: whatever the library or the kit says.
pub type Cause = Box<dyn Error + Send + Sync>;

/// What a figure function returns: a drawing, or why there is none.
pub type Outcome = Result<Drawing, Cause>;

/// A figure to be drawn: its id on the page, its chapter, the file and the line that name it, the function
/// that draws it.
struct Entry {
    id: &'static str,
    chapter: &'static str,
    file: &'static str,
    line: usize,
    draw: fn(&str) -> Outcome,
}

/// A figure of the book, rendered.
#[derive(Debug, Clone)]
pub struct Figure {
    /// Its label on the page, as in `fig:machine`.
    pub id: String,
    /// The folder of the chapter that draws it, as in `laundromat`; `figures` for pages without a number.
    pub chapter: String,
    /// A short title, for readers who cannot see it.
    pub title: String,
    /// What it shows, in words, for readers who cannot see it.
    pub description: String,
    /// Its SVGs in the box that lays them out on a page; roles are classes of `book/theme/figures.css`.
    pub svg: String,
    /// Whether it is wider than a column of text, its panels side by side.
    pub wide: bool,
    /// An SVG file that stands alone, with its own style sheet for light and dark.
    pub standalone: String,
    /// What it was rendered from.
    pub drawing: Drawing,
}

/// The tables that the library gives, those of `book/tables.rs`: name and Markdown.
pub fn tables() -> impl Iterator<Item = (&'static str, String)> {
    TABLES.iter().map(|(name, written)| (*name, written()))
}

/// Draws every figure of the book, chapter by chapter.
///
/// # Errors
/// A [`Failure`] for each figure that could not be drawn, with its file and the reason.
pub fn all() -> Result<Vec<Figure>, Vec<Failure>> {
    of(|_| true)
}

/// Draws the figures of those chapters whose folders are `wanted`, each chapter on a thread of its own.
///
/// # Errors
/// As for [`all`].
pub fn of(wanted: impl Fn(&str) -> bool) -> Result<Vec<Figure>, Vec<Failure>> {
    let draw = |entry: &Entry| render(entry).map_err(|cause| failed(entry, cause));
    let drawn: Vec<Result<Figure, Failure>> = thread::scope(|scope| {
        let chapters = ENTRIES.chunk_by(|one, next| one.chapter == next.chapter);
        let threads: Vec<_> = chapters
            .filter(|chapter| wanted(chapter[0].chapter))
            .map(|chapter| scope.spawn(move || chapter.iter().map(draw).collect::<Vec<_>>()))
            .collect();
        threads
            .into_iter()
            .flat_map(|thread| thread.join().unwrap_or_else(|cause| panic::resume_unwind(cause)))
            .collect()
    });
    let (mut figures, mut failures) = (Vec::new(), Vec::new());
    for result in drawn {
        match result {
            Ok(figure) => figures.push(figure),
            Err(failure) => failures.push(failure),
        }
    }
    if failures.is_empty() { Ok(figures) } else { Err(failures) }
}

fn failed(entry: &Entry, cause: Cause) -> Failure {
    Failure { file: entry.file, line: entry.line, figure: entry.id, cause }
}

fn render(entry: &Entry) -> Result<Figure, Cause> {
    let _limit = limit::watch(format!("{}:{}: the figure {}", entry.file, entry.line, entry.id));
    let drawing = (entry.draw)(entry.id)?;
    let [title, description] = [drawing.title(), drawing.description()].map(|words| words.trim().is_empty());
    // A panel may leave the words to the whole, but not half of them.
    let mut parts = drawing.all_parts().into_iter();
    if title || description || parts.any(|part| part.title().is_empty() != part.description().is_empty()) {
        return Err("the figure lacks a title or a description for those who cannot see it".into());
    }
    Ok(Figure {
        id: entry.id.into(),
        chapter: entry.chapter.into(),
        title: drawing.title().into(),
        description: drawing.description().into(),
        svg: boxed(&drawing)?,
        wide: drawing.room() > COLUMN,
        standalone: drawing.to_standalone_svg()?,
        drawing,
    })
}

/// The SVGs of a figure in their box.
fn boxed(drawing: &Drawing) -> Result<String, Flaw> {
    let class = if drawing.all_parts().len() > 1 { "drawing panels" } else { "drawing" };
    Ok(format!("<div class=\"{class}\">\n{}\n</div>", drawing.to_svg()?))
}

#[cfg(test)]
mod tests {
    use super::{Axis, Drawing, Entry, Outcome, Plot, failed, render};
    use drawing::{Hue, Rect, Side, Stroke, at};

    /// What is said of a figure that is drawn by `draw`, in the third line of its file.
    fn said(draw: fn(&str) -> Outcome) -> String {
        let entry =
            Entry { id: "fig:typo", chapter: "nowhere", file: "book/nowhere/figures.rs", line: 3, draw };
        failed(&entry, render(&entry).expect_err("it is wrong")).to_string()
    }

    fn empty(id: &str) -> Drawing {
        Drawing::new(id, 100.0, 100.0).titled("A figure", "It shows nothing.")
    }

    /// A figure with one curve in a plot whose axes go from 1 to 10, logarithmic along y.
    fn curve(id: &str, values: &[(f64, f64)]) -> Outcome {
        let mut drawing = empty(id);
        let frame = Rect::new(30.0, 10.0, 60.0, 60.0);
        let mut plot = Plot::new(&mut drawing, frame, Axis::linear(1.0, 10.0, 3.0), Axis::log(1.0, 10.0, 1))?;
        plot.curve("body", values.iter().copied(), Stroke::Curve, Hue::Blue);
        Ok(drawing)
    }

    #[test]
    fn a_figure_that_fails_is_named_with_its_line() {
        let typo = |id: &str| {
            let mut drawing = empty(id);
            drawing.label(at(50.0, 50.0), Side::Over, r"$\omga$", Hue::Ink)?;
            Ok(drawing)
        };
        assert_eq!(
            said(typo),
            r"book/nowhere/figures.rs:3: fig:typo: label `$\omga$`: unknown command `\omga`"
        );
        for draw in
            [(|id| Ok(Drawing::new(id, 9.0, 9.0).titled("", "Words."))) as fn(&str) -> Outcome, |id| {
                Ok(Drawing::new(id, 9.0, 9.0).titled("Words", " "))
            }]
        {
            assert!(said(draw).contains("lacks a title or a description"));
        }
    }

    #[test]
    fn no_figure_is_drawn_without_what_is_no_number() {
        let nan = |id: &str| {
            let mut drawing = empty(id);
            drawing.line(at(1.0, 1.0), at(f64::NAN, 2.0), Stroke::Outline, Hue::Ink);
            Ok(drawing)
        };
        let gap = |id: &str| {
            let mut drawing = empty(id);
            let line = [at(1.0, 1.0), at(2.0, 2.0), at(3.0, f64::NAN), at(4.0, 4.0)];
            drawing.polyline(&line, Stroke::Curve, Hue::Blue);
            drawing.name_curve("path", 1);
            Ok(drawing)
        };
        for (draw, expected) in [
            (gap as fn(&str) -> Outcome, "the line path goes through (3, NaN)"),
            (nan as fn(&str) -> Outcome, "a line (f-line f-outline f-ink) goes through (NaN, 2)"),
            (|id| curve(id, &[(1.0, f64::NAN), (2.0, f64::NAN)]), "the curve body goes through (1, NaN)"),
            (
                |id| curve(id, &[(1.0, 2.0), (2.0, 3.0), (f64::INFINITY, 3.0), (3.0, 2.0)]),
                "the curve body goes through (inf, 3)",
            ),
            (|id| curve(id, &[(1.0, 2.0), (2.0, 3.0), (3.0, 0.0)]), "the curve body goes through (3, 0)"),
            (|id| curve(id, &[(20.0, 2.0), (30.0, 3.0)]), "no part of the curve body lies inside the frame"),
        ] {
            let said = said(draw);
            assert!(
                said.starts_with("book/nowhere/figures.rs:3: fig:typo: ") && said.contains(expected),
                "{said}"
            );
        }
        assert!(curve("fig:typo", &[(1.0, 2.0), (2.0, 3.0)]).expect("a plot").to_svg().is_ok());
    }
}
