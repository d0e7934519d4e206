//! Printing by a headless Chromium, and reading where in the PDF everything stands.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

/// The variable that names a browser.
const VARIABLE: &str = "BOOK_CHROMIUM";

/// What the browser is called by Debian and others.
const NAMES: [&str; 5] = ["chromium", "chromium-browser", "google-chrome", "chrome", "msedge"];

/// The browser that `BOOK_CHROMIUM` names, else the first one on PATH.
///
/// # Errors
/// If there is none: what to do about it.
pub fn browser() -> Result<PathBuf, String> {
    if let Some(named) = env::var_os(VARIABLE).map(PathBuf::from) {
        return if runs(&named) {
            Ok(named)
        } else {
            Err(format!("error: {VARIABLE} names {}, which cannot be run", named.display()))
        };
    }
    NAMES.into_iter().map(PathBuf::from).find(|name| runs(name)).ok_or_else(|| {
        format!(
            "error: a PDF is printed by Chromium or Chrome, and there is none on PATH.\n\
             Install one (`apt install chromium`, or google.com/chrome), or let {VARIABLE} name it.\n\
             Or open target/book/html/print.html in any browser, after `cargo book build`, and print it."
        )
    })
}

fn runs(program: &Path) -> bool {
    let version = Command::new(program).arg("--version").stdin(Stdio::null()).output();
    version.is_ok_and(|output| output.status.success())
}

/// Prints the file `page` into `target`; what the browser keeps for itself goes into `profile`.
///
/// # Errors
/// If there is no PDF then: what the browser says.
pub fn print(browser: &Path, page: &Path, target: &Path, profile: &Path) -> Result<(), String> {
    let cannot = |path: &Path, error: &dyn std::fmt::Display| format!("error: {}: {error}", path.display());
    if let Some(folder) = target.parent() {
        fs::create_dir_all(folder).map_err(|error| cannot(folder, &error))?;
    }
    if target.exists() {
        fs::remove_file(target).map_err(|error| cannot(target, &error))?;
    }
    let output = Command::new(browser)
        .args([
            "--headless",
            "--disable-gpu",
            "--no-first-run",
            "--disable-background-networking",
            "--no-sandbox",
        ])
        .args(["--no-pdf-header-footer", "--generate-pdf-document-outline", "--virtual-time-budget=10000"])
        .arg(format!("--user-data-dir={}", profile.display()))
        .arg(format!("--print-to-pdf={}", target.display()))
        .arg(address(page))
        .stdin(Stdio::null())
        .output()
        .map_err(|error| format!("error: Chromium cannot be run: {error}"))?;
    let mut pdf = fs::read(target).unwrap_or_default();
    if pdf.is_empty() {
        return Err(format!("error: Chromium printed nothing:\n{}", String::from_utf8_lossy(&output.stderr)));
    }
    mend_outline(&mut pdf);
    fs::write(target, pdf).map_err(|error| cannot(target, &error))
}

/// Chromium writes the words of a heading twice into the outline where it had to push it to the top of a page. They are
/// cut to their half. Spaces take the place of the rest, because the PDF says at which byte each of its parts begins.
fn mend_outline(pdf: &mut [u8]) {
    const KEY: &[u8] = b"/Title ";
    let mut at = 0;
    while let Some(found) = pdf[at..].windows(KEY.len()).position(|window| window == KEY) {
        at += found + KEY.len();
        // A text in parentheses, or in hexadecimal digits behind a mark of their order.
        let (start, end) = match pdf.get(at) {
            Some(b'(') => (at + 1, b')'),
            Some(b'<') if pdf[at + 1..].starts_with(b"FEFF") => (at + 5, b'>'),
            _ => continue,
        };
        let mut stop = start;
        while pdf.get(stop).is_some_and(|byte| *byte != end) {
            stop += if pdf[stop] == b'\\' { 2 } else { 1 };
        }
        if stop >= pdf.len() {
            return;
        }
        let half = (stop - start) / 2;
        if half > 0 && pdf[start..start + half] == pdf[start + half..stop] {
            pdf[start + half..=stop].fill(b' ');
            pdf[start + half] = end;
        }
        at = stop;
    }
}

