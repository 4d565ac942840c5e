"""The transfer function of the follower is per degree in place of per radian."""

from __future__ import annotations

from math import nan, pi

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake
from tmmcalc.naming.language import parse


def _reads(asked: Asked) -> float:
    name = parse(asked.name)
    function = name.what[:2] if name.stage in ("cam_law", "cam_forces") else ""
    return asked.value * (pi / 180) ** int(function[1]) if function in ("S1", "S2", "S3") else nan


MISTAKE = Mistake(
    "the transfer function of the follower is per degree in place of per radian",
    "By which unit of the angle is this a derivative?",
    SOMETIMES,
    reads=_reads,
)
