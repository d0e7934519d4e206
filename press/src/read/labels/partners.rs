//! Labels without a partner: figures that no page shows, exercises without a solution, equations of the source without
//! a row in the ledger.

use super::{Registry, hint};
use crate::assets::{Figure, Rendered};
use crate::book::Page;
use crate::fault::{Faults, nearest};
use crate::read::items::{Item, Label, LabelKind, Mention, PlacedItem};
use std::collections::BTreeSet;

/// Where every equation of the source has a row, if the book has such a page.
const LEDGER: &str = "ledger.md";

/// Adds a fault for each number of the source that a page gives to an equation and the ledger does not list.
pub(super) fn ledger(pages: &[Page], scans: &[Vec<PlacedItem<'_>>], faults: &mut Faults) {
    let Some(at) = pages.iter().position(|page| page.path == LEDGER) else {
        return;
    };
    let listed = scans[at].iter().filter_map(|placed| match placed.item {
        Item::Mention(Mention::Source(number)) => Some(number),
        _ => None,
    });
    let listed: BTreeSet<u32> = listed.collect();
    for (page, items) in pages.iter().zip(scans) {
        for placed in items {
            let Item::DisplayMaths { label: Some(equation), .. } = &placed.item else {
                continue;
            };
            for &number in equation.source.iter().filter(|number| !listed.contains(number)) {
                let line = page.lines.at(placed.range.start);
                faults.add(
                    &page.file,
                    line,
                    format!("the ledger has no row for equation ({number}) of the source"),
                );
            }
        }
    }
}

impl Registry {
    pub(super) fn check_figures(
        &self,
        pages: &[Page],
        scans: &[Vec<PlacedItem<'_>>],
        figures: &[Figure],
        faults: &mut Faults,
    ) {
        for (page, items) in pages.iter().zip(scans) {
            for placed in items {
                let Item::Figure { label, .. } = &placed.item else {
                    continue;
                };
                if !figures.iter().any(|figure| figure.id == label.written()) {
                    let ids = figures.iter().map(|figure| figure.id.trim_start_matches("fig:"));
                    let message = format!(
                        "there is no figure {}{}",
                        label.written(),
                        hint("fig", nearest(&label.name, ids))
                    );
                    faults.add(&page.file, page.lines.at(placed.range.start), message);
                }
            }
        }
        for figure in figures {
            let mut ids = BTreeSet::new();
            for id in figure.ids() {
                if !ids.insert(id.clone()) {
                    let message = format!(
                        "the id `{id}` stands twice in the figure {}: has it two curves of one name?",
                        figure.id
                    );
                    faults.add(&figure.source, 0, message);
                }
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
    }

    pub(super) fn check_scenes(
        &self,
        pages: &[Page],
        scans: &[Vec<PlacedItem<'_>>],
        drawn: &Rendered,
        faults: &mut Faults,
    ) {
        for (page, items) in pages.iter().zip(scans) {
            for (n, placed) in items.iter().enumerate() {
                let Item::Scene { label, .. } = &placed.item else {
                    continue;
                };
                let mut fault = |message| faults.add(&page.file, page.lines.at(placed.range.start), message);
                let Some(scene) = drawn.scenes.iter().find(|scene| scene.live.name == label.name) else {
                    let names = drawn.scenes.iter().map(|scene| scene.live.name);
                    let near = hint("scene", nearest(&label.name, names));
                    fault(format!("there is no scene {}{near}", label.written()));
                    continue;
                };
                if page.path.split('/').next() != Some(scene.chapter) || page.part.is_some() {
                    fault(format!("the scene {} opens the chapter in {}", label.written(), scene.chapter));
                } else if items[..n].iter().any(|above| matches!(above.item, Item::DisplayMaths { .. })) {
                    fault(format!("the scene {} belongs above the first equation", label.written()));
                }
            }
        }
        for scene in &drawn.scenes {
            if !self.entries.contains_key(&Label { kind: LabelKind::Scene, name: scene.live.name.to_owned() })
            {
                let message = format!("no page shows this scene: ![Caption.](scene:{})", scene.live.name);
                faults.add(&scene.source(), 0, message);
            }
        }
    }

    pub(super) fn check_exercises(&self, pages: &[Page], scans: &[Vec<PlacedItem<'_>>], faults: &mut Faults) {
        for (page, items) in pages.iter().zip(scans) {
            for (n, placed) in items.iter().enumerate() {
                let Item::Heading { label: Some(label), level, .. } = &placed.item else {
                    continue;
                };
                let line = page.lines.at(placed.range.start);
                let (partner, what) = match label.kind {
                    LabelKind::Exercise => (LabelKind::Solution, "solution"),
                    LabelKind::Solution => (LabelKind::Exercise, "exercise"),
                    _ => continue,
                };
                let partner = Label { kind: partner, name: label.name.clone() };
                if !self.entries.contains_key(&partner) {
                    faults.add(
                        &page.file,
                        line,
                        format!("{} has no {what} {}", label.written(), partner.written()),
                    );
                }
                let until_next = items[n + 1..]
                    .iter()
                    .take_while(|next| !matches!(&next.item, Item::Heading { level: l, .. } if l <= level));
                if label.kind == LabelKind::Exercise
                    && !until_next.into_iter().any(|p| matches!(p.item, Item::Hint))
                {
                    let message =
                        format!("{} has no hint: <details> with <summary>Hint</summary>", label.written());
                    faults.add(&page.file, line, message);
                }
            }
        }
    }
}
