"""Regions f >= 0 and their logic: characteristic functions, and R-functions whose sign follows the logic.

    form     f and g                                  f or g
    minmax   min(f, g)                                max(f, g)
    R0       f + g - sqrt(f^2 + g^2)                  f + g + sqrt(f^2 + g^2)
    Rm       R0 times (f^2 + g^2)^(m/2)               the same; m times differentiable where f = g = 0 too

The boundary f = 0 belongs to the region: Signum(0) = +1. The complement excludes it, so that "not" of a region is
1 - X_f, while -f is zero on the boundary as well. Of R-functions the sign counts alone: the value is no distance.
"""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmmcalc.core.errors import UsageError

Form = Literal["minmax", "R0", "Rm"]
FORMS = ("minmax", "R0", "Rm")
LARGEST, LEAST = 1e150, 1e-300  # magnitudes of R-functions; what is beyond counts as these
Values = NDArray[np.floating[Any]]


def characteristic(f: ArrayLike) -> Values:
    """X_f: 1 where f >= 0, else 0.

    >>> characteristic([-1.0, 0.0, 2.0]).tolist()
    [0.0, 1.0, 1.0]
    """
    return np.where(np.asarray(f) >= 0, 1.0, 0.0)


def complement(x: ArrayLike) -> Values:
    """The characteristic function of what is not in a region: 1 - X."""
    return np.asarray(1.0 - np.asarray(x))


def conjunction(f: ArrayLike, g: ArrayLike, form: Form = "minmax", m: int = 1) -> Values:
    """A function that is not negative where f and g both are: their intersection.

    >>> round(float(conjunction(0.5, 0.25, "R0")), 10)
    0.1909830056
    """
    a, b = _pair(f, g, form)
    return np.minimum(a, b) if form == "minmax" else -_joined(-a, -b, form, m)


def disjunction(f: ArrayLike, g: ArrayLike, form: Form = "minmax", m: int = 1) -> Values:
    """A function that is not negative where f or g is: their union."""
    a, b = _pair(f, g, form)
    return np.maximum(a, b) if form == "minmax" else _joined(a, b, form, m)


def negation(f: ArrayLike) -> Values:
    """-f: negative inside the region, zero on its boundary."""
    return np.asarray(-np.asarray(f, dtype=float))


def _pair(f: ArrayLike, g: ArrayLike, form: Form) -> tuple[Values, Values]:
    if form not in FORMS:
        raise UsageError(f"there is no form {form!r}", where="feasibility", remedy=f"forms: {', '.join(FORMS)}")
    return np.asarray(f, dtype=float), np.asarray(g, dtype=float)


def _joined(f: Values, g: Values, form: Form, m: int) -> Values:
    """f + g + sqrt(f^2 + g^2), times the factor of Rm; no two large parts cancel, and the sign outlives over- and
    underflow, so that functions may be joined again and again.
    """
    a, b = np.clip(f, -LARGEST, LARGEST), np.clip(g, -LARGEST, LARGEST)
    root, low, high = np.hypot(a, b), np.minimum(a, b), np.maximum(a, b)
    of_two_signs = high + high * (high / np.where(low < 0, root - low, 1.0))
    both_below = high * (2 * low / np.where(high < 0, low + high - root, -1.0))
    total = np.where(high < 0, both_below, np.where(low < 0, of_two_signs, a + b + root))
    if form == "Rm":
        with np.errstate(over="ignore", under="ignore"):
            total = np.sign(total) * np.clip(np.abs(total) * np.minimum(root**m, LARGEST), LEAST, LARGEST)
    return np.asarray(total)
