"""The end view of a train: pitch circles at their true places, tips of planets dashed, the gap between neighbours."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.pictures.placed import PlacedTrain, Wheel
from tmmcalc.report.drawing.board import Board
from tmmcalc.report.drawing.style import CURVES, THIN
from tmmcalc.report.numbers import number

PLANES: tuple[dict[str, Any], ...] = (
    {"color": CURVES[0]["color"], "linestyle": "-"},
    {"color": CURVES[1]["color"], "linestyle": (0, (9, 1.5))},
    {"color": CURVES[2]["color"], "linestyle": (0, (9, 1.5, 2, 1.5))},
)
PITCH_WEIGHT = 1.5  # [pt]
TIP: dict[str, Any] = {"linewidth": 0.7, "linestyle": (0, (3, 2)), "zorder": 4}
CENTRE: dict[str, Any] = {"color": THIN, "linewidth": 0.5, "linestyle": (0, (10, 2, 2, 2)), "zorder": 2}
RIM = 2.5  # [module] that is shown of a ring behind its pitch circle
AROUND = np.exp(2j * np.pi * np.linspace(0, 1, 181))
NAMED = np.exp(1j * np.radians([62, 118, 40, 140, 20, 160, 90, -40, -140]))  # where names of circles may stand


def style_of(wheel: Wheel) -> dict[str, Any]:
    """Colour and dashes of the plane that a wheel meshes in; of a wheel in two planes those of the first."""
    return PLANES[wheel.planes[0] % len(PLANES)]


def extent(train: PlacedTrain) -> Plane:
    """Corners of all that the end view shows."""
    corners = []
    for wheel in train.wheels:
        radius = wheel.outer + RIM * wheel.module if wheel.internal else wheel.outer
        corners += [axis + radius * side for axis in wheel.axes for side in (-1, 1, -1j, 1j)]
    return np.array(corners)


def draw_end_view(board: Board, train: PlacedTrain, at: complex) -> None:
    """All circles, centre lines and the least gap, the main axis ``at`` this place."""
    _centre_lines(board, train, at)
    for wheel in train.wheels:
        style = style_of(wheel)
        for axis in wheel.axes:
            for radius, plane in wheel.pitch:
                look = {"linewidth": PITCH_WEIGHT, "zorder": 5, **PLANES[plane % len(PLANES)]}
                board.line(at + axis + radius * AROUND, weight=0.8, **look)
            if wheel.planet:
                board.line(at + axis + wheel.tip * AROUND, weight=0.3, color=style["color"], **TIP)
        if wheel.internal:
            rim = wheel.reference + RIM * wheel.module
            board.line(at + rim * AROUND, linewidth=0.7, weight=0.4, zorder=4, color=style["color"])
    for place in {axis for wheel in train.wheels for axis in wheel.axes}:
        board.circle(at + place, 0.6, zorder=8)


def label_end_view(board: Board, train: PlacedTrain, at: complex) -> None:
    """Names of the wheels, and the least gap with its size."""
    for wheel in train.wheels:
        anchors = (at + wheel.axes[0] + wheel.pitch[0][0] * NAMED).tolist()
        color = style_of(wheel)["color"]
        board.labels.put(wheel.name, anchors, size=8, gaps=(1.0, 1.8, 2.8), ring=True, color=color)
    gap = train.gap
    if gap is None or gap.size <= 0:
        return
    ends = [at + end for end in gap.ends]
    board.line(ends, linewidth=2.2, zorder=9, weight=2.0)
    text = f"gap {length_text(train, gap.size)}"
    board.labels.put(text, [sum(ends) / 2], size=7.5, gaps=(1.6, 2.6, 4.0, 6.0, 9.0), prefer=sum(ends) - 2 * at)


def length_text(train: PlacedTrain, value: float) -> str:
    """A length in mm, or in modules of stage 1."""
    return f"{number(1e3 * value, 4)} mm" if train.known else f"{number(value, 4)} $m_1$"


def _centre_lines(board: Board, train: PlacedTrain, at: complex) -> None:
    """Circles on which planets stand, rays to them, the line of axes in a row."""
    over = 4 * board.mu
    for orbit in {abs(wheel.axes[0]) for wheel in train.wheels if wheel.planet}:
        if train.planets > 1:
            board.line(at + orbit * AROUND, weight=0, **CENTRE)
    ends = extent(train)
    rays = {axis / abs(axis) for wheel in train.wheels for axis in wheel.axes if axis}
    for ray in rays:
        far = float(np.max((ends * np.conj(ray)).real)) + over
        board.line((at - over * ray, at + far * ray), weight=0.2, **CENTRE)
    if not train.scheme.branched:
        board.line((at + ends.real.min() - over, at), weight=0.2, **CENTRE)
        for wheel in train.wheels:
            up = (wheel.outer + over) * 1j
            board.line((at + wheel.axes[0] - up, at + wheel.axes[0] + up), weight=0.2, **CENTRE)
