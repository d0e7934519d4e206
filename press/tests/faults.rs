//! Every fault of a page names file, line and what is wrong, and nothing else is reported.
//!
//! Each case is a small book of its own: a SUMMARY.md, a book.toml and a few pages, written to a temporary folder.

use press::check::check;
use std::fs;
use std::path::{Path, PathBuf};

/// A book in a temporary folder, removed when dropped.
struct Book {
    root: PathBuf,
}

impl Book {
    /// A book of one numbered chapter with two pages, `a.md` and `b.md`, and a suffix page `c.md`.
    fn new(name: &str, a: &str, b: &str, c: &str) -> Self {
        let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("faults-{name}"));
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
        let Err(faults) = check(&self.root) else {
            return Vec::new();
        };
        let lines = faults.sorted().iter().map(ToString::to_string).collect::<Vec<_>>();
        lines.into_iter().filter(|line| !line.contains("is drawn, but no page shows it")).collect()
    }
}

impl Drop for Book {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.root);
    }
}

type Case = (&'static str, &'static str, &'static [(usize, &'static str)]);

/// The name of a case, a page, and what must be said of it: the line of `a.md` and words of the message. An empty list means nothing.
const CASES: &[Case] = &[
    ("good-maths", "# A\n\nSo $x = 1$ and\n\n$$\ny = \\frac{1}{2}\n$$ {#eq:half}\n\nby @eq:half.\n", &[]),
    ("dollar", "# A\n\nIt costs \\$5.\n", &[]),
    ("dollar-in-code", "# A\n\n`$x` and\n\n```sh\necho $HOME @eq:none\n```\n", &[]),
    ("unknown-command", "# A\n\n$$\na = \\fraction{1}{2}\n$$\n", &[(4, "fraction")]),
    ("unknown-inline", "# A\n\nline\nand $\\unknown$ here\n", &[(4, "unknown")]),
    ("stray-dollar", "# A\n\nIt costs $5.\n", &[(3, "a stray `$`")]),
    ("blank-line", "# A\n\n$$\na\n\n= b\n$$\n", &[(3, "a stray `$$`"), (7, "a stray `$$`")]),
    ("list-in-formula", "# A\n\n$$\na\n+ b\n$$\n", &[(3, "starts a list"), (6, "a stray `$$`")]),
    ("lost-row", "# A\n\n| a | b |\n|---|---|\n\n| 1 | 2 |\n", &[(6, "a row of no table")]),
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
    ("no-caption", "# A\n\n![](fig:machine)\n", &[(3, "has no caption")]),
    ("source-empty", "# A\n\n$$\na\n$$ {#eq:x source=}\n", &[(5, "lacks a number")]),
    ("source-too-large", "# A\n\n$$\na\n$$ {#eq:x source=99}\n", &[(5, "from 1 to 98")]),
    ("source-comma", "# A\n\n$$\na\n$$ {#eq:x source=12,13}\n", &[(5, "source=\"12 13\"")]),
    (
        "small-hint",
        "# A\n\n<details>\n<summary>hint</summary>\n\nSo.\n\n</details>\n",
        &[(4, "the word `Hint`")],
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
        "code-label",
        "# A\n\n```rust\nlet x = 1; // eq:nowhere\n```\n",
        &[(4, "no page defines the label eq:nowhere")],
    ),
    (
        "reference-in-link",
        "# A\n\n$$\na\n$$ {#eq:x}\n\n[see @eq:x](b.md)\n",
        &[(7, "cannot stand inside a link")],
    ),
    ("bar-in-table", "# A\n\n| a |\n|---|\n| $\\|x\\|$ |\n", &[(5, "`|` in the mathematics of a table")]),
    ("cut-in-table", "# A\n\n| a | b |\n|---|---|\n| $|x|$ | b |\n", &[(5, "write \\lvert")]),
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
    fs::write(book.root.join("src/lib.rs"), "//! Nothing.\nfn f() {} // eq:nowhere\n").unwrap();
    let faults = book.faults();
    assert_eq!(faults, ["error: src/lib.rs:2: no page defines the label eq:nowhere"]);
}

#[test]
fn a_missing_page_and_a_broken_configuration_are_faults() {
    let book = Book::new("missing", "# A\n", "# B\n", "# C\n");
    fs::remove_file(book.root.join("book/b.md")).unwrap();
    assert!(book.faults()[0].starts_with("error: book/b.md: SUMMARY.md names it"), "{:?}", book.faults());
    fs::write(book.root.join("book.toml"), "[book\n").unwrap();
    assert!(book.faults()[0].starts_with("error: book.toml: "), "{:?}", book.faults());
}

#[test]
fn all_faults_of_a_run_are_reported_in_order() {
    let book = Book::new("many", "# A\n\n$5\n\n@eq:none\n", "# B\n\n```\n```\n", "# C\n\n@cite:none\n");
    let faults = book.faults();
    let places: Vec<&str> = faults.iter().filter_map(|fault| fault.split(": ").nth(1)).collect();
    assert_eq!(places, ["book/a.md:3", "book/a.md:5", "book/b.md:3", "book/c.md:3"], "{faults:#?}");
}
