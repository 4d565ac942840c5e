"""Stage ``manipulator``: an arm, its gripper and its joints over the time."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.stage import Late, Record, Table
from tmmcalc.manipulators.columns import manipulator_columns
from tmmcalc.manipulators.results import Manipulator

if TYPE_CHECKING:
    from tmmcalc.manipulators.task import ManipulatorTask
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> ManipulatorTask:
    """Arm, motion, limits and obstacles."""
    from tmmcalc.manipulators.tables.tasks.manipulator import to_manipulator

    return to_manipulator(spec)


def solve(given: ManipulatorTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Manipulator:
    """The inverse problem of a path, or the direct one of the joints."""
    from tmmcalc.manipulators.solve import solve_manipulator

    return solve_manipulator(given)


def dump(result: Manipulator) -> Record:
    """Arrays by the names of the fields."""
    return to_record(result, result.error)


def load(record: Record) -> Manipulator:
    """Build the result from its record."""
    result: Manipulator = from_record(Manipulator, record)
    return result


def table(result: Manipulator) -> Table:
    """All columns, one row an instant."""
    columns = manipulator_columns(result)
    label = np.array(result.labels)
    return Table(["i", *(c.header for c in columns)], Late([label, *(c.make for c in columns)]))
