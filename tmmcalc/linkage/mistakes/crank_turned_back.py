"""The crank is turned the other way."""

from __future__ import annotations

from typing import Any

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables
from tmmcalc.linkage.tables.altered import mechanism_with
from tmmcalc.spec.altered import bare
from tmmcalc.spec.quantities import BY_MOTOR, CLOCKWISE

OTHER = {BY_MOTOR: CLOCKWISE, CLOCKWISE: BY_MOTOR}


def _tables(document: Document, part: str) -> Tables:
    def turned(mechanism: dict[str, Any]) -> bool:
        speed = mechanism["input"].get("speed")
        number = bare(speed)
        mechanism["input"]["speed"] = OTHER.get(speed) if number is None else -number
        return mechanism["input"]["speed"] is not None

    return mechanism_with(document, turned)


MISTAKE = Mistake(
    "the crank is turned the other way",
    "Look at the arrow at the crank: which way does it turn?",
    OFTEN,
    tables=_tables,
)
