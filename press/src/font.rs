//! The mathematics font of the site: New Computer Modern Math, cut down to what its formulas use.
//!
//! A page needs a font with a MATH table, or its formulas look poor. The whole font has 1.3 MB. Its outlines are nearly all of
//! that, so those of glyphs that no formula here can reach are overwritten with a single repeated instruction, and the
//! compression of WOFF makes them vanish. All tables keep their structure and glyphs their numbers, so nothing that refers
//! to a glyph has to be rewritten.

use miniz_oxide::deflate::compress_to_vec_zlib;
use std::collections::BTreeSet;
use ttf_parser::gsub::SubstitutionSubtable;
use ttf_parser::{Face, GlyphId, Tag};

/// The licence of the font, which has to accompany it.
pub(crate) const LICENCE: &str = "\
New Computer Modern Math, Copyright (C) 2019-2025 Antonis Tsolomitis.

The font software is released under the GUST Font License (GFL), a free license, legally equivalent
to the LaTeX Project Public License (LPPL), version 1.3c or later, with the request that modified
files are given another name. Its text: https://www.gust.org.pl/projects/e-foundry/licenses

The file beside this one, math.woff, is a modified version under another name, \"Book Math\": the
outlines of glyphs that this book does not use are removed. The original font comes from
https://ctan.org/pkg/newcomputermodern
";

/// Characters that browsers draw for elements, though they stand in no text: the root of `<msqrt>`.
const IMPLIED: [char; 1] = ['√'];

/// The features of the font that MathML layout uses: small forms for scripts, dotless letters, flat accents.
const FEATURES: [&[u8; 4]; 3] = [b"ssty", b"dtls", b"flac"];

/// The tables that a browser needs for mathematics.
const TABLES: [&[u8; 4]; 11] =
    [b"CFF ", b"GSUB", b"MATH", b"OS/2", b"cmap", b"head", b"hhea", b"hmtx", b"maxp", b"name", b"post"];

/// A charstring instruction: the end of an outline.
const END_OF_OUTLINE: u8 = 14;

/// The font, with what formulas made of these characters can need, as a WOFF file; `None` if the font is missing or has another structure than the one this was written for.
pub(crate) fn woff(characters: &BTreeSet<char>) -> Option<Vec<u8>> {
    let (data, face) = math_face()?;
    let kept = reachable(&face, characters);
    let mut tables = Vec::new();
    for tag in TABLES {
        let mut table = face.raw_face().table(Tag::from_bytes(tag))?.to_vec();
        if tag == b"CFF " {
            erase_outlines(&mut table, &kept)?;
        }
        tables.push((tag, table));
    }
    Some(packed(&data[..4], &tables))
}

/// New Computer Modern Math among the assets.
fn math_face() -> Option<(&'static [u8], Face<'static>)> {
    typst_assets::fonts().find_map(|data| {
        let face = Face::parse(data, 0).ok()?;
        let is_math = face.tables().math.is_some()
            && face
                .names()
                .into_iter()
                .any(|name| name.to_string().is_some_and(|name| name == "NewCMMath-Regular"));
        is_math.then_some((data, face))
    })
}

/// The glyphs of the characters, and all that style, stretching and scripts can make of them.
fn reachable(face: &Face<'_>, characters: &BTreeSet<char>) -> BTreeSet<u16> {
    let all = characters.iter().chain(&IMPLIED).flat_map(|&c| styled(c));
    let mut kept: BTreeSet<u16> = all.filter_map(|c| face.glyph_index(c)).map(|glyph| glyph.0).collect();
    kept.insert(0);
    loop {
        let before = kept.len();
        substitutions(face, &mut kept);
        constructions(face, &mut kept);
        if kept.len() == before {
            return kept;
        }
    }
}

/// A character and, for a letter, its italic form: browsers set `<mi>x</mi>` with 𝑥.
fn styled(c: char) -> impl Iterator<Item = char> {
    let italic = match c {
        'h' => Some(0x210e),
        'A'..='Z' => Some(0x1d434 + (u32::from(c) - 0x41)),
        'a'..='z' => Some(0x1d44e + (u32::from(c) - 0x61)),
        'Α'..='Ω' => Some(0x1d6e2 + (u32::from(c) - 0x391)),
        'α'..='ω' => Some(0x1d6fc + (u32::from(c) - 0x3b1)),
        '∂' => Some(0x1d715),
        'ϵ' => Some(0x1d716),
        'ϑ' => Some(0x1d717),
        'ϕ' => Some(0x1d719),
        'ϱ' => Some(0x1d71a),
        'ϖ' => Some(0x1d71b),
        'ı' => Some(0x1d6a4),
        'ȷ' => Some(0x1d6a5),
        _ => None,
    };
    std::iter::once(c).chain(italic.and_then(char::from_u32))
}

