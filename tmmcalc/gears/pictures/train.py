"""The picture of the train stage: a set of every variant to scale, all sets and what was removed, curves of choice."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.gears.chosen.choice import numbered_set
from tmmcalc.gears.chosen.motion import moving
from tmmcalc.gears.columns import ratios
from tmmcalc.gears.details import speed_of_driver
from tmmcalc.gears.kinds import from_tooth_ratio
from tmmcalc.gears.model import Values
from tmmcalc.gears.pictures.graphs import graphs_of
from tmmcalc.gears.pictures.motionplans import draw_motion
from tmmcalc.gears.pictures.placed import PlacedTrain, placed
from tmmcalc.gears.pictures.scheme import scheme_sheet
from tmmcalc.gears.pictures.solutions import solutions_panel
from tmmcalc.gears.pictures.words import layout_name, ratio_text, teeth_text
from tmmcalc.gears.search.measures import tooth_ratio
from tmmcalc.gears.selection.results import Selection
from tmmcalc.gears.trains import Trains, Variant
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import headed, sheets
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr
from tmmcalc.report.numbers import number
from tmmcalc.report.rows import check_choice

ROWS = 2  # strips of diagrams that share a sheet
COLUMNS = 3  # diagrams that stand side by side at most
Strip = Sequence[Callable[[Drawing, Box], object]]  # what stands side by side


def figure(order: Order) -> Drawing:
    """The drawing of the stage, with the set that is chosen."""
    result, selection = order.results["train"], order.results.get("criteria")
    speed = speed_of_driver(order.spec, order.results)
    if selection is not None:
        place = selection.winner.place if order.choice is None else order.choice - 1
        check_choice(place + 1, len(selection.pool), "row")
        told = tr("row {row} of {count} trains compared, ", row=place + 1, count=len(selection.pool))
        at, row = int(selection.pool.variant[place]), int(selection.pool.row[place])
        modules = tuple(selection.variants[at].module[row].tolist())
        return train_drawing(result, chosen_rows(result, selection, order.choice), told, speed, modules)
    return train_drawing(result, numbered_rows(result, 1 if order.choice is None else order.choice), speed=speed)


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
    check_choice(place + 1, len(pool), "row")
    at, row = int(pool.variant[place]), int(pool.row[place])
    own, sets = selection.variants[at].sets, result.variants[at].sets
    same = (sets.teeth == own.teeth[row]).all(axis=1) & (sets.modules == own.modules[row]).all(axis=1)
    found = int(np.flatnonzero(same)[0])
    return [found if k == at else None for k in range(len(result.variants))]


def train_drawing(
    result: Trains,
    rows: Sequence[int | None],
    told: str = "",
    speed: float | None = None,
    modules: tuple[float, ...] = (),
) -> Drawing:
    """Two sheets for the set of every variant that ``rows`` names: its scheme from two sides, and its plans.

    Then sets, removals and curves, two strips a sheet. ``told`` is said of the set before its number among all;
    ``speed`` is that of what drives [rad/s], 1 rad/s where it is not known; ``modules`` are those of the stages [m]
    that criteria found.
    """
    schemes = [(variant, row) for variant, row in zip(result.variants, rows, strict=True) if row is not None]
    strips = _strips(result, rows)
    drawing, boxes = sheets(2 * len(schemes) + -(-len(strips) // ROWS), tr("Synthesis of the gear train"))
    for (variant, row), first, second in zip(schemes, boxes[::2], boxes[1::2], strict=False):
        head = _heading(variant, row, told)
        scheme_sheet(drawing, first, _to_scale(variant, row, modules), head)
        found = numbered_set(variant, row + 1)
        found = replace(found, modules=modules) if modules else found
        draw_motion(drawing, headed(drawing, second, head), moving(found, speed))
    for k, box in enumerate(boxes[2 * len(schemes) :]):
        here = strips[ROWS * k : ROWS * (k + 1)]
        for strip, part in zip(here, box.split(*(1.0 for _ in here), gap=5), strict=True):
            for draw, place in zip(strip, part.split(*(1.0 for _ in strip), gap=6, across=True), strict=True):
                draw(drawing, place)
    return drawing


def _strips(result: Trains, rows: Sequence[int | None]) -> list[Strip]:
    """One of every variant with sets, those without share theirs, then the curves of choice."""
    found: list[Strip] = []
    empty = []
    for variant, row in zip(result.variants, rows, strict=True):
        panel = partial(solutions_panel, variant=variant, row=row)
        if len(variant.sets):
            found.append([panel])
        else:
            empty.append(panel)
    panels = graphs_of(result.variants)
    for each, columns in ((empty, COLUMNS - 1), (panels, ROWS if len(panels) == ROWS**2 else COLUMNS)):
        found += [each[k : k + columns] for k in range(0, len(each), columns)]
    return found


def _to_scale(variant: Variant, row: int, modules: tuple[float, ...]) -> PlacedTrain:
    task = variant.request.task
    parts = variant.sets.modules[row]
    module: Values | None = None if task.module is None or not parts.all() else task.module * parts / parts[0]
    module = np.array(modules) if modules else module
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
    second = tr(
        "$z$ = {teeth}, error {error} % of {ratio}; {told}set {row} of {count}",
        teeth=teeth_text(sets.teeth[row].tolist()),
        error=minus(number(error, 3)),
        ratio=minus(number(float(request.nominal), 8)),
        told=told,
        row=row + 1,
        count=variant.synthesis.count,
    )
    return f"{first}\n{second}"
