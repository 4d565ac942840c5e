"""Sliding along the line of action: where it is evaluated, and its table in metres.

Before and behind the active part the flanks do not touch; the curves are continued there up to N1 and N2, which are
left out because the sliding is unbounded there.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.gears.involute.quality.sliding import Sliding, SlidingExtremes
from tmmcalc.gears.involute.rackpair import RackSliding
from tmmcalc.gears.meshing.results import SlidingPeaks, SlidingTable
from tmmcalc.gears.model import Values

ACTIVE = 41  # points of the active part, both ends and the pitch point among them
STEPS = 60  # of the whole line
REST = 1.2  # where it has no end ahead, the curves of sliding go so far beyond the end of the contact


def line_points(low: float, high: float, pitch: float, top: float) -> Values:
    """rho1 (n,) between 0 and ``top``, both left out: equal steps, finer from ``low`` to ``high``.

    >>> points = line_points(2.0, 5.0, 3.6, 8.0)
    >>> len(points), 3.6 in points
    (78, True)
    """
    outer = top / STEPS * np.arange(1, STEPS)
    if not 0 < low < high < top:
        return outer
    inner = np.linspace(low, high, ACTIVE)
    near = 0.3 * top / STEPS
    if low < pitch < high:
        at = int(np.argmin(np.abs(inner - pitch)))
        if abs(inner[at] - pitch) >= 1e-9 * top:
            inner = np.sort(np.append(inner, pitch))
        elif 0 < at < ACTIVE - 1:
            inner[at] = pitch
    return np.concatenate((outer[outer < low - near], inner, outer[outer > high + near]))


def sliding_table(found: Sliding | RackSliding, low: float, high: float, module: float) -> SlidingTable:
    """The table; the flanks touch from ``low`` to ``high``, both in modules as ``found`` is."""
    slack = 1e-12 * max(abs(low), abs(high))
    active = (found.rho1 >= low - slack) & (found.rho1 <= high + slack) & (low < high)
    return SlidingTable(
        module * found.rho1, module * found.along, found.theta1, found.theta2, found.pressure, np.asarray(active)
    )


def peaks_of(found: SlidingExtremes) -> SlidingPeaks:
    """The largest values of the contact."""
    return SlidingPeaks(
        found.theta1,
        found.theta2,
        found.pressure_start,
        found.pressure_pitch,
        found.pressure_end,
        found.pressure_largest,
    )
