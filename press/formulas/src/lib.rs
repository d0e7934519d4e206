//! Sets the formulas of a scene while it is compiled, so that a page needs no typesetter and no font.

use proc_macro::{TokenStream, TokenTree};

/// The formulas that the labels of a scene may use, set: `formulas![r"\omega_3", r"r_0"]` is a
/// `&'static [drawing::Symbol]`.
///
/// # Errors
/// A formula that cannot be set, or anything but strings with commas between, is an error of the compiler.
#[proc_macro]
pub fn formulas(input: TokenStream) -> TokenStream {
    let read = input.into_iter().filter_map(|token| match token {
        TokenTree::Punct(comma) if comma.as_char() == ',' => None,
        TokenTree::Literal(literal) => Some(text(&literal.to_string())),
        other => Some(Err(format!("a formula is a string, as in r\"\\omega\", and not `{other}`"))),
    });
    let set = read.collect::<Result<Vec<_>, _>>().and_then(|formulas| {
        drawing::symbols_of(formulas.iter().map(String::as_str)).map_err(|error| error.to_string())
    });
    let code = set.unwrap_or_else(|why| format!("::core::compile_error!({why:?})"));
    code.parse().unwrap_or_default()
}

/// What a string of the source holds; one with a backslash has to be raw.
fn text(literal: &str) -> Result<String, String> {
    let open = literal.strip_prefix('r').unwrap_or(literal);
    let text = open.trim_matches('#').strip_prefix('"').and_then(|rest| rest.strip_suffix('"'));
    match text {
        Some(text) if literal.starts_with('r') || !text.contains('\\') => Ok(text.to_owned()),
        _ => Err(format!("a formula is a raw string, as in r\"\\omega\", and not {literal}")),
    }
}
