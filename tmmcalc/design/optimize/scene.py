"""The optimum of a spec: the course of its search, the designs that are found, solved again, and as ready specs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.batch.content import key_of
from tmmcalc.batch.journal import Journal
from tmmcalc.batch.sweep import part
from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.design.gradient import Gradients
from tmmcalc.design.optimize.optimum import Binding, Flatness, Stationarity, bindings, flatness, kinks
from tmmcalc.design.optimize.order import Scores
from tmmcalc.design.optimize.problem import Limit, Objective, Problem, Variable
from tmmcalc.design.optimize.search import search
from tmmcalc.design.optimize.second import Second
from tmmcalc.design.optimize.task import EACH, prepared
from tmmcalc.naming.language import parse
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import one
from tmmcalc.pipeline.hashing import content_hash
from tmmcalc.project.loader import Variants, read_text
from tmmcalc.spec.override import apply
from tmmcalc.spec.rewrite import Change, Found, value_at

if TYPE_CHECKING:
    from tmmcalc.batch.task import Task
    from tmmcalc.design.tables.optimize import OptimizeTable
    from tmmcalc.project import Spec

Values = NDArray[np.floating[Any]]
Told = Callable[[int, str], None]  # designs that are solved; what is being done, and the best so far

SCALE = 1e-2  # of the range of a variable, for steps where derivatives are not exact


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
    use: Callable[[Optimum], None] = lambda result: None,
) -> Optimum:
    """The best design, or the front of designs, by ``[optimize]`` of a spec with overrides ``fixed``.

    What an earlier run has solved is taken from ``out``.part, which goes once ``use`` has been made of the result, as
    to write it: what goes wrong there loses no design. Raises UsageError for what does not fit, the error of the spec
    as it is, NoSolutionError where no design can be chosen.
    """
    variants = Variants(read_text(file), str(file), file.parent, fixed)
    spec = variants.spec()
    if spec.optimize is None:
        raise UsageError("nothing is sought", where=str(file), remedy="add [optimize] with least = ... to the spec")
    frame, problem_of, nominal = prepared(file, fixed, spec, jobs, scheduler, tell)
    with ExitStack() as stack:
        journal = None
        if out is not None:
            left = part(out)
            if fresh:
                left.unlink(missing_ok=True)
            journal = stack.enter_context(Journal(left, _key(frame)))
        problem = problem_of(journal)
        result = _found(problem, frame, spec.optimize, nominal, told)
        use(result)
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


def found_of(result: Optimum, spec: Spec, choose: int | None = None) -> Found:
    """The changes of a spec that make design ``choose`` of it, from 1."""
    written = spec._written
    assert written is not None
    number = choose or 1
    document, paths = apply(written.document, result.designs[number - 1].assignments)
    of = f"design {number} of {len(result.designs)}" if len(result.designs) > 1 else ""
    return Found(tuple(Change(path, value_at(document, path)) for path in paths), of=of)
