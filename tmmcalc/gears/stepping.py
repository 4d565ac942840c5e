"""The textbook's programs of synthesis: tooth numbers found by stepping through z or e (programs 1.8 to 1.10, 2.4).

They show the course's way and its tables. For given e and Z2' they keep only the greatest Z2 that the ratio admits
(4.17) and end an inner loop at the first planets that overlap, so that they find a part of what the complete search
finds. All arithmetic of tooth numbers is in integers and fractions.

Which of given sets a program would find is told without stepping: for given e and Z2' it keeps the greatest Z2 that the
ratio admits, so with one tooth more on wheel 2 and one less on wheel 1 the ratio would be beyond its upper limit.
Neighbours that overlap end the inner loop only where all further sets overlap too, so nothing else is passed over but
the e below and above the textbook's bounds.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import replace
from fractions import Fraction

import numpy as np

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.records import record
from tmmcalc.gears.bounds import half_pitch, most_planets, side, step_bounds, tips
from tmmcalc.gears.exact import within
from tmmcalc.gears.model import Integers, Interval, ToothSets, TrainTask
from tmmcalc.gears.scheme import layout_of
from tmmcalc.gears.split import exponents


@record
class Stepped:
    """Tooth sets in the order in which a program finds them."""

    sets: ToothSets
    step: Integers  # (n,) z of equal pinions, e of coaxial trains, Z1 of AIbar
    ratios: tuple[Fraction, ...]  # actual tooth ratios U (n,)
    common: Integers  # (n, meshes) greatest common divisors of the wheels in mesh

    @property
    def coprime(self) -> np.ndarray:
        """Whether no wheels in mesh have a common factor, (n,)."""
        return np.all(self.common == 1, axis=1)


Row = tuple[int, tuple[int, ...], tuple[int, ...]]  # step, tooth numbers, proportion of modules


def stepped(task: TrainTask, most: int | None = None) -> Stepped:
    """The tooth sets that the textbook's program for this layout finds, the first ``most`` of them.

    Raises `UsageError` for a layout without a program, `NoSolutionError` for planets that overlap whatever the teeth.
    """
    if task.layout not in PROGRAMS:
        raise UsageError(
            f"the textbook has no program for layout {task.layout!r}",
            where="stepping",
            remedy=f"layouts: {', '.join(PROGRAMS)}",
        )
    rows: list[Row] = []
    for row in PROGRAMS[task.layout](task):
        if len(rows) == most:
            break
        rows.append(row)
    return _table(task, rows)


def equal_pinions(task: TrainTask, pinions: Iterable[int]) -> Stepped:
    """All rows of program 1.8 for these pinions, those outside the tolerance too (textbook table 4.2)."""
    return _table(task, _unfolded(task, pinions))


def wheel_of(pinion: int, ratio: Fraction, power: Fraction) -> int:
    """floor(z U^(p/q) + 1/2): the wheel of a stage, without rounding on the way.

    >>> wheel_of(17, Fraction("8.15"), Fraction(3, 5))
    60
    """
    p, q = power.numerator, power.denominator
    target = (2 * pinion) ** q * ratio**p

    def fits(wheel: int) -> bool:
        return (2 * wheel - 1) ** q <= target  # wheel - 1/2 <= z U^(p/q)

    wheel = math.floor(pinion * float(ratio) ** float(power) + 0.5)
    while not fits(wheel):
        wheel -= 1
    while fits(wheel + 1):
        wheel += 1
    return wheel


def _unfolded(task: TrainTask, pinions: Iterable[int]) -> Iterator[Row]:
    powers = exponents(task.scheme.stages)
    for z in pinions:
        wheels = (wheel_of(z, task.nominal, power) for power in powers)
        yield z, tuple(teeth for wheel in wheels for teeth in (z, wheel)), task.proportions[0]


def _within_tolerance(task: TrainTask) -> Iterator[Row]:
    """Program 1.8: equal pinions, wheels by the split of equal diameters, kept if the ratio is admitted (4.6)."""
    limits = task.limits
    for row in _unfolded(task, range(limits.least, limits.largest_pinion + 1)):
        if max(row[1]) > limits.largest:
            return
        if task.ratio.low <= _ratio(task.layout, row[1]) <= task.ratio.high:
            yield row


def _single(task: TrainTask) -> Iterator[Row]:
    """Program 1.10: Z1 upward, Z3 downward; coaxiality, assembly, neighbourhood (4.24 to 4.30)."""
    limits, ratio = task.limits, task.ratio
    for sun in range(_first_sun(task), limits.largest + 1):
        smallest = math.ceil(ratio.low * sun)
        if smallest > limits.largest_ring:
            return
        for ring in range(math.floor(ratio.high * sun), smallest - 1, -1):
            planet = (ring - sun) // 2
            if (ring - sun) % 2 or not _assembles(task, (sun, planet, ring)):
                continue
            if _admitted(task, (sun, planet), ring, planet) and _clear(task, sun + planet, planet):
                yield sun, (sun, planet, ring), task.proportions[0]


def _first_sun(task: TrainTask) -> int:
    """Least sun worth trying by (4.33): Z1 (s + 1 - U (1 - s)) > 2 tips at the least ratio admitted."""
    gap = tips(task)
    if gap is None:
        return task.limits.least
    s, u = half_pitch(task.planets), float(task.ratio.low)
    room = s + 1 - u * (1 - s)
    if room <= 0:
        raise NoSolutionError(
            f"{task.planets} planets overlap in a train AIbar of U = {u:g} and more",
            where="stepping",
            value=u,
            limit=(1 + s) / (1 - s),
            remedy=f"K = {most_planets(u)} at most, or a smaller ratio",
        )
    return max(task.limits.least, math.floor(2 * gap / room))


def _double(task: TrainTask) -> Iterator[Row]:
    """Programs 1.9 and 2.4: e and Z2' upward, the greatest Z2 of the ratio (4.16, 4.17)."""
    for proportion in task.proportions:
        mu1, mu2 = proportion
        first, last = _first_and_last(task, (mu1, mu2))
        for e in range(first, last + 1):
            for teeth in _inner(task, e * mu2, e * mu1):
                yield e, teeth, proportion


