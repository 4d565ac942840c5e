"""The record that the kinematics stage leaves, and the choice of its method."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from tmmcalc.linkage.assembly import Domain
from tmmcalc.linkage.outputs import OutputSummary
from tmmcalc.linkage.plane import Real
from tmmcalc.linkage.quality import Grade, GroupQuality
from tmmcalc.linkage.rounding import ErrorEstimate
from tmmcalc.linkage.structure import Structure
from tmmcalc.linkage.trace import Trace

MethodName = Literal["closed", "projection", "differences"]


@dataclass(frozen=True)
class Method:
    """How velocities and accelerations are found.

    ``closed``: elimination by cross products (default). ``projection``: the vector equations projected on
    two axes and solved as 2x2 systems. ``differences``: central differences of positions with ``step`` [rad or
    m] (by default 1.5 degrees, or 1/240 of a slider's range), of positions rounded to ``decimals`` of the crank
    length if given (textbook (2.62), (2.63)).
    """

    name: MethodName = "closed"
    step: float | None = None
    decimals: int | None = None


@dataclass(frozen=True)
class Kinematics:
    """Result of the kinematics stage for n positions and O outputs.

    Derivatives ``d...``, ``dd...`` are transfer functions, per unit of the input coordinate.
    """

    structure: Structure
    variants: dict[str, int]  # sign by group name
    input_joint: str
    turns: bool  # crank (True) or driven slider
    speed: float  # [rad/s] or [m/s]
    acceleration: float  # [rad/s^2] or [m/s^2]
    crank_length: float | None  # l_1 [m], the unit of dimensionless results; None for a driven slider
    labels: tuple[str, ...]  # (n,) position labels
    phi: Real  # (n,) input coordinate counted from position 0 [rad or m]
    x: Real  # (n,) input coordinate [rad or m]
    trace: Trace  # points, links, prismatic joints at x
    outputs: tuple[str, ...]  # (O,)
    angular: tuple[bool, ...]  # (O,) whether the output is an angle
    s: Real  # (O, n) displacement from position 0 [m or rad]
    ds: Real  # (O, n)
    dds: Real  # (O, n)
    domain: Domain
    summaries: tuple[OutputSummary, ...]
    qualities: tuple[GroupQuality, ...]
    grades: tuple[Grade, ...]
    method: Method
    error: ErrorEstimate
    counters: dict[str, int]

    def in_time(self, rate: np.ndarray, rate2: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Velocity and acceleration from first and second transfer function: v = S' w, a = S'' w^2 + S' eps."""
        steady = rate2 * self.speed**2
        return rate * self.speed, steady + rate * self.acceleration if self.acceleration else steady
