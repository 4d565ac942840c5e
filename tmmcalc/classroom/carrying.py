"""Answers that are right for a wrong one before them.

Where an item follows an earlier one by a power, as a velocity its angular one, an acceleration the square of it, a
power the force, its own wrong value carries on by the same power. The powers are those of the item; where it tells
none, it is 1, but not of a value that is right by plans: that meets whatever is so near. Of several wrong ones before
it all have been carried on, or one alone. What follows by a sum or otherwise is found where a known mistake explains
both answers.

The more is tried, the more often a number that comes of nothing is met, so what is allowed is shared among several that
are tried alone: about 3 % of such numbers near the right one are taken for carried on at most, which is measured
(`tests/classroom/test_carrying.py`).

The student's own value has to be plausible, so that a trivial one is no way to make the rest right: of the right sign
and within a factor of ``FACTOR``, or explained by a known mistake.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from tmmcalc.classroom.answers.handed import Answer
from tmmcalc.classroom.model import Item, Values
from tmmcalc.classroom.verdicts import Standing, standing_of

FACTOR = 5.0
UNTOLD = 1.0  # power of what is only known to come before
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
    ]
    if not before or not right[k]:
        return
    ratios = [_power(answers[j].value / right[j], powers.get(j) or UNTOLD) for j in before]
    count = len(ratios)
    parts = 2 * count  # all together have more of it than one alone
    shared = replace(items[k], tolerance=items[k].tolerance / parts, within=items[k].within / parts)
    tried = [(math.prod(ratios), items[k]), *((ratio, shared) for ratio in ratios)]
    for ratio, item in tried[: 1 if count == 1 else None]:
        value = right[k] * ratio
        if math.isfinite(value) and standing_of(answers[k], item, value) is Standing.right:
            yield value


def _power(ratio: float, power: float) -> float:
    """A ratio to a power, with its sign where the power is no even number."""
    size = abs(ratio) ** power
    return size if power % 2 == 0 else math.copysign(size, ratio)
