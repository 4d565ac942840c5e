"""How the best train is chosen."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.records import record
from tmmcalc.gears.criteria.efficiency import MeshEfficiency

if TYPE_CHECKING:
    from tmmcalc.feasibility.judge import FeasibilityTask

WEIGHTED, ROW = "weighted", "row"  # ways to choose beside a single criterion


@record
class SelectionTask:
    """What is asked of the choice."""

    objectives: tuple[str, ...] = ("mass", "inertia", "size")  # of front, minima and comparisons
    weights: tuple[tuple[str, float], ...] = ()  # of criteria in the ranking; empty: all objectives alike
    choose: str | int = "inertia"  # a criterion, WEIGHTED, or the number of a row, from 1
    meshes: MeshEfficiency = MeshEfficiency()
    series: bool = False  # two trains AIbar in series are compared as well
    kept: FeasibilityTask | None = None  # the user's constraints on trains, if there are any

    @property
    def compared(self) -> tuple[str, ...]:
        """The objectives, and the criterion of choice if it is none of them."""
        word = self.choose
        single = isinstance(word, str) and word != WEIGHTED and word not in self.objectives
        return (*self.objectives, str(word)) if single else self.objectives
