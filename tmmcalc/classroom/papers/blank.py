"""The empty table of answers of a student, as ``class mark`` reads it."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence

from tmmcalc.classroom.model import Item
from tmmcalc.report.language import tr


def blank(items: Sequence[Item]) -> bytes:
    """Names and units with room for values: semicolons part them, since a comma may be decimal."""
    text = io.StringIO()
    table = csv.writer(text, delimiter=";", lineterminator="\n")
    table.writerow((tr("Quantity"), tr("Value"), tr("Unit")))
    table.writerows((item.name, "", item.unit) for item in items)
    return text.getvalue().encode("utf-8-sig")
