//! A PDF whose objects are packed, and whose curves have the digits that can be seen.
//!
//! Chromium writes what a reader is told of each word, a hundred thousand small objects, as they are: two thirds of
//! the book. PDF 1.5 has streams of objects, which are compressed. Places it writes with nine digits.

use flate2::Compression;
use flate2::read::ZlibDecoder;
use flate2::write::ZlibEncoder;
use std::collections::BTreeSet;
use std::io::{Read as _, Write as _};

/// How many objects share a stream: a viewer unpacks all for one.
const TOGETHER: usize = 200;

/// The PDF with all objects in streams that are no streams themselves; `None` if it is not as Chromium writes it.
pub(super) fn packed(pdf: &[u8]) -> Option<Vec<u8>> {
    let table = last(pdf, b"startxref\n")?;
    let table: usize = number(&pdf[table + 10..])?;
    let trailer = table + first(&pdf[table..], b"trailer\n<<")?;
    let trailer_end = trailer + first(&pdf[trailer..], b">>\nstartxref")?;
    let kept = std::str::from_utf8(&pdf[trailer + 10..trailer_end]).ok()?;
    let offsets = offsets(pdf, table)?;
    let ends: BTreeSet<usize> = offsets.iter().copied().chain([table]).collect();
    // 0 unused, 1 at a place of the file, 2 in a stream: the place or the stream, and which object of it.
    let mut places = vec![(0u8, 0u32, 0u8); offsets.len()];
    let mut out = b"%PDF-1.5\n%\xd3\xeb\xe9\xe1\n".to_vec();
    let mut small = Vec::new();
    for id in 1..places.len() {
        let end = *ends.range(offsets[id] + 1..).next()?;
        let object = &pdf[offsets[id]..end];
        let body = object.strip_prefix(format!("{id} 0 obj\n").as_bytes())?;
        let body = &body[..last(body, b"\nendobj")?];
        if body.ends_with(b"endstream") {
            places[id] = (1, u32::try_from(out.len()).ok()?, 0);
            match content(body) {
                Some(content) => stream(&mut out, id, "", rounded(&content).as_bytes()),
                None => out.extend(object),
            }
        } else {
            small.push((id, body));
        }
    }
    for together in small.chunks(TOGETHER) {
        let (mut head, mut bodies) = (String::new(), Vec::new());
        for (index, (id, body)) in together.iter().enumerate() {
            places[*id] = (2, u32::try_from(places.len()).ok()?, u8::try_from(index).ok()?);
            head += &format!("{id} {} ", bodies.len());
            bodies.extend_from_slice(body);
            bodies.push(b'\n');
        }
        let words = format!("/Type /ObjStm /N {} /First {}", together.len(), head.len());
        places.push((1, u32::try_from(out.len()).ok()?, 0));
        stream(&mut out, places.len() - 1, &words, &[head.as_bytes(), &bodies].concat());
    }
    let start = out.len();
    places.push((1, u32::try_from(start).ok()?, 0));
    // Each row less the one above it, which the 2 before it says: so their bytes are much alike.
    let mut above = [0; 6];
    let rows = places.iter().flat_map(|(kind, place, index)| {
        let [a, b, c, d] = place.to_be_bytes();
        let row = [*kind, a, b, c, d, *index];
        let less = std::array::from_fn::<u8, 6, _>(|k| row[k].wrapping_sub(above[k]));
        above = row;
        std::iter::once(2).chain(less)
    });
    let rows: Vec<u8> = rows.collect();
    let kept =
        kept.trim_start().trim_start_matches("/Size ").trim_start_matches(|c: char| c.is_ascii_digit());
    let words = format!(
        "/Type /XRef /W [1 4 1] /DecodeParms <</Predictor 12 /Columns 6>> /Size {}{}",
        places.len(),
        kept.replace('\n', " ")
    );
    stream(&mut out, places.len() - 1, &words, &rows);
    out.extend(format!("startxref\n{start}\n%%EOF\n").bytes());
    Some(out)
}

/// Where each object begins, by the table; the first is none.
fn offsets(pdf: &[u8], table: usize) -> Option<Vec<usize>> {
    let rows = pdf[table..].strip_prefix(b"xref\n0 ")?;
    let count: usize = number(rows)?;
    let rows = &rows[first(rows, b"\n")? + 1..];
    rows.chunks(20).take(count).map(number).collect()
}

