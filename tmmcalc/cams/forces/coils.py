"""The wire of a compression spring: c = G d^4/(8 D^3 n), tau = 8 Q D k_w/(pi d^3); and the springs that an allowed
stress leaves, by D/d.
"""

from __future__ import annotations

from math import pi, sqrt

from tmmcalc.cams.forces.results import Wire, WireSize
from tmmcalc.cams.task import CamTask, Spring
from tmmcalc.core.errors import NoSolutionError

INDEX = (4, 16)  # usual D/d
CLEARANCE = 0.1  # of the wire, between working coils at the highest position


def wound(task: CamTask, asked: Spring, stiffness: float, preload: float, highest: float) -> Wire | None:
    """Coils and stresses of the spring with the wire and the coil that are given."""
    d, coil = asked.wire, asked.coil
    if d is None or coil is None or stiffness <= 0 or task.asked.kind == "oscillating":
        return None
    index = coil / d
    if index <= 1:
        raise NoSolutionError(
            f"the wire of {1e3 * d:g} mm does not wind to coils of {1e3 * coil:g} mm mean diameter",
            where="cam_forces, spring",
            value=index,
            limit=1.0,
            remedy="a thinner wire or larger coils; usual is coil/wire = 4 to 12",
        )
    factor = wahl(index)
    stress = 8 * coil * factor / (pi * d**3)
    coils = asked.shear * d**4 / (8 * coil**3 * stiffness)
    return Wire(index, coils, factor, stress * highest, stress * preload)


def by_index(task: CamTask, asked: Spring, stiffness: float, highest: float) -> tuple[WireSize, ...]:
    """The springs of this stiffness whose stress at the highest position is the allowed one, for the usual D/d.

    d = sqrt(8 Q i k_w/(pi [tau])), D = i d, n = G d/(8 i^3 c), with i = D/d. Solid they are (n + dead coils) d high;
    free they add the gaps of the working coils and their deflection Q/c.
    """
    if asked.allowed is None or stiffness <= 0 or highest <= 0 or task.asked.kind == "oscillating":
        return ()
    found = []
    for index in range(INDEX[0], INDEX[1] + 1):
        d = sqrt(8 * highest * index * wahl(index) / (pi * asked.allowed))
        coils = asked.shear * d / (8 * index**3 * stiffness)
        solid = (coils + asked.dead) * d
        free = solid + CLEARANCE * d * coils + highest / stiffness
        found.append(WireSize(float(index), d, index * d, coils, solid, free))
    return tuple(found)


def wahl(index: float) -> float:
    """k_w of the stress at the inside of the coils."""
    return (4 * index - 1) / (4 * index - 4) + 0.615 / index
