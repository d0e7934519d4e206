//! Pages of chapter 1, each with what must stand, in this order, in what becomes of it.
//!
//! There `'` is a straight quotation mark, `~` a blank at which no line ends, and `⟨x⟩` the formula of x.

pub(super) type Case = (&'static str, &'static str, &'static [&'static str]);

pub(super) const CASES: &[Case] = &[
    (
        "an entry ends with links to where it is cited",
        "# A\n\nBy @cite:b, and again @cite:b.\n\n- {#cite:a \"A 1999\"} A book,\n  of $x$.\n\
         - {#cite:b \"B 2000\"} Beside @cite:a.\n\nEnd.\n",
        &[
            "<span id='from-b-0'></span>[B~2000](a.md#cite-b), and again [B",
            "</span> <span class='citing'>Cited in [Chapter 1](a.md#from-a-0).</span>\n- <span class",
            " <span class='citing'>Cited in [Chapter 1](a.md#from-b-0).</span>\n\nEnd.",
        ],
    ),
    (
        "the paragraph below a formula is read like any other",
        "# A\n\n$$\na\n$$\n\nSo [spin]{.spin} is 5 kg.\n",
        &["So <span class='q-spin'>spin</span> is 5~kg."],
    ),
    (
        "a note stands behind the block that refers to it",
        "# A\n\n$$\na\n$$ {#eq:x}\n\nSo.[^b] More[^a]\nhere.\n\n[^a]: It's $x$.\n\n[^b]: From *b*\n    by @eq:x.\n\n\
         - one[^c]\n- two\n\n> quoted[^d]\n\nEnd.\n\n[^c]: C.\n[^d]: D.\n",
        &[
            "So.<a class='note-mark' id='noteref-b' href='#note-b' role='doc-noteref'>1</a> More<a class='note-mark' id='noteref-a'",
            ">2</a>\nhere.\n",
            "<aside class='note' id='note-b' role='doc-footnote' aria-label='Note 1'><a class='note-number' \
             href='#noteref-b' aria-label='1, back to the text'>1</a> From <em>b</em> by <a href='a.md#eq-x'>(1.1)</a>.</aside>\n\n",
            "<aside class='note' id='note-a'",
            ">2</a> It’s <span class='tied'>⟨x⟩.</span></aside>",
            "- one<a class='note-mark' id='noteref-c'",
            ">3</a>\n- two\n",
            "<aside class='note' id='note-c'",
            "> quoted<a class='note-mark'",
            ">4</a>",
            "<aside class='note' id='note-d'",
            "End.",
        ],
    ),
    (
        "a section is named by its number, and its title is there for those who point",
        "# A {#sec:a}\n\n## One\n\n## Two {#sec:two}\n\n### In it {#sec:in}\n\n@sec:two.[^n] @sec:in, @sec:a\n\n[^n]: @sec:two.\n",
        &[
            "[§1.2](a.md#sec-two \"Two\").",
            "[§1.2](a.md#sec-in \"In it\"), [Chapter~1](a.md#sec-a \"A\")",
            "<a href='a.md#sec-two' title='Two'>§1.2</a>.",
        ],
    ),
    (
        "brackets around the number of an equation are its own",
        "# A\n\n$$\na\n$$ {#eq:x}\n\nBy @eq:x (@eq:x, as in @eq:x) and (so)\n@eq:x.[^a]\n\n[^a]: By (@eq:x) @eq:x.\n",
        &[
            "By [(1.1)](a.md#eq-x) ([1.1](a.md#eq-x), as in [Eq.~1.1](a.md#eq-x)) and (so)\n[(1.1)](a.md#eq-x).",
            "By (<a href='a.md#eq-x'>1.1</a>) <a href='a.md#eq-x'>(1.1)</a>.",
        ],
    ),
    (
        "a table has a caption and columns of numbers",
        "# A\n\n| what[^a] | it's |\n|---|---|\n| `a` | 1.25 |\n| @sec:x | 1e-3 |\n| b | – |\n\n\
         Table: Words\nand *more*.[^b]\n\nEnd.\n\n[^a]: A.\n[^b]: B.\n\n## X {#sec:x}\n",
        &[
            "<div class='table-wrapper'>\n<table>\n<caption>Words and <em>more</em>.<a class='note-mark' id='noteref-b'",
            ">1</a></caption>\n<thead>\n<tr><th scope='col'>what<a class='note-mark' id='noteref-a'",
            ">2</a></th><th scope='col' class='number'>it’s</th></tr>\n</thead>\n<tbody>\n\
             <tr><td><code>a</code></td><td class='number'>1.25</td></tr>\n\
             <tr><td><a href='a.md#sec-x' title='X'>§1.1</a></td><td class='number'>10<sup>−3</sup>\
             <span class='pad' data-pad='.00'></span></td></tr>\n\
             <tr><td>b</td><td class='number'>–<span class='pad' data-pad='.00'></span></td></tr>\n\
             </tbody>\n</table>\n</div>\n\n\n<aside ",
        ],
    ),
    (
        "a table of verdicts on the source has a square for each row",
        "# A\n\n$$\na\n$$ {#eq:x source=19}\n\n| equation | says | verdict |\n|---|---|---|\n| @source:19 | $x$ | **slip**: $y$ |\n\nTable: T.\n",
        &[
            "<p class='squares'><a class='slip' href='a.md#source-19' title='(19) of the source: slip'>19</a> </p>\n<div class='table-wrapper'>",
        ],
    ),
    (
        "a table that says something else of the source has none",
        "# A\n\n$$\na\n$$ {#eq:x source=19}\n\nSo.\n\n| equation | says | true |\n|---|---|---|\n| @source:19 | $x$ | the root |\n\nTable: T.\n",
        &["\nSo.\n\n<div class='table-wrapper'>"],
    ),
    (
        "words have the colour of their quantity",
        "# A\n\nThe [angular *momentum*]{.momentum}, [so] and [$x$]{.spin}.\n\n\
         | a |\n|---|\n| [$x$ *so*]{.spin}, [b] |\n\nTable: [L]{.momentum}].\n",
        &[
            "The <span class='q-momentum'>angular *momentum*</span>, [so] and <span class='q-spin'>⟨x⟩</span>.",
            "<caption><span class='q-momentum'>L</span>].</caption>",
            "<td><span class='q-spin'>⟨x⟩ <em>so</em></span>, [b]</td>",
        ],
    ),
    (
        "words for a screen alone hold links and other brackets",
        "# A\n\nSee [the tub [so] in [motion](https://a.example)]{.screen}.\n",
        &["See <span class='screen'>the tub [so] in [motion](https://a.example)</span>."],
    ),
    (
        "a formula is tied to what stands beside it in text, tables and notes",
        "# A\n\nSo ($x$), 5 kg, *$x$.*[^a]\n\n| a |\n|---|\n| ($x$) |\n\nTable: T.\n\n[^a]: So ($x$), 5 kg.\n",
        &[
            "So <span class='tied'>(⟨x⟩),</span> 5~kg, *<span class='tied'>⟨x⟩.</span>*",
            "So <span class='tied'>(⟨x⟩),</span> 5~kg.</aside>",
            "<td><span class='tied'>(⟨x⟩)</span></td>",
        ],
    ),
    (
        "the ends of a range stay on one line, and of a clause they need not",
        "# A\n\nOf 67–85, and 3 – or so.\n",
        &["Of 67–\u{2060}85, and 3 – or so."],
    ),
    (
        "many checks are folded into a block of their own, and few are not",
        "# A\n\n```rust\n# use x;\nlet a = 1;\n\nassert!(a);\nassert!(\n    a\n);\n# Ok(())\n```\n\n\
         ```rust\nlet a = 1;\nassert!(a);\n```\n",
        &[
            "```rust\n# use x;\nlet a = 1;\n```\n\n<details class='checks'>\n<summary>2 checks</summary>\n\n\
             ```rust\nassert!(a);\nassert!(\n    a\n);\n# Ok(())\n```\n\n</details>\n",
            "```rust\nlet a = 1;\nassert!(a);\n```\n",
        ],
    ),
    (
        "a live number shows its unit, and a panel stands beside it",
        "# A\n\n```rust\nlet a = 1.0; // live: 0..2 m\nlet b = 2; // live: 0..2\nf(a); // → 3e-2 m\nassert!(a > b); // It holds.\n```\n",
        &[
            "<div class='answering'>\n\n```rust\nlet a = 1.0; // m\nlet b = 2;\nf(a); // → 3e-2 m\nassert!(a > b); // It holds.\n```\n\n\n\
             <div class='answers' data-snippet='0' data-module='live-a.md.js'",
            "<code>a</code></label><span><input type='number' id='answers-0-0' inputmode='decimal' data-name='a' data-decimals='2' \
             min='0' max='2' step='0.01' value='1.0'><span class='unit'>m</span>",
            "<dt><code>f(<wbr>a)</code></dt><dd><output data-value='3e-2'>3·10<sup>−2</sup></output>~m</dd>",
            "<b>holds</b><span>: it holds</span><span class='by'></span>",
            "<i hidden data-check='0' data-words='It holds.'></i>",
        ],
    ),
    (
        "a note of a caption stands below the figure",
        "# A\n\n![It's so.](fig:x)[^a]\n\n[^a]: A.\n",
        &["It’s so.<a class='note-mark'", "</figcaption>", "</figure>", "<aside class='note'"],
    ),
    (
        "a scene has its question, still and panel, and links that set it",
        "# A\n\n![A *plate*.](scene:plate)\n\n[Set $x$](scene:plate?spin=3&kick=0).\n",
        &[
            "<figure class='scene' id='scene-plate' data-scene='0' data-module='live-a.md.js' aria-labelledby='scene-plate-caption'>\n\
             <p class='question'>Why <span class='tied'>⟨x⟩?</span></p>\n\
             <p class='presets'><button type='button' data-set='spin=1&amp;drag=0.1'>a ball</button> </p>\n\
             <div class='drawing'><svg></svg></div>\n<div class='panel'>\n",
            "class='time' id='scene-plate-time' min='0' max='1' step='any' value='0.5'",
            "<label for='scene-plate-spin'>spin, ⟨x⟩</label><input type='range' id='scene-plate-spin' name='spin' min='-1' max='4' \
             step='0.1' value='2' data-start='2' data-unit='rad/s'><output for='scene-plate-spin' style='min-width: 10ch'>2.0~rad/s</output>",
            "id='scene-plate-drag' name='drag' min='-3' max='0' step='any' value='-2'",
            " data-log>",
            "<input type='radio' name='scene-plate-camera' value='0' data-name='camera' checked data-start> room",
            "<input type='radio' name='scene-plate-camera' value='1' data-name='camera'> body",
            "<input type='checkbox' id='scene-plate-cones' name='cones' checked data-start> cones",
            "<button type='button' class='press' name='kick' data-start='-1'>Kick</button>",
            "name='azimuth' min='-180' max='180' step='any' value='-28.64788975654116'",
            "<div><dt>wobbles</dt><dd></dd></div>",
            "<figcaption id='scene-plate-caption'><span class='number'>Scene 1.1.</span> A <em>plate</em>.</figcaption>\n</figure>",
            "<a href='#scene-plate' data-set='spin=3&amp;kick=0'>Set ⟨x⟩</a>.",
        ],
    ),
];
