"""Methods for the largest forces of a cam: off a table of rows at equal steps, and as extremes on panels.

The table has a row at every end of a phase too, before a jump and behind it, as the program prints it. The reference
looks for the extremes by brute force. All methods begin with the task and size the spring.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np

from tmmcalc.cams.accuracy.sides import beside
from tmmcalc.cams.forces.results import CamForces
from tmmcalc.cams.forces.solve import solve_forces
from tmmcalc.cams.forces.spring import solve_spring
from tmmcalc.cams.forces.state import Carried, state
from tmmcalc.cams.forces.turn import at_rows, loads_of
from tmmcalc.cams.forces.turnforces import turn_forces
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.program import TURN, Positions, of_step
from tmmcalc.cams.task import CamTask
from tmmcalc.core.studies.measure import Way, relative, series
from tmmcalc.core.studies.sampled import COUNTS, of_positions, summit
from tmmcalc.core.studies.scene import Scene
from tmmcalc.core.studies.study import Reference, Study


def studies(scene: Scene) -> Iterator[Study]:
    """The largest contact force and the largest driving torque."""
    task: CamTask = scene.inputs.at_speed(scene.results.get("motion"))
    found: CamForces = scene.results["cam_forces"]
    loads = loads_of(task)

    def carried() -> Carried:
        return turn_forces(task, found.follower, loads, solve_spring(task, loads)).carried

    def forces(of: Carried, rows: Positions) -> Values:
        now = state(of, at_rows(task, loads, rows))
        return np.abs(np.stack((now.contact, now.driving)))

    def tabled(count: int) -> Values:
        return np.asarray(np.max(forces(carried(), of_step(task.program, TURN / count)), axis=1))

    def by_extremes() -> Values:
        extreme = solve_forces(task, found.follower).extreme
        return np.array([extreme(name).size for name in ("R", "M_drive")])

    of = carried()

    def reached(phi: Values) -> Values:
        """The larger of both sides of a jump (2, m)."""
        sides = beside(task.program, phi.astype(float))
        return np.max([forces(of, Positions(at, piece, ())) for at, piece in sides], axis=0)

    true = summit(reached, TURN, [found.extreme(name).place for name in ("R", "M_drive")])
    size = np.where(true.values > 0, true.values, 1.0)

    def error(sizes: Values) -> float:
        return relative(sizes / size, true.values / size, 1.0)

    ways = [Way(f"{n} steps", 1 / n, partial(tabled, n)) for n in COUNTS]
    yield Study(
        "cam_forces",
        "largest contact force, largest torque",
        Reference(
            "ever finer positions about the largest, by the equations themselves",
            max(found.error["extremes"], true.short),
        ),
        (
            series("extremes on panels", [Way("", None, by_extremes)], error, scene.clock, note="all of the stage"),
            of_positions("table of equal steps", ways, error, scene.clock),
        ),
    )
