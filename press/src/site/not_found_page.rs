//! The page for addresses at which there is none.

use html::escaped;
use mdbook_renderer::book::BookItem;
use std::fmt::Write as _;

/// The page: it needs no other file, as it may be shown for an address in any folder. Its links lead to the pages of
/// the book from the root of the site: `address` if that is known, else the nearest folder above that holds the book.
pub(crate) fn page<'a>(
    title: &str,
    language: &str,
    address: &str,
    items: impl Iterator<Item = &'a BookItem>,
) -> String {
    let mut links = String::new();
    for item in items {
        if let BookItem::Chapter(chapter) = item
            && let Some(path) = &chapter.path
            && chapter.number.as_ref().is_none_or(|number| number.len() == 1)
        {
            let number = chapter.number.as_ref().map(|number| format!("{number} ")).unwrap_or_default();
            let path = path.with_extension("html");
            let _ = writeln!(
                links,
                "<li><a href=\"{}\">{number}{}</a></li>",
                escaped(&crate::book::slashed(&path)),
                escaped(&chapter.name)
            );
        }
    }
    TEMPLATE
        .replace("TITLE", &escaped(title))
        .replace("LANGUAGE", &escaped(language))
        .replace("ADDRESS", &escaped(address))
        .replace("LINKS", &links)
}

const TEMPLATE: &str = r#"<!DOCTYPE html>
<html lang="LANGUAGE">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="robots" content="noindex">
<title>No such page - TITLE</title>
<base href="ADDRESS">
<style>
:root { color-scheme: light dark; }
body { max-width: 36rem; margin: 3rem auto; padding: 0 1.2rem; font: 1.1rem/1.5 "Libertinus Serif", Georgia, serif; }
ul { list-style: none; padding: 0; }
li { padding: 0.2rem 0; }
a { color: light-dark(#0b5394, #8cc1f8); }
</style>
</head>
<body>
<main>
<h1>There is no such page</h1>
<p>The address may have a slip, or the page has another name now. <em>TITLE</em> has these:</p>
<ul>
LINKS</ul>
</main>
<script>
// The site may stand in any folder: its root is the nearest one above that has the book's table of contents.
(async () => {
  const folders = location.pathname.split("/").slice(0, -1);
  for (let count = folders.length; count > 0; count--) {
    const root = folders.slice(0, count).join("/") + "/";
    const answer = await fetch(root + "toc.html", { method: "HEAD" }).catch(() => null);
    if (answer?.ok) return (document.querySelector("base").href = root);
  }
})();
</script>
</body>
</html>
"#;
