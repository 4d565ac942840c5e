"""How far the pitch curve can be offset: the largest roller or tool.

A ball of radius R that touches the curve at p from one side (normal n) holds no other point q of it while

    R <= |q - p|^2 / (2 n (q - p))          for all q with n (q - p) > 0

For q near p the bound is the radius of curvature: the offset gets a cusp. Elsewhere the least bound is at two places
that face each other across a neck, their distance being 2R: the offset touches itself.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.profile.offsets import Frame, Rim
from tmmcalc.cams.profile.results import Place, Reach
from tmmcalc.cams.program import TURN

SLACK = 1.15  # of the radius of curvature: a neck on the samples that may be less in truth
FACING = 1.2  # chord against R of pairs that are no neighbours; 2 at a neck
GRID = np.linspace(-1, 1, 9)
SHRINK = 0.4  # of the grid about a neck, pass by pass
PASSES = 40
POLISH = 6
MOST = 4  # necks that are looked at closely


def reach(rim: Rim, bend: Place | None, side: int) -> Reach | None:
    """The largest offset inwards (side 1) or outwards (-1); None if any is possible.

    ``bend`` is the place of the largest curvature towards that side, None if there is none.
    """
    cusp = None if bend is None else Reach(1 / abs(bend.value), "cusp", (bend.phi,))
    if bend is None and side < 0:
        return None  # a convex curve: no ball outside touches it twice
    limit = np.inf if cusp is None else cusp.distance
    necks = [_neck(rim, side, *pair) for pair in _candidates(rim, side, limit)]
    least = min((neck for neck in necks if neck is not None), key=lambda neck: neck.distance, default=None)
    if least is None or least.distance >= limit * (1 - 1e-12):
        return cusp
    return least


def _candidates(rim: Rim, side: int, limit: float) -> list[tuple[float, float, float]]:
    """Pairs of angles with the spacing of the samples, that may face each other across a neck."""
    on = rim.program.panels
    phi = np.sort(np.concatenate((on.x.ravel(), on.edges[:-1])))
    here = rim.at(phi)
    bound, chord = _bounds(here, here, side)
    least = (bound < SLACK * limit) & (chord > FACING * bound)
    if not least.any():
        return []
    for shift in ((0, 1), (1, 0), (1, 1), (1, -1)):
        least &= bound <= np.roll(bound, shift, (0, 1))
        least &= bound <= np.roll(bound, (-shift[0], -shift[1]), (0, 1))
    i, j = np.nonzero(np.triu(least | least.T))
    order = np.argsort(bound[i, j])[:MOST]
    width = np.diff(phi, append=phi[0] + TURN)
    step = 2 * np.maximum(width, np.roll(width, 1))
    return [
        (float(phi[a]), float(phi[b]), float(max(step[a], step[b]))) for a, b in zip(i[order], j[order], strict=True)
    ]


def _bounds(first: Frame, second: Frame, side: int) -> tuple[Values, Values]:
    """Radii of the balls at p (m,) that reach q (n,), and the chords, (m, n); huge where q lies on the other side."""
    chord = second.points - first.points[:, None]
    normal = side * 1j * first.tangent
    depth = (np.conj(normal)[:, None] * chord).real
    square = chord.real**2 + chord.imag**2
    with np.errstate(divide="ignore", invalid="ignore"):
        bound = np.where(depth > 1e-9 * np.sqrt(square), square / (2 * depth), 1e300)
    return np.where(np.isfinite(bound), bound, 1e300), np.sqrt(square)


def _neck(rim: Rim, side: int, one: float, other: float, step: float) -> Reach | None:
    """The neck near a pair of angles, exact to rounding; None if they slide into one place."""
    for _ in range(PASSES):
        a, b = one + step * GRID, other + step * GRID
        bound, _ = _bounds(rim.at(a), rim.at(b), side)
        i, j = np.unravel_index(int(np.argmin(bound)), bound.shape)
        one, other, step = float(a[i]), float(b[j]), SHRINK * step if 0 < i < 8 and 0 < j < 8 else step
        if step < 1e-9:
            break
    one, other = _polished(rim, one, other)
    ends = rim.at(np.array([one, other]))
    chord = complex(ends.points[1] - ends.points[0])
    facing = abs(abs((np.conj(ends.tangent[0]) * chord).real) / abs(chord)) if chord else 1.0
    if facing > 1e-5 or (np.conj(side * 1j * ends.tangent[0]) * chord).real <= 0:
        return None
    at = tuple(sorted((one % TURN, other % TURN)))
    return Reach(abs(chord) / 2, "neck", at)


def _polished(rim: Rim, one: float, other: float) -> tuple[float, float]:
    """Newton on the chord being square to both tangents; kept only while it closes in."""
    size = np.inf
    now = best = (one, other)
    for _ in range(POLISH):
        ends = rim.at(np.array(now))
        (p, q), (t, u), (v, w) = ends.points, ends.tangent, ends.speed
        (k, m) = ends.bend
        chord = q - p
        rest = np.array([(np.conj(t) * chord).real, (np.conj(u) * chord).real])
        if np.max(np.abs(rest)) >= size:
            break
        size, best = float(np.max(np.abs(rest))), now
        cross = float((np.conj(t) * u).real)
        matrix = np.array(
            [
                [v * (k * (np.conj(1j * t) * chord).real - 1), w * cross],
                [-v * cross, w * (m * (np.conj(1j * u) * chord).real + 1)],
            ]
        )
        if abs(np.linalg.det(matrix)) < 1e-14 * np.max(np.abs(matrix)) ** 2:
            break
        by = np.linalg.solve(matrix, rest)
        now = (now[0] - float(by[0]), now[1] - float(by[1]))
    return best