/// The address of a file.
pub(super) fn address(path: &Path) -> String {
    let mut address = "file://".to_owned();
    for byte in path.to_string_lossy().bytes() {
        match byte {
            b'/' | b'-' | b'_' | b'.' | b'~' => address.push(byte as char),
            _ if byte.is_ascii_alphanumeric() => address.push(byte as char),
            _ => address += &format!("%{byte:02X}"),
        }
    }
    address
}

/// On which page each place stands to which a link leads, by its id.
///
/// This reads what Chromium writes, and no other PDF: pages in their order, and one table of places, uncompressed.
#[must_use]
pub fn numbers(pdf: &[u8]) -> BTreeMap<String, usize> {
    // A PDF is bytes, of which only the ASCII is read here.
    let text: String = pdf.iter().map(|byte| if byte.is_ascii() { *byte as char } else { '?' }).collect();
    let object = |before: &str| -> Option<usize> {
        before.strip_suffix(" 0 obj\n<<")?.rsplit('\n').next()?.parse().ok()
    };
    let pages =
        text.match_indices("/Type /Page\n").filter_map(|(at, _)| object(&text[at.saturating_sub(40)..at]));
    let pages: BTreeMap<usize, usize> = pages.enumerate().map(|(n, object)| (object, n + 1)).collect();
    let table = text.split("/Dests ").nth(1).and_then(|rest| rest.split(" 0 R").next());
    let table = table.and_then(|number| text.split(&format!("\n{number} 0 obj\n<<")).nth(1));
    let places = table.and_then(|rest| rest.split(">>\nendobj").next()).unwrap_or_default();
    let places = places.split(']').filter_map(|place| {
        let (name, target) = place.trim().strip_prefix('/')?.split_once(" [")?;
        let page = pages.get(&target.split(' ').next()?.parse().ok()?)?;
        Some((unescaped(name), *page))
    });
    places.collect()
}

/// A name of PDF: `a#20b` is `a b`.
fn unescaped(name: &str) -> String {
    let mut parts = name.split('#');
    let mut bytes = parts.next().unwrap_or_default().as_bytes().to_vec();
    for part in parts {
        match part.get(..2).and_then(|digits| u8::from_str_radix(digits, 16).ok()) {
            Some(byte) => {
                bytes.push(byte);
                bytes.extend_from_slice(&part.as_bytes()[2..]);
            }
            None => bytes.extend_from_slice(part.as_bytes()),
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pages_of_places_are_read() {
        let pdf = "%PDF-1.4\n2 0 obj\n<</Type /Page\n/Contents 7 0 R>>\nendobj\n8 0 obj\n<</Type /Page\n/Parent 13 0 R>>\n\
                   endobj\n13 0 obj\n<</Type /Pages\n/Kids [2 0 R 8 0 R]>>\nendobj\n14 0 obj\n<</a-b [8 0 R /XYZ 6 826.1 0]\n\
                   /c#20d [2 0 R /XYZ 0 1 0]>>\nendobj\n15 0 obj\n<</Type /Catalog\n/Dests 14 0 R>>\nendobj\n";
        let expected = BTreeMap::from([("a-b".to_owned(), 2), ("c d".to_owned(), 1)]);
        assert_eq!(numbers(pdf.as_bytes()), expected);
        assert_eq!(numbers(b"%PDF-1.7 of another kind"), BTreeMap::new());
    }

    #[test]
    fn an_entry_of_the_outline_says_its_words_once() {
        for (printed, mended) in [
            ("<</Title (PrefacePreface)\n>>", "<</Title (Preface)       \n>>"),
            ("/Title (a\\)a\\)) /Title (aba)", "/Title (a\\))    /Title (aba)"),
            ("/Title <FEFF00C900C9> /Title <FEFF00C9>", "/Title <FEFF00C9>     /Title <FEFF00C9>"),
            ("/Title () /Title (open", "/Title () /Title (open"),
        ] {
            let mut pdf = printed.as_bytes().to_vec();
            mend_outline(&mut pdf);
            assert_eq!(String::from_utf8(pdf).unwrap(), mended);
        }
    }

    #[test]
    fn an_address_holds_what_an_address_may_hold() {
        assert_eq!(address(Path::new("/a b/c#1.html")), "file:///a%20b/c%231.html");
    }
}
