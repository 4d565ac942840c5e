"""How exact a contour is: what rounding and the quadrature leave of its corners and of its area.

Every edge is a curve f = 0 in the plane of the shifts. The terms of f carry a rounding each, N in the mean, so the edge
stands within N/|grad f| of its place, and a corner of two edges within |J^-1| N. Over the boundary the former adds up
to the area. Gauss's rule of n points misses the Legendre coefficients from the order 2n on; how far they fall until
then is foretold by their fall from n/2 to n.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.gears.involute.contour.contour import Contour
from tmmcalc.gears.involute.contour.corners import ROW_OF, SLOPE, equations, stacked
from tmmcalc.gears.involute.contour.frame import Frame
from tmmcalc.gears.involute.contour.joined import Region
from tmmcalc.gears.involute.contour.side import Side
from tmmcalc.gears.involute.contour.trace import POINTS, Part
from tmmcalc.gears.model import Values
from tmmcalc.numerics.extended import EPS
from tmmcalc.numerics.gauss import rule
from tmmcalc.records import record

WIDTH = 1e-6  # [rad] of the differences along w
TAIL = 3  # coefficients at the end of a series that tell what is missing
FLAT = 1e-9  # gradient that is none
STRIDE = 4  # steps of the boundary to one that is looked at
MEAN = 0.9  # of a rounding unit, for each term
DECAY = 1.5  # of the fall over half of the coefficients, what the next ones go on to; 2 would be geometric
LIKE = 2.0  # displacement over the median one that is still its own


@record
class ContourError:
    """Relative errors of a contour."""

    area: float
    corners: float  # of the shifts, to the largest of them


def contour_error(found: Contour) -> ContourError | None:
    """Of the main region; None where there is none."""
    if found.main is None:
        return None
    frame, region = found.frame, found.main
    return ContourError(_area(frame, region) / region.area, _corners(frame, region))


def _area(frame: Frame, region: Region) -> float:
    """Absolute, of the quadrature and of the boundary's place."""
    x1, x2 = region.outline
    rows = np.repeat([ROW_OF[edge.line] for edge in region.edges], [edge.x1.size - 1 for edge in region.edges])
    length = np.add.reduceat(np.hypot(np.diff(x1), np.diff(x2)), np.arange(0, rows.size, STRIDE))
    one, two = ((x[1:] + x[:-1])[::STRIDE] / 2 for x in (x1, x2))
    rows = rows[::STRIDE]
    size = np.hypot(*_gradients(frame, one, two, rows))
    shift = MEAN * _noise(frame, one, two)[rows, np.arange(rows.size)] / np.maximum(size, FLAT)
    # next to a tip on its base circle both are without bounds, and their quotient is that of the neighbours
    shift = np.minimum(shift, LIKE * np.median(shift))
    # places err to both sides: the steps of a stride do so each by itself
    placed = float(np.sqrt(np.sum((shift * length) ** 2) / STRIDE))
    return placed + sum(_missed(frame, part) for part in region.parts) + 2 * EPS * region.area


def _missed(frame: Frame, part: Part) -> float:
    """What Gauss's rule leaves of a part's area."""
    size, gauss = POINTS + 1, rule(POINTS)
    inner = part.angles[:-1].reshape(-1, size)[:, 1:]
    half = np.diff(part.angles[::size]) / 2
    gaps = (part.high - part.low)[:-1].reshape(-1, size)[:, 1:]
    values = gaps * frame.sum_slope(inner) * half[:, None] * np.sin(np.pi * gauss.points) * np.pi
    terms = np.abs(values @ gauss.coefficients.T)
    before, last = terms[:, POINTS // 2 : POINTS // 2 + TAIL].max(axis=1), terms[:, -TAIL:].max(axis=1)
    return float(np.sum(last * (last / np.maximum(before, last)) ** DECAY)) / 2


def _corners(frame: Frame, region: Region) -> float:
    """The largest error of a corner over the largest shift of any."""
    # where one line breaks, at the angle of the rack, the corner is known exactly
    corners = [corner for corner in region.corners if equations(*corner.lines)[1] < SLOPE]
    if not corners:
        return EPS
    x1, x2 = (np.array([getattr(corner, name) for corner in corners]) for name in ("x1", "x2"))
    pairs = np.array([equations(*corner.lines) for corner in corners]).T
    noise = 2 * MEAN * _noise(frame, x1, x2)[pairs, np.arange(x1.size)]
    jacobian = np.moveaxis(np.array([_gradients(frame, x1, x2, rows) for rows in pairs]), 2, 0)  # (m, 2 rows, 2)
    determinant = jacobian[:, 0, 0] * jacobian[:, 1, 1] - jacobian[:, 0, 1] * jacobian[:, 1, 0]
    cofactors = np.abs(jacobian[:, ::-1, ::-1])  # of the transposed inverse
    missed = np.einsum("mij,im->mj", cofactors, noise) / np.maximum(np.abs(determinant), FLAT)[:, None]
    return max(float(missed.max()) / float(max(np.abs(x1).max(), np.abs(x2).max())), EPS)


def _gradients(frame: Frame, x1: Values, x2: Values, rows: Values) -> tuple[Values, Values]:
    """Derivatives (m,) of the conditions ``rows`` by x1 and by x2."""
    w, every = frame.angle_of(x1 + x2), np.arange(x1.size)
    ends = stacked(frame, np.concatenate((w + WIDTH, w - WIDTH)), np.concatenate((x1, x1)))
    by_w = (ends[rows, every] - ends[rows, every + x1.size]) / (2 * WIDTH)
    along = (ends[rows + SLOPE, every] + ends[rows + SLOPE, every + x1.size]) / 2
    across = by_w / frame.sum_slope(w)
    return along + across, across


def _noise(frame: Frame, x1: Values, x2: Values) -> Values:
    """What the roundings of all terms add up to, (9, m) by the rows of `corners`."""
    w = frame.angle_of(x1 + x2)
    sums = frame.sums(w)
    one, two = frame.sides
    distance = sums.modification + one.reference + two.reference
    tips = frame.tip(0, sums, x1), frame.tip(1, sums, x2)
    rho = [np.sqrt(np.maximum(r * r - side.base**2, EPS)) for r, side in zip(tips, frame.sides, strict=True)]
    spread = [distance * r / each for r, each in zip(tips, rho, strict=True)]  # of rho by r, whose terms are a_w
    rooms = [
        sums.length + spread[1 - i] + np.abs(side.start(x)[0]) + side.reference + _fitted(side, x)
        for i, (side, x) in enumerate(zip(frame.sides, (x1, x2), strict=True))
    ]
    thick = [
        side.flat + np.abs(x) / side.base + each / side.base + each * s / (each * each + side.base**2)
        for side, x, each, s in zip(frame.sides, (x1, x2), rho, spread, strict=True)
    ]
    ratio = (spread[0] + spread[1] + sums.length) / frame.pitch
    least = [np.abs(x) + abs(side.least) + side.reference for side, x in zip(frame.sides, (x1, x2), strict=True)]
    return EPS * np.array([*rooms, *thick, ratio, *least, distance, distance])


def _fitted(side: Side, x: Values) -> Values:
    """Error of the polynomial that stands for undercut, over the unit of rounding."""
    if not np.any(x < side.least):
        return np.zeros_like(x)
    lack = np.maximum(side.least - x, 0.0) * side.steepness
    tail: Values = lack * (1 + np.abs(side.form.series[0, -TAIL:]).max() / EPS)
    return tail
