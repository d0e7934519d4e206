//! In which order solids are painted.
//!
//! Which of two parts is in front is asked of lines of sight through points where both are seen. A rod that
//! pierces something is divided along the lines where it does, and what is inside is not painted. Other
//! solids that answer both ways are divided if they can be: rings into sectors. A ring is then first painted
//! whole, at the turn of its hindmost sector, and once more in every sector that is in front of something
//! painted since; the seams fall on the same colours and cannot be seen.

use super::camera::Camera;
use super::form::{Form, Part, Patch};
use crate::point::{Rect, at};
use std::cmp::Ordering;

/// How many lines of sight in each direction compare two parts: few at first, and many if so many of the few do not say
/// the same.
const GRIDS: [u32; 2] = [7, 24];
const AGREED: u32 = 6;
/// A pair answers both ways if the lesser answer is more than this part of the greater.
const DOUBT: f64 = 0.02;

/// A solid to be painted.
pub(super) struct Body<'a> {
    pub(super) form: &'a dyn Form,
    pub(super) parts: Vec<Part>,
}

/// What is painted in one go.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Coat {
    /// Which solid it belongs to.
    pub(super) body: usize,
    pub(super) patches: Vec<Patch>,
}

struct Piece {
    body: usize,
    /// Its place among the undivided parts, if it is one of them.
    whole: Option<usize>,
    part: Part,
    patches: Vec<Patch>,
    bounds: Rect,
}

