"""The lines of a blocking contour as strokes of the picture: each with its number, its words and its look.

Strokes come from three sources: the limits of undercut, which run across the whole window; the edges of the outlines;
and the lines that the result carries. Equal numbers of one value are one stroke, of several values get a letter.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import groupby

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.core.records import record
from tmmcalc.gears.involute.contour.task import LINES
from tmmcalc.gears.meshing.contours import ContourPoint, PairContour
from tmmcalc.gears.pictures.contourpaths import outlines, paths_of
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.pens import INK, MARK, Pen
from tmmcalc.report.language import tr_name
from tmmcalc.report.numbers import number as digits

RATIO, TIP, FILLET = "#0072b2", "#8f6b00", "#00795a"
SLIDING, STRENGTH = "#7a5195", "#c2558f"
SUMS = ("14", "15", "16")
GREY = "#6b6b6b"
WITHIN, BEYOND = 0.4, 0.2  # width of lines in the contour and outside [mm]
LOOKS: dict[str, tuple[str, tuple[float, ...]]] = {
    "1": (INK, ()),
    "11": (INK, ()),
    "2": (INK, (2.6, 0.8)),
    "10": (INK, (2.6, 0.8)),
    "3": (FILLET, ()),
    "4": (RATIO, (2.2, 0.8)),
    "5": (RATIO, ()),
    "6": (SLIDING, (3.2, 0.7, 0.7, 0.7)),
    "7": (TIP, (0.9, 0.6)),
    "8": (TIP, (2.2, 0.8)),
    "9": (TIP, ()),
    "12": (STRENGTH, (1.8, 0.6, 0.6, 0.6, 0.6, 0.6)),
    "14": (MARK.colour, (4.2, 0.8, 0.8, 0.8)),
    "15": (GREY, (1.5, 1.1)),
    "16": (GREY, (4.2, 0.8, 0.8, 0.8)),
}
PLAIN = (GREY, (0.6, 0.6))
BARE = ("6", "12")  # lines of equality: what is constant along them is a difference of zero
THICKNESS = ("7", "8", "9")  # lengths
SAME = 1e-9  # values that are one
LETTERS = "abcdefghij"
INDEXED = re.compile(r"\bx([12])\b")
SIGN = re.compile(r"(?<= )-(?=[0-9])")
SUBSCRIPTS = {"1": "\N{SUBSCRIPT ONE}", "2": "\N{SUBSCRIPT TWO}"}
DIGITS = re.compile("[0-9]+")


@record
class Stroke:
    """What is drawn with one look and stands in the key as one row."""

    number: str  # in the circle; two parted by a comma have a circle each; empty: none
    title: str
    value: float | None  # None: nothing is constant along it but what the title says
    paths: tuple[Plane, ...]  # x1 + i x2

    @property
    def pens(self) -> tuple[Pen, Pen]:
        """The pens inside the contour and outside."""
        leading = DIGITS.match(self.number)
        colour, dashes = LOOKS.get(leading[0], PLAIN) if leading else PLAIN
        layer = f"LINE_{self.number.replace(', ', '_').replace(chr(39), '_') or 'OTHER'}".upper()
        return Pen(f"{layer}_WITHIN", WITHIN, dashes, colour), Pen(layer, BEYOND, dashes, colour)

    @property
    def text(self) -> str:
        """The words of the key.

        >>> Stroke("4", "contact ratio", 1.2, ()).text
        'contact ratio: 1.2'
        """
        title = indexed(tr_name(self.title))
        if self.value is None:
            return title
        value = minus(digits(self.value, 5))
        if f"= {value}" in title:
            return title
        if self.value and self.number.startswith(THICKNESS) and "modules" not in self.title:
            value += " $m$"
        return f"{title}: {value}"


def indexed(text: str) -> str:
    """Words in which the shifts x1, x2 have true indices and numbers true signs.

    >>> indexed("x1 = -0.5")
    'x₁ = −0.5'
    """
    return SIGN.sub("\N{MINUS SIGN}", INDEXED.sub(lambda found: f"x{SUBSCRIPTS[found[1]]}", text))


def strokes(pair: PairContour, low: complex, high: complex) -> tuple[Stroke, ...]:
    """All lines of a pair in a window between two corners, in the order of their numbers."""
    found = [*_limits(pair, low, high), *_edges(pair)]
    for line in pair.lines:
        value = None if line.number.startswith(BARE) else float(line.value)
        path = line.x1 + 1j * line.x2
        if line.number.split(", ")[0] in SUMS:
            ends = np.array([low.real, high.real])
            path = ends + 1j * (line.value - ends)
        if path.size:
            found.append(Stroke(line.number, line.title, value, (path,)))
    return tuple(_lettered(_merged(found)))


def chosen(pair: PairContour) -> ContourPoint | None:
    """The point of the shifts of the pair."""
    return next((point for point in pair.points if point.name == "chosen"), None)


def least_shifts(pair: PairContour) -> tuple[float | None, float | None]:
    """Least shifts without undercut, as far as the margins or the edges tell them."""
    point = chosen(pair)
    one, two = (f"undercut{wheel}" for wheel in (1, 2))
    if point is not None and {one, two} <= pair.margins.keys():
        return point.x1 - pair.margins[one], point.x2 - pair.margins[two]
    outline = pair.strict.main
    x1, x2 = ([] if outline is None else [path[0] for path in paths_of(outline, key)] for key in (one, two))
    return (float(x1[0].real) if x1 else None), (float(x2[0].imag) if x2 else None)


def _limits(pair: PairContour, low: complex, high: complex) -> Iterator[Stroke]:
    """Lines 2 and 10 from border to border, where they are known."""
    x1, x2 = least_shifts(pair)
    if x1 is not None:
        yield _on_edge(pair, "undercut1", np.array([complex(x1, low.imag), complex(x1, high.imag)]))
    if x2 is not None:
        yield _on_edge(pair, "undercut2", np.array([complex(low.real, x2), complex(high.real, x2)]))


def _edges(pair: PairContour) -> Iterator[Stroke]:
    """The other edges of the outlines."""
    for outline in outlines(pair):
        for key in dict.fromkeys(outline.edges):
            if not key.startswith("undercut"):
                for path in paths_of(outline, key):
                    yield _on_edge(pair, key, path)


def _on_edge(pair: PairContour, key: str, path: Plane) -> Stroke:
    number, value = _known(pair, key)
    title = "tip of the mate cuts into the fillet" if key.startswith("interference") else LINES[key][1]
    return Stroke(number, title, value, (path,))


def _known(pair: PairContour, key: str) -> tuple[str, float | None]:
    """The textbook's number of a line of the contour, and what is constant along it."""
    number = LINES[key][0]
    if key == "contact_ratio":
        return number if pair.contact_ratio == 1 else "4", pair.contact_ratio
    if key.startswith("thickness"):
        return number.replace("9", {0.25: "8", 0.4: "7"}.get(pair.thickness, "9")), pair.thickness
    return number, None


