"""Headings and symbols that the pictures of gear trains share."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from unicodedata import normalize

from tmmcalc.gears.scheme import Layout
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.numbers import number

KINDS = {"u": "U", "i_1H": "i_{1H}", "i_H1": "i_{H1}", "i_14": "i_{14}"}
EXACT = 100_000  # larger denominators are not written out

CRITERIA: dict[str, tuple[str, float, str]] = {
    "mass": ("mass of moving wheels $M$", 1.0, "kg"),
    "inertia": ("reduced inertia $J$", 1.0, "kg·m²"),
    "size": ("size $D$", 1e3, "mm"),
    "envelope": ("envelope", 1e3, "mm"),
    "efficiency": ("efficiency $η$", 1.0, ""),
    "error": ("error of the ratio", 100.0, "%"),
    "width_deviation": ("$b/m$ beyond the usual", 1.0, ""),
}


def axis_name(key: str) -> str:
    """A criterion with the unit in which it is shown."""
    name, _, unit = CRITERIA[key]
    return f"{name}, {unit}" if unit else name


def layout_name(scheme: Layout, planets: int) -> str:
    """The layout in a sentence with its designation and the number of planets."""
    called = f" ({normalize('NFC', scheme.designation)})" if scheme.planetary else ""
    name = scheme.title[0].upper() + scheme.title[1:] + called
    if not scheme.branched:
        return name
    what = "planet" if scheme.planetary else "layshaft"
    if scheme.paired:
        return f"{name}, $K$ = {planets}"
    return f"{name}, {planets} {what}{'s' if planets > 1 else ''}"


def ratio_text(kind: str, value: Fraction) -> str:
    """A ratio by its kind, as a number and exactly.

    >>> ratio_text("i_1H", Fraction(22, 3))
    '$i_{1H}$ = 7.333333 = 22/3'
    """
    text = f"${KINDS.get(kind, kind)}$ = {minus(number(float(value)))}"
    exact = 1 < value.denominator < EXACT
    return f"{text} = {minus(str(value))}" if exact else text


def teeth_text(teeth: Iterable[int]) -> str:
    """Tooth numbers with strokes between them."""
    return "/".join(map(str, teeth))
