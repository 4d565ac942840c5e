"""The picture of the pendulum-rotor: mode shapes along the hanging rod, Campbell diagram, path of the lower end."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Axis, Diagram, key_rows
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.panels import PLACE, Panel, panels
from tmmcalc.report.drawing.pens import CURVES, INK, MARK, PATH, Pen
from tmmcalc.report.drawing.polar import AROUND, name_axes
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.numbers import number
from tmmcalc.report.sheets.piece import Piece
from tmmcalc.vibration.pendulum.results import Campbell, PendulumResult
from tmmcalc.vibration.pendulum.swing import SwingCourse
from tmmcalc.vibration.pictures.sheets import sheets_of

RPM = 30 / np.pi
SPIN = Pen("SPIN", 0.35, colour=INK)
MARGIN = 6.0  # free border of the path [mm]


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return pendulum_drawing(order.results["pendulum"])


def pendulum_drawing(result: PendulumResult) -> Drawing:
    """A sheet each of shapes, Campbell diagram and motion, as far as there are results."""
    return sheets_of([(piece.heading, piece.draw) for piece in pieces_of(result).values()])


def pieces_of(result: PendulumResult) -> dict[str, Piece]:
    """Shapes, Campbell diagram and motion, as far as there are results."""
    found = {"modes": _piece(tr("Mode shapes"), partial(_shapes, result=result), 100.0)}
    if result.campbell is not None:
        drawn = partial(_campbell, result=result, campbell=result.campbell)
        found["campbell"] = _piece(tr("Campbell diagram"), drawn, 150.0 if len(result.campbell.whirl) else 90.0)
    if result.swing is not None:
        found["swing"] = _piece(tr("Motion of the lower end"), partial(_swing, swing=result.swing), 85.0)
    return found


def _piece(heading: str, draw: Callable[[Drawing, Box], None], high: float) -> Piece:
    return Piece("linkage", heading, draw, (150.0, 80.0), (160.0, high))


def _shapes(drawing: Drawing, box: Box, result: PendulumResult) -> None:
    """Displacements across, the rod downwards."""
    depth = Axis(tr("$a$ along the rod, mm"), 1e3 * float(np.max(result.place)), 1e3 * float(np.min(result.place)))
    parts = box.split(*(1.0 for _ in result.modes), gap=3, across=True)
    for part, modes in zip(parts, result.modes, strict=True):
        drawing.add(Words(complex(part.middle.real, part.top), _plane(modes.name), 2.8, 1j))
        names = [
            (f"{n + 1}: {number(float(w) / (2 * np.pi), 5)} {tr_unit('Hz')}", CURVES[n % len(CURVES)])
            for n, w in enumerate(modes.frequency[: len(modes.shapes)])
        ]
        rows = len(key_rows(names, part.width - 18.0))
        frame = part.inset(16, 12, 2, 7 + 4.2 * rows)
        field = Diagram(drawing, frame, Axis(tr("displacement, largest 1"), -1.15, 1.15), depth)
        field.vertical(0.0, PLACE)
        for (_, pen), shape in zip(names, modes.shapes, strict=True):
            field.curve(shape + 1e3j * result.place, pen)
        field.key(names)


def _campbell(drawing: Drawing, box: Box, result: PendulumResult, campbell: Campbell) -> None:
    """Frequencies over the spin with the line of the spin itself, and the whirl of the unbalance."""
    spin = campbell.spin * RPM
    top = max(1.6 * float(spin[-1]), 1.3 * float(campbell.forward[0, -1]) * RPM)
    along = Axis(tr("spin, rpm"), float(spin[0]), float(spin[-1]))
    parts = box.split(1, 1) if len(campbell.whirl) else [box]
    frame = parts[0].inset(16, 12, 5, 7)
    field = Diagram(drawing, frame, along, Axis(tr("whirl, 1/min"), 0.0, top))
    for k in range(campbell.modes):
        field.curve(spin + 1j * campbell.forward[k] * RPM, CURVES[0])
        field.curve(spin + 1j * campbell.backward[k] * RPM, CURVES[1])
    field.curve(spin * (1 + 1j), SPIN)
    field.key([(tr("forward"), CURVES[0]), (tr("backward"), CURVES[1]), (tr("spin"), SPIN)])
    for w in result.forward_critical.tolist():
        if campbell.spin[0] <= w <= campbell.spin[-1]:
            field.marker(complex(w * RPM, w * RPM), "D", MARK, 1.6, filled=False)
    for part in parts[1:]:
        size = 1e3 * np.abs(campbell.whirl)
        low, high = 1e-2 * float(np.median(size)), 1e2 * float(np.median(size))
        whirl = Axis(tr("whirl of the unbalance, mm"), low, high, log=True)
        below = Diagram(drawing, part.inset(16, 12, 5, 3), along, whirl)
        below.curve(spin + 1j * np.clip(size, low, high), CURVES[2])


def _swing(drawing: Drawing, box: Box, swing: SwingCourse) -> None:
    left, right = box.split(1, 1, gap=4, across=True)
    path: Plane = np.asarray(1e3 * (swing.v + 1j * swing.w), complex)
    board = Board(drawing, left.inset(*AROUND, 2), path, MARGIN)
    name_axes(board, ("v", "w"), float(np.max(np.abs(path))) or 1.0, "mm")
    board.line(path, PATH._replace(dashes=()), level=4)
    board.circle(complex(path[0]), 0.8, MARK._replace(width=0.3), level=6)
    rows = [
        Panel(tr_unit("mm"), ((tr("$v$ from under the joint"), 1e3 * swing.v), ("$w$", 1e3 * swing.w))),
        Panel(tr("joint, m"), (("$x_O$", swing.carrier_x), ("$y_O$", swing.carrier_y)), 2),
    ]
    panels(drawing, right, swing.t, f"$t$, {tr_unit('s')}", rows)


def _plane(name: str) -> str:
    """Where a mode is: a plane of the joint, or a sense of the whirl."""
    return {"plane xz": tr("plane $xz$"), "plane yz": tr("plane $yz$")}.get(name) or tr_name(name)