/// What a stream draws: a page, or a letter. Others have more to say of themselves, such as fonts and pictures.
fn content(body: &[u8]) -> Option<String> {
    let start = first(body, b" stream\n")?;
    let words = std::str::from_utf8(&body[..start]).ok()?.strip_prefix("<</Filter /FlateDecode\n/Length ")?;
    let length: usize = words.strip_suffix(">>")?.parse().ok()?;
    let mut content = String::new();
    ZlibDecoder::new(body.get(start + 8..start + 8 + length)?).read_to_string(&mut content).ok()?;
    Some(content)
}

/// What is drawn, with the places of lines, curves and words to a hundredth of a pixel, or a thousandth if they are less
/// than one; those of a letter are whole numbers, of which its height has some two thousand. What scales others keeps all
/// its digits.
fn rounded(content: &str) -> String {
    let is_letter = content.lines().next().is_some_and(|line| line.ends_with(" d1"));
    let mut out = String::with_capacity(content.len());
    for line in content.split_inclusive('\n') {
        let (numbers, act) = line.rsplit_once(' ').unwrap_or(("", line));
        if !["m", "l", "c", "v", "y", "re", "Tm"].contains(&act.trim_end()) {
            out += line;
            continue;
        }
        for number in numbers.split(' ') {
            match number.parse::<f64>() {
                Ok(value) if number.contains('.') => {
                    let digits = if is_letter { 0 } else { 2 + usize::from(value.abs() < 1.0) };
                    let written = format!("{value:.digits$}");
                    let short = if digits > 0 {
                        written.trim_end_matches('0').trim_end_matches('.')
                    } else {
                        &written
                    };
                    out += if short == "-0" { "0" } else { short };
                }
                _ => out += number,
            }
            out.push(' ');
        }
        out += act;
    }
    out
}

/// Writes an object that is a compressed stream.
fn stream(out: &mut Vec<u8>, id: usize, words: &str, content: &[u8]) {
    let mut packer = ZlibEncoder::new(Vec::new(), Compression::best());
    let packed = packer.write_all(content).and_then(|()| packer.finish()).unwrap_or_default();
    out.extend(
        format!("{id} 0 obj\n<<{words} /Filter /FlateDecode /Length {}>> stream\n", packed.len()).bytes(),
    );
    out.extend(packed);
    out.extend(b"\nendstream\nendobj\n");
}

/// The number at the beginning.
fn number(text: &[u8]) -> Option<usize> {
    let digits = text.iter().take_while(|byte| byte.is_ascii_digit()).count();
    std::str::from_utf8(&text[..digits]).ok()?.parse().ok()
}

fn first(text: &[u8], word: &[u8]) -> Option<usize> {
    text.windows(word.len()).position(|part| part == word)
}

fn last(text: &[u8], word: &[u8]) -> Option<usize> {
    text.windows(word.len()).rposition(|part| part == word)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_rounded_and_scales_and_words_are_not() {
        let page = ".23999999 0 0 -.23999999 0 841.91998 cm\nBT\n1 0 0 -1 164.12345 214024 Tm\n(1.23456 c) Tj\nET\n\
                    -.0001 .123456 m\n10.999999 -20.125 3 4.5 6 7.004 c\n.12345 .5 .25 rg\nf\n";
        let expected = ".23999999 0 0 -.23999999 0 841.91998 cm\nBT\n1 0 0 -1 164.12 214024 Tm\n(1.23456 c) Tj\nET\n\
                        0 0.123 m\n11 -20.12 3 4.5 6 7 c\n.12345 .5 .25 rg\nf\n";
        assert_eq!(rounded(page), expected);
        let letter = "1255 0 -161 -1832 1355 296 d1\n922 128.757568 m\n-.4 10.5 l\nf";
        assert_eq!(rounded(letter), "1255 0 -161 -1832 1355 296 d1\n922 129 m\n0 10 l\nf");
    }

    #[test]
    fn only_what_draws_is_opened() {
        let mut packer = ZlibEncoder::new(Vec::new(), Compression::best());
        packer.write_all(b"1.234567 2 m\n").unwrap();
        let packed = packer.finish().unwrap();
        let body = |words: &str| {
            let head = format!("<<{words}/Filter /FlateDecode\n/Length {}>> stream\n", packed.len());
            [head.as_bytes(), &packed, b"\nendstream"].concat()
        };
        assert_eq!(content(&body("")).as_deref(), Some("1.234567 2 m\n"));
        assert_eq!(content(&body("/Length1 9\n")), None, "a font");
    }
}
