"""Builds Principia's solver of Euler's equations as a contestant of `cargo book measure --principia FOLDER`.

    python3 build.py PRINCIPIA CORE_MATH FOLDER

PRINCIPIA and CORE_MATH are checkouts of github.com/mockingbirdnest/Principia and github.com/mockingbirdnest/core-math, both under the MIT licence; of the
commits below unless you say otherwise in the environment variable COMMIT. It needs clang++-19 (or what CXX names), protoc, and the headers of
Boost and Protocol Buffers: on Debian 12 the packages clang-19, protobuf-compiler, libprotobuf-dev and libboost-dev. FOLDER gets two programs,
`default` and `native`, which are Principia's two platforms, x64 and x64_AVX_FMA, with the options of its Makefile.

The solver, its functions and its numbers are compiled as they stand. Of abseil, which Principia takes for checks and texts, `stand-in` has what is
asked for here: checks are made, what they would print is not. The standard library is GCC's, as the Protocol Buffers of a distribution are.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

COMMIT = os.environ.get("COMMIT", "9ffb8b0c4e7502878f87753b273800813a42f056")
CORE_MATH_COMMIT = "30f41602b754fbf37c44b79e4f7d87d30d1b0acc"
HERE = Path(__file__).resolve().parent
DATA = HERE.parents[2] / "tests" / "data"
COMPILER = os.environ.get("CXX", "clang++-19")

# What Principia's Makefile says, but for warnings and the library of the standard.
OPTIONS = """-std=c++23 -O3 -m64 -msse4.1 -fexceptions -ffp-contract=off -fno-omit-frame-pointer -fno-char8_t -fdeclspec
    -fbracket-depth=257 -DNDEBUG -w""".split()
PLATFORMS = {
    "default": ("principia", "-DPRINCIPIA_REQUIRES_AVX=0 -DPRINCIPIA_REQUIRES_FMA=0".split()),
    "native": ("principia native", "-DPRINCIPIA_REQUIRES_AVX=1 -DPRINCIPIA_REQUIRES_FMA=1 -mfma -mavx".split()),
}
SOURCES = ["numerics/cbrt.cpp", "numerics/sin_cos.cpp", "numerics/elliptic_functions.cpp", "numerics/elliptic_integrals.cpp"]
MESSAGES = ["astronomy", "base", "geometry", "integrators", "numerics", "options", "physics", "quantities"]
PROBLEMS = [
    ("hoop", "thousand-periods.json", [1.5, 0.5, 2.0]),
    ("separatrix", "near-separatrix.json", [1.5, 0.5, 2.0]),
    ("toss", "tossed-coin.json", [0.25, 0.25, 0.5]),
    ("station", "struck-station.json", [0.5, 0.5, 1.0]),
]


def header():
    """The problems of the report as tables of exact doubles."""
    lines = [
        "#pragma once",
        "struct Problem { char const* name; double moments[3], start[3]; int steps; double const* times; int kept; int const* index;",
        "  double const *high, *low; };",
    ]
    table = []
    for name, file, moments in PROBLEMS:
        data = json.loads((DATA / file).read_text())
        assert data["y0"][3:] == [1, 0, 0, 0], "the solver is asked for the attitude since the start"
        lists = {
            "times": [i * data["dt"] for i in range(data["n"] + 1)],
            "high": [x for row in data["grid_hi"] for x in row],
            "low": [x for row in data["grid_lo"] for x in row],
        }
        for kind, numbers in lists.items():
            lines.append(f"constexpr double {name}_{kind}[] = {{{', '.join(float(x).hex() for x in numbers)}}};")
        lines.append(f"constexpr int {name}_index[] = {{{', '.join(map(str, data['index']))}}};")
        three = [", ".join(float(x).hex() for x in numbers) for numbers in (moments, data["y0"][:3])]
        table.append(
            f'  {{"{name}", {{{three[0]}}}, {{{three[1]}}}, {data["n"]}, {name}_times, {len(data["index"])}, {name}_index,'
            f" {name}_high, {name}_low}},"
        )
    return "\n".join([*lines, "constexpr Problem problems[] = {", *table, "};", ""])


def run(*command, cwd=None):
    print(" ".join(map(str, command[:2])), "…", command[-1])
    subprocess.run([str(part) for part in command], check=True, cwd=cwd)


def main(principia, core_math, folder):
    made = folder / "made"
    made.mkdir(parents=True, exist_ok=True)
    (made / "problems.hpp").write_text(header())
    run("protoc", f"--proto_path={principia}", f"--cpp_out={made}", *(principia / f"serialization/{name}.proto" for name in MESSAGES))
    includes = [f"-I{path}" for path in (HERE / "stand-in", made, principia, core_math / "include")]
    common = []
    for name in MESSAGES:
        common.append(made / f"{name}.pb.o")
        run(COMPILER, "-std=c++17", "-O1", "-w", f"-I{made}", "-c", made / f"serialization/{name}.pb.cc", "-o", common[-1])
    for platform, (contestant, options) in PLATFORMS.items():
        objects = list(common)
        sources = [principia / source for source in SOURCES]
        sources += [core_math / f"src/binary64/{name}/{name}.c" for name in ("sin", "cos")]
        for source in [*sources, HERE / "peer.cpp"]:
            objects.append(made / f"{source.stem}-{platform}.o")
            names = [f'-DCONTESTANT="{contestant}"', f'-DPRINCIPIA_COMMIT="{COMMIT[:12]}"']
            first = ["-include", HERE / "stand-in/first.hpp"]
            run(COMPILER, *OPTIONS, *options, *names, *includes, *first, "-x", "c++", "-c", source, "-o", objects[-1])
        run(COMPILER, *objects, "-lprotobuf", "-o", folder / platform)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*(Path(argument).resolve() for argument in sys.argv[1:]))
