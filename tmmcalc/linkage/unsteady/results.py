"""The record that the unsteady stage leaves."""

from __future__ import annotations

from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.core.timelaw import TimeLaw
from tmmcalc.core.timerows import TimedExtreme
from tmmcalc.linkage.results import ErrorEstimate, Grade, Trace


@record
class Unsteady:
    """A motion from rest to rest at n rows; all derivatives are by the time.

    A jump of the acceleration inside the motion has two rows: 4- is the limit before a jump at row 4. The first and the
    last row are the limits inside the motion.
    """

    law: TimeLaw  # of the input coordinate
    input_link: int | None  # the driven link; None where the drive acts between two moving links
    input_joint: str
    turns: bool  # a crank [rad], else a driven slider or length [m]
    start: float = quantity("x_start[{unit}]", "input coordinate at the beginning")
    end: float = quantity("x_end[{unit}]", "input coordinate at the end")
    labels: tuple[str, ...]  # (n,)
    t: Real  # (n,) [s]
    side: Indices  # (n,) -1: the limit from before, +1: from after
    drive: Real  # (3, n) input coordinate [rad or m], its speed and acceleration
    trace: Trace  # points, links, prismatic joints; derivatives by the time
    outputs: tuple[str, ...]  # (O,)
    angular: tuple[bool, ...]  # (O,) whether the output is an angle
    coordinate: Real  # (3, O, n) output coordinate [m or rad], its velocity and acceleration
    extremes: tuple[TimedExtreme, ...]  # of speeds and accelerations
    grades: tuple[Grade, ...]
    error: ErrorEstimate = quantity("error", "estimated relative errors of the motion of points and input")
    counters: dict[str, int]
