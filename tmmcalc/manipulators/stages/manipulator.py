"""Stage ``manipulator``: an arm, its gripper and its joints over the time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from tmmcalc.core.stage import said
from tmmcalc.manipulators.columns import manipulator_columns
from tmmcalc.manipulators.results import Manipulator

if TYPE_CHECKING:
    from tmmcalc.core.columns import Column
    from tmmcalc.manipulators.room import ManipulatorTables
    from tmmcalc.manipulators.task import ManipulatorTask


NO_OBSTACLES = "no obstacles: no distance to any is taken"


def inputs(spec: ManipulatorTables) -> ManipulatorTask:
    """Arm, motion, limits and obstacles."""
    from tmmcalc.manipulators.tables.tasks.manipulator import to_manipulator

    return to_manipulator(spec)


def solve(given: ManipulatorTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Manipulator:
    """The inverse problem of a path, or the direct one of the joints."""
    from tmmcalc.manipulators.solve import solve_manipulator

    return solve_manipulator(given)


def columns(result: Manipulator) -> Sequence[Column]:
    """All columns, one row an instant."""
    return manipulator_columns(result)


def omits(spec: ManipulatorTables) -> tuple[str, ...]:
    """Obstacles."""
    table = spec.manipulator
    return said((table is not None and not table.obstacles, NO_OBSTACLES))


def packages(spec: ManipulatorTables) -> tuple[str, ...]:
    """A motion by a table is a cubic spline."""
    from tmmcalc.manipulators.tables.tasks.manipulator import to_manipulator
    from tmmcalc.manipulators.task import TableTask

    return ("scipy.interpolate",) if isinstance(to_manipulator(spec).motion, TableTask) else ()
