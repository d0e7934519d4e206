//! The letters that a page uses, for the test of a book that has tables of symbols.

use crate::fault::Faults;
use crate::print::maths::Maths;
use dialect::markdown::options;
use pulldown_cmark::{Event, Parser};
use std::collections::BTreeSet;

/// The letters in the formulas of a text in Markdown, each with its subscript and none with its accent: `ω`, `ω_0`,
/// `r_cm`. A vector has the letter of its length, so that `\boldsymbol\omega` is `ω`; words and names of functions have
/// none.
///
/// # Errors
/// What the converter says of a formula that it does not understand.
pub fn letters(text: &str) -> Result<BTreeSet<String>, String> {
    let maths = Maths::new(&[], &[], &mut Faults::default());
    let mut found = BTreeSet::new();
    for event in Parser::new_ext(text, options()) {
        if let Event::InlineMath(tex) | Event::DisplayMath(tex) = event {
            let letters = maths.letters_of(&tex).map_err(|fault| format!("`{tex}`: {}", fault.message))?;
            found.extend(letters);
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_have_their_subscripts_and_nothing_else() {
        for (tex, expected) in [
            (r"\boldsymbol\omega = \dot{\theta}_1\,\hat{\mathbf 3} + x", "x θ_1 ω"),
            (r"\omega_\text{rel}^2 + \theta_L + \hat{\boldsymbol r}_m", "r_m θ_L ω_rel"),
            (r"L = \tfrac12 m v'_{1,2} + \mathsf I", "L m v_1,2 𝖨"),
            (r"\frac{a}{b} \operatorname{Re}(\bar u v) \text{if } \left( c \right)", "a b c u v"),
            (r"e^{i\Omega t}, \dot\omega_\perp, \infty, \mathrm{cm}", "e i t Ω ω_⟂"),
        ] {
            let found = letters(&format!("${tex}$")).unwrap();
            assert_eq!(Vec::from_iter(found).join(" "), expected, "{tex}");
        }
        assert!(letters(r"$\fraction{1}{2}$").unwrap_err().contains("fraction"));
    }
}
