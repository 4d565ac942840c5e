"""What the stage ``cam_strength`` leaves: the margins of all requirements, and what they are made of at the rows."""

from __future__ import annotations

from tmmcalc.cams.follower import Follower
from tmmcalc.cams.forces.formulas import Mask
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.program import Positions
from tmmcalc.cams.rounding import Errors
from tmmcalc.cams.strength.formulas import unused
from tmmcalc.core.notes import Said
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record

OK, OPEN = "ok", "not judged"


@record
class Margin:
    """One requirement: what there is, what is allowed, and what is left of it."""

    name: str = quantity("requirement", "name of the requirement")
    constraint: int | None = quantity("constraint", "number in table 5.5")
    verdict: str = quantity("verdict", "ok, not judged, or what is wrong: slip, undercut, tool_interference, exceeded")
    formula: str = quantity("formula", "formula of the requirement")
    symbol: str = quantity("symbol", "symbol of the value", default="")
    unit: str = ""  # SI unit of value and limit
    value: float | None = quantity("value[{unit}]", "value that is judged", default=None)
    limit: float | None = quantity("limit[{unit}]", "its limit", default=None)
    margin: float | None = quantity(
        "margin", "1 - value/limit, or 1 - limit/value of what has to be large", default=None
    )
    phi: float | None = quantity("phi[rad]", "angle of the cam where the value stands", default=None)
    why: str = quantity("why", "why it is not judged, or what else there is to say", default="")
    advice: bool = quantity("advice", "a recommendation: it decides nothing", default=False)


def stressed(
    name: str, constraint: int, formula: str, symbol: str, value: float, limit: float | None, phi: float, key: str
) -> Margin:
    """The largest stress [Pa] with its margin, or without one where ``key`` gives no limit."""
    if limit is None:
        why = f"give {key} in [cam.requirements]"
        return Margin(name, constraint, OPEN, formula, symbol, "Pa", value, phi=phi, why=why)
    return judged(name, constraint, formula, symbol, "Pa", value, limit, float(unused(value, limit)), phi)


def judged(
    name: str,
    constraint: int | None,
    formula: str,
    symbol: str,
    unit: str,
    value: float,
    limit: float,
    margin: float,
    phi: float | None,
    fault: str = "exceeded",
    why: str = "",
) -> Margin:
    """A margin with its verdict."""
    verdict = OK if margin >= 0 else fault
    return Margin(name, constraint, verdict, formula, symbol, unit, value, limit, margin, phi, why)


@record
class RollerUnit:
    """Roller and pin."""

    pin: float = quantity("r0[m]", "radius of the pin", symbol="r_0")
    given: bool = quantity("r0_given", "the radius of the pin is given, else by the pressure on it")
    least: float = quantity("r2_least[m]", "least radius of the roller, alpha0 r0", symbol="r_2^*")

    def fits(self, roller: float) -> bool:
        """Whether the pin goes into a roller of radius r2 [m]."""
        return self.pin < roller


@record
class Rolling:
    """The slip function's constants; intervals of phi [rad]."""

    resisting: float = quantity("C1", "constant of the resistance in the slip function", symbol="C_1")
    driving: float = quantity("C2[N/m]", "constant of the inertia in the slip function", symbol="C_2")
    inertia: float = quantity("J_roller[kg*m^2]", "moment of inertia of the roller")
    slipping: tuple[tuple[float, float], ...] = quantity(
        "slipping[rad]", "angles of the cam between which the roller slips, D > 1"
    )


@record
class ShaftFound:
    """The camshaft between its supports."""

    moment: float | None = quantity("M_E_max[N*m]", "largest reduced moment of the camshaft")
    moment_phi: float | None  # [rad] where it stands
    moment_rubbed: float | None  # the same with the torque that friction adds
    strength: float | None = quantity("r1_strength[m]", "radius of the camshaft by its strength", symbol="r_1'")
    stiffness: float | None = quantity("r1_stiffness[m]", "radius of the camshaft by its stiffness", symbol="r_1''")
    radius: float = quantity("r1[m]", "the larger radius rounded up to a whole mm", symbol="r_1^*")

    @derived("M_E_max_friction[N*m]", "largest reduced moment with the torque that friction adds")
    def moment_with_friction(self) -> float | None:
        """Without friction the same."""
        return self.moment_rubbed or self.moment


@record
class CamStrength:
    """Stage ``cam_strength``; what has no data is None."""

    follower: Follower
    positions: Positions  # (n,)
    ends: tuple[float, ...]  # of the phases [rad], from 0 to the end of the turn
    touching: Mask  # (n,) a wall presses on the roller, so that it can roll
    # (n,) each
    curvature: Values = quantity("kappa[1/m]", "curvature of the pitch curve, or of the profile under a flat face")
    run: Values | None = quantity(  # of a varying speed what it accelerates by, over the mean squared
        "A[m]", "acceleration of the roller over the speed squared"
    )
    slip: Values | None = quantity("D", "slip function; 0 where nothing presses")
    stress: Values | None = quantity("sigma_H[Pa]", "contact stress")
    reduced: Values | None = quantity("M_E[N*m]", "reduced moment of the camshaft")
    bending: Values | None = quantity("sigma_F[Pa]", "bending stress of the stem")
    pressure: Values | None = quantity("p[Pa]", "larger pressure of the two edges of the guide")
    # None: there are no such parts
    convex: float | None = quantity("{radius}[m]", "least radius of convex parts")
    convex_phi: float = quantity("{radius}_at_phi[rad]", "angle of the cam at the least convex radius")
    concave: float | None = quantity("rho1[m]", "least radius of concave parts", symbol="rho_1")
    concave_phi: float = quantity("rho1_at_phi[rad]", "angle of the cam at the least concave radius")
    unit: RollerUnit | None
    rolling: Rolling | None
    shaft: ShaftFound | None
    margins: tuple[Margin, ...]
    verdict: str = quantity(
        "verdict", "the gravest of the margins' verdicts: undercut, tool_interference, slip, exceeded, ok"
    )
    notes: tuple[Said, ...]
    error: Errors  # estimates, relative: of the rows by their names, of the extremes behind the margins

    @property
    def judged(self) -> tuple[Margin, ...]:
        """The margins that decide."""
        return tuple(each for each in self.margins if each.verdict != OPEN and not each.advice)

    @derived("judged", "number of the margins that decide")
    def judged_count(self) -> int:
        """Advice is none of them."""
        return len(self.judged)

    @derived("least_margin", "the least margin")
    def least_margin(self) -> float | None:
        """None: nothing is judged."""
        return None if self.governing is None else self.governing.margin

    @derived("least_margin_of", "the requirement of the least margin")
    def least_margin_of(self) -> str | None:
        """None: nothing is judged."""
        return None if self.governing is None else self.governing.name

    @property
    def governing(self) -> Margin | None:
        """The least margin."""
        known = [each for each in self.judged if each.margin is not None]
        return min(known, key=lambda each: each.margin or 0.0) if known else None
