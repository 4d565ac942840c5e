"""How far apart the results of two equivalent scenes are: the columns of a stage's table, or its facts.

A difference is told relative to the largest magnitude of the same unit in the stage, because a coordinate that is zero
but for rounding has no digits of its own. Angles are compared but for whole turns.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np

from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.pipeline.stage import Table
from tmmcalc.records import record
from tmmcalc.stages.feasibility import facts
from tmmcalc.stress.units import Factors

Values = Any  # array of numbers (n,)
Quantities = dict[str, tuple[Values, str]]  # by name: values (n,) and their unit

TURN = 360.0
PLAIN = re.compile(r"\d+")  # label of a position of the grid
INDEX = ("i", "phase", "motion")  # columns that say which row it is
# what is found by a rule of thumb on the grid, counts, places of extremes (flat: half of the digits), and estimates
SKIPPED = re.compile(
    r"_at_|_at$|error|counters|Simpson|textbook|_off$|steps|residual|evaluations|lumped|_given$|(^|_)rim_|power_balance|turns$"
    r"|^equilibrium$|^virtual$"
)
BY_FACTS = ("vibrator", "pendulum", "transient")  # rows of forms without a size, of instants chosen by the steps
COUNTED = ("structure", "train")  # whole numbers, which have no digits to lose
FROM_START = re.compile(r"phi$|t$|S_")  # what is counted from position 0


@record
class Alignment:
    """What one scene is to another: its units, whether it is mirrored, and which position answers to which."""

    factors: Factors = Factors()
    mirrored: bool = False
    label: Callable[[int, int], int] | None = None  # (position, count) -> position of the other scene; None: the same
    shifted: bool = False  # whether position 0 lies elsewhere: what is counted from it differs


SAME = Alignment()


def difference(stage: str, one: RunResult, two: RunResult, alignment: Alignment = SAME) -> tuple[float, str] | None:
    """The largest relative difference of a stage's results, ``two`` against ``one``, and of which quantity.

    None: there is nothing to compare.
    """
    if stage in COUNTED:
        return None
    found = None
    if stage not in BY_FACTS:
        found = _tables(one.table(stage), two.table(stage), alignment)
    if found is None and alignment.label is None:
        found = _facts(stage, one), _facts(stage, two)
    if found is None:
        return None
    apart = list(_differences(*found, alignment))
    sizes: dict[str, float] = {}
    for _, kind, size, _ in apart:
        sizes[kind] = max(sizes.get(kind, 0.0), size)
    if "N" in sizes and "N*m" in sizes:  # a moment that is zero but for rounding is small beside forces times arms
        sizes["N*m"] = max(sizes["N*m"], sizes["N"] * _reach(one))
    ratios = [(gap / sizes[kind] if sizes[kind] else gap, name) for name, kind, _, gap in apart]
    return max(ratios, default=None)


def _reach(run: RunResult) -> float:
    """Largest coordinate of the linkage [m]; 0 without one."""
    if "kinematics" not in run.outcomes:
        return 0.0
    return float(np.max(np.abs(run.results["kinematics"].trace.r), initial=0.0))


def _differences(one: Quantities, two: Quantities, alignment: Alignment) -> Iterator[tuple[str, str, float, float]]:
    """Of every quantity its name, its kind (that of its unit, or its own), its largest magnitude, its difference."""
    for name, (a, unit) in one.items():
        if name not in two or (alignment.shifted and FROM_START.match(name)):
            continue
        b = two[name][0] / alignment.factors.of(unit)
        if a.shape == b.shape:
            kind = unit if unit not in ("", "-") else name
            size, gap = np.max(np.abs(a), initial=0.0), np.max(_apart(a, b, unit, alignment.mirrored), initial=0.0)
            yield name, kind, float(size), float(gap)


def _apart(a: Values, b: Values, unit: str, mirrored: bool) -> Values:
    """Differences; in a mirror a quantity is the same but for its sign, a direction of an axis also for half a turn."""
    gap = _gap(a, b, unit)
    if not mirrored:
        return gap
    others = [-b, TURN / 2 - b] if unit == "deg" else [-b]
    return min((gap, *(_gap(a, other, unit) for other in others)), key=lambda each: np.max(each, initial=0.0))


def _gap(a: Values, b: Values, unit: str) -> Values:
    gap = np.abs(a - b)
    return np.abs(gap - TURN * np.round(gap / TURN)) if unit == "deg" else gap


def _tables(one: Table | None, two: Table | None, alignment: Alignment) -> tuple[Quantities, Quantities] | None:
    if one is None or two is None or not one.rows or not two.rows:
        return None
    rows = _rows(one, two, alignment)
    return None if rows is None else (_columns(one, rows[0]), _columns(two, rows[1]))


def _rows(one: Table, two: Table, alignment: Alignment) -> tuple[Values, Values] | None:
    """Rows of the two tables that are of the same position."""
    if alignment.label is None:
        return (np.arange(one.rows), np.arange(two.rows)) if one.rows == two.rows else None
    if one.header[0] != "i":
        return None
    here = _labels(one)
    count = max(here)
    labels = np.asarray(two.columns[0])
    pairs = [(row, _row(labels, alignment.label(label, count))) for label, row in here.items() if label < count]
    met = [(row, other) for row, other in pairs if other is not None]
    return (np.array([row for row, _ in met]), np.array([other for _, other in met])) if met else None


def _row(labels: Values, label: int) -> int | None:
    """The row of a position, None if there is none."""
    rows = np.flatnonzero(labels == (label if labels.dtype.kind in "iu" else str(label)))
    return int(rows[0]) if rows.size else None


def _labels(table: Table) -> dict[int, int]:
    """Rows of the positions of the grid by their number."""
    labels = np.asarray(table.columns[0])
    if labels.dtype.kind in "iu":
        return {int(label): row for row, label in enumerate(labels)}
    return {int(label): row for row, label in enumerate(labels.tolist()) if PLAIN.fullmatch(str(label))}


def _columns(table: Table, rows: Values) -> Quantities:
    found = {}
    for header, column in zip(table.header, table.columns, strict=True):
        name, _, unit = header.partition("[")
        values = np.asarray(column)
        if values.dtype.kind == "f" and name not in INDEX and not SKIPPED.search(name):
            found[name] = values[rows], unit.rstrip("]")
    return found


def _facts(stage: str, run: RunResult) -> Quantities:
    told = facts(stage, run.results[stage])
    return {name: (np.array([value]), unit) for name, (value, unit) in told if not SKIPPED.search(name)}


def not_finite(run: RunResult, stage: str) -> Iterator[str]:
    """Places in the record and the table of a stage that hold no finite number."""
    record_, table = run.record(stage), run.table(stage)
    for part in (record_.scalars, record_.error):
        yield from (f"{stage}{place}" for place, value in _numbers(part) if not np.isfinite(value))
    columns = dict(zip(table.header, table.columns, strict=True)) if table is not None else {}
    for place, array in {**record_.arrays, **columns}.items():
        if np.asarray(array).dtype.kind in "fc" and not np.all(np.isfinite(array)):
            yield f"{stage}.{place}"


def _numbers(value: Any, place: str = "") -> Iterator[tuple[str, float]]:
    if isinstance(value, Mapping):
        for key, part in value.items():
            yield from _numbers(part, f"{place}.{key}")
    elif isinstance(value, list | tuple):
        for index, part in enumerate(value):
            yield from _numbers(part, f"{place}.{index}")
    elif isinstance(value, float):
        yield place, value
