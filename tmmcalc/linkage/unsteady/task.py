"""What is asked of an unsteady motion: its ends, its limits, its rows."""

from __future__ import annotations

from tmmcalc.core.records import record


@record
class UnsteadyTask:
    """A motion of the input from rest to rest. Of ``end``, ``travel``, ``duration`` one is given, or the first two.

    ``start`` and ``end`` are values of the input coordinate, or of the output if one is named.
    """

    acceleration: float  # a_m of the input [rad/s^2 or m/s^2]
    speed: float | None = None  # v_m of the input [rad/s or m/s]; None: travel and duration settle it
    start: float | None = None  # [rad or m]; None: position 0 of the mechanism
    end: float | None = None  # [rad or m]
    travel: float | None = None  # S_m of the input with its sign [rad or m]
    duration: float | None = None  # T [s]
    output: str | None = None  # the output whose values start and end are
    sense: int | None = None  # +1 or -1: to which side the input moves; None: the nearer one
    steps: int = 24  # equal steps of the time
