"""How small and how large coaxial and planetary trains can be: bounds of the search parameter e, limits of K.

In a coaxial train Z1 + Z2 = e mu2 and Z3 -+ Z2' = e mu1 with an integer e (4.12, 4.22). The bounds of e tell why a
task has few solutions or none; the complete search does not depend on them. s = sin(pi/K), and a neighbour keeps
``tips`` = 2 h_a + gap modules from the pitch circles, 3 in the textbook.
"""

from __future__ import annotations

import math
from fractions import Fraction

from tmmcalc.core.errors import UsageError
from tmmcalc.core.records import record
from tmmcalc.gears.model import TrainTask


@record
class Quadratic:
    """e^2 + p e + q = 0 and its positive root."""

    p: float
    q: float
    root: float


@record
class StepBounds:
    """Bounds of e for one proportion of modules."""

    teeth: Quadratic  # all of Z1, Z2' at the least number of teeth (4.18, 4.35)
    neighbours_book: Quadratic | None  # the textbook's estimate (4.36); None: neighbourhood does not bind
    neighbours: Quadratic | None  # the necessary bound
    first: int  # least e that these bounds admit
    largest: float  # (4.37)

    @property
    def compatible(self) -> bool:
        """Whether any e is left; if not, a smaller K or larger wheels are needed."""
        return self.first <= self.largest


@record
class SinglePlanetLimits:
    """Limits of U = Z3/Z1 of a train AIbar by the neighbourhood of its planets (4.33); None: no limit."""

    planets: int  # K
    rational: float | None  # below it the least sun will do
    permissible: float | None  # at and above it the planets overlap whatever the sun


def half_pitch(planets: int) -> float:
    """sin(pi/K), exactly 1/2 for six planets: half the distance of neighbours over the radius of their circle.

    >>> half_pitch(6), half_pitch(2)
    (0.5, 1.0)
    """
    if planets < 2:
        raise UsageError(
            f"{planets} planets have no neighbours", where="planets", value=planets, limit=2, remedy="K > 1"
        )
    return 0.5 if planets == 6 else math.sin(math.pi / planets)


def tips(task: TrainTask) -> Fraction | None:
    """What a neighbour keeps from the pitch circle of a planet, 2 h_a + gap [module]; None if it need not."""
    crowded = task.demands.gap is not None and task.scheme.branched and task.planets > 2
    return 2 * task.addendum + (task.demands.gap or 0) if crowded else None


def step_bounds(task: TrainTask, proportion: tuple[int, int], ratio: Fraction | None = None) -> StepBounds:
    """Bounds of e for a train coaxial, AA or AI (textbook 4.18, 4.35 to 4.37).

    ``ratio`` is the tooth ratio they are taken at: by default the nominal one as in the textbook. The bounds are
    necessary only at the least ratio admitted, U - Delta.
    """
    mu1, mu2 = proportion
    u = float(task.nominal if ratio is None else ratio)
    z, sign = task.limits.least, side(task)
    both = mu1 * mu2
    teeth = _quadratic(z * (sign * mu2 - mu1) / both, -z * z * (u + sign) / both)
    largest = (task.limits.largest_ring if sign > 0 else task.limits.largest) - sign * z
    gap = tips(task)
    if gap is None:
        return StepBounds(teeth, None, None, math.ceil(teeth.root), largest / mu1)
    s, c = half_pitch(task.planets), float(gap)
    book = _quadratic((sign * mu2 * s * z - c * mu1) / (both * s), -z * (u * z + c * sign) / (both * s))
    slope = sign * s * mu2 * z - c * mu1 - u * (1 - s) * mu2 * z
    exact = _quadratic(slope / (s * both), -c * z * (u + sign) / (s * both))
    # with a sun below its least number of teeth the bound by neighbours rests on a train that is not admitted
    binds = exact.root * mu2 * (1 - s) + c >= z
    first = math.ceil(max(teeth.root, exact.root) if binds else teeth.root)
    return StepBounds(teeth, book, exact, first, largest / mu1)


def side(task: TrainTask) -> int:
    """Sign of Z2' in Z3 = e mu1 +- Z2': +1 for an internal second mesh (AI), -1 for an external one (AA, coaxial)."""
    if not task.scheme.stepped:
        raise UsageError(
            f"layout {task.layout!r} has no parameter e", where="stepping", remedy="layouts: coaxial, AA, AI"
        )
    return 1 if task.scheme.rings else -1


def single_planet_limits(planets: int, *, sun: int = 17, tips: float = 3.0) -> SinglePlanetLimits:
    """Rational and permissible U of a train AIbar with K planets, ``sun`` the least one (textbook 4.33, table 4.7).

    >>> limits = single_planet_limits(3)
    >>> round(limits.rational, 4), round(limits.permissible, 4)
    (11.2938, 13.9282)
    """
    s = 1.0 if planets < 3 else half_pitch(planets)
    if s == 1.0:
        return SinglePlanetLimits(planets, None, None)
    return SinglePlanetLimits(planets, (1 + s - 2 * tips / sun) / (1 - s), (1 + s) / (1 - s))


def most_planets(ratio: float) -> int:
    """The largest K that the neighbourhood admits in a train AIbar of ratio U = Z3/Z1, at least 2 (textbook 4.33).

    >>> most_planets(6.29), most_planets(3.0), most_planets(15)
    (3, 5, 2)
    """
    if not 1 < ratio < math.inf:
        raise UsageError("the ring is larger than the sun", where="AIbar", value=ratio, limit=1.0, remedy="U > 1")
    planets = max(int(math.pi / math.asin((ratio - 1) / (ratio + 1))) - 1, 2)
    while ratio < (single_planet_limits(planets + 1).permissible or math.inf):
        planets += 1
    return planets


def _quadratic(p: float, q: float) -> Quadratic:
    root = math.sqrt(p * p / 4 - q)
    # of the two forms of the root the one without cancellation
    return Quadratic(p, q, root - p / 2 if p <= 0 else -q / (p / 2 + root))
