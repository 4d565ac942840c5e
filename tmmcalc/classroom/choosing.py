"""The choice of variants: candidates in their order, each taken that keeps all demands and is far from those before.

Nothing depends on how many are wanted: the first forty of fifty are those that forty would have been.
"""

from __future__ import annotations

import json
import math
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import chain, combinations
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmmcalc.batch.task import BROKEN, OK, Row
from tmmcalc.classroom import demands
from tmmcalc.classroom.demands import TIE, Refusal
from tmmcalc.classroom.draws import Candidate, assignments, candidate, number_of_all, spans
from tmmcalc.core.errors import NoSolutionError
from tmmcalc.core.records import record

if TYPE_CHECKING:
    from tmmcalc.batch.journal import Journal
    from tmmcalc.classroom.judging import Judge

Values = NDArray[np.floating[Any]]
Pair = tuple[str, str]  # an item, and a mistake that gives the right answer of it, by their names
Told = Callable[[int, str], None]  # variants that are chosen; what is being done

LOT = 256  # candidates whose linkage and forces are judged at once
MOST = 50_000  # candidates without a variant among them, after which there are hardly any more
DEAR = 400  # the same of those of which all stages were solved
PROBED = 16  # good candidates of which all mistakes are made before one is chosen
OFTEN = 1 / 4  # of them: a mistake that gives the right answer in so many is not avoided, but told
CLASHES = "clashes"  # mark of a row that holds the pairs of a candidate
TOLD = 4  # demands that an error tells


@record
class Chosen:
    """A variant: its candidate, the overrides that make it, the values of the items in the units of results."""

    candidate: Candidate
    assignments: tuple[str, ...]
    values: tuple[float, ...]


@record
class Choice:
    """What was chosen, and what was not."""

    chosen: tuple[Chosen, ...]
    tried: int  # candidates up to the last that was chosen, from the first of all on
    refused: dict[str, int]  # by demand, of those that were tried now
    unavoided: tuple[Pair, ...] | None  # mistakes that give the right answer in many; None: they were not looked for
    least: float  # distance of two variants, as `apart` counts it; NaN of a single one


class Sought(NamedTuple):
    """Which clashes are sought when it is known which are not avoided: one of the others, the likeliest first."""

    unavoided: tuple[Pair, ...]
    counts: Mapping[str, int]  # of the probed candidates those of which a mistake gave a right answer that is avoided

    def rank(self, mistake: str) -> int:
        """The place of a mistake: those before that were met more often."""
        return -self.counts.get(mistake, 0)


Clashes = Callable[[Sequence[Candidate], Sought | None], Mapping[int, Sequence[Pair]]]
"""Pairs of candidates by their numbers: of those that are sought one mistake's, if there are any; None: all."""


class _Judged(NamedTuple):
    """A candidate and what is known of it, before it is compared with those that are chosen."""

    candidate: Candidate
    refusal: Refusal | None  # by what it is, or by linkage and forces
    row: Row | None = None  # of all stages; None: they were not solved, as it is refused or near to another one
    pairs: Sequence[Pair] = ()  # mistakes that give a right answer, of one that is good


