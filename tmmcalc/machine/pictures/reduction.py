"""The picture of the reduction stage: reduced moments of every cause and their sum, reduced inertia, its derivative."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tmmcalc.core.numerics.panels import Values
from tmmcalc.linkage.results import Extreme
from tmmcalc.machine.flywheel.results import Flywheel
from tmmcalc.machine.pictures.words import cause_name, indexed, speed_words
from tmmcalc.machine.power import moment_at
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
from tmmcalc.report.language import tr
from tmmcalc.report.numbers import NOISE, number

SUM = Pen("CURVE_SUM", 0.6, colour=INK)
LUMPED = Pen("CURVE_LUMPED", 0.3, colour="#d55e00")
BESIDE = 64.0  # width of the key beside the diagrams [mm]
HEADING = 7.0  # room of the heading
STRAIGHT = 1e-9  # of its largest value: a function whose slope changes less has no extremes to mark


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
    heading = tr("with the work $A$ of a cycle") if result.whole else tr("with the work $A$ over the range")
    works = [Sample(line.label, line.pen) for line in graphs[0].lines]
    parts = [Part(heading, samples=works), *lumped]
    left = free.right - BESIDE + 3.0
    write_key(drawing, Box(left, free.bottom, free.right, frames[0].box.top), parts)
    return drawing


def draw_course(drawing: Drawing, box: Box, result: Reduction, flywheel: Flywheel | None = None) -> list[Diagram]:
    """Moments, works, excess energy and inertia to scale, one under another; of a range alone the first and the last.

    The forces are taken at the mean speed, that of the ``flywheel`` where there is one; a constant moment closes the
    work of a cycle.
    """
    sense, cycle = math.copysign(1.0, result.speed), result.cycle
    panels, speed = cycle.panels, cycle.speed if flywheel is None else flywheel.picture.speed
    moment = moment_at(cycle, speed)
    symbol, unit = (indexed(tr("M_red")), "N*m") if result.turns else (indexed(tr("F_red")), "N")
    loads = tr("loads")
    if not result.whole:
        works = [(loads, panels.primitive(moment)[0], CURVES[0])]
        graphs = [_course(result, symbol, unit, [(loads, sense * moment, CURVES[0])]), _course(result, "A", "J", works)]
        return column(drawing, box, [*graphs, replace(_inertia(result), mu="J" if result.turns else "m", key=())])
    drive = -float(panels.total(moment)) / cycle.period
    name = tr("drive: a constant moment") if drive >= 0 else tr("what is driven: a constant moment")
    of_constant = tr("work of the constant moment")
    constant = np.full(moment.shape, drive)
    done, given, left = (panels.primitive(each)[0] for each in (moment, constant, moment + constant))
    graphs = [
        _course(result, symbol, unit, [(loads, sense * moment, CURVES[0]), (name, sense * constant, CURVES[1])]),
        _course(result, "A", "J", [(tr("work of the loads"), done, CURVES[0]), (of_constant, given, CURVES[1])]),
        replace(_inertia(result), mu="J" if result.turns else "m", key=()),
    ]
    shares = [1.3, 1.3, 1.0]
    if np.max(np.abs(left)) > NOISE * np.max(np.abs(done)):
        graphs.insert(2, _course(result, "ΔT", "J", [(tr("sum of both works"), left, CURVES[2])]))
        shares.append(1.0)
    return column(drawing, box, graphs, shares)


def _course(result: Reduction, symbol: str, unit: str, lines: Sequence[tuple[str, Values, Pen]]) -> Graph:
    """Functions on the panels (K, N), the extremes of each marked unless it is a constant or a straight line."""
    panels, found = result.cycle.panels, []
    for name, values, pen in lines:
        ends = panels.extremes(values)
        bent = float(np.ptp(panels.slope(values))) > STRAIGHT * float(np.max(np.abs(values)))
        marks = tuple(_mark(result, Extreme(*end)) for end in ends) if bent else ()
        nodes = panels.at(values, np.clip(np.abs(result.phi), 0.0, panels.edges[-1]))
        found.append(Line(name, with_limits(panels, values), nodes, pen, marks))
    letter = symbol[0] if symbol[0] in "MF" else symbol
    return replace(_graph(result, symbol, unit, tuple(found)), mu=letter, key=None)


def _heading(result: Reduction) -> str:
    speed, turns = speed_words(result.speed, turns=result.turns), result.turns
    if result.speed > 0:
        return (
            tr("Reduced moments and reduced inertia at {speed}", speed=speed)
            if turns
            else tr("Reduced forces and reduced mass at {speed}", speed=speed)
        )
    # the moments are algebraic: power over the speed, which is negative here
    return (
        tr("Reduced moments and reduced inertia at {speed}; a positive moment resists", speed=speed)
        if turns
        else tr("Reduced forces and reduced mass at {speed}; a positive force resists", speed=speed)
    )


def _phi(result: Reduction) -> Values:
    """The points of the panels with their edges (m,), along the positive input coordinate [rad or m]."""
    return math.copysign(1.0, result.speed) * places(result.cycle.panels)


def _graph(result: Reduction, symbol: str, unit: str, lines: tuple[Line, ...]) -> Graph:
    return Graph(symbol, unit, result.turns, _phi(result), result.phi, lines, key=())


def _moments(result: Reduction) -> Graph:
    """Every contribution with its work in the key, and the sum over them."""
    panels, sense = result.cycle.panels, math.copysign(1.0, result.speed)
    lines = [
        Line(_named(result, cause_name(c.name), c), with_limits(panels, sense * part), nodes, CURVES[k % len(CURVES)])
        for k, (c, part, nodes) in enumerate(zip(result.contributions, result.parts, result.moment, strict=True))
    ]
    total = sense * result.parts.sum(axis=0)
    marks = tuple(_mark(result, Extreme(*found)) for found in panels.extremes(total))
    lines.append(Line(_named(result, tr("sum"), None), with_limits(panels, total), result.total, SUM, marks))
    symbol, unit = (indexed(tr("M_red")), "N*m") if result.turns else (indexed(tr("F_red")), "N")
    return _graph(result, symbol, unit, tuple(lines))


def _named(result: Reduction, name: str, contribution: Contribution | None) -> str:
    """A curve of the key: its name, and the work per cycle."""
    works = [c.work for c in result.contributions]
    work = math.fsum(works) if contribution is None else contribution.work
    factor, unit = suited(max(map(abs, works), default=0.0), "J")
    extremes = (e.value for c in result.contributions for e in (c.least, c.largest))
    noise = NOISE * result.cycle.period * max(map(abs, extremes), default=0.0)
    if contribution is not None and contribution.kind == "damper":
        name = tr("{name} (damping)", name=name)
    return f"{name}: $A$ = {minus(number(work * factor if abs(work) > noise else 0.0, 5))} {unit}"


def _inertia(result: Reduction) -> Graph:
    symbol, unit = (indexed(tr("J_red")), "kg*m^2") if result.turns else (indexed(tr("m_red")), "kg")
    still = float(np.ptp(result.cycle.inertia)) <= STRAIGHT * float(np.max(result.cycle.inertia))
    extremes = result.inertia_range[:1] if still else result.inertia_range
    marks = tuple(_mark(result, extreme) for extreme in extremes)
    line = Line(tr("exact"), with_limits(result.cycle.panels, result.cycle.inertia), result.inertia, CURVES[0], marks)
    return _graph(result, symbol, unit, (line,))


def _slope(result: Reduction) -> Graph:
    """Derivative against the positive input coordinate."""
    mass = indexed(tr("J_red") if result.turns else tr("m_red"))
    symbol, unit = (f"d{mass}/dφ", "kg*m^2/rad") if result.turns else (f"d{mass}/ds", "kg/m")
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
    one = len(result.rod_links) == 1
    lumped = (
        tr("link {rods} lumped in the pins", rods=rods) if one else tr("links {rods} lumped in the pins", rods=rods)
    )
    own, label = (tr("exact"), lumped) if result.rods == "exact" else (lumped, tr("exact"))
    for at, value in zip(along_input(result.turns, result.phi).tolist(), (other * factor).tolist(), strict=True):
        diagram.point(complex(at, value), LUMPED, 0.6)
    circles = Sample(tr("{label}: circles", label=label), LUMPED)
    return [Part(tr("Reduced inertia"), samples=[Sample(own, CURVES[0]), circles])]


def _mark(result: Reduction, extreme: Extreme) -> tuple[float, float]:
    return math.copysign(extreme.x, result.speed), extreme.value
