"""What the synthesis finds: the follower, the designs beside it, the region of admissible centres."""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Follower, FollowerKind
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.pivot import PivotRoom
from tmmcalc.cams.pressure.angle import Extreme, Reached
from tmmcalc.cams.rounding import Errors
from tmmcalc.core.notes import Said
from tmmcalc.core.quantity import headed, keys, quantity
from tmmcalc.core.records import record

PLANE = "e, S0"  # frames of a region
OFFSET, CENTRE = {"x": "e", "y": "S0"}, {"x": "x_O", "y": "y_O"}  # what the coordinates of a region are
PIVOT = "from the pivot A, x along the lowest rocker, y towards its lift"


@record
class Size:
    """One size of the follower and where it comes from."""

    symbol: str  # S0, R0, e, l0, l2, psi0, r2
    value: float = quantity("{symbol}[{unit}]", "size {symbol}")  # e in the user's sense
    given: bool = quantity("{symbol}_given", "the size {symbol} is given")
    how: str  # the rule that found it; "given"


@record
class Design:
    """Sizes by one rule, and the pressure angles that they really reach."""

    name: str = quantity("name", "the rule of the design")
    base: float  # R0 [m]
    start: float  # S0 [m] or psi0 [rad]
    offset: float  # e [m], canonical; RT
    centres: float  # l0 [m]; RK
    rocker: float  # l2 [m]; RK
    rise: tuple[float, float] = quantity(
        "theta_rise[rad]", "least and largest pressure angle on the rise", header="rise[rad]"
    )
    back: tuple[float, float] = quantity(
        "theta_return[rad]", "least and largest pressure angle on the return", header="return[rad]"
    )
    excess: float = quantity(
        "beyond_limit[rad]", "excess of |theta| over its limit; negative: within", header="beyond[rad]"
    )


@record
class Region:
    """Corners (m,) of the admissible places of the cam's axis, counter-clockwise; a window cuts it where it is open.

    RT: x is e (canonical), y is S0. RK: from the pivot A, x along the rocker in its lowest position, y to its lift.
    The side from a corner to the next belongs to the cam angle ``phi``.
    """

    frame: str  # PLANE or PIVOT
    x: Values = quantity("{x}[m]", "corner of the admissible region")  # (m,)
    y: Values = quantity("{y}[m]", "corner of the admissible region")  # (m,)
    phi: Values = quantity("phi[rad]", "angle of the cam to which the side belongs; 0 on a cut")  # (m,)
    side: Indices = quantity("side", "+1 or -1: theta reaches its limit with this sign; 0: cut")  # (m,)


@record
class Convexity:
    """What a flat face asks of S0: rho = S0 + F > 0 with F = dS + S'' (5.96, 5.97)."""

    least: Extreme = quantity("F_min[m]", "least dS + S''")
    limit: float = quantity("r_m[m]", "least radius of curvature of the profile that is allowed")
    needed: float = quantity("S0_min[m]", "least start distance, r_m - F_min")
    radius: float = quantity("rho_min[m]", "least radius of curvature of the profile with the start distance taken")
    # user's sense, margin included
    left: float = quantity("face_left[m]", "reach of the face to the left of the axis")
    right: float = quantity("face_right[m]", "reach of the face to the right of the axis")
    margin: float  # [m]


@record
class RollerRule:
    """An upper bound of the roller's radius."""

    name: str
    value: float = quantity("r2_max: {rule}[m]", "largest radius of the roller by the rule")


@record
class RollerChoice:
    """The roller and what bounds it."""

    radius: float  # r2 [m]
    governs: str = quantity("r2_governs", "the smallest bound of the roller's radius")
    rules: tuple[RollerRule, ...]
    convex: Extreme = quantity("rho2[m]", "least radius of convex parts of the pitch curve", symbol="rho_2")
    concave: Extreme | None = quantity(  # None: there are none
        "rho1[m]", "least radius of concave parts of the pitch curve", symbol="rho_1"
    )


@record
class Synthesis:
    """Stage ``cam_synthesis``."""

    kind: FollowerKind = quantity("follower", "kind of the follower")
    follower: Follower
    sizes: tuple[Size, ...]
    governs: str = quantity("governs", "what decides the size of the cam")
    designs: tuple[Design, ...]  # the one taken, other exact ones, the textbook's
    rounded: Design | None  # the next whole millimetres that keep the limits
    rise: Reached | None  # None: a flat face has no pressure angle
    back: Reached | None
    region: Region | None
    convexity: Convexity | None
    roller: RollerChoice | None
    residual: float = quantity(  # 0 if they reach none
        "residual[rad]", "by how much the sizes found miss the limit that they are to reach"
    )
    notes: tuple[Said, ...]
    error: Errors  # estimates: of the sizes relative to R0, of angles and radii relative to themselves
    pivot: PivotRoom | None = None  # None: no rocker


def region_columns(result: Synthesis) -> dict[str, Values]:
    """Corners of the admissible region by their headers; no rows without a region."""
    region = result.region
    if region is None:
        return {key: np.empty(0) for key in keys(Region, "x", "y", **CENTRE)}
    translating = result.kind == "translating"
    sides = headed(region, "x", "y", "phi[deg]", "side", **(OFFSET if translating else CENTRE))
    return sides | {next(iter(sides)): (result.follower.sense if translating else 1) * region.x}
