"""Reference tables of the strength calculation, one CSV file each beside the code, every row with its source.

A file has exactly the columns of its record; a cell that is not of the column's type is a fault of the file.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from inspect import get_annotations
from pathlib import Path
from typing import Any, TypeVar

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record

R = TypeVar("R")

ANY = "*"  # of all treatments, of all steels


@record
class Arrangement:
    """A row of Table D.4.1: how the load spreads over the width, K_beta = 1 + beta psi_bd."""

    row: int
    arrangement: str
    position: str  # of the wheels between their bearings, for D.4.2
    soft_contact: float  # beta_H, one wheel at least up to HB 350
    soft_bending: float  # beta_F
    hard_contact: float  # both wheels harder
    hard_bending: float
    source: str


@record
class WidthRange:
    """A row of Table D.4.2: usual face-width coefficients psi_bd."""

    position: str
    soft_low: float
    soft_high: float
    hard_low: float
    hard_high: float
    source: str


@record
class BendingRow:
    """A row of Table D.4.3: sigma_Flim^0 = base + slope * hardness, and S_F'."""

    row: str
    treatments: tuple[str, ...]
    scale: str  # of the range of hardness of the teeth; empty: no range
    low: float | None
    high: float | None
    steels: tuple[str, ...]
    doubtful: tuple[str, ...]  # steels whose designation is doubtful in print
    similar: bool  # the row holds for similar steels too
    base_mpa: float
    base_protected_mpa: float  # with measures against decarburisation of the surface
    slope_mpa: float
    slope_of: str  # "surface" or "core": whose hardness the slope is of
    safety: float  # S_F'
    safety_protected: float
    source: str


@record
class ContactRow:
    """A row of Table D.4.4: sigma_Hlim = slope * hardness + offset."""

    treatments: tuple[str, ...]
    scale: str
    low: float | None
    high: float | None
    slope_mpa: float
    offset_mpa: float
    source: str


@record
class ContactSafety:
    """A row of Table D.4.5: S_H by the consequences of a failure."""

    structure: str
    severe: float
    ordinary: float
    source: str


@record
class BlankSafety:
    """A row of Table D.4.6: the range of S_F''."""

    blank: str
    wear: str
    low: float
    high: float
    source: str


@record
class LoadSides:
    """A row of Table D.4.7: K_FC."""

    load: str
    treatments: tuple[str, ...]
    factor: float
    source: str


@record
class StandardModule:
    """An entry of Table D.4.8, of row 1 (preferred) or 2."""

    module_mm: float
    row: int
    source: str


FILES: dict[type, str] = {
    Arrangement: "load_distribution.csv",
    WidthRange: "face_width.csv",
    BendingRow: "bending_limits.csv",
    ContactRow: "contact_limits.csv",
    ContactSafety: "contact_safety.csv",
    BlankSafety: "blank_safety.csv",
    LoadSides: "load_sides.csv",
    StandardModule: "modules.csv",
}


@cache
def table(kind: type[R]) -> tuple[R, ...]:
    """All rows of the table whose rows are of this record.

    >>> [row.factor for row in table(LoadSides)]
    [1.0, 0.65, 0.75, 0.9]
    """
    file = Path(__file__).parent / "data" / FILES[kind]
    return parse(file.read_text(encoding="utf-8"), kind, file.name)


def parse(text: str, kind: type[R], file: str) -> tuple[R, ...]:
    """The rows of a CSV text; raises `UsageError` at the first cell that is not what its column says."""
    import csv  # late: only strength reads tables

    fields = get_annotations(kind)
    reader = csv.reader(text.splitlines())
    if next(reader, None) != [*fields]:
        raise _damaged(f"the columns are not {', '.join(fields)}", file, 1)
    rows = []
    for cells in reader:
        if len(cells) != len(fields) or not cells[-1]:
            raise _damaged(f"not {len(fields)} cells with a source in the last", file, reader.line_num)
        try:
            values = [_READERS[told](cell) for told, cell in zip(fields.values(), cells, strict=True)]
        except ValueError as error:
            raise _damaged(str(error), file, reader.line_num) from None
        rows.append(kind(*values))
    return tuple(rows)


def _damaged(message: str, file: str, line: int) -> UsageError:
    return UsageError(f"line {line}: {message}", where=f"table {file}", remedy="install the program anew")


def _number(cell: str) -> float:
    value = float(cell)
    if not math.isfinite(value):
        raise ValueError(f"{cell!r} is not a finite number")
    return value


def _optional(cell: str) -> float | None:
    return _number(cell) if cell else None


def _flag(cell: str) -> bool:
    if cell not in ("yes", "no"):
        raise ValueError(f"{cell!r} is neither yes nor no")
    return cell == "yes"


def _words(cell: str) -> tuple[str, ...]:
    return tuple(cell.split())


_READERS: dict[str, Callable[[str], Any]] = {
    "str": str,
    "int": int,
    "float": _number,
    "float | None": _optional,
    "bool": _flag,
    str(tuple[str, ...]): _words,
}
