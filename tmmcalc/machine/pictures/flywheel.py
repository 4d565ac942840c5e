"""The picture of the flywheel stage: energy-mass curve with its tangents, work over the cycle, methods, search."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.facts.motion import unevenness
from tmmcalc.machine.flywheel.results import Flywheel, RequiredInertia, Row, Trial
from tmmcalc.machine.flywheel.wittenbauer import EnergyMass
from tmmcalc.machine.pictures.constructions import machine_of, ordinates_sheet, wittenbauer_sheet
from tmmcalc.machine.pictures.energymass import draw_energy_mass
from tmmcalc.machine.pictures.words import method_name, under
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import BELOW, SIDES, Graph, Line, column
from tmmcalc.report.drawing.diagram import HEIGHT, ROW, Axis, Diagram, key_above, key_rows, ticks, written
from tmmcalc.report.drawing.lettering import minus, width
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import headed, sheets
from tmmcalc.report.drawing.pens import AXIS, CURVES, GRID, THIN, Pen
from tmmcalc.report.drawing.shapes import Area, Drawing, Words
from tmmcalc.report.language import tr, tr_unit
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
    reduction = order.results["reduction"]
    return flywheel_drawing(order.results["flywheel"], reduction.phi, reduction.cycle)


def flywheel_drawing(result: Flywheel, phi: Real, cycle: Cycle) -> Drawing:
    """A sheet of the results, two of constructions; ``phi`` (n,) are the positions, which say how the input turns."""
    drawing, (first, second, third) = sheets(3)
    _sheet(drawing, _headed(drawing, first, _heading(result)), result, phi)
    machine = machine_of(result.picture, cycle, phi, result.delta)
    wittenbauer_sheet(drawing, headed(drawing, second, tr("Wittenbauer's construction of the flywheel"), 3.0), machine)
    heading = tr("Constructions of Mertsalov and Artobolevsky")
    ordinates_sheet(drawing, headed(drawing, third, heading, 3.0), machine)
    return drawing


def _sheet(drawing: Drawing, box: Box, result: Flywheel, phi: Real) -> None:
    """The energy-mass curve, the work over the cycle, all methods, the search under a motor."""
    sense, required = math.copysign(1.0, phi[-1] - phi[0]), result.required
    left, right = box.split(1, 1, gap=4, across=True)
    above, bars, *below = right.split(*((1.2, 0.8) if required is None else (1.1, 0.8, 1.0)), gap=1)
    draw_energy_mass(drawing, left, result.picture, sense)
    column(drawing, above, [_work(result, phi, sense)])
    _draw_bars(drawing, bars, result)
    if required is not None:
        _draw_search(drawing, below[0], result, required)


def _headed(drawing: Drawing, box: Box, heading: str) -> Box:
    drawing.add(Words(complex(box.middle.real, box.top), heading, 3.0, 1j))
    return box.inset(0, 0, 0, HEADING)


def _heading(result: Flywheel) -> str:
    values = {
        "delta": unevenness(result.delta, 4),
        "under": under(result),
        "inertia": number(result.inertia, 5),
        "addition": number(result.addition, 5),
        "own": number(result.own, 5),
    }
    if result.addition <= 0:
        return tr("No flywheel is needed for $δ$ = {delta}: {inertia} kg·m² at hand do", **values)
    if result.ratio != 1:
        first = tr(
            "Flywheel for $δ$ = {delta} {under}: {addition} kg·m² at the input shaft or {own} kg·m² on its own shaft",
            **values,
        )
    else:
        first = tr("Flywheel for $δ$ = {delta} {under}: {addition} kg·m² at the input shaft", **values)
    return first + "\n" + tr("$J_F$ = {inertia} kg·m² with what is at hand", **values)


def _work(result: Flywheel, phi: Real, sense: float) -> Graph:
    """Work of all moments over the cycle, and what of it is left to the flywheel at the mean speed (Mertsalov)."""
    picture = result.picture
    half = sum(picture.slopes) / 2 / (1 + result.delta**2 / 4)
    own = picture.work - half * picture.links
    nodes = np.abs(phi - phi[0])
    lines = [
        _curve(tr("$A$: work of all moments"), picture, picture.work, nodes, sense, CURVES[0]),
        _curve(tr("$A − T_{II}$: left to the flywheel"), picture, own, nodes, sense, CURVES[1]),
    ]
    return Graph("A", "J", True, sense * picture.theta, phi, tuple(lines))


def _curve(label: str, picture: EnergyMass, values: Real, nodes: Real, sense: float, pen: Pen) -> Line:
    low, high = int(np.argmin(values)), int(np.argmax(values))
    marks = tuple((sense * float(picture.theta[k]), float(values[k])) for k in (low, high))
    return Line(label, values, np.interp(nodes, picture.theta, values), pen, marks)


def _draw_bars(drawing: Drawing, box: Box, result: Flywheel) -> None:
    """J_F by every method, with the delta that it reaches; what is needed and what is at hand."""
    rows = result.rows
    left = max(width(method_name(row.positional.method), HEIGHT) for row in rows) + 2.5
    frame = box.inset(left, BELOW + SIDES[1], SIDES[2], ROW + SIDES[3])
    widest = 1.05 * max(result.inertia, result.at_hand.total, *(row.positional.inertia for row in rows))
    axis, unit = Axis(f"$J_F$, {tr_unit('kg*m^2')}", 0.0, widest), frame.width / widest
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
        drawing.add(Words(complex(frame.left - 1.5, y), method_name(row.positional.method), HEIGHT, 1))
        said = Words(complex(frame.left + 1.5, y), _reached(row, under(result)), min(2.1, 0.45 * pitch), -1, clear=True)
        drawing.add(said, level=8)
    for inertia, pen in ((result.inertia, NEEDED), (result.at_hand.total, AT_HAND)):
        x = frame.left + inertia * unit
        drawing.line([complex(x, frame.bottom), complex(x, frame.top)], pen, level=3)
    outline = [complex(frame.left, frame.bottom), complex(frame.right, frame.bottom)]
    drawing.line([*outline, complex(frame.right, frame.top), complex(frame.left, frame.top)], THIN, closed=True)
    drawing.add(Words(complex(frame.middle.real, frame.bottom - 3.0 - 1.6 * HEIGHT), axis.name, HEIGHT + 0.5, 1j))
    key_above(drawing, frame, [(tr("needed $J_F$"), NEEDED), (tr("at hand"), AT_HAND)])


def _reached(row: Row, under: str) -> str:
    """The inertia that a method asks for, the delta that it reaches under forces of position, and the real one."""
    method = row.positional
    values = {"inertia": minus(number(method.inertia, 5)), "under": under}
    alone = _delta(method.delta)
    if row.error is None:
        return tr("{inertia}: {alone}", alone=alone, **values)
    return tr("{inertia}: {alone}; {really} {under}", alone=alone, really=_delta(row.delta), **values)


def _delta(delta: float | None) -> str:
    return tr("it stalls") if delta is None else f"$δ$ = {number(delta, 4)}"


def _draw_search(drawing: Drawing, box: Box, result: Flywheel, required: RequiredInertia) -> None:
    """delta against the constant inertia under the real drive: the search, the textbook's correction, the methods."""
    methods = [Trial(row.positional.inertia, row.delta) for row in result.rows if row.positional.addition > 0]
    together = sorted((*required.trials, *result.history, *methods), key=lambda trial: trial.inertia)
    corrected = result.history if len(result.history) > 1 else ()
    drawn = [
        (tr("motions computed: points"), required.trials, TRIED),
        (tr("correction (3.60): circles"), corrected, CORRECTED),
        (tr("methods above: circles"), methods, METHODS),
    ]
    shown = [each for each in drawn if each[1]]
    names = [*((label, pen) for label, _, pen in shown), (tr("allowed $δ$"), ALLOWED), (tr("needed $J_F$"), NEEDED)]
    if result.existing:
        names.append((tr("with the one there"), AT_HAND))
    inertias, deltas = _points(together)
    left, bottom, right, top = SIDES
    room = ROW * len(key_rows(names, box.width - left - right))
    across = Axis(tr("constant inertia, kg·m²"), 0.0, 1.05 * max(result.inertia, *inertias))
    up = Axis(tr("$δ$ {under}", under=under(result)), 0.0, HEADROOM * max(result.delta, *deltas))
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
