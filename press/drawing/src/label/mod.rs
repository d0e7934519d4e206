//! Labels: words and mathematics, measured and set without any font on the reader's machine.
//!
//! A label is written as words with mathematics between `$` signs, in a subset of TeX: letters and digits,
//! Greek, `^` and `_` (nested too), primes, accents, `\mathbf`, `\boldsymbol`, `\sqrt{}`, `\tfrac{}{}`,
//! `\text{}`, relations and operations ([`tex_commands`]). Among the words, `^{…}` raises what it holds:
//! `10^{-4}`. Whatever is not understood is an error.
//!
//! Mathematics becomes outlines of the math font's glyphs, set by the `typesetter` (a feature of the crate)
//! or taken from a table of [`Symbol`]s that it has set before, which is all that a page in a browser
//! carries. On a page words stay text, with their widths given, so that they can be searched and copied and
//! yet take the same room with every font. In a file of its own they become outlines too ([`Label::outline`]).

mod error;
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

pub use error::LabelError;
pub use symbol::{Glyph, Symbol, with_symbols};
#[cfg(feature = "typesetter")]
pub use tex::tex_commands;
#[cfg(feature = "typesetter")]
pub use typesetter::symbols_of;

use crate::point::{Point, Rect, at};
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
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Segment {
    /// Begin at this point.
    Move(Point),
    /// A straight line to this point.
    Line(Point),
    /// A quadratic curve: control point, end.
    Quadratic(Point, Point),
    /// A cubic curve: two control points, end.
    Cubic(Point, Point, Point),
    /// Back to the beginning.
    Close,
}

impl Segment {
    /// The step with every point moved.
    fn mapped(self, place: impl Fn(Point) -> Point) -> Self {
        match self {
            Self::Move(end) => Self::Move(place(end)),
            Self::Line(end) => Self::Line(place(end)),
            Self::Quadratic(control, end) => Self::Quadratic(place(control), place(end)),
            Self::Cubic(first, second, end) => Self::Cubic(place(first), place(second), place(end)),
            Self::Close => Self::Close,
        }
    }
}

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
    /// [`LabelError`] for a command or character that is not known, for braces and `$` without partners, and
    /// for commands without what they apply to.
    ///
    /// ```
    /// use drawing::{Label, LabelError};
    /// let wide = Label::new(r"spin rate $\Omega/\omega_0$", 14.0)?;
    /// let narrow = Label::new(r"$\omega_0$", 14.0)?;
    /// assert!(narrow.width() < wide.width());
    /// let error = Label::new(r"$\omga$", 14.0).unwrap_err();
    /// assert_eq!(error.to_string(), r"label `$\omga$`: unknown command `\omga`");
    /// # Ok::<(), LabelError>(())
    /// ```
    pub fn new(source: &str, size: f64) -> Result<Self, LabelError> {
        let bounds = Rect::new(0.0, 0.0, 0.0, 0.0);
        let mut label = Self { pieces: Vec::new(), bounds, size, smallest: size, width: 0.0 };
        let mut ink: Option<Rect> = None;
        let parts: Vec<&str> = source.split('$').collect();
        if parts.len().is_multiple_of(2) {
            return Err(LabelError::Unbalanced { label: source.into(), delimiter: '$' });
        }
        for (index, part) in parts.into_iter().enumerate() {
            if part.is_empty() {
                continue;
            }
            if index % 2 == 1 {
                label.push_mathematics(part, source, &mut ink)?;
            } else {
                label.push_words(part, source, &mut ink)?;
            }
        }
        label.bounds = ink.unwrap_or(label.bounds);
        Ok(label)
    }

    /// The room that it takes along its line, px.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// All of it as one outline, its words too: what needs no font, wherever it is shown.
    ///
    /// ```
    /// use drawing::{Label, Segment};
    /// let outline = Label::new("spin $x$", 14.0)?.outline();
    /// // Five letters, of which the p has an eye and the i a dot.
    /// assert_eq!(outline.iter().filter(|segment| matches!(segment, Segment::Move(_))).count(), 7);
    /// # Ok::<(), drawing::LabelError>(())
    /// ```
    pub fn outline(&self) -> Vec<Segment> {
        let mut segments = Vec::new();
        for piece in &self.pieces {
            match piece {
                Piece::Outline(own) => segments.extend(own),
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
                    for segment in segments {
                        *segment = segment.mapped(|point| point + step);
                    }
                }
            }
        }
    }

    fn push_words(&mut self, part: &str, source: &str, ink: &mut Option<Rect>) -> Result<(), LabelError> {
        let mut rest = part;
        while let Some((plain, after)) = rest.split_once("^{") {
            let (raised, after) = after
                .split_once('}')
                .ok_or_else(|| LabelError::Unbalanced { label: source.into(), delimiter: '{' })?;
            self.push_run(plain, 1.0, 0.0, source, ink)?;
            self.push_run(raised, RAISED.0, RAISED.1, source, ink)?;
            rest = after;
        }
        if let Some(stray) = rest.chars().find(|c| matches!(c, '{' | '}')) {
            return Err(LabelError::Unbalanced { label: source.into(), delimiter: stray });
        }
        self.push_run(rest, 1.0, 0.0, source, ink)
    }

    fn push_run(
        &mut self,
        text: &str,
        scale: f64,
        rise: f64,
        source: &str,
        ink: &mut Option<Rect>,
    ) -> Result<(), LabelError> {
        if text.is_empty() {
            return Ok(());
        }
        let size = scale * self.size;
        self.smallest = self.smallest.min(size);
        let (mut width, mut above, mut below) = (0.0, 0.0_f64, 0.0_f64);
        for character in text.chars() {
            let advance = words::advance(character)
                .ok_or_else(|| LabelError::UnknownCharacter { label: source.into(), character })?;
            width += advance * size;
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
            let bounds = Rect {
                left: start.x,
                top: baseline - above,
                right: start.x + inner_width,
                bottom: baseline + below,
            };
            *ink = Some(ink.map_or(bounds, |all| all.union(&bounds)));
            self.pieces.push(Piece::Words { text: inner.into(), start, width: inner_width, size });
        }
        self.width += width;
        Ok(())
    }

    fn push_mathematics(
        &mut self,
        part: &str,
        source: &str,
        ink: &mut Option<Rect>,
    ) -> Result<(), LabelError> {
        let set = set(part, source)?;
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
            segments.extend([
                Segment::Move(place(rule_left, bottom)),
                Segment::Line(place(rule_left + width, bottom)),
                Segment::Line(place(rule_left + width, bottom + height)),
                Segment::Line(place(rule_left, bottom + height)),
                Segment::Close,
            ]);
            right = right.max(place(rule_left + width, 0.0).x);
        }
        if !segments.is_empty() {
            let bounds = Rect { left, top: -set.high * size, right, bottom: -set.low * size };
            *ink = Some(ink.map_or(bounds, |all| all.union(&bounds)));
            self.pieces.push(Piece::Outline(segments));
        }
        self.width += set.width * size;
        Ok(())
    }
}

