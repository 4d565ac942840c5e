"""The number of revolutions a minute is taken for radians a second."""

from __future__ import annotations

from math import pi
from typing import Any

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables
from tmmcalc.linkage.tables.altered import mechanism_with
from tmmcalc.spec.altered import bare
from tmmcalc.spec.units import unit_of


def _tables(document: Document, part: str) -> Tables:
    def taken(mechanism: dict[str, Any]) -> bool:
        speed = mechanism["input"].get("speed")
        number = bare(speed)
        if number is None or unit_of(speed) != "rpm":
            return False
        mechanism["input"]["speed"] = number * 30 / pi
        return True

    return mechanism_with(document, taken)


MISTAKE = Mistake(
    "the speed in rpm is taken for rad/s",
    "Look at the unit of the speed of the crank before you put it into a formula.",
    OFTEN,
    tables=_tables,
)
