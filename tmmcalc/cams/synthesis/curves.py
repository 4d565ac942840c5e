"""The axis of the cam on a curve of the rocker's plane: where one size more is prescribed.

    psi0          a ray from the pivot            o = x e^(-i psi0)
    l0/l2 = q     a circle about the pivot        o = q e^(-i x)
    R0/l2 = k     a circle about the roller       o = 1 + k e^(-i x)
    R0/l0 = k     a circle of Apollonius          o = 1/(1 + k e^(i x)),   |o - 1| = k |o|

A curve meets the region in intervals of x. They are looked for on a grid, which is drawn together where no point of it
is inside; their ends are then exact.
"""

from __future__ import annotations

from collections.abc import Callable
from math import pi

import numpy as np

from tmmcalc.cams.follower import Complex
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.synthesis.halfplanes import Family, Lines, lines_at, outside, sampled
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.numerics.roots import bracketed
from tmmcalc.core.records import record

GRID = 721
EXCHANGES = 30
FINER = 41
ZOOMS = 12
TOUCH = 1e-12  # a curve that comes this near to the region touches it

Over = Callable[[Complex], Values]


@record
class Curve:
    """Points o(x), x from low to high."""

    name: str
    at: Callable[[Values], Complex]
    low: float
    high: float
    inner: tuple[float, ...] = ()  # places inside where what is to be least may be so


def ray(angle: float) -> Curve:
    """psi0 is given; x = |o|, and the base circle is least where the centres stand at cos(psi0)."""
    inner = (float(np.cos(angle)),) if np.cos(angle) > 0 else ()

    def at(x: Values) -> Complex:
        return np.asarray(x / (1 - x) * np.exp(-1j * angle))

    return Curve("start_angle", at, 1e-6, 1 - 1e-6, tuple(q / (1 + q) for q in inner))


def about_pivot(q: float) -> Curve:
    """l0/l2 is given."""
    return Curve("centre_distance", lambda x: np.asarray(q * np.exp(-1j * x)), 0.0, pi)


def about_roller(k: float) -> Curve:
    """R0/l2 is given."""
    return Curve("base_radius", lambda x: np.asarray(1 + k * np.exp(-1j * x)), 0.0, pi)


def about_centres(k: float) -> Curve:
    """R0/l0 is given."""
    return Curve("base_radius", lambda x: np.asarray(1 / (1 + k * np.exp(1j * x))), 1e-9, pi - 1e-9)


def best_on(
    every: tuple[Family, ...], curve: Curve, value: Callable[[complex], float], also: Over | None = None
) -> complex:
    """The point of the curve within the region where ``value`` is least; ``also`` is not above zero there.

    Raises `NoSolutionError` if the curve does not meet the region.
    """
    lines = sampled(every)
    for _ in range(EXCHANGES):
        x, far = _grid(lines, curve, also)
        runs = _runs(far)
        deepest = [int(run[np.argmin(far[run])]) for run in runs] or [int(np.argmin(far))]
        points = curve.at(x[deepest])
        if np.min(far) > TOUCH * (1 + abs(points[0])):
            raise _none(curve)
        checked = [outside(every, complex(point)) for point in points]
        if all(over <= TOUCH * (1 + abs(point)) for (over, _), point in zip(checked, points, strict=True)):
            break
        lines = lines.joined(*(lines_at(every, places) for over, places in checked if over > 0))
    else:
        raise _none(curve)

    def exact(at: Values, which: Indices) -> Values:
        over = np.array([outside(every, complex(point))[0] for point in curve.at(at)])
        return over if also is None else np.maximum(over, also(curve.at(at)))

    inside = [run for run, (over, _) in zip(runs, checked, strict=False) if over < 0]
    lowest = [k for k, (over, _) in zip(deepest, checked, strict=True) if over < 0]
    outer = [max(run[0] - 1, 0) for run in inside] + [min(run[-1] + 1, len(x) - 1) for run in inside]
    ends = bracketed(exact, x[outer], x[[*lowest, *lowest]]) if inside else np.empty(0)
    inner = [q for q in curve.inner if exact(np.array([q]), np.zeros(1, dtype=np.intp))[0] <= 0]
    found = np.concatenate((points, curve.at(np.array([*ends.tolist(), *inner]))))
    return min(found.tolist(), key=value)


def _none(curve: Curve) -> NoSolutionError:
    return NoSolutionError(
        f"no place of the cam's axis keeps the pressure angle with this {curve.name}",
        where="cam_synthesis",
        remedy=f"leave {curve.name} out to see the best one, or allow a larger pressure_angle",
    )


def _runs(far: Values) -> list[Indices]:
    """Numbers of neighbouring places that are inside."""
    inside = np.flatnonzero(far <= 0)
    return [run for run in np.split(inside, np.flatnonzero(np.diff(inside) > 1) + 1) if len(run)]


def _grid(lines: Lines, curve: Curve, also: Over | None) -> tuple[Values, Values]:
    """x and how far outside, drawn together about the best place until one is inside."""

    def over(x: Values) -> Values:
        points = curve.at(x)
        far = np.asarray(np.max(lines.over(points), axis=-1))
        return far if also is None else np.maximum(far, also(points))

    x = np.linspace(curve.low, curve.high, GRID)
    far = over(x)
    for _ in range(ZOOMS):
        k = int(np.argmin(far))
        if far[k] <= 0:
            break
        finer = np.linspace(x[max(k - 1, 0)], x[min(k + 1, len(x) - 1)], FINER)[1:-1]
        order = np.argsort(np.concatenate((x, finer)), kind="stable")
        x, far = np.concatenate((x, finer))[order], np.concatenate((far, over(finer)))[order]
        fresh = np.concatenate(([True], np.diff(x) > 0))
        x, far = x[fresh], far[fresh]
    return x, far
