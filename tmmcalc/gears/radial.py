"""The planetary train 2A-(AA with bar) before rounding: tooth numbers as real numbers, and the limits of its ratio.

Sun 1 drives, planets 2 and 3 mesh with each other on the carrier, sun 4 stands still; all three meshes are external
and the centres of 1, 2 and 3 lie on one ray, 3 outside 2 ("radially far"):

    1 -- 2 -- 3         a_12 + a_23 = a_34          i_1H = 1 + Z4/Z1
    4 -------- 3

Operating pressure angles enter by t1 = cos a_w12/cos a_w23 and t2 = cos a_w12/cos a_w34. Source: Kavetsky and Geresh,
article on this train; its formulas (9) and (11) hold for t2 = 1 only and are replaced here.
"""

from __future__ import annotations

import math

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record
from tmmcalc.gears.bounds import half_pitch

WHERE = "train 2A-AA"
WITHIN = (0.8, 1.2)  # t1 and t2 that are usual


@record
class RadialShape:
    """What the equations leave free: the planets to each other, the mesh angles, the number of assembly."""

    y: float = quantity("y", "Z3/Z2", default=1.0)
    t1: float = quantity("t1", "cos a_w12/cos a_w23", default=1.0)
    t2: float = quantity("t2", "cos a_w12/cos a_w34", default=1.0)
    assembly: int | None = None  # N = (Z1 + Z4)/k; None: the least that gives sun 1 its least teeth
    angles: tuple[float, float, float] | None = None  # [rad] of the meshes 1-2, 2-3, 3-4, if they gave t1 and t2

    @derived("mesh_angles[deg]", "operating pressure angles of the meshes 1-2, 2-3, 3-4, where they gave t1 and t2")
    def degrees(self) -> list[float]:
        """The angles in degrees; none if they are not given."""
        return [math.degrees(angle) for angle in self.angles or ()]


@record
class RadialTeeth:
    """Tooth numbers as real numbers, and how well they close."""

    z1: float = quantity("Z1", "teeth of sun 1")
    z2: float = quantity("Z2", "teeth of the planets 2")
    z3: float = quantity("Z3", "teeth of the planets 3")
    z4: float = quantity("Z4", "teeth of sun 4")
    denominator: float = quantity("denominator", "1 + t1 (1 + y) - y t2", symbol="D")
    residual: float = quantity("coaxial_residual", "residual of the coaxiality equation in teeth", source="(2)")


@record
class RatioLimits:
    """Limits of i_1H by coaxiality and neighbourhood of k pairs of planets, 2/Z1 neglected."""

    coaxial: float = quantity("i_min_coaxial", "i above it: planet 2 has teeth", source="(7)")
    first: float | None = quantity("i_max_neighbour1", "i below it: neighbouring planets 2 clear each other")
    # None of a limit: there is none
    bracket: float = quantity("second_bracket", "B of the condition B i > C of neighbouring planets 3", symbol="B")
    second: float | None = quantity("i_bound_neighbour2", "C/B: i above it if B > 0, below it if B < 0")
    low: float  # i lies above ...
    high: float | None  # ... and below; None: no limit

    @derived("neighbour2_is_upper_bound", "whether the limit by planets 3 is an upper one")
    def second_is_upper(self) -> bool:
        """B is negative."""
        return self.bracket < 0


def angle_ratios(angles: tuple[float, float, float]) -> tuple[float, float]:
    """t1 and t2 of the operating pressure angles [rad] of the meshes 1-2, 2-3, 3-4.

    >>> [round(t, 12) for t in angle_ratios((0.0, math.pi / 3, 0.0))]
    [2.0, 1.0]
    """
    first, between, last = map(math.cos, angles)
    return first / between, first / last


def usual_assembly(ratio: float, planets: int, least: int) -> int:
    """The least N that gives sun 1 ``least`` teeth or more.

    >>> usual_assembly(5, 3, 17)
    29
    """
    return math.ceil(least * ratio / planets - 1e-9)


