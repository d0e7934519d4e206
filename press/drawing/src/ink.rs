//! What a drawing covers: its SVG is cut to the ink and a margin around it.

use crate::drawing::Drawing;
use crate::point::Rect;
use crate::role::{Fill, Role};
use crate::shape::Item;

/// The room around the ink of an SVG, px.
pub const MARGIN: f64 = 10.0;

impl Drawing {
    /// The smallest rectangle that holds all ink: strokes with their width, areas, labels; not what is drawn in
    /// the colour of the page. None without ink. Of a figure of panels, see its [`parts`](Self::parts).
    pub fn ink(&self) -> Option<Rect> {
        self.items().iter().filter_map(ink).reduce(|all, next| all.union(&next))
    }

    /// What the SVG shows: the ink and a margin around it, in whole pixels; or all
    /// of its frame.
    pub(crate) fn seen(&self) -> Rect {
        let ink = self.ink().filter(|_| !self.is_framed);
        let seen = ink.map_or(self.frame(), |ink| ink.grown(MARGIN));
        Rect {
            left: seen.left.floor(),
            top: seen.top.floor(),
            right: seen.right.ceil(),
            bottom: seen.bottom.ceil(),
        }
    }
}

/// What a shape covers.
fn ink(item: &Item) -> Option<Rect> {
    let stroke = match item.role {
        Role::Area(Fill::Page, _) => return None,
        Role::Line(stroke, _) => stroke.width(),
        Role::Area(..) | Role::Text(_) | Role::PlainText(_) => 0.0,
    };
    Rect::around(item.shape.points()).map(|rect| rect.grown(0.5 * stroke))
}
