"""Stage ``unsteady``: a motion of the mechanism from rest to rest by the time-optimal law."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.linkage.unsteady.columns import unsteady_columns
from tmmcalc.linkage.unsteady.results import Unsteady

if TYPE_CHECKING:
    from tmmcalc.linkage.model import Mechanism
    from tmmcalc.linkage.room import LinkageTables
    from tmmcalc.linkage.unsteady.task import UnsteadyTask

solve = "tmmcalc.linkage.unsteady.solve:solve_unsteady"
kind = Unsteady
columns = unsteady_columns
dense = "tmmcalc.linkage.tables.tasks.unsteady:with_steps"
words = "tmmcalc.linkage.tables.tasks.words:words_of"
declares = ()


def inputs(spec: LinkageTables) -> tuple[Mechanism, UnsteadyTask]:
    """The linkage, and the motion that is asked for."""
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
    from tmmcalc.linkage.tables.tasks.unsteady import to_unsteady

    return to_linkage(spec.linkage), to_unsteady(spec)
