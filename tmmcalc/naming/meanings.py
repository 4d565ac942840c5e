"""Meaning and symbol of what a stage tells, by its name: as they are declared on the fields of its results."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from importlib import import_module
from inspect import getmodule
from string import Formatter

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import FORMS, Quantity, given_out, given_over_rows, standing_in
from tmmcalc.core.stage import STAGES
from tmmcalc.naming.language import ANY

AXES = ("x", "y")  # what stands in a place of this name
WORDS = {  # all that may stand in places of these names
    "axis": AXES,
    "along": ("x", "y", "z"),
    "coordinate": ("S", "psi"),
    "spring": ("Q", "M"),
    "kind": ("steps", "least"),
    "height": ("H2", "l0"),
    "start": ("S0", "R0"),
    "shafts": ("crankshaft", "shafts"),
    "left": ("D", "M_D"),
}
PREFIX = "prefix"  # a place of this name is empty or ends with _
SOME = re.compile(r"\{\w+\}")  # a unit that is a place alone: there may be none
# name of a fact: quantity, what value of it; of an extreme the place, and what that is counted by
EXTREME = re.compile(r"(.+)_(min|max|rms|start|end)((?<=_min|_max)_at(?:_(\w+))?)?")
# words in these places may have _ themselves: what is said for it
LONG = {**dict.fromkeys(("phase", "cause", "shaft", "plan", "scheme"), " "), "way": " → "}
SAID = {  # what short words in these places stand for
    "curve": {
        "c": "the pitch curve",
        "w": "the working profile",
        "o": "the second wall",
        "t": "the path of the tool",
        "to": "the path of the tool along the second wall",
    }
}


@cache
def described(stage: str, column: bool) -> Callable[[str, str], tuple[str, str]]:
    """A function of the name and the unit of a fact, or of a column: meaning and symbol, empty if none is declared.

    The unit `ANY` is that of whatever has the name.

    >>> import tmmcalc.rooms
    >>> described("kinematics", True)("vx_D", "m/s")
    ('velocity of point D along x', '')
    """
    own = STAGES[stage]
    every: list[Quantity] = []
    if not column:  # what the document alone tells, also in modules that it imports late
        facts = import_module(own.facts)
        for module in (facts, *map(import_module, getattr(facts, "FURTHER", ()))):
            every += standing_in(module)
    every += [each for kind in own.kinds for each in given_out(kind)]
    heads: set[str] = set()  # what stands over columns, before what is told once beside the table
    if column and (columns := own.part("columns") or own.part("table")):
        standing = list(standing_in(getmodule(columns)))
        every += standing
        heads = {each.name for each in (*standing, *(q for kind in own.kinds for q in given_over_rows(kind)))}
        every += [each._replace(key=each.header) for each in every if each.header]
    plain = {(each.name, _bare(each.unit)): each for each in reversed(every)}  # of records in others the outer says it
    names = {each.name: each for each in reversed(every)}
    # what has most words of its own first: v{axis}_{point} before {axis}_{point}
    forms = [each for each in every if "{" in each.name and (_literal(each.name) or _closed(each.name))]
    forms.sort(key=lambda each: (each.name not in heads, -_literal(each.name)))

    def found(name: str, unit: str) -> tuple[str, str]:
        unit = _bare(unit)
        same = plain.get((name, unit)) or names.get(name)
        if same is not None and _units(same.unit, unit) is not None:
            return same.meaning, same.symbol
        for each in forms:
            of_name, of_unit = _places(each.name, name), _units(each.unit, unit)
            if of_name is None or of_unit is None:
                continue
            if column or not any(_beyond(place, word) for place, word in of_name.items()):
                return _filled(each, {**of_unit, **of_name})
        return "", ""

    return cache(found)


def _bare(unit: str) -> str:
    """The unit of a number is none, or - in the header of a column."""
    return "" if unit == "-" else unit


def _units(form: str, unit: str) -> dict[str, str] | None:
    """The words in the places of a unit; a value may be told in the unit of people."""
    if unit == ANY:
        return {}
    form = _bare(form)
    found = _places(form, unit) if unit or not SOME.fullmatch(form) else {}
    return {} if found is None and (form, unit) in FORMS else found


def _beyond(place: str, word: str) -> bool:
    """Whether a word in a place is more than a name there: of S_{output} no fact is S_D_min."""
    if place in (PREFIX, "moment"):
        return False
    return EXTREME.fullmatch(word) is not None if place in LONG else "_" in word


def _closed(form: str) -> bool:
    """Whether one of its places has few words."""
    return any(f"{{{place}}}" in form for place in WORDS)


def _literal(form: str) -> int:
    return sum(len(words.strip("_")) for words, *_ in Formatter().parse(form))


def _filled(form: Quantity, places: Mapping[str, str]) -> tuple[str, str]:
    """Meaning and symbol with the names of the scene; a symbol has braces of its own."""
    words = {place: _said(place, word) for place, word in places.items()}
    meaning = Phrase(form.meaning, **words) if "{" in form.meaning else form.meaning
    if prefix := places.get(PREFIX, "").removesuffix("_"):
        meaning = Phrase("{quantity}: {word}", quantity=meaning, word=prefix)
    return meaning, form.symbol if "{" not in form.symbol else ""


def _said(place: str, word: str) -> str:
    if place in LONG:
        return word.replace("_", LONG[place])
    return SAID[place].get(word, word) if place in SAID else word


def worded(meaning: str) -> str:
    """A meaning of which some places have short words, with what these stand for.

    >>> worded(Phrase("radius of curvature of {curve}", curve="c"))
    'radius of curvature of the pitch curve'
    """
    if not isinstance(meaning, Phrase) or SAID.keys().isdisjoint(meaning.values):
        return meaning
    words = {
        place: SAID[place].get(str(word), word) if place in SAID else word for place, word in meaning.values.items()
    }
    return Phrase(meaning.template, **words)


def _places(form: str, text: str) -> dict[str, str] | None:
    """The words that stand in the places of a form; None if the text is not of this form.

    >>> _places("v{axis}_{point}", "vx_D")
    {'axis': 'x', 'point': 'D'}
    """
    return _matched([(words, place) for words, place, *_ in Formatter().parse(form)], text)


def _matched(parts: Sequence[tuple[str, str | None]], text: str) -> dict[str, str] | None:
    if not parts:
        return None if text else {}
    (words, place), *rest = parts
    if not text.startswith(words):
        return None
    text = text[len(words) :]
    if place is None:
        return _matched(rest, text)
    for end in range(place != PREFIX, len(text) + 1):
        if place == PREFIX and end and text[end - 1] != "_":
            continue
        found = _matched(rest, text[end:])
        if found is not None and text[:end] in WORDS.get(place, (text[:end],)):
            return {place: text[:end], **found}
    return None
