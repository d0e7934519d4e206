//! The colours of the built site, computed from its style sheets: text can be read in every theme, and links
//! are told by a line.

use super::{files, site};
use std::collections::BTreeMap;

pub(super) const THEMES: [&str; 5] = ["light", "rust", "coal", "navy", "ayu"];
/// The least contrast of text with what is behind it, and of the signs on buttons (WCAG 2.2, 1.4.3 and 1.4.11).
const TEXT: f64 = 4.5;
const SIGN: f64 = 3.0;

/// Red, green, blue and opacity, from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Colour([f64; 4]);

impl Colour {
    /// What is seen of it before another colour.
    fn over(self, ground: Self) -> Self {
        let [.., opacity] = self.0;
        let mut mixed = [1.0; 4];
        for (n, channel) in mixed.iter_mut().take(3).enumerate() {
            *channel = opacity * self.0[n] + (1.0 - opacity) * ground.0[n];
        }
        Self(mixed)
    }

    /// Red, green and blue as amounts of light.
    fn linear(self) -> [f64; 3] {
        let [r, g, b, _] = self.0;
        [r, g, b].map(|c| if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) })
    }

    fn luminance(self) -> f64 {
        let [r, g, b] = self.linear();
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }
}

fn contrast(text: Colour, ground: Colour) -> f64 {
    let [a, b] = [text.over(ground), ground].map(Colour::luminance);
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

/// A rule of a style sheet: one selector and its declarations.
type Rule = (String, BTreeMap<String, String>);

/// The rules of style sheets outside of `@media`, selector by selector, in order.
fn rules(css: &str) -> Vec<Rule> {
    let mut plain = String::new();
    for (n, part) in css.split("/*").enumerate() {
        plain += if n == 0 { part } else { part.split_once("*/").map_or("", |(_, after)| after) };
    }
    let mut found = Vec::new();
    let mut rest = plain.as_str();
    while let Some((head, body)) = rest.split_once('{') {
        let head = head.trim().rsplit(';').next().unwrap().trim();
        let mut depth = 1;
        let end = body.char_indices().find(|(_, c)| {
            depth += i32::from(*c == '{') - i32::from(*c == '}');
            depth == 0
        });
        let end = end.expect("balanced braces").0;
        if !head.starts_with('@') {
            let declarations = body[..end].split(';').filter_map(|line| line.split_once(':'));
            let declarations: BTreeMap<String, String> =
                declarations.map(|(name, value)| (name.trim().to_owned(), value.trim().to_owned())).collect();
            let selectors = head.split(',').map(|one| one.split_whitespace().collect::<Vec<_>>().join(" "));
            found.extend(selectors.map(|selector| (selector, declarations.clone())));
        }
        rest = &body[end + 1..];
    }
    found
}

/// The sheet of the site whose name begins so.
fn sheet(name: &str) -> Vec<Rule> {
    let sheets = files(site(), ".css");
    let is_it = |path: &std::path::Path| path.file_name().unwrap().to_str().unwrap().starts_with(name);
    let (_, css) = sheets.iter().find(|(path, _)| is_it(path)).unwrap_or_else(|| panic!("no sheet {name}"));
    rules(css)
}

/// The colours of one theme.
pub(super) struct Theme {
    name: &'static str,
    /// The variables of the page and of its figures.
    variables: BTreeMap<String, String>,
    /// The rules of mdBook and ours.
    page: Vec<Rule>,
}

impl Theme {
    pub(super) fn new(name: &'static str) -> Self {
        let own = sheet("look");
        let mut variables = BTreeMap::new();
        // In the order of their weight: a class, then an element with it.
        let [class, element] = [format!(".{name}"), format!("html.{name}")];
        for selector in [":root", &class, "html:root", &element] {
            for (_, declarations) in sheet("variables").iter().chain(&own).filter(|(s, _)| s == selector) {
                let variable = declarations.iter().filter(|(name, _)| name.starts_with("--"));
                variables.extend(variable.map(|(name, value)| (name.clone(), value.clone())));
            }
        }
        let mut page = sheet("general");
        page.extend(sheet("chrome"));
        page.extend(own.clone());
        Self { name, variables, page }
    }

    fn is_dark(&self) -> bool {
        self.variables.get("--color-scheme").is_some_and(|scheme| scheme == "dark")
    }

    /// What an expression of CSS gives in this theme, as amounts of red, green and blue light.
    pub(super) fn linear(&self, expression: &str) -> [f64; 3] {
        self.colour(expression).linear()
    }

    /// What an expression of CSS gives in this theme.
    fn colour(&self, expression: &str) -> Colour {
        let expression = expression.trim();
        let call = expression.strip_suffix(')').and_then(|call| call.split_once('('));
        let numbers = |text: &str| -> Vec<f64> {
            let parts = text.split([',', ' ', '/']).filter(|part| !part.is_empty());
            let number = |part: &str| match part.strip_suffix('%') {
                Some(percent) => percent.parse::<f64>().map(|value| value / 100.0),
                None => part.parse(),
            };
            parts.map(|part| number(part).unwrap_or_else(|_| panic!("{text}"))).collect()
        };
        match call {
            Some(("var", arguments)) => {
                let (name, otherwise) = arguments.split_once(',').unwrap_or((arguments, ""));
                self.colour(self.variables.get(name.trim()).map_or(otherwise, String::as_str))
            }
            Some(("light-dark", arguments)) => {
                let mut depth = 0;
                let comma = arguments.char_indices().find(|(_, c)| {
                    depth += i32::from(*c == '(') - i32::from(*c == ')');
                    depth == 0 && *c == ','
                });
                let (light, dark) = arguments.split_at(comma.expect("two colours").0);
                self.colour(if self.is_dark() { &dark[1..] } else { light })
            }
            Some(("rgb", arguments)) => {
                let n = numbers(arguments);
                Colour([n[0] / 255.0, n[1] / 255.0, n[2] / 255.0, n.get(3).copied().unwrap_or(1.0)])
            }
            Some(("hsl", arguments)) => {
                let n = numbers(arguments);
                let (spread, middle) = (n[1] * n[2].min(1.0 - n[2]), n[2]);
                let channel = |offset: f64| {
                    let k = (offset + n[0] / 30.0) % 12.0;
                    middle - spread * (k - 3.0).min(9.0 - k).clamp(-1.0, 1.0)
                };
                Colour([channel(0.0), channel(8.0), channel(4.0), 1.0])
            }
            _ => {
                let digits =
                    expression.strip_prefix('#').unwrap_or_else(|| panic!("{}: `{expression}`", self.name));
                let long: String = match digits.len() {
                    3 => digits.chars().flat_map(|c| [c, c]).collect(),
                    _ => digits.to_owned(),
                };
                let channel = |n: usize| f64::from(u8::from_str_radix(&long[n..n + 2], 16).unwrap()) / 255.0;
                Colour([channel(0), channel(2), channel(4), 1.0])
            }
        }
    }

    /// What the last rule of this selector says of a property.
    fn declared<'a>(rules: &'a [Rule], selector: &str, property: &str) -> Option<&'a str> {
        let mut of_selector = rules.iter().filter(|(s, _)| s == selector);
        assert!(of_selector.clone().next().is_some(), "no rule `{selector}`");
        of_selector.rfind(|(_, d)| d.contains_key(property)).map(|(_, d)| d[property].as_str())
    }

    /// What can be behind the text of a page. Quotations, tables and blocks of code have no ground of their own.
    fn grounds(&self) -> Vec<(&'static str, Colour)> {
        for bare in [".content blockquote", ".content table thead", ".content table tbody tr", ".hljs"] {
            assert_eq!(Self::declared(&self.page, bare, "background"), Some("none"), "{bare}");
        }
        let page = self.colour("var(--bg)");
        let tint =
            |selector| self.colour(Self::declared(&self.page, selector, "background").expect("a tint"));
        vec![("the page", page), ("a hint", tint(".content details").over(page))]
    }

    /// Every text with what can be behind it, and the least contrast that it needs.
    fn pairs(&self) -> Vec<(String, Colour, Colour, f64)> {
        let mut pairs = Vec::new();
        let mut pair = |text: &str, colour: Colour, on: &str, ground: Colour, least: f64| {
            pairs.push((format!("{}: {text} on {on}", self.name), colour, ground, least));
        };
        for (on, ground) in self.grounds() {
            let within =
                Self::declared(&self.page, ".content :not(pre) > code", "background").expect("a tint");
            let within = self.colour(within).over(ground);
            for text in ["--fg", "--links", "--inline-code-color"] {
                pair(text, self.colour(&format!("var({text})")), on, ground, TEXT);
                pair(text, self.colour(&format!("var({text})")), &format!("code in {on}"), within, TEXT);
            }
            // These inherit the colour of the text, or that of links, unless they name their own.
            for (selector, inherited) in [
                (".content .marks .origin > p", "var(--fg)"),
                (".figure .save", "var(--links)"),
                (".figure .panel > span", "var(--links)"),
                (".figure figcaption", "var(--fg)"),
                (".note", "var(--fg)"),
                (".scene button", "var(--fg)"),
                (".scene .press", "var(--fg)"),
                (".scene .view", "var(--fg)"),
                (".scene .says.trouble", "var(--fg)"),
                (".answers b", "var(--fg)"),
                (".answers .fails b", "var(--fg)"),
                (".answers .unread b", "var(--fg)"),
                (".answers .says", "var(--fg)"),
                (".answers .reset", "var(--fg)"),
                (".content main .answers .number code", "var(--fg)"),
                (".note-number", "var(--links)"),
                (".kicker", "var(--fg)"),
                (".content main h2::before", "var(--fg)"),
                (".content main h2:target::before", "var(--fg)"),
                (".uses", "var(--fg)"),
                (".content details.checks > summary", "var(--fg)"),
                (".content main li::marker", "var(--fg)"),
                (".menu-title", "var(--icons)"),
                (".foot", "var(--fg)"),
                (".foot nav span", "var(--links)"),
            ] {
                let colour = self.colour(Self::declared(&self.page, selector, "color").unwrap_or(inherited));
                let opacity =
                    Self::declared(&self.page, selector, "opacity").map_or(1.0, |n| n.parse().unwrap());
                let [r, g, b, _] = colour.0;
                pair(selector, Colour([r, g, b, opacity]), on, ground, TEXT);
            }
        }
        for hue in ["ink", "muted", "blue", "orange", "green", "pink", "purple"] {
            let [text, ground] = [hue, "page"].map(|name| self.colour(&format!("var(--figure-{name})")));
            pair(&format!("{hue} of figures"), text, "the page", ground, TEXT);
        }
        // Letters and words in the colours of quantities, wherever a formula can stand.
        let target = Self::declared(&self.page, ".equation:target", "background").expect("a tint");
        let target = self.colour(target).over(self.colour("var(--bg)"));
        for role in ["body", "spin", "momentum", "contact", "force"] {
            let class = format!(".q-{role}");
            let colour = self.colour(Self::declared(&self.page, &class, "color").expect("a colour"));
            for (on, ground) in self.grounds().into_iter().chain([("an equation that was asked for", target)])
            {
                pair(&class, colour, on, ground, TEXT);
            }
        }
        for (on, ground) in self.grounds() {
            let of_code = self.page.iter().filter(|(selector, _)| selector.starts_with(".hljs"));
            for (selector, colour) in of_code.filter_map(|(selector, d)| Some((selector, d.get("color")?))) {
                pair(selector, self.colour(colour), on, ground, TEXT);
            }
            let hidden = Self::declared(&self.page, ".boring", "opacity").expect("an opacity");
            let [r, g, b, _] = self.colour(Self::declared(&self.page, ".hljs", "color").expect("a colour")).0;
            pair("hidden lines", Colour([r, g, b, hidden.parse().unwrap()]), on, ground, TEXT);
        }
        for (text, on, least) in [
            ("--sidebar-fg", "--sidebar-bg", TEXT),
            ("--sidebar-active", "--sidebar-bg", TEXT),
            ("--searchresults-header-fg", "--bg", TEXT),
            ("--icons", "--bg", SIGN),
            ("--accent", "--bg", SIGN),
            ("--track", "--bg", SIGN),
            ("--bg", "--accent", TEXT),
            ("--icons", "--theme-popup-bg", SIGN),
        ] {
            let [text_colour, ground] = [text, on].map(|name| self.colour(&format!("var({name})")));
            pair(text, text_colour, on, ground, least);
        }
        pairs
    }
}

