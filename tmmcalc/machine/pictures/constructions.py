"""The constructions of the textbooks for the flywheel, to standard scale factors, with what is read from them.

Wittenbauer's energy-mass curve stands between the diagrams that it is made of: the work on its left, the inertia of
the links above, turned so that its ordinates lie along J. Mertsalov takes the energy of the links at the mean speed
off the work; Artobolevsky needs the ordinates of work and inertia where the work is extreme.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.flywheel.onpaper import Construction, Reading, artobolevsky, mertsalov, wittenbauer
from tmmcalc.machine.flywheel.wittenbauer import EnergyMass
from tmmcalc.machine.flywheel.worked import Worked, round_scales, worked
from tmmcalc.machine.pictures.energymass import CURVE, FAST, SLOW, at, draw_energy_mass, numbered
from tmmcalc.machine.pictures.words import method_name
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import SIDES, Graph, Line, along_input, column, input_axis, scale_factor
from tmmcalc.report.drawing.diagram import Axis, Diagram
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.pens import CURVES, OTHER, Pen
from tmmcalc.report.drawing.scales import standard_scale
from tmmcalc.report.drawing.shapes import Dimension, Drawing, Words
from tmmcalc.report.drawing.tables import draw_table
from tmmcalc.report.language import tr, tr_number, tr_unit
from tmmcalc.report.numbers import number

WORK, LINKS, REST, INERTIA = CURVES[0], CURVES[2], CURVES[1], CURVES[0]
PROJECTED = OTHER._replace(width=0.2, dashes=(1.6, 1.2))
TURNED = 46.0  # height of the inertia's diagram above the curve [mm]
LINE = 5.6  # between the lines of what follows from readings [mm]
AIR = 0.06  # of the range of works, below and above, for the names of ordinates
SEEN = 5e-7  # a smaller relative difference is none
HEADING, LETTERS = 3.0, 2.6  # heights of the words beside [mm]


class Machine(NamedTuple):
    """What is constructed: the picture, the methods worked out, and what it is for."""

    picture: EnergyMass
    rows: dict[str, Worked]  # by their keys
    phi: Real  # (n,) of the positions [rad]
    delta: float
    sense: float

    def graph(self, symbol: str, unit: str, lines: Sequence[tuple[str, Real, Pen]], mu: str) -> Graph:
        """A diagram over the cycle of values at the picture's places, to scale."""
        picture, nodes = self.picture, np.abs(self.phi - self.phi[0])
        every = tuple(Line(name, v, np.interp(nodes, picture.theta, v), pen) for name, v, pen in lines)
        values = np.concatenate([v for _, v, _ in lines])
        low, high = float(min(values.min(), 0.0)), float(max(values.max(), 0.0))
        air = AIR * (high - low)
        ends = (low - air * (low < 0 or symbol == "A"), high + air)
        return Graph(symbol, unit, True, self.sense * picture.theta, self.phi, every, ends=ends, mu=mu)


def machine_of(picture: EnergyMass, cycle: Cycle, phi: Real, delta: float) -> Machine:
    """``phi`` (n,) are the positions, which say how the input turns."""
    sense = math.copysign(1.0, phi[-1] - phi[0])
    rows = {each.key: each for each in worked(cycle, delta, picture.speed, None, sense)}
    return Machine(picture, rows, phi, delta, sense)


def wittenbauer_sheet(drawing: Drawing, box: Box, machine: Machine) -> None:
    """The curve at the scales of ``flywheel --tangents``, the diagrams that it is made of, what is read from it."""
    scales, picture = round_scales(machine.picture), machine.picture
    left, right = box.split(133, 146, gap=4, across=True)
    above, below = right.split(TURNED, right.height - TURNED)
    curve = draw_energy_mass(drawing, below, picture, machine.sense, scales)
    factor = (curve.y.high - curve.y.low) / curve.box.height / scales[0]
    work = _beside(drawing, left, curve, machine, factor)
    inertia = _above(drawing, above, curve, machine)
    for k, pen in enumerate((FAST, SLOW)):
        _project(machine, k, factor, pen, (work, curve, inertia))
    found = wittenbauer(picture, scales, machine.delta)
    heading = tr("Wittenbauer: read from paper")
    divisor = f"({number(machine.delta, 4)}·{number(picture.speed, 5)}²)"
    line = f"$J_F = GH·μ_A/(δ ω_m^2)$ = {_millimetres(found.readings[0])}·{number(scales[0])}/{divisor}"
    write_readings(drawing, Box(left.left, work.box.top + 6, left.right, box.top), heading, found, [line])


