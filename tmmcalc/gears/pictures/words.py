"""Headings and symbols that the pictures of gear trains share, in the language in force."""

from __future__ import annotations

import re
from collections.abc import Iterable
from fractions import Fraction
from unicodedata import normalize

from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.model import ToothSets
from tmmcalc.gears.scheme import Layout, known_layouts
from tmmcalc.report.drawing.lettering import minus, plain
from tmmcalc.report.language import tr, tr_count, tr_name, tr_unit
from tmmcalc.report.numbers import number

KINDS = {"u": "U", "i_1H": "i_{1H}", "i_H1": "i_{H1}", "i_14": "i_{14}"}
EXACT = 100_000  # larger denominators are not written out
WHEELS = re.compile(r"(\d+'*)-(\d+'*)")  # of a mesh

CRITERIA: dict[str, tuple[float, str]] = {  # factor from SI, and the unit in which a criterion is shown
    "mass": (1.0, "kg"),
    "inertia": (1.0, "kg·m²"),
    "size": (1e3, "mm"),
    "envelope": (1e3, "mm"),
    "efficiency": (1.0, ""),
    "error": (100.0, "%"),
    "width_deviation": (1.0, ""),
}


def axis_name(key: str) -> str:
    """A criterion with the unit in which it is shown."""
    names = {
        "mass": tr("mass of moving wheels $M$"),
        "inertia": tr("reduced inertia $J$"),
        "size": tr("size $D$"),
        "efficiency": tr("efficiency $η$"),
        "error": tr("error of the ratio"),
        "width_deviation": tr("$b/m$ beyond the usual"),
    }
    _, unit = CRITERIA[key]
    name = names.get(key) or tr_name(key)
    return f"{name}, {tr_unit(unit)}" if unit else name


def short_name(key: str) -> str:
    """A criterion in a word."""
    return tr_name(key.replace("_", " "))


def of_many(text: str, drawn: int, thinned: bool) -> str:
    """A text, with how many signs are drawn where not all are."""
    return tr("{what}, {drawn} drawn, evenly", what=text, drawn=drawn) if thinned else text


def counted(scheme: Layout, planets: int) -> str:
    """The planets, pairs of planets or layshafts of a layout with their number."""
    if not scheme.planetary:
        return tr_count(planets, "layshaft", "layshafts")
    if scheme.paired:
        return tr_count(planets, "pair of planets", "pairs of planets")
    return tr_count(planets, "planet", "planets")


def layout_name(scheme: Layout, planets: int) -> str:
    """The layout in a sentence with its designation and the number of planets."""
    title = tr_name(scheme.title)
    title = title[0].upper() + title[1:]
    name = title + (f" ({normalize('NFC', scheme.designation)})" if scheme.planetary else "")
    return f"{name}, {counted(scheme, planets)}" if scheme.branched else name


def layout_word(key: str) -> str:
    """A layout in a word, a planetary one by its designation; a number of planets as it is."""
    scheme = known_layouts().get(key)
    return normalize("NFC", scheme.designation) if scheme is not None and scheme.planetary else tr_name(key)


def variant_word(scheme: Layout, planets: int) -> str:
    """A layout in a word with the number of its planets or layshafts."""
    name = layout_word(scheme.key)
    return f"{name}, $K$ = {planets}" if scheme.branched else name


def train_name(sets: ToothSets) -> str:
    """A tooth set by its layout and its teeth."""
    return f"{layout_name(sets.scheme, sets.planets)}: $z$ = {teeth_text(sets.teeth[0].tolist())}"


def pair_name(name: str) -> str:
    """The name of a pair as it is read: a mesh has a dash between its wheels.

    >>> pair_name("2'-3"), pair_name("high-speed pair")
    ("2'–3", 'high-speed pair')
    """
    wheels = WHEELS.fullmatch(name)
    return f"{wheels[1]}–{wheels[2]}" if wheels else tr_name(name)


def pair_title(task: PairTask) -> str:
    """A pair by its name and its teeth."""
    first, second = task.teeth
    teeth = f"$z$ = {first}/{second}"
    if task.kind == "rack":
        teeth = tr("$z$ = {teeth} and a rack", teeth=first)
    elif task.kind == "internal":
        teeth = tr("$z$ = {teeth}, internal", teeth=f"{first}/{second}")
    return f"{plain(pair_name(task.name))}: {teeth}" if task.name else teeth


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
