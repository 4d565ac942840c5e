"""Many linkages fitted to points or poses at once: Levenberg's and Marquardt's method, block by block.

The angle of the crank at one point moves no other point, so these angles are eliminated and a step is solved for the
sizes alone, however many the points are. Slopes are central differences, whose error a residual that vanishes does not
feel. After a few steps hopeless linkages are dropped, so that the cost goes into those that converge.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.records import record
from tmmcalc.linkage.synthesis.batch import Course
from tmmcalc.linkage.synthesis.planar import Bars, bars_of

SIZES = 9  # A, D or a point of the guide, P; a, b, and c or the direction of the guide
STEP = 1e-6  # of the differences, of unknowns of unit size
CLOSE = 1e-30  # sum of squares at which a fit is finished
LOST = 1e12  # damping at which a fit no longer gets better
STALLED = 1e-9  # part of the sum of squares; a step that gains less is the last one
FLAT = 1e-14  # square slope of a point that its angle hardly moves


@record
class Wanted:
    """Points (n,) in units of their spread about their middle, and what else is asked at them."""

    points: Plane
    turns: Plane | None  # (n,) unit turns of the body since the first pose; None: a path
    timing: Real | None  # (n,) angles of the crank since the first point; None: free
    slides: bool
    region: tuple[complex, complex] | None = None  # corners between which the fixed pivots stand

    @property
    def shared(self) -> int:
        """Unknowns that move all points: the sizes, where the body stands on the coupler, the first angle if timed."""
        return SIZES + (self.turns is not None) + (self.timing is not None)


class Fits(NamedTuple):
    """Linkages, the angles of their cranks at the points, and the sums of squares, the least first."""

    bars: Bars
    phi: Real  # (k, n)
    cost: Real  # (k,)


def fitted(
    wanted: Wanted, bars: Bars, phi: Real, cuts: Mapping[int, int], iterations: int, course: list[Course] | None = None
) -> Fits:
    """Fit m linkages with the crank's angles (m, n) as starts; after ``cuts`` iterations that many are kept.

    ``course`` takes of every iteration how many are iterated and the least sum of squares.
    """
    x, sign = _inside(wanted, _packed(wanted, bars, phi)), bars.sign.copy()
    r = _residuals(wanted, x, sign)
    cost = np.sum(r**2, axis=(1, 2))
    damping = np.full(len(x), 1e-2)
    for done in range(iterations):
        if done in cuts:
            kept = np.argsort(cost)[: cuts[done]]
            x, sign, r, cost, damping = x[kept], sign[kept], r[kept], cost[kept], damping[kept]
        active = np.flatnonzero((cost > CLOSE) & (damping < LOST))
        if course is not None:
            course.append((len(active), float(cost.min())))
        if not active.size:
            break
        tried = _inside(wanted, x[active] + _step(wanted, x[active], sign[active], r[active], damping[active]))
        new = _residuals(wanted, tried, sign[active])
        new_cost = np.sum(new**2, axis=(1, 2))
        better = new_cost < cost[active]
        slow = better & (new_cost > (1 - STALLED) * cost[active])
        rows = active[better]
        x[rows], r[rows], cost[rows] = tried[better], new[better], new_cost[better]
        damping[active] = np.maximum(damping[active] * np.where(better, 0.2, 4.0), 1e-15)
        damping[active[slow]] = LOST
    order = np.argsort(cost)
    return Fits(*_unpacked(wanted, x[order], sign[order]), cost[order])


def _packed(wanted: Wanted, bars: Bars, phi: Real) -> Real:
    """Unknowns (m, p): those that all points share, then the free angles of the crank."""
    last = np.angle(bars.guide) if wanted.slides else bars.rocker
    parts = [part for at in (bars.pivot, bars.end, bars.point) for part in (at.real, at.imag)]
    parts += [bars.crank, bars.coupler, last]
    if wanted.turns is not None:
        off = np.conj(wanted.turns) * bars.at(phi).turn
        parts.append(np.angle(off.sum(axis=1, keepdims=True)))
    parts.append(phi if wanted.timing is None else phi[:, :1])
    return np.concatenate(parts, axis=1)


def _inside(wanted: Wanted, x: Real) -> Real:
    """The unknowns with the fixed pivots brought to the border of the region, if they have left it."""
    if wanted.region is None:
        return x
    low, high = ([corner.real, corner.imag] for corner in wanted.region)
    for k in (0,) if wanted.slides else (0, 2):
        x[:, k : k + 2] = np.clip(x[:, k : k + 2], low, high)
    return x


def _unpacked(wanted: Wanted, x: Real, sign: Real) -> tuple[Bars, Real]:
    pivot, end, point = (x[:, [k]] + 1j * x[:, [k + 1]] for k in (0, 2, 4))
    crank, coupler, last, one = np.abs(x[:, [6]]), np.abs(x[:, [7]]), x[:, [8]], np.ones((len(x), 1))
    rocker, guide = (one, np.exp(1j * last)) if wanted.slides else (np.abs(last), one + 0j)
    bars = bars_of((pivot, crank, coupler, end, rocker, guide, point, sign), wanted.slides)
    return bars, x[:, wanted.shared :] if wanted.timing is None else x[:, wanted.shared - 1 :] + wanted.timing


def _residuals(wanted: Wanted, x: Real, sign: Real) -> Real:
    """Residuals (m, q, n): distance from the point, gap of links that do not reach, error of the body's angle."""
    bars, phi = _unpacked(wanted, x, sign)
    placed = bars.at(phi)
    off = placed.point - wanted.points
    rows = [off.real, off.imag, np.minimum(placed.margin, 0)]
    if wanted.turns is not None:
        rows.append(np.angle(placed.turn * np.conj(wanted.turns) * np.exp(-1j * x[:, [SIZES]])))
    return np.nan_to_num(np.stack(rows, axis=1), nan=1e6, posinf=1e6, neginf=-1e6)


def _step(wanted: Wanted, x: Real, sign: Real, r: Real, damping: Real) -> Real:
    """The damped step (m, p): the point's own angle eliminated, sizes from the rest, then the angles."""

    def slope(along: Real) -> Real:
        ahead, behind = (_residuals(wanted, x + way * STEP * along, sign) for way in (1, -1))
        return (ahead - behind) / (2 * STEP)

    p = wanted.shared
    unit = np.eye(x.shape[1])
    by_sizes = np.stack([slope(unit[k]) for k in range(p)], axis=-1)  # (m, q, n, p)
    by_angle = slope(unit[p:].sum(axis=0)) if wanted.timing is None else np.zeros_like(r)
    own = np.sum(by_angle**2, axis=1) * (1 + damping[:, None]) + FLAT
    mixed = np.einsum("kqnp,kqn->knp", by_sizes, by_angle)
    right = np.sum(by_angle * r, axis=1)
    flat = by_sizes.reshape(len(x), -1, p)
    normal = np.einsum("kqi,kqj->kij", flat, flat)
    scale = np.maximum(np.einsum("kii->ki", normal), 1e-12)
    normal += (damping[:, None] * scale)[:, :, None] * np.eye(p)
    normal -= np.einsum("kni,knj->kij", mixed / own[:, :, None], mixed)
    gradient = np.einsum("kqi,kq->ki", flat, r.reshape(len(x), -1)) - np.einsum("kni,kn->ki", mixed, right / own)
    sizes = np.linalg.solve(normal, -gradient[..., None])[..., 0]
    if wanted.timing is not None:
        return np.asarray(sizes)
    return np.concatenate((sizes, -(right + np.einsum("kni,ki->kn", mixed, sizes)) / own), axis=1)
