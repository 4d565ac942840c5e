"""Stage ratios: closed forms, minima against scipy, and limits."""

from __future__ import annotations

from math import cbrt

import numpy as np
import pytest
from sparing import sparing

from gears.criteria.worked import CASES, lengths, sets
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.criteria.inertia import reduced_inertia
from tmmcalc.gears.criteria.size import size
from tmmcalc.gears.criteria.wheels import wheels
from tmmcalc.gears.split import CRITERIA, best_split, cost, equal_diameters, exponents


def test_two_stages() -> None:
    expected = CASES["GT-S01"]["expected"]
    found = equal_diameters(8.15)
    assert found.ratios == pytest.approx(expected["stage_ratios"], abs=1e-6)
    assert found.modules[1] == pytest.approx(expected["module_ratio_m2_over_m1"], abs=1e-6)


@pytest.mark.parametrize("stages", [1, 2, 3, 4, 7])
def test_wheels_of_equal_diameter(stages: int) -> None:
    found = equal_diameters(37.5, stages)
    assert sum(exponents(stages)) == 1
    assert np.prod(found.ratios) == pytest.approx(37.5, rel=1e-14)
    diameters = found.modules * found.ratios
    assert diameters == pytest.approx(np.full(stages, diameters[0]), rel=1e-13)


@pytest.mark.parametrize("criterion", CRITERIA)
@pytest.mark.parametrize(("ratio", "stages"), [(4.0, 2), (8.15, 2), (19.0, 2), (20.0, 3), (45.0, 3), (100.0, 4)])
def test_minimum(criterion: str, ratio: float, stages: int) -> None:
    from scipy.optimize import minimize

    def level(x: np.ndarray) -> float:
        ratios = np.exp(np.append(x, np.log(ratio) - x.sum()))
        return float(np.log(cost(criterion, ratios)))

    truth = minimize(
        level,
        np.full(stages - 1, np.log(ratio) / stages),
        method="Nelder-Mead",
        options={"xatol": 1e-9, "fatol": 1e-15, "maxiter": 4000},
    )
    found = best_split(ratio, criterion, stages, least=0.1, most=None)
    assert np.prod(found.ratios) == pytest.approx(ratio, rel=1e-13)
    assert found.cost is not None
    assert np.log(found.cost) <= truth.fun + 1e-14
    assert np.log(found.ratios[:-1]) == pytest.approx(truth.x, abs=3e-7)
    # the slope along every exchange between two stages is zero to rounding
    for k in range(stages - 1):
        step = np.ones(stages)
        step[k : k + 2] = np.exp([1e-4, -1e-4])
        rise = [cost(criterion, found.ratios * step**sign) / found.cost - 1 for sign in (1, -1)]
        assert abs(rise[0] - rise[1]) < 1e-10


@sparing("criterion", CRITERIA, every=3)
def test_limits_of_the_stage_ratio(criterion: str) -> None:
    found = best_split(34.0, criterion, 2, most=6.0)
    assert found.ratios.max() == pytest.approx(6.0, rel=1e-14)
    assert len(found.bounded) == 1
    assert found.ratios[found.bounded[0]] == pytest.approx(6.0, rel=1e-14)
    scan = np.linspace(34 / 6, 6, 4001)
    assert found.cost == pytest.approx(min(cost(criterion, np.array([u, 34 / u])) for u in scan), rel=1e-12)
    corner = best_split(36.0, criterion, 2, most=6.0)
    assert corner.ratios == pytest.approx([6.0, 6.0], rel=1e-12)


@pytest.mark.slow
def test_limits_of_three_stages() -> None:
    """With a narrow box the best split stands on its border; compared with a fine scan of the box."""
    low, high, total = 2.5, 3.2, 26.0
    for criterion in CRITERIA:
        found = best_split(total, criterion, 3, least=low, most=high)
        grid = np.linspace(low, high, 141)
        first, second = (axis.ravel() for axis in np.meshgrid(grid, grid))
        third = total / first / second
        inside = (third >= low) & (third <= high)
        triples = zip(first[inside], second[inside], third[inside], strict=True)
        least = min(cost(criterion, np.array(triple)) for triple in triples)
        assert found.cost is not None
        assert found.cost <= least * (1 + 1e-12)
        assert found.cost == pytest.approx(least, rel=2e-3)


def test_costs_are_those_of_built_trains() -> None:
    """Mass, inertia and size of a train with these proportions, in units of its first pinion."""
    u, z = np.array([3.0, 2.5]), 20
    train = sets("unfolded2", [[z, 60, z, 50]])
    modules = np.array([0.002, 0.002 * cbrt(3.0)])
    widths = 0.5 * z * modules
    module, width = lengths(train, *modules), lengths(train, *widths)
    made = wheels(train, module, width)
    pinion_mass, pinion_inertia = made.masses[0, 0], made.inertias[0, 0]
    assert cost("mass", u) == pytest.approx(made.mass[0] / pinion_mass, rel=1e-13)
    assert cost("inertia", u) == pytest.approx(reduced_inertia(train, module, width)[0] / pinion_inertia, rel=1e-13)
    assert cost("size", u) == pytest.approx(size(train, module)[0] / (0.002 * z), rel=1e-13)


def test_faults() -> None:
    with pytest.raises(NoSolutionError, match="cannot be split"):
        best_split(40.0, "mass", 2)
    with pytest.raises(NoSolutionError):
        best_split(3.0, "mass", 2, least=2.0)
    for wrong in (
        lambda: best_split(8.0, "price"),
        lambda: best_split(8.0, "mass", 5),
        lambda: best_split(0.9, "mass"),
    ):
        with pytest.raises(UsageError):
            wrong()
    with pytest.raises(UsageError):
        equal_diameters(8.0, 0)