/// Adds what single and alternate substitutions make of the glyphs: small forms for scripts, dotless letters, …
fn substitutions(face: &Face<'_>, kept: &mut BTreeSet<u16>) {
    let Some(gsub) = face.tables().gsub else {
        return;
    };
    let used = gsub
        .features
        .into_iter()
        .filter(|feature| FEATURES.iter().any(|tag| Tag::from_bytes(tag) == feature.tag));
    let used: BTreeSet<u16> = used.flat_map(|feature| feature.lookup_indices).collect();
    for lookup in used.into_iter().filter_map(|index| gsub.lookups.get(index)) {
        for subtable in lookup.subtables.into_iter::<SubstitutionSubtable<'_>>() {
            let glyphs: Vec<u16> = kept.iter().copied().collect();
            for glyph in glyphs {
                let Some(place) = subtable.coverage().get(GlyphId(glyph)) else {
                    continue;
                };
                match subtable {
                    SubstitutionSubtable::Single(ttf_parser::gsub::SingleSubstitution::Format1 {
                        delta,
                        ..
                    }) => {
                        kept.insert(glyph.wrapping_add_signed(delta));
                    }
                    SubstitutionSubtable::Single(ttf_parser::gsub::SingleSubstitution::Format2 {
                        substitutes,
                        ..
                    }) => {
                        kept.extend(substitutes.get(place).map(|glyph| glyph.0));
                    }
                    SubstitutionSubtable::Alternate(table) => {
                        let alternates = table.alternate_sets.get(place).map(|set| set.alternates);
                        kept.extend(alternates.into_iter().flatten().map(|glyph| glyph.0));
                    }
                    _ => {}
                }
            }
        }
    }
}

/// Adds the larger versions and the parts of delimiters, roots, accents and other glyphs that stretch.
fn constructions(face: &Face<'_>, kept: &mut BTreeSet<u16>) {
    let Some(variants) = face.tables().math.and_then(|math| math.variants) else {
        return;
    };
    for table in [variants.vertical_constructions, variants.horizontal_constructions] {
        let glyphs: Vec<u16> = kept.iter().copied().collect();
        for glyph in glyphs {
            let Some(construction) = table.get(GlyphId(glyph)) else {
                continue;
            };
            kept.extend(construction.variants.into_iter().map(|variant| variant.variant_glyph.0));
            let parts = construction.assembly.map(|assembly| assembly.parts);
            kept.extend(parts.into_iter().flatten().map(|part| part.glyph_id.0));
        }
    }
}

/// An INDEX of the CFF format: where its objects lie, and where it ends (Adobe Technical Note 5176, section 5).
fn index(cff: &[u8], at: usize) -> Option<(Vec<std::ops::Range<usize>>, usize)> {
    let count = usize::from(u16::from_be_bytes(cff.get(at..at + 2)?.try_into().ok()?));
    if count == 0 {
        return Some((Vec::new(), at + 2));
    }
    let size = usize::from(*cff.get(at + 2)?);
    let base = at + 3 + (count + 1) * size - 1;
    let offset = |n: usize| -> Option<usize> {
        let bytes = cff.get(at + 3 + n * size..at + 3 + (n + 1) * size)?;
        Some(base + bytes.iter().fold(0, |sum, byte| (sum << 8) | usize::from(*byte)))
    };
    let objects = (0..count).map(|n| Some(offset(n)?..offset(n + 1)?)).collect::<Option<Vec<_>>>()?;
    let end = objects.last()?.end;
    Some((objects, end))
}

/// Overwrites the outlines of all glyphs that are not kept.
fn erase_outlines(cff: &mut [u8], kept: &BTreeSet<u16>) -> Option<()> {
    let (_, names_end) = index(cff, usize::from(*cff.get(2)?))?;
    let (top_dicts, _) = index(cff, names_end)?;
    let charstrings = operand(cff.get(top_dicts.first()?.clone())?, 17)?;
    let (outlines, _) = index(cff, charstrings)?;
    for (glyph, outline) in outlines.into_iter().enumerate() {
        if !kept.contains(&u16::try_from(glyph).ok()?) {
            cff.get_mut(outline)?.fill(END_OF_OUTLINE);
        }
    }
    Some(())
}

