"""Phrases in the stored form of a result: each stands there as its sentence, what it is made of in a list of its own.

So a file tells people the same sentences with the list and without it, and a result that comes back from a file of an
earlier version has sentences in place of its phrases.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from tmmcalc.core.notes import Phrase, restored
from tmmcalc.core.stored import Record

KEY = "sentences"  # of the list among the scalars


def parted(record: Record) -> Record:
    """The record with sentences in place of its phrases, and what these are made of beside them."""
    found: dict[str, Phrase] = {}

    def bare(text: str) -> str:
        if not isinstance(text, Phrase):
            return text
        sentence = str.__str__(text)
        found[sentence] = text
        return sentence

    scalars = _each(record.scalars, bare)
    if not found:
        return record
    return replace(record, scalars={**scalars, KEY: [each.stored() for each in found.values()]})


def rejoined(record: Record) -> Record:
    """The record that `parted` took its phrases of."""
    if KEY not in record.scalars:
        return record
    scalars = dict(record.scalars)
    found = {str(each): each for each in (restored(Phrase, data) for data in scalars.pop(KEY))}
    return replace(record, scalars=_each(scalars, lambda text: found.get(text, text)))


def _each(value: Any, change: Callable[[str], str]) -> Any:
    """Nested plain values with every text changed."""
    if isinstance(value, str):
        return change(value)
    if isinstance(value, dict):
        return {key: _each(part, change) for key, part in value.items()}
    return [_each(part, change) for part in value] if isinstance(value, list) else value
