"""The pairs of a project, solved one by one or mesh by mesh of the train that was chosen."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.errors import NoSolutionError, UsageError
from tmmcalc.gears.involute.profile.rounding import rounding
from tmmcalc.gears.meshing.mates import wheel_of
from tmmcalc.gears.meshing.refusal import joined, named
from tmmcalc.gears.meshing.results import MeshPair, Pairs
from tmmcalc.gears.meshing.task import PairsTask, PairTask

if TYPE_CHECKING:
    from tmmcalc.gears.selection.results import Selection


def solve_pairs(task: PairsTask, selection: Selection | None = None) -> Pairs:
    """All pairs: those written out, else the meshes of the chosen train.

    Raises `NoSolutionError` with every pair that cannot be made.
    """
    if task.pairs:
        return Pairs(_each(task.pairs), "", ())
    if selection is None:
        raise UsageError(
            "there is neither a pair nor a train",
            where="pairs",
            remedy="give teeth and module in [pair], or a [train] whose meshes are to be solved",
        )
    from tmmcalc.gears.meshing.train import solve_meshes

    return solve_meshes(task, selection, solve_pair)


def solve_pair(task: PairTask) -> MeshPair:
    """One pair, from the strategy of its shifts to its measures.

    Raises `NoSolutionError` for a pair that does not exist, and for one that cannot work if the task refuses it: with
    every reason, its margin and the nearest admissible shifts.

    >>> found = solve_pair(PairTask((14, 17), 0.005, strategy="given", shifts=(0.6, 0.522)))
    >>> round(1000 * found.distance, 4), found.verdict
    (82.2051, 'warn')
    """
    with named(task):
        rounding(wheel_of(task, 1), task.fillet)  # the tool has to exist
        if task.kind == "external":
            from tmmcalc.gears.meshing.external import solve_external

            return solve_external(task)
        if task.kind == "rack":
            from tmmcalc.gears.meshing.rack import solve_rack

            return solve_rack(task)
        from tmmcalc.gears.meshing.internal import solve_internal

        return solve_internal(task)


def _each(tasks: tuple[PairTask, ...]) -> tuple[MeshPair, ...]:
    found, errors = [], []
    for task in tasks:
        try:
            found.append(solve_pair(task))
        except NoSolutionError as error:
            errors.append(error)
    if errors:
        raise joined(errors, len(tasks))
    return tuple(found)
