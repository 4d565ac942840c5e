"""Which known mistakes explain the wrong answers of a student.

A mistake is weighed by what it predicts: the likelihood of the answers with it, over that without, times how common
it is. Without it a wrong answer comes of nothing known by half, else of poor accuracy or of a misreading. Where
answers are drawn of just that the mean of the odds, summed over all mistakes, is 1 at most, so by Markov's inequality
they are above a level in one table of so many, however many mistakes are tried. Where they come of nothing known
alone it is more, by 1.8 for each wrong answer at most, so the inequality bounds little, and the levels stand on what
is measured: chance meets a prediction of several answers by pairs, so the least that counts grows with the square of
how many are wrong, and random tables of one wrong answer or of many are explained in less than 1 %
(`tests/classroom/test_explaining.py`).

A mistake of a whole solution speaks against itself where an answer is not what it predicts; a misreading is made in one
answer, or in several. The best explanation is taken, and what it leaves open is explained by the next one.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.classroom.likelihood import COMPUTED, Array, Written, anything, computed, drawn
from tmmcalc.classroom.model import Item, Key, Told
from tmmcalc.classroom.verdicts import Standing
from tmmcalc.core.records import record

LEAST = (6.0, 8.0)  # odds that count where one or two answers are wrong: of who computes, of who works by plans
MOST = 4  # mistakes of one student
SHOWN = 0.8  # of the answers that a mistake of a whole solution changes are as it predicts
MISREAD = 0.15  # of these are misread besides
SHARES = (0.5, 0.9)  # of wrong answers that a repeated misreading is in; once is tried too
_WRONG = (0.5, 0.3, 0.2)  # of wrong answers come of nothing, of poor accuracy, of misreading


@record
class Explanation:
    """Mistakes that give equal numbers, one of which explains answers."""

    mistakes: tuple[int, ...]  # by place in the keybook, the likeliest first
    items: tuple[int, ...]  # whose answers are what comes of it
    against: tuple[int, ...]  # whose answers are not, though it changes them
    deviation: float  # greatest relative one of its items
    odds: float  # that numbers like these come of it and not of nothing, by what is common


_Places = NDArray[np.intp]
_Flags = NDArray[np.bool_]


class _Found(NamedTuple):
    explanation: Explanation
    predicted: Array  # (I,) with it
    usual: Array  # (I,) the same, and where answers are still open what it would give


def explain(
    items: Sequence[Item],
    told: Sequence[Told],
    key: Key,
    answers: tuple[Array, Array],
    standings: Sequence[Standing],
    carried: Array,
) -> tuple[Explanation, ...]:
    """The explanations of the wrong answers of a student, the most certain first.

    ``answers`` are values and halves of last figures (I,) in the units of the items, NaN without a number; ``carried``
    what would be right by the student's own values before (I,), NaN where that is nothing else.
    """
    if not told or Standing.wrong not in standings:
        return ()
    table = _Table(items, told, key, answers, standings, carried)
    found = list[Explanation]()
    while len(found) < MOST and (table.open.any() or not found):  # all may be carried on from one mistake
        best = max((table.whole(), table.single()), key=lambda each: each.explanation.odds if each else 0.0)
        if best is None or best.explanation.odds < table.level:
            break
        found.append(best.explanation)
        table.take(best)
    return tuple(found)


class _Table:
    """The answers of a student, and what is explained of them."""

    def __init__(
        self,
        items: Sequence[Item],
        told: Sequence[Told],
        key: Key,
        answers: tuple[Array, Array],
        standings: Sequence[Standing],
        carried: Array,
    ) -> None:
        open_sense = np.array([item.either_sense for item in items])
        values, halves = answers
        values, right, mistaken, carried = (
            np.where(open_sense, np.abs(each), each)
            for each in (values, np.array(key.values), np.array(key.mistaken, dtype=float), carried)
        )
        used = np.isfinite(values) & np.isfinite(right) & (values != 0) & (right != 0)
        self.places = np.flatnonzero(used)
        self.tolerance, self.within = (
            np.array(each)[used] for each in ([item.tolerance for item in items], [item.within for item in items])
        )
        self.right, self.carried = right[used], carried[used]
        self.written = Written(values[used], halves[used])
        self.ways = (COMPUTED, drawn(max(item.plans for item in items)))
        mistaken = mistaken[:, used]
        mistaken[np.abs(mistaken - self.right) <= 1e-9 * np.abs(self.right)] = np.nan
        self.mistaken = mistaken
        self.sole = np.array([each.single for each in told])
        self.common = np.array([each.common for each in told])
        for kind in (self.sole, ~self.sole):  # both kinds share what is likely
            self.common[kind] /= max(2 * self.common[kind].sum(), 1e-300)
        state = [standings[int(k)] for k in self.places]
        self.wrong = np.array([each is Standing.wrong for each in state])
        self.fine = np.array([each is Standing.right for each in state])
        self.predicted = self.usual = self.right
        self.left = self.common > 0  # mistakes that are not told yet
        self.nothing = anything(self.written, self.right)
        self.as_right = computed(self.written, self.right, self.ways)
        self.ratios = mistaken[self.sole] / self.right
        self.base = self._base()
        self.weights = self._weights()
        # still to be explained: neither carried on, nor off as it happens to somebody who works by plans
        poor = np.einsum("w,wi->i", self.weights, self.as_right) > self.nothing
        self.open = self.wrong & np.isnan(self.carried) & ~poor

    @property
    def level(self) -> float:
        """The least odds that count."""
        return max(float(self.weights @ LEAST), float(self.open.sum()) ** 2)

    def _base(self) -> Array:
        """Densities of the answers (W, I) before anything is explained."""
        misread = self._misread(self.right)
        wrong = _WRONG[0] * self.nothing + _WRONG[1] * self.as_right + _WRONG[2] * misread
        near = 0.5 * self.as_right + 0.5 * wrong
        carried = 0.5 * computed(self.written, self.carried, self.ways) + 0.5 * self.nothing
        wrong = np.where(np.isfinite(self.carried), carried, wrong)
        return np.where(self.fine, 0.98 * self.as_right + 0.02 * self.nothing, np.where(self.wrong, wrong, near))

    def _misread(self, predicted: Array) -> Array:
        """Densities (W, ..., I) where the value is misread once more."""
        common = self.common[self.sole]
        if not common.sum():
            return np.zeros((len(self.ways), *predicted.shape))
        spread = predicted[..., None, :] * self.ratios
        return np.einsum("w...si,s->w...i", computed(self.written, spread, self.ways), common / common.sum())

    def _weights(self) -> Array:
        """How the student works, by the right answers (W,)."""
        logs = np.log(np.where(self.fine, self.as_right, 1.0) + 1e-300).sum(axis=1)
        weights = np.exp(logs - logs.max())
        return weights / weights.sum()

    def whole(self) -> _Found | None:
        """The best mistake of a whole solution."""
        kind = np.flatnonzero(~self.sole & self.left)
        if not kind.size:
            return None
        predicted = self.mistaken[kind]
        changed = np.isfinite(predicted)
        # near enough to the right value to be right says nothing
        changed &= ~(self.fine & self._near(predicted, self.right))
        both = predicted * self.predicted / self.right  # on top of what is explained already
        shown = self._shown(predicted)
        base = np.maximum(self.base, 1e-300)[:, None, :]
        taken = ~np.isclose(self.predicted, self.right)
        shown = np.where(taken, 0.5 * shown + 0.5 * self._shown(both), shown)
        ratios = np.where(changed, SHOWN * shown / base + (1 - SHOWN), 1.0)
        odds = self._odds(ratios, kind)
        best = int(np.argmax(odds))
        value = np.where(taken & (self._off(both[best]) < self._off(predicted[best])), both[best], predicted[best])
        likelier = np.einsum("w,wi->i", self.weights, ratios[:, best]) > 1.0
        fits = changed[best] & (likelier | self._near(self.written.values, value, self.written.halves))
        return self._found(kind, best, odds, fits & self.wrong, changed[best] & ~fits, value)

    def _near(self, value: Array, other: Array, rounded: Array | float = 0.0) -> _Flags:
        """Whether values, rounded by so much, are others within what is allowed there."""
        return np.abs(value - other) - rounded <= np.maximum(self.tolerance * np.abs(other), self.within)

    def _shown(self, predicted: Array) -> Array:
        direct = computed(self.written, predicted, self.ways)
        return (1 - MISREAD) * direct + MISREAD * self._misread(predicted)

    def single(self) -> _Found | None:
        """The best misreading of single answers."""
        kind = np.flatnonzero(self.sole & self.left)
        if not kind.size:
            return None
        ratios_of = self.mistaken[kind] / self.right
        plain, on_top = self.right * ratios_of, self.usual * ratios_of
        density = 0.5 * computed(self.written, plain, self.ways) + 0.5 * computed(self.written, on_top, self.ways)
        ratios = np.where(self.open, density / self.nothing, 1.0)
        count = max(int(self.open.sum()), 1)
        tried = [np.where(self.open, 1 - share + share * ratios, 1.0) for share in (1 / count, *SHARES)]
        each = np.array([self._odds(ratio, kind) for ratio in tried])
        odds = each.mean(axis=0)
        best = int(np.argmax(odds))
        fits = self.open & (np.einsum("w,wi->i", self.weights, ratios[:, best]) > 1.0)
        value = np.where(self._off(on_top[best]) < self._off(plain[best]), on_top[best], plain[best])
        return self._found(kind, best, odds, fits, np.zeros_like(fits), value)

    def _odds(self, ratios: Array, kind: _Places) -> Array:
        """The mean over ways of working of products over answers (W, M, I), times how common each is."""
        logs = np.log(np.maximum(ratios, 1e-300)).sum(axis=-1)
        return np.einsum("w,wm->m", self.weights, np.exp(np.minimum(logs, 600.0))) * self.common[kind]

    def _off(self, predicted: Array) -> Array:
        """How far the answers are from what is predicted, as a part of it; infinite where nothing is."""
        with np.errstate(divide="ignore", invalid="ignore"):  # a mistake may give 0
            off = np.abs(self.written.values - predicted) / np.abs(predicted)
        return np.where(np.isfinite(off), off, np.inf)

    def _found(
        self, kind: _Places, best: int, odds: Array, fits: _Flags, against: _Flags, value: Array
    ) -> _Found | None:
        if not fits.any():
            return None
        own = self.mistaken[kind[best]]
        told = np.where(np.isfinite(own) & (fits | ~self.sole[kind[best]]), own, self.right)
        mine = np.where(np.isfinite(self.mistaken), self.mistaken, self.right)
        near = self._near(mine, told)
        spared = self.wrong if self.sole[kind[best]] else np.zeros_like(self.wrong)
        anywhere = ~fits & (self.sole[:, None] | spared)
        alike = (near | anywhere).all(axis=1) & self.left
        alike[kind[best]] = True
        sums = dict(zip(kind.tolist(), odds.tolist(), strict=True))
        order = sorted(np.flatnonzero(alike).tolist(), key=lambda m: (-sums.get(m, 0.0), m))
        misread = self._off(value) > 3 * self.tolerance  # on top of it, and told apart
        explanation = Explanation(
            tuple(order),
            tuple(map(int, self.places[fits])),
            tuple(map(int, self.places[against])),
            float(np.max(np.where(fits & ~misread, self._off(value), 0.0))),
            sum(sums.get(m, 0.0) for m in order),
        )
        predicted = np.where(fits, value, self.predicted)
        again = np.isfinite(own) & self.open & ~fits & (fits.sum() > 1)
        return _Found(explanation, predicted, np.where(again, own, predicted))

    def take(self, found: _Found) -> None:
        """Go on with what this explanation leaves open."""
        self.predicted, self.usual = found.predicted, found.usual
        self.left[list(found.explanation.mistakes)] = False
        near = computed(self.written, self.predicted, self.ways)
        done = np.isin(self.places, found.explanation.items)
        direct = done & (np.einsum("w,wi->i", self.weights, near) > np.einsum("w,wi->i", self.weights, self.base))
        self.base = np.where(direct, near, self.base)
        self.open &= ~direct