/// What is painted, from back to front.
pub(super) fn coats(bodies: &[Body<'_>], camera: &Camera) -> Vec<Coat> {
    let mut pieces: Vec<Piece> = Vec::new();
    for (body, solid) in bodies.iter().enumerate() {
        pieces.extend(solid.parts.iter().filter_map(|part| piece(body, solid.form, part, camera)));
    }
    for (index, piece) in pieces.iter_mut().enumerate() {
        piece.whole = Some(index);
    }
    let answers: Vec<Vec<(f64, f64)>> = (0..pieces.len())
        .map(|later| {
            (0..later).map(|earlier| in_front(&pieces[later], &pieces[earlier], bodies, camera)).collect()
        })
        .collect();
    let doubtful = in_doubt(&pieces, &answers, bodies.len());
    for (body, solid) in bodies.iter().enumerate().filter(|&(body, _)| doubtful[body]) {
        let sectors = solid.form.sectors();
        if !sectors.is_empty() {
            pieces.retain(|piece| piece.body != body);
            pieces.extend(sectors.iter().filter_map(|part| piece(body, solid.form, part, camera)));
        }
    }
    arrange(&pieces, &answers, bodies, camera)
}

fn piece(body: usize, form: &dyn Form, part: &Part, camera: &Camera) -> Option<Piece> {
    let patches = form.patches(camera, part);
    let bounds = Rect::around(patches.iter().flat_map(|patch| patch.shape.points()))?;
    Some(Piece { body, whole: None, part: part.clone(), patches, bounds })
}

/// By how much the first part is in front of the second, and the second in front of the first, summed over
/// lines of sight.
fn in_front(first: &Piece, second: &Piece, bodies: &[Body<'_>], camera: &Camera) -> (f64, f64) {
    let mut sums = (0.0, 0.0);
    if !first.bounds.overlaps(&second.bounds) {
        return sums;
    }
    let left = first.bounds.left.max(second.bounds.left);
    let top = first.bounds.top.max(second.bounds.top);
    let width = first.bounds.right.min(second.bounds.right) - left;
    let height = first.bounds.bottom.min(second.bounds.bottom) - top;
    // Of two parts the larger is the likelier to be missed by a line through their common rectangle: then the other is not asked.
    let is_larger =
        first.bounds.width() * first.bounds.height() > second.bounds.width() * second.bounds.height();
    for grid in GRIDS {
        let part = |index: u32| (f64::from(index) + 0.5) / f64::from(grid);
        sums = (0.0, 0.0);
        let mut agreed = 0;
        for row in 0..grid {
            for column in 0..grid {
                let ray = camera.ray(at(left + width * part(column), top + height * part(row)));
                let enters = |piece: &Piece| bodies[piece.body].form.enters(&ray, &piece.part);
                let met = if is_larger {
                    enters(first).and_then(|near| Some((near, enters(second)?)))
                } else {
                    enters(second).and_then(|far| Some((enters(first)?, far)))
                };
                if let Some((near, far)) = met {
                    agreed += 1;
                    sums.0 += (far - near).max(0.0);
                    sums.1 += (near - far).max(0.0);
                }
            }
        }
        if agreed >= AGREED && (sums.0 == 0.0) != (sums.1 == 0.0) {
            break;
        }
    }
    sums
}

/// The solids that are partly before and partly behind another.
fn in_doubt(pieces: &[Piece], answers: &[Vec<(f64, f64)>], count: usize) -> Vec<bool> {
    let mut doubtful = vec![false; count];
    for (first, answers) in pieces.iter().zip(answers) {
        for (second, &(before, behind)) in pieces.iter().zip(answers) {
            if second.body != first.body && before.min(behind) > DOUBT * before.max(behind) {
                doubtful[first.body] = true;
                doubtful[second.body] = true;
            }
        }
    }
    doubtful
}

/// Sorts a few things by a measure. The sorting of the standard library, made for thousands, would be a sixth of the
/// module that the pages load.
pub(super) fn put_in_order<T>(things: &mut [T], measure: impl Fn(&T) -> f64) {
    for end in 1..things.len() {
        let mut place = end;
        while place > 0 && measure(&things[place]) < measure(&things[place - 1]) {
            things.swap(place, place - 1);
            place -= 1;
        }
    }
}

/// Paints first what nothing unpainted is behind, and among such pieces the furthest.
fn arrange(pieces: &[Piece], answers: &[Vec<(f64, f64)>], bodies: &[Body<'_>], camera: &Camera) -> Vec<Coat> {
    let count = pieces.len();
    let mut behind = vec![vec![false; count]; count];
    for later in 0..count {
        for earlier in 0..later {
            let (before, after) = match (pieces[later].whole, pieces[earlier].whole) {
                (Some(one), Some(other)) => answers[one][other],
                _ => in_front(&pieces[later], &pieces[earlier], bodies, camera),
            };
            behind[later][earlier] = before > after;
            behind[earlier][later] = after > before;
        }
    }
    let depth = |piece: &Piece| {
        let ray = camera.ray(piece.bounds.centre());
        bodies[piece.body].form.enters(&ray, &piece.part).unwrap_or(0.0)
    };
    let depths: Vec<f64> = pieces.iter().map(depth).collect();
    let mut waiting: Vec<usize> = (0..count).collect();
    let mut order: Vec<usize> = Vec::new();
    while !waiting.is_empty() {
        let furthest =
            |a: &&usize, b: &&usize| -> Ordering { depths[**a].total_cmp(&depths[**b]).then(b.cmp(a)) };
        let free = waiting.iter().filter(|&&piece| !waiting.iter().any(|&other| behind[piece][other]));
        // Parts that are each in front of the next in a ring have no right order: then the furthest comes first.
        let Some(&next) = free.max_by(furthest).or_else(|| waiting.iter().max_by(furthest)) else { break };
        waiting.retain(|&piece| piece != next);
        order.push(next);
    }
    let mut coats: Vec<Coat> = Vec::new();
    for (turn, &next) in order.iter().enumerate() {
        let piece = &pieces[next];
        let divided = matches!(piece.part, Part::Sector(..));
        let begun = order[..turn].iter().position(|&other| pieces[other].body == piece.body);
        let patches = match begun.filter(|_| divided) {
            None if divided => bodies[piece.body].form.patches(camera, &Part::Whole),
            Some(begun) => {
                let since = &order[begun..turn];
                let covers = |&other: &usize| pieces[other].body != piece.body && behind[next][other];
                if !since.iter().any(covers) {
                    continue;
                }
                piece.patches.clone()
            }
            None => piece.patches.clone(),
        };
        coats.push(Coat { body: piece.body, patches });
    }
    coats
}
