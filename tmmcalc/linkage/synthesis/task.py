"""What is asked of a synthesis: one record a kind, in SI, beside what all kinds share.

A None is a size that is to be found. Angles in rad, lengths in m; plane points are complex x + iy.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.feasibility.judge import FeasibilityTask

MechanismName = Literal["four_bar", "slider_crank"]


@record
class SliderCrankTask:
    """A slider-crank: one length at least, and three independent sizes in all."""

    stroke: float | None = None  # S
    crank: float | None = None  # r
    rod: float | None = None  # l
    offset: float | None = None  # e, of the guide to the side of the crank pin on the working stroke
    time_ratio: float | None = None  # K
    crank_ratio: float | None = None  # lambda = r/l
    offset_ratio: float | None = None  # eps = e/r
    offset_part: float | None = None  # e/S
    pressure_working: float | None = None  # nu_p, where the crank stands across the guide
    pressure_idle: float | None = None  # nu_x


@record
class SlottedTask:
    """An oscillating slotted link with a rod and a slider on a guide across the line of centres."""

    stroke: float
    time_ratio: float
    pressure: float | None = None  # largest pressure angle nu_max, or
    rod: float | None = None  # l
    guide: float | None = None  # e, from the pivot of the slotted link to the guide
    clearance: float = 1.5  # k of the rule e = L + k r, which finds what is not given
    crank: float | None = None  # r
    centres: float | None = None  # L


@record
class RotatingTask:
    """A rotating slotted link with a rod and a slider whose guide passes its pivot at ``guide``."""

    stroke: float
    time_ratio: float
    pressure: float | None = None  # largest pressure angle nu_max, or
    rod: float | None = None  # l
    crank: float | None = None  # r, or
    centres: float | None = None  # L
    guide: float = 0.0  # e', of the guide to the side of the crank's pivot


@record
class CrankRockerTask:
    """A crank-rocker by its swing: one length for the scale, a second size or else the best transmission."""

    swing: float  # 2 phi
    time_ratio: float = 1.0
    crank: float | None = None  # r
    coupler: float | None = None  # l
    rocker: float | None = None  # R
    frame: float | None = None  # L
    transmission: float | None = None  # least transmission angle, if that is the second size
    largest_ratio: float = 6.0  # of the longest link to the crank, where the best transmission is sought


@record
class TrailingRodTask:
    """A trailing rod on the master rod of a V-engine whose pistons have equally high top dead centres."""

    v_angle: float  # beta, from the right cylinder to the left one
    crank: float  # r
    rod: float  # l, of the master rod
    lug: float  # l_C, from the crank pin to the pin of the trailing rod
    lug_angle: float | None = None  # alpha, from the master rod; found unless given
    length: float | None = None  # l_4, of the trailing rod; found unless given


@record
class FunctionTask:
    """Output against input at n precision points, both counted from where x begins."""

    mechanism: MechanismName
    inputs: Real  # (n,) angles of the crank [rad]
    outputs: Real  # (n,) angles of the rocker [rad] or displacements of the slider [m]
    fine_inputs: Real  # (m,) where the function is compared; empty: at the points alone
    fine_outputs: Real  # (m,)
    span: tuple[float, float]  # least and largest input
    input_start: float | None = None  # angle of the crank where x begins
    output_start: float | None = None  # angle of the rocker, or place of the slider, where x begins
    frame: float = 1.0  # length of the frame, which scales a four-bar; a slider-crank has its own scale


@record
class PoseTask:
    """Places of the coupler point, with the angles of the coupler (motion) or without (path)."""

    mechanism: MechanismName
    points: Plane  # (n,) [m]
    angles: Real | None = None  # (n,) of the coupler [rad]; None: path generation
    timing: Real | None = None  # (n,) angles of the crank from the first point [rad]
    region: tuple[complex, complex] | None = None  # corners between which the fixed pivots stand
    full_turn: bool = False  # whether the crank has to turn fully
    largest_ratio: float = 20.0  # of the longest to the shortest link


@record
class SynthesisTask:
    """A synthesis: its kind and what that kind asks, the motion of the crank, what is listed."""

    kind: str
    asked: Any  # the record of the kind
    crank_speed: float | None = None  # [rad/s]
    working_speed: float | None = None  # mean speed of the slider on the working stroke [m/s]
    solutions: int = 5  # listed at most
    seed: int = 1  # of the random starts
    transmission: float = 0.0  # least transmission angle that is wanted [rad]: below it a design has a defect
    positions: int = 24  # of the ready spec
    title: str = ""  # of the ready spec
    constraints: FeasibilityTask | None = None  # those of the user that a search keeps
