"""Weights are left out of the forces."""

from __future__ import annotations

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables
from tmmcalc.linkage.tables.altered import with_gravity


def _tables(document: Document, part: str) -> Tables:
    return with_gravity(document, 0.0)


MISTAKE = Mistake(
    "the weights of the links are left out",
    "Are all given forces there, on every link that has a mass?",
    OFTEN,
    tables=_tables,
)
