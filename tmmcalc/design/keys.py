"""The numbers of a spec by their keys, and how large a change of each is an ordinary one."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from typing import Any

from tmmcalc.batch.task import Task
from tmmcalc.core.errors import SpecError, TmmError, UsageError
from tmmcalc.naming.language import WILD, like, near
from tmmcalc.spec.units import dimension_of
from tmmcalc.spec.units import parse as in_si
from tmmcalc.spec.variants import Axis, given

# Tables that say what is made of results, or held against them: no result depends on them.
NO_DATA = frozenset({"project", "note", "sheets", "constraints", "feasibility", "tolerances", "optimize"})
SMALL = 1e-3  # of the largest of its kind: a number that is smaller is changed as if it were that large
NOTHING = 0.1  # of the largest of its kind: as if it were that large a number that is 0 is changed
_BARE = re.compile(r"[A-Za-z0-9_-]+")
_NUMBERED = ("id", "name")  # keys by which elements of lists are told apart


def keys_of(data: dict[str, Any]) -> list[str]:
    """The keys of all numbers in a document, with units or without, as an override writes them."""
    return [key for table, value in data.items() if table not in NO_DATA for key in _keys(_bare(table), value, data)]


def chosen(data: dict[str, Any], patterns: Sequence[str]) -> list[str]:
    """The keys that patterns name, each once; those with wildcards ``*`` and ``?`` among all numbers of a document.

    Raises UsageError for a pattern that names none.
    """
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
            raise UsageError(f"no number of the spec has a key {pattern!r}", where="--to", remedy=remedy)
        found.update(dict.fromkeys(own))
    return [*found]


def scales(axes: Sequence[Axis]) -> list[float]:
    """An ordinary size of each value, in its unit: its own, or of one near 0 a part of the largest of its kind."""
    largest: dict[str, float] = {}
    sizes = [_in_si(axis) for axis in axes]
    for kind, unit, value in sizes:
        largest[kind] = max(largest.get(kind, 0.0), abs(value) * unit)
    return [max(abs(value), (SMALL if value else NOTHING) * largest[kind] / unit) or 1.0 for kind, unit, value in sizes]


def varied(task: Task, sizes: Sequence[float]) -> list[str]:
    """Why each key of a task of one point cannot be varied, by a small step of its size; empty where it can."""
    variants, values = task.variants(), task.values(0)
    reasons = []
    for k, (axis, size) in enumerate(zip(task.axes, sizes, strict=True)):
        errors = []
        for step in (1e-3 * size, -1e-3 * size):
            try:
                variants.spec([axis.assignment(values[k] + step)])
                break
            except TmmError as error:
                errors.append(error.faults[0].message if isinstance(error, SpecError) else error.message)
        reasons.append(errors[0] if len(errors) == 2 else "")
    return reasons


def _keys(path: str, value: Any, data: dict[str, Any]) -> Iterator[str]:
    if isinstance(value, dict):
        for key, part in value.items():
            yield from _keys(f"{path}.{_bare(key)}", part, data)
    elif isinstance(value, list):
        for place, part in zip(_places(value), value, strict=True):
            yield from _keys(f"{path}[{place}]", part, data)
    elif not isinstance(value, bool):
        try:
            given(path, data)
        except UsageError:
            return
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


def _in_si(axis: Axis) -> tuple[str, float, float]:
    """Kind of a quantity, its unit in SI, its value in its unit."""
    unit, value = axis.unit or axis.si, axis.values[0]
    dimension = dimension_of(f"1 {unit}") if unit else None
    if dimension is None:
        return unit, 1.0, value
    return dimension, in_si(f"1 {unit}", dimension), value
