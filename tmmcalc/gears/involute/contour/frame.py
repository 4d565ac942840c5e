"""The plane of the shifts in the coordinates (w, x1): the operating pressure angle and the shift of wheel 1.

Everything that both wheels share depends on w alone, which replaces the sum of the shifts,

    s = x1 + x2 = a (inv w - inv alpha_t) cos(beta)/tan(alpha),   a_w = a cos(alpha_t)/cos(w),   y = a_w - a

and needs no iteration. On a line of constant sum every condition is unimodal in the shift x of the wheel it concerns:
the contact ratio and the tip thickness are concave, and the room N1A2 - LN before interference is convex with its least
value where the mate's tip circle is its reference circle. That value is never positive, and zero at w = alpha_t, for a
rack whose straight flank ends at h_a*; where it ends deeper, the areas on both sides are joined by a neck.
"""

from __future__ import annotations

from functools import cached_property
from math import acos, atan2, cos, hypot, pi, sin, tan

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record
from tmmcalc.gears.involute.contour.side import Side, Sloped, side_of
from tmmcalc.gears.involute.contour.task import Task
from tmmcalc.gears.involute.function import inverse_involute, involute
from tmmcalc.gears.involute.wheel import curvature
from tmmcalc.gears.model import Values

BRANCHES = (0, 1, 2, 3)
LOW: tuple[tuple[int, ...], ...] = ((), (1,), (0,), (0, 1))  # of each branch: wheels with the tip inside r
CROSSING = 60  # halvings


Chosen = NDArray[np.bool_] | NDArray[np.intp]


@record
class Sums:
    """What both wheels share on n lines of constant sum; lengths in normal modules."""

    angle: Values  # w = alpha_tw [rad], (n,)
    total: Values  # s = x1 + x2
    modification: Values  # y
    length: Values  # g = N1N2

    def some(self, which: Chosen) -> Sums:
        """Only the lines chosen by a mask or by numbers."""
        return Sums(self.angle[which], self.total[which], self.modification[which], self.length[which])


