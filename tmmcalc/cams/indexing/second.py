"""The cam of the second row, where it is not equal to the first: other rollers, or dwells that are not equal.

The second cam has its groove where the first has its lobe. With dwells D1 and D2 the lobe of the first cam is followed
by D1, then by its groove; that of the second by D2. So with equal rollers the second cam is the first one turned over.
Its pitch curve is made of the same flanks: pressure angles, curvature and the limits of rollers are those of the first.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.indexing.flanks import Drive, Flank
from tmmcalc.cams.indexing.handover import working_tip
from tmmcalc.cams.indexing.results import SecondCam
from tmmcalc.core.plane import Plane


def second_cam(drive: Drive, part: float, roller: float, rests: tuple[float, float], equal: bool) -> SecondCam:
    """The working profile of the second cam; ``part`` is k_m, ``equal`` whether its rollers are those of the first."""
    end = working_tip(drive, roller, part)
    at = np.array([end])
    return SecondCam(
        roller=roller,
        working_part=end,
        working_tip=float(np.abs(Flank(drive, "A").points(at, roller))[0]),
        working_angle=float(Flank(drive, "B").pressure(at)[0]),
        nearest=drive.centres - drive.wheel - roller,
        lag=drive.step + rests[0],
        turned_over=equal,
    )


def turned(drive: Drive, rests: tuple[float, float], phase: float) -> float:
    """Turn [rad] of the wheel, in its own sense, since the start of the first step, at an angle of the cams."""
    turns, rest = divmod(phase, 2 * np.pi)
    steps, second = 2 * turns, drive.step + rests[0]
    if rest >= second:
        steps, rest = steps + 1, rest - second
    part = float(drive.law.at(np.array([min(rest / drive.step, 1.0)]))[0, 0])
    return float(2 * drive.half * (steps + part))


def rows_of(drive: Drive, rests: tuple[float, float], phase: float) -> tuple[Plane, Plane]:
    """Places (z2/2,) of the rollers of the two cams at an angle of the cams."""
    every = 4 * drive.half * np.arange(drive.rollers // 2)
    first = drive.half + every + turned(drive, rests, phase)
    near, far = (drive.centres - drive.wheel * np.exp(-1j * theta) for theta in (first, first - 2 * drive.half))
    return near, far
