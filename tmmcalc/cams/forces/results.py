"""What the stage ``cam_forces`` leaves. Forces [N] of RT and PT are moments about the pivot [N*m] of RK where said."""

from __future__ import annotations

from tmmcalc.cams.follower import Closure, Follower
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.program import Positions
from tmmcalc.cams.rounding import Errors
from tmmcalc.core.records import record


@record
class Wire:
    """A compression spring wound of round wire."""

    index: float  # D/d
    coils: float  # n, that work
    factor: float  # k_w, stress at the inside of the coils (Wahl)
    stress: float  # tau [Pa] at the highest position
    stress_low: float  # tau [Pa] at the lowest


@record
class Governing:
    """The phase that asks for the stiffness, where that is not the phase of the largest lifting force."""

    phase: str  # "rise" or "return"
    force: float  # largest force that lifts off in it
    lift: float  # dS [m or rad] there
    phi: float  # [rad]
    rule: float  # c by the largest lifting force alone (5.57)


@record
class SpringFound:
    """The return spring; forces and stiffness of RK are moments [N*m] and [N*m/rad]."""

    method: str
    stiffness: float  # c [N/m]
    preload: float  # Q0 [N] or M0 at the lowest position
    highest: float  # Q0 + c dS at the largest dS
    asked: float | None  # K1 that was asked for
    lifting: float | None  # P_M, the largest force of inertia and weight that lifts off; None: nothing does
    phi: float | None  # [rad] where it stands, or where the tangent touches
    lift: float | None  # dS_M [m or rad] there
    phase: str  # "rise" or "return"; "" if nothing lifts off
    governing: Governing | None  # of the method safety, where a smaller P_M asks for the stiffer spring
    exact: float | None  # least stiffness that keeps K1 all over the turn with this preload; None: there is none
    exact_phi: float | None  # [rad] where it is needed
    reached: float | None  # least |Q_spring|/P where P > 0
    reached_phi: float | None  # [rad]
    wire: Wire | None


@record
class GuideFound:
    """The guide of a stem; heights above O [m]."""

    lower: float  # H1
    top: float  # H2
    length: float  # l


@record
class ForceExtreme:
    """Least and largest value of a quantity over the turn, one-sided limits included; angles [rad]."""

    name: str  # header of its column without the unit
    unit: str
    least: float
    least_phi: float
    largest: float
    largest_phi: float

    @property
    def size(self) -> float:
        """Largest magnitude."""
        return max(abs(self.least), abs(self.largest))

    @property
    def place(self) -> float:
        """Where it stands."""
        return self.largest_phi if abs(self.largest) >= abs(self.least) else self.least_phi


@record
class Reserve:
    """The place nearest to jamming; angles [rad]."""

    useful: float  # cos(theta) - mu, at or below 0 the follower jams
    eaten: float  # mu/cos(theta), 1: it jams
    phi: float
    theta: float
    critical: float | None  # |theta| at which it would jam there; None: without friction, and for a flat face


@record
class CamWork:
    """Energy of a turn [J]; driving + force = friction."""

    driving: float  # that the camshaft gives
    given: float  # its positive part
    returned: float  # its negative part, that the follower gives back
    friction: float  # lost in guide or pivot
    force: float  # that the technological force gives
    mean: float  # mean driving torque [N*m]
    power: float  # mean power [W]
    error: float  # of the balance, relative to what is given and returned


@record
class CamForces:
    """Stage ``cam_forces``: forces at n rows, and over the turn. Canonical signs but for N1, N2, pivot: user's axes."""

    follower: Follower
    closure: Closure
    positions: Positions  # (n,)
    ends: tuple[float, ...]  # of the phases [rad], from 0 to the end of the turn
    speed: float  # omega [rad/s]
    stroke: float  # h [m] or psi_m [rad]
    lift: Values  # (n,) dS [m] or dpsi [rad]
    inertia: Values  # (n,) P or its moment along the lift
    elastic: Values  # (n,) of the spring, -(Q0 + c dS)
    force: Values  # (n,) technological force and weight
    load: Values  # (n,) P_c or M_c; closed where negative
    theta: Values  # (n,) [rad]
    ratio: Values  # (n,) mu
    contact: Values  # (n,) R [N], positive on the inner wall
    protrusion: Values | None  # (n,) q [m]
    lower: Values | None  # (n,) N1 [N] of the lower edge on the stem
    upper: Values | None  # (n,) N2 [N] of the upper edge
    pivot: Values | None  # (2, n) force of the frame on the rocker [N] in the pivot, OX from O to it
    torque: Values  # (n,) T = P_c S' [N*m] on the camshaft, without friction (5.75)
    driving: Values  # (n,) [N*m] that the camshaft has to give, with friction
    guide: GuideFound | None
    spring: SpringFound
    extremes: tuple[ForceExtreme, ...]
    lost: tuple[tuple[float, float], ...]  # from phi to phi [rad], nothing presses the follower on the cam
    reversals: tuple[float, ...]  # phi [rad] where the roller goes from wall to wall of a groove
    reserve: Reserve
    work: CamWork
    verdict: str  # "ok" or "loss_of_contact"
    notes: tuple[str, ...]
    error: Errors  # estimates, relative: of load, contact, guide, pivot, torques, extremes, spring, work

    @property
    def labels(self) -> tuple[str, ...]:
        """Labels of the rows."""
        return self.positions.labels

    def extreme(self, name: str) -> ForceExtreme:
        """The extremes of a quantity by its name."""
        return next(each for each in self.extremes if each.name == name)
