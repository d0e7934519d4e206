//! Mathematics set by the measures of the math font, after the rules of TeX (D. E. Knuth's book on TeX,
//! appendix G) with the constants of OpenType's MATH table.

use super::font::{self, em};
use super::no_glyph;
use super::symbol::Glyph;
use super::tex::{Class, Node};

/// Set mathematics: everything in ems of the label's size, y upwards from the baseline.
#[derive(Debug, Clone, Default)]
pub(super) struct Set {
    pub(super) width: f64,
    pub(super) high: f64,
    pub(super) low: f64,
    /// How far the last glyph's top leans out.
    italic: f64,
    /// Where an accent over this is centred.
    accent: Option<f64>,
    pub(super) glyphs: Vec<Glyph>,
    /// Rules: left, bottom, width, height.
    pub(super) rules: Vec<[f64; 4]>,
}

impl Set {
    fn place(&mut self, other: Self, x: f64, y: f64) {
        self.high = self.high.max(other.high + y);
        self.low = self.low.min(other.low + y);
        self.glyphs.extend(other.glyphs.into_iter().map(|own| Glyph { x: own.x + x, y: own.y + y, ..own }));
        self.rules.extend(other.rules.into_iter().map(|[left, bottom, w, h]| [left + x, bottom + y, w, h]));
    }

    /// Adds what stands behind it on the line.
    fn append(&mut self, next: Self) {
        let (x, width) = (self.width, next.width);
        self.place(next, x, 0.0);
        self.width += width;
    }

    fn rule(&mut self, rule: [f64; 4]) {
        self.low = self.low.min(rule[1]);
        self.high = self.high.max(rule[1] + rule[3]);
        self.rules.push(rule);
    }
}

/// The size of type at a depth of nesting: 1 on the line, smaller in scripts and scripts of scripts.
fn size(depth: u8) -> f64 {
    match depth {
        0 => 1.0,
        1 => f64::from(font::SCRIPT_PERCENT) / 100.0,
        _ => f64::from(font::SCRIPT_SCRIPT_PERCENT) / 100.0,
    }
}

/// Sets a tree at a depth of nesting.
pub(super) fn set(node: &Node, depth: u8) -> Result<Set, String> {
    match node {
        Node::Symbol(_, character) => glyph(*character, depth),
        Node::Word(_, word) => {
            let mut row = Set::default();
            for character in word.chars() {
                if character == ' ' {
                    row.width += 0.28 * size(depth);
                    continue;
                }
                row.append(glyph(character, depth)?);
            }
            Ok(row)
        }
        Node::Space => Ok(Set { width: 3.0 / 18.0 * size(depth), ..Set::default() }),
        Node::Row(nodes) => set_row(nodes, depth),
        Node::Script { base, below, above } => {
            let base = set(base, depth)?;
            let below = below.as_ref().map(|node| set(node, depth + 1)).transpose()?;
            let above = above.as_ref().map(|node| set(node, depth + 1)).transpose()?;
            Ok(set_scripts(base, below, above, size(depth)))
        }
        Node::Accent(accent, base) => Ok(set_accent(set(base, depth)?, glyph(*accent, depth)?, size(depth))),
        Node::Root(inner) => Ok(set_root(set(inner, depth)?, size(depth))),
        Node::Fraction(above, below) => {
            Ok(set_fraction(set(above, depth + 1)?, set(below, depth + 1)?, size(depth)))
        }
    }
}

fn glyph(character: char, depth: u8) -> Result<Set, String> {
    let plain = font::glyph(character.into()).ok_or_else(|| no_glyph(character))?;
    let glyph = if depth > 0 { plain.script.and_then(font::glyph).unwrap_or(plain) } else { plain };
    Ok(set_glyph(glyph, size(depth)))
}

fn set_glyph(glyph: &'static font::Glyph, size: f64) -> Set {
    let (left, right, units_per_em) = (glyph.left, glyph.right, f64::from(font::UNITS_PER_EM));
    Set {
        width: f64::from(glyph.advance) / units_per_em * size,
        high: em(glyph.high) * size,
        low: em(glyph.low) * size,
        italic: em(glyph.italic) * size,
        accent: Some(em(glyph.accent) * size),
        glyphs: vec![Glyph {
            outline: glyph.outline,
            left,
            right,
            units_per_em,
            x: 0.0,
            y: 0.0,
            scale: size,
        }],
        rules: Vec::new(),
    }
}

fn class(node: &Node) -> Class {
    match node {
        Node::Symbol(class, _) | Node::Word(class, _) => *class,
        Node::Script { base, .. } | Node::Accent(_, base) => class(base),
        Node::Row(_) | Node::Root(_) | Node::Fraction(..) | Node::Space => Class::Ordinary,
    }
}

fn set_row(nodes: &[Node], depth: u8) -> Result<Set, String> {
    let mut row = Set::default();
    let mut before: Option<Class> = None;
    for (index, node) in nodes.iter().enumerate() {
        if let Node::Space = node {
            row.width += set(node, depth)?.width;
            continue;
        }
        let mut here = class(node);
        // A sign without a left neighbour, or before a relation, is no operation.
        let after = nodes[index + 1..].iter().find(|node| !matches!(node, Node::Space)).map(class);
        let lonely = matches!(
            before,
            None | Some(Class::Binary | Class::Relation | Class::Open | Class::Punctuation | Class::Operator)
        ) || matches!(after, None | Some(Class::Relation | Class::Close | Class::Punctuation));
        if here == Class::Binary && lonely {
            here = Class::Ordinary;
        }
        if let Some(before) = before {
            row.width += f64::from(space(before, here, depth)) / 18.0 * size(depth);
        }
        let next = set(node, depth)?;
        // An upright neighbour must not touch a leaning top; a script or a leaning neighbour follows the advance.
        row.italic = next.italic;
        row.append(next);
        before = Some(here);
    }
    Ok(row)
}

