"""The blocking contours of the pairs of a project; shifts are in normal modules.

Only external pairs have a contour: its conditions are those of two wheels cut by a rack.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.notes import Phrase
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.gears.involute.contour.results import ContourError
from tmmcalc.gears.involute.rack import Rack
from tmmcalc.gears.model import Values


@record
class ContourCorner:
    """A corner."""

    x1: float = quantity("x_1", "profile shift of wheel 1")
    x2: float = quantity("x_2", "profile shift of wheel 2")
    lines: tuple[str, str] = quantity("lines", "keys of the lines that meet in it")


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
    reason: Phrase | str
    pieces: tuple[Outline, ...]  # beyond a pinch point, or apart, mostly with a tip inside its reference circle
    untraced: tuple[int, ...]  # wheels on whose side there are pieces whose outline is not found
    best_contact_ratio: float  # largest that the other conditions leave
    error: ContourError | None = None  # of the main curve; None: there is none


@record
class ContourLine:
    """A line of the picture."""

    # 4, 5, 6, 7, 8, 9, 12, 14, 15, 16
    number: str = quantity("number", "number of the line in the textbook's figures")
    title: str = quantity("title", "what is constant along it")
    value: float = quantity("value", "value that is constant")
    x1: Values = quantity("x_1", "profile shifts of wheel 1")  # (n,)
    x2: Values = quantity("x_2", "profile shifts of wheel 2")  # (n,)


UNBOUNDED = 1e8  # of a specific sliding: what a point on the limit of undercut has that misses it by rounding


@record
class ContourPoint:
    """A point of interest.

    Where a flank would have to begin within its base circle its sliding is 0; where it begins on it, at the limit of
    undercut, sliding grows beyond all bounds, and what is computed of it is rounding.
    """

    name: str  # C, D, E, "balanced", "equal strength", "chosen"
    title: Phrase | str  # what is special about it
    x1: float = quantity("x_1", "profile shift of wheel 1")
    x2: float = quantity("x_2", "profile shift of wheel 2")
    contact_ratio: float = quantity("eps_alpha", "transverse contact ratio")
    tip_thickness: tuple[float, float] = quantity("s_na{wheel}", "normal tip thickness in modules")
    sliding: tuple[float, float] = quantity("theta_{wheel}", "specific sliding, of wheel 1 at A2, of wheel 2 at A1")
    form_factors: tuple[float, float] = quantity("Y_F{wheel}", "form factor with the load at the tip")
    distance: float = quantity("a_w[m]", "operating centre distance")
    strict: bool = quantity("in_strict", "whether the strict contour holds it")
    tolerated: bool = quantity("in_tolerated", "whether the tolerated contour holds it")


@record
class MissingPoints:
    """Points of interest that do not exist."""

    names: tuple[str, ...]
    reason: Phrase | str

    @property
    def text(self) -> str:
        """Which, and why.

        >>> MissingPoints(("C", "D"), "no shifts give a mesh").text
        'C, D: no shifts give a mesh'
        """
        return Phrase("{names}: {reason}", names=self.names, reason=self.reason)


@record
class PairContour:
    """The contours of one external pair, its lines and points, and where the chosen shifts stand."""

    name: str
    teeth: tuple[int, int]
    module: float  # [m], normal
    helix: float  # beta [rad]
    rack: Rack
    contact_ratio: float = quantity("eps_min", "least contact ratio")
    thickness: float = quantity("s_a_min", "least tip thickness in modules")
    strict: Area
    tolerated: Area
    lines: tuple[ContourLine, ...]
    points: tuple[ContourPoint, ...]  # the chosen one first; what does not exist is left out
    missing: tuple[MissingPoints, ...]
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
