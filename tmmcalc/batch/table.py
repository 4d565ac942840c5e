"""Tables of variants: a CSV with a variant a row and keys of the spec as headers.

    variant,mechanism.links[id=1].points.A[0][mm],mechanism.input.speed[rpm]
    01,180,52
    02,185,55

A header with a dot is a key, with the unit of its numbers in brackets at the end; the other columns are labels, the
first of which names the variant.
"""

from __future__ import annotations

import csv
from pathlib import Path

from tmmcalc.core.errors import UsageError
from tmmcalc.core.headers import key_and_unit
from tmmcalc.project.loader import read_text
from tmmcalc.spec.variants import Axis

MOST_BYTES = 10_000_000

Labels = tuple[tuple[str, tuple[str, ...]], ...]


def read_points(file: Path) -> tuple[Labels, tuple[Axis, ...]]:
    """Labels and keys of a table; raises UsageError for a file that is none."""
    header, *rows = cells_of(file)
    labels: list[tuple[str, tuple[str, ...]]] = []
    axes: list[Axis] = []
    for at, name in enumerate(header):
        column = [row[at] for row in rows]
        if not is_key(name):
            labels.append((name, tuple(column)))
            continue
        key, unit = key_and_unit(name)
        axes.append(Axis(key, tuple(number_of(file, line, name, cell) for line, cell in enumerate(column, 2)), unit))
    if not axes:
        raise UsageError(
            f"{file} has no key of the spec among its headers", remedy="a key has a dot, such as motion.inertia"
        )
    return tuple(labels), tuple(axes)


def is_key(header: str) -> bool:
    """Whether a header is a key of the spec, not that of labels."""
    return "." in header


def row_of(file: Path, name: str) -> list[str]:
    """The overrides of the variant with this name; raises UsageError if there is none."""
    labels, axes = read_points(file)
    names = labels[0][1] if labels else ()
    if names.count(name) != 1:
        count = f"{names.count(name)} rows are" if name in names else "no row is"
        raise UsageError(f"{file}: {count} called {name!r}", remedy=f"its rows: {', '.join(names) or 'have no names'}")
    at = names.index(name)
    return [axis.assignment(axis.values[at]) for axis in axes]


def cells_of(file: Path) -> list[list[str]]:
    """The rows of a CSV with the same number of cells in each; raises UsageError for a file that is none."""
    try:
        rows = [
            [cell.strip() for cell in row] for row in csv.reader(read_text(file, MOST_BYTES).splitlines()) if any(row)
        ]
    except csv.Error as error:
        raise UsageError(f"{file} is not CSV: {error}", remedy="look for a quote that is not closed") from None
    if len(rows) < 2:
        raise UsageError(f"{file} has no rows under its header", remedy="write one row for each variant")
    uneven = next((line for line, row in enumerate(rows, 1) if len(row) != len(rows[0])), None)
    if uneven is not None:
        raise UsageError(
            f"{file}, row {uneven}: {len(rows[uneven - 1])} cells under {len(rows[0])} headers",
            remedy="separate cells by commas, one for each header",
        )
    return rows


def number_of(file: Path, line: int, name: str, cell: str, where: str = "") -> float:
    """The number of a cell; raises UsageError for one that is none, with its row and its header."""
    try:
        value = float(cell)
    except ValueError:
        value = float("nan")
    if abs(value) < float("inf"):
        return value
    rule = f"{file}, row {line}, {name}: {cell!r} is no number"
    raise UsageError(rule, where=where, remedy="write a number such as 62 or 0.05")
