"""The textbook's programs: cases GT-S01, S04, S06, S08, S09, and a part of the complete sets."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sparing import sparing

from gears.criteria.worked import CASES, task
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.model import Demands, Limits
from tmmcalc.gears.stepping import equal_pinions, stepped, wheel_of


def test_unfolded_reducer() -> None:
    expected = CASES["GT-S01"]["expected"]
    work = task("unfolded2", "8.15", "0.01", relative=True, limits=Limits(least=16, largest_pinion=22))
    rows = equal_pinions(work, range(16, 23))
    for row, z, teeth, u, coprime in zip(
        expected["rows"], rows.step, rows.sets.teeth.tolist(), rows.ratios, rows.coprime, strict=True
    ):
        pinion = row["z_pinion"]
        assert (z, teeth) == (pinion, [pinion, row["z_wheels"][0], pinion, row["z_wheels"][1]])
        assert float(u) == pytest.approx(row["U_actual"], abs=1e-6)
        assert float(u / Fraction("8.15") - 1) == pytest.approx(row["rel_error"], abs=1e-6)
        assert coprime == row["coprime"]
    accepted = stepped(work)
    assert accepted.step.tolist() == expected["accepted_z_pinion"]
    assert accepted.step[accepted.coprime].tolist() == expected["accepted_coprime"]


@given(st.integers(15, 30), st.integers(1100, 60000), st.sampled_from([(3, 5), (2, 5), (9, 19), (6, 19), (4, 19)]))
def test_wheel_is_rounded_exactly(pinion: int, thousandths: int, power: tuple[int, int]) -> None:
    ratio = Fraction(thousandths, 1000)
    wheel = wheel_of(pinion, ratio, Fraction(*power))
    p, q = power
    # (wheel - 1/2)^q <= z^q U^p < (wheel + 1/2)^q, in fractions
    exact = pinion**q * ratio**p
    assert (wheel - Fraction(1, 2)) ** q <= exact < (wheel + Fraction(1, 2)) ** q


def test_rounding_at_a_half() -> None:
    assert wheel_of(18, Fraction(243, 32), Fraction(1, 5)) == 27
    assert wheel_of(17, Fraction(243, 32), Fraction(1, 5)) == 26  # 25.5, exactly
    assert wheel_of(17, Fraction(243, 32) - Fraction(1, 10**30), Fraction(1, 5)) == 25


def test_three_stages() -> None:
    found = stepped(task("unfolded3", "40", "0.02", (1, 1, 1), relative=True))
    assert len(found.sets)
    for z, teeth, u in zip(found.step.tolist(), found.sets.teeth.tolist(), found.ratios, strict=True):
        assert teeth[::2] == [z] * 3
        assert abs(u / 40 - 1) <= Fraction("0.02")
        for wheel, power in zip(teeth[1::2], (9 / 19, 6 / 19, 4 / 19), strict=True):
            assert wheel == math.floor(z * 40**power + 0.5)


def test_coaxial_reducer() -> None:
    expected = CASES["GT-S04"]["expected"]
    found = stepped(task("coaxial", "8.15", "0.08", (2, 3), limits=Limits(largest=100)))
    listed = found.step <= 33
    rows = expected["solutions_up_to_e_max"]
    assert found.step[listed].tolist() == [row["e"] for row in rows]
    assert found.sets.teeth[listed].tolist() == [row["z"] for row in rows]
    assert found.coprime[listed].tolist() == [row["coprime"] for row in rows]
    # in this task no pair of sums holds two wheels Z2 at once, so that the program misses nothing
    assert len(found.sets) == expected["full_search_count"]
    assert sorted(found.sets.teeth[found.coprime].tolist()) == expected["full_search_coprime"]


def test_single_planets() -> None:
    expected = CASES["GT-S06"]["expected"]
    found = stepped(task("AIbar", "6.29", "0.1", (1,), planets=3))
    listed = found.step <= 26
    assert found.sets.teeth[listed].tolist() == [row["z"] for row in expected["solutions"]]
    assert found.coprime[listed].tolist() == [row["coprime"] for row in expected["solutions"]]
    assert np.count_nonzero(found.step <= 40) == expected["full_count"]
    full = found.sets.teeth[found.coprime & (found.step <= 40)]
    assert full.tolist() == expected["full_coprime"]


def test_ratio_borders_are_admitted() -> None:
    """GT-S22: (6.2 - 0.1) 20 = 122 exactly, which binary fractions miss."""
    found = stepped(task("AIbar", "6.2", "0.1", (1,), planets=2))
    assert [20, 51, 122] in found.sets.teeth.tolist()


def test_double_planets() -> None:
    expected = CASES["GT-S08"]["expected"]
    found = stepped(task("AI", "30.29", "0.5", (4, 7), planets=3))
    rows = expected["solutions_up_to_e_max"]
    listed = found.step <= 24
    assert found.step[listed].tolist() == [row["e"] for row in rows]
    assert found.sets.teeth[listed].tolist() == [row["z"] for row in rows]
    assert [float(u) for u in found.ratios[: len(rows)]] == pytest.approx([row["U"] for row in rows], abs=1e-6)
    assert found.common[listed].tolist() == [[row["gcd12"], row["gcd2p3"]] for row in rows]
    assert len(found.sets) == expected["full_count"]


def test_several_layshafts() -> None:
    expected = CASES["GT-S09"]["expected"]
    for layout in ("AA", "coaxial"):
        found = stepped(task(layout, "8.15", "0.08", (2, 3), planets=3, limits=Limits(largest=120)))
        teeth = found.sets.teeth[np.lexsort((*found.sets.teeth.T[::-1], found.step))]
        assert teeth[:8].tolist() == expected["first_eight_by_sum"]
        assert (len(teeth), np.count_nonzero(found.coprime)) == (expected["full_count"], expected["coprime_count"])


@sparing(
    ("layout", "ratio", "proportion", "planets"),
    [("coaxial", "9", (1, 1), 1), ("AI", "12", (1, 1), 3), ("AA", "6", (3, 4), 3), ("AI", "9", (2, 3), 6)],
    every=4,
)
def test_rows_meet_every_constraint(layout: str, ratio: str, proportion: tuple[int, int], planets: int) -> None:
    """Wide tolerances, in which the program keeps one wheel Z2 of several, tested by the conditions themselves."""
    found = stepped(task(layout, ratio, "0.5", proportion, planets=planets))
    assert len(found.sets)
    side, s = (1 if layout == "AI" else -1), math.sin(math.pi / planets)
    nominal = Fraction(ratio)
    for e, (z1, z2, p, z3), u in zip(found.step.tolist(), found.sets.teeth.tolist(), found.ratios, strict=True):
        assert u == Fraction(z2 * z3, z1 * p)
        assert abs(u - nominal) <= Fraction(1, 2)
        assert (z1 + z2, z3 - side * p) == (e * proportion[1], e * proportion[0])
        if planets > 1:
            assert (z2 * z3 + side * z1 * p) % (planets * math.gcd(z2, p)) == 0
            assert (z1 + z2) * s > z2 + 3
            assert (z3 - side * p) * s > p + 3
        # the next larger Z2 of the same sums leaves the tolerance
        assert Fraction((z2 + 1) * z3, (z1 - 1) * p) > nominal + Fraction(1, 2)
        assert min(z1, z2, p) >= 17
        assert max(z1, z2, p) <= 150
        assert (40 <= z3 <= 350 and z3 - p >= 7) if layout == "AI" else 17 <= z3 <= 150


def test_limits_of_the_list() -> None:
    work = task("coaxial", "8.15", "0.08", (2, 3), (4, 7))
    assert len(stepped(work, 5).sets) == 5
    assert len(stepped(work, 0).sets) == 0
    assert {tuple(row) for row in stepped(work).sets.modules.tolist()} == {(2, 3), (4, 7)}
    free = replace(task("AIbar", "6.29", "0.1", (1,), planets=5), demands=Demands(gap=None, assembly=False))
    assert len(stepped(free).sets) > len(stepped(task("AIbar", "6.29", "0.1", (1,), planets=3)).sets)


def test_faults() -> None:
    with pytest.raises(UsageError, match="no program"):
        stepped(task("II", "0.9", "0.01"))
    with pytest.raises(NoSolutionError, match="5 planets overlap") as error:
        stepped(task("AIbar", "5", "0.1", (1,), planets=5))
    assert error.value.limit == pytest.approx(3.8518, abs=1e-4)
