"""The optimum of a spec: its variables, objectives and constraints; the designs that are found, solved again."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import replace
from itertools import combinations
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.batch.content import key_of
from tmmcalc.batch.journal import Journal
from tmmcalc.batch.reading import frame_of
from tmmcalc.batch.sweep import part
from tmmcalc.core.errors import SpecError, TmmError, UsageError
from tmmcalc.core.headers import key_and_unit
from tmmcalc.core.records import record
from tmmcalc.design.gradient import Gradients
from tmmcalc.design.model import Model, solver_of
from tmmcalc.design.optimize.optimum import Binding, Flatness, Stationarity, bindings, flatness, kinks
from tmmcalc.design.optimize.order import Scores
from tmmcalc.design.optimize.problem import Limit, Objective, Problem, Rule, Variable
from tmmcalc.design.optimize.search import Second, search
from tmmcalc.feasibility.judge import sides
from tmmcalc.feasibility.quantities import limits, of_given, place
from tmmcalc.feasibility.tables.tasks.feasibility import to_feasibility
from tmmcalc.naming.language import parse
from tmmcalc.naming.rows import in_unit
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import one
from tmmcalc.pipeline.hashing import content_hash
from tmmcalc.project.loader import Variants, read_text
from tmmcalc.spec.units import UnitError, dimension_of

if TYPE_CHECKING:
    from tmmcalc.batch.task import Task
    from tmmcalc.design.tables.optimize import OptimizeTable, VariableTable
    from tmmcalc.feasibility.judge import FeasibilityTask
    from tmmcalc.project import Spec
    from tmmcalc.spec.variants import Axis

Values = NDArray[np.floating[Any]]
Told = Callable[[int, str], None]  # designs that are solved; what is being done, and the best so far

SCALE = 1e-2  # of the range of a variable, for steps where derivatives are not exact
EACH = 2000  # designs a variable that may be solved
MOST = 10_000  # values of a variable in steps


@record
class Design:
    """One design: values of the variables, and what it was when it was solved again by itself."""

    values: tuple[float, ...]
    objectives: tuple[float, ...]  # in their own sense
    limits: tuple[float, ...]  # the constrained results
    assignments: tuple[str, ...]  # the overrides that make it
    again: float  # how far the objectives are off when it is solved by itself, relative


@record
class Optimum:
    """What was sought, what was found, and how sure that is."""

    variables: tuple[Variable, ...]
    objectives: tuple[Objective, ...]
    limits: tuple[Limit, ...]
    nominal: tuple[float, ...]  # the objectives of the spec as it is, NaN where it has none
    broken: tuple[str, ...]  # the limits that the spec as it is does not keep
    designs: tuple[Design, ...]  # the best, or the front
    method: str
    complete: bool
    second: Second | None
    binding: tuple[Binding, ...]
    stationarity: Stationarity | None  # of one objective
    exact: bool  # the slopes that it is told by
    ends: tuple[str, ...]  # variables of which a small step has no solution
    flat: tuple[Flatness, ...]
    solved: int
    failed: int
    resumed: int  # of those solved: by an earlier run


def optimize(
    file: Path,
    fixed: Sequence[str] = (),
    *,
    out: Path | None = None,
    fresh: bool = False,
    jobs: int | None = None,
    scheduler: str | None = None,
    tell: Callable[[str], None] = lambda said: None,
    told: Told = lambda solved, words: None,
) -> Optimum:
    """The best design, or the front of designs, by ``[optimize]`` of a spec with overrides ``fixed``.

    What an earlier run has solved is taken from ``out``.part. Raises UsageError for what does not fit, the error of the
    spec as it is, NoSolutionError where no design can be chosen.
    """
    variants = Variants(read_text(file), str(file), file.parent, fixed)
    spec = variants.spec()
    if spec.optimize is None:
        raise UsageError("nothing is sought", where=str(file), remedy="add [optimize] with least = ... to the spec")
    frame, problem_of, nominal = _prepared(file, fixed, spec, jobs, scheduler, tell)
    with ExitStack() as stack:
        journal = None
        if out is not None:
            left = part(out)
            if fresh:
                left.unlink(missing_ok=True)
            journal = stack.enter_context(Journal(left, _key(frame)))
        problem = problem_of(journal)
        result = _found(problem, frame, spec.optimize, nominal, told)
        if journal is not None:
            journal.done = True
    return result


def _key(frame: Task) -> str:
    """Hash of what a search depends on: other random numbers or local searches would ask for other designs."""
    import scipy

    return content_hash((key_of(frame), np.__version__, scipy.__version__))


def _found(problem: Problem, frame: Task, table: OptimizeTable, nominal: Values, told: Told) -> Optimum:
    unit, said = problem.objectives[0].unit, ["first designs"]

    def tell(words: str, best: Scores) -> None:
        kept = best.objectives[best.violation == 0, 0]
        value = problem.objectives[0].sign * float(kept.min(initial=np.inf))
        said.append(
            f"{words}, best {value:.6g} {unit}".rstrip() if kept.size else f"{words}, none keeps constraints yet"
        )

    problem.told = lambda solved: told(solved, said[-1])

    start = np.array([nominal[each.keys[0]] for each in problem.variables])
    budget = table.evaluations or EACH * len(problem.variables)
    course = search(problem, start, budget, table.seed, table.designs, tell)
    single = len(problem.objectives) == 1
    designs = tuple(_design(problem, frame, place) for place in course.places)
    binding: tuple[Binding, ...] = ()
    stationarity, exact = None, False
    ends: tuple[str, ...] = ()
    if single:
        slopes, exact = _slopes(problem, frame, course.places[0])
        broken, ends = kinks(problem, course.places[0])
        slopes[broken] = np.nan
        binding, stationarity = bindings(problem, course.places[0], slopes)
    return Optimum(
        problem.variables,
        problem.objectives,
        problem.rule.limits,
        tuple(float(problem.model.found[each.column]) for each in problem.objectives),
        tuple(each.name for each in problem.rule.limits if not problem.rule.kept(each, problem.model.found[None])[0]),
        designs,
        course.method,
        course.complete,
        course.second,
        binding,
        stationarity,
        exact,
        ends,
        flatness(problem, course.places[0]) if single else (),
        problem.solved,
        sum(map(bool, problem.reasons)),
        problem.resumed,
    )


def _slopes(problem: Problem, frame: Task, place: Values) -> tuple[Values, bool]:
    """Derivatives (m, f) of the results by the variables that take any value, over the unit box; whether all are exact.

    NaN where there is none.
    """
    values = problem.inside(place[None])[0]
    set_to = dict[int, float]()
    for variable, value in zip(problem.variables, values.tolist(), strict=True):
        set_to |= dict.fromkeys(variable.keys, value)
    free = [problem.variables[k] for k in problem.free]
    moved = [key for variable in free for key in variable.keys]
    if not moved:
        return np.zeros((len(problem.model.names), 0)), True
    held = [frame.axes[key].assignment(value) for key, value in set_to.items() if key not in moved]
    here = [set_to[key] for key in moved]
    there = replace(frame, axes=tuple(frame.axes[key] for key in moved), fixed=(*frame.fixed, *held)).at([here])
    spans = [problem.variables[k].stretch(float(values[k])) for k in problem.free]
    sizes = [SCALE * span for variable, span in zip(free, spans, strict=True) for _ in variable.keys]
    gradients = Gradients(there, sizes)
    found = gradients(np.array(here))
    rows = [gradients.names.index(name) for name in problem.model.names]
    ends = np.cumsum([len(variable.keys) for variable in free])[:-1]
    parts = np.split(found.slopes[rows], ends, axis=1)
    slopes = np.array([part.sum(axis=1) * span for part, span in zip(parts, spans, strict=True)]).T
    return slopes, bool(found.exact[rows].all())


def _design(problem: Problem, frame: Task, place: Values) -> Design:
    """A design solved again by the ordinary stages; raises what it raises there."""
    from tmmcalc.batch.points import run_of

    values = problem.inside(place[None])[0]
    results = problem.solve(values[None])[0]
    assignments = [
        frame.axes[key].assignment(float(value))
        for variable, value in zip(problem.variables, values, strict=True)
        for key in variable.keys
    ]
    run = run_of(frame, frame.variants().spec(assignments))
    for error in run.failures.values():
        raise error
    scene = Scene(run.spec, run.results)
    own = [one(parse(problem.model.names[each.column]), run.results, scene).value for each in problem.objectives]
    sought = [float(results[each.column]) for each in problem.objectives]
    off = max(abs(a - b) / (abs(b) or 1.0) for a, b in zip(own, sought, strict=True))
    return Design(
        tuple(values.tolist()),
        tuple(own),
        tuple(float(results[each.column]) for each in problem.rule.limits),
        tuple(assignments),
        off,
    )


def _prepared(
    file: Path,
    fixed: Sequence[str],
    spec: Spec,
    jobs: int | None,
    scheduler: str | None,
    tell: Callable[[str], None],
) -> tuple[Task, Callable[[Journal | None], Problem], Values]:
    """The frame of a spec, the problem for a journal, and the values of its keys as they are."""
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
