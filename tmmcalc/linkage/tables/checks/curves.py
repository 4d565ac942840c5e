"""Checks of ``[loads.table]``: abscissae that ascend within their range, and one value for each."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from tmmcalc.linkage.tables.checks.windows import (
    MOST_TURNS,
    TURN,
    beyond,
    check_output,
    check_travel,
    check_turns,
    grid_steps,
    outputs,
    travel,
)
from tmmcalc.linkage.tables.checks.written_linkage import written_linkage
from tmmcalc.spec.dimensions import DIMENSIONS
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.outline import Outline, Raw, word
from tmmcalc.spec.phrases import Path, show
from tmmcalc.spec.units import dimension_of
from tmmcalc.spec.values import amount, amounts, first_disorder

_OF_OUTPUT = ("displacement", "stroke")


class Curve(NamedTuple):
    """A table as written, or as read from its file."""

    outline: Outline
    table: Raw
    path: Path
    of: str

    def place(self, key: str, index: int | None = None) -> Path:
        """Place of a value: in the table, or the file that it comes from."""
        if self.path in self.outline.rows:
            return (*self.path, "file")
        return (*self.path, key) if index is None else (*self.path, key, index)

    def at(self, index: int) -> str:
        """Words for the line of a file that a value stands in."""
        rows = self.outline.rows.get(self.path)
        return f"{rows.file}, line {rows.lines[index]}: " if rows else ""


def check_table(outline: Outline, table: object, path: Path) -> Iterator[Finding]:
    """Yield the faults of a load table."""
    if not isinstance(table, dict):
        return
    curve = Curve(outline, table, path, word(table, "of", "angle"))
    yield from _check_source(curve)
    yield from _check_options(curve)
    yield from _check_abscissae(curve)


def _check_source(curve: Curve) -> Iterator[Finding]:
    """Values stand in the table or in a file, and are forces or moments."""
    values = [key for key in ("force", "moment") if key in curve.table]
    if "file" in curve.table:
        given = [key for key in ("x", *values) if key in curve.table]
        if given and curve.path not in curve.outline.rows:
            yield Finding(
                (*curve.path, "file"),
                f"file together with {' and '.join(given)}: the file holds all values",
                f"remove file, or remove {' and '.join(given)}",
            )
    elif not values:
        yield Finding(
            curve.path,
            "missing key: a table of a load has its values",
            'add force = [0, "1.5 kN", 0], moment = [...], or file = "q.csv"',
        )
    if len(values) == 2:
        yield Finding(
            (*curve.path, "moment"), "force and moment together: a load is one of them", "write one [[loads]] for each"
        )


def _check_options(curve: Curve) -> Iterator[Finding]:
    table, path = curve.table, curve.path
    if "output" in table and curve.of not in _OF_OUTPUT:
        yield Finding(
            (*path, "output"),
            f"output in a table of {curve.of}: only a displacement or stroke is that of an output",
            'remove it, or write of = "displacement"',
        )
    else:
        yield from check_output(curve.outline, table.get("output"), (*path, "output"))
    if "period" not in table:
        return
    if curve.of not in ("angle", "position") or written_linkage(curve.outline).slides:
        what = "with a driven slider" if written_linkage(curve.outline).slides else f"of {curve.of}"
        yield Finding((*path, "period"), f"period in a table {what}: only crank angles repeat", "remove it")
        return
    period = amount(table["period"], "angle")
    if curve.of == "position" or (period and period > MOST_TURNS * TURN):
        yield from check_turns(table["period"], (*path, "period"))
    elif period and not _is_whole(max(period / TURN, TURN / period)):
        yield Finding(
            (*path, "period"),
            f"{show(table['period'])} is neither a whole number of turns nor a whole part of a turn",
            'write "360 deg", "720 deg" for a four-stroke engine, or "180 deg"',
        )


def _is_whole(number: float) -> bool:
    return abs(number - round(number)) < 1e-9


def _check_abscissae(curve: Curve) -> Iterator[Finding]:
    """One value for each abscissa; the abscissae ascend, in the dimension and the range of what they are."""
    key = next((key for key in ("force", "moment") if key in curve.table), "")
    values = curve.table.get(key)
    count = len(values) if isinstance(values, list) else None
    if "x" not in curve.table:
        yield from _check_without_x(curve, key, count)
        return
    listed = curve.table["x"]
    if not isinstance(listed, list):
        return
    if count is not None and count != len(listed) > 1 < count:
        yield Finding(
            curve.place(key), f"{count} values for {len(listed)} abscissae x", "write one value for each abscissa"
        )
    wrong = list(_check_dimensions(curve, listed))
    yield from wrong
    numbers = amounts(listed, "angle", "length")
    if wrong or not numbers:
        return
    jumps = curve.of == "angle" and word(curve.table, "interpolation", "linear") == "linear"
    disorder = first_disorder(numbers, jumps=jumps)
    if disorder is not None:
        twice = jumps and numbers[disorder] == numbers[disorder - 1]
        rule = "at most two values at one angle, a jump" if twice else "x ascends"
        yield Finding(
            curve.place("x", disorder),
            f"{curve.at(disorder)}{show(listed[disorder])} does not come after {show(listed[disorder - 1])}; {rule}",
            "put the values in order" + ("" if jumps else "; a jump is two loads, each between its own angles"),
        )
    else:
        yield from _check_range(curve, listed, numbers)


def _check_without_x(curve: Curve, key: str, count: int | None) -> Iterator[Finding]:
    missing = curve.of == "displacement" or (curve.of == "angle" and written_linkage(curve.outline).slides)
    if missing and "file" not in curve.table:
        what = "displacements" if curve.of == "displacement" else "distances of the driven slider"
        yield Finding(curve.path, f"missing key: a table of {what} has its x", 'add x = ["0 mm", "50 mm", "200 mm"]')
    steps = grid_steps(curve.outline)
    if count is None or steps is None or count <= steps:
        return
    values = curve.table[key]
    last = steps * _turns(curve)
    if curve.of == "position" and count > last + 1:
        yield Finding(
            (*curve.path, key),
            f"{count} values for {last + 1} positions (0 to {last})",
            "write one value for each position, or add x",
        )
    if curve.of == "angle" and not missing and count == steps + 1 and values[0] == values[-1]:
        yield Finding(
            (*curve.path, key),
            f"{count} values are {count} equal steps over the period, but the last repeats the first as at the {count} "
            f"positions 0 to {steps}",
            'write of = "position", or leave the last value out',
        )


def _check_dimensions(curve: Curve, listed: list[object]) -> Iterator[Finding]:
    if curve.path in curve.outline.rows:
        written = curve.outline.rows[curve.path].unit
        listed = [written] if written else []
    for index, value in enumerate(listed):
        dimension = dimension_of(value)
        if dimension not in ("angle", "length"):
            continue
        if curve.of in ("position", "stroke"):
            what = "numbers of positions" if curve.of == "position" else "parts of the stroke, from 0 to 1"
            yield Finding(
                curve.place("x", index), f"{show(value)} has a unit; x are {what}", "write a number without unit"
            )
        elif curve.of == "displacement":
            needed = _of_output(curve)
            if needed not in (None, dimension):
                yield Finding(
                    curve.place("x", index),
                    f"{show(value)} is {DIMENSIONS[dimension].noun}; the displacement of the output is "
                    f"{DIMENSIONS[needed].noun}",
                    f'write {DIMENSIONS[needed].noun}, such as "{DIMENSIONS[needed].example}"',
                )
        elif dimension != travel(curve.outline):
            yield from check_travel(curve.outline, value, math.inf, curve.place("x", index))


def _of_output(curve: Curve) -> str | None:
    """Return the dimension of the output's displacement, None if the output is not listed."""
    named = outputs(curve.outline)
    wanted = curve.table.get("output", named[0][0] if named else None)
    output = next((output for name, output in named if name == wanted), None)
    return None if output is None else "angle" if "link" in output else "length"


