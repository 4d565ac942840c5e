"""Texts of a page in all its languages: a list with one of each, or the text alone where they are the same."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TypeVar

from tmmcalc.report.formula.symbols import with_letters
from tmmcalc.report.language import LANGUAGES, speaking, tr, tr_name, tr_unit

Said = str | list[str]
T = TypeVar("T")

SIGNS = (
    (re.compile(r"(?<=\s)->(?=\s)"), "→"),
    (re.compile(r"(?<=[A-Za-z\d])\*(?=[A-Za-z])"), "·"),
    (re.compile(r"(?<=\d) deg\b"), "°"),
    (re.compile(r"(?<![^\s(])-(?=\d| )"), "−"),
)


def each_said(say: Callable[[], T]) -> list[T]:
    """What ``say`` gives in each language."""
    found = []
    for language in LANGUAGES:
        with speaking(language):
            found.append(say())
    return found


def said(say: Callable[[], str]) -> Said:
    """A text in all languages."""
    return alike(each_said(say))


def alike(texts: list[str]) -> Said:
    """A text in all languages, or once where they say the same."""
    return texts[0] if len(set(texts)) == 1 else texts


def name_of(text: str) -> Said:
    """A text that the program says elsewhere: a meaning, a warning; with Greek letters and signs of print."""
    return said(lambda: _printed(with_letters(tr_name(text))))


def _printed(text: str) -> str:
    """Signs that a terminal has not: 5 N*m at -3 deg -> 5 N·m at −3°."""
    for typed, printed in SIGNS:
        text = typed.sub(printed, text)
    return text


def unit_of(unit: str) -> Said:
    """A unit; of an angle the sign of degrees, of a number that has none nothing."""
    known = {"deg": "°", "-": ""}
    return known[unit] if unit in known else said(lambda: tr_unit(unit))


def words() -> dict[str, Said]:
    """What the page itself says, by the names that its scripts know."""
    spoken = each_said(_words)
    return {key: alike([each[key] for each in spoken]) for key in spoken[0]}


def _words() -> dict[str, str]:
    return {
        "play": tr("Play"),
        "pause": tr("Pause"),
        "speed": tr("Speed"),
        "back": tr("Back one position"),
        "on": tr("On one position"),
        "input": tr("Position of the input"),
        "solved": tr("values at the nearest solved position, {value}"),
        "unreached": tr("cannot be reached: the links do not close there"),
        "beyond": tr("beyond the range that is analysed"),
        "step": tr("in position {label}"),
        "pick": tr("Drag the point, or move it by the arrow keys."),
        "chosen": tr("Back to the chosen point"),
        "within": tr("within the contour"),
        "flawed": tr("within the tolerated contour only"),
        "outside": tr("outside the contour"),
        "apart": tr("{place}, in a part that lies apart"),
        "least": tr("at least {low}"),
        "absent": tr("there is no such pair: {why}"),
        "useless": tr("the pair cannot work: {why}"),
        "show": tr("Show"),
        "paths": tr("Paths"),
        "numbers": tr("Numbers of links"),
        "names": tr("Names of points"),
        "masses": tr("Centres of mass"),
        "centres": tr("Instant centres"),
        "ghosts": tr("Other variants"),
        "diagrams": tr("Diagrams"),
        "add": tr("Add a diagram"),
        "remove": tr("Take away"),
        "copy": tr("Copy the value"),
        "facts": tr("Results"),
        "find": tr("Find"),
        "variant": tr("Variant"),
        "plans": tr("Plans of vectors"),
        "given": tr("Given data"),
        "quantity": tr("Quantity"),
        "designation": tr("Designation"),
        "value": tr("Value"),
        "diagram": tr("Diagram"),
        "errors": tr("Estimated relative errors"),
        "language": tr("Language"),
        "theme": tr("Light or dark"),
        "print": tr("Print"),
        "kept": tr("{kept} rows of {of}"),
        "lowest": tr("least"),
        "highest": tr("greatest"),
        "spec": tr("The spec"),
        "precision": tr("Numbers of diagrams are stored with a relative error of {error}; results are whole."),
        "arrow": tr("1 cm: {value}"),
        "none": tr("nothing is found"),
        "holds": tr("yes"),
        "fails": tr("no"),
        "drag": tr("Drag a link, or turn the input by the arrow keys."),
    }
