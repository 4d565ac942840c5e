"""Which nodes of a grid touch, and their pressures: an active set on conjugate gradients."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import AccuracyError
from tmmcalc.core.numerics.panels import Values

Mask = NDArray[np.bool_]

PASSES = 100  # of the active set
SLACK = 1e-12  # of the approach: a smaller overlap outside is rounding
ACCURACY = 1e-12  # of the conjugate gradients, relative
STEPS = 2000  # of them
FINER = "write more cells, or a smoother gap"


def active_set(
    settle: Callable[[Values], Values], gap: Values, load: float, touching: Mask
) -> tuple[Values, float, Values, Mask, int]:
    """Pressures q >= 0 (n,) with W q + h = delta where q > 0 and the sum ``load``; delta, opening, who touches, passes.

    From a first guess of who touches, nodes that pull are dropped until none does, then those that overlap are
    admitted. Raises `AccuracyError` if that does not settle.
    """
    unit: Values = np.zeros(len(gap))
    own: Values = np.zeros(len(gap))
    for passes in range(1, PASSES + 1):
        unit = _solve(settle, np.ones(len(gap)), unit, touching)
        own = _solve(settle, gap, own, touching)
        delta = float((load + own.sum()) / unit.sum())
        q = delta * unit - own
        if np.any(q < 0):
            touching = q > 0
            continue
        opening = np.where(touching, 0.0, settle(q) + gap - delta)
        overlap = opening < -SLACK * (abs(delta) + float(np.ptp(gap)))
        if not overlap.any():
            return q, delta, opening, touching, passes
        touching = touching | overlap
    raise AccuracyError(f"the nodes in contact did not settle in {PASSES} passes", where="contact", remedy=FINER)


def _solve(settle: Callable[[Values], Values], wanted: Values, first: Values, touching: Mask) -> Values:
    """q, zero where nothing touches, with W q = wanted (n,) elsewhere: conjugate gradients from ``first``."""
    q = np.where(touching, first, 0.0)
    enough = ACCURACY**2 * float(wanted[touching] @ wanted[touching])
    if not enough:
        return np.zeros(len(q))
    residual = np.where(touching, wanted - settle(q), 0.0)
    direction, left = residual, float(residual @ residual)
    for _ in range(STEPS):
        if left <= enough:
            return q
        turned = np.where(touching, settle(direction), 0.0)
        part = left / float(direction @ turned)
        q, residual = q + part * direction, residual - part * turned
        before, left = left, float(residual @ residual)
        direction = residual + left / before * direction
    raise AccuracyError(f"pressures were not found in {STEPS} steps", where="contact", remedy=FINER)
