"""The pressure angle over the turn: limits of rise and return, extremes, and where a limit is exceeded."""

from __future__ import annotations

from math import degrees

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.pressure.angle import Reached, pressure_angle
from tmmcalc.cams.pressure.solve import Pressure
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.curves import DOTTED, bottom, frame, mark
from tmmcalc.report.drawing.labels import Labels, signed
from tmmcalc.report.drawing.limits import places, with_limits
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES, INK, MARK, THIN
from tmmcalc.report.numbers import angle

TICKS = 25


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return pressure_figure(cam_of(order), order.results["cam_pressure"])


def pressure_figure(task: CamTask, result: Pressure) -> Figure:
    """One sheet: theta above, the displacement under it."""
    figure, (sheet,) = blank(1)
    sheet.suptitle("Pressure angle over a turn of the cam", fontsize=10)
    upper, lower = sheet.subplots(2, 1, height_ratios=[2.2, 1.0], sharex=True)
    phi, theta, lift = _dense(task, result)
    _draw_angle(upper, task, result, phi, theta)
    factor, name = (
        (degrees(1.0), "$\\Delta\\psi$, °") if result.follower.kind == "oscillating" else (1e3, "$\\Delta S$, mm")
    )
    lower.plot(np.degrees(phi), factor * lift, linewidth=1.3, **CURVES[2])
    frame(lower, name, np.degrees(phi), True, TICKS)
    _phases(lower, task)
    bottom([upper, lower], True)
    settle(figure)
    _label(upper, task, result, phi, theta)
    _name_phases(lower, task)
    return figure


def _dense(task: CamTask, result: Pressure) -> tuple[Values, Values, Values]:
    """phi, theta, displacement (m,) with both limits at every edge."""
    program = task.program
    dense = program.panels.halved()
    motion = program.at(dense.x.ravel())
    theta = pressure_angle(result.follower, dense.x.ravel(), motion).reshape(dense.x.shape)
    return places(dense), with_limits(dense, theta), with_limits(dense, motion[0].reshape(dense.x.shape))


def _draw_angle(axes: Axes, task: CamTask, result: Pressure, phi: Values, theta: Values) -> None:
    axes.plot(np.degrees(phi), np.degrees(theta), linewidth=1.4, zorder=4, **CURVES[0])
    if len(result.phi) <= DOTTED:
        axes.plot(
            np.degrees(result.phi), np.degrees(result.theta), "o", markersize=2.4, color=CURVES[0]["color"], zorder=5
        )
    frame(axes, "pressure angle $\\theta$, °", np.degrees(phi), True, TICKS)
    _phases(axes, task)
    high = max(np.max(np.abs(theta)), *(on.limit or 0.0 for on in (result.rise, result.back)))
    axes.set_ylim(-1.18 * max(degrees(high), 1.0), 1.18 * max(degrees(high), 1.0))
    for on, (a, b) in zip((result.rise, result.back), _spans(task), strict=True):
        for sign in (1, -1) if on.limit is not None else ():
            level = sign * degrees(on.limit or 0.0)
            axes.plot([a, b], [level, level], color=MARK, linewidth=1.1, linestyle=(0, (6, 2)), zorder=3)
        for low, top in on.exceeded:
            inside = (phi >= low) & (phi <= top)
            limit = np.copysign(on.limit or 0.0, theta[inside])
            axes.fill_between(
                np.degrees(phi[inside]), np.degrees(limit), np.degrees(theta[inside]), color=MARK, alpha=0.3, zorder=2
            )


def _label(axes: Axes, task: CamTask, result: Pressure, phi: Values, theta: Values) -> None:
    labels = Labels(axes)
    labels.avoid(np.degrees(phi) + 1j * np.degrees(theta), 1.0)
    for on, (a, b) in zip((result.rise, result.back), _spans(task), strict=True):
        _label_limit(axes, labels, on, a, b)
        for extreme in (on.least, on.largest):
            at = complex(degrees(extreme.phi), degrees(extreme.value) if abs(extreme.value) > 1e-12 else 0.0)
            mark(axes, labels, at, CURVES[0], 5)


def _label_limit(axes: Axes, labels: Labels, on: Reached, a: float, b: float) -> None:
    if on.limit is None:
        text = "not limited"
        labels.put(text, [complex((a + b) / 2, 0.9 * axes.get_ylim()[1])], size=7.5, color=MARK)
        return
    for sign in (1, -1):
        level = sign * degrees(on.limit)
        labels.avoid([complex(a, level), complex(b, level)], 1.0)
        text = f"${'' if sign > 0 else '-'}[\\theta]$ = {signed(float(angle(level)), 5)}°"
        labels.put(text, [complex(b, level), complex(a, level)], size=7.5, prefer=1 + sign * 1j, color=MARK)


def _spans(task: CamTask) -> list[tuple[float, float]]:
    """From where to where rise and return go [deg]."""
    program = task.program
    spans = []
    for kind in ("rise", "return"):
        k = next(k for k, phase in enumerate(program.phases) if phase.kind == kind)
        spans.append((degrees(program.starts[k]), degrees(program.starts[k + 1])))
    return spans


def _phases(axes: Axes, task: CamTask) -> None:
    for start in np.degrees(task.program.starts[1:-1]).tolist():
        axes.axvline(start, color=THIN, linewidth=0.6, zorder=1)


def _name_phases(axes: Axes, task: CamTask) -> None:
    starts, high = np.degrees(task.program.starts), axes.get_ylim()[1]
    labels = Labels(axes)
    line = axes.lines[0]
    labels.avoid(np.asarray(line.get_xdata()) + 1j * np.asarray(line.get_ydata()), 1.0)
    for phase, a, b in zip(task.program.phases, starts[:-1], starts[1:], strict=True):
        if b > a:
            labels.put(phase.kind, [complex((a + b) / 2, 0.55 * high)], size=7.5, prefer=1j, color=INK)
