"""Numbers that are drawn for variants: by integer arithmetic alone, so that a seed gives the same ones everywhere.

Every candidate has a stream of random words of its own, by the seed and its number: what one is depends on no other.
Values are ratios of integers, multiples of steps, in the units in which the spec writes their keys.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from tmmcalc.classroom.items import class_of
from tmmcalc.core.records import record
from tmmcalc.design.tables.checks.ranges import place_of
from tmmcalc.project.loader import refused
from tmmcalc.spec.findings import Finding
from tmmcalc.spec.units import UnitError, exact
from tmmcalc.spec.variants import given

if TYPE_CHECKING:
    from tmmcalc.classroom.tables.class_ import DrawnTable
    from tmmcalc.project import Spec
    from tmmcalc.spec.outline import Raw
    from tmmcalc.spec.phrases import Path
    from tmmcalc.spec.variants import Axis

MASK = 2**64 - 1
GAMMA = 0x9E3779B97F4A7C15  # by which states go on: 2^64 over the golden section, odd
MOST = 1_000_000  # values of one number

Value = Fraction


class Stream:
    """Random words of 64 bits by SplitMix64: G. L. Steele, D. Lea, C. H. Flood, Fast splittable generators, 2014."""

    def __init__(self, state: int) -> None:
        self._state = state & MASK

    @classmethod
    def of(cls, seed: int, number: int) -> Stream:
        """The stream of a candidate: its state is mixed of both, so that neighbours have nothing in common."""
        return cls(mixed(mixed(seed + GAMMA) + number))

    def word(self) -> int:
        """The next word.

        >>> Stream(1234567).word()
        6457827717110365317
        """
        self._state = (self._state + GAMMA) & MASK
        return mixed(self._state)

    def below(self, count: int) -> int:
        """A whole number from 0 to ``count`` - 1, each as likely: words that would favour some are passed over."""
        fair = 2**64 - 2**64 % count
        while (word := self.word()) >= fair:
            pass
        return word % count


def mixed(word: int) -> int:
    """A word whose bits depend on all bits of another one (the finalizer of SplitMix64)."""
    word &= MASK
    word = ((word ^ (word >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    word = ((word ^ (word >> 27)) * 0x94D049BB133111EB) & MASK
    return word ^ (word >> 31)


@record
class Drawn:
    """One number that variants have their own of."""

    axes: tuple[Axis, ...]  # of its keys, which get the same value
    unit: str  # in which values are; empty: as bare numbers of the spec
    low: Fraction  # least value, or least factor
    high: Fraction
    step: Fraction  # 0: values are listed
    among: tuple[Fraction, ...] = ()
    base: int | Fraction | None = None  # what factors multiply: a number drawn before by its place, or one in the unit
    scale: Fraction = Fraction(1)  # of the unit of a number drawn before, in this unit

    @property
    def key(self) -> str:
        """The key that it is told by."""
        return self.axes[0].key

    def drawn(self, stream: Stream, before: Sequence[Value]) -> Value | None:
        """A value, each as likely; None where no multiple of the step is between its limits."""
        if self.among:
            return self.among[stream.below(len(self.among))]
        first, count = self._steps(*self.limits(before))
        return (first + stream.below(count)) * self.step if count > 0 else None

    def limits(self, before: Sequence[Value]) -> tuple[Fraction, Fraction]:
        """Least and greatest value beside what is drawn before."""
        if self.among:
            return min(self.among), max(self.among)
        if self.base is None:
            return self.low, self.high
        base = before[self.base] * self.scale if isinstance(self.base, int) else self.base
        low, high = sorted((self.low * base, self.high * base))
        return low, high

    def _steps(self, low: Fraction, high: Fraction) -> tuple[int, int]:
        """The first multiple of the step within limits, and how many there are."""
        first, last = math.ceil(low / self.step), math.floor(high / self.step)
        return first, last - first + 1

    @property
    def count(self) -> int | None:
        """How many values there are; None where that depends on what is drawn before."""
        if self.among:
            return len(self.among)
        return None if isinstance(self.base, int) else self._steps(*self.limits(()))[1]


def drawn_of(spec: Spec, axes: Sequence[Axis]) -> tuple[Drawn, ...]:
    """What ``[[class.drawn]]`` of a spec asks for; ``axes`` are those of all its keys, in their order.

    Raises SpecError with all limits in another unit, numbers without a value, and those with too many.
    """
    found, faults, at = list[Drawn](), list[Finding](), 0
    written, tables = spec._written, class_of(spec).drawn
    assert written is not None
    for number, table in enumerate(tables):
        own = tuple(axes[at : at + len(table.of)])
        at += len(own)
        path: Path = ("class", "drawn", number)
        try:
            found.append(_drawn(table, own, found, written.document))
        except UnitError as error:
            unit = own[0].unit or own[0].si
            faults.append(Finding(path, str(error), f"write it in {unit}" if unit else "write numbers"))
            found.append(Drawn(own, unit, Fraction(1), Fraction(1), Fraction(1)))  # in its place, for those after it
            continue
        count = found[-1].count
        if count is not None and not 0 < count <= MOST:
            rule = f"{found[-1].key} has {'no value' if count <= 0 else f'more than {MOST} values'} between its limits"
            remedy = "write a smaller step, or wider limits" if count <= 0 else "write a larger step"
            faults.append(Finding(path, rule, remedy))
    if faults:
        raise refused(spec, faults)
    return tuple(found)


def _drawn(table: DrawnTable, axes: tuple[Axis, ...], before: Sequence[Drawn], document: Raw) -> Drawn:
    unit = axes[0].unit or axes[0].si
    if table.among is not None:
        among = tuple(sorted(exact(each, unit) for each in table.among))
        return Drawn(axes, unit, among[0], among[-1], Fraction(0), among)
    assert table.at_least is not None
    assert table.at_most is not None
    assert table.step is not None
    step = exact(table.step, unit)
    if table.times is None:
        return Drawn(axes, unit, exact(table.at_least, unit), exact(table.at_most, unit), step)
    low, high = exact(table.at_least, ""), exact(table.at_most, "")
    place = place_of(table.times[0], document)
    for at, each in enumerate(before):
        if any(place_of(axis.key, document) == place for axis in each.axes):
            scale = exact(f"1 {each.unit}", unit) if each.unit else Fraction(1)
            return Drawn(axes, unit, low, high, step, base=at, scale=scale)
    number, written = given(table.times[0], document)
    base = exact(f"{number!r} {written}", unit) if written else exact(number, unit)
    return Drawn(axes, unit, low, high, step, base=base)


@record
class Candidate:
    """What is drawn under one number: a value for each of the drawn numbers."""

    number: int  # from 0
    values: tuple[Value, ...]  # in the units of the drawn numbers; fewer where one has no value
    missing: str = ""  # the key of the first number that has no value beside those before it


def candidate(drawn: Sequence[Drawn], seed: int, number: int) -> Candidate:
    """What is drawn under a number."""
    stream, values = Stream.of(seed, number), list[Value]()
    for each in drawn:
        value = each.drawn(stream, values)
        if value is None:
            return Candidate(number, tuple(values), each.key)
        values.append(value)
    return Candidate(number, tuple(values))


def assignments(drawn: Sequence[Drawn], values: Sequence[Value]) -> tuple[str, ...]:
    """The overrides that make a variant: ``mechanism.links[id=1].points.A[0]="75 mm"``."""
    pairs = zip(drawn, values, strict=True)
    return tuple(axis.assignment(float(value)) for each, value in pairs for axis in each.axes)


def spans(drawn: Sequence[Drawn]) -> tuple[tuple[Fraction, Fraction], ...]:
    """Least and greatest value of each number, whatever is drawn before it."""
    found: list[tuple[Fraction, Fraction]] = []
    for each in drawn:
        lows, highs = (tuple(end[side] for end in found) for side in (0, 1))
        ends = (*each.limits(lows), *each.limits(highs))
        found.append((min(ends), max(ends)))
    return tuple(found)


def number_of_all(drawn: Sequence[Drawn]) -> int | None:
    """How many different candidates there are; None where that depends on what is drawn."""
    counts = [each.count for each in drawn]
    return None if None in counts else math.prod(count for count in counts if count is not None)
