//! The outline of a glyph, as a Rust table has it.

use ttf_parser::OutlineBuilder;

/// The outline as numbers: 0 move, 1 line, 2 quadratic, 3 cubic, 4 close, each followed by its coordinates.
#[derive(Default)]
pub(crate) struct Outline(pub(crate) Vec<i16>);

impl Outline {
    fn push(&mut self, command: i16, coordinates: &[f32]) {
        self.0.push(command);
        self.0.extend(coordinates.iter().map(|value| value.round() as i16));
    }
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.push(0, &[x, y]);
    }
    fn line_to(&mut self, x: f32, y: f32) {
        self.push(1, &[x, y]);
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.push(2, &[x1, y1, x, y]);
    }
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.push(3, &[x1, y1, x2, y2, x, y]);
    }
    fn close(&mut self) {
        self.push(4, &[]);
    }
}
