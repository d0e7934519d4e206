//! Every fault of a page names file, line and what is wrong, and nothing else is reported.
//!
//! Each case is a small book of its own: a SUMMARY.md, a book.toml and a few pages, written to a temporary folder.

use press::check::check;
use press::rendered::{Control, Figure, Input, Rendered, Scene};
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
        wide: false,
    };
    let tables = vec![("methods".to_owned(), "| a |\n|---|\n".to_owned())];
    Rendered {
        figures: vec![figure],
        tables,
        scenes: vec![scene()],
        book: press::Book { code: &["src"], ..press::Book::default() },
        ..Rendered::default()
    }
}

/// A scene of the chapter `a.md`, with a control of each kind.
fn scene() -> Scene {
    let control = |name: &str, input, start: f64| {
        let [name, words] = [name, "Some words"].map(str::to_owned);
        Control { name, words, input, start, unit: String::new(), shown: String::new() }
    };
    let controls = vec![
        control("spin", Input::Slider { from: -1.0, to: 4.0, step: 0.1 }, 2.0),
        control("drag", Input::LogSlider { from: 1e-3, to: 1.0 }, 0.01),
        control("camera", Input::Choice(vec!["one".to_owned(), "two".to_owned()]), 0.0),
        control("cones", Input::Switch, 1.0),
        control("kick", Input::Button, -1.0),
    ];
    let [name, chapter, question] = ["plate", "a.md", "Why $x$?"].map(str::to_owned);
    let presets = [("fast", "spin=4&cones=0"), ("as at first", "")]
        .map(|(words, settings)| (words.to_owned(), settings.to_owned()));
    let presets = presets.to_vec();
    let source = "book/a/scene.rs".to_owned();
    Scene { name, chapter, source, question, controls, presets, ..Scene::default() }
}

/// A book in a temporary folder, removed when dropped.
struct Book {
    root: PathBuf,
}

