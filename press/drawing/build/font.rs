//! The glyphs and the measures of the mathematics font, as a Rust table.

use crate::outline::outline;
use read_fonts::TableProvider;
use read_fonts::model::Font;
use read_fonts::tables::gsub::{AlternateSubst, SubstitutionSubtables};
use read_fonts::tables::math::{MathConstant, StretchAxis};
use read_fonts::types::{GlyphId, Tag};
use std::error::Error;
use std::fmt::Write as _;

const FONT: &str = "font/math.otf";

/// Everything that the TeX subset of the labels can ask for, beside the alphabets.
const SYMBOLS: &str = "+−=<>√()[]|,;:.!/°′⊥";
/// Combining accents: hat, dot.
const ACCENTS: &str = "\u{302}\u{307}";
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
/// Letters that stand apart in Unicode: the italic h, a variant of a Greek letter, the script l.
const STRAYS: &str = "ℎϕℓ";

/// Where glyphs without a character of their own get their keys: larger roots, and shapes drawn for small sizes.
const ROOTS: u32 = 0x0f_0000;
const SCRIPTS: u32 = 0x10_0000;

pub(crate) fn write() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed={FONT}");
    let font = Font::new(std::fs::read(FONT)?, 0).ok_or("no font")?;

    let mut table = Vec::new();
    let ranges = ALPHABETS.iter().flat_map(|&(first, last)| first..=last).filter_map(char::from_u32);
    for character in ranges.chain(SYMBOLS.chars()).chain(ACCENTS.chars()).chain(STRAYS.chars()) {
        let Some(glyph) = font.charmap().map_unicode(character) else {
            continue;
        };
        let script = small_size_shape(&font, glyph)?;
        table.push((u32::from(character), glyph, script.map(|_| SCRIPTS + u32::from(character))));
        if let Some(script) = script {
            table.push((SCRIPTS + u32::from(character), script, None));
        }
    }
    for (size, glyph) in (0..).zip(larger_roots(&font)?) {
        table.push((ROOTS + size, glyph, None));
    }
    table.sort_by_key(|&(key, ..)| key);
    table.dedup_by_key(|&mut (key, ..)| key);

    let path = std::path::Path::new(&std::env::var("OUT_DIR")?).join("math_font.rs");
    std::fs::write(path, constants(&font)? + &glyphs(&font, &table)?)?;
    Ok(())
}

/// The shape that the font's feature `ssty` gives a glyph in superscripts and subscripts.
fn small_size_shape(font: &Font, glyph: GlyphId) -> Result<Option<GlyphId>, Box<dyn Error>> {
    let table = font.tables().gsub()?;
    let (features, lookups) = (table.feature_list()?, table.lookup_list()?);
    let mut records = features.feature_records().iter();
    let scripts =
        records.find(|record| record.feature_tag() == Tag::new(b"ssty")).ok_or("no small shapes")?;
    for index in scripts.feature(features.offset_data())?.lookup_list_indices() {
        let SubstitutionSubtables::Alternate(tables) =
            lookups.lookups().get(usize::from(index.get()))?.subtables()?
        else {
            continue;
        };
        for table in tables.iter() {
            let AlternateSubst::Format1(table) = table? else { continue };
            if let Some(covered) = table.coverage()?.get(glyph) {
                let shapes = table.alternate_sets().get(covered as usize)?;
                return Ok(shapes.alternate_glyph_ids().first().map(|shape| shape.get().into()));
            }
        }
    }
    Ok(None)
}

fn larger_roots(font: &Font) -> Result<Vec<GlyphId>, Box<dyn Error>> {
    let root = font.charmap().map_unicode('√').ok_or("no root sign")?;
    let variants = font.tables().math()?.math_variants()?;
    let forms = variants.glyph_construction(root, StretchAxis::Vertical).ok_or("the root does not grow")?;
    let forms = forms.math_glyph_variant_records().iter().map(|form| form.variant_glyph().into());
    Ok(forms.filter(|&glyph| glyph != root).collect())
}