/// A formula of a label, set: out of the table, where there is one, or by the typesetter.
fn set(formula: &str, label: &str) -> Result<Cow<'static, Symbol>, LabelError> {
    let not_set = || LabelError::NotSet { label: label.into(), formula: formula.into() };
    match symbol::table() {
        Some(table) => {
            table.iter().find(|symbol| symbol.source == formula).map(Cow::Borrowed).ok_or_else(not_set)
        }
        #[cfg(feature = "typesetter")]
        None => typesetter::set(formula, label).map(Cow::Owned),
        #[cfg(not(feature = "typesetter"))]
        None => Err(not_set()),
    }
}

/// Reads an outline of the table into segments.
fn trace(outline: &[i16], place: impl Fn(i16, i16) -> Point, segments: &mut Vec<Segment>) {
    let mut rest = outline;
    while let [command, after @ ..] = rest {
        rest = match (command, after) {
            (0, [x, y, after @ ..]) => {
                segments.push(Segment::Move(place(*x, *y)));
                after
            }
            (1, [x, y, after @ ..]) => {
                segments.push(Segment::Line(place(*x, *y)));
                after
            }
            (2, [x1, y1, x, y, after @ ..]) => {
                segments.push(Segment::Quadratic(place(*x1, *y1), place(*x, *y)));
                after
            }
            (3, [x1, y1, x2, y2, x, y, after @ ..]) => {
                segments.push(Segment::Cubic(place(*x1, *y1), place(*x2, *y2), place(*x, *y)));
                after
            }
            _ => {
                segments.push(Segment::Close);
                after
            }
        };
    }
}
