"""How exact a contour is: what rounding and the quadrature leave of its corners and of its area.

Every edge is a curve f = 0 in the plane of the shifts. What f is, in extended precision, at a point that was found
tells how far the edge is from there: f over its derivative along the line of constant sum. Weighted as the points are
in the quadrature, these distances add up to no less than what the area is off. In a corner of two edges the point is
off by J^-1 f of both.

Gauss's rule of n points misses the Legendre coefficients from the order 2n on. They fall at least as fast as a power of
the order: from n to 2n by as much again as from n/2 to n. Where that leaves more than rounding, the edges are
traced at twice as many points, and what the area changes by is what it was off.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.extended import CHAIN, EPS, MARGIN, WIDER
from tmmcalc.core.numerics.gauss import rule
from tmmcalc.gears.involute.contour.bounds import cuts
from tmmcalc.gears.involute.contour.contour import Contour
from tmmcalc.gears.involute.contour.corners import SLOPE, equations, stacked
from tmmcalc.gears.involute.contour.exact import Exact, exact_of
from tmmcalc.gears.involute.contour.frame import Frame
from tmmcalc.gears.involute.contour.regions import Region
from tmmcalc.gears.involute.contour.results import ContourError
from tmmcalc.gears.involute.contour.side import Side
from tmmcalc.gears.involute.contour.trace import POINTS, ContourPart
from tmmcalc.gears.model import Values

WIDTH = 1e-6  # [rad] of the differences along w
TAIL = 3  # coefficients at the end of a series that tell what is missing
FLAT = 1e-9  # slope that is none
TINY = 1e-300  # a coefficient that is none
PRODUCT = 8  # roundings, of half a unit at most, in a term of the area


def contour_error(found: Contour) -> ContourError | None:
    """Of the main region; None where there is none."""
    if found.main is None:
        return None
    frame, region = found.frame, found.main
    missed = sum(_missed(frame, part, found.strict) for part in region.parts) / region.area + PRODUCT * EPS / 2
    if not WIDER:
        return ContourError(CHAIN + missed, CHAIN)
    exact = exact_of(frame)
    placed = sum(_placed(exact, part) for part in region.parts) / region.area
    return ContourError(placed + missed, _corners(exact, region))


def _placed(exact: Exact, part: ContourPart) -> float:
    """Area between the edges of a part and the points that were found on them."""
    size, gauss, frame = POINTS + 1, rule(POINTS), exact.frame
    w = part.angles[:-1].reshape(-1, size)[:, 1:].ravel()
    half = np.diff(part.angles[::size]) / 2
    weights = (half[:, None] * np.sin(np.pi * gauss.points) * np.pi * gauss.weights).ravel() * frame.sum_slope(w)
    ends = np.stack([end[:-1].reshape(-1, size)[:, 1:].ravel() for end in (part.low, part.high)])
    return float(np.sum(weights * sum(_distance(exact, w, x1) for x1 in ends)))


def _distance(exact: Exact, w: Values, x1: Values) -> Values:
    """Distances (m,) along the lines of constant sum to the nearest edge, on which the points were found."""
    slopes = np.maximum(np.abs(stacked(exact.frame, w, x1)[SLOPE:]), FLAT)
    total = exact.frame.sums(w).total
    found = (np.abs(exact.values(w, x1)).astype(float) + _fitted_rows(exact.frame, x1, total - x1)) / slopes
    return np.asarray(np.min(found, axis=0))


def _missed(frame: Frame, part: ContourPart, strict: bool) -> float:
    """What Gauss's rule leaves of a part's area."""
    size, gauss = POINTS + 1, rule(POINTS)
    half = np.diff(part.angles[::size]) / 2
    gaps = (part.high - part.low)[:-1].reshape(-1, size)[:, 1:]
    values = _rates(frame, half, part.angles[:-1].reshape(-1, size)[:, 1:], gaps)
    terms = np.abs(values @ gauss.coefficients.T)
    before, last = terms[:, POINTS // 2 : POINTS // 2 + TAIL].max(axis=1), terms[:, -TAIL:].max(axis=1)
    left = last * last / np.maximum(np.maximum(before, last), TINY)
    rough = left > EPS * part.area
    if rough.any():
        left[rough] = MARGIN * np.abs(_again(frame, part, strict, rough) - values[rough] @ gauss.weights)
    return float(np.sum(left))


def _again(frame: Frame, part: ContourPart, strict: bool, which: NDArray[np.bool_]) -> Values:
    """Areas (m,) of some panels of a part by a rule of twice as many points."""
    gauss, edges = rule(2 * POINTS), part.angles[:: POINTS + 1]
    mean, half = ((edges[1:] + edges[:-1]) / 2)[which], (np.diff(edges) / 2)[which]
    w = mean[:, None] - half[:, None] * np.cos(np.pi * gauss.points)
    low, high, _, _ = cuts(frame, w.ravel(), part.branch, tolerated=not strict).ends(strict)
    return np.asarray(_rates(frame, half, w, (high - low).reshape(w.shape)) @ gauss.weights)


def _rates(frame: Frame, half: Values, w: Values, gaps: Values) -> Values:
    """Area (k, n) by the variable of the rule on panels of half widths (k,), at w (k, n) with gaps (k, n)."""
    found: Values = gaps * frame.sum_slope(w) * half[:, None] * np.sin(np.pi * rule(w.shape[1]).points) * np.pi
    return found


def _corners(exact: Exact, region: Region) -> float:
    """The largest error of a corner over the largest shift of any."""
    # where one line breaks, at the angle of the rack, the corner is known exactly
    corners = [corner for corner in region.corners if equations(*corner.lines)[1] < SLOPE]
    if not corners:
        return EPS
    x1, x2 = (np.array([getattr(corner, name) for corner in corners]) for name in ("x1", "x2"))
    pairs, every = np.array([equations(*corner.lines) for corner in corners]).T, np.arange(x1.size)
    total = x1.astype(np.longdouble) + x2
    values = np.abs(exact.values(exact.angle_of(total), x1)).astype(float) + _fitted_rows(exact.frame, x1, x2)
    left = values[pairs, every]
    jacobian = np.moveaxis(np.array([_gradients(exact.frame, x1, x2, rows) for rows in pairs]), 2, 0)  # (m, 2 rows, 2)
    determinant = jacobian[:, 0, 0] * jacobian[:, 1, 1] - jacobian[:, 0, 1] * jacobian[:, 1, 0]
    cofactors = np.abs(jacobian[:, ::-1, ::-1])  # of the transposed inverse
    missed = np.einsum("mij,im->mj", cofactors, left) / np.maximum(np.abs(determinant), FLAT)[:, None]
    return max(MARGIN * float(missed.max()) / float(max(np.abs(x1).max(), np.abs(x2).max())), EPS)


def _gradients(frame: Frame, x1: Values, x2: Values, rows: Values) -> tuple[Values, Values]:
    """Derivatives (m,) of the conditions ``rows`` by x1 and by x2."""
    w, every = frame.angle_of(x1 + x2), np.arange(x1.size)
    ends = stacked(frame, np.concatenate((w + WIDTH, w - WIDTH)), np.concatenate((x1, x1)))
    by_w = (ends[rows, every] - ends[rows, every + x1.size]) / (2 * WIDTH)
    along = (ends[rows + SLOPE, every] + ends[rows + SLOPE, every + x1.size]) / 2
    across = by_w / frame.sum_slope(w)
    return along + across, across


def _fitted_rows(frame: Frame, x1: Values, x2: Values) -> Values:
    """What the polynomials of undercut leave of the conditions (9, m): only of the first two."""
    fitted = [_fitted(side, x) for side, x in zip(frame.sides, (x1, x2), strict=True)]
    return np.concatenate((fitted, np.zeros((SLOPE - 2, x1.size))))


def _fitted(side: Side, x: Values) -> Values:
    """Error of the polynomial that stands for undercut."""
    if not np.any(x < side.least):
        return np.zeros_like(x)
    lack = np.maximum(side.least - x, 0.0) * side.steepness
    return np.asarray(lack * np.abs(side.form.series[0, -TAIL:]).max())
