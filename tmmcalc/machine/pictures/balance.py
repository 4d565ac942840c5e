"""The picture of the balance stage: hodographs of the shaking force, and what the schemes leave of force and moment.

In the axes of the crank the force of a counterweight stands still: the best one takes the mean of the hodograph
there, O1, away, and in the fixed axes its force runs around a circle. An engine has a sheet of its own.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.fourier import TURN, Magnitude, Series
from tmmcalc.core.plane import Plane, Real
from tmmcalc.machine.balance.solve import Balancing, Scheme
from tmmcalc.machine.facts.shakingmoment import moved, phi_at
from tmmcalc.machine.pictures.shaking import Path, Polar, Ring, Sizes, Spot, draw_sizes, shaking_sheet
from tmmcalc.machine.pictures.words import scheme_name, speed_words
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import Graph, Line
from tmmcalc.report.drawing.diagram import Diagram
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.order import Order
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.pens import CURVES
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr
from tmmcalc.report.numbers import NOISE, number

if TYPE_CHECKING:
    from tmmcalc.machine.stages.balance import Balances

SAMPLES = 721  # of a turn
FORCE = CURVES[0]._replace(width=0.5)
WEIGHT, LEFT, CIRCLE = CURVES[1], CURVES[2], CURVES[3]
PAIRS = ("lanchester", "lanchester 2")  # schemes of weights that turn against each other
TOGETHER = 3  # so many schemes are told apart in one diagram
HEADING = 12.0  # room of the heading [mm]


def figure(order: Order) -> Drawing:
    """The drawing of the stage."""
    return balance_drawing(order.results["balance"])


def balance_drawing(result: Balances) -> Drawing:
    """A sheet of the linkage, and one of the engine. Raises `UsageError` for a rotor alone."""
    linkage, engine = result.linkage, result.engine
    if linkage is None and engine is None:
        raise UsageError("there is no picture of a rotor", where="plot", remedy="tmmcalc balance tells its loads")
    drawing, boxes = sheets(2 if linkage is not None and engine is not None else 1)
    if linkage is not None:
        _linkage_sheet(drawing, boxes[0], linkage)
    if engine is not None:
        from tmmcalc.machine.pictures.engine import engine_sheet

        engine_sheet(drawing, boxes[-1], engine)
    return drawing


def _linkage_sheet(drawing: Drawing, box: Box, result: Balancing) -> None:
    drawing.add(Words(complex(box.middle.real, box.top), _heading(result), 3.0, 1j))
    views = (_fixed(result), _turning(result)), (*_forces(result), _moments(result))
    heights = [1.5] * (len(views[1]) - 1) + [1.0]
    shaking_sheet(drawing, box.inset(0, 0, 0, HEADING), *views, heights)


def draw_shaking(drawing: Drawing, box: Box, result: Balancing) -> list[Diagram]:
    """The shaking force before and after balancing over a turn, to scale."""
    letters = [replace(each, graph=replace(each.graph, mu="R")) for each in _forces(result)]
    return draw_sizes(drawing, box, letters, [1.0] * len(letters))


def draw_hodographs(drawing: Drawing, box: Box, result: Balancing) -> None:
    """The hodographs in the fixed axes and in those of the crank, beside each other."""
    halves = box.split(1.0, 1.0, gap=4, across=True)
    for part, hodograph in zip(halves, (_fixed(result), _turning(result)), strict=True):
        hodograph.draw(drawing, part)


def _heading(result: Balancing) -> str:
    found = result.shaking
    values = {
        "x": minus(number(1e3 * found.about.real)),
        "y": minus(number(1e3 * found.about.imag)),
        "speed": speed_words(found.speed),
    }
    if found.about == found.pivot:
        first = tr("Shaking force $R$ and moment $M_R$ about the crank's pivot at {speed}", **values)
    else:
        first = tr("Shaking force $R$ and moment $M_R$ about ({x}; {y}) mm at {speed}", **values)
    return first + "\n" + tr("$D$: what the schemes of balancing leave of it")


def _angles(result: Balancing) -> tuple[Real, Real]:
    """phi over a whole turn from position 0 along the motion (m,), and the crank angle there (m,) [rad]."""
    sense = math.copysign(1.0, result.shaking.speed)
    phi = sense * np.linspace(0.0, TURN, SAMPLES)
    return phi, phi + float(result.shaking.phi[0] - result.phi[0])


def _counterweight(result: Balancing) -> Scheme | None:
    """The counterweight for the least mean square, or else the one for the least maximum, if one is asked for."""
    found = {scheme.name: scheme for scheme in result.schemes}
    return found.get("least squares", found.get("minimax"))


def _fixed(result: Balancing) -> Polar:
    """The hodograph in the fixed axes, the circle of the counterweight's force, and the sum of both."""
    found, best = result.shaking, _counterweight(result)
    _, crank = _angles(result)
    paths = [Path("$R$", found.series.at(crank), found.force, FORCE)]
    rings, spots = [], []
    if best is not None:
        series = best.balance.series
        paths.append(
            Path(tr("$D$, {scheme}", scheme=scheme_name(best.name)), series.at(crank), best.balance.force, LEFT)
        )
        weight = series.coefficient(1) - found.series.coefficient(1)
        rings.append(Ring(tr("force of the counterweight"), 0j, abs(weight), WEIGHT))
        spots.append(Spot("0", complex(weight * np.exp(1j * crank[0])), WEIGHT, arrow=True))
    return Polar(
        tr("Hodograph in the fixed axes"), ("R_x", "R_y"), "N", tuple(paths), result.labels, tuple(rings), tuple(spots)
    )


