"""The transmission angle is given for the pressure angle, or the other way: they add up to a right angle."""

from __future__ import annotations

from math import nan

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake
from tmmcalc.naming.language import parse

RIGHT = {"deg": 90.0, "rad": 1.5707963267948966}
ANGLES = ("transmission_", "pressure_", "theta_", "gamma_")


def _reads(asked: Asked) -> float:
    what = parse(asked.name).what
    if asked.unit not in RIGHT or not (what in ("theta", "gamma") or what.startswith(ANGLES)) or "_at_" in what:
        return nan
    return RIGHT[asked.unit] - abs(asked.value)


MISTAKE = Mistake(
    "the transmission angle is given for the pressure angle, or the other way",
    "Between which two directions is this angle?",
    SOMETIMES,
    reads=_reads,
)
