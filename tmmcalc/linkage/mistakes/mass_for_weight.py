"""The mass in kilograms is taken for the weight in newtons."""

from __future__ import annotations

from tmmcalc.core.mistake import SOMETIMES, Document, Mistake, Tables
from tmmcalc.linkage.tables.altered import with_gravity


def _tables(document: Document, part: str) -> Tables:
    return with_gravity(document, 1.0)


MISTAKE = Mistake(
    "the number of the mass is taken for the weight, in newtons",
    "Mass and weight of a link have different units: look at how one follows from the other.",
    SOMETIMES,
    tables=_tables,
)
