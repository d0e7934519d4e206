"""Cuts the fonts of the book down to the characters that characters.txt lists.

    python cut.py FONTS...        (with fonttools and brotli)

FONTS are files, or folders that hold them somewhere, with these originals:

    LibertinusSerif-Regular.otf, -Italic.otf, -Semibold.otf      github.com/alerque/libertinus, and the crate `typst-assets`
    NewCMMath-Book.otf                                           ctan.org/pkg/newcomputermodern, and the crate `typst-assets`
    open-sans-v17-all-charsets-{regular,italic,600}.woff2,
    source-code-pro-v11-all-charsets-500.woff2                   front-end/fonts of the crate `mdbook-html`

Cargo has the two crates in its registry's folder `src`, once it has fetched them. Written are press/theme/fonts/*.woff2 for the
pages, and two files beside this one for the labels of figures: math.otf, with the shapes that NewCM draws for small sizes, and
open-sans.ttf, Open Sans Regular once more in a form that needs no unpacking. Two licences ask that a modified version have another
name: Book Math, Book Code. See press/theme/fonts/LICENCES.txt.
"""

import sys
from pathlib import Path

from fontTools import subset
from fontTools.misc.transform import Transform
from fontTools.pens.cu2quPen import Cu2QuPen
from fontTools.pens.recordingPen import DecomposingRecordingPen
from fontTools.pens.transformPen import TransformPen
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.ttLib import newTable

HERE = Path(__file__).parent
PAGES = HERE.parents[1] / "theme/fonts"
LETTERS = ["ccmp", "kern", "liga", "locl", "mark", "mkmk"]
# What grows with a formula, and how many sizes of it stay beside the first: TeX has four of brackets.
GROW = {"()[]{}|⟨⟩√": 4, "∫∮∑": 1, "\u0302\u0303\u20d7": 2}


def characters():
    """The code points of each section of characters.txt."""
    sections, name = {}, None
    for line in (HERE / "characters.txt").read_text().splitlines():
        if line.startswith("["):
            name = line[1 : line.index("]")]
            sections[name] = set()
        elif name:
            for word in line.split("   ")[0].split():
                first, _, last = word.partition("-")
                sections[name].update(range(int(first, 16), int(last or first, 16) + 1))
    return sections


def original(name):
    """The file of that name among FONTS."""
    for place in map(Path, sys.argv[1:]):
        for file in [place] if place.is_file() else sorted(place.rglob(name)):
            if file.name == name:
                return file
    sys.exit(f"no {name} in {sys.argv[1:]}")


def options(features):
    return subset.Options(
        layout_features=features, bidi_closure=False, hinting=False, desubroutinize=True, notdef_outline=True,
        name_IDs=[0, 1, 2, 4, 6, 16, 17], drop_tables=["FFTM", "PfEd"],
    )  # fmt: skip


def draw(font, character, parts):
    """Gives a TrueType font a character that it lacks, put together from others: each part with a scale and a shift."""
    glyphs, names = font.getGlyphSet(), font.getBestCmap()
    pen = TTGlyphPen(None)
    for part, scale, right, up in parts:
        outline = DecomposingRecordingPen(glyphs)
        glyphs[names[ord(part)]].draw(outline)
        outline.replay(TransformPen(pen, Transform(scale, 0, 0, scale, right, up)))
    name, like = f"uni{ord(character):04X}", names[ord(parts[0][0])]
    font.setGlyphOrder([*font.getGlyphOrder(), name])
    font["glyf"][name] = pen.glyph()
    font["glyf"][name].recalcBounds(font["glyf"])
    advance = font["hmtx"][like][0]
    font["hmtx"][name] = (round(advance * parts[0][1]), font["glyf"][name].xMin)
    for table in font["cmap"].tables:
        if table.isUnicode():
            table.cmap[ord(character)] = name


def prune(font):
    """Takes away the largest of the drawn sizes of what grows, and all of what need not."""
    names = font.getBestCmap()
    sizes = {names[ord(character)]: 1 + count for characters, count in GROW.items() for character in characters}
    variants = font["MATH"].table.MathVariants
    for way in ["Vert", "Horiz"]:
        glyphs, constructions = getattr(variants, f"{way}GlyphCoverage").glyphs, f"{way}GlyphConstruction"
        kept = [(g, c) for g, c in zip(glyphs, getattr(variants, constructions)) if g in sizes]
        for glyph, construction in kept:
            construction.MathGlyphVariantRecord = construction.MathGlyphVariantRecord[: sizes[glyph]]
            construction.VariantCount = len(construction.MathGlyphVariantRecord)
        glyphs[:] = [glyph for glyph, _ in kept]
        setattr(variants, constructions, [construction for _, construction in kept])
        setattr(variants, f"{way}GlyphCount", len(kept))


