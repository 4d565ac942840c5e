"""A resistance in proportion to the square of the velocity."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.records import record
from tmmcalc.linkage.loadlaws.resistance import Resistance

if TYPE_CHECKING:
    from tmmcalc.core.plane import Real


@record
class Quadratic(Resistance):
    """Against the velocity, -c v |v| [N*s^2/m^2 or N*m*s^2/rad^2]."""

    coefficient: float

    rank = 40
    order = 2
    key, formula = "quadratic", "-c v abs(v)"
    dimensions = ("quadratic damping", "torsional quadratic damping")
    examples = ("3.5 N*s^2/m^2", "0.02 N*m*s^2/rad^2")

    def against(self, factor: float, rate: Real) -> Real:
        """-c v |v|."""
        return -factor * self.coefficient * (rate * abs(rate))
