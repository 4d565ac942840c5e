"""A reference for equations of motion in time: extrapolation in extended precision.

Gragg's and Bulirsch's midpoint rule has an error in even powers of the step alone, h = H/2, H/4, H/6, ..., so that each
column of Neville's scheme takes two orders more away.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.studies.timed import Slopes

COLUMNS = 9  # order 18


def extrapolated(slopes: Slopes, state: Values, instants: Values, parts: int) -> Values:
    """States (m, n) at equal instants (n,), each step between them in ``parts``; in extended precision."""
    step = np.longdouble(instants[0]) / parts
    y, t, states = state.astype(np.longdouble), np.longdouble(0.0), []
    for _ in instants:
        for _ in range(parts):
            y, t = _extrapolated(slopes, t, y, step), t + step
        states.append(y)
    return np.array(states).T


def _extrapolated(slopes: Slopes, t: np.longdouble, y: Values, whole: np.longdouble) -> Values:
    """One step by Neville's scheme in the squares of the substeps."""
    row: list[Values] = []
    for k in range(1, COLUMNS + 1):
        new = [_midpoints(slopes, t, y, whole, 2 * k)]
        for j in range(1, k):
            ratio = (np.longdouble(k) / (k - j)) ** 2
            new.append(new[-1] + (new[-1] - row[j - 1]) / (ratio - 1))
        row = new
    return row[-1]


def _midpoints(slopes: Slopes, t: np.longdouble, y: Values, whole: np.longdouble, count: int) -> Values:
    h = whole / count
    before, here = y, y + h * np.asarray(slopes(t, y))
    for k in range(1, count):
        before, here = here, before + 2 * h * np.asarray(slopes(t + k * h, here))
    return here
