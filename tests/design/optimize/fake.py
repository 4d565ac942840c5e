"""A model whose results are functions of its keys, in place of the stages of a spec."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from tmmcalc.batch.task import OK, Row
from tmmcalc.design.model import Answers
from tmmcalc.design.optimize.problem import Limit, Objective, Problem, Rule, Variable


class Fake:
    """Results are the columns of ``function`` of places (n, k); where they are NaN there is no solution."""

    def __init__(self, function: Callable[[Any], Any], keys: int) -> None:
        self._function = function
        self.keys = tuple(f"x{k}" for k in range(keys))
        self.names = tuple(f"y{m}" for m in range(function(np.zeros((1, keys))).shape[1]))
        self.solved = 0

    def rows(self, places: Iterator[tuple[int, Sequence[float]]]) -> Iterator[list[Row]]:
        every = [*places]
        self.solved += len(every)
        found = self._function(np.array([values for _, values in every]))
        for (number, _), own in zip(every, found, strict=True):
            known = np.isfinite(own).all()
            yield [
                Row(number, OK if known else "failed 3", "" if known else "no way", self.names if known else (), own)
            ]

    def answers(self, rows: Sequence[Row]) -> Answers:
        ordered = sorted(rows, key=lambda row: row.point)
        values = np.array([row.values if row.names else np.full(len(self.names), np.nan) for row in ordered])
        return Answers(values, tuple(row.reason for row in ordered))


def problem(
    function: Callable[[Any], Any],
    variables: Sequence[Variable | tuple[float, float]],
    limits: Sequence[Limit] = (),
    signs: Sequence[int] = (1,),
    rule: str = "",
    **more: Any,
) -> Problem:
    """The first results are the objectives."""
    made = [
        each if isinstance(each, Variable) else Variable(f"x{k}", (k,), "", *each) for k, each in enumerate(variables)
    ]
    objectives = [Objective(f"y{m}", "", m, sign) for m, sign in enumerate(signs)]
    fake: Any = Fake(function, len(made))
    return Problem(made, objectives, Rule(tuple(limits), {}, rule, "minmax", 1), fake, **more)
