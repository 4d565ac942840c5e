"""Whether an answer is right.

A number that is written to so many figures is an interval: it is right where the interval meets the tolerance. It is so
for as many figures as are asked for and for one less; fewer figures count as these followed by zeros, so that a rough
number is no way to be right.
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
    unasked = "not asked"  # the variant has no such result


def standing_of(answer: Answer, item: Item, right: float) -> Standing:
    """What an answer is beside the right value, in the unit of the item; what was carried on is not known here."""
    if not math.isfinite(right):
        return Standing.unasked
    if math.isnan(answer.value):
        return Standing.unreadable if answer.text else Standing.missing
    within = max(item.tolerance * abs(right), item.within)
    off = distance(answer.value, item, right) - rounding(answer, item)
    if off <= within + SLACK * abs(right):
        return Standing.right
    by_plans = max(item.plans * abs(right), item.within)
    return Standing.plans if off <= by_plans + SLACK * abs(right) else Standing.wrong


def distance(value: float, item: Item, right: float) -> float:
    """How far a value is from the right one: of angles whole turns aside, of an open sense the nearer of both."""
    apart = _apart(value, item, right)
    return min(apart, _apart(value, item, -right)) if item.either_sense else apart


def rounding(answer: Answer, item: Item) -> float:
    """By how much the value may have been rounded, in the unit of the item."""
    if not answer.value:
        return answer.step / 2
    figures = max(LEAST_FIGURES, item.digits - 1)
    most = 10.0 ** (math.floor(math.log10(abs(answer.value))) - figures + 1)
    return min(answer.step, most) / 2


def _apart(value: float, item: Item, right: float) -> float:
    apart = abs(value - right)
    if kind_of(item.unit) == "angle":
        turn = conversion("rev", item.unit)
        return min(apart % turn, -apart % turn)
    return apart
