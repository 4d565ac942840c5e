"""What the profile stage finds."""

from __future__ import annotations

from typing import Literal

from tmmcalc.cams.follower import Complex, Follower
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.pivot import PivotRoom
from tmmcalc.cams.program import Positions
from tmmcalc.cams.rounding import Errors
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

    distance: float  # [m]
    cause: Literal["cusp", "neck"]  # the curvature at one place, or two places that face each other
    at: tuple[float, ...]  # [rad] of the place, or of both


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
    loops: tuple[tuple[float, float], ...]  # (from, to) [rad] where it runs backwards; to > 2 pi beyond phi = 0
    crossings: tuple[Crossing, ...]
    sound: bool  # it neither turns back nor crosses itself


@record
class Face:
    """What a flat face has to reach from its axis [m]; seen along the lift, in the user's sense."""

    left: float
    right: float
    margin: float  # on both sides

    @property
    def length(self) -> float:
        """Of the whole face [m]."""
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
    pitch_curvature: Values | None  # (n,) [1/m], positive where it bulges outwards; None: flat face
    curvature: Values  # (n,) [1/m] of the working profile
    tool_radius: float | None  # [m]
    sharpest: Place  # largest curvature of the pitch curve [1/m]; flat face: least radius of the profile [m]
    hollowest: Place | None  # least curvature of the pitch curve [1/m], negative; None: convex
    inner_reach: Reach | None  # the largest roller; None: flat face
    outer_reach: Reach | None  # the same for the second wall; None: unlimited
    largest_tool: float | None  # [m] of the working profile; None: any
    nearest: Place  # least distance of the working profile from the axis of the cam [m]
    face: Face | None
    pivot: PivotRoom | None  # None: no rocker
    remarks: tuple[str, ...]
    error: Errors  # estimates, relative: of points, normals, curvature, limits, angles of loops

    @property
    def flat(self) -> bool:
        """The follower has a flat face."""
        return self.follower.kind == "flat"

    @property
    def least_convex(self) -> float:
        """rho2 - r2, least radius of convex parts of the working profile [m]; negative if it is undercut."""
        return self.sharpest.value if self.flat else 1 / self.sharpest.value - self.follower.roller

    @property
    def least_concave(self) -> float | None:
        """rho1 + r2, least radius of concave parts of the working profile [m]; None: convex."""
        return None if self.hollowest is None else -1 / self.hollowest.value + self.follower.roller

    @property
    def walls(self) -> tuple[Wall, ...]:
        """All walls and tool paths."""
        return tuple(wall for wall in (self.working, self.outer, self.tool, self.outer_tool) if wall is not None)
