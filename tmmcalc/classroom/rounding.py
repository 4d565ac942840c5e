"""What is zero but for rounding: beside the largest of its own column, or of all that its stage tells in its unit.

The last digits of such a value are those of a machine, no student can find them, and no other machine does.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite
from typing import Any

from tmmcalc.naming.language import parse
from tmmcalc.naming.told import Extent, Told, listed

OF_COLUMN = 1e-9  # of its largest value
OF_STAGE = 1e-13  # of the largest of all in this unit; of numbers without a unit nothing is known


class Floors:
    """The magnitudes up to which quantities of some results stand for zero."""

    def __init__(self, results: Mapping[str, Any]) -> None:
        self._results = results
        self._sizes: dict[str, tuple[dict[str, float], dict[str, float]]] = {}

    def of(self, found: Told) -> float:
        """That of a quantity, in its unit."""
        if found.stage not in self._sizes:
            self._sizes[found.stage] = _sizes(found.stage, self._results[found.stage])
        columns, units = self._sizes[found.stage]
        own = columns.get(parse(f"{found.stage}.{found.quantity}").what, 0.0)
        return max(OF_COLUMN * own, OF_STAGE * units.get(found.unit, 0.0) if found.unit else 0.0)

    def settled(self, found: Told) -> float:
        """Its value, zero where it is one but for rounding."""
        return settled(found.value, self.of(found))


def settled(value: float, floor: float) -> float:
    """The value, or zero where it is not above the magnitude that stands for it."""
    return 0.0 if abs(value) <= floor else value


def _sizes(stage: str, result: Any) -> tuple[dict[str, float], dict[str, float]]:
    """The largest magnitudes in the columns of a stage, and among all that it tells in a unit."""
    columns, units = dict[str, float](), dict[str, float]()
    for each in listed(stage, result):
        ends = (each.least, each.greatest) if isinstance(each, Extent) else (each.value,)
        size = max((abs(end) for end in ends if isfinite(end)), default=0.0)
        units[each.unit] = max(units.get(each.unit, 0.0), size)
        if isinstance(each, Extent):
            columns[each.quantity] = size
    return columns, units