/// The space between two neighbours in eighteenths of an em; none around operations in scripts.
fn space(before: Class, after: Class, depth: u8) -> u8 {
    use Class::{Binary, Close, Open, Operator, Ordinary, Punctuation, Relation};
    match (before, after) {
        (Operator, Operator | Ordinary) | (Ordinary | Close, Operator) => 3,
        (Binary, _) | (_, Binary) if depth == 0 => 4,
        (Relation, Relation) | (Open, Relation) => 0,
        (Relation, Ordinary | Operator | Open) | (Ordinary | Operator | Close, Relation) if depth == 0 => 5,
        (Punctuation, _) if depth == 0 => 3,
        _ => 0,
    }
}

fn set_scripts(base: Set, below: Option<Set>, above: Option<Set>, size: f64) -> Set {
    let measure = |units: i16| em(units) * size;
    let mut up =
        measure(font::SUPERSCRIPT_SHIFT_UP).max(base.high - measure(font::SUPERSCRIPT_BASELINE_DROP_MAX));
    let mut down =
        measure(font::SUBSCRIPT_SHIFT_DOWN).max(-base.low + measure(font::SUBSCRIPT_BASELINE_DROP_MIN));
    // A single letter keeps its scripts at the ordinary height, so that neighbours agree.
    if base.glyphs.len() == 1 {
        up = measure(font::SUPERSCRIPT_SHIFT_UP);
        down = measure(font::SUBSCRIPT_SHIFT_DOWN);
    }
    if let Some(above) = &above {
        up = up.max(measure(font::SUPERSCRIPT_BOTTOM_MIN) - above.low);
    }
    if let Some(below) = &below {
        down = down.max(below.high - measure(font::SUBSCRIPT_TOP_MAX));
    }
    if let (Some(above), Some(below)) = (&above, &below) {
        let gap = (up + above.low) - (below.high - down);
        down += (measure(font::SUB_SUPERSCRIPT_GAP_MIN) - gap).max(0.0);
    }
    let (width, italic) = (base.width, base.italic);
    let mut whole = Set::default();
    whole.place(base, 0.0, 0.0);
    whole.width = width;
    if let Some(below) = below {
        whole.width = whole.width.max(width + below.width);
        whole.place(below, width, -down);
    }
    if let Some(above) = above {
        whole.width = whole.width.max(width + italic + above.width);
        whole.place(above, width + italic, up);
    }
    whole.width += measure(font::SPACE_AFTER_SCRIPT);
    whole
}

/// How much higher than the font says an accent stands over a tall letter, em.
const TALL: f64 = 0.06;

fn set_accent(base: Set, accent: Set, size: f64) -> Set {
    let centre = base.accent.unwrap_or(0.5 * base.width);
    // The font says where an accent lies over a low letter; over a tall stem a dot that is as near would touch it.
    let low = em(font::ACCENT_BASE_HEIGHT) * size;
    let rise = if base.high > low { base.high - low + TALL * size } else { 0.0 };
    let x = centre - accent.accent.unwrap_or(0.0);
    let mut whole = Set { width: base.width, italic: base.italic, ..Set::default() };
    whole.place(base, 0.0, 0.0);
    whole.place(accent, x, rise);
    whole
}

fn set_root(inner: Set, size: f64) -> Set {
    let (gap, rule) = (em(font::RADICAL_VERTICAL_GAP) * size, em(font::RADICAL_RULE_THICKNESS) * size);
    let needed = inner.high - inner.low + gap + rule;
    // The smallest root sign that is tall enough, or the tallest of all.
    let grown = (0..).map_while(|step| font::glyph(font::ROOTS + step));
    let signs = font::glyph(u32::from('√')).into_iter().chain(grown);
    let mut sign = Set::default();
    for candidate in signs {
        sign = set_glyph(candidate, size);
        if sign.high - sign.low >= needed {
            break;
        }
    }
    let spare = (sign.high - sign.low - needed).max(0.0);
    let top = inner.high + gap + 0.5 * spare + rule;
    let (left, width) = (sign.width, inner.width);
    let rise = top - sign.high;
    let mut whole = Set::default();
    whole.place(sign, 0.0, rise);
    whole.place(inner, left, 0.0);
    whole.rule([left, top - rule, width, rule]);
    whole.width = left + width;
    whole
}

fn set_fraction(above: Set, below: Set, size: f64) -> Set {
    let measure = |units: i16| em(units) * size;
    let (axis, rule) = (measure(font::AXIS_HEIGHT), measure(font::FRACTION_RULE_THICKNESS));
    let up = measure(font::FRACTION_NUMERATOR_SHIFT_UP)
        .max(axis + 0.5 * rule + measure(font::FRACTION_NUMERATOR_GAP_MIN) - above.low);
    let down = measure(font::FRACTION_DENOMINATOR_SHIFT_DOWN)
        .max(-axis + 0.5 * rule + measure(font::FRACTION_DENOMINATOR_GAP_MIN) + below.high);
    let (margin, width) = (0.12 * size, above.width.max(below.width));
    let [left_above, left_below] = [&above, &below].map(|part| margin + 0.5 * (width - part.width));
    let mut whole = Set { width: width + 2.0 * margin, ..Set::default() };
    whole.place(above, left_above, up);
    whole.place(below, left_below, -down);
    whole.rule([0.5 * margin, axis - 0.5 * rule, width + margin, rule]);
    whole
}
