"""Stage ``unsteady``: a motion of the mechanism from rest to rest by the time-optimal law."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from tmmcalc.linkage.unsteady.columns import unsteady_columns
from tmmcalc.linkage.unsteady.results import Unsteady
from tmmcalc.linkage.unsteady.task import UnsteadyTask

if TYPE_CHECKING:
    from tmmcalc.core.columns import Column
    from tmmcalc.linkage.model import Mechanism
    from tmmcalc.linkage.room import LinkageTables


class UnsteadyInputs(NamedTuple):
    """What the stage reads."""

    mechanism: Mechanism
    task: UnsteadyTask


def inputs(spec: LinkageTables) -> UnsteadyInputs:
    """The linkage, and the motion that is asked for."""
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
    from tmmcalc.linkage.tables.tasks.unsteady import to_unsteady

    return UnsteadyInputs(to_linkage(spec.linkage), to_unsteady(spec))


def solve(given: UnsteadyInputs, upstream: Mapping[str, Any], settings: Mapping[str, Any]) -> Unsteady:
    """The law of the input and the motion of all links, on the assembly of the kinematics stage."""
    from tmmcalc.linkage.unsteady.solve import solve_unsteady

    return solve_unsteady(given.mechanism, given.task, upstream["kinematics"])


def columns(result: Unsteady) -> Sequence[Column]:
    """All columns, one row an instant."""
    return unsteady_columns(result)
