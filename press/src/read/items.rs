//! What stands on a page that the press has to replace or check.

use pulldown_cmark::Event;
use std::borrow::Cow;
use std::ops::Range;

/// The kinds of labels, as they are written before the colon.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum LabelKind {
    Equation,
    Figure,
    Scene,
    Exercise,
    Solution,
    Section,
    Citation,
}

impl LabelKind {
    pub(crate) const ALL: [Self; 7] = [
        Self::Equation,
        Self::Figure,
        Self::Scene,
        Self::Exercise,
        Self::Solution,
        Self::Section,
        Self::Citation,
    ];

    pub(crate) fn prefix(self) -> &'static str {
        match self {
            Self::Equation => "eq",
            Self::Figure => "fig",
            Self::Scene => "scene",
            Self::Exercise => "ex",
            Self::Solution => "sol",
            Self::Section => "sec",
            Self::Citation => "cite",
        }
    }

    pub(crate) fn from_prefix(prefix: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.prefix() == prefix)
    }
}

/// A label as a page defines it.
#[derive(Debug, Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Label {
    pub(crate) kind: LabelKind,
    pub(crate) name: String,
}

impl Label {
    /// As authors write it: `eq:steady-radius`.
    pub(crate) fn written(&self) -> String {
        format!("{}:{}", self.kind.prefix(), self.name)
    }

    /// As the page's id: `eq-steady-radius`.
    pub(crate) fn id(&self) -> String {
        format!("{}-{}", self.kind.prefix(), self.name)
    }
}

/// What is said behind the closing dollars of a labelled equation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct EquationLabel {
    pub(crate) label: Label,
    /// Numbers of the source.
    pub(crate) source: Vec<u32>,
    pub(crate) corrected: bool,
}

/// A mention: `@eq:steady-radius`, or `@source:19`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Mention {
    Label(Label),
    Source(u32),
}

/// Words that the press prints as HTML, each piece with its place on the page.
pub(crate) type Words<'a> = Vec<(Event<'a>, usize)>;

/// A table: its rows of cells, of which the first holds the names of the columns.
#[derive(Debug, Default)]
pub(crate) struct Table<'a> {
    pub(crate) rows: Vec<Vec<Cell<'a>>>,
}

/// A cell of a table.
#[derive(Debug, Default)]
pub(crate) struct Cell<'a> {
    /// Where it stands on the page.
    pub(crate) offset: usize,
    pub(crate) words: Words<'a>,
}

/// A note in the margin: `[^name]` in the text and `[^name]: words` below it.
#[derive(Debug, Clone)]
pub(crate) struct Note<'a> {
    pub(crate) name: String,
    pub(crate) words: Words<'a>,
    /// Where the words stand on the page.
    pub(crate) offset: usize,
}

/// One thing on a page that the press has to see to.
#[derive(Debug)]
pub(crate) enum Item<'a> {
    InlineMaths {
        tex: Cow<'a, str>,
    },
    DisplayMaths {
        tex: Cow<'a, str>,
        label: Option<EquationLabel>,
    },
    Figure {
        label: Label,
        caption: Words<'a>,
    },
    Scene {
        label: Label,
        caption: Words<'a>,
    },
    Table {
        table: Table<'a>,
        caption: Words<'a>,
    },
    /// A table that the library gives.
    LibraryTable {
        name: String,
        caption: Words<'a>,
    },
    Heading {
        level: u8,
        label: Option<Label>,
        /// The id that the heading claims, `## Title {#id}`, if that is no label.
        id: Option<&'a str>,
        title: &'a str,
        plain: String,
    },
    Mention(Mention),
    /// The mark of a note.
    NoteMark(String),
    /// The words of a note, behind the block that holds its mark.
    Note(Note<'a>),
    /// The place where a note is written, and not printed.
    NoteDefinition,
    /// A snippet in Rust, fences included.
    Snippet {
        code: &'a str,
    },
    Citation {
        label: Label,
        short: &'a str,
    },
    /// Where an entry of the bibliography ends.
    CitationEnd(Label),
    Link {
        target: Cow<'a, str>,
    },
    /// A picture in a file beside the page, which mdBook prints as it is.
    Picture {
        file: String,
    },
    /// `[`: words begin that set a scene of the page. It holds the name of the scene and the settings.
    SettingStart(Cow<'a, str>),
    /// `](scene:…)`: these words end.
    SettingEnd,
    /// An id that raw HTML claims.
    Id(String),
    Hint,
    /// A blank between a number and its unit.
    Blank,
    /// A dash between two numbers, behind which no line ends.
    Dash,
    /// `[`: words of this class begin: in the colour of a quantity, or for a screen alone.
    MarkedStart(String),
    /// `]{.role}`: these words end.
    MarkedEnd,
}

/// An item and the bytes of the page that it takes up.
#[derive(Debug)]
pub(crate) struct PlacedItem<'a> {
    pub(crate) range: Range<usize>,
    pub(crate) item: Item<'a>,
}
