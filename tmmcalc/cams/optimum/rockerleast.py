"""The least distance of the centres l0 of any sizes: a sequence of quadratic programs over l2, R0, r2 and l0.

    minimise l0   where all margins are at least 0, those of every panel of the turn by itself

Of every step the curvature is that of the margins that held the one before, weighted with what they cost. The step is
the best of all sets of constraints that may hold it; of it the part is taken that makes l0 with a penalty least.
"""

from __future__ import annotations

from functools import cache
from itertools import combinations

import numpy as np

from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.optimum.rockersizes import NUMBERS, RockerScene, Sizes, judge_rocker
from tmmcalc.cams.task import Optimum

NEAR = 3e-5  # of l0: step of the differences
REGION = 0.1  # of l0: longest step
PARTS_OF_STEP = 0.5 ** np.arange(12)  # of a step that are tried
STEPS = 60
STIFF = 1e-4, 1e3  # of the curvature that a step reckons with
NEAREST = 12  # margins that a step reckons with
MET = 1e-11  # margin that a step may miss
WORST = 1e14  # condition of the equations of a step
PAIRS = tuple(combinations(range(4), 2))
PENALTY = 10.0  # l0 for a margin of -1
GAIN = 1e-14  # of l0: what is less is none


def held(of: RockerScene, asked: Optimum, x: Values, rolls: bool = True) -> Values:
    """Margins (k, B) at sizes (4, B), on every panel of the turn apart, and those of the asked ranges.

    Without constraint 2 unless it ``rolls``. What is far from its limit everywhere alike is one for all.
    """
    found = judge_rocker(of, Sizes(*x), apart=True).margin
    found = found.reshape(len(NUMBERS), x.shape[1], -1).swapaxes(1, 2)
    rows = [*(found[:-1] if rolls else found[1:-1]), found[-1][:1]]
    for size, ends in ((x[0], asked.rocker_lengths), (x[3], asked.centre_distances)):
        if ends is not None:
            rows.append(np.stack((size / ends[0] - 1, 1 - size / ends[1])))
    return np.concatenate(rows)


def least_centres(of: RockerScene, asked: Optimum, starts: Values, rolls: bool = True) -> Values:
    """Sizes (4,) of the least l0 near those that are given (4, n), each of which should be all but feasible."""
    ends = [_descended(of, asked, x, rolls) for x in starts.T]
    return min(ends, key=lambda end: end[1])[0]


def _descended(of: RockerScene, asked: Optimum, x: Values, rolls: bool) -> tuple[Values, float]:
    """The end of the quadratic programming from x, and its l0 with a penalty."""
    price: Values = np.zeros(0)
    for _ in range(STEPS):
        value, slope, bend = _quadratic(of, asked, x, rolls)
        price = price if price.size else np.zeros(len(value))
        step, price = _best_step(value, slope, -np.einsum("k,kij->ij", price, bend))
        step *= min(1.0, REGION / max(float(np.max(np.abs(step))), 1e-300))
        merit, parts = _merit(x, value), PARTS_OF_STEP[:, None]
        tried = x + parts * step * x[3]
        tried = tried[np.all(tried > 0, axis=1)]
        merits = _merit(tried.T, held(of, asked, tried.T, rolls)) if len(tried) else np.array([np.inf])
        k = int(np.argmin(merits))
        if not merits[k] < merit * (1 - GAIN):
            break
        x = tried[k]
    return x, float(np.min(_merit(x, held(of, asked, x[:, None], rolls))))


def _merit(x: Values, value: Values) -> Values:
    """l0 (...) with a penalty of what margins (k, ...) are below 0."""
    found: Values = x[3] * (1 + PENALTY * np.maximum(0.0, -np.maximum(np.min(value, axis=0), -1.0)))
    return found


def _quadratic(of: RockerScene, asked: Optimum, x: Values, rolls: bool) -> tuple[Values, Values, Values]:
    """Margins (k,), their slopes (k, 4) and second derivatives (k, 4, 4) by sizes over l0."""
    one = np.eye(4)
    ways = np.concatenate((np.zeros((1, 4)), one, -one, [one[i] + one[j] for i, j in PAIRS]))
    found = held(of, asked, x[:, None] + NEAR * x[3] * ways.T, rolls)
    value, plus, minus = found[:, 0], found[:, 1:5], found[:, 5:9]
    bend = np.zeros((len(value), 4, 4))
    for n, (i, j) in enumerate(PAIRS):
        bend[:, i, j] = bend[:, j, i] = found[:, 9 + n] - plus[:, i] - plus[:, j] + value
    bend[:, range(4), range(4)] = plus + minus - 2 * value[:, None]
    return value, (plus - minus) / (2 * NEAR), bend / NEAR**2


def _best_step(value: Values, slope: Values, curved: Values) -> tuple[Values, Values]:
    """The step (4,) of least l0 in the quadratic task, and what it pays for every margin (k,).

    ``curved`` (4, 4) is made convex. Of few margins, to which that is added which the step falls short of most.
    """
    size, ways = np.linalg.eigh(curved)
    curved = (ways * np.clip(np.abs(size), *STIFF)) @ ways.T
    among = [int(np.argmin(value))]
    while True:
        own = np.array(among)
        step, pays = _step_among(value[own], slope[own], curved)
        left = value + slope @ step
        worst = int(np.argmin(left))
        if left[worst] >= -MET or worst in among or len(among) == NEAREST:
            break
        among.append(worst)
    price = np.zeros(len(value))
    price[own] = pays
    return step, price


def _step_among(value: Values, slope: Values, curved: Values) -> tuple[Values, Values]:
    """The same of few margins (m,): of all sets of one to four that may hold it one is right.

    Where they cannot be met at once the set that leaves least short is taken.
    """
    best, step, price = np.inf, np.zeros(4), np.zeros(len(value))
    for count in range(1, min(len(value), 4) + 1):
        sets = _sets(len(value), count)
        rows, short = slope[sets], value[sets]
        system = np.zeros((len(sets), 4 + count, 4 + count))
        system[:, :4, :4], system[:, :4, 4:], system[:, 4:, :4] = curved, -np.swapaxes(rows, 1, 2), rows
        right = np.concatenate((np.tile([0.0, 0.0, 0.0, -1.0], (len(sets), 1)), -short), axis=1)
        sound = np.linalg.cond(system) < WORST
        found = np.linalg.solve(system[sound], right[sound][..., None])[..., 0]
        if not len(found):
            continue
        left = np.minimum(np.min(value + found[:, :4] @ slope.T, axis=1), 0.0)
        pays = np.minimum(np.min(found[:, 4:], axis=1), 0.0)
        cost = found[:, 3] + np.einsum("ni,ij,nj->n", found[:, :4], curved, found[:, :4]) / 2
        cost += 1e3 * np.where(left < -MET, -left, 0.0) + np.where(pays < -MET, 1e3, 0.0)
        k = int(np.argmin(cost))
        if cost[k] < best:
            best, step, price = float(cost[k]), found[k, :4], np.zeros(len(value))
            price[sets[sound][k]] = np.maximum(found[k, 4:], 0.0)
    return step, price


@cache
def _sets(count: int, size: int) -> Indices:
    """All choices (n, size) of so many."""
    return np.array(list(combinations(range(count), size)), dtype=np.intp)