def number_of(pair: PairContour, key: str, seen: Iterable[Stroke]) -> str:
    """The number of a line of the contour as it stands in the picture."""
    number, value = _known(pair, key)
    plain = Stroke(number, LINES[key][1], value, ())
    return next((s.number for s in seen if _alike(replace(s, number=s.number.rstrip(LETTERS)), plain)), plain.number)


def _merged(found: Iterable[Stroke]) -> list[Stroke]:
    """One stroke a number and value; the first one gives the words."""
    groups: list[Stroke] = []
    for stroke in found:
        for k, other in enumerate(groups):
            if _alike(stroke, other):
                groups[k] = replace(other, paths=(*other.paths, *stroke.paths))
                break
        else:
            groups.append(stroke)
    return sorted(groups, key=lambda stroke: _order(stroke.number))


def _alike(one: Stroke, other: Stroke) -> bool:
    if one.number != other.number or (not one.number and one.title != other.title):
        return False
    if one.value is None or other.value is None:
        return one.value is other.value
    return abs(one.value - other.value) < SAME


def _order(number: str) -> tuple[float, str]:
    leading = DIGITS.match(number)
    return (float(leading[0]) if leading else np.inf), number


def _lettered(found: list[Stroke]) -> Iterator[Stroke]:
    for number, group in groupby(found, key=lambda stroke: stroke.number):
        same = list(group)
        for letter, stroke in zip(LETTERS, same, strict=False):
            yield replace(stroke, number=f"{number}{letter}") if number and len(same) > 1 else stroke
