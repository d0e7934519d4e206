//! How the house is built, read off its code.

use crate::{Outcome, house};
use drawing::kit::head;
use drawing::{Drawing, Fill, Hue, Point, Role, Side, Stroke, at};
use std::collections::BTreeSet;
use std::env;
use std::path::PathBuf;

/// One box: its name, its lines of code where they are shown, and what it uses.
struct Block<'a> {
    name: &'a str,
    lines: Option<usize>,
    /// The blocks that it uses, and whether only its build script or its tests do.
    uses: Vec<(&'a str, bool)>,
}

impl<'a> Block<'a> {
    fn of(one: &'a house::Crate) -> Self {
        let always = one.uses.iter().map(|used| (used.as_str(), false));
        let uses = always.chain(one.builds_with.iter().map(|used| (used.as_str(), true))).collect();
        Self { name: &one.name, lines: None, uses }
    }
}

/// The left edge of the boxes, their width and height, from one to the next, from one lane to the next, px.
const LEFT: f64 = 34.0;
const WIDTH: f64 = 146.0;
const HEIGHT: f64 = 32.0;
const ROW: f64 = 44.0;
const LANE: f64 = 18.0;

/// The rooms of the library and the crates of the workspace, each above what it imports.
pub(crate) fn house(id: &str) -> Outcome {
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?).join("../..");
    let library = house::library(&root)?;
    let found = house::rooms(&library);
    let mut rooms = Vec::new();
    for (name, _) in house::ROOMS.iter().rev() {
        let (lines, uses) = found.get(name).ok_or("a room of the table is not in the library")?;
        rooms.push(Block {
            name,
            lines: Some(*lines),
            uses: uses.iter().map(|used| (*used, false)).collect(),
        });
    }
    let crates = house::crates(&root)?;
    let crates: Vec<Block> = crates.iter().map(Block::of).collect();
    let height = ROW * rooms.len().max(crates.len()) as f64 + 40.0; // of both, so that they stand level
    let rooms = panel("Rooms of the library", &rooms, height)?;
    let crates = panel("Crates of the workspace", &crates, height)?;
    Ok(Drawing::panels(id, vec![rooms, crates]))
}

/// Boxes one below another, each with a line to the lanes of what it uses; a lane ends with an arrow in its box.
fn panel(title: &str, blocks: &[Block], height: f64) -> Outcome {
    let row = |name: &str| blocks.iter().position(|block| block.name == name).ok_or("nobody has that name");
    let mut said = Vec::new();
    // The lane of what is highest lies next to the boxes, so that no arrow into a box crosses a lane.
    let used: BTreeSet<&str> = blocks.iter().flat_map(|block| &block.uses).map(|(name, _)| *name).collect();
    let lanes: Vec<&str> = blocks
        .iter()
        .map(|block| block.name)
        .filter(|name| used.contains(name))
        .collect();
    let mut drawing = Drawing::new("", LEFT + WIDTH + LANE * (lanes.len() as f64 + 2.0), height);
    drawing.label(at(LEFT + 0.5 * WIDTH, 14.0), Side::Over, title, Hue::Ink)?;

    let top = |row: usize| 34.0 + ROW * row as f64;
    let (inward, outward) = (0.28 * HEIGHT, 0.72 * HEIGHT);
    let right = LEFT + WIDTH;
    for (from, block) in blocks.iter().enumerate() {
        let is_below = |name: &str| row(name).is_ok_and(|to| from < to);
        let uses = |lane: &str| block.uses.iter().any(|(name, _)| *name == lane);
        if let Some(last) = lanes.iter().rposition(|lane| is_below(lane) && uses(lane)) {
            let start = at(right, top(from) + outward);
            drawing.line(start, start + at(LANE * (last + 1) as f64, 0.0), Stroke::Outline, Hue::Ink);
        }
    }
    for (number, lane) in lanes.into_iter().enumerate() {
        let target = row(lane)?;
        let mut first = None;
        let mut joints: Vec<(Point, bool)> = Vec::new();
        for (from, block) in blocks.iter().enumerate() {
            let Some((_, builds)) = block.uses.iter().find(|(name, _)| *name == lane) else { continue };
            if from > target {
                return Err(format!("{} uses {lane}, which stands above it", block.name).into());
            }
            first.get_or_insert(from);
            joints.push((at(0.0, top(from) + outward), *builds));
        }
        let Some(first) = first else { continue };
        let (x, end) = (right + LANE * (number + 1) as f64, at(right, top(target) + inward));
        let way = [at(x, top(first) + outward), at(x, end.y), at(right + 6.0, end.y)];
        drawing.polyline(&way, Stroke::Outline, Hue::Ink);
        head(&mut drawing, end, at(-1.0, 0.0), 0.8, Hue::Ink);
        for (joint, builds) in joints {
            let joint = at(x, joint.y);
            if builds {
                drawing.circle(joint, 3.5, Role::Area(Fill::Page, Hue::Ink));
                drawing.circle(joint, 3.5, Role::Line(Stroke::Outline, Hue::Ink));
            } else {
                drawing.dot(joint, 3.5, Hue::Ink);
            }
        }
    }

    let heaviest = blocks.iter().filter_map(|block| block.lines).max().unwrap_or(1) as f64;
    for (row, block) in blocks.iter().enumerate() {
        let (y, middle) = (top(row), top(row) + 0.5 * HEIGHT);
        let corners = |right: f64, top: f64| {
            vec![at(LEFT, top), at(right, top), at(right, y + HEIGHT), at(LEFT, y + HEIGHT)]
        };
        drawing.polygon(corners(right, y), Fill::Face, Hue::Blue);
        if let Some(lines) = block.lines {
            let length = WIDTH * lines as f64 / heaviest;
            drawing.polygon(corners(LEFT + length.max(1.0), y + HEIGHT - 3.0), Fill::Solid, Hue::Blue);
            drawing.label_on_face(at(right, middle), Side::Left, &lines.to_string(), Hue::Ink)?;
        }
        let outline = corners(right, y);
        drawing.polyline(&[&outline[..], &outline[..1]].concat(), Stroke::Outline, Hue::Blue);
        drawing.label_on_face(at(LEFT, middle), Side::Right, block.name, Hue::Ink)?;
        let lines = block.lines.map_or(String::new(), |lines| format!(" ({lines} lines)"));
        let names: Vec<&str> = block.uses.iter().map(|(name, _)| *name).collect();
        let names = if names.is_empty() { "nothing".to_owned() } else { names.join(", ") };
        said.push(format!("{}{lines} uses {names}.", block.name));
    }
    Ok(drawing.titled(title, &said.join(" ")))
}
