"""The picture of the unsteady stage: input, links and outputs over the time, with the jumps of the acceleration."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.records import record
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.results import Kinematics
from tmmcalc.linkage.unsteady.results import Unsteady
from tmmcalc.linkage.unsteady.solve import solve_unsteady
from tmmcalc.linkage.unsteady.task import UnsteadyTask
from tmmcalc.report.drawing.curves import bottom, frame
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES
from tmmcalc.report.numbers import number

PHASE: dict[str, Any] = {"color": "#b8b8b8", "linewidth": 0.6, "zorder": 1}
SMOOTH = 400  # steps of the curves
SAME = 1e-9  # of the duration: a row of the table
DOTTED = 72  # more rows than this are not marked one by one


@record
class Graph:
    """Curves of one quantity over the time: label and rows (n,) each."""

    title: str
    curves: tuple[tuple[str, Values], ...]


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    from tmmcalc.linkage.tables.tasks.mechanism import to_linkage
    from tmmcalc.linkage.tables.tasks.unsteady import to_unsteady

    mechanism, task = to_linkage(order.spec.linkage), to_unsteady(order.spec)
    return unsteady_figure(mechanism, task, order.results["kinematics"], order.results["unsteady"])


def unsteady_figure(mechanism: Mechanism, task: UnsteadyTask, kinematics: Kinematics, result: Unsteady) -> Figure:
    """A sheet for the input and the outputs, and one for the links."""
    dense = solve_unsteady(mechanism, replace(task, steps=task.steps * -(-SMOOTH // task.steps)), kinematics)
    graphs = [_input(dense), *([_outputs(dense)] if result.outputs else []), *_links(dense)]
    figure, sheets = blank((len(graphs) + 1) // 2)
    for k, sheet in enumerate(sheets):
        pair = graphs[2 * k : 2 * k + 2]
        sheet.suptitle(_heading(result) if k == 0 else "", fontsize=10)
        for part, graph in zip(sheet.subfigures(1, len(pair), squeeze=False)[0], pair, strict=True):
            panels = part.subplots(3, 1).tolist()
            part.suptitle(graph[0].title.split("|")[0], fontsize=9)
            for axes, each in zip(panels, graph, strict=True):
                _draw(axes, each, dense, result)
            bottom(panels, False)
            panels[-1].set_xlabel("$t$, s")
    settle(figure)
    return figure


def _heading(result: Unsteady) -> str:
    law = result.law
    times = f"{number(law.ramp, 5)} + {number(law.uniform, 5)} + {number(law.ramp, 5)} s"
    return f"Unsteady motion by the time-optimal law: {times}, T = {number(law.duration, 6)} s"


def _input(result: Unsteady) -> tuple[Graph, ...]:
    units = _units(result.turns)
    scale = (_degrees(result.turns), 1.0, 1.0)
    names = ("x", "v", "a")
    return tuple(
        Graph(f"Input|${name}$, {unit}", (("input", factor * row),))
        for name, unit, factor, row in zip(names, units, scale, result.drive, strict=True)
    )


def _outputs(result: Unsteady) -> tuple[Graph, ...]:
    """All outputs that have the units of the first."""
    angular = result.angular[0]
    chosen = [k for k, other in enumerate(result.angular) if other == angular]
    graphs = []
    title = "Outputs" if len(chosen) > 1 else f"Output {result.outputs[chosen[0]]}"
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
    rows = ((r"\varphi", np.degrees(moved.angle)), (r"\omega", moved.dangle), (r"\varepsilon", moved.ddangle))
    return [
        tuple(
            Graph(f"Links|${name}$, {unit}", tuple((f"link {moved.link_ids[k]}", values[k]) for k in turning))
            for (name, values), unit in zip(rows, _units(True), strict=True)
        )
    ]


def _units(angular: bool) -> tuple[str, str, str]:
    return ("°", "rad/s", "rad/s²") if angular else ("m", "m/s", "m/s²")


def _degrees(angular: bool) -> float:
    return 180 / np.pi if angular else 1.0


def _draw(axes: Axes, graph: Graph, dense: Unsteady, result: Unsteady) -> None:
    """Curves over the time with dots at the rows of the table; a jump is the upright line between its two rows."""
    rows = [k for k, t in enumerate(dense.t) if np.min(np.abs(result.t - t)) <= SAME * dense.t[-1]]
    for k, (label, values) in enumerate(graph.curves):
        style = CURVES[k % len(CURVES)]
        axes.plot(dense.t, values, linewidth=1.3, zorder=4, label=label, **style)
        if len(result.t) <= DOTTED:
            axes.plot(dense.t[rows], values[rows], "o", markersize=2.2, color=style["color"], zorder=5, linestyle="")
    for instant in result.law.instants:
        axes.axvline(instant, **PHASE)
    span = result.t if len(result.t) > 1 else np.array([0.0, 1.0])
    frame(axes, graph.title.split("|")[1], span, False, 0)
    if len(graph.curves) > 1:
        place: dict[str, Any] = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.0), "ncols": 6}
        axes.legend(handlelength=3, columnspacing=1.2, borderaxespad=0.3, **place)
