"""The given moment of inertia is taken as one about the pin, and m s^2 is taken away."""

from __future__ import annotations

from tmmcalc.core.mistake import SELDOM, Document, Mistake, Tables
from tmmcalc.linkage.tables.altered import with_steiner


def _tables(document: Document, part: str) -> Tables:
    return with_steiner(document, -1)


MISTAKE = Mistake(
    "m s^2 is taken away from the given moment of inertia, which is about the centre of mass already",
    "About which point is the moment of inertia given?",
    SELDOM,
    tables=_tables,
)