def _first_and_last(task: TrainTask, proportion: tuple[int, int]) -> tuple[int, int]:
    """The first and the last e of the programs 1.9 and 2.4."""
    bounds = step_bounds(task, proportion)
    # 1.9 begins with the bound rounded up, 2.4 with the integer part of the larger one and one more
    first = math.ceil(bounds.teeth.root)
    if bounds.neighbours_book is not None:
        first = math.floor(max(bounds.teeth.root, bounds.neighbours_book.root)) + 1
    # beyond the textbook's largest e, Z2' above its least leaves room for external wheels 3
    return first, math.floor(bounds.largest if side(task) > 0 else 2 * task.limits.largest / proportion[0])


def _inner(task: TrainTask, sum1: int, sum2: int) -> Iterator[tuple[int, int, int, int]]:
    """The loop over Z2' for given sums Z1 + Z2 and Z3 -+ Z2'."""
    low, high, sign = task.ratio.low, task.ratio.high, side(task)
    for pinion in range(task.limits.least, task.limits.largest + 1):
        last = sum2 + sign * pinion
        if last < 1:
            return
        wheel = sum1 * high.numerator * pinion // (high.numerator * pinion + high.denominator * last)
        sun = sum1 - wheel
        if sun < task.limits.least:
            return
        teeth = (sun, wheel, pinion, last)
        if wheel * last < low * sun * pinion or not _admitted(task, teeth[:3], last, pinion):
            continue
        if not _assembles(task, teeth):
            continue
        if not (_clear(task, sum1, wheel) and _clear(task, sum2, pinion)):
            return  # a larger Z2' makes both worse
        yield teeth


