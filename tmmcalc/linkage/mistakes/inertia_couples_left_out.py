"""The couples of inertia are left out, the forces of inertia alone are there (textbook 3.1)."""

from __future__ import annotations

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables
from tmmcalc.linkage.tables.altered import with_each


def _tables(document: Document, part: str) -> Tables:
    return with_each(document, "links", "inertia", lambda inertia: 0.0)


MISTAKE = Mistake(
    "the couples of the inertia of the links are left out",
    "What does the inertia of a link that turns unevenly give beside a force?",
    OFTEN,
    tables=_tables,
)
