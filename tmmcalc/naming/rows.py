"""What is asked of the rows of a table: extremes, means, where they are, integrals, values at a place.

Extremes, means and where they are go by the rows of the table as they stand, each counting once. An integral is that of
the cubic through the four nearest rows, over what the rows run over (angles in rad), which on equal steps around a
whole turn is the trapezoid rule with its full accuracy; no cubic reaches over a jump, where two rows have one place,
and around a turn that closes it goes on from the first row. A value between two rows is computed there where the stage
can do that (`placed` of a stage, as kinematics and forces can), so it is as exact as its rows; else it is that of the
same cubic, with its distance from the polynomial through six rows. Every value says how it was found.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import nan
from typing import Any

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.facts import named
from tmmcalc.core.numerics.through import between, integral
from tmmcalc.naming.language import ROWS, Name, Place, near
from tmmcalc.naming.table import Table, Values
from tmmcalc.spec.units import UnitError, dimension_of
from tmmcalc.spec.units import parse as in_si

REDUCED: Mapping[str, Callable[[Values], Any]] = {  # what is asked of columns (..., n) by themselves
    "max": lambda values: np.max(values, axis=-1),
    "min": lambda values: np.min(values, axis=-1),
    "range": lambda values: np.ptp(values, axis=-1),
    "mean": lambda values: np.mean(values, axis=-1),
    "rms": lambda values: np.sqrt(np.mean(values**2, axis=-1)),
    "size": lambda values: np.max(np.abs(values), axis=-1),
    "first": lambda values: values[..., 0],
    "last": lambda values: values[..., -1],
}
WHERE: Mapping[str, Callable[[Values], Any]] = {
    "at_max": np.argmax,
    "at_min": np.argmin,
    "at_size": lambda values: np.argmax(np.abs(values)),
}
There = Callable[[Place], Table | None]
SAME = 1e-9  # of what the rows run over: a row nearer than this is at the place
SOME = "some rows have no value"
CLOSED = 1e-9  # of the largest value: the ends of a turn that closes differ by less


def asked_of(name: Name, result: Any, table: Table, header: str, there: There) -> tuple[float, str, str]:
    """Value, unit, and how it was found, of what a name asks of the column of a header; NaN where it has no value.

    ``there`` gives the table with a row at a place, where the stage can be solved there.
    """
    unit, place = named(header)[1], name.place
    values = table.column(header)
    if name.of == "chosen":
        if name.stage not in ROWS or place is not None:
            rule = "has no rows to choose from" if place is None else "the chosen row is one already"
            raise _misplaced(name, rule, f"chosen() is asked of {' and '.join(ROWS)}, without a place")
        return float(values[result.winner.place if name.stage == "criteria" else 0]), unit, "the chosen row"
    if place is None:
        return _of_rows(name, table, values, unit, _run_of(table))
    if not place.column:
        some = labelled(name, table.labels, place)
        if not place.last:
            return _of_one(name, float(values[some[0]]), unit, f"row {table.labels[some[0]]}")
        return _of_rows(name, table, values, unit, _run_of(table), some)
    unit_over, x = _over(name, table, place.column)
    low = _inside(name, place.column, place.first, unit_over, x)
    first, how = _at(name, place._replace(last=""), low, table, header, (unit_over, x), there)
    if not place.last:
        return _of_one(name, first, unit, how)
    high = _inside(name, place.column, place.last, unit_over, x)
    if high <= low:
        rule = f"ends at {high:g} {unit_over}, and begins at {low:g}".replace(" ,", ",")
        raise _misplaced(name, rule, "write the smaller value first; over the end of the rows two names are needed")
    last, _ = _at(name, Place(place.column, place.last), high, table, header, (unit_over, x), there)
    sense = slice(None) if x[-1] > x[0] else slice(None, None, -1)
    inside = (x > low) & (x < high)
    rows = np.concatenate(([low], x[inside][sense], [high]))
    ends = np.concatenate(([first], values[inside][sense], [last]))
    return _of_rows(name, table, ends, unit, (unit_over, rows))


def _of_one(name: Name, value: float, unit: str, how: str) -> tuple[float, str, str]:
    """What is asked of one row: its value, or nothing else."""
    if name.of in ("", "max", "min", "mean", "first", "last"):
        return value, unit, how
    if name.of in ("size", "rms"):
        return abs(value), unit, how
    raise _misplaced(name, "is asked of one row", "name the rows from one to another, @2..12, or leave the place out")


def _of_rows(
    name: Name, table: Table, values: Values, unit: str, over: tuple[str, Values] | None, some: Any = slice(None)
) -> tuple[float, str, str]:
    """What is asked of those rows that have a value, and of what they run over (its unit and its values)."""
    own = values[some]
    known = ~np.isnan(own)
    if name.of in REDUCED:
        own = own[known]
        return float(REDUCED[name.of](own)) if own.size else nan, unit, f"of {len(own)} rows"
    if over is None:
        raise _misplaced(name, "has rows that run over nothing", f"{name.of}() needs a column that grows or falls")
    per, x = over[0], over[1][some]
    if name.of == "integral":
        whole = known.all()
        found = integral(np.deg2rad(x) if per == "deg" else x, own, closes(per, x, own)) if whole else nan
        per = "rad" if per == "deg" else per
        how = "cubics through the rows" if whole else SOME
        return found, per if unit in ("", "-") else f"{unit}*{per}", how
    x, own = x[known], own[known]
    return float(x[int(WHERE[name.of](own))]) if own.size else nan, per, f"among {len(own)} rows"


def run_of(table: Table) -> str | None:
    """The header of what the rows run over: the first column after the numbers of the rows that runs one way."""
    own = table.headers[: len(table.headers) - table.further]
    return next((header for header in own if named(header)[0] != "i" and _one_way(table.column(header))), None)


def _run_of(table: Table) -> tuple[str, Values] | None:
    """Its unit and values."""
    header = run_of(table)
    return None if header is None else (named(header)[1], table.column(header))


def _one_way(x: Values) -> bool:
    steps = np.diff(x)
    return bool(x[0] != x[-1] and (np.all(steps >= 0) or np.all(steps <= 0)))


def labelled(name: Name, labels: Sequence[str], place: Place) -> Any:
    """The rows of a label, or from one to another; raises `UsageError` for labels that no row has."""
    ends = []
    for label in (place.first, place.last or place.first):
        if label not in labels:
            known = labels if len(labels) <= 12 else [*labels[:6], "...", labels[-1]]
            raise _misplaced(name, f"has no row {label!r}", near(label, known, "its rows are"))
        ends.append(labels.index(label))
    if ends[1] < ends[0]:
        raise _misplaced(name, f"has row {place.last} before row {place.first}", "write the earlier row first")
    return range(ends[0], ends[0] + 1) if not place.last else slice(ends[0], ends[1] + 1)


def _over(name: Name, table: Table, column: str) -> tuple[str, Values]:
    """The column of a place, its unit and values, which has to run one way."""
    found = {named(header)[0]: header for header in table.headers}
    if column not in found:
        raise _misplaced(name, f"stands in no table with a column {column!r}", near(column, found, "columns"))
    values = table.column(found[column])
    if not _one_way(values):
        rule = f"has several places, or none, for a value of {column}: it does not run one way"
        raise _misplaced(name, rule, "name a row, @6, or the value of phi or t")
    return named(found[column])[1], values


def _value(name: Name, written: str, unit: str) -> float:
    """A value in the unit of its column."""
    try:
        return in_unit(written, unit)
    except UnitError as error:
        raise _misplaced(name, f"cannot be found: {error.message}", f"write a number in {unit}") from None


def in_unit(value: float | str, unit: str) -> float:
    """A number, or a text with a unit, in the unit of what it is compared with.

    Raises `UnitError` for a unit of another kind, and for what is no number.

    >>> in_unit("30 mm", "m"), in_unit("45", "deg"), in_unit(2.0, "N")
    (0.03, 45.0, 2.0)
    """
    if not isinstance(value, str):
        return float(value)
    dimension = dimension_of(value)
    if dimension is None:
        try:
            return float(value)
        except ValueError:
            raise UnitError(f"{value!r} is no quantity") from None
    try:
        return in_si(value, dimension) / in_si(f"1 {unit}", dimension)
    except UnitError:
        raise UnitError(f"{value!r} is no number in {unit or 'no unit'}") from None


def _inside(name: Name, column: str, written: str, unit: str, x: Values) -> float:
    """A value of the column that rows run over, within these; of a turn it may be given in another one."""
    at, span = _value(name, written, unit), float(np.ptp(x))
    low, high = float(np.min(x)), float(np.max(x))
    if _turn(unit, x) and not low <= at <= high:
        at = low + (at - low) % 360
    if not low - SAME * span <= at <= high + SAME * span:
        rule = f"has no row about {column} = {written}"
        raise _misplaced(name, rule, f"its rows are from {low:g} to {high:g} {unit}".rstrip())
    return at


def _at(
    name: Name, place: Place, at: float, table: Table, header: str, over: tuple[str, Values], there: There
) -> tuple[float, str]:
    """The value of a column at a place, in the unit of the column that rows run over, and how it was found."""
    unit, x = over
    values = table.column(header)
    nearest = np.flatnonzero(np.abs(x - at) <= SAME * np.ptp(x))
    if nearest.size:
        side = ", after the jump" if nearest.size > 1 else ""
        return float(values[nearest[-1]]), f"row {table.labels[nearest[-1]]}{side}"
    found = there(place)
    if found is not None:
        own = found.column(next(each for each in found.headers if named(each)[0] == place.column))
        return float(found.column(header)[int(np.argmin(np.abs(own - at)))]), "computed there"
    if np.isnan(values).any():
        return nan, SOME
    value, off = between(x, values, at, closes(unit, x, values))
    return value, f"cubic through the rows, off by about {off:.1e}"


def closes(unit: str, x: Values, values: Values) -> bool:
    """Whether rows go around a turn that closes."""
    ends = abs(values[-1] - values[0]) <= CLOSED * float(np.max(np.abs(values)))
    return bool(ends and _turn(unit, x))


def _turn(unit: str, x: Values) -> bool:
    """Whether rows go around one turn."""
    return unit == "deg" and abs(float(np.ptp(x)) - 360) <= SAME * 360


def _misplaced(name: Name, rule: str, remedy: str) -> UsageError:
    return UsageError(f"{name.text} {rule}", remedy=remedy)
