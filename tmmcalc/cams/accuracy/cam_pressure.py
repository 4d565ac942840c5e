"""Methods for the largest pressure angle: off a table of n positions, and as a root of the derivative on panels.

The reference looks for it by brute force, in extended precision.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.cams.accuracy.sides import beside
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pressure.angle import pressure_angle, reached
from tmmcalc.cams.pressure.solve import Pressure
from tmmcalc.cams.program import TURN, Program
from tmmcalc.cams.task import CamTask
from tmmcalc.cams.wide import wide
from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.core.studies.measure import Way, relative, series
from tmmcalc.core.studies.sampled import COUNTS, of_positions, summit
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Study

EXTENDED = float(np.finfo(np.longdouble).eps)


def studies(scene: Scene) -> Iterator[Study]:
    """The largest |theta| of the turn; a flat face has none."""
    found: Pressure = scene.results["cam_pressure"]
    task: CamTask = scene.inputs
    if found.follower.kind == "flat" or not WIDER:
        return
    follower, program = found.follower, task.program
    worst = max((on.worst for on in (found.rise, found.back)), key=lambda extreme: abs(extreme.value))
    exact = summit(partial(_sizes, program, follower), TURN, [worst.phi])

    def error(theta: float) -> float:
        return relative(theta, exact.values)

    def tabled(count: int) -> float:
        phi = TURN * np.arange(count) / count
        return float(np.max(np.abs(pressure_angle(follower, phi, program.at(phi)))))

    def by_roots() -> float:
        return max(abs(on.worst.value) for on in reached(task, follower, intervals=False))

    ways = [Way(f"{n} positions", 1 / n, partial(tabled, n)) for n in COUNTS]
    yield Study(
        "cam_pressure",
        "largest pressure angle",
        Reference(
            "ever finer positions about the largest, in extended precision (64-bit mantissa)",
            max(EXTENDED, exact.short),
        ),
        (
            series("extremes on panels", [Way("", None, by_roots)], error, scene.clock, note="of rise and return"),
            of_positions("table of n positions", ways, error, scene.clock),
        ),
    )


def _sizes(program: Program, follower: Follower, phi: Values) -> Values:
    """|theta| (1, m) in extended precision; at an end of a piece of the law the larger of both."""
    sides = [
        pressure_angle(wide(follower), at, program.wider.at(at, piece)) for at, piece in beside(program, wide(phi))
    ]
    return np.max(np.abs(sides), axis=0)[None]
