"""What all blocks of a task need: made by one variant that has a solution, or why blocks cannot be solved together."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from tmmcalc.batch.content import hash_of_files
from tmmcalc.batch.points import scene_to
from tmmcalc.batch.quantities import between_rows, by_choice, told
from tmmcalc.batch.stacked_columns import Asked, Columns, asked
from tmmcalc.batch.stacked_inputs import Inputs
from tmmcalc.batch.stacked_machine import MACHINE
from tmmcalc.batch.stacked_results import Results
from tmmcalc.batch.task import Task, verdict
from tmmcalc.core.errors import TmmError, UsageError
from tmmcalc.naming.language import Name, parse

if TYPE_CHECKING:
    from collections.abc import Sequence

    from tmmcalc.pipeline.outcome import RunResult

TRIED = 16  # points over the sweep, one of which has to have a solution
COLUMNS = frozenset({"structure", "kinematics", "paths", "forces", "reduction", "power", "motion"})  # their columns do
LOADED = ("forces", "reduction")  # stages that read what acts on the linkage


def prepared(task: Task) -> Columns | Results | str:
    """What all blocks of a task need, or why it cannot be solved in blocks."""
    return _prepared(replace(task, solver="", block=0), hash_of_files(task))  # whoever solves it


@lru_cache(maxsize=2)
def _prepared(task: Task, files: str) -> Columns | Results | str:
    """The same; ``files`` tells apart what else would have been made of files that have changed."""
    if task.tolerance is not None:
        return "a tolerance is asked for"
    if between_rows(task.patterns):
        return "places between rows are asked for"
    reason = "no variant that was tried has a solution"
    for point in _tried(task):
        try:
            return _solver(task, point)
        except UsageError as error:
            return f"{error.where}: {error.message}"
        except TmmError:
            continue
        except Exception as fault:  # of this point perhaps: solved alone it says so
            reason = verdict(fault)[1]
    return reason


def _tried(task: Task) -> list[int]:
    """Points over the sweep; first those with the most values that are not zero: a zero hides what others have."""
    further = range(0, task.count, max(1, task.count // TRIED))
    points = dict.fromkeys((*task.spread(), *further))
    return sorted(points, key=lambda point: -int(np.count_nonzero(task.values(point))))


def _solver(task: Task, point: int) -> Columns | Results | str:
    from tmmcalc.pipeline.runner import run

    spec = task.variants().spec(task.assignments(point))
    if spec.mechanism is None:
        return "there is no linkage"
    base = run(spec, target=task.targets or None, scene=scene_to(spec, task.targets))
    ran = {*base.outcomes}
    if "kinematics" not in ran:
        return "no motion of the linkage is asked for"
    if spec.reduction is not None and spec.reduction.rods == "lumped" and "reduction" in ran:
        return "rods are lumped in two masses"
    if "reduction" in ran and spec.cam is not None and spec.cam.shaft is not None:
        return "a cam loads a shaft of the machine"
    if by_choice(task.patterns, base.results, base.spec):
        return "columns or facts by choice are asked for"
    loaded, driven, traced = not ran.isdisjoint(LOADED), not ran.isdisjoint(MACHINE), "paths" in ran
    columns = _columns(task, base)
    if columns:
        targets = {*task.targets}
        loaded, driven, traced = bool({"forces", "motion"} & targets), "motion" in targets, "paths" in targets
    inputs = Inputs(task, point, loaded=loaded, driven=driven, traced=traced)
    if inputs.fixed is not None:
        return f"{inputs.fixed} differs"
    return _compiled(task, base, inputs, columns)


def _columns(task: Task, base: RunResult) -> dict[str, Asked]:
    """What is asked for, by name, if it is columns and a few facts alone; else nothing."""
    if not (task.patterns and task.targets) or not COLUMNS.issuperset(base.outcomes):
        return {}
    names = [name for name, _ in told(base.results, task.patterns)]
    if _told_by_others(task.patterns, names, base):
        return {}
    found = {name: each for name in names if (each := asked(name, base)) is not None}
    return found if len(found) == len(names) else {}


def _told_by_others(patterns: Sequence[str], names: Sequence[str], base: RunResult) -> bool:
    """Whether wildcards ask for strokes that the base has not, as its output goes round, and others may have."""
    from tmmcalc.linkage.stacked.tables import STROKES

    found = {parse(name).what for name in names}
    strokes = (
        Name("kinematics", "", f"{kind}_{out}") for kind in STROKES for out in base.results["kinematics"].outputs
    )
    asked_for = [name._replace(unit=None) for name in map(parse, patterns) if name.fact and name.wild]
    return any(each.what not in found and any(name.fits(each) for name in asked_for) for each in strokes)


def _compiled(task: Task, base: RunResult, inputs: Inputs, columns: dict[str, Asked]) -> Columns | Results | str:
    from tmmcalc.batch.stacked_machine import refusal as machine_refusal
    from tmmcalc.linkage.stacked.scene import refusal as refused
    from tmmcalc.linkage.stacked.scene import same_of

    mechanism, loading, machine, _ = inputs.tree
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
    from tmmcalc.linkage.stacked.tables import STROKES

    return any(each.stage == "kinematics" and not each.of and each.column in STROKES for each in columns.values())
