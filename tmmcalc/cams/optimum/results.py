"""What the stage ``cam_optimum`` leaves."""

from __future__ import annotations

from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.rounding import Errors
from tmmcalc.core.records import record

NAMES = {
    1: "closure of the pair",
    2: "roller without slip",
    3: "no undercut",
    4: "concave parts",
    5: "roller on its pin",
    6: "shaft",
    7: "bending of the stem",
    8: "pressure in the guide",
    9: "contact stress",
}


@record
class Check:
    """One constraint at one choice of sizes."""

    number: int  # of table 5.5
    name: str
    symbol: str  # of the value
    value: float | None  # None: not judged, for want of data
    relation: str  # "<=" or ">="
    limit: float | None  # None: nothing limits it
    unit: str
    margin: float  # relative; 0 at the limit

    @property
    def judged(self) -> bool:
        """Whether there were data."""
        return self.value is not None


@record
class Choice:
    """Sizes and how they keep the constraints."""

    start: float  # S0 [m]
    roller: float  # r2 [m]
    height: float  # H2 [m]
    length: float  # l of the guide [m]
    checks: tuple[Check, ...]

    @property
    def active(self) -> tuple[int, ...]:
        """Numbers of the constraints that are just met."""
        return tuple(each.number for each in self._sized if abs(each.margin) < ACTIVE)

    @property
    def worst(self) -> Check:
        """The constraint of least margin."""
        return min(self._sized, key=lambda each: each.margin)

    @property
    def _sized(self) -> list[Check]:
        """What is judged and depends on the sizes: all but the closure of the pair."""
        return [each for each in self.checks if each.judged and each.number > 1]


ACTIVE = 1e-7  # a margin this small is none


@record
class Relaxation:
    """What a looser limit of an active constraint buys."""

    number: int
    key: str  # what is changed, as in the spec
    unit: str
    before: float
    after: float
    preferred: bool  # to the next preferred number, else by 1 %
    height: float  # least H2 then [m]
    gain: float  # by which H2 falls [m]


@record
class Option:
    """One mechanism of the design game; lengths 0 where it has no solution."""

    changes: tuple[str, ...]  # against what is asked, as "law sine"; none: that itself
    law: str  # of rise and return; both names where they differ
    safety: float | None  # K1 by which the spring is sized; None: it is not
    allowed: float | None  # [sigma_H] [Pa]
    ratio: float | None  # alpha0; None: no roller
    height: float  # least H2 in whole steps [m]
    start: float  # S0 [m]
    roller: float  # r2 [m]
    least: float  # least H2 of any sizes [m]
    active: tuple[int, ...]  # there
    stress: float  # largest sigma_H at the step point [Pa]
    contact: float  # largest R [N]
    torque: float  # largest |T| on the camshaft, without friction [N*m]
    driving: float  # largest driving torque, with friction [N*m]
    stiffness: float  # c [N/m]
    preload: float  # Q0 [N]
    refused: str  # why there is no solution; empty if there is

    @property
    def name(self) -> str:
        """The changes in words."""
        return ", ".join(self.changes) or "as asked"


@record
class Section:
    """Along r2 at the chosen S0 and H2 (fig. 5.30)."""

    start: float  # S0 [m]
    height: float  # H2 [m]
    roller: Values  # (m,) [m]
    edge: Values  # largest |N1| (m,) [N]
    stress: Values  # largest sigma_H (m,) [Pa]
    edge_limit: float | None  # [N]
    stress_limit: float | None  # [Pa]


@record
class FlatChart:
    """The chart of a flat-faced follower (fig. 5.37): H2_min = S0_min + h + l*."""

    least_start: float  # S0_min by convexity [m]
    convexity: float  # F_min = min (dS + S'') [m]
    phi: float  # [rad] where it stands
    least_length: float  # l* of the guide by its pressure [m]
    length_phi: float  # [rad] where the pressure is largest then
    least_height: float  # H2_min [m]
    stroke: float  # h [m]
    gap: float  # [m]


@record
class Corner:
    """Where two constraints bind."""

    start: float  # S0 [m]
    roller: float  # r2 [m]
    numbers: tuple[int, int]  # before it and after it along the border

    @property
    def turned(self) -> Corner:
        """The same, run through the other way."""
        return Corner(self.start, self.roller, self.numbers[::-1])


@record
class Outline:
    """A closed border of the region, counter-clockwise; the last point is the first."""

    start: Values  # (n,) [m]
    roller: Values  # (n,) [m]
    edge: Indices  # (n - 1,) number of the constraint from a point to the next; 0: border of the plane
    corners: tuple[Corner, ...]
    area: float  # [m^2]; negative: a hole


@record
class Curve:
    """A stretch of the line on which one constraint is just met."""

    number: int
    start: Values  # (n,) [m]
    roller: Values  # (n,) [m]


@record
class Contour:
    """The region at one height; no outlines if it is empty."""

    height: float  # H2 [m]
    outlines: tuple[Outline, ...]
    curves: tuple[Curve, ...]
    window: tuple[float, float, float, float]  # S0 from, to, r2 from, to [m]

    @property
    def area(self) -> float:
        """Of the region [m^2]."""
        return sum(outline.area for outline in self.outlines)


@record
class CamOptimum:
    """Stage ``cam_optimum``: the lowest mechanism, and what keeps it from being lower."""

    kind: str  # of the follower
    phases: str  # "turn" or "rise": what was examined
    step: float  # of S0 and r2 [m]
    height_step: float  # of H2 [m]
    stiffness: float  # of the spring c [N/m]
    preload: float  # Q0 [N]
    safety: float | None  # what the spring reaches of K1; None: nothing lifts off
    offset: float | None  # e [m], in the user's sense: of all the mechanisms here; None: a flat face
    theta: tuple[float, float] | None  # largest |theta| on rise and return at the chosen sizes [rad]
    chosen: Choice  # in whole steps
    start: Values  # S0 (n,) [m] of all feasible step points at its height, the best first
    roller: Values  # r2 (n,) [m]
    margin: Values  # least margin (n,)
    examined: int  # step points that were looked at
    excluded: int  # of those, how many no height suits
    passed: tuple[tuple[int, int], ...]  # constraint, how many step points it alone leaves
    least: Choice  # of any sizes
    asked: float | None  # H2 of the spec [m]
    contours: tuple[Contour, ...]  # of the spec's height, and of the least in steps
    relaxations: tuple[Relaxation, ...]
    options: tuple[Option, ...]  # of the design game, the first is what is asked; empty: no other was named
    section: Section | None
    flat: FlatChart | None
    notes: tuple[str, ...]
    error: Errors  # estimates: of the margins, and of the least H2 relative to it
    refused: str = ""  # why what is asked has no solution: all but ``options`` is then of the lowest of them
    shown: tuple[str, ...] = ()  # the changes of that option
