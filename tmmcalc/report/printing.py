"""How a note is printed: how much of it, in what frame, in which units beside those of its formulas."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar

from tmmcalc.spec.units import conversion, kind_of

FULL, SHORT, ANSWERS = DEPTHS = ("full", "short", "answers")
FRAMES = ("gost", "none")

_units: ContextVar[Sequence[str]] = ContextVar("units", default=())


@contextmanager
def printing(units: Sequence[str]) -> Iterator[None]:
    """Results within are printed in these units, each for all that are of its dimension."""
    token = _units.set(units)
    try:
        yield
    finally:
        _units.reset(token)


def printed_as(unit: str) -> tuple[str, float]:
    """The unit in which a value in ``unit`` is printed, and the factor of the value.

    >>> with printing(["mm", "MPa"]):
    ...     printed_as("m"), printed_as("N")
    (('mm', 1000.0), ('N', 1.0))
    """
    dimension = kind_of(unit)
    for other in _units.get():
        if dimension and kind_of(other) == dimension and other != unit:
            return other, conversion(unit, other)
    return unit, 1.0
