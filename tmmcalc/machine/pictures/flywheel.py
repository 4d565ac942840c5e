"""The picture of the flywheel stage: energy-mass curve with its tangents, work over the cycle, methods, search."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.machine.facts.flywheel import called
from tmmcalc.machine.facts.motion import unevenness
from tmmcalc.machine.flywheel.results import Flywheel, RequiredInertia, Row, Trial
from tmmcalc.machine.flywheel.wittenbauer import EnergyMass
from tmmcalc.machine.pictures.energymass import draw_energy_mass
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import BELOW, SIDES, Graph, Line, column
from tmmcalc.report.drawing.diagram import HEIGHT, ROW, Axis, Diagram, key_above, key_rows, ticks, written
from tmmcalc.report.drawing.lettering import minus, width
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.pens import AXIS, CURVES, GRID, THIN, Pen
from tmmcalc.report.drawing.shapes import Area, Drawing, Words
from tmmcalc.report.numbers import number

NEEDED = Pen("NEEDED", 0.45, (3.0, 1.2), "#d55e00")
AT_HAND = Pen("AT_HAND", 0.45, (0.9, 0.9), "#6b6b6b")
ALLOWED = AXIS._replace(layer="ALLOWED")
TRIED = Pen("TRIED", 0.3, colour="#0072b2")
CORRECTED = Pen("CORRECTED", 0.3, colour="#009e73")
METHODS = Pen("METHODS", 0.3, colour="#cc79a7")
HEADING = 11.0  # room of the heading [mm]
HEADROOM = 1.12
BAR = "#a9cbe2"


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return flywheel_drawing(order.results["flywheel"], order.results["reduction"].phi)


def flywheel_drawing(result: Flywheel, phi: Real) -> Drawing:
    """One sheet; ``phi`` (n,) are the positions, which say how the input shaft turns."""
    sense, required = math.copysign(1.0, phi[-1] - phi[0]), result.required
    drawing, (box,) = sheets(1)
    drawing.add(Words(complex(box.middle.real, box.top), _heading(result), 3.0, 1j))
    left, right = box.inset(0, 0, 0, HEADING).split(1, 1, gap=4, across=True)
    above, bars, *below = right.split(*((1.2, 0.8) if required is None else (1.1, 0.8, 1.0)), gap=1)
    draw_energy_mass(drawing, left, result.picture, sense)
    column(drawing, above, [_work(result, phi, sense)])
    _draw_bars(drawing, bars, result)
    if required is not None:
        _draw_search(drawing, below[0], result, required)
    return drawing


def _heading(result: Flywheel) -> str:
    delta = f"$δ$ = {unevenness(result.delta, 4)}"
    if result.addition <= 0:
        return f"No flywheel is needed for {delta}: {number(result.inertia, 5)} kg·m² at hand do"
    first = f"Flywheel for {delta} under {result.under}: {number(result.addition, 5)} kg·m² at the input shaft"
    if result.ratio != 1:
        first += f" or {number(result.own, 5)} kg·m² on its own shaft"
    return f"{first}\n$J_F$ = {number(result.inertia, 5)} kg·m² with what is at hand"


def _work(result: Flywheel, phi: Real, sense: float) -> Graph:
    """Work of all moments over the cycle, and what of it is left to the flywheel at the mean speed (Mertsalov)."""
    picture = result.picture
    half = sum(picture.slopes) / 2 / (1 + result.delta**2 / 4)
    own = picture.work - half * picture.links
    nodes = np.abs(phi - phi[0])
    lines = [
        _curve("$A$: work of all moments", picture, picture.work, nodes, sense, CURVES[0]),
        _curve("$A − J ω_m^2/2$: left to the flywheel", picture, own, nodes, sense, CURVES[1]),
    ]
    return Graph("A", "J", True, sense * picture.theta, phi, tuple(lines))


def _curve(label: str, picture: EnergyMass, values: Real, nodes: Real, sense: float, pen: Pen) -> Line:
    low, high = int(np.argmin(values)), int(np.argmax(values))
    marks = tuple((sense * float(picture.theta[k]), float(values[k])) for k in (low, high))
    return Line(label, values, np.interp(nodes, picture.theta, values), pen, marks)


def _draw_bars(drawing: Drawing, box: Box, result: Flywheel) -> None:
    """J_F by every method, with the delta that it reaches; what is needed and what is at hand."""
    rows = result.rows
    left = max(width(called(row.positional), HEIGHT) for row in rows) + 2.5
    frame = box.inset(left, BELOW + SIDES[1], SIDES[2], ROW + SIDES[3])
    widest = 1.05 * max(result.inertia, result.at_hand.total, *(row.positional.inertia for row in rows))
    axis, unit = Axis("$J_F$, kg·m²", 0.0, widest), frame.width / widest
    values = ticks(axis, max(2, int(frame.width / 14)))
    for value in values:
        x = frame.left + value * unit
        drawing.line([complex(x, frame.bottom), complex(x, frame.top)], GRID, level=-2)
        drawing.add(Words(complex(x, frame.bottom - 1.5), written(value, values), HEIGHT, 1j))
    pitch = frame.height / len(rows)
    for k, row in enumerate(rows):
        y, half, end = frame.top - pitch * (k + 0.5), 0.31 * pitch, frame.left + row.positional.inertia * unit
        corners = [complex(frame.left, y - half), complex(end, y - half), complex(end, y + half)]
        drawing.add(Area(np.array([*corners, complex(frame.left, y + half)]), BAR), level=-1)
        drawing.add(Words(complex(frame.left - 1.5, y), called(row.positional), HEIGHT, 1))
        said = Words(complex(frame.left + 1.5, y), _reached(row, result.under), min(2.1, 0.45 * pitch), -1, clear=True)
        drawing.add(said, level=8)
    for inertia, pen in ((result.inertia, NEEDED), (result.at_hand.total, AT_HAND)):
        x = frame.left + inertia * unit
        drawing.line([complex(x, frame.bottom), complex(x, frame.top)], pen, level=3)
    outline = [complex(frame.left, frame.bottom), complex(frame.right, frame.bottom)]
    drawing.line([*outline, complex(frame.right, frame.top), complex(frame.left, frame.top)], THIN, closed=True)
    drawing.add(Words(complex(frame.middle.real, frame.bottom - 3.0 - 1.6 * HEIGHT), axis.name, HEIGHT + 0.5, 1j))
    key_above(drawing, frame, [("needed $J_F$", NEEDED), ("at hand", AT_HAND)])


def _reached(row: Row, under: str) -> str:
    method = row.positional
    alone = "stalls" if method.delta is None else f"$δ$ = {number(method.delta, 4)}"
    text = f"{minus(number(method.inertia, 5))}: {alone}"
    if row.error is None:
        return text
    return f"{text}, {'stalls' if row.delta is None else number(row.delta, 4)} under {under}"


def _draw_search(drawing: Drawing, box: Box, result: Flywheel, required: RequiredInertia) -> None:
    """delta against the constant inertia under the real drive: the search, the textbook's correction, the methods."""
    methods = [Trial(row.positional.inertia, row.delta) for row in result.rows if row.positional.addition > 0]
    together = sorted((*required.trials, *result.history, *methods), key=lambda trial: trial.inertia)
    corrected = result.history if len(result.history) > 1 else ()
    drawn = [
        ("motions computed: points", required.trials, TRIED),
        ("correction (3.60): circles", corrected, CORRECTED),
        ("methods above: circles", methods, METHODS),
    ]
    shown = [each for each in drawn if each[1]]
    names = [*((label, pen) for label, _, pen in shown), ("allowed $δ$", ALLOWED), ("needed $J_F$", NEEDED)]
    if result.existing:
        names.append(("with the one there", AT_HAND))
    inertias, deltas = _points(together)
    left, bottom, right, top = SIDES
    room = ROW * len(key_rows(names, box.width - left - right))
    across = Axis("constant inertia, kg·m²", 0.0, 1.05 * max(result.inertia, *inertias))
    up = Axis(f"$δ$ under {result.under}", 0.0, HEADROOM * max(result.delta, *deltas))
    diagram = Diagram(drawing, box.inset(left, BELOW + bottom, right, room + top), across, up)
    diagram.curve(np.array(inertias) + 1j * np.array(deltas), TRIED, level=4)
    for _, trials, pen in shown:
        for inertia, delta in zip(*_points(trials), strict=True):
            filled = {"fill": pen.colour} if pen is TRIED else {}
            diagram.point(complex(inertia, delta), pen, 0.45 if pen is TRIED else 0.75, **filled)
    diagram.level(result.delta, ALLOWED)
    diagram.vertical(result.inertia, NEEDED)
    if result.existing:
        diagram.vertical(result.at_hand.total + result.existing, AT_HAND)
    diagram.key(names)


def _points(trials: Sequence[Trial]) -> tuple[list[float], list[float]]:
    """Inertias and deltas of the trials that do not stall."""
    found = [(trial.inertia, trial.delta) for trial in trials if trial.delta is not None]
    return [inertia for inertia, _ in found], [delta for _, delta in found]
