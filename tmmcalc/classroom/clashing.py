"""Known mistakes that give the right answer of a variant, found for many candidates side by side."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from tmmcalc.batch.task import BROKEN, OK, Row, Task, verdict
from tmmcalc.classroom.choosing import Clashes, Pair, Sought
from tmmcalc.classroom.draws import Candidate, assignments
from tmmcalc.classroom.judging import Judge
from tmmcalc.classroom.keying import Desk, mistakes_of

if TYPE_CHECKING:
    from tmmcalc.classroom.model import Item

SOLVER = "tmmcalc.classroom.clashing:solve_clashes"


class Question(NamedTuple):
    """A candidate of which clashes are sought, as it is sent to another process."""

    point: int  # number of the candidate
    assignments: tuple[str, ...]
    items: tuple[Item, ...]
    mistakes: tuple[str, ...]  # in the order in which they are made
    unavoided: frozenset[Pair] | None  # pairs that do not count, and one other is enough; None: all are told


def clashes_of(judge: Judge) -> Clashes:
    """What finds the pairs of candidates of an assignment, by their numbers."""
    task = replace(judge.frame, solver=SOLVER)
    mistakes = [each.name for each in mistakes_of(judge.spec)]

    def found(candidates: Sequence[Candidate], sought: Sought | None) -> dict[int, list[Pair]]:
        order, unavoided = tuple(mistakes), None
        if sought is not None:
            order, unavoided = tuple(sorted(mistakes, key=sought.rank)), frozenset(sought.unavoided)
        questions = [
            Question(each.number, assignments(judge.drawn, each.values), judge.items, order, unavoided)
            for each in candidates
        ]
        every: dict[int, list[Pair]] = {}
        for rows in judge.solver(task, [[question] for question in questions]):
            for row in rows:
                if row.status == BROKEN:
                    raise RuntimeError(row.reason)
                every[row.point] = [(item, mistake) for item, mistake in json.loads(row.reason)] if row.ok else []
        return every

    return found


def solve_clashes(task: Task, questions: Sequence[Question]) -> list[Row]:
    """A row of each candidate, whose reason names its pairs."""
    variants = task.variants()
    rows = []
    for each in questions:
        try:
            pairs = _pairs(Desk(variants.spec(each.assignments), each.items), each)
            rows.append(Row(each.point, OK, json.dumps(pairs)))
        except Exception as error:  # one candidate that breaks the program must not end the others
            rows.append(Row(each.point, *verdict(error)))
    return rows


def _pairs(desk: Desk, asked: Question) -> list[Pair]:
    """The pairs of a candidate; where some do not count, those of the first mistake that has others."""
    found: list[Pair] = []
    for mistake in asked.mistakes:
        wanted = [
            at for at, item in enumerate(asked.items) if (item.name, mistake) not in (asked.unavoided or frozenset())
        ]
        values = desk.mistaken(mistake, wanted)
        found += [(asked.items[at].name, mistake) for at in desk.hidden(values)]
        if found and asked.unavoided is not None:
            break
    return found
