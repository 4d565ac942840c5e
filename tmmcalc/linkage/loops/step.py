"""A group of class III or higher, or one with the drive inside it, as a step of the chain."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage import solvers
from tmmcalc.linkage.dyads.base import Motions, Slides
from tmmcalc.linkage.loops.branch import guess
from tmmcalc.linkage.loops.closure import Loops, PlacedGroup
from tmmcalc.linkage.loops.equations import Equations
from tmmcalc.linkage.results import Branch
from tmmcalc.linkage.structure import Group


class LoopStep(NamedTuple):
    """The loops of a group on one branch."""

    group: Group
    variant: int  # number of its assembly, in the order of all of them where it was chosen
    equations: Equations
    branch: Branch

    def loops(self, motions: Motions, x: Real) -> Loops:
        """The loops at the motions of the source chain."""
        return Loops(self.equations, motions, self.equations.given(motions), x)

    def advance(
        self, motions: Motions, slides: Slides, x: Real, order: int, method: solvers.Method
    ) -> tuple[Loops, PlacedGroup]:
        """Close the loops on the branch and add the motions of the group's links; NaN where it does not reach."""
        loops = self.loops(motions, x)
        placed, done = loops.close(guess(self.branch, x).astype(x.dtype))
        if not done.all():
            placed = loops.place(np.where(done, placed.q, np.nan))
        q1, q2 = loops.rates(placed) if order else (np.zeros_like(placed.q),) * 2
        loops.move(placed, q1, q2, motions, slides)
        return loops, placed

    def regularity(self, placed: PlacedGroup) -> Real:
        """Distance (n,) from a singular position: 1 the best, 0 singular."""
        return placed.regularity
