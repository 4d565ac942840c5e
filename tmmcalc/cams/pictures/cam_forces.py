"""Pictures of the cam's forces: the spring line over P(dS), forces and torque over the turn."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees

import numpy as np

from tmmcalc.cams.forces.results import CamForces, WireSize
from tmmcalc.cams.forces.spring import lifting_force
from tmmcalc.cams.forces.state import pivot_force
from tmmcalc.cams.forces.turn import at_angles, loads_of
from tmmcalc.cams.forces.turnforces import TurnForces, turn_forces
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pictures.ordered import cam_of
from tmmcalc.cams.pressure.angle import on_phase
from tmmcalc.cams.task import CamTask, Loads
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import Graph, Line, column
from tmmcalc.report.drawing.diagram import ROW, Axis, Diagram, key_rows, room
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.limits import places, with_limits
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import titled
from tmmcalc.report.drawing.pens import CURVES, OTHER, Pen
from tmmcalc.report.drawing.shapes import Drawing
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number

NAMES = {"P_c": "$P_c$", "M_c": "$M_c$", "R": "$R$", "N1": "$N_1$", "N2": "$N_2$", "T": "$T$ = $P_c$$S'$"}
DIGITS = 5  # of marked values
SPRING = CURVES[2]._replace(layer="SPRING", dashes=(), width=0.5)
DIVIDED = CURVES[2]._replace(layer="SPRING_DIVIDED", dashes=(3.0, 1.2), width=0.3)
LOST = "#f8ddcb"  # where nothing presses
SIDES = (14.0, 9.0, 4.0, 6.0)  # room around a frame: left, bottom, right, top [mm]


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return forces_drawing(cam_of(order), order.results["cam_forces"])


def forces_drawing(task: CamTask, result: CamForces) -> Drawing:
    """One sheet: the force that lifts off and the spring over the lift; forces, reactions, torque over the turn."""
    drawing, box = titled(_heading(result), 3.0)
    left, right = box.split(1.0, 1.55, gap=4, across=True)
    if result.spring.sizes:
        left, heights = left.split(1.7, 1.0, gap=3)
        draw_heights(drawing, heights, result.spring.sizes)
    draw_spring(drawing, left, task, loads_of(task), result)
    draw_course(drawing, right, task, result)
    return drawing


def draw_course(drawing: Drawing, box: Box, task: CamTask, result: CamForces) -> None:
    """Forces, reactions and torque over the turn, one under another."""
    course = turn_forces(task, result.follower, loads_of(task), result.spring)
    for diagram in column(drawing, box, _graphs(result, course)):
        phase_ends(diagram, result.ends)
        for a, b in result.lost:
            diagram.band(degrees(a), degrees(b), LOST)


def _heading(result: CamForces) -> str:
    spring = result.spring
    turns = result.follower.kind == "oscillating"
    unit, factor = (tr_unit("N*m/rad"), 1.0) if turns else (tr_unit("N/mm"), 1e-3)
    force = tr_unit("N*m" if turns else "N")
    speed = f"{minus(number(result.speed, 6))} {tr_unit('rad/s')}"
    text = tr("Forces on the follower at {speed}", speed=speed)
    if spring.stiffness or spring.preload:
        stiffness, preload = (minus(number(v, 5)) for v in (factor * spring.stiffness, spring.preload))
        text = tr(
            "Forces on the follower at {speed}; spring {stiffness}, preload {preload}",
            speed=speed,
            stiffness=f"{stiffness} {unit}",
            preload=f"{preload} {force}",
        )
    if result.lost:
        text += "\n" + tr("shaded: nothing presses the follower on the cam")
    return text


def _line(label: str, course: TurnForces, values: Values, nodes: Values, pen: Pen, marked: bool = True) -> Line:
    """A curve with its extremes."""
    shaped = course.shaped(values)
    (low, low_at), (high, high_at) = course.on.extremes(shaped)
    marks = ((low_at, low), (high_at, high)) if marked else ()
    return Line(label, with_limits(course.on, shaped), nodes, pen, marks)


def _graphs(result: CamForces, course: TurnForces) -> list[Graph]:
    now, turns = course.state, result.follower.kind == "oscillating"
    phi, nodes = places(course.on), result.positions.phi

    def graph(symbol: str, unit: str, *lines: Line) -> Graph:
        return Graph(symbol, unit, True, phi, nodes, lines, DIGITS)

    contact = _line(tr("$R$ of the cam"), course, now.contact, result.contact, CURVES[0])
    load = _line(NAMES["M_c" if turns else "P_c"], course, now.load, result.load, CURVES[1])
    found = [graph("M_c", "N*m", load), graph("R", "N", contact)] if turns else [graph("P", "N", load, contact)]
    if result.lower is not None and result.upper is not None:
        side = result.follower.sense
        lower = _line(tr("$N_1$ lower edge"), course, side * now.lower, result.lower, CURVES[2])
        upper = _line(tr("$N_2$ upper edge"), course, side * now.upper, result.upper, CURVES[3])
        found.append(graph("N", "N", lower, upper))
    if result.pivot is not None:
        force = pivot_force(result.follower, course.points.motion, now.contact, now.sine, now.cosine)
        lines = [
            _line(f"$R_{{A{axis}}}$", course, force[k], result.pivot[k], CURVES[2 + k]) for k, axis in enumerate("xy")
        ]
        found.append(graph("R_A", "N", *lines))
    torque = _line(tr("driving torque"), course, now.driving, result.driving, CURVES[4])
    plain = _line(tr("$−T$, without friction"), course, now.torque, -result.torque, CURVES[7], marked=False)
    return [*found, graph("M", "N*m", torque, *((plain,) if course.carried.rubs else ()))]


def draw_heights(drawing: Drawing, box: Box, sizes: Sequence[WireSize]) -> None:
    """Heights of the springs that have the allowed stress, over D/d."""
    index = np.array([each.index for each in sizes])
    curves = [np.array([1e3 * each.free for each in sizes]), np.array([1e3 * each.solid for each in sizes])]
    up = Axis(tr("height of the spring, mm"), *room(curves))
    diagram = Diagram(drawing, box.inset(*SIDES), Axis("$D$/$d$", float(index.min()), float(index.max())), up)
    for values, pen in zip(curves, CURVES, strict=False):
        diagram.curve(index + 1j * values, pen)
    diagram.key([(tr("free"), CURVES[0]), (tr("solid"), CURVES[1])])


def draw_spring(drawing: Drawing, box: Box, task: CamTask, loads: Loads, result: CamForces) -> None:
    """P over dS on rise and return and the line of the spring (fig. 5.20)."""
    turns = result.follower.kind == "oscillating"
    factor = degrees(1.0) if turns else 1e3
    spring, letter, end = result.spring, "M" if turns else "P", factor * result.stroke
    names = f"${letter}$, {tr('rise')}", f"${letter}$, {tr('return')}"
    curves = [(name, *_over_lift(task, loads, kind, factor), CURVES[k])
              for k, (name, kind) in enumerate(zip(names, ("rise", "return"), strict=True))]  # fmt: skip
    lines = [(tr("spring"), 1.0, SPRING)] if spring.stiffness or spring.preload else []
    if lines and spring.asked is not None:
        lines.append((tr("spring/$K_1$, $K_1$ = {safety}", safety=number(spring.asked, 4)), spring.asked, DIVIDED))
    named = [*((name, pen) for name, _, _, pen in curves), *((name, pen) for name, _, pen in lines)]
    frame = box.inset(*SIDES)
    frame = frame.inset(0, 0, 0, ROW * (len(key_rows(named, frame.width)) - 1))
    ends = [np.array([spring.preload, spring.highest]) / by for _, by, _ in lines]
    up = Axis(tr("moment $M$ and spring, N·m") if turns else tr("force $P$ and spring, N"),
              *room([*(y for _, _, y, _ in curves), *ends]))  # fmt: skip
    diagram = Diagram(drawing, frame, Axis("$Δψ$, °" if turns else f"$ΔS$, {tr_unit('mm')}", 0.0, end), up)
    for _, x, y, pen in curves:
        diagram.curve(x + 1j * y, pen)
    for (_, _, pen), heights in zip(lines, ends, strict=True):
        diagram.curve(np.array([0.0, end]) + 1j * heights, pen, level=5)
    diagram.key(named)
    if spring.lifting is not None and spring.lift is not None:
        at = complex(factor * spring.lift, spring.lifting)
        diagram.mark(at, number(at.imag, DIGITS), CURVES[0])
        diagram.labels.put("$M$", [diagram.place(at)], prefer=-1 - 1j, gaps=(0.9, 1.7, 2.8, 4.5, 6.5))
    if lines:
        for at in (1j * spring.preload, complex(end, spring.highest)):
            diagram.mark(at, number(at.imag, DIGITS), CURVES[2])


def _over_lift(task: CamTask, loads: Loads, kind: str, factor: float) -> tuple[Values, Values]:
    """dS and P of a phase with both limits at edges."""
    on = task.program.panels.halved().halved()
    at = at_angles(task, loads, on.x.ravel())
    both = np.stack((at.motion[0], lifting_force(task, loads, at.acceleration)))
    part, values = on_phase(task.program, on, both.reshape(2, *on.x.shape), kind)
    lift, force = with_limits(part, values)
    return factor * lift, force


def phase_ends(diagram: Diagram, ends: Sequence[float]) -> None:
    """Thin lines where the phases end [rad]."""
    for end in ends[1:-1]:
        diagram.vertical(degrees(end), OTHER)
