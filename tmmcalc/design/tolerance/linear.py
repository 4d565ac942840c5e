"""What derivatives tell of tolerances: mean, sigma, worst case, and the share of every source in the variance."""

from __future__ import annotations

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.design.differences import Slope
from tmmcalc.design.tolerance.sources import Clearance, Sources, Values


@record
class Linear:
    """Of m results with n parts that vary; NaN of a result that has no derivative."""

    mean: Values  # (m,)
    sigma: Values  # (m,)
    least: Values  # (m,) worst case below
    largest: Values  # (m,) worst case above
    shares: Values  # (m, n) of the variance; each row sums to 1, or is 0 where nothing varies


def straight(found: Slope) -> float:
    """The derivative by which a straight line stands for a result: of a kink the middle of both; NaN: there is none."""
    return (found.left + found.right) / 2 if found.side == "kink" else found.value


def linear(sources: Sources, nominal: Values, slopes: Values) -> Linear:
    """Of results ``nominal`` (m,) with derivatives ``slopes`` (m, k) by keys.

    sigma^2 = sum over parts of S C S^T; worst case: the sum of |S| T, of dimensions made alike |sum of S T|, of a pin
    the length of its slope.
    """
    variances = np.einsum("mi,pij,mj->mp", slopes, sources.covariances(), slopes)
    total = variances.sum(axis=1)
    ends = [ends_of(sources, slope) for slope in slopes]
    return Linear(
        nominal + slopes @ sources.mean(),
        np.sqrt(total),
        nominal + np.array([low for low, _ in ends]),
        nominal + np.array([high for _, high in ends]),
        np.divide(variances, total[:, None], out=np.zeros_like(variances), where=total[:, None] > 0),
    )


def ends_of(sources: Sources, slope: Values) -> tuple[float, float]:
    """The least and the largest change of a linear result with derivatives (k,)."""
    low = high = 0.0
    alike: dict[str, list[float]] = {}
    for each in sources.dimensions:
        ends = [slope[each.key] * end for end in each.ends]
        if each.alike:
            both = alike.setdefault(each.group, [0.0, 0.0])
            both[0] += ends[0]
            both[1] += ends[1]
        else:
            low, high = low + min(ends), high + max(ends)
    for ends in alike.values():
        low, high = low + min(ends), high + max(ends)
    for pair in sources.clearances:
        least, largest = ends_of_play(pair, slope)
        low, high = low + least, high + largest
    return float(low), float(high)


def ends_of_play(pair: Clearance, slope: Values) -> tuple[float, float]:
    """The least and the largest change that a clearance makes."""
    own = slope[list(pair.keys)] * pair.scale
    if pair.along is None:
        reach = pair.largest * float(np.hypot(*own))
        return -reach, reach
    straight = float(own @ np.array(pair.along))
    ends = (-pair.largest if pair.sides else pair.radius.low) * straight, pair.largest * straight
    return min(ends), max(ends)
