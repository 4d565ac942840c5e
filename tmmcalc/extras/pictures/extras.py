"""Pictures of the small calculators: pressure of a contact, reliability over the time, speed and way of a ball."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from tmmcalc.extras.contact import Contact
from tmmcalc.extras.falling_ball import Ball
from tmmcalc.extras.reliability import Reliability
from tmmcalc.report.drawing import check_matplotlib, form_of
from tmmcalc.report.drawing.page import blank, settle, write
from tmmcalc.report.drawing.style import CURVES, MARK
from tmmcalc.report.numbers import number
from tmmcalc.vibration.pictures.axes import diagram, marked


def draw_extra(stage: str, result: Any, file: Path) -> None:
    """Draw the result of a small calculator."""
    form = form_of(file)
    check_matplotlib()
    figures: dict[str, Callable[[Any], Figure]] = {
        "contact": contact_figure,
        "reliability": reliability_figure,
        "falling_ball": ball_figure,
    }
    write(file, form, lambda: figures[stage](result))


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


def reliability_figure(result: Reliability) -> Figure:
    """Reliability, and the density of failures below it; the mean life is marked."""
    figure, (sheet,) = blank(1)
    sheet.suptitle(f"Reliability, mean life {number(result.mean, 6)}", fontsize=10)
    upper, lower = sheet.subplots(2, 1, sharex=True)
    diagram(upper, result.t, [("R", result.kept)], "R")
    diagram(lower, result.t, [("f", result.density), ("intensity", result.intensity)], "1/unit of time", first=1)
    for axes in (upper, lower):
        marked(axes, [result.threshold, result.mean])
    lower.set_xlabel("$t$")
    settle(figure)
    return figure


def ball_figure(result: Ball) -> Figure:
    """Speed and way over the time; maximum and stop are marked."""
    figure, (sheet,) = blank(1)
    sheet.suptitle("Fall of the ball", fontsize=10)
    upper, lower = sheet.subplots(2, 1, sharex=True)
    diagram(upper, result.t, [("v", result.v)], "v, m/s")
    diagram(lower, result.t, [("S", result.way)], "S, m", first=1)
    for axes in (upper, lower):
        marked(axes, [each.t for each in (result.fastest, result.stop) if each is not None])
    lower.set_xlabel("$t$, s")
    settle(figure)
    return figure
