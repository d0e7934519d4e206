//! A drawing as a backend of plotters: a thousandth of a pixel is its unit.

use drawing::{Drawing, Flaw, Hue, Label, Point, Role, Shape, Side, Stroke, at};
use plotters_backend::text_anchor::HPos;
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
};

/// The coordinates of plotters are whole numbers, so many a pixel.
const UNITS: f64 = 1000.0;
/// The type size of numbers at ticks, px.
const TICK_TYPE: f64 = 13.0;

/// Pixels in units of plotters.
pub(crate) fn units(pixels: f64) -> i32 {
    (pixels * UNITS).round() as i32
}

/// A point of plotters, px.
pub(crate) fn point((x, y): BackendCoord) -> Point {
    at(f64::from(x) / UNITS, f64::from(y) / UNITS)
}

/// The backend. It draws what the axes of a plot need, all lines with one stroke: the colours of plotters mean nothing
/// here.
pub(crate) struct Canvas<'a> {
    pub(crate) drawing: &'a mut Drawing,
    pub(crate) stroke: Stroke,
}

type Drawn = Result<(), DrawingErrorKind<Flaw>>;

impl DrawingBackend for Canvas<'_> {
    type ErrorType = Flaw;

    fn get_size(&self) -> (u32, u32) {
        (units(self.drawing.width()).unsigned_abs(), units(self.drawing.height()).unsigned_abs())
    }

    fn ensure_prepared(&mut self) -> Drawn {
        Ok(())
    }

    fn present(&mut self) -> Drawn {
        Ok(())
    }

    fn draw_pixel(&mut self, place: BackendCoord, _: BackendColor) -> Drawn {
        self.drawing.dot(point(place), 0.5, Hue::Ink);
        Ok(())
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(&mut self, path: I, _: &S) -> Drawn {
        let points: Vec<Point> = path.into_iter().map(point).collect();
        self.drawing.polyline(&points, self.stroke, Hue::Ink);
        Ok(())
    }

    /// The number at a tick, 10 px from the axis for plotters. To the left of an axis it stands 1 px nearer;
    /// those below an axis stand on one baseline, whatever their ink.
    fn draw_text<S: BackendTextStyle>(&mut self, text: &str, style: &S, place: BackendCoord) -> Drawn {
        let label = Label::new(text, TICK_TYPE).map_err(DrawingErrorKind::DrawingError)?;
        let label = match style.anchor().h_pos {
            HPos::Right => label.placed(point(place), Side::Left, -1.0),
            _ => {
                let start = point(place) + at(-0.5 * label.width(), 10.0);
                label.from_baseline(start)
            }
        };
        if !text.is_empty() {
            self.drawing.push(Role::PlainText(Hue::Ink), Shape::Label(label));
        }
        Ok(())
    }
}
