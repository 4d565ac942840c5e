"""The picture of the criteria stage: the Pareto diagram, all pairs of criteria, the chosen train to scale."""

from __future__ import annotations

import numpy as np

from tmmcalc.gears.pictures.front import pairs_of, pairs_sheet, pareto_sheet
from tmmcalc.gears.pictures.placed import placed
from tmmcalc.gears.pictures.scheme import scheme_sheet
from tmmcalc.gears.pictures.words import CRITERIA, layout_name, layout_word, ratio_text, short_name, teeth_text
from tmmcalc.gears.selection.results import Pool, Selection
from tmmcalc.gears.selection.solve import speed_ratio
from tmmcalc.gears.sizing import rows_of
from tmmcalc.gears.trains import Trains
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number
from tmmcalc.report.rows import check_choice

USUAL = 3  # objectives that the first diagram shows together: mass, inertia, size


def figure(order: Order) -> Drawing:
    """The drawing of the stage, with the train that is chosen."""
    return criteria_drawing(order.results["criteria"], order.results["train"], order.choice)


def criteria_drawing(result: Selection, trains: Trains, choose: int | None = None) -> Drawing:
    """The winner's sheets, or those of row ``choose`` of the stage's table, from 1.

    Raises `UsageError` for a row that there is not.
    """
    place = result.winner.place if choose is None else choose - 1
    check_choice(place + 1, len(result.pool), "row")
    more = len(result.objectives) > USUAL or bool(set(result.objectives) - {"mass", "inertia", "size"})
    pairs = pairs_of(result) if more and len(result.objectives) > 1 else []
    drawing, (first, *others, last) = sheets(2 + len(pairs), tr("Choice of the gear train"))
    pareto_sheet(drawing, first, result, place, _heading(result, place))
    for box, part in zip(others, pairs, strict=True):
        pairs_sheet(drawing, box, result, part, place)
    _scheme(drawing, last, result, trains, place)
    return drawing


def _heading(result: Selection, place: int) -> str:
    """How many trains there are, and by what the one that is drawn was chosen."""
    reason = result.reason
    first = tr(
        "Trains strong enough: {count}; on the Pareto front: {front}", count=len(result.pool), front=len(result.front)
    )
    name = f"{layout_word(result.winner.layout)} {teeth_text(result.winner.teeth)}"
    winner = result.winner.place + 1
    if place != result.winner.place:
        said = tr("row {row} is drawn; chosen is row {chosen}, {name}", row=place + 1, chosen=winner, name=name)
        return f"{first}\n{said}"
    if reason.criterion not in CRITERIA:
        said = tr("chosen by {criterion}: {name}", criterion=reason.criterion, name=name)
        return f"{first}\n{said}"
    factor, unit = CRITERIA[reason.criterion]
    best = {"criterion": short_name(reason.criterion), "name": name}
    best["value"] = f"{number(factor * reason.value, 4)} {tr_unit(unit)}".strip()
    if reason.runner_up_value is None:
        said = tr("chosen by the best {criterion}: {name}, {value}", **best)
        return f"{first}\n{said}"
    other = f"{number(factor * reason.runner_up_value, 4)} {tr_unit(unit)}".strip()
    said = tr("chosen by the best {criterion}: {name}, {value}; the next best has {other}", **best, other=other)
    return f"{first}\n{said}"


def _scheme(drawing: Drawing, box: Box, result: Selection, trains: Trains, place: int) -> None:
    """The train of a row with its modules and widths."""
    pool = result.pool
    at, row = int(pool.variant[place]), int(pool.row[place])
    variant, request = result.variants[at], trains.variants[at].request
    task = request.task
    train = placed(
        variant.sets,
        row,
        variant.module[row],
        variant.width[row],
        rack=task.pressure_angle,
        addendum=float(task.addendum),
        driver="H" if request.kind == "i_H1" else "1",
    )
    ratio = speed_ratio(rows_of(variant.sets, np.array([row])), request.kind)
    kind = request.kind if request.scheme.sign and request.kind != "u" else "i"
    name = layout_name(request.scheme, variant.sets.planets)
    teeth = teeth_text(variant.sets.teeth[row].tolist())
    measured = ", ".join(_measured(pool, key, place) for key in ("mass", "inertia", "size", "efficiency", "error"))
    heading = f"{name}: {ratio_text(kind, ratio)}, $z$ = {teeth}\n{measured}"
    scheme_sheet(drawing, box, train, heading)


def _measured(pool: Pool, key: str, place: int) -> str:
    symbols = {"mass": "$M$", "inertia": "$J$", "size": "$D$", "efficiency": "$η$", "error": tr("error of the ratio")}
    factor, unit = CRITERIA[key]
    return f"{symbols[key]} = {number(factor * float(getattr(pool, key)[place]), 4)} {tr_unit(unit)}".strip()
