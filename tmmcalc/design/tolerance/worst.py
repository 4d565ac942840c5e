"""The worst case of results over all that varies: the corner that signs of derivatives tell, or else a search.

Places are numbers (n, v) of the unit cube: where every dimension stands between its ends (one number of those that are
wholly alike), at which part of a turn a pin rests, on which side a slider, or how large a clearance is whose side is
told; else clearances are the largest. The corner of a result is found by slopes
where one stands, again and again, so that the directions of pins settle too. Then slopes are taken at the corners and
at random places. Where some that matter have another sign than at the corner, the others stay there and the box of
these is searched: corners, quasi-random places, and steps from the best of them along every number. Where places lack
a result, or one of them outdoes the corners, that is the whole box.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.records import record
from tmmcalc.design.tolerance.sources import Clearance, Dimension, Sources, Values

Results = Callable[[Values], Values]  # places of the keys (n, k) -> results (n, m), NaN where there is none
Indices = NDArray[np.intp]
How = Literal["signs", "search", "none"]

STEP = 1e-3  # of a difference, as part of a range
MATTERS = 1e-6  # of all slopes times ranges: less is none
ROUNDS = 8  # of the way to a corner
SETTLED = 1e-9  # of the range of a result: a corner that adds less is the one
RANDOM = 12  # places at which signs are checked, beside the corners
CORNERS = 10  # numbers of which all corners are tried
PLACES, EACH = 2048, 32  # of a search, quasi-random: at most, and to a corner of the box
STARTS = 4  # of its steps
MOST_LOST = 256  # places without a result, after which a search goes no further: they take long
FIRST, LAST = 0.25, 1e-5  # length of the first and the last step


@record
class Worst:
    """The least and the largest value of a result, the places (k,) of the keys there, and how they were found.

    ``turned`` names the variables whose slope changes its sign, ``lost`` counts places of the box without a result.
    """

    least: float
    largest: float
    at_least: Values
    at_largest: Values
    how: How
    turned: tuple[str, ...]
    lost: int
    evaluations: int  # of all results together


class Box:
    """All that varies as numbers of the unit cube."""

    def __init__(self, sources: Sources, nominal: Values) -> None:
        self.sources, self.nominal = sources, nominal
        self.movers: list[tuple[Dimension, ...] | Clearance] = [
            tuple(each for each in sources.dimensions if each.alike and each.group == group) for group in sources.groups
        ]
        self.movers = [each for each in self.movers if each]
        self.movers += [(each,) for each in sources.dimensions if not each.alike]
        self.movers += sources.clearances
        self.turns = np.array([isinstance(each, Clearance) and each.pin for each in self.movers])
        self.names = [
            each.name if isinstance(each, Clearance) else each[0].group if each[0].alike else each[0].name
            for each in self.movers
        ]

    def keys(self, places: Values) -> Values:
        """Values (n, k) of the keys at places (n, v)."""
        found = np.tile(self.nominal, (len(places), 1))
        for at, each in enumerate(self.movers):
            if isinstance(each, Clearance):
                low = each.largest if each.drawn else each.radius.low
                radius = low + (each.largest - low) * places[:, at]
                found[:, list(each.keys)] += each.shift(places[:, at], radius)
                continue
            for one in each:
                first, last = one.ends
                found[:, one.key] += first + (last - first) * places[:, at]
        return found

    def kept(self, places: Values) -> Values:
        """Places in the cube: turns go on, the rest ends at its ends."""
        return np.where(self.turns, places % 1.0, np.clip(places, 0.0, 1.0))


class _Counted:
    """Results at places of a box, counted."""

    def __init__(self, results: Results, box: Box) -> None:
        self.results, self.box = results, box
        self.evaluations = self.lost = 0

    @property
    def cut(self) -> bool:
        """Whether too many places have no result for a search to go on."""
        return self.lost >= MOST_LOST

    def __call__(self, places: Values) -> Values:
        found = np.asarray(self.results(self.box.keys(places)), float)
        self.evaluations += len(places)
        self.lost += int((~np.isfinite(found)).any(axis=1).sum())
        return found

    def slopes(self, places: Values) -> Values:
        """Derivatives (n, v, m) by the numbers, of clearances by x and y: (n, v + clearances, m)."""
        box = self.box
        around, widths = [], []
        for at, each in enumerate(box.movers):
            if isinstance(each, Clearance):
                continue
            low, high = (np.clip(places[:, at] + step, 0.0, 1.0) for step in (-STEP, STEP))
            for end in (low, high):
                moved = places.copy()
                moved[:, at] = end
                around.append(box.keys(moved))
            widths.append(high - low)
        for each in box.sources.clearances:
            for key, scale in zip(each.keys, each.scale, strict=True):
                for step in (-STEP, STEP):
                    moved = box.keys(places)
                    moved[:, key] += step * each.largest * scale
                    around.append(moved)
                widths.append(np.full(len(places), 2 * STEP * each.largest))
        found = np.asarray(self.results(np.concatenate(around)), float).reshape(len(widths), 2, len(places), -1)
        self.evaluations += len(around) * len(places)
        return np.asarray((found[:, 1] - found[:, 0]) / np.array(widths)[:, :, None]).transpose(1, 0, 2)


def worst_cases(results: Results, sources: Sources, nominal: Values, seed: int) -> tuple[Worst, ...]:
    """Of all m results, in as few calls as can be; ``nominal`` (k,) are the keys."""
    box = Box(sources, nominal)
    counted = _Counted(results, box)
    ends, values = _corners(counted)
    rows = np.random.default_rng(np.random.SeedSequence(seed).spawn(1)[0])
    count = values.shape[1]
    places = np.concatenate([ends.reshape(-1, len(box.names)), rows.random((RANDOM, len(box.names)))])
    slopes = counted.slopes(places)
    at_places = counted(places)
    turned = [_turned(box, slopes[:, :, which]) for which in range(count)]
    found = []
    for which in range(count):
        lost = not np.isfinite(at_places[:, which]).all() or not np.isfinite(slopes[:, :, which]).all()
        sides = np.array([ends[0, which], ends[1, which]])
        best = np.array([values[0, which], values[1, which]])
        column = at_places[:, which]
        outdone = np.nanmin(column, initial=np.inf) < best[0] - SETTLED * abs(best[0]) or (
            np.nanmax(column, initial=-np.inf) > best[1] + SETTLED * abs(best[1])
        )
        how: How = "signs"
        if lost or outdone or not np.isfinite(best).all():
            how = "search"
            every = np.arange(len(box.names))
            sides, best = _searched(counted, which, np.stack([np.concatenate([places, sides])] * 2), every, seed)
        elif turned[which]:
            how = "search"
            free = np.array([box.names.index(name) for name in turned[which]])
            starts = np.repeat(sides[:, None], len(places), axis=1)
            starts[:, :, free] = places[:, free]
            sides, best = _searched(counted, which, np.concatenate([sides[:, None], starts], axis=1), free, seed)
        if not np.isfinite(best).all():
            how = "none"
        low, high = box.keys(sides)
        found.append((float(best[0]), float(best[1]), low, high, how, turned[which]))
    return tuple(Worst(*each, counted.lost, counted.evaluations) for each in found)


def _corners(counted: _Counted) -> tuple[Values, Values]:
    """Places (2, m, v) of the least and largest of every result by its slopes, and its value (2, m) there."""
    box = counted.box
    here = np.full((1, len(box.names)), 0.5)
    slopes = counted.slopes(here)
    count = slopes.shape[2]
    signs = np.repeat([-1.0, 1.0], count)  # what is sought, by rows of places
    which = np.tile(np.arange(count), 2)
    places = np.array([_corner(box, sign * slopes[0, :, at]) for sign, at in zip(signs, which, strict=True)])
    values = counted(places)[np.arange(2 * count), which]
    for _ in range(ROUNDS):
        slopes = counted.slopes(places)
        tried = np.array([_corner(box, sign * slopes[at, :, which[at]]) for at, sign in enumerate(signs)])
        found = counted(tried)[np.arange(2 * count), which]
        better = signs * (found - values) > SETTLED * np.abs(values)
        if not better.any():
            break
        places[better], values[better] = tried[better], found[better]
    return places.reshape(2, count, -1), values.reshape(2, count)


def _corner(box: Box, slope: Values) -> Values:
    """The place (v,) where a result with these slopes is largest."""
    found = np.zeros(len(box.movers))
    at = 0
    for number, each in enumerate(box.movers):
        if isinstance(each, Clearance):
            own = slope[at : at + 2]
            at += 2
            if each.along is None:
                found[number] = (np.arctan2(own[1], own[0]) / (2 * np.pi)) % 1.0 if np.isfinite(own).all() else 0.0
            else:
                found[number] = float(own @ np.array(each.along) > 0)
        else:
            found[number] = float(slope[at] > 0)
            at += 1
    return found


def _turned(box: Box, slopes: Values) -> tuple[str, ...]:
    """The variables whose slope (n, v) has both signs; of clearances where it turns by more than a right angle."""
    ranges = np.array([
        1.0 if not isinstance(each, Clearance) else each.largest
        for each in box.movers
        for _ in range(2 if isinstance(each, Clearance) else 1)
    ])  # fmt: skip
    moved = slopes * ranges
    least = MATTERS * np.nanmax(np.abs(moved).sum(axis=1), initial=0.0)
    names, at = [], 0
    for name, each in zip(box.names, box.movers, strict=True):
        own = moved[:, at : at + (2 if isinstance(each, Clearance) else 1)]
        if isinstance(each, Clearance) and each.along is not None:
            own = own @ np.array(each.along)[:, None]
        at += 2 if isinstance(each, Clearance) else 1
        reach = own[np.nanargmax(np.linalg.norm(own, axis=1))] if np.isfinite(own).all(axis=1).any() else own[0]
        along = own @ reach / (np.linalg.norm(reach) or 1.0)
        if (along < -least).any():
            names.append(name)
    return tuple(names)


def _searched(counted: _Counted, which: int, starts: Values, free: Indices, seed: int) -> tuple[Values, Values]:
    """The best places (2, v) for the least and the largest of a result, and its values (2,).

    ``starts`` (2, n, v) are tried first; the numbers ``free`` go through the box, the others stay as in the first.
    """
    box = counted.box
    ends, best = [], []
    steps = np.eye(len(box.names))[free]
    spread = _spread(len(free), seed)
    for sign, own in zip((-1.0, 1.0), starts, strict=True):
        further = np.tile(own[0], (len(spread), 1))
        further[:, free] = spread
        places = np.concatenate([own, further])
        values = counted(places)[:, which]
        good = np.argsort(np.where(np.isfinite(values), -sign * values, np.inf), kind="stable")[:STARTS]
        here, gain = places[good], sign * values[good]
        step = np.full(len(good), FIRST)
        while (step > LAST).any() and not counted.cut:
            moves = np.concatenate([steps, -steps])
            tried = box.kept(here[:, None, :] + step[:, None, None] * moves)
            found = sign * counted(tried.reshape(-1, len(box.names)))[:, which].reshape(len(good), -1)
            found = np.where(np.isfinite(found), found, -np.inf)
            at = found.argmax(axis=1)
            rows = np.arange(len(good))
            better = found[rows, at] > np.where(np.isfinite(gain), gain, -np.inf)
            here = np.where(better[:, None], tried[rows, at], here)
            gain = np.where(better, found[rows, at], gain)
            step = np.where(better, step, step / 2)
        top = int(np.argmax(np.where(np.isfinite(gain), gain, -np.inf)))
        ends.append(here[top])
        best.append(sign * gain[top])
    return np.array(ends), np.array(best)


def _spread(count: int, seed: int) -> Values:
    """Corners of the unit cube, all or as many as of so many numbers, and quasi-random places in it."""
    from scipy.stats.qmc import Sobol

    inner = Sobol(count, seed=np.random.default_rng(np.random.SeedSequence(seed).spawn(2)[1])).random(
        min(PLACES, EACH * 2**count)
    )
    if count <= CORNERS:
        corners: NDArray[np.floating] = (np.arange(2**count)[:, None] >> np.arange(count) & 1).astype(float)
    else:
        corners = np.round(inner[: 2**CORNERS])
    return np.concatenate([corners, inner])
