"""The speed against the carrier is given in place of that against the frame, or the other way."""

from __future__ import annotations

from math import nan

from tmmcalc.core.mistake import OFTEN, Asked, Mistake
from tmmcalc.naming.language import parse

OTHER = {"omega": "omega_rel", "omega_rel": "omega"}


def _reads(asked: Asked) -> float:
    name = parse(asked.name)
    if name.stage != "gearing" or name.what not in OTHER:
        return nan
    return asked.another(name._replace(what=OTHER[name.what]).text)


MISTAKE = Mistake(
    "speeds against the carrier and against the frame are mixed up",
    "Against what is this speed: the frame or the carrier?",
    OFTEN,
    reads=_reads,
)
