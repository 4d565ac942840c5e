"""Candidates judged: linkage and forces of many at once by the batch engine, all stages of those that are left."""

from __future__ import annotations

import json
import re
from array import array
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.batch.choice import heavy, local
from tmmcalc.batch.executors import Solve
from tmmcalc.batch.local import available, cores
from tmmcalc.batch.places import Place
from tmmcalc.batch.reading import frame_of
from tmmcalc.batch.task import BROKEN, INVALID, OK, Row, Task, verdict
from tmmcalc.classroom import demands
from tmmcalc.classroom.demands import DEAD, TIE, Limits, Refusal, Spread, limits_of
from tmmcalc.classroom.draws import Candidate, Drawn, drawn_of, spans
from tmmcalc.classroom.faults import Faults
from tmmcalc.classroom.items import class_of, items_of
from tmmcalc.classroom.rounding import Floors
from tmmcalc.core.errors import TmmError, UsageError
from tmmcalc.core.records import record
from tmmcalc.design.model import Model
from tmmcalc.feasibility.quantities import place
from tmmcalc.feasibility.tables.tasks.feasibility import to_feasibility
from tmmcalc.naming.language import parse
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import Told, one, told
from tmmcalc.pipeline.outcome import Watch
from tmmcalc.pipeline.runner import run
from tmmcalc.project.loader import Variants, read_text
from tmmcalc.rooms import STAGES
from tmmcalc.spec.rewrite import without
from tmmcalc.spec.units import conversion

if TYPE_CHECKING:
    from tmmcalc.classroom.model import Item
    from tmmcalc.classroom.tables.class_ import ClassTable
    from tmmcalc.pipeline.outcome import RunResult
    from tmmcalc.project import Spec

Values = NDArray[np.floating[Any]]

CHEAP = ("structure", "kinematics", "paths", "forces")  # stages of which many variants are solved at once
SOLVER = "tmmcalc.classroom.judging:solve_whole"
GROWTH = "kinematics.amplification_max_*"
ROOM = 2.0  # times the growth of the assignment, where that is near to a dead point itself
_NUMBERS = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


@record
class Verdict:
    """What all stages say of a candidate: why it is refused, or what it has of the asked results."""

    refusal: Refusal | None
    values: tuple[float, ...] = ()  # of the items, in the units of the results


