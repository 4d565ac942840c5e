"""Sentences of results for people, which hold apart what programs ask for: notes and warnings, texts with values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache
from math import pi
from string import Formatter
from typing import Any

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
        return Note(level, text, listed((place, own), ": ") if own else place, *numbers)

    def stored(self) -> dict[str, Any]:
        """What it is made of, by name; parts that it has not are left out."""
        parts = zip(("level", "text", "place", "value", "limit", "unit", "name"), self.__getnewargs__(), strict=True)
        return {key: part for key, part in parts if part not in (None, "")}


Said = Note | str  # in a result: a sentence, with its numbers or without


class Phrase(str):
    """A text with ``{name}`` for each of its values, by which another language says it; several are parted by commas.

    A number is written as its place asks, ``{name:.3g}``; then the template has the place alone, and the value is what
    was written. A value may be a phrase.

    >>> Phrase("no mesh has {ratio:.3g}: {lines}", ratio=1.2, lines=("tip", "root"))
    'no mesh has 1.2: tip, root'
    """

    def __new__(cls, template: str, **values: Any) -> Phrase:
        """Make the text; values that it has no place for are left out."""
        bare, places = _places(template)
        told = {name: _told(values[name], written) for name, written in places.items()}
        made = super().__new__(
            cls, bare.format_map({k: each if isinstance(each, str) else ", ".join(each) for k, each in told.items()})
        )
        made.template, made.values = bare, told
        return made

    template: str
    values: Mapping[str, str | Sequence[str]]

    def __getnewargs_ex__(self) -> tuple[tuple[str], Mapping[str, str | Sequence[str]]]:
        """What it is made of, for other processes."""
        return (self.template,), self.values

    def stored(self) -> dict[str, Any]:
        """What it is made of, by name."""
        return {"template": self.template, **{name: _stored(each) for name, each in self.values.items()}}


@cache
def _places(template: str) -> tuple[str, Mapping[str, str]]:
    """A template without the forms of its numbers, and these forms by the names of the places."""
    bare, places = "", {}
    for text, name, written, _ in Formatter().parse(template):
        bare += text.replace("{", "{{").replace("}", "}}")
        if name is not None:
            bare += f"{{{name}}}"
            places[name] = written or ""
    return bare, places


def _told(value: Any, written: str) -> str | Sequence[str]:
    if isinstance(value, str):
        return value
    if isinstance(value, Sequence):
        return tuple(each if isinstance(each, str) else str(each) for each in value)
    return format(value, written)


def _stored(value: str | Sequence[str]) -> Any:
    if isinstance(value, Phrase):
        return value.stored()
    return value if isinstance(value, str) else [_stored(each) for each in value]


def listed(parts: Sequence[str], between: str) -> str:
    """Several phrases as one, with what stands ``between`` two of them; a single one is itself, none is empty.

    >>> listed(("30 deg", "40 deg"), " to ").template, listed(("30 deg", "40 deg", "50 deg"), " or ")
    ('{one} to {other}', '30 deg or 40 deg or 50 deg')
    """
    if not parts:
        return ""
    *before, last = parts
    return Phrase(f"{{one}}{between}{{other}}", one=listed(before, between), other=last) if before else last


def restored(kind: type[Note] | type[Phrase], data: str | dict[str, Any]) -> Note | Phrase | str:
    """The note or phrase that its ``stored`` gave; a sentence is what it was.

    >>> restored(Note, Note("note", "two", value=2.0).stored())
    'note: two'
    """
    return kind(**{name: _restored(part) for name, part in data.items()}) if isinstance(data, dict) else data


def _restored(part: Any) -> Any:
    if isinstance(part, list):
        return [_restored(each) for each in part]
    return restored(Phrase, part) if isinstance(part, dict) else part


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
    the other ``words``, as a `Phrase` has them.

    >>> print(held("warning", "h = {value:.3g} mm is above {limit:g} mm", 0.002, 0.001, "m", shown="mm", name="h"))
    warning: h = 2 mm is above 1 mm
    """
    value, limit = float(value), float(limit)
    factor = SHOWN[unit, shown] if shown else 1.0
    said = Phrase(text, value=factor * value, limit=factor * limit, unit=shown or unit, **words)
    return Note(level, said, place, value, limit, unit, name)


def graded(note: str) -> tuple[str, str]:
    """Level of a note, and its place and text; a text without a level is a ``note``.

    >>> graded(Phrase("warning: {count} ties yield", count=2))
    ('warning', '2 ties yield')
    """
    if isinstance(note, Note):
        return note.level, listed((note.place, note.text), ": ") if note.place else note.text
    level, colon, text = note.partition(": ")
    if not colon or level not in LEVELS:
        return "note", note
    if isinstance(note, Phrase):
        return level, Phrase(note.template.removeprefix(f"{level}: "), **note.values)
    return level, text


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
    level, text = graded(note)
    return {"level": level, "text": text}
