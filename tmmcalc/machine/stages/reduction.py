"""Stage ``reduction``: reduced moments and reduced inertia over the cycle, work per cycle."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from tmmcalc.core.conversion import from_record, plain, to_record
from tmmcalc.core.stage import Late, Record, Table
from tmmcalc.machine.model import TorqueTask
from tmmcalc.machine.reduction.columns import EFFICIENCY, cells, columns
from tmmcalc.machine.reduction.results import Reduction

if TYPE_CHECKING:
    from tmmcalc.core.columns import Column
    from tmmcalc.linkage.loading import Loading
    from tmmcalc.linkage.model import Mechanism
    from tmmcalc.project import Spec


Given = tuple["Mechanism", "Loading", str] | TorqueTask


def inputs(spec: Spec) -> Given:
    """The linkage, what acts on it, and how rods are reduced; or the torque diagram that stands in its place."""
    from tmmcalc.machine.tables.tasks.machine import to_torque

    torque = to_torque(spec)
    if torque is not None:
        return torque
    from tmmcalc.linkage.tables.tasks.loading import to_loading
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    rods = spec.reduction.rods if spec.reduction is not None else "exact"
    return to_linkage(spec.linkage), to_loading(spec), rods


def solve(given: Given, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Reduction:
    """Reduce everything to the input link."""
    if isinstance(given, TorqueTask):
        from tmmcalc.machine.diagram.task import cycle_of
        from tmmcalc.machine.stages.diagram import reduced_diagram

        return reduced_diagram(given.name, cycle_of(given))
    from tmmcalc.machine.reduction.reduce import solve_reduction  # a stored result is loaded without it

    mechanism, loading, rods = given
    return solve_reduction(mechanism, loading, upstream["kinematics"], rods)


def dump(result: Reduction) -> Record:
    """Arrays by the names of the fields; those of the dense cycle under ``cycle.``."""
    return to_record(result, plain(result.error))


def load(record: Record) -> Reduction:
    """Build the result from its record."""
    result: Reduction = from_record(Reduction, record)
    return result


def table(result: Reduction) -> Table:
    """All columns, one row a position; one with blanks is written as text."""
    chosen = columns(result)
    written = [partial(_efficiency, result, c) if c.name == EFFICIENCY else c.make for c in chosen]
    return Table(["i", *(c.header for c in chosen)], Late([np.array(result.labels), *written]))


def _efficiency(result: Reduction, column: Column) -> np.ndarray:
    """The cells as texts of full precision (n,)."""
    values = cells(result, column)
    return np.array([value if isinstance(value, str) else repr(value) for value in values])
