"""The module ratio mu* = m2/m1 at which both stages of a coaxial or planetary train are loaded equally in contact.

The module that a stage needs grows with cbrt(T (u +- 1)/u); equal use of both stages gives

    mu*^3 = U1 (U2 +- 1)/U2 U1/(U1 + 1)        + external second mesh (4.15), - internal (4.20)

Before the stage ratios are known they are taken at the smallest train, Z1 = Z2' = Z_min, where coaxiality reads
U1 + 1 = mu* (U2 +- 1). Then mu*^4 = U1^2/U2 with U1 U2 = U. The teeth chosen later differ, so mu* is a first guess:
above it the second stage is loaded less than the first, below it more.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.roots import Indices, bracketed
from tmmcalc.core.records import record
from tmmcalc.gears.model import Values

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


def curve(*, internal: bool, low: float | None = None, high: float | None = None, points: int = 101) -> Proportion:
    """The graph of mu* against U, by default over the textbook's range (figs 4.4, 4.11)."""
    ends = RANGE_INTERNAL if internal else RANGE
    start, stop = (ends[0] if low is None else low), (ends[1] if high is None else high)
    return equal_strength(np.linspace(start, stop, points), internal=internal)
