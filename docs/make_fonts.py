"""The font of drawings: Latin, Greek and Cyrillic of STIX Two Text with the operators of STIX Two Math, and widths.

    python docs/make_fonts.py FOLDER

FOLDER has STIXTwoText-Regular.ttf, STIXTwoText-Italic.ttf and STIXTwoMath-Regular.ttf as their project gives them
out, under the SIL Open Font License 1.1. Needs fonttools.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from fontTools import subset
from fontTools.merge import Merger
from fontTools.ttLib import TTFont

FONTS = Path(__file__).parent.parent / "tmmcalc" / "report" / "fonts"
NAME = "TMM Text"
LETTERS = [*range(0x20, 0x7F), *range(0xA0, 0x180), *range(0x391, 0x3D7), *range(0x400, 0x460), 0x490, 0x491]
MARKS = [ord(c) for c in "‐–—‘’‚“”„•…‰′″₀₁₂₃₄₅₆₇₈₉№−×·±°"]
OPERATORS = [ord(c) for c in "←↑→↓↔↺↻∂∅∈∏∑∓∙√∝∞∠∥∫≈≠≤≥⊥⌀△○●□◇✓"]


def main(folder: Path) -> None:
    """Write both faces and the widths of their letters."""
    widths: dict[str, Any] = {}
    for face in ("Regular", "Italic"):
        with TemporaryDirectory() as scratch:
            font = merged(folder, face, Path(scratch))
        renamed(font, face)
        file = FONTS / f"TMMText-{face}.ttf"
        font.save(file)
        widths[face.lower()] = measured(TTFont(file))
    (FONTS / "widths.json").write_text(json.dumps(widths, ensure_ascii=False, indent=0) + "\n", encoding="utf-8")


def merged(folder: Path, face: str, scratch: Path) -> TTFont:
    """The letters of a face with the operators, which have one face."""
    parts = []
    for source, wanted in ((f"STIXTwoText-{face}", LETTERS + MARKS), ("STIXTwoMath-Regular", OPERATORS)):
        font = TTFont(folder / f"{source}.ttf")
        taken = set(wanted) - (set(TTFont(parts[0]).getBestCmap()) if parts else set())
        options = subset.Options()
        options.layout_features = ["kern", "mark", "mkmk", "ccmp"] if not parts else []
        options.hinting, options.name_IDs, options.notdef_outline = False, [0, 5, 13, 14], True
        options.drop_tables += ["MATH", "GSUB", "GDEF", "DSIG", "FFTM", "STAT"]
        if parts:
            options.drop_tables += ["GPOS"]
        worker = subset.Subsetter(options)
        worker.populate(unicodes=taken)
        worker.subset(font)
        parts.append(str(scratch / f"{source}.ttf"))
        font.save(parts[-1])
    return Merger().merge(parts)


def renamed(font: TTFont, face: str) -> None:
    """Its own name, for it is a changed version."""
    for number, text in ((1, NAME), (2, face), (3, f"{NAME} {face}"), (4, f"{NAME} {face}"), (6, f"TMMText-{face}")):
        font["name"].setName(text, number, 3, 1, 0x409)
    font["head"].created = font["head"].modified = 0


def measured(font: TTFont) -> dict[str, Any]:
    """Sizes in parts of the em: height of capitals, of small letters, depth, and the advance of every letter."""
    em, advance = font["head"].unitsPerEm, font["hmtx"]
    return {
        "capital": round(font["OS/2"].sCapHeight / em, 4),
        "small": round(font["OS/2"].sxHeight / em, 4),
        "advance": {chr(c): round(advance[name][0] / em, 4) for c, name in sorted(font.getBestCmap().items())},
    }


if __name__ == "__main__":
    main(Path(sys.argv[1]))