def _turning(result: Balancing) -> Polar:
    """The hodograph in the axes of the crank, its mean O1, and the smallest circle around it."""
    found = result.shaking
    _, crank = _angles(result)
    mean = found.series.coefficient(1)
    path = Path("$R$", found.series.at(crank) * np.exp(-1j * crank), found.turned, FORCE)
    spots = [Spot("$O_1$", mean, WEIGHT, arrow=True)]
    rings = []
    for scheme in result.schemes:
        if scheme.name == "minimax":
            weight, name = scheme.balance.series.coefficient(1) - mean, tr("smallest circle, $O_2$")
            rings.append(Ring(name, -weight, scheme.balance.after.largest, CIRCLE))
            spots.append(Spot("$O_2$", -weight, CIRCLE))
    heading = tr("In the axes of the crank; the best counterweight takes $OO_1$ away")
    names = ("R_{x1}", "R_{y1}")
    return Polar(heading, names, "N", (path,), result.labels, tuple(rings), tuple(spots))


def _forces(result: Balancing) -> list[Sizes]:
    """|R| beside |D| of the schemes; of many those of a kind in a diagram."""
    found = result.shaking
    before = _Left("$R$", 0, found.series, found.force, found.size)
    kinds: dict[str, list[_Left]] = {}
    for k, scheme in enumerate(result.schemes, 1):
        balance = scheme.balance
        left = _Left(scheme_name(scheme.name), k, balance.series, balance.force, balance.after)
        kinds.setdefault("pairs" if scheme.name in PAIRS else "crank", []).append(left)
    if result.redistribution is not None:
        after = result.redistribution.after
        k = len(result.schemes) + 1
        kinds["links"] = [_Left(tr("counterweights"), k, after.series, after.force, after.size)]
    every = [left for kind in kinds.values() for left in kind]
    rows = [[before, *every]] if len(every) <= TOGETHER else [[before, *kind] for kind in kinds.values()]
    return [_sizes(result, ("|R|, |D|", "N"), each, np.abs) for each in rows]


def _moments(result: Balancing) -> Sizes:
    """M_R, and what is left of it by the schemes that change it."""
    found = result.shaking
    rows = [_Left("$M_R$", 0, found.moment_series, found.moment, found.moment_size)]
    for k, scheme in enumerate(result.schemes, 1):
        balance = scheme.balance
        if moved(balance):
            rows.append(_Left(scheme_name(scheme.name), k, balance.moment_series, balance.moment, balance.moment_after))
    if result.redistribution is not None:
        k, after = len(result.schemes) + 1, result.redistribution.after
        rows.append(_Left(tr("counterweights"), k, after.moment_series, after.moment, after.moment_size))
    return _sizes(result, ("M", "N*m"), rows, np.real)


class _Left(NamedTuple):
    """What a scheme leaves: its name and colour, its series, its values at the positions, how large it is."""

    label: str
    colour: int
    series: Series
    nodes: Plane | Real
    size: Magnitude


def _sizes(
    result: Balancing, named: tuple[str, str], rows: Sequence[_Left], of: Callable[[Plane | Real], Real]
) -> Sizes:
    """A diagram with its rms levels; what is noise is drawn as zero."""
    phi, crank = _angles(result)
    seen = [row.size.largest > NOISE * result.shaking.scale for row in rows]
    lines = [
        _line(result, row, of(row.series.at(crank)) * some, of(row.nodes) * some)
        for row, some in zip(rows, seen, strict=True)
    ]
    levels = tuple(row.size.rms * some for row, some in zip(rows, seen, strict=True))
    return Sizes(Graph(*named, True, phi, result.phi, tuple(lines)), levels)


def _line(result: Balancing, row: _Left, values: Real, nodes: Real) -> Line:
    """A curve with its largest value marked."""
    pen = CURVES[row.colour % len(CURVES)]
    at = math.radians(phi_at(result, row.size.at))
    value = float(np.interp(abs(at), np.abs(_angles(result)[0]), values))
    marks = ((at, math.copysign(row.size.largest, value)),) if values.any() else ()
    return Line(row.label, values, nodes, pen, marks)