impl Book {
    /// A book of one numbered chapter with two pages, `a.md` and `b.md`, and a suffix page `c.md`.
    fn new(name: &str, a: &str, b: &str, c: &str) -> Self {
        let root = std::env::temp_dir().join(format!("press-faults-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&root);
        fs::create_dir_all(root.join("book")).unwrap();
        fs::write(root.join("book.toml"), "[book]\ntitle = \"T\"\nsrc = \"book\"\n").unwrap();
        fs::write(root.join("book/SUMMARY.md"), "# Summary\n\n- [A](a.md)\n  - [B](b.md)\n\n[C](c.md)\n")
            .unwrap();
        for (file, text) in [("a.md", a), ("b.md", b), ("c.md", c)] {
            fs::write(root.join("book").join(file), text).unwrap();
        }
        Self { root }
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

type Case = (&'static str, &'static str, &'static [(usize, &'static str)]);

/// The name of a case, a page, and what must be said of it: the line of `a.md` and words of the message. An
/// empty list means nothing.
const CASES: &[Case] = &[
    ("good-maths", "# A\n\nSo $x = 1$ and\n\n$$\ny = \\frac{1}{2}\n$$ {#eq:half}\n\nby @eq:half.\n", &[]),
    ("coloured", "# A\n\nThe [spin]{.spin} of $x$.\n", &[]),
    (
        "coloured-unknown",
        "# A\n\nThe\n[spin]{.spins}.\n",
        &[(4, "no words are coloured as `spins`, but as body, spin")],
    ),
    ("coloured-caption", "# A\n\n![The [spin]{.spin}.](fig:machine)[^a]\n\n[^a]: [L]{.momentum}\n", &[]),
    ("dollar", "# A\n\nIt costs \\$5.\n", &[]),
    ("dollar-in-code", "# A\n\n`$x` and\n\n```sh\necho $HOME @eq:none\n```\n", &[]),
    ("unknown-command", "# A\n\n$$\na = \\fraction{1}{2}\n$$\n", &[(4, "fraction")]),
    ("unknown-inline", "# A\n\nline\nand $\\unknown$ here\n", &[(4, "unknown")]),
    ("stray-dollar", "# A\n\nIt costs $5.\n", &[(3, "a stray `$`")]),
    ("blank-line", "# A\n\n$$\na\n\n= b\n$$\n", &[(3, "a stray `$$`"), (7, "a stray `$$`")]),
    ("list-in-formula", "# A\n\n$$\na\n+ b\n$$\n", &[(3, "starts a list"), (6, "a stray `$$`")]),
    ("lost-row", "# A\n\n| a | b |\n|---|---|\n\nTable: T.\n\n| 1 | 2 |\n", &[(8, "a row of no table")]),
    ("not-alone", "# A\n\nHere $$a$$ stands.\n", &[(3, "paragraph of its own")]),
    ("empty-maths", "# A\n\n$$\n$$ {#eq:e}\n", &[(3, "the formula is empty")]),
    ("maths-in-heading", "# A\n\n## On $x$\n", &[(3, "mathematics in a heading")]),
    (
        "dangling",
        "# A\n\n$$\na\n$$ {#eq:steady-radius}\n\nSee @eq:steady-radus.\n",
        &[(7, "no page defines the label eq:steady-radus; is eq:steady-radius meant?")],
    ),
    ("doubled", "# A\n\n$$\na\n$$ {#eq:x}\n\n$$\nb\n$$ {#eq:x}\n", &[(7, "already defined at book/a.md:3")]),
    ("unknown-kind", "# A\n\nSee @tab:one.\n", &[(3, "no labels of the kind `tab`")]),
    ("bad-name", "# A\n\n$$\na\n$$ {#eq:Steady_Radius}\n", &[(5, "lower-case letters, digits and hyphens")]),
    ("bad-label", "# A\n\n$$\na\n$$ {eq:x}\n", &[(5, "is not a label")]),
    ("bad-attribute", "# A\n\n$$\na\n$$ {#eq:x sauce=19}\n", &[(5, "neither source=")]),
    ("bad-source", "# A\n\n$$\na\n$$ {#eq:x source=nineteen}\n", &[(5, "not an equation number")]),
    ("corrects-nothing", "# A\n\n$$\na\n$$ {#eq:x corrected}\n", &[(5, "says not which equation")]),
    (
        "source-twice",
        "# A\n\n$$\na\n$$ {#eq:x source=3}\n\n$$\nb\n$$ {#eq:y source=\"2 3\"}\n",
        &[(7, "equation (3) of the source already belongs to eq:x")],
    ),
    ("source-missing", "# A\n\nSee @source:77.\n", &[(3, "source's number (77)")]),
    (
        "unknown-figure",
        "# A\n\n![A caption.](fig:no-such-figure)\n",
        &[(3, "there is no figure fig:no-such-figure")],
    ),
    ("not-our-rust", "# A\n\n```rs\nlet x = 1;\n```\n", &[(3, "`rs` is no language of this book")]),
    (
        "braces-of-a-fence",
        "# A\n\n```{.rust .ignore}\nlet x = 1;\n```\n",
        &[(3, "is no language of this book")],
    ),
    ("unbalanced", "# A\n\n$$\n\\frac{1}{2\n$$\n", &[(3, "braces that do not balance"), (5, "a stray `$$`")]),
    ("underlined", "# A\n\nOne {#sec:one}\n---\n", &[(3, "an underlined one cannot carry a label")]),
    ("label-below", "# A\n\n$$\na\n$$\n{#eq:x}\n", &[(6, "stands right behind the closing dollars")]),
    ("label-and-stop", "# A\n\n$$\na\n$$ {#eq:x}.\n", &[(5, "and nothing behind it")]),
    ("inline-label", "# A\n\nSo $a$ {#eq:x} is.\n", &[(3, "a label stands behind the closing")]),
    ("glued-heading", "# A\n\n##Title {#ex:x}\n", &[(3, "a label stands behind the closing")]),
    ("parentheses", "# A\n\nSo \\(x\\) and \\[y\\] are.\n", &[(3, "write $…$")]),
    ("capitals", "# A\n\nSee @Eq:x.\n", &[(3, "is written `@eq:`")]),
    (
        "figure-in-caption",
        "# A\n\n![One ![two](fig:nope).](fig:nope)\n",
        &[(3, "in the caption of another"), (3, "there is no figure")],
    ),
    ("no-caption", "# A\n\n![](fig:machine)\n", &[(3, "has no caption")]),
    ("source-empty", "# A\n\n$$\na\n$$ {#eq:x source=}\n", &[(5, "lacks a number")]),
    ("source-comma", "# A\n\n$$\na\n$$ {#eq:x source=12,13}\n", &[(5, "source=\"12 13\"")]),
    (
        "small-hint",
        "# A\n\n<details>\n<summary>hint</summary>\n\nSo.\n\n</details>\n",
        &[(4, "the word `Hint`")],
    ),
    ("table", "# A\n\n![It's *so*.](table:methods)[^a]\n\n[^a]: A.\n", &[]),
    ("mute-table", "# A\n\n![](table:methods)\n", &[(3, "the table methods has no caption")]),
    (
        "good-table",
        "# A\n\n| a |\n|---|\n| $b$[^b] |\n\nTable: It's\n@ex:x.[^a]\n\n[^a]: A.\n[^b]: B.\n\n## X {#ex:x}\n\n\
     <details>\n<summary>Hint</summary>\n\nSo.\n\n</details>\n\n## {#sol:x}\n",
        &[],
    ),
    ("no-table-caption", "# A\n\n| a |\n|---|\n| b |\n\nWords.\n", &[(3, "the table has no caption")]),
    ("empty-table-caption", "# A\n\n| a |\n|---|\n| b |\n\nTable:\n", &[(3, "the table has no caption")]),
    ("lost-table-caption", "# A\n\nTable: Words.\n", &[(3, "a caption of no table")]),
    (
        "listed-table",
        "# A\n\n- | a |\n  |---|\n  | b |\n\n  Table: Words.\n",
        &[(3, "in a list or a quotation")],
    ),
    (
        "maths-in-table",
        "# A\n\n| a |\n|---|\n| b |\n| $\\unknown$ |\n\nTable: See @eq:none.\n",
        &[(6, "in the table, "), (8, "no page defines the label eq:none")],
    ),
    ("no-table", "# A\n\n![Words.](table:none)\n", &[(3, "the library gives no table `none`")]),
    (
        "table-in-text",
        "# A\n\nA ![Words.](table:methods)\n",
        &[(3, "the table methods must stand in a paragraph")],
    ),
    (
        "scene",
        "# A\n\n![A plate.](scene:plate)[^a]\n\n[Set $x$](scene:plate?spin=-0.9&drag=0.5&camera=1&cones=0&kick=0&t=1.5), \
         @scene:plate.\n\n$$\na\n$$\n\n[^a]: [Set](scene:plate?spin=4).\n",
        &[],
    ),
    (
        "unknown-scene",
        "# A\n\n![A plate.](scene:plates)\n\n[Set](scene:top?spin=1).\n",
        &[
            (3, "there is no scene scene:plates; is scene:plate meant?"),
            (5, "no page defines the label scene:top"),
        ],
    ),
    (
        "scene-below",
        "# A\n\n$$\na\n$$\n\n![A plate.](scene:plate)\n",
        &[(7, "the scene scene:plate belongs above the first equation")],
    ),
    (
        "scene-in-text",
        "# A\n\nSo ![](scene:plate)\n",
        &[
            (3, "the scene scene:plate has no caption"),
            (3, "the scene scene:plate must stand in a paragraph"),
        ],
    ),
    (
        "settings",
        "# A\n\n![A plate.](scene:plate)\n\n[A](scene:plate?spun=1)\n[B](scene:plate?spin=5)\n[C](scene:plate?spin=1.25)\n\
         [D](scene:plate?camera=2)\n[E](scene:plate?kick=now)\n[F](scene:plate?drag=0)\n[G](scene:plate)\n\
         [H](scene:plate?t=inf)\n[I](scene:plate?cones=2)\n\n| [J](scene:plate?kick=-2) |\n|---|\n\nTable: T.\n",
        &[
            (5, "the scene plate has no control `spun`; is `spin` meant?"),
            (6, "`spin=5`, which must be from -1 to 4 in steps of 0.1"),
            (7, "`spin=1.25`, which must be from -1 to 4 in steps of 0.1"),
            (8, "`camera=2`, which must be from 0 to 1"),
            (9, "`kick=now` is no setting"),
            (10, "`drag=0`, which must be from 0.001 to 1"),
            (11, "`` is no setting"),
            (12, "no control `t`"),
            (13, "`cones=2`"),
            (15, "`kick=-2`, which must be at least -1"),
        ],
    ),
    ("image", "# A\n\n![A cat](cat.png)\n", &[(3, "not a figure of the book")]),
    ("citation", "# A\n\nSee [@cite:nobody-1999].\n", &[(3, "no page defines the label cite:nobody-1999")]),
    ("bare-entry", "# A\n\nSomewhere {#cite:x \"X\"} in a line.\n", &[(3, "list item")]),
    ("untagged", "# A\n\n```\nlet x = 1;\n```\n", &[(3, "a fence needs a language")]),
    ("ignored", "# A\n\n```rust,ignore\nlet x = 1;\n```\n", &[(3, "every snippet runs")]),
    ("indented", "# A\n\nText.\n\n    let x = 1;\n", &[(5, "indented by four spaces")]),
    (
        "wide",
        "# A\n\n```rust\nlet a_rather_long_name_for_a_variable_in_a_snippet = \"and a rather long string, too, to go with it\";\n```\n",
        &[(4, "do not fit on the page")],
    ),
    (
        "printed",
        "# A\n\n```rust\nlet x = 1; // → much\nlet y = 1 // → 4\n    .f(); // → 5 m\n\n// → 6\ny; // → -1.2e-5, 7 m\n```\n",
        &[(4, "is written `// → 4.317 rad/s`"), (5, "end of a statement"), (8, "end of a statement")],
    ),
    (
        "nearly-printed",
        "# A\n\n```rust\nlet x = 1; // -> 7.0\nx; /* → 9.9 */\nx; // about → 9.9\nx; // a → b\n// |x| -> y\n```\n",
        &[(4, "is written `// → 4.317"), (5, "is written `// → 4.317"), (6, "is written `// → 4.317")],
    ),
    (
        "nearly-live",
        "# A\n\n```rust\nlet x = 1.5; //live: 0..2\nlet y = 1.5; // Live: 0..2\nlet z = 1.5; //\tlive: 0..2\n\
         let w = 1.5; // m; live: 0..2\nlet v = 1.5; // live 0..2\nlet u = 1.5; // they live on\n```\n",
        &[
            (4, "a live number is written"),
            (5, "a live number is written"),
            (6, "a live number is written"),
            (7, "a live number is written"),
            (8, "a live number is written"),
        ],
    ),
    (
        "live-extreme",
        "# A\n\n```rust\nlet x = 1.5; // live: 0..1e999\nlet y = 1.5; // live: 1..2 step 1e-150\n\
         let z = 1e-20; // live: 0..1e-19\nx; // → 1.5\n```\n",
        &[(4, "the range of `x` ends at a number"), (5, "more than 12 digits"), (6, "more than 12 digits")],
    ),
    (
        "live",
        "# A\n\n```rust\nlet x = 1.5; // live: 0..2 step 0.5 m\nlet n = 3; // live: 1..9\nx; // → 1.5 m\n\
         assert!(x < 2.0); // it is small\n```\n",
        &[],
    ),
    (
        "live-form",
        "# A\n\n```rust\nlet x = f(); // live: 0..2\nx = 2; // live: 0..2\nlet (a, b) = (1, 2); // live: 0..2\n\
         let y = 1; // live: 0 to 2\nlet z = 1; // live: 0..2m\nlet w = 2 + 1; // live: 0..2\ny; // → 1\n```\n",
        &[
            (4, "a live number is written"),
            (5, "a live number is written"),
            (6, "a live number is written"),
            (7, "a live number is written"),
            (8, "a live number is written"),
            (9, "a live number is written"),
        ],
    ),
    (
        "live-range",
        "# A\n\n```rust\nlet x = 1.0; // live: 2..3\nlet y = 1.0; // live: 1..1\nlet z = 1.0; // live: 0..2 step 3\n\
         let n = 1; // live: 0..2.5\nlet m = 1; // live: 0..2\nlet m = 1; // live: 0..2\nm; // → 1\n```\n",
        &[
            (4, "`x` is 1.0, outside of its range, 2 to 3"),
            (5, "the range of `y` is empty"),
            (6, "the step of `z`"),
            (7, "`n` counts, and its range does not"),
            (9, "`m` is a live number of this snippet already"),
        ],
    ),
    ("live-mute", "# A\n\n```rust\nlet x = 1.0; // live: 0..2\n```\n", &[(3, "nothing answers")]),
    (
        "live-wordless",
        "# A\n\n```rust\nlet x = 1.0; // live: 0..2\nassert!(x > 0.0);\n```\n",
        &[(5, "says in words what holds")],
    ),
    (
        "live-told",
        "# A\n\n```rust,should_panic\nlet x = 1.0; // live: 0..2\nx; // → 1.0\n```\n\n\
         - item\n\n  ```rust\n  let x = 1.0; // live: 0..2\n  x; // → 1.0\n  ```\n",
        &[(3, "stands on its own"), (10, "stands on its own")],
    ),
    ("live-elsewhere", "# A\n\n```text\n// live: 0..2\n```\n", &[]),
    ("not-printed", "# A\n\n```text\n// → much\n```\n", &[]),
    (
        "code-label",
        "# A\n\n```rust\nlet x = 1; // eq:nowhere\n```\n",
        &[(4, "no page defines the label eq:nowhere")],
    ),
    (
        "reference-in-link",
        "# A\n\n$$\na\n$$ {#eq:x}\n\n[see @eq:x](b.md)\n",
        &[(7, "cannot stand inside a link")],
    ),
    (
        "bar-in-table",
        "# A\n\n| a |\n|---|\n| $\\|x\\|$ |\n\nTable: T.\n",
        &[(5, "`|` in the mathematics of a table")],
    ),
    ("cut-in-table", "# A\n\n| a | b |\n|---|---|\n| $|x|$ | b |\n\nTable: T.\n", &[(5, "write \\lvert")]),
    ("dollar-in-html", "# A\n\n<p>So $x$ is</p>\n", &[(3, "raw HTML is not read")]),
    ("own-anchor", "# A\n\n## Two words {#mine}\n\nSee [there](#mine) and [that](#a).\n", &[]),
    ("quoted-fault", "# A\n\n> $$\n> a +\n> \\fraction{1}{2}\n> $$\n", &[(5, "fraction")]),
    ("dead-page", "# A\n\nSee [there](nowhere.md).\n", &[(3, "leads to no page of the book")]),
    ("dead-anchor", "# A\n\nSee [there](b.md#nowhere).\n", &[(3, "without the anchor `#nowhere`")]),
    (
        "live-anchor",
        "# A\n\nSee [there](b.md#the-end-of-it) and [that](#a) and [out](https://example.org/x).\n",
        &[],
    ),
    ("no-hint", "# A\n\n## One {#ex:one}\n\nDo it.\n\n## {#sol:one}\n\nDone.\n", &[(3, "has no hint")]),
    (
        "no-solution",
        "# A\n\n## One {#ex:one}\n\n<details>\n<summary>Hint</summary>\n\nSo.\n\n</details>\n",
        &[(3, "has no solution sol:one")],
    ),
    ("no-exercise", "# A\n\n## {#sol:one}\n\nDone.\n", &[(3, "has no exercise ex:one")]),
    (
        "titled-solution",
        "# A\n\n## One {#sol:one}\n",
        &[(3, "has no exercise"), (3, "takes its title from the exercise")],
    ),
    (
        "script",
        "# A\n\n<script src=\"https://example.org/x.js\"></script>\n",
        &[(3, "raw HTML must not load")],
    ),
    (
        "shouted-script",
        "# A\n\n<SCRIPT>fetch(\"x\")</SCRIPT>\n",
        &[(3, "`<script>`: raw HTML must not load")],
    ),
    (
        "inline-image",
        "# A\n\nSo <IMG SRC=\"//example.org/x.png\"> it is.\n",
        &[(3, "`<img>`: raw HTML must not")],
    ),
    ("raw-heading", "# A\n\n<h2>Two</h2>\n", &[(3, "`<h2>`: raw HTML must not")]),
    ("handler", "# A\n\n<p class=\"x\"\n   onClick=\"f()\">So.</p>\n", &[(4, "the attribute `onclick`")]),
    (
        "raw-style",
        "# A\n\n<p STYLE=\"background: URL(//example.org/x)\">So.</p>\n",
        &[(3, "the attribute `style`")],
    ),
    ("heading-attribute", "# A\n\n## Two {onclick=f()}\n", &[(3, "braces behind a heading hold an id")]),
    ("unclosed-div", "# A\n\n<div>\n\nText.\n", &[(3, "`<div>` is not closed")]),
    ("unclosed-b", "# A\n\nOne\n<b>two.\n\nThree.\n", &[(4, "`<b>` is not closed")]),
    (
        "unclosed-in-list",
        "# A\n\n- <details>\n- two\n\n</details>\n",
        &[(3, "not closed"), (6, "closes nothing")],
    ),
    (
        "closed-elsewhere",
        "# A\n\nOne <b>two.\n\nThree</b>.\n",
        &[(3, "`<b>` is not closed"), (5, "`</b>` closes nothing")],
    ),
    ("stray-end", "# A\n\nOne <b>two</b>.\n\n</main>\n", &[(5, "`</main>` closes nothing")]),
    (
        "crossed",
        "# A\n\nOne <b><sub>two</b></sub>.\n",
        &[(3, "`</sub>` closes nothing"), (3, "`<sub>` is not closed")],
    ),
    ("unclosed-comment", "# A\n\n<!-- words\n\nMore.\n", &[(3, "the HTML is broken: eof-in-comment")]),
    (
        "broken-html",
        "# A\n\n<p class=\"x\" class=\"y\">So.</p>\n",
        &[(3, "the HTML is broken: duplicate-attribute")],
    ),
    (
        "sound-html",
        "# A\n\n<details>\n<summary>More</summary>\n\n<p id=\"x\">A <b>word</b><br>or two</p>\n\n- see <a\n  href=\"b.html#b\">there</a>\n\n</details>\n\n<!-- words -->\n",
        &[],
    ),
    (
        "raw-link",
        "# A\n\n<p>One\n<a href=\"nowhere.html\">there</a></p>\n",
        &[(4, "the link to `nowhere.html` leads to no page")],
    ),
    (
        "raw-anchor",
        "# A\n\n> <p>\n> <A HREF=\"b.html#nowhere\">there</A></p>\n",
        &[(4, "without the anchor `#nowhere`")],
    ),
    (
        "raw-id",
        "# A\n\n## Two words\n\n<p id=\"two-words\">So.</p>\n\nOr <b id=\"x\">so</b>\nor <b id=\"x\">so</b>.\n",
        &[(5, "the id `two-words` stands on the page already"), (8, "the id `x` stands")],
    ),
    ("heading-id", "# A\n\n## One {#x}\n\n## Two {#x}\n", &[(5, "the id `x` stands on the page already")]),
    (
        "foreign-id",
        "# A\n\n## One {#print-button}\n\n<p id=\"mdbook-content\">So.</p>\n",
        &[(3, "one of mdBook's own"), (5, "one of mdBook's own")],
    ),
    ("raw-reference", "# A\n\n<p>See @eq:x</p>\n", &[(3, "raw HTML is not read for references")]),
    (
        "link-in-caption",
        "# A\n\n![One,\nsee [there](nowhere.md) and <A HREF=\"nope.html\">there</A>.](fig:machine)\n",
        &[(4, "the link to `nope.html`"), (4, "the link to `nowhere.md`")],
    ),
    ("empty-link", "# A\n\nSee [there]().\n", &[(3, "the link leads nowhere")]),
    ("mute-link", "# A\n\nSee [](b.md).\n", &[(3, "the link to `b.md` has no words")]),
    ("bare-figure", "# A\n\n![A caption.](laundromat-machine)\n", &[(3, "(`fig:name`)")]),
    ("undefined-reference", "# A\n\nSee\n[this][nope].\n", &[(4, "`[nope]` is defined nowhere")]),
    ("collapsed-reference", "# A\n\nSee [nope][].\n", &[(3, "`[nope]` is defined nowhere")]),
    ("undefined-footnote", "# A\n\nSo it is.[^nope]\n", &[(3, "the footnote `[^nope]` is defined nowhere")]),
    ("unused-footnote", "# A\n\nSo.\n\n[^one]: Words.\n", &[(5, "nothing refers to the footnote `[^one]`")]),
    (
        "doubled-footnote",
        "# A\n\nSo.[^one]\n\n[^one]: Words.\n\n[^one]: More.\n",
        &[(7, "the footnote `[^one]` is defined already")],
    ),
    (
        "footnote-twice",
        "# A\n\nSo.[^one]\n\nAnd so.[^one]\n\n[^one]: Words.\n",
        &[(5, "a second reference to the footnote `[^one]`")],
    ),
    (
        "footnote-places",
        "# A\n\n## Two[^a]\n\nSo.[^c]\n\n[^a]: A.\n\n[^c]: C.[^d]\n\n[^d]: D.\n",
        &[(3, "hang on a heading"), (9, "hang on another note"), (9, "one paragraph of words")],
    ),
    ("footnote-in-link", "# A\n\nSee [there[^a]](b.md).\n\n[^a]: A.\n", &[(3, "`](` was left as it is")]),
    (
        "footnote-in-caption",
        "# A\n\n![Words.[^a]](fig:machine)\n\n[^a]: A.\n",
        &[(3, "stands behind it, `![Caption.](fig:name)[^note]`")],
    ),
    (
        "footnote-and-more",
        "# A\n\n![Words.](fig:machine)[^a] More.\n\n[^a]: A.\n",
        &[(3, "must stand in a paragraph of its own")],
    ),
    ("good-bracket", "# A\n\nSo \\](x) is.\n", &[]),
    (
        "footnote-body",
        "# A\n\nSo[^a] it[^b] is.[^C]\n\n[^a]: A.\n\n    B.\n\n[^b]: - c\n\n[^C]: C.\n",
        &[(5, "one paragraph of words"), (9, "one paragraph of words"), (11, "only lower-case letters")],
    ),
    (
        "footnote-maths",
        "# A\n\nSo.[^a]\n\n[^a]: By $\\unknown$ and @eq:none.\n",
        &[(5, "in the note, "), (5, "no page defines the label eq:none")],
    ),
    (
        "footnote-id",
        "# A\n\n## One {#note-a}\n\nSo.[^a]\n\n[^a]: A.\n",
        &[(5, "the id `note-a` stands on the page already")],
    ),
    (
        "good-footnotes",
        "# A\n\n![Caption.](fig:machine)[^a]\n\n| a |\n|---|\n| b[^b] |\n\nTable: T.\n\n1. So\n   it is.[^c]\n\n\
         [^a]: A [link](b.md).\n[^b]: B.\n[^c]: `C`.\n",
        &[],
    ),
    ("good-brackets", "# A\n\nFrom [0, 1], [so] [far] and [x],[^one] [ ] too.\n\n[^one]: Words.\n", &[]),
    ("include", "# A\n\n{{#include nowhere.md}}\n", &[(3, "`{{#include`: mdBook's directives")]),
    (
        "playground",
        "# A\n\n```text\n{{ #playground x.rs}}\n```\n",
        &[(4, "`{{#playground`: mdBook's directives")],
    ),
    ("escaped-include", "# A\n\n```text\n\\{{#include x.rs}}\n```\n", &[]),
    ("unclosed-fence", "# A\n\n````text\nwords\n```\n", &[(3, "the fence is not closed")]),
    ("fence-of-a-quotation", "# A\n\n> ~~~text\n> words\n\nAfter.\n", &[(3, "the fence is not closed")]),
    ("good-fences", "# A\n\n- ```text\n  a\n  ````\n\n> ~~~text\n> ```\n> ~~~\n", &[]),
    ("second-title", "# A\n\n# B\n", &[(3, "a second title")]),
    ("no-title", "Words.\n\nMore.\n", &[(1, "the page has no title")]),
    ("late-title", "\n## B\n\n# A\n", &[(2, "begins with a title"), (4, "a second title")]),
    ("jump", "# A\n\n### B\n\n#### C\n\n## D\n", &[(3, "jumps from `#` to `###`")]),
    ("empty-heading", "# A\n\n##\n\nWords.\n", &[(3, "the heading is empty")]),
    (
        "empty-column",
        "# A\n\n| a | |\n|---|---|\n| 1 | 2 |\n\nTable: T.\n",
        &[(3, "a column of the table has no name")],
    ),
    (
        "entities",
        "# A\n\nOne &amp; two\n&#x202e;three &#x5e9;\nand &omega;.\n",
        &[(4, "no `ש`"), (4, "U+202E"), (5, "no `ω`")],
    ),
    (
        "entities-in-html",
        "# A\n\n<p title=\"&#x202e;\">\n&lt;\n&omega;\n</p>\n",
        &[(3, "U+202E"), (5, "no `ω`")],
    ),
    ("nul", "# A\n\nA\0B.\n", &[(3, "U+0000")]),
    ("override", "# A\n\nOne\ntwo\u{202e}three.\n", &[(4, "U+202E")]),
    ("isolate-in-code", "# A\n\n```text\na\u{2066}b\n```\n", &[(4, "U+2066")]),
    ("good-characters", "\u{feff}# A\r\n\r\n“Störmer”, \u{2060}10⁻⁴ − 1,\ttab; `ω₀²`.\r\n", &[]),
    ("text-lacks", "# A\n\nOf course\nω is.\n", &[(4, "the face of the text has no `ω` (U+03C9)")]),
    (
        "table-lacks",
        "# A\n\n| a | b |\n|---|---|\n| x | 🛞 |\n\nTable: T.\n",
        &[(5, "the face of the text has no `🛞`")],
    ),
    ("caption-lacks", "# A\n\n![So ∇ is.](fig:machine)\n", &[(3, "the face of the text has no `∇`")]),
    (
        "html-lacks",
        "# A\n\n<details>\n<summary>Hint</summary>\nω\n</details>\n",
        &[(5, "the text has no `ω`")],
    ),
    ("code-lacks", "# A\n\n```rust\n//\n// a ∝ b\n```\n", &[(5, "the face of the code has no `∝`")]),
    ("inline-code-lacks", "# A\n\nSo\n`Γᵢ`.\n", &[(4, "the face of the code has no `ᵢ`")]),
    ("maths-lacks", "# A\n\nSo\n$\\mathfrak{g}$.\n", &[(4, "the face of mathematics has no `𝔤`")]),
    ("words-in-maths-lack", "# A\n\n$$\na \\text{ ∇}\n$$\n", &[(3, "the face of the text has no `∇`")]),
    (
        "unused-citation",
        "# A\n\n- {#cite:x \"X 1999\"} Words.\n- {#cite:y \"Y 1999\"} Words; @cite:y.\n",
        &[(3, "nothing cites cite:x")],
    ),
];

#[test]
fn every_fault_names_file_line_and_what_is_wrong() {
    let mut wrong = Vec::new();
    for (name, text, expected) in CASES {
        let book = Book::new(name, text, "# B\n\n## The end of it\n", "# C\n");
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
        let faults = Book::new(&format!("deep-{name}"), &page(20_000), "# B\n", "# C\n").faults();
        assert!(
            faults.len() == 1 && faults[0].starts_with("error: book/a.md:4: the formula is nested more than"),
            "{name}: {faults:?}"
        );
        assert_eq!(
            Book::new(&format!("shallow-{name}"), &page(12), "# B\n", "# C\n").faults(),
            [""; 0],
            "{name}"
        );
    }
    let page = format!("# A\n\n$$\n{}a\n$$\n", "a + ".repeat(200_000));
    let faults = Book::new("long-formula", &page, "# B\n", "# C\n").faults();
    assert!(faults.len() == 1 && faults[0].contains("more than 10000 cannot be read"), "{faults:?}");
    let page = format!("# A\n\n{}\n", "<b>".repeat(20_000));
    let faults = Book::new("deep-html", &page, "# B\n", "# C\n").faults();
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
        let book = Book::new(&format!("large-{name}"), &format!("# A\n\n{text}\n"), "# B\n", "# C\n");
        let faults = book.faults();
        assert_eq!(
            faults.is_empty(),
            matches!(name, "formulas" | "displays" | "ats" | "brackets" | "headings"),
            "{name}"
        );
    }
}

#[test]
fn equations_outside_numbered_chapters_have_no_number_to_bear() {
    let book = Book::new("unnumbered", "# A\n", "# B\n", "# C\n\n$$\na\n$$ {#eq:x}\n");
    let faults = book.faults();
    assert!(
        faults.len() == 1 && faults[0].starts_with("error: book/c.md:3: eq:x needs a number"),
        "{faults:?}"
    );
}

#[test]
fn labels_cited_in_code_must_exist() {
    let book = Book::new("code", "# A\n", "# B\n", "# C\n");
    fs::create_dir_all(book.root.join("src")).unwrap();
    fs::write(book.root.join("src/lib.rs"), "\n\n\nfn f() {} // eq:nowhere\n").unwrap();
    let faults = book.faults();
    assert_eq!(faults, ["error: src/lib.rs:4: no page defines the label eq:nowhere"]);
}

#[test]
fn a_page_that_the_summary_does_not_name_is_a_fault() {
    let book = Book::new("stray", "# A\n", "# B\n", "# C\n");
    fs::create_dir_all(book.root.join("book/more")).unwrap();
    fs::write(book.root.join("book/more/stray.md"), "# Nobody reads this\n").unwrap();
    let said = "error: book/more/stray.md: SUMMARY.md does not name this page: add it there, or move it out of book/";
    assert_eq!(book.faults(), [said]);
}

/// Checking, building and testing read SUMMARY.md alike (`press/src/pages.rs`).
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
        let book = Book::new("names", "# A\n", "# B\n", "# C\n");
        let path = book.root.join("book").join(file);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, "# N\n").unwrap();
        let rest = if file == "b.md" { "" } else { "- [B](b.md)\n" };
        let named = if link.is_empty() {
            "- [Draft]()\n- [B](b.md)\n".into()
        } else {
            format!("- [N]({link})\n{rest}")
        };
        fs::write(book.root.join("book/SUMMARY.md"), format!("- [A](a.md)\n{named}- [C](c.md)\n")).unwrap();
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
        let book = Book::new("names", "# A\n", "# B\n", "# C\n");
        fs::write(book.root.join("outside.md"), "# N\n").unwrap();
        fs::write(
            book.root.join("book/SUMMARY.md"),
            format!("- [A](a.md)\n- [B](b.md)\n- [C](c.md)\n- [N]({link})\n"),
        )
        .unwrap();
        let [fault] = &book.faults()[..] else { panic!("{link}: one fault, not {:?}", book.faults()) };
        assert!(fault.starts_with("error: book/SUMMARY.md:4: ") && fault.ends_with(words), "{link}: {fault}");
    }
    let book = Book::new("names", "# A\n", "# B\n", "# C\n");
    fs::write(book.root.join("book/SUMMARY.md"), "# [A](a.md)\n\n- [B](b.md)\n- [C](c.md)\n").unwrap();
    assert_eq!(
        book.faults(),
        ["error: book/SUMMARY.md:1: mdBook does not read a.md as a page where it stands here"]
    );
}

