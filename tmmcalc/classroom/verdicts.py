"""Whether an answer is right.

A number that is written to so many figures is an interval: it is right where the interval meets the tolerance. It is so
for as many figures as are asked for and for one less; fewer figures count as these followed by zeros, so that a rough
number is no way to be right. A zero has no figures: it is 0, however it is written.
"""

from __future__ import annotations

import math
from enum import StrEnum

from tmmcalc.classroom.answers.handed import Answer
from tmmcalc.classroom.model import Item
from tmmcalc.spec.units import conversion, kind_of

LEAST_FIGURES = 2  # which any interval of rounding needs
SLACK = 1e-12  # relative: what stands at the tolerance is within it


class Standing(StrEnum):
    """What an answer is."""

    right = "right"
    plans = "right by plans"
    carried = "carried on"
    wrong = "wrong"
    unreadable = "unreadable"
    missing = "missing"


def standing_of(answer: Answer, item: Item, right: float) -> Standing:
    """What an answer is beside the right value, in the unit of the item; what was carried on is not known here."""
    if math.isnan(answer.value):
        return Standing.unreadable if answer.text else Standing.missing
    rounded = rounding(answer, item)
    if is_within(answer.value, right, item, item.tolerance, rounded):
        return Standing.right
    return Standing.plans if is_within(answer.value, right, item, item.plans, rounded) else Standing.wrong


def is_within(value: float, right: float, item: Item, part: float, rounded: float = 0.0) -> bool:
    """Whether a value, rounded by so much, is within a part of the right one, or within what the item allows."""
    return distance(value, item, right) - rounded <= allowed(right, item, part) + SLACK * abs(right)


def allowed(right: float, item: Item, part: float) -> float:
    """How far from the right value is within a part of it: the larger of that and of what the item allows."""
    return max(part * abs(right), item.within)


def distance(value: float, item: Item, right: float) -> float:
    """How far a value is from the right one: of angles whole turns aside, of an open sense the nearer of both."""
    apart = _apart(value, item, right)
    return min(apart, _apart(value, item, -right)) if item.either_sense else apart


def rounding(answer: Answer, item: Item) -> float:
    """By how much the value may have been rounded, in the unit of the item."""
    if not answer.value:
        return 0.0
    figures = max(LEAST_FIGURES, item.digits - 1)
    most = 10.0 ** (math.floor(math.log10(abs(answer.value))) - figures + 1)
    return min(answer.step, most) / 2


def _apart(value: float, item: Item, right: float) -> float:
    apart = abs(value - right)
    if kind_of(item.unit) == "angle":
        turn = conversion("rev", item.unit)
        return min(apart % turn, -apart % turn)
    return apart
