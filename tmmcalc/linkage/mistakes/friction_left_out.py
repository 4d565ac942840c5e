"""Friction in the pairs is left out."""

from __future__ import annotations

from tmmcalc.core.mistake import OFTEN, Document, Mistake, Tables
from tmmcalc.linkage.tables.altered import with_each


def _tables(document: Document, part: str) -> Tables:
    return with_each(document, "joints", "friction", lambda coefficient: 0.0)


MISTAKE = Mistake(
    "friction in the pairs is left out",
    "Which pairs rub, and does your table have what that adds?",
    OFTEN,
    tables=_tables,
)
