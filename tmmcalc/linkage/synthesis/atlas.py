"""An atlas of random linkages, brought to wanted points by the shift, turn and scale that fit best.

The crank meets the points one after another within a turn: at prescribed angles, or where the parts of the way that the
coupler point has gone are those of the way along the points.
"""

from __future__ import annotations

import numpy as np

from tmmcalc.core.plane import Plane, Real, square
from tmmcalc.linkage.synthesis.curvefit import Wanted
from tmmcalc.linkage.synthesis.planar import Bars, bars_of

TURN = 2 * np.pi
PLACES = 72  # of the crank on the way
SPREAD = 0.6  # standard deviation of the logarithms of the lengths


def atlas(wanted: Wanted, rng: np.random.Generator, count: int, keep: int, turning: bool) -> tuple[Bars, Real, Real]:
    """The linkages of ``count`` that come nearest, their crank's angles (k, n) and errors (k,), the nearest first.

    Only cranks that turn fully if ``turning``.
    """
    bars = _random(wanted.slides, rng, count)
    phi, good = _angles(wanted, bars, rng)
    if turning:
        good &= bars.turns()
    rows = np.flatnonzero(good)
    bars, phi = bars.rows(rows), phi[rows]
    placed = bars.at(phi)
    curve, points = placed.point, wanted.points
    middles, middle = curve.mean(axis=1, keepdims=True), points.mean()
    ratio = np.sum(np.conj(curve - middles) * (points - middle), axis=1, keepdims=True)
    ratio = ratio / np.maximum(np.sum(square(curve - middles), axis=1, keepdims=True), 1e-300)
    error = np.mean(square(ratio * (curve - middles) - (points - middle)), axis=1)
    if wanted.turns is not None:
        turned = placed.turn * np.conj(wanted.turns)
        error += 1 - np.abs(turned.mean(axis=1)) ** 2
    best = np.argsort(error)[:keep]
    ratio = ratio[best]
    moved = bars.rows(best).moved(ratio, middle - ratio * middles[best])
    return moved, phi[best] + np.angle(ratio), np.sqrt(error[best])


def _random(slides: bool, rng: np.random.Generator, count: int) -> Bars:
    """Random linkages with the crank's pivot at 0 and the frame, or the guide, along x."""
    shape = (count, 1)

    def length(usual: float) -> Real:
        return np.exp(rng.normal(np.log(usual), SPREAD, shape))

    crank, coupler = length(0.75), length(1.6)
    rocker, frame = (np.ones(shape), 1j * rng.normal(0, 0.5, shape)) if slides else (length(1.6), length(1.6) + 0j)
    point = coupler * (rng.normal(0.5, 0.8, shape) + 1j * rng.normal(0, 0.8, shape))
    sign = rng.choice([1.0, -1.0], shape)
    return bars_of(
        (np.zeros(shape, complex), crank, coupler, frame, rocker, np.ones(shape, complex), point, sign), slides
    )


def _angles(wanted: Wanted, bars: Bars, rng: np.random.Generator) -> tuple[Real, np.ndarray]:
    """Angles (m, n) of the crank at the points, and whether it gets along them."""
    count = len(bars.crank)
    start = rng.uniform(0, TURN, (count, 1))
    if wanted.timing is not None:
        phi = start + wanted.timing
        return phi, np.all(bars.at(phi).margin > 0, axis=1)
    span = TURN * rng.uniform(0.1, 1, (count, 1)) * rng.choice([1.0, -1.0], (count, 1))
    way = start + span * np.linspace(0, 1, PLACES)
    placed = bars.at(way)
    gone, going = _parts(placed.point), _parts(wanted.points[None])[0]
    rows = np.sum(gone[:, :, None] <= going + 1e-12, axis=1) - 1
    return np.take_along_axis(way, rows, axis=1), np.all(placed.margin > 0, axis=1)


def _parts(points: Plane) -> Real:
    """Parts (k, n) of the way along points (k, n) that lie before each of them."""
    steps = np.cumsum(np.abs(np.diff(points, axis=1)), axis=1)
    whole = np.maximum(steps[:, -1:], 1e-300)
    return np.concatenate((np.zeros((len(points), 1)), steps / whole), axis=1)
