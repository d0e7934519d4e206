//! The key of the colours on the page of conventions: its table, its drawing and the style sheet say the same.

use super::{files, pages, site};

/// What a table's row says: role, words, name of the colour.
fn rows(page: &str) -> Vec<(String, String, String)> {
    let table = page.split("<table").find(|table| table.contains(">quantity</th>")).expect("the key");
    let body = table.split("</table>").next().unwrap();
    let row = |row: &str| {
        let (_, rest) = row.split_once("class=\"q-")?;
        let (role, rest) = rest.split_once("\">")?;
        let (words, rest) = rest.split_once("</span>")?;
        let colour = rest.split("<td>").nth(1)?.split('<').next()?;
        Some([role, words, colour].map(str::to_owned).into())
    };
    body.split("<tr>").filter_map(row).collect()
}

#[test]
fn the_key_of_the_colours_is_what_formulas_and_figures_show() {
    let (_, page) = pages().into_iter().find(|(path, _)| path.ends_with("conventions.html")).unwrap();
    let sheets =
        files(site(), ".css").into_iter().filter(|(path, _)| path.to_string_lossy().contains("/look-"));
    let compact: String =
        sheets.flat_map(|(_, css)| css.split_whitespace().map(str::to_owned).collect::<Vec<_>>()).collect();
    let rows = rows(&page);
    assert_eq!(rows.len(), 5, "{rows:?}");
    for (role, words, colour) in rows {
        let rule = format!(".q-{role}{{color:var(--figure-{colour});}}");
        assert!(compact.contains(&rule), "no {rule}");
        // The drawing names it in the same colour, by the first of its words.
        let name = words.trim_start_matches("the ").split(" or ").next().unwrap();
        let label = page
            .split("<text")
            .find(|text| text.contains(&format!(">{name}</text>")) && !text.contains("f-rim"));
        let label = label.unwrap_or_else(|| panic!("no label `{name}`"));
        assert!(label.contains(&format!("f-{colour}\"")), "{label}");
    }
}
