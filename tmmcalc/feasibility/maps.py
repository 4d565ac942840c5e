"""The region of feasible parameters: the constraints of a scene judged at every point of a grid of one or two of them.

Where the scene has no solution, a point is refused: it is not feasible, and nothing is known of its margins. Between
points the border of a constraint is where its margin, taken as linear, is zero; it is known to a step of the grid.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import NoSolutionError, SpecError, TmmError
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.feasibility.judge import Feasibility
from tmmcalc.feasibility.logic import Form, Values
from tmmcalc.feasibility.rule import function

Mask = NDArray[np.bool_]


@record
class Parameter:
    """A parameter and its values."""

    header: str  # key[unit]
    values: tuple[float, ...]  # (n,)
    assignments: tuple[str, ...]  # (n,) overrides that set them


@record
class RegionMap:
    """Constraints over a grid of parameters; its points run with the last parameter first."""

    parameters: tuple[Parameter, ...]
    names: tuple[str, ...]  # of the constraints
    rule: str = quantity("rule", "rule that combines the constraints")
    form: Form
    solved: Mask  # (p,) where the scene has a solution
    feasible: Mask = quantity("feasible", "where the rule holds")  # (p,)
    function: Values = quantity("function", "function of the rule", header="function ({form})")  # (p,) 0: not solved
    values: Values = quantity("{constraint}[{unit}]", "constrained quantity")  # (c, p) 0 where not solved
    margins: Values = quantity("margin_{constraint}", "margin of the constraint")  # (c, p) 0 where not solved
    units: tuple[str, ...]  # (c,) of the quantities
    failing: tuple[tuple[str, ...], ...] = quantity("fails", "constraints at fault")  # (p,)
    refused: tuple[str, ...]  # (p,) why there is no solution, "" where there is

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of values of each parameter."""
        return tuple(len(each.values) for each in self.parameters)

    @property
    def best(self) -> int:
        """The solved point, feasible if one is, where the function of the rule is the greatest."""
        eligible = self.feasible if self.feasible.any() else self.solved
        return int(np.argmax(np.where(eligible, self.function, -np.inf)))

    def at(self, point: int) -> tuple[int, ...]:
        """Indices of a point along the parameters."""
        return tuple(int(k) for k in np.unravel_index(point, self.shape))

    def exact(self, margins: Sequence[Values]) -> Values:
        """The function of the rule by least and greatest of these margins, whose zeros are the borders of the region.

        They are arrays of any shape, one for each constraint.
        """
        return function(self.rule, dict(zip(self.names, margins, strict=True)), "minmax", 1)


def region_map(parameters: Sequence[Parameter], found: Iterable[Feasibility | TmmError]) -> RegionMap:
    """Gather what was found at every point of a grid; raises `NoSolutionError` if nothing was at any.

    Where that is for faults of the spec alone, the first is raised.
    """
    points = list(found)
    judged = [each for each in points if isinstance(each, Feasibility)]
    if not judged:
        raise _nothing(points)
    verdicts = judged[0].verdicts
    blank = np.zeros((len(verdicts), len(points)))
    values, margins = blank, blank.copy()
    for k, each in enumerate(points):
        if isinstance(each, Feasibility):
            values[:, k] = [verdict.value for verdict in each.verdicts]
            margins[:, k] = [verdict.margin for verdict in each.verdicts]
    return RegionMap(
        parameters=tuple(parameters),
        names=tuple(verdict.name for verdict in verdicts),
        rule=judged[0].rule,
        form=judged[0].form,
        solved=np.array([isinstance(each, Feasibility) for each in points]),
        feasible=np.array([isinstance(each, Feasibility) and each.feasible for each in points]),
        function=np.array([each.function if isinstance(each, Feasibility) else 0.0 for each in points]),
        values=values,
        margins=margins,
        units=tuple(verdict.unit for verdict in verdicts),
        failing=tuple(each.failing if isinstance(each, Feasibility) else () for each in points),
        refused=tuple("" if isinstance(each, Feasibility) else _reason(each) for each in points),
    )


def _reason(error: TmmError) -> str:
    if isinstance(error, SpecError):
        return "; ".join(f"{fault.path}: {fault.message}" for fault in error.faults)
    return f"{error.where}: {error.message}" if error.where else error.message


def _nothing(points: Sequence[Feasibility | TmmError]) -> TmmError:
    errors = [each for each in points if not isinstance(each, Feasibility)]
    if all(isinstance(each, SpecError) for each in errors):
        return errors[0]
    first = next(each for each in errors if not isinstance(each, SpecError))
    return NoSolutionError(
        f"none of {len(errors)} points has a solution; the first: {_reason(first)}",
        where="feasibility",
        remedy=first.remedy or "choose other ranges",
    )
