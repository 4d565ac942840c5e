"""Sliding along the line of action of a solved pair: where it is evaluated, and its tables in metres.

Before and behind the active part the flanks do not touch; the curves are continued there up to N1 and N2, which are
left out because the sliding is unbounded there. Tables are at given points too, or in equal steps (program 1.15).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.involute.internal.contact import internal_sliding
from tmmcalc.gears.involute.quality.sliding import Sliding, SlidingExtremes, sliding
from tmmcalc.gears.involute.rackpair import RackSliding, rack_sliding
from tmmcalc.gears.meshing.geometry import external_pair, internal_pair, pinion_on_rack
from tmmcalc.gears.meshing.results import MeshPair, SlidingPeaks, SlidingTable
from tmmcalc.gears.model import Values

ACTIVE = 41  # points of the active part, both ends and the pitch point among them
STEPS = 60  # of the whole line
REST = 1.2  # where it has no end ahead, the curves of sliding go so far beyond the end of the contact
FIRST = 0.25  # of the step: where a table in equal steps begins, as 0.5 mm of 2 mm
ROWS = 10_000


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


def sliding_at(found: MeshPair, rho1: Sequence[float] | Values) -> SlidingTable:
    """theta and lambda at radii of curvature rho1 = N1K (n,) [m] of wheel 1.

    Raises `UsageError` for points at or beyond the ends of the line of action: 0 < rho1 < g; of a ring or a rack
    rho1 > 0.

    >>> from tmmcalc.gears.meshing.solve import solve_pair
    >>> from tmmcalc.gears.meshing.task import PairTask
    >>> pair = solve_pair(PairTask((14, 17), 0.005, strategy="given", shifts=(0.6, 0.522)))
    >>> bool(sliding_at(pair, [pair.line.start]).theta1[0] == pair.peaks.theta1)
    True
    """
    line, m = found.line, found.task.module
    points = np.atleast_1d(np.asarray(rho1, float)) / m
    segment = line.begins / m, line.ends / m
    return sliding_table(_sliding(found, points, segment), *segment, m)


def _sliding(found: MeshPair, points: Values, segment: tuple[float, float]) -> Sliding | RackSliding:
    kind = found.task.kind
    if kind == "external":
        return sliding(external_pair(found), points, segment)
    if kind == "internal":
        return internal_sliding(internal_pair(found), points, segment)
    return rack_sliding(pinion_on_rack(found), points)


def sliding_steps(found: MeshPair, step: float) -> SlidingTable:
    """theta and lambda in equal steps [m] of rho1 from a quarter of the step to N2, as in the textbook's program 1.15.

    Where there is no N2 ahead (ring, rack), to a little beyond the contact. Raises `UsageError` for a step that is not
    positive, leaves no point or makes too many.
    """
    line = found.line
    end = line.length if found.task.kind == "external" else REST * max(line.ends, line.pitch)
    if not (step > 0 and FIRST * step < end and end / step <= ROWS):
        raise UsageError(
            f"no table has steps of {1e3 * step:.6g} mm",
            where="sliding",
            value=step,
            limit=end,
            remedy=f"a step between {1e3 * end / ROWS:.4g} and {1e3 * end:.6g} mm",
        )
    return sliding_at(found, np.arange(FIRST * step, end * (1 - 1e-9), step))
