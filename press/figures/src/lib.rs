//! Figures from code: the plot style, and how figures and tables become files that the press prints.
//!
//! A figure is a function that takes what a library computes and returns a [`Drawing`]. A chapter lists its own with
//! [`figures!`], and the build script of the book [writes](fn@write) all of them into its folder.

mod axis;
mod canvas;
mod plot;
mod room;

pub use drawing::{Axis, Drawing, Look, Room, linear_steps, log_steps};
pub use plot::Plot;
pub use room::in_both;

use drawing::Flaw;
use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Display;
use std::path::Path;
use std::process::ExitCode;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::{env, fs, thread};

/// The widest figure of the margin, and of the column of text with the band beside it, px.
const MARGIN: f64 = 340.0;
/// See [`MARGIN`].
const COLUMN: f64 = 660.0;

/// Why a figure could not be drawn: whatever the library or the kit says.
pub type Cause = Box<dyn Error + Send + Sync>;

/// What a figure function returns: a drawing, or why there is none.
pub type Outcome = Result<Drawing, Cause>;

/// A figure of a book: a function and its name. [`figures!`] makes them.
#[derive(Debug, Clone, Copy)]
pub struct Figure {
    /// The function, as the list names it: `parts::two_clocks` for `fig:two-clocks`.
    pub name: &'static str,
    /// The file that lists it, and the line of the list.
    pub file: &'static str,
    /// See [`file`](Self::file).
    pub line: u32,
    /// Draws it; it is given its id.
    pub draw: fn(&str) -> Outcome,
}

/// A list of figures, each by the path of the function that draws it: `figures![machine, parts::two_clocks]` is a
/// `&'static [Figure]` with `fig:machine` and `fig:two-clocks`.
#[macro_export]
macro_rules! figures {
    ($($($name:ident)::+),* $(,)?) => {
        &[$($crate::Figure {
            name: concat!($("::", stringify!($name)),+),
            file: file!(),
            line: line!(),
            draw: $($name)::+,
        }),*]
    };
}

/// A table that a library gives: its name and what writes it, in Markdown. [`tables!`] makes them.
#[derive(Debug, Clone, Copy)]
pub struct Table {
    /// The function: `step_sizes` for `table:step-sizes`.
    pub name: &'static str,
    /// Writes it.
    pub write: fn() -> String,
}

/// A list of tables, each by the function that writes it: `tables![step_sizes]` is a `&'static [Table]` with
/// `table:step-sizes`.
#[macro_export]
macro_rules! tables {
    ($($name:ident),* $(,)?) => {
        &[$($crate::Table { name: stringify!($name), write: $name }),*]
    };
}

impl Figure {
    /// Its label on a page, as in `fig:two-clocks`.
    pub fn id(&self) -> String {
        let function = self.name.rsplit("::").next().unwrap_or_default();
        format!("fig:{}", function.replace('_', "-"))
    }

    /// Draws it and writes its SVGs.
    ///
    /// # Errors
    /// What the figure says, or that it lacks words for those who cannot see it, behind its place and its name.
    pub fn render(&self) -> Result<Rendered, String> {
        rendered(self).map_err(|cause| self.failure(&cause))
    }

    fn failure(&self, why: impl Display) -> String {
        format!("{}:{}: {}: {why}", self.file, self.line, self.id())
    }
}

/// A figure, rendered.
#[derive(Debug, Clone)]
pub struct Rendered {
    /// Its label on the page, as in `fig:machine`.
    pub id: String,
    /// Its SVGs in the box that lays them out on a page; the page's style sheet gives their roles colours.
    pub svg: String,
    /// Where on a page it has room, its panels side by side: `margin`, `column`, or `wide`.
    pub place: &'static str,
    /// An SVG file that stands alone, with its own style sheet for light and dark.
    pub standalone: String,
    /// What it was rendered from.
    pub drawing: Drawing,
}

/// For a build script: renders all figures of a book and writes its tables, into Cargo's `OUT_DIR`, from where the
/// press reads them. `figures.txt` has a line `fig:name wide file` (or `column`, `margin`) for each figure, which is in
/// `name.inline.svg` for a page and in `name.svg` to stand alone; a table is in `name.md`. What fails is said with file
/// and line.
pub fn write(figures: &[&[Figure]], tables: &[Table]) -> ExitCode {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed=BOOK_ROOT"); // the program knows its figures by their place
    match written(figures, tables) {
        Ok(()) => ExitCode::SUCCESS,
        Err(faults) => {
            faults.iter().for_each(|fault| eprintln!("error: {fault}"));
            ExitCode::FAILURE
        }
    }
}

fn written(figures: &[&[Figure]], tables: &[Table]) -> Result<(), Vec<String>> {
    let one = |error: Cause| vec![error.to_string()];
    let out = env::var_os("OUT_DIR").ok_or_else(|| one("Cargo sets OUT_DIR".into()))?;
    let rendered = all(figures)?;
    let out = Path::new(&out);
    let mut list = String::new();
    let files = || -> Result<(), Cause> {
        fs::remove_dir_all(out)?; // a figure may be gone
        fs::create_dir_all(out)?;
        for (figure, source) in rendered.iter().zip(figures.iter().copied().flatten()) {
            let name = figure.id.trim_start_matches("fig:");
            fs::write(out.join(format!("{name}.inline.svg")), &figure.svg)?;
            fs::write(out.join(format!("{name}.svg")), &figure.standalone)?;
            list += &format!("{} {} {}\n", figure.id, figure.place, source.file.replace('\\', "/"));
        }
        for table in tables {
            fs::write(out.join(format!("{}.md", table.name.replace('_', "-"))), (table.write)())?;
        }
        Ok(fs::write(out.join("figures.txt"), list)?)
    };
    files().map_err(one)
}

