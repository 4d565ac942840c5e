"""Weights act upwards."""

from __future__ import annotations

from math import pi
from typing import Any

from tmmcalc.core.mistake import SELDOM, Document, Mistake, Tables
from tmmcalc.linkage.tables.altered import mechanism_with
from tmmcalc.spec.altered import bare


def _tables(document: Document, part: str) -> Tables:
    def turned(mechanism: dict[str, Any]) -> bool:
        direction = bare(mechanism.get("gravity_direction", -pi / 2))
        if direction is None or not any(link.get("mass") for link in mechanism["links"]):
            return False
        mechanism["gravity_direction"] = direction + pi if direction <= 0 else direction - pi
        return True

    return mechanism_with(document, turned)


MISTAKE = Mistake(
    "the weights act upwards",
    "Look at the sense of the weights in your equations.",
    SELDOM,
    tables=_tables,
)
