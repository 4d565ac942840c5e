"""A rule by plain logic: its table over all combinations of the truths of its constraints, and a short form of it.

The short form is a disjunction of conjunctions, or a conjunction of disjunctions where that has fewer words. Its
terms are prime implicants (Quine, McCluskey): none can lose a word, and none can be left out.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from tmmcalc.core.errors import UsageError
from tmmcalc.core.quantity import quantity
from tmmcalc.core.records import record
from tmmcalc.feasibility.rule import may_hold, names_of

MOST = 10  # names in a table, which has 2^10 rows
ALWAYS, NEVER = "always holds", "never holds"
Term = tuple[int, int]  # the names that it has, and those of them that hold, by their bits


@record
class TruthTable:
    """All combinations of n truths; in the first every constraint fails, the last name changes first."""

    rule: str = quantity("rule", "rule that combines the constraints")
    names: tuple[str, ...]  # (n,) of the rule, in its order
    states: NDArray[np.bool_]  # (2^n, n)
    holds: NDArray[np.bool_] = quantity("holds", "whether the rule holds")  # (2^n,)
    short: str = quantity("short_form", "the rule without what can be left out")
    now: int  # the row of the truths as they are

    @property
    def count(self) -> int:
        """Combinations in which the rule holds."""
        return int(self.holds.sum())


def truth_table(rule: str, truths: Mapping[str, bool]) -> TruthTable:
    """The table of a rule, with the row of these truths; raises `UsageError` for more than `MOST` names.

    >>> table = truth_table("a and (b or a) and not (c and not c)", {"a": True, "b": False, "c": True})
    >>> table.count, table.short, table.now
    (4, 'a', 5)
    """
    names = names_of(rule)
    if len(names) > MOST:
        raise UsageError(
            f"the rule has {len(names)} names: a table of {2 ** len(names)} combinations",
            where="--truth",
            value=len(names),
            limit=MOST,
            remedy=f"a table has {MOST} names at most: ask for a part of the rule, --set feasibility.rule=\"'...'\"",
        )
    count = 2 ** len(names)
    bits = len(names) - 1 - np.arange(len(names))
    states = (np.arange(count)[:, None] >> bits & 1).astype(bool)
    holds = may_hold(rule, {name: states[:, k] for k, name in enumerate(names)}, (count,))
    now = sum(int(truths[name]) << int(bit) for name, bit in zip(names, bits, strict=True))
    return TruthTable(rule, tuple(names), states, holds, _short(holds, names), now)


def _short(holds: NDArray[np.bool_], names: list[str]) -> str:
    """The shorter of both forms, in the words of rules."""
    if holds.all() or not holds.any():
        return ALWAYS if holds.all() else NEVER
    width = len(names)
    either = _cover(np.flatnonzero(holds).tolist(), width)
    both = [(care, care & ~value) for care, value in _cover(np.flatnonzero(~holds).tolist(), width)]
    if _words(both) < _words(either):
        return _joined(both, names, " or ", " and ")
    return _joined(either, names, " and ", " or ")


def _words(terms: list[Term]) -> int:
    return sum(care.bit_count() for care, _ in terms)


def _joined(terms: list[Term], names: list[str], inner: str, outer: str) -> str:
    parts = []
    for care, value in terms:
        bits = [(1 << (len(names) - 1 - k), name) for k, name in enumerate(names)]
        words = [name if value & bit else f"not {name}" for bit, name in bits if care & bit]
        bracket = inner == " or " and len(words) > 1 and len(terms) > 1
        parts.append(f"({inner.join(words)})" if bracket else inner.join(words))
    return outer.join(parts)


def _cover(rows: list[int], width: int) -> list[Term]:
    """Prime implicants that hold in these rows together and in no other; none of them is spare."""
    primes = sorted(_primes(rows, width), key=lambda term: (term[0].bit_count(), -term[0], -term[1]))
    covered = {term: {row for row in rows if row & term[0] == term[1]} for term in primes}
    chosen: list[Term] = []
    left = set(rows)
    while left:
        best = max(primes, key=lambda term: len(covered[term] & left))
        chosen.append(best)
        left -= covered[best]
    for term in list(chosen):
        others = set().union(*(covered[other] for other in chosen if other != term))
        if covered[term] <= others:
            chosen.remove(term)
    return sorted(chosen, key=lambda term: (-term[0], -term[1]))


def _primes(rows: list[int], width: int) -> set[Term]:
    """The implicants that cannot lose a word: those of a size are joined where they differ in one truth."""
    found: set[Term] = set()
    terms: set[Term] = {((1 << width) - 1, row) for row in rows}
    while terms:
        joined: set[Term] = set()
        used: set[Term] = set()
        for care, value in terms:
            for k in range(width):
                bit = 1 << k
                if care & bit and (care, value ^ bit) in terms:
                    joined.add((care ^ bit, value & ~bit))
                    used.add((care, value))
        found |= terms - used
        terms = joined
    return found
