//! Books of several files, each with all that is wrong with it.

/// The name of a case, what is written into a book of the pages a.md, b.md below it and c.md without a number, and how
/// each line begins that is said of it.
pub(crate) type Files = (&'static str, &'static [(&'static str, &'static [u8])], &'static [&'static str]);

pub(crate) const BOOKS: &[Files] = &[
    (
        "equations outside numbered chapters have no number to bear",
        &[("book/c.md", b"# C\n\n$$\na\n$$ {#eq:x}\n")],
        &["error: book/c.md:3: eq:x needs a number"],
    ),
    (
        "labels cited in code must exist",
        &[("src/lib.rs", b"\n\n\nfn f() {} // eq:nowhere\n")],
        &["error: src/lib.rs:4: no page defines the label eq:nowhere"],
    ),
    (
        "a page that the summary does not name",
        &[("book/more/stray.md", b"# Nobody reads this\n")],
        &[
            "error: book/more/stray.md: SUMMARY.md does not name this page: add it there, or move it out of book/",
        ],
    ),
    ("a book without a ledger", &[("book/a.md", b"# A\n\n$$\na\n$$ {#eq:x source=\"1 3\"}\n")], &[]),
    (
        "every number of the source has a row in the ledger and every row an equation",
        &[
            ("book/a.md", b"# A\n\n$$\na\n$$ {#eq:x source=\"1 3\"}\n"),
            ("book/ledger.md", b"# Ledger\n\n| a |\n|---|\n| @source:1 |\n| @source:2 |\n\nTable: T.\n"),
            ("book/SUMMARY.md", b"- [A](a.md)\n- [B](b.md)\n- [C](c.md)\n- [L](ledger.md)\n"),
        ],
        &[
            "error: book/a.md:3: the ledger has no row for equation (3) of the source",
            "error: book/ledger.md:6: no equation carries the source's number (2)",
        ],
    ),
    (
        "a scene is set from its page alone",
        &[
            ("book/a.md", b"# A\n\n![A plate.](scene:plate)\n"),
            ("book/b.md", b"# B\n\n[Set](scene:plate?spin=3) or see @scene:plate.\n"),
        ],
        &["error: book/b.md:3: scene:plate stands on another page: refer to it as @scene:plate"],
    ),
    (
        "a scene opens its chapter and no page below",
        &[("book/b.md", b"# B\n\n![A plate.](scene:plate)\n")],
        &["error: book/b.md:3: the scene scene:plate opens the chapter in a.md"],
    ),
    (
        "a scene opens its chapter and no other page",
        &[("book/c.md", b"# C\n\n![A plate.](scene:plate)\n")],
        &[
            "error: book/c.md:3: scene:plate needs a number",
            "error: book/c.md:3: the scene scene:plate opens the chapter in a.md",
        ],
    ),
    (
        "a style sheet of the book loads nothing from a network",
        &[("book/theme/x.css", b"p {\n  background: URL( 'https://example.org/x.png' );\n}\n")],
        &["error: book/theme/x.css:2: the style sheet loads https://example.org/x.png from a network"],
    ),
    (
        "a page in another encoding",
        &[("book/b.md", b"# B\n\nCaf\xe9.\n")],
        &["error: book/b.md:3: this line is not UTF-8: save the file in that encoding"],
    ),
    (
        "a page that is missing",
        &[("book/SUMMARY.md", b"- [A](a.md)\n- [B](b.md)\n- [C](c.md)\n- [D](d.md)\n")],
        &["error: book/SUMMARY.md:4: there is no page book/d.md"],
    ),
    (
        "a page that is named twice",
        &[("book/SUMMARY.md", b"# Summary\n\n- [A](a.md)\n- [B](b.md)\n- [Again](./a.md)\n")],
        &["error: book/SUMMARY.md:5: book/a.md is named a second time"],
    ),
    (
        "a summary that mdBook does not understand",
        &[("book/SUMMARY.md", b"# Summary\n\n- [A](a.md)\n- B\n")],
        &["error: book/SUMMARY.md:4: The link items"],
    ),
    (
        "a summary that names a page with a blank",
        &[("book/SUMMARY.md", b"# Summary\n\n- [A](a.md)\n- [B](b c.md)\n")],
        &["error: book/SUMMARY.md:4: a target with a blank stands in angle brackets"],
    ),
    (
        "a page where mdBook reads none",
        &[("book/SUMMARY.md", b"# [A](a.md)\n\n- [B](b.md)\n- [C](c.md)\n")],
        &["error: book/SUMMARY.md:1: mdBook does not read a.md as a page where it stands here"],
    ),
    (
        "a summary that turns the direction of its text",
        &[("book/SUMMARY.md", "# Summary\n\n- [A](a.md)\n- [\u{202e}B](b.md)\n- [C](c.md)\n".as_bytes())],
        &["error: book/SUMMARY.md:4: "],
    ),
    (
        "settings that are no TOML",
        &[("book.toml", b"[book]\ntitle = \"T\nsrc = \"book\"\n")],
        &["error: book.toml:2: "],
    ),
    (
        "all faults of a run are reported in order",
        &[
            ("book/a.md", b"# A\n\n$5\n\n@eq:none\n"),
            ("book/b.md", b"# B\n\n```\n```\n"),
            ("book/c.md", b"# C\n\n@cite:none\n"),
        ],
        &["error: book/a.md:3: ", "error: book/a.md:5: ", "error: book/b.md:3: ", "error: book/c.md:3: "],
    ),
];
