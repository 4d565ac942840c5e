"""The records that the forces stage leaves, apart from the code that makes them."""

from __future__ import annotations

from typing import Literal

from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.loading import GearDrive
from tmmcalc.linkage.results import Extreme, Grade

LEAST_ARM = 1e-13  # of a force that rounding alone moves off the slider's point [m]


@record
class PairForces:
    """A pair: its name and kind, the two links, and the largest values with the angle theta where they stand."""

    joint: str
    kind: Literal["revolute", "prismatic"]
    links: tuple[int, int]  # the lower-numbered, whose force on the other is given
    friction: float  # coefficient
    radius: float  # of the pin [m]
    length: float | None  # of the slider [m]
    force: Extreme = quantity("R_{joint}_max[N]", "largest reaction in {joint}")
    couple: Extreme | None = quantity(  # None: a revolute pair
        "M_{joint}_max[N*m]", "largest couple in {joint} about the slider's point of the line"
    )
    pressure: Extreme | None = quantity(  # None: no slider whose length is given
        "edge_{joint}_max[N]", "larger edge reaction of the slider of {joint}"
    )
    tips: tuple[str, ...] = quantity("tips_{joint}", "positions where the slider of {joint} bears on opposite edges")


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
    drive: Real = quantity(  # (n,) a moment, of a driven slider a force
        "{letter}_drive[{unit}]", "drive along the positive input coordinate"
    )
    power: Real = quantity("P_drive[W]", "power of the drive")  # (n,)
    mesh: Plane | None = quantity(  # (n,) None without a gear
        "F_mesh[N]", "force of the pinion on the crank's gear"
    )
    drive_kind: Literal["coupling", "gear", "slider"] = quantity("drive", "how the drive acts")
    gear: GearDrive | None  # the gear on the crank; None: there is none
    equilibrium: Real = quantity(  # (n,)
        "equilibrium[-]", "largest residual of a link, against the largest force or moment"
    )
    virtual: Real = quantity(  # (n,)
        "virtual[-]", "drive by virtual power less the drive, against the largest drive"
    )
    drive_extremes: tuple[Extreme, Extreme] = quantity(  # least and largest drive
        "{letter}_drive_max[{unit}]", "largest drive along the positive input coordinate"
    )
    power_extremes: tuple[Extreme, Extreme] = quantity("P_drive_max[W]", "largest power of the drive")
    power_mean: Mean = quantity("P_drive_mean[W]", "mean power of the drive over the motion")
    grades: tuple[Grade, ...]
    counters: dict[str, int]
    error: float = quantity("reactions", "estimated relative error of the reactions")
    last_digit: float | None = quantity(  # None: no more than rounding
        "reactions", "relative change of the reactions by the last digit of the metric", default=None
    )


@record
class LeverScale:
    """The fact by choice of Zhukovsky's lever."""

    mu: float = quantity(
        "lever_mu_v[m/s/mm]", "scale of Zhukovsky's lever in the columns by choice", symbol=r"\mu_v", source="3.2.8"
    )


def side_of(result: Forces, row: int) -> float:
    """The side from which a row is taken where friction jumps: -1 just before, at the very end too, else +1."""
    return -1.0 if result.labels[row].endswith("-") or row == len(result.labels) - 1 else 1.0


def edge_reactions(normal: Real, couple: Real, length: float) -> tuple[Real, Real]:
    """Forces N', N'' [N] along the normal at the edges of a slider, ahead of and behind its point (fig. 3.1b).

    N' + N'' = N, (N' - N'') length/2 = couple. They point the same way unless the resultant leaves the slider.

    >>> edge_reactions(10.0, 1.0, 0.5)
    (7.0, 3.0)
    """
    return normal / 2 + couple / length, normal / 2 - couple / length
