//! Numbers in print: a power of ten, and the units that stand behind them. Pages and scenes print them alike.

/// A number with a power of ten, as HTML: 1.6·10⁸.
pub fn with_power(mantissa: &str, power: &str) -> String {
    format!("{mantissa}·10<sup>{power}</sup>").replace('-', "−")
}

/// What units are made of.
const PARTS: [&str; 31] = [
    "kg", "g", "t", "m", "cm", "mm", "µm", "nm", "km", "s", "ms", "µs", "ns", "min", "h", "N", "mN", "kN",
    "MN", "J", "mJ", "kJ", "W", "mW", "kW", "Hz", "kHz", "Pa", "rad", "mrad", "%",
];

/// Whether a word is a unit: `kg`, `rad/s²`, `N·m`, `s⁻¹`.
pub fn is_unit(word: &str) -> bool {
    word.split(['/', '·']).all(|part| PARTS.contains(&part.trim_end_matches(['²', '³', '⁻', '¹'])))
}