class Judge:
    """The demands of an assignment, and who holds candidates against them.

    Raises the error of the assignment as it is, and UsageError for what does not fit.
    """

    def __init__(self, file: Path, jobs: int | None = None, tell: Callable[[str], None] = lambda said: None) -> None:
        variants = Variants(read_text(file), str(file), file.parent)
        self.spec: Spec = variants.spec()
        self.table: ClassTable = drawing(self.spec)
        task = to_feasibility(self.spec)
        limited = {each.name: each for each in task.constraints if each.given is None}
        names = [*(each.result for each in self.table.asked), *(each.asked.text for each in limited.values())]
        keys = [key for each in self.table.drawn for key in each.of]
        frame = frame_of(file, (), keys, names)
        faults = Faults(self.spec)
        with faults.gathered():
            self.drawn: tuple[Drawn, ...] = drawn_of(self.spec, frame.axes)
        self.run: RunResult = run(self.spec)
        scene = Scene(self.run.spec, self.run.results)
        with faults.gathered():
            self.items: tuple[Item, ...] = items_of(self.spec, self.run)
        faults.tell()
        found = [one(parse(each.result), self.run.results, scene) for each in self.table.asked]
        self.asked: tuple[Told, ...] = tuple(found)
        found += [_of_constraint(each.asked.text, place(each), self.run, scene) for each in limited.values()]
        own = {told.key: at for at, told in reversed([*enumerate(found)])}
        self._columns = tuple(own)
        at = [self._columns.index(each.key) for each in found]
        self._asked, rest = at[: len(self.asked)], at[len(self.asked) :]
        pairs = zip(limited, rest, found[len(self.asked) :], strict=True)
        columns = {name: (column, told.value, told.unit) for name, column, told in pairs}
        self.limits: Limits = limits_of(task, columns, float(self.table.margin))
        floors = Floors(self.run.results)
        self.spreads = tuple(
            Spread.of(item.name, floors.settled(each), float(self.table.spread), item.within / by)
            for item, each, by in zip(self.items, self.asked, self.factors, strict=True)
        )
        bare = without(frame.text, "class")  # it is checked once, and not again for each candidate
        self.frame = replace(frame, text=bare, patterns=(*self._columns, GROWTH), targets=(), solver=SOLVER)
        grown = max(_growths(self.run), default=0.0)
        self._growth = DEAD if grown <= DEAD else ROOM * grown
        self._known = {*_warnings(self.run)}
        self.processes = jobs or (cores() if heavy(self.frame) and available() else 1)
        self.solver: Solve = local(self.processes, tell, kept=True)

    @property
    def factors(self) -> tuple[float, ...]:
        """What values of the items in the units of results are multiplied by for their own units."""
        pairs = zip(self.items, self.asked, strict=True)
        return tuple(conversion(each.unit, item.unit) for item, each in pairs)

    def keyed(self, each: Candidate) -> list[float]:
        """Values of all keys of a candidate, in the units in which the spec writes them."""
        pairs = zip(self.drawn, each.values, strict=True)
        return [float(value) for drawn, value in pairs for _ in drawn.axes]

    def at_once(self, candidates: Sequence[Candidate], *, alike: bool = True) -> dict[int, Refusal | None]:
        """Why candidates are refused by their linkage and forces alone, None where they are not, by their numbers.

        ``alike``: of those alone that can be solved together, which cost next to nothing; of some linkages none can.
        """
        if self._cheap is None or not candidates:
            return {each.number: None for each in candidates}
        model, asked, limits = self._cheap
        places = ((each.number, self.keyed(each)) for each in candidates)
        rows = [row for some in model.rows(places, alike=alike) for row in some]
        values = model.answers(rows).values
        broken = limits.broken(values)
        found: dict[int, Refusal | None] = {}
        for row, own, constraint in zip(sorted(rows, key=lambda row: row.point), values, broken, strict=True):
            found[row.point] = _refused(row) if row.reason else self._cheaply(own, asked, constraint)
        return found

    def _cheaply(self, values: Values, asked: Mapping[int, int], constraint: str) -> Refusal | None:
        """Why results (m,) of linkage and forces are refused; ``asked`` are their columns by the items."""
        for item, column in asked.items():
            if not np.isfinite(values[column]):
                return demands.valueless(self.items[item].name)
        if constraint:
            return demands.constrained(constraint)
        refusals = (self.spreads[item].refusal(float(values[column])) for item, column in asked.items())
        return next((each for each in refusals if each is not None), None)

    def whole(self, candidates: Sequence[Candidate]) -> Iterator[Row]:
        """Rows of all stages of candidates, in any order."""
        places = [[Place(each.number, tuple(self.keyed(each)))] for each in candidates]
        for some in self.solver(self.frame, places):
            yield from some

    def verdict(self, row: Row) -> Verdict:
        """What such a row says."""
        if row.status == BROKEN:
            raise RuntimeError(row.reason)
        if not row.ok:
            return Verdict(_refused(row))
        known = dict(zip(row.names, row.values, strict=True))
        for item, each in zip(self.items, self.asked, strict=True):
            if each.key not in known:
                return Verdict(demands.valueless(item.name))
        lost = next((key for key in self._columns if key not in known), None)
        if lost is not None:
            return Verdict(demands.valueless(lost))
        growth = max((value for key, value in known.items() if _is_growth(key)), default=0.0)
        if growth > self._growth * (1 + TIE):
            return Verdict(demands.dead(growth))
        values = np.array([[known[key] for key in self._columns]])
        if broken := self.limits.broken(values)[0]:
            return Verdict(demands.constrained(broken))
        for spread, each in zip(self.spreads, self.asked, strict=True):
            if (refusal := spread.refusal(known[each.key])) is not None:
                return Verdict(refusal)
        fresh = [each for each in json.loads(row.reason or "[]") if each not in self._known]
        if fresh:
            return Verdict(demands.warned(fresh[0]))
        return Verdict(None, tuple(known[each.key] for each in self.asked))

    @cached_property
    def _cheap(self) -> tuple[Model, dict[int, int], Limits] | None:
        """Results of linkage and forces as a function of the keys, the columns of items there, and the limits on them.

        None where nothing of them is asked.
        """
        cheap = [key for key in self._columns if parse(key).stage in CHEAP]
        if not cheap:
            return None
        wanted = {parse(name).stage for name in cheap}
        targets = tuple(name for name in STAGES if name in wanted)
        model = Model(replace(self.frame, patterns=tuple(cheap), targets=targets), brief=True)
        ends = [span for span, each in zip(spans(self.drawn), self.drawn, strict=True) for _ in each.axes]
        low, high = (np.array([float(end[side]) for end in ends]) for side in (0, 1))
        near = model.over(range(len(low)), low, high, model.nominal.tolist())
        places = {self._columns.index(name): at for at, name in enumerate(near.names)}
        asked = {item: places[column] for item, column in enumerate(self._asked) if column in places}
        return near, asked, self.limits.among(places)


