"""How far apart the results of two equivalent scenes are: the columns of a stage's table, or its facts.

A difference is told relative to the largest magnitude of the same unit in the stage, because a coordinate that is zero
but for rounding has no digits of its own; where all of a unit are zero, to what it is made from. Angles are compared
but for whole turns. What only one of the scenes tells, and a zero that nothing gives a size, is named and left out.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from tmmcalc.core.facts import facts
from tmmcalc.core.records import record
from tmmcalc.core.stored import Table
from tmmcalc.pipeline.outcome import RunResult
from tmmcalc.stress.stages import between, in_millimetres
from tmmcalc.stress.units import Factors

Values = Any  # array of numbers (n,)
Quantities = dict[str, tuple[Values, str]]  # by name: values (n,) and their unit

TURN = 360.0
PLAIN = re.compile(r"\d+")  # label of a position of the grid
INDEX = ("i", "phase", "motion")  # columns that say which row it is
# what is found by a rule of thumb on the grid, counts, places of extremes (flat: half of the digits) and arms there,
# and estimates
SKIPPED = re.compile(
    r"_at_|_at$|error|counters|Simpson|textbook|_off$|steps|residual|evaluations|lumped|lumping|_given$|(^|_)rim_|power_balance|turns$|_dphi_"
    r"|^equilibrium$|^virtual$|^h_(?!T$|t_)|^(S0|r2|l)_least$"
)
OF_POINTS = ("paths",)  # rows are those of wanted points, whatever the positions are
BY_FACTS = ("vibrator", "pendulum", "transient")  # rows of forms without a size, of instants chosen by the steps
COUNTED = ("structure", "train")  # whole numbers, which have no digits to lose
FROM_START = re.compile(r"phi$|t$|S_")  # what is counted from position 0


@record
class Alignment:
    """What one scene is to another: its units, whether it is mirrored, and which position answers to which."""

    factors: Factors = Factors()
    twin: bool = False  # whether the other scene is made from the rung; else the rung is made from the other scene
    mirrored: bool = False
    label: Callable[[int, int], int] | None = None  # (position, count) -> position of the other scene; None: the same
    shifted: bool = False  # whether position 0 lies elsewhere: what is counted from it differs


@record
class Difference:
    """How far apart two scenes are in a stage."""

    size: float | None = None  # the largest, relative; None: nothing to compare
    quantity: str = ""  # of which it is the largest
    skipped: tuple[str, ...] = ()  # what could not be compared, each with the reason


@record
class Apart:
    """A quantity of both scenes, in the units of the first."""

    name: str
    kind: str  # its unit, or, of a pure number, its name
    size: float  # largest magnitude in the first scene, over the cycle where that is known
    gap: float  # largest difference


SAME = Alignment()


def difference(stage: str, one: RunResult, two: RunResult, alignment: Alignment = SAME) -> Difference:
    """The largest relative difference of a stage's results, ``two`` against ``one``."""
    if stage in COUNTED:
        return Difference()
    bound = in_millimetres(stage, one, two) if alignment.factors.length != 1 else ""
    if bound:
        return Difference(skipped=(f"all ({bound})",))
    if stage in OF_POINTS:
        alignment = replace(alignment, label=None)
    tables = None if stage in BY_FACTS else _tables(one.table(stage), two.table(stage), alignment)
    found = tables
    if found is None and alignment.label is None:
        found = _facts(stage, one), _facts(stage, two)
    if found is None:
        return Difference()
    ratios, unlike = _ratios(list(_differences(*found, alignment, between(stage, one))), _reach(one))
    skipped = [*_lengths(stage, one, two, tables is None), *_on_one_side(*found), *unlike]
    size, quantity = max(ratios, default=(None, ""))
    return Difference(size, quantity, tuple(skipped))


def _lengths(stage: str, one: RunResult, two: RunResult, uncompared: bool) -> list[str]:
    """Tables of other lengths, whose rows are not of the same places."""
    if stage in BY_FACTS or not uncompared:
        return []
    rows = [0 if table is None else table.rows for table in (one.table(stage), two.table(stage))]
    return [f"table ({rows[0]} rows beside {rows[1]})"] if rows[0] != rows[1] else []


def _on_one_side(one: Quantities, two: Quantities) -> list[str]:
    return [f"{name} (in one scene only)" for name in {**one, **two} if (name in one) != (name in two)]


def _ratios(apart: list[Apart], reach: float) -> tuple[list[tuple[float, str]], list[str]]:
    """Relative differences of quantities by name, and those that are zero in one scene without a size to compare."""
    sizes = _sizes(apart, reach)
    ratios = [(each.gap / (sizes[each.kind] or 1.0), each.name) for each in apart if sizes[each.kind] or not each.gap]
    unlike = [
        f"{each.name} (zero beside {each.gap:.1e} {each.kind})" for each in apart if each.gap and not sizes[each.kind]
    ]
    return ratios, unlike


def _sizes(apart: list[Apart], reach: float) -> dict[str, float]:
    """What differences of each kind are relative to: the largest magnitude, of zeros what they are made from."""
    sizes: dict[str, float] = {}
    for each in apart:
        sizes[each.kind] = max(sizes.get(each.kind, 0.0), each.size)
    if "N" in sizes and "N*m" in sizes:  # a moment that is zero but for rounding is small beside forces times arms
        sizes["N*m"] = max(sizes["N*m"], sizes["N"] * reach)
    natural = {each.name: 1.0 for each in apart} | {"deg": TURN, "m": reach}  # a pure number is a kind by itself
    return {kind: size or natural.get(kind, 0.0) for kind, size in sizes.items()}


def _reach(run: RunResult) -> float:
    """Largest coordinate of the linkage [m]; 0 without one."""
    if "kinematics" not in run.outcomes:
        return 0.0
    return float(np.max(np.abs(run.results["kinematics"].trace.r), initial=0.0))


def _differences(
    one: Quantities, two: Quantities, alignment: Alignment, largest: Mapping[str, float]
) -> Iterator[Apart]:
    """Of every quantity that both have; ``largest`` are magnitudes that are known of more than these values."""
    for name, (a, unit) in one.items():
        if name not in two or (alignment.shifted and FROM_START.match(name)):
            continue
        b = two[name][0] / alignment.factors.of(unit)
        kind = unit if unit not in ("", "-") else name
        size, gap = (
            np.max(np.abs(a), initial=largest.get(name, 0.0)),
            np.max(_difference_of(a, b, unit, alignment.mirrored), initial=0.0),
        )
        yield Apart(name, kind, float(size), float(gap))


def _difference_of(a: Values, b: Values, unit: str, mirrored: bool) -> Values:
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
