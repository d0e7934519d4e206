//! Labels without a partner: figures that no page shows, exercises without a solution, equations of the source without
//! a row in the ledger.

use super::{Registry, hint};
use crate::assets::Rendered;
use crate::book::Page;
use crate::fault::{Faults, nearest};
use crate::read::items::{Item, Label, LabelKind, Mention, PlacedItem};
use std::collections::BTreeSet;

/// Where every equation of the source has a row, if the book has such a page.
const LEDGER: &str = "ledger.md";

impl Registry {
    /// Adds a fault for each label of the pages, and for each figure and scene, that lacks its partner.
    pub(super) fn check_partners(
        &self,
        pages: &[Page],
        scans: &[Vec<PlacedItem<'_>>],
        drawn: &Rendered,
        faults: &mut Faults,
    ) {
        let ledger = pages.iter().position(|page| page.path == LEDGER);
        let listed: Option<BTreeSet<u32>> = ledger.map(|at| scans[at].iter().filter_map(source).collect());
        let is_drawn = |id: &str| drawn.figures.iter().any(|figure| figure.id == id);
        for (page, items) in pages.iter().zip(scans) {
            let mut report = page.reporter(faults);
            for (n, placed) in items.iter().enumerate() {
                let mut fault = |message: String| report.fault(placed.range.start, message);
                match &placed.item {
                    Item::DisplayMaths { label: Some(equation), .. } => {
                        let lacks =
                            |number: &u32| listed.as_ref().is_some_and(|listed| !listed.contains(number));
                        for number in equation.source.iter().copied().filter(lacks) {
                            fault(format!("the ledger has no row for equation ({number}) of the source"));
                        }
                    }
                    Item::Figure { label, .. } if !is_drawn(&label.written()) => {
                        let ids = drawn.figures.iter().map(|figure| figure.id.trim_start_matches("fig:"));
                        let near = hint("fig", nearest(&label.name, ids));
                        fault(format!("there is no figure {}{near}", label.written()));
                    }
                    Item::Scene { label, .. } => {
                        if let Err(message) = check_scene(label, page, &items[..n], drawn) {
                            fault(message);
                        }
                    }
                    Item::Heading { label: Some(label), level, .. } => {
                        self.check_exercise(label, *level, &items[n + 1..], fault);
                    }
                    _ => {}
                }
            }
        }
        for figure in &drawn.figures {
            let mut ids = BTreeSet::new();
            for id in figure.ids().filter(|id| !ids.insert(id.clone())) {
                let twins = format!(
                    "the id `{id}` stands twice in the figure {}: has it two curves of one name?",
                    figure.id
                );
                faults.add(&figure.source, 0, twins);
            }
            let name = figure.id.trim_start_matches("fig:").to_owned();
            if !self.entries.contains_key(&Label { kind: LabelKind::Figure, name }) {
                faults.add(
                    &figure.source,
                    0,
                    format!("the figure {} is drawn, but no page shows it", figure.id),
                );
            }
        }
        for scene in &drawn.scenes {
            let name = scene.live.name.to_owned();
            if !self.entries.contains_key(&Label { kind: LabelKind::Scene, name }) {
                let message = format!("no page shows this scene: ![Caption.](scene:{})", scene.live.name);
                faults.add(&scene.source(), 0, message);
            }
        }
    }

    fn check_exercise(
        &self,
        label: &Label,
        level: u8,
        below: &[PlacedItem<'_>],
        mut fault: impl FnMut(String),
    ) {
        let (kind, what) = match label.kind {
            LabelKind::Exercise => (LabelKind::Solution, "solution"),
            LabelKind::Solution => (LabelKind::Exercise, "exercise"),
            _ => return,
        };
        let partner = Label { kind, name: label.name.clone() };
        if !self.entries.contains_key(&partner) {
            fault(format!("{} has no {what} {}", label.written(), partner.written()));
        }
        let own =
            |next: &&PlacedItem<'_>| !matches!(&next.item, Item::Heading { level: l, .. } if *l <= level);
        let has_hint = below.iter().take_while(own).any(|placed| matches!(placed.item, Item::Hint));
        if label.kind == LabelKind::Exercise && !has_hint {
            fault(format!("{} has no hint: <details> with <summary>Hint</summary>", label.written()));
        }
    }
}

/// The number of the source that a row of the ledger names.
fn source(placed: &PlacedItem<'_>) -> Option<u32> {
    match placed.item {
        Item::Mention(Mention::Source(number)) => Some(number),
        _ => None,
    }
}

/// What is wrong with where a scene stands, below the items `above` it.
fn check_scene(label: &Label, page: &Page, above: &[PlacedItem<'_>], drawn: &Rendered) -> Result<(), String> {
    let Some(scene) = drawn.scenes.iter().find(|scene| scene.live.name == label.name) else {
        let names = drawn.scenes.iter().map(|scene| scene.live.name);
        let near = hint("scene", nearest(&label.name, names));
        return Err(format!("there is no scene {}{near}", label.written()));
    };
    let opens = scene.page == scene.chapter();
    if !opens && page.path.strip_suffix(".md") != Some(scene.page) {
        Err(format!("the scene {} belongs on {}.md", label.written(), scene.page))
    } else if opens && (page.path.split('/').next() != Some(scene.page) || page.part.is_some()) {
        Err(format!("the scene {} opens the chapter in {}", label.written(), scene.page))
    } else if opens && above.iter().any(|above| matches!(above.item, Item::DisplayMaths { .. })) {
        Err(format!("the scene {} belongs above the first equation", label.written()))
    } else {
        Ok(())
    }
}
