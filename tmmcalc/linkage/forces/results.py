"""The records that the forces stage leaves, apart from the code that makes them."""

from __future__ import annotations

from typing import Literal

from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.records import record
from tmmcalc.linkage.results import Extreme, Grade


@record
class PairForces:
    """A pair: its name and kind, the two links, and the largest values with the angle theta where they stand.

    ``force`` is |R|; ``couple`` of a prismatic pair is about the slider's point of the line; ``pressure`` is the
    larger edge reaction of a slider whose length is given.
    """

    joint: str
    kind: Literal["revolute", "prismatic"]
    links: tuple[int, int]  # the lower-numbered, whose force on the other is given
    friction: float  # coefficient
    radius: float  # of the pin [m]
    length: float | None  # of the slider [m]
    force: Extreme
    couple: Extreme | None
    pressure: Extreme | None
    tips: tuple[str, ...]  # positions where the slider bears on its edges


@record
class Mean:
    """A mean over the motion, and what it may be off by."""

    value: float
    error: float


@record
class Forces:
    """Result of the forces stage over n rows: the positions of the cycle, and the left limits at jumps of friction.

    A reaction is the force of the lower-numbered link on the higher-numbered one. Where the friction of a pair
    changes sign at a position there are two rows: the limit before it, labelled ``6-``, and the one after it.
    """

    labels: tuple[str, ...]  # (n,)
    phi: Real  # (n,) input coordinate counted from position 0 [rad or m]
    theta: Real  # (n,) the same along the motion
    turns: bool  # crank, and not a driven slider
    speed: float  # [rad/s] or [m/s]
    pairs: tuple[PairForces, ...]  # (J,)
    reaction: Plane  # (J, n) whole force, friction included [N]
    normal: Real  # (J, n) of a prismatic pair N along the line's left normal [N], of a revolute one |R|
    couple: Real  # (J, n) about the pin (its friction) or about the slider's point [N*m]
    friction: Real  # (J, n) along the line [N] or about the pin [N*m]
    drive: Real  # (n,) moment [N*m] or force [N] of the drive along the positive input coordinate
    power: Real  # (n,) of the drive [W]
    mesh: Plane | None  # (n,) mesh force on the crank's gear [N]; None without a gear
    drive_kind: Literal["coupling", "gear", "slider"]
    equilibrium: Real  # (n,) largest residual of a link, against the largest force or moment [-]
    virtual: Real  # (n,) drive by virtual power less the drive, against the largest drive [-]
    drive_extremes: tuple[Extreme, Extreme]  # least and largest drive
    power_extremes: tuple[Extreme, Extreme]
    power_mean: Mean  # of the drive over the motion [W]
    grades: tuple[Grade, ...]
    counters: dict[str, int]
    error: float  # estimated relative error of the reactions [-]
