"""What the stage ``cam_strength`` leaves: the margins of all requirements, and what they are made of at the rows."""

from __future__ import annotations

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.kernels import Mask
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.program import Positions
from tmmcalc.cams.rounding import Errors
from tmmcalc.core.records import record

OK, OPEN = "ok", "not judged"


@record
class Margin:
    """One requirement: what there is, what is allowed, and what is left of it."""

    name: str  # for people
    constraint: int | None  # number in table 5.5
    verdict: str  # "ok", "not judged", or what is wrong: "slip", "undercut", "tool_interference", "exceeded"
    formula: str
    symbol: str = ""
    unit: str = ""  # SI
    value: float | None = None
    limit: float | None = None
    margin: float | None = None  # 1 - value/limit, or 1 - limit/value of what has to be large
    phi: float | None = None  # [rad] where the value stands
    why: str = ""  # why it is not judged, or what else there is to say
    advice: bool = False  # a recommendation: it decides nothing


@record
class RollerUnit:
    """Roller and pin."""

    pin: float  # r0 [m]
    given: bool  # r0 is given, else by the pressure on it
    least: float  # r2* = alpha0 r0 [m]

    def fits(self, roller: float) -> bool:
        """Whether the pin goes into a roller of radius r2 [m]."""
        return self.pin < roller


@record
class Rolling:
    """The slip function's constants; intervals of phi [rad]."""

    resisting: float  # C1
    driving: float  # C2 [N/m]
    inertia: float  # J [kg*m^2] of the roller
    slipping: tuple[tuple[float, float], ...]  # where D > 1


@record
class ShaftFound:
    """The camshaft between its supports."""

    moment: float | None  # largest M_E [N*m]
    moment_phi: float | None  # [rad] where it stands
    moment_rubbed: float | None  # the same with the torque that friction adds
    strength: float | None  # r1' [m]
    stiffness: float | None  # r1'' [m]
    radius: float  # r1* [m], the larger one rounded up to a whole mm


@record
class CamStrength:
    """Stage ``cam_strength``; what has no data is None."""

    follower: Follower
    positions: Positions  # (n,)
    ends: tuple[float, ...]  # of the phases [rad], from 0 to the end of the turn
    touching: Mask  # (n,) a wall presses on the roller, so that it can roll
    curvature: Values  # (n,) kappa [1/m] of the pitch curve, or of the profile under a flat face
    run: Values | None  # (n,) A [m] of the roller; of a varying speed what it accelerates by, over the mean squared
    slip: Values | None  # (n,) D; 0 where nothing presses
    stress: Values | None  # (n,) sigma_H [Pa]
    reduced: Values | None  # (n,) M_E [N*m]
    bending: Values | None  # (n,) stress of the stem [Pa]
    pressure: Values | None  # (n,) larger pressure of the two edges of the guide [Pa]
    convex: float | None  # rho2 [m], least radius of convex parts; None: there are none
    convex_phi: float
    concave: float | None  # rho1 [m], least radius of concave parts; None: there are none
    concave_phi: float
    unit: RollerUnit | None
    rolling: Rolling | None
    shaft: ShaftFound | None
    margins: tuple[Margin, ...]
    verdict: str  # the gravest of the margins' verdicts: "undercut", "tool_interference", "slip", "exceeded", "ok"
    notes: tuple[str, ...]
    error: Errors  # estimates, relative: of the rows by their names, of the extremes behind the margins

    @property
    def judged(self) -> tuple[Margin, ...]:
        """The margins that decide."""
        return tuple(each for each in self.margins if each.verdict != OPEN and not each.advice)

    @property
    def governing(self) -> Margin | None:
        """The least margin."""
        known = [each for each in self.judged if each.margin is not None]
        return min(known, key=lambda each: each.margin or 0.0) if known else None
