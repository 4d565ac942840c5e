"""Why a pair cannot exist, by how much, and the nearest shifts at which it can.

A pair needs a positive involute of its operating angle (centre distance above the base circles), teeth that are not
pointed, no interference, a contact ratio of at least 1, and, where undercut is not tolerated, no undercut.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import pi, tan

import numpy as np
from numpy.typing import NDArray

from tmmcalc.errors import NoSolutionError
from tmmcalc.gears.involute.contour.form import form_of
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.pair import Pair, pair_at, pair_of_shifts, sum_of_shifts
from tmmcalc.gears.involute.profile.form import junction
from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.quality.verdicts import QualityLimits, checks
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.model import Values
from tmmcalc.records import record

WHERE = "involute pair"
REACH = 3.0  # how far from the given shifts the nearest admissible ones are sought
STEPS = 60  # along a ray
RAYS = 72  # directions in the plane (x1, x2)
ZOOMS = 7  # looks between the neighbours of the best ray: its direction ends within 1e-5 rad
PARTS = np.arange(1, 25) / 24  # of the step in which a ray enters
PASSES = 5  # the entry ends within 1e-8
INWARD = 1e-9  # the shifts found are moved so far inward, beyond the error of the polynomial

Form = Callable[[Values], Values]
Margin = Callable[[Values, Values], Values]  # over x1 and x2 (n,)


@record
class Nearest:
    """The nearest admissible shifts, and how far they are."""

    shifts: tuple[float, float]  # x1, x2
    distance: float  # in the plane (x1, x2)


def least_sum(first: Wheel, second: Wheel) -> float:
    """x1 + x2 at which the operating angle vanishes; the sum has to be greater.

    >>> round(least_sum(Wheel(14), Wheel(17)), 5)
    -0.63472
    """
    total = first.teeth + second.teeth
    return -total * float(involute(first.section.angle)) / (2 * tan(first.rack.angle))


def least_margin(
    first: Wheel,
    second: Wheel,
    x1: Values,
    x2: Values,
    limits: QualityLimits,
    fillet: Shape = "ellipse",
    forms: tuple[Form, Form] | None = None,
) -> Values:
    """The least margin at shifts (n,), -inf where there is no pair; a pair exists where it is not negative.

    Where it is negative it may leave out the ends of the involutes. ``forms`` are their curvatures over the shifts,
    as `form_over_shifts` gives them; None: each is found exactly.
    """
    bottom = deepest(first), deepest(second)
    whole = (x1 > bottom[0]) & (x2 > bottom[1])
    x1, x2 = np.maximum(x1, bottom[0]), np.maximum(x2, bottom[1])
    pair = pair_of_shifts(replace(first, shift=x1), replace(second, shift=x2))
    rows = [*pair.starts, pair.contact_ratio - limits.contact_ratio, pair.angle]
    for wheel, tip in zip(pair.wheels, pair.tips, strict=True):
        rows += [tip - wheel.base, wheel.thickness_at(tip) - limits.tip_thickness]
        if not limits.undercut:
            rows.append(wheel.shift - wheel.least_shift)
    least: Values = np.min(np.array(np.broadcast_arrays(*rows)), axis=0)
    least = np.where(np.isnan(least) | ~whole, -np.inf, least)
    # where the involutes end takes longest to find, and only lowers the margins above
    left = np.flatnonzero(least >= 0)
    if left.size:
        if forms is None:
            ends = _form(first, x1[left], fillet), _form(second, x2[left], fillet)
        else:
            ends = forms[0](x1[left]), forms[1](x2[left])
        starts = np.asarray(pair.starts)[:, left]
        used = np.asarray(pair.length)[left] - np.maximum(starts, ends).sum(axis=0)
        rest = np.min(starts - ends, axis=0), used / first.base_pitch - limits.contact_ratio
        least[left] = np.minimum(least[left], np.minimum(*rest))
    return least


def _form(wheel: Wheel, shift: Values, fillet: Shape) -> Values:
    return np.asarray(junction(replace(wheel, shift=shift), fillet).curvature_radius)


def form_over_shifts(wheel: Wheel, fillet: Shape = "ellipse") -> Form:
    """rho_F as a function of the shift, exact to about 1e-12."""
    form = form_of(wheel, max(deepest(wheel), wheel.least_shift - 2 * REACH), fillet)
    return lambda shift: form(shift)[0]


def deepest(wheel: Wheel) -> float:
    """The shift at which the root circle has all but shrunk to the centre."""
    return 1e-3 - float(replace(wheel, shift=0.0).root)


def nearest_shifts(
    first: Wheel,
    second: Wheel,
    limits: QualityLimits | None = None,
    direction: float | None = None,
    fillet: Shape = "ellipse",
) -> Nearest | None:
    """The nearest shifts at which the pair exists; None if there are none within 3 of the given ones.

    ``direction`` [rad] in the plane (x1, x2) confines the search to one line through the given shifts: 0 changes x1
    only, pi/2 changes x2 only, -pi/4 keeps the centre distance.

    >>> nearest = nearest_shifts(Wheel(14, 0.6), Wheel(17, 0.5))
    >>> nearest.distance
    0.0
    """
    chosen = limits or QualityLimits()
    forms = form_over_shifts(first, fillet), form_over_shifts(second, fillet)

    def least(x1: Values, x2: Values) -> Values:
        return least_margin(first, second, x1, x2, chosen, fillet, forms)

    return nearest_admitted(least, (float(first.shift), float(second.shift)), direction)


def nearest_admitted(least: Margin, start: tuple[float, float], direction: float | None = None) -> Nearest | None:
    """The point nearest to ``start`` where a margin over the shifts (n,) is not negative; None: none within 3."""

    def admitted(angle: Values, t: Values) -> NDArray[np.bool_]:
        x1, x2 = start[0] + t * np.cos(angle), start[1] + t * np.sin(angle)
        return least(x1.ravel(), x2.ravel()).reshape(x1.shape) >= 0

    if direction is not None:
        angles = np.array([direction, direction + pi])
        lengths = _entries(admitted, angles)
    else:
        angles = np.arange(RAYS) * (2 * pi / RAYS)
        lengths = _entries(admitted, angles)
        for zoom in range(ZOOMS):
            middle, width = angles[np.argmin(lengths)], 2 * pi / RAYS / 5**zoom
            angles = middle + width * np.linspace(-1, 1, 11)
            lengths = _entries(admitted, angles)
    at, angle = float(np.min(lengths)), float(angles[np.argmin(lengths)])
    if not np.isfinite(at):
        return None
    at += INWARD if at else 0.0
    x1, x2 = start[0] + at * float(np.cos(angle)), start[1] + at * float(np.sin(angle))
    return Nearest((round(x1, 12) + 0.0, round(x2, 12) + 0.0), at)


def _entries(admitted: Callable[[Values, Values], NDArray[np.bool_]], angles: Values) -> Values:
    """How far along each ray (k,) the first admissible point lies; inf: there is none."""
    steps = np.linspace(0.0, REACH, STEPS + 1)
    inside = admitted(angles[:, None], np.broadcast_to(steps, (len(angles), len(steps))))
    index, hit = np.argmax(inside, axis=1), inside.any(axis=1)
    lengths = np.where(hit, steps[index], np.inf)
    # only rays that may hold the nearest point are worth refining
    near = np.flatnonzero((index > 0) & (lengths <= np.min(lengths) + steps[1]))
    low, width = lengths[near] - steps[1], steps[1]
    for _ in range(PASSES if near.size else 0):
        trial = low[:, None] + width * PARTS
        inside = admitted(angles[near, None], trial)
        inside[:, -1] = True  # the end was found admissible before
        lengths[near] = trial[np.arange(near.size), np.argmax(inside, axis=1)]
        width = width * PARTS[0]
        low = lengths[near] - width
    return lengths


def require_pair(pair: Pair, limits: QualityLimits | None = None, fillet: Shape = "ellipse") -> None:
    """Raise `NoSolutionError` if a pair (scalar shifts) cannot exist, with every reason, its margin and the remedy."""
    chosen = limits or QualityLimits()
    broken = [check for check in checks(pair, chosen, fillet=fillet) if check.verdict == "fail"]
    if not broken:
        return
    least = min(broken, key=lambda check: check.margin)
    raise NoSolutionError(
        "; ".join(f"{check.text} (margin {check.margin:.4g})" for check in broken),
        where=WHERE,
        value=least.value,
        limit=least.limit,
        remedy=_remedy(pair.first, pair.second, chosen, fillet),
    )


def pair_from_shifts(first: Wheel, second: Wheel) -> Pair:
    """The pair of two wheels with scalar shifts; raises `NoSolutionError` if the sum of the shifts is too small.

    >>> round(float(pair_from_shifts(Wheel(14, 0.6), Wheel(17, 0.522)).distance), 6)
    16.441028
    """
    total, least = float(first.shift + second.shift), least_sum(first, second)
    if total > least:
        return pair_of_shifts(first, second)
    raise NoSolutionError(
        f"the involute of the operating pressure angle is not positive: x1 + x2 = {total:.6g}, "
        f"it has to exceed {least:.6g} (margin {total - least:.4g})",
        where=WHERE,
        value=total,
        limit=least,
        remedy=_remedy(first, second, QualityLimits(), "ellipse"),
    )


def pair_from_distance(first: Wheel, second: Wheel, distance: float, first_shift: float) -> Pair:
    """The pair with a given centre distance and x1, in normal modules; the shifts of both wheels are not read.

    Raises `NoSolutionError` if the distance does not exceed the sum of the base radii.

    >>> from math import radians
    >>> pair = pair_from_distance(Wheel(14, 0.0, radians(15)), Wheel(17, 0.0, radians(15)), 17.0, 0.6)
    >>> round(float(pair.second.shift), 6)
    0.522194
    """
    least = first.base + second.base
    if distance > least:
        total, angle = sum_of_shifts(first, second, distance)
        return pair_at(
            replace(first, shift=first_shift),
            replace(second, shift=float(total) - first_shift),
            float(angle),
            float(distance),
        )
    raise NoSolutionError(
        f"the centre distance of {distance:.6g} modules does not exceed the sum of the base radii, "
        f"{least:.6g} (margin {distance - least:.4g})",
        where=WHERE,
        value=distance,
        limit=least,
        remedy=f"a centre distance above {least:.6g} modules, near {first.reference + second.reference:.6g}; "
        "other numbers of teeth or another helix angle",
    )


def _remedy(first: Wheel, second: Wheel, limits: QualityLimits, fillet: Shape) -> str:
    forms = form_over_shifts(first, fillet), form_over_shifts(second, fillet)

    def fast(x1: Values, x2: Values) -> Values:
        return least_margin(first, second, x1, x2, limits, fillet, forms)

    def exact(x1: Values, x2: Values) -> Values:
        return least_margin(first, second, x1, x2, limits, fillet)

    told = told_nearest(fast, exact, (float(first.shift), float(second.shift)))
    return told or f"no shifts within {REACH:g} make this pair possible: other numbers of teeth or lower limits"


def told_nearest(fast: Margin, exact: Margin, start: tuple[float, float]) -> str:
    """The shifts nearest to ``start`` in the plane and along its main lines, in words; empty if there are none.

    Both margins are the same, the first to about 1e-9.
    """
    parts = []
    for direction, text in ((None, ""), (0.0, "x1 alone: "), (pi / 2, "x2 alone: "), (-pi / 4, "at this x1 + x2: ")):
        along = nearest_admitted(fast, start, direction)
        if direction is None and along is None:
            return ""
        if along is not None:
            x1, x2 = _rounded(exact, start, along)
            parts.append(f"{text}x1 = {x1:.6g}, x2 = {x2:.6g}")
    return "the nearest admissible shifts are " + "; ".join(parts)


def _rounded(least: Margin, at: tuple[float, float], nearest: Nearest) -> tuple[float, float]:
    """The shifts with four decimals where they change, a little farther along if rounding leads out again."""
    start, end = np.array(at), np.array(nearest.shifts)
    along = end - start
    points = end + np.arange(41)[:, None] / 20000 * along / (nearest.distance or 1.0)
    shifts = np.where(np.abs(along) > 1e-9, np.round(points, 4), start)
    if abs(along.sum()) < 1e-9:
        shifts[:, 1] = start.sum() - shifts[:, 0]
    good = np.flatnonzero(least(shifts[:, 0], shifts[:, 1]) >= 0)
    x1, x2 = shifts[good[0]] if good.size else end
    return float(x1) + 0.0, float(x2) + 0.0
