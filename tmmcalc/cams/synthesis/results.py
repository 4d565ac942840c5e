"""What the synthesis finds: the follower, the designs beside it, the region of admissible centres."""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Follower, FollowerKind
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.pivot import PivotRoom
from tmmcalc.cams.pressure.angle import Extreme, Reached
from tmmcalc.cams.rounding import Errors
from tmmcalc.core.records import record

PLANE = "e, S0"  # frames of a region
PIVOT = "from the pivot A, x along the lowest rocker, y towards its lift"


@record
class Size:
    """One size of the follower and where it comes from."""

    symbol: str  # S0, R0, e, l0, l2, psi0, r2
    value: float  # [m] or [rad]; e in the user's sense
    given: bool
    how: str  # the rule that found it; "given"


@record
class Design:
    """Sizes by one rule, and the pressure angles that they really reach."""

    name: str
    base: float  # R0 [m]
    start: float  # S0 [m] or psi0 [rad]
    offset: float  # e [m], canonical; RT
    centres: float  # l0 [m]; RK
    rocker: float  # l2 [m]; RK
    rise: tuple[float, float]  # least and largest theta [rad]
    back: tuple[float, float]
    excess: float  # of |theta| beyond its limit [rad]; negative: within


@record
class Region:
    """Corners (m,) of the admissible places of the cam's axis, counter-clockwise; a window cuts it where it is open.

    RT: x is e (canonical), y is S0. RK: from the pivot A, x along the rocker in its lowest position, y to its lift.
    The side from a corner to the next belongs to the cam angle ``phi``.
    """

    frame: str  # PLANE or PIVOT
    x: Values  # (m,) [m]
    y: Values  # (m,) [m]
    phi: Values  # (m,) [rad]; 0 on a cut
    side: Indices  # (m,) +1 or -1: theta reaches its limit with this sign; 0: cut


@record
class Convexity:
    """What a flat face asks of S0: rho = S0 + F > 0 with F = dS + S'' (5.96, 5.97)."""

    least: Extreme  # F_min [m] and where
    limit: float  # r_m [m]
    needed: float  # S0 >= r_m - F_min [m]
    radius: float  # least radius of the profile with the S0 taken [m]
    left: float  # reach of the face to the left of the axis, user's sense, margin included [m]
    right: float
    margin: float  # [m]


@record
class RollerRule:
    """An upper bound of the roller's radius."""

    name: str
    value: float  # [m]


@record
class RollerChoice:
    """The roller and what bounds it."""

    radius: float  # r2 [m]
    governs: str  # the smallest bound
    rules: tuple[RollerRule, ...]
    convex: Extreme  # rho2 [m], least radius of the convex parts of the pitch curve
    concave: Extreme | None  # rho1 [m], of the concave parts; None: there are none


@record
class Synthesis:
    """Stage ``cam_synthesis``."""

    kind: FollowerKind
    follower: Follower
    sizes: tuple[Size, ...]
    governs: str  # what decides the size of the cam
    designs: tuple[Design, ...]  # the one taken, other exact ones, the textbook's
    rounded: Design | None  # the next whole millimetres that keep the limits
    rise: Reached | None  # None: a flat face has no pressure angle
    back: Reached | None
    region: Region | None
    convexity: Convexity | None
    roller: RollerChoice | None
    residual: float  # [rad] by how much the sizes found miss the limit that they are to reach; 0 if they reach none
    notes: tuple[str, ...]
    error: Errors  # estimates: of the sizes relative to R0, of angles and radii relative to themselves
    pivot: PivotRoom | None = None  # None: no rocker


def region_columns(result: Synthesis) -> dict[str, Values]:
    """Corners of the admissible region by their headers; no rows without a region."""
    region = result.region
    if region is None:
        return {"x_O[m]": np.empty(0), "y_O[m]": np.empty(0)}
    sign = result.follower.sense if result.kind == "translating" else 1
    names = ("e[m]", "S0[m]") if result.kind == "translating" else ("x_O[m]", "y_O[m]")
    return {
        names[0]: sign * region.x,
        names[1]: region.y,
        "phi[deg]": np.degrees(region.phi),
        "side": region.side,
    }
