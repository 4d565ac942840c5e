"""The picture of the train stage: a set of every variant to scale, all sets and what was removed, curves of choice."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

import numpy as np
from matplotlib.figure import Figure

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.columns import ratios
from tmmcalc.gears.kinds import from_tooth_ratio
from tmmcalc.gears.model import Values
from tmmcalc.gears.pictures.criteria import check_row
from tmmcalc.gears.pictures.graphs import graphs_of, graphs_sheet
from tmmcalc.gears.pictures.placed import PlacedTrain, placed
from tmmcalc.gears.pictures.scheme import scheme_sheet
from tmmcalc.gears.pictures.solutions import solutions_sheet
from tmmcalc.gears.pictures.words import layout_name, ratio_text, teeth_text
from tmmcalc.gears.search.measures import tooth_ratio
from tmmcalc.gears.selection.results import Selection
from tmmcalc.gears.trains import Trains, Variant
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.numbers import number


def figure(order: Order) -> Figure:
    """The figure of the stage, with the set that is chosen."""
    result, selection = order.results["train"], order.results.get("criteria")
    if selection is not None:
        place = selection.winner.place if order.choice is None else order.choice - 1
        told = f"row {place + 1} of {len(selection.pool)} trains compared, "
        return train_figure(result, chosen_rows(result, selection, order.choice), told)
    return train_figure(result, numbered_rows(result, 1 if order.choice is None else order.choice))


def numbered_rows(result: Trains, choose: int) -> list[int | None]:
    """The row of set ``choose`` of each variant, from 1; None: it has fewer. Raises `UsageError` if all have."""
    most = max(len(variant.sets) for variant in result.variants)
    if not 1 <= choose <= most:
        raise UsageError(
            f"there is no tooth set {choose}", where="plot", value=choose, limit=most, remedy=f"1 to {most}"
        )
    return [choose - 1 if choose <= len(variant.sets) else None for variant in result.variants]


def chosen_rows(result: Trains, selection: Selection, choose: int | None = None) -> list[int | None]:
    """The row of the train that is chosen, or of row ``choose`` of the trains compared, from 1; None: not of a variant.

    Raises `UsageError` for a row that there is not.
    """
    place, pool = selection.winner.place if choose is None else choose - 1, selection.pool
    check_row(place, len(pool))
    at, row = int(pool.variant[place]), int(pool.row[place])
    own, sets = selection.variants[at].sets, result.variants[at].sets
    same = (sets.teeth == own.teeth[row]).all(axis=1) & (sets.modules == own.modules[row]).all(axis=1)
    found = int(np.flatnonzero(same)[0])
    return [found if k == at else None for k in range(len(result.variants))]


def train_figure(result: Trains, rows: Sequence[int | None], told: str = "") -> Figure:
    """Two sheets a variant, of which ``rows`` names the set that is drawn, one where it names none; one of curves.

    ``told`` is said of the set before its number among all.
    """
    panels = graphs_of(result.variants)
    figure, sheets = blank(sum(row is not None for row in rows) + len(result.variants) + bool(panels))
    places, finish = iter(sheets), list[Callable[[], None]]()
    for variant, row in zip(result.variants, rows, strict=True):
        if row is not None:
            finish.append(scheme_sheet(next(places), _to_scale(variant, row), _heading(variant, row, told)))
        finish.append(solutions_sheet(next(places), variant, row))
    if panels:
        finish.append(graphs_sheet(next(places), panels))
    settle(figure)
    for draw in finish:
        draw()
    return figure


def _to_scale(variant: Variant, row: int) -> PlacedTrain:
    task = variant.request.task
    parts = variant.sets.modules[row]
    module: Values | None = None if task.module is None or not parts.all() else task.module * parts / parts[0]
    driver = "H" if variant.request.kind == "i_H1" else "1"
    return placed(variant.sets, row, module, rack=task.pressure_angle, addendum=float(task.addendum), driver=driver)


def _heading(variant: Variant, row: int, told: str) -> str:
    """Layout, ratio of the set, its teeth and error."""
    request, sets = variant.request, variant.sets
    top, bottom = tooth_ratio(sets)
    ratio = from_tooth_ratio(request.scheme, request.kind, Fraction(int(top[row]), int(bottom[row])))
    error = 100 * float(ratios(request, sets)[1][row])
    said = "" if ratio is None else f": {ratio_text(request.kind, ratio)}"
    first = f"{layout_name(request.scheme, sets.planets)}{said}"
    asked = f"error {signed(error, 3)} % of {number(float(request.nominal), 8)}"
    named = f"{told}set {row + 1} of {variant.synthesis.count}"
    return f"{first}\n$z$ = {teeth_text(sets.teeth[row].tolist())}, {asked}; {named}"