@record
class Frame:
    """The constants of a task."""

    task: Task
    sides: tuple[Side, Side]
    angle: float  # alpha_t [rad]
    pitch: float  # p_bt, transverse base pitch
    addendum: float  # h_a*
    slant: float  # tan(beta)

    @cached_property
    def level(self) -> float:
        """inv(alpha_t)."""
        return float(involute(self.angle))

    @property
    def neck(self) -> float:
        """How much deeper than h_a* the straight flank ends; 0 but for rounding: the branches touch in a point.

        Positive: they are joined. Negative: they are apart.
        """
        depth = self.task.first.rack.straight - self.addendum
        return depth if abs(depth) > 1e-12 else 0.0

    @cached_property
    def branches(self) -> tuple[int, ...]:
        """The branches that may have admissible shifts."""
        # a wheel with x_min > 0 whose tip is low would be undercut far into its flank
        found = (b for b in BRANCHES if all(self.sides[i].least <= 0 for i in LOW[b]))
        return tuple(b for b in found if b != 3 or self.neck > 0)  # only a deep flank leaves room for two low tips

    def sums(self, w: Values) -> Sums:
        """The shared quantities at operating angles (n,)."""
        one, two = self.sides
        base = one.base + two.base
        a = one.reference + two.reference
        rise = base * (involute(w) - self.level) / sin(self.angle)
        return Sums(w, rise, base / np.cos(w) - a, base * np.tan(w))

    def angle_of(self, total: Values) -> Values:
        """The operating angle of sums of shifts; nan below the least."""
        base = self.sides[0].base + self.sides[1].base
        return inverse_involute(self.level + np.asarray(total, float) * sin(self.angle) / base)

    def sum_slope(self, w: Values) -> Values:
        """ds/dw."""
        base = self.sides[0].base + self.sides[1].base
        return base * np.tan(w) ** 2 / sin(self.angle)

    def room(self, i: int, sums: Sums, x: Values) -> Sloped:
        """N1A2 - rho_F1 (i = 0) or N2A1 - rho_F2 (i = 1), and the derivative by x_i at constant sum."""
        side = self.sides[i]
        radius = side.mate_reference + self.addendum + sums.modification - x
        rho = curvature(radius, side.mate_base)
        start, slope = side.start(x)
        return sums.length - rho - start, radius / rho - slope

    def touch(self, sums: Sums) -> Values:
        """The least room (n,) of each line, of both wheels: where the tip of the mate is its reference circle."""
        base = self.sides[0].base + self.sides[1].base
        apart = 2 * base * np.sin((sums.angle - self.angle) / 2) ** 2 / np.cos(sums.angle)
        return (self.neck - apart) / sin(self.angle)

    @cached_property
    def joint(self) -> tuple[float, float]:
        """Operating angles between which both necks end below, and at which both tip lines cross; equal: no necks.

        The room on a tip line is positive down to the first one; at the other one both tip circles are the reference
        circles.
        """
        if self.neck <= 0:
            return self.angle, self.angle
        base = self.sides[0].base + self.sides[1].base
        turned = cos(self.angle) + self.neck / base
        end = atan2(sin(self.angle), turned) - acos(1 / hypot(sin(self.angle), turned))
        low, high = 1e-4, self.angle
        for _ in range(CROSSING):
            middle = (low + high) / 2
            sums = self.sums(np.array([middle]))
            outside = sums.total[0] > 2 * (sums.modification[0] + self.addendum)
            low, high = (middle, high) if outside else (low, middle)
        return end, high

    def room_roots(self, i: int, sums: Sums) -> tuple[Values, Values]:
        """x_i (n,) on both sides of the least room where the room of a flank without undercut vanishes.

        nan where it does not vanish. With u from the place of the least room e: (g - LN + k u)^2 = rho^2 is quadratic.
        """
        k, least = self.sides[i].steepness, self.touch(sums)
        span = k * k - 1
        tangent = self.sides[i].mate_reference / k
        with np.errstate(invalid="ignore"):
            turn = np.where(least <= 0, np.sqrt(least * least - 2 * span * tangent * least), np.nan)
        reach = sums.modification + self.addendum
        return reach - (turn - k * least) / span, reach + (turn + k * least) / span

    def overlap_roots(self, sums: Sums) -> tuple[Values, Values]:
        """x1 (n,) between which the contact ratio exceeds eps_min; nan where it does not fall to it on that side.

        With t = r_a2 the equation rho_a1 + rho_a2 = C of both tips is quadratic.
        """
        one, two = self.sides
        top = self.tip(1, sums, sums.total)  # r_a2 at x1 = 0
        both = self.tip(0, sums, np.zeros_like(top)) + top
        wanted = sums.length + self.task.contact_ratio * self.pitch
        n = both / wanted
        shift = (wanted * wanted - both * both + one.base**2 - two.base**2) / (2 * wanted)
        span = (n - 1) * (n + 1)
        with np.errstate(invalid="ignore", divide="ignore"):
            turn = np.sqrt(np.maximum(shift * shift - span * two.base**2, 0.0))  # 0 where both ends meet
            radii = (-n * shift + turn) / span, (-n * shift - turn) / span
            found = []
            for t in radii:
                rho = n * t + shift
                found.append(np.where((rho >= 0) & (rho <= wanted), top - t, np.nan))
        return found[0], found[1]

    def tip(self, i: int, sums: Sums, x: Values) -> Values:
        """r_a of the wheel itself."""
        return self.sides[i].reference + self.addendum + sums.modification - sums.total + x

    def thickness(self, i: int, sums: Sums, x: Values) -> Sloped:
        """Half the angle of the tip less the one of the least thickness [rad], and its derivative by x_i."""
        side = self.sides[i]
        radius = self.tip(i, sums, x)
        tangent = curvature(radius, side.base) / side.base
        own = np.arctan(tangent)
        half = side.flat + x * sin(self.angle) / side.base - (tangent - own)
        slope = (sin(self.angle) - np.sin(own)) / side.base
        if side.thickness:
            stretch = 1 / np.sqrt(1 + (radius * self.slant / side.reference) ** 2)
            half = half - side.thickness / (2 * radius * stretch)
            slope = slope + side.thickness * stretch / (2 * radius**2)
        return half, slope

    def overlap(self, sums: Sums, x1: Values) -> Sloped:
        """eps_alpha - eps_min, and its derivative by x1."""
        one, two = self.sides
        first, second = self.tip(0, sums, x1), self.tip(1, sums, sums.total - x1)
        rho1, rho2 = curvature(first, one.base), curvature(second, two.base)
        value = (rho1 + rho2 - sums.length) / self.pitch - self.task.contact_ratio
        return value, (first / rho1 - second / rho2) / self.pitch

    def best_split(self, sums: Sums) -> Values:
        """x1 of the largest contact ratio of each line: both tips at one pressure angle."""
        one, two = self.sides
        first, second = self.tip(0, sums, np.zeros_like(sums.total)), self.tip(1, sums, sums.total)
        return (second * one.base - first * two.base) / (one.base + two.base)


def frame_of(task: Task) -> Frame:
    """The frame of a task."""
    rack, cut = task.first.rack, task.first.section
    pitch = pi / cos(task.first.helix) * cos(cut.angle)
    one, two = task.first, task.second
    sides = (side_of(one, two, task.thickness[0], task.fillet), side_of(two, one, task.thickness[1], task.fillet))
    return Frame(task, sides, cut.angle, pitch, rack.addendum, tan(task.first.helix))
