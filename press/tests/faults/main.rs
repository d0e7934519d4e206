//! Every fault of a page names file, line and what is wrong, and nothing else is reported.
//!
//! Each case is a small book of its own: a SUMMARY.md, a book.toml and a few pages, written to a temporary folder.

mod books;
mod cases;

use books::BOOKS;
use cases::CASES;
use live::{Control, Preset};
use press::assets::{Figure, Rendered, Scene};
use press::site::check::check;
use std::fs;
use std::path::PathBuf;

/// The only figure, the only table and the only scene that these books can show.
fn drawn() -> Rendered {
    let [svg, standalone] = [String::new(), String::new()];
    let figure = Figure {
        id: "fig:machine".to_owned(),
        source: "book/a/figures.rs".to_owned(),
        svg,
        standalone,
        place: "column".to_owned(),
    };
    let tables = vec![("methods".to_owned(), "| a |\n|---|\n".to_owned())];
    let book = press::Book { code: &["src"], ..press::Book::default() };
    Rendered { book, figures: vec![figure], tables, scenes: vec![scene()], ..Rendered::default() }
}

/// A scene of the chapter `a.md`, with a control of each kind.
fn scene() -> Scene {
    const PLATE: live::Scene = live::Scene {
        file: "book/a/scene.rs",
        name: "plate",
        title: "",
        description: "",
        question: "Why $x$?",
        size: [[1.0; 2]; 2],
        view: None,
        still: 0.0,
        controls: &[
            Control::slider("spin", "Some words", [-1.0, 4.0, 0.1], "", 2.0),
            Control::log_slider("drag", "Some words", [1e-3, 1.0], "", 0.01),
            Control::choice("camera", "Some words", &["one", "two"]),
            Control::switch("cones", "Some words", true),
            Control::button("kick", "Some words"),
        ],
        presets: &[
            Preset { words: "fast", settings: &[("spin", 4.0), ("cones", 0.0)] },
            Preset { words: "as at first", settings: &[] },
        ],
        readings: &[],
        symbols: &[],
        start: |_| Err("it never starts".into()),
    };
    let svg = String::new();
    Scene { page: "a.md", live: PLATE, longest: svg.clone(), svg, sounds: false, lowest_eye: 0.0 }
}

/// The same with another control in a place.
fn with_control(scene: &mut Scene, place: usize, control: Control) {
    let mut controls = scene.live.controls.to_vec();
    controls[place] = control;
    scene.live.controls = controls.leak();
}

/// A book in a temporary folder, removed when dropped.
struct Book {
    root: PathBuf,
}

impl Book {
    /// A book of one numbered chapter with two pages, `a.md`, which is given, and `b.md`, and a suffix page `c.md`.
    fn new(name: &str, a: &str) -> Self {
        let root = std::env::temp_dir().join(format!("press-faults-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&root);
        let book = Self { root };
        for (file, text) in [
            ("book.toml", "[book]\ntitle = \"T\"\nsrc = \"book\"\n"),
            ("book/SUMMARY.md", "# Summary\n\n- [A](a.md)\n  - [B](b.md)\n\n[C](c.md)\n"),
            ("book/a.md", a),
            ("book/b.md", "# B\n\n## The end of it\n"),
            ("book/c.md", "# C\n"),
        ] {
            book.write(file, text.as_bytes());
        }
        book
    }

    fn write(&self, file: &str, text: &[u8]) {
        let file = self.root.join(file);
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, text).unwrap();
    }

    /// The faults as they are printed, without those of figures that this book does not show.
    fn faults(&self) -> Vec<String> {
        let Err(faults) = check(&self.root, &drawn()) else {
            return Vec::new();
        };
        let lines = faults.sorted().iter().map(ToString::to_string).collect::<Vec<_>>();
        let is_unused = ["is drawn, but no page shows it", "no page shows this scene"];
        lines.into_iter().filter(|line| !is_unused.iter().any(|words| line.contains(words))).collect()
    }
}

impl Drop for Book {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.root);
    }
}

