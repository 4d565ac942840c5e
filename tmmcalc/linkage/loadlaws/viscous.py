"""A resistance in proportion to the velocity."""

from __future__ import annotations

from typing import TYPE_CHECKING

from tmmcalc.core.records import record
from tmmcalc.linkage.loadlaws.resistance import Resistance

if TYPE_CHECKING:
    from tmmcalc.core.plane import Real


@record
class Viscous(Resistance):
    """Against the velocity of the point along the direction (or the link's speed): -c v [N*s/m or N*m*s/rad]."""

    coefficient: float

    rank = 30
    order = 1
    key, formula = "viscous", "-c v"
    dimensions = ("damping", "torsional damping")
    examples = ("20 N*s/m", "0.5 N*m*s/rad")
    alike = True

    def against(self, factor: float, rate: Real) -> Real:
        """-c v."""
        return -factor * self.coefficient * rate
