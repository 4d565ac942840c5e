"""Methods for the peaks of power and moment: off a table of n positions, and as extremes on panels.

The moment is that of the loads at the mean speed; where a load jumps between two positions, a table misses the peak by
what the moment gains up to there. The reference has its panels cut in half.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.accuracy.measure import Way, series
from tmmcalc.accuracy.sampled import SECOND
from tmmcalc.accuracy.study import FLOOR, Reference, Study
from tmmcalc.accuracy.subjects import Scene
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.onemass import onto
from tmmcalc.machine.power import moment_at
from tmmcalc.numerics.panels import Values

COUNTS = (6, 12, 24, 48, 96, 192, 384, 768)  # positions of the cycle


def studies(scene: Scene) -> Iterator[Study]:
    """The least and the largest reduced moment, which are those of the power over the mean speed."""
    cycle: Cycle = scene.results["reduction"].cycle
    finer = onto(cycle, cycle.panels.split(np.ones(cycle.panels.count, bool)))
    exact = _extremes(finer)
    size = float(np.max(np.abs(exact)))
    if not size:
        return

    def error(found: Values) -> float:
        return max(float(np.max(np.abs(found - exact))) / size, FLOOR)

    def tabled(count: int) -> Values:
        theta = cycle.period * np.arange(count + 1) / count
        moment = cycle.panels.at(moment_at(cycle, cycle.speed) - cycle.balancing, theta)
        return np.array([np.min(moment), np.max(moment)])

    ways = [Way(f"{n} positions", 1 / n, partial(tabled, n)) for n in COUNTS]
    yield Study(
        "power",
        "least and largest power",
        Reference("extremes on panels cut in half", max(error(_extremes(cycle)), cycle.error)),
        (
            series("extremes on panels", [Way("", 1.0, partial(_extremes, cycle))], error, scene.clock),
            series("table of n positions", ways, error, scene.clock, expected=2.0, note=SECOND),
        ),
    )


def _extremes(cycle: Cycle) -> Values:
    (least, _), (largest, _) = cycle.panels.extremes(moment_at(cycle, cycle.speed) - cycle.balancing)
    return np.array([least, largest])
