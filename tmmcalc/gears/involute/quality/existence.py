"""Why a pair cannot exist, by how much, and the nearest shifts at which it can.

A pair needs a positive involute of its operating angle (centre distance above the base circles), teeth that are not
pointed, no interference, a contact ratio of at least 1, and, where undercut is not tolerated, no undercut.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import tan

import numpy as np

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.gears.involute.contour.side import form_of
from tmmcalc.gears.involute.function import involute
from tmmcalc.gears.involute.pair import Pair, pair_of_shifts
from tmmcalc.gears.involute.profile.form import junction
from tmmcalc.gears.involute.profile.rounding import Shape
from tmmcalc.gears.involute.quality.nearest import REACH, Margin, Nearest, nearest_admitted, told_nearest
from tmmcalc.gears.involute.quality.verdicts import QualityLimits, checks
from tmmcalc.gears.involute.wheel import Wheel
from tmmcalc.gears.model import Values

WHERE = "involute pair"

Form = Callable[[Values], Values]


def least_sum(first: Wheel, second: Wheel) -> float:
    """x1 + x2 at which the operating angle vanishes; the sum has to be greater.

    >>> round(least_sum(Wheel(14), Wheel(17)), 5)
    -0.63472
    """
    total = first.teeth + second.teeth
    return -total * float(involute(first.transverse_angle)) / (2 * tan(first.rack.angle))


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
    fast, _ = margin_of(first, second, limits or QualityLimits(), fillet)
    return nearest_admitted(fast, (float(first.shift), float(second.shift)), direction)


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


def require_least_sum(first: Wheel, second: Wheel) -> None:
    """Raise `NoSolutionError` if the sum of two scalar shifts is too small for a pair without backlash."""
    total, least = float(first.shift + second.shift), least_sum(first, second)
    if total > least:
        return
    raise NoSolutionError(
        f"the involute of the operating pressure angle is not positive: x1 + x2 = {total:.6g}, "
        f"it has to exceed {least:.6g} (margin {total - least:.4g})",
        where=WHERE,
        value=total,
        limit=least,
        remedy=_remedy(first, second, QualityLimits(), "ellipse"),
    )


def margin_of(first: Wheel, second: Wheel, limits: QualityLimits, fillet: Shape) -> tuple[Margin, Margin]:
    """The least margin over x1 and x2 (n,): quickly to about 1e-9, and exactly."""
    forms = form_over_shifts(first, fillet), form_over_shifts(second, fillet)

    def fast(x1: Values, x2: Values) -> Values:
        return least_margin(first, second, x1, x2, limits, fillet, forms)

    def exact(x1: Values, x2: Values) -> Values:
        return least_margin(first, second, x1, x2, limits, fillet)

    return fast, exact


def _remedy(first: Wheel, second: Wheel, limits: QualityLimits, fillet: Shape) -> str:
    fast, exact = margin_of(first, second, limits, fillet)
    told = told_nearest(fast, exact, (float(first.shift), float(second.shift)))
    return told or f"no shifts within {REACH:g} make this pair possible: other numbers of teeth or lower limits"
