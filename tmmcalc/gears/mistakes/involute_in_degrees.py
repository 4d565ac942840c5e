"""The involute function has its angle in degrees: inv alpha = tan alpha - alpha."""

from __future__ import annotations

from math import degrees, nan

from tmmcalc.core.mistake import SOMETIMES, Asked, Mistake
from tmmcalc.gears.readings import wheel_value
from tmmcalc.naming.language import parse

ANGLES = {"inv_alpha_t": "alpha_t", "inv_alpha_tw": "alpha_tw", "inv_alpha_a": "alpha_a"}


def _reads(asked: Asked) -> float:
    what = parse(asked.name).what.rpartition(".")[2]
    if what in ANGLES:
        alpha = wheel_value(asked, ANGLES[what])
        return asked.value + alpha - degrees(alpha)
    if what != "s_ta":
        return nan
    alpha, at_tip, radius = (wheel_value(asked, each) for each in ("alpha_t", "alpha_a", "r_a"))
    return asked.value + 2 * radius * asked.scale * ((alpha - degrees(alpha)) - (at_tip - degrees(at_tip)))


MISTAKE = Mistake(
    "the involute function has its angle in degrees",
    "In which unit does the angle stand in the involute function?",
    SOMETIMES,
    reads=_reads,
)
