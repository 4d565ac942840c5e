"""Observed order of convergence: the slope of the error over the size of the setting.

    error ~ C size^p,    p = d ln(error) / d ln(size)

Settings at the coarse end have not reached the asymptotic range, at the fine end rounding takes over; so the order is
that of a straight run of at least three settings over which the error falls by a decade, by least squares.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

FEW = 3  # settings that make a slope
DECADE = 10.0  # that the error falls by over a run, so that chance makes none
STRAIGHT = 0.1  # largest departure of the slopes between neighbours from their mean, relative


def observed(sizes: Sequence[float], errors: Sequence[float], floor: float = 1e-14) -> float | None:
    """Slope of ln(error) over ln(size), None where no three settings in a row fall on a line over a decade.

    Errors at the ``floor`` are rounding and do not count. Of several straight runs the longest is taken, of these the
    finest.

    >>> observed([1e-1, 1e-2, 1e-3], [3e-2, 3e-4, 3e-6])
    2.0
    """
    pairs = sorted((s, e) for s, e in zip(sizes, errors, strict=True) if e > floor and s > 0)
    x, y = np.log([s for s, _ in pairs]), np.log([e for _, e in pairs])
    best: tuple[int, float] | None = None
    for low in range(len(pairs) - FEW + 1):
        for high in range(low + FEW, len(pairs) + 1):
            slopes = np.diff(y[low:high]) / np.diff(x[low:high])
            mean = float(np.mean(slopes))
            falls = float(np.ptp(y[low:high])) >= np.log(DECADE)
            straight = falls and mean > 0 and float(np.max(np.abs(slopes - mean))) <= STRAIGHT * mean
            if straight and (best is None or high - low > best[0]):
                best = high - low, _slope(x[low:high], y[low:high])
    return None if best is None else best[1]


def _slope(x: np.ndarray, y: np.ndarray) -> float:
    dx = x - x.mean()
    slope = float(dx @ y / (dx @ dx))
    return round(slope, 2) if math.isfinite(slope) else slope