#[cfg(unix)]
#[test]
fn a_link_to_a_folder_is_not_followed_round_in_a_circle() {
    let book = Book::new("circle", "# A\n", "# B\n", "# C\n");
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
    let book = Book::new("twins", "# A\n\n![A.](fig:machine)\n", "# B\n", "# C\n");
    let mut drawn = drawn();
    drawn.figures[0].svg = "<svg><path id=\"fig-machine-gain\"/><path id=\"fig-machine-gain\"/></svg>".into();
    let faults = check(&book.root, &drawn).unwrap_err().to_string();
    let said = "error: book/a/figures.rs: the id `fig-machine-gain` stands twice in the figure fig:machine: has it two \
                curves of one name?";
    assert!(faults.contains(said) && !faults.contains("stands on the page already"), "{faults}");
}

#[test]
fn every_number_of_the_source_has_a_row_in_the_ledger_and_every_row_an_equation() {
    let book = Book::new("ledger", "# A\n\n$$\na\n$$ {#eq:x source=\"1 3\"}\n", "# B\n", "# C\n");
    assert_eq!(book.faults(), [""; 0], "a book without a ledger");
    fs::write(
        book.root.join("book/ledger.md"),
        "# Ledger\n\n| a |\n|---|\n| @source:1 |\n| @source:2 |\n\nTable: T.\n",
    )
    .unwrap();
    fs::write(book.root.join("book/SUMMARY.md"), "- [A](a.md)\n- [B](b.md)\n- [C](c.md)\n- [L](ledger.md)\n")
        .unwrap();
    let expected = [
        "error: book/a.md:3: the ledger has no row for equation (3) of the source",
        "error: book/ledger.md:6: no equation carries the source's number (2)",
    ];
    assert_eq!(book.faults(), expected);
}

