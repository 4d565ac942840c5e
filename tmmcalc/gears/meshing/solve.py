"""The pairs of a project, solved one by one or mesh by mesh of the train that was chosen."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.involute.rack import require_tool
from tmmcalc.gears.meshing.errors import pair_error
from tmmcalc.gears.meshing.refusal import error_of_all, millimetres, named
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.gears.meshing.task import PairsTask, PairTask

if TYPE_CHECKING:
    from tmmcalc.gears.selection.results import Selection


def solve_pairs(task: PairsTask, criteria: Selection | None = None) -> Pairs:
    """All pairs: those written out, else the meshes of the chosen train.

    Raises `NoSolutionError` with every pair that cannot be made.
    """
    if task.pairs:
        found, errors = [], []
        for pair in task.pairs:
            try:
                found.append(solve_pair(pair))
            except NoSolutionError as error:
                errors.append(error)
        if errors:
            raise error_of_all(errors, len(task.pairs))
        return Pairs(tuple(found), "", ())
    if criteria is None:
        raise UsageError(
            "there is neither a pair nor a train",
            where="pairs",
            remedy="give teeth and module in [pair], or a [train] whose meshes are to be solved",
        )
    from tmmcalc.gears.meshing.train import solve_meshes

    return solve_meshes(task, criteria, solve_pair)


def solve_pair(task: PairTask) -> MeshPair:
    """One pair, from the strategy of its shifts to its measures.

    Raises `NoSolutionError` for a pair that does not exist, and for one that cannot work if the task refuses it: with
    every reason, its margin and the nearest admissible shifts.

    >>> found = solve_pair(PairTask((14, 17), 0.005, strategy="given", shifts=(0.6, 0.522)))
    >>> round(1000 * found.distance, 4), found.verdict
    (82.2051, 'warn')
    """
    with named(task):
        require_tool(task.rack)
        if task.kind == "external":
            from tmmcalc.gears.meshing.external import solve_external

            found = solve_external(task)
        elif task.kind == "rack":
            from tmmcalc.gears.meshing.rack import solve_rack

            found = solve_rack(task)
        else:
            from tmmcalc.gears.meshing.internal import solve_internal

            found = solve_internal(task)
        note = "; ".join(filter(None, (found.note, _rounded(task))))
        return replace(found, note=note, error=pair_error(found))


def _rounded(task: PairTask) -> str:
    """What is to be said about a rack that is too narrow for the usual rounding."""
    rack, m = task.rack, task.module
    if not rack.limited:
        return ""
    return (
        "the rack is too narrow at its tip for the usual radius c*/(1 - sin alpha) = "
        f"{millimetres(m * rack.usual_radius)}: it is fully rounded by {millimetres(m * rack.radius)}, "
        f"rho* = {rack.radius:.4f}"
    )
