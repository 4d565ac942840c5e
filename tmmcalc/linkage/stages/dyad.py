"""Stage ``dyad``: the motion of a dyad with given states of its outer joints."""

from __future__ import annotations

from tmmcalc.linkage.dyadstate import DyadState, solve_dyad_task
from tmmcalc.linkage.tables.tasks.dyad import to_dyad

inputs = to_dyad
solve = solve_dyad_task
kind = DyadState
