"""The train 2A-(AA with bar) in real numbers: case GT-S20, its equations, and its limits against a scan."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gears.criteria.worked import CASES
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.radial import angle_ratios, ratio_limits, real_teeth, usual_assembly


@pytest.mark.parametrize(
    ("given", "expected"),
    list(zip(CASES["GT-S20"]["inputs"]["items"], CASES["GT-S20"]["expected"]["items"], strict=True)),
)
def test_worked_trains(given: dict[str, float], expected: dict[str, float]) -> None:
    shape = {key: given[key] for key in ("y", "t1", "t2")}
    teeth = real_teeth(given["i_1H"], int(given["k"]), int(given["N"]), **shape)
    assert [teeth.z1, teeth.z2, teeth.z3, teeth.z4] == pytest.approx(
        [expected[f"Z{n}"] for n in (1, 2, 3, 4)], abs=1e-6
    )
    assert teeth.denominator == pytest.approx(expected["denominator"], abs=1e-6)
    assert abs(teeth.residual) < 1e-12
    limits = ratio_limits(int(given["k"]), **shape)
    found = [limits.coaxial, limits.first, limits.bracket, limits.second]
    keys = ("i_min_coaxial", "i_max_neighbour1", "second_bracket", "i_bound_neighbour2")
    assert found == pytest.approx([expected[key] for key in keys], abs=1e-6)
    assert [limits.low, limits.high] == pytest.approx(expected["i_range"], abs=1e-6)
    assert limits.second_is_upper == expected["neighbour2_is_upper_bound"]


@pytest.mark.parametrize("planets", [3, 4, 6, 8])
@pytest.mark.parametrize(
    ("y", "t1", "t2"), [(1.0, 1.0, 1.0), (1.4, 1.1, 0.9), (0.7, 0.85, 1.15), (3.0, 1.0, 1.0), (2.0, 1.05, 0.95)]
)
def test_limits_against_a_scan(planets: int, y: float, t1: float, t2: float) -> None:
    """Where inequalities (8) without 2/Z1 hold on a fine scan of ratios, teeth taken from the equations."""
    s = math.sin(math.pi / planets)
    ratios = np.linspace(1.0, 40.0, 39_001)
    z2 = (t2 * (ratios - 1) - 1) / (1 + t1 * (1 + y) - y * t2)  # over Z1
    z3, z4 = y * z2, ratios - 1
    holds = (z2 > 0) & ((1 + z2) * s > z2) & ((z4 + z3) * s > z3)
    try:
        limits = ratio_limits(planets, y=y, t1=t1, t2=t2)
    except NoSolutionError:
        assert not holds.any()
        return
    found = (ratios > limits.low) & (ratios < (limits.high or math.inf))
    assert np.count_nonzero(found != holds) <= 2


def test_equations() -> None:
    for y, t1, t2 in ((1.0, 1.0, 1.0), (1.3, 0.9, 1.1), (0.6, 1.2, 0.8)):
        teeth = real_teeth(6.5, 4, 33, y=y, t1=t1, t2=t2)
        assert teeth.z1 + teeth.z4 == pytest.approx(4 * 33, rel=1e-14)
        assert teeth.z4 / teeth.z1 == pytest.approx(5.5, rel=1e-14)
        assert teeth.z3 / teeth.z2 == pytest.approx(y, rel=1e-14)
        assert abs(teeth.residual) < 1e-12 * (teeth.z3 + teeth.z4)


def test_two_pairs_have_no_neighbours() -> None:
    limits = ratio_limits(2)
    assert (limits.low, limits.high, limits.first, limits.second) == (2.0, None, None, None)


def test_faults() -> None:
    with pytest.raises(NoSolutionError, match="without teeth"):
        real_teeth(2.0, 3, 30)
    with pytest.raises(NoSolutionError, match="does not close"):
        real_teeth(5.0, 3, 30, y=12.0, t1=0.9, t2=1.1)
    for wrong in ({"y": 0.0}, {"t1": -1.0}):
        with pytest.raises(UsageError):
            ratio_limits(3, **wrong)
    with pytest.raises(UsageError):
        real_teeth(5.0, 0, 30)


def test_mesh_angles_give_the_parameters() -> None:
    found = angle_ratios((math.radians(20), math.radians(25), math.radians(22)))
    given = CASES["GT-S20"]["inputs"]["items"][1]
    assert found == pytest.approx((given["t1"], given["t2"]), abs=1e-9)


@pytest.mark.parametrize(("ratio", "planets", "least"), [(5.0, 3, 18), (3.5, 6, 17), (6.3, 4, 20)])
def test_the_usual_number_of_assembly_is_the_least(ratio: float, planets: int, least: int) -> None:
    number = usual_assembly(ratio, planets, least)
    assert real_teeth(ratio, planets, number).z1 >= least - 1e-6
    assert real_teeth(ratio, planets, number - 1).z1 < least
