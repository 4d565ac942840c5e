"""What the indexing stage finds."""

from __future__ import annotations

from math import pi

import numpy as np
from numpy.typing import NDArray

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.indexing.bounds import Bounds
from tmmcalc.cams.indexing.handover import Handover
from tmmcalc.cams.indexing.rollers import RollerLimit
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.rounding import Errors
from tmmcalc.core.notes import Said
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record

Flags = NDArray[np.bool_]
LARGEST = 1e12  # of l_k: a radius of curvature that stands for a straight line


@record
class FlankTable:
    """A flank at n parts of the step, beyond its end as well."""

    name: str  # A or B
    # (n,) each
    theta: Values = quantity("theta_{flank}[rad]", "angle of its roller on the wheel from O2O1")
    polar: Values = quantity("delta_{flank}[rad]", "polar angle of the pitch curve in the axes of the cam")
    pressure: Values = quantity("vartheta_{flank}[rad]", "pressure angle")
    source: Values = quantity("source_{flank}[rad]", "pressure angle as the printed tables have it")
    curvature: Values  # (n,) [1/m] of the pitch curve, positive where it bulges outwards
    pitch: Complex  # (n,) [m]
    working: Complex  # (n,) [m] inner equidistant

    @derived("x_{flank}[m]", "x of the pitch curve")
    def x(self) -> Values:
        """(n,)."""
        return self.pitch.real

    @derived("y_{flank}[m]", "y of the pitch curve")
    def y(self) -> Values:
        """(n,)."""
        return self.pitch.imag

    @derived("xw_{flank}[m]", "x of the working profile", symbol="x_w")
    def working_x(self) -> Values:
        """(n,)."""
        return self.working.real

    @derived("yw_{flank}[m]", "y of the working profile", symbol="y_w")
    def working_y(self) -> Values:
        """(n,)."""
        return self.working.imag

    @derived("R_{flank}[m]", "distance of the pitch curve from O1")
    def radius(self) -> Values:
        """(n,)."""
        return np.abs(self.pitch)

    @derived("rho_{flank}[m]", "radius of curvature of the pitch curve")
    def bend(self) -> Values:
        """(n,); a straight line has a very large one."""
        least = 1 / (LARGEST * float(np.max(self.radius)))
        return 1 / np.where(np.abs(self.curvature) < least, least, self.curvature)


@record
class PressureReached:
    """The pressure angle on the flank that drives, both ends included."""

    flank: str  # A from k = 0 to k_m, B from k_m to 1
    largest: float = quantity("{part}_max[rad]", "largest pressure angle of the {part}")
    part: float = quantity("{part}_at_k", "k at the largest pressure angle of the {part}")
    limit: float = quantity("limit[rad]", "allowed pressure angle", symbol="theta_d")

    @property
    def exceeded(self) -> bool:
        """Whether it is beyond theta_d."""
        return self.largest > self.limit * (1 + 1e-9)


@record
class EfficiencyTable:
    """Efficiency of the driving flank, A up to k_m and B after it, at n parts of the step."""

    against: Values = quantity("eta_against", "efficiency with the load against the motion", source="(12)")  # (n,)
    aiding: Values = quantity("eta_aiding", "efficiency with the load along the motion", source="(13)")  # (n,)
    against_cut: Flags  # (n,) cut off at 0 or 1
    aiding_cut: Flags  # (n,)
    # integrals of both efficiencies over the part of the step that a flank drives
    against_a: float = quantity(
        "eta_against_A", "integral of the efficiency with the load against the motion over the parts up to k_m"
    )
    against_b: float = quantity(
        "eta_against_B", "integral of the efficiency with the load against the motion over the parts from k_m on"
    )
    aiding_a: float = quantity(
        "eta_aiding_A", "integral of the efficiency with the load along the motion over the parts up to k_m"
    )
    aiding_b: float = quantity(
        "eta_aiding_B", "integral of the efficiency with the load along the motion over the parts from k_m on"
    )
    mean_against: float = quantity("eta_against", "mean efficiency of the step with the load against the motion")
    mean_aiding: float = quantity("eta_aiding", "mean efficiency of the step with the load along the motion")
    mean_paper: float = quantity(
        "eta_mixed", "mean efficiency with the load against the motion up to k_m, along it while the wheel runs out"
    )
    against_share: float = quantity(
        "cut_off_against", "part of the step over which the efficiency against the load is cut off"
    )
    aiding_share: float = quantity(
        "cut_off_aiding", "part of the step over which the efficiency along the load is cut off"
    )

    @derived("eta_cut", "where the efficiency is cut off at 0 or 1: 1 against the load, 2 along it, 3 both")
    def cut(self) -> Indices:
        """(n,)."""
        return np.where(self.against_cut, 1, 0) + np.where(self.aiding_cut, 2, 0)


