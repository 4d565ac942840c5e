"""The picture of a flat-faced follower: the radius S0 + F with what convexity asks (figure 5.34), the contact on it."""

from __future__ import annotations

from math import degrees

import numpy as np

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.pictures.wording import mm
from tmmcalc.cams.pictures.zone import LIMIT
from tmmcalc.cams.synthesis.results import Convexity
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import input_axis, stacked
from tmmcalc.report.drawing.diagram import Axis, Diagram, room
from tmmcalc.report.drawing.limits import places, with_limits
from tmmcalc.report.drawing.pens import AXIS, CURVES, INK
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr
from tmmcalc.report.numbers import number

FORBIDDEN = "#fae5d9"
START = AXIS._replace(colour=INK)


def draw_convexity(drawing: Drawing, box: Box, task: CamTask, found: Convexity, follower: Follower) -> None:
    """Two diagrams: radius of the profile and of what it is made; place of the contact on the face."""
    upper, lower = stacked(box, [0, 0], [1.8, 1.0])
    dense = task.program.panels.halved()
    y, y1, y2, _ = (with_limits(dense, row.reshape(dense.x.shape)) for row in task.program.at(dense.x.ravel()))
    phi, rho = np.degrees(places(dense)), 1e3 * (follower.start + y + y2)
    along = input_axis(True, phi)
    low = min(0.0, 1.15 * float(rho.min())) - 0.03 * float(rho.max())
    up = Axis(tr("radius of the profile $ρ = S_0 + F$, mm"), low, 1.12 * float(rho.max()))
    diagram = Diagram(drawing, upper, along, up, numbered=False)
    corners = [0j, along.high + 0j, complex(along.high, 1e3 * found.limit), 1e3j * found.limit]
    diagram.filled(np.array(corners), FORBIDDEN)
    diagram.level(1e3 * follower.start, START)
    diagram.level(1e3 * found.limit, LIMIT)
    diagram.curve(phi + 1j * rho, CURVES[0])
    at = complex(degrees(found.least.phi), 1e3 * found.radius)
    diagram.mark(at, number(at.imag, 6), CURVES[0])
    diagram.name_level(1e3 * follower.start, f"$S_0$ = {mm(follower.start, 6)}", INK)
    text = f"$r_m$ = {mm(found.limit)}: $S_0 ≥ r_m − F_{{min}}$ = {mm(found.needed, 6)}"
    diagram.name_level(1e3 * found.limit, text, LIMIT.colour)
    place = -follower.sense * 1e3 * y1  # the contact stands to the left on the rise of a clockwise cam
    reaches = np.array([-1e3 * found.left, 1e3 * found.right])
    name = tr("contact, mm (> 0: right)")
    diagram = Diagram(drawing, lower, along, Axis(name, *room([place, reaches], 0.2, 0.2)))
    for reach in reaches.tolist():
        diagram.level(reach, LIMIT)
    diagram.curve(phi + 1j * place, CURVES[2])
    diagram.name_level(reaches[0], tr("left {reach}", reach=mm(found.left, 6)), LIMIT.colour)
    diagram.name_level(reaches[1], tr("right {reach}", reach=mm(found.right, 6)), LIMIT.colour)