def _admitted(task: TrainTask, external: tuple[int, ...], last: int, mate: int) -> bool:
    """Whether the tooth numbers keep their limits; the last wheel is a ring or external, ``mate`` meshes with it."""
    limits = task.limits
    if not task.scheme.rings:
        external = (*external, last)
    elif not limits.least_ring <= last <= limits.largest_ring or last - mate < (task.demands.ring_difference or 0):
        return False
    return all(limits.least <= teeth <= limits.largest for teeth in external)


def _assembles(task: TrainTask, teeth: tuple[int, ...]) -> bool:
    """Whether K equally spaced planets fit in (4.25, 4.26)."""
    if not task.demands.assembly or task.planets == 1:
        return True
    assert task.scheme.assembly is not None
    terms = task.scheme.assembly(dict(zip(task.scheme.wheels, teeth, strict=True)), task.planets)
    return all(numerator % denominator == 0 for numerator, denominator in terms)


def _clear(task: TrainTask, total: int, planet: int) -> bool:
    """Whether neighbours on a circle of radius ``total``/2 modules keep their distance (4.27, 4.28)."""
    gap = tips(task)
    return gap is None or total * half_pitch(task.planets) > planet + float(gap)


def _ratio(layout: str, teeth: tuple[int, ...]) -> Fraction:
    """Tooth ratio U."""
    scheme = layout_of(layout)
    return Fraction(*scheme.tooth_ratio(dict(zip(scheme.wheels, teeth, strict=True))))


def _table(task: TrainTask, rows: Iterable[Row]) -> Stepped:
    found = list(rows)
    scheme = task.scheme
    teeth = np.array([row[1] for row in found], np.int64).reshape(-1, len(scheme.wheels))
    proportions = [row[2] or (0,) * scheme.stages for row in found]
    modules = np.array(proportions, np.int64).reshape(-1, scheme.stages)
    angles = np.full((len(found), len(scheme.meshes)), task.pressure_angle)
    meshing = [np.gcd(teeth[:, scheme.index(m.first)], teeth[:, scheme.index(m.second)]) for m in scheme.meshes]
    return Stepped(
        ToothSets(task.layout, teeth, modules, angles, task.planets),
        np.array([row[0] for row in found], np.int64),
        tuple(_ratio(task.layout, row[1]) for row in found),
        np.stack(meshing, axis=1),
    )


def found_by_textbook(task: TrainTask, sets: ToothSets) -> np.ndarray | None:
    """Whether the textbook's program for the layout finds each set (n,); None where it has none for the task."""
    if task.layout not in PROGRAMS or task.demands.largest_angle is not None:
        return None
    if task.scheme.single:
        return np.ones(len(sets), dtype=bool)
    if not task.scheme.branched:
        rows = {tuple(row) for row in stepped(task).sets.teeth.tolist()}
        return np.array([tuple(row) in rows for row in sets.teeth.tolist()], dtype=bool)
    found = np.zeros(len(sets), dtype=bool)
    for proportion in task.proportions:
        at = np.flatnonzero((sets.modules == proportion).all(axis=1))
        if len(at):
            part = replace(sets, teeth=sets.teeth[at], modules=sets.modules[at], angles=sets.angles[at])
            found[at] = _among_stepped(task, (proportion[0], proportion[1]), part)
    return found


def _among_stepped(task: TrainTask, proportion: tuple[int, int], sets: ToothSets) -> np.ndarray:
    """The same for coaxial, AA and AI with one proportion of modules."""
    e = (sets.of("1") + sets.of("2")) // proportion[1]
    first, last = _first_and_last(task, proportion)
    sun, wheel = sets.of("1") - 1, sets.of("2") + 1
    above = wheel * sets.of("3"), np.maximum(sun, 1) * sets.of("2'")
    admitted = within(Interval(Fraction(0), task.ratio.high), *above, int(above[1].max(initial=1)))
    found: np.ndarray = (e >= first) & (e <= last) & (~admitted | (sun < 1))
    return found


PROGRAMS = {
    "unfolded2": _within_tolerance,  # 1.8
    "unfolded3": _within_tolerance,
    "coaxial": _double,  # 1.9
    "AIbar": _single,  # 1.10
    "AA": _double,  # 2.4
    "AI": _double,
}
