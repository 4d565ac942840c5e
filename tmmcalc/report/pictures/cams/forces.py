"""Pictures of the cam's forces: the spring line over P(dS), forces and torque over the turn; slip and stress."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees, sqrt
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, MaxNLocator

from tmmcalc.cams.forces.course import Course, course_of
from tmmcalc.cams.forces.results import CamForces
from tmmcalc.cams.forces.spring import lifting_force, solve_spring
from tmmcalc.cams.forces.state import pivot_force
from tmmcalc.cams.forces.turn import at_angles, loads_of
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pressure import halved, on_phase
from tmmcalc.cams.strength.kernels import HERTZ
from tmmcalc.cams.strength.results import CamStrength, Rolling
from tmmcalc.cams.strength.work import Case, case_of, contact_square, curved
from tmmcalc.cams.task import CamTask, Loads
from tmmcalc.report.pictures.curves import Diagram, Line, bottom, mark
from tmmcalc.report.pictures.labels import Labels, signed
from tmmcalc.report.pictures.limits import places, with_limits
from tmmcalc.report.pictures.page import blank, settle
from tmmcalc.report.pictures.style import CURVES, INK, MARK, THIN

LIMIT: dict[str, Any] = {"color": MARK, "linewidth": 1.1, "linestyle": (0, (6, 2)), "zorder": 3}
NAMES = {"P_c": "$P_c$", "M_c": "$M_c$", "R": "$R$", "N1": "$N_1$", "N2": "$N_2$", "T": "$T = P_c S'$"}
NOTHING = 1e-12  # of the largest force
DIGITS = 5  # of marked values
HIGHEST, FAR = 3.0, 30.0  # of the slip function in the picture: it grows without end where R goes to 0


def forces_figure(task: CamTask, result: CamForces) -> Figure:
    """One sheet: the force that lifts off and the spring over the lift; forces, reactions, torque over the turn."""
    loads = loads_of(task)
    course = course_of(task, result.follower, loads, result.spring)
    figure, (sheet,) = blank(1)
    sheet.suptitle(_heading(result), fontsize=9)
    left, right = sheet.subfigures(1, 2, squeeze=False, width_ratios=[1.0, 1.55])[0]
    plane = left.subplots(1, 1)
    diagrams = _diagrams(result, course)
    panels = right.subplots(len(diagrams), 1, sharex=True).tolist()
    finish = _draw_spring(plane, task, loads, result)
    for axes, diagram in zip(panels, diagrams, strict=True):
        diagram.draw(axes)
        diagram.legend(axes, 4)
        _phases(axes, result.ends)
        for a, b in result.lost:
            axes.axvspan(degrees(a), degrees(b), color=MARK, alpha=0.15, zorder=0.5)
    bottom(panels, True)
    settle(figure)
    finish()
    for axes, diagram in zip(panels, diagrams, strict=True):
        diagram.label(axes)
    return figure


def _heading(result: CamForces) -> str:
    spring = result.spring
    turns = result.follower.kind == "oscillating"
    unit, factor = ("N·m/rad", 1.0) if turns else ("N/mm", 1e-3)
    force = "N·m" if turns else "N"
    text = f"Forces on the follower at {signed(result.speed, 6)} rad/s"
    if spring.stiffness or spring.preload:
        text += f"; spring {signed(factor * spring.stiffness, 5)} {unit}, preload {signed(spring.preload, 5)} {force}"
    if result.lost:
        text += "\nshaded: nothing presses the follower on the cam"
    return text


def _line(
    label: str, course: Course, values: Values, nodes: Values, style: dict[str, Any], marked: bool = True
) -> Line:
    """A curve with its extremes."""
    shaped = course.shaped(values)
    (low, low_at), (high, high_at) = course.on.extremes(shaped)
    marks = ((low_at, low), (high_at, high)) if marked else ()
    return Line(label, with_limits(course.on, shaped), nodes, style, marks)


def _diagrams(result: CamForces, course: Course) -> list[Diagram]:
    now, turns = course.state, result.follower.kind == "oscillating"
    phi, nodes = places(course.on), result.positions.phi

    def diagram(symbol: str, unit: str, *lines: Line) -> Diagram:
        return Diagram(symbol, unit, True, phi, nodes, lines, DIGITS)

    contact = _line("$R$ of the cam", course, now.contact, result.contact, CURVES[0])
    load = _line(NAMES["M_c" if turns else "P_c"], course, now.load, result.load, CURVES[1])
    found = [diagram("M_c", "N*m", load), diagram("R", "N", contact)] if turns else [diagram("P", "N", load, contact)]
    if result.lower is not None and result.upper is not None:
        side = result.follower.sense
        lower = _line("$N_1$ lower edge", course, side * now.lower, result.lower, CURVES[2])
        upper = _line("$N_2$ upper edge", course, side * now.upper, result.upper, CURVES[3])
        found.append(diagram("N", "N", lower, upper))
    if result.pivot is not None:
        force = pivot_force(result.follower, course.points.motion, now.contact, now.sine, now.cosine)
        lines = [
            _line(f"$R_{{A{axis}}}$", course, force[k], result.pivot[k], CURVES[2 + k]) for k, axis in enumerate("xy")
        ]
        found.append(diagram("R_A", "N", *lines))
    torque = _line("driving torque", course, now.driving, result.driving, CURVES[4])
    plain = _line("$-T$, without friction", course, now.torque, -result.torque, CURVES[7], marked=False)
    return [*found, diagram("M", "N*m", torque, *((plain,) if course.carried.rubs else ()))]


def _draw_spring(axes: Axes, task: CamTask, loads: Loads, result: CamForces) -> Any:
    """P over dS on rise and return and the line of the spring (fig. 5.20); what writes the texts is returned."""
    turns = result.follower.kind == "oscillating"
    factor = degrees(1.0) if turns else 1e3
    spring, letter = result.spring, "M" if turns else "P"
    labels_at: list[np.ndarray] = []
    handles = []
    for kind, style in (("rise", CURVES[0]), ("return", CURVES[1])):
        x, y = _over_lift(task, loads, kind, factor)
        axes.plot(x, y, linewidth=1.4, zorder=4, **style)
        labels_at.append(x + 1j * y)
        handles.append(Line2D([], [], label=f"${letter}$, {kind}", linewidth=1.4, **style))
    end = factor * result.stroke
    lines = [("spring", spring.preload, spring.highest, {**CURVES[2], "linestyle": "-", "linewidth": 1.6})]
    if spring.asked is not None:
        lines.append((f"spring/$K_1$, $K_1$ = {signed(spring.asked, 4)}", spring.preload / spring.asked,
                      spring.highest / spring.asked, {**CURVES[2], "linestyle": "--", "linewidth": 1.0}))  # fmt: skip
    for label, low, high, style in lines if spring.stiffness or spring.preload else ():
        axes.plot([0, end], [low, high], zorder=5, **style)
        labels_at.append(np.array([1j * low, end + 1j * high]))
        handles.append(Line2D([], [], label=label, **style))
    axes.axhline(0, color="#333333", linewidth=0.8, zorder=1.5)
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_xlim(0, end)
    axes.margins(y=0.1)
    axes.set_xlabel("$\\Delta\\psi$, °" if turns else "$\\Delta S$, mm")
    axes.set_ylabel("lifting moment and spring, N·m" if turns else "lifting force $P$ and spring, N")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(8))
        axis.set_major_formatter(FuncFormatter(lambda v, _: signed(v, 6)))
    axes.legend(handles=handles, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=2, handlelength=3)

    def write() -> None:
        labels = Labels(axes)
        for line in labels_at:
            labels.avoid(line, 0.8)
        if spring.lifting is not None and spring.lift is not None:
            mark(axes, labels, complex(factor * spring.lift, spring.lifting), CURVES[0], DIGITS)
            labels.put("M", [complex(factor * spring.lift, spring.lifting)], size=9, prefer=-1 - 1j, color=INK)
        if spring.stiffness or spring.preload:
            mark(axes, labels, complex(0, spring.preload), CURVES[2], DIGITS)
            mark(axes, labels, complex(end, spring.highest), CURVES[2], DIGITS)

    return write


def _over_lift(task: CamTask, loads: Loads, kind: str, factor: float) -> tuple[Values, Values]:
    """dS and P of a phase with both limits at edges."""
    on = halved(halved(task.program.panels))
    at = at_angles(task, loads, on.x.ravel())
    both = np.stack((at.motion[0], lifting_force(task, loads, at.acceleration)))
    part, values = on_phase(task.program, on, both.reshape(2, *on.x.shape), kind)
    lift, force = with_limits(part, values)
    return factor * lift, force


def _phases(axes: Axes, ends: Sequence[float]) -> None:
    for end in ends[1:-1]:
        axes.axvline(degrees(end), color=THIN, linewidth=0.6, zorder=1)


def strength_figure(task: CamTask, result: CamStrength) -> Figure:
    """One sheet over the turn: slip function, contact stress, reduced moment of the shaft, with their limits."""
    loads = loads_of(task)
    case = case_of(task, result.follower, loads, course_of(task, result.follower, loads, solve_spring(task, loads)))
    diagrams = _judged_diagrams(case, result)
    figure, (sheet,) = blank(1)
    sheet.suptitle(
        "Requirements over a turn of the cam" if diagrams else "No data of slip, contact or shaft", fontsize=9
    )
    panels = sheet.subplots(max(len(diagrams), 1), 1, sharex=True, squeeze=False)[:, 0].tolist()
    for axes, (diagram, limit) in zip(panels, diagrams, strict=False):
        diagram.draw(axes, 25)
        _phases(axes, result.ends)
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
    course, needs = case.course, case.needs
    now, (kappa, run) = course.state, curved(case.follower, course.points.motion)
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
        drawn = _drawn_slip(limits(now.contact), limits(run), result.rolling, course.on.count)
        add("D", "", drawn, np.minimum(result.slip, FAR), 1.0)
    if result.stress is not None and needs.width is not None:
        square = np.abs(now.contact) * kappa if case.flat else contact_square(now, kappa, case.follower.roller)
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
