"""The pressure angle over the turn: limits of rise and return, extremes, and where a limit is exceeded."""

from __future__ import annotations

from math import degrees

import numpy as np

from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.pictures.phasenames import PhaseRow, draw_phases, line_phases, phase_row
from tmmcalc.cams.pictures.toscale import ends_to_scale, turn_to_scale
from tmmcalc.cams.pictures.wording import deg, limit_name
from tmmcalc.cams.pictures.zone import LIMIT
from tmmcalc.cams.pressure.angle import Reached, pressure_angle
from tmmcalc.cams.pressure.solve import Pressure
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import DOTTED, input_axis, stacked
from tmmcalc.report.drawing.diagram import Axis, Diagram, room
from tmmcalc.report.drawing.limits import places, with_limits
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import titled
from tmmcalc.report.drawing.pens import CURVES, OTHER
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number

EXCEEDED = "#f3c3a3"  # what is beyond a limit
NOISE = 1e-12  # [rad] of an extreme that is zero


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return pressure_drawing(cam_of(order), order.results["cam_pressure"])


def pressure_drawing(task: CamTask, result: Pressure) -> Drawing:
    """One sheet: theta above, the displacement under it."""
    drawing, box = titled(tr("Pressure angle over a turn of the cam"), 3.2)
    upper, lower = stacked(box, [0, 0], [2.2, 1.0])
    phi, _, lift = _dense(task, result)
    draw_angle(drawing, upper, task, result)
    turns = result.follower.kind == "oscillating"
    factor, name = (degrees(1.0), "$Δψ$, °") if turns else (1e3, f"$ΔS$, {tr_unit('mm')}")
    diagram = Diagram(drawing, lower, input_axis(True, np.degrees(phi)), Axis(name, *room([factor * lift], 0.16)))
    line_phases(diagram, np.degrees(task.program.starts), OTHER)
    diagram.curve(np.degrees(phi) + 1j * factor * lift, CURVES[2]._replace(dashes=()))
    return drawing


def _dense(task: CamTask, result: Pressure) -> tuple[Values, Values, Values]:
    """phi, theta, displacement (m,) with both limits at every edge."""
    program = task.program
    dense = program.panels.halved()
    motion = program.at(dense.x.ravel())
    theta = pressure_angle(result.follower, dense.x.ravel(), motion).reshape(dense.x.shape)
    return places(dense), with_limits(dense, theta), with_limits(dense, motion[0].reshape(dense.x.shape))


def draw_angle(
    drawing: Drawing, box: Box, task: CamTask, result: Pressure, *, to_scale: bool = False, numbered: bool = False
) -> Diagram:
    """The pressure angle with its limits and extremes.

    ``numbered``: with numbers along; ``to_scale``: at standard scales, with numbers too.
    """
    phi, theta, _ = _dense(task, result)
    high = max(np.max(np.abs(theta)), *(on.limit or 0.0 for on in (result.rise, result.back)))
    top = 1.18 * max(degrees(high), 1.0)
    along = input_axis(True, np.degrees(phi))
    box = turn_to_scale(box) if to_scale else box
    row = _row(task, box.width)
    ends = -top, -top + 2 * top * box.height / (box.height - row.height)
    if to_scale:
        ends = ends_to_scale(ends, box.height)
    diagram = Diagram(drawing, box, along, Axis(tr("pressure angle $θ$, °"), *ends), numbered=to_scale or numbered)
    draw_phases(diagram, row, OTHER)
    spans = _spans(task)
    for on, (a, b) in zip((result.rise, result.back), spans, strict=True):
        for level in () if on.limit is None else (degrees(on.limit), -degrees(on.limit)):
            diagram.curve(np.array([complex(a, level), complex(b, level)]), LIMIT, level=3)
        for low, last in on.exceeded:
            inside = (phi >= low) & (phi <= last)
            x, over = np.degrees(phi[inside]), np.degrees(theta[inside])
            limit = np.copysign(degrees(on.limit or 0.0), over)
            diagram.filled(np.concatenate((x + 1j * limit, (x + 1j * over)[::-1])), EXCEEDED)
    diagram.curve(np.degrees(phi) + 1j * np.degrees(theta), CURVES[0])
    if len(result.phi) <= DOTTED:
        diagram.dots(np.degrees(result.phi), np.degrees(result.theta), CURVES[0])
    for kind, on, span in zip(("rise", "return"), (result.rise, result.back), spans, strict=True):
        _name_limit(diagram, limit_name(kind), on, span, degrees(high))
    done: list[complex] = []
    for extreme in (each for on in (result.rise, result.back) for each in (on.least, on.largest)):
        at = complex(degrees(extreme.phi), degrees(extreme.value) if abs(extreme.value) > NOISE else 0.0)
        if all(abs(diagram.place(at) - other) > 0.5 for other in done):
            done.append(diagram.place(at))
            diagram.mark(at, number(at.imag, 5), CURVES[0])
    return diagram


def _name_limit(diagram: Diagram, name: str, on: Reached, span: tuple[float, float], top: float) -> None:
    a, b = span
    if on.limit is None:
        at = diagram.paper([complex((a + b) / 2, part * top) for part in (-0.5, 0.5, -0.9)])
        diagram.labels.put(tr("not limited"), at, height=2.2, gaps=(0.0, 0.9, 1.7), colour=LIMIT.colour)
        return
    for sign in (1, -1):
        level = sign * degrees(on.limit)
        text = f"{'' if sign > 0 else '−'}{name} = {deg(sign * on.limit)}"
        at = diagram.paper([complex(a + part * (b - a), level) for part in (1.0, 0.0, 0.5)])
        diagram.labels.put(text, at, height=2.2, prefer=1 + sign * 1j, colour=LIMIT.colour)


def _spans(task: CamTask) -> list[tuple[float, float]]:
    """From where to where rise and return go [deg]."""
    program = task.program
    spans = []
    for kind in ("rise", "return"):
        k = next(k for k, phase in enumerate(program.phases) if phase.kind == kind)
        spans.append((degrees(program.starts[k]), degrees(program.starts[k + 1])))
    return spans


def _row(task: CamTask, room: float) -> PhaseRow:
    """The names of the phases over a diagram as wide as ``room`` [mm]."""
    program = task.program
    return phase_row([phase.kind for phase in program.phases], np.degrees(program.starts), room, angles=False)
