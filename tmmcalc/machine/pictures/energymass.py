"""Wittenbauer's picture: the closed energy-mass curve, its two outer tangents, the segment GH on the axis of energies.

Abscissa is the reduced inertia J of the links, ordinate the change A of the kinetic energy since position 0. Both
tangents meet far to the left and below, in the origin of the whole inertia and the whole energy.
"""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.machine.flywheel.wittenbauer import EnergyMass
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.curves import suited
from tmmcalc.report.drawing.diagram import Axis, Diagram
from tmmcalc.report.drawing.lettering import minus
from tmmcalc.report.drawing.pens import CURVES, MIDDLE, Pen
from tmmcalc.report.drawing.shapes import Drawing, Words
from tmmcalc.report.numbers import NOISE, number

CURVE, FAST, SLOW = CURVES[0]._replace(width=0.5), CURVES[1], CURVES[2]
SIDES = (16.0, 10.0, 2.0, 10.0)  # room around the frame: left, bottom, right, top [mm]
AIR = 0.08  # of the range of energies, above and below
NUMBERED = 12  # places of the cycle that are named
LEFT, RIGHT = 0.16, 0.1  # of the largest inertia, beside the axis and the curve


def draw_energy_mass(drawing: Drawing, box: Box, picture: EnergyMass, sense: float) -> None:
    """Curve, tangents and the axis of energies with its intercepts; ``sense`` is that of the input."""
    factor, unit = scale(picture)
    widest = float(np.max(picture.links)) or abs(picture.inertia) or 1.0
    x = np.array([-LEFT * widest, (1 + RIGHT) * widest])
    tangents = [(b + k * x) * factor for k, b in zip(picture.slopes, picture.intercepts, strict=True)]
    heights = np.concatenate((picture.work * factor, *tangents))
    air = AIR * float(np.ptp(heights)) or 1.0
    across = Axis("$J$ of the links, kg·m²", *x.tolist())
    up = Axis(f"$A$, {unit}", float(heights.min()) - air, float(heights.max()) + air)
    diagram = Diagram(drawing, box.inset(*SIDES), across, up)
    for values, pen in zip(tangents, (FAST, SLOW), strict=True):
        diagram.curve(x + 1j * values, pen)
    diagram.curve(picture.links + 1j * picture.work * factor, CURVE, level=5)
    diagram.vertical(0.0, MIDDLE)
    drawing.add(Words(complex(diagram.box.left, box.top), _meeting(picture), 2.1, -1 + 1j))
    _mark_tangents(diagram, picture, factor, unit)
    _number(diagram, picture, factor, sense)


def _meeting(picture: EnergyMass) -> str:
    factor, unit = suited(picture.energy, "J")
    inertia, energy = (minus(number(-value, 4)) for value in (picture.inertia, picture.energy * factor))
    first = "Energy-mass curve; numbers: degrees of $φ$; slopes: half the squares of the extreme speeds"
    return f"{first}\nthe tangents meet at $J$ = {inertia} kg·m², $A$ = {energy} {unit}"


def scale(picture: EnergyMass) -> tuple[float, str]:
    """Factor and unit of the energies."""
    return suited(max(float(np.max(np.abs(picture.work))), *map(abs, picture.intercepts)), "J")


def _mark_tangents(diagram: Diagram, picture: EnergyMass, factor: float, unit: str) -> None:
    """G and H with the segment between them, and the touching points."""
    high, low = (value * factor for value in picture.intercepts)
    below, above = diagram.place(complex(0, low)), diagram.place(complex(0, high))
    segment = Pen("DIMENSIONS", 0.4)
    diagram.drawing.vector(below, above, segment, level=6)
    diagram.drawing.vector(above, below, segment, level=6)
    diagram.labels.avoid((below, above))
    labels, gaps = diagram.labels, (1.0, 1.8, 2.8)
    for name, value, pen in (("G", high, FAST), ("H", low, SLOW)):
        at = diagram.point(complex(0, value), pen)
        labels.put(f"${name}$: {minus(number(value, 5))} {unit}", [at], gaps=gaps, colour=pen.colour)
    for word, theta, pen in (("max", picture.touching[0], FAST), ("min", picture.touching[1], SLOW)):
        inertia, work = _at(picture, theta)
        at = diagram.point(complex(inertia, work * factor), pen)
        labels.put(f"$ω_{{{word}}}$", [at], gaps=gaps, colour=pen.colour)
    middle = diagram.place(complex(0, (high + low) / 2))
    labels.put(f"$GH$ = {minus(number(high - low, 5))} {unit}", [middle], prefer=1, gaps=gaps)


def _number(diagram: Diagram, picture: EnergyMass, factor: float, sense: float) -> None:
    """Dots at equal steps of the input with their angles."""
    for theta in np.linspace(0.0, float(picture.theta[-1]), NUMBERED, endpoint=False).tolist():
        inertia, work = _at(picture, theta)
        at = diagram.point(complex(inertia, work * factor), CURVE, 0.4, CURVE.colour)
        degrees = math.degrees(theta)
        text = minus(number(round(sense * degrees if abs(degrees) > NOISE else 0.0, 6), 6))
        diagram.labels.put(text, [at], height=1.7, gaps=(0.7, 1.3, 2.1), colour=CURVE.colour)


def _at(picture: EnergyMass, theta: float) -> tuple[float, float]:
    inertia, work = (float(np.interp(theta, picture.theta, v)) for v in (picture.links, picture.work))
    return inertia, work
