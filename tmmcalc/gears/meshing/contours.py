"""The blocking contours of the pairs of a project; shifts are in normal modules.

Only external pairs have a contour: its conditions are those of two wheels cut by a rack.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.involute.contour.rounding import ContourError
from tmmcalc.gears.involute.rack import Rack
from tmmcalc.gears.model import Values


@record
class ContourCorner:
    """A corner, and the keys of the lines that meet in it."""

    x1: float
    x2: float
    lines: tuple[str, str]


@record
class Outline:
    """A closed curve in the plane of shifts, counter-clockwise; the first point is the last too."""

    x1: Values  # (n,)
    x2: Values  # (n,)
    edge: np.ndarray  # (n - 1,) number of the edge that each step belongs to
    edges: tuple[str, ...]  # keys of the lines (contour.task.LINES) of the edges, in their order
    corners: tuple[ContourCorner, ...]
    area: float


@record
class Area:
    """All admissible shifts, strict or tolerated."""

    strict: bool  # no undercut at all
    main: Outline | None  # None: nothing is admissible; then ``reason`` says why
    reason: str
    pieces: tuple[Outline, ...]  # beyond a pinch point, or apart, mostly with a tip inside its reference circle
    untraced: tuple[int, ...]  # wheels on whose side there are pieces whose outline is not found
    best_contact_ratio: float  # largest that the other conditions leave
    error: ContourError | None = None  # of the main curve; None: there is none


@record
class ContourLine:
    """A line of the picture."""

    number: str  # in the textbook's figures: 4, 5, 6, 7, 8, 9, 12, 14, 15, 16
    title: str  # what is constant along it
    value: float
    x1: Values  # (n,)
    x2: Values  # (n,)


@record
class ContourPoint:
    """A point of interest."""

    name: str  # C, D, E, "balanced", "equal strength", "chosen"
    title: str  # what is special about it
    x1: float
    x2: float
    contact_ratio: float
    tip_thickness: tuple[float, float]  # s_na, modules
    sliding: tuple[float, float]  # theta1 at A2, theta2 at A1
    form_factors: tuple[float, float]  # Y_F of both wheels, load at the tip
    distance: float  # a_w [m]
    strict: bool  # whether the strict contour holds it
    tolerated: bool


@record
class PairContour:
    """The contours of one external pair, its lines and points, and where the chosen shifts stand."""

    name: str
    teeth: tuple[int, int]
    module: float  # [m], normal
    helix: float  # beta [rad]
    rack: Rack
    contact_ratio: float  # eps_min
    thickness: float  # s_a,min, modules
    strict: Area
    tolerated: Area
    lines: tuple[ContourLine, ...]
    points: tuple[ContourPoint, ...]  # the chosen one first; what does not exist is left out
    missing: tuple[str, ...]  # the points that do not exist, with the reason
    margins: dict[str, float]  # of the chosen shifts, by the keys of the lines; modules
    # the admissible interval of x1 at the chosen sum of shifts that holds the chosen x1, or else is nearest to it
    low: float | None
    high: float | None
    ends: tuple[str, str]  # keys of the lines at both; empty if there are none


@record
class Blocking:
    """All contours of a project."""

    pairs: tuple[PairContour, ...]
    remarks: tuple[str, ...]  # pairs that have none
