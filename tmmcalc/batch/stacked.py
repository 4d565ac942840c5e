"""Points solved together: variants of one structure as rows of the same arrays.

Of columns and a few facts the values are made at once (`stacked_columns`), of all else the results of every variant by
itself, cut out of those of all (`stacked_results`). Blocks are those of the numbers of the points, so that a point has
the same value to the last digit whatever it is solved with. A variant that is not clear (see `linkage.stacked`) is
solved alone, and so is one that fails.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

from tmmcalc.batch.points import solve_points as solve_alone
from tmmcalc.batch.points import stages_to
from tmmcalc.batch.quantities import told
from tmmcalc.batch.stacked_columns import Asked, Columns, asked
from tmmcalc.batch.stacked_inputs import Inputs
from tmmcalc.batch.stacked_results import Results
from tmmcalc.batch.task import Row, Task
from tmmcalc.errors import TmmError, UsageError

if TYPE_CHECKING:
    from tmmcalc.pipeline.outcome import RunResult

SOLVER = "tmmcalc.batch.stacked:solve_points"
FEW = 16  # points that are not worth it
TRIED = 16  # points over the sweep, one of which has to have a solution
COLUMNS = frozenset({"structure", "kinematics", "forces", "reduction", "power", "motion"})  # for which columns do
LOADED = ("forces", "reduction")  # stages that read what acts on the linkage
DRIVEN = ("power", "flywheel", "motion")  # and the machine


def together(task: Task) -> int:
    """How many points of a task are to be solved together; 0 where they cannot be, or are a few."""
    made = prepared(task) if task.count >= FEW else ""
    return 0 if isinstance(made, str) else made.block


def way(task: Task, apart: int = 0) -> str:
    """How the points of a task are solved, in words; nothing of a few points. ``apart`` were solved alone after all."""
    if task.count < FEW:
        return ""
    made = prepared(task)
    if isinstance(made, str):
        return f"variants solved one by one: {made}"
    said = "variants solved together"
    if made.alone:
        said += f", {', '.join(made.alone)} of each by itself"
    return f"{said}; {apart} of {task.count} alone, near to a limit position or without a solution" if apart else said


def refusal(task: Task) -> str | None:
    """Why the points of a task cannot be solved together; None if they can."""
    made = prepared(task)
    return made if isinstance(made, str) else None


def prepared(task: Task) -> Columns | Results | str:
    """What all blocks of a task need, or why it cannot be solved in blocks."""
    return _prepared(replace(task, solver="", block=0))  # whoever solves it


def solve_points(task: Task, points: Sequence[int]) -> list[Row]:
    """Rows of the points, in their order; those that cannot be solved together are solved alone."""
    made, found = prepared(task), dict[int, Row]()
    if not isinstance(made, str):
        for block in dict.fromkeys(point // made.block for point in points):
            found.update(_rows(replace(task, solver="", block=0), block))
    rest = [point for point in points if point not in found]
    found.update((row.point, replace(row, alone=True)) for row in solve_alone(task, rest))
    return [found[point] for point in points]


@lru_cache(maxsize=4)  # neighbouring blocks, when points are asked for one by one
def _rows(task: Task, block: int) -> dict[int, Row]:
    made = prepared(task)
    assert not isinstance(made, str)
    return made.rows(range(block * made.block, min((block + 1) * made.block, task.count)))


@lru_cache(maxsize=2)
def _prepared(task: Task) -> Columns | Results | str:
    if task.tolerance is not None:
        return "a tolerance is asked for"
    further = range(0, task.count, max(1, task.count // TRIED))
    for point in dict.fromkeys((*task.spread(), *further)):
        try:
            return _made(task, point)
        except UsageError as error:
            return f"{error.where}: {error.message}"
        except TmmError:
            continue
    return "no variant that was tried has a solution"


def _made(task: Task, point: int) -> Columns | Results | str:
    from tmmcalc.pipeline.runner import run

    spec = task.variants().spec(task.assignments(point))
    if spec.mechanism is None:
        return "there is no linkage"
    base = run(spec, stages=stages_to(spec, task.targets))
    ran = {*base.outcomes}
    if "kinematics" not in ran:
        return "no motion of the linkage is asked for"
    if spec.reduction is not None and spec.reduction.rods == "lumped" and "reduction" in ran:
        return "rods are lumped in two masses"
    loaded, driven = not ran.isdisjoint(LOADED), not ran.isdisjoint(DRIVEN)
    columns = _columns(task, base)
    if columns:
        loaded, driven = bool({"forces", "motion"} & {*task.targets}), "motion" in task.targets
    inputs = Inputs(task, point, loaded=loaded, driven=driven)
    if inputs.fixed is not None:
        return f"{inputs.fixed} differs"
    return _compiled(task, base, inputs, columns)


def _columns(task: Task, base: RunResult) -> dict[str, Asked]:
    """What is asked for, by name, if it is columns and a few facts alone; else nothing."""
    if not (task.patterns and task.targets) or not COLUMNS.issuperset(base.outcomes):
        return {}
    names = [name for stage in base.results for name, _ in told(stage, base.results[stage], task.patterns)]
    found = {name: each for name in names if (each := asked(name, base)) is not None}
    return found if len(found) == len(names) else {}


def _compiled(task: Task, base: RunResult, inputs: Inputs, columns: dict[str, Asked]) -> Columns | Results | str:
    from tmmcalc.batch.stacked_machine import refusal as machine_refusal
    from tmmcalc.linkage.stacked.scene import refusal as refused
    from tmmcalc.linkage.stacked.scene import same_of

    mechanism, loading, machine = inputs.tree
    same = same_of(mechanism, loading, base.results["kinematics"])
    reason = refused(mechanism, loading, same)
    if reason is not None:
        return reason
    apart = machine is not None and machine_refusal(machine, base) is not None
    if columns and not apart and not (mechanism.input.start is not None and _of_strokes(columns)):
        return Columns(inputs, same, base, columns)
    return Results(task, inputs, same, base, with_motion=not apart)


def _of_strokes(columns: dict[str, Asked]) -> bool:
    """Whether facts of strokes are among what is asked for."""
    return any(each.stage == "kinematics" and not each.of for each in columns.values())
