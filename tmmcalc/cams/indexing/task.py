"""What is asked of a cam-lantern indexing mechanism. All in SI.

O1   shaft of the two cams, which turns uniformly, counter-clockwise
O2   shaft of the wheel, which turns clockwise by beta_m = 2 pi/z2 in every step, two steps a turn of the cams

Each turn has two dwells. The lobe of the second cam stands gamma = phi_p + (first dwell) behind that of the first, half
a turn where the dwells are equal; each cam has its groove where the other has its lobe. Rollers of one row, which run
on one cam, are equal; those of the other row may have another radius.
"""

from __future__ import annotations

from math import pi, radians

from tmmcalc.cams.indexing.laws import StepLaw
from tmmcalc.core.records import record

FRICTION_RATIO = 1.27  # f2/f1


@record
class IndexingTask:
    """An indexing drive; None: to be chosen."""

    law: StepLaw
    rollers: int  # z2, even; half of them in each row
    step: float  # phi_p [rad], angle of the cams during one step
    wheel: float  # l_k [m], radius on which the rollers stand
    ratio: float | None = None  # lambda = a/l_k, a = O1O2
    roller: float | None = None  # r_r [m], of the first row
    second_roller: float | None = None  # [m] of the second row; None: as the first
    dwells: tuple[float, float] | None = None  # [rad] after the step by the first cam, by the second; None: equal
    limit: float = radians(50)  # theta_d [rad], largest pressure angle
    friction: float = 0.18  # f1, roller on cam
    pin_friction: float = FRICTION_RATIO * 0.18  # f2
    shaft: float = 0.0  # [m] radius of the camshaft, which the groove has to clear
    rows: int = 20  # equal parts of the step in the tables
    tolerance: float = 1e-6  # [m] chord of exported curves

    @property
    def pitch(self) -> float:
        """beta_m [rad], turn of the wheel in one step."""
        return 2 * pi / self.rollers

    @property
    def rests(self) -> tuple[float, float]:
        """Both dwells [rad]."""
        return (pi - self.step, pi - self.step) if self.dwells is None else self.dwells
