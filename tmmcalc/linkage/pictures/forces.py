"""The picture of the forces stage: reactions over the cycle, hodographs, drive; free bodies, levers on sheets below."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.loading import Loading
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.pictures.choice import check_positions
from tmmcalc.linkage.pictures.course import DiagramCourse, course_of, statics_of
from tmmcalc.linkage.pictures.cutting import draw_sheet, sheets_of
from tmmcalc.linkage.pictures.hodographs import draw_hodograph, hodographs_of
from tmmcalc.linkage.pictures.lever import draw_lever
from tmmcalc.linkage.results import Extreme, Kinematics
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import Graph, Line, column
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.order import POLYGONS, Order
from tmmcalc.report.drawing.page import headed, sheets
from tmmcalc.report.drawing.pens import CURVES, Pen
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import NOISE, number

HEADING = 9.0  # room of the heading [mm]


def figure(order: Order) -> Drawing:
    """The drawing of the stage: reactions and drive, free bodies and lever in the positions that are asked for."""
    from tmmcalc.linkage.tables.tasks.loading import to_loading
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    result = order.results["forces"]
    mechanism, loading = to_linkage(order.spec.linkage), to_loading(order.spec)
    return forces_drawing(mechanism, loading, order.results["kinematics"], result, order.rows(POLYGONS, result.labels))


def forces_drawing(
    mechanism: Mechanism, loading: Loading, kinematics: Kinematics, result: Forces, marked: Sequence[int] | None
) -> Drawing:
    """One sheet, and of each row ``marked`` those of the free bodies and the lever.

    Raises `UsageError` for a row that is not there.
    """
    marked = list(dict.fromkeys(marked or ()))
    check_positions(len(result.labels), marked)
    statics = statics_of(mechanism, loading, kinematics)
    cuts = [sheets_of(statics, kinematics, result, row) for row in marked]
    drawing, boxes = sheets(1 + sum(len(each) + 1 for each in cuts))
    _over_the_cycle(drawing, boxes[0], statics, result)
    further = iter(boxes[1:])
    for row, each in zip(marked, cuts, strict=True):
        for cut in each:
            draw_sheet(drawing, next(further), cut)
        box = headed(drawing, next(further), tr("Lever of Zhukovsky"))
        draw_lever(drawing, box, statics, kinematics, result, row)
    return drawing


def _over_the_cycle(drawing: Drawing, box: Box, statics: Statics, result: Forces) -> None:
    chain, course = statics.scene.chain, course_of(statics)
    drawing.add(Words(complex(box.middle.real, box.top), _heading(result), 2.5, 1j))
    left, right = box.inset(0, 0, 0, HEADING).split(1.0, 1.15, gap=4.0, across=True)
    shown = hodographs_of(chain.mechanism, result)
    upper, lower = right.split(1.25, 1.0, gap=2.0) if shown else (None, right)
    column(drawing, left, reaction_graphs(statics, result, course))
    column(drawing, lower, drive_graphs(result, course))
    if upper is not None:
        for part, each in zip(upper.split(*(1.0 for _ in shown), gap=3.0, across=True), shown, strict=True):
            draw_hodograph(drawing, part, result, course, each, chain.structure.input_link)


def _heading(result: Forces) -> str:
    drives = {
        "coupling": tr("driven through a coupling"),
        "gear": tr("driven by a gear"),
        "slider": tr("driven along the guide"),
    }
    drive = drives[result.drive_kind]
    first = tr("Reactions and drive at {speed}, {drive}", speed=_speed(result), drive=drive)
    return f"{first}\n" + tr("$R_A$ (1–2): force of link 1 on link 2 in joint A")


def _speed(result: Forces) -> str:
    if not result.turns:
        return f"{minus(number(result.speed))} {tr_unit('m/s')}"
    rpm = result.speed * 30 / math.pi
    return f"{minus(number(result.speed))} {tr_unit('rad/s')} ({minus(number(rpm))} {tr_unit('rpm')})"


def reaction_graphs(statics: Statics, result: Forces, course: DiagramCourse) -> list[Graph]:
    """Sizes of the reactions, one diagram a group; the input joint stands with the first."""
    rows = {pair.joint: j for j, pair in enumerate(result.pairs)}
    structure, first = statics.scene.chain.structure, statics.scene.chain.input_joint.name
    groups = {group.name: (group.outer[0], *group.inner, *group.outer[1:]) for group in structure.groups}
    if not groups:
        groups = {f"I(0,{structure.input_link})": ()}
    found = []
    for k, (name, joints) in enumerate(groups.items()):
        own = [rows[joint] for joint in dict.fromkeys((first, *joints) if k == 0 else joints)]
        lines = tuple(_size(result, course, j, CURVES[i % len(CURVES)]) for i, j in enumerate(own))
        found.append(Graph("|R|", "N", result.turns, course.phi, result.phi, lines, title=name))
    return found


def _size(result: Forces, course: DiagramCourse, j: int, pen: Pen) -> Line:
    pair = result.pairs[j]
    label = f"$R_{{{pair.joint}}}$ ({pair.links[0]}–{pair.links[1]})"
    seen = pair.force.value > NOISE * max(each.force.value for each in result.pairs)
    marks = (_mark(result, pair.force),) if seen else ()
    return Line(label, np.abs(course.reaction[j]), np.abs(result.reaction[j]), pen, marks)


def drive_graphs(result: Forces, course: DiagramCourse) -> list[Graph]:
    """Moment (force) of the drive, and its power."""
    what = ("M_d", "N*m", result.drive, course.drive, result.drive_extremes)
    if not result.turns:
        what = ("F_d", "N", *what[2:])
    power = ("P_d", "W", result.power, course.drive * result.speed, result.power_extremes)
    return [
        Graph(symbol, unit, result.turns, course.phi, result.phi, (_driven(result, values, nodes, pair, pen),))
        for (symbol, unit, nodes, values, pair), pen in zip((what, power), CURVES, strict=False)
    ]


def _driven(result: Forces, values: Real, nodes: Real, pair: tuple[Extreme, Extreme], pen: Pen) -> Line:
    return Line("", values, nodes, pen._replace(dashes=()), tuple(_mark(result, extreme) for extreme in pair))


def _mark(result: Forces, extreme: Extreme) -> tuple[float, float]:
    return math.copysign(extreme.x, result.speed), extreme.value
