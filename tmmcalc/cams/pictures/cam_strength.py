"""The picture of the requirements over the turn: slip function, contact stress, moment of the shaft; limits."""

from __future__ import annotations

from math import degrees, sqrt
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tmmcalc.cams.forces.spring import solve_spring
from tmmcalc.cams.forces.turn import loads_of
from tmmcalc.cams.forces.turnforces import turn_forces
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pictures.cam_forces import DIGITS, phase_ends
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.strength.case import Case, case_of
from tmmcalc.cams.strength.formulas import HERTZ
from tmmcalc.cams.strength.results import CamStrength, Rolling
from tmmcalc.cams.task import CamTask
from tmmcalc.report.drawing.curves import Diagram, Line, bottom
from tmmcalc.report.drawing.labels import Labels, signed
from tmmcalc.report.drawing.limits import places, with_limits
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES, MARK

LIMIT: dict[str, Any] = {"color": MARK, "linewidth": 1.1, "linestyle": (0, (6, 2)), "zorder": 3}
NOTHING = 1e-12  # of the largest force
HIGHEST, FAR = 3.0, 30.0  # of the slip function in the picture: it grows without end where R goes to 0


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return strength_figure(cam_of(order), order.results["cam_strength"])


def strength_figure(task: CamTask, result: CamStrength) -> Figure:
    """One sheet over the turn: slip function, contact stress, reduced moment of the shaft, with their limits."""
    loads = loads_of(task)
    case = case_of(task, result.follower, loads, turn_forces(task, result.follower, loads, solve_spring(task, loads)))
    diagrams = _judged_diagrams(case, result)
    figure, (sheet,) = blank(1)
    sheet.suptitle(
        "Requirements over a turn of the cam" if diagrams else "No data of slip, contact or shaft", fontsize=9
    )
    panels = sheet.subplots(max(len(diagrams), 1), 1, sharex=True, squeeze=False)[:, 0].tolist()
    for axes, (diagram, limit) in zip(panels, diagrams, strict=False):
        diagram.draw(axes, 25)
        phase_ends(axes, result.ends)
        factor, _ = diagram.scale
        if limit is not None:
            axes.axhline(limit * factor, **LIMIT)
            axes.set_ylim(0, 1.15 * max(axes.get_ylim()[1] / 1.15, limit * factor))
        if diagram.symbol == "D":
            axes.set_ylim(0, min(axes.get_ylim()[1], HIGHEST))
            axes.set_ylabel("$D$")
        for a, b in result.rolling.slipping if diagram.symbol == "D" and result.rolling else ():
            axes.axvspan(degrees(a), degrees(b), color=MARK, alpha=0.15, zorder=0.5)
    if diagrams:
        bottom(panels, True)
    settle(figure)
    for axes, (diagram, limit) in zip(panels, diagrams, strict=False):
        _label_judged(axes, diagram, limit)
    return figure


def _label_judged(axes: Axes, diagram: Diagram, limit: float | None) -> None:
    diagram.label(axes)
    if limit is not None:
        labels, (factor, unit) = Labels(axes), diagram.scale
        ends = [complex(x, limit * factor) for x in axes.get_xlim()]
        labels.avoid(ends, 2.0)
        labels.put(f"limit {signed(limit * factor, 5)} {unit}", ends[1:], size=7.5, prefer=-1 + 1j, color=MARK)


def _judged_diagrams(case: Case, result: CamStrength) -> list[tuple[Diagram, float | None]]:
    """Slip, contact stress and M_E as far as their data is there, each with its limit."""
    course, needs = case.course, case.task.requirements
    now = course.state
    phi, nodes = places(course.on), result.positions.phi
    found: list[tuple[Diagram, float | None]] = []

    def limits(values: Values) -> Values:
        return with_limits(course.on, course.shaped(values))

    def add(
        symbol: str, unit: str, values: Values, at: Values, limit: float | None, *marks: tuple[float, float]
    ) -> None:
        line = Line("", values, at, {**CURVES[len(found)], "linestyle": "-"}, marks)
        found.append((Diagram(symbol, unit, True, phi, nodes, (line,), DIGITS), limit))

    if result.slip is not None and result.rolling is not None:
        drawn = _drawn_slip(limits(now.contact), limits(case.run), result.rolling, course.on.count)
        add("D", "", drawn, np.minimum(result.slip, FAR), 1.0)
    if result.stress is not None and needs.width is not None:
        square = case.stress_square
        factor, top = 1e-6 * HERTZ * sqrt(needs.modulus / needs.width), case.over(square)
        stress = factor * np.sqrt(np.maximum(limits(square), 0.0))
        limit = None if needs.contact is None else 1e-6 * needs.contact
        peak = (top.largest_phi, factor * sqrt(top.largest))
        add("\\sigma_H", "MPa", stress, 1e-6 * result.stress, limit, peak)
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
