"""The picture of the train stage: a set of every variant to scale, all sets and what was removed, curves of choice."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from matplotlib.figure import Figure

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.columns import ratios
from tmmcalc.gears.kinds import from_tooth_ratio
from tmmcalc.gears.model import Values
from tmmcalc.gears.pictures.graphs import graphs_of, graphs_sheet
from tmmcalc.gears.pictures.placed import PlacedTrain, placed
from tmmcalc.gears.pictures.scheme import scheme_sheet
from tmmcalc.gears.pictures.solutions import solutions_sheet
from tmmcalc.gears.pictures.words import layout_name, ratio_text, teeth_text
from tmmcalc.gears.search.measures import tooth_ratio
from tmmcalc.gears.trains import Trains, Variant
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.numbers import number


def figure(order: Order) -> Figure:
    """The figure of the stage, with the set that is chosen."""
    return train_figure(order.results["train"], 1 if order.choice is None else order.choice)


def train_figure(result: Trains, choose: int) -> Figure:
    """Two sheets a variant and one of curves; ``choose`` is the number of the set in each variant, from 1.

    Raises `UsageError` if no variant has such a set.
    """
    most = max(len(variant.sets) for variant in result.variants)
    if not 1 <= choose <= most:
        raise UsageError(
            f"there is no tooth set {choose}", where="plot", value=choose, limit=most, remedy=f"1 to {most}"
        )
    row = choose - 1
    panels = graphs_of(result.variants)
    shown = [variant for variant in result.variants if row < len(variant.sets)]
    figure, sheets = blank(len(shown) + len(result.variants) + bool(panels))
    places, finish = iter(sheets), list[Callable[[], None]]()
    for variant in result.variants:
        has = row < len(variant.sets)
        if has:
            finish.append(scheme_sheet(next(places), _to_scale(variant, row), _heading(variant, row)))
        finish.append(solutions_sheet(next(places), variant, row if has else None))
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


def _heading(variant: Variant, row: int) -> str:
    """Layout, ratio of the set, its teeth and error."""
    request, sets = variant.request, variant.sets
    top, bottom = tooth_ratio(sets)
    ratio = from_tooth_ratio(request.scheme, request.kind, Fraction(int(top[row]), int(bottom[row])))
    error = 100 * float(ratios(request, sets)[1][row])
    said = "" if ratio is None else f": {ratio_text(request.kind, ratio)}"
    first = f"{layout_name(request.scheme, sets.planets)}{said}"
    asked = f"error {signed(error, 3)} % of {number(float(request.nominal), 8)}"
    return f"{first}\n$z$ = {teeth_text(sets.teeth[row].tolist())}, {asked}; set {row + 1} of {variant.synthesis.count}"
