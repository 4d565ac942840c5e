"""What the profile stage finds."""

from __future__ import annotations

from typing import Literal

from tmmcalc.cams.follower import Complex, Follower
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pivot import PivotRoom
from tmmcalc.cams.program import Positions
from tmmcalc.cams.rounding import Errors
from tmmcalc.core.notes import Said
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record

WallName = Literal["inner", "outer", "tool", "outer tool"]
WALLS: dict[WallName, str] = {
    "inner": "working profile",
    "outer": "second wall",
    "tool": "tool path",
    "outer tool": "second tool path",
}


@record
class Place:
    """An extreme value over the turn."""

    value: float
    phi: float  # [rad]
    side: int  # -1: the limit before a jump at phi, 1: after it, 0: smooth there


@record
class Reach:
    """How far a curve can be offset to one side before its offset gets a point or crosses itself."""

    distance: float = quantity("{part}_max[m]", "largest {part}")
    cause: Literal["cusp", "neck"] = quantity(
        "{part}_max_cause", "cusp: the curvature at one place; neck: two places that face each other"
    )
    at: tuple[float, ...] = quantity("{part}_max_at_phi[rad]", "angle of the cam at the place, or at both")


@record
class Crossing:
    """Two angles at which a wall passes the same point: between them the follower leaves its law."""

    first: float  # [rad]
    second: float  # [rad], larger
    point: complex  # [m]


@record
class Wall:
    """An offset of the pitch curve (of the profile under a flat face)."""

    name: WallName
    distance: float  # [m] inwards
    points: Complex  # (n,) [m]
    loops: tuple[tuple[float, float], ...] = quantity(  # to > 2 pi beyond phi = 0
        "{wall}_loops[rad]", "angles of the cam between which the curve runs backwards"
    )
    crossings: tuple[Crossing, ...]
    sound: bool  # it neither turns back nor crosses itself

    @derived("{wall}_crossings[rad]", "pairs of angles of the cam at which the curve passes the same point")
    def crossed(self) -> tuple[tuple[float, float], ...]:
        """Of all crossings."""
        return tuple((each.first, each.second) for each in self.crossings)


@record
class Face:
    """What a flat face has to reach from its axis [m]; seen along the lift, in the user's sense."""

    left: float = quantity("face_left[m]", "reach of the face to the left of its axis")
    right: float = quantity("face_right[m]", "reach of the face to the right of its axis")
    margin: float  # on both sides

    @derived("face_length[m]", "length of the face")
    def length(self) -> float:
        """With the margins."""
        return self.left + self.right + 2 * self.margin


@record
class Profile:
    """The curves of a cam at n rows, in the user's sense [m], and their limits.

    x leads to the right and y along the lift at phi = 0; for a rocker x leads to its pivot.
    """

    positions: Positions  # (n,)
    follower: Follower
    pitch: Complex | None  # (n,); None: flat face
    working: Wall
    outer: Wall | None  # second wall of a groove
    tool: Wall | None  # path of the tool's centre along the working profile
    outer_tool: Wall | None  # and along the second wall
    normal: Complex  # (n,) unit normal of the curves, out of the cam
    pitch_curvature: Values | None = quantity(  # (n,) None: flat face
        "kappa_c[1/m]", "curvature of the pitch curve, positive where it bulges outwards"
    )
    curvature: Values = quantity("kappa_w[1/m]", "curvature of the working profile")  # (n,)
    tool_radius: float | None = quantity("tool[m]", "radius of the tool")
    sharpest: Place  # largest curvature of the pitch curve [1/m]; flat face: least radius of the profile [m]
    hollowest: Place | None  # least curvature of the pitch curve [1/m], negative; None: convex
    inner_reach: Reach | None  # the largest roller; None: flat face
    outer_reach: Reach | None  # the same for the second wall; None: unlimited
    largest_tool: float | None = quantity(  # None: any
        "tool_max[m]", "radius of the largest tool for the working profile"
    )
    nearest: Place = quantity("r_min[m]", "least distance of the working profile from the axis of the cam")
    face: Face | None
    pivot: PivotRoom | None  # None: no rocker
    remarks: tuple[Said, ...]
    error: Errors  # estimates, relative: of points, normals, curvature, limits, angles of loops

    @property
    def flat(self) -> bool:
        """The follower has a flat face."""
        return self.follower.kind == "flat"

    @derived("rho_min[m]", "least radius of the profile under a flat face")
    def flat_least(self) -> Place:
        """Of a flat face."""
        return self.sharpest

    @derived("rho2[m]", "least radius of convex parts of the pitch curve", symbol="rho_2")
    def convex(self) -> Place:
        """Of a roller."""
        return Place(1 / self.sharpest.value, self.sharpest.phi, self.sharpest.side)

    @derived("rho1[m]", "least radius of concave parts of the pitch curve", symbol="rho_1")
    def concave(self) -> Place | None:
        """None: convex."""
        hollow = self.hollowest
        return None if hollow is None else Place(-1 / hollow.value, hollow.phi, hollow.side)

    @derived("n_x", "normal out of the cam along x")
    def normal_x(self) -> Values:
        """(n,)."""
        return self.normal.real

    @derived("n_y", "normal out of the cam along y")
    def normal_y(self) -> Values:
        """(n,)."""
        return self.normal.imag

    @derived("rho_w_convex[m]", "least radius of convex parts of the working profile, rho2 - r2")
    def least_convex(self) -> float:
        """Negative if the profile is undercut."""
        return self.sharpest.value if self.flat else 1 / self.sharpest.value - self.follower.roller

    @derived("rho_w_concave[m]", "least radius of concave parts of the working profile, rho1 + r2")
    def least_concave(self) -> float | None:
        """None: convex."""
        return None if self.hollowest is None else -1 / self.hollowest.value + self.follower.roller

    @property
    def walls(self) -> tuple[Wall, ...]:
        """All walls and tool paths."""
        return tuple(wall for wall in (self.working, self.outer, self.tool, self.outer_tool) if wall is not None)
