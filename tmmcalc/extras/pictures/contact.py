"""The picture of the elastic contact: the field of pressure, and along the axis of x beside Hertz."""

from __future__ import annotations

import numpy as np

from tmmcalc.extras.contact import Contact
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import ROW, Axis, Diagram, key_rows, room
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import titled
from tmmcalc.report.drawing.pens import CURVES, MARK, Pen
from tmmcalc.report.drawing.polar import AROUND, name_axes
from tmmcalc.report.drawing.shapes import Area, Drawing, Words
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number

MARGIN = 6.0  # free border of the field [mm]
LEVELS = 14  # shades of the pressure
PALE, DEEP = np.array([0xF7, 0xFB, 0xFF]), np.array([0x08, 0x30, 0x6B])
BAR = 4.0  # width of the scale of shades [mm]


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return contact_drawing(order.results["contact"])


def contact_drawing(result: Contact) -> Drawing:
    """The field of pressure from above, and along the axis of x beside Hertz."""
    drawing, box = titled(tr("Contact pressure, largest {pressure} MPa", pressure=number(1e-6 * result.peak, 5)))
    draw_contact(drawing, box, result)
    return drawing


def draw_contact(drawing: Drawing, box: Box, result: Contact) -> None:
    """The field and the section in a rectangle."""
    left, right = box.split(1, 1, gap=6, across=True)
    _field(drawing, left, result)
    _section(drawing, right, result)


def _field(drawing: Drawing, box: Box, result: Contact) -> None:
    """A square for every element, shaded by its pressure, with the ellipse of Hertz."""
    x, y, p = 1e3 * result.x, 1e3 * result.y, 1e-6 * result.pressure
    z, half = x + 1j * y, 1e3 * result.step / 2
    corners = half * np.array([-1 - 1j, 1 - 1j, 1 + 1j, -1 + 1j])
    board = Board(drawing, box.inset(*AROUND, 16), np.concatenate([z - half * (1 + 1j), z + half * (1 + 1j)]), MARGIN)
    name_axes(board, ("x", "y"), float(np.max(np.abs(z))), "mm")
    top = float(p.max()) or 1.0
    for at, pressure in zip(z.tolist(), p.tolist(), strict=True):
        drawing.add(Area(board.paper(at + corners), _shade(pressure / top)), level=2)
    smooth = result.hertz
    if smooth is not None:
        turn = np.linspace(0, 2 * np.pi, 181)
        ellipse = 1e3 * (smooth.along_x * np.cos(turn) + 1j * smooth.along_y * np.sin(turn))
        board.line(ellipse, MARK._replace(width=0.35), level=4)
    wide = box.width - 40.0
    for k in range(LEVELS):
        at = complex(box.left + 20 + k * wide / LEVELS, box.top - 6)
        cell = at + np.array([0, wide / LEVELS, wide / LEVELS + 1j * BAR, 1j * BAR])
        drawing.add(Area(cell, _shade((k + 0.5) / LEVELS)))
    drawing.add(Words(complex(box.left + 19, box.top - 4), "0", 2.3, 1))
    drawing.add(Words(complex(box.left + 21 + wide, box.top - 4), f"{number(top, 4)} {tr_unit('MPa')}", 2.3, -1))


def _shade(part: float) -> str:
    level = min(int(max(part, 0.0) * LEVELS), LEVELS - 1) / (LEVELS - 1)
    return "#" + "".join(f"{round(v):02x}" for v in (PALE + level * (DEEP - PALE)).tolist())


def _section(drawing: Drawing, box: Box, result: Contact) -> None:
    """The pressure on the axis of x."""
    x, p = 1e3 * result.x, 1e-6 * result.pressure
    axis = np.flatnonzero(np.abs(result.y) < result.step / 4)
    axis = axis[np.argsort(x[axis])]
    values, smooth = [p[axis]], result.hertz
    fine = np.linspace(float(x[axis[0]]), float(x[axis[-1]]), 401)
    if smooth is not None:
        part = np.maximum(1 - (fine / (1e3 * smooth.along_x)) ** 2, 0.0)
        values.append(1e-6 * smooth.peak * np.sqrt(part))
    air = 0.04 * float(np.ptp(fine))
    across = Axis(tr("$x$ at $y$ = 0, mm"), float(fine[0]) - air, float(fine[-1]) + air)
    names = [(tr("boundary integral: points"), Pen("POINTS", 0.3, colour=CURVES[0].colour))]
    if smooth is not None:
        names.append((tr("Hertz"), CURVES[1]))
    larger = drawing.letters
    left, right = 16 * larger, 2.0
    top = larger * ROW * len(key_rows(names, box.width - left - right, larger)) + 2.5
    frame = box.inset(left, 12 * larger, right, top)
    field = Diagram(drawing, frame, across, Axis(f"$p$, {tr_unit('MPa')}", *room(values)))
    if smooth is not None:
        field.curve(fine + 1j * values[1], CURVES[1])
    field.dots(x[axis], p[axis], CURVES[0])
    field.key(names)
