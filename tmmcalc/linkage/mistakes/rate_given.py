"""The velocity or the acceleration is given, per second, in place of the transfer function."""

from __future__ import annotations

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake
from tmmcalc.linkage.readings import in_time


def _reads(asked: Asked) -> float:
    return asked.another(in_time(asked.name))


MISTAKE = Mistake(
    "the rate per second is given in place of that per radian of the crank",
    "By what has the transfer function been multiplied? It does not depend on the speed of the crank.",
    SOMETIMES,
    reads=_reads,
)
