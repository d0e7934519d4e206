//! Labels: words and mathematics, measured and set without any font on the reader's machine.
//!
//! A label is written as words with mathematics between `$` signs, in a subset of TeX: letters, digits and the
//! signs of the keyboard, `^` and `_` (nested too), primes, and the commands that figures have needed so far
//! ([`tex_commands`]). Among the words, `^{…}` raises what it holds: `10^{-4}`. Whatever is not understood is an
//! error.
//!
//! Mathematics becomes outlines of the math font's glyphs, set by the `typesetter` (a feature of the crate)
//! or taken from a table of [`Symbol`]s that it has set before, which is all that a page in a browser
//! carries. On a page words stay text, with their widths given, so that they can be searched and copied and
//! yet take the same room with every font. In a file of its own they become outlines too ([`Label::outline`]).

#[cfg(feature = "typesetter")]
mod font;
#[cfg(feature = "typesetter")]
mod layout;
mod symbol;
#[cfg(feature = "typesetter")]
mod tex;
#[cfg(feature = "typesetter")]
mod typesetter;
mod words;

pub use symbol::{Glyph, Symbol, with_symbols};
#[cfg(feature = "typesetter")]
pub use tex::tex_commands;
#[cfg(feature = "typesetter")]
pub use typesetter::symbols_of;

use crate::flaw::Flaw;
use crate::point::{Point, Rect, at};
use arrayvec::ArrayVec;
use std::borrow::Cow;

/// Mathematics is set this much larger than words, whose letters are tall for their size.
const MATHEMATICS: f64 = 1.1;
/// Raised words: their size, and how far their baseline rises, both in sizes of the words.
const RAISED: (f64, f64) = (0.75, 0.42);

/// On which side of a point a label stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// Its middle on the point.
    Over,
    /// Centred above.
    Above,
    /// Centred below.
    Below,
    /// To the left, at the height of the point.
    Left,
    /// To the right, at the height of the point.
    Right,
    /// Up and to the left.
    AboveLeft,
    /// Up and to the right.
    AboveRight,
    /// Down and to the left.
    BelowLeft,
    /// Down and to the right.
    BelowRight,
}

/// One step of a glyph's outline.
#[derive(Debug, Clone, PartialEq)]
pub struct Segment {
    /// Its letter in the paths of SVG: `m` begins at a point, `l` is a straight line, `q` and `c` are curves with one and
    /// two points of control, `z` goes back to the beginning.
    pub letter: char,
    /// The points of control, and the end.
    pub points: ArrayVec<Point, 3>,
}

/// The steps as outlines of the tables number them, and how many points each has.
const STEPS: [(char, usize); 5] = [('m', 1), ('l', 1), ('q', 2), ('c', 3), ('z', 0)];

/// A part of a label.
#[derive(Debug, Clone, PartialEq)]
pub enum Piece {
    /// Words: where their baseline starts, their width and their type size, px.
    Words {
        /// The words.
        text: String,
        /// The left end of the baseline.
        start: Point,
        /// The width that the words take, px.
        width: f64,
        /// The type size, px.
        size: f64,
    },
    /// Mathematics, as outlines to be filled.
    Outline(Vec<Segment>),
}

/// A label that has been set: its baseline begins at the origin until it is placed.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// Its parts, from left to right.
    pub pieces: Vec<Piece>,
    /// The rectangle that its ink fills, px.
    pub bounds: Rect,
    /// Its type size, px.
    pub size: f64,
    /// The size of its smallest raised or lowered sign, px; its type size if it has none.
    pub smallest: f64,
    /// The sum of the advances, px.
    width: f64,
}

impl Label {
    /// Sets a label at a type size, px.
    ///
    /// # Errors
    /// [`Flaw`] for a command or character that is not known, for braces and `$` without partners, and for
    /// commands without what they apply to.
    ///
    /// ```
    /// use drawing::{Flaw, Label};
    /// let wide = Label::new(r"spin rate $\Omega/\omega_0$", 14.0)?;
    /// let narrow = Label::new(r"$\omega_0$", 14.0)?;
    /// assert!(narrow.width() < wide.width());
    /// let error = Label::new(r"$\omga$", 14.0).unwrap_err();
    /// assert_eq!(error.to_string(), r"label `$\omga$`: unknown command `\omga`");
    /// # Ok::<(), Flaw>(())
    /// ```
    pub fn new(source: &str, size: f64) -> Result<Self, Flaw> {
        let bounds = Rect::default();
        let mut label = Self { pieces: Vec::new(), bounds, size, smallest: size, width: 0.0 };
        label.read(source).map_err(|why| flaw(source, &why))?;
        Ok(label)
    }