fn constants(font: &Font) -> Result<String, Box<dyn Error>> {
    let measures = font.tables().math()?.math_constants()?;
    let list = [
        ("SCRIPT_PERCENT", MathConstant::ScriptPercentScaleDown),
        ("SCRIPT_SCRIPT_PERCENT", MathConstant::ScriptScriptPercentScaleDown),
        ("AXIS_HEIGHT", MathConstant::AxisHeight),
        ("ACCENT_BASE_HEIGHT", MathConstant::AccentBaseHeight),
        ("SUBSCRIPT_SHIFT_DOWN", MathConstant::SubscriptShiftDown),
        ("SUBSCRIPT_TOP_MAX", MathConstant::SubscriptTopMax),
        ("SUBSCRIPT_BASELINE_DROP_MIN", MathConstant::SubscriptBaselineDropMin),
        ("SUPERSCRIPT_SHIFT_UP", MathConstant::SuperscriptShiftUp),
        ("SUPERSCRIPT_BOTTOM_MIN", MathConstant::SuperscriptBottomMin),
        ("SUPERSCRIPT_BASELINE_DROP_MAX", MathConstant::SuperscriptBaselineDropMax),
        ("SUB_SUPERSCRIPT_GAP_MIN", MathConstant::SubSuperscriptGapMin),
        ("SPACE_AFTER_SCRIPT", MathConstant::SpaceAfterScript),
        ("FRACTION_NUMERATOR_SHIFT_UP", MathConstant::FractionNumeratorShiftUp),
        ("FRACTION_NUMERATOR_GAP_MIN", MathConstant::FractionNumeratorGapMin),
        ("FRACTION_DENOMINATOR_SHIFT_DOWN", MathConstant::FractionDenominatorShiftDown),
        ("FRACTION_DENOMINATOR_GAP_MIN", MathConstant::FractionDenominatorGapMin),
        ("FRACTION_RULE_THICKNESS", MathConstant::FractionRuleThickness),
        ("RADICAL_VERTICAL_GAP", MathConstant::RadicalVerticalGap),
        ("RADICAL_RULE_THICKNESS", MathConstant::RadicalRuleThickness),
    ];
    let mut out = format!("pub(super) const UNITS_PER_EM: i16 = {};\n", font.units_per_em());
    for (name, measure) in list {
        writeln!(out, "pub(super) const {name}: i16 = {};", measures.constant(measure))?;
    }
    writeln!(out, "pub(super) const ROOTS: u32 = {ROOTS:#x};")?;
    Ok(out)
}

fn glyphs(font: &Font, table: &[(u32, GlyphId, Option<u32>)]) -> Result<String, Box<dyn Error>> {
    let info = font.tables().math()?.math_glyph_info()?;
    let italics = info.math_italics_correction_info().ok_or("no italics")??;
    let tops = info.math_top_accent_attachment().ok_or("no places of accents")??;
    let mut out = String::from("pub(super) static GLYPHS: &[Glyph] = &[\n");
    for &(key, glyph, script) in table {
        let metrics = font.glyph_metrics();
        let advance = metrics.h_advance(glyph);
        let ink = metrics.extents(glyph).unwrap_or_default();
        let (left, right) = (ink.x_bearing, ink.x_bearing + ink.width);
        let (low, high) = (ink.y_bearing - ink.height, ink.y_bearing);
        let italic = italics.correction(glyph).unwrap_or(0);
        let accent = tops.attachment(glyph).unwrap_or((left as i32 + right as i32) / 2);
        writeln!(
            out,
            "Glyph {{ key: {key:#x}, script: {script:?}, advance: {advance}, low: {low}, high: {high}, left: {left}, \
             right: {right}, italic: {italic}, accent: {accent}, outline: &{:?} }},",
            outline(font, glyph)?
        )?;
    }
    out.push_str("];\n");
    Ok(out)
}