#[test]
fn text_can_be_read_in_every_theme() {
    let mut poor = Vec::new();
    for name in THEMES {
        let pairs = Theme::new(name).pairs();
        assert!(pairs.len() > 70, "{name}: only {} pairs", pairs.len());
        for (what, text, ground, least) in pairs {
            let found = contrast(text, ground);
            if found < least {
                poor.push(format!("{what}: {found:.2}"));
            }
        }
    }
    assert!(poor.is_empty(), "{}", poor.join("\n"));
}

#[test]
fn colours_are_computed_as_the_recommendation_says() {
    let theme = Theme::new("light");
    let of = |a: &str, b: &str| contrast(theme.colour(a), theme.colour(b));
    assert!((of("#000", "#ffffff") - 21.0).abs() < 1e-9);
    assert!((of("#767676", "hsl(0, 0%, 100%)") - 4.54).abs() < 5e-3); // the well-known lightest grey on white
    assert!((of("hsl(210, 25%, 8%)", "#0f141a") - 1.0).abs() < 0.01);
    assert!((of("rgb(0 0 0 / 50%)", "#fff") - 3.98).abs() < 0.01);
    assert_eq!(theme.colour("light-dark(rgb(1 2 3), #fff)"), theme.colour("#010203"));
    assert!(!theme.is_dark() && Theme::new("ayu").is_dark());
}

