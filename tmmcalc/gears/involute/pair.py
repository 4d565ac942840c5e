"""An external pair without backlash: from shifts to the centre distance and back; all lengths in normal modules.

    inv(alpha_tw) = inv(alpha_t) + 2 (x1 + x2) tan(alpha)/(z1 + z2)        a_w = a cos(alpha_t)/cos(alpha_tw)

The tips are shortened by dy = x1 + x2 - y, so that the radial clearance stays c*.
"""

from __future__ import annotations

from math import cos, tan

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.records import record
from tmmcalc.gears.involute.function import inverse_involute, involute
from tmmcalc.gears.involute.wheel import Number, Wheel


@record
class Pair:
    """Two external wheels in mesh; fields are arrays if the shifts are. nan: no such pair."""

    first: Wheel
    second: Wheel
    angle: Number  # alpha_tw [rad], operating transverse pressure angle
    distance: Number  # a_w
    tips: tuple[Number, Number]  # r_a1, r_a2

    @property
    def reference_distance(self) -> float:
        """a, the distance of two touching reference circles."""
        return self.first.reference + self.second.reference

    @property
    def stretch(self) -> Number:
        """eta = a_w/a: operating over reference radius."""
        return self.distance / self.reference_distance

    @property
    def modification(self) -> Number:
        """y = a_w - a, centre distance modification."""
        return self.distance - self.reference_distance

    @property
    def shortening(self) -> Number:
        """dy = x1 + x2 - y, of both tips."""
        return self.first.shift + self.second.shift - self.modification

    @property
    def operating(self) -> tuple[Number, Number]:
        """Radii r_w1, r_w2 of the operating pitch circles."""
        return self.first.reference * self.stretch, self.second.reference * self.stretch

    @property
    def length(self) -> Number:
        """g = N1N2, of the line of action between the base circles (4.66)."""
        return self.distance * np.sin(self.angle)

    @property
    def tip_curvatures(self) -> tuple[Number, Number]:
        """rho_a1 = N1A1, rho_a2 = N2A2: radii of curvature at the tips."""
        with np.errstate(invalid="ignore"):
            one, two = (np.sqrt(tip**2 - wheel.base**2) for tip, wheel in zip(self.tips, self.wheels, strict=True))
        return one, two

    @property
    def starts(self) -> tuple[Number, Number]:
        """N1A2, N2A1: radii of curvature of each wheel where the other's tip meets it."""
        first, second = self.tip_curvatures
        return self.length - second, self.length - first

    @property
    def clearances(self) -> tuple[Number, Number]:
        """Radial clearances at the roots of wheels 1 and 2."""
        return self.distance - self.tips[1] - self.first.root, self.distance - self.tips[0] - self.second.root

    @property
    def ratio(self) -> float:
        """u = z2/z1."""
        return self.second.teeth / self.first.teeth

    @property
    def wheels(self) -> tuple[Wheel, Wheel]:
        """Both wheels."""
        return self.first, self.second

    @property
    def contact_ratio(self) -> Number:
        """eps_alpha, transverse (4.67), with the whole flanks active."""
        first, second = self.tip_curvatures
        return (first + second - self.length) / self.first.base_pitch


def pair_of_shifts(first: Wheel, second: Wheel) -> Pair:
    """The pair of two wheels with their shifts; nan everywhere if the involute of its pressure angle were negative.

    >>> from math import degrees, radians
    >>> pair = pair_of_shifts(Wheel(14, 0.52, radians(15)), Wheel(27, 0.31, radians(15)))
    >>> round(degrees(float(pair.angle)), 4)
    25.3154
    """
    start, total = first.transverse_angle, first.teeth + second.teeth
    target = involute(start) + 2 * (first.shift + second.shift) * tan(first.rack.angle) / total
    angle = inverse_involute(target)
    distance = (first.reference + second.reference) * cos(start) / np.cos(angle)
    return pair_at(first, second, angle, distance)


def pair_at(first: Wheel, second: Wheel, angle: Number, distance: Number) -> Pair:
    """The pair at a known operating angle and centre distance, tips shortened to keep the clearance."""
    rack = first.rack
    tips = (
        distance - second.root - rack.clearance,
        distance - first.root - rack.clearance,
    )
    return Pair(first, second, angle, distance, tips)


def sum_of_shifts(first: Wheel, second: Wheel, distance: Number) -> tuple[Number, Number]:
    """x1 + x2 and the operating angle [rad] of a centre distance; nan below the sum of the base radii.

    Only the numbers of teeth, the helix and the rack of the wheels are read.
    """
    start, total = first.transverse_angle, first.teeth + second.teeth
    cosine = (first.reference + second.reference) * cos(start) / np.asarray(distance, dtype=float)
    with np.errstate(invalid="ignore"):
        angle = np.arccos(cosine)
    return total * (involute(angle) - involute(start)) / (2 * tan(first.rack.angle)), angle


def sum_from_distance(first: Wheel, second: Wheel, distance: float) -> tuple[float, float]:
    """`sum_of_shifts` of one centre distance in normal modules.

    Raises `NoSolutionError` if the distance does not exceed the sum of the base radii.
    """
    least = first.base + second.base
    if distance > least:
        total, angle = sum_of_shifts(first, second, distance)
        return float(total), float(angle)
    raise NoSolutionError(
        f"the centre distance of {distance:.6g} normal modules does not exceed the sum of the base radii, "
        f"{least:.6g} (margin {distance - least:.4g})",
        where="pair",
        value=distance,
        limit=least,
        remedy=f"a centre distance above {least:.6g} normal modules, near {first.reference + second.reference:.6g}; "
        "other numbers of teeth or another helix angle",
    )