#[test]
fn a_scene_opens_its_chapter_and_is_set_from_its_page_alone() {
    let b = "# B\n\n[Set](scene:plate?spin=3) or see @scene:plate.\n";
    let book = Book::new("scene-elsewhere", "# A\n\n![A plate.](scene:plate)\n", b, "# C\n");
    let said = "error: book/b.md:3: scene:plate stands on another page: refer to it as @scene:plate";
    assert_eq!(book.faults(), [said]);
    for (n, pages) in [["# A\n", b, "# C\n"], ["# A\n", "# B\n", b]].into_iter().enumerate() {
        let [a, b, c] = pages.map(|page| page.replace(b, "# B\n\n![A plate.](scene:plate)\n"));
        let faults = Book::new(&format!("scene-moved-{n}"), &a, &b, &c).faults();
        assert!(faults.iter().any(|fault| fault.contains("opens the chapter in a.md")), "{faults:?}");
    }
}

#[test]
fn a_scene_that_contradicts_itself_is_a_fault() {
    type Spoil = fn(&mut Scene);
    let cases: [(Spoil, &str); 8] = [
        (|scene| scene.question.clear(), "the scene plate asks nothing"),
        (|scene| scene.name = "Plate".into(), "digits and hyphens, not `Plate`"),
        (|scene| scene.controls[0].name = "t".into(), "cannot have the name `t`"),
        (|scene| scene.controls[1].name = "spin".into(), "cannot have the name `spin`"),
        (|scene| scene.controls[2].words.clear(), "nothing says what the control `camera`"),
        (|scene| scene.controls[3].start = 0.5, "starts with `cones=0.5`, which must be from 0 to 1"),
        (
            |scene| scene.presets[0].1 = "spun=4".into(),
            "the preset “fast” of the scene plate: the scene plate has no",
        ),
        (|_| (), "no page shows this scene: ![Caption.](scene:plate)"),
    ];
    let book = Book::new("spoiled", "# A\n\n![A.](fig:machine)\n", "# B\n", "# C\n");
    for (spoil, words) in cases {
        let mut drawn = drawn();
        spoil(&mut drawn.scenes[0]);
        let faults = check(&book.root, &drawn).unwrap_err().to_string();
        assert!(faults.contains("error: book/a/scene.rs: ") && faults.contains(words), "{words}: {faults}");
    }
}

