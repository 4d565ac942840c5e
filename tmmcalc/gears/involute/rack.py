"""The basic rack: the straight-sided profile that cuts both wheels, and its section across a helical wheel.

     ______ tip flat, (h_a* + c*) m from the datum line
    /rho
   /          straight flank, inclined by alpha; its end b lies h_a* m from the datum line
--/------- datum line
"""

from __future__ import annotations

from math import atan, cos, pi, radians, sin, tan

from tmmcalc.errors import NoSolutionError
from tmmcalc.records import record


@record
class Rack:
    """Basic rack tooth profile in the normal section; lengths in normal modules."""

    angle: float = radians(20)  # alpha [rad]
    addendum: float = 1.0  # h_a*
    clearance: float = 0.25  # c*
    tip_radius: float | None = None  # rho*; None: the largest that ends with the straight flank, c*/(1 - sin alpha)

    @property
    def radius(self) -> float:
        """Radius rho* of the tip rounding."""
        return self.clearance / (1 - sin(self.angle)) if self.tip_radius is None else self.tip_radius

    @property
    def straight(self) -> float:
        """Depth of b, the end of the straight flank, below the datum line: h_a* unless the rack has its own radius."""
        if self.tip_radius is None:
            return self.addendum
        return self.addendum + self.clearance - self.tip_radius * (1 - sin(self.angle))


@record
class Section:
    """A rack cut across a wheel of helix angle beta; lengths in normal modules (4.52)."""

    rack: Rack
    helix: float  # beta [rad]

    @property
    def angle(self) -> float:
        """Transverse profile angle alpha_t [rad]."""
        return atan(tan(self.rack.angle) / cos(self.helix))

    @property
    def module(self) -> float:
        """Transverse module m_t over the normal one."""
        return 1 / cos(self.helix)

    @property
    def radius(self) -> float:
        """rho_t*: the circle that stands for the ellipse of the tip rounding, of the same height of its end."""
        rack = self.rack
        if rack.tip_radius is not None:
            return rack.tip_radius * (1 - sin(rack.angle)) / (1 - sin(self.angle))
        return rack.clearance / (1 - sin(self.angle))

    @property
    def base_helix(self) -> float:
        """Helix angle beta_b [rad] at the base cylinder."""
        from math import asin

        return asin(sin(self.helix) * cos(self.rack.angle))

    @property
    def tip_flat(self) -> float:
        """Half the width of the flat of the tip, in normal modules; negative: the tool cannot exist."""
        return pi / 4 * self.module - self.rack.straight * tan(self.angle) - self.radius * cos(self.angle)


RACKS: dict[str, Rack] = {
    "GOST 13755": Rack(),
    "ISO 53 A": Rack(radians(20), 1.0, 0.25, 0.38),
    "ISO 53 B": Rack(radians(20), 1.0, 0.25, 0.30),
    "ISO 53 C": Rack(radians(20), 1.0, 0.25, 0.25),
    "ISO 53 D": Rack(radians(20), 1.0, 0.40, 0.39),
    "AGMA 14.5": Rack(radians(14.5), 1.0, 0.157, 0.209),
    "stub 20": Rack(radians(20), 0.8, 0.30, 0.304),
}


def section(rack: Rack, helix: float = 0.0) -> Section:
    """The section of a rack; raises `NoSolutionError` if its tip would be wider than its tooth.

    >>> round(section(Rack(), radians(10)).radius, 6)
    0.382653
    """
    cut = Section(rack, helix)
    if cut.tip_flat < -1e-12:
        raise NoSolutionError(
            "the tip rounding is wider than the tooth of the rack",
            where="basic rack",
            value=cut.tip_flat,
            limit=0.0,
            remedy="a smaller tip radius, addendum, clearance or profile angle",
        )
    return cut
