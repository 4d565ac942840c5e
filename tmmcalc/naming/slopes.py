"""How what is asked of the rows of a table changes when the rows do, to both sides.

Extremes go with the row where they stand. Where several rows have the same extreme, the one that grows most takes over
to larger values and the one that falls most to smaller ones: both sides are told, which are one where all grow alike.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.derivatives import Derivative
from tmmcalc.core.facts import named
from tmmcalc.core.numerics.through import integral
from tmmcalc.naming.language import Name
from tmmcalc.naming.rows import closes, labelled, run_of
from tmmcalc.naming.table import Table

Values = NDArray[np.floating[Any]]

TIE = 1e-9  # of the largest value: rows nearer than this have one extreme
NOISE = 1e-13  # of the largest value in the same unit: what is less may be rounding
STEP = 1e-3  # of the difference of an integral over rows that move, against what changes
STENCIL = ((-2.0, 1 / 12), (-1.0, -2 / 3), (1.0, 2 / 3), (2.0, -1 / 12))


class _Asked(NamedTuple):
    """The rows that are asked, and their changes along K directions; what of both may be rounding."""

    values: Values  # (n,)
    changes: Values  # (K, n)
    noise: float
    error: Values  # (K,)


class Sides(NamedTuple):
    """Derivatives (K,) to larger values along K directions, and from smaller ones; what they may be off by."""

    right: Values
    left: Values
    error: Values


def slopes_of_rows(name: Name, table: Table, header: str, columns: Mapping[str, Derivative]) -> Sides | None:
    """Derivatives of what a name asks of the column of a header, whose rows change as ``columns`` by header tell.

    None where they are not given: at places between rows, and of where extremes stand if that may jump.
    """
    place, change = name.place, columns.get(header)
    if change is None or (place is not None and place.column) or name.of == "chosen":
        return None
    some = slice(None) if place is None else labelled(name, table.labels, place)
    one = place is not None and not place.last
    values, changes = table.column(header)[some], change.value[:, some]
    known = ~np.isnan(values)
    if not known.any() or (name.of == "integral" and not known.all()):
        return None
    noise, error = _rounding(table, header, columns)
    asked = _Asked(values[known], changes[:, known], noise, np.maximum(error, change.error))
    if one and not name.of:
        return Sides(changes[:, 0], changes[:, 0], asked.error)
    if name.of in ("integral", "at_max", "at_min", "at_size"):
        return _over_rows(name.of, table, columns, some, asked)
    way = WAYS.get(name.of)
    return None if way is None else way(asked)


def _rounding(table: Table, header: str, columns: Mapping[str, Derivative]) -> tuple[float, Values]:
    """What of values, and of changes (K,), in the unit of a column may be rounding."""
    unit = named(header)[1]
    alike = [each for each in table.headers if named(each)[1] == unit and each in columns]
    values = max(float(np.nanmax(np.abs(table.column(each)), initial=0.0)) for each in alike)
    changes = np.max([np.max(np.abs(columns[each].value), axis=1) for each in alike], axis=0)
    return NOISE * values, NOISE * changes


def _extreme(asked: _Asked, sign: float = 1.0) -> Sides:
    there = asked.changes[:, _tied(sign * asked.values, asked.noise)]
    most, least = there.max(axis=1), there.min(axis=1)
    return Sides(most, least, asked.error) if sign > 0 else Sides(least, most, asked.error)


def _tied(values: Values, noise: float) -> NDArray[np.bool_]:
    """Rows that share the largest value."""
    return np.asarray(values >= np.max(values) - max(TIE * np.max(np.abs(values)), noise))


def _range(asked: _Asked) -> Sides:
    high, low = _extreme(asked), _extreme(asked, -1.0)
    return Sides(high.right - low.right, high.left - low.left, 2 * asked.error)


def _size(asked: _Asked) -> Sides:
    """Of the largest magnitude; a column that is nothing everywhere grows to both sides."""
    if np.max(np.abs(asked.values)) <= asked.noise:
        most = np.max(np.abs(asked.changes), axis=1)
        return Sides(most, -most, asked.error)
    return _extreme(asked._replace(values=np.abs(asked.values), changes=np.sign(asked.values) * asked.changes))


def _mean(asked: _Asked) -> Sides:
    mean = asked.changes.mean(axis=1)
    return Sides(mean, mean, asked.error)


def _root_mean_square(asked: _Asked) -> Sides:
    size = float(np.sqrt(np.mean(asked.values**2)))
    if size <= asked.noise:
        grown = np.sqrt(np.mean(asked.changes**2, axis=1))
        return Sides(grown, -grown, asked.error)
    changed = (asked.changes @ asked.values) / (len(asked.values) * size)
    return Sides(changed, changed, asked.error)


def _row(asked: _Asked, at: int) -> Sides:
    return Sides(asked.changes[:, at], asked.changes[:, at], asked.error)


WAYS: Mapping[str, Callable[[_Asked], Sides]] = {
    "max": _extreme,
    "min": lambda asked: _extreme(asked, -1.0),
    "range": _range,
    "size": _size,
    "mean": _mean,
    "rms": _root_mean_square,
    "first": lambda asked: _row(asked, 0),
    "last": lambda asked: _row(asked, -1),
}


def _over_rows(of: str, table: Table, columns: Mapping[str, Derivative], some: Any, asked: _Asked) -> Sides | None:
    """Of an integral over what the rows run over, and of where an extreme stands."""
    header = run_of(table)
    if header is None or header not in columns:
        return None
    unit, change, values = named(header)[1], columns[header], asked.values
    x, dx = table.column(header)[some], change.value[:, some]
    if of != "integral":
        best = {"at_max": values, "at_min": -values, "at_size": np.abs(values)}[of]
        tied = np.flatnonzero(_tied(best, asked.noise))
        return Sides(dx[:, tied[0]], dx[:, tied[0]], change.error) if len(tied) == 1 and len(values) == len(x) else None
    factor = np.deg2rad(1.0) if unit == "deg" else 1.0
    closed, span = closes(unit, x, values), float(np.ptp(x)) * factor
    pairs = zip(factor * dx, asked.changes, strict=True)
    changed = np.array([_integral(factor * x, values, *pair, closed) for pair in pairs])
    off = change.error * factor * float(np.max(np.abs(values)))
    return Sides(changed, changed, asked.error * span + off)


def _integral(x: Values, values: Values, dx: Values, changes: Values, closed: bool) -> float:
    """The change of an integral: by differences of its formula where the rows move, which are exact to rounding."""
    if not dx.any():
        return integral(x, changes, closed)
    size = max(np.max(np.abs(dx)) / np.ptp(x), np.max(np.abs(changes)) / (np.max(np.abs(values)) or 1.0))
    h = STEP / float(size)
    return sum(w / h * integral(x + s * h * dx, values + s * h * changes, closed) for s, w in STENCIL)
