"""The second transfer function is multiplied by omega and not by its square."""

from __future__ import annotations

from math import nan

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake
from tmmcalc.linkage.readings import is_acceleration, speed


def _reads(asked: Asked) -> float:
    return asked.value / speed(asked) if is_acceleration(asked.name) else nan


MISTAKE = Mistake(
    "the acceleration has omega in place of its square",
    "Look at the power of the angular velocity in the acceleration.",
    SOMETIMES,
    reads=_reads,
)
