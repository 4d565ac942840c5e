"""Stage ``gearing``: a train that is written out, its speeds, torques, power flow and efficiency."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.conversion import from_record, to_record
from tmmcalc.core.stage import Record, Table
from tmmcalc.gears.gearing import Gearing, solve_gearing
from tmmcalc.gears.gearingtask import GearingTask
from tmmcalc.gears.members import member_columns

if TYPE_CHECKING:
    from tmmcalc.project import Spec


def inputs(spec: Spec) -> GearingTask | None:
    """The members, the meshes, what is known of speeds and torques."""
    from tmmcalc.gears.tables.tasks.gearing import to_gearing

    return to_gearing(spec)


def solve(given: GearingTask, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Gearing:
    """The train in motion."""
    return solve_gearing(given)


def dump(result: Gearing) -> Record:
    """Arrays by the names of the fields: ``motion.speeds``, ``flow.torques``, ..."""
    return to_record(result, result.error)


def load(record: Record) -> Gearing:
    """Build the result from its record."""
    result: Gearing = from_record(Gearing, record)
    return result


def table(result: Gearing) -> Table:
    """Speeds, torques and powers, one row a member."""
    columns = member_columns(result)
    return Table(list(columns), [np.array(column) for column in columns.values()])