    fn read(&mut self, source: &str) -> Result<(), String> {
        let parts: Vec<&str> = source.split('$').collect();
        if parts.len().is_multiple_of(2) {
            return Err(unbalanced('$'));
        }
        for (index, part) in parts.into_iter().enumerate() {
            if index % 2 == 0 {
                self.push_words(part)?;
            } else if !part.is_empty() {
                self.push_mathematics(part)?;
            }
        }
        Ok(())
    }

    /// The room that it takes along its line, px.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// All of it as one outline, its words too: what needs no font, wherever it is shown.
    ///
    /// ```
    /// use drawing::Label;
    /// let outline = Label::new("spin $x$", 14.0)?.outline();
    /// // Five letters, of which the p has an eye and the i a dot.
    /// assert_eq!(outline.iter().filter(|segment| segment.letter == 'm').count(), 7);
    /// # Ok::<(), drawing::Flaw>(())
    /// ```
    pub fn outline(&self) -> Vec<Segment> {
        let mut segments = Vec::new();
        for piece in &self.pieces {
            match piece {
                Piece::Outline(own) => segments.extend_from_slice(own),
                Piece::Words { text, start, size, .. } => {
                    let mut x = start.x;
                    for (outline, advance, unit) in text.chars().filter_map(words::letter) {
                        let [left, unit] = [x, unit * size];
                        let place = |gx: i16, gy: i16| {
                            at(left + f64::from(gx) * unit, start.y - f64::from(gy) * unit)
                        };
                        trace(outline, place, &mut segments);
                        x += advance * size;
                    }
                }
            }
        }
        segments
    }

    /// The label moved so that it stands on a side of a point, `gap` px away from it.
    pub fn placed(mut self, point: Point, side: Side, gap: f64) -> Self {
        let ink = self.bounds;
        let diagonal = gap * std::f64::consts::FRAC_1_SQRT_2;
        // Beside a point, letters are centred by their usual height and not by their ink, so that baselines agree.
        let level = 0.5 * words::CAPITAL_HEIGHT * self.size;
        let x = match side {
            Side::Over | Side::Above | Side::Below => -0.5 * (ink.left + ink.right),
            Side::Left => -gap - ink.right,
            Side::Right => gap - ink.left,
            Side::AboveLeft | Side::BelowLeft => -diagonal - ink.right,
            Side::AboveRight | Side::BelowRight => diagonal - ink.left,
        };
        let y = match side {
            Side::Over | Side::Left | Side::Right => level,
            Side::Above => -gap - ink.bottom,
            Side::Below => gap - ink.top,
            Side::AboveLeft | Side::AboveRight => -diagonal - ink.bottom,
            Side::BelowLeft | Side::BelowRight => diagonal - ink.top,
        };
        self.shift(point + at(x, y));
        self
    }

    /// The label moved so that its baseline begins at a point.
    pub fn from_baseline(mut self, start: Point) -> Self {
        self.shift(start);
        self
    }

    pub(crate) fn shift(&mut self, step: Point) {
        self.bounds = self.bounds.moved(step);
        for piece in &mut self.pieces {
            match piece {
                Piece::Words { start, .. } => *start = *start + step,
                Piece::Outline(segments) => {
                    let points = segments.iter_mut().flat_map(|segment| &mut segment.points);
                    points.for_each(|point| *point = *point + step);
                }
            }
        }
    }

    /// Adds a piece and the rectangle that its ink fills.
    fn push(&mut self, piece: Piece, ink: Rect) {
        self.bounds = if self.pieces.is_empty() { ink } else { self.bounds.union(&ink) };
        self.pieces.push(piece);
    }

    fn push_words(&mut self, part: &str) -> Result<(), String> {
        let mut rest = part;
        while let Some((plain, after)) = rest.split_once("^{") {
            let (raised, after) = after.split_once('}').ok_or_else(|| unbalanced('{'))?;
            self.push_run(plain, 1.0, 0.0)?;
            self.push_run(raised, RAISED.0, RAISED.1)?;
            rest = after;
        }
        match rest.chars().find(|c| matches!(c, '{' | '}')) {
            Some(stray) => Err(unbalanced(stray)),
            None => self.push_run(rest, 1.0, 0.0),
        }
    }

