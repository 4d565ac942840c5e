"""One set of results by stage judged by the constraints of a scene."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from tmmcalc.core.errors import UsageError
from tmmcalc.core.facts import Quantity
from tmmcalc.feasibility.judge import Constraint, Feasibility, FeasibilityTask, judge
from tmmcalc.feasibility.quantities import limits, of_given, place
from tmmcalc.naming.scene import Scene
from tmmcalc.naming.told import one


def judged(task: FeasibilityTask, upstream: Mapping[str, Any], scene: Scene | None = None) -> Feasibility:
    """Judge one set of results by stage; the ``scene`` has places between their rows, and what is by choice."""
    found = {}
    for constraint in task.constraints:
        value, unit = _quantity(constraint, upstream, scene)
        found[constraint.name] = value, unit, *limits(constraint, unit)
    return judge(task, found)


def _quantity(constraint: Constraint, upstream: Mapping[str, Any], scene: Scene | None) -> Quantity:
    """Value and unit of the quantity of a constraint."""
    if constraint.given is not None:
        return of_given(constraint)
    try:
        told = one(constraint.asked, upstream, scene)
    except UsageError as error:
        raise UsageError(error.message, where=place(constraint), remedy=error.remedy) from None
    return told.value, told.unit
