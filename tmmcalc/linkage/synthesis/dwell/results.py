"""The records that the synthesis of a six-bar with a dwell leaves beside its sizes, in SI."""

from __future__ import annotations

from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.synthesis.dwell.task import OutputKind


@record
class Largest:
    """A largest value, and where it stands."""

    name: str = quantity("name", "name of the quantity")
    value: float = quantity("value[{unit}]", "its largest value")
    unit: str  # m, rad, N or - for a number
    at: float = quantity("at[rad]", "turn of the crank from position 1")


@record
class BarForce:
    """A bar where its force against a unit resistance is largest on a stroke; lengths in parts of l_OB."""

    bar: str = quantity("bar", "the bar")  # CB or DE
    stroke: str = quantity("stroke", "the stroke")  # working or idle
    at: float = quantity("at[rad]", "turn of the crank from position 1")
    force: float = quantity("R", "its compressive force for a unit resistance, lengths in parts of l_OB")
    # a unit force along each bar, from link 5 to the coupler: its arm about A, its part along the motion of link 5
    arms: tuple[float, float] = quantity("arms", "arms of bars CB and DE about A")
    pulls: tuple[float, float] = quantity("pulls", "projections of both on the guide, or arms about F")
    x: tuple[float, ...] = quantity("x", "abscissas of A, B, C, D, E")
    y: tuple[float, ...] = quantity("y", "ordinates of A, B, C, D, E")


@record
class DwellMotion:
    """Positions of a turn: those of the kinematics room, position 1 first, in the sense of the crank.

    Forces are those against the given resistance, which acts against the motion where S grows; S', S'' are per radian
    of the crank, counter-clockwise.
    """

    labels: tuple[str, ...]  # (n,)
    phi: Real = quantity("phi[rad]", "turn of the crank from position 1")  # (n,)
    crank: Real = quantity("phi_1[rad]", "angle of the crank")  # (n,)
    theta: Real = quantity("theta[rad]", "angle of A -> C")  # (n,)
    s: Real = quantity("S[{unit}]", "displacement of the output")  # (n,)
    b: Plane  # (n,) place of B [m]
    ds: Real = quantity("dS[{slope}]", "first transfer function S'")  # (n,)
    dds: Real = quantity("d2S[{slope}]", "second transfer function S''")  # (n,)
    f3: Real = quantity("R35[N]", "compressive force of bar CB")  # (n,)
    f4: Real = quantity("R45[N]", "compressive force of bar DE")  # (n,)
    r21: Real = quantity("R21[N]", "force between crank and coupler")  # (n,)
    # (n,) 0 of a rocker
    normal: Real = quantity("N[N]", "force of the guide on the slider, along the left normal of u")
    couple: Real = quantity("M_N[N*m]", "couple of the guide on the slider, about B")  # (n,) 0 of a rocker
    delta: Real = quantity("delta[rad]", "pressure angle")  # (n,)
    moment: Real = quantity("M_1[N*m]", "driving moment on the crank")  # (n,)


@record
class CrossCheck:
    """The method of the relative trajectory against the exact motion: largest errors as parts of the stroke."""

    steps: int = quantity("steps", "steps of the arc")
    # equal steps of bar BC, or of an angle around where the arc changes its branch
    uniform: float = quantity("uniform", "largest error with equal steps of the arc, against the stroke")
    cosine: float = quantity("cosine", "largest error with cosine spacing, against the stroke")
    first: float = quantity("first[rad]", "angle of bar BC at the beginning of the arc")
    last: float = quantity("last[rad]", "angle of bar BC at the end of the arc")


@record
class Slots:
    """The branches of Gamma around the dwell, places of the crank pin in the axes of link 5 [m]."""

    own: Plane  # (k,) that of the linkage
    other: Plane  # (k,)


@record
class Agreement:
    """Largest differences between methods, against the largest value of each kind."""

    motion: float = quantity("motion", "S, S', S'' of the kinematics stage and of the two closures")
    forces: float = quantity("forces", "bars, crank, guide: the forces stage and the two equations of equilibrium")
    virtual_work: float = quantity("virtual_work", "M_1 and F S'")
    positions: float = quantity("positions", "|S| in positions 2 and 3 against the stroke")


@record
class Dwell:
    """A six-bar with a dwell, analysed."""

    output: OutputKind
    stroke: float  # h [m], or swing [rad]
    dwell_error: float  # max |S| over the dwell [m or rad]
    dwell_ratio: float = quantity("dwell_error", "max |S| over the dwell as a part of the stroke")
    dwell_angle: float  # phi_B [rad]
    positions: tuple[float, ...]  # turns of the crank in positions 1 to 3 [rad]
    extremes: tuple[Largest, ...] = quantity("extremes", "positions where the output turns back, along the motion")
    working: tuple[float, float] = quantity(
        "working[rad]", "turn of the crank along the motion at the beginning and end of the working stroke"
    )
    idle: tuple[float, float] = quantity("idle[rad]", "the same of the idle stroke")
    maxima: tuple[Largest, ...] = quantity("maxima", "largest values")
    criteria: tuple[float, ...]  # f1 to f5 with lengths in parts of l_OB
    bars: tuple[BarForce, ...] = quantity("bars", "bars where they are loaded most on each stroke")
    cost: float | None = quantity("cost", "weighted sum of the criteria")  # None: no optimisation
    motion: DwellMotion  # at the positions
    fine: DwellMotion  # every degree, for drawing
    slots: Slots
    cross_check: CrossCheck | None = quantity(  # None where the method does not apply
        "relative_trajectory", "the method of the relative trajectory"
    )
    unchecked: str  # why it does not; empty where it does
    agreement: Agreement = quantity("agreement", "largest differences between methods")
