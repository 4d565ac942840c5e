"""Error estimate of a kinematics result.

The formulas are exact, so what remains is rounding. It is measured, not guessed: the positions nearest to a
dead point and an even choice of the others are computed again in extended precision (64-bit mantissa), and
the largest difference, with a factor for the positions left out, is the estimate. The lengths of the groups are formed
again from the given points, too: near a dead point their rounding is amplified like any other. Where the platform has
no wider float it falls back to the rounding unit times the amplification of the dyads. Central differences
are compared with the exact derivatives the same way.

That takes the data as exact. Near a dead point their own last digit matters as much; it is told apart, see `lastdigit`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import SingularityError
from tmmcalc.core.numerics.extended import CHAIN, EPS, WIDER
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.assembly import coordinate
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.lastdigit import SENSITIVE, against, effects, in_full
from tmmcalc.linkage.results import ErrorEstimate, GroupQuality, Kinematics, LastDigit, Trace
from tmmcalc.linkage.trace import TURN, trace

CHOSEN = 24  # positions computed again
MARGIN = 4.0  # factor for the positions left out


def estimate(
    chain: Chain,
    x: Real,
    evaluate: Callable[[Real], Trace],
    weakest: Sequence[float] = (),
    centre: float | None = None,
) -> ErrorEstimate:
    """Estimate the error of ``evaluate``, a way to compute the trace, over the positions ``x`` (n,).

    ``weakest`` are input coordinates known to be the least regular ones, which a sample of ``x`` may miss. ``centre``
    is position 0 if it is a dead centre. Raises `SingularityError` where the wider float no longer assembles.
    """
    chosen = x[chosen_of(chain, x, weakest)]
    least = float(np.min(regularity_of(chain, chosen)))
    digit = last_digit(chain, chosen, centre) if least < SENSITIVE else None
    if not WIDER:
        k = 1 / least
        return ErrorEstimate(CHAIN * k, CHAIN * k**2, CHAIN * k**3, "amplification of the rounding unit", digit)
    exact = trace(in_full(chain), chosen.astype(np.longdouble))
    parted = np.flatnonzero(~np.isfinite(exact.r).all(axis=0))
    if len(parted):
        raise SingularityError(
            f"at {coordinate(chain, *chosen[parted].tolist())} a limit position is so near that a rounding decides "
            "whether the links meet",
            where="kinematics",
            remedy="keep further from it: a lesser range or travel",
        )
    return between(evaluate(chosen), exact, digit)


def centre_of(chain: Chain, kinematics: Kinematics) -> float | None:
    """The input coordinate of position 0 where it is a dead centre, which hangs on the metric."""
    if chain.mechanism.input.start is not None or not kinematics.outputs:
        return None
    return float(kinematics.x[0] - kinematics.phi[0])


def last_digit(chain: Chain, x: Real, centre: float | None = None) -> LastDigit:
    """What a unit in the last place of the metric and of the input coordinate does to the motion at ``x`` (n,)."""
    effect = effects(chain, x, lambda of, at: _kinds(trace(of, at)), centre)
    parts = [against(off, scale) for off, scale in zip(effect, _scales(_kinds(trace(chain, x))), strict=True)]
    position, velocity, acceleration = map(max, parts[::2], parts[1::2])
    return LastDigit(position, velocity, acceleration)


def between(found: Trace, exact: Trace, digit: LastDigit | None = None) -> ErrorEstimate:
    """The estimate from a trace and the same in extended precision."""
    told, truth = _kinds(found), _kinds(exact)
    parts = [_relative(*each) for each in zip(told, truth, _scales(truth), strict=True)]
    position, velocity, acceleration = (MARGIN * max(pair) for pair in zip(parts[::2], parts[1::2], strict=True))
    return ErrorEstimate(position, velocity, acceleration, "extended precision (64-bit mantissa)", digit)


def _kinds(of: Trace) -> list[Any]:
    """Positions, velocities, accelerations, each of points with prismatic joints (P + J, n) and of links (L, n).

    Angles are told by their unit vectors, which have no seam.
    """
    turns = np.empty(of.angle.shape, np.result_type(of.angle, np.complex64))
    np.cos(of.angle, out=turns.real)
    np.sin(of.angle, out=turns.imag)
    linear = (np.concatenate((points, joints)) for points, joints in ((of.r, of.s), (of.dr, of.ds), (of.ddr, of.dds)))
    return [each for pair in zip(linear, (turns, of.dangle, of.ddangle), strict=True) for each in pair]


def _scales(kinds: Sequence[Plane | Real]) -> list[float]:
    """What errors of these `_kinds` are relative to: the largest value of each, of links also what it is made from.

    A link that does not turn, or turns evenly, has rates that are rounding alone: they are made from the velocity of
    points over their distance, and from the square of the rate.
    """
    size, _, speed, turning, acceleration, second = map(_largest, kinds)
    rate = max(turning, speed / size if size else 0.0)
    return [size, 1.0, speed, rate, acceleration, max(second, rate * rate)]


def _largest(values: Plane | Real) -> float:
    return float(np.max(np.abs(values), initial=0.0))


def _relative(found: Plane, exact: Plane, scale: float) -> float:
    """Largest difference over the scale, never below the rounding of one operation."""
    return max(_largest(found - exact) / (scale or 1.0), EPS)


def regularity_of(chain: Chain, x: Real) -> Real:
    """Regularity of the least regular group at x (n,)."""
    return least_regularity(chain, chain.evaluate(x, order=0), len(x))


def least_regularity(chain: Chain, configuration: Configuration, n: int) -> Real:
    """The same (n,) of a configuration at n positions."""
    rows = [step.regularity(placed) for step, placed in zip(chain.steps, configuration.placed, strict=True)]
    return np.min([np.broadcast_to(row, n) for row in rows], axis=0) if rows else np.ones(n)


def chosen_of(chain: Chain, x: Real, weakest: Sequence[float]) -> NDArray[np.intp]:
    """Indices of the positions x (n,) of a chain that are computed again, see `choice`."""
    return choice(x, lambda coarse: regularity_of(chain, x[coarse]), weakest, turns=chain.turns)


def weakest_of(qualities: Sequence[GroupQuality]) -> list[float]:
    """Input coordinates where the groups are the least regular."""
    return [quality.regularity_at for quality in qualities if quality.regularity_at is not None]


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
