//! The glyphs and the measures of the mathematics font, as a Rust table.

use crate::outline::Outline;
use std::error::Error;
use std::fmt::Write as _;
use ttf_parser::gsub::SubstitutionSubtable;
use ttf_parser::{Face, GlyphId, Tag};

const FONT: &str = "font/math.otf";

/// Everything that the TeX subset of the labels can ask for, beside the alphabets.
const SYMBOLS: &str = "+−×·±∓=<>≤≥≪≫≈≃∼∝≠≡∞→←↔∂∇√()[]{}|,;:.!/°′″…⋯⟨⟩∠⊥∥";
/// Combining accents: hat, tilde, bar, dot, two dots, vector arrow.
const ACCENTS: &str = "\u{302}\u{303}\u{304}\u{307}\u{308}\u{20d7}";
/// First and last of: letters, digits, Greek, and the mathematical alphabets (italic, bold, bold italic;
/// Latin, Greek, digits).
const ALPHABETS: [(u32, u32); 10] = [
    (0x30, 0x39),
    (0x41, 0x5a),
    (0x61, 0x7a),
    (0x391, 0x3a9),
    (0x3b1, 0x3c9),
    (0x1d400, 0x1d433),
    (0x1d434, 0x1d49b),
    (0x1d6a8, 0x1d6e1),
    (0x1d6e2, 0x1d755),
    (0x1d7ce, 0x1d7d7),
];
/// Letters that stand apart in Unicode: the italic h, the dotless i (upright and italic), variants of Greek letters.
const STRAYS: &str = "ℎı\u{1d6a4}ϵϕϑϱ";

/// Where glyphs without a character of their own get their keys: larger roots, and shapes drawn for small sizes.
const ROOTS: u32 = 0x0f_0000;
const SCRIPTS: u32 = 0x10_0000;

pub(crate) fn write() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed={FONT}");
    let data = std::fs::read(FONT)?;
    let face = Face::parse(&data, 0)?;

    let mut table = Vec::new();
    let ranges = ALPHABETS.iter().flat_map(|&(first, last)| first..=last).filter_map(char::from_u32);
    for character in ranges.chain(SYMBOLS.chars()).chain(ACCENTS.chars()).chain(STRAYS.chars()) {
        let Some(glyph) = face.glyph_index(character) else {
            continue;
        };
        let script = small_size_shape(&face, glyph);
        table.push((u32::from(character), glyph, script.map(|_| SCRIPTS + u32::from(character))));
        if let Some(script) = script {
            table.push((SCRIPTS + u32::from(character), script, None));
        }
    }
    for (size, glyph) in (0..).zip(larger_roots(&face)?) {
        table.push((ROOTS + size, glyph, None));
    }
    table.sort_by_key(|&(key, ..)| key);
    table.dedup_by_key(|&mut (key, ..)| key);

    let path = std::path::Path::new(&std::env::var("OUT_DIR")?).join("math_font.rs");
    std::fs::write(path, constants(&face)? + &glyphs(&face, &table)?)?;
    Ok(())
}

/// The shape that the font's feature `ssty` gives a glyph in superscripts and subscripts.
fn small_size_shape(face: &Face<'_>, glyph: GlyphId) -> Option<GlyphId> {
    let substitutions = face.tables().gsub?;
    let feature = substitutions.features.find(Tag::from_bytes(b"ssty"))?;
    feature.lookup_indices.into_iter().find_map(|index| {
        let lookup = substitutions.lookups.get(index)?;
        lookup.subtables.into_iter::<SubstitutionSubtable<'_>>().find_map(|subtable| match subtable {
            SubstitutionSubtable::Alternate(table) => {
                let set = table.alternate_sets.get(table.coverage.get(glyph)?)?;
                set.alternates.get(0)
            }
            SubstitutionSubtable::Single(table) => {
                let covered = table.coverage().get(glyph)?;
                match table {
                    ttf_parser::gsub::SingleSubstitution::Format2 { substitutes, .. } => {
                        substitutes.get(covered)
                    }
                    ttf_parser::gsub::SingleSubstitution::Format1 { .. } => None,
                }
            }
            _ => None,
        })
    })
}

