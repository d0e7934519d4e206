//! What the pages show: the figures of the book and the tables of the library, as its build script has rendered them,
//! and its live scenes.

mod stills;

use crate::{Book, html};
use std::path::Path;
use std::{fs, io};

/// What a build script has rendered, read from its folder, and what the program itself knows.
#[derive(Debug, Clone, Default)]
pub struct Rendered {
    /// What the book says of itself.
    pub book: Book,
    /// Every figure.
    pub figures: Vec<Figure>,
    /// Tables in Markdown, each with its name: `methods`.
    pub tables: Vec<(String, String)>,
    /// The live scenes, in the order in which the module of the pages counts them.
    pub scenes: Vec<Scene>,
    /// Whether there is no module that could move them, and pages show stills without controls.
    pub is_still: bool,
}

/// A live scene: what its page prints of it.
#[derive(Debug, Clone, Default)]
pub struct Scene {
    /// Its name: `turning` for `scene:turning`.
    pub name: String,
    /// The folder of the chapter that it opens.
    pub chapter: String,
    /// The file that makes it: `book/turning/scene.rs`.
    pub source: String,
    /// What it asks. Here and in other words of a scene formulas stand between `$` signs.
    pub question: String,
    /// Its still as SVGs for a page, on a wide one and on a phone.
    pub svg: String,
    /// Where the eye stands at first, azimuth and elevation in degrees, if a reader can turn the view.
    pub view: Option<[f64; 2]>,
    /// The time that the still shows, s of the scene.
    pub still: f64,
    /// What a reader can change.
    pub controls: Vec<Control>,
    /// Words on buttons, and the settings that they bring: `ratio=1&spin=3`.
    pub presets: Vec<(String, String)>,
    /// What the numbers beside the picture are.
    pub readings: Vec<String>,
}

/// Something that a reader can change.
#[derive(Debug, Clone)]
pub struct Control {
    /// Its name in links and presets.
    pub name: String,
    /// What stands beside it.
    pub words: String,
    /// What kind of thing it is.
    pub input: Input,
    /// Its value when the page opens.
    pub start: f64,
    /// Its unit; empty for pure numbers.
    pub unit: String,
    /// That value with its unit, as the page shows it.
    pub shown: String,
}

/// The kinds of controls.
#[derive(Debug, Clone, PartialEq)]
pub enum Input {
    /// A slider in steps from the first value.
    Slider {
        /// The least value.
        from: f64,
        /// The greatest value.
        to: f64,
        /// The step.
        step: f64,
    },
    /// A slider over powers of ten.
    LogSlider {
        /// The least value, above zero.
        from: f64,
        /// The greatest value.
        to: f64,
    },
    /// One of several; the value is its place.
    Choice(Vec<String>),
    /// On (1) or off (0).
    Switch,
    /// A button; its value is the time at which it was pressed, or −1.
    Button,
}

/// One rendered figure.
#[derive(Debug, Clone)]
pub struct Figure {
    /// Its label: `fig:machine`.
    pub id: String,
    /// The file that draws it: `book/laundromat/figures.rs`.
    pub source: String,
    /// Its SVGs for a page in their box, coloured by the page's style sheet.
    pub svg: String,
    /// Whether it needs more room than a column of text has.
    pub wide: bool,
    /// SVG that stands alone, for slides.
    pub standalone: String,
}

impl Rendered {
    /// All that a book shows; the stills of its scenes are drawn now.
    ///
    /// # Errors
    /// If a file of the build script is missing or cannot be read; which scene cannot be drawn as it starts, and why.
    pub fn of(book: &Book) -> Result<Self, String> {
        let mut rendered = Self::read(book).map_err(|error| format!("error: {error}"))?;
        rendered.scenes = stills::all(book.scenes).map_err(|error| format!("error: {error}"))?;
        Ok(rendered)
    }

    /// The figures and tables, of which `figures::write` says how they lie in the folder.
    ///
    /// # Errors
    /// If a file is missing or cannot be read.
    pub(crate) fn read(book: &Book) -> io::Result<Self> {
        let folder = Path::new(book.drawn);
        let text = |name: &str| {
            fs::read_to_string(folder.join(name)).map_err(|error| {
                io::Error::new(error.kind(), format!("{}/{name}: {error}", folder.display()))
            })
        };
        let mut rendered = Self { book: *book, ..Self::default() };
        for line in text("figures.txt")?.lines() {
            let mut words = line.splitn(3, ' ');
            let [id, place, source] = [(); 3].map(|()| words.next().unwrap_or_default());
            let name = file_stem(id);
            rendered.figures.push(Figure {
                id: id.to_owned(),
                source: source.to_owned(),
                wide: place == "wide",
                svg: text(&format!("{name}.inline.svg"))?,
                standalone: text(&format!("{name}.svg"))?,
            });
        }
        for entry in fs::read_dir(folder)? {
            let name = entry?.file_name().to_string_lossy().into_owned();
            if let Some(table) = name.strip_suffix(".md") {
                rendered.tables.push((table.to_owned(), text(&name)?));
            }
        }
        Ok(rendered)
    }

    /// Writes every figure into `folder` as a standalone SVG file, `machine.svg`; returns how many there are.
    ///
    /// # Errors
    /// If the folder or a file cannot be written.
    pub fn write_all(&self, folder: &Path) -> io::Result<usize> {
        fs::create_dir_all(folder)?;
        for figure in &self.figures {
            fs::write(folder.join(figure.file_name()), &figure.standalone)?;
        }
        Ok(self.figures.len())
    }
}

impl Figure {
    /// The ids in its SVG.
    pub(crate) fn ids(&self) -> impl Iterator<Item = String> {
        html::ids(&self.svg)
    }

    /// The name of its file: `machine.svg`.
    pub(crate) fn file_name(&self) -> String {
        format!("{}.svg", file_stem(&self.id))
    }
}

/// `fig:machine` → `machine`.
fn file_stem(id: &str) -> &str {
    id.trim_start_matches("fig:")
}
