"""The basic rack: the straight-sided profile that cuts both wheels, and its section across a helical wheel.

     ______ tip flat, (h_a* + c*) m from the datum line
    /rho
   /          straight flank, inclined by alpha; its end b lies h_a* m from the datum line
--/------- datum line
"""

from __future__ import annotations

from dataclasses import replace
from math import atan, cos, degrees, floor, pi, radians, sin, tan

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record

SLIGHT = 1e-12  # [module] lack of width that is rounding
BISECTIONS = 50
LEAST_ANGLE = radians(10)  # profile angles below it are not proposed


@record
class Rack:
    """Basic rack tooth profile in the normal section; lengths in normal modules."""

    angle: float = quantity("alpha[rad]", "profile angle", default=radians(20))
    addendum: float = quantity("h_a", "addendum in modules", symbol="h_a^*", default=1.0)
    clearance: float = quantity("c", "radial clearance in modules", symbol="c^*", default=0.25)
    tip_radius: float | None = None  # rho*; None: the largest that ends with the straight flank, c*/(1 - sin alpha)

    @property
    def full_radius(self) -> float:
        """rho* of a tip rounded from flank to flank, the largest there is; negative: the flanks meet before the tip."""
        room = pi / 4 - (self.addendum + self.clearance) * tan(self.angle)
        return room * cos(self.angle) / (1 - sin(self.angle))

    @property
    def usual_radius(self) -> float:
        """c*/(1 - sin alpha): the rounding begins at the depth h_a*."""
        return self.clearance / (1 - sin(self.angle))

    @property
    def limited(self) -> bool:
        """Whether the rack has no radius of its own, and is too narrow for the usual one: its tip is fully rounded."""
        return self.tip_radius is None and self.full_radius < self.usual_radius

    @derived("rho", "radius of the tip rounding in modules", symbol="rho^*")
    def radius(self) -> float:
        """Radius rho* of the tip rounding."""
        if self.tip_radius is not None:
            return self.tip_radius
        return max(self.full_radius, 0.0) if self.limited else self.usual_radius

    @property
    def rounded(self) -> float:
        """Height of the tip rounding, from b to the tip: c* unless the rack has another radius than the usual one."""
        if self.tip_radius is None and not self.limited:
            return self.clearance
        return self.radius * (1 - sin(self.angle))

    @property
    def straight(self) -> float:
        """Depth of b, the end of the straight flank, below the datum line: h_a* with the usual radius."""
        if self.tip_radius is None and not self.limited:
            return self.addendum
        return self.addendum + self.clearance - self.rounded

    @property
    def tip_flat(self) -> float:
        """Half the width of the flat of the tip in the normal section; negative: the tool cannot exist."""
        return pi / 4 - self.straight * tan(self.angle) - self.radius * cos(self.angle)


def transverse_angle(rack: Rack, helix: float) -> float:
    """Transverse profile angle alpha_t [rad] (4.52)."""
    return atan(tan(rack.angle) / cos(helix))


@record
class Section:
    """A rack cut across a wheel of helix angle beta; lengths in normal modules (4.52)."""

    rack: Rack
    helix: float  # beta [rad]

    @property
    def angle(self) -> float:
        """Transverse profile angle alpha_t [rad]."""
        return transverse_angle(self.rack, self.helix)

    @property
    def module(self) -> float:
        """Transverse module m_t over the normal one."""
        return 1 / cos(self.helix)

    @derived("rho_t*", "radius of the circle that stands for the ellipse of the tip rounding", symbol="rho_t^*")
    def radius(self) -> float:
        """rho_t*: the circle that stands for the ellipse of the tip rounding, of the same height of its end."""
        return self.rack.rounded / (1 - sin(self.angle))

    @property
    def base_helix(self) -> float:
        """Helix angle beta_b [rad] at the base cylinder."""
        from math import asin

        return asin(sin(self.helix) * cos(self.rack.angle))


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
    """The section of a rack; raises `NoSolutionError` as `require_tool` does.

    >>> round(section(Rack(), radians(10)).radius, 6)
    0.382653
    """
    require_tool(rack)
    return Section(rack, helix)


def require_tool(rack: Rack) -> None:
    """Raise `NoSolutionError` if the tip of a rack would be wider than its tooth, with all that would do instead."""
    flat = rack.tip_flat
    if flat >= -SLIGHT:
        return
    own = rack.radius if rack.tip_radius is not None else 0.0
    # the deepest tip whose rounding still stands between the flanks
    depth = (pi / 4 - own * (1 - sin(rack.angle)) / cos(rack.angle)) / tan(rack.angle)
    angle = _largest_angle(rack, own)
    remedies = [f"a profile angle of at most {degrees(angle):.2f} deg"] if angle > LEAST_ANGLE else []
    if depth > rack.clearance:
        remedies.append(f"an addendum of at most {_down(depth - rack.clearance):g}")
    if depth > rack.addendum:
        remedies.append(f"a clearance of at most {_down(depth - rack.addendum):g}")
    if own and rack.full_radius > 0:
        remedies.insert(0, f"a tip radius of at most {_down(rack.full_radius):g}")
    what = f"the tip rounding of radius {own:g}" if own else "the tip"
    raise NoSolutionError(
        f"{what} is wider than the tooth of the rack by {-2 * flat:.4g} of the module",
        where="basic rack",
        value=flat,
        limit=0.0,
        remedy=", or ".join(remedies) or "a smaller tip radius, addendum, clearance and profile angle",
    )


def _down(value: float) -> float:
    """Four decimals, rounded towards zero."""
    return floor(value * 1e4) / 1e4


def _largest_angle(rack: Rack, radius: float) -> float:
    """The angle at which the tip is fully rounded, rounded down to a hundredth of a degree."""
    low, high = 0.0, rack.angle
    for _ in range(BISECTIONS):
        middle = (low + high) / 2
        if replace(rack, angle=middle, tip_radius=radius).tip_flat >= 0:
            low = middle
        else:
            high = middle
    return radians(floor(degrees(low) * 100) / 100)
