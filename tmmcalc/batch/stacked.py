"""Points solved together: variants of one structure as rows of the same arrays.

Kinematics, forces and the steady motion with a motor go this way, as far as columns of their tables are asked for,
strokes from dead centre to dead centre, or figures of the motion.
Blocks are those of the numbers of the points, so that a point has the same value to the last digit whatever it is
solved with. A variant that is not clear (see `linkage.stacked`) is solved alone, and so is one that fails.
"""

from __future__ import annotations

import re
from array import array
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.batch.points import solve_points as solve_alone
from tmmcalc.batch.points import stages_to
from tmmcalc.batch.quantities import told
from tmmcalc.batch.stacked_inputs import Inputs
from tmmcalc.batch.task import OK, Row, Task
from tmmcalc.errors import TmmError
from tmmcalc.feasibility.judge import OF
from tmmcalc.numerics.alike import MixedError

if TYPE_CHECKING:
    from tmmcalc.batch.stacked_machine import Machine
    from tmmcalc.linkage.forces.results import Forces
    from tmmcalc.linkage.stacked.scene import Block, Same
    from tmmcalc.pipeline.outcome import RunResult

Values = NDArray[np.floating[Any]]
Flags = NDArray[np.bool_]

SOLVER = "tmmcalc.batch.stacked:solve_points"
BLOCK = 128  # variants
FEW = 16  # points that are not worth it
TRIED = 16  # points over the sweep, one of which has to have a solution
STAGES = ("kinematics", "forces", "motion")  # whose columns blocks tell
KNOWN = {*STAGES, "structure", "reduction", "power"}  # that they can do without running them
OTHERS = {"equilibrium", "virtual", "omega_idle", "omega_textbook"}  # columns that no block tells
_COLUMN = re.compile(rf"(\w+)\.({'|'.join(OF)})\((.+)\)(?:\[.*\])?")
_OF: dict[str, Callable[[Values], Values]] = {
    "max": lambda v: np.max(v, axis=1),
    "min": lambda v: np.min(v, axis=1),
    "range": lambda v: np.ptp(v, axis=1),
    "mean": lambda v: np.mean(v, axis=1),
    "size": lambda v: np.max(np.abs(v), axis=1),
    "first": lambda v: v[:, 0],
    "last": lambda v: v[:, -1],
}


class Asked(NamedTuple):
    """One quantity: what is asked of which column of which stage."""

    stage: str
    of: str  # empty: a fact of its summary
    column: str


def together(task: Task) -> bool:
    """Whether the points of a task are to be solved together: they can be, and they are not a few."""
    return task.count >= FEW and refusal(task) is None


def way(task: Task) -> str:
    """How the points of a task are solved, in words; nothing of a few points."""
    if task.count < FEW:
        return ""
    reason = refusal(task)
    return "variants solved together" if reason is None else f"variants solved one by one: {reason}"


def refusal(task: Task) -> str | None:
    """Why the points of a task cannot be solved together; None if they can."""
    made = prepared(task)
    return made if isinstance(made, str) else None


def prepared(task: Task) -> Together | str:
    """What all blocks of a task need, or why it cannot be solved in blocks."""
    return _together(replace(task, solver="", block=0))  # whoever solves it


