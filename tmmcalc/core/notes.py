"""Sentences of results for people, which hold apart what programs ask for: notes and warnings, texts with values."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from math import pi
from string import Formatter
from typing import Any

FORM = re.compile(r":[^{}]*\}")  # of a number in a text with its digits
LEVELS = ("note", "warning")
SHOWN = {  # units of the data and of sentences, with the factor between them
    ("m", "mm"): 1e3,
    ("m/s", "m/min"): 60.0,
    ("Pa", "MPa"): 1e-6,
    ("rad", "deg"): 180 / pi,
    ("rad/s", "rpm"): 30 / pi,
}


class Note(str):
    """The sentence ``level: place: text``; ``value`` and ``limit`` are the numbers that it is about, in one unit.

    ``name`` is that of the quantity which has the value.

    >>> weak = Note("warning", "transmission angle 12 deg, below 20 deg", "group RRR(2,3)", 12.0, 20.0, "deg", "mu")
    >>> print(weak)
    warning: group RRR(2,3): transmission angle 12 deg, below 20 deg
    >>> finding(weak)["value[deg]"]
    12.0
    """

    def __new__(
        cls,
        level: str,
        text: str,
        place: str = "",
        value: float | None = None,
        limit: float | None = None,
        unit: str | None = None,
        name: str = "",
    ) -> Note:
        """Make the sentence; without a place or numbers it has none."""
        made = super().__new__(cls, f"{level}: {place}: {text}" if place else f"{level}: {text}")
        made.level, made.text, made.place = level, text, place
        made.value, made.limit, made.unit, made.name = value, limit, unit or "", name
        return made

    level: str
    text: str
    place: str
    value: float | None
    limit: float | None
    unit: str
    name: str

    def __getnewargs__(self) -> tuple[Any, ...]:
        """What it is made of, for other processes."""
        return self.level, self.text, self.place, self.value, self.limit, self.unit, self.name

    def within(self, place: str) -> Note:
        """The same note of a thing in a ``place``."""
        level, text, own, *numbers = self.__getnewargs__()
        return Note(level, text, f"{place}: {own}" if own else place, *numbers)

    def stored(self) -> dict[str, Any]:
        """What it is made of, by name; parts that it has not are left out."""
        parts = zip(("level", "text", "place", "value", "limit", "unit", "name"), self.__getnewargs__(), strict=True)
        kept = {key: part for key, part in parts if part not in (None, "")}
        return {key: part.stored() if isinstance(part, Phrase) else part for key, part in kept.items()}


Said = Note | str  # in a result: a sentence, with its numbers or without


class Phrase(str):
    """A text with ``{name}`` for each of its values, by which another language says it; several are parted by commas.

    >>> Phrase("no mesh has {ratio}: {lines}", ratio="1.2", lines=("tip", "root"))
    'no mesh has 1.2: tip, root'
    """

    def __new__(cls, template: str, **values: str | Sequence[str]) -> Phrase:
        """Make the text."""
        texts = {name: each if isinstance(each, str) else ", ".join(each) for name, each in values.items()}
        made = super().__new__(cls, template.format(**texts))
        made.template, made.values = template, values
        return made

    template: str
    values: Mapping[str, str | Sequence[str]]

    def __getnewargs_ex__(self) -> tuple[tuple[str], Mapping[str, str | Sequence[str]]]:
        """What it is made of, for other processes."""
        return (self.template,), self.values

    def stored(self) -> dict[str, Any]:
        """What it is made of, by name."""
        return {"template": self.template, **self.values}


def restored(kind: type[Note] | type[Phrase], data: str | dict[str, Any]) -> Note | Phrase | str:
    """The note or phrase that its ``stored`` gave; a sentence is what it was.

    >>> restored(Note, Note("note", "two", value=2.0).stored())
    'note: two'
    """
    if not isinstance(data, dict):
        return data
    parts: dict[str, Any] = {key: Phrase(**part) if isinstance(part, dict) else part for key, part in data.items()}
    return kind(**parts)


def held(
    level: str,
    text: str,
    value: float,
    limit: float,
    unit: str = "",
    *,
    name: str,
    shown: str = "",
    place: str = "",
    **words: Any,
) -> Note:
    """A note on the quantity ``name`` held against a ``limit``, both in ``unit``.

    ``text`` has both as ``{value:.4g}`` and ``{limit:g}``, in the digits and in the unit that people are ``shown``, and
    the other ``words``.

    >>> print(held("warning", "h = {value:.3g} mm is above {limit:g} mm", 0.002, 0.001, "m", shown="mm", name="h"))
    warning: h = 2 mm is above 1 mm
    """
    value, limit = float(value), float(limit)
    factor = SHOWN[unit, shown] if shown else 1.0
    numbers = {"value": factor * value, "limit": factor * limit, "unit": shown or unit, **words}
    return Note(level, _phrase(text, numbers), place, value, limit, unit, name)


def _phrase(text: str, numbers: Mapping[str, Any]) -> Phrase | str:
    """The text with its numbers as they are told; a plain one where a number stands twice in different digits."""
    forms: dict[str, str] = {}
    for _, key, form, _ in Formatter().parse(text):
        if key is not None and forms.setdefault(key, form or "") != (form or ""):
            return text.format(**numbers)
    if "template" in forms:
        return text.format(**numbers)
    template = FORM.sub("}", text)
    return Phrase(template, **{key: format(numbers[key], form) for key, form in forms.items()})


def finding(note: str) -> dict[str, Any]:
    """A note as data: level, place, name of its quantity, value, limit and text, those that it has.

    >>> finding("warning: the ties yield")
    {'level': 'warning', 'text': 'the ties yield'}
    """
    if isinstance(note, Note):
        unit = f"[{note.unit}]" if note.unit else ""
        told = {
            "place": note.place or None,
            "name": note.name or None,
            f"value{unit}": note.value,
            f"limit{unit}": note.limit,
        }
        return {"level": note.level, **{k: v for k, v in told.items() if v is not None}, "text": note.text}
    level, _, text = note.partition(": ")
    return {"level": level, "text": text} if level in LEVELS else {"level": "note", "text": note}
