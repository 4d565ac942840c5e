"""One external wheel in mesh with the rack that cuts it; all lengths in normal modules.

The reference circle r rolls on the rack's line at the distance x from the datum line. b, the end of the straight flank,
meets the line of action at L; the distance LN of L from the base circle is the involute's radius of curvature there:

    LN > 0  involute and fillet join smoothly at the radius r_L;  LN < 0  the tool undercuts the tooth
"""

from __future__ import annotations

from math import cos, pi, sin, tan
from typing import Any

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import inverse_involute, involute
from tmmcalc.gears.involute.rack import Rack, Section, transverse_angle
from tmmcalc.gears.model import Values

Number = float | Values
LEAST_CURVATURE = 1e-12  # [normal module] where an involute does not reach so far down


def curvature(radius: Any, base: Any) -> Any:
    """Radius of curvature of the involute at a radius, in numbers of any kind; tiny at and below the base circle."""
    return np.sqrt(np.maximum((radius - base) * (radius + base), LEAST_CURVATURE**2))


@record
class Wheel:
    """An external involute wheel; the shift may be an array, and then so is everything that depends on it."""

    teeth: int  # z
    shift: Number = 0.0  # x, positive: the rack is moved away from the centre
    helix: float = 0.0  # beta [rad]
    rack: Rack = Rack()

    @property
    def section(self) -> Section:
        """The rack across this wheel."""
        return Section(self.rack, self.helix)

    @property
    def transverse_angle(self) -> float:
        """alpha_t [rad], pressure angle on the reference circle (4.52)."""
        return transverse_angle(self.rack, self.helix)

    @property
    def reference(self) -> float:
        """Radius r of the reference circle."""
        return self.teeth / (2 * cos(self.helix))

    @property
    def base(self) -> float:
        """Radius r_b of the base circle (4.53)."""
        return self.reference * cos(self.transverse_angle)

    @property
    def root(self) -> Number:
        """Radius r_f of the root circle (4.54)."""
        return self.reference - (self.rack.addendum + self.rack.clearance - self.shift)

    @property
    def plain_tip(self) -> Number:
        """Radius of the tip circle without shortening, r + h_a* + x."""
        return self.reference + self.rack.addendum + self.shift

    @property
    def limit(self) -> Number:
        """LN, signed: radius of curvature at the limit point L (4.55); negative: undercut."""
        angle = self.transverse_angle
        return self.reference * sin(angle) - (self.rack.straight - self.shift) / sin(angle)

    @property
    def least_shift(self) -> float:
        """x_min: the least shift without undercut, exactly."""
        return self.rack.straight - self.reference * sin(self.transverse_angle) ** 2

    @property
    def half_angle(self) -> Number:
        """psi [rad]: half the angle of the tooth on the reference circle (4.96)."""
        return (pi / 2 + 2 * self.shift * tan(self.rack.angle)) / self.teeth

    def half_angle_at(self, radius: Number) -> Number:
        """theta [rad]: half the angle of the tooth at a radius of at least r_b; without meaning below, but finite."""
        turned = involute(np.arccos(np.clip(self.base / np.asarray(radius, dtype=float), -1.0, 1.0)))
        half: Values = self.half_angle + involute(self.transverse_angle) - turned
        return half

    def helix_at(self, radius: Number) -> Number:
        """Helix angle [rad] at a radius."""
        angle: Values = np.arctan(tan(self.helix) * np.asarray(radius) / self.reference)
        return angle

    def thickness_at(self, radius: Number) -> Number:
        """Arc thickness of the tooth in the normal section at a radius; negative above the pointing radius."""
        return 2 * radius * self.half_angle_at(radius) * np.cos(self.helix_at(radius))

    def curvature_at(self, radius: Number) -> Number:
        """Radius of curvature of the transverse involute at a radius; nan below the base circle."""
        r = np.asarray(radius, dtype=float)
        with np.errstate(invalid="ignore"):
            rho: Values = np.sqrt((r - self.base) * (r + self.base))
        return rho

    @property
    def base_pitch(self) -> float:
        """Transverse base pitch p_bt = p_t cos(alpha_t)."""
        return pi / cos(self.helix) * cos(self.transverse_angle)

    @property
    def pointing(self) -> Number:
        """Radius at which the flanks of the tooth meet in a point."""
        radius: Values = self.base / np.cos(inverse_involute(self.half_angle + involute(self.transverse_angle)))
        return radius
