"""The records that the stage of wanted paths leaves, apart from the code that makes them."""

from __future__ import annotations

from typing import Literal

from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.linkage.results import Grade

Order = Literal["along", "against", "none"]


@record
class PathDeviation:
    """How far the path of a point is from its n wanted points: from the nearest places, or those of the timing."""

    name: str
    point: str
    count: int  # n
    timed: bool
    total: float = quantity(
        "deviation_sum_{path}[m^2]", "sum of the squares of the distances of path {path} from its points"
    )
    rms: float = quantity("deviation_rms_{path}[m]", "root mean square of the distances of path {path} from its points")
    largest: float = quantity("deviation_max_{path}[m]", "greatest distance of path {path} from one of its points")
    worst: int = quantity("deviation_worst_{path}", "number of the point from which path {path} is the farthest")
    worst_at: float = quantity(
        "deviation_max_phi_{path}[{own}]", "input coordinate from position 0 where path {path} is nearest to that point"
    )
    covered: float = quantity(
        "deviation_covered_{path}[{own}]", "part of the input over which path {path} is nearest to its points"
    )
    order: Order | None  # in which the nearest places follow: along the motion, against it; None: as timed

    @derived("deviation_ordered_{path}", "whether path {path} meets its points in their order, one way or the other")
    def ordered(self) -> bool:
        """Whether the points are met in their order, one way or the other; those that are timed are."""
        return self.order != "none"


@record
class PathError:
    """Estimated largest errors over all points [-]."""

    distance: float = quantity("distance", "error of distances, relative to the largest coordinate of path and points")
    place: float = quantity("place", "error of the places of the input, relative to its range")


@record
class Paths:
    """Result of the stage of wanted paths: n points of all paths, one path after the other."""

    turns: bool
    closed: bool = quantity("deviation_whole_turn", "whether the paths are those of a whole turn of the crank")
    paths: tuple[PathDeviation, ...]
    labels: tuple[str, ...]  # (n,)
    phi: Real  # (n,) input coordinate counted from position 0 [rad or m]
    wanted: Plane  # (n,) points [m]
    reached: Plane  # (n,) places of the path [m]
    error: PathError = quantity("error", "estimated errors")
    grades: tuple[Grade, ...]
    counters: dict[str, int]
