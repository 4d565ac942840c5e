"""Places of values in a spec: paths into its tables, and the spec with another value there."""

from __future__ import annotations

import copy
import re
from collections.abc import Iterator
from typing import Any

Steps = tuple[str | int, ...]
_NUMBER = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(.*)", re.DOTALL)


def leaves(value: Any, path: Steps = ()) -> Iterator[tuple[Steps, Any]]:
    """All values that are no tables or lists, with their paths."""
    if isinstance(value, dict | list):
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            yield from leaves(inner, (*path, key))
    else:
        yield path, value


def branches(value: Any, path: Steps = ()) -> Iterator[Steps]:
    """Paths of all values, of tables and lists too, but for the root."""
    if path:
        yield path
    if isinstance(value, dict | list):
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            yield from branches(inner, (*path, key))


def numeric(value: Any) -> bool:
    """Whether a value is a number, or a string of a number with its unit."""
    if isinstance(value, str):
        return _NUMBER.fullmatch(value) is not None
    return isinstance(value, int | float) and not isinstance(value, bool)


def times(value: Any, factor: float) -> Any:
    """A numeric value times a factor, in its own unit; an integer stays one if it can."""
    if isinstance(value, str):
        found = _NUMBER.fullmatch(value)
        assert found is not None
        return f"{float(found[1]) * factor!r}{found[2]}"
    product = value * factor if abs(value) < 1e300 else value
    return int(product) if isinstance(value, int) and product == int(product) else product


def valued(value: Any, number: float) -> Any:
    """Another number with the unit of a numeric value; an integer of an integer."""
    if isinstance(value, str):
        found = _NUMBER.fullmatch(value)
        assert found is not None
        return f"{number!r}{found[2]}"
    return int(number) if isinstance(value, int) and number == number and abs(number) < 1e300 else number


def replaced(document: dict[str, Any], path: Steps, value: Any) -> dict[str, Any]:
    """A copy of the document with a value in the place of another."""
    changed = copy.deepcopy(document)
    holder: Any = changed
    for step in path[:-1]:
        holder = holder[step]
    holder[path[-1]] = value
    return changed


def removed(document: dict[str, Any], path: Steps) -> dict[str, Any]:
    """A copy of the document without a value."""
    changed = copy.deepcopy(document)
    holder: Any = changed
    for step in path[:-1]:
        holder = holder[step]
    del holder[path[-1]]
    return changed


def pattern(path: Steps) -> str:
    """A path without the numbers in lists."""
    return ".".join("[]" if isinstance(step, int) else step for step in path)
