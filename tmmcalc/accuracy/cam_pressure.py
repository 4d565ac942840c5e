"""Methods for the largest pressure angle: off a table of n positions, and as a root of the derivative on panels.

The reference is the largest of places ever closer to the extremes, in extended precision.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.accuracy.measure import Way, series
from tmmcalc.accuracy.sampled import SECOND, around
from tmmcalc.accuracy.study import FLOOR, Reference, Study
from tmmcalc.accuracy.subjects import Scene
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pressure import Pressure, pressure, reached
from tmmcalc.cams.program import TURN, Program
from tmmcalc.cams.task import CamTask
from tmmcalc.cams.wide import WIDER, wide

COUNTS = (12, 24, 48, 96, 192, 384, 768, 1536, 3072)  # positions of the turn


def studies(scene: Scene) -> Iterator[Study]:
    """The largest |theta| of the turn; a flat face has none."""
    found: Pressure = scene.results["cam_pressure"]
    task: CamTask = scene.inputs
    if found.follower.kind == "flat" or not WIDER:
        return
    follower, program = found.follower, task.program
    exact = _exact(program, follower, [on.worst.phi for on in (found.rise, found.back)])

    def error(theta: float) -> float:
        return max(float(abs(theta - exact) / exact), FLOOR)

    def tabled(count: int) -> float:
        phi = TURN * np.arange(count) / count
        return float(np.max(np.abs(pressure(follower, phi, program.at(phi)))))

    def by_roots() -> float:
        return max(abs(on.worst.value) for on in reached(task, follower))

    ways = [Way(f"{n} positions", 1 / n, partial(tabled, n)) for n in COUNTS]
    yield Study(
        "cam_pressure",
        "largest pressure angle",
        Reference("places ever closer to the extremes, in extended precision (64-bit mantissa)", 1e-14),
        (
            series("extremes on panels", [Way("", 1.0, by_roots)], error, scene.clock, note="of rise and return"),
            series("table of n positions", ways, error, scene.clock, expected=2.0, note=SECOND),
        ),
    )


def _exact(program: Program, follower: Follower, places: list[float]) -> np.longdouble:
    """At an end of a piece of the law both pieces count."""
    largest = np.longdouble(0.0)
    for place in places:
        phi = np.mod(around(place)[0], TURN)
        for side in (-1, 1):
            piece = program.piece(np.mod(phi + side * 1e-9, TURN))
            theta: Values = pressure(wide(follower), wide(phi), program.wider.at(wide(phi), piece))
            largest = max(largest, np.max(np.abs(theta)))
    return largest
