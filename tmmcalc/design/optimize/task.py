"""From the tables of a spec to the problem: variables, objectives and constraints, by the results of a model."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import combinations
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.batch.journal import Journal
from tmmcalc.batch.reading import frame_of
from tmmcalc.core.errors import SpecError, TmmError, UsageError
from tmmcalc.core.headers import key_and_unit
from tmmcalc.design.model import Model, solver_of
from tmmcalc.design.optimize.problem import Limit, Objective, Problem, Rule, Variable
from tmmcalc.feasibility.judge import sides
from tmmcalc.feasibility.quantities import limits, of_given, place
from tmmcalc.feasibility.tables.tasks.feasibility import to_feasibility
from tmmcalc.naming.language import parse
from tmmcalc.naming.rows import in_unit
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import one
from tmmcalc.spec.units import UnitError, dimension_of

if TYPE_CHECKING:
    from tmmcalc.batch.task import Task
    from tmmcalc.design.tables.optimize import OptimizeTable, VariableTable
    from tmmcalc.feasibility.judge import FeasibilityTask
    from tmmcalc.project import Spec
    from tmmcalc.spec.variants import Axis

Values = NDArray[np.floating[Any]]

EACH = 2000  # designs a variable that may be solved
MOST = 10_000  # values of a variable in steps


def prepared(
    file: Path,
    fixed: Sequence[str],
    spec: Spec,
    jobs: int | None,
    scheduler: str | None,
    tell: Callable[[str], None],
) -> tuple[Task, Callable[[Journal | None], Problem], Values]:
    """The frame of a spec, the problem for a journal, and the values of its keys as they are.

    Raises UsageError for names, keys and limits that do not fit, and the error of the spec as it is.
    """
    table = spec.optimize
    assert table is not None
    keys = [key for variable in table.variables for key in variable.of]
    task = to_feasibility(spec)
    asking = {each.asked.text: place(each) for each in task.constraints if each.given is None}
    asking |= {name: f"optimize.{sense}" for sense in ("least", "greatest") for name in getattr(table, sense)}
    names = [*asking]
    frame = frame_of(file, fixed, keys, names)
    variables, at = [], 0
    for number, variable in enumerate(table.variables):
        axes = frame.axes[at : at + len(variable.of)]
        variables.append(_variable(variable, axes, at, frame, f"optimize.variables[{number}]"))
        at += len(axes)
    solver = solver_of(frame, EACH * len(variables), jobs, scheduler, tell)
    try:
        model = Model(frame, solver, brief=True, where=asking.__getitem__)
    except UsageError as error:
        asked = next((where for name, where in asking.items() if parse(name).stage == error.where), None)
        if asked is None:
            raise
        raise UsageError(f"{error.where} does not run: {error.message}", where=asked, remedy=error.remedy) from None
    low, high = np.empty(len(keys)), np.empty(len(keys))
    for each in variables:
        low[[*each.keys]], high[[*each.keys]] = each.low, each.high
    near = model.over(range(len(keys)), low, high)
    objectives, rule = _objectives(model, table), _rule(model, task)
    return frame, lambda journal: Problem(variables, objectives, rule, near, journal), model.nominal


def _objectives(model: Model, table: OptimizeTable) -> list[Objective]:
    """The results that are sought; raises UsageError where two names mean one."""
    columns = _columns(model)
    objectives = [_objective(model, columns, name, 1) for name in table.least]
    objectives += [_objective(model, columns, name, -1) for name in table.greatest]
    for one_of, other in combinations(objectives, 2):
        if one_of.column == other.column:
            said = f"{one_of.name} and {other.name} are the same result"
            raise UsageError(said, where="optimize", remedy="remove one of them")
    return objectives


def _rule(model: Model, task: FeasibilityTask) -> Rule:
    """The constraints on results, in their units, those that are given, and how all are combined."""
    columns, scene = _columns(model), Scene(model.run.spec, model.run.results)
    given: dict[str, float] = {}
    limited: list[Limit] = []
    for constraint in task.constraints:
        if constraint.given is not None:
            value, unit = of_given(constraint)
            given[constraint.name] = float(min(sides(value, *limits(constraint, unit))))
        else:
            found = one(constraint.asked, model.run.results, scene)
            ends = limits(constraint, found.unit)
            limited.append(Limit(constraint.name, columns[found.key], found.unit, *ends))
    return Rule(tuple(limited), given, task.rule, task.form, task.m)


def _columns(model: Model) -> dict[str, int]:
    """The place of each result by its name without a unit, or with."""
    return {key: at for at, name in enumerate(model.names) for key in (name, key_and_unit(name)[0])}


def _objective(model: Model, columns: dict[str, int], name: str, sign: int) -> Objective:
    found = one(parse(name), model.run.results, Scene(model.run.spec, model.run.results))
    return Objective(name, found.unit, columns[found.key], sign)


def _variable(table: VariableTable, axes: Sequence[Axis], at: int, frame: Task, where: str) -> Variable:
    """A variable with its values in the unit of its keys; raises UsageError for limits that do not fit."""
    first = axes[0]
    unit = first.unit or first.si
    odd = next((axis for axis in axes if (axis.unit or axis.si) != unit), None)
    if odd is not None:
        rule = f"{odd.key} is in {odd.unit or odd.si or 'no unit'}, {first.key} in {unit or 'no unit'}"
        raise UsageError(rule, where=where, remedy="write the spec in one unit, or two variables")
    keys = tuple(range(at, at + len(axes)))
    try:
        if table.among is not None:
            among = tuple(sorted(_in(unit, each) for each in table.among))
            return Variable(first.key, keys, unit, among[0], among[-1], among)
        assert table.at_least is not None
        assert table.at_most is not None
        low, high = _in(unit, table.at_least), _in(unit, table.at_most)
        step = _in(unit, table.step) if table.step is not None else 0.0
        if not step and _whole(frame, first):
            step, low = 1.0, float(math.ceil(low))
    except UnitError as error:
        raise UsageError(str(error), where=where, remedy=f"write it in {unit}" if unit else "write numbers") from None
    if not step:
        return Variable(first.key, keys, unit, low, high)
    count = int((high - low) / step * (1 + 1e-12)) + 1
    if count > MOST:
        rule = f"{count} values are more than {MOST}"
        raise UsageError(rule, where=where, value=count, limit=MOST, remedy="write a larger step, or none")
    among = tuple(float(f"{low + i * step:.15g}") for i in range(count))
    return Variable(first.key, keys, unit, low, among[-1], among)


def _in(unit: str, value: float | str) -> float:
    """A limit in the unit of a key; a bare number is in it already, as the spec writes it."""
    if isinstance(value, str) and not unit and dimension_of(value) is not None:
        raise UnitError(f"{value!r} has a unit, and the key has none")
    return in_unit(value, unit)


def _whole(frame: Task, axis: Axis) -> bool:
    """Whether a key takes whole numbers alone: half of one more is refused."""
    if axis.values[0] != int(axis.values[0]):
        return False
    try:
        frame.variants().spec([axis.assignment(axis.values[0] + 0.5)])
    except SpecError as error:
        return any("whole number" in f"{fault.message} {fault.remedy}" for fault in error.faults)
    except TmmError:
        return False
    return False
