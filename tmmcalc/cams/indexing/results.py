"""What the indexing stage finds."""

from __future__ import annotations

from math import pi

import numpy as np

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.indexing.bounds import Bounds
from tmmcalc.cams.indexing.efficiency import Flags
from tmmcalc.cams.indexing.handover import Handover
from tmmcalc.cams.indexing.rollers import RollerLimit
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.rounding import Errors
from tmmcalc.core.records import record

LARGEST = 1e12  # of l_k: a radius of curvature that stands for a straight line


@record
class FlankTable:
    """A flank at n parts of the step, beyond its end as well."""

    name: str  # A or B
    theta: Values  # (n,) [rad] angle of its roller on the wheel from O2O1
    polar: Values  # (n,) [rad] delta, polar angle of the pitch curve in the axes of the cam
    pressure: Values  # (n,) [rad] vartheta
    source: Values  # (n,) [rad] the same as the printed tables have it
    curvature: Values  # (n,) [1/m] of the pitch curve, positive where it bulges outwards
    pitch: Complex  # (n,) [m]
    working: Complex  # (n,) [m] inner equidistant

    @property
    def radius(self) -> Values:
        """R (n,) [m], from O1 to the pitch curve."""
        return np.abs(self.pitch)

    @property
    def bend(self) -> Values:
        """rho (n,) [m], radius of curvature of the pitch curve; a straight line has a very large one."""
        least = 1 / (LARGEST * float(np.max(self.radius)))
        return 1 / np.where(np.abs(self.curvature) < least, least, self.curvature)


@record
class PressureReached:
    """The pressure angle on the flank that drives, both ends included."""

    flank: str  # A from k = 0 to k_m, B from k_m to 1
    largest: float  # |vartheta| [rad]
    part: float  # k
    limit: float  # theta_d [rad]

    @property
    def exceeded(self) -> bool:
        """Whether it is beyond theta_d."""
        return self.largest > self.limit * (1 + 1e-9)


@record
class EfficiencyTable:
    """Efficiency of the driving flank, A up to k_m and B after it, at n parts of the step."""

    against: Values  # (n,) load against the motion (12)
    aiding: Values  # (n,) load along the motion (13)
    against_cut: Flags  # (n,) cut off at 0 or 1
    aiding_cut: Flags  # (n,)
    mean_against: float  # over the step
    mean_aiding: float
    mean_paper: float  # (12) up to k_m, (13) while the wheel runs out
    against_share: float  # part of the step over which it is cut off
    aiding_share: float


@record
class Cam:
    """The profile of the two equal cams."""

    a: FlankTable
    b: FlankTable
    handover: Handover  # of the pitch curve
    working_part: float  # k_w, where the working profile of A ends
    working_tip: float  # [m] from O1 to the tip of the working profile
    working_angle: float  # [rad] pressure angle of B at k_w
    nearest: float  # [m] from O1 to the working profile, at the bottom of the groove
    bottom: float  # rho of the pitch curve at the bottom of the groove [m], negative: concave
    roller_limits: tuple[RollerLimit, ...]
    run_up: PressureReached
    run_out: PressureReached
    efficiency: EfficiencyTable


@record
class Indexing:
    """Stage ``indexing``: an indexing drive at n parts k of its step."""

    rollers: int  # z2
    step: float  # phi_p [rad]
    wheel: float  # l_k [m]
    ratio: float  # lambda
    ratio_how: str  # given, or how it was chosen
    roller: float | None  # r_r [m]; None: the law is known by its B alone
    roller_how: str
    limit: float  # theta_d [rad]
    frictions: tuple[float, float]  # f1, f2
    law: str
    peak: float  # B
    bounds: Bounds
    base: float  # R_0 [m] of the pitch curve in the dwells
    start_angle: float  # delta_0 [rad]
    start_pressure: float  # theta_1m [rad]
    k: Values  # (n,)
    motion: Values  # (4, n) beta [rad] and its derivatives by the angle of the cams
    cam: Cam | None  # None: the law is known by its B alone
    notes: tuple[str, ...]
    error: Errors  # estimates, relative: of points, curvature, pressure, limits; of efficiency and ends absolute

    @property
    def centres(self) -> float:
        """a [m]."""
        return self.ratio * self.wheel

    @property
    def wheel_room(self) -> float | None:
        """What the lobe leaves about O2 [m] for a shaft of the wheel, negative if it sweeps over O2; None: no cam."""
        return None if self.cam is None else self.centres - self.cam.working_tip

    @property
    def dwell(self) -> float:
        """Angle of the cams [rad] during each of the two dwells of a turn."""
        return pi - self.step

    @property
    def labels(self) -> tuple[str, ...]:
        """Numbers of the rows."""
        return tuple(map(str, range(len(self.k))))