def drawing(spec: Spec) -> ClassTable:
    """The table ``[class]`` of an assignment in which something is drawn; raises UsageError for another spec."""
    table = class_of(spec)
    if not table.drawn:
        where = spec._written.file if spec._written is not None else ""
        raise UsageError(
            "nothing is drawn", where=where, remedy="add [[class.drawn]]: what each variant has its own of"
        )
    return table


def _of_constraint(name: str, where: str, of: RunResult, scene: Scene) -> Told:
    try:
        return one(parse(name), of.results, scene)
    except UsageError as error:
        raise UsageError(error.message, where=where, remedy=error.remedy) from None


def solve_whole(task: Task, places: Sequence[Place]) -> list[Row]:
    """Rows of places by all stages: what is asked of them, and their warnings as the reason, or why there is none.

    Nothing is raised for a variant: its row says why it failed, after the name of the stage.
    """
    variants = task.variants()
    rows = []
    for each in places:
        axes = zip(task.axes, each.values, strict=True)
        rows.append(_whole(task, variants, each.point, [axis.assignment(value) for axis, value in axes]))
    return rows


def _whole(task: Task, variants: Variants, point: int, overrides: Sequence[str]) -> Row:
    at = ["spec"]
    try:
        result = run(variants.spec(overrides), watch=Watch(at.append), by_name=True)
        scene = Scene(result.spec, result.results)
        names = [*map(parse, task.patterns)]
        floors = Floors(result.results)
        found = {each.key: floors.settled(each) for each in told(result.results, names, scene)}
        found = {key: value for key, value in found.items() if np.isfinite(value)}
        return Row(point, OK, json.dumps(_warnings(result)), tuple(found), array("d", found.values()))
    except TmmError as error:
        status, reason = verdict(error)
        return Row(point, status, f"{at[-1]}: {reason}")
    except Exception as fault:  # one variant that breaks the program must not end the others
        return Row(point, *verdict(fault))


def _warnings(result: RunResult) -> list[str]:
    """The warnings of all stages without their numbers and places, each with its stage."""
    found = []
    for name in result.outcomes:
        document = STAGES[name].summary(result.results[name], name)
        for note in (note for part in (document, *document.parts) for note in part.notes):
            if note.startswith("warning"):
                text = getattr(note, "text", note.removeprefix("warning: "))
                found.append(f"{name}: {getattr(text, 'template', _NUMBERS.sub('#', text))}")
    return sorted({*found})


def _growths(result: RunResult) -> list[float]:
    if "kinematics" not in result.results:
        return []
    return [each.value for each in told(result.results, [parse(GROWTH)]) if _is_growth(each.key)]


def _is_growth(key: str) -> bool:
    return key.startswith(GROWTH[:-1]) and not key.endswith("]")


def _refused(row: Row) -> Refusal:
    """Why a candidate has no results, by the reason of its row."""
    stage, _, reason = row.reason.partition(": ")
    if row.status == INVALID:
        return demands.unfit(reason)
    return demands.unsolved(stage.partition(",")[0], reason)
