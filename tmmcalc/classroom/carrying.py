"""Answers that are right for a wrong one before them.

Where an item follows an earlier one by a power, as a velocity its angular one, an acceleration the square of it, a
power the force, its own wrong value carries on by the same power. The powers are those of the item; where it tells
none, 1, 2 and -1 are tried, but not of a value that is right by plans: some power meets whatever is so near. Of several
wrong ones before it each may have been carried on or not. What follows by a sum
or otherwise is found where a known mistake explains both answers.

The student's own value has to be plausible, so that a trivial one is no way to make the rest right: of the right sign
and within a factor of ``FACTOR``, or explained by a known mistake.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import product

from tmmcalc.classroom.answers.handed import Answer
from tmmcalc.classroom.model import Item, Values
from tmmcalc.classroom.verdicts import Standing, standing_of

FACTOR = 5.0
TRIED = (1.0, 2.0, -1.0)
MOST = 3  # wrong answers before one that are followed together
OFF = (Standing.wrong, Standing.plans)  # of which something can be carried on


def carried_values(
    items: Sequence[Item], right: Values, answers: Sequence[Answer], standings: Sequence[Standing]
) -> Values:
    """What would be right of each wrong answer by the student's own values before; NaN where nothing fits it."""
    return tuple(
        next(_fitting(k, items, right, answers, standings), math.nan) if standings[k] is Standing.wrong else math.nan
        for k in range(len(items))
    )


def plausible(value: float, right: float, item: Item) -> bool:
    """Whether a wrong value could have been believed."""
    ratio = value / right if right else math.inf
    return 1 / FACTOR <= (abs(ratio) if item.either_sense else ratio) <= FACTOR


def _fitting(
    k: int, items: Sequence[Item], right: Values, answers: Sequence[Answer], standings: Sequence[Standing]
) -> Iterator[float]:
    """The values of an item that follow from wrong ones before it, as far as the answer is one of them."""
    powers = dict(zip(items[k].after, items[k].powers, strict=False))
    before = [
        j
        for j in items[k].after
        if (standings[j] is Standing.wrong or (standings[j] is Standing.plans and powers.get(j)))
        and right[j]
        and answers[j].value
    ][:MOST]
    if not before or not right[k]:
        return
    options = [(0.0, *((powers[j],) if powers.get(j) else TRIED)) for j in before]
    for chosen in product(*options):
        if not any(chosen):
            continue
        value = right[k]
        for j, power in zip(before, chosen, strict=True):
            ratio = answers[j].value / right[j]
            if power % 2 == 0:
                ratio = abs(ratio)
            value *= math.copysign(abs(ratio) ** power, ratio) if power else 1.0
        if math.isfinite(value) and standing_of(answers[k], items[k], value) is Standing.right:
            yield value