def _beside(drawing: Drawing, box: Box, curve: Diagram, machine: Machine, factor: float) -> Diagram:
    """The work over the cycle, its ordinates at the heights of the curve."""
    picture = machine.picture
    x = along_input(True, machine.sense * picture.theta)
    room = box.width - SIDES[0] - SIDES[2]
    mu = standard_scale(float(np.ptp(x)) / room)
    right = box.right - SIDES[2]
    frame = Box(right - float(np.ptp(x)) / mu, curve.box.bottom, right, curve.box.top)
    along = input_axis(True, x)
    along = along._replace(name=f"{along.name}; {scale_factor('φ', mu, '°')}")
    diagram = Diagram(drawing, frame, along, curve.y)
    diagram.curve(x + 1j * picture.work * factor, CURVE)
    for theta in numbered(picture):
        degrees = math.degrees(machine.sense * theta)
        diagram.point(complex(degrees, at(picture, theta)[1] * factor), CURVE, 0.4, CURVE.colour)
    return diagram


def _above(drawing: Drawing, box: Box, curve: Diagram, machine: Machine) -> Diagram:
    """The inertia along the abscissa of the curve, the input upwards."""
    picture = machine.picture
    degrees = np.degrees(picture.theta)
    mu = standard_scale(float(degrees[-1]) / (box.height - 4.0))
    frame = Box(curve.box.left, box.top - float(degrees[-1]) / mu, curve.box.right, box.top)
    name = f"$φ$, °; {scale_factor('φ', mu, '°')}" if machine.sense > 0 else f"$−φ$, °; {scale_factor('φ', mu, '°')}"
    up = Axis(name, 0.0, float(degrees[-1]), True)
    diagram = Diagram(drawing, frame, curve.x, up, numbered=False)
    diagram.curve(picture.links + 1j * degrees, CURVE)
    for theta in numbered(picture):
        diagram.point(complex(at(picture, theta)[0], math.degrees(theta)), CURVE, 0.4, CURVE.colour)
    return diagram


def _project(machine: Machine, k: int, factor: float, pen: Pen, diagrams: tuple[Diagram, Diagram, Diagram]) -> None:
    """How a place where a tangent touches comes from both diagrams."""
    work, curve, inertia = diagrams
    theta = machine.picture.touching[k]
    x, y = at(machine.picture, theta)
    y *= factor
    degrees = math.degrees(theta)
    first, second = complex(machine.sense * degrees, y), complex(x, degrees)
    work.curve(np.array([first, complex(work.x.high, y)]), PROJECTED, level=2)
    curve.curve(np.array([complex(curve.x.low, y), complex(x, y), complex(x, curve.y.high)]), PROJECTED, level=2)
    inertia.curve(np.array([complex(x, 0.0), second]), PROJECTED, level=2)
    work.point(first, pen)
    inertia.point(second, pen)


def ordinates_sheet(drawing: Drawing, box: Box, machine: Machine) -> None:
    """Mertsalov's and Artobolevsky's constructions over the cycle, what is read from them, all three side by side."""
    left, right = box.split(1.62, 1.0, gap=5, across=True)
    mu_a, mu_j = draw_ordinates(drawing, left, machine)
    upper, middle, lower = right.split(1.0, 1.25, 0.75, gap=3)
    speed, delta = number(machine.picture.speed, 5), number(machine.delta, 4)
    divisor = f"({delta}·{speed}²)"
    own = mertsalov(machine.rows["mertsalov_by_cycle"], mu_a)
    high, low = map(_millimetres, own.readings)
    lines = [
        f"$T_{{II}} = J ω_m^2/2$, $ω_m$ = {speed} {tr_unit('rad/s')}",
        "$ΔT = (y_{max} − y_{min}) μ_A$, $J_F = ΔT/(δ ω_m^2)$",
        f"$J_F$ = ({high} − {_in_braces(low)})·{number(mu_a)}/{divisor}",
    ]
    write_readings(drawing, upper, tr("Mertsalov: read from paper"), own, lines)
    excess = artobolevsky(machine.rows["artobolevsky_by_cycle"], (mu_a, mu_j), machine.delta)
    a, b, c, d = map(_millimetres, excess.readings)
    more, less = number(1 + machine.delta, 5), number(1 - machine.delta, 5)
    lines = [
        "$J_F = ((y_a − y_b) μ_A − (z_a (1 + δ) − z_b (1 − δ)) μ_J ω_m^2/2)/(δ ω_m^2)$",
        f"$J_F$ = (({a} − {_in_braces(b)})·{number(mu_a)}",
        f"− ({c}·{more} − {d}·{less})·{number(mu_j)}·{speed}²/2)/{divisor}",
    ]
    write_readings(drawing, middle, tr("Artobolevsky: read from paper"), excess, lines)
    tangents = wittenbauer(machine.picture, round_scales(machine.picture), machine.delta)
    _compare(drawing, lower, (("wittenbauer", tangents), ("mertsalov", own), ("artobolevsky", excess)))


