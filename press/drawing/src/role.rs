//! What a shape means. The style sheet says what that looks like.

/// An enumeration whose members each have a class of the style sheet.
macro_rules! styled {
    ($(#[$about:meta])* $name:ident { $($(#[$what:meta])* $member:ident = $class:literal,)+ }) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum $name {
            $($(#[$what])* $member,)+
        }

        impl $name {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$member),+];

            /// The class of the style sheet.
            pub const fn class(self) -> &'static str {
                match self {
                    $(Self::$member => $class,)+
                }
            }
        }
    };
}

styled! {
    /// What a colour stands for, the same on every page of the book.
    Hue {
        /// The colour of the text: axes, outlines, names.
        Ink = "f-ink",
        /// A quieter ink, for what stands behind: references, bounds, remarks.
        Muted = "f-muted",
        /// The faintest ink: with [`Ink`](Self::Ink) and [`Muted`](Self::Muted) a ramp of three for curves that differ by a
        /// parameter. Too faint for words: name such a curve in the muted ink.
        Faint = "f-faint",
        /// The body.
        Blue = "f-blue",
        /// Angular velocity.
        Orange = "f-orange",
        /// Angular momentum.
        Green = "f-green",
        /// Points of contact and impulses.
        Pink = "f-pink",
        /// Forces and torques.
        Purple = "f-purple",
        /// Stepping methods: the first hue of a code of their own.
        Teal = "f-teal",
        /// Stepping methods: the second.
        Ochre = "f-ochre",
    }
}

styled! {
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
    Stroke {
        /// An axis of a plot or a major tick, 1 px.
        Axis = "f-axis",
        /// A minor tick, 0.75 px.
        Tick = "f-tick",
        /// A curve of a plot, 2 px.
        Curve = "f-curve",
        /// The curve that a plot is about, among others, 3 px.
        Heavy = "f-heavy",
        /// A curve that is shown as wrong or as an approximation, 2 px, in even dashes.
        DashedCurve = "f-dashed-curve",
        /// The second curve of a hue, right as the first, 2 px, in long dashes.
        Second = "f-second",
        /// The third curve of a hue, 2 px, in short dashes.
        Third = "f-third",
        /// A separatrix, or the border of a region, 1.25 px, in dashes and dots.
        Border = "f-border",
        /// A path of many turns, 1 px.
        Orbit = "f-orbit",
        /// An arrow's shaft, 1.75 px.
        Vector = "f-vector",
        /// The outline of a body, an angle's arc, a dimension, 1 px.
        Outline = "f-outline",
        /// A construction or reference line, 1 px, dashed.
        Reference = "f-reference",
        /// A quieter reference line, dotted.
        Dotted = "f-dotted",
        /// An edge behind a body, dashed and pale.
        Hidden = "f-hidden",
        /// What stands further back: the outline of a ghost, the far side of a path, 1 px, pale.
        Pale = "f-pale",
        /// Hatching, 0.75 px.
        Hatch = "f-hatch",
        /// A line of a grid on the ground, a pale hairline.
        Grid = "f-grid",
    }
}

styled! {
    /// How an area is filled.
    Fill {
        /// With the hue itself: markers, arrowheads.
        Solid = "f-solid",
        /// The lit face of a body: a tint of the hue.
        Face = "f-face",
        /// The side of a body: a stronger tint.
        Side = "f-side",
        /// A body of glass: a tint through which others are seen.
        Glass = "f-glass",
        /// A body at another time: barely a tint.
        Ghost = "f-ghost",
        /// A region of the plane that means something: the palest tint.
        Ground = "f-ground",
        /// The shading of a rounded body, given by its shape, [`Shape::Rounded`](crate::Shape::Rounded).
        Round = "f-round",
        /// The ground that bodies stand on: barely a tint.
        Floor = "f-floor",
        /// The colour of the page, to hide what lies behind.
        Page = "f-page",
    }
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

impl Stroke {
    /// How wide the style sheet draws it, px.
    pub const fn width(self) -> f64 {
        match self {
            Self::Heavy => 3.0,
            Self::Curve | Self::DashedCurve | Self::Second | Self::Third => 2.0,
            Self::Border => 1.25,
            Self::Vector => 1.75,
            Self::Dotted => 1.6,
            Self::Tick | Self::Hatch => 0.75,
            Self::Grid => 0.6,
            Self::Axis | Self::Orbit | Self::Outline | Self::Reference | Self::Hidden | Self::Pale => 1.0,
        }
    }
}

impl Fill {
    /// Whether one sees through it what is painted behind it.
    pub(crate) const fn is_tint(self) -> bool {
        !matches!(self, Self::Solid | Self::Page)
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
