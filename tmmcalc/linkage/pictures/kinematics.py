"""The picture of the kinematics stage: scheme and diagrams; the vector polygons on a second sheet below."""

from __future__ import annotations

import math
from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure

from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.pictures.choice import check_positions, chosen
from tmmcalc.linkage.pictures.cycle import LinkageMotion, whole_cycle
from tmmcalc.linkage.pictures.diagrams import columns_of, draw_diagrams, label_diagrams
from tmmcalc.linkage.pictures.scheme import draw_scheme, prepare
from tmmcalc.linkage.pictures.vectors import draw_notes, draw_polygon, scale_note
from tmmcalc.linkage.polygons import polygons
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.drawing.curves import TICKS
from tmmcalc.report.drawing.labels import signed
from tmmcalc.report.drawing.order import POLYGONS, POSITIONS, Order
from tmmcalc.report.drawing.page import blank, settle


def figure(order: Order) -> Figure:
    """The figure of the stage: scheme and diagrams, and the polygons of a position that is asked for."""
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    result = order.results["kinematics"]
    chosen, marked = order.rows(POSITIONS, result.labels), order.row(POLYGONS, result.labels)
    return kinematics_figure(to_linkage(order.spec.linkage), result, chosen, marked)


def kinematics_figure(
    mechanism: Mechanism, result: Kinematics, positions: Sequence[int] | None, marked: int | None
) -> Figure:
    """One sheet, or two with the polygons of the position ``marked``; raises `UsageError` for one that is not there."""
    check_positions(len(result.x), [*(positions or ()), *([] if marked is None else [marked])])
    figure, sheets = blank(1 if marked is None else 2)
    cycle = whole_cycle(chain_of(mechanism, result), result)
    drawn = chosen(cycle, result, positions, marked)
    _first_sheet(figure, sheets[0], result, cycle, drawn)
    if marked is not None:
        _second_sheet(sheets[1], mechanism, result, marked)
    return figure


def _first_sheet(
    figure: Figure, sheet: SubFigure, result: Kinematics, cycle: LinkageMotion, drawn: Sequence[int]
) -> None:
    columns = columns_of(result, cycle)
    grid = sheet.add_gridspec(
        3, 1 + len(columns), width_ratios=[1.35 if len(columns) < 2 else 1.5, *(1 for _ in columns)]
    )
    scheme = sheet.add_subplot(grid[:, 0])
    prepare(scheme, cycle)
    panels: list[list[Axes]] = []
    for c, curves in enumerate(columns):
        column: list[Axes] = []
        for row in range(3):
            column.append(sheet.add_subplot(grid[row, 1 + c], sharex=column[0] if column else None))
        draw_diagrams(column, result, cycle, curves, TICKS // len(columns))
        panels.append(column)
    settle(figure)
    draw_scheme(scheme, result, cycle, drawn)
    for column, curves in zip(panels, columns, strict=True):
        label_diagrams(column, result, cycle, curves)


def _second_sheet(sheet: SubFigure, mechanism: Mechanism, result: Kinematics, marked: int) -> None:
    vectors = polygons(mechanism, result, marked)
    where = f"Position {result.labels[marked]}"
    if result.turns:
        where += f", $\\varphi$ = {signed(math.degrees(result.phi[marked]), 5)}°"
    sheet.text(0.5, 0.965, where, ha="center", fontsize=10)
    for left, letter, polygon in ((0.02, "v", vectors.velocity), (0.51, "a", vectors.acceleration)):
        axes = sheet.add_axes((left, 0.2, 0.47, 0.71))
        mu = draw_polygon(axes, polygon, vectors.fixed)
        name = "Velocity polygon" if letter == "v" else "Acceleration polygon"
        axes.set_title(f"{name},  {scale_note(letter, mu)}")
    draw_notes(sheet.add_axes((0.04, 0.02, 0.92, 0.15)), vectors)
