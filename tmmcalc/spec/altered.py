"""Values of a document that are changed by a factor or an amount, whatever they are written as."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmmcalc.spec.units import UnitError, dimension_of, parse


def bare(value: Any) -> float | None:
    """A quantity in SI; None of what is none, as a name.

    >>> bare("290 mm"), bare(3), bare("motor")
    (0.29, 3.0, None)
    """
    if isinstance(value, bool):
        return None
    if isinstance(value, int | float):
        return float(value)
    dimension = dimension_of(value)
    try:
        return None if dimension is None else parse(value, dimension)
    except UnitError:
        return None


def changed(value: Any, change: Callable[[float], float]) -> Any:
    """A quantity changed, as a bare number in SI; pairs and lists by their parts, what is no quantity as it is.

    >>> changed(["75 mm", 0], lambda x: 2 * x), changed("motor", abs)
    ([0.15, 0.0], 'motor')
    """
    if isinstance(value, list):
        return [changed(each, change) for each in value]
    number = bare(value)
    return value if number is None else change(number)