class Chooser:
    """The choice for a judge; ``taken`` are given out already, ``tried`` are the candidates up to the last of them."""

    def __init__(
        self,
        judge: Judge,
        seed: int,
        *,
        taken: Sequence[Candidate] = (),
        tried: int = 0,
        clashes: Clashes | None = None,
        unavoided: Sequence[Pair] | None = None,
        journal: Journal | None = None,
        told: Told = lambda done, words: None,
    ) -> None:
        self._judge, self._seed, self._first = judge, seed, tried
        self._clashes = clashes
        self._sought = None if unavoided is None else Sought(tuple(unavoided), {})
        self._journal, self._told = journal, told
        rows = [*journal.rows()] if journal is not None else []
        self._known = {row.point: row for row in rows if row.alone != CLASHES}
        self._known_pairs: dict[int, Sequence[Pair]] = {
            row.point: _pairs_in(row.reason) for row in rows if row.alone == CLASHES
        }
        self._done = 0
        self._spans = np.array([float(high - low) or 1.0 for low, high in spans(judge.drawn)])
        self._apart = float(judge.table.apart)
        self._places: list[Values] = [self._place(each) for each in taken]
        self._seen = {candidate(judge.drawn, seed, number).values for number in range(tried)}

    def choose(self, wanted: int) -> Choice:
        """So many further variants.

        Raises NoSolutionError where there are hardly so many, with the demand that most candidates do not keep.
        """
        chosen: list[Chosen] = []
        refused, refusals = Counter[str](), dict[str, Refusal]()
        tried, since, dear = self._first, 0, 0
        for each in self._probed() if wanted else ():
            refusal, values = self._decided(each)
            if refusal is None:
                own = each.candidate
                chosen.append(Chosen(own, assignments(self._judge.drawn, own.values), values))
                self._places.append(self._place(own))
                tried, since, dear = own.number + 1, 0, 0
                self._done = len(chosen)
                if len(chosen) == wanted:
                    break
                continue
            if refusal != demands.again():  # it is no further candidate
                refused[refusal.demand] += 1
                refusals.setdefault(refusal.demand, refusal)
            since, dear = since + 1, dear + (each.row is not None and not self._is_near(each.candidate))
            if since > MOST or dear > DEAR:
                break
        if len(chosen) < wanted:
            raise _scarce(len(chosen), wanted, refused, refusals)
        unavoided = None if self._sought is None else self._sought.unavoided
        return Choice(tuple(chosen), tried, dict(refused.most_common()), unavoided, self._least())

    def _probed(self) -> Iterator[_Judged]:
        """All candidates, judged; which clashes are not avoided is found by the first good ones before."""
        every = self._judged()
        if self._clashes is None or self._sought is not None:
            yield from every
            return
        first: list[_Judged] = []
        good: list[_Judged] = []
        since = dear = 0  # since the last good one
        for each in every:
            first.append(each)
            since, dear = since + 1, dear + (each.row is not None)
            if each.row is not None and self._judge.verdict(each.row).refusal is None:
                good.append(each)
                since = dear = 0
            if len(good) == PROBED or since > MOST or dear > DEAR:
                break
        counts = Counter(pair for each in good for pair in {*each.pairs})
        unavoided = tuple(sorted(pair for pair, count in counts.items() if count >= OFTEN * len(good)))
        met = Counter(pair[1] for each in good for pair in {*each.pairs}.difference(unavoided))
        self._sought = Sought(unavoided, met)
        yield from chain(first, every)

    def _decided(self, each: _Judged) -> tuple[Refusal | None, tuple[float, ...]]:
        """Why a candidate is refused, or the values of its items. What costs least is asked first."""
        if each.candidate.missing or each.refusal == demands.again():
            return each.refusal, ()
        if self._is_near(each.candidate):
            return demands.near(self._apart), ()
        if each.refusal is not None:
            return each.refusal, ()
        assert each.row is not None
        verdict = self._judge.verdict(each.row)
        if verdict.refusal is not None or self._clashes is None:
            return verdict.refusal, verdict.values
        sought = self._sought
        assert sought is not None
        others = [pair for pair in each.pairs if pair not in sought.unavoided]
        clash = min(others, key=lambda pair: sought.rank(pair[1]), default=None)
        return (None if clash is None else demands.clashing(*clash)), verdict.values

    def _judged(self) -> Iterator[_Judged]:
        """Candidates in their order; of those that linkage and forces leave all stages are solved, some at a time."""
        width = 1 if self._judge.processes == 1 else 2 * self._judge.processes
        most = number_of_all(self._judge.drawn)
        first = self._first
        while most is None or len(self._seen) < most:
            lot = [self._drawn(number) for number in range(first, first + LOT)]
            first += LOT
            cheap = self._judge.at_once([each.candidate for each in lot if each.refusal is None])
            ready: list[_Judged] = []
            waiting: list[Candidate] = []
            for each in lot:
                own = self._cheaply(each, cheap)
                ready.append(own)
                if own.refusal is None and not self._is_near(own.candidate):
                    waiting.append(own.candidate)
                if len(waiting) == width or each is lot[-1]:
                    rows = self._rows(waiting)
                    pairs = self._pairs(waiting, rows)
                    self._told(self._done, f"of {own.candidate.number + 1} candidates")
                    for one in ready:
                        number = one.candidate.number
                        yield one._replace(row=rows.get(number), pairs=pairs.get(number, ()))
                    ready, waiting = [], []

    def _drawn(self, number: int) -> _Judged:
        """What is drawn under a number, refused where that is no candidate, or the same as one before."""
        own = candidate(self._judge.drawn, self._seed, number)
        if own.missing:
            return _Judged(own, demands.missing(own.missing))
        if own.values in self._seen:
            return _Judged(own, demands.again())
        self._seen.add(own.values)
        return _Judged(own, None)

    def _cheaply(self, each: _Judged, cheap: dict[int, Refusal | None]) -> _Judged:
        """With what linkage and forces say; one that could not be solved with the others is solved now."""
        own = each.candidate
        if each.refusal is not None or self._is_near(own):
            return each
        if own.number not in cheap:
            cheap = self._judge.at_once([own], alike=False)
        return each._replace(refusal=cheap[own.number])

    def _rows(self, candidates: Sequence[Candidate]) -> dict[int, Row]:
        """All stages of some candidates, by the journal where it has them."""
        found = {each.number: self._known[each.number] for each in candidates if each.number in self._known}
        for row in self._judge.whole([each for each in candidates if each.number not in found]):
            found[row.point] = row
            if self._journal is not None and row.status != BROKEN:
                self._journal.append([row])
        return found

    def _pairs(self, candidates: Sequence[Candidate], rows: Mapping[int, Row]) -> dict[int, Sequence[Pair]]:
        """Mistakes that give a right answer, of those candidates that are good; by the journal where it has them."""
        if self._clashes is None:
            return {}
        good = [each for each in candidates if self._judge.verdict(rows[each.number]).refusal is None]
        fresh = [each for each in good if each.number not in self._known_pairs]
        for number, pairs in (self._clashes(fresh, self._sought) if fresh else {}).items():
            self._known_pairs[number] = pairs
            if self._journal is not None:
                self._journal.append([Row(number, OK, json.dumps([*pairs]), alone=CLASHES)])
        return {each.number: self._known_pairs[each.number] for each in good}

    def _place(self, each: Candidate) -> Values:
        """A candidate in the box of all values, as parts of their ranges."""
        return np.array([float(value) for value in each.values]) / self._spans

    def _is_near(self, each: Candidate) -> bool:
        """Whether a candidate is nearer to one that is chosen than variants may be."""
        if not self._places:
            return False
        off = np.mean(np.abs(np.array(self._places) - self._place(each)), axis=1)
        return bool(off.min() < self._apart * (1 - TIE))

    def _least(self) -> float:
        """The least distance of two variants, the mean over the drawn numbers of parts of their ranges."""
        pairs = combinations(self._places, 2)
        return min((float(np.mean(np.abs(one - other))) for one, other in pairs), default=math.nan)


def _pairs_in(text: str) -> list[Pair]:
    return [(item, mistake) for item, mistake in json.loads(text)]


def _scarce(found: int, wanted: int, refused: Counter[str], refusals: dict[str, Refusal]) -> NoSolutionError:
    """The error of too few variants: which demands remove how many, and what may be done for the first of them."""
    removed = refused.total()
    told = [f"{count} by {demand}" for demand, count in refused.most_common(TOLD)]
    if len(told) == 1:
        told = [f"by {demand}" for demand in refused]
    more = f", {len(refused) - TOLD} further demands" if len(refused) > TOLD else ""
    most = refusals[refused.most_common(1)[0][0]] if refused else None
    example = f" (such as: {most.reason})" if most is not None and most.reason else ""
    return NoSolutionError(
        f"{found} of {wanted} variants keep all demands; of {found + removed} candidates {removed} are refused"
        f"{': ' if len(told) > 1 else ' '}{', '.join(told)}{more}{example}".rstrip(),
        where="class",
        value=found,
        limit=wanted,
        remedy=most.remedy if most is not None else "widen the ranges, or draw more numbers",
    )
