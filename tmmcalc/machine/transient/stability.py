"""How long a fixed explicit step may be: the stability polynomial of the method over all eigenvalues.

    y+ = R(h lambda) y,   R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24, of Kutta-Merson + z^5/144

A part of the solution that decays or swings has to stay bounded in the numbers too, so |R| may not exceed 1; the bound
is 2.785 (Kutta-Merson 3.548) on the real axis, 2.828 (3.464) on the imaginary one, and more or less in between. Where
|R| exceeds what the part itself does by so little that the whole duration makes no more than e of it, the
step is let pass: such a part is followed badly, which the error tells, but it drowns nothing.
Source: E. Hairer, G. Wanner, Solving ODE II, IV.2.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.panels import Values

POLYNOMIALS = {
    "merson": (1.0, 1.0, 1 / 2, 1 / 6, 1 / 24, 1 / 144),
    "rk4": (1.0, 1.0, 1 / 2, 1 / 6, 1 / 24),
}
GROWN = 1.0  # logarithm of the spurious growth over the duration that is let pass
RADII = np.linspace(0.0, 8.0, 161)[1:]  # |h lambda|; beyond 8 nothing that decays is bounded
NEAR = 0.25  # of the fastest: slower parts bound no step, for the bounds of all directions differ by less
SECTIONS, ROUNDS = 64, 5  # a step is sought in so many sections at once, so many times: as fine as 30 halvings


def growth(name: str, z: Values) -> Values:
    """|R(z)| of "merson" or "rk4".

    >>> [round(float(growth(name, np.array(at))), 3) for name, at in (("rk4", -2.785), ("merson", 3.464j))]
    [1.0, 1.0]
    """
    size: Values = np.abs(np.polynomial.polynomial.polyval(z, POLYNOMIALS[name]))
    return size


def stable_step(name: str, values: Values, duration: float) -> float:
    """The longest step [s] of a method up to which all eigenvalues (m,) [1/s] are stable; inf if none bounds it.

    >>> round(stable_step("rk4", np.array([-1000.0]), 10.0), 6)
    0.002785
    """
    size = np.abs(values)
    fastest = float(size.max(initial=0.0))
    chosen = values[(size > NEAR * fastest) & (size * duration > 1)]
    if not len(chosen):
        return math.inf
    size, way = np.abs(chosen), chosen / np.abs(chosen)
    own = np.maximum(way.real, 0.0)

    def over(radius: Values) -> NDArray[np.bool_]:
        """Whether in a step |h lambda| a part grows beyond its own growth and what is let pass."""
        with np.errstate(divide="ignore"):
            logarithm: Values = np.log(growth(name, radius * way))
        beyond: NDArray[np.bool_] = logarithm > radius * (own + GROWN / (size * duration))
        return beyond

    beyond = over(RADII[:, None])
    bounded = beyond.any(axis=0)
    if not bounded.any():
        return math.inf
    first = np.argmax(beyond, axis=0)
    high = RADII[first]
    low = high - RADII[0]
    for _ in range(ROUNDS):
        inside = over(low + (high - low) * np.arange(1, SECTIONS)[:, None] / SECTIONS)
        first = np.where(inside.any(axis=0), np.argmax(inside, axis=0), SECTIONS - 1)
        low, high = low + (high - low) * first / SECTIONS, low + (high - low) * (first + 1) / SECTIONS
    return float((low / size)[bounded].min())
