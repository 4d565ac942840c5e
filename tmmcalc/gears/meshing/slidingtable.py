"""Sliding of a solved pair where it is asked for: at given points, or in equal steps (program 1.15)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.involute.internal.contact import internal_sliding
from tmmcalc.gears.involute.quality.sliding import Sliding, sliding
from tmmcalc.gears.involute.rackpair import RackSliding, rack_sliding
from tmmcalc.gears.meshing.along import REST, sliding_table
from tmmcalc.gears.meshing.mates import external_pair, internal_pair, pinion_on_rack
from tmmcalc.gears.meshing.results import MeshPair, SlidingTable
from tmmcalc.gears.model import Values

FIRST = 0.25  # of the step: where a table in equal steps begins, as 0.5 mm of 2 mm
ROWS = 10_000


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
