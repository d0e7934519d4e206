//! What a shape means. The style sheet says what that looks like.

/// What a colour stands for, the same on every page of the book.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Hue {
    /// The colour of the text: axes, outlines, names.
    Ink,
    /// A quieter ink, for what stands behind: references, bounds, remarks.
    Muted,
    /// The body; in plots the first curve.
    Blue,
    /// Angular velocity; the second curve.
    Orange,
    /// Angular momentum; the third curve.
    Green,
    /// Points of contact and impulses; the fourth curve.
    Pink,
    /// Forces and torques; the fifth curve.
    Purple,
}

/// How a line is drawn. Each meaning of a broken line has a pattern of its own:
///
/// | pattern | stroke | meaning |
/// |---|---|---|
/// | even dashes, thin | [`Reference`](Self::Reference) | a line to compare with, a construction |
/// | dots | [`Dotted`](Self::Dotted) | a quieter one; the way from a label to what it names |
/// | even dashes, thick | [`DashedCurve`](Self::DashedCurve) | a curve that is wrong, or only near the truth |
/// | short dashes, pale | [`Hidden`](Self::Hidden) | what lies behind a body |
/// | dash and dot | [`Border`](Self::Border) | where one kind of motion ends and another begins: a separatrix |
/// | long dashes, thick | [`Second`](Self::Second) | the second curve of a hue |
/// | short dashes, thick | [`Third`](Self::Third) | the third curve of a hue |
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Stroke {
    /// An axis of a plot or a major tick, 1 px.
    Axis,
    /// A minor tick, 0.75 px.
    Tick,
    /// A curve of a plot, 2 px.
    Curve,
    /// A curve that is shown as wrong or as an approximation, 2 px, in even dashes.
    DashedCurve,
    /// The second curve of a hue, right as the first, 2 px, in long dashes.
    Second,
    /// The third curve of a hue, 2 px, in short dashes.
    Third,
    /// A separatrix, or the border of a region, 1.25 px, in dashes and dots.
    Border,
    /// A path of many turns, 1 px.
    Orbit,
    /// An arrow's shaft, 1.75 px.
    Vector,
    /// The outline of a body, an angle's arc, a dimension, 1 px.
    Outline,
    /// A construction or reference line, 1 px, dashed.
    Reference,
    /// A quieter reference line, dotted.
    Dotted,
    /// An edge behind a body, dashed and pale.
    Hidden,
    /// What stands further back: the outline of a ghost, the far side of a path, 1 px, pale.
    Pale,
    /// Hatching, 0.75 px.
    Hatch,
    /// A line of a grid on the ground, a pale hairline.
    Grid,
}

/// How an area is filled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Fill {
    /// With the hue itself: markers, arrowheads.
    Solid,
    /// The lit face of a body: a tint of the hue.
    Face,
    /// The side of a body: a stronger tint.
    Side,
    /// A body of glass: a tint through which others are seen.
    Glass,
    /// A body at another time: barely a tint.
    Ghost,
    /// A region of the plane that means something: the palest tint.
    Ground,
    /// The shading of a rounded body, given by its shape, [`Shape::Rounded`](crate::Shape::Rounded).
    Round,
    /// The ground that bodies stand on: barely a tint.
    Floor,
    /// The colour of the page, to hide what lies behind.
    Page,
}

/// What a shape is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Role {
    /// A line.
    Line(Stroke, Hue),
    /// A filled area without outline.
    Area(Fill, Hue),
    /// A label, with a rim in the colour of the page.
    Text(Hue),
    /// A label on a filled area, without rim.
    PlainText(Hue),
}

/// The classes of the three stops of a rounded body's shading, from where it is brightest to its outline.
pub(crate) const STOPS: [&str; 3] = ["f-lit", "f-half-lit", "f-unlit"];

/// The class of a tint under which the page is, and not what is painted behind it.
pub(crate) const OPAQUE: &str = "f-opaque";

/// The class of a label's rim where it is drawn by itself.
pub(crate) const RIM: &str = "f-rim";

impl Hue {
    /// All of them.
    pub const ALL: [Self; 7] =
        [Self::Ink, Self::Muted, Self::Blue, Self::Orange, Self::Green, Self::Pink, Self::Purple];

    /// The class of the style sheet.
    pub const fn class(self) -> &'static str {
        match self {
            Self::Ink => "f-ink",
            Self::Muted => "f-muted",
            Self::Blue => "f-blue",
            Self::Orange => "f-orange",
            Self::Green => "f-green",
            Self::Pink => "f-pink",
            Self::Purple => "f-purple",
        }
    }
}

impl Stroke {
    /// All of them.
    pub const ALL: [Self; 16] = [
        Self::Axis,
        Self::Tick,
        Self::Curve,
        Self::DashedCurve,
        Self::Second,
        Self::Third,
        Self::Border,
        Self::Orbit,
        Self::Vector,
        Self::Outline,
        Self::Reference,
        Self::Dotted,
        Self::Hidden,
        Self::Pale,
        Self::Hatch,
        Self::Grid,
    ];

    /// How wide the style sheet draws it, px.
    pub const fn width(self) -> f64 {
        match self {
            Self::Curve | Self::DashedCurve | Self::Second | Self::Third => 2.0,
            Self::Border => 1.25,
            Self::Vector => 1.75,
            Self::Dotted => 1.6,
            Self::Tick | Self::Hatch => 0.75,
            Self::Grid => 0.6,
            Self::Axis | Self::Orbit | Self::Outline | Self::Reference | Self::Hidden | Self::Pale => 1.0,
        }
    }

    /// The class of the style sheet.
    pub const fn class(self) -> &'static str {
        match self {
            Self::Axis => "f-axis",
            Self::Tick => "f-tick",
            Self::Curve => "f-curve",
            Self::DashedCurve => "f-dashed-curve",
            Self::Second => "f-second",
            Self::Third => "f-third",
            Self::Border => "f-border",
            Self::Orbit => "f-orbit",
            Self::Vector => "f-vector",
            Self::Outline => "f-outline",
            Self::Reference => "f-reference",
            Self::Dotted => "f-dotted",
            Self::Hidden => "f-hidden",
            Self::Pale => "f-pale",
            Self::Hatch => "f-hatch",
            Self::Grid => "f-grid",
        }
    }
}

impl Fill {
    /// Whether one sees through it what is painted behind it.
    pub(crate) const fn is_tint(self) -> bool {
        !matches!(self, Self::Solid | Self::Page)
    }

    /// All of them.
    pub const ALL: [Self; 9] = [
        Self::Solid,
        Self::Face,
        Self::Side,
        Self::Glass,
        Self::Ghost,
        Self::Ground,
        Self::Round,
        Self::Floor,
        Self::Page,
    ];

    /// The class of the style sheet.
    pub const fn class(self) -> &'static str {
        match self {
            Self::Solid => "f-solid",
            Self::Face => "f-face",
            Self::Side => "f-side",
            Self::Glass => "f-glass",
            Self::Ghost => "f-ghost",
            Self::Ground => "f-ground",
            Self::Round => "f-round",
            Self::Floor => "f-floor",
            Self::Page => "f-page",
        }
    }
}

impl Role {
    /// The classes of the style sheet, as an SVG element carries them.
    pub fn classes(self) -> String {
        match self {
            Self::Line(stroke, hue) => format!("f-line {} {}", stroke.class(), hue.class()),
            Self::Area(fill, hue) => format!("{} {}", fill.class(), hue.class()),
            Self::Text(hue) => format!("f-text {}", hue.class()),
            Self::PlainText(hue) => format!("f-plain {}", hue.class()),
        }
    }
}
