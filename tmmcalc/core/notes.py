"""Notes and warnings of documents: sentences for people, which hold apart what programs ask for."""

from __future__ import annotations

from typing import Any

LEVELS = ("note", "warning")


class Note(str):
    """The sentence ``level: place: text``; ``value`` and ``limit`` are the numbers that it is about, in one unit.

    >>> weak = Note("warning", "transmission angle 12 deg, below 20 deg", "group RRR(2,3)", 12.0, 20.0, "deg")
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
    ) -> Note:
        """Make the sentence; without a place or numbers it has none."""
        made = super().__new__(cls, f"{level}: {place}: {text}" if place else f"{level}: {text}")
        made.level, made.text, made.place = level, text, place
        made.value, made.limit, made.unit = value, limit, unit or ""
        return made

    level: str
    text: str
    place: str
    value: float | None
    limit: float | None
    unit: str

    def __getnewargs__(self) -> tuple[Any, ...]:
        """What it is made of, for other processes."""
        return self.level, self.text, self.place, self.value, self.limit, self.unit


def finding(note: str) -> dict[str, Any]:
    """A note as data: level, place, value, limit and text, those that it has.

    >>> finding("warning: the ties yield")
    {'level': 'warning', 'text': 'the ties yield'}
    """
    if isinstance(note, Note):
        unit = f"[{note.unit}]" if note.unit else ""
        told = {"place": note.place or None, f"value{unit}": note.value, f"limit{unit}": note.limit}
        return {"level": note.level, **{k: v for k, v in told.items() if v is not None}, "text": note.text}
    level, _, text = note.partition(": ")
    return {"level": level, "text": text} if level in LEVELS else {"level": "note", "text": note}
