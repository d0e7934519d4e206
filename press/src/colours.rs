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

/// The role of words that only a reader at a screen can follow, “drag the ring”: paper leaves them out.
const SCREEN: &str = "screen";

/// The class of `[words]{.role}`: the colour of a quantity, or that they are for a screen alone. If there is no such role, those
/// that there are.
pub(crate) fn class_of(role: &str) -> Result<String, String> {
    if role == SCREEN {
        return Ok(SCREEN.to_owned());
    }
    let known = || QUANTITIES.map(|quantity| quantity.role).join(", ");
    let found = QUANTITIES.into_iter().find(|quantity| quantity.role == role);
    found.map(Quantity::class).ok_or_else(|| {
        format!("no words are marked as `{role}`, but as {SCREEN}, or coloured as {}", known())
    })
}

impl Quantity {
    /// The class of a page's elements that are to have its colour.
    pub(crate) fn class(self) -> String {
        format!("q-{}", self.role)
    }
}
