"""The picture of the requirements over the turn: slip function, contact stress, moment of the shaft; limits."""

from __future__ import annotations

from math import degrees, sqrt

import numpy as np

from tmmcalc.cams.forces.spring import solve_spring
from tmmcalc.cams.forces.turn import loads_of
from tmmcalc.cams.forces.turnforces import turn_forces
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pictures.cam_forces import DIGITS, LOST, phase_ends
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.pictures.zone import LIMIT
from tmmcalc.cams.strength.case import Case, case_of
from tmmcalc.cams.strength.formulas import HERTZ
from tmmcalc.cams.strength.results import CamStrength, Rolling
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import Graph, Line, column, suited
from tmmcalc.report.drawing.diagram import room
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.limits import places, with_limits
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import titled
from tmmcalc.report.drawing.pens import CURVES
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr
from tmmcalc.report.numbers import number

NOTHING = 1e-12  # of the largest force
HIGHEST, FAR = 3.0, 30.0  # of the slip function in the picture: it grows without end where R goes to 0


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return strength_drawing(cam_of(order), order.results["cam_strength"])


def strength_drawing(task: CamTask, result: CamStrength) -> Drawing:
    """One sheet over the turn: slip function, contact stress, reduced moment of the shaft, with their limits."""
    known = any(each is not None for each in (result.slip, result.stress, result.reduced))
    heading = tr("Requirements over a turn of the cam") if known else tr("No data of slip, contact or shaft")
    drawing, box = titled(heading, 3.2)
    draw_requirements(drawing, box, task, result)
    return drawing


def draw_requirements(drawing: Drawing, box: Box, task: CamTask, result: CamStrength) -> None:
    """Slip function, contact stress and reduced moment over the turn, one under another; those that have data."""
    loads = loads_of(task)
    case = case_of(task, result.follower, loads, turn_forces(task, result.follower, loads, solve_spring(task, loads)))
    graphs = _graphs(case, result)
    for graph, diagram in zip(graphs, column(drawing, box, graphs) if graphs else (), strict=True):
        phase_ends(diagram, result.ends)
        for a, b in result.rolling.slipping if graph.symbol == "D" and result.rolling else ():
            diagram.band(degrees(a), degrees(b), LOST)


def _graphs(case: Case, result: CamStrength) -> list[Graph]:
    """Slip, contact stress and M_E as far as their data is there, each with its limit."""
    course, needs = case.course, case.task.requirements
    now = course.state
    phi, nodes = places(course.on), result.positions.phi
    found: list[Graph] = []

    def limits(values: Values) -> Values:
        return with_limits(course.on, course.shaped(values))

    def add(
        symbol: str, unit: str, values: Values, at: Values, limit: float | None, *marks: tuple[float, float]
    ) -> None:
        line = Line("", values, at, CURVES[len(found)]._replace(dashes=()), marks)
        low, high = room([values, np.array([limit or 0.0])])
        factor, shown = suited(float(np.max(np.abs(values))), unit)
        name = ""
        if limit is not None:
            name = tr("limit {limit}", limit=f"{minus(number(factor * limit, 5))} {shown}".rstrip())
        levels = () if limit is None else ((limit, LIMIT, name),)
        ends = (low, min(high, HIGHEST) if symbol == "D" else high)
        found.append(Graph(symbol, unit, True, phi, nodes, (line,), DIGITS, ends=ends, levels=levels))

    if result.slip is not None and result.rolling is not None:
        drawn = _drawn_slip(limits(now.contact), limits(case.run), result.rolling, course.on.count)
        add("D", "", drawn, np.minimum(result.slip, FAR), 1.0)
    if result.stress is not None and needs.width is not None:
        square = case.stress_square
        factor, top = 1e-6 * HERTZ * sqrt(needs.modulus / needs.width), case.over(square)
        stress = factor * np.sqrt(np.maximum(limits(square), 0.0))
        limit = None if needs.contact is None else 1e-6 * needs.contact
        peak = (top.largest_phi, factor * sqrt(top.largest))
        add("σ_H", "MPa", stress, 1e-6 * result.stress, limit, peak)
    if result.reduced is not None and needs.span is not None:
        square = (now.contact * (needs.span / 4)) ** 2 + needs.torsion * now.torque**2
        top = case.over(square)
        moment = np.sqrt(np.maximum(limits(square), 0.0))
        add("M_E", "N*m", moment, result.reduced, None, (top.largest_phi, sqrt(top.largest)))
    return found


def _drawn_slip(contact: Values, run: Values, rolling: Rolling, count: int) -> Values:
    """D for the eye: none where nothing presses, cut off where R passes zero."""
    size = np.abs(contact).reshape(count, -1)
    none = size <= NOTHING * np.max(size)
    grown = np.abs(rolling.resisting + rolling.driving * run.reshape(count, -1) / np.where(none, 1.0, size))
    for edge, near in ((0, 1), (-1, -2)):  # at an edge where R is 0 the next point tells: a pole, or not
        grown[:, edge] = np.where(none[:, edge], grown[:, near], grown[:, edge])
    idle = none.all(axis=1)[:, None]
    return np.where(idle, 0.0, np.minimum(grown, FAR)).ravel()
