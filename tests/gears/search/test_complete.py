"""The search is complete: brute force over all combinations of wheels finds the same sets, layout by layout."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

import pytest
from sparing import sparing

from tmmcalc.gears.exact import around
from tmmcalc.gears.kinds import from_tooth_ratio, to_tooth_ratio
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.model import Demands, Interval, Limits, TrainTask
from tmmcalc.gears.search.relaxation import nearest_ratio
from tmmcalc.gears.search.search import Synthesis, synthesise

SMALL = Limits(least=10, largest=22, largest_pinion=14, least_ring=20, largest_ring=38)
OF_LAYOUT = {
    "2A-AA": Limits(least=5, largest=20),
    "AII": Limits(least=12, largest=17, least_ring=30, largest_ring=44),
}
FREE = Demands(assembly=False, gap=None, ring_difference=None)
Found = list[tuple[tuple[int, ...], tuple[int, ...]]]


def task(layout: str, ratio: str, tolerance: str, *proportions: tuple[int, ...], demands: Demands = FREE) -> TrainTask:
    nominal = Fraction(ratio)
    within = around(nominal, Fraction(tolerance), relative=True)
    return TrainTask(layout, nominal, within, proportions, limits=OF_LAYOUT.get(layout, SMALL), demands=demands)


def rows(found: Synthesis) -> Found:
    return sorted(
        (tuple(parts), tuple(teeth))
        for parts, teeth in zip(found.sets.modules.tolist(), found.sets.teeth.tolist(), strict=True)
    )


def ranges(task: TrainTask) -> list[range]:
    limits, scheme = task.limits, task.scheme
    found = []
    for place, wheel in enumerate(scheme.wheels):
        if wheel in scheme.rings:
            found.append(range(limits.least_ring, limits.largest_ring + 1))
        elif not scheme.branched and place % 2 == 0:
            found.append(range(limits.least, limits.largest_pinion + 1))
        else:
            found.append(range(limits.least, limits.largest + 1))
    return found


def centre_distances(layout: str, z: dict[str, int], mu: tuple[int, ...]) -> list[int]:
    """Twice the reference centre distances that must be equal."""
    return {
        "coaxial": lambda: [mu[0] * (z["1"] + z["2"]), mu[1] * (z["2'"] + z["3"])],
        "AA": lambda: [mu[0] * (z["1"] + z["2"]), mu[1] * (z["2'"] + z["3"])],
        "AI": lambda: [mu[0] * (z["1"] + z["2"]), mu[1] * (z["3"] - z["2'"])],
        "II": lambda: [mu[0] * (z["1"] - z["2"]), mu[1] * (z["3"] - z["2'"])],
        "AIbar": lambda: [z["1"] + z["2"], z["3"] - z["2"]],
        "AII": lambda: [mu[0] * (z["1"] + z["2"]), mu[0] * (z["3"] - z["2"]), mu[1] * (z["4"] - z["2'"])],
        "2A-AA": lambda: [z["1"] + 2 * z["2"] + z["3"], z["3"] + z["4"]],
    }[layout]()


def ratio(layout: str, z: dict[str, int]) -> Fraction | None:
    if layout == "AIbar":
        return Fraction(z["3"], z["1"])
    if layout == "2A-AA":
        return Fraction(z["4"], z["1"])
    if layout == "AII":
        slip = 1 - Fraction(z["3"] * z["2'"], z["2"] * z["4"])
        return (1 + Fraction(z["3"], z["1"])) / slip if slip else None
    if layout == "unfolded3":
        return Fraction(z["2"] * z["3"] * z["4"], z["1"] * z["2'"] * z["3'"])
    return Fraction(z["2"] * z["3"], z["1"] * z["2'"])


def combinations(task: TrainTask) -> Iterator[tuple[tuple[int, ...], dict[str, int]]]:
    """Every combination of wheels within the tooth limits whose ratio is right."""
    for mu in task.proportions:
        for teeth in itertools.product(*ranges(task)):
            z = dict(zip(task.scheme.wheels, teeth, strict=True))
            found = ratio(task.layout, z)
            if found is not None and task.ratio.low <= found <= task.ratio.high:
                yield mu or (0,) * task.scheme.stages, z


BRANCHED = [
    ("coaxial", "3", ((1, 1), (2, 3))),
    ("AA", "51/50", ((1, 1), (3, 4))),
    ("AI", "3", ((1, 1), (2, 3))),
    ("II", "11/10", ((1, 1), (3, 4))),
    ("AIbar", "3", ((1,),)),
    ("AII", "-17", ((1, 1), (3, 4))),
    ("2A-AA", "2", ((1,),)),
]


@sparing("tolerance", ["0", "1/20", "3/10"], every=3)
@sparing(("layout", "nominal", "proportions"), BRANCHED, every=3)
def test_branched(layout: str, nominal: str, proportions: tuple[tuple[int, ...], ...], tolerance: str) -> None:
    work = task(layout, nominal, tolerance, *proportions)
    expected = sorted(
        (mu, tuple(z.values()))
        for mu, z in combinations(work)
        if len(set(sums := centre_distances(layout, z, mu))) == 1 and sums[0] > 0
    )
    found = synthesise(work)
    assert rows(found) == expected
    assert found.count == len(expected)
    assert bool(expected) or tolerance == "0"


@sparing(("layout", "nominal", "proportions"), BRANCHED, every=8)
def test_mesh_angles(layout: str, nominal: str, proportions: tuple[tuple[int, ...], ...]) -> None:
    largest = math.radians(30)
    work = task(layout, nominal, "1/10", *proportions, demands=replace(FREE, largest_angle=largest))
    closeness = math.cos(largest) / math.cos(math.radians(20))
    expected = sorted(
        (mu, tuple(z.values()))
        for mu, z in combinations(work)
        if min(sums := centre_distances(layout, z, mu)) >= closeness * max(sums) > 0
    )
    found = synthesise(work)
    assert rows(found) == expected
    assert len(expected) > len(synthesise(replace(work, demands=FREE)).sets)
    assert (found.sets.angles <= largest + 1e-12).all()


@pytest.mark.parametrize("equal", [True, False])
@pytest.mark.parametrize(("layout", "nominal"), [("unfolded2", "2.6"), ("unfolded3", "3")])
def test_unfolded(layout: str, nominal: str, equal: bool) -> None:
    steepest, band = Fraction(2), Fraction(1, 5)
    demands = Demands(stage_ratio=steepest, diameter_band=band, equal_pinions=equal)
    small = Limits(least=10, largest=18, largest_pinion=12)
    work = replace(task(layout, nominal, "1/50", (), demands=demands), limits=small)
    names = LAYOUTS[layout].wheels
    expected = []
    for mu, z in combinations(work):
        pinions, wheels = [z[name] for name in names[::2]], [z[name] for name in names[1::2]]
        ratios = [wheel / pinion for wheel, pinion in zip(wheels, pinions, strict=True)]
        alike = all(
            abs(ratios[k - 1] ** (1 / 3) * wheels[k] / wheels[k - 1] - 1) <= band for k in range(1, len(wheels))
        )
        if alike and all(1 <= u <= steepest for u in ratios) and (not equal or len(set(pinions)) == 1):
            expected.append((mu, tuple(z.values())))
    assert rows(synthesise(work)) == sorted(expected)
    assert expected


@pytest.mark.parametrize(("layout", "nominal", "proportions"), BRANCHED)
def test_every_combination_is_counted_once(layout: str, nominal: str, proportions: tuple[tuple[int, ...], ...]) -> None:
    demands = Demands(undercut=12, coprime=True)
    work = replace(task(layout, nominal, "1/5", *proportions, demands=demands), planets=3)
    found = synthesise(work)
    assert found.candidates == len(proportions) * math.prod(len(numbers) for numbers in ranges(work))
    assert found.candidates - sum(found.removed.values()) == found.count == len(found.sets)


def test_a_bounded_list_keeps_the_smallest_and_counts_all() -> None:
    nominal = Fraction("20")
    work = TrainTask("AI", nominal, around(nominal, Fraction("0.01"), relative=True), ((1, 1), (2, 3)), 3)
    whole, part = synthesise(work), synthesise(work, keep=100)
    assert part.count == whole.count > 1000
    assert not part.complete
    assert part.sets.teeth.tolist() == whole.sets.teeth.tolist()[:100]


@sparing("equal", [True, False], every=4)
@pytest.mark.parametrize(("layout", "nominal"), [("unfolded2", "2.6"), ("unfolded3", "3")])
def test_removals_of_unfolded_trains_are_those_of_the_order(layout: str, nominal: str, equal: bool) -> None:
    steepest = Fraction(7, 4)
    demands = Demands(stage_ratio=steepest, diameter_band=Fraction(1, 10), equal_pinions=equal)
    small = Limits(least=10, largest=20, largest_pinion=13)
    work = replace(task(layout, nominal, "1/20", (), demands=demands), limits=small)
    names = LAYOUTS[layout].wheels
    of_ratio = of_stages = total = 0
    for teeth in itertools.product(*ranges(work)):
        z = dict(zip(names, teeth, strict=True))
        pairs = [(z[names[k]], z[names[k + 1]]) for k in range(0, len(names), 2)]
        if equal and len({pinion for pinion, _ in pairs}) > 1:
            continue
        total += 1
        found = ratio(layout, z)
        if found is not None and work.ratio.low <= found <= work.ratio.high:
            of_ratio += 1
            of_stages += all(pinion <= wheel <= steepest * pinion for pinion, wheel in pairs)
    synthesis = synthesise(work)
    assert synthesis.candidates == total
    assert synthesis.removed == {
        "ratio": total - of_ratio,
        "stage_ratio": of_ratio - of_stages,
        "diameter_band": of_stages - synthesis.count,
    }


@sparing(
    ("layout", "kind", "asked", "proportions"),
    [
        ("AA", "i_1H", "-30", ((1, 1),)),
        ("AA", "i_H1", "-1/100", ((1, 1),)),
        ("AI", "i_1H", "100", ((1, 1), (2, 3))),
        ("II", "i_H1", "5.03", ((3, 4),)),
        ("AIbar", "i_1H", "4.9999", ((1,),)),
        ("AII", "i_14", "-17.003", ((1, 1), (3, 4))),
    ],
    every=3,
)
def test_the_nearest_ratios_are_the_nearest(
    layout: str, kind: str, asked: str, proportions: tuple[tuple[int, ...], ...]
) -> None:
    scheme, wanted = LAYOUTS[layout], Fraction(asked)
    nominal = to_tooth_ratio(scheme, kind, wanted)
    work = replace(task(layout, "1", "0", *proportions), nominal=nominal, ratio=Interval(nominal, nominal))
    every = []
    for _, z in combinations(replace(work, ratio=Interval(Fraction(-(10**9)), Fraction(10**9)))):
        found = ratio(layout, z)
        if found and any(len(set(sums := centre_distances(layout, z, mu))) == 1 and sums[0] > 0 for mu in proportions):
            own = from_tooth_ratio(scheme, kind, found)
            if own is not None and own * wanted > 0:
                every.append(own / wanted)
    for outward in (False, True):
        side = [part for part in every if (part > 1 if outward else part < 1)]
        change = nearest_ratio(work, kind, outward)
        if not side:
            assert change is None
            continue
        best = min(side) - 1 if outward else 1 - max(side)
        assert change is not None
        assert change.needed == pytest.approx(float(best), rel=1e-9)
