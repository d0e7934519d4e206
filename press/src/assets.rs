//! What the pages show: the figures of the book and the tables of the library, as its build script has rendered them,
//! and its live scenes.

use crate::Book;
use anyhow::{Context as _, Result, anyhow};
use live::{Kind, Player};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

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
    /// The files beside the pages, by their paths within the book: `a/cat.png`.
    pub beside: BTreeSet<String>,
    /// Whether there is no module that could move them, and pages show stills without controls.
    pub is_still: bool,
}

/// A live scene, as its page shows it first.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Where it stands: the folder of the chapter that it opens, `turning`, or a page of a chapter, `turning/middle-axis`.
    pub page: &'static str,
    /// What it is.
    pub live: live::Scene,
    /// Its still as SVGs for a page, on a wide one and on a phone.
    pub svg: String,
    /// The longest of what it says where the text leads and at the ends of its controls: the page keeps room for it.
    pub longest: String,
    /// Whether it can be heard.
    pub sounds: bool,
    /// The least elevation from which it can be looked at, rad.
    pub lowest_eye: f64,
}

impl Scene {
    /// The file that makes it: `book/turning/scene.rs`.
    pub(crate) fn source(&self) -> String {
        self.live.file.replace('\\', "/")
    }

    /// The folder of its chapter: `turning`.
    pub(crate) fn chapter(&self) -> &'static str {
        chapter_of(self.page)
    }

    /// Draws the still, by the code that moves the scene in its page.
    fn drawn(page: &'static str, scene: &'static live::Scene) -> Result<Self> {
        let cannot = |error| anyhow!("{}: the scene {}: {error}", scene.file, scene.name);
        let mut player = Player::new(scene).map_err(cannot)?;
        let svg = player.still().and_then(|still| Ok(still.to_svg()?)).map_err(cannot)?;
        let (sounds, lowest_eye) = (player.sound(scene.still).is_some(), player.lowest_eye());
        Ok(Self { page, live: *scene, svg, longest: longest(scene), sounds, lowest_eye })
    }
}

/// The folder of the chapter in which a scene stands.
pub(crate) fn chapter_of(page: &'static str) -> &'static str {
    page.split_once('/').map_or(page, |(chapter, _)| chapter)
}

/// The longest words that a scene may say: room is kept for them.
fn longest(scene: &'static live::Scene) -> String {
    let ends = scene.controls.iter().flat_map(|control| {
        let values = match control.kind {
            Kind::Slider { from, to, .. } | Kind::LogSlider { from, to, .. } => vec![from, to],
            Kind::Choice(choices) => (0..choices.len()).map(|choice| choice as f64).collect(),
            Kind::Switch => vec![0.0, 1.0],
            Kind::Button(_) => vec![0.0],
            Kind::Kept => Vec::new(),
        };
        values.into_iter().map(|value| vec![(control.name, value)])
    });
    let all = scene.presets.iter().map(|preset| preset.settings.to_vec()).chain(ends);
    let said = all.map(|settings| {
        let player = Player::new(scene).and_then(|start| start.changed(&settings));
        player.map_or_else(|trouble| trouble.to_string(), |player| player.words(0.0))
    });
    said.max_by_key(|words| words.chars().count()).unwrap_or_default()
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
    /// Where on a page it has room: `margin`, `column` of text, or `wide`.
    pub place: String,
    /// SVG that stands alone, for slides.
    pub standalone: String,
}

impl Rendered {
    /// All that a book shows; the stills of its scenes are drawn now.
    ///
    /// # Errors
    /// If a file of the build script is missing or cannot be read; which scene cannot be drawn as it starts, and why.
    pub fn of(book: &Book) -> Result<Self> {
        let mut rendered = Self::read(book)?;
        let scenes = book.scenes.iter().map(|(page, scene)| Scene::drawn(page, scene));
        rendered.scenes = scenes.collect::<Result<_>>()?;
        Ok(rendered)
    }

    /// The figures and tables, of which `figures::write` says how they lie in the folder.
    pub(crate) fn read(book: &Book) -> Result<Self> {
        let folder = Path::new(book.drawn);
        let text = |name: &str| {
            fs::read_to_string(folder.join(name)).with_context(|| format!("{}/{name}", folder.display()))
        };
        let mut rendered = Self { book: *book, ..Self::default() };
        for line in text("figures.txt")?.lines() {
            let mut words = line.splitn(3, ' ');
            let [id, place, source] = [(); 3].map(|()| words.next().unwrap_or_default());
            let name = file_stem(id);
            rendered.figures.push(Figure {
                id: id.to_owned(),
                source: source.to_owned(),
                place: place.to_owned(),
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
    pub fn write_all(&self, folder: &Path) -> Result<usize> {
        fs::create_dir_all(folder).with_context(|| folder.display().to_string())?;
        for figure in &self.figures {
            let file = folder.join(figure.file_name());
            fs::write(&file, &figure.standalone).with_context(|| file.display().to_string())?;
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
