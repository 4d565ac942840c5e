"""How people read the sizes of gears: modules and widths in millimetres, stresses in megapascals."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from tmmcalc.core.quantity import FORMS, Quantity
from tmmcalc.report.document import View
from tmmcalc.report.numbers import number

UNITS = {unit: (drawn, FORMS[unit, drawn]) for unit, drawn in (("m", "mm"), ("Pa", "MPa"))}  # of a drawing, factors


def quantity(value: float, unit: str, digits: int = 6) -> str:
    """A number with the unit of a drawing.

    >>> quantity(0.0035, "m"), quantity(609.0909e6, "Pa"), quantity(1.3, "-")
    ('3.5 mm', '609.091 MPa', '1.3')
    """
    shown, factor = UNITS.get(unit, (unit, 1.0))
    return f"{number(value * factor, digits)}{'' if unit == '-' else f' {shown}'}"


def lengths(values: Sequence[float]) -> str:
    """Lengths of the stages in millimetres.

    >>> lengths((0.002, 0.0035))
    '2 and 3.5 mm'
    """
    return f"{' and '.join(number(1e3 * value) for value in values)} mm"


def drawn(columns: Mapping[str, np.ndarray]) -> View:
    """A table for people: columns in m and Pa in the units of a drawing."""
    headers, values = [], []
    for header, column in columns.items():
        told = Quantity(header, "")
        unit = UNITS.get(told.unit, ("", 1.0))[0]
        shown, factor = told.shown(unit) if unit else (header, 1.0)
        headers.append(shown)
        values.append((column * factor).tolist() if unit and column.dtype.kind == "f" else _scaled(column, factor))
    return View(headers, values)


def _scaled(column: np.ndarray, factor: float) -> list[float | int | str]:
    """Cells of a column that may have blanks."""
    cells = column.tolist()
    return cells if factor == 1.0 else [float(cell) * factor if cell else "" for cell in cells]


def plain(columns: Mapping[str, np.ndarray]) -> View:
    """The table for programs, in SI."""
    return View(list(columns), [column.tolist() for column in columns.values()])
