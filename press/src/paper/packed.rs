//! A PDF whose objects are packed.
//!
//! Chromium writes what a reader is told of each word, a hundred thousand small objects, as they are: two thirds of
//! the book. PDF 1.5 has streams of objects, which are compressed.

use flate2::Compression;
use flate2::write::ZlibEncoder;
use std::collections::BTreeSet;
use std::io::Write as _;

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
            out.extend(object);
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
    let rows = places.iter().flat_map(|(kind, place, index)| {
        let [a, b, c, d] = place.to_be_bytes();
        [*kind, a, b, c, d, *index]
    });
    let rows: Vec<u8> = rows.collect();
    let kept =
        kept.trim_start().trim_start_matches("/Size ").trim_start_matches(|c: char| c.is_ascii_digit());
    let words = format!("/Type /XRef /W [1 4 1] /Size {}{}", places.len(), kept.replace('\n', " "));
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
