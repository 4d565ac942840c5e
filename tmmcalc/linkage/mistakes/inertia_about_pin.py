"""The moment of inertia is taken about the origin of the axes of the link: I + m s^2."""

from __future__ import annotations

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables
from tmmcalc.linkage.tables.altered import with_steiner


def _tables(document: Document, part: str) -> Tables:
    return with_steiner(document, 1)


MISTAKE = Mistake(
    "the moment of inertia is taken about the pin of the link, as if it were given about the centre of "
    "mass (I + m s^2)",
    "About which point is the moment of inertia given, and about which one does your equation need it?",
    OFTEN,
    tables=_tables,
)
