//! The style sheet of figures that stand alone.
//!
//! There is one source for the looks of the roles, the page's `press/theme/figures.css`. It names every colour
//! once, as a pair for light and dark pages. A slide or a picture viewer knows neither the page's variables
//! nor `light-dark()` nor `color-mix()`, so here all of them are resolved: the rules once for light, and
//! those that differ once more for dark.

use crate::role::OPAQUE;

const PAGE: &str = include_str!("../../theme/figures.css");

/// A tint as the page has it, before and after its percentage.
const TINT: (&str, &str) = ("color-mix(in srgb, currentColor ", "%, var(--under, transparent))");

#[derive(Clone, Copy)]
enum Side {
    Light,
    Dark,
}

/// Rules for light, then for dark, in plain CSS without variables.
pub(crate) fn standalone() -> String {
    let (mut light, mut dark) = (String::new(), String::new());
    for rule in PAGE.lines().filter(|line| line.starts_with(".f-") && !line.contains(OPAQUE)) {
        let [on_light, on_dark] = [Side::Light, Side::Dark].map(|side| resolved(rule, side) + "\n");
        light += &on_light;
        if on_dark != on_light {
            dark += &on_dark;
        }
    }
    format!("{light}@media (prefers-color-scheme: dark) {{\n{dark}}}\n")
}

/// A rule with the page's variables, pairs and tints replaced by what they are on one side.
fn resolved(rule: &str, side: Side) -> String {
    let mut rule = rule.to_owned();
    for (variable, value) in PAGE.lines().filter_map(definition) {
        rule = rule.replace(&format!("var({variable})"), &value);
    }
    while let Some((before, pair, after)) = call(&rule, "light-dark") {
        let (light, dark) = halves(pair);
        let chosen = match side {
            Side::Light => light,
            Side::Dark => dark,
        };
        rule = format!("{before}{chosen}{after}");
    }
    if let Some((before, rest)) = rule.split_once(TINT.0)
        && let Some((percent, after)) = rest.split_once(TINT.1)
    {
        let opacity = if before.ends_with("stop-color: ") { "stop-opacity" } else { "fill-opacity" };
        rule = format!("{before}currentColor; {opacity}: {percent}%{after}");
    }
    rule
}

/// Reads `  --figure-blue: light-dark(#0072b2, #56b4e9);`; of `var(--fg, light-dark(…))` it takes the pair.
fn definition(line: &str) -> Option<(&str, String)> {
    let (variable, value) = line.trim().split_once(": ")?;
    let (_, pair, _) = call(value, "light-dark")?;
    variable.starts_with("--figure-").then(|| (variable, format!("light-dark({pair})")))
}

/// The first call of a CSS function: what stands before it, its arguments, and what stands after it.
fn call<'a>(text: &'a str, function: &str) -> Option<(&'a str, &'a str, &'a str)> {
    let start = text.find(&format!("{function}("))?;
    let inner = start + function.len() + 1;
    let mut depth = 1;
    for (offset, character) in text[inner..].char_indices() {
        match character {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some((&text[..start], &text[inner..inner + offset], &text[inner + offset + 1..]));
        }
    }
    None
}

/// Two arguments, parted at the comma that is not inside brackets.
fn halves(arguments: &str) -> (&str, &str) {
    let mut depth = 0;
    for (offset, character) in arguments.char_indices() {
        match character {
            '(' => depth += 1,
            ')' => depth -= 1,
            ',' if depth == 0 => return (&arguments[..offset], arguments[offset + 1..].trim_start()),
            _ => {}
        }
    }
    (arguments, arguments)
}

#[cfg(test)]
mod tests {
    use super::{PAGE, standalone};
    use crate::role::{Fill, Hue, OPAQUE, RIM, Role, STOPS, Stroke};

    #[test]
    fn every_role_has_a_rule_in_the_style_sheet() {
        let roles = Hue::ALL.iter().map(|hue| hue.class());
        let roles = roles.chain(Stroke::ALL.iter().map(|stroke| stroke.class()));
        let roles = roles.chain(Fill::ALL.iter().map(|fill| fill.class()));
        let classes = roles.chain(STOPS).chain(["f-line", "f-text", "f-plain", RIM, OPAQUE]);
        for class in classes {
            let rule = format!(".{class} {{");
            assert!(PAGE.lines().any(|line| line.starts_with(&rule)), "figures.css has no rule for {class}");
        }
        assert_eq!(Role::Line(Stroke::Curve, Hue::Blue).classes(), "f-line f-curve f-blue");
    }

    #[test]
    fn lines_are_as_wide_as_the_style_sheet_draws_them() {
        for stroke in Stroke::ALL {
            let (class, width) = (stroke.class(), stroke.width());
            let rule = format!(".{class} {{ stroke-width: {width}");
            let agrees =
                |line: &str| line.strip_prefix(&rule).is_some_and(|rest| rest.starts_with([';', ' ']));
            assert!(PAGE.lines().any(agrees), "{class} is not {width} px wide");
        }
    }

    #[test]
    fn each_meaning_of_a_broken_line_has_a_pattern_of_its_own() {
        let rules = Stroke::ALL.iter().filter_map(|stroke| {
            let rule = format!(".{} {{", stroke.class());
            PAGE.lines().find(|line| line.starts_with(&rule))
        });
        let pattern =
            |rule: &str| rule.split_once("stroke-dasharray: ")?.1.split(';').next().map(str::to_owned);
        let patterns: Vec<String> = rules.filter_map(pattern).collect();
        let thick: std::collections::BTreeSet<&String> = patterns.iter().collect();
        assert_eq!((patterns.len(), thick.len()), (7, 7), "{patterns:?}");
    }

    #[test]
    fn the_standalone_style_sheet_is_plain_css() {
        let sheet = standalone();
        for word in ["var(", "light-dark(", "color-mix("] {
            assert!(!sheet.contains(word), "{sheet}");
        }
        let (light, dark) = sheet.split_once("@media").expect("a part for dark");
        for (rule, in_light, in_dark) in [
            (".f-blue { color: ", "#1772ba; }", "#8cc1f8; }"),
            (".f-ink { color: ", "#1a1a1a; }", "#c9cad6; }"),
            (".f-page { fill: ", "#ffffff; }", "#161923; }"),
            (".f-face { fill: currentColor; fill-opacity: ", "22%; }", "42%; }"),
            (".f-unlit { stop-color: currentColor; stop-opacity: ", "42%; }", "18%; }"),
        ] {
            assert!(light.contains(&format!("{rule}{in_light}\n")), "{light}");
            assert!(dark.contains(&format!("{rule}{in_dark}\n")), "{dark}");
        }
        assert!(
            light.contains(".f-curve {") && !dark.contains(".f-curve {"),
            "what does not differ is said once"
        );
    }
}