def draw_ordinates(drawing: Drawing, box: Box, machine: Machine) -> tuple[float, float]:
    """The work less the energy of the links, and their inertia, with the ordinates that are read; both scale factors.

    In J/mm and kg*m^2/mm.
    """
    picture = machine.picture
    energy = picture.links * picture.speed**2 / 2
    works = machine.graph(
        "A",
        "J",
        (
            (tr("$A$: work of all moments"), picture.work, WORK),
            (tr("$T_{II}$: energy of the links"), energy, LINKS),
            (tr("$A − T_{II}$: left to the flywheel"), picture.work - energy, REST),
        ),
        "A",
    )
    inertia = machine.graph("J", "kg*m^2", (("", picture.links, INERTIA),), "J")
    above, below = column(drawing, box, (works, inertia), (2.3, 1.0))
    factors = works.scale[0], inertia.scale[0]
    mu_a, mu_j = (
        (each.y.high - each.y.low) / each.box.height / factor
        for each, factor in zip((above, below), factors, strict=True)
    )
    own, excess = machine.rows["mertsalov_by_cycle"], machine.rows["artobolevsky_by_cycle"]
    for diagram, theta in product((above, below), (excess.at_max, excess.at_min)):
        diagram.vertical(math.degrees(theta), PROJECTED)
    _mark_rest(above, own, factors[0], mu_a)
    for word, theta, work, links in (
        ("a", excess.at_max, excess.work_max, excess.links_max),
        ("b", excess.at_min, excess.work_min, excess.links_min),
    ):
        degrees = math.degrees(theta)
        above.mark(complex(degrees, work * factors[0]), f"$y_{word}$ = {_length(work / mu_a)}", WORK, 2.2)
        below.mark(complex(degrees, links * factors[1]), f"$z_{word}$ = {_length(links / mu_j)}", INERTIA, 2.2)
    return mu_a, mu_j


def _mark_rest(diagram: Diagram, own: Worked, factor: float, mu: float) -> None:
    """The extremes of what is left to the flywheel, and the excess work between their levels."""
    read = ("max", own.at_max, own.intercept_max), ("min", own.at_min, own.intercept_min)
    for _, _, value in read:
        diagram.level(value * factor, PROJECTED)
    high, low = (complex(diagram.box.right - 8.0, diagram.place(1j * value * factor).imag) for _, _, value in read)
    diagram.drawing.add(Dimension(low, high, low, ""), level=6)
    diagram.labels.avoid((low, high), 2.0)
    for word, theta, value in read:
        text = f"$y_{{{word}}}$ = {_length(value / mu)}"
        diagram.mark(complex(math.degrees(theta), value * factor), text, REST, 2.2)
    along = low + (high - low) * np.linspace(0.1, 0.9, 9)
    text = f"$ΔT$ = {_length(own.segment / mu)}"
    diagram.labels.put(text, along.tolist(), height=2.2, gaps=(0.8, 1.4), prefer=-1)


def write_readings(drawing: Drawing, box: Box, heading: str, found: Construction, lines: Sequence[str]) -> None:
    """A table of readings beside the exact numbers, and the inertia that follows from them."""
    drawing.add(Words(complex(box.left, box.top), heading, HEADING, -1 + 1j))
    rows = [
        (
            f"${each.symbol}$",
            f"{_millimetres(each)}{'°' if each.of == '°' else ' ' + tr_unit('mm')}",
            f"{minus(number(each.value, 5))} {tr_unit(each.unit)}",
            minus(number(each.exact, 5)),
            _percent(each.error),
        )
        for each in found.readings
    ]
    unit = tr_unit("kg*m^2")
    inertia = (minus(number(found.inertia, 5)), minus(number(found.exact, 5)), _percent(found.error))
    rows.append(("$J_F$", "", f"{inertia[0]} {unit}", *inertia[1:]))
    head = ("", tr("read"), tr("by scale"), tr("exact"), tr("off, %"))
    table = Box(box.left, box.bottom, box.right, box.top - 2.4 * HEADING)
    high = draw_table(drawing, table, head, rows, LETTERS)
    for k, line in enumerate(lines):
        drawing.add(Words(complex(box.left, table.top - high - LINE * (k + 0.8)), line, LETTERS - 0.2, -1))


def _compare(drawing: Drawing, box: Box, found: Sequence[tuple[str, Construction]]) -> None:
    """The inertias of the constructions against the exact tangents."""
    exact = found[0][1].exact
    heading = tr("$J_F$ from paper against the exact tangents")
    drawing.add(Words(complex(box.left, box.top), heading, HEADING, -1 + 1j))
    rows = [
        (method_name(name), minus(number(each.inertia, 5)), minus(number(exact, 5)), _percent(each.inertia / exact - 1))
        for name, each in found
    ]
    unit = tr_unit("kg*m^2")
    head = ("", f"{tr('by scale')}, {unit}", tr("exact"), tr("off, %"))
    draw_table(drawing, box._replace(top=box.top - 2.4 * HEADING), head, rows, LETTERS)


def _percent(error: float) -> str:
    return minus(number(100 * error, 2)) if abs(error) >= SEEN else "0"


def _millimetres(reading: Reading) -> str:
    return minus(tr_number(f"{reading.read:.1f}"))


def _in_braces(text: str) -> str:
    return f"({text})" if text.startswith("−") else text


def _length(millimetres: float) -> str:
    return f"{tr_number(f'{millimetres:.1f}')} {tr_unit('mm')}"
