"""Stage ``unsteady``: a motion of the mechanism from rest to rest by the time-optimal law."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from tmmcalc.core.conversion import from_record, plain, to_record
from tmmcalc.core.stage import Late, Record, Table
from tmmcalc.linkage.unsteady.columns import unsteady_columns
from tmmcalc.linkage.unsteady.results import Unsteady
from tmmcalc.linkage.unsteady.task import UnsteadyTask

if TYPE_CHECKING:
    from tmmcalc.linkage.model import Mechanism
    from tmmcalc.project import Spec


class UnsteadyInputs(NamedTuple):
    """What the stage reads."""

    mechanism: Mechanism
    task: UnsteadyTask


def inputs(spec: Spec) -> UnsteadyInputs:
    """The linkage, and the motion that is asked for."""
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
    from tmmcalc.linkage.tables.tasks.unsteady import to_unsteady

    return UnsteadyInputs(to_linkage(spec.linkage), to_unsteady(spec))


def solve(given: UnsteadyInputs, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Unsteady:
    """The law of the input and the motion of all links, on the assembly of the kinematics stage."""
    from tmmcalc.linkage.unsteady.solve import solve_unsteady

    return solve_unsteady(given.mechanism, given.task, upstream["kinematics"])


def dump(result: Unsteady) -> Record:
    """Arrays by the names of the fields."""
    return to_record(result, plain(result.error))


def load(record: Record) -> Unsteady:
    """Build the result from its record."""
    result: Unsteady = from_record(Unsteady, record)
    return result


def table(result: Unsteady) -> Table:
    """All columns, one row an instant."""
    columns = unsteady_columns(result)
    label = np.array(result.labels)
    return Table(["i", *(c.header for c in columns)], Late([label, *(c.make for c in columns)]))
