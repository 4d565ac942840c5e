"""The pictures of a six-bar with a dwell: the mechanism at dwell, both branches of Gamma, motion, forces."""

from __future__ import annotations

import math
from collections.abc import Sequence

from tmmcalc.core.plane import Real
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.kinematics import solve_kinematics
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.pictures.cycle import whole_cycle
from tmmcalc.linkage.pictures.scheme import draw_scheme
from tmmcalc.linkage.synthesis.dwell.results import Dwell
from tmmcalc.linkage.synthesis.results import Design
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import Graph, Line, column
from tmmcalc.report.drawing.key import Part, Sample, write_key
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.page import sheets
from tmmcalc.report.drawing.pens import CURVES
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.language import tr, tr_name, tr_unit
from tmmcalc.report.numbers import number

DEGREE = math.degrees(1.0)
OWN, OTHER, DWELL = CURVES[2], CURVES[3], "#f2e6c9"
SKIPPED = ("x_E", "y_E", "x_D2", "y_D2", "x_F", "y_F")  # sizes that the key leaves to the table


def dwell_drawing(mechanism: Mechanism, design: Design, dwell: Dwell) -> Drawing:
    """A sheet with the mechanism in position 1, and one with the diagrams over the turn of the crank."""
    drawing, (first, second) = sheets(2)
    angle = minus(number(DEGREE * dwell.dwell_angle, 5))
    title = tr("{name}, dwell of {angle}°", name=tr_name(design.name), angle=angle)
    drawing.add(Words(complex(first.middle.real, first.top), title, 3.5, 1j))
    scheme, key = first.inset(0, 0, 0, 7).split(2.4, 1.0, gap=4, across=True)
    draw_dwelling(drawing, scheme, mechanism, dwell)
    write_key(drawing, key, _key(design, dwell))
    motion, forces = second.split(1, 1, gap=4, across=True)
    draw_motion(drawing, motion, dwell)
    draw_forces(drawing, forces, dwell)
    return drawing


def draw_dwelling(drawing: Drawing, box: Box, mechanism: Mechanism, dwell: Dwell) -> None:
    """The linkage in position 1 to scale, with both branches of Gamma."""
    motion = solve_kinematics(mechanism)
    board = draw_scheme(drawing, box, motion, whole_cycle(chain_of(mechanism, motion), motion), [0])
    board.line(dwell.slots.own, OWN, weight=0.3, level=12.5)
    board.line(dwell.slots.other, OTHER, weight=0.3, level=12.4)


def draw_motion(drawing: Drawing, box: Box, dwell: Dwell) -> None:
    """The diagrams of the output over the turn of the crank, the dwell shaded."""
    _panels(drawing, box, _of_motion(dwell), dwell)


def draw_forces(drawing: Drawing, box: Box, dwell: Dwell) -> None:
    """The diagrams of forces and moment over the turn of the crank, the dwell shaded."""
    _panels(drawing, box, _of_forces(dwell), dwell)


def _key(design: Design, dwell: Dwell) -> list[Part]:
    sizes = [
        (_formula(size.symbol), _shown(size.value, size.unit)) for size in design.sizes if size.symbol not in SKIPPED
    ]
    checks = [
        (tr_name(check.name).replace("|S|", "$|S|$"), _shown(check.achieved, check.unit)) for check in design.checks
    ]
    samples = [
        Sample(tr("slot $Γ$ of the crank pin $A$ in link 5"), OWN),
        Sample(tr("its other branch"), OTHER),
        Sample(tr("dwell, in the diagrams"), DWELL),
    ]
    return [Part(tr("Sizes"), sizes), Part(tr("By simulation"), checks), Part(tr("Lines"), samples=samples)]


def _formula(symbol: str) -> str:
    letter, _, index = symbol.partition("_")
    greek = {"phi": "φ", "psi": "ψ", "alpha": "α"}.get(letter, letter)
    return f"${greek}_{{{index}}}$" if index else f"${greek}$"


def _shown(value: float, unit: str) -> str:
    if unit == "rad":
        return f"{minus(number(DEGREE * value, 6))}°"
    return f"{minus(number(1e3 * value, 6))} {tr_unit('mm')}" if unit == "m" else minus(number(value, 5))


def _of_motion(dwell: Dwell) -> list[Graph]:
    """S with the place of B, and both transfer functions."""
    factor, unit = (1e3, "mm") if dwell.output == "slider" else (DEGREE, "°")
    fine, rows = dwell.fine, dwell.motion
    ends = [(each.at, factor * each.value) for each in dwell.extremes]
    far = max(ends, key=lambda end: abs(end[1]))
    return [
        _diagram(dwell, "S", unit, [("$S$", factor * fine.s, factor * rows.s, (far,))]),
        _diagram(dwell, "x_B", "mm", [("$x_B$", 1e3 * fine.b.real, 1e3 * rows.b.real, ())]),
        _diagram(dwell, "S'", unit, [("$S'$", factor * fine.ds, factor * rows.ds, ())]),
        _diagram(dwell, "S''", unit, [("$S''$", factor * fine.dds, factor * rows.dds, ())]),
    ]


def _of_forces(dwell: Dwell) -> list[Graph]:
    """Forces of the bars and the crank, pressure angle, driving moment."""
    fine, rows = dwell.fine, dwell.motion
    forces = [
        ("$R_{35}$", fine.f3, rows.f3, ()),
        ("$R_{45}$", fine.f4, rows.f4, ()),
        ("$R_{21}$", fine.r21, rows.r21, ()),
    ]
    return [
        _diagram(dwell, "R", "N", forces),
        _diagram(dwell, "δ", "°", [("$δ$", DEGREE * fine.delta, DEGREE * rows.delta, ())]),
        _diagram(dwell, "M_1", "N*m", [("$M_1$", fine.moment, rows.moment, ())]),
    ]


Curve = tuple[str, Real, Real, tuple[tuple[float, float], ...]]


def _diagram(dwell: Dwell, symbol: str, unit: str, curves: Sequence[Curve]) -> Graph:
    several = len(curves) > 1
    lines = tuple(
        Line(name if several else "", values, nodes, pen, marks)
        for (name, values, nodes, marks), pen in zip(curves, CURVES, strict=False)
    )
    return Graph(symbol, unit, True, dwell.fine.phi, dwell.motion.phi, lines)


def _panels(drawing: Drawing, box: Box, graphs: Sequence[Graph], dwell: Dwell) -> None:
    """The diagrams one under another, the dwell shaded."""
    for diagram in column(drawing, box, graphs):
        for low, high in _rests(dwell):
            diagram.band(DEGREE * low, DEGREE * high, DWELL)


def _rests(dwell: Dwell) -> list[tuple[float, float]]:
    """The dwell, turns of the crank along the motion: between the strokes."""
    ends = sorted((dwell.working, dwell.idle))
    after = max(end for _, end in ends)
    before = min(begin for begin, _ in ends)
    return [(low, high) for low, high in ((0.0, before), (after, 2 * math.pi)) if high - low > 1e-9]
