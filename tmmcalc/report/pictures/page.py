"""The page: scheme on the left, diagrams on the right; the vector polygons on a second sheet below.

A sheet is A4 landscape, so that scales hold on paper; with the polygons the page is A3 upright.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from io import BytesIO
from typing import Any

import matplotlib
from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.polygons import polygons
from tmmcalc.linkage.results import Kinematics
from tmmcalc.report.pictures.choice import chosen
from tmmcalc.report.pictures.cycle import Motion, chain_of, whole_cycle
from tmmcalc.report.pictures.diagrams import columns_of, draw_diagrams, label_diagrams
from tmmcalc.report.pictures.labels import signed
from tmmcalc.report.pictures.scheme import draw_scheme, prepare
from tmmcalc.report.pictures.style import RC, SHEET
from tmmcalc.report.pictures.vectors import draw_notes, draw_polygon, scale_note

TICKS = 13  # ticks of the input coordinate that fit beside each other on the page
UNDATED: dict[str, dict[str, Any]] = {
    "svg": {"Date": None},
    "pdf": {"CreationDate": None, "ModDate": None},
    "png": {},
}


def kinematics_page(
    mechanism: Mechanism,
    result: Kinematics,
    form: str,
    positions: Sequence[int] | None,
    marked: int | None,
) -> bytes:
    """The bytes of the picture in this format; they depend on the arguments and the versions of the programs."""
    settings: Any = {k: v for k, v in matplotlib.rcParamsDefault.items() if not k.startswith("backend")}
    settings.update(RC)
    with matplotlib.rc_context(settings):
        figure = _figure(mechanism, result, positions, marked)
        buffer = BytesIO()
        figure.savefig(buffer, format=form, metadata=UNDATED[form])
    return buffer.getvalue()


def _figure(mechanism: Mechanism, result: Kinematics, positions: Sequence[int] | None, marked: int | None) -> Figure:
    width, height = SHEET
    layout = ConstrainedLayoutEngine(w_pad=0.1, h_pad=0.1)
    figure = Figure(figsize=(width, height if marked is None else 2 * height), layout=layout)
    sheets = figure.subfigures(1 if marked is None else 2, 1, squeeze=False)[:, 0]
    cycle = whole_cycle(chain_of(mechanism, result), result)
    drawn = chosen(cycle, result, positions, marked)
    _first_sheet(figure, sheets[0], result, cycle, drawn)
    if marked is not None:
        _second_sheet(sheets[1], mechanism, result, marked)
    return figure


def _first_sheet(figure: Figure, sheet: SubFigure, result: Kinematics, cycle: Motion, drawn: Sequence[int]) -> None:
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
    _settle(figure)
    draw_scheme(scheme, result, cycle, drawn)
    for column, curves in zip(panels, columns, strict=True):
        label_diagrams(column, result, cycle, curves)


def _settle(figure: Figure) -> None:
    """Let the constrained layout place the axes once; what follows is drawn in mm of paper."""
    layout = figure.get_layout_engine()
    if layout is not None:
        layout.execute(figure)
    figure.set_layout_engine("none")


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
