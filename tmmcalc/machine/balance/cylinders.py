"""The inertia forces of one cylinder of a reciprocating engine, exactly and over the shaft.

The connecting rod is divided between crank pin and piston; with the crank's own unbalance that gives a rotating mass
at the pin and a reciprocating mass on the cylinder's axis. Directions are complex numbers in the plane across the
shaft; the shaft turns by phi, counter-clockwise positive, and the cylinder's crank stands at phi + crank_angle:

    alpha = phi + crank_angle - axis_angle                      crank against the axis of the cylinder
    s(alpha) = r cos alpha + sqrt(l^2 - (r sin alpha - e)^2)      piston from the shaft, along the axis
    F = -m_rec s'' omega^2 exp(i axis_angle) + m_rot r omega^2 exp(i (phi + crank_angle))

The couple of a force F at the position z along the shaft is (z - z0) F: a complex number whose direction is that of the
force that, at unit distance ahead of the reference plane z0, has it.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.fourier import Complex
from tmmcalc.core.numerics.roots import Values
from tmmcalc.core.records import record


@record
class Cylinder:
    """A cylinder with its crank, rod and masses. Raises `UsageError` for sizes that no engine has."""

    axis_angle: float  # direction from the shaft to the cylinder [rad]
    crank_angle: float  # of its crank where the shaft angle is 0 [rad]
    position_along_shaft: float  # z [m]
    crank_radius: float  # r [m]
    rod_length: float  # l [m]
    reciprocating_mass: float  # m_rec: piston and its part of the rod [kg]
    rotating_mass: float = 0.0  # m_rot at the radius r: pin, its part of the rod, the crank reduced to the pin [kg]
    offset: float = 0.0  # e: the cylinder's axis passes the shaft on the left at this distance [m]

    def __post_init__(self) -> None:
        """Refuse a crank that cannot turn, and negative masses."""
        where = f"cylinder at {self.position_along_shaft:g} m"
        if not self.crank_radius > 0:
            text = f"the crank radius {self.crank_radius:g} m is not positive"
            raise UsageError(text, where=where, value=self.crank_radius, limit=0.0, remedy="give r > 0")
        reach = self.crank_radius + abs(self.offset)
        if not reach < self.rod_length:
            text = f"the rod {self.rod_length:g} m is not longer than crank and offset, {reach:g} m"
            raise UsageError(text, where=where, value=self.rod_length, limit=reach, remedy="change the lengths")
        least = min(self.reciprocating_mass, self.rotating_mass)
        if not least >= 0:
            text = f"a mass of {least:g} kg is negative"
            raise UsageError(text, where=where, value=least, limit=0.0, remedy="give masses of zero or more")


def piston(alpha: Values, radius: float, rod: float, offset: float = 0.0) -> tuple[Values, Values, Values]:
    """Piston distance s [m] from the shaft, and its first and second derivative by the crank angle alpha.

    >>> s, _, acceleration = piston(np.array([0.0]), 0.5, 2.0)
    >>> float(s[0]), float(acceleration[0])
    (2.5, -0.625)
    """
    x, h = radius * np.cos(alpha), radius * np.sin(alpha)
    y = h - offset
    q = np.sqrt(rod * rod - y * y)
    q1 = -x * y / q
    q2 = (y * h - x * x - q1 * q1) / q
    return x + q, -h + q1, -x + q2


def cylinder_force(cylinder: Cylinder, phi: Values, speed: float) -> Complex:
    """Inertia force on the frame [N] at the shaft angles phi (n,), all harmonics included; ``speed`` [rad/s]."""
    c = cylinder
    crank = phi + c.crank_angle
    _, _, s2 = piston(crank - c.axis_angle, c.crank_radius, c.rod_length, c.offset)
    rotating = c.rotating_mass * c.crank_radius * np.exp(1j * crank)
    return speed * speed * (rotating - c.reciprocating_mass * s2 * np.exp(1j * c.axis_angle))


def middle(cylinders: Sequence[Cylinder]) -> float:
    """The middle between the outermost cylinders [m]; raises `UsageError` if there are none."""
    if not cylinders:
        raise UsageError("the engine has no cylinders", where="engine", remedy="give one cylinder at least")
    places = [c.position_along_shaft for c in cylinders]
    return (min(places) + max(places)) / 2
