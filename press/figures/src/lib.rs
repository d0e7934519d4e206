//! Every figure of the book: the house plot style, and the collection of `book/*/figures.rs`.
//!
//! A figure is a function that takes what the library computes and returns a [`Drawing`]. Each chapter keeps its figures in
//! its own folder, in `figures.rs`; this crate compiles those files and gives them the plot style ([`Plot`], [`Axis`]) and
//! the drawing kit. The press calls [`all`] while it is built, so Cargo renders again exactly what has changed.

mod axis;
mod failure;
mod plot;
mod sample;

/// The chapters with figures: a module for each `figures.rs`, and the list in the order of the book.
macro_rules! chapters {
    ($($name:ident in $folder:literal: $path:literal;)*) => {
        $(
            #[path = $path]
            mod $name;
        )*
        const CHAPTERS: &[(&str, &[Entry])] = &[$(($folder, $name::FIGURES)),*];
    };
}

chapters! {
    laundromat in "laundromat": "../../../book/laundromat/figures.rs";
    turning in "turning": "../../../book/turning/figures.rs";
    wobble_plate in "wobble-plate": "../../../book/wobble-plate/figures.rs";
    coin_toss in "coin-toss": "../../../book/coin-toss/figures.rs";
    space_station in "space-station": "../../../book/space-station/figures.rs";
    air_drag in "air-drag": "../../../book/air-drag/figures.rs";
    pinned_hoop in "pinned-hoop": "../../../book/pinned-hoop/figures.rs";
    rolling_wheel in "rolling-wheel": "../../../book/rolling-wheel/figures.rs";
    spinning_coin in "spinning-coin": "../../../book/spinning-coin/figures.rs";
    methods in "methods": "../../../book/methods/figures.rs";
    speed_and_accuracy in "speed-and-accuracy": "../../../book/speed-and-accuracy/figures.rs";
    hard_cases in "hard-cases": "../../../book/hard-cases/figures.rs";
}

pub use axis::Axis;
pub use drawing::Drawing;
pub use failure::{Failure, InvalidAxis};
pub use plot::Plot;
pub use sample::{linear_steps, log_steps};

use std::error::Error;

/// Why a figure could not be drawn: whatever the library or the kit says.
pub type Cause = Box<dyn Error + Send + Sync>;

/// What a figure function returns: a drawing, or why there is none.
pub type Outcome = Result<Drawing, Cause>;

/// A figure to be drawn: its id on the page and the function that draws it.
pub(crate) struct Entry {
    pub(crate) id: &'static str,
    pub(crate) draw: fn(&str) -> Outcome,
}

/// A figure of the book, rendered.
#[derive(Debug, Clone)]
pub struct Figure {
    /// Its label on the page, as in `fig:machine`.
    pub id: String,
    /// The folder of the chapter that draws it, as in `laundromat`.
    pub chapter: String,
    /// A short title, for readers who cannot see it.
    pub title: String,
    /// What it shows, in words, for readers who cannot see it.
    pub description: String,
    /// SVG to be put into a page; roles are classes of `book/theme/figures.css`.
    pub svg: String,
    /// An SVG file that stands alone, with its own style sheet for light and dark.
    pub standalone: String,
    /// What it was rendered from.
    pub drawing: Drawing,
}

/// Draws every figure of the book, chapter by chapter.
///
/// # Errors
/// A [`Failure`] for each figure that could not be drawn, or whose id another figure has, with its file and the reason.
pub fn all() -> Result<Vec<Figure>, Vec<Failure>> {
    let (mut figures, mut failures) = (Vec::<Figure>::new(), Vec::new());
    for (chapter, entries) in CHAPTERS {
        for entry in *entries {
            match render(chapter, entry) {
                Ok(figure) => match figures.iter().find(|other| other.id == figure.id) {
                    Some(other) => {
                        let cause =
                            format!("book/{}/figures.rs has a figure of this name too", other.chapter);
                        failures.push(Failure::new(chapter, entry.id, cause.into()));
                    }
                    None => figures.push(figure),
                },
                Err(failure) => failures.push(failure),
            }
        }
    }
    if failures.is_empty() { Ok(figures) } else { Err(failures) }
}

fn render(chapter: &str, entry: &Entry) -> Result<Figure, Failure> {
    let drawing = (entry.draw)(entry.id).map_err(|cause| Failure::new(chapter, entry.id, cause))?;
    Ok(Figure {
        id: entry.id.into(),
        chapter: chapter.into(),
        title: drawing.title().into(),
        description: drawing.description().into(),
        svg: drawing.to_svg(),
        standalone: drawing.to_standalone_svg(),
        drawing,
    })
}

#[cfg(test)]
mod tests {
    use super::{Drawing, Entry, render};
    use drawing::{Hue, Side, at};

    #[test]
    fn a_figure_that_fails_is_named() {
        let draw = |id: &str| {
            let mut drawing = Drawing::new(id, 100.0, 100.0);
            drawing.label(at(50.0, 50.0), Side::Over, r"$\omga$", Hue::Ink)?;
            Ok(drawing)
        };
        let failure = render("nowhere", &Entry { id: "fig:typo", draw }).expect_err("the label is wrong");
        assert_eq!(failure.figure(), "fig:typo");
        assert_eq!(
            failure.to_string(),
            r"book/nowhere/figures.rs: fig:typo: label `$\omga$`: unknown command `\omga`"
        );
    }
}
