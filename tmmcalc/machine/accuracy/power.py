"""Methods for the peaks of power and moment: off a table of n positions, and as extremes on panels.

The moment is that of the loads at the mean speed; where a load jumps between two positions, a table misses the peak by
what the moment gains up to there. The reference looks for the peaks of the same functions by brute force.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.studies.measure import Way, relative, series
from tmmcalc.core.studies.sampled import COUNTS, of_positions, summit
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Study
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.power import moment_at


def studies(scene: Scene) -> Iterator[Study]:
    """The least and the largest reduced moment, which are those of the power over the mean speed."""
    cycle: Cycle = scene.results["reduction"].cycle
    moment = _moment(cycle)
    size = float(np.max(np.abs(moment)))
    if not size:
        return

    def both(theta: Values) -> Values:
        """The moment downwards and upwards (2, m)."""
        inside = np.clip(theta, 0.0, cycle.period).astype(float)
        sides = [cycle.panels.at(moment, inside, before=before) for before in (False, True)]
        return np.stack((-np.minimum(*sides), np.maximum(*sides)))

    (_, least_at), (_, largest_at) = cycle.panels.extremes(moment)
    found = summit(both, cycle.period, [least_at, largest_at])
    exact = found.values * np.array([-1.0, 1.0])

    def error(peaks: Values) -> float:
        return relative(peaks, exact, size)

    def tabled(count: int) -> Values:
        values = cycle.panels.at(_moment(cycle), cycle.period * np.arange(count + 1) / count)
        return np.array([np.min(values), np.max(values)])

    ways = [Way(f"{n} positions", 1 / n, partial(tabled, n)) for n in COUNTS]
    yield Study(
        "power",
        "least and largest power",
        Reference("ever finer positions about the peaks of the same functions", max(found.short, cycle.error)),
        (
            series("extremes on panels", [Way("", None, partial(_extremes, cycle))], error, scene.clock),
            of_positions("table of n positions", ways, error, scene.clock),
        ),
    )


def _moment(cycle: Cycle) -> Values:
    """Moment (K, N) of the loads at the mean speed."""
    return moment_at(cycle, cycle.speed) - cycle.balancing


def _extremes(cycle: Cycle) -> Values:
    (least, _), (largest, _) = cycle.panels.extremes(_moment(cycle))
    return np.array([least, largest])
