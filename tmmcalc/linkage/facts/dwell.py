"""What the document of a synthesis tells of a six-bar with a dwell: extremes, strokes, checks, its positions."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

from tmmcalc.core.columns import select
from tmmcalc.core.quantity import keyed
from tmmcalc.linkage.synthesis.dwell.columns import USUAL, columns_of
from tmmcalc.linkage.synthesis.dwell.results import Dwell, Largest
from tmmcalc.report.document import Fact, View
from tmmcalc.report.numbers import angle, number

ANGLE = math.degrees(1.0)


def dwell_facts(dwell: Dwell) -> Iterator[Fact]:
    """Facts of one linkage; angles of the crank count from position 1 along the motion."""
    unit = "m" if dwell.output == "slider" else "rad"
    listed = [_at(each, f"{_amount(each.value, unit)}") for each in dwell.extremes]
    yield Fact("extreme positions", "\n".join(listed), {"extremes": [*map(_values, dwell.extremes)]})
    largest = [_at(each, f"{each.name} {_amount(each.value, each.unit)}") for each in dwell.maxima]
    yield Fact("largest values", "\n".join(largest), {"maxima": [*map(_values, dwell.maxima)]})
    for name, window in (("working", dwell.working), ("idle", dwell.idle)):
        low, high = (ANGLE * end for end in window)
        text = f"{angle(low)} to {angle(high)} deg, {angle(high - low)} deg"
        yield Fact(f"{name} stroke", text, keyed(dwell, name))
    yield _check_fact(dwell)
    found = dwell.agreement
    text = (
        f"motion {found.motion:.0e}, forces {found.forces:.0e} against the rooms of kinematics and forces; "
        f"virtual work {found.virtual_work:.0e}; S in positions 2 and 3 {found.positions:.0e} h"
    )
    yield Fact("agreement", text, {"agreement": keyed(found)})


def _values(each: Largest) -> dict[str, Any]:
    return keyed(each, unit="" if each.unit == "-" else each.unit)


def _check_fact(dwell: Dwell) -> Fact:
    """The method of the relative trajectory."""
    found = dwell.cross_check
    if found is None:
        return Fact("relative trajectory", f"does not apply: {dwell.unchecked}", {"relative_trajectory": None})
    text = (
        f"{found.steps} steps of the arc: S off by {number(100 * found.uniform, 3)} % of the stroke with equal steps, "
        f"{number(100 * found.cosine, 3)} % with cosine spacing"
    )
    return Fact("relative trajectory", text, {"relative_trajectory": keyed(found)})


def _at(each: Largest, text: str) -> str:
    return f"{text} at {angle(ANGLE * each.at)} deg"


def _amount(value: float, unit: str) -> str:
    """A value for people: mm, deg, N."""
    if unit == "rad":
        return f"{number(ANGLE * value, 6)} deg"
    return f"{number(1e3 * value, 6)} mm" if unit == "m" else f"{number(value, 6)} {unit}".removesuffix(" -")


def dwell_table(dwell: Dwell, patterns: Sequence[str], everything: bool) -> View:
    """The positions; ``patterns`` choose columns by name, else the usual ones or ``everything``."""
    available = columns_of(dwell.motion, dwell.output)
    if patterns:
        chosen = select(available, patterns)
    else:
        chosen = available if everything else [column for column in available if column.name in USUAL]
        chosen = chosen if everything else sorted(chosen, key=lambda column: USUAL.index(column.name))
    headers, columns = ["i"], [list(dwell.motion.labels)]
    for column in chosen:
        values = column.make()
        if not everything and column.unit == "m":
            header, factor = column.shown("mm")
            headers.append(header)
            columns.append((factor * values).tolist())
        else:
            headers.append(column.header)
            columns.append(values.tolist())
    return View(headers, columns)