#[test]
fn links_are_told_by_a_line_and_what_shows_under_a_pointer_shows_to_the_keyboard() {
    let page = Theme::new("light").page;
    let of =
        |selector: &str, property: &str| Theme::declared(&page, selector, property).unwrap_or("").to_owned();
    assert_eq!(of(".content main a:any-link", "text-decoration"), "underline");
    let without: Vec<&str> = page
        .iter()
        .filter(|(selector, d)| {
            selector.contains("main") && d.get("text-decoration").is_some_and(|line| line == "none")
        })
        .map(|(selector, _)| selector.as_str())
        .collect();
    // What is no word in a text: headings, numbers of equations and of notes, names below pictures, squares of the ledger.
    let apart = [
        ".kicker.leaf a",
        "a.header",
        ".marks .number",
        "a.note-mark",
        "a.note-number",
        "a.panel",
        ".squares a",
    ];
    assert_eq!(without, apart.map(|what| format!(".content main {what}:any-link")));
    assert_eq!(of("pre > .buttons", "visibility"), "visible");
    assert_eq!(of("pre:focus-within > .buttons", "opacity"), "1");
    for (path, html) in super::pages() {
        assert!(
            !html.contains("class=\"drawing\" tabindex"),
            "{}: a figure is a stop without a name",
            path.display()
        );
        assert!(!html.contains("<th></th>"), "{}: a column has no name", path.display());
    }
}