def real_teeth(
    ratio: float, planets: int, assembly: int, *, y: float = 1.0, t1: float = 1.0, t2: float = 1.0
) -> RadialTeeth:
    """Tooth numbers of ratio i_1H with k pairs of planets, N = ``assembly`` = (Z1 + Z4)/k and y = Z3/Z2 (3)-(5).

    Raises `NoSolutionError` where planet 2 would have no teeth or the train does not close (D <= 0).

    >>> real_teeth(5, 3, 30)
    RadialTeeth(z1=18.0, z2=27.0, z3=27.0, z4=72.0, denominator=2.0, residual=0.0)
    """
    _check(planets, y, t1, t2)
    below = denominator(y, t1, t2)
    if ratio * t2 <= 1 + t2:
        raise NoSolutionError(
            f"i_1H = {ratio:.6g} leaves planet 2 without teeth: it has to exceed {(1 + t2) / t2:.6g}",
            where=WHERE,
            value=ratio,
            limit=(1 + t2) / t2,
            remedy="a larger ratio, or a larger t2",
        )
    z1 = planets * assembly / ratio
    z4 = z1 * (ratio - 1)
    z2 = z1 * (t2 * (ratio - 1) - 1) / below
    z3 = y * z2
    return RadialTeeth(z1, z2, z3, z4, below, z1 + z2 + (z2 + z3) * t1 - (z3 + z4) * t2)


def ratio_limits(planets: int, *, y: float = 1.0, t1: float = 1.0, t2: float = 1.0) -> RatioLimits:
    """Between which ratios i_1H the train exists with k pairs of planets (7), (8), 2/Z1 neglected.

    Neighbourhood is asked of three planets and more. Integer teeth have to pass the unsimplified inequalities all the
    same. Raises `NoSolutionError` where the train does not close.

    >>> limits = ratio_limits(3)
    >>> limits.low, round(limits.high, 6)
    (2.0, 14.928203)
    """
    _check(planets, y, t1, t2)
    denominator(y, t1, t2)
    coaxial = (1 + t2) / t2
    if planets < 3:
        return RatioLimits(coaxial, None, 0.0, None, coaxial, None)
    s = half_pitch(planets)
    first = (t2 + 1 + (t1 - t2) * (1 + y) * s) / (t2 * (1 - s))
    bracket, constant = _second(s, y, t1, t2)
    # D > 0 makes both limits lie above the coaxial one, and C/B below one where B > 0: the range is never empty
    second = constant / bracket if bracket else None
    high = min(first, second) if second is not None and bracket < 0 else first
    return RatioLimits(coaxial, first, bracket, second, coaxial, high)


def _second(s: float, y: float, t1: float, t2: float) -> tuple[float, float]:
    """B and C of the condition B i > C that neighbouring planets 3 clear each other."""
    bracket = s * (1 + t1 * (1 + y)) - y * t2
    return bracket, s * (1 + t1 * (1 + y) + y) - y * (1 + t2)


def denominator(y: float, t1: float, t2: float) -> float:
    """D = 1 + t1 (1 + y) - y t2; raises `NoSolutionError` where it is not positive: the train does not close."""
    found = 1 + t1 * (1 + y) - y * t2
    if found > 0:
        return found
    raise NoSolutionError(
        f"y = Z3/Z2 = {y:.6g} does not close: it has to be below (1 + t1)/(t2 - t1) = {(1 + t1) / (t2 - t1):.6g}",
        where=WHERE,
        value=y,
        limit=(1 + t1) / (t2 - t1),
        remedy="a smaller planet 3, or t1 nearer to t2",
    )


def _check(planets: int, y: float, t1: float, t2: float) -> None:
    if planets < 1 or min(y, t1, t2) <= 0:
        raise UsageError(
            f"k = {planets}, y = {y:g}, t1 = {t1:g}, t2 = {t2:g}",
            where=WHERE,
            remedy="at least one pair of planets, and positive y, t1, t2",
        )
