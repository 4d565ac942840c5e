"""The picture of a manipulator: its path with points equally spaced in time, arm, obstacles; joints over the time.

Where the gripper speeds up or slows down the path has one colour, where it moves uniformly another. In space there are
two views, from above and from the side.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure
from matplotlib.patches import Polygon

from tmmcalc.core.numerics.panels import Values
from tmmcalc.manipulators.results import Manipulator
from tmmcalc.manipulators.solve import solve_manipulator
from tmmcalc.manipulators.task import ManipulatorTask, Obstacle
from tmmcalc.report.drawing.curves import bottom, frame
from tmmcalc.report.drawing.labels import Labels
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import blank, settle
from tmmcalc.report.drawing.style import CURVES, INK, MARK, PATH, THIN
from tmmcalc.report.numbers import number

UNIFORM = 2  # number of the phase
SMOOTH = 400  # steps of the curves
ARMS = 5  # places in which the arm is drawn
RAMP: dict[str, Any] = {"color": MARK, "linewidth": 1.8, "zorder": 5}
EVEN: dict[str, Any] = {"color": PATH, "linewidth": 1.8, "zorder": 5}
LIMB: dict[str, Any] = {"color": THIN, "linewidth": 1.4, "zorder": 3, "solid_capstyle": "round"}
DOT: dict[str, Any] = {"markersize": 4.5, "zorder": 6}
ZONE: dict[str, Any] = {"facecolor": "#ececec", "edgecolor": INK, "linewidth": 1.0, "hatch": "///", "zorder": 1}
PHASE: dict[str, Any] = {"color": "#b8b8b8", "linewidth": 0.6, "zorder": 1}


def figure(order: Order) -> Figure:
    """The figure of the stage."""
    from tmmcalc.manipulators.tables.tasks.manipulator import to_manipulator

    return manipulator_figure(to_manipulator(order.spec), order.results["manipulator"])


def manipulator_figure(task: ManipulatorTask, result: Manipulator) -> Figure:
    """A sheet with the path, and one with gripper and joints over the time."""
    figure, (first, second) = blank(2)
    dense = solve_manipulator(replace(task, steps=task.steps * -(-SMOOTH // task.steps)))
    first.suptitle(_heading(result), fontsize=10)
    views = _draw_views(first, task, result, dense)
    _draw_graphs(second, result, dense)
    settle(figure)
    for axes, places in views:
        _name_ends(axes, places)
    return figure


def _heading(result: Manipulator) -> str:
    problem = "inverse problem" if result.inverse else "direct problem"
    kind = f"{result.arm.kind} arm{' on a turning base' if result.arm.spatial else ''}"
    colours = "orange: acceleration and deceleration, blue: uniform motion" if result.inverse else ""
    return f"Manipulator, {kind}, {problem}, T = {number(result.duration, 6)} s\n{colours}"


def _draw_views(
    sheet: SubFigure, task: ManipulatorTask, result: Manipulator, dense: Manipulator
) -> list[tuple[Axes, Values]]:
    """The vertical plane; in space the plan and the vertical plane that turns with the arm."""
    limbs = _limbs(dense)
    if not result.arm.spatial:
        axes = sheet.subplots()
        _draw_view(axes, result, dense, (result.gripper[0], dense.gripper[0]), limbs)
        _draw_zones(axes, task.obstacles)
        _name_axes(axes, "x", "y")
        return [(axes, result.gripper[0])]
    above, side = sheet.subplots(1, 2).tolist()
    plan, reach = ([view(each.gripper[0]) for each in (result, dense)] for view in (_from_above, _from_side))
    _draw_view(above, result, dense, (plan[0], plan[1]), [limb[:2] for limb in limbs])
    _draw_view(side, result, dense, (reach[0], reach[1]), [_turned(limb) for limb in limbs])
    _name_axes(above, "x", "y")
    _name_axes(side, "r", "z")
    _draw_zones(above, task.obstacles)
    above.set_title("from above")
    side.set_title("in the plane of the arm")
    return [(above, plan[0]), (side, reach[0])]


def _from_above(places: Values) -> Values:
    return places[:2]


def _from_side(places: Values) -> Values:
    return np.stack((np.hypot(places[0], places[1]), places[2]))


def _name_axes(axes: Axes, across: str, up: str) -> None:
    axes.set_xlabel(f"${across}$, m")
    axes.set_ylabel(f"${up}$, m")


def _turned(limb: Values) -> Values:
    """Joints of an arm (3, J) in its own vertical plane, r signed by the side of the gripper."""
    along = limb[:2, -1] / (np.hypot(*limb[:2, -1]) or 1.0)
    return np.stack((along @ limb[:2], limb[2]))


def _limbs(result: Manipulator) -> list[Values]:
    """The arm in places equally spaced in time: shoulder, elbow or column, gripper, (D, J) each."""
    rows = sorted({int(np.argmin(np.abs(result.t - t))) for t in np.linspace(0.0, result.duration, ARMS)})
    found = []
    for k in rows:
        hand = result.gripper[0, :, k]
        shoulder = np.zeros_like(hand)
        shoulder[-1] = result.arm.height
        joints = [shoulder, hand]
        if result.elbow is not None:
            joints.insert(1, result.elbow[:, k])
        elif result.arm.kind == "cylindrical":
            joints.insert(1, np.append(shoulder[:-1], hand[-1]))
        found.append(np.array(joints).T)
    return found


def _draw_view(
    axes: Axes, result: Manipulator, dense: Manipulator, places: tuple[Values, Values], limbs: list[Values]
) -> None:
    """Path by phases, points of equal time, the arm."""
    for limb in limbs:
        axes.plot(limb[0], limb[1], **LIMB)
        axes.plot(limb[0, :-1], limb[1, :-1], "o", color=THIN, markersize=3.5, markerfacecolor="white", zorder=4)
    dots, path = places
    even = (dense.phase == UNIFORM) if dense.inverse else np.ones(len(dense.t), bool)
    ends = np.concatenate(([0], np.flatnonzero(np.diff(even)) + 1, [len(even)]))
    for low, high in pairwise(ends.tolist()):
        axes.plot(path[0, low:high], path[1, low:high], **(EVEN if even[low] else RAMP))
    for k, label in enumerate(result.labels):
        if label.isdigit():
            colour = EVEN if result.phase[k] == UNIFORM or not result.inverse else RAMP
            axes.plot(dots[0, k], dots[1, k], "o", color=colour["color"], markerfacecolor="white", **DOT)
    axes.grid(True, linewidth=0.35, color="#d0d0d0", zorder=0)
    axes.set_axisbelow(True)
    axes.axhline(0, color="#333333", linewidth=0.8, zorder=1.5)
    axes.axvline(0, color="#333333", linewidth=0.8, zorder=1.5)
    axes.margins(0.1)
    axes.set_aspect("equal", adjustable="datalim")


def _draw_zones(axes: Axes, obstacles: tuple[Obstacle, ...]) -> None:
    for obstacle in obstacles:
        corners = np.array(obstacle.corners)
        axes.add_patch(Polygon(np.column_stack((corners.real, corners.imag)), closed=True, **ZONE))
        middle = complex(np.mean(corners))
        box = {"facecolor": "white", "edgecolor": "none", "pad": 1.0}
        axes.text(middle.real, middle.imag, obstacle.name, ha="center", va="center", fontsize=7, bbox=box, zorder=2)
        axes.update_datalim(np.column_stack((corners.real, corners.imag)))


def _name_ends(axes: Axes, places: Values) -> None:
    labels = Labels(axes)
    z = places[0] + 1j * places[1]
    labels.avoid(z, 1.0)
    for name, k in (("start", 0), ("end", -1)):
        axes.plot(z[k].real, z[k].imag, "s", markersize=6, color=INK, markerfacecolor="white", zorder=7)
        labels.put(name, [complex(z[k])], size=8, style="italic")


def _draw_graphs(sheet: SubFigure, result: Manipulator, dense: Manipulator) -> None:
    """Gripper on the left, joints on the right: values, rates, accelerations."""
    left, right = sheet.subfigures(1, 2, squeeze=False)[0]
    left.suptitle("Gripper", fontsize=9)
    right.suptitle("Joints", fontsize=9)
    axes = "xyz"[: result.gripper.shape[1]]
    for order, panel in enumerate(_panels(left)):
        unit = ("m", "m/s", "m/s²")[order]
        symbol = ("", "v_", "a_")[order]
        curves = [(f"${symbol}{name}$", row) for name, row in zip(axes, dense.gripper[order], strict=True)]
        _draw_graph(panel, curves, unit, dense)
    for order, panel in enumerate(_panels(right)):
        unit = ("rad or m", "rad/s or m/s", "rad/s² or m/s²")[order]
        dot = ("", "\\dot ", "\\ddot ")[order]
        curves = [(f"${dot}{{{_symbol(name)}}}$", row) for name, row in zip(result.joints, dense.q[order], strict=True)]
        _draw_graph(panel, curves, unit, dense)


def _symbol(name: str) -> str:
    letter, _, index = name.partition("_")
    return {"psi": r"\psi", "phi": r"\varphi"}.get(letter, letter) + (f"_{index}" if index else "")


def _panels(part: SubFigure) -> list[Axes]:
    panels: list[Axes] = part.subplots(3, 1).tolist()
    return panels


def _draw_graph(axes: Axes, curves: list[tuple[str, Values]], unit: str, result: Manipulator) -> None:
    for k, (name, values) in enumerate(curves):
        axes.plot(result.t, values, linewidth=1.3, zorder=4, label=name, **CURVES[k])
    for law in (*(leg.law for leg in result.legs), *result.laws):
        begin = next((leg.begin for leg in result.legs if leg.law is law), 0.0)
        for instant in law.instants:
            axes.axvline(begin + instant, **PHASE)
    span = result.t if len(result.t) > 1 else np.array([0.0, 1.0])
    frame(axes, unit, span, False, 0)
    place: dict[str, Any] = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.0), "ncols": 4}
    axes.legend(handlelength=3, columnspacing=1.2, borderaxespad=0.3, **place)
    bottom([axes], False)
    axes.set_xlabel("$t$, s")