#[test]
fn a_style_sheet_of_the_book_loads_nothing_from_a_network() {
    let book = Book::new("sheet", "# A\n", "# B\n", "# C\n");
    fs::create_dir_all(book.root.join("book/theme")).unwrap();
    fs::write(
        book.root.join("book/theme/x.css"),
        "p {\n  background: URL( 'https://example.org/x.png' );\n}\n",
    )
    .unwrap();
    let said = "error: book/theme/x.css:2: the style sheet loads https://example.org/x.png from a network";
    assert_eq!(book.faults(), [said]);
}

#[test]
fn what_cannot_be_read_is_a_fault_at_its_line() {
    let book = Book::new("unreadable", "# A\n", "# B\n", "# C\n");
    let write = |file: &str, text: &[u8]| fs::write(book.root.join(file), text).unwrap();
    write("book/b.md", b"# B\n\nCaf\xe9.\n");
    assert_eq!(book.faults(), ["error: book/b.md:3: this line is not UTF-8: save the file in that encoding"]);
    fs::remove_file(book.root.join("book/b.md")).unwrap();
    assert_eq!(book.faults(), ["error: book/SUMMARY.md:4: there is no page book/b.md"]);
    write("book/b.md", b"# B\n");
    write("book/SUMMARY.md", b"# Summary\n\n- [A](a.md)\n- [B](b.md)\n- [Again](./a.md)\n");
    let faults = book.faults();
    assert_eq!(faults, ["error: book/SUMMARY.md:5: book/a.md is named a second time"]);
    write("book/SUMMARY.md", b"# Summary\n\n- [A](a.md)\n- B\n");
    let faults = book.faults();
    assert!(faults.len() == 1 && faults[0].starts_with("error: book/SUMMARY.md:4: "), "{faults:?}");
    write("book/SUMMARY.md", "# Summary\n\n- [A](a.md)\n- [\u{202e}B](b.md)\n- [C](c.md)\n".as_bytes());
    let faults = book.faults();
    assert!(faults.len() == 1 && faults[0].starts_with("error: book/SUMMARY.md:4: "), "{faults:?}");
    write("book.toml", b"[book]\ntitle = \"T\nsrc = \"book\"\n");
    let faults = book.faults();
    assert!(faults.len() == 1 && faults[0].starts_with("error: book.toml:2: "), "{faults:?}");
}

#[test]
fn all_faults_of_a_run_are_reported_in_order() {
    let book = Book::new("many", "# A\n\n$5\n\n@eq:none\n", "# B\n\n```\n```\n", "# C\n\n@cite:none\n");
    let faults = book.faults();
    let places: Vec<&str> = faults.iter().filter_map(|fault| fault.split(": ").nth(1)).collect();
    assert_eq!(places, ["book/a.md:3", "book/a.md:5", "book/b.md:3", "book/c.md:3"], "{faults:#?}");
}
