"""The picture of the law of motion: displacement and its derivatives over the turn, and the phase portrait S'(S).

The second sheet is the graphical integration of S'', beside the exact law.
"""

from __future__ import annotations

from math import degrees

import numpy as np

from tmmcalc.cams.lawresult import LawResult
from tmmcalc.cams.laws.graphical import constructed
from tmmcalc.cams.pictures.integration import INTERVALS, draw_integration, integration_heading
from tmmcalc.cams.pictures.lawdiagrams import (
    DENSE,
    axis_name,
    draw_laws,
    pieces_of,
    shown_scale,
    symbol,
)
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.pictures.wording import mm
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import DOTTED
from tmmcalc.report.drawing.diagram import Axis, Diagram, one_scale
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import headed, sheets
from tmmcalc.report.drawing.pens import CURVES, INK, MIDDLE, Pen
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.numbers import number

HEIGHTS = (1.3, 1.0, 1.0, 0.9)  # of the diagrams of S, S', S'', S'''
HEADING = 3.2  # height of the headings [mm]
AROUND = (14.0, 9.0, 1.0, 7.0)  # the phase portrait, for its names and its title [mm]


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return law_drawing(cam_of(order), order.results["cam_law"])


def law_drawing(task: CamTask, result: LawResult) -> Drawing:
    """Two sheets: four diagrams and the phase portrait; the graphical integration."""
    drawing, (first, second) = sheets(2)
    left, right = headed(drawing, first, _heading(result), HEADING).split(1.6, 1.0, gap=5, across=True)
    draw_laws(drawing, left, task.program, result, range(4), HEIGHTS)
    title = tr("Phase portrait ${ordinate}$(${abscissa}$)", ordinate=symbol(result, 1), abscissa=symbol(result, 0))
    drawing.add(Words(complex(right.inset(*AROUND).middle.real, right.top - 1.0), title, 2.8, 1j))
    draw_portrait(drawing, right.inset(0, 0, 0, AROUND[3]), task, result)
    box = headed(drawing, second, integration_heading(result), HEADING)
    draw_integration(drawing, box, task.program, result, constructed(task.program, INTERVALS))
    return drawing


def _heading(result: LawResult) -> str:
    parts = []
    for each in result.phases:
        if each.constants is not None:
            law = tr_name(each.constants.name)
            parts.append(tr("rise: {law}", law=law) if each.kind == "rise" else tr("return: {law}", law=law))
    size = f"$ψ_m$ = {number(degrees(result.stroke), 5)}°"
    if not result.turns:
        size = f"$h$ = {mm(result.stroke)} {tr_unit('mm')}"
    speed = "" if result.speed is None else f", {number(result.speed * 30 / np.pi, 5)} {tr_unit('rpm')}"
    return tr("Law of motion of the follower, {size}; {laws}", size=size + speed, laws=", ".join(parts))


def draw_portrait(drawing: Drawing, box: Box, task: CamTask, result: LawResult) -> None:
    """S' against S in one unit, of a rocker radians: rise above, return below."""
    scale, pieces = shown_scale(result, 1), pieces_of(task.program)
    curves = [(scale * motion[0] + 1j * scale * motion[1], motion[1, DENSE // 2] >= 0) for _, motion in pieces]
    every = np.concatenate([z for z, _ in curves])
    unit, air = tr_unit("rad" if result.turns else "mm"), 0.14
    ends = [
        (float(v.min()) - air * float(np.ptp(v)), float(v.max()) + air * float(np.ptp(v)))
        for v in (every.real, every.imag)
    ]
    x, y = Axis(f"${symbol(result, 0)}$, {unit}", *ends[0]), Axis(axis_name(result, 1), *ends[1])
    left, bottom, right, _ = AROUND
    frame = box.inset(left, bottom, right, 0)
    if not result.turns:
        x, y = one_scale(frame, x, y)  # an angle of a ray is a pressure angle then
    diagram = Diagram(drawing, frame, x, y)
    diagram.vertical(0.0, MIDDLE)
    diagram.labels.avoid(diagram.paper([complex(x.low), complex(x.high)]), 0.5)
    for z, rising in curves:
        diagram.curve(z, CURVES[0 if rising else 1])
    if len(result.positions.phi) <= DOTTED:
        diagram.dots(scale * result.motion[0], scale * result.motion[1], Pen("POINTS", 0.13, colour=INK))
    for name, end in (("a, d", 0.0), ("b, c", scale * result.stroke)):
        at = diagram.point(complex(end), MIDDLE)
        diagram.labels.put(f"${name}$", [at], height=2.3, prefer=1 + 1j if end else -1 - 1j)
    for each in result.extremes:
        if each.order == 1:
            row = int(np.argmin(np.abs(result.positions.phi - each.phi)))
            at = diagram.place(scale * complex(result.motion[0, row], each.value))
            diagram.labels.put(minus(number(scale * each.value, 4)), [at], height=2.2, prefer=1j * each.value)
