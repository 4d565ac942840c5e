"""What the stage ``cam_optimum`` leaves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import inf

import numpy as np

from tmmcalc.cams.forces.formulas import Mask
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.rounding import Errors
from tmmcalc.core.notes import Said
from tmmcalc.core.quantity import derived, quantity
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
    10: "pressure angle",
    11: "room at the pivot",
}


# what stands for the places in keys of sizes: a rocker has the distance of the centres for the height of a guide
STEM = {"height": "H2", "start": "S0", "length": "l"}
ROCKER = {"height": "l0", "start": "R0", "length": "l2"}


def sized(kind: str) -> dict[str, str]:
    """The names of the sizes of a kind of follower."""
    return ROCKER if kind == "oscillating" else STEM


@record
class Check:
    """One constraint at one choice of sizes."""

    number: int = quantity("constraint", "number of the constraint in table 5.5")
    name: str = quantity("name", "name of the constraint")
    symbol: str  # of the value
    value: float | None = quantity("{symbol}[{unit}]", "value that is judged")  # None: not judged, for want of data
    relation: str = quantity("relation", "<= or >=")
    limit: float | None = quantity("limit[{unit}]", "its limit")  # None: nothing limits it
    unit: str
    margin: float = quantity("margin", "relative margin; 0 at the limit")

    @derived("judged", "there are data by which it is judged")
    def judged(self) -> bool:
        """Whether there were data."""
        return self.value is not None


@record
class Choice:
    """Sizes and how they keep the constraints."""

    start: float = quantity("{start}_{kind}[m]", "start distance S0; of a rocker the base circle R0: {kind}")
    roller: float = quantity("r2_{kind}[m]", "radius of the roller: {kind}", symbol="r_2")
    height: float = quantity(
        "{height}_{kind}[m]", "height H2 of the mechanism; of a rocker the distance l0 of the centres: {kind}"
    )
    length: float = quantity("{length}_{kind}[m]", "length l of the guide; of a rocker its own length l2: {kind}")
    checks: tuple[Check, ...]

    @derived("active", "numbers of the constraints that are just met")
    def active(self) -> tuple[int, ...]:
        """By table 5.5."""
        return tuple(each.number for each in self._sized if abs(each.margin) < ACTIVE)

    @derived("least_margin", "least margin of the constraints")
    def least_margin(self) -> float:
        """Of those that depend on the sizes."""
        return self.worst.margin

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
class Level:
    """A height that was tried; of a rocker a distance of the centres."""

    height: float = quantity("{height}[m]", "height that was tried; of a rocker the distance of the centres")
    points: int = quantity("points", "points S0, r2 that it suits; of a rocker l2, R0 that the pressure angle leaves")
    judged: int = quantity("judged", "how many are judged by all constraints; of a rocker with every radius r2")
    kept: int = quantity("kept", "how many of these keep all constraints")
    margin: float | None = quantity("least_margin", "least margin of the constraints at the best of them", default=None)
    number: int | None = quantity("constraint", "number of the constraint of this margin", default=None)


def level(height: float, points: int, numbers: Sequence[int], margin: Values, good: Mask) -> Level:
    """The margins (k, n) of constraints of these numbers at a height; ``good`` are the points that keep all."""
    least = np.min(margin, axis=0)
    best = int(np.argmax(least))
    worst = numbers[int(np.argmin(margin[:, best]))]
    return Level(height, points, margin.shape[1], int(np.count_nonzero(good)), float(least[best]), worst)


def merged(levels: Sequence[Level], height: float) -> tuple[Level, ...]:
    """The levels up to a height, ascending, those of one height together."""
    found: dict[float, Level] = {}
    for each in levels:
        if each.height > height:
            continue
        other = found.get(each.height)
        if other is not None:
            best = max(each, other, key=lambda one: -inf if one.margin is None else one.margin)
            counts = {key: getattr(each, key) + getattr(other, key) for key in ("points", "judged", "kept")}
            each = replace(best, **counts)
        found[each.height] = each
    return tuple(found[key] for key in sorted(found))


@record
class Relaxation:
    """What a looser limit of an active constraint buys."""

    number: int = quantity("constraint", "number of the constraint in table 5.5")
    key: str = quantity("key", "what is changed, as in the spec")
    unit: str
    before: float = quantity("from[{unit}]", "limit before")
    after: float = quantity("to[{unit}]", "limit after")
    preferred: bool  # to the next preferred number, else by 1 %
    height: float = quantity("{height}[m]", "least height of the mechanism then, of a rocker distance of the centres")
    gain: float = quantity("gain[m]", "by how much that falls")


@record
class Option:
    """One mechanism of the design game; lengths 0 where it has no solution."""

    changes: tuple[str, ...] = quantity("option", 'changes against what is asked, as "law sine"; none: that itself')
    law: str = quantity("law", "law of rise and return; both names where they differ")
    safety: float | None = quantity("K1", "safety of the contact by which the spring is sized")  # None: it is not
    allowed: float | None = quantity("contact[Pa]", "allowed contact stress", symbol="[sigma_H]")
    ratio: float | None = quantity("roller_ratio", "radius of the roller over that of its pin", symbol="alpha_0")
    height: float = quantity(
        "{height}[m]", "least height of the mechanism in whole steps, of a rocker distance of the centres"
    )
    start: float = quantity("{start}[m]", "start distance; of a rocker the base circle")
    roller: float = quantity("r2[m]", "radius of the roller", symbol="r_2")
    least: float = quantity(
        "{height}_least[m]", "least height of the mechanism of any sizes, of a rocker distance of the centres"
    )
    active: tuple[int, ...] = quantity("active", "numbers of the constraints that are just met there")
    stress: float = quantity("sigma_H[Pa]", "largest contact stress at the step point")
    contact: float = quantity("R_max[N]", "largest force of the cam")
    torque: float = quantity("T_max[N*m]", "largest torque on the camshaft, without friction")
    driving: float = quantity("M_drive_max[N*m]", "largest driving torque, with friction", header="M_drive[N*m]")
    stiffness: float = quantity("c[{rate}]", "stiffness of the spring")
    preload: float = quantity("{spring}0[{force}]", "preload of the spring")
    refused: str = quantity("refused", "why there is no solution; empty if there is")
    length: float | None = quantity("l2[m]", "length of the rocker", symbol="l_2", default=None)  # None: a stem

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

    least_start: float = quantity("S0_min[m]", "least start distance by convexity")
    convexity: float = quantity("F_min[m]", "least dS + S''")
    phi: float  # [rad] where it stands
    least_length: float = quantity("l_min[m]", "least length of the guide by its pressure", symbol="l^*")
    length_phi: float  # [rad] where the pressure is largest then
    least_height: float = quantity("H2_min[m]", "least height of the mechanism")
    stroke: float  # h [m]
    gap: float  # [m]


@record
class Corner:
    """Where two constraints bind."""

    start: float = quantity("{start}[m]", "start distance; of a rocker the base circle")
    roller: float = quantity("r2[m]", "radius of the roller", symbol="r_2")
    numbers: tuple[int, int] = quantity("constraints", "constraints before and after the corner along the border")

    @property
    def turned(self) -> Corner:
        """The same, run through the other way."""
        return Corner(self.start, self.roller, self.numbers[::-1])


@record
class Outline:
    """A closed border of the region, counter-clockwise; the last point is the first."""

    start: Values = quantity("{start}[m]", "start distance; of a rocker the base circle")  # (n,)
    roller: Values = quantity("r2[m]", "radius of the roller", symbol="r_2")  # (n,)
    edge: Indices = quantity(  # (n - 1,)
        "constraint", "number of the constraint from a point to the next; 0: border of the plane"
    )
    corners: tuple[Corner, ...]
    area: float = quantity("area[m^2]", "area of the region; negative: a hole")


@record
class Curve:
    """A stretch of the line on which one constraint is just met."""

    number: int = quantity("constraint", "number of the constraint")
    start: Values = quantity("{start}[m]", "start distance; of a rocker the base circle")  # (n,)
    roller: Values = quantity("r2[m]", "radius of the roller", symbol="r_2")  # (n,)


@record
class Contour:
    """The region at one height; no outlines if it is empty."""

    height: float = quantity("{height}[m]", "height of the mechanism; of a rocker distance of the centres")
    outlines: tuple[Outline, ...]
    curves: tuple[Curve, ...]
    window: tuple[float, float, float, float]  # S0 from, to, r2 from, to [m]

    @derived("area[m^2]", "area of the region")
    def area(self) -> float:
        """Of all its parts, less the holes."""
        return sum(outline.area for outline in self.outlines)


@record
class CamOptimum:
    """Stage ``cam_optimum``: the lowest mechanism, and what keeps it from being lower."""

    kind: str  # of the follower
    phases: str = quantity("phases", "turn or rise: what was examined")
    step: float  # of S0 and r2 [m]
    height_step: float  # of H2 [m]
    stiffness: float = quantity("c[{rate}]", "stiffness of the spring")
    preload: float = quantity("{spring}0[{force}]", "preload of the spring")
    safety: float | None  # what the spring reaches of K1; None: nothing lifts off
    offset: float | None = quantity("e[m]", "offset of all the mechanisms, in the user's sense")  # None: a flat face
    theta: tuple[float, float] | None  # largest |theta| on rise and return at the chosen sizes [rad]
    chosen: Choice  # in whole steps
    # (n,) of all feasible step points at its height, the best first
    start: Values = quantity("{start}[m]", "start distance; of a rocker the base circle")
    roller: Values = quantity("r2[m]", "radius of the roller", symbol="r_2")
    margin: Values = quantity("least_margin", "least margin of the constraints")
    examined: int = quantity("examined", "step points that were looked at")
    excluded: int = quantity("excluded", "how many of them no height suits")
    passed: tuple[tuple[int, int], ...]  # constraint, how many step points it alone leaves
    course: tuple[Level, ...]  # the heights that were tried, ascending; the last is the least
    least: Choice  # of any sizes
    asked: float | None  # H2 of the spec [m]
    contours: tuple[Contour, ...]  # of the spec's height, and of the least in steps
    relaxations: tuple[Relaxation, ...]
    options: tuple[Option, ...]  # of the design game, the first is what is asked; empty: no other was named
    section: Section | None
    flat: FlatChart | None
    notes: tuple[Said, ...]
    error: Errors  # estimates: of the margins, and of the least H2 relative to it
    # where what is asked has no solution, all but ``options`` is of the lowest of them
    refused: str = quantity("refused", "why what is asked has no solution", default="")
    shown: tuple[str, ...] = quantity("option_shown", "the changes of the option that is shown", default=())
    # (n,) of the step points; None: a stem
    length: Values | None = quantity("l2[m]", "length of the rocker", symbol="l_2", default=None)

    @property
    def names(self) -> dict[str, str]:
        """What stands for the places in keys of sizes."""
        return sized(self.kind)

    @derived("left_by", "how many step points each constraint alone leaves")
    def left_by(self) -> dict[str, int]:
        """By the number of the constraint."""
        return {str(number): count for number, count in self.passed}

    @derived("theta_rise[rad]", "largest |theta| on the rise")
    def theta_rise(self) -> float | None:
        """At the chosen sizes; None: a flat face."""
        return None if self.theta is None else self.theta[0]

    @derived("theta_return[rad]", "largest |theta| on the return")
    def theta_return(self) -> float | None:
        """At the chosen sizes; None: a flat face."""
        return None if self.theta is None else self.theta[1]
