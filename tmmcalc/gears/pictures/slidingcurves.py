"""Specific sliding and pressure over the line of action (Fig. 4.24), under the mesh that they belong to.

The abscissa is the projection of the line of action on paper, so every point stands below its place in the mesh.
Outside of the contact A2A1 the curves are dashed; zones where two pairs of teeth touch are shaded.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.core.records import record
from tmmcalc.gears.involute.quality.sliding import slide
from tmmcalc.gears.meshing.results import MeshPair
from tmmcalc.gears.pictures.placedpair import Mark, PlacedPair, point_sign
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Axis, Diagram
from tmmcalc.report.drawing.pens import CURVES, Pen
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr

SAMPLES = 1201
NEAR = 1e-6  # of the length, between N1 or N2 and the curves
LOWEST, DEEPEST = -2.0, -8.0  # ends of the ordinate of theta
ROOM = 1.25  # of the ordinate over the values of the contact
BEYOND = 1.15  # where there is no N2: how far the curves go, in parts of N1A1
DOUBLE = "#eaf3ea"
GUIDE = Pen("PLACES", 0.18, (1.6, 1.0), "#7a7a7a")
SLIDING = tuple(CURVES[k - 1]._replace(layer=f"SLIDING_{k}", width=0.6) for k in (1, 2))
PRESSURE = Pen("PRESSURE", 0.6, (), CURVES[2].colour)
DASHES = (1.4, 1.0)  # outside of the contact
HEIGHT, ROW = 2.5, 3.7  # of the names of points and of their rows [mm]
ROWS = 3
APART = 5.5  # names in a row [mm]


@record
class Course:
    """n points of the line of action."""

    rho1: Real  # (n,) [m]
    theta1: Real  # (n,)
    theta2: Real  # (n,)
    pressure: Real  # (n,) lambda


def course(found: MeshPair, rho1: Real) -> Course:
    """Sliding and pressure at distances (n,) from N1, none of them at N1 or N2 (4.71, 4.72)."""
    module, g = found.task.module, found.line.length
    if found.task.kind == "rack":
        pitch = found.line.pitch
        return Course(rho1, 1 - pitch / rho1, 1 - rho1 / pitch, module / rho1)
    rho2 = np.abs(g - rho1)
    theta1, theta2 = slide(rho1, rho2, found.task.teeth[1] / found.task.teeth[0])
    return Course(rho1, theta1, theta2, module * abs(g) / (rho1 * rho2))


def draw_course(drawing: Drawing, boxes: tuple[Box, Box], pair: PlacedPair, limits: tuple[float, float]) -> None:
    """theta in the upper rectangle and lambda in the lower one; ``limits`` are those of the mesh in x [m]."""
    found = pair.found
    line = found.line
    end = line.length if line.length > 0 else BEYOND * line.end
    # close to each other where the curves are steep, at N1 and N2 and where the picture begins
    left, right = (float((x - pair.base_point.real) / pair.direction.real) for x in limits)
    high = min(end, max(left, right, line.end))
    rho = high * (NEAR + (1 - 2 * NEAR) * np.sin(np.pi / 2 * np.linspace(0, 1, SAMPLES)) ** 2)
    within = np.clip([line.begins, line.ends], rho[0], rho[-1])
    points = course(found, np.sort(np.concatenate([rho, within])))
    contact = course(found, within)
    along = Axis(
        tr("$ρ_1 = N_1K$, mm; the contact moves from $A_2$ to $A_1$ when wheel 1 drives"), 1e3 * left, 1e3 * right
    )
    deepest = min(LOWEST, ROOM * min(float(contact.theta1.min()), float(contact.theta2.min())))
    largest = max(2.0 * float(contact.pressure.min()), min(ROOM * float(contact.pressure.max()), 4.0))
    theta = Axis(tr("specific sliding $θ$"), max(deepest, DEEPEST), 1.25)
    upper = Diagram(drawing, boxes[0], along, theta, numbered=False)
    lower = Diagram(drawing, boxes[1], along, Axis(tr("specific pressure $λ$"), 0.0, largest))
    for diagram in (upper, lower):
        _places(diagram, pair)
    for values, pen in ((points.theta1, SLIDING[0]), (points.theta2, SLIDING[1])):
        _curve(upper, points.rho1, values, within, pen)
    _curve(lower, points.rho1, points.pressure, within, PRESSURE)
    rows = _name_marks(upper, pair)
    outside = SLIDING[0]._replace(layer="BEYOND_CONTACT", dashes=DASHES, width=0.3, colour="#6b6b6b")
    names = [("$θ_1$", SLIDING[0]), ("$θ_2$", SLIDING[1]), (tr("beyond the contact"), outside)]
    upper.key(names, lift=2.0 + ROW * rows)
    lower.key([("$λ$", PRESSURE)])


def singles(pair: PlacedPair) -> list[tuple[str, float]]:
    """B2 and B1 with their distances from N1, between which one pair of teeth touches alone; none: never."""
    line = pair.found.line
    double = line.ends - line.begins - pair.pitch
    return [("B2", line.begins + double), ("B1", line.ends - double)] if 0 < double < pair.pitch else []


def _curve(diagram: Diagram, rho: Real, values: Real, within: Real, pen: Pen) -> None:
    """A curve, dashed outside of the contact, with dots at its ends."""
    dashes = (*DASHES, 0.4, 1.0) if pen.dashes else DASHES
    beyond = pen._replace(layer=f"{pen.layer}_BEYOND", width=0.3, dashes=dashes)
    z = 1e3 * rho + 1j * values
    before, active, after = rho <= within[0], (rho >= within[0]) & (rho <= within[1]), rho >= within[1]
    for part in (before, after):
        diagram.curve(z[part], beyond)
    diagram.curve(z[active], pen, level=5)
    ends = z[active][[0, -1]]
    seen = ends[(ends.imag >= diagram.y.low) & (ends.imag <= diagram.y.high)]
    diagram.dots(seen.real, seen.imag, pen, 0.6)


def _places(diagram: Diagram, pair: PlacedPair) -> None:
    """The points of the line of action, and where two pairs of teeth touch."""
    for mark in pair.marks:
        diagram.vertical(1e3 * mark.rho, GUIDE)
    line, alone = pair.found.line, singles(pair)
    if alone:
        (_, second), (_, first) = alone
        for start, end in ((line.begins, second), (first, line.ends)):
            diagram.band(1e3 * start, 1e3 * end, DOUBLE)


def _name_marks(diagram: Diagram, pair: PlacedPair) -> int:
    """Names of the points above the diagram, those that stand too near one another in more rows; how many rows."""
    marks = [*pair.marks, *(Mark(name, rho, complex(pair.on_line(rho))) for name, rho in singles(pair))]
    last = [float("-inf")] * ROWS
    used = 0
    places = [(diagram.place(complex(1e3 * mark.rho, 0.0)).real, mark.name) for mark in marks]
    for x, name in sorted(place for place in places if diagram.box.left < place[0] < diagram.box.right):
        row = next((k for k, before in enumerate(last) if x - before > APART), ROWS - 1)
        last[row], used = x, max(used, row + 1)
        at = complex(x, diagram.box.top + 1.2 + ROW * row)
        diagram.drawing.add(Words(at, point_sign(name), HEIGHT, -1j))
    return used
