"""Function generators by their sizes: rating of many at once, and fits in the least squares.

Sizes are (a, b, c, d) of a four-bar, (r, l, e, 0) of a slider-crank; a negative coefficient is a crank or rocker turned
by half a turn, so that offsets and not lengths take it up.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.core.progress import tell
from tmmcalc.linkage.synthesis.freudenstein import TURN, Closure, Coefficients, coefficients, offsets
from tmmcalc.linkage.synthesis.results import SearchStep

STARTS = 8  # fits from so many of the best starts
LONGEST = 50.0  # of a link against the frame, or against the travel of the slider
MET = 1e-7  # of a wanted value: nearer, and the linkage meets it in that variant
LONG = 20.0  # times the shortest link: longer is a defect
POOR = np.radians(20)  # least transmission angle without a defect, if none is asked for


class Fitted(NamedTuple):
    """k generators: sizes (k, 4), offsets (k, 2), variant of the output, largest error, number of defects."""

    sizes: Real
    offsets: Real
    sign: Real
    error: Real  # (k,) over the range [rad, or parts of the travel]
    defects: Real
    transmission: Real  # (k,) least transmission angle over the range [rad]


def sizes_of(closure: Closure, found: Coefficients) -> tuple[Real, Real]:
    """Sizes (k, 4) and offsets (k, 2) of coefficients; rows that are no linkage hold NaN."""
    k, places = found.coefficients, found.offsets.copy()
    with np.errstate(all="ignore"):
        if closure.slides:
            r = k[:, 0] / 2
            e = k[:, 1] / (2 * r)
            l = np.sqrt(r**2 + e**2 - k[:, 2])
            places[:, 0] += np.where(r < 0, np.pi, 0)
            sizes = np.stack((np.abs(r), l, e, np.zeros_like(r)), axis=1)
        else:
            d = closure.frame
            a, c = d / k[:, 0], d / k[:, 1]
            b = np.sqrt(a**2 + c**2 + d**2 - 2 * a * c * k[:, 2])
            places[:, 0] += np.where(a < 0, np.pi, 0)
            places[:, 1] += np.where(c < 0, np.pi, 0)
            sizes = np.stack((np.abs(a), b, np.abs(c), np.full_like(a, d)), axis=1)
    return sizes, places


def output(closure: Closure, sizes: Real, phi: Real, sign: Real) -> tuple[Real, Real]:
    """Output (k, n) at crank angles (k, n), and the squared sine of the transmission angle."""
    a, b, c, d = (sizes[:, i, None] for i in range(4))
    with np.errstate(all="ignore"):
        if closure.slides:
            r, l, e = a, b, c
            across = (e - r * np.sin(phi)) / l
            margin = 1 - across**2
            return r * np.cos(phi) + sign[:, None] * l * np.sqrt(np.maximum(margin, 0)), margin
        q = a * np.exp(1j * phi) - d  # D -> B
        q2 = np.abs(q) ** 2
        cosine = (q2 + c**2 - b**2) / (2 * np.abs(q) * c)
        margin = ((b + c) ** 2 - q2) * (q2 - (b - c) ** 2) / (2 * b * c) ** 2
        return np.angle(q) + sign[:, None] * np.arccos(np.clip(cosine, -1, 1)), margin


def difference(closure: Closure, found: Real, wanted: Real) -> Real:
    """Error of outputs; angles within half a turn."""
    error = found - wanted
    return error if closure.slides else error - TURN * np.round(error / TURN)


def rated(closure: Closure, found: Coefficients, least: float, exact: bool) -> Fitted:
    """Errors and defects of all linkages, each in its better variant; those that are none are left out."""
    sizes, places = sizes_of(closure, found)
    whole = np.all(np.isfinite(sizes), axis=1) & (sizes[:, :2].min(axis=1) > 0)
    scale = closure.frame if not closure.slides else 1.0
    whole &= sizes[:, :3].max(axis=1) < LONGEST * scale
    return _rated(closure, sizes[whole], places[whole], least, exact)


def _rated(closure: Closure, sizes: Real, places: Real, least: float, exact: bool) -> Fitted:
    """Of the two variants each linkage takes the one that comes nearer to the points."""
    fine, wanted = closure.fine
    best: list[Real] = []
    for way in (1.0, -1.0):
        sign = np.full(len(sizes), way)
        at, _ = output(closure, sizes, closure.inputs + places[:, :1], sign)
        met = np.max(np.abs(difference(closure, at, closure.outputs + places[:, 1:])), axis=1)
        values, margin = output(closure, sizes, fine + places[:, :1], sign)
        error = np.max(np.abs(difference(closure, values, wanted + places[:, 1:])), axis=1)
        best.append(np.stack((met, error, margin.min(axis=1))))
    one, two = best
    first = one[0] <= two[0]
    met, error, margin = np.where(first, one, two)
    angle = np.arcsin(np.sqrt(np.clip(margin, 0, 1)))
    lengths = sizes[:, : 2 if closure.slides else 4]
    ratio = lengths.max(axis=1) / lengths.min(axis=1)
    branch = (met > MET) & exact
    defects = branch * 1.0 + (margin <= 0) * 2 + (angle < (least or POOR)) + (ratio > LONG)
    return Fitted(sizes, places, np.where(first, 1.0, -1.0), error, defects.astype(float), angle)


def best_fits(closure: Closure, grid: int, course: list[SearchStep] | None = None) -> Coefficients:
    """Coefficients and offsets of fits in the least squares: of the closure on a grid, then of the output itself.

    ``course`` takes of each fit the sum of squares at its start and at its end, with the evaluations.
    """
    u, v = (values.ravel() for values in np.meshgrid(*offsets(closure, grid), indexing="ij"))
    starts = coefficients(closure, u, v)
    fitted = rated(closure, starts, 0.0, False)
    order = np.lexsort((fitted.error, fitted.defects))
    chosen: list[int] = []
    for k in order.tolist():
        near = (np.max(np.abs(fitted.offsets[k] - fitted.offsets[j])) < TURN / grid * 3 for j in chosen)
        if not any(near):
            chosen.append(k)
        if len(chosen) == STARTS:
            break
    results = []
    for done, k in enumerate(chosen):
        tell((done + 1) / (len(chosen) + 1), f"fit {done + 1} of {len(chosen)}")
        *result, steps = _fit(closure, fitted, k, done + 1)
        results.append(result)
        if course is not None:
            course += steps
    if not results:
        return Coefficients(np.empty((0, 3)), np.empty((0, 2)))
    sizes, places = (np.array(part) for part in zip(*results, strict=True))
    return Coefficients(coefficients_of(closure, sizes), places)


def _fit(closure: Closure, fitted: Fitted, k: int, run: int) -> tuple[Real, Real, list[SearchStep]]:
    """One fit of sizes and free offsets, from one start, with its first and its last step."""
    from scipy.optimize import least_squares

    count = 3
    free = [i for i in (0, 1) if closure.given[i] is None]
    sign, fixed = fitted.sign[k : k + 1], fitted.offsets[k].copy()
    start = np.concatenate((fitted.sizes[k, :count], fitted.offsets[k, free]))

    def unpacked(x: Real) -> tuple[Real, Real]:
        sizes = np.append(x[:count], fitted.sizes[k, 3])
        if not closure.slides:
            sizes[:3] = np.abs(sizes[:3])
        places = fixed.copy()
        places[free] = x[count:]
        return sizes, places

    def residual(x: Real) -> Real:
        sizes, places = unpacked(x)
        values, margin = output(closure, sizes[None], (closure.inputs + places[0])[None], sign)
        error = difference(closure, values, closure.outputs + places[1])[0]
        return np.asarray(error + np.minimum(margin[0], 0) * np.where(error < 0, 1, -1))

    solved = least_squares(residual, start, xtol=1e-13, ftol=1e-13, gtol=1e-15, max_nfev=150)
    steps = ((0, start), (int(solved.nfev), solved.x))
    return *unpacked(solved.x), [SearchStep(run, done, 1, float(np.sum(residual(x) ** 2))) for done, x in steps]


def coefficients_of(closure: Closure, sizes: Real) -> Real:
    """Coefficients K (k, 3) of linkages with these sizes (k, 4)."""
    a, b, c, d = sizes.T
    if closure.slides:
        return np.stack((2 * a, 2 * a * c, a**2 - b**2 + c**2), axis=1)
    return np.stack((d / a, d / c, (a**2 + c**2 + d**2 - b**2) / (2 * a * c)), axis=1)
