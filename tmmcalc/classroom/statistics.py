"""What the marks of a class have in common: how items went, which mistakes were made, which wrong numbers are equal.

Equal wrong numbers, and wrong ones that are right in another variant, are told as facts: nothing is concluded.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from tmmcalc.classroom.marking import Marked, Marks
from tmmcalc.classroom.verdicts import Standing, distance
from tmmcalc.core.records import record

FIGURES = 3  # of wrong numbers that are told as equal
LEAST = 2  # wrong answers that are right in another variant; one may be so by chance
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
class Foreign:
    """Wrong answers of a variant that are the right ones of another, to all figures that are written."""

    number: int
    other: int
    items: tuple[int, ...]


@record
class Statistics:
    """What the marks of a class have in common."""

    students: int  # who handed something in
    mean: float  # points; NaN without students
    items: tuple[Went, ...]
    made: tuple[Made, ...]  # the commonest first
    equal: tuple[Equal, ...]
    foreign: tuple[Foreign, ...]


def statistics_of(marks: Marks) -> Statistics:
    """The statistics of the hand-ins that count."""
    counting = marks.counting
    mean = math.fsum(each.total for each in counting) / len(counting) if counting else math.nan
    items = tuple(_went(marks, counting, k) for k in range(len(marks.items)))
    return Statistics(len(counting), mean, items, _made(counting), _equal(counting), tuple(_foreign(marks, counting)))


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


def _telling(each: Marked, k: int) -> bool:
    """Whether an answer is a wrong number of enough figures to be known again."""
    answer = each.answers[k]
    return each.standings[k] not in GOOD and math.isfinite(answer.value) and answer.figures >= FIGURES


def _foreign(marks: Marks, counting: Sequence[Marked]) -> Iterator[Foreign]:
    for each in counting:
        wrong = [
            k
            for k, standing in enumerate(each.standings)
            if _telling(each, k) or (standing is Standing.carried and each.answers[k].figures >= FIGURES)
        ]
        for key in marks.keys:
            items = tuple(
                k
                for k in wrong
                if distance(each.answers[k].value, marks.items[k], key.values[k])
                <= min(each.answers[k].step, marks.items[k].tolerance * abs(key.values[k]))
            )
            if key.number != each.number and len(items) >= LEAST:
                yield Foreign(each.number, key.number, items)


def _equal(counting: Sequence[Marked]) -> tuple[Equal, ...]:
    found: dict[tuple[int, str], list[Marked]] = {}
    for each in counting:
        for k, answer in enumerate(each.answers):
            if _telling(each, k):
                found.setdefault((k, f"{answer.value:.12g}"), []).append(each)
    return tuple(
        Equal(k, those[0].answers[k].text, tuple(each.number for each in those))
        for (k, _), those in sorted(found.items())
        if len(those) > 1
    )
