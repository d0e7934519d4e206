//! Numbers in print: a power of ten, and the units that stand behind them. Pages and scenes print them alike.

/// A blank at which no line ends.
pub const BLANK: &str = "\u{a0}";

/// A number with a power of ten, as HTML: 1.6·10⁸, and 10⁻³ where it is one of them itself. (`pretty` in numbers.js
/// does the same when a reader changes a number.)
pub fn with_power(mantissa: &str, power: &str) -> String {
    let digits = mantissa.strip_suffix('1').filter(|sign| matches!(*sign, "" | "-" | "−"));
    let digits = digits.map_or_else(|| format!("{mantissa}·"), str::to_owned);
    format!("{digits}10<sup>{power}</sup>").replace('-', "−")
}

/// What units are made of.
const PARTS: [&str; 32] = [
    "kg", "g", "mg", "t", "m", "cm", "mm", "µm", "nm", "km", "s", "ms", "µs", "ns", "min", "h", "N", "mN",
    "kN", "MN", "J", "mJ", "kJ", "W", "mW", "kW", "Hz", "kHz", "Pa", "rad", "mrad", "%",
];

/// Whether a word is a unit: `kg`, `rad/s²`, `N·m`, `s⁻¹`.
pub fn is_unit(word: &str) -> bool {
    word.split(['/', '·']).all(|part| PARTS.contains(&part.trim_end_matches(['²', '³', '⁻', '¹'])))
}

/// Words whose number is their name: `axis 3`.
const NUMBERED: [&str; 10] =
    ["axis", "axes", "simulator", "problem", "chapter", "chapters", "section", "article", "volume", "page"];

/// Where in a run of text a blank stands between a number and its unit, or before a number that is a name.
pub fn blanks(text: &str) -> impl Iterator<Item = usize> + '_ {
    let bytes = text.as_bytes();
    let names = move |at: usize| {
        let is_number = bytes.get(at + 1).is_some_and(u8::is_ascii_digit);
        let word = || text[..at].rsplit(|c: char| !c.is_ascii_alphabetic()).next().unwrap_or_default();
        matches!(bytes[at], b' ' | b'\n')
            && is_number
            && NUMBERED.iter().any(|name| name.eq_ignore_ascii_case(word()))
    };
    // Between the thousands of a number: behind one to three digits, and before three.
    let digits =
        |digits: &mut dyn Iterator<Item = &u8>| digits.take_while(|byte| byte.is_ascii_digit()).count();
    let is_inside = move |at: usize| {
        matches!(bytes[at], b' ' | b'\n')
            && (1..=3).contains(&digits(&mut bytes[..at].iter().rev()))
            && digits(&mut bytes[at + 1..].iter()) == 3
    };
    (1..bytes.len()).filter(move |&at| {
        bytes[at - 1].is_ascii_digit() && (unit(&text[at..]).is_some() || is_inside(at))
            || bytes[at - 1].is_ascii_alphabetic() && names(at)
    })
}

/// How long the blank and the unit are with which a text begins. (Only of the letters that units have, as a module of a
/// page would carry the tables of all others.)
pub fn unit(text: &str) -> Option<usize> {
    let rest = text.strip_prefix([' ', '\n'])?;
    let of_unit =
        |c: char| c.is_ascii_alphabetic() || matches!(c, 'µ' | '/' | '%' | '·' | '²' | '³' | '⁻' | '¹');
    let end = rest.char_indices().find(|&(_, c)| !of_unit(c)).map_or(rest.len(), |(end, _)| end);
    let goes_on = matches!(rest[end..].chars().next(), Some('^' | 'À'..='ʯ'));
    (is_unit(&rest[..end]) && !goes_on).then_some(1 + end)
}

/// A text in which no line parts a number from its unit, nor from the word that it numbers.
///
/// ```
/// use live::numbers::tied;
/// assert_eq!(tied("every 0.31 s, at 30 rad/s of 2 turns"), "every 0.31\u{a0}s, at 30\u{a0}rad/s of 2 turns");
/// assert_eq!(tied("12 345 678 of 90 000 in 2026"), "12\u{a0}345\u{a0}678 of 90\u{a0}000 in 2026");
/// assert_eq!(tied("of 3 axes axis 3 is the axle"), "of 3 axes axis\u{a0}3 is the axle");
/// assert_eq!(tied("Chapters 4 and 14"), "Chapters\u{a0}4 and 14");
/// ```
pub fn tied(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut done = 0;
    for at in blanks(text) {
        out.push_str(&text[done..at]);
        out.push_str(BLANK);
        done = at + 1;
    }
    out.push_str(&text[done..]);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_of_ten_has_no_one_before_it() {
        let raised = |power: &str| format!("10<sup>{power}</sup>");
        assert_eq!(with_power("1.6", "8"), format!("1.6·{}", raised("8")));
        assert_eq!(with_power("-11", "-2"), format!("−11·{}", raised("−2")));
        assert_eq!(
            [with_power("1", "-3"), with_power("-1", "3")],
            [raised("−3"), format!("−{}", raised("3"))]
        );
    }

    #[test]
    fn a_number_keeps_its_unit() {
        let found: Vec<usize> = blanks("It has 5 kg, 3 m and 20 meals; in 4\ns, 9 % at 1.5 rad/s").collect();
        assert_eq!(found, [8, 14, 35, 40, 49]);
        for tied in
            ["400 t", "30 km/s", "44 cm/s", "7.9 kN", "6 N·m", "2 kg·m²", "10 m/s²", "3 s⁻¹.", "7 MN·s"]
        {
            assert_eq!(blanks(tied).count(), 1, "{tied}");
        }
        assert_eq!(blanks("5 N·, 2 things, 3 m^2, 1 a/b, 3 mètres").count(), 0);
    }
}
