"""Methods for the largest forces of a cam: off a table of rows at equal steps, and as extremes on panels.

The table has a row at every end of a phase too, before a jump and behind it, as the program prints it. The reference
are places ever closer to every extreme.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.accuracy.measure import Way, series
from tmmcalc.accuracy.sampled import SECOND, around
from tmmcalc.accuracy.study import FLOOR, Reference, Study
from tmmcalc.accuracy.subjects import Scene
from tmmcalc.cams.forces.course import course_of
from tmmcalc.cams.forces.results import CamForces
from tmmcalc.cams.forces.solve import solve_forces
from tmmcalc.cams.forces.spring import solve_spring
from tmmcalc.cams.forces.state import state
from tmmcalc.cams.forces.turn import at_rows, loads_of
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.program import TURN, Positions, of_step
from tmmcalc.cams.task import CamTask
from tmmcalc.stages.camparts import at_speed

COUNTS = (12, 24, 48, 96, 192, 384, 768, 1536)  # equal steps of the turn
BESIDE = 1e-9  # [rad] of an end of a piece of the law


def studies(scene: Scene) -> Iterator[Study]:
    """The largest contact force and the largest driving torque."""
    task: CamTask = at_speed(scene.inputs, scene.results.get("motion"))
    found: CamForces = scene.results["cam_forces"]
    loads = loads_of(task)
    of = course_of(task, found.follower, loads, solve_spring(task, loads)).carried

    def forces(rows: Positions) -> Values:
        now = state(of, at_rows(task, loads, rows))
        return np.abs(np.stack((now.contact, now.driving)))

    def tabled(count: int) -> Values:
        return np.asarray(np.max(forces(of_step(task.program, TURN / count)), axis=1))

    def by_extremes() -> Values:
        return _sizes(solve_forces(task, found.follower))

    places = [found.extreme(name).place for name in ("R", "M_drive")]
    true = np.array([np.max(forces(_beside(task, place))[k]) for k, place in enumerate(places)])

    def error(sizes: Values) -> float:
        return max(float(np.max(np.abs(sizes - true) / np.where(true > 0, true, 1.0))), FLOOR)

    ways = [Way(f"{n} steps", 1 / n, partial(tabled, n)) for n in COUNTS]
    yield Study(
        "cam_forces",
        "largest contact force, largest torque",
        Reference("places ever closer to every extreme, by the equations themselves", found.error["extremes"]),
        (
            series("extremes on panels", [Way("", 1.0, by_extremes)], error, scene.clock, note="all of the stage"),
            series("table of equal steps", ways, error, scene.clock, expected=2.0, note=SECOND),
        ),
    )


def _sizes(found: CamForces) -> Values:
    return np.array([found.extreme(name).size for name in ("R", "M_drive")])


def _beside(task: CamTask, place: float) -> Positions:
    """Rows ever closer to a place, each by the piece before it and the one behind it."""
    phi = np.mod(around(place)[0], TURN)
    pieces = [task.program.piece(np.mod(phi + side, TURN)) for side in (-BESIDE, BESIDE)]
    return Positions(np.tile(phi, 2), np.concatenate(pieces), ())
