"""Rounding errors measured by the same formulas in extended precision (64-bit mantissa).

A formula that is generic in its type of numbers is called once with doubles and once with what `widened` makes of
them; the difference of both results is what rounding left. Where the platform has no wider float the difference tells
nothing, and the estimate is that of a chain of operations, `CHAIN` units of rounding.
"""

from __future__ import annotations

from dataclasses import fields, is_dataclass, replace
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from fractions import Fraction  # its import would cost a start of the program more than all else here

T = TypeVar("T")

EPS = float(np.finfo(float).eps)
WIDER = np.finfo(np.longdouble).eps < EPS / 100
CHAIN = 64 * EPS
MARGIN = 2.0  # of a measured difference, for the rounding of the wider numbers and of the result when it is stored
PI = 4 * np.arctan(np.longdouble(1))


def widened(value: T) -> T:
    """The value with all floats in it as longdoubles: of arrays, tuples and records; anything else as it is."""
    widest: T = _widened(value)
    return widest


def _widened(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return value.astype(np.longdouble) if value.dtype == float else value
    if isinstance(value, float):
        return np.longdouble(value)
    if isinstance(value, tuple):
        return tuple(_widened(part) for part in value)
    if is_dataclass(value) and not isinstance(value, type):
        return replace(value, **{f.name: _widened(getattr(value, f.name)) for f in fields(value)})
    return value


def apart(found: Any, exact: Any) -> float:
    """Largest difference of two arrays or numbers over the largest exact value with its margin, one rounding at least.

    >>> apart(1.0, np.longdouble(1.0)) == (EPS if WIDER else CHAIN)
    True
    """
    exact = np.asarray(exact)
    scale = np.max(np.abs(exact), initial=0.0)
    least = EPS if WIDER else CHAIN
    if not scale > 0:
        return least
    return max(MARGIN * float(np.max(np.abs(np.asarray(found) - exact)) / scale), least)


def as_number(exact: Fraction, kind: type) -> Any:
    """A fraction as a float or, of another kind, a longdouble.

    >>> from fractions import Fraction
    >>> as_number(Fraction(1, 4), float)
    0.25
    """
    return float(exact) if kind is float else np.longdouble(exact.numerator) / np.longdouble(exact.denominator)


def spread(count: int, chosen: int) -> NDArray[np.intp]:
    """Indices of at most ``chosen`` of ``count`` rows, evenly spread, with both ends.

    >>> spread(9, 3).tolist(), spread(2, 3).tolist()
    ([0, 4, 8], [0, 1])
    """
    if count <= chosen:
        return np.arange(count)
    return np.linspace(0, count - 1, chosen).astype(np.intp)
