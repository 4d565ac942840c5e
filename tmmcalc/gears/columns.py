"""The columns of tooth sets: wheels, proportion of modules, ratio and its error, and what the constraints look at.

Tables of several layouts stand one under the other: what a layout has not is blank in its rows.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from tmmcalc.core.columns import degrees
from tmmcalc.core.quantity import Quantity, components
from tmmcalc.gears.model import ToothSets, TrainTask, Values
from tmmcalc.gears.search import measures
from tmmcalc.gears.trains import Request, Trains, Variant

NO, YES = "no", "yes"
FIRST = ("i", "layout", "K")  # headers that come first, before the wheels in their order
WHEEL = "z_"
PLANETS = Quantity("planets", "number of planets or layshafts")
RATIOS = (  # by their kind, which is the name of the column
    Quantity("u", "ratio of the numbers of teeth of the train"),
    Quantity("i_{ratio}", "ratio of angular velocities, of the first member of the index over the second"),
)
ERROR = Quantity("error[%]", "deviation of the ratio from the one asked for")
COPRIME = Quantity("coprime", "whether no two wheels in mesh have a common factor")
TEXTBOOK = Quantity("textbook", "whether the textbook's stepping finds the set")
DISTANCE = Quantity("a_12[m]", "centre distance of the wheels 1 and 2")
DIAMETER = Quantity("D[m]", "diameter around the pitch circles")
GAP = Quantity("gap[module]", "gap between the tips of neighbouring planets")
ANGLE = Quantity("alpha_max[deg]", "largest operating pressure angle")
STEP = Quantity("e", "Z1 + Z2 = e m_2, m_1 and m_2 in lowest terms")
ASSEMBLY = Quantity("assembly", "the whole number of the assembly condition", source="(4.25), (4.26)")


def set_columns(variant: Variant) -> dict[str, np.ndarray]:
    """Every column of the sets of a variant by its header, in the order of a reader's interest."""
    request, sets = variant.request, variant.sets
    task = request.task
    columns: dict[str, np.ndarray] = components(sets, "teeth", wheel=sets.scheme.wheels)
    if sets.scheme.branched and sets.scheme.stages > 1:
        columns |= components(sets, "modules", stage=range(1, sets.scheme.stages + 1))
    ratio, error = ratios(request, sets)
    columns |= {request.kind: ratio, ERROR.key: 100 * error, COPRIME.key: measures.coprime_meshes(sets)}
    if variant.textbook is not None and request.method == "complete":
        columns[TEXTBOOK.key] = variant.textbook
    columns |= dict(_of_branches(task, sets))
    if task.module is not None and len(sets):
        columns[DISTANCE.key] = measures.distance(task, sets)
        if sets.scheme.branched:
            columns[DIAMETER.key] = measures.diameter(task, sets)
    return columns


def ratios(request: Request, sets: ToothSets) -> tuple[Values, Values]:
    """The ratio of its kind and its relative deviation, each rounded once where integers of 64 bits hold it.

    A carrier that drives is without limit where it stands still itself: such sets are outside every tolerance.
    """
    numerator, denominator = measures.tooth_ratio(sets)
    if request.kind in ("i_1H", "i_H1"):
        numerator = denominator + request.scheme.sign * numerator
    if request.kind == "i_H1":
        numerator, denominator = denominator, numerator
    p, q = request.nominal.numerator, request.nominal.denominator
    largest = max(int(abs(part).max(initial=1)) for part in (numerator, denominator))
    if max(abs(p), q) * largest < 2**62:
        return numerator / denominator, (numerator * q - p * denominator) / (p * denominator)
    pairs = zip(numerator.tolist(), denominator.tolist(), strict=True)
    return numerator / denominator, np.array([(n * q - p * d) / (p * d) for n, d in pairs])


def _of_branches(task: TrainTask, sets: ToothSets) -> Iterator[tuple[str, np.ndarray]]:
    """What planets and a common axis ask for."""
    if not sets.scheme.branched:
        return
    if sets.planets > 2 and task.demands.gap is not None:
        yield GAP.key, measures.tip_gap(task, sets)
    if task.demands.largest_angle is not None:
        yield ANGLE.key, degrees(sets.angles.max(axis=1))
    elif sets.scheme.stepped:
        yield STEP.key, (sets.of("1") + sets.of("2")) // sets.modules[:, 1]
    if sets.planets > 1:
        number = measures.assembly_number(sets)
        yield ASSEMBLY.key, number.astype(np.int64) if task.demands.assembly else number


def said(columns: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    """The columns with words in place of true and false."""
    return {header: np.where(c, YES, NO) if c.dtype == np.bool_ else c for header, c in columns.items()}


def stacked(trains: Trains, *, words: bool = True) -> dict[str, np.ndarray]:
    """The columns of all variants, one after the other; what a layout has not is blank in its rows.

    With ``words`` it is yes and no, as in a file for people, else true and false.
    """
    tables = [{**_named(variant), **set_columns(variant)} for variant in trains.variants if len(variant.sets)]
    tables = [said(table) for table in tables] if words else tables
    return stacked_tables(tables, lambda header: not header.startswith(("layout", "planets", WHEEL)))


def _named(variant: Variant) -> dict[str, np.ndarray]:
    count = len(variant.sets)
    return {"layout": np.full(count, variant.request.task.layout), PLANETS.key: np.full(count, variant.sets.planets)}


def by_wheels(header: str) -> tuple[int, str]:
    """Wheels by their names, which are in their order: 1, 2, 2', 3; everything else as it comes."""
    return (1, header) if header.startswith(WHEEL) else (0 if header in FIRST else 2, "")


def stacked_tables(
    tables: Sequence[Mapping[str, np.ndarray]], order: Callable[[str], Any] = by_wheels
) -> dict[str, np.ndarray]:
    """The columns of all tables by their headers; one that a table lacks is text, of true and false it stays so.

    >>> both = stacked_tables([{"K": np.array([3]), "z_1": np.array([17])}, {"K": np.array([4])}])
    >>> both["K"].tolist(), both["z_1"].tolist()
    ([3, 4], ['17', ''])
    """
    headers = dict.fromkeys(header for table in tables for header in table)
    return {header: _stacked_column(header, tables) for header in sorted(headers, key=order)}


def _stacked_column(header: str, tables: Sequence[Mapping[str, np.ndarray]]) -> np.ndarray:
    there = [table[header] for table in tables if header in table]
    if len(there) == len(tables):
        return np.concatenate(there)
    parts = [table.get(header, np.full(len(next(iter(table.values()))), "")) for table in tables]
    if any(part.dtype == np.bool_ for part in there):
        return np.concatenate([part.astype(object) for part in parts])
    return np.concatenate([np.array([*map(str, part.tolist())], dtype=np.str_) for part in parts])
