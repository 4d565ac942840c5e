"""The angular velocity is taken as n/60, without the 2 pi of a turn."""

from __future__ import annotations

from math import pi
from typing import Any

from tmmcalc.core.mistake import SOMETIMES, Document, Mistake, Tables
from tmmcalc.linkage.tables.altered import mechanism_with
from tmmcalc.spec.altered import bare
from tmmcalc.spec.units import unit_of


def _tables(document: Document, part: str) -> Tables:
    def taken(mechanism: dict[str, Any]) -> bool:
        speed = mechanism["input"].get("speed")
        number = bare(speed)
        if number is None or unit_of(speed) != "rpm":
            return False
        mechanism["input"]["speed"] = number / (2 * pi)
        return True

    return mechanism_with(document, taken)


MISTAKE = Mistake(
    "the angular velocity is taken in turns per second: n/60 without 2 pi",
    "How many radians has a turn? Look at how the angular velocity follows from the revolutions.",
    SOMETIMES,
    tables=_tables,
)
