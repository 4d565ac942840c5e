"""What is demanded of variants, and which demand a candidate does not keep.

Limits are kept with the margin of ``[class]``, and what is at a limit but for rounding counts as within it: no decision
depends on the last digits, so that a seed gives the same variants on every machine.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record
from tmmcalc.feasibility.rule import surely_holds

if TYPE_CHECKING:
    from tmmcalc.feasibility.judge import FeasibilityTask

Values = NDArray[np.floating[Any]]
Flags = NDArray[np.bool_]

TIE = 1e-9  # of a limit: what is so near to it is at it
_PLACES = re.compile(r"\{\w+\}")  # for values in the template of a warning
DEAD = 10.0  # times that errors of lengths may grow in a group (pressure angles up to 84 deg)


class Refusal(NamedTuple):
    """Why a candidate is none: the demand, what of it, and what an assignment may do for it."""

    demand: str
    reason: str = ""
    remedy: str = ""


def unfit(reason: str) -> Refusal:
    """The numbers make no spec."""
    return Refusal("a valid spec", reason, "draw within the limits that the checks have")


def missing(key: str) -> Refusal:
    """A relation leaves no value."""
    rule = f"a multiple of its step for {key}"
    return Refusal(rule, "no multiple is between its factors", "make its step smaller, or its factors farther apart")


def again() -> Refusal:
    """The same numbers were drawn before."""
    return Refusal(
        "numbers that were not drawn before", "", "widen the ranges, make steps smaller, or draw more numbers"
    )


def unsolved(stage: str, reason: str) -> Refusal:
    """A stage has no solution."""
    if stage in ("structure", "kinematics"):
        remedy = "narrow the ranges of lengths to where the linkage assembles"
        return Refusal("links that assemble and turn", reason, remedy)
    return Refusal(f"a solution of {stage}", reason, "move the ranges to where it has one")


def valueless(name: str) -> Refusal:
    """An asked result has no value."""
    return Refusal(f"a value of {name}", "", "move the ranges to where it has one")


def dead(growth: float) -> Refusal:
    """A group is near to a dead point, where rounding would decide whether it assembles."""
    reason = f"errors of lengths grow {growth:.3g} times"
    return Refusal("no dead point near", reason, "narrow the ranges of lengths")


def near(apart: float) -> Refusal:
    """It is hardly another variant."""
    rule = f"a distance of {100 * apart:g} % from those before"
    return Refusal(rule, "", "make apart smaller, widen the ranges, or draw more numbers")


def warned(warning: str) -> Refusal:
    """A result has a warning that the assignment has not."""
    text = _PLACES.sub("..", warning)
    return Refusal(f"no warning but those of the assignment: {text}", "", "move the ranges away from it")


def constrained(name: str) -> Refusal:
    """A constraint does not hold, or not by the margin."""
    return Refusal(f"constraint {name}", "", "loosen it, make margin smaller, or move the ranges")


def clashing(item: str, mistake: str) -> Refusal:
    """A known mistake gives the right answer."""
    rule = f"{item}: no mistake that gives the right answer"
    return Refusal(rule, mistake, "make its tolerance smaller, or ask another result")


class Ends(NamedTuple):
    """The limits of a constraint and its margin, in the unit of its column among the results; -1: it is not there."""

    column: int
    low: float | None
    high: float | None
    margin: float


@record
class Limits:
    """Constraints by their columns among results, those that are given, and the rule that all have to keep."""

    rule: str
    ends: dict[str, Ends]
    given: dict[str, bool]

    def truths(self, values: Values) -> dict[str, tuple[Flags, Flags]]:
        """Of every constraint where it surely holds, and where it surely does not; results (n, m).

        One whose result is not there is not among them.
        """
        shape = (len(values),)
        found = {name: (np.full(shape, held), np.full(shape, not held)) for name, held in self.given.items()}
        for name, (column, low, high, margin) in self.ends.items():
            if column < 0:
                continue
            value = values[:, column]
            inside = [value - low] if low is not None else []
            inside += [high - value] if high is not None else []
            left = np.min(inside, axis=0)
            tie = TIE * np.maximum(np.abs(value), margin)
            found[name] = left >= margin - tie, left <= -margin + tie
        return found

    def broken(self, values: Values) -> list[str]:
        """The constraint that each of some results (n, m) does not keep, of several the first; empty: none.

        It is the rule itself where all hold and the rule excludes one.
        """
        truths = self.truths(values)
        kept = surely_holds(self.rule, truths, (len(values),)) if self.rule else np.ones(len(values), bool)
        first = []
        for k in range(len(values)):
            own = next((name for name, (holds, _) in truths.items() if not holds[k]), self.rule)
            first.append("" if kept[k] else own)
        return first

    def among(self, columns: Mapping[int, int]) -> Limits:
        """The same on fewer results, whose columns are told by those of now; of others nothing is known."""
        ends = {name: each._replace(column=columns.get(each.column, -1)) for name, each in self.ends.items()}
        return Limits(self.rule, ends, self.given)


def limits_of(task: FeasibilityTask, columns: Mapping[str, tuple[int, float, str]], part: float) -> Limits:
    """The constraints; ``columns`` are of those on results: place among these, value of the assignment, unit.

    ``part`` is the margin as a part of a limit; of one that is zero it is that part of the assignment's own value.
    """
    from tmmcalc.feasibility.judge import sides
    from tmmcalc.feasibility.quantities import limits, of_given

    ends, given = {}, {}
    for each in task.constraints:
        if each.given is not None:
            value, unit = of_given(each)
            given[each.name] = bool(min(sides(value, *limits(each, unit))) >= 0)
            continue
        column, own, unit = columns[each.name]
        low, high = limits(each, unit)
        size = max((abs(end) for end in (low, high) if end is not None), default=0.0) or abs(own)
        ends[each.name] = Ends(column, low, high, part * size)
    return Limits(task.combined if task.constraints else "", ends, given)


@record
class Spread:
    """Between which magnitudes an asked result of all variants is: so many times that of the assignment."""

    name: str
    low: float
    high: float

    @classmethod
    def of(cls, name: str, own: float, ratio: float, nothing: float) -> Spread:
        """About the assignment's ``own`` value; one that is ``nothing`` may be anything."""
        if abs(own) <= nothing:
            return cls(name, 0.0, math.inf)
        return cls(name, abs(own) / math.sqrt(ratio), abs(own) * math.sqrt(ratio))

    def refusal(self, value: float) -> Refusal | None:
        """Why a value is too far from that of the assignment."""
        if self.low * (1 - TIE) <= abs(value) <= self.high * (1 + TIE):
            return None
        return Refusal(f"{self.name} within the spread", "", "make spread larger, or narrow the ranges")