def to_quadratic(font):
    """Gives a font with cubic outlines quadratic ones, nowhere further away than a thousandth of an em. Chromium prints only
    these as fonts of a PDF; of others it draws each letter anew (Type 3)."""
    glyphs, order = font.getGlyphSet(), font.getGlyphOrder()
    made = {}
    for name in order:
        pen = TTGlyphPen(None)
        glyphs[name].draw(Cu2QuPen(pen, 1.0, reverse_direction=True))
        made[name] = pen.glyph()
    font["loca"], font["glyf"] = newTable("loca"), newTable("glyf")
    font["glyf"].glyphOrder, font["glyf"].glyphs = order, made
    for name, glyph in made.items():
        glyph.recalcBounds(font["glyf"])
        font["hmtx"][name] = (font["hmtx"][name][0], getattr(glyph, "xMin", 0))
    for table in ["CFF ", "VORG"]:
        if table in font:
            del font[table]
    maxp = font["maxp"]
    maxp.tableVersion, maxp.maxZones = 0x00010000, 1
    for count in ["TwilightPoints", "Storage", "FunctionDefs", "InstructionDefs", "StackElements", "SizeOfInstructions", "ComponentElements"]:
        setattr(maxp, f"max{count}", 0)
    maxp.recalc(font)
    font["post"].formatType, font.sfntVersion = 3.0, "\0\1\0\0"
    return font


def cut(source, wanted, features, flavor="woff2", glyphs=(), mend=lambda font: None):
    choices = options(features)
    font = subset.load_font(str(original(source)), choices)
    mend(font)
    lacks = sorted(wanted - set(font.getBestCmap()))
    if lacks:
        sys.exit(f"{source} lacks " + " ".join(f"{c:x} ({chr(c)})" for c in lacks))
    cutter = subset.Subsetter(choices)
    cutter.populate(unicodes=wanted, glyphs=glyphs)
    cutter.subset(font)
    font.flavor = flavor
    return font


def save(font, file, family=None):
    if family:
        compact = family.replace(" ", "")
        named = {1: family, 4: family, 6: compact, 16: family}
        for entry in font["name"].names:
            entry.string = named.get(entry.nameID, entry.toUnicode())
        if "CFF " in font:
            font["CFF "].cff.fontNames = [compact]
    font["head"].modified = font["head"].created  # the same file every time
    font.recalcTimestamp = False
    font.save(file)
    print(f"{file.name:28} {file.stat().st_size:7} bytes, {len(font.getGlyphOrder())} glyphs")


def text(sections):
    for style in ["Regular", "Italic", "Semibold"]:
        font = cut(f"LibertinusSerif-{style}.otf", sections["text"], LETTERS)
        save(to_quadratic(font), PAGES / f"libertinus-serif-{style.lower()}.woff2")
    for style in ["regular", "italic", "600"]:
        minus = lambda font: draw(font, "⁻", [("−", 0.62, 0, 560)])
        font = cut(f"open-sans-v17-all-charsets-{style}.woff2", sections["text"], LETTERS, mend=minus)
        save(font, PAGES / f"open-sans-{style.replace('600', 'semibold')}.woff2")
        if style == "regular":
            save(cut(f"open-sans-v17-all-charsets-{style}.woff2", sections["text"], [], flavor=None, mend=minus), HERE / "open-sans.ttf")


def code(sections):
    def mend(font):
        draw(font, "⁻", [("−", 0.62, 114, 300)])
        draw(font, "ẋ", [("x", 1, 0, 0), ("˙", 1, 0, 0)])
        font["hmtx"]["uni207B"] = font["hmtx"]["x"]

    font = cut("source-code-pro-v11-all-charsets-500.woff2", sections["code"], ["ccmp", "mark"], mend=mend)
    save(font, PAGES / "book-code.woff2", "Book Code")


def for_browsers(font):
    """Makes up for what browsers do not do."""
    prune(font)
    # They lower a subscript by a measure of its letter's foot and raise an exponent by one of its head, as TeX does only for
    # what is larger than a letter. These are the measures of Computer Modern, and the first so small that no letter feels it.
    constants = font["MATH"].table.MathConstants
    constants.SubscriptBaselineDropMin.Value = 25
    constants.SuperscriptBaselineDropMax.Value = 386
    # A prime is an exponent. Its own shape is raised and small already; there is one to be raised and made small.
    small = {prime: f"{font.getBestCmap()[prime]}.st" for prime in range(0x2032, 0x2035)}
    for table in font["cmap"].tables:
        table.cmap.update({prime: glyph for prime, glyph in small.items() if prime in table.cmap})


def maths(sections):
    # Pages go without the shapes that the font has for small sizes, two for each letter: of the browsers only Firefox asks for
    # them. Each is cut twice, as the table MATH keeps its measures of such glyphs only as are asked for by name.
    plain = cut("NewCMMath-Book.otf", sections["maths"], [], mend=for_browsers).getGlyphOrder()
    font = cut("NewCMMath-Book.otf", sections["maths"], [], glyphs=plain, mend=for_browsers)
    save(to_quadratic(font), PAGES / "book-math.woff2", "Book Math")
    every = cut("NewCMMath-Book.otf", sections["maths"], ["ssty"], mend=prune).getGlyphOrder()
    font = cut("NewCMMath-Book.otf", sections["maths"], ["ssty"], flavor=None, glyphs=every, mend=prune)
    save(font, HERE / "math.otf", "Book Math")


sections = characters()
text(sections)
code(sections)
maths(sections)
