"""The sheet of one train: side view and end view to one scale, and the table of its wheels."""

from __future__ import annotations

import math
from collections.abc import Callable
from math import gcd
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import SubFigure
from matplotlib.lines import Line2D

from tmmcalc.core.plane import Plane
from tmmcalc.gears.pictures import endview, lengthwise, sideview
from tmmcalc.gears.pictures.endview import PITCH_WEIGHT, PLANES, TIP, length_text
from tmmcalc.gears.pictures.placed import PlacedTrain
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.style import INK
from tmmcalc.report.numbers import number

MARGIN = 9.0  # free border of the views [mm]
APART = 0.13  # between the views, in parts of the height of the train
ROW = 0.036  # height of a row of the table, in parts of its axes
ALIKE = 1e-9  # relative: pressure angles that are one


def scheme_sheet(sheet: SubFigure, train: PlacedTrain, heading: str) -> Callable[[], None]:
    """Lay the sheet out; what is returned draws when the layout is settled."""
    sheet.suptitle(heading, fontsize=10)
    left, right = sheet.subfigures(1, 2, squeeze=False, width_ratios=[3.4, 1.0])[0]
    views, table = left.subplots(), right.subplots()
    views.set_axis_off()
    table.set_axis_off()
    _tabulate(table, train)

    def finish() -> None:
        _draw(views, train)

    return finish


def _draw(axes: Axes, train: PlacedTrain) -> None:
    to, at, content = _arranged(train)
    board = Board(axes, content, MARGIN)
    sideview.draw_side_view(board, train, to)
    endview.draw_end_view(board, train, at)
    _axis_line(board, train, to)
    endview.label_end_view(board, train, at)
    sideview.label_side_view(board, train, to)
    axes.legend(handles=_handles(train), loc="lower left", bbox_to_anchor=(0.0, -0.02), ncols=4, handlelength=3)
    axes.text(1.0, -0.01, _scale(train, board.mu), transform=axes.transAxes, ha="right", va="bottom", size=8)


def _arranged(train: PlacedTrain) -> tuple[sideview.To, complex, Plane]:
    """How the side view is put on the board, where the main axis of the end view stands, corners of all."""
    end, side = endview.extent(train), lengthwise.extent(train)
    apart = APART * train.height
    if train.scheme.branched:
        at = complex(side.real.max() - end.real.min() + apart)
        return complex, at, np.concatenate((side, at + end))
    # seen from above: the axis of the shafts runs down, below the end view
    at = 1j * (side.real.max() - end.imag.min() + apart)

    def turned(s: float, r: float) -> complex:
        return complex(r, side.real.max() - s + side.real.min())

    corners = np.array([turned(z.real, z.imag) for z in side.tolist()])
    return turned, at + 1j * (corners.imag.max() - side.real.max()), np.concatenate((corners, at + end))


def _axis_line(board: Board, train: PlacedTrain, to: sideview.To) -> None:
    """The main axis through the side view."""
    if train.scheme.branched:
        frame, over = lengthwise.frame_of(train), 3 * board.mu
        board.line((to(frame.left, 0.0) - over, to(frame.right, 0.0) + over), weight=0.2, **endview.CENTRE)


def _handles(train: PlacedTrain) -> list[Line2D]:
    found = []
    for plane in range(train.planes):
        names = ", ".join(w.name for w in train.wheels if w.planes[0] <= plane <= w.planes[1])
        label = f"pitch circles {names}"
        found.append(Line2D([], [], label=label, linewidth=PITCH_WEIGHT, **PLANES[plane % len(PLANES)]))
    if train.scheme.branched:
        found.append(Line2D([], [], label="tips of planets", color=INK, **TIP))
    return found


def _scale(train: PlacedTrain, mu: float) -> str:
    said = f"scale 1:{number(1e3 * mu, 4)}" if train.known and mu >= 1e-3 else f"scale {number(1e-3 / mu, 4)}:1"
    if not train.known:
        said = f"1 mm of paper = {number(mu, 4)} $m_1$"
    return said if train.widths is not None else f"{said}; widths of wheels not to scale"


def _tabulate(axes: Axes, train: PlacedTrain) -> None:
    """Wheels with their teeth, modules, diameters; below it what else is to be known."""
    unit = 1e3 if train.known else 1.0
    named = ("m, mm", "d, mm") if train.known else ("$m/m_1$", "$d/m_1$")
    heads = ["wheel", "z", *named]
    if train.widths is not None:
        heads.append("b, mm")
    rows = []
    for wheel in train.wheels:
        row = [wheel.name, str(wheel.teeth), number(unit * wheel.module, 4), number(unit * 2 * wheel.reference, 5)]
        if train.widths is not None:
            row.append(number(1e3 * _width(train, wheel.name), 4))
        rows.append(row)
    height = ROW * (len(rows) + 1)
    look: dict[str, Any] = {"cellLoc": "center", "edges": "horizontal", "bbox": (0.0, 1.0 - height, 1.0, height)}
    table = axes.table(cellText=rows, colLabels=heads, **look)
    table.auto_set_font_size(False)
    table.set_fontsize(8)
    for cell in table.get_celld().values():
        cell.set_linewidth(0.5)
    axes.text(0.0, 1.0 - height - ROW, "\n".join(_facts(train)), va="top", size=7.5, linespacing=1.5)


def _width(train: PlacedTrain, name: str) -> float:
    widths = train.widths or ()
    stages = {mesh.stage for mesh in train.scheme.meshes if name in (mesh.first, mesh.second)}
    wheel = train.wheel(name)
    return widths[min(stages)] * (1 + wheel.planes[1] - wheel.planes[0])


def _facts(train: PlacedTrain) -> list[str]:
    found = []
    if train.scheme.branched:
        what = ("pair of planets" if train.scheme.paired else "planet") if train.scheme.planetary else "layshaft"
        many = what.replace("pair", "pairs") if "pair" in what else f"{what}s"
        found.append(f"{train.planets} {what if train.planets == 1 else many}")
    found += [f"wheel {wheel.name} stands still" for wheel in train.wheels if wheel.fixed]
    for mesh, distance, angle in zip(train.scheme.meshes, train.distances, train.angles, strict=True):
        one, other = train.wheel(mesh.first).teeth, train.wheel(mesh.second).teeth
        text = f"mesh {mesh.first}-{mesh.second}: $a_w$ = {length_text(train, distance)}"
        if _raised(train):
            text += f", $\\alpha_w$ = {number(math.degrees(angle), 4)}°"
        shared = gcd(one, other)
        found.append(f"{text}\n    {'coprime' if shared == 1 else f'common factor {shared}'}")
    gap = train.gap
    if gap is not None:
        found.append(f"gap of neighbours {length_text(train, gap.size)}")
    if _raised(train) and train.scheme.branched:
        found.append("tips drawn without profile shift")
    if train.estimated:
        found.append("modules not chosen yet, drawn with\n$m_{k+1} = m_k\\,u_k^{1/3}$ (4.4)")
    elif not train.known:
        found.append("lengths in modules of stage 1")
    return found


def _raised(train: PlacedTrain) -> bool:
    """Whether the meshes differ in their pressure angle, or it is not that of the rack."""
    return max(train.angles) - min(train.angles) > ALIKE * max(train.angles)
