"""A balance weight from its static moment: what matters is mass times radius, one of the two is chosen.

A static moment is a complex number [kg*m]: mass times the vector from the axis to the centre of the weight.
"""

from __future__ import annotations

import cmath
import math

from tmmcalc.core.errors import UsageError
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record


@record
class Weight:
    """A weight at a radius from its axis."""

    mass: float = quantity("mass[kg]", "mass of the weight")
    radius: float = quantity("radius[m]", "radius of the centre of the weight")
    angle: float = quantity("angle[rad]", "angle of the centre of the weight, in the axes of its static moment")

    @property
    def moment(self) -> complex:
        """Static moment [kg*m]."""
        return self.mass * cmath.rect(self.radius, self.angle)


def sized(moment: complex, *, mass: float | None = None, radius: float | None = None) -> Weight:
    """The weight with this static moment [kg*m] and the chosen ``mass`` [kg] or ``radius`` [m].

    Raises `UsageError` unless exactly one of the two is given, positive.

    >>> sized(-0.6, radius=0.3)
    Weight(mass=2.0, radius=0.3, angle=3.141592653589793)
    """
    check_choice(mass, radius)
    size, angle = abs(moment), cmath.phase(moment)
    if mass is not None:
        return Weight(mass, size / mass, angle)
    assert radius is not None
    return Weight(size / radius, radius, angle)


def check_choice(mass: float | None, radius: float | None, where: str = "counterweight") -> None:
    """Raise `UsageError` unless exactly one of mass [kg] and radius [m] is given, finite and positive."""
    given = [value for value in (mass, radius) if value is not None]
    if len(given) != 1:
        which = "both are given" if given else "neither is given"
        raise UsageError(
            f"choose the mass or the radius of the weight: {which}",
            where=where,
            remedy="give one; the other follows from the static moment",
        )
    if not (given[0] > 0 and math.isfinite(given[0])):
        name = "mass" if mass is not None else "radius"
        raise UsageError(
            f"{name} {given[0]:g} is not positive",
            where=where,
            value=given[0],
            limit=0.0,
            remedy=f"choose a {name} > 0",
        )


def in_planes(moment: complex, couple: complex, planes: tuple[float, float]) -> tuple[complex, complex]:
    """Static moments [kg*m] in two planes at z [m] with this resultant and this couple sum z U [kg*m^2] about z = 0.

    Raises `UsageError` if the planes coincide.

    >>> in_planes(3.0, 2.0, (0.0, 1.0))
    (1.0, 2.0)
    """
    low, high = planes
    if low == high:
        text = f"both planes lie at {low:g} m"
        raise UsageError(text, where="balancing planes", value=low, remedy="two planes at a distance can hold a couple")
    second = (couple - low * moment) / (high - low)
    return moment - second, second