def _turns(curve: Curve) -> int:
    """Turns over which a table of positions counts."""
    return max(1, round((amount(curve.table.get("period"), "angle") or TURN) / TURN))


def _check_range(curve: Curve, listed: list[object], numbers: list[float]) -> Iterator[Finding]:
    last = len(numbers) - 1
    if curve.of == "stroke" and numbers[last] > 1:
        yield Finding(
            curve.place("x", last),
            f"{curve.at(last)}{show(listed[last])} is more than 1, the whole stroke",
            'write parts of the stroke from 0 to 1, or of = "displacement"',
        )
    if curve.of == "position":
        yield from _check_numbers(curve, listed, numbers)
    if curve.of == "angle" and not written_linkage(curve.outline).slides:
        end = numbers[0] + (amount(curve.table.get("period"), "angle") or TURN)
        if numbers[last] > end * (1 + 1e-12):
            fault = beyond(listed[last], numbers[last], end - numbers[0], curve.place("x", last))
            yield fault._replace(message=curve.at(last) + fault.message)


def _check_numbers(curve: Curve, listed: list[object], numbers: list[float]) -> Iterator[Finding]:
    own = grid_steps(curve.outline)
    steps = None if own is None else own * _turns(curve)
    for index, number in enumerate(numbers):
        if not number.is_integer() or (steps is not None and number > steps):
            known = f"0 to {steps}" if steps is not None else "whole numbers"
            yield Finding(
                curve.place("x", index),
                f"{curve.at(index)}there is no position {show(listed[index])}",
                f"the positions are {known} ([mechanism.grid])",
            )
            return
