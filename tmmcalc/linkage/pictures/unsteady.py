"""The picture of the unsteady stage: input, links and outputs over the time, with the jumps of the acceleration."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.unsteady.results import Unsteady
from tmmcalc.linkage.unsteady.solve import solve_unsteady
from tmmcalc.linkage.unsteady.task import UnsteadyTask
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import BELOW, DOTTED, SIDES
from tmmcalc.report.drawing.diagram import ROW, Axis, Diagram, room
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.pens import CURVES, Pen
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number
from tmmcalc.report.sheets.piece import Piece

PHASE = Pen("PHASES", 0.2, colour="#b8b8b8")
SMOOTH = 400  # steps of the curves
SAME = 1e-9  # of the duration: a row of the table


@record
class Graph:
    """Curves of one quantity over the time: label and rows (n,) each."""

    title: str
    curves: tuple[tuple[str, Values], ...]


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
    from tmmcalc.linkage.tables.tasks.unsteady import to_unsteady

    mechanism, task = to_linkage(order.spec.linkage), to_unsteady(order.spec)
    return unsteady_drawing(mechanism, task, order.results["kinematics"], order.results["unsteady"])


def unsteady_drawing(mechanism: Mechanism, task: UnsteadyTask, kinematics: Kinematics, result: Unsteady) -> Drawing:
    """A sheet for the input and the outputs, and one for the links."""
    dense = _dense(mechanism, task, kinematics)
    graphs = [_input(dense), *([_outputs(dense)] if result.outputs else []), *_links(dense)]
    drawing, boxes = sheets((len(graphs) + 1) // 2)
    heading = Words(complex(boxes[0].middle.real, boxes[0].top), _heading(result), 3.0, 1j)
    drawing.add(heading)
    for k, box in enumerate(boxes):
        pair = graphs[2 * k : 2 * k + 2]
        _draw_pair(drawing, box.inset(0, 0, 0, 7.0 if k == 0 else 0.0), pair, dense, result)
    return drawing


def piece_of(order: Order) -> Piece:
    """The input and the outputs, without them the links, side by side over the time."""
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
    from tmmcalc.linkage.tables.tasks.unsteady import to_unsteady

    mechanism, task, result = to_linkage(order.spec.linkage), to_unsteady(order.spec), order.results["unsteady"]
    dense = _dense(mechanism, task, order.results["kinematics"])
    pair = [_input(dense), *([_outputs(dense)] if result.outputs else _links(dense))]
    draw = partial(_draw_pair, pair=pair, dense=dense, result=result)
    return Piece("linkage", tr("Unsteady motion by the time-optimal law"), draw, (150.0, 120.0), (160.0, 150.0))


def _dense(mechanism: Mechanism, task: UnsteadyTask, kinematics: Kinematics) -> Unsteady:
    """The motion at so many rows that curves through them are smooth."""
    return solve_unsteady(mechanism, replace(task, steps=task.steps * -(-SMOOTH // task.steps)), kinematics)


def _draw_pair(
    drawing: Drawing, box: Box, pair: Sequence[tuple[Graph, ...]], dense: Unsteady, result: Unsteady
) -> None:
    """Coordinate, speed and acceleration one under another, of both side by side."""
    for part, graph in zip(box.split(*(1.0 for _ in pair), gap=4, across=True), pair, strict=True):
        drawing.add(Words(complex(part.middle.real, part.top), graph[0].title.split("|")[0], 2.8, 1j))
        frames = part.inset(0, BELOW, 0, 6.0).split(1, 1, 1)
        for row, (frame, each) in enumerate(zip(frames, graph, strict=True)):
            _draw(drawing, frame, each, dense, result, numbered=row == 2)


def _heading(result: Unsteady) -> str:
    law = result.law
    ramp, uniform, total = number(law.ramp, 5), number(law.uniform, 5), number(law.duration, 6)
    return tr(
        "Unsteady motion by the time-optimal law: {ramp} + {uniform} + {ramp} s, $T$ = {total} s",
        ramp=ramp,
        uniform=uniform,
        total=total,
    )


def _input(result: Unsteady) -> tuple[Graph, ...]:
    units = _units(result.turns)
    scale = (_degrees(result.turns), 1.0, 1.0)
    names = ("x", "v", "a")
    return tuple(
        Graph(f"{tr('Input')}|${name}$, {unit}", (("", factor * row),))
        for name, unit, factor, row in zip(names, units, scale, result.drive, strict=True)
    )


def _outputs(result: Unsteady) -> tuple[Graph, ...]:
    """All outputs that have the units of the first."""
    angular = result.angular[0]
    chosen = [k for k, other in enumerate(result.angular) if other == angular]
    graphs = []
    title = tr("Outputs") if len(chosen) > 1 else tr("Output {name}", name=result.outputs[chosen[0]])
    for order, (name, unit) in enumerate(zip(("S", "v", "a"), _units(angular), strict=True)):
        factor = _degrees(angular) if order == 0 else 1.0
        curves = tuple((result.outputs[k], factor * result.coordinate[order, k]) for k in chosen)
        graphs.append(Graph(f"{title}|${name}$, {unit}", curves))
    return tuple(graphs)


def _links(result: Unsteady) -> list[tuple[Graph, ...]]:
    """Angles, omega and eps of all links that turn."""
    moved = result.trace
    turning = [k for k in range(len(moved.link_ids)) if np.ptp(moved.angle[k]) > 0]
    if not turning:
        return []
    rows = (("φ", np.degrees(moved.angle)), ("ω", moved.dangle), ("ε", moved.ddangle))
    return [
        tuple(
            Graph(
                f"{tr('Links')}|${name}$, {unit}",
                tuple((tr("link {number}", number=moved.link_ids[k]), values[k]) for k in turning),
            )
            for (name, values), unit in zip(rows, _units(True), strict=True)
        )
    ]


def _units(angular: bool) -> tuple[str, str, str]:
    one, two, three = ("°", "rad/s", "rad/s²") if angular else ("m", "m/s", "m/s²")
    return tr_unit(one), tr_unit(two), tr_unit(three)


def _degrees(angular: bool) -> float:
    return 180 / np.pi if angular else 1.0


def _draw(drawing: Drawing, box: Box, graph: Graph, dense: Unsteady, result: Unsteady, *, numbered: bool) -> None:
    """Curves over the time with dots at the rows of the table; a jump is the upright line between its two rows."""
    rows = [k for k, t in enumerate(dense.t) if np.min(np.abs(result.t - t)) <= SAME * dense.t[-1]]
    several = len(graph.curves) > 1
    left, bottom, right, top = SIDES
    values = [row for _, row in graph.curves]
    span = (float(dense.t[0]), float(dense.t[-1])) if len(result.t) > 1 else (0.0, 1.0)
    axis = Axis(graph.title.split("|")[1], *room(values))
    frame = box.inset(left, bottom, right, top + (ROW if several else 0.0))
    diagram = Diagram(drawing, frame, Axis(f"$t$, {tr_unit('s')}", *span), axis, numbered=numbered)
    for k, row in enumerate(values):
        pen = CURVES[k % len(CURVES)]
        diagram.curve(dense.t + 1j * row, pen)
        if len(result.t) <= DOTTED:
            diagram.dots(dense.t[rows], row[rows], pen)
    for instant in result.law.instants:
        diagram.vertical(instant, PHASE)
    if several:
        diagram.key([(label, CURVES[k % len(CURVES)]) for k, (label, _) in enumerate(graph.curves)])
