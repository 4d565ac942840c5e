"""The conditions of a contour in extended precision, to measure what rounding leaves of its edges and corners."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from tmmcalc.core.numerics.extended import PI
from tmmcalc.core.records import record
from tmmcalc.gears.involute.contour.frame import Frame
from tmmcalc.gears.involute.function import Long, inverse_extended, involute_extended
from tmmcalc.gears.involute.wheel import Wheel, curvature
from tmmcalc.gears.model import Values


@record
class ExactSide:
    """One wheel; scalars are longdoubles."""

    reference: Any
    base: Any
    least: Any  # x_min
    flat: Any  # psi at x = 0, + inv alpha_t [rad]


@record
class Exact:
    """The constants of a frame from the data of its task alone; scalars are longdoubles."""

    frame: Frame
    sides: tuple[ExactSide, ExactSide]
    sine: Any  # of alpha_t
    level: Any  # inv(alpha_t)
    pitch: Any  # p_bt
    slant: Any  # tan(beta)

    @property
    def centres(self) -> Any:
        """a of wheels without shifts."""
        return self.sides[0].reference + self.sides[1].reference

    @property
    def bases(self) -> Any:
        """Both base circles' radii together."""
        return self.sides[0].base + self.sides[1].base

    def angle_of(self, total: Values) -> Long:
        """Operating angles (m,) of sums of shifts."""
        return inverse_extended(self.level + np.asarray(total, np.longdouble) * self.sine / self.bases)

    def values(self, w: Values, x1: Values) -> Long:
        """All conditions by the rows of `corners` (9, m) at operating angles (m,)."""
        angle, first = np.asarray(w, np.longdouble), np.asarray(x1, np.longdouble)
        total = self.bases * (involute_extended(angle) - self.level) / self.sine
        shifts = first, total - first
        reach = self.bases / np.cos(angle) - self.centres + np.longdouble(self.frame.addendum)
        length = self.bases * np.tan(angle)
        tips = [side.reference + reach - shifts[1 - i] for i, side in enumerate(self.sides)]
        rho = [curvature(tip, side.base) for tip, side in zip(tips, self.sides, strict=True)]
        rooms = [length - rho[1 - i] - self._start(i, shifts[i]) for i in (0, 1)]
        thick = [self._thickness(i, shifts[i], tips[i], rho[i]) for i in (0, 1)]
        ratio = (rho[0] + rho[1] - length) / self.pitch - self.frame.task.contact_ratio
        under = [x - side.least for x, side in zip(shifts, self.sides, strict=True)]
        return np.array([*rooms, *thick, ratio, *under, reach - shifts[1], reach - shifts[0]])

    def _start(self, i: int, x: Long) -> Long:
        """rho_F of the wheel; below x_min the same polynomial as that of the frame."""
        side = self.frame.sides[i]
        plain: Long = (x - self.sides[i].least) / self.sine
        if not np.any(x < side.least):
            return plain
        return np.asarray(replace(side.form, steepness=1 / self.sine, least=self.sides[i].least)(x)[0])

    def _thickness(self, i: int, x: Long, tip: Long, rho: Long) -> Long:
        side, least = self.sides[i], self.frame.sides[i].thickness
        tangent = rho / side.base
        half: Long = side.flat + x * self.sine / side.base - (tangent - np.arctan(tangent))
        return half - least * np.sqrt(1 + (tip * self.slant / side.reference) ** 2) / (2 * tip)


def exact_of(frame: Frame) -> Exact:
    """The constants of a frame again."""
    rack, helix = frame.task.first.rack, np.longdouble(frame.task.first.helix)
    angle = np.arctan(np.tan(np.longdouble(rack.angle)) / np.cos(helix))
    sine, level = np.sin(angle), involute_extended(angle)

    def side(wheel: Wheel) -> ExactSide:
        reference = wheel.teeth / (2 * np.cos(helix))
        least = np.longdouble(rack.straight) - reference * sine**2
        return ExactSide(reference, reference * np.cos(angle), least, PI / (2 * wheel.teeth) + level)

    sides = side(frame.task.first), side(frame.task.second)
    return Exact(frame, sides, sine, level, PI / np.cos(helix) * np.cos(angle), np.tan(helix))
