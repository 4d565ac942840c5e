"""Where one flank hands the wheel over to the other, and whether the groove crosses itself; exact.

The lobe is symmetric about -phi_p/2, the groove about its bottom: each curve meets its mirror image on its axis,

    tip of the lobe    psi(beta_0 + beta_m s(k)) = phi_p (k - 1/2), the first root k_m in (1/2, 1)          (3)
    groove             psi(beta_m s(k) - beta_0) < phi_p (k - 1/2) for all k in (1/2, 1], else it crosses itself
    working profile    the offset of A comes to the axis of the lobe at k_w, before k_m
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.indexing.flanks import Drive, Flank, sign_changes
from tmmcalc.cams.laws.law import Values
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record

BESIDE = 1e-3  # of the step: how far from the bottom of the groove its halves are sought to meet
ROUNDING = 1e-12  # [rad] an angle that is none, of the step a part


@record
class Handover:
    """The end of flank A, where B takes over."""

    part: float = quantity("k_m", "part of the step at which B takes over")
    radius: float = quantity("R_m[m]", "distance of the tip of the lobe from O1")
    angle: float = quantity("theta2[rad]", "pressure angle with which B takes over", symbol="theta_2")
    source_angle: float = quantity("theta2_source[rad]", "theta_2 as the printed tables have it")


def tip(drive: Drive) -> float | None:
    """k_m; None: the lobe ends before the step does, there is no such mechanism.

    >>> from tmmcalc.cams.laws.catalogue import LAWS
    >>> round(tip(Drive(LAWS["shun"], 6, np.pi / 2, 0.13, 0.05)), 6)
    0.742217
    """
    flank = Flank(drive, "A")

    def before(k: Values) -> Values:
        return flank.polar(k) - drive.step * (k - 0.5)

    found = sign_changes(before, drive, 0.5, 1.0)
    return found[0] if found else 1.0 if abs(before(np.ones(1))[0]) < ROUNDING else None


def handover(drive: Drive) -> Handover | None:
    """The tip of the lobe with the pressure angle of B there; None: there is no such mechanism."""
    part = tip(drive)
    if part is None:
        return None
    at, groove = np.array([part]), Flank(drive, "B")
    radius = float(np.abs(Flank(drive, "A").roller(at))[0])
    return Handover(part, radius, float(groove.pressure(at)[0]), float(groove.source_pressure(at)[0]))


def crossing(drive: Drive) -> float | None:
    """The part k in (1/2, 1] at which the groove crosses its mirror image; None: it does not."""
    flank = Flank(drive, "B")

    def beyond(k: Values) -> Values:
        return flank.polar(k) - drive.step * (k - 0.5)

    if beyond(np.ones(1))[0] > ROUNDING:
        return 1.0
    found = [k for k in sign_changes(beyond, drive, 0.5 + BESIDE, 1.0) if k < 1 - ROUNDING]
    return found[-1] if found else None


def working_tip(drive: Drive, roller: float, part: float) -> float:
    """k_w, at which the working profile of flank A ends on the axis of the lobe; ``part`` is k_m."""
    flank = Flank(drive, "A")
    axis = np.exp(0.5j * drive.step)
    found = sign_changes(lambda k: (flank.points(k, roller) * axis).imag, drive, 0.0, part)
    return found[0] if found else part
