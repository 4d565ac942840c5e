"""What the marks of a class have in common: how items went, which mistakes were made, which wrong numbers are equal."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence

from tmmcalc.classroom.marking import Marked, Marks
from tmmcalc.classroom.verdicts import Standing
from tmmcalc.core.records import record

FIGURES = 3  # of wrong numbers that are told as equal
GOOD = (Standing.right, Standing.plans, Standing.carried)


@record
class Went:
    """How an item went."""

    item: int
    counts: Mapping[Standing, int]
    share: float  # of its points that the class has got


@record
class Made:
    """A mistake of the class, or several that give equal numbers."""

    mistakes: tuple[int, ...]  # by place in the keybook
    numbers: tuple[int, ...]  # of the variants in which it was made


@record
class Equal:
    """A wrong number that stands in several variants, in which different ones are right."""

    item: int
    text: str
    numbers: tuple[int, ...]


@record
class Statistics:
    """What the marks of a class have in common."""

    students: int  # who handed something in
    mean: float  # points; NaN without students
    items: tuple[Went, ...]
    made: tuple[Made, ...]  # the commonest first
    equal: tuple[Equal, ...]


def statistics_of(marks: Marks) -> Statistics:
    """The statistics of the hand-ins that count."""
    counting = marks.counting
    mean = math.fsum(each.total for each in counting) / len(counting) if counting else math.nan
    items = tuple(_went(marks, counting, k) for k in range(len(marks.items)))
    return Statistics(len(counting), mean, items, _made(counting), _equal(marks, counting))


def _went(marks: Marks, counting: Sequence[Marked], k: int) -> Went:
    counts = Counter(each.standings[k] for each in counting)
    most = marks.items[k].weight * len(counting)
    got = math.fsum(each.points[k] for each in counting)
    return Went(k, counts, got / most if most else math.nan)


def _made(counting: Sequence[Marked]) -> tuple[Made, ...]:
    found: dict[tuple[int, ...], list[int]] = {}
    for each in counting:
        for explanation in each.explanations:
            found.setdefault(tuple(sorted(explanation.mistakes)), []).append(each.number)
    made = (Made(mistakes, tuple(sorted({*numbers}))) for mistakes, numbers in found.items())
    return tuple(sorted(made, key=lambda each: (-len(each.numbers), each.mistakes)))


def _equal(marks: Marks, counting: Sequence[Marked]) -> tuple[Equal, ...]:
    found: dict[tuple[int, str], list[Marked]] = {}
    for each in counting:
        for k, answer in enumerate(each.answers):
            bad = each.standings[k] not in GOOD and math.isfinite(answer.value)
            if bad and answer.figures >= FIGURES:
                found.setdefault((k, f"{answer.value:.12g}"), []).append(each)
    return tuple(
        Equal(k, those[0].answers[k].text, tuple(each.number for each in those))
        for (k, _), those in sorted(found.items())
        if len(those) > 1
    )