/// The last integer before a one-byte operator of a DICT (the same note, section 4).
fn operand(dict: &[u8], operator: u8) -> Option<usize> {
    let (mut n, mut last) = (0, 0_i64);
    while let Some(&byte) = dict.get(n) {
        match byte {
            0..=21 => {
                if byte == operator {
                    return usize::try_from(last).ok();
                }
                n += if byte == 12 { 2 } else { 1 };
            }
            28 => {
                last = i64::from(i16::from_be_bytes(dict.get(n + 1..n + 3)?.try_into().ok()?));
                n += 3;
            }
            29 => {
                last = i64::from(i32::from_be_bytes(dict.get(n + 1..n + 5)?.try_into().ok()?));
                n += 5;
            }
            30 => {
                n += 2 + dict[n + 1..].iter().position(|b| b & 0x0f == 0x0f || b >> 4 == 0x0f)?;
            }
            32..=246 => {
                last = i64::from(byte) - 139;
                n += 1;
            }
            247..=250 => {
                last = (i64::from(byte) - 247) * 256 + i64::from(*dict.get(n + 1)?) + 108;
                n += 2;
            }
            251..=254 => {
                last = -(i64::from(byte) - 251) * 256 - i64::from(*dict.get(n + 1)?) - 108;
                n += 2;
            }
            _ => return None,
        }
    }
    None
}

/// Tables as a WOFF file (W3C Recommendation *WOFF File Format 1.0*, section 3).
fn packed(flavour: &[u8], tables: &[(&[u8; 4], Vec<u8>)]) -> Vec<u8> {
    let padded = |length: usize| length.div_ceil(4) * 4;
    let word = |value: usize| u32::try_from(value).unwrap_or(u32::MAX).to_be_bytes();
    let mut directory = Vec::new();
    let mut body = Vec::new();
    let start = 44 + 20 * tables.len();
    let mut unpacked = 12 + 16 * tables.len();
    for (tag, table) in tables {
        let squeezed = compress_to_vec_zlib(table, 9);
        let stored = if squeezed.len() < table.len() { &squeezed } else { table };
        directory.extend_from_slice(*tag);
        directory.extend_from_slice(&word(start + body.len()));
        directory.extend_from_slice(&word(stored.len()));
        directory.extend_from_slice(&word(table.len()));
        directory.extend_from_slice(&checksum(table).to_be_bytes());
        body.extend_from_slice(stored);
        body.resize(padded(body.len()), 0);
        unpacked += padded(table.len());
    }
    let mut file = Vec::with_capacity(start + body.len());
    file.extend_from_slice(b"wOFF");
    file.extend_from_slice(flavour);
    file.extend_from_slice(&word(start + body.len()));
    file.extend_from_slice(&u16::try_from(tables.len()).unwrap_or(u16::MAX).to_be_bytes());
    file.extend_from_slice(&[0, 0]);
    file.extend_from_slice(&word(unpacked));
    file.extend_from_slice(&[0, 1, 0, 0]); // version 1.0
    file.resize(44, 0); // no metadata, no private data
    file.extend_from_slice(&directory);
    file.extend_from_slice(&body);
    file
}

/// The sum of a table's big-endian words.
fn checksum(table: &[u8]) -> u32 {
    table.chunks(4).fold(0_u32, |sum, chunk| {
        let mut word = [0; 4];
        word[..chunk.len()].copy_from_slice(chunk);
        sum.wrapping_add(u32::from_be_bytes(word))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_font_is_found_and_small_and_keeps_what_is_used() {
        let font =
            woff(&"ax+αϕ=∫".chars().collect()).expect("the font is among the assets, with its structure");
        assert_eq!(&font[..8], b"wOFFOTTO");
        assert!(font.len() < 250_000, "{} bytes", font.len());
        let face_of_root = reachable(&math_face().expect("the font").1, &BTreeSet::new());
        assert!(face_of_root.len() > 5, "a root and its larger sizes, not {face_of_root:?}");
        let more = woff(&('!'..='~').chain('α'..='ω').collect()).expect("the same font");
        assert!(more.len() > font.len() + 1_000, "{} and {} bytes", font.len(), more.len());
    }
}