fn larger_roots(face: &Face<'_>) -> Result<Vec<GlyphId>, Box<dyn Error>> {
    let root = face.glyph_index('√').ok_or("no root sign")?;
    let variants = face.tables().math.and_then(|math| math.variants).ok_or("no variants")?;
    let construction = variants.vertical_constructions.get(root).ok_or("the root does not grow")?;
    Ok(construction
        .variants
        .into_iter()
        .map(|variant| variant.variant_glyph)
        .filter(|&glyph| glyph != root)
        .collect())
}

fn constants(face: &Face<'_>) -> Result<String, Box<dyn Error>> {
    let c = face.tables().math.and_then(|math| math.constants).ok_or("no math constants")?;
    let list = [
        ("UNITS_PER_EM", face.units_per_em() as i16),
        ("SCRIPT_PERCENT", c.script_percent_scale_down()),
        ("SCRIPT_SCRIPT_PERCENT", c.script_script_percent_scale_down()),
        ("AXIS_HEIGHT", c.axis_height().value),
        ("ACCENT_BASE_HEIGHT", c.accent_base_height().value),
        ("SUBSCRIPT_SHIFT_DOWN", c.subscript_shift_down().value),
        ("SUBSCRIPT_TOP_MAX", c.subscript_top_max().value),
        ("SUBSCRIPT_BASELINE_DROP_MIN", c.subscript_baseline_drop_min().value),
        ("SUPERSCRIPT_SHIFT_UP", c.superscript_shift_up().value),
        ("SUPERSCRIPT_BOTTOM_MIN", c.superscript_bottom_min().value),
        ("SUPERSCRIPT_BASELINE_DROP_MAX", c.superscript_baseline_drop_max().value),
        ("SUB_SUPERSCRIPT_GAP_MIN", c.sub_superscript_gap_min().value),
        ("SPACE_AFTER_SCRIPT", c.space_after_script().value),
        ("FRACTION_NUMERATOR_SHIFT_UP", c.fraction_numerator_shift_up().value),
        ("FRACTION_NUMERATOR_GAP_MIN", c.fraction_numerator_gap_min().value),
        ("FRACTION_DENOMINATOR_SHIFT_DOWN", c.fraction_denominator_shift_down().value),
        ("FRACTION_DENOMINATOR_GAP_MIN", c.fraction_denominator_gap_min().value),
        ("FRACTION_RULE_THICKNESS", c.fraction_rule_thickness().value),
        ("RADICAL_VERTICAL_GAP", c.radical_vertical_gap().value),
        ("RADICAL_RULE_THICKNESS", c.radical_rule_thickness().value),
    ];
    let mut out = String::new();
    for (name, value) in list {
        writeln!(out, "pub(super) const {name}: i16 = {value};")?;
    }
    writeln!(out, "pub(super) const ROOTS: u32 = {ROOTS:#x};")?;
    Ok(out)
}

fn glyphs(face: &Face<'_>, table: &[(u32, GlyphId, Option<u32>)]) -> Result<String, Box<dyn Error>> {
    let info = face.tables().math.and_then(|math| math.glyph_info).ok_or("no glyph information")?;
    let mut out = String::from("pub(super) static GLYPHS: &[Glyph] = &[\n");
    for &(key, glyph, script) in table {
        let mut outline = Outline::default();
        let bounds = face.outline_glyph(glyph, &mut outline);
        let [low, high, left, right] = bounds.map_or([0; 4], |b| [b.y_min, b.y_max, b.x_min, b.x_max]);
        let advance = face.glyph_hor_advance(glyph).ok_or("a glyph without advance")?;
        let italic = info.italic_corrections.and_then(|all| all.get(glyph)).map_or(0, |value| value.value);
        let middle = i16::try_from((i32::from(left) + i32::from(right)) / 2)?;
        let accent =
            info.top_accent_attachments.and_then(|all| all.get(glyph)).map_or(middle, |value| value.value);
        writeln!(
            out,
            "Glyph {{ key: {key:#x}, script: {script:?}, advance: {advance}, low: {low}, high: {high}, left: {left}, \
             right: {right}, italic: {italic}, accent: {accent}, outline: &{:?} }},",
            outline.0
        )?;
    }
    out.push_str("];\n");
    Ok(out)
}
