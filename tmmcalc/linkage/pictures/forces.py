"""The picture of the forces stage: reactions over the cycle, hodographs, drive; free bodies on sheets below."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.figure import Figure, SubFigure

from tmmcalc.core.plane import Real
from tmmcalc.linkage.facts.places import speed_text
from tmmcalc.linkage.forces.kinetostatics import Statics
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.loading import Loading
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.pictures.choice import check_positions
from tmmcalc.linkage.pictures.course import DiagramCourse, course_of, statics_of
from tmmcalc.linkage.pictures.cutting import draw_sheet, sheets_of
from tmmcalc.linkage.pictures.hodographs import draw_hodograph, hodographs_of, prepare
from tmmcalc.linkage.results import Extreme, Kinematics
from tmmcalc.report.drawing.curves import Diagram, Line, bottom
from tmmcalc.report.drawing.labels import upright
from tmmcalc.report.drawing.order import POLYGONS, Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES
from tmmcalc.report.numbers import NOISE


def figure(order: Order) -> Figure:
    """The figure of the stage: reactions and drive, and the free bodies in a position that is asked for."""
    from tmmcalc.linkage.tables.tasks.loading import to_loading
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

    result = order.results["forces"]
    mechanism, loading = to_linkage(order.spec.linkage), to_loading(order.spec)
    return forces_figure(mechanism, loading, order.results["kinematics"], result, order.row(POLYGONS, result.labels))


def forces_figure(
    mechanism: Mechanism, loading: Loading, kinematics: Kinematics, result: Forces, marked: int | None
) -> Figure:
    """One sheet, and those of the free bodies in the row ``marked``; raises `UsageError` for one that is not there."""
    check_positions(len(result.labels), [] if marked is None else [marked])
    statics = statics_of(mechanism, loading, kinematics)
    cuts = [] if marked is None else sheets_of(statics, kinematics, result, marked)
    figure, sheets = blank(1 + len(cuts))
    _first_sheet(figure, sheets[0], statics, result)
    for sheet, cut in zip(sheets[1:], cuts, strict=True):
        draw_sheet(sheet, cut)
    return figure


def _first_sheet(figure: Figure, sheet: SubFigure, statics: Statics, result: Forces) -> None:
    chain, course = statics.scene.chain, course_of(statics)
    sheet.suptitle(_heading(result), fontsize=9)
    left, right = sheet.subfigures(1, 2, squeeze=False, width_ratios=[1.0, 1.15])[0]
    upper, lower = right.subfigures(2, 1, squeeze=False, height_ratios=[1.25, 1.0])[:, 0]
    reactions, drives = _reaction_diagrams(statics, result, course), _drive_diagrams(result, course)
    shown = hodographs_of(chain.mechanism, result)
    panels = left.subplots(len(reactions), 1, sharex=True, squeeze=False)[:, 0].tolist()
    lines = lower.subplots(len(drives), 1, sharex=True).tolist()
    polar = upper.subplots(1, len(shown), squeeze=False)[0].tolist() if shown else []
    for axes, diagram in zip([*panels, *lines], [*reactions.values(), *drives], strict=True):
        diagram.draw(axes)
    for axes, (name, diagram) in zip(panels, reactions.items(), strict=True):
        diagram.legend(axes, 4)
        axes.text(1.0, 1.03, name, ha="right", va="bottom", fontsize=8, transform=axes.transAxes)
    bottom(panels, result.turns)
    bottom(lines, result.turns)
    for axes in polar:
        prepare(axes)
    settle(figure)
    for axes, drawn in zip(polar, shown, strict=True):
        draw_hodograph(axes, result, course, drawn, chain.structure.input_link)
    for axes, diagram in zip([*panels, *lines], [*reactions.values(), *drives], strict=True):
        diagram.label(axes)


def _heading(result: Forces) -> str:
    kind = {"coupling": "driven through a coupling", "gear": "driven by a gear", "slider": "driven along the guide"}
    speed = speed_text(result).replace("-", "\N{MINUS SIGN}")
    first = f"Reactions and drive at {speed}, {kind[result.drive_kind]}"
    return f"{first}\n$R_\\mathrm{{A}}$ (1–2): force of link 1 on link 2 in joint A"


def _reaction_diagrams(statics: Statics, result: Forces, course: DiagramCourse) -> dict[str, Diagram]:
    """Sizes of the reactions, one diagram a group; the input joint stands with the first."""
    rows = {pair.joint: j for j, pair in enumerate(result.pairs)}
    structure, first = statics.scene.chain.structure, statics.scene.chain.input_joint.name
    groups = {group.name: (group.outer[0], *group.inner, *group.outer[1:]) for group in structure.groups}
    if not groups:
        groups = {f"I(0,{structure.input_link})": ()}
    found = {}
    for k, (name, joints) in enumerate(groups.items()):
        own = [rows[joint] for joint in dict.fromkeys((first, *joints) if k == 0 else joints)]
        lines = tuple(_size(result, course, j, CURVES[i % len(CURVES)]) for i, j in enumerate(own))
        found[name] = Diagram("|R|", "N", result.turns, course.phi, result.phi, lines)
    return found


def _size(result: Forces, course: DiagramCourse, j: int, style: dict[str, Any]) -> Line:
    pair = result.pairs[j]
    label = f"$R_{{{upright(pair.joint)}}}$ ({pair.links[0]}–{pair.links[1]})"
    seen = pair.force.value > NOISE * max(each.force.value for each in result.pairs)
    marks = (_mark(result, pair.force),) if seen else ()
    return Line(label, np.abs(course.reaction[j]), np.abs(result.reaction[j]), style, marks)


def _drive_diagrams(result: Forces, course: DiagramCourse) -> list[Diagram]:
    """Moment (force) of the drive, and its power."""
    what = ("M_d", "N*m", result.drive, course.drive, result.drive_extremes)
    if not result.turns:
        what = ("F_d", "N", *what[2:])
    power = ("P_d", "W", result.power, course.drive * result.speed, result.power_extremes)
    return [
        Diagram(symbol, unit, result.turns, course.phi, result.phi, (_driven(result, values, nodes, pair, style),))
        for (symbol, unit, nodes, values, pair), style in zip((what, power), CURVES, strict=False)
    ]


def _driven(result: Forces, values: Real, nodes: Real, pair: tuple[Extreme, Extreme], style: dict[str, Any]) -> Line:
    return Line("", values, nodes, {**style, "linestyle": "-"}, tuple(_mark(result, extreme) for extreme in pair))


def _mark(result: Forces, extreme: Extreme) -> tuple[float, float]:
    return math.copysign(extreme.x, result.speed), extreme.value
