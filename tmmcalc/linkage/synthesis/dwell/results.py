"""The records that the synthesis of a six-bar with a dwell leaves beside its sizes, in SI."""

from __future__ import annotations

from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.records import record
from tmmcalc.linkage.synthesis.dwell.task import OutputKind


@record
class Largest:
    """A largest value, and the turn of the crank from position 1 where it stands [rad]."""

    name: str
    value: float
    unit: str
    at: float


@record
class Motion:
    """Positions of a turn: those of the kinematics room, position 1 first, in the sense of the crank.

    Forces are those against the given resistance, which acts against the motion where S grows; S', S'' are per radian
    of the crank, counter-clockwise.
    """

    labels: tuple[str, ...]  # (n,)
    phi: Real  # (n,) turn of the crank from position 1 [rad]
    crank: Real  # (n,) its angle [rad]
    theta: Real  # (n,) angle of A -> C [rad]
    s: Real  # (n,) S [m or rad]
    b: Plane  # (n,) place of B [m]
    ds: Real  # (n,) S' [m or rad]
    dds: Real  # (n,) S''
    f3: Real  # (n,) compressive force of bar CB, R35 [N]
    f4: Real  # (n,) of bar DE, R45 [N]
    r21: Real  # (n,) between crank and coupler [N]
    normal: Real  # (n,) of the guide on the slider, along the left normal of u [N]; 0 of a rocker
    couple: Real  # (n,) of the guide on the slider, about B [N*m]; 0 of a rocker
    delta: Real  # (n,) pressure angle [rad]
    moment: Real  # (n,) driving moment on the crank [N*m]


@record
class CrossCheck:
    """The method of the relative trajectory against the exact motion: largest errors as parts of the stroke."""

    steps: int  # of the arc
    uniform: float  # its points at equal steps of bar BC, or of an angle around where the arc changes its branch
    cosine: float  # its points in cosine spacing
    first: float  # ends of the arc, angle of bar BC [rad]
    last: float


@record
class Slots:
    """The branches of Gamma around the dwell, places of the crank pin in the axes of link 5 [m]."""

    own: Plane  # (k,) that of the linkage
    other: Plane  # (k,)


@record
class Agreement:
    """Largest differences between methods, against the largest value of each kind."""

    motion: float  # S, S', S'' of the kinematics room and of the two closures
    forces: float  # bars, crank, guide: the forces room and the two equations of equilibrium
    virtual_work: float  # M_1 and F S'
    positions: float  # |S| in positions 2 and 3 against the stroke


@record
class Dwell:
    """A six-bar with a dwell, analysed."""

    output: OutputKind
    stroke: float  # h [m], or swing [rad]
    dwell_error: float  # max |S| over the dwell [m or rad]
    dwell_ratio: float  # the same as a part of the stroke
    dwell_angle: float  # phi_B [rad]
    positions: tuple[float, ...]  # turns of the crank in positions 1 to 3 [rad]
    extremes: tuple[Largest, ...]  # all positions where the output turns back, along the motion
    working: tuple[float, float]  # begin and end of the working stroke, turn of the crank along the motion [rad]
    idle: tuple[float, float]
    maxima: tuple[Largest, ...]
    criteria: tuple[float, ...]  # f1 to f5 with lengths in parts of l_OB
    cost: float | None  # their weighted sum, of an optimisation
    motion: Motion  # at the positions
    fine: Motion  # every degree, for drawing
    slots: Slots
    cross_check: CrossCheck | None  # None where the method does not apply
    unchecked: str  # why it does not; empty where it does
    agreement: Agreement
