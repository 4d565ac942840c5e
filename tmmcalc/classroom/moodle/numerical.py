"""A class as a category a variant, with a numerical question for each asked result.

The first answer that fits counts: the right ones stand first, then what is right by plans, then what comes out with
known mistakes, each with a hint and no points, at last whatever else. A mistake whose answers could be taken for right
is none of them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from tmmcalc.classroom.moodle import elements
from tmmcalc.classroom.moodle.scenes import Told, markup, senses, sentences, table
from tmmcalc.classroom.papers.tasksheet import tolerance_of, unit_of
from tmmcalc.core.records import record
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.spec.dimensions import UNITS
from tmmcalc.spec.units import conversion, kind_of

if TYPE_CHECKING:
    from tmmcalc.classroom.marking import Rules
    from tmmcalc.classroom.model import Item, Key, Keybook

SCHEME = "scheme.svg"
KEYS = str.maketrans({"²": "^2", "³": "^3", "·": "*"})  # as they are typed
HINTS = 3  # of mistakes that give the same number


@record
class Wrong:
    """A value that comes out with known mistakes, and by how much it may be off."""

    value: float
    within: float
    hints: tuple[str, ...]


def questions_of(book: Keybook, scenes: Sequence[Told], title: str, name: str, rules: Rules) -> Iterator[str]:
    """The questions of all variants, in the language in force; ``name`` begins the keys that Moodle knows them by."""
    name = elements.stem(name)
    for key, scene in zip(book.keys, scenes, strict=True):
        number = f"{key.number:02d}"
        yield elements.category((title, tr("Variant {number}", number=number)), key.student)
        yield _described(scene, book.items, f"{number} {title}", f"{name}-{number}-0")
        for at, (item, meaning) in enumerate(zip(book.items, scene.meanings, strict=True)):
            yield elements.question(
                "numerical",
                f"{number} {item.name}",
                asked_in(item, meaning),
                *answers_of(book, key, at, rules),
                *elements.units(units_of(item.unit)),
                points=item.weight,
                key=f"{name}-{number}-{at + 1}",
            )


def _described(scene: Told, items: Sequence[Item], name: str, key: str) -> str:
    """The scheme and the data, before the questions: it asks for nothing."""
    picture = f'<p><img src="@@PLUGINFILE@@/{SCHEME}" alt="{markup(tr("Scheme of the mechanism"))}"></p>'
    text = (picture if scene.scheme else "") + sentences(scene.said)
    text += table(scene.own, tr("Data of this variant alone"))
    text += table(scene.common, tr("Data of all variants")) + senses(items)
    files = elements.file(SCHEME, scene.scheme.encode()) if scene.scheme else ""
    return elements.question("description", name, text, files=files, points=0, key=key)


def asked_in(item: Item, meaning: str) -> str:
    """The text of a question."""
    unit = f" [{_begun(unit_of(item))}]" if unit_of(item) else ""  # as it can be typed
    asked = f"{tr('{count} significant digits', count=item.digits)}, {tr('within {part}', part=tolerance_of(item))}"
    return f"<p><b>{markup(item.name)}</b>{markup(unit)}: {markup(meaning)} ({markup(asked)})</p>"


def answers_of(book: Keybook, key: Key, at: int, rules: Rules) -> Iterator[str]:
    """The answers of a question, in the order in which they are tried."""
    item, right = book.items[at], key.values[at]
    within, plans = _allowed(item, right), max(item.plans * abs(right), item.within)
    for value in rights(item, right):
        yield _answer(value, 100.0, within, tr("Right."))
    if plans > within and rules.for_plans:
        for value in rights(item, right):
            yield _answer(value, elements.grade(rules.for_plans), plans, tr("Right within the accuracy of plans."))
    for wrong in wrongs_of(book, key, at):
        yield _answer(wrong.value, 0.0, wrong.within, "<br>".join(markup(hint) for hint in wrong.hints))
    yield _answer("*", 0.0, 0.0, "")


def rights(item: Item, right: float) -> Iterator[float]:
    """All values that count as right: of the other sign too where that is left open, of angles a whole turn aside."""
    turn = conversion("rev", item.unit) if kind_of(item.unit) == "angle" else 0.0
    for value in dict.fromkeys((right, -right) if item.either_sense else (right,)):
        yield from (value, value - turn, value + turn) if turn else (value,)


def wrongs_of(book: Keybook, key: Key, at: int) -> list[Wrong]:
    """What comes out with known mistakes, but near to what is right, or right by plans; those that are alike as one."""
    item = book.items[at]
    taken = max(item.plans * abs(key.values[at]), _allowed(item, key.values[at]))
    found: list[Wrong] = []
    for told, values in zip(book.mistakes, key.mistaken, strict=True):
        value, hint = values[at], tr_name(told.hint)
        if not math.isfinite(value):
            continue
        within = _allowed(item, value)
        if any(abs(value - right) <= taken + within for right in rights(item, key.values[at])):
            continue
        for k, other in enumerate(found):
            if abs(value - other.value) <= max(within, other.within):
                if hint not in other.hints and len(other.hints) < HINTS:
                    found[k] = Wrong(other.value, other.within, (*other.hints, hint))
                break
        else:
            found.append(Wrong(value, within, (hint,)))
    return found


def units_of(unit: str) -> list[tuple[str, float]]:
    """All units in which an answer may be, the asked one first, with how many of each make one of that."""
    kind = kind_of(unit)
    if kind is None:
        return []
    found: dict[str, float] = {}
    for each in (unit, *UNITS[kind]):
        for spelled in (each, tr_unit(each)):
            typed = _begun(spelled.translate(KEYS))
            for either in (typed, typed.replace("^2", "²").replace("^3", "³").replace("*", "·")):
                found.setdefault(either, float(f"{conversion(unit, each):.12g}"))
    return [*found.items()]


def _begun(unit: str) -> str:
    """A unit that begins with no digit, which would be read as one of the number before it.

    >>> _begun("1/min"), _begun("1/s^2"), _begun("mm")
    ('min^-1', 's^-2', 'mm')
    """
    if not unit.startswith("1/"):
        return unit
    name, _, power = unit.removeprefix("1/").partition("^")
    return f"{name}^-{power or 1}"


def _allowed(item: Item, value: float) -> float:
    return max(item.tolerance * abs(value), item.within)


def _answer(value: float | str, part: float, within: float, feedback: str) -> str:
    text = value if isinstance(value, str) else elements.shown(float(f"{value:.10g}"))
    tolerance = elements.element("tolerance", elements.shown(float(f"{within:.6g}")))
    return elements.answer(text, part, feedback, tolerance)
