"""Error estimate of a kinematics result.

The formulas are exact, so what remains is rounding. It is measured, not guessed: the positions nearest to a
dead point and an even choice of the others are computed again in extended precision (64-bit mantissa), and
the largest difference, with a factor for the positions left out, is the estimate. Where the platform has no
wider float it falls back to the rounding unit times the amplification of the dyads. Central differences
are compared with the exact derivatives the same way.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.numerics.extended import CHAIN, EPS, WIDER
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.results import ErrorEstimate, Trace
from tmmcalc.linkage.trace import TURN, trace

CHOSEN = 24  # positions computed again
MARGIN = 4.0  # factor for the positions left out
SHARED = 2.0  # the constants of loops are rounded to double precision before either: as much again is not seen


def estimate(chain: Chain, x: Real, evaluate: Callable[[Real], Trace], weakest: Sequence[float] = ()) -> ErrorEstimate:
    """Estimate the error of ``evaluate``, a way to compute the trace, over the positions ``x`` (n,).

    ``weakest`` are input coordinates known to be the least regular ones, which a sample of ``x`` may miss.
    """
    chosen = x[choice(x, lambda coarse: regularity_of(chain, x[coarse]), weakest, turns=chain.turns)]
    if not WIDER:
        k = float(np.max(1 / regularity_of(chain, chosen)))
        return ErrorEstimate(CHAIN * k, CHAIN * k**2, CHAIN * k**3, "amplification of the rounding unit")
    margin = MARGIN * (SHARED if chain.branches else 1.0)
    return between(evaluate(chosen), trace(chain, chosen.astype(np.longdouble)), margin)


def between(found: Trace, exact: Trace, margin: float = MARGIN) -> ErrorEstimate:
    """The estimate from a trace and the same in extended precision."""
    return ErrorEstimate(
        margin * _relative(found.r, exact.r),
        margin * _relative(found.dr, exact.dr),
        margin * _relative(found.ddr, exact.ddr),
        "extended precision (64-bit mantissa)",
    )


def _relative(found: Plane, exact: Plane) -> float:
    """Largest difference over the largest value, never below the rounding of one operation."""
    scale = float(np.max(np.abs(exact), initial=0.0))
    if scale == 0:
        return EPS
    return max(float(np.max(np.abs(found - exact))) / scale, EPS)


def regularity_of(chain: Chain, x: Real) -> Real:
    """Regularity of the least regular group at x (n,)."""
    return least_regularity(chain, chain.evaluate(x, order=0), len(x))


def least_regularity(chain: Chain, configuration: Configuration, n: int) -> Real:
    """The same (n,) of a configuration at n positions."""
    rows = [step.regularity(placed) for step, placed in zip(chain.steps, configuration.placed, strict=True)]
    return np.min([np.broadcast_to(row, n) for row in rows], axis=0) if rows else np.ones(n)


def choice(
    x: Real, regularity: Callable[[NDArray[np.intp]], Real], weakest: Sequence[float], *, turns: bool
) -> NDArray[np.intp]:
    """Indices of the least regular positions, of those next to the weakest places, and of an even spread.

    ``regularity`` tells that of some positions by their indices.
    """
    if len(x) <= CHOSEN:
        return np.arange(len(x))
    spread = np.linspace(0, len(x) - 1, CHOSEN // 2).astype(int)
    coarse = np.linspace(0, len(x) - 1, min(len(x), 720)).astype(int)
    worst = coarse[np.argsort(regularity(coarse))[: CHOSEN // 2]]
    next_to = [i for at in weakest for i in _nearest(x, at, turns=turns)]
    return np.array(sorted({*spread.tolist(), *worst.tolist(), *next_to}))  # np.unique would import numpy.ma, 10 ms


def _nearest(x: Real, at: float, *, turns: bool) -> range:
    """Indices of the position nearest to a coordinate and of its neighbours; of a crank in whichever turn."""
    middle = float(x[0] + x[-1]) / 2
    here = at - TURN * round((at - middle) / TURN) if turns else at
    i = int(np.argmin(np.abs(x - here)))
    return range(max(i - 1, 0), min(i + 2, len(x)))
