"""The picture of the reduction stage: reduced moments of every cause and their sum, reduced inertia, its derivative."""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.linkage.facts.places import speed_text
from tmmcalc.linkage.results import Extreme
from tmmcalc.machine.reduction.results import Contribution, Reduction
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import Graph, Line, along_input, column, suited
from tmmcalc.report.drawing.diagram import Diagram
from tmmcalc.report.drawing.key import Part, Sample, write_key
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.limits import places, with_limits
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.pens import CURVES, INK, Pen
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.numbers import NOISE, number

SUM = Pen("CURVE_SUM", 0.6, colour=INK)
LUMPED = Pen("CURVE_LUMPED", 0.3, colour="#d55e00")
BESIDE = 52.0  # width of the key beside the diagrams [mm]
HEADING = 7.0  # room of the heading


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return reduction_drawing(order.results["reduction"])


def reduction_drawing(result: Reduction) -> Drawing:
    """One sheet of three diagrams, one under another, with a key beside them."""
    drawing, (box,) = sheets(1)
    drawing.add(Words(complex(box.middle.real, box.top), _heading(result), 3.2, 1j))
    graphs = (_moments(result), _inertia(result), _slope(result))
    free = box.inset(0, 0, 0, HEADING)
    frames = column(drawing, free.inset(0, 0, BESIDE, 0), graphs, (2.0, 1.0, 1.0))
    lumped = _draw_other(frames[1], result, graphs[1])
    span = "of a cycle" if result.whole else "over the range"
    works = [Sample(line.label, line.pen) for line in graphs[0].lines]
    parts = [Part(f"with the work $A$ {span}", samples=works), *lumped]
    left = free.right - BESIDE + 3.0
    write_key(drawing, Box(left, free.bottom, free.right, frames[0].box.top), parts)
    return drawing


def _heading(result: Reduction) -> str:
    what = "Reduced moments and reduced inertia" if result.turns else "Reduced forces and reduced mass"
    text = minus(f"{what} at {speed_text(result)}")
    # the moments are algebraic: power over the speed, which is negative here
    return text if result.speed > 0 else f"{text}; a positive {'moment' if result.turns else 'force'} resists"


def _phi(result: Reduction) -> Values:
    """The points of the panels with their edges (m,), along the positive input coordinate [rad or m]."""
    return math.copysign(1.0, result.speed) * places(result.cycle.panels)


def _graph(result: Reduction, symbol: str, unit: str, lines: tuple[Line, ...]) -> Graph:
    return Graph(symbol, unit, result.turns, _phi(result), result.phi, lines, key=())


def _moments(result: Reduction) -> Graph:
    """Every contribution with its work in the key, and the sum over them."""
    panels, sense = result.cycle.panels, math.copysign(1.0, result.speed)
    lines = [
        Line(_named(result, c.name, c), with_limits(panels, sense * part), nodes, CURVES[k % len(CURVES)])
        for k, (c, part, nodes) in enumerate(zip(result.contributions, result.parts, result.moment, strict=True))
    ]
    total = sense * result.parts.sum(axis=0)
    marks = tuple(_mark(result, Extreme(*found)) for found in panels.extremes(total))
    lines.append(Line(_named(result, "sum", None), with_limits(panels, total), result.total, SUM, marks))
    symbol, unit = ("M_{red}", "N*m") if result.turns else ("F_{red}", "N")
    return _graph(result, symbol, unit, tuple(lines))


def _named(result: Reduction, name: str, contribution: Contribution | None) -> str:
    """A curve of the key: its name, and the work per cycle."""
    works = [c.work for c in result.contributions]
    work = math.fsum(works) if contribution is None else contribution.work
    factor, unit = suited(max(map(abs, works), default=0.0), "J")
    extremes = (e.value for c in result.contributions for e in (c.least, c.largest))
    noise = NOISE * result.cycle.period * max(map(abs, extremes), default=0.0)
    if contribution is not None and contribution.kind == "damper":
        name += " (damping)"
    return f"{name}: $A$ = {minus(number(work * factor if abs(work) > noise else 0.0, 5))} {unit}"


def _inertia(result: Reduction) -> Graph:
    symbol, unit = ("J_{red}", "kg*m^2") if result.turns else ("m_{red}", "kg")
    marks = tuple(_mark(result, extreme) for extreme in result.inertia_range)
    line = Line("exact", with_limits(result.cycle.panels, result.cycle.inertia), result.inertia, CURVES[0], marks)
    return _graph(result, symbol, unit, (line,))


def _slope(result: Reduction) -> Graph:
    """Derivative against the positive input coordinate."""
    symbol, unit = ("dJ_{red}/dφ", "kg*m^2/rad") if result.turns else ("dm_{red}/ds", "kg/m")
    slope = math.copysign(1.0, result.speed) * result.cycle.slope
    panels = result.cycle.panels
    marks = tuple(_mark(result, Extreme(*found)) for found in panels.extremes(slope))
    return _graph(result, symbol, unit, (Line("", with_limits(panels, slope), result.slope, CURVES[0], marks),))


def _draw_other(diagram: Diagram, result: Reduction, graph: Graph) -> list[Part]:
    """The inertia with the rods the other way, at the positions alone, and its key; nothing where it is the same."""
    other, factor = result.other, graph.scale[0]
    if other is None or np.max(np.abs(other - result.inertia)) <= NOISE * np.max(other):
        return []
    rods = ", ".join(map(str, result.rod_links))
    lumped = f"link{'s' if len(result.rod_links) > 1 else ''} {rods} lumped in the pins"
    own, label = ("exact", lumped) if result.rods == "exact" else (lumped, "exact")
    for at, value in zip(along_input(result.turns, result.phi).tolist(), (other * factor).tolist(), strict=True):
        diagram.point(complex(at, value), LUMPED, 0.6)
    return [Part("Reduced inertia", samples=[Sample(own, CURVES[0]), Sample(f"{label}: circles", LUMPED)])]


def _mark(result: Reduction, extreme: Extreme) -> tuple[float, float]:
    return math.copysign(extreme.x, result.speed), extreme.value
