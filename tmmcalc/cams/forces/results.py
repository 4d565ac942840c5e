"""What the stage ``cam_forces`` leaves. Forces [N] of RT and PT are moments about the pivot [N*m] of RK where said."""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Closure, Follower
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.program import Positions
from tmmcalc.cams.rounding import Errors
from tmmcalc.core.notes import Said
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record


@record
class Wire:
    """A compression spring wound of round wire."""

    index: float  # D/d
    coils: float = quantity("coils", "number of working coils", symbol="n")
    factor: float = quantity("k_w", "factor of the stress at the inside of the coils (Wahl)")
    stress: float = quantity("tau_max[Pa]", "shear stress at the highest position")
    stress_low: float = quantity("tau_min[Pa]", "shear stress at the lowest position")


@record
class WireSize:
    """A compression spring whose stress at the highest position is the allowed one."""

    index: float = quantity("index", "D/d of the spring", symbol="D/d")
    wire: float = quantity("d[m]", "diameter of the wire")
    coil: float = quantity("D[m]", "mean diameter of the coils")
    coils: float = quantity("n", "number of working coils")
    solid: float = quantity("H_solid[m]", "height with all coils in touch")
    free: float = quantity("H_free[m]", "height without a force")


@record
class Governing:
    """The phase that asks for the stiffness, where that is not the phase of the largest lifting force."""

    phase: str = quantity("c_by", "phase that asks for the stiffness: rise or return")
    force: float  # largest force that lifts off in it
    lift: float  # dS [m or rad] there
    phi: float = quantity("c_by_phi[rad]", "angle of the cam where the stiffness is asked for")
    rule: float = quantity("c_rule[{rate}]", "stiffness by the largest lifting force alone", source="(5.57)")


@record
class SpringFound:
    """The return spring; forces and stiffness of RK are moments [N*m] and [N*m/rad]."""

    method: str = quantity("method", "how the spring is found: none, given, safety or preload")
    stiffness: float = quantity("c[{rate}]", "stiffness of the return spring")
    preload: float = quantity("{spring}0[{force}]", "preload of the spring at the lowest position")
    highest: float = quantity("{spring}_max[{force}]", "force of the spring {spring} at the highest position")
    asked: float | None = quantity("K1", "safety of the contact that is asked for", symbol="K_1")
    lifting: float | None = quantity(  # None: nothing lifts off
        "{load}_M[{force}]", "largest force of inertia and weight that lifts off"
    )
    phi: float | None = quantity("phi_M[rad]", "angle of the largest lifting force, or where the tangent touches")
    lift: float | None = quantity("d{coordinate}_M[{size}]", "displacement there")
    phase: str  # "rise" or "return"; "" if nothing lifts off
    governing: Governing | None  # of the method safety, where a smaller P_M asks for the stiffer spring
    exact: float | None = quantity(  # None: there is none
        "c_exact[{rate}]", "least stiffness that keeps K1 all over the turn with this preload"
    )
    exact_phi: float | None  # [rad] where it is needed
    reached: float | None = quantity("K_min", "least |Q_spring|/P where P > 0")
    reached_phi: float | None = quantity("K_min_at_phi[rad]", "angle of the least safety")
    wire: Wire | None
    sizes: tuple[WireSize, ...] = ()  # of the usual D/d, where a stress is allowed


@record
class GuideFound:
    """The guide of a stem; heights above O [m]."""

    lower: float = quantity("H1[m]", "height of the guide's lower edge", symbol="H_1")
    top: float = quantity("H2[m]", "height of the guide's upper edge", symbol="H_2")
    length: float = quantity("l[m]", "length of the guide")


@record
class ForceExtreme:
    """Least and largest value of a quantity over the turn, one-sided limits included; angles [rad]."""

    name: str  # header of its column without the unit
    unit: str
    least: float = quantity("{name}_min[{unit}]", "least {name} over the turn")
    least_phi: float = quantity("{name}_min_at_phi[rad]", "angle of the least {name}")
    largest: float = quantity("{name}_max[{unit}]", "largest {name} over the turn")
    largest_phi: float = quantity("{name}_max_at_phi[rad]", "angle of the largest {name}")

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
    eaten: float = quantity("friction_part", "mu/cos(theta); at 1 the follower jams")
    phi: float = quantity("friction_part_at_phi[rad]", "angle of the cam nearest to jamming")
    theta: float
    critical: float | None = quantity(  # None: without friction, and for a flat face
        "theta_critical[rad]", "|theta| at which the follower would jam there"
    )


