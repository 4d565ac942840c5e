"""The user's constraints within the search: what a candidate tells, and how far it is from keeping the rule.

A candidate tells sizes, checks, criteria and positions under the names that the document and the table give them, on
the coarse steps of the search. What it does not tell, such as results of other stages, is taken to be as the rule wants
it: the linkages that are analysed in the end are judged exactly. The function of the rule is smooth (R0 in place of
minmax), and leads the search back where it is negative.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from tmmcalc.core.columns import Column
from tmmcalc.core.plane import Real
from tmmcalc.core.quantity import quantity_of
from tmmcalc.feasibility.judge import Constraint, FeasibilityTask, judge
from tmmcalc.feasibility.quantities import limits
from tmmcalc.feasibility.rule import may_hold
from tmmcalc.linkage.synthesis.dwell.columns import columns_of
from tmmcalc.linkage.synthesis.dwell.criteria import NAMES, Traits, achieved
from tmmcalc.linkage.synthesis.dwell.motion import Unknowns
from tmmcalc.linkage.synthesis.dwell.positions import motion_of
from tmmcalc.linkage.synthesis.dwell.results import Dwell
from tmmcalc.linkage.synthesis.dwell.sizes import scale_of, sizes_of
from tmmcalc.linkage.synthesis.dwell.task import DwellTask
from tmmcalc.linkage.synthesis.dwell.turn import Turn
from tmmcalc.linkage.synthesis.results import check_key
from tmmcalc.naming.rows import REDUCED

Told = tuple[Real, str]  # values (k,) and their unit
Quantity = tuple[float, str, float | None, float | None]  # value, unit, least, most
STAGE = "synthesis"
SLACK = 2e-3  # of the function: the exact figures differ from those of the coarse steps by less
BARRIER = 1e6  # cost of a candidate that breaks the rule, and the same again for every unit of the function
FARTHEST = 100.0  # of the function: beyond it all are equally bad
AS_WANTED: dict[bool, Quantity] = {
    True: (1.0, "", 0.0, None),
    False: (-1.0, "", 0.0, None),
}  # a quantity that keeps, or breaks, its limit


class Rule:
    """The rule of the constraints on candidates; it counts those that keep it, and what the others fail."""

    def __init__(self, task: FeasibilityTask, asked: DwellTask) -> None:
        self.task = replace(task, form="R0") if task.form == "minmax" else task
        self.asked = asked
        self.wanted = {each.name: _wanted(task, each.name) for each in task.constraints}
        self.kept = 0
        self.failing: Counter[str] = Counter()

    def ranked(self, costs: Real, turn: Turn, parameters: Mapping[str, Real], traits: Traits) -> Real:
        """Costs (k,) of the linkages of a turn; those that break the rule come after all others, the nearest first."""
        values = told_values(self.asked, turn, parameters, traits)
        columns = told_columns(self.asked, turn, traits)
        every = self.task.constraints
        told = {each.name: _told(each, values, columns) for each in every}
        functions = np.empty(len(costs))
        for k in range(len(costs)):
            judged = judge(self.task, {each.name: self._quantity(each, told[each.name], k) for each in every})
            functions[k] = judged.function
            self.kept += judged.feasible
            self.failing.update(judged.failing)
        short = np.minimum(SLACK - functions, FARTHEST)
        return np.where(short <= 0, np.minimum(costs, BARRIER), BARRIER * (1 + np.maximum(short, 0.0)))

    def _quantity(self, constraint: Constraint, told: Told | None, k: int) -> Quantity:
        """Value, unit and limits of the quantity of candidate k."""
        if told is None:
            return AS_WANTED[self.wanted[constraint.name]]
        values, unit = told
        return float(values[k]), unit, *limits(constraint, unit)


def _wanted(task: FeasibilityTask, name: str) -> bool:
    """Whether a constraint of which nothing is known should be kept: all but those that the rule excludes."""
    return bool(may_hold(task.combined, {name: np.array(True)}, ()))


def told_values(asked: DwellTask, turn: Turn, parameters: Mapping[str, Real], traits: Traits) -> dict[str, Told]:
    """Sizes, checks and criteria (k,) by their names in the summary, angles in deg."""
    scale = scale_of(asked, traits.stroke)
    length = np.ones_like(scale) if turn.linkages.rocks else scale
    sizes = sizes_of(asked, turn.linkages, parameters, scale)
    found = {size.symbol: _shown(size.values, size.unit) for size in sizes}
    checks = achieved(asked, traits.stroke, traits.dwell, traits.far, length)
    found |= {f"{check_key(name)}.achieved": _shown(*told) for name, told in checks.items()}
    found |= {name: (values, "") for name, values in zip(NAMES, traits.criteria, strict=True)}
    return found | {quantity_of(Dwell, "dwell_ratio").name: (100 * traits.criteria.f1, "%")}


def _shown(values: Real, unit: str) -> Told:
    """A size or check as the summary tells it."""
    return (np.degrees(values), "deg") if unit == "rad" else (values, unit.removesuffix("-"))


def told_columns(asked: DwellTask, turn: Turn, traits: Traits) -> dict[str, Column]:
    """The columns of the positions, each (n, k), along the motion of the crank."""
    sense = -1 if asked.clockwise else 1
    state, phi = Unknowns(*(part[::sense] for part in turn.state)), turn.phi[:, None]
    crank = turn.linkages.phi0 + sense * phi
    motion = motion_of(asked, turn.linkages, (), phi, crank, state, scale_of(asked, traits.stroke))
    return {column.name: column for column in columns_of(motion, asked.output)}


def _told(constraint: Constraint, values: Mapping[str, Told], columns: Mapping[str, Column]) -> Told | None:
    """What the candidates tell of a quantity; None where they do not know it."""
    if constraint.stage != STAGE:
        return None
    if constraint.value is not None:
        return values.get(constraint.value)
    column = columns.get(constraint.column or "") if constraint.of in REDUCED else None
    if column is None:
        return None
    count = next(iter(values.values()))[0].shape
    return np.broadcast_to(REDUCED[constraint.of](column.make().T), count), column.unit
