"""Cuts the mathematics font of pages and labels, math.otf, out of New Computer Modern Math.

    python subset.py NewCMMath-Regular.otf        (with fonttools; the font is at https://ctan.org/pkg/newcomputermodern)

Kept are these characters and whatever style, stretching and scripts can make of them, with the table MATH. The original has
1.3 MB. Its licence asks that a modified version have another name: Book Math.
"""

import sys
from fontTools import subset

CHARACTERS = """
20-7e a0 a8 af b0 b1 b4 b7 d7 f7 131 237 2c6 2c7 2d8 2d9 2dc       ASCII, and signs that TeX and MathML write
302-304 306-308 30c 338 20d7 20db 20dc                             combining accents
391-3a9 3b1-3c9 3d1 3d5 3d6 3f1 3f5                                Greek
2009 200a 2013 2014 2016 2018 2019 201c 201d 2020-2022 2026        spaces, dashes, quotes
2032-2035 203e 2057 2061-2064                                      primes, a bar, invisible operators
2102 210e 210f 2111 2113 2115 211a 211c 211d 2124                  letters that stand apart
2190-2199 21a6 21cc 21d0-21d2 21d4 27f5-27f7 27f9                  arrows
2200-2209 220b-220d 220f-2213 2216-2218 221a 221d-2220             operators and relations
2223-222e 2234 2235 223c 2243 2245 2248 224d 2250 2254 2260-2265 226a 226b 227a 227b 2282 2283 2286 2287
2295-2299 22a2-22a5 22c0-22c6 22ee-22f1 27c2 2a7d 2a7e
2308-230b 23dc-23df 27e8-27e9                                      delimiters
1d400-1d49b 1d5a0-1d5d3 1d6a4 1d6a5 1d6a8-1d755                    alphabets: bold, italic, both; sans; Greek
1d7ce-1d7d7 1d7e2-1d7eb                                            digits: bold, sans
"""


def characters():
    for line in CHARACTERS.splitlines():
        for word in line.split("   ")[0].split():
            first, _, last = word.partition("-")
            yield from range(int(first, 16), int(last or first, 16) + 1)


options = subset.Options(layout_features=["ssty", "dtls", "flac"], name_IDs=[0, 1, 2, 4, 6])


def cut(glyphs):
    font = subset.load_font(sys.argv[1], options)
    cutter = subset.Subsetter(options)
    cutter.populate(unicodes=characters(), glyphs=glyphs)
    cutter.subset(font)
    return font


# Twice, as the table MATH keeps its measures of such glyphs only as are asked for by name.
font = cut(cut([]).getGlyphOrder())
for entry in font["name"].names:
    names = {1: "Book Math", 4: "Book Math Regular", 6: "BookMath-Regular"}
    entry.string = names.get(entry.nameID, entry.toUnicode())
font["CFF "].cff.fontNames = ["BookMath-Regular"]
font["head"].modified = font["head"].created  # the same file every time
subset.save_font(font, "math.otf", subset.Options(recalc_timestamp=False))
