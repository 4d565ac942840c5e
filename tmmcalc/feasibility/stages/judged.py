"""One set of results by stage judged by the constraints of a scene."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from tmmcalc.core.errors import UsageError
from tmmcalc.core.facts import Quantity
from tmmcalc.feasibility.judge import Constraint, Feasibility, FeasibilityTask, judge
from tmmcalc.feasibility.quantities import limits, of_given, place
from tmmcalc.naming.anew import Again, Anew
from tmmcalc.naming.told import one


def judged(task: FeasibilityTask, upstream: Mapping[str, Any], again: Sequence[Again] = ()) -> Feasibility:
    """Judge one set of results by stage; ``again`` is read for places between their rows."""
    found, anew = {}, Anew(again, upstream)
    for constraint in task.constraints:
        value, unit = _quantity(constraint, upstream, anew)
        found[constraint.name] = value, unit, *limits(constraint, unit)
    return judge(task, found)


def _quantity(constraint: Constraint, upstream: Mapping[str, Any], anew: Anew) -> Quantity:
    """Value and unit of the quantity of a constraint."""
    if constraint.given is not None:
        return of_given(constraint)
    try:
        told = one(constraint.asked, upstream, anew)
    except UsageError as error:
        raise UsageError(error.message, where=place(constraint), remedy=error.remedy) from None
    return told.value, told.unit
