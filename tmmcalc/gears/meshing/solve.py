"""The pairs of a project, solved one by one or mesh by mesh of the train that was chosen."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.notes import Phrase, listed
from tmmcalc.gears.involute.rack import require_tool
from tmmcalc.gears.meshing.errors import pair_error
from tmmcalc.gears.meshing.refusal import error_of_all, millimetres, named
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.gears.meshing.task import PairsTask, PairTask

if TYPE_CHECKING:
    from tmmcalc.gears.selection.results import Selection


APART = (
    "the pairs that [pair] writes out are no part of the drive, and the meshes of the train are not shown; a pair "
    "between the train and the crank is [open_pair]"
)


def solve_pairs(task: PairsTask, criteria: Selection | None = None) -> Pairs:
    """All pairs: those written out, else the meshes of the chosen train; and the open pair on the crank.

    Raises `NoSolutionError` with every pair that cannot be made.
    """
    if task.usual is not None or not (task.pairs or task.on_crank):
        meshes = _meshes(task, criteria)
        beside = () if task.on_crank is None else (solve_pair(task.on_crank),)
        return replace(meshes, pairs=(*meshes.pairs, *beside))
    written = (*task.pairs, *(() if task.on_crank is None else (task.on_crank,)))
    found, errors = [], []
    for pair in written:
        try:
            found.append(solve_pair(pair))
        except NoSolutionError as error:
            errors.append(error)
    if errors:
        raise error_of_all(errors, len(written))
    return Pairs(tuple(found), "", (APART,) if task.beside_train and task.on_crank is None else ())


def _meshes(task: PairsTask, criteria: Selection | None) -> Pairs:
    """The meshes of the chosen train."""
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
        note = listed([text for text in (found.note, _rounded(task)) if text], "; ")
        return replace(found, note=note, error=pair_error(found))


def _rounded(task: PairTask) -> str:
    """What is to be said about a rack that is too narrow for the usual rounding."""
    rack, m = task.rack, task.module
    if not rack.limited:
        return ""
    return Phrase(
        "the rack is too narrow at its tip for the usual radius c*/(1 - sin alpha) = {usual}: it is fully rounded by "
        "{own}, rho* = {radius:.4f}",
        usual=millimetres(m * rack.usual_radius),
        own=millimetres(m * rack.radius),
        radius=rack.radius,
    )
