"""Quantities of a document, read as the spec reads them, changed, and written in a form that it reads again."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.quantities import Number
from tmmcalc.spec.units import dimension_of, parse

_PURE = Number("a number", "1.5")


def pure(value: object) -> float:
    """A number without a unit; a quotient in quotes is one as well.

    >>> pure("7/5")
    1.4
    """
    return _PURE.read(value)


def rewritten(value: Any, change: Callable[[float], float]) -> Any:
    """A quantity with its number changed: with a unit in SI, without one as a number.

    >>> rewritten("15deg", lambda angle: -angle), rewritten("1/4", lambda number: -number)
    ('-0.26179938779914946 rad', -0.25)
    """
    dimension = dimension_of(value)
    if dimension is None:
        return change(pure(value))
    return f"{change(parse(value, dimension))!r} {DIMENSIONS[dimension].si}"