def solve_points(task: Task, points: Sequence[int]) -> list[Row]:
    """Rows of the points, in their order; those that cannot be solved together are solved alone."""
    together = prepared(task)
    found: dict[int, Row] = {}
    if not isinstance(together, str):
        for block in dict.fromkeys(point // BLOCK for point in points):
            found.update(together.rows(range(block * BLOCK, min((block + 1) * BLOCK, task.count))))
    rest = [point for point in points if point not in found]
    found.update((row.point, row) for row in solve_alone(task, rest))
    return [found[point] for point in points]


@lru_cache(maxsize=2)
def _together(task: Task) -> Together | str:
    if task.tolerance is not None or not task.patterns or not task.targets:
        return "all facts of stages, or a tolerance, are asked for"
    others = [target for target in task.targets if target not in STAGES]
    if others:
        return f"{', '.join(others)} is asked for"
    further = range(0, task.count, max(1, task.count // TRIED))
    for point in dict.fromkeys((*task.spread(), *further)):
        try:
            return _made(task, point)
        except TmmError:
            continue
    return "no variant that was tried has a solution"


def _made(task: Task, point: int) -> Together | str:
    from tmmcalc.pipeline.runner import run

    spec = task.variants().spec(task.assignments(point))
    stages = stages_to(spec, task.targets)
    others = [name for name in stages if name not in KNOWN]
    if others:
        return f"{', '.join(others)} has to be solved too"
    base = run(spec, stages=stages)
    names = tuple(name for stage in base.results for name, _ in told(stage, base.results[stage], task.patterns))
    asked = [_asked(name, base) for name in names]
    lacking = next((name for name, found in zip(names, asked, strict=True) if found is None), None)
    if lacking is not None:
        return f"{lacking} is nothing that blocks tell"
    inputs = Inputs(task, point, {"forces", "motion"} & {*task.targets} != set(), "motion" in task.targets)
    if inputs.fixed is not None:
        return f"{inputs.fixed} differs"
    return _compiled(base, inputs, names, tuple(filter(None, asked)))


def _asked(name: str, base: RunResult) -> Asked | None:
    """What a name asks for; None for what blocks do not tell."""
    from tmmcalc.linkage.stacked.tables import STROKES
    from tmmcalc.machine.stacked import FIGURES

    column = _COLUMN.fullmatch(name)
    if column is not None:
        return Asked(*column.groups()) if column[1] in STAGES and column[3] not in OTHERS else None
    stage, _, fact = name.rpartition("[")[0].partition(".") if name.endswith("]") else name.partition(".")
    if stage == "motion" and fact in FIGURES:
        return Asked(stage, "", fact)
    kind, _, output = fact.partition("_")
    kinematics = base.results["kinematics"]
    first = kinematics.outputs[0] if kinematics.outputs else None
    return Asked(stage, "", kind) if stage == "kinematics" and kind in STROKES and output == first else None


def _compiled(base: RunResult, inputs: Inputs, names: tuple[str, ...], asked: tuple[Asked, ...]) -> Together | str:
    from tmmcalc.batch.stacked_machine import refusal as machine_refusal
    from tmmcalc.linkage.stacked.scene import refusal as refused
    from tmmcalc.linkage.stacked.scene import same_of

    mechanism, loading, machine = inputs.tree
    if any(each.stage == "kinematics" and not each.of for each in asked) and mechanism.input.start is not None:
        return "strokes, with position 0 given"
    same = same_of(mechanism, loading, base.results["kinematics"])
    reason = refused(mechanism, loading, same) or (machine_refusal(machine, base) if machine else None)
    return reason or Together(inputs, same, base, names, asked)


class Together:
    """Solves blocks of points of a task whose variants are like one that is solved."""

    def __init__(
        self, inputs: Inputs, same: Same, base: RunResult, names: tuple[str, ...], asked: tuple[Asked, ...]
    ) -> None:
        self._inputs, self._same, self._base = inputs, same, base
        self._names, self._asked = names, asked
        self._tracked = any(each.column.startswith(("angle_", "S_")) for each in asked)
        self._solved = lru_cache(maxsize=4)(self._rows)  # neighbouring blocks, when points are asked for one by one

    def rows(self, points: range) -> dict[int, Row]:
        """Rows of those points of a block that are solved together."""
        return self._solved(points)

    def _rows(self, points: range) -> dict[int, Row]:
        numbers, there = self._inputs.numbers(points)
        found: dict[int, Row] = {}
        for which, values, clear in self._parts(numbers, np.flatnonzero(there)):
            clear = clear & np.all(np.isfinite(values), axis=1)
            for place, row in zip(which[clear].tolist(), values[clear], strict=True):
                found[points[place]] = Row(points[place], OK, "", self._names, array("d", row.tolist()))
        return found

    def _parts(self, numbers: Any, which: Any) -> Iterator[tuple[Any, Values, Flags]]:
        """Values (v, names) of the variants ``which`` (v,), in parts whose constants answer all questions alike."""
        if not which.size:
            return
        try:
            yield which, *self._block(self._inputs.stacked(numbers[which]), len(which))
        except (TmmError, TypeError, ValueError, LookupError):
            return  # asked for what one number alone can tell, or for what the solved variant has not: each alone
        except MixedError:
            if len(which) > 1:
                half = len(which) // 2
                yield from self._parts(numbers, which[:half])
                yield from self._parts(numbers, which[half:])

    def _block(self, tree: Any, count: int) -> tuple[Values, Flags]:
        """Values (v, names) of stacked inputs, and which of the variants are clear."""
        from tmmcalc.linkage.stacked.scene import block_of
        from tmmcalc.linkage.stacked.tables import strokes_of

        mechanism, loading, machine = tree
        block = block_of(self._same, count, mechanism, loading, self._tracked)
        values, clear = np.zeros((count, len(self._names))), block.settled.clear.copy()
        targets = {each.stage for each in self._asked}
        if machine is not None:
            self._motion(block, machine, values, clear)
        self._facts("kinematics", strokes_of(block) if block.settled.reached.size else {}, slice(None), values)
        for part in block.parts(block.labels):
            some = part[clear[part]]
            if some.size and "kinematics" in targets:
                self._kinematics(block, some, values)
            if some.size and "forces" in targets:
                clear[some] &= self._forces(block, some, values, machine is None)
        return values, clear

    def _kinematics(self, block: Block, some: Any, values: Values) -> None:
        from tmmcalc.linkage.columns import columns
        from tmmcalc.linkage.stacked.tables import kinematics_of

        self._write("kinematics", columns(kinematics_of(block, some)), some, values)

    def _forces(self, block: Block, some: Any, values: Values, between: bool) -> Flags:
        from tmmcalc.linkage.forces.columns import columns
        from tmmcalc.linkage.stacked.tables import forces_of

        base: Forces = self._base.results["forces"]
        found, clear = forces_of(block, some, base, between)
        self._write("forces", columns(found), some, values)
        return clear

    def _motion(self, block: Block, machine: Machine, values: Values, clear: Flags) -> None:
        from tmmcalc.batch.stacked_machine import motions_of
        from tmmcalc.machine.columns import motion_columns

        some = np.flatnonzero(clear)
        if some.size:
            wanted = {each.column for each in self._asked if each.stage == "motion"}
            found, figures, clear[some] = motions_of(block, some, machine, self._base.results["motion"], wanted)
            self._write("motion", motion_columns(found), some, values)
            self._facts("motion", figures, some, values)

    def _write(self, stage: str, columns: Sequence[Any], some: Any, values: Values) -> None:
        """Write what is asked of columns with the rows of some variants (v,)."""
        made: dict[str, Values] = {}
        by_name = {column.name: column for column in columns}
        for k, asked in enumerate(self._asked):
            if asked.stage == stage and asked.of:
                if asked.column not in made:
                    made[asked.column] = np.asarray(by_name[asked.column].make(), float).reshape(len(some), -1)
                values[some, k] = _OF[asked.of](made[asked.column])

    def _facts(self, stage: str, found: dict[str, Values], some: Any, values: Values) -> None:
        """Write what is asked of facts (v,) of some variants."""
        for k, asked in enumerate(self._asked):
            if asked.stage == stage and not asked.of:
                values[some, k] = found[asked.column]
