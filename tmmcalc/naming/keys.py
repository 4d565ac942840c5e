"""The numbers of a spec by their keys, as an override writes them, and wildcards among them."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from typing import Any

from tmmcalc.core.errors import UsageError
from tmmcalc.naming.language import WILD, like, near
from tmmcalc.spec.variants import given, is_number

# Tables that say what is made of results, or held against them: no result depends on them.
NO_DATA = frozenset({"project", "note", "sheets", "constraints", "feasibility", "tolerances", "optimize", "class"})
_BARE = re.compile(r"[A-Za-z0-9_-]+")
_NUMBERED = ("id", "name")  # keys by which elements of lists are told apart


def keys_of(data: dict[str, Any]) -> list[str]:
    """The keys of all quantities in a document, with units or without; a number that names an element is none.

    >>> keys_of({"mechanism": {"links": [{"id": 1, "points": {"A": ["200 mm", 0]}}]}, "project": {"title": "x"}})
    ['mechanism.links[id=1].points.A[0]', 'mechanism.links[id=1].points.A[1]']
    """
    return [key for table, value in data.items() if table not in NO_DATA for key in _keys(_bare(table), value)]


def chosen(data: dict[str, Any], patterns: Sequence[str], where: str = "--to") -> list[str]:
    """The keys that patterns name, each once; those with wildcards ``*`` and ``?`` among all numbers of a document.

    Without patterns these are all its numbers. Raises UsageError for a pattern that names none.
    """
    if not patterns:
        return keys_of(data)
    found: dict[str, None] = {}
    for pattern in patterns:
        if WILD.isdisjoint(pattern):
            given(pattern, data)
            found[pattern] = None
            continue
        every = keys_of(data)
        own = [key for key in every if like(key, pattern)]
        if not own:
            remedy = near(pattern, every, "keys")
            raise UsageError(f"no number of the spec has a key {pattern!r}", where=where, remedy=remedy)
        found.update(dict.fromkeys(own))
    return [*found]


def _keys(path: str, value: Any) -> Iterator[str]:
    if isinstance(value, dict):
        for key, part in value.items():
            if key not in _NUMBERED:
                yield from _keys(f"{path}.{_bare(key)}", part)
    elif isinstance(value, list):
        for place, part in zip(_places(value), value, strict=True):
            yield from _keys(f"{path}[{place}]", part)
    elif is_number(value):
        yield path


def _places(items: Sequence[Any]) -> list[str]:
    """What stands in brackets for each element: its number or name where these tell all apart, else its index."""
    for key in _NUMBERED:
        own = [item.get(key) if isinstance(item, dict) else None for item in items]
        words = [str(each) if isinstance(each, int) else _bare(each) for each in own if isinstance(each, int | str)]
        if len(words) == len({*words}) == len(items):
            return [f"{key}={word}" for word in words]
    return [str(at) for at in range(len(items))]


def _bare(word: str) -> str:
    return word if _BARE.fullmatch(word) else json.dumps(word, ensure_ascii=False)
