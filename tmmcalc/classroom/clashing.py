"""Known mistakes that give the right answer of a variant, found for many candidates side by side."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from tmmcalc.batch.task import BROKEN, OK, Row, Task, verdict
from tmmcalc.classroom.draws import Candidate, assignments
from tmmcalc.classroom.judging import Judge
from tmmcalc.classroom.keying import clashes, key_of, mistakes_of, told_of
from tmmcalc.classroom.keymaking import Order

SOLVER = "tmmcalc.classroom.clashing:solve_clashes"
Pair = tuple[str, str]  # an item, and a mistake that gives the right answer of it, by their names
Clashes = Callable[[Sequence[Candidate]], Mapping[int, Sequence[Pair]]]


def clashes_of(judge: Judge) -> Clashes:
    """What finds the pairs of candidates of an assignment, by their numbers."""
    task = replace(judge.frame, solver=SOLVER)
    mistakes = tuple(each.name for each in mistakes_of(judge.spec))

    def found(candidates: Sequence[Candidate]) -> dict[int, list[Pair]]:
        orders = [
            Order(each.number, assignments(judge.drawn, each.values), judge.items, mistakes) for each in candidates
        ]
        every: dict[int, list[Pair]] = {}
        for rows in judge.solver(task, [[order] for order in orders]):
            for row in rows:
                if row.status == BROKEN:
                    raise RuntimeError(row.reason)
                every[row.point] = [(item, mistake) for item, mistake in json.loads(row.reason)] if row.ok else []
        return every

    return found


def solve_clashes(task: Task, orders: Sequence[Order]) -> list[Row]:
    """A row of each candidate, whose reason names its pairs."""
    variants = task.variants()
    rows = []
    for order in orders:
        try:
            mistakes = [told_of(name) for name in order.mistakes]
            key = key_of(order.point, "", variants.spec(order.assignments), order.items, mistakes)
            pairs = [(order.items[item].name, mistakes[at].name) for at, item in clashes(key, order.items)]
            rows.append(Row(order.point, OK, json.dumps(pairs)))
        except Exception as error:  # one candidate that breaks the program must not end the others
            rows.append(Row(order.point, *verdict(error)))
    return rows
