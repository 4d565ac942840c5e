"""What is sought as a function of the unit box: variables in, objectives and constraints of designs out.

Every design is solved once: designs that a search asks for again, as whole numbers make it do, are known. What is
solved is numbered as it is asked for, so that a journal of an earlier run answers the same questions again.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import reduce
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.batch.journal import Journal
from tmmcalc.batch.task import BROKEN, Row
from tmmcalc.core.records import record
from tmmcalc.design.model import Model
from tmmcalc.design.optimize.order import Scores
from tmmcalc.feasibility.judge import sides
from tmmcalc.feasibility.logic import Form, conjunction
from tmmcalc.feasibility.rule import function

Values = NDArray[np.floating[Any]]
Told = Callable[[int], None]  # designs that are solved

BEYOND = 0.1  # of the box, that steps about a design may go beyond it
DECADES = 100.0  # times its least value the greatest is, from where on a range is wide
TINY = 1e-300
SMALL = 1e-6  # of what designs have of an objective: less is nothing
BLOCK = 256  # designs that are solved and stored at once
START = 1024  # designs that there is room for at the beginning
FIRST = 1024  # designs before a search has come near to an optimum
INSIDE = 1e-9  # of a limit: by how much local searches stay off it, so that rounding breaks none


@record
class Variable:
    """A number that is changed: its keys by their places among those of the model, and its values."""

    name: str
    keys: tuple[int, ...]
    unit: str
    low: float
    high: float
    among: tuple[float, ...] = ()  # in rising order; empty: any from low to high

    @property
    def wide(self) -> bool:
        """Whether the range goes over decades, in whose logarithm it is then searched evenly."""
        return not self.among and self.low > 0 and self.high >= DECADES * self.low

    def value(self, part: Values) -> Values:
        """Values (n,) at parts (n,) of the range from 0 to 1."""
        if self.wide:
            return np.asarray(self.low * (self.high / self.low) ** part)
        if not self.among:
            return np.asarray(self.low + part * (self.high - self.low))
        index = np.minimum((part * len(self.among)).astype(int), len(self.among) - 1)
        return np.asarray(self.among)[np.maximum(index, 0)]

    def part(self, value: Values) -> Values:
        """The parts of the range at values (n,); of values that are listed the middle of that of the nearest."""
        if self.wide:
            return np.asarray(np.log(np.maximum(value, TINY) / self.low) / math.log(self.high / self.low))
        if not self.among:
            return np.asarray((value - self.low) / (self.high - self.low))
        nearest = np.argmin(np.abs(np.asarray(self.among) - np.asarray(value)[..., None]), axis=-1)
        return np.asarray((nearest + 0.5) / len(self.among))

    def stretch(self, value: float) -> float:
        """Change of the value for a change of its part, where it takes any."""
        return value * math.log(self.high / self.low) if self.wide else self.high - self.low


@record
class Objective:
    """A result that is sought: its place among those of the model, 1 where less is better and -1 where more is."""

    name: str
    unit: str
    column: int
    sign: int


@record
class Limit:
    """A constraint on a result by its place among those of the model, with limits in its unit."""

    name: str
    column: int
    unit: str
    at_least: float | None
    at_most: float | None


@record
class Rule:
    """The constraints, those that are given (their functions by name), and how all are combined."""

    limits: tuple[Limit, ...]
    given: Mapping[str, float]
    rule: str  # empty: all hold
    form: Form
    m: int

    @property
    def plain(self) -> bool:
        """Whether all limits have to hold, each by itself."""
        return self.rule in ("", " and ".join((*(each.name for each in self.limits), *self.given)))

    def moved(self, name: str, side: str, by: float) -> Rule:
        """The same with one side of a limit moved by so much."""
        moved = []
        for each in self.limits:
            if each.name == name and side == "at least" and each.at_least is not None:
                each = replace(each, at_least=each.at_least + by)
            elif each.name == name and side == "at most" and each.at_most is not None:
                each = replace(each, at_most=each.at_most + by)
            moved.append(each)
        return replace(self, limits=tuple(moved))

    def kept(self, limit: Limit, results: Values) -> NDArray[np.bool_]:
        """Which results (n, m) are within one limit."""
        parts = sides(results[:, limit.column], limit.at_least, limit.at_most)
        with np.errstate(invalid="ignore"):
            return np.asarray(np.min(parts, axis=0) >= 0)

    def violation(self, results: Values) -> Values:
        """How far (n,) results (n, m) are from keeping the rule, as parts of limits; 0 where they keep it."""
        return np.maximum(0.0, -self.margin(results))

    def margin(self, results: Values) -> Values:
        """The function (n,) of the rule of results (n, m): not negative where they keep it."""
        functions: dict[str, Values] = {name: np.full(len(results), value) for name, value in self.given.items()}
        for each in self.limits:
            parts = sides(results[:, each.column], each.at_least, each.at_most)
            functions[each.name] = reduce(lambda f, g: conjunction(f, g, self.form, self.m), parts)
        if not functions:
            return np.ones(len(results))
        return np.asarray(function(self.rule or " and ".join(functions), functions, self.form, self.m))


class Problem:
    """Designs of the unit box (n, k) by their scores; ``places`` and ``results`` are all that were solved."""

    def __init__(
        self,
        variables: Sequence[Variable],
        objectives: Sequence[Objective],
        rule: Rule,
        model: Model,
        journal: Journal | None = None,
    ) -> None:
        self.variables, self.objectives, self.rule, self.model = tuple(variables), tuple(objectives), rule, model
        self._journal = journal
        self._known = {row.point: row for row in journal.rows()} if journal is not None else {}
        self.told: Told = lambda solved: None  # called as designs are solved
        self.resumed = 0  # designs that an earlier run had solved
        self._index: dict[bytes, int] = {}
        self._values: Values = np.empty((START, len(self.variables)))
        self._results: Values = np.empty((START, len(model.names)))
        self._reasons: list[str] = []

    @property
    def solved(self) -> int:
        """Designs that were solved."""
        return len(self._reasons)

    @property
    def values(self) -> Values:
        """Values (n, v) of the variables of all designs that were solved."""
        return self._values[: self.solved]

    @property
    def results(self) -> Values:
        """Results (n, m) of all designs that were solved."""
        return self._results[: self.solved]

    @property
    def reasons(self) -> tuple[str, ...]:
        """Why each that was solved has no results; empty where it has."""
        return tuple(self._reasons)

    @property
    def free(self) -> list[int]:
        """The variables that take any value."""
        return [k for k, variable in enumerate(self.variables) if not variable.among]

    @property
    def discrete(self) -> list[int]:
        """The variables that take listed values."""
        return [k for k, variable in enumerate(self.variables) if variable.among]

    def scale(self, objective: int, best: float) -> float:
        """Against what differences of an objective are small: its best value, or a bit of what first designs have."""
        own = self.results[:FIRST, self.objectives[objective].column]
        known = np.abs(own[np.isfinite(own)])
        return max(abs(best), SMALL * float(np.median(known)) if known.size else 0.0) or 1.0

    def scores(self, places: Values) -> Scores:
        """Scores of designs (n, k) of the unit box."""
        return self.judged(self.solve(self.inside(places)))

    def inside(self, places: Values) -> Values:
        """Values (n, v) of the variables at places (n, v) of the unit box."""
        parts = np.clip(places, 0.0, 1.0)
        return np.array([each.value(part) for each, part in zip(self.variables, parts.T, strict=True)]).T

    def beyond(self, places: Values) -> Values:
        """Results (n, m) at places that may be a step beyond the unit box, farther ones taken back to `BEYOND`."""
        parts = zip(self.variables, np.clip(places, -BEYOND, 1 + BEYOND).T, strict=True)
        return self.solve(np.array([each.value(part) for each, part in parts]).T)

    def parts(self, values: Values) -> Values:
        """Places (..., v) of the unit box of values (..., v)."""
        return np.stack([each.part(values[..., k]) for k, each in enumerate(self.variables)], axis=-1)

    def judged(self, results: Values) -> Scores:
        """Scores of results (n, m)."""
        failed = np.asarray(~np.isfinite(results[:, self._needed]).all(axis=1))
        objectives = np.array([each.sign * results[:, each.column] for each in self.objectives]).T
        with np.errstate(invalid="ignore"):
            violation = self.rule.violation(results)
        return Scores(np.where(failed[:, None], np.inf, objectives), np.where(failed, np.inf, violation))

    def solve(self, values: Values) -> Values:
        """Results (n, m) of designs by the values (n, v) of their variables, NaN where one has none."""
        numbers, fresh = self._numbered(values)
        if fresh:
            found, reasons = self._solved(values[fresh])
            first, last = self.solved, self.solved + len(fresh)
            self._values, self._results = _room(self._values, last), _room(self._results, last)
            self._values[first:last], self._results[first:last] = values[fresh], found
            self._reasons += reasons
        return np.asarray(self._results[numbers])

    @property
    def _needed(self) -> list[int]:
        return [*{*(each.column for each in self.objectives), *(each.column for each in self.rule.limits)}]

    def _numbered(self, values: Values) -> tuple[list[int], list[int]]:
        """The number of every design, and which rows are those of new ones."""
        numbers, fresh = [], []
        for row, own in enumerate(values):
            key = own.tobytes()
            if key not in self._index:
                self._index[key] = len(self._index)
                fresh.append(row)
            numbers.append(self._index[key])
        return numbers, fresh

    def _solved(self, values: Values) -> tuple[Values, tuple[str, ...]]:
        """New designs, some at a time."""
        rows: list[Row] = []
        for at in range(0, len(values), BLOCK):
            rows += self._rows(self.solved + at, values[at : at + BLOCK])
            self.told(self.solved + len(rows))
        answers = self.model.answers(rows)
        return answers.values, answers.reasons

    def _rows(self, first: int, values: Values) -> list[Row]:
        """Rows of designs with numbers from ``first`` on, by the journal where it has all of them."""
        numbers = range(first, first + len(values))
        rows = [self._known[number] for number in numbers if number in self._known]
        if len(rows) == len(values):
            self.resumed += len(rows)
        else:
            rows = []
            keys = np.empty((len(values), len(self.model.keys)))
            for variable, own in zip(self.variables, values.T, strict=True):
                keys[:, [*variable.keys]] = own[:, None]
            for some in self.model.rows(zip(numbers, keys.tolist(), strict=True)):
                rows += some
            if self._journal is not None:
                self._journal.append(row for row in rows if row.status != BROKEN)
        return rows


def _room(rows: Values, count: int) -> Values:
    """The rows with room for ``count``."""
    return rows if count <= len(rows) else np.concatenate((rows, np.empty((max(len(rows), count), rows.shape[1]))))
