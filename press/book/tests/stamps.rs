//! Only figures whose code has changed are drawn again, and no figure is kept that would be drawn otherwise.

#[path = "../stamps.rs"]
mod stamps;

use press::rendered::Rendered;
use stamps::Stamps;
use std::fs;
use std::path::{Path, PathBuf};

#[test]
fn the_figures_that_are_kept_are_those_that_would_be_drawn_now() {
    let kept = Rendered::read(Path::new(env!("OUT_DIR"))).expect("they are there").figures;
    let drawn = figures::all().expect("every figure can be drawn");
    assert_eq!(kept.len(), drawn.len());
    for figure in drawn {
        let same = kept.iter().find(|kept| kept.id == figure.id).expect("it is kept");
        assert!(same.svg == figure.svg && same.standalone == figure.standalone, "{} is old", figure.id);
    }
}

/// A workspace with three chapters, two scenes and some shared code: path and text.
const WORKSPACE: [(&str, &str); 13] = [
    ("Cargo.toml", "members = [\".\", \"press/live\"]\n"),
    ("press/live/Cargo.toml", ""),
    ("Cargo.lock", ""),
    ("press/book/build.rs", ""),
    ("press/drawing/src/lib.rs", ""),
    ("press/figures/src/lib.rs", ""),
    ("src/lib.rs", "//! Has the wheel.\npub mod scenes;\nmod shared;\n"),
    ("src/shared.rs", "pub fn wheel() {}\n"),
    ("src/scenes/mod.rs", "pub mod wheel;\npub mod two_coins;\n"),
    ("src/scenes/wheel.rs", "//! Unlike two_coins.\nuse crate::shared;\n"),
    ("src/scenes/two_coins/mod.rs", "const A: f64 = 1.0;\n"),
    (
        "book/two-coins/figures.rs",
        "use mechanics::{scenes::two_coins, wide};\nconst DATA: &str = include_str!(\"data.csv\");\n",
    ),
    ("book/methods/figures.rs", "use mechanics::scenes::wheel;\ninclude_str!(\"../../tests/data.csv\");\n"),
];

/// The stamps of the chapters `two-coins` and `methods` after some files have been written.
fn stamps_with(root: &Path, changes: &[(&str, &str)]) -> [String; 2] {
    let _ = fs::remove_dir_all(root);
    for (path, text) in WORKSPACE.iter().chain(changes) {
        let path: PathBuf = root.join(path);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, text).expect("a file");
    }
    let stamps = Stamps::read(root).expect("all can be read");
    ["two-coins", "methods"].map(|chapter| stamps.of(chapter))
}

#[test]
fn a_stamp_changes_with_what_its_figures_are_drawn_from_and_with_nothing_else() {
    let root = std::env::temp_dir().join(format!("press-stamps-{}", std::process::id()));
    let before = stamps_with(&root, &[]);
    for (changes, expected) in [
        // Pages, tests and live scenes draw no figures.
        (&[("book/two-coins/index.md", "new"), ("press/figures/tests/a.rs", "new")][..], [false, false]),
        (&[("book/two-coins/scene.rs", "use mechanics::scenes::wheel;")], [false, false]),
        // What all figures share.
        (&[("src/shared.rs", "pub fn wheel() { new() }\n")], [true, true]),
        (&[("press/drawing/src/lib.rs", "new")], [true, true]),
        (&[("press/figures/src/lib.rs", "new")], [true, true]),
        (&[("src/wide/mod.rs", "new")], [true, true]),
        (&[("Cargo.lock", "new")], [true, true]),
        (&[("press/live/Cargo.toml", "new")], [true, true]),
        // A scene, the chapter of its name, and those that mention it.
        (&[("src/scenes/wheel.rs", "new")], [false, true]),
        (&[("src/scenes/two_coins/mod.rs", "new")], [true, false]),
        (&[("src/scenes/two_coins/deep/er.rs", "new")], [true, false]),
        (&[("src/wide/two_coins.rs", "new")], [true, false]),
        (&[("book/two-coins/figures.rs", "new")], [true, false]),
        (&[("book/two-coins/figures/edge.rs", "new")], [true, false]),
        (&[("book/two-coins/data.csv", "new")], [true, false]),
        (&[("tests/data.csv", "new")], [false, true]),
    ] {
        let after = stamps_with(&root, changes);
        let changed = [0, 1].map(|n| after[n] != before[n]);
        assert_eq!(changed, expected, "{changes:?}");
    }
    // Code that uses a scene, a kernel or another chapter passes its changes on.
    let [scene, kernel, chapter] =
        ["src/scenes/two_coins/mod.rs", "src/wide/two_coins.rs", "book/two-coins/figures.rs"];
    for (by, text, used) in [
        ("src/scenes/wheel.rs", "use super::two_coins;\n", scene),
        ("src/shared.rs", "use crate::scenes::two_coins;\n", scene),
        ("src/shared.rs", "use crate::wide::{two_coins};\n", kernel),
        ("book/methods/figures.rs", "use mechanics::wide;\nuse wide::wheel::*;\n", kernel),
        ("book/methods/figures.rs", "use crate::chapter_two_coins::coins;\n", chapter),
    ] {
        let wheel = ("src/wide/wheel.rs", "use super::two_coins;\n");
        let before = stamps_with(&root, &[wheel, (by, text)]);
        let after = stamps_with(&root, &[wheel, (by, text), (used, "use crate::wide::two_coins;")]);
        assert!(after[0] != before[0] && after[1] != before[1], "{by}: {text}");
    }
    // Who only names it does not.
    let named = ("src/shared.rs", "const SCENES: [&str; 2] = [\"scenes\", \"two_coins\"];\n");
    let [before, after] = [None, Some(("src/scenes/two_coins/mod.rs", "new"))]
        .map(|change| stamps_with(&root, &[Some(named), change].into_iter().flatten().collect::<Vec<_>>()));
    assert!(after[0] != before[0] && after[1] == before[1]);
    fs::remove_dir_all(root).expect("it is there");
}
