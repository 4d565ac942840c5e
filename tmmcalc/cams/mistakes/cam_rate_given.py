"""The rate per second is given for the transfer function of the follower."""

from __future__ import annotations

from tmmcalc.cams.readings import IN_TIME
from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake
from tmmcalc.naming.beside import in_place


def _reads(asked: Asked) -> float:
    return asked.another(in_place(asked.name, IN_TIME))


MISTAKE = Mistake(
    "the rate per second is given in place of that per radian of the cam",
    "By what has the transfer function been multiplied? It does not depend on the speed of the cam.",
    SOMETIMES,
    reads=_reads,
)
