"""Pictures of the cam's forces: the spring line over P(dS), forces and torque over the turn."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, MaxNLocator

from tmmcalc.cams.forces.results import CamForces, WireSize
from tmmcalc.cams.forces.spring import lifting_force
from tmmcalc.cams.forces.state import pivot_force
from tmmcalc.cams.forces.turn import at_angles, loads_of
from tmmcalc.cams.forces.turnforces import TurnForces, turn_forces
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.pressure.angle import on_phase
from tmmcalc.cams.task import CamTask, Loads
from tmmcalc.report.drawing.axes import diagram
from tmmcalc.report.drawing.curves import Diagram, Line, bottom, mark
from tmmcalc.report.drawing.labels import Labels, signed
from tmmcalc.report.drawing.limits import places, with_limits
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES, INK, MARK, THIN

NAMES = {"P_c": "$P_c$", "M_c": "$M_c$", "R": "$R$", "N1": "$N_1$", "N2": "$N_2$", "T": "$T = P_c S'$"}
DIGITS = 5  # of marked values


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    return forces_figure(cam_of(order), order.results["cam_forces"])


def forces_figure(task: CamTask, result: CamForces) -> Figure:
    """One sheet: the force that lifts off and the spring over the lift; forces, reactions, torque over the turn."""
    loads = loads_of(task)
    course = turn_forces(task, result.follower, loads, result.spring)
    figure, (sheet,) = blank(1)
    sheet.suptitle(_heading(result), fontsize=9)
    left, right = sheet.subfigures(1, 2, squeeze=False, width_ratios=[1.0, 1.55])[0]
    if result.spring.sizes:
        plane, heights = left.subplots(2, 1, height_ratios=[1.7, 1.0])
        _draw_heights(heights, result.spring.sizes)
    else:
        plane = left.subplots(1, 1)
    diagrams = _diagrams(result, course)
    panels = right.subplots(len(diagrams), 1, sharex=True).tolist()
    finish = _draw_spring(plane, task, loads, result)
    for axes, each in zip(panels, diagrams, strict=True):
        each.draw(axes)
        each.legend(axes, 4)
        phase_ends(axes, result.ends)
        for a, b in result.lost:
            axes.axvspan(degrees(a), degrees(b), color=MARK, alpha=0.15, zorder=0.5)
    bottom(panels, True)
    settle(figure)
    finish()
    for axes, each in zip(panels, diagrams, strict=True):
        each.label(axes)
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
    label: str, course: TurnForces, values: Values, nodes: Values, style: dict[str, Any], marked: bool = True
) -> Line:
    """A curve with its extremes."""
    shaped = course.shaped(values)
    (low, low_at), (high, high_at) = course.on.extremes(shaped)
    marks = ((low_at, low), (high_at, high)) if marked else ()
    return Line(label, with_limits(course.on, shaped), nodes, style, marks)


def _diagrams(result: CamForces, course: TurnForces) -> list[Diagram]:
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


def _draw_heights(axes: Axes, sizes: Sequence[WireSize]) -> None:
    """Heights of the springs that have the allowed stress, over D/d."""
    index = np.array([each.index for each in sizes])
    lines = [("free", np.array([1e3 * each.free for each in sizes]))]
    lines += [("solid", np.array([1e3 * each.solid for each in sizes]))]
    diagram(axes, index, lines, "height of the spring, mm")
    axes.set_ylim(bottom=0)
    axes.set_xlabel("$D/d$")


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
    on = task.program.panels.halved().halved()
    at = at_angles(task, loads, on.x.ravel())
    both = np.stack((at.motion[0], lifting_force(task, loads, at.acceleration)))
    part, values = on_phase(task.program, on, both.reshape(2, *on.x.shape), kind)
    lift, force = with_limits(part, values)
    return factor * lift, force


def phase_ends(axes: Axes, ends: Sequence[float]) -> None:
    """Thin lines where the phases end [rad]."""
    for end in ends[1:-1]:
        axes.axvline(degrees(end), color=THIN, linewidth=0.6, zorder=1)