    fn push_run(&mut self, text: &str, scale: f64, rise: f64) -> Result<(), String> {
        if text.is_empty() {
            return Ok(());
        }
        let size = scale * self.size;
        self.smallest = self.smallest.min(size);
        let (mut width, mut above, mut below) = (0.0, 0.0_f64, 0.0_f64);
        for character in text.chars() {
            width += words::advance(character).ok_or_else(|| no_glyph(character))? * size;
            let (high, low) = words::extent(character);
            above = above.max(high * size);
            below = below.max(low * size);
        }
        let baseline = -rise * self.size;
        // Spaces at either end become distance: XML would drop them.
        let space = words::advance(' ').unwrap_or(0.0) * size;
        let inner = text.trim_matches(' ');
        let leading = (text.len() - text.trim_start_matches(' ').len()) as f64 * space;
        let trailing = (text.len() - text.trim_end_matches(' ').len()) as f64 * space;
        if !inner.is_empty() {
            let start = at(self.width + leading, baseline);
            let inner_width = width - leading - trailing;
            let (top, bottom) = (baseline - above, baseline + below);
            let ink = Rect { left: start.x, top, right: start.x + inner_width, bottom };
            self.push(Piece::Words { text: inner.into(), start, width: inner_width, size }, ink);
        }
        self.width += width;
        Ok(())
    }

    fn push_mathematics(&mut self, part: &str) -> Result<(), String> {
        let set = set(part)?;
        let size = MATHEMATICS * self.size;
        let x0 = self.width;
        let mut segments = Vec::new();
        let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
        for glyph in &*set.glyphs {
            self.smallest = self.smallest.min(glyph.scale * size);
            let units = glyph.scale * size / glyph.units_per_em;
            let place = |gx: i16, gy: i16| {
                at(x0 + glyph.x * size + f64::from(gx) * units, -glyph.y * size - f64::from(gy) * units)
            };
            trace(glyph.outline, place, &mut segments);
            left = left.min(place(glyph.left, 0).x);
            right = right.max(place(glyph.right, 0).x);
        }
        for &[rule_left, bottom, width, height] in &*set.rules {
            let place = |x: f64, y: f64| at(x0 + x * size, -y * size);
            let (end, top) = (rule_left + width, bottom + height);
            let corners =
                [('m', rule_left, bottom), ('l', end, bottom), ('l', end, top), ('l', rule_left, top)];
            let line = |(letter, x, y)| Segment { letter, points: ArrayVec::from_iter([place(x, y)]) };
            segments.extend(corners.map(line));
            segments.push(Segment { letter: 'z', points: ArrayVec::new() });
            right = right.max(place(end, 0.0).x);
        }
        if !segments.is_empty() {
            let ink = Rect { left, top: -set.high * size, right, bottom: -set.low * size };
            self.push(Piece::Outline(segments), ink);
        }
        self.width += set.width * size;
        Ok(())
    }
}

/// A formula of a label, set: out of the table, where there is one, or by the typesetter.
fn set(formula: &str) -> Result<Cow<'static, Symbol>, String> {
    let not_set = || format!("`{formula}` was not set beforehand");
    match symbol::table() {
        Some(table) => {
            table.iter().find(|symbol| symbol.source == formula).map(Cow::Borrowed).ok_or_else(not_set)
        }
        #[cfg(feature = "typesetter")]
        None => typesetter::set(formula).map(Cow::Owned),
        #[cfg(not(feature = "typesetter"))]
        None => Err(not_set()),
    }
}

/// The flaw of a label, from what is wrong in it.
fn flaw(label: &str, why: &str) -> Flaw {
    Flaw::new(format!("label `{label}`: {why}"))
}

fn unbalanced(delimiter: char) -> String {
    format!("`{delimiter}` without its partner")
}

fn no_glyph(character: char) -> String {
    format!("no glyph for `{character}` (U+{:04X})", u32::from(character))
}

/// Reads an outline of the table into segments.
fn trace(outline: &[i16], place: impl Fn(i16, i16) -> Point, segments: &mut Vec<Segment>) {
    let mut rest = outline;
    while let [step, after @ ..] = rest {
        let (letter, count) = STEPS[*step as usize];
        let (own, after) = after.split_at(2 * count);
        let points = own.chunks_exact(2).map(|pair| place(pair[0], pair[1])).collect();
        segments.push(Segment { letter, points });
        rest = after;
    }
}
