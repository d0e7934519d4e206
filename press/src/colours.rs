//! The quantities that have a colour, in formulas, in words and in figures.

/// A quantity that has a colour: what authors call it, and the hue of figures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Quantity {
    pub(crate) role: &'static str,
    pub(crate) hue: &'static str,
}

/// All of them, as figures colour them.
pub(crate) const QUANTITIES: [Quantity; 5] = [
    Quantity { role: "body", hue: "blue" },
    Quantity { role: "spin", hue: "orange" },
    Quantity { role: "momentum", hue: "green" },
    Quantity { role: "contact", hue: "pink" },
    Quantity { role: "force", hue: "purple" },
];

impl Quantity {
    /// The quantity that authors call so in `[words]{.role}`; if there is none, what there is.
    pub(crate) fn of_role(role: &str) -> Result<Self, String> {
        let known = || QUANTITIES.map(|quantity| quantity.role).join(", ");
        let found = QUANTITIES.into_iter().find(|quantity| quantity.role == role);
        found.ok_or_else(|| format!("no words are coloured as `{role}`, but as {}", known()))
    }

    /// The class of a page's elements that are to have its colour.
    pub(crate) fn class(self) -> String {
        format!("q-{}", self.role)
    }
}
