"""The records that a synthesis leaves: designs with their sizes, checks, defects and ready specs, best first."""

from __future__ import annotations

from dataclasses import field

from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.records import record
from tmmcalc.linkage.synthesis.dwell.results import Dwell


@record
class Size:
    """One size of a design: ``unit`` is m, rad or - for a number."""

    symbol: str
    value: float
    unit: str
    meaning: str


@record
class Check:
    """One quantity of the simulated mechanism beside its target.

    ``residual`` is relative to the target, or absolute where that is zero; None without a target.
    """

    name: str
    achieved: float
    unit: str
    target: float | None = None
    residual: float | None = None


def check_key(name: str) -> str:
    """The name of a check in the documents.

    >>> check_key("stroke h")
    'check_stroke_h'
    """
    return f"check_{name.replace(' ', '_')}"


@record
class StrokeTimes:
    """Times, angles and mean speeds of the two strokes at a constant speed of the crank."""

    crank_speed: float  # [rad/s]
    time_ratio: float  # K
    stroke: float  # S, or the swing 2 phi
    unit: str  # of the stroke, m or rad
    period: float  # t [s]
    working_time: float  # t_p [s]
    idle_time: float  # t_x [s]
    working_speed: float  # v_p, or omega_p [unit/s]
    idle_speed: float  # v_x, or omega_x [unit/s]
    mean_speed: float  # 2 S/t over the cycle [unit/s]
    working_angle: float  # alpha_p [rad]
    idle_angle: float  # alpha_x [rad]
    overlap: float  # psi [rad]


@record
class Precision:
    """What was wanted at the n points, and what the simulated mechanism does there."""

    unit: str  # of the output, rad or m
    sense: int  # of the crank from the first point on, +1 counter-clockwise
    crank: Real  # (n,) angle of the crank [rad]
    wanted: Real  # (n,) output [rad or m]; of a path the distance 0 from the point
    found: Real  # (n,)
    points: Plane  # (n,) places of the coupler point that were wanted; empty for a function
    reached: Plane  # (n,) places that it reaches
    angle_errors: Real  # (n,) of the coupler [rad]; empty unless it was asked for
    fine: Real  # (m,) angles of the crank over the range of a function [rad]; empty for a path
    error: Real  # (m,) error of the output there [rad or m]


@record
class Design:
    """One linkage that answers the task."""

    name: str
    sizes: tuple[Size, ...]
    checks: tuple[Check, ...]
    merits: dict[str, float]  # figures of merit, their unit in the name
    defects: tuple[str, ...]
    spec: str  # the ready spec, TOML
    times: StrokeTimes | None = None
    precision: Precision | None = None
    dwell: Dwell | None = None  # of a six-bar with a dwell

    def size(self, symbol: str) -> float:
        """The size of this symbol in SI; raises KeyError if there is none."""
        return {size.symbol: size.value for size in self.sizes}[symbol]

    def check(self, name: str) -> Check:
        """The check of this name; raises KeyError if there is none."""
        return {check.name: check for check in self.checks}[name]


@record
class Synthesis:
    """All designs that are listed, the best first by ``rule``; ``residual`` is the largest against any target."""

    kind: str
    rule: str
    designs: tuple[Design, ...]
    residual: float
    notes: tuple[str, ...] = ()
    counters: dict[str, int] = field(default_factory=dict)
    error: float | None = None  # of the sizes, of lengths relative to the longest; None: no equations settle them

    @property
    def best(self) -> Design:
        """The first of the designs."""
        return self.designs[0]
