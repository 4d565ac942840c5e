"""Linear equations with whole coefficients, solved without rounding: rank, dependence and solution in one pass.

Rows come one after another, so that a dependent one can be told by those before it. Each row carries the combination
of the given rows that it is; a pivot row then reads ``pivot * w_c + (free unknowns) = combination of right sides``.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import gcd

from tmmcalc.core.records import record

Row = list[int]


@record
class Reduced:
    """Rows in reduced echelon form over n unknowns."""

    unknowns: int  # n
    basis: dict[int, Row]  # by pivot column: n coefficients, then the combination of the given rows
    dependent: dict[int, Row]  # by number of a row that those before it imply: 0 = this combination of rows

    @property
    def free(self) -> tuple[int, ...]:
        """Unknowns that the rows leave open, one for each degree of freedom."""
        return tuple(c for c in range(self.unknowns) if c not in self.basis)

    def undetermined(self) -> tuple[int, ...]:
        """All unknowns that are not determined: the free ones and those that depend on them."""
        free = self.free
        return tuple(c for c in range(self.unknowns) if c in free or any(self.basis[c][f] for f in free))

    def motions(self) -> tuple[tuple[Fraction, ...], ...]:
        """A basis of the solutions of the homogeneous system, one for each free unknown."""
        return tuple(tuple(self._in_motion(c, f) for c in range(self.unknowns)) for f in self.free)

    def _in_motion(self, c: int, free: int) -> Fraction:
        row = self.basis.get(c)
        return Fraction(-row[free], row[c]) if row else Fraction(int(c == free))

    def response(self, c: int, row: int) -> Fraction:
        """Value of a determined unknown for right side 1 of the row of this number and 0 of all others."""
        pivot = self.basis[c]
        return Fraction(pivot[self.unknowns + row], pivot[c])


def reduce(rows: Sequence[Sequence[int]], unknowns: int) -> Reduced:
    """Reduce rows of n whole coefficients.

    >>> reduced = reduce([[2, 3], [4, 6], [0, 1]], 2)
    >>> sorted(reduced.dependent), reduced.free, reduced.response(0, 2)
    ([1], (), Fraction(-3, 2))
    """
    basis: dict[int, Row] = {}
    dependent: dict[int, Row] = {}
    for i, given in enumerate(rows):
        row = [*given, *(int(i == k) for k in range(len(rows)))]
        for c, pivot in basis.items():
            row = _without(row, pivot, c)
        column = next((c for c in range(unknowns) if row[c]), None)
        if column is None:
            dependent[i] = row[unknowns:]
            continue
        for c, pivot in basis.items():
            basis[c] = _without(pivot, row, column)
        basis[column] = row
    return Reduced(unknowns, basis, dependent)


def _without(row: Row, pivot: Row, c: int) -> Row:
    """The row freed of unknown ``c`` by the pivot row, in lowest terms."""
    if not row[c]:
        return row
    a, b = pivot[c], row[c]
    combined = [a * x - b * y for x, y in zip(row, pivot, strict=True)]
    common = gcd(*combined)
    return [x // common for x in combined] if common > 1 else combined
