"""Wittenbauer's picture: the closed energy-mass curve, its two outer tangents, the segment GH on the axis of energies.

Abscissa is the reduced inertia J of the links, ordinate the change A of the kinetic energy since position 0, both to
standard scale factors, so that the angles of the tangents can be measured: tan ψ = ω² μ_J/(2 μ_A). The tangents meet
far to the left and below, in the origin of the whole inertia and the whole energy.
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.plane import Plane
from tmmcalc.machine.flywheel.wittenbauer import EnergyMass
from tmmcalc.machine.flywheel.worked import paper, round_scales
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import scale_factor, suited
from tmmcalc.report.drawing.diagram import Axis, Diagram
from tmmcalc.report.drawing.lettering import minus, width
from tmmcalc.report.drawing.pens import CURVES, DIMENSION, MIDDLE, THIN
from tmmcalc.report.drawing.shapes import Arc, Dimension, Drawing, Words
from tmmcalc.report.language import tr, tr_unit
from tmmcalc.report.numbers import NOISE, number

CURVE, FAST, SLOW = CURVES[0]._replace(width=0.5), CURVES[1], CURVES[2]
SIDES = (18.0, 11.0, 2.0, 11.0)  # room around the frame: left, bottom, right, top [mm]
BEFORE, AFTER, AIR = 17.0, 9.0, 9.0  # in the frame: left of the axis, right of the curve, below and above [mm]
NUMBERED = 12  # places of the cycle that are named
LEG = 24.0  # of the level line that an angle is measured from [mm]
BEYOND = 14.0  # how far a tangent goes on where it has touched [mm]


def _frame(box: Box, larger: float) -> Box:
    """The frame in a rectangle, where words are so many times ``larger`` than usual."""
    left, bottom, right, top = SIDES
    return box.inset(left * larger, bottom * larger, right, top * larger)


def draw_energy_mass(
    drawing: Drawing, box: Box, picture: EnergyMass, sense: float, scales: tuple[float, float] | None = None
) -> Diagram:
    """Curve, tangents with their angles and the axis of energies; ``sense`` is that of the input.

    ``scales`` are mu_A [J/mm] and mu_J [kg*m^2/mm]; by default the largest standard ones for the rectangle.
    """
    larger = drawing.letters
    frame = _frame(box, larger)
    told, before = _meeting(picture), BEFORE * larger
    free = frame.width - before - AFTER * larger, frame.height - 2 * AIR * larger
    mu_a, mu_j = scales or round_scales(picture, *free)
    factor, unit = suited(max(float(np.max(np.abs(picture.work))), *map(abs, picture.intercepts)), "J")
    heights = [*picture.work, *picture.intercepts]
    low = (max(heights) + min(heights)) / 2 - frame.height / 2 * mu_a
    across = Axis(
        tr("$J$ of the links, kg·m²") + f"; {scale_factor('J', mu_j, 'kg*m^2')}",
        -before * mu_j,
        (frame.width - before) * mu_j,
    )
    ends = (low * factor, (low + frame.height * mu_a) * factor)
    up = Axis(f"$A$, {unit}; {scale_factor('A', mu_a * factor, unit)}", *ends)
    diagram = Diagram(drawing, frame, across, up)
    for k, pen in enumerate((FAST, SLOW)):
        diagram.curve(_tangent(picture, k, mu_j).real + 1j * factor * _tangent(picture, k, mu_j).imag, pen)
    diagram.curve(picture.links + 1j * picture.work * factor, CURVE, level=5)
    diagram.vertical(0.0, MIDDLE)
    diagram.labels.avoid(diagram.paper([complex(0, up.low), complex(0, up.high)]))
    diagram.labels.avoid(diagram.paper([complex(across.low, 0), complex(across.high, 0)]))
    drawing.add(Words(complex(frame.left, box.top), told, min(2.1 * larger, frame.width / width(told)), -1 + 1j))
    _measure(diagram, picture, (mu_a, mu_j), factor)
    _mark_tangents(diagram, picture, factor)
    _number(diagram, picture, factor, sense)
    return diagram


def _tangent(picture: EnergyMass, k: int, mu_j: float) -> Plane:
    """A tangent (2,), from the axis to beyond the place where it touches: inertia + i energy."""
    touched, _ = at(picture, picture.touching[k])
    x = np.array([-0.5 * BEFORE * mu_j, touched + BEYOND * mu_j])
    return np.asarray(x + 1j * (picture.intercepts[k] + picture.slopes[k] * x))


def _meeting(picture: EnergyMass) -> str:
    factor, unit = suited(picture.energy, "J")
    inertia, energy = (minus(number(-value, 4)) for value in (picture.inertia, picture.energy * factor))
    peak = max(abs(picture.upper), abs(picture.lower))
    return (
        tr("Energy-mass curve; numbers: degrees of $φ$; tan $ψ$ = $ω^2 μ_J/(2 μ_A)$")
        + "\n"
        + tr(
            "$G$: {upper} J, $H$: {lower} J; the tangents meet at $J$ = {inertia} kg·m², $A$ = {energy}",
            upper=minus(number(picture.upper, 5, peak)),
            lower=minus(number(picture.lower, 5, peak)),
            inertia=inertia,
            energy=f"{energy} {unit}",
        )
    )


def _measure(diagram: Diagram, picture: EnergyMass, scales: tuple[float, float], factor: float) -> None:
    """The segment GH in mm, and the angles of both tangents from level lines."""
    measured = paper(picture, scales)
    high, low = (diagram.place(complex(0, value * factor)) for value in picture.intercepts)
    larger = diagram.drawing.letters
    side = -0.62 * BEFORE * larger
    diagram.drawing.add(Dimension(low, high, low + side, "", 2.3), level=6)
    diagram.labels.avoid([low + side, high + side])
    zero = diagram.place(0j).imag  # a line that the words keep clear of
    ends = [low.imag, min(max(zero, low.imag), high.imag), high.imag]
    middle = (ends[0] + ends[1]) / 2 if ends[1] - ends[0] > ends[2] - ends[1] else (ends[1] + ends[2]) / 2
    text = f"$GH$ = {number(measured.segment, 4)} {tr_unit('mm')}"
    words = Words(complex((low + side).real - 0.9, middle), text, 2.3 * larger, -1j, math.pi / 2, clear=True)
    diagram.drawing.add(words, level=6)
    for vertex, angle, word, pen in (
        (high, measured.angle_max, "max", FAST),
        (low, measured.angle_min, "min", SLOW),
    ):
        level, solid = [vertex, vertex + LEG], DIMENSION._replace(colour=pen.colour)
        diagram.drawing.line(level, THIN, level=2)
        diagram.labels.avoid(level, 0.6)
        radius = 0.8 * LEG
        diagram.drawing.add(Arc(vertex, radius, solid, 0.0, angle), level=6)
        arc = vertex + radius * np.exp(1j * np.linspace(0.0, angle, 12))
        diagram.labels.avoid(arc.tolist())
        text = f"$ψ_{{{word}}}$ = {number(math.degrees(angle), 4)}°"
        beside = [vertex + LEG * np.exp(0.5j * angle), vertex + 0.5 * LEG, vertex + LEG]
        diagram.labels.put(text, beside, gaps=(0.8, 1.6, 2.6, 4.0), prefer=1 - 1j, colour=pen.colour)


def _mark_tangents(diagram: Diagram, picture: EnergyMass, factor: float) -> None:
    """G, H and the touching points, with their names."""
    labels, gaps = diagram.labels, (1.0, 1.8, 2.8, 4.2, 6.0)
    for name, value, pen in (("G", picture.upper, FAST), ("H", picture.lower, SLOW)):
        place = diagram.point(complex(0, value * factor), pen)
        labels.put(f"${name}$", [place], gaps=gaps, colour=pen.colour)
    for word, theta, pen in (("max", picture.touching[0], FAST), ("min", picture.touching[1], SLOW)):
        inertia, work = at(picture, theta)
        place = diagram.point(complex(inertia, work * factor), pen)
        labels.put(f"$ω_{{{word}}}$", [place], gaps=gaps, colour=pen.colour)


def _number(diagram: Diagram, picture: EnergyMass, factor: float, sense: float) -> None:
    """Dots at equal steps of the input with their angles."""
    for theta in numbered(picture):
        inertia, work = at(picture, theta)
        place = diagram.point(complex(inertia, work * factor), CURVE, 0.4, CURVE.colour)
        degrees = math.degrees(theta)
        text = minus(number(round(sense * degrees if abs(degrees) > NOISE else 0.0, 6), 6))
        diagram.labels.put(text, [place], height=1.7, gaps=(0.7, 1.3, 2.1), colour=CURVE.colour)


def numbered(picture: EnergyMass) -> list[float]:
    """Places of the cycle that are named [rad], equal steps."""
    return np.linspace(0.0, float(picture.theta[-1]), NUMBERED, endpoint=False).tolist()


def at(picture: EnergyMass, theta: float) -> tuple[float, float]:
    """Inertia and work at a place of the cycle."""
    inertia, work = (float(np.interp(theta, picture.theta, v)) for v in (picture.links, picture.work))
    return inertia, work