/// Renders all figures, on all processors, in their order.
///
/// # Errors
/// A line for each figure that could not be drawn, with its file and the reason; also for two of one name.
pub fn all(figures: &[&[Figure]]) -> Result<Vec<Rendered>, Vec<String>> {
    let figures: Vec<&Figure> = figures.iter().copied().flatten().collect();
    let mut failures = twice(&figures);
    let next = AtomicUsize::new(0);
    let done = Mutex::new(BTreeMap::new());
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                while let Some(figure) = figures.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let rendered = figure.render();
                    done.lock().unwrap_or_else(PoisonError::into_inner).insert(figure.id(), rendered);
                }
            });
        }
    });
    let mut done = done.into_inner().unwrap_or_else(PoisonError::into_inner);
    let mut rendered = Vec::new();
    for figure in figures.iter().filter_map(|figure| done.remove(&figure.id())) {
        match figure {
            Ok(figure) => rendered.push(figure),
            Err(failure) => failures.push(failure),
        }
    }
    if failures.is_empty() { Ok(rendered) } else { Err(failures) }
}

/// A line for each figure whose name another one has.
fn twice(figures: &[&Figure]) -> Vec<String> {
    let mut known = BTreeMap::new();
    let again = figures.iter().filter_map(|figure| {
        let before: &Figure = known.insert(figure.id(), *figure)?;
        Some(figure.failure(format!("{} has a figure of this name too", before.file)))
    });
    again.collect()
}

fn rendered(figure: &Figure) -> Result<Rendered, Cause> {
    let id = figure.id();
    let _limit = live::limit::watch(format!("{}:{}: the figure {id}", figure.file, figure.line));
    let sound = |part: &str| {
        !part.is_empty() && part.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-')
    };
    if !id.trim_start_matches("fig:").split('-').all(sound) {
        let rule = "the name of a figure is lower-case letters and digits, with single underscores between";
        return Err(rule.into());
    }
    let drawing = (figure.draw)(&id)?;
    let [title, description] = [drawing.title(), drawing.description()].map(|words| words.trim().is_empty());
    // A panel may leave the words to the whole, but not half of them.
    let mut parts = drawing.all_parts().into_iter();
    if title || description || parts.any(|part| part.title().is_empty() != part.description().is_empty()) {
        return Err("the figure lacks a title or a description for those who cannot see it".into());
    }
    Ok(Rendered {
        id,
        svg: boxed(&drawing)?,
        place: match drawing.room() {
            ..=MARGIN => "margin",
            ..=COLUMN => "column",
            _ => "wide",
        },
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
    use super::{Axis, Drawing, Figure, Outcome, Plot, all};
    use drawing::{Hue, Rect, Side, Stroke, at};

    /// What is said of a figure that is drawn by `draw`, in the third line of its file.
    fn said(draw: fn(&str) -> Outcome) -> String {
        let figure = Figure { name: "typo", file: "book/nowhere/figures.rs", line: 3, draw };
        figure.render().expect_err("it is wrong")
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
    fn a_label_far_outside_the_axes_is_refused() {
        let draw = |id: &str| {
            let mut drawing = empty(id);
            let frame = Rect::new(30.0, 10.0, 60.0, 60.0);
            let axis = || Axis::linear(1.0, 10.0, 3.0);
            let mut plot = Plot::new(&mut drawing, frame, axis(), axis())?;
            plot.label((10.5, 5.0), Side::Right, "near", Hue::Ink)?;
            plot.label((1050.0, 5.0), Side::Right, "far", Hue::Ink)?;
            Ok(drawing)
        };
        assert!(
            said(draw).ends_with("the label `far` at (1050, 5) lies far outside the axes"),
            "{}",
            said(draw)
        );
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

    #[test]
    fn figures_are_listed_by_their_functions_and_each_has_a_name_of_its_own() {
        mod parts {
            pub(super) fn two_clocks(id: &str) -> super::Outcome {
                Ok(super::empty(id))
            }
        }
        let [one, other] = figures![parts::two_clocks, empty_too];
        fn empty_too(id: &str) -> Outcome {
            Ok(empty(id))
        }
        assert_eq!([one.id(), other.id()], ["fig:two-clocks", "fig:empty-too"]);
        let again = all(&[&[*one], &[*one, *other]]).expect_err("two have one name");
        assert!(again[0].contains("fig:two-clocks: ") && again.len() == 1, "{again:?}");
        assert!(again[0].ends_with(" has a figure of this name too"), "{again:?}");
        for name in ["Gimbal", "two__bodies", "_top", "top_"] {
            let said = Figure { name, ..*one }.render().expect_err(name);
            assert!(said.contains("the name of a figure is lower-case"), "{said}");
        }
    }
}
