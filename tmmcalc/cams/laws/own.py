"""Laws of the user's own: polynomials, accelerations in a table, splines through points of the displacement.

Each has to begin and end at rest, and is brought to s(1) = 1.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.laws.law import Acceleration, Law, Values, of_acceleration, polynomial
from tmmcalc.core.errors import UsageError

REST = 1e-6  # of the largest s': a law may miss rest at its end by so much, as rounded data do
DEGREE = 5  # of the spline


def of_coefficients(coefficients: list[float], name: str = "polynomial") -> Law:
    """s = c0 + c1 k + c2 k^2 + ..., brought to s(1) = 1.

    Raises `UsageError` if it does not begin at 0 and at rest, or does not end at rest, with the amount.

    >>> of_coefficients([0, 0, 3, -2]).at(np.array([0.5]))[0].tolist()
    [0.5]
    """
    law = polynomial(name, (0.0, coefficients))
    ends = law.at(np.array([0.0, 1.0]))
    if not ends[0, 1] > 0:
        raise _fault(name, f"it ends at s(1) = {ends[0, 1]:.6g}, not above 0", "coefficients that add up to 1")
    law = polynomial(name, (0.0, (np.array(coefficients) / ends[0, 1]).tolist()))
    return _resting(law)


def of_accelerations(k: Values, acceleration: Values, name: str = "acceleration") -> Law:
    """Straight lines between the values of s'' at k, to any scale; a k that stands twice is a jump.

    Raises `UsageError` if the areas above and below zero are not equal within a part of 1e-6, with both areas.
    """
    _check_parts(name, k)
    pieces = []
    for a, b, low, high in zip(k[:-1], k[1:], acceleration[:-1], acceleration[1:], strict=True):
        if b > a:
            pieces.append(Acceleration(float(a), (float(low), float((high - low) / (b - a)))))
    total = float(np.sum(np.diff(k) * (acceleration[1:] + acceleration[:-1]) / 2))
    lift = float(np.sum(_moments(k, acceleration)))
    if abs(total) > REST * float(np.sum(np.diff(k) * np.abs(acceleration[1:] + acceleration[:-1]) / 2)):
        raise _fault(
            name,
            f"its acceleration does not add up to 0: the areas above and below differ by {total:.6g}",
            "equal areas above and below zero, so that it ends at rest",
        )
    if not lift > 0:
        raise _fault(name, "its acceleration gives no lift", "first an acceleration above zero, then below")
    return _resting(of_acceleration(name, *pieces))


def of_points(k: Values, s: Values, name: str = "points") -> Law:
    """A spline of the fifth degree through points (k, s), at rest and without acceleration at both ends.

    Raises `UsageError` for points that do not ascend in k from 0 to 1, or s that does not lead from 0 upwards.
    """
    from scipy.interpolate import PPoly, make_interp_spline

    _check_parts(name, k, strictly=True)
    if s[0] != 0 or not s[-1] > 0:
        raise _fault(name, f"s runs from {s[0]:.6g} to {s[-1]:.6g}", "displacements from 0 to 1, or to the stroke")
    rest = ([(1, 0.0), (2, 0.0)], [(1, 0.0), (2, 0.0)])
    spline = PPoly.from_spline(make_interp_spline(k, s / s[-1], DEGREE, bc_type=rest))
    kept = np.flatnonzero(np.diff(spline.x) > 0)
    still = np.zeros(kept.size)
    breaks = np.append(spline.x[kept], 1.0)
    return Law(name, breaks, np.ascontiguousarray(spline.c[::-1, kept].T), still, still, still)


def _check_parts(name: str, k: Values, strictly: bool = False) -> None:
    steps = np.diff(k)
    if len(k) < 2 or k[0] != 0 or k[-1] != 1 or np.any(steps < 0) or (strictly and np.any(steps == 0)):
        what = "they have to ascend from 0 to 1" + (", each once" if strictly else "")
        raise _fault(name, f"its parts k do not fit: {what}", "k from 0 to 1 in the order of the motion")


def _moments(k: Values, acceleration: Values) -> Values:
    """What each straight piece of s'' adds to s(1): its area times the way that is left, exactly."""
    width, low, high = np.diff(k), acceleration[:-1], acceleration[1:]
    return width * ((1 - k[1:]) * (low + high) / 2 + width * (2 * low + high) / 6)


def _resting(law: Law) -> Law:
    """The law, if it begins and ends at rest."""
    ends = law.at(np.array([0.0, 1.0]), np.array([0, law.count - 1]))
    size = max(1.0, float(np.max(np.abs(law.at(np.linspace(0.0, 1.0, 65))[1]))))
    for place, values in (("begin", ends[:, 0]), ("end", ends[:, 1])):
        wanted = 0.0 if place == "begin" else 1.0
        if abs(values[0] - wanted) > REST or abs(values[1]) > REST * size:
            raise _fault(
                law.name,
                f"at its {place} s = {values[0]:.6g}, s' = {values[1]:.6g}",
                "s(0) = 0, s(1) = 1 and s'(0) = s'(1) = 0: else the follower would be struck",
            )
    return law


def _fault(name: str, what: str, remedy: str) -> UsageError:
    return UsageError(f"the law {name!r} cannot move a follower: {what}", where="law", remedy=remedy)
