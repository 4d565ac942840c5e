"""The module ratio mu* = m2/m1 at which both stages of a coaxial or planetary train are loaded equally in contact.

The module that a stage needs grows with cbrt(T (u +- 1)/u); equal use of both stages gives

    mu*^3 = U1 (U2 +- 1)/U2 U1/(U1 + 1)        + external second mesh (4.15), - internal (4.20)

Before the stage ratios are known they are taken at the smallest train, Z1 = Z2' = Z_min, where coaxiality reads
U1 + 1 = mu* (U2 +- 1). Then mu*^4 = U1^2/U2 with U1 U2 = U. The teeth chosen later differ, so mu* is a first guess:
above it the second stage is loaded less than the first, below it more.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from typing import Literal

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.roots import Indices, bracketed
from tmmcalc.core.records import record
from tmmcalc.gears.model import Values
from tmmcalc.gears.strength.series import EIGHTHS, eighths

RANGE = (4.0, 20.0)  # of the textbook's graph for two external meshes (fig. 4.4)
RANGE_INTERNAL = (5.0, 40.0)  # for an internal second mesh (fig. 4.11)


@record
class Proportion:
    """Module ratios of equal strength of n tooth ratios."""

    ratio: Values  # U (n,)
    modules: Values  # mu* = m2/m1 (n,)
    first: Values  # U1 (n,)
    second: Values  # U2 (n,)


def equal_strength(ratio: Values | float, *, internal: bool) -> Proportion:
    """mu* and the stage ratios of the smallest train for every tooth ratio U (n,) (textbook 4.15, 4.20).

    ``internal``: the second mesh is internal (AI), else external (AA, coaxial). Raises `UsageError` for U at or
    below one.

    >>> found = equal_strength(8.15, internal=False)
    >>> round(float(found.modules[0]), 5), round(float(found.first[0]), 4)
    (1.70357, 4.0945)
    """
    u = np.atleast_1d(np.asarray(ratio, float))
    if not (np.all(np.isfinite(u)) and np.all(u > 1)):
        raise UsageError(
            "the tooth ratio has to be above 1", where="module ratio", value=float(np.min(u)), limit=1.0, remedy="U > 1"
        )
    side = -1.0 if internal else 1.0

    def gap(root: Values, which: Indices) -> Values:
        # The unknown is x = cbrt(mu*), so that U1 = x^4 cbrt(U): coaxiality without fractional powers of the unknown.
        first = root**4 * cube[which]
        return first + 1 - root**3 * (u[which] / first + side)

    cube = np.cbrt(u)
    # U1 = U/1000 leaves the second stage too large, U1 = U too small.
    root = bracketed(gap, (u / 1000 / cube) ** 0.25, (u / cube) ** 0.25)
    first = root**4 * cube
    return Proportion(u, root**3, first, u / first)


def module_ratio(first: Values | float, second: Values | float, *, internal: bool) -> Values:
    """mu* of given stage ratios U1 and U2 (textbook 4.15, 4.20).

    >>> round(float(module_ratio(4.0945, 1.99048, internal=False)), 4)
    1.7036
    """
    u1, u2 = np.asarray(first, float), np.asarray(second, float)
    ratio: Values = np.cbrt(u1 * (u2 + (-1 if internal else 1)) / u2 * u1 / (u1 + 1))
    return ratio


def curve(*, internal: bool, low: float | None = None, high: float | None = None, points: int = 101) -> Proportion:
    """The graph of mu* against U, by default over the textbook's range (figs 4.4, 4.11)."""
    ends = RANGE_INTERNAL if internal else RANGE
    start, stop = (ends[0] if low is None else low), (ends[1] if high is None else high)
    return equal_strength(np.linspace(start, stop, points), internal=internal)


@record
class StandardRatio:
    """A ratio mu1 : mu2 = m1 : m2 that standard modules make."""

    proportion: tuple[int, int]  # mu1, mu2 in lowest terms
    modules: Values  # [m] (p, 2) the standard modules m1, m2 in this ratio, ascending
    deviation: float  # (m2/m1)/mu* - 1


def standard_ratios(target: float, *, rows: Literal[1, 2] = 2, within: float = 0.1) -> tuple[StandardRatio, ...]:
    """Ratios m2/m1 of standard modules that lie within a relative distance of mu* = ``target``, the nearest first.

    ``rows`` 1 takes the preferred row of modules only, 2 both.

    >>> [ratio.proportion for ratio in standard_ratios(1.7, rows=1, within=0.06)]
    [(3, 5), (5, 8)]
    """
    pairs: dict[Fraction, list[tuple[int, int]]] = {}
    for m1, m2 in product(eighths(rows), repeat=2):
        if abs(m2 / m1 / target - 1) <= within:
            pairs.setdefault(Fraction(m2, m1), []).append((m1, m2))
    found = [
        StandardRatio((ratio.denominator, ratio.numerator), np.array(made) / EIGHTHS, float(ratio) / target - 1)
        for ratio, made in pairs.items()
    ]
    return tuple(sorted(found, key=lambda each: (abs(each.deviation), each.proportion)))