@record
class Cam:
    """The profile of the two equal cams."""

    a: FlankTable
    b: FlankTable
    handover: Handover  # of the pitch curve
    working_part: float = quantity("k_w", "part of the step at which the working profile of A ends")
    working_tip: float = quantity("R_w[m]", "distance of the tip of the working profile from O1")
    working_angle: float = quantity("theta2_working[rad]", "pressure angle of B at k_w")
    nearest: float = quantity("r_min[m]", "least distance of the working profile from O1, at the bottom of the groove")
    bottom: float = quantity(
        "rho_B_mid[m]", "radius of curvature of the pitch curve at the bottom of the groove; negative: concave"
    )
    roller_limits: tuple[RollerLimit, ...]
    run_up: PressureReached
    run_out: PressureReached
    efficiency: EfficiencyTable


@record
class SecondCam:
    """The cam of the second row, where it is not equal to the first."""

    roller: float = quantity("r_r2[m]", "radius of the rollers of the second row", symbol="r_(r 2)")
    working_part: float = quantity("k_w2", "part of the step at which the working profile of A ends, second cam")
    working_tip: float = quantity("R_w2[m]", "distance of the tip of the working profile from O1, second cam")
    working_angle: float = quantity("theta2_working2[rad]", "pressure angle of B at k_w2")
    nearest: float = quantity("r_min2[m]", "least distance of the working profile from O1, second cam")
    lag: float = quantity("gamma[rad]", "angle by which the lobe of the second cam stands behind that of the first")
    turned_over: bool = quantity("turned_over", "whether the second cam is the first one turned over")


@record
class Indexing:
    """Stage ``indexing``: an indexing drive at n parts k of its step."""

    rollers: int = quantity("rollers", "number of rollers", symbol="z_2")
    step: float = quantity("phi_p[rad]", "angle of the cams while the wheel turns")
    wheel: float = quantity("l_k[m]", "radius of the wheel to the axes of its rollers")
    ratio: float = quantity("lambda", "centre distance over the radius of the wheel")
    ratio_how: str = quantity("lambda_how", "given, or how lambda was chosen")
    roller: float | None = quantity("r_r[m]", "radius of the rollers")  # None: the law is known by its B alone
    roller_how: str
    limit: float  # theta_d [rad]
    frictions: tuple[float, float]  # f1, f2
    law: str = quantity("law", "law of motion of the wheel")
    peak: float = quantity("B", "largest s' of the law")
    bounds: Bounds
    base: float = quantity("R0[m]", "radius of the pitch curve in the dwells", symbol="R_0")
    start_angle: float = quantity("delta_0[rad]", "polar angle of a roller at O1 in the dwell")
    start_pressure: float = quantity("theta_1m[rad]", "pressure angle at the start of the step")
    k: Values = quantity("k", "part of the step")  # (n,)
    motion: Values  # (4, n) beta [rad] and its derivatives by the angle of the cams
    cam: Cam | None  # None: the law is known by its B alone
    notes: tuple[Said, ...]
    error: Errors  # estimates, relative: of points, curvature, pressure, limits; of efficiency and ends absolute
    dwells: tuple[float, float] | None = quantity(  # None: equal
        "dwell_{number}[rad]", "angle of the cams during dwell {number}", default=None
    )
    second: SecondCam | None = None  # None: equal to the first

    @derived("a[m]", "centre distance")
    def centres(self) -> float:
        """By lambda."""
        return self.ratio * self.wheel

    @derived("a_min[m]", "least centre distance")
    def least_centres(self) -> float:
        """By lambda_min."""
        return self.bounds.ratio_min * self.wheel

    @derived("pitch[deg]", "angle by which the wheel turns")
    def pitch(self) -> float:
        """In a step."""
        return 360 / self.rollers

    @derived("phi_p_min[rad]", "least angle of the step")
    def step_min(self) -> float:
        """0 where there is none."""
        return self.bounds.step_min or 0.0

    @derived("phi_p_max[rad]", "largest angle of the step that is recommended")
    def step_max(self) -> float:
        """0 where there is none."""
        return self.bounds.step_max or 0.0

    @derived("wheel_room[m]", "what the lobe leaves about O2 for a shaft of the wheel; negative: it sweeps over O2")
    def wheel_room(self) -> float | None:
        """None: no cam."""
        if self.cam is None:
            return None
        return self.centres - max(self.cam.working_tip, 0.0 if self.second is None else self.second.working_tip)

    @derived("dwell[rad]", "angle of the cams during each of the two dwells of a turn, of unequal ones their mean")
    def dwell(self) -> float:
        """What the step leaves of half a turn."""
        return pi - self.step

    @derived("f1", "coefficient of friction of the rollers on the cams", symbol="f_1")
    def first_friction(self) -> float:
        """Of both."""
        return self.frictions[0]

    @derived("f2", "coefficient of friction of the rollers on their pins", symbol="f_2")
    def second_friction(self) -> float:
        """Of both."""
        return self.frictions[1]

    @property
    def labels(self) -> tuple[str, ...]:
        """Numbers of the rows."""
        return tuple(map(str, range(len(self.k))))