#[test]
fn every_fault_names_file_line_and_what_is_wrong() {
    let mut wrong = Vec::new();
    for (name, text, expected) in CASES {
        let book = Book::new(name, text);
        let faults = book.faults();
        let as_expected = faults.len() == expected.len()
            && faults.iter().zip(*expected).all(|(fault, (line, words))| {
                fault.starts_with(&format!("error: book/a.md:{line}: ")) && fault.contains(words)
            });
        if !as_expected {
            wrong.push(format!("{name}: expected {expected:?}, got {faults:#?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn what_is_nested_too_deeply_is_a_fault_at_its_line() {
    for (name, open, close) in [
        ("brace", "{", "}"),
        ("frac", "\\frac{", "}{2}"),
        ("root", "\\sqrt[2", "]{2}"),
        ("row", "\\sqrt ", ""),
        ("left", "\\left(", "\\right)"),
        ("matrix", "\\begin{matrix}", "\\end{matrix}"),
    ] {
        let page = |depth: usize| format!("# A\n\n$$\n{}x{}\n$$\n", open.repeat(depth), close.repeat(depth));
        let faults = Book::new(&format!("deep-{name}"), &page(20_000)).faults();
        assert!(
            faults.len() == 1 && faults[0].starts_with("error: book/a.md:4: the formula is nested more than"),
            "{name}: {faults:?}"
        );
        assert_eq!(Book::new(&format!("shallow-{name}"), &page(12)).faults(), [""; 0], "{name}");
    }
    let page = format!("# A\n\n$$\n{}a\n$$\n", "a + ".repeat(200_000));
    let faults = Book::new("long-formula", &page).faults();
    assert!(faults.len() == 1 && faults[0].contains("more than 10000 cannot be read"), "{faults:?}");
    let page = format!("# A\n\n{}\n", "<b>".repeat(20_000));
    let faults = Book::new("deep-html", &page).faults();
    assert!(faults.iter().any(|fault| fault.contains("more than 30 elements of raw HTML")), "{}", faults[0]);
}

/// Each of these took minutes while something was counted from the beginning of the page for every item on it; in time
/// that grows as the page does, each takes a second. (No clock: who makes it quadratic again waits for this test.)
#[test]
fn a_page_of_a_megabyte_is_read_in_seconds() {
    for (name, text) in [
        ("formulas", "So $x$ is.\n".repeat(250_000)),
        ("displays", "$$\nx\n$$\n\n".repeat(250_000)),
        ("dollars", "$".repeat(1_000_000)),
        ("ats", "@".repeat(1_000_000)),
        ("brackets", "[^".repeat(500_000)),
        ("images", "![a".repeat(250_000) + &"](fig:x)".repeat(250_000)),
        ("headings", "## a\n\n".repeat(100_000)),
    ] {
        let book = Book::new(&format!("large-{name}"), &format!("# A\n\n{text}\n"));
        let faults = book.faults();
        assert_eq!(
            faults.is_empty(),
            matches!(name, "formulas" | "displays" | "ats" | "brackets" | "headings"),
            "{name}"
        );
    }
}

#[test]
fn every_fault_of_a_book_names_its_file() {
    for (name, files, expected) in BOOKS {
        let book = Book::new("files", "# A\n");
        files.iter().for_each(|(file, text)| book.write(file, text));
        let faults = book.faults();
        let as_expected = faults.len() == expected.len()
            && faults.iter().zip(*expected).all(|(fault, begin)| fault.starts_with(begin));
        assert!(as_expected, "{name}: expected {expected:?}, got {faults:#?}");
    }
}

/// Checking, building and testing read SUMMARY.md alike (`press/dialect/src/pages.rs`).
#[test]
fn a_page_may_have_any_name_that_does_not_lead_away_or_belong_to_the_site() {
    for (link, file) in [
        ("01-intro/index.md", "01-intro/index.md"),
        ("loop/index.md", "loop/index.md"),
        ("v1.0.md", "v1.0.md"),
        ("./b.md", "b.md"),
        ("a/b.md", "a/b.md"),
        ("<b c.md>", "b c.md"),
        ("b%20c.md", "b c.md"),
        ("b.md \"tip\"", "b.md"),
        ("", "b.md"),
        ("api.md", "api.md"),
    ] {
        let book = Book::new("names", "# A\n");
        book.write(&format!("book/{file}"), b"# N\n");
        let rest = if file == "b.md" { "" } else { "- [B](b.md)\n" };
        let named = match link {
            "" => "- [Draft]()\n- [B](b.md)\n".to_owned(),
            link => format!("- [N]({link})\n{rest}"),
        };
        book.write("book/SUMMARY.md", format!("- [A](a.md)\n{named}- [C](c.md)\n").as_bytes());
        assert_eq!(book.faults(), [""; 0], "{link}");
    }
    let away = "is no page in book/: the way there goes down from it, without `..`";
    let taken = "cannot have this name: the site has a page of its own there";
    for (link, words) in [
        ("../outside.md", away),
        ("x/../b.md", away),
        ("print.md", taken),
        ("toc.md", taken),
        ("404.md", taken),
        ("api/index.md", taken),
    ] {
        let book = Book::new("names", "# A\n");
        book.write("outside.md", b"# N\n");
        let summary = format!("- [A](a.md)\n- [B](b.md)\n- [C](c.md)\n- [N]({link})\n");
        book.write("book/SUMMARY.md", summary.as_bytes());
        let [fault] = &book.faults()[..] else { panic!("{link}: one fault, not {:?}", book.faults()) };
        assert!(fault.starts_with("error: book/SUMMARY.md:4: ") && fault.ends_with(words), "{link}: {fault}");
    }
}

#[cfg(unix)]
#[test]
fn a_link_to_a_folder_is_not_followed_round_in_a_circle() {
    let book = Book::new("circle", "# A\n");
    for name in ["one", "two"] {
        std::os::unix::fs::symlink(".", book.root.join("book").join(name)).unwrap();
    }
    let said = ["one", "two"].map(|name| {
        format!(
            "error: book/{name}: a link to a folder could lead round in a circle: put the folder itself here"
        )
    });
    assert_eq!(book.faults(), said);
}

#[test]
fn two_curves_of_one_name_are_a_fault_of_their_figure() {
    let book = Book::new("twins", "# A\n\n![A.](fig:machine)\n");
    let mut drawn = drawn();
    drawn.figures[0].svg = "<svg><path id=\"fig-machine-gain\"/><path id=\"fig-machine-gain\"/></svg>".into();
    let faults = check(&book.root, &drawn).unwrap_err().to_string();
    let said = "error: book/a/figures.rs: the id `fig-machine-gain` stands twice in the figure fig:machine: has it two \
                curves of one name?";
    assert!(faults.contains(said) && !faults.contains("stands on the page already"), "{faults}");
}

#[test]
fn a_scene_of_a_further_page_stands_there_wherever_it_is_needed() {
    let text = "# A\n\n$$\na\n$$\n\n![A plate.](scene:plate)\n";
    let book = Book::new("further", "# A\n");
    book.write("book/SUMMARY.md", b"- [A](a.md)\n  - [D](a/d.md)\n  - [B](b.md)\n");
    for (page, shown, said) in [
        ("a/d", "book/a/d.md", None),
        ("a/d", "book/b.md", Some("error: book/b.md:7: the scene scene:plate belongs on a/d.md")),
        ("a", "book/a/d.md", Some("error: book/a/d.md:7: the scene scene:plate opens the chapter in a")),
    ] {
        let mut drawn = drawn();
        drawn.scenes[0].page = page;
        drawn.figures.clear();
        book.write("book/a/d.md", b"# D\n");
        book.write("book/b.md", b"# B\n");
        book.write(shown, text.as_bytes());
        let faults = check(&book.root, &drawn).err().map(|faults| faults.to_string());
        let first = faults.as_deref().and_then(|faults| faults.lines().find(|line| line.contains("scene")));
        assert_eq!(first, said, "{faults:?}");
    }
}

#[test]
fn a_scene_that_contradicts_itself_is_a_fault() {
    type Spoil = fn(&mut Scene);
    const ONE: &[&str] = &["one"];
    let cases: [(Spoil, &str); 8] = [
        (|scene| scene.live.question = "", "the scene plate asks nothing"),
        (|scene| scene.live.name = "Plate", "digits and hyphens, not `Plate`"),
        (|scene| with_control(scene, 0, Control::switch("t", "Words", true)), "cannot have the name `t`"),
        (
            |scene| with_control(scene, 1, Control::switch("spin", "Words", true)),
            "cannot have the name `spin`",
        ),
        (|scene| with_control(scene, 2, Control::choice("camera", "", ONE)), "what the control `camera`"),
        (
            |scene| with_control(scene, 3, Control { start: 0.5, ..scene.live.controls[3] }),
            "starts with `cones=0.5`, which must be from 0 to 1",
        ),
        (
            |scene| scene.live.presets = &[Preset { words: "fast", settings: &[("spun", 4.0)] }],
            "the preset “fast” of the scene plate: the scene plate has no",
        ),
        (|_| (), "no page shows this scene: ![Caption.](scene:plate)"),
    ];
    let book = Book::new("spoiled", "# A\n\n![A.](fig:machine)\n");
    for (spoil, words) in cases {
        let mut drawn = drawn();
        spoil(&mut drawn.scenes[0]);
        let faults = check(&book.root, &drawn).unwrap_err().to_string();
        assert!(faults.contains("error: book/a/scene.rs: ") && faults.contains(words), "{words}: {faults}");
    }
}
