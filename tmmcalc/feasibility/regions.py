"""The logic of regions f >= 0 for values and for functions alike: of functions it gives a function of the same point.

    >>> disk = lambda x, y: 1 - x**2 - y**2
    >>> right = lambda x, y: x - 0.25
    >>> both = conjunction(disk, right, "R0")
    >>> bool(both(0.5, 0.0) >= 0), bool(both(0.0, 0.0) >= 0)
    (True, False)

Such a function may be the constraint of an optimiser: smooth in the forms R0 (but where both vanish) and Rm.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from numpy.typing import ArrayLike

from tmmcalc.feasibility import logic
from tmmcalc.feasibility.logic import Form, Values

Region = ArrayLike | Callable[..., ArrayLike]  # values of f, or f itself


def characteristic(f: Region) -> Any:
    """X_f: 1 where f >= 0, else 0; an array of the shape of f, or a function where f is one."""
    return _lifted(logic.characteristic, f)


def complement(x: Region) -> Any:
    """1 - X, the characteristic function of what is not in a region."""
    return _lifted(logic.complement, x)


def negation(f: Region) -> Any:
    """-f: negative inside the region, zero on its boundary as well."""
    return _lifted(logic.negation, f)


def conjunction(f: Region, g: Region, form: Form = "minmax", m: int = 1) -> Any:
    """Not negative where f and g both are; raises `UsageError` for a form that there is not."""
    return _lifted(lambda a, b: logic.conjunction(a, b, form, m), f, g)


def disjunction(f: Region, g: Region, form: Form = "minmax", m: int = 1) -> Any:
    """Not negative where f or g is; raises `UsageError` for a form that there is not."""
    return _lifted(lambda a, b: logic.disjunction(a, b, form, m), f, g)


def _lifted(operation: Callable[..., Values], *regions: Region) -> Any:
    if not any(callable(region) for region in regions):
        return operation(*regions)

    def at(*point: Any, **named: Any) -> Values:
        return operation(*(region(*point, **named) if callable(region) else region for region in regions))

    return at
