"""The tables of vibration: columns chosen by name; people get the series that says most in few rows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from tmmcalc.core.columns import picked
from tmmcalc.core.quantity import Quantity
from tmmcalc.report.document import View
from tmmcalc.report.sizes import plain

SHOWN = 24  # equal steps of a series that is shown


def all_rows(columns: Mapping[str, np.ndarray], patterns: Sequence[str]) -> View:
    """All rows in SI."""
    return plain(picked(columns, patterns, "series"))


def spaced_rows(columns: Mapping[str, np.ndarray], patterns: Sequence[str]) -> View:
    """Rows at about equal steps of one series, in the units of a drawing."""
    chosen = dict(_drawn(header, column) for header, column in picked(columns, patterns, "series").items())
    count = len(next(iter(chosen.values())))
    rows = sorted({round(k * (count - 1) / SHOWN) for k in range(SHOWN + 1)})
    return View(
        list(chosen),
        [column[rows].tolist() for column in chosen.values()],
        [float(np.max(np.abs(column))) for column in chosen.values()],
    )


def _drawn(header: str, column: np.ndarray) -> tuple[str, np.ndarray]:
    """Lengths in millimetres, angles in degrees."""
    told = Quantity(header, "")
    people = {"m": "mm", "rad": "deg"}.get(told.unit)
    if people is None:
        return header, column
    shown, factor = told.shown(people)
    return shown, factor * column
