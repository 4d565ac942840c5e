"""Variants of a spec: ranges of its numeric values, and the grid that they span.

    mechanism.links[id=3].mass=10:20:11                 11 values in equal steps from 10 to 20, both included
    mechanism.crank.speed=50 rpm:70 rpm:5               the same with a unit
    mechanism.links[id=1].points.A[0]=*0.9:1.1:21       the value of the spec times 0.9 to 1.1
    flywheel.unevenness=0.02,0.03                       these values

A key is written as in an override; a variant is one override for every key.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from itertools import product
from typing import Any

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.spec.override import split, value_at
from tmmcalc.spec.phrases import show

MOST = 1_000_000  # values of one range: more is a slip of the pen
_QUANTITY = re.compile(r"([+-]?(?:\d++(?:\.\d*+)?|\.\d++)(?:[eE][+-]?\d++)?)\s*+([^:\"']*+)", re.ASCII)


@record
class Axis:
    """One key and the values that it takes, as numbers in ``unit`` (empty: as the bare numbers of a spec)."""

    key: str
    values: tuple[float, ...]
    unit: str = ""
    si: str = ""  # unit of bare numbers, where it is known

    @property
    def name(self) -> str:
        """Header of a column of its values: ``mechanism.crank.speed[rpm]``."""
        unit = self.unit or self.si
        return f"{self.key}[{unit}]" if unit else self.key

    def assignment(self, value: float) -> str:
        """The override that sets the key to ``value``."""
        return f'{self.key}="{self.number(value)} {self.unit}"' if self.unit else f"{self.key}={self.number(value)}"

    @staticmethod
    def number(value: float) -> str:
        """The value as the override has it: whole numbers without a point."""
        return repr(int(value)) if value == int(value) and abs(value) < 2**53 else repr(value)


def is_range(assignment: str) -> bool:
    """Whether an assignment gives several values and is no plain override.

    >>> is_range("loads[0].factor=1:2:3"), is_range('flywheel.material="steel"'), is_range("a.b=[1, 2]")
    (True, False, False)
    """
    _, text = split(assignment)
    return _parts(text, assignment) is not None


def axis(assignment: str, data: dict[str, Any]) -> Axis:
    """Read ``KEY=FROM:TO:COUNT``, ``KEY=*FROM:TO:COUNT`` or ``KEY=A,B,C``; ``data`` is the document it refers to.

    Raises UsageError for what is none, for ends of different units, and for a factor on what is no number.
    """
    key, text = split(assignment)
    parts = _parts(text, assignment)
    if parts is None:
        raise _refusal(assignment, f"{show(text)} is no range", "write FROM:TO:COUNT, e.g. 0.9:1.1:21, or A,B,C")
    values, unit = parts
    if text.startswith("*"):
        base, unit = _quantity(value_at(data, assignment), assignment)
        values = tuple(base * factor for factor in values)
    if not all(map(math.isfinite, values)):
        raise _refusal(assignment, "a number too large", "write numbers below 1e308")
    return Axis(key, values, unit)


def given(key: str, data: dict[str, Any]) -> tuple[float, str]:
    """Number and unit of what a document holds at a key; raises UsageError if that is no number, or nothing.

    >>> given("motor.power", {"motor": {"power": "2 kW"}})
    (2.0, 'kW')
    """
    assignment = f"{key}=0"
    value = value_at(data, assignment)
    number = _number(value)
    if number is None:
        raise _refusal(assignment, f"{show(value)} is no number", "name a key that holds one")
    return number


def is_number(value: object) -> bool:
    """Whether a value of a document is a number, or the text of one with what may be its unit.

    >>> is_number("2 kW"), is_number(True), is_number("steel")
    (True, False, False)
    """
    if isinstance(value, str):
        return _read(value) is not None
    return isinstance(value, int | float) and not isinstance(value, bool)


def grid(axes: Sequence[Axis]) -> Iterator[tuple[float, ...]]:
    """Every point of the grid, one value an axis; the last axis runs fastest.

    >>> list(grid([Axis("a", (1.0, 2.0)), Axis("b", (5.0, 6.0))]))
    [(1.0, 5.0), (1.0, 6.0), (2.0, 5.0), (2.0, 6.0)]
    """
    return product(*(each.values for each in axes))


def count(axes: Sequence[Axis]) -> int:
    """Points of the grid."""
    return math.prod(len(each.values) for each in axes)


def _parts(text: str, assignment: str) -> tuple[tuple[float, ...], str] | None:
    """Values and unit of a range, None for a plain value."""
    body = text.removeprefix("*")
    if body.startswith(("[", "{")):
        return None
    if body.count(":") == 2:
        low, high, number = body.split(":")
        return _steps(low, high, number, assignment)
    listed = [_read(item) for item in body.split(",")]
    if len(listed) < 2 or not all(listed):
        return None
    numbers, units = zip(*(match.groups() for match in listed if match), strict=True)
    return tuple(map(float, numbers)), _one_unit(units, assignment)


def _read(text: str) -> re.Match[str] | None:
    """Number and unit of a text, with quotes or without."""
    text = text.strip()
    text = text[1:].lstrip() if text[:1] in ("'", '"') else text
    return _QUANTITY.fullmatch(text[:-1].rstrip() if text[-1:] in ("'", '"') else text)


def _steps(low: str, high: str, number: str, assignment: str) -> tuple[tuple[float, ...], str] | None:
    first, last = _read(low), _read(high)
    if not (first and last):
        return None
    steps = number.strip()
    if not (steps.isdecimal() and len(steps) < 10) or not 2 <= int(steps) <= MOST:
        raise _refusal(assignment, f"{show(number)} values", f"the count is a whole number from 2 to {MOST}")
    unit = _one_unit((first.group(2), last.group(2)), assignment)
    a, b, n = float(first.group(1)), float(last.group(1)), int(number) - 1
    # both ends exactly, and equal steps told as a person would write them
    return tuple(float(f"{a + (b - a) * i / n:.15g}") if 0 < i < n else (b if i else a) for i in range(n + 1)), unit


def _one_unit(units: Sequence[str], assignment: str) -> str:
    if len(set(units)) > 1:
        told = " and ".join(show(unit) for unit in dict.fromkeys(units))
        raise _refusal(assignment, f"different units: {told}", "write all values in one unit")
    return units[0]


def _quantity(value: object, assignment: str) -> tuple[float, str]:
    """Number and unit of a value of the spec that is to be multiplied."""
    number = _number(value)
    if number is None:
        rule = f"{show(value)} is no number that could be multiplied"
        raise _refusal(assignment, rule, "write the values themselves")
    return number


def _number(value: object) -> tuple[float, str] | None:
    """Number and unit of a value of the spec, None if it is none."""
    match = _read(value) if isinstance(value, str) else None
    if match:
        return float(match.group(1)), match.group(2)
    if isinstance(value, int | float) and not isinstance(value, bool):
        return float(value), ""
    return None


def _refusal(assignment: str, message: str, remedy: str) -> UsageError:
    return UsageError(message, where=f"range {show(assignment)}", remedy=remedy)
