"""Simpson's rule over tabulated values, as the course integrates by hand."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.numerics.panels import Values


def simpson(x: Values, y: Values) -> float | None:
    """Integral of y (n,) over x (n,) by Simpson's rule (3.38); None unless the steps are equal and even in number.

    >>> simpson(np.array([0.0, 1.0, 2.0]), np.array([0.0, 1.0, 8.0]))
    4.0
    """
    steps = np.diff(x)
    if len(steps) % 2 or np.ptp(steps) > 1e-9 * abs(steps[0]):
        return None
    return float(steps[0] / 3 * (y[0] + y[-1] + 4 * y[1:-1:2].sum() + 2 * y[2:-2:2].sum()))


def simpson_weights(count: int) -> Values:
    """What the ordinates (n,) of an even number of steps are multiplied by: 1, 4, 2, 4, ... 4, 1 (3.38).

    >>> simpson_weights(7).tolist()
    [1.0, 4.0, 2.0, 4.0, 2.0, 4.0, 1.0]
    """
    weights = np.where(np.arange(count) % 2, 4.0, 2.0)
    weights[0] = weights[-1] = 1.0
    return weights


def running_simpson(values: Values, step: Values) -> Values:
    """The integral (P, n + 1) from the first node to every node of values (P, n + 1), n even, at equal steps (P,).

    Between two nodes it is that of the parabola through three.

    >>> running_simpson(np.array([[0.0, 3.0, 12.0]]), np.array([1.0]))
    array([[0., 1., 8.]])
    """
    first, middle, last = values[:, :-1:2], values[:, 1::2], values[:, 2::2]
    half = (5 * first + 8 * middle - last) / 12 * step[:, None]
    pair = (first + 4 * middle + last) / 3 * step[:, None]
    found = np.zeros_like(values)
    found[:, 2::2] = np.cumsum(pair, axis=1)
    found[:, 1::2] = found[:, :-1:2] + half
    return found
