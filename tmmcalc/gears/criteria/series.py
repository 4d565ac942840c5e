"""One train replaced by two in series (textbook 4.4.5.3, 4.6.3): all pairs of variants.

The first train drives the second one's wheel 1; both are reduced to the second one's output:

    J = J_I i_II^2 + J_II        M = M_I + M_II        D = max(D_I, D_II)        i = i_I i_II
"""

from __future__ import annotations

from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.gears.criteria.evaluate import Criteria, deviation
from tmmcalc.gears.criteria.speeds import Ratios, speeds
from tmmcalc.gears.exact import within
from tmmcalc.gears.model import Integers, Interval, ToothSets, Values

PAIRS = 1 << 20  # pairs of a block


@record
class Series:
    """Pairs of trains in series, n of them."""

    first: NDArray[np.intp]  # (n,) index of the variant of the first train
    second: NDArray[np.intp]  # (n,)
    # (n,)
    ratio: Values = quantity("i", "ratio of both, i = i_I i_II")
    mass: Values = quantity("mass[kg]", "mass of both")
    inertia: Values = quantity("inertia[kg*m^2]", "inertia reduced to the output of the second train")
    size: Values = quantity("size[m]", "the larger diameter around the pitch circles")
    envelope: Values  # [m]
    efficiency: Values = quantity("efficiency", "efficiency of both")
    error: Values = quantity("error", "relative deviation of the ratio")
    width_deviation: Values  # (n,)
    tried: int  # pairs in all

    def __len__(self) -> int:
        """Number of pairs."""
        return len(self.first)


def series(
    trains: tuple[ToothSets, ToothSets], criteria: tuple[Criteria, Criteria], nominal: Fraction, admitted: Interval
) -> Series:
    """All pairs of variants of two trains whose product of ratios is admitted, exactly (textbook 4.6.3).

    ``criteria`` are those of the two trains, each reduced to its own output; ``nominal`` and ``admitted`` are ratios
    i = i_I i_II with their sign. Raises `NoSolutionError` if no pair is admitted.
    """
    one, two = (speeds(each).exact("1") for each in trains)
    first, second = _admitted(one, two, admitted)
    if not len(first):
        raise NoSolutionError(
            f"none of {len(trains[0]) * len(trains[1])} pairs has a ratio from {float(admitted.low):g} to "
            f"{float(admitted.high):g}",
            where="trains in series",
            value=float(nominal),
            remedy="a wider tolerance of the product, or of the single trains",
        )
    whole = _product(one, two, first, second)
    a, b = criteria
    # of two trains that lock, the product of negative efficiencies would pass for a good one
    locking = a.locking[first] | b.locking[second]
    passed = a.efficiency[first] * b.efficiency[second]
    return Series(
        first,
        second,
        ratio=a.ratio[first] * b.ratio[second],
        mass=a.mass[first] + b.mass[second],
        inertia=a.inertia[first] * b.ratio[second] ** 2 + b.inertia[second],
        size=np.maximum(a.size[first], b.size[second]),
        envelope=np.maximum(a.envelope[first], b.envelope[second]),
        efficiency=np.where(locking, np.minimum(a.efficiency[first], b.efficiency[second]), passed),
        error=deviation(whole, nominal),
        width_deviation=np.maximum(a.width_deviation[first], b.width_deviation[second]),
        tried=len(trains[0]) * len(trains[1]),
    )


def _admitted(one: Ratios, two: Ratios, admitted: Interval) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Indices of the pairs whose product lies in the interval, block by block."""
    n, m = len(one.numerators), len(two.numerators)
    rows = max(PAIRS // max(m, 1), 1)
    found = [np.empty((0, 2), np.intp)]
    for start in range(0, n, rows):
        own = np.arange(start, min(start + rows, n))
        first, second = np.repeat(own, m), np.tile(np.arange(m), len(own))
        whole = _product(one, two, first, second)
        largest = int(whole.denominators.max(initial=1))
        inside = np.asarray(within(admitted, whole.numerators, whole.denominators, largest), bool)
        found.append(np.stack((first[inside], second[inside]), axis=1))
    pairs = np.concatenate(found)
    return pairs[:, 0], pairs[:, 1]


def _product(one: Ratios, two: Ratios, first: NDArray[np.intp], second: NDArray[np.intp]) -> Ratios:
    """Products of ratios; in 64 bits where the comparison with limits of the same terms fits, else without limit."""
    tops = [_peak(one.numerators), _peak(two.numerators)]
    bottoms = [_peak(one.denominators), _peak(two.denominators)]
    wide = tops[0] * tops[1] * bottoms[0] * bottoms[1] >= 1 << 61
    kind = object if wide else np.int64
    top = one.numerators[first].astype(kind) * two.numerators[second].astype(kind)
    bottom = one.denominators[first].astype(kind) * two.denominators[second].astype(kind)
    return Ratios(top, bottom)


def _peak(numbers: Integers) -> int:
    return int(abs(numbers).max(initial=1))
