//! Panels, and a second layout for narrow pages.

use crate::drawing::Drawing;
use crate::point::Rect;

/// No panel is wider, px.
pub const PANEL: f64 = 480.0;
/// The room between two panels, px.
pub const GAP: f64 = 20.0;
/// A page with less room than this shows the narrow layout, px.
pub const NARROW: f64 = 560.0;

/// The room that a figure is drawn for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Room {
    /// A page's column of text: 660 px.
    Wide,
    /// A phone: 340 px. Type of 13 px may shrink there to 11, so a drawing may be 400 px wide with its margins.
    Narrow,
}

impl Room {
    /// What differs between the two.
    ///
    /// ```
    /// # use drawing::{Rect, Room};
    /// let frame = |room: Room| Rect::new(50.0, 40.0, room.of(580.0, 320.0), 260.0);
    /// assert_eq!(frame(Room::Narrow).right, 370.0);
    /// ```
    pub fn of<T>(self, wide: T, narrow: T) -> T {
        match self {
            Self::Wide => wide,
            Self::Narrow => narrow,
        }
    }
}

/// On which pages a drawing is seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pages {
    All,
    Wide,
    Narrow,
}

impl Drawing {
    /// A figure of panels, each a drawing with a size, axes and words of its own. On a page they stand side by
    /// side where there is room, and else one below another.
    ///
    /// Each SVG is cut to its ink; panels of equal height are cut alike above and below, so that axes drawn
    /// at the same height stay level. The first panel of `fig:pair` gets the id `fig:pair-a`. The words of
    /// the whole are those of [`titled`](Self::titled), or else those of its panels one after another. Where
    /// panels have none of their own, the first has those of the whole, and the others are not announced to
    /// those who cannot see.
    ///
    /// ```
    /// use drawing::{Drawing, Hue, at};
    /// let panel = |x: f64| {
    ///     let mut panel = Drawing::new("", 300.0, 200.0).titled("A point", "One point.");
    ///     panel.dot(at(x, 100.0), 3.0, Hue::Blue);
    ///     panel
    /// };
    /// let pair = Drawing::panels("fig:pair", vec![panel(20.0), panel(80.0)]);
    /// assert_eq!(pair.parts().iter().map(|part| part.id()).collect::<Vec<_>>(), ["fig:pair-a", "fig:pair-b"]);
    /// assert_eq!(pair.to_svg()?.matches("<svg ").count(), 2);
    /// # Ok::<(), drawing::Flaw>(())
    /// ```
    pub fn panels(id: &str, panels: Vec<Self>) -> Self {
        let said = |words: fn(&Self) -> &str, between: &str| {
            panels.iter().map(words).filter(|words| !words.is_empty()).collect::<Vec<_>>().join(between)
        };
        let (title, description) = (said(Self::title, "; "), said(Self::description, " "));
        let width = panels.iter().map(Self::width).sum();
        let height = panels.iter().map(Self::height).fold(0.0, f64::max);
        let mut whole = Self::new("", width, height).titled(&title, &description);
        whole.panels = panels;
        whole.name(id);
        whole
    }

    /// The figure with a second layout, which shows the same, for pages with less than [`NARROW`] px of room:
    /// phones. It needs no words of its own.
    #[must_use]
    pub fn with_narrow(mut self, other: Self) -> Self {
        self.narrow = Some(Box::new(other));
        let id = self.id.clone();
        self.name(&id);
        self
    }

    /// The panel as a link to a page, on pages; its title stands below it and says where to.
    #[must_use]
    pub fn linked(mut self, target: &str) -> Self {
        self.link = Some(target.to_owned());
        self
    }

    /// Gives the figure its id, and its panels and its narrow layout theirs.
    fn name(&mut self, id: &str) {
        for (panel, letter) in self.panels.iter_mut().zip('a'..) {
            panel.name(&format!("{id}-{letter}"));
        }
        if let Some(narrow) = &mut self.narrow {
            narrow.name(&format!("{id}-narrow"));
        }
        id.clone_into(&mut self.id);
    }

    /// The drawings of the figure: its panels, or itself if it has none.
    pub fn parts(&self) -> Vec<&Self> {
        if self.panels.is_empty() { vec![self] } else { self.panels.iter().flat_map(Self::parts).collect() }
    }

    /// The drawings that a narrow page shows: those of the second layout, where there is one.
    pub fn narrow_parts(&self) -> Vec<&Self> {
        match &self.narrow {
            Some(narrow) => narrow.parts(),
            None if self.panels.is_empty() => vec![self],
            None => self.panels.iter().flat_map(Self::narrow_parts).collect(),
        }
    }

    /// The drawings of all layouts, each once.
    pub fn all_parts(&self) -> Vec<&Self> {
        self.leaves().into_iter().map(|(part, ..)| part).collect()
    }

    /// The drawings of all layouts, with what their SVGs show and where they are seen.
    pub(crate) fn leaves(&self) -> Vec<(&Self, Rect, Pages)> {
        let (wide, narrow) = (self.parts(), self.narrow_parts());
        let is_in = |part: &Self, parts: &[&Self]| parts.iter().any(|other| std::ptr::eq(part, *other));
        let pages = |part: &Self| if is_in(part, &narrow) { Pages::All } else { Pages::Wide };
        let only_narrow: Vec<&Self> = narrow.iter().copied().filter(|part| !is_in(part, &wide)).collect();
        let of_wide = wide.iter().zip(seen(&wide)).map(|(part, seen)| (*part, seen, pages(part)));
        let of_narrow = only_narrow.iter().zip(seen(&only_narrow));
        of_wide.chain(of_narrow.map(|(part, seen)| (*part, seen, Pages::Narrow))).collect()
    }

    /// How wide the figure is, its panels side by side, px.
    pub fn room(&self) -> f64 {
        let seen = seen(&self.parts());
        seen.iter().map(Rect::width).sum::<f64>() + GAP * (seen.len() as f64 - 1.0)
    }
}

/// What the SVGs of drawings show that stand side by side: the ink and a margin, and where they are of equal height the
/// same from above to below.
pub(crate) fn seen(parts: &[&Drawing]) -> Vec<Rect> {
    let own: Vec<Rect> = parts.iter().map(|part| part.seen()).collect();
    let level = |part: &&Drawing| {
        let row = parts.iter().zip(&own).filter(|(other, _)| other.height() == part.height());
        row.map(|(_, seen)| *seen).reduce(|all, next| all.union(&next)).unwrap_or(part.frame())
    };
    let rows = parts.iter().map(level);
    own.iter().zip(rows).map(|(own, row)| Rect { top: row.top, bottom: row.bottom, ..*own }).collect()
}
