"""How far a pair is from every condition of the blocking contour; exact, for shifts of any shape.

These are the margins that are printed. The boundary itself follows from `frame`, which has the same conditions with
their derivatives in (w, x1); `exact` has them once more in extended precision, as a check of both.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record
from tmmcalc.gears.involute.contour.task import Task
from tmmcalc.gears.involute.pair import pair_of_shifts
from tmmcalc.gears.involute.profile.form import junction
from tmmcalc.gears.involute.wheel import Number, Wheel
from tmmcalc.gears.model import Values

NONE = -1.0  # the margin of a pair that does not exist
ON_BASE = 1e-10  # of the mate's radius of curvature: a flank that begins so near its base circle begins on it


@record
class Margins:
    """Margins at the shifts x1, x2, arrays of their shape; negative: not met. Lengths in normal modules."""

    exists: NDArray[np.bool_]  # there is a line of action, and both tips lie outside the base circles
    undercut1: Values  # x1 - x_min1
    undercut2: Values
    interference1: Values  # N1A2 - N1L1, signed also where wheel 1 is undercut
    interference2: Values  # N2A1 - N2L2
    tolerated1: Values  # N1A2 - rho_F1, of the flank that is left
    tolerated2: Values  # N2A1 - rho_F2
    contact_ratio: Values  # eps_alpha - eps_min
    thickness1: Values  # s_na1 - s_a,min
    thickness2: Values
    theta1: Values  # specific sliding of wheel 1 at A2; 0 where its flank would have to begin inside the base circle
    theta2: Values  # of wheel 2 at A1

    def least(self, strict: bool = True) -> Values:
        """The least of the margins that the strict or the tolerated contour asks for."""
        rows = [self.tolerated1, self.tolerated2, self.contact_ratio, self.thickness1, self.thickness2]
        if strict:
            rows += [self.undercut1, self.undercut2]
        smallest: Values = np.minimum.reduce(rows)
        return smallest

    def broken(self, strict: bool = True) -> tuple[str, ...]:
        """Keys of LINES whose conditions a single point does not meet."""
        names = ["tolerated1", "tolerated2", "contact_ratio", "thickness1", "thickness2"]
        if strict:
            names = ["undercut1", "undercut2", *names]
        found = [name for name in names if float(getattr(self, name)) < 0]
        bare = [
            f"interference{name[-1]}" if name.startswith("tolerated") and not self._undercut(name[-1]) else name
            for name in found
        ]
        return tuple(bare)

    def _undercut(self, wheel: str) -> bool:
        return float(getattr(self, f"undercut{wheel}")) < 0


def margins(task: Task, x1: float | Values, x2: float | Values) -> Margins:
    """All margins at shifts x1, x2 of one shape (section 4.7.2 of the textbook).

    >>> found = margins(Task(Wheel(14), Wheel(17)), 0.6, 0.522)
    >>> round(float(found.contact_ratio), 6), round(float(found.interference1), 6)
    (0.143934, 0.653044)
    """
    x1, x2 = np.broadcast_arrays(np.asarray(x1, float), np.asarray(x2, float))
    one, two = task.first, task.second
    first = Wheel(one.teeth, x1, one.helix, one.rack)
    second = Wheel(two.teeth, x2, two.helix, two.rack)
    pair = pair_of_shifts(first, second)
    (rho1, rho2), (start1, start2) = pair.tip_curvatures, pair.starts
    tips = [np.asarray(tip) for tip in pair.tips]
    exists = (np.asarray(pair.angle) > 0) & (tips[0] > first.base) & (tips[1] > second.base)

    def known(values: Number) -> Values:
        return np.where(exists, values, NONE)

    forms = [np.asarray(junction(wheel, task.fillet).curvature_radius) for wheel in (first, second)]
    thick = [
        wheel.thickness_at(np.where(exists, tip, wheel.base)) for wheel, tip in zip(pair.wheels, tips, strict=True)
    ]
    u = two.teeth / one.teeth
    return Margins(
        exists,
        x1 - first.least_shift,
        x2 - second.least_shift,
        known(start1 - first.limit),
        known(start2 - second.limit),
        known(start1 - forms[0]),
        known(start2 - forms[1]),
        known(pair.contact_ratio - task.contact_ratio),
        known(thick[0] - task.thickness[0]),
        known(thick[1] - task.thickness[1]),
        sliding_at_start(np.asarray(rho2), np.asarray(start1), u),
        sliding_at_start(np.asarray(rho1), np.asarray(start2), 1 / u),
    )


def sliding_at_start(mate: Values, own: Values, ratio: float) -> Values:
    """theta = 1 - rho_mate/(u rho_own) where the own radius of curvature is positive (4.71), 0 where it is not.

    A flank that begins at its base circle slides beyond all bounds: within `ON_BASE` of it the value is that bound.
    """
    least = ON_BASE * np.abs(mate)
    begins, safe = own >= -least, np.maximum(own, np.where(least > 0, least, 1.0))
    return np.where(begins, 1 - np.where(begins, mate, 0.0) / (ratio * safe), 0.0)
