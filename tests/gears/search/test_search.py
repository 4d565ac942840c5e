"""Worked cases, exact borders, extreme ratios, and what opens an empty task."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sparing import sparing

from tmmcalc.gears.criteria.evaluate import ratio_error
from tmmcalc.gears.exact import around, at_least, at_most, fraction, within
from tmmcalc.gears.model import Demands, Interval, Limits, TrainTask
from tmmcalc.gears.search.measures import coprime_meshes, tooth_ratio
from tmmcalc.gears.search.relaxation import Relaxation, relaxations
from tmmcalc.gears.search.search import synthesise

CASES: dict[str, dict[str, Any]] = {
    case["id"]: case for case in json.loads((Path(__file__).parents[2] / "cases" / "gear-trains.json").read_text())
}


def task(layout: str, ratio: str, tolerance: str, *proportions: tuple[int, ...], relative: bool = True) -> TrainTask:
    nominal = Fraction(ratio)
    return TrainTask(layout, nominal, around(nominal, Fraction(tolerance), relative=relative), proportions)


def test_coaxial_case() -> None:
    case = CASES["GT-S04"]
    work = replace(task("coaxial", "8.15", "0.08", (2, 3), relative=False), limits=Limits(largest=100))
    found = synthesise(work)
    sums = found.sets.of("1") + found.sets.of("2")
    listed = found.sets.teeth[sums <= 3 * 33].tolist()
    assert sorted(listed) == sorted(row["z"] for row in case["expected"]["solutions_up_to_e_max"])
    assert found.count == case["expected"]["full_search_count"]
    assert np.count_nonzero(coprime_meshes(found.sets)) == case["expected"]["full_search_coprime_count"]


def test_coaxial_case_with_three_layshafts() -> None:
    expected = CASES["GT-S09"]["expected"]
    work = replace(task("coaxial", "8.15", "0.08", (2, 3), relative=False), limits=Limits(largest=120), planets=3)
    found = synthesise(work)
    assert (found.count, np.count_nonzero(coprime_meshes(found.sets))) == (
        expected["full_count"],
        expected["coprime_count"],
    )
    assert found.sets.teeth[:8].tolist() == expected["first_eight_by_sum"]


def test_single_planet_cases() -> None:
    expected = CASES["GT-S06"]["expected"]
    sets = synthesise(replace(task("AIbar", "6.29", "0.1", (1,), relative=False), planets=3)).sets
    listed = sets.teeth[sets.of("1") <= 26].tolist()
    assert listed == [row["z"] for row in expected["solutions"]]
    some = sets.of("1") <= 40
    assert np.count_nonzero(some) == expected["full_count"]
    assert sets.teeth[some & coprime_meshes(sets)].tolist() == expected["full_coprime"]


def test_borders_of_the_tolerance_belong_to_it() -> None:
    expected = CASES["GT-S22"]["expected"]["solutions"]
    sets = synthesise(replace(task("AIbar", "6.2", "0.1", (1,), relative=False), planets=2)).sets
    assert sets.teeth[sets.of("1") == 20].tolist() == expected


def test_double_planet_case() -> None:
    expected = CASES["GT-S08"]["expected"]
    found = synthesise(replace(task("AI", "30.29", "0.5", (4, 7), relative=False), planets=3))
    listed = [row["z"] for row in expected["solutions_up_to_e_max"]]
    sums = found.sets.of("1") + found.sets.of("2")
    assert found.sets.teeth[sums <= 7 * 24].tolist() == sorted(listed, key=lambda z: (z[0] + z[1], z))
    assert found.count == expected["full_count"]
    numerator, denominator = tooth_ratio(found.sets)
    printed = {tuple(row["z"]): row["U"] for row in expected["solutions_up_to_e_max"]}
    for teeth, n, d in zip(found.sets.teeth.tolist(), numerator, denominator, strict=True):
        assert n / d == pytest.approx(printed.get(tuple(teeth), n / d), abs=1e-6)


@pytest.mark.parametrize("equal", [True, False])
def test_unfolded_case(equal: bool) -> None:
    expected = CASES["GT-S24"]["expected"]
    demands = Demands(stage_ratio=Fraction(6), diameter_band=Fraction("0.03"), equal_pinions=equal)
    limits = Limits(least=16, largest=150, largest_pinion=22)
    found = synthesise(replace(task("unfolded2", "8.15", "0.01", ()), demands=demands, limits=limits))
    if equal:
        assert found.sets.teeth.tolist() == sorted(expected["equal_pinions_solutions"], key=lambda z: (z[0] + z[1], z))
    kind = "equal" if equal else "independent"
    assert found.count == expected.get(f"{kind}_pinions_count", found.count)
    assert np.count_nonzero(coprime_meshes(found.sets)) == expected[f"{kind}_pinions_coprime_count"]


def test_mesh_angle_case() -> None:
    given, expected = CASES["GT-S21"]["inputs"], CASES["GT-S21"]["expected"]
    demands = Demands(largest_angle=math.radians(given["alpha_w_max_deg"]))
    work = replace(
        task("2A-AA", "4", "0.05", (1,), relative=False),
        planets=given["k"],
        demands=demands,
        limits=Limits(least=17, largest=200),
    )

    def chosen(work: TrainTask) -> Any:
        sets = synthesise(work).sets
        inside = np.ones(len(sets), dtype=bool)
        for wheel, key in (("1", "z1"), ("2", "z2"), ("3", "z3")):
            inside &= (sets.of(wheel) >= given[key][0]) & (sets.of(wheel) <= given[key][1])
        return sets.teeth[inside], sets.angles[inside]

    teeth, angles = chosen(work)
    assert len(teeth) == expected["count"]
    assert len(chosen(replace(work, demands=Demands()))[0]) == expected["count_equal_angle"]
    example = expected["closure_example"]
    place = teeth.tolist().index(given["closure_example"])
    told = [example[f"alpha_w{mesh}_deg"] for mesh in (12, 23, 34)]
    assert np.degrees(angles[place]) == pytest.approx(told, abs=1e-4)


@given(st.fractions(-1000, 1000, max_denominator=10**9), st.integers(1, 60))
def test_nearest_fractions_of_bounded_terms(limit: Fraction, largest: int) -> None:
    below = max(Fraction(math.floor(limit * q), q) for q in range(1, largest + 1))
    above = min(Fraction(math.ceil(limit * q), q) for q in range(1, largest + 1))
    assert (at_most(limit, largest), at_least(limit, largest)) == (below, above)


@given(st.fractions(0, 5), st.fractions(0, 5))
def test_many_ratios_at_once_are_exact(one: Fraction, other: Fraction) -> None:
    interval = Interval(min(one, other), max(one, other))
    numerator, denominator = (part.ravel() for part in np.meshgrid(np.arange(0, 40), np.arange(1, 12)))
    inside = within(interval, numerator, denominator, 11)
    expected = [
        interval.low <= Fraction(n, d) <= interval.high
        for n, d in zip(numerator.tolist(), denominator.tolist(), strict=True)
    ]
    assert inside.tolist() == expected


def test_numbers_are_taken_as_written() -> None:
    assert fraction(6.29) == fraction("6.29") == fraction("629/100") == Fraction(629, 100)


@pytest.mark.parametrize("layout", ["AA", "II"])
def test_ratio_of_ten_thousand(layout: str) -> None:
    # The carrier drives: i_H1 = 1/(1 - U), of 99 101/100^2 it is exactly 10 000.
    work = task(layout, "9999/10000", "0", (1, 1))
    limits = Limits(largest=150, largest_ring=150)
    angle = math.radians(24) if layout == "AA" else None  # 99 + 100 and 100 + 101 teeth need mesh angles
    demands = Demands(ring_difference=None, largest_angle=angle)
    found = synthesise(replace(work, limits=limits, demands=demands))
    assert found.count
    assert set(zip(*tooth_ratio(found.sets), strict=True)) == {(9999, 10000)}


def test_ratio_next_to_one() -> None:
    work = task("unfolded2", "1.0001", "1e-4", ())
    demands = Demands(stage_ratio=Fraction(6))
    found = synthesise(replace(work, demands=demands, limits=Limits(largest_pinion=150)))
    assert found.count
    assert ratio_error(found.sets, work.nominal).max() <= 1e-4


@pytest.mark.parametrize("tolerance", ["0", "1e-9"])
def test_tolerance_of_nothing(tolerance: str) -> None:
    found = synthesise(task("AI", "77/5", tolerance, (1, 1)))
    assert found.count
    numerator, denominator = tooth_ratio(found.sets)
    assert set(zip(numerator.tolist(), denominator.tolist(), strict=True)) == {(77, 5)}


def test_twelve_planets() -> None:
    found = synthesise(replace(task("AIbar", "1.5", "0.02", (1,)), planets=12))
    sets = found.sets
    assert found.count
    assert not ((sets.of("1") + sets.of("3")) % 12).any()
    assert ((sets.of("1") + sets.of("2")) * math.sin(math.pi / 12) > sets.of("2") + 3).all()


EMPTY = {
    "planets too near": replace(task("AIbar", "13", "0.001", (1,)), planets=4),
    "rings too near": task("II", "9999/10000", "1e-5", (1, 1)),
    "steep stages": replace(
        task("unfolded2", "30", "1e-5", ()),
        demands=Demands(stage_ratio=Fraction(6), diameter_band=Fraction(1, 100)),
    ),
    "few teeth": replace(task("AI", "20", "1e-3", (1, 1)), limits=Limits(largest=60, largest_ring=100)),
    "bad proportion": replace(task("AA", "5.0031", "1e-7", (7, 8)), planets=5),
}


def opened(work: TrainTask, change: Relaxation) -> TrainTask:
    """The task with the change made."""
    limits = {"largest", "least", "largest_ring", "least_ring", "largest_pinion", "largest_sum"}
    if change.constraint in limits:
        return replace(work, limits=replace(work.limits, **{change.constraint: int(change.needed)}))
    if change.constraint == "planets":
        return replace(work, planets=int(change.needed))
    if change.constraint == "ratio":
        n, d = Fraction(change.needed).limit_denominator(10**12).as_integer_ratio()
        return replace(work, ratio=around(work.nominal, Fraction(n, d) + Fraction(1, 10**12), relative=True))
    value: Any = {
        "adjacency": {"gap": Fraction(change.needed) - Fraction(1, 10**9)},
        "interference": {"ring_difference": int(change.needed)},
        "stage_ratio": {"stage_ratio": Fraction(change.needed) + Fraction(1, 10**9)},
        "diameter_band": {"diameter_band": Fraction(change.needed) + Fraction(1, 10**9)},
        "mesh_angles": {"largest_angle": change.needed + 1e-12},
        "assembly": {"assembly": False},
    }[change.constraint]
    return replace(work, demands=replace(work.demands, **value))


@sparing("name", EMPTY, every=3)
def test_what_opens_an_empty_task_opens_it(name: str) -> None:
    work = EMPTY[name]
    assert synthesise(work).count == 0
    changes = relaxations(work)
    assert changes
    for change in changes:
        sets = synthesise(opened(work, change)).sets
        assert list(change.teeth) in sets.teeth.tolist(), change


@sparing("name", EMPTY, every=3)
def test_no_smaller_change_of_teeth_opens_it(name: str) -> None:
    work = EMPTY[name]
    for change in relaxations(work):
        if change.constraint in ("largest", "least", "largest_ring", "least_ring"):
            nearer = change.needed - math.copysign(1, change.needed - change.present)
            assert synthesise(opened(work, replace(change, needed=nearer))).count == 0
