"""The picture of the elastic contact: the field of pressure, and along the axis of x beside Hertz."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from tmmcalc.extras.contact import Contact
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES, MARK
from tmmcalc.report.numbers import number


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return contact_figure(order.results["contact"])


def contact_figure(result: Contact) -> Figure:
    """The field of pressure from above, and along the axis of x beside Hertz."""
    figure, (sheet,) = blank(1)
    sheet.suptitle(f"Contact pressure, largest {number(1e-6 * result.peak, 5)} MPa", fontsize=10)
    field, section = sheet.subplots(1, 2)
    x, y, p = 1e3 * result.x, 1e3 * result.y, 1e-6 * result.pressure
    filled = field.tricontourf(x, y, p, levels=14, cmap="Blues")
    sheet.colorbar(filled, ax=field, label="p, MPa", shrink=0.7)
    field.set_aspect("equal")
    field.set_xlabel("$x$, mm")
    field.set_ylabel("$y$, mm")
    axis = np.flatnonzero(np.abs(result.y) < result.step / 4)
    smooth = result.hertz
    if smooth is not None:
        turn = np.linspace(0, 2 * np.pi, 181)
        field.plot(1e3 * smooth.along_x * np.cos(turn), 1e3 * smooth.along_y * np.sin(turn), color=MARK, linewidth=1.0)
        fine = np.linspace(x[axis[0]], x[axis[-1]], 401)
        part = np.maximum(1 - (fine / (1e3 * smooth.along_x)) ** 2, 0.0)
        section.plot(fine, 1e-6 * smooth.peak * np.sqrt(part), label="Hertz", linewidth=1.1, **CURVES[1])
    section.plot(x[axis], p[axis], ".", label="boundary integral", color=CURVES[0]["color"], zorder=4)
    section.legend()
    section.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    section.set_xlabel("$x$ at $y = 0$, mm")
    section.set_ylabel("p, MPa")
    settle(figure)
    return figure
