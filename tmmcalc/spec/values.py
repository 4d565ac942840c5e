"""Numbers of the raw document in SI, where they can be read; what cannot is reported with the tables."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

from tmmcalc.spec.findings import Finding
from tmmcalc.spec.phrases import Path, either, show
from tmmcalc.spec.quantities import Number
from tmmcalc.spec.units import LARGEST, UnitError, parse

FASTEST_BARE = 400.0  # rad/s: a larger bare speed is rpm in disguise
_ANY = Number("a number", "1")


def amount(value: object, *dimensions: str) -> float | None:
    """Return a quantity of one of the dimensions in SI, a bare number without any; None if it is absent or faulty."""
    try:
        return parse(value, *dimensions) if dimensions else _ANY.read(value)
    except UnitError:
        return None


def amounts(listed: object, *dimensions: str) -> list[float] | None:
    """Return a list of quantities in SI; None if it is no list or one of them is faulty."""
    if not isinstance(listed, list):
        return None
    found = [amount(value, *dimensions) for value in listed]
    numbers = [number for number in found if number is not None]
    return numbers if len(numbers) == len(found) else None


def first_disorder(numbers: list[float], *, jumps: bool = False) -> int | None:
    """Return the index of the first number that does not come after the one before it; None if all ascend.

    Where the values may jump (``jumps``) two numbers may be equal, and no three.

    >>> first_disorder([0.0, 1.0, 1.0, 2.0]), first_disorder([0.0, 1.0, 1.0, 2.0, 2.0, 2.0], jumps=True)
    (2, 5)
    """
    for i in range(1, len(numbers)):
        twice = jumps and numbers[i] == numbers[i - 1] and (i == 1 or numbers[i] > numbers[i - 2])
        if not (numbers[i] > numbers[i - 1] or twice):
            return i
    return None


def check_bare_speed(value: object, path: Path) -> Iterator[Finding]:
    """A speed in rpm says so: its bare number stands out."""
    bare = bare_number(value)
    if bare is not None and bare > FASTEST_BARE:
        yield Finding(
            path,
            f"{show(bare)} without a unit is in rad/s, which is {bare * 30 / math.pi:.0f} rpm",
            f'write "{bare:g} rpm" or "{bare:g} rad/s"',
        )


def bare_number(value: object) -> float | None:
    """Return a finite number without a unit."""
    number = isinstance(value, int | float) and not isinstance(value, bool)
    return value if number and isinstance(value, int | float) and abs(value) < LARGEST else None


def check_one_of(path: Path, table: Mapping[str, Any], keys: tuple[str, ...], remedy: str) -> Iterator[Finding]:
    """Exactly one of several keys of a table stands in the place of the others; ``remedy`` adds one."""
    there = [key for key in keys if key in table]
    if not there:
        yield Finding(path, f"missing key: there is none of {either(keys)}", remedy)
    elif len(there) > 1:
        yield Finding((*path, there[1]), f"{' and '.join(there)} together: one is enough", "keep one of them")
