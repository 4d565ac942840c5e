"""Stage ``manipulator``: an arm, its gripper and its joints over the time."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.stage import said
from tmmcalc.manipulators.columns import manipulator_columns
from tmmcalc.manipulators.results import Manipulator
from tmmcalc.manipulators.tables.tasks.manipulator import to_manipulator

if TYPE_CHECKING:
    from tmmcalc.manipulators.room import ManipulatorTables


NO_OBSTACLES = "no obstacles: no distance to any is taken"

inputs = to_manipulator
solve = "tmmcalc.manipulators.solve:solve_manipulator"
kind = Manipulator
columns = manipulator_columns
dense = "tmmcalc.manipulators.tables.tasks.manipulator:with_steps"


def omits(spec: ManipulatorTables) -> tuple[str, ...]:
    """Obstacles."""
    table = spec.manipulator
    return said((table is not None and not table.obstacles, NO_OBSTACLES))


def packages(spec: ManipulatorTables) -> tuple[str, ...]:
    """A motion by a table is a cubic spline."""
    from tmmcalc.manipulators.tables.tasks.manipulator import to_manipulator
    from tmmcalc.manipulators.task import TableTask

    return ("scipy.interpolate",) if isinstance(to_manipulator(spec).motion, TableTask) else ()
