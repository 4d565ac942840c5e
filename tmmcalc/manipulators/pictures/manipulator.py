"""The picture of a manipulator: its path with points equally spaced in time, arm, obstacles; joints over the time.

Where the gripper speeds up or slows down the path has one colour, where it moves uniformly another. In space there are
two views, from above and from the side.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.manipulators.results import Manipulator
from tmmcalc.manipulators.solve import solve_manipulator
from tmmcalc.manipulators.task import ManipulatorTask, Obstacle
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.field import Board
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.panels import Panel, marked, panels
from tmmcalc.report.drawing.pens import INK, MIDDLE, Pen
from tmmcalc.report.drawing.polar import AROUND, name_axes
from tmmcalc.report.drawing.shapes import Area, Drawing, Hatching, Words
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import number
from tmmcalc.report.sheets.piece import Piece

UNIFORM = 2  # number of the phase
SMOOTH = 400  # steps of the curves
ARMS = 5  # places in which the arm is drawn
MARGIN = 9.0  # free border of the views [mm]
HEADING = 12.0  # room of the heading [mm]
RAMP = Pen("PATH_ACCELERATED", 0.6, colour="#d55e00")
EVEN = Pen("PATH_UNIFORM", 0.6, colour="#0072b2")
LIMB = Pen("ARM", 0.5, colour="#9a9a9a")
ZONE = Pen("OBSTACLES", 0.35)
FILL = "#ececec"


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    from tmmcalc.manipulators.tables.tasks.manipulator import to_manipulator

    return manipulator_drawing(to_manipulator(order.spec), order.results["manipulator"])


def pieces_of(order: Order) -> tuple[Piece, Piece]:
    """The path with the arm and what is in the way; gripper and joints over the time."""
    from tmmcalc.manipulators.tables.tasks.manipulator import to_manipulator

    task, result = to_manipulator(order.spec), order.results["manipulator"]
    dense = _dense(task)

    def views(drawing: Drawing, box: Box) -> None:
        _draw_views(drawing, box, task, result, dense)

    def graphs(drawing: Drawing, box: Box) -> None:
        _draw_graphs(drawing, box, result, dense)

    path = tr("Path of the gripper with points equally spaced in time, the arm")
    return (
        Piece("linkage", path, views, (150.0, 80.0), (160.0, 85.0 if result.arm.spatial else 130.0)),
        Piece("linkage", tr("Gripper and joints over the time"), graphs, (150.0, 120.0), (160.0, 150.0)),
    )


def manipulator_drawing(task: ManipulatorTask, result: Manipulator) -> Drawing:
    """A sheet with the path, and one with gripper and joints over the time."""
    drawing, (first, second) = sheets(2)
    dense = _dense(task)
    drawing.add(Words(complex(first.middle.real, first.top), _heading(result), 3.2, 1j))
    _draw_views(drawing, first.inset(0, 0, 0, HEADING), task, result, dense)
    _draw_graphs(drawing, second, result, dense)
    return drawing


def _dense(task: ManipulatorTask) -> Manipulator:
    """The motion at so many rows that curves through them are smooth."""
    return solve_manipulator(replace(task, steps=task.steps * -(-SMOOTH // task.steps)))


def _heading(result: Manipulator) -> str:
    values = {"arm": _arm(result), "time": number(result.duration, 6)}
    if not result.inverse:
        return tr("Manipulator, {arm}, direct problem, $T$ = {time} s", **values)
    first = tr("Manipulator, {arm}, inverse problem, $T$ = {time} s", **values)
    return first + "\n" + tr("orange: acceleration and deceleration, blue: uniform motion")


def _arm(result: Manipulator) -> str:
    kinds = {
        "spherical": (tr("spherical arm"), tr("spherical arm on a turning base")),
        "cylindrical": (tr("cylindrical arm"), tr("cylindrical arm on a turning base")),
        "angular": (tr("angular arm"), tr("angular arm on a turning base")),
    }
    return kinds[result.arm.kind][result.arm.spatial]


def _draw_views(drawing: Drawing, box: Box, task: ManipulatorTask, result: Manipulator, dense: Manipulator) -> None:
    """The vertical plane; in space the plan and the vertical plane that turns with the arm."""
    limbs = _limbs(dense)
    if not result.arm.spatial:
        places = result.gripper[0], dense.gripper[0]
        _draw_view(drawing, box, ("x", "y"), result, dense, places, limbs, task.obstacles)
        return
    left, right = box.split(1, 1, gap=4, across=True)
    for part, title in ((left, tr("from above")), (right, tr("in the plane of the arm"))):
        drawing.add(Words(complex(part.middle.real, part.top), title, 2.8, 1j))
    plan, reach = ([view(each.gripper[0]) for each in (result, dense)] for view in (_from_above, _from_side))
    above, side = left.inset(0, 0, 0, 6), right.inset(0, 0, 0, 6)
    flat = [limb[:2] for limb in limbs]
    _draw_view(drawing, above, ("x", "y"), result, dense, (plan[0], plan[1]), flat, task.obstacles)
    turned = [_turned(limb) for limb in limbs]
    _draw_view(drawing, side, ("r", "z"), result, dense, (reach[0], reach[1]), turned, ())


def _from_above(places: Values) -> Values:
    return places[:2]


def _from_side(places: Values) -> Values:
    return np.stack((np.hypot(places[0], places[1]), places[2]))


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
    drawing: Drawing,
    box: Box,
    names: tuple[str, str],
    result: Manipulator,
    dense: Manipulator,
    places: tuple[Values, Values],
    limbs: list[Values],
    obstacles: tuple[Obstacle, ...],
) -> None:
    """Path by phases, points of equal time, the arm, what is in the way."""
    dots, path = (row[0] + 1j * row[1] for row in places)
    arms = [limb[0] + 1j * limb[1] for limb in limbs]
    corners = [np.array(obstacle.corners) for obstacle in obstacles]
    content = np.concatenate([path, *arms, *corners])
    board = Board(drawing, box.inset(*AROUND, 1), content, MARGIN)
    name_axes(board, names, float(np.max(np.abs(content))) or 1.0, "m")
    for obstacle, z in zip(obstacles, corners, strict=True):
        outline = board.paper(z)
        drawing.add(Area(outline, FILL, ZONE), Hatching((outline,), pitch=2.5), level=1)
        middle = complex(np.mean(outline))
        drawing.add(Words(middle, obstacle.name, 2.3, clear=True), level=2)
        board.labels.avoid([*outline, outline[0]])
    for arm in arms:
        board.line(arm, LIMB, level=3, weight=0.3)
        for joint in arm[:-1].tolist():
            board.circle(joint, 0.55, LIMB._replace(width=0.25), level=4)
    even = (dense.phase == UNIFORM) if dense.inverse else np.ones(len(dense.t), bool)
    ends = np.concatenate(([0], np.flatnonzero(np.diff(even)) + 1, [len(even)]))
    for low, high in pairwise(ends.tolist()):
        board.line(path[low:high], EVEN if even[low] else RAMP, level=5)
    for k, label in enumerate(result.labels):
        if label.isdigit():
            pen = EVEN if result.phase[k] == UNIFORM or not result.inverse else RAMP
            board.circle(complex(dots[k]), 0.7, pen._replace(width=0.3), level=6)
    for name, k in ((tr("start"), 0), (tr("end"), -1)):
        at = complex(dots[k])
        here = board.place(at)
        square = here + np.array([-1 - 1j, 1 - 1j, 1 + 1j, -1 + 1j])
        drawing.add(Area(square, "#ffffff", MIDDLE._replace(colour=INK)), level=7)
        board.labels.put(name, [here], gaps=(1.8, 2.8, 4.0))


def _draw_graphs(drawing: Drawing, box: Box, result: Manipulator, dense: Manipulator) -> None:
    """Gripper on the left, joints on the right: values, rates, accelerations."""
    left, right = box.split(1, 1, gap=4, across=True)
    axes = "xyz"[: result.gripper.shape[1]]
    gripper = [
        Panel(
            tr_unit(unit),
            tuple((f"${symbol}{name}$", row) for name, row in zip(axes, dense.gripper[order], strict=True)),
        )
        for order, (symbol, unit) in enumerate((("", "m"), ("v_", "m/s"), ("a_", "m/s²")))
    ]
    joints = [
        Panel(unit, tuple((_rate(name, order), row) for name, row in zip(result.joints, values, strict=True)))
        for order, (unit, values) in enumerate(
            zip((tr("rad or m"), tr("rad/s or m/s"), tr("rad/s² or m/s²")), dense.q, strict=True)
        )
    ]
    instants = _instants(result)
    for part, title, rows in ((left, tr("Gripper"), gripper), (right, tr("Joints"), joints)):
        drawing.add(Words(complex(part.middle.real, part.top), title, 3.2, 1j))
        marked(panels(drawing, part.inset(0, 0, 0, 6), dense.t, f"$t$, {tr_unit('s')}", rows), instants)


def _rate(joint: str, order: int) -> str:
    """A joint, or a derivative of it."""
    symbol = f"${_symbol(joint)}$"
    return (symbol, tr("{joint}, first derivative", joint=symbol), tr("{joint}, second derivative", joint=symbol))[
        order
    ]


def _instants(result: Manipulator) -> list[float]:
    """Where phases begin and end."""
    found = []
    for law in (*(leg.law for leg in result.legs), *result.laws):
        begin = next((leg.begin for leg in result.legs if leg.law is law), 0.0)
        found += [begin + instant for instant in law.instants]
    return found


def _symbol(name: str) -> str:
    letter, _, index = name.partition("_")
    return {"psi": "ψ", "phi": "φ"}.get(letter, letter) + (f"_{index}" if index else "")
