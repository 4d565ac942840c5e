"""Module ratio of equal strength: case GT-S03, its defining equations, and standard ratios."""

from __future__ import annotations

import numpy as np
import pytest

from gears.criteria.worked import CASES
from tmmcalc.core.errors import UsageError
from tmmcalc.gears.proportion import curve, equal_strength


def test_worked_ratios() -> None:
    case = CASES["GT-S03"]
    for given, expected in zip(case["inputs"]["cases"], case["expected"]["results"], strict=True):
        found = equal_strength(given["U"], internal=given["type"] == "AI")
        numbers = [float(values[0]) for values in (found.modules, found.first, found.second)]
        assert numbers == pytest.approx([expected[key] for key in ("mu_star", "U1", "U2")], abs=6e-6)


@pytest.mark.parametrize(
    ("internal", "values"),
    [
        (False, {4: 1.4872, 6: 1.6093, 8.15: 1.7036, 10: 1.7682, 12: 1.8273, 16: 1.9238, 20: 2.0018}),
        (True, {10: 1.0906, 12: 1.1667, 16: 1.2907, 20: 1.3902}),
    ],
)
def test_values_of_the_graph(internal: bool, values: dict[float, float]) -> None:
    found = equal_strength(np.array(list(values), float), internal=internal)
    assert found.modules == pytest.approx(list(values.values()), abs=6e-5)


@pytest.mark.parametrize("internal", [False, True])
def test_equations_hold_to_rounding(*, internal: bool) -> None:
    u = np.geomspace(1.001, 1e6, 400)
    found = equal_strength(u, internal=internal)
    side = -1 if internal else 1
    assert found.first * found.second == pytest.approx(u, rel=1e-14)
    assert found.first + 1 == pytest.approx(found.modules * (found.second + side), rel=1e-12)
    u1, u2 = found.first, found.second
    by_stages = np.cbrt(u1 * (u2 + side) / u2 * u1 / (u1 + 1))  # (4.15), (4.20)
    assert by_stages == pytest.approx(found.modules, rel=1e-12)


def test_the_root_is_the_only_one() -> None:
    """The equation of coaxiality changes its sign once on a fine scan."""
    for u in (1.5, 8.15, 40.0):
        for side in (1, -1):
            first = np.linspace(u / 1000, u, 200_001)
            gap = first + 1 - (first**3 / u) ** 0.25 * (u / first + side)
            change = np.flatnonzero(np.diff(np.sign(gap)) != 0)
            assert len(change) == 1
            found = equal_strength(u, internal=side < 0).first[0]
            assert first[change[0]] <= found <= first[change[0] + 1]


def test_curve() -> None:
    found = curve(internal=False)
    assert (found.ratio[0], found.ratio[-1], len(found.ratio)) == (4.0, 20.0, 101)
    assert np.all(np.diff(found.modules) > 0)
    assert curve(internal=True).ratio[-1] == 40.0
    assert curve(internal=True, low=6.0, high=7.0, points=3).ratio.tolist() == [6.0, 6.5, 7.0]


def test_faults() -> None:
    for u in (1.0, np.nan, np.array([5.0, 0.5])):
        with pytest.raises(UsageError):
            equal_strength(u, internal=False)
