"""What the constructions of the textbooks give when they are read from paper with a ruler, beside the exact numbers.

Wittenbauer   J_F = GH mu_A / (delta omega^2),  omega = sqrt(2 tan psi mu_A / mu_J)                   (3.50), (3.53)
Mertsalov     J_F = (y_max - y_min) mu_A / (delta omega^2) on the curve of A less the energy of the links
Artobolevsky  J_F = [(y_a - y_b) mu_A - (z_a (1 + delta) - z_b (1 - delta)) mu_J omega^2/2] / (delta omega^2)

y are ordinates of works, z those of the inertia, a and b the places of the largest and the least work.
"""

from __future__ import annotations

import math
from typing import Literal, NamedTuple

from tmmcalc.machine.flywheel.wittenbauer import EnergyMass
from tmmcalc.machine.flywheel.worked import Worked, paper

LENGTH, ANGLE = 0.1, 0.1  # what a ruler tells [mm], and a protractor [deg]


class Reading(NamedTuple):
    """What is measured on paper and what it stands for, beside the exact value."""

    symbol: str  # as a formula
    read: float  # [mm or deg]
    of: Literal["mm", "°"]
    value: float  # by the scale factors, in the unit
    exact: float
    unit: str

    @property
    def error(self) -> float:
        """Relative; 0 where the exact value is 0 and was read so."""
        return (self.value - self.exact) / abs(self.exact) if self.exact else self.value


class Construction(NamedTuple):
    """The readings of one construction, and the inertia that follows [kg*m^2]."""

    readings: tuple[Reading, ...]
    inertia: float  # from the readings
    exact: float  # by the same method without a drawing

    @property
    def error(self) -> float:
        """Relative."""
        return (self.inertia - self.exact) / abs(self.exact) if self.exact else 0.0


def wittenbauer(picture: EnergyMass, scales: tuple[float, float], delta: float) -> Construction:
    """From the segment GH and the angles at the ``scales`` mu_A [J/mm] and mu_J [kg*m^2/mm]."""
    mu_a, mu_j = scales
    drawn = paper(picture, scales)
    segment = _length("GH", drawn.segment * mu_a, mu_a, "J")
    angles = tuple(
        _angle(f"ψ_{{{word}}}", angle, 2 * mu_a / mu_j)
        for word, angle in (("max", drawn.angle_max), ("min", drawn.angle_min))
    )
    inertia = segment.value / (delta * picture.speed**2)
    return Construction((segment, *angles), inertia, picture.inertia)


def mertsalov(row: Worked, mu_a: float) -> Construction:
    """From the extreme ordinates of A - J omega^2/2; ``row`` is what the method works out."""
    high, low = _length("y_{max}", row.intercept_max, mu_a, "J"), _length("y_{min}", row.intercept_min, mu_a, "J")
    return Construction((high, low), (high.value - low.value) / row.divisor, row.inertia)


def artobolevsky(row: Worked, scales: tuple[float, float], delta: float) -> Construction:
    """From the extreme ordinates of A and those of J at the same places."""
    mu_a, mu_j = scales
    works = _length("y_a", row.work_max, mu_a, "J"), _length("y_b", row.work_min, mu_a, "J")
    links = _length("z_a", row.links_max, mu_j, "kg*m^2"), _length("z_b", row.links_min, mu_j, "kg*m^2")
    half = row.divisor / delta / 2
    energy = half * (links[0].value * (1 + delta) - links[1].value * (1 - delta))
    return Construction((*works, *links), (works[0].value - works[1].value - energy) / row.divisor, row.inertia)


def _length(symbol: str, exact: float, mu: float, unit: str) -> Reading:
    read = round(exact / mu / LENGTH) * LENGTH
    return Reading(symbol, read, "mm", read * mu, exact, unit)


def _angle(symbol: str, exact: float, factor: float) -> Reading:
    """An angle [rad] with the speed that follows, omega^2 = ``factor`` tan psi."""
    read = round(math.degrees(exact) / ANGLE) * ANGLE
    value, true = (math.sqrt(factor * math.tan(psi)) for psi in (math.radians(read), exact))
    return Reading(symbol, read, "°", value, true, "rad/s")
