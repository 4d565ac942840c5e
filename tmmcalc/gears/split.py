"""How the ratio of a reducer with parallel shafts is best split between its stages, before tooth numbers are chosen.

All pinions have equal numbers of teeth, the modules grow with the cube root of the pinion's torque,
m_(k+1) = m_k cbrt(U_k) (4.4), and so do diameters d_k and widths psi d_k. In units of the first pinion every criterion
is then a sum of products of powers of the stage ratios,

    mass      sum_k d_k^3 (1 + alpha1 U_k^2)
    inertia   sum_k d_k^5 (1 + alpha1 alpha2 U_k^4) (omega_k/omega_n)^2      reduced to the output shaft
    size      d_1 + sum_k d_k (1 + U_k)/2 + ...                              length of the row of wheels (4.51)

with d_k^3 = U_1 ... U_(k-1): convex in the logarithms of the ratios, so that Newton's method finds the one minimum.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import product
from math import log

import numpy as np

from tmmcalc.core.errors import AccuracyError, NoSolutionError, UsageError
from tmmcalc.core.records import record
from tmmcalc.gears.criteria.wheels import Build
from tmmcalc.gears.model import Values

CRITERIA = ("mass", "inertia", "size")
ITERATIONS = 60
SETTLED = 1e-13  # step in the logarithm of a ratio


@record
class Split:
    """A split of the whole ratio between the stages."""

    criterion: str  # mass, inertia, size, or equal diameters
    ratios: Values  # U_k (N,)
    modules: Values  # m_k/m_1 (N,)
    cost: float | None  # of the criterion in units of the first pinion; None for equal diameters
    bounded: tuple[int, ...] = ()  # stages whose ratio stands at a limit


def exponents(stages: int) -> tuple[Fraction, ...]:
    """Powers of U that are the stage ratios of equal wheel diameters, U_k = U^(3/2)^(N-k)/s (textbook 4.5, 4.8).

    >>> [str(power) for power in exponents(3)]
    ['9/19', '6/19', '4/19']
    """
    if stages < 1:
        raise UsageError(f"{stages} stages", where="split of the ratio", value=stages, limit=1, remedy="one or more")
    whole = 3**stages - 2**stages
    return tuple(Fraction(3 ** (stages - k) * 2 ** (k - 1), whole) for k in range(1, stages + 1))


def equal_diameters(ratio: float, stages: int = 2) -> Split:
    """The split at which all wheels have the same diameter and dip alike into the oil (textbook 4.5, 4.8).

    >>> equal_diameters(8.15).ratios.round(6).tolist()
    [3.521231, 2.314531]
    """
    _check(ratio)
    powers = np.array([float(power) for power in exponents(stages)])
    ratios = ratio**powers
    return Split("equal diameters", ratios, _modules(ratios), None)


def best_split(ratio: float, criterion: str, stages: int = 2, *, least: float = 1.0, most: float | None = 6.0) -> Split:
    """The split of U between ``stages`` (up to 4) that makes the mass, the inertia or the size least.

    Stage ratios stay between ``least`` and ``most`` (None: no limit). Raises `NoSolutionError` if these limits do
    not admit U.

    >>> best_split(8.15, "mass").ratios.round(4).tolist()
    [2.8726, 2.8371]
    """
    _check(ratio)
    if criterion not in CRITERIA or not 2 <= stages <= 4:
        raise UsageError(
            f"criterion {criterion!r}, {stages} stages",
            where="split of the ratio",
            remedy=f"criteria: {', '.join(CRITERIA)}; two to four stages",
        )
    total, low = log(ratio), log(least)
    high = total if most is None else log(most)
    if not stages * low <= total <= stages * high:
        limit = least**stages if total < stages * low else (most or ratio) ** stages
        raise NoSolutionError(
            f"U = {ratio:g} cannot be split into {stages} stages of {least:g} to {most}",
            where="split of the ratio",
            value=ratio,
            limit=limit,
            remedy="another number of stages, or wider limits of the stage ratio",
        )
    x, pinned = _least(_terms(criterion, stages), total, stages, low, high)
    ratios = np.exp(x)
    return Split(criterion, ratios, _modules(ratios), cost(criterion, ratios), pinned)


def cost(criterion: str, ratios: Values) -> float:
    """Value of a criterion for stage ratios (N,), in units of the first pinion.

    >>> round(cost("size", np.array([2.0, 1.0])), 6)
    3.889882
    """
    terms = _terms(criterion, len(ratios))
    return float(terms[:, 0] @ np.exp(terms[:, 1:] @ np.log(ratios)))


def _check(ratio: float) -> None:
    if not 1 < ratio < np.inf:
        raise UsageError(
            "the ratio has to be above 1", where="split of the ratio", value=ratio, limit=1.0, remedy="U > 1"
        )


def _modules(ratios: Values) -> Values:
    modules: Values = np.cbrt(np.concatenate(([1.0], np.cumprod(ratios[:-1]))))
    return modules


def _terms(criterion: str, stages: int) -> Values:
    """Products of powers, one a row (t, 1 + N): coefficient, then the power of each stage ratio."""
    build, rows = Build(), []
    for k in range(stages):
        torque, own, rest = (np.zeros(stages) for _ in range(3))
        torque[:k], own[k], rest[k:] = 1.0, 1.0, 1.0
        if criterion == "mass":
            rows += [(1.0, torque), (build.webbed_mass, torque + 2 * own)]
        elif criterion == "inertia":
            pinion = 5 / 3 * torque + 2 * rest  # omega_k/omega_n is the product of this and the later ratios
            rows += [(1.0, pinion), (build.webbed_mass * build.webbed_inertia, pinion + 2 * own)]
        else:
            ends = (0.5 if k == 0 else 0.0), (0.5 if k == stages - 1 else 0.0)
            rows += [(0.5 + ends[0], torque / 3), (0.5 + ends[1], torque / 3 + own)]
    return np.array([(factor, *powers) for factor, powers in rows])


def _least(terms: Values, total: float, stages: int, low: float, high: float) -> tuple[Values, tuple[int, ...]]:
    """Logarithms of the best stage ratios, and the stages at a limit.

    The minimum lies inside or on a face of the box of limits. All faces are tried, that of no limit first: it is the
    best of all if it keeps within them.
    """
    best: tuple[float, Values, tuple[int, ...]] | None = None
    for sides in sorted(product((None, low, high), repeat=stages), key=lambda s: sum(e is not None for e in s)):
        free = np.array([side is None for side in sides])
        x = np.array([0.0 if side is None else side for side in sides])
        left = total - float(x.sum())
        if not free.any() and abs(left) > SETTLED:
            continue
        if free.any():
            x[free] = left / free.sum()
            x = _newton(terms, x, free)
        if np.any(x < low - SETTLED) or np.any(x > high + SETTLED):
            continue
        value = float(np.log(terms[:, 0] @ np.exp(terms[:, 1:] @ x)))
        if best is None or value < best[0] - SETTLED:
            best = value, x, tuple(int(k) for k in np.flatnonzero(~free))
        if free.all():
            break
    if best is None:
        raise AccuracyError("no split was found within the limits", where="split of the ratio", value=total)
    return best[1], best[2]


def _newton(terms: Values, x: Values, free: np.ndarray) -> Values:
    """Minimum of the logarithm of the sum over the ``free`` logarithms of ratios, their sum kept."""
    powers, count = terms[:, 1:], int(free.sum())
    if count < 2:
        return x

    def level(at: Values) -> float:
        return float(np.logaddexp.reduce(np.log(terms[:, 0]) + powers @ at))

    now = level(x)
    for _ in range(ITERATIONS):
        share = terms[:, 0] * np.exp(powers @ x - now)
        slope = share @ powers[:, free]
        bend = (powers[:, free] * share[:, None]).T @ powers[:, free] - np.outer(slope, slope)
        # the multiplier of the constant sum completes the system
        system = np.block([[bend, np.ones((count, 1))], [np.ones((1, count)), np.zeros((1, 1))]])
        step = np.zeros_like(x)
        step[free] = np.linalg.solve(system, np.append(-slope, 0.0))[:count]
        part, gain = 1.0, float(slope @ step[free])
        while (after := level(x + part * step)) > now + 1e-4 * part * gain + 1e-15 and part > 1e-6:
            part /= 2
        x, now = x + part * step, after
        if part * float(np.max(np.abs(step))) < SETTLED:
            return x
    return x