@record
class CamWork:
    """Energy of a turn [J]; driving + force = friction."""

    driving: float = quantity("W_drive[J]", "work of the camshaft in a turn")
    given: float = quantity("W_given[J]", "its positive part")
    returned: float = quantity("W_back[J]", "its negative part, that the follower gives back")
    friction: float = quantity("W_friction[J]", "work lost by friction in guide or pivot")
    force: float = quantity("W_Q[J]", "work of the technological force")
    mean: float = quantity("M_mean[N*m]", "mean driving torque")
    power: float = quantity("P_mean[W]", "mean power")
    error: float = quantity("work_error", "error of the balance over what is given and returned")

    @derived("eta_turn", "efficiency of a turn: work done against the technological force over that of the camshaft")
    def efficiency(self) -> float | None:
        """None: nothing useful is done."""
        return -self.force / self.driving if self.force < 0 < self.driving else None


@record
class CamForces:
    """Stage ``cam_forces``: forces at n rows, and over the turn. Canonical signs but for N1, N2, pivot: user's axes."""

    follower: Follower
    closure: Closure
    positions: Positions  # (n,)
    ends: tuple[float, ...]  # of the phases [rad], from 0 to the end of the turn
    speed: float = quantity("omega[rad/s]", "speed of the cam")
    stroke: float  # h [m] or psi_m [rad]
    # (n,) each; along the lift forces, of a rocker moments
    lift: Values = quantity("d{coordinate}[{size}]", "displacement from the lowest position")
    inertia: Values = quantity("{load}_in[{force}]", "inertia along the lift")
    elastic: Values = quantity("{spring}_spring[{force}]", "force of the spring along the lift")
    force: Values = quantity("{given}[{force}]", "technological force with the weight along the lift")
    load: Values = quantity("{load}_c[{force}]", "resultant along the lift; it presses on the cam where negative")
    theta: Values = quantity("theta[rad]", "pressure angle")
    ratio: Values = quantity("mu", "friction in guide or pivot over the force of the cam")
    contact: Values = quantity("R[N]", "force of the cam on the follower, in a groove positive on the inner wall")
    protrusion: Values | None = quantity("q[m]", "length of the stem out of the guide")
    lower: Values | None = quantity("N1[N]", "force of the guide's lower edge on the stem", symbol="N_1")
    upper: Values | None = quantity("N2[N]", "force of the guide's upper edge on the stem", symbol="N_2")
    pivot: Values | None  # (2, n) force of the frame on the rocker [N] in the pivot, OX from O to it
    torque: Values = quantity("T[N*m]", "torque P_c S' on the camshaft, without friction", source="(5.75)")
    driving: Values = quantity("M_drive[N*m]", "torque that the camshaft has to give, with friction")
    guide: GuideFound | None
    spring: SpringFound
    extremes: tuple[ForceExtreme, ...]
    lost: tuple[tuple[float, float], ...] = quantity(
        "lost[rad]", "angles of the cam between which nothing presses the follower on it"
    )
    reversals: tuple[float, ...] = quantity(
        "reversals[rad]", "angles of the cam at which the roller goes from wall to wall of a groove"
    )
    reserve: Reserve
    work: CamWork
    verdict: str = quantity("verdict", "ok or loss_of_contact")
    notes: tuple[Said, ...]
    error: Errors  # estimates, relative: of load, contact, guide, pivot, torques, extremes, spring, work

    @derived("R_A_x[N]", "force of the frame on the rocker along x")
    def pivot_x(self) -> Values:
        """(n,) of a rocker."""
        assert self.pivot is not None
        return self.pivot[0]

    @derived("R_A_y[N]", "force of the frame on the rocker along y")
    def pivot_y(self) -> Values:
        """(n,) of a rocker."""
        assert self.pivot is not None
        return self.pivot[1]

    @derived("R_A[N]", "force of the frame on the rocker")
    def pivot_force(self) -> Values:
        """(n,) of a rocker."""
        return np.hypot(self.pivot_x, self.pivot_y)

    @property
    def labels(self) -> tuple[str, ...]:
        """Labels of the rows."""
        return self.positions.labels

    def extreme(self, name: str) -> ForceExtreme:
        """The extremes of a quantity by its name."""
        return next(each for each in self.extremes if each.name == name)
