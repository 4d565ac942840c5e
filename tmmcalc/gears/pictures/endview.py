"""The end view of a train: pitch circles at their true places, tips of planets dashed, the gap between neighbours."""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.gears.pictures.placed import PlacedTrain, Wheel
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.pens import CURVES, Pen
from tmmcalc.report.drawing.shapes import Arc
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number

COLOURS = tuple(pen.colour for pen in CURVES[:3])  # of the planes of meshing
PITCH = tuple(
    Pen(f"PITCH_CIRCLES_{k}", 0.5, dashes, colour)
    for k, (dashes, colour) in enumerate(zip(((), (5.0, 1.0), (5.0, 1.0, 1.0, 1.0)), COLOURS, strict=True), 1)
)
TIPS = tuple(Pen(f"TIP_CIRCLES_{k}", 0.25, (1.2, 0.9), colour) for k, colour in enumerate(COLOURS, 1))
RIMS = tuple(Pen(f"RIMS_{k}", 0.25, (), colour) for k, colour in enumerate(COLOURS, 1))
CENTRES = Pen("CENTRE_LINES", 0.18, (6.0, 1.5, 1.0, 1.5), "#7a7a7a")
GAP = Pen("GAPS", 0.8)
LEADER = Pen("LEADERS", 0.18)
OUTWARD = (0.0, 4.0, 8.0, 12.0, 16.0, 20.0, 24.0, 28.0)  # places for the name of a gap, away from the main axis [mm]
FAR, NEAR = 4.5, 2.6  # a name that stands higher or lower than this has a line to what it names, as near to it [mm]
RIM = 2.5  # [module] that is shown of a ring behind its pitch circle
AROUND = np.exp(2j * np.pi * np.linspace(0, 1, 181))
NAMED = np.exp(1j * np.radians([62, 118, 40, 140, 20, 160, 90, -40, -140]))  # where names of circles may stand


def plane_of(wheel: Wheel) -> int:
    """Which of the pens of planes a wheel is drawn with; of a wheel in two planes that of the first."""
    return wheel.planes[0] % len(PITCH)


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
        for axis in wheel.axes:
            for radius, plane in wheel.pitch:
                _circle(board, at + axis, radius, PITCH[plane % len(PITCH)], 0.8, 5)
            if wheel.planet:
                _circle(board, at + axis, wheel.tip, TIPS[plane_of(wheel)], 0.3, 4)
        if wheel.internal:
            _circle(board, at, wheel.reference + RIM * wheel.module, RIMS[plane_of(wheel)], 0.4, 4)
    for place in {axis for wheel in train.wheels for axis in wheel.axes}:
        board.circle(at + place, 0.7, level=8)


def _circle(board: Board, centre: complex, radius: float, pen: Pen, weight: float, level: float) -> None:
    """A circle of this radius [m, or m1]; names keep clear of it by ``weight``."""
    board.drawing.add(Arc(board.place(centre), radius / board.mu, pen), level=level)
    board.labels.avoid(board.paper(centre + radius * AROUND), weight)


def label_end_view(board: Board, train: PlacedTrain, at: complex) -> None:
    """Names of the wheels, and the least gap with its size."""
    for wheel in train.wheels:
        anchors = board.paper(at + wheel.axes[0] + wheel.pitch[0][0] * NAMED)
        colour = COLOURS[plane_of(wheel)]
        board.labels.put(wheel.name, anchors, height=2.2, gaps=(0.9, 1.7, 2.8, 5.0), ring=True, colour=colour)
    gap = train.gap
    if gap is None or gap.size <= 0:
        return
    ends = [at + end for end in gap.ends]
    board.line(ends, GAP, level=9, weight=2.0)
    outward = sum(ends) - 2 * at
    middle = board.place(sum(ends) / 2)
    free = [middle + step * outward / abs(outward) for step in OUTWARD]
    name = board.labels.put(
        tr("gap {length}", length=length_text(train, gap.size)), free, gaps=(1.6, 2.6), prefer=outward
    )
    away = (name - middle).imag
    if abs(away) > FAR:
        board.drawing.line([middle, name - math.copysign(NEAR, away) * 1j], LEADER, level=9)


def length_text(train: PlacedTrain, value: float) -> str:
    """A length in mm, or in modules of stage 1."""
    return f"{number(1e3 * value, 4)} {tr_unit('mm')}" if train.known else f"{number(value, 4)} $m_1$"


def _centre_lines(board: Board, train: PlacedTrain, at: complex) -> None:
    """Circles on which planets stand, rays to them, the line of axes in a row."""
    over = 4 * board.mu
    for orbit in {abs(wheel.axes[0]) for wheel in train.wheels if wheel.planet}:
        if train.planets > 1:
            _circle(board, at, orbit, CENTRES, 0.2, 2)
    ends = extent(train)
    rays = {axis / abs(axis) for wheel in train.wheels for axis in wheel.axes if axis}
    for ray in rays:
        far = float(np.max((ends * np.conj(ray)).real)) + over
        board.line((at - over * ray, at + far * ray), CENTRES, weight=0.2, level=2)
    if not train.scheme.branched:
        board.line((at + ends.real.min() - over, at), CENTRES, weight=0.2, level=2)
        for wheel in train.wheels:
            up = (wheel.outer + over) * 1j
            board.line((at + wheel.axes[0] - up, at + wheel.axes[0] + up), CENTRES, weight=0.2, level=2)
