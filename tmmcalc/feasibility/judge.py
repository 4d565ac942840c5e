"""Constraints on named quantities, their margins, and whether all that is asked holds.

A constraint holds its quantity between two limits, or on one side of one. Its margin is what is left to the nearer
limit as a part of that limit (of one where the limit is zero): not negative where it holds.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import reduce
from typing import Any, Literal

import numpy as np

from tmmcalc.core import quantity as told
from tmmcalc.core.notes import Phrase
from tmmcalc.core.numerics.extended import apart, widened
from tmmcalc.core.records import record
from tmmcalc.feasibility.logic import LARGEST, Form, conjunction
from tmmcalc.feasibility.rule import failing, function, holds
from tmmcalc.naming.language import ANY, ROWS, Name, parse

Sense = Literal["value", "function", "truth"]
ASKED = {  # what of a column, in words
    "max": "{stage} max {column}",
    "min": "{stage} min {column}",
    "range": "{stage} range {column}",
    "mean": "{stage} mean {column}",
    "size": "{stage} size {column}",
    "first": "{stage} first {column}",
    "last": "{stage} last {column}",
    "rms": "{stage} rms {column}",
    "integral": "{stage} integral {column}",
    "at_max": "{stage} at_max {column}",
    "at_min": "{stage} at_min {column}",
    "at_size": "{stage} at_size {column}",
    "chosen": "{stage} chosen {column}",
}


@record
class Constraint:
    """A named inequality on what a stage tells: a column of its table, or what else a name can stand for.

    Limits are numbers in the unit in which the quantity is told, or texts with a unit. Without a stage the quantity is
    ``given``: a value, or a function that is not negative where the constraint holds, which of a truth is +1 or -1.
    """

    name: str
    stage: str = ""
    value: str | None = None  # a fact, or another name of `tmmcalc.naming.language` without its stage
    column: str | None = None  # a column, without its unit
    of: str = "max"  # what of the column, see there
    at_least: float | str | None = None
    at_most: float | str | None = None
    given: float | str | None = None
    sense: Sense = "value"  # of what is given

    @property
    def asked(self) -> Name:
        """What it is on. Of a stage whose rows are sets to choose from a column is that of the chosen one."""
        stage = "" if self.stage == ANY else self.stage
        if self.column:
            return Name(stage, "chosen" if stage in ROWS else self.of, self.column)
        return parse(self.value or "")._replace(stage=stage)

    @property
    def quantity(self) -> str:
        """The quantity in words: ``kinematics stroke_D``, ``forces max R_A``, ``criteria mass``, ``given value``."""
        if not self.stage:
            return f"given {self.sense}"
        if self.value and self.stage == ANY:
            return self.value
        text = "{stage} {column}" if self.value or self.stage in ROWS else ASKED[self.of]
        return Phrase(text, stage=self.stage, column=self.value or self.column)


@record
class FeasibilityTask:
    """The constraints, the rule that combines them (empty: all must hold), and the form of its function."""

    constraints: tuple[Constraint, ...]
    rule: str = ""
    form: Form = "minmax"
    m: int = 1  # order of smoothness of Rm

    @property
    def combined(self) -> str:
        """The rule, or that all must hold."""
        return self.rule or " and ".join(constraint.name for constraint in self.constraints)


@record
class Verdict:
    """A constraint at its value, with limits in the value's unit."""

    name: str = told.quantity("constraint", "name of the constraint")
    quantity: str = told.quantity("quantity", "what is constrained, by its stage and name")
    value: float = told.quantity("value", "its value")
    unit: str = told.quantity("unit", "unit of value and limits")
    at_least: float | None = told.quantity("at_least", "lower limit", header="at least")
    at_most: float | None = told.quantity("at_most", "upper limit", header="at most")
    margin: float = told.quantity("margin", "what is left to the nearer limit, as a part of it")
    holds: bool = told.quantity("holds", "whether the value is within its limits")


@record
class Candidate:
    """One of several designs, judged; ``refused`` says why one could not be, then nothing else is known of it."""

    number: int = told.quantity("solution", "its number among the designs, from 1", header="i")
    name: str = told.quantity("name", "name of the design", header="design")
    feasible: bool = told.quantity("feasible", "whether the rule holds")
    function: float | None = told.quantity("function", "function of the rule", header="function ({form})")
    failing: tuple[str, ...] = told.quantity("failing", "constraints at fault", header="fails")
    verdicts: tuple[Verdict, ...]
    refused: str = ""


@record
class Feasibility:
    """All verdicts, whether the rule holds, its function, and the constraints at fault.

    A constraint is at fault if it does not hold and the rule asks for it, or if it holds and the rule excludes it.
    Of several designs ``candidates`` are all, the best first, and the rest tells of the first of them.
    """

    verdicts: tuple[Verdict, ...]
    rule: str = told.quantity("rule", "rule that combines the constraints")
    form: Form
    feasible: bool = told.quantity("feasible", "whether the rule holds")
    function: float = told.quantity("function", "function of the rule")
    failing: tuple[str, ...] = told.quantity("failing", "constraints at fault")
    candidates: tuple[Candidate, ...] = ()
    error: float = 0.0  # what rounding leaves of the margins, relative to the largest; that of values is their stage's

    @told.derived("chosen", "number of the best design")
    def chosen(self) -> int:
        """Number of the best design, the first feasible one if there is any; 1 where nothing is chosen."""
        return self.candidates[0].number if self.candidates else 1


def margin(value: float, at_least: float | None, at_most: float | None) -> float:
    """What is left to the nearer limit, as a part of it.

    >>> margin(3.0, 2.0, 4.0)
    0.25
    """
    return min(sides(value, at_least, at_most))


def sides(value: Any, at_least: float | None, at_most: float | None) -> list[Any]:
    """What is left to each limit that there is, as a part of it: of one value, or of each of an array."""
    parts = []
    if at_least is not None:
        parts.append((value - at_least) / (abs(at_least) or 1.0))
    if at_most is not None:
        parts.append((at_most - value) / (abs(at_most) or 1.0))
    if isinstance(value, np.ndarray):
        return [np.clip(part, -LARGEST, LARGEST) for part in parts]
    return [min(max(part, -LARGEST), LARGEST) for part in parts]


def _rounding(verdicts: Sequence[Verdict]) -> float:
    """Of the margins, against the same in extended precision."""
    wide = [(widened(each.value), each.at_least, each.at_most) for each in verdicts]
    return apart([each.margin for each in verdicts], [margin(*each) for each in wide])


def judge(task: FeasibilityTask, found: Mapping[str, tuple[float, str, float | None, float | None]]) -> Feasibility:
    """Judge quantities by constraint name: value, unit, and both limits in that unit."""
    verdicts, functions = [], {}
    for constraint in task.constraints:
        value, unit, low, high = found[constraint.name]
        within = (low is None or value >= low) and (high is None or value <= high)
        left = margin(value, low, high)
        verdicts.append(Verdict(constraint.name, constraint.quantity, value, unit, low, high, left, within))
        parts = map(np.asarray, sides(value, low, high))
        functions[constraint.name] = reduce(lambda f, g: conjunction(f, g, task.form, task.m), parts)
    rule = task.combined
    truths = {verdict.name: verdict.holds for verdict in verdicts}
    return Feasibility(
        tuple(verdicts),
        rule,
        task.form,
        holds(rule, truths),
        float(function(rule, functions, task.form, task.m)),
        tuple(failing(rule, truths)),
        error=_rounding(verdicts),
    )
