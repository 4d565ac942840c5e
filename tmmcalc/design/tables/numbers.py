"""The numbers of a document by their keys, and wildcards among them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from tmmcalc.core.errors import UsageError
from tmmcalc.spec.outline import Raw
from tmmcalc.spec.units import dimension_of
from tmmcalc.spec.variants import given

LABELS = ("id", "name")  # keys that tell elements of a list apart


def numbers(document: Raw) -> list[str]:
    """Keys of all numbers, as overrides write them, but those of the tolerances themselves.

    >>> numbers({"mechanism": {"links": [{"id": 1, "points": {"A": ["200 mm", 0]}}]}, "project": {"title": "x"}})
    ['mechanism.links[id=1].points.A[0]', 'mechanism.links[id=1].points.A[1]']
    """
    return [key for name, value in document.items() if name != "tolerances" for key in _within(name, value)]


def _within(key: str, value: Any) -> Iterator[str]:
    if isinstance(value, dict):
        for name, inner in value.items():
            if name not in LABELS:
                yield from _within(f"{key}.{name}", inner)
    elif isinstance(value, list):
        for at, inner in enumerate(value):
            yield from _within(f"{key}[{_label(inner, at, value)}]", inner)
    elif (isinstance(value, int | float) and not isinstance(value, bool)) or dimension_of(value) is not None:
        yield key


def _label(element: Any, at: int, of: list[Any]) -> str:
    """What tells an element of a list: its id or name where it is the only one, else its index."""
    for label in LABELS if isinstance(element, dict) else ():
        told = element.get(label)
        if isinstance(told, int | str) and [each.get(label) for each in of if isinstance(each, dict)].count(told) == 1:
            return f"{label}={told}"
    return str(at)


def is_wild(key: str) -> bool:
    """Whether a key stands for several."""
    return "*" in key or "?" in key


def matching(key: str, document: Raw) -> list[str]:
    """The keys that one stands for: itself if it holds a number, or those that its wildcards match.

    Raises UsageError where that is none.
    """
    if not is_wild(key):
        given(key, document)
        return [key]
    rule = re.compile("".join({"*": ".*", "?": "."}.get(each, re.escape(each)) for each in key))
    found = [each for each in numbers(document) if rule.fullmatch(each)]
    if not found:
        remedy = "keys are those of --set, e.g. mechanism.links[id=1].points.A[0]"
        raise UsageError(f"{key} matches no number of the spec", where="tolerances", remedy=remedy)
    return found
