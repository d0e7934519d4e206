//! Printing by a headless Chromium, and reading where in the PDF everything stands.

use crate::paper::packed;
use crate::site::publish;
use anyhow::{Context as _, Result, bail, ensure};
use hayro_syntax::Pdf;
use hayro_syntax::object::{Array, Dict, ObjectIdentifier};
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};
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
pub fn browser() -> Result<PathBuf> {
    if let Some(named) = env::var_os(VARIABLE).map(PathBuf::from) {
        ensure!(runs(&named), "{VARIABLE} names {}, which cannot be run", named.display());
        return Ok(named);
    }
    NAMES.into_iter().map(PathBuf::from).find(|name| runs(name)).with_context(|| {
        format!(
            "a PDF is printed by Chromium or Chrome, and there is none on PATH.\n\
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
pub fn print(browser: &Path, page: &Path, target: &Path, profile: &Path) -> Result<()> {
    if let Some(folder) = target.parent() {
        fs::create_dir_all(folder).with_context(|| folder.display().to_string())?;
    }
    publish::remove(target).with_context(|| target.display().to_string())?;
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
        .context("Chromium cannot be run")?;
    match fs::metadata(target) {
        Ok(pdf) if pdf.len() > 0 => {
            let packed = packed::packed(&fs::read(target)?);
            packed.map_or(Ok(()), |pdf| fs::write(target, pdf)).with_context(|| target.display().to_string())
        }
        _ => bail!("Chromium printed nothing:\n{}", String::from_utf8_lossy(&output.stderr)),
    }
}

/// The address of a file.
fn address(path: &Path) -> String {
    const ESCAPED: AsciiSet =
        NON_ALPHANUMERIC.remove(b'/').remove(b'-').remove(b'_').remove(b'.').remove(b'~');
    format!("file://{}", utf8_percent_encode(&path.to_string_lossy(), &ESCAPED))
}

/// On which page each place stands to which a link leads, by its id; nothing where the PDF has no table of places.
#[must_use]
pub fn numbers(pdf: &[u8]) -> BTreeMap<String, usize> {
    let Ok(pdf) = Pdf::new(pdf.to_vec()) else { return BTreeMap::new() };
    let pages = pdf.pages().iter().enumerate().filter_map(|(n, page)| Some((page.raw().obj_id()?, n + 1)));
    let pages: BTreeMap<ObjectIdentifier, usize> = pages.collect();
    let catalog: Option<Dict<'_>> = pdf.xref().get(pdf.xref().root_id());
    let places: Dict<'_> = catalog.and_then(|catalog| catalog.get("Dests")).unwrap_or_else(Dict::empty);
    let number = |target: &Array<'_>| {
        let page = target.raw_iter().next()?.as_obj_ref()?;
        pages.get(&page.into()).copied()
    };
    let places =
        places.keys().filter_map(|name| Some((name.as_str().to_owned(), number(&places.get(&name)?)?)));
    places.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pages_of_places_are_read() {
        let pdf = "%PDF-1.4\n2 0 obj\n<</Type /Page /Parent 13 0 R>>\nendobj\n8 0 obj\n<</Type /Page /Parent 13 0 R>>\n\
                   endobj\n13 0 obj\n<</Type /Pages /Count 2 /MediaBox [0 0 9 9] /Kids [2 0 R 8 0 R]>>\nendobj\n14 0 obj\n\
                   <</a-b [8 0 R /XYZ 6 826.1 0] /c#20d [2 0 R /XYZ 0 1 0]>>\nendobj\n\
                   15 0 obj\n<</Type /Catalog /Pages 13 0 R /Dests 14 0 R>>\nendobj\ntrailer <</Root 15 0 R>>\n";
        let expected = BTreeMap::from([("a-b".to_owned(), 2), ("c d".to_owned(), 1)]);
        assert_eq!(numbers(pdf.as_bytes()), expected);
        assert_eq!(numbers(pdf.replace("/Dests", "/Other").as_bytes()), BTreeMap::new());
        assert_eq!(numbers(b"%PDF-1.7 of another kind"), BTreeMap::new());
    }

    #[test]
    fn a_pdf_is_packed_and_what_is_none_stays() {
        let head = "%PDF-1.4\n%\u{3}\n";
        let objects = [
            "1 0 obj\n<</Type /Catalog\n/Pages 3 0 R\n/Dests 4 0 R>>\nendobj\n",
            "2 0 obj\n<</Type /Page\n/Parent 3 0 R>>\nendobj\n",
            "3 0 obj\n<</Type /Pages\n/Count 1\n/MediaBox [0 0 9 9]\n/Kids [2 0 R]>>\nendobj\n",
            "4 0 obj\n<</here [2 0 R /XYZ 0 1 0]>>\nendobj\n",
            "5 0 obj\n<</Length 3>> stream\nabc\nendstream\nendobj\n",
        ];
        // Their order in the file is another than that of their numbers.
        let order = [0, 4, 2, 3, 1];
        let mut file = head.to_owned();
        let mut places = [0; 5];
        for n in order {
            places[n] = file.len();
            file += objects[n];
        }
        let start = file.len();
        file += "xref\n0 6\n0000000000 65535 f \n";
        places.iter().for_each(|place| file += &format!("{place:010} 00000 n \n"));
        file += &format!("trailer\n<</Size 6\n/Root 1 0 R>>\nstartxref\n{start}\n%%EOF\n");
        let packed = packed::packed(file.as_bytes()).expect("it is as Chromium writes it");
        assert_eq!(numbers(&packed), BTreeMap::from([("here".to_owned(), 1)]));
        assert_eq!(Pdf::new(packed).expect("a PDF").pages().len(), 1);
        assert!(packed::packed(b"%PDF-1.7 of another kind").is_none());
    }

    #[test]
    fn an_address_holds_what_an_address_may_hold() {
        assert_eq!(address(Path::new("/a b/c#1.html")), "file:///a%20b/c%231.html");
    }
}
