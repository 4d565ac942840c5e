"""Notes and warnings of documents: sentences for people, which hold apart what programs ask for."""

from __future__ import annotations

from typing import Any

LEVELS = ("note", "warning")


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

    def stored(self) -> str | dict[str, Any]:
        """What `restored` takes: the sentence alone if it has neither place nor numbers."""
        if self.value is None and self.limit is None and not self.place:
            return str(self)
        parts = zip(("level", "text", "place", "value", "limit", "unit", "name"), self.__getnewargs__(), strict=True)
        return {key: part for key, part in parts if part not in (None, "")}


Said = Note | str  # in a result: a sentence, with its numbers or without


def restored(data: str | dict[str, Any]) -> Any:
    """The note that `Note.stored` gave; a sentence without a level stays one.

    >>> restored(Note("note", "two", value=2.0).stored()).value
    2.0
    """
    if isinstance(data, dict):
        return Note(**data)
    level, colon, text = data.partition(": ")
    return Note(level, text) if colon and level in LEVELS else data


def held(
    level: str, text: str, value: float, limit: float, unit: str = "", *, name: str, place: str = "", **words: Any
) -> Note:
    """A note on the quantity ``name`` held against a ``limit``, both in ``unit``.

    ``text`` has both as ``{value:.4g}`` and ``{limit:g}``, in the digits that people are shown, ``{unit}``, and the
    other ``words``.

    >>> print(held("warning", "h/r = {value:.3g} is above {limit:g} in the {part}", 0.2, 0.1, name="h/r", part="ring"))
    warning: h/r = 0.2 is above 0.1 in the ring
    """
    value, limit = float(value), float(limit)
    return Note(level, text.format(value=value, limit=limit, unit=unit, **words), place, value, limit, unit, name)


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
