"""The transfer function of the follower is given for its velocity or acceleration (digest 08)."""

from __future__ import annotations

from tmmcalc.core.mistake import OFTEN, Asked, Mistake
from tmmcalc.naming.beside import in_place

OTHER = {
    "v": "S1",
    "a": "S2",
    "jerk": "S3",
    "velocity_max": "S1_max",
    "velocity_min": "S1_min",
    "acceleration_max": "S2_max",
    "acceleration_min": "S2_min",
}


def _reads(asked: Asked) -> float:
    return asked.another(in_place(asked.name, OTHER))


MISTAKE = Mistake(
    "the transfer function of the follower is given: it is not multiplied by omega or its square",
    "By what does a transfer function have to be multiplied for a velocity, and for an acceleration?",
    OFTEN,
    reads=_reads,
)
