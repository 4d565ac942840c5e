"""The mean power is the work of a cycle, not divided by its time."""

from __future__ import annotations

from math import nan

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake
from tmmcalc.naming.language import parse


def _reads(asked: Asked) -> float:
    if parse(asked.name).what not in ("P_mean", "P_required") or parse(asked.name).stage != "power":
        return nan
    return asked.value * asked.another("power.cycle_time") / asked.scale


MISTAKE = Mistake(
    "the work of a cycle is given in place of the mean power",
    "Work over what is power?",
    SOMETIMES,
    reads=_reads,
)
