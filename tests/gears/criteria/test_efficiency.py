"""Efficiency of whole lists against the power flow of single trains."""

from __future__ import annotations

import numpy as np
import pytest

from gears.criteria.worked import CASES, TEETH, sets
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.criteria.efficiency import MeshEfficiency, efficiency
from tmmcalc.gears.criteria.speeds import speeds
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.network.builder import network_of
from tmmcalc.gears.network.efficiency import efficiency as of_network


def by_network(layout: str, teeth: list[int], meshes: MeshEfficiency, *, back: bool) -> float:
    each = [meshes.internal if mesh.internal else meshes.external for mesh in LAYOUTS[layout].meshes]
    train = network_of(layout, teeth, 1, each)
    train = train.reversed() if back else train
    return of_network(train.network, train.driver, train.output, train.fixed).efficiency


@pytest.mark.parametrize("layout", LAYOUTS)
@pytest.mark.parametrize("back", [False, True])
def test_against_power_flow(layout: str, *, back: bool) -> None:
    meshes = MeshEfficiency(0.97, 0.99)
    train = sets(layout, TEETH[layout])
    found = efficiency(train, meshes, train.scheme.output if back else "1")
    truth = [by_network(layout, row, meshes, back=back) for row in TEETH[layout]]
    assert found == pytest.approx(truth, rel=1e-11)


def test_three_central_wheels_of_many_ratios() -> None:
    """Ratios of both signs up to several hundred, among them such as lock."""
    teeth = [[20, 40, p, 100, z4] for p in (25, 31, 37, 43) for z4 in range(61, 120, 6) if 100 * p != 40 * z4]
    train = sets("AII", teeth)
    meshes = MeshEfficiency(0.97, 0.98)
    ratios = speeds(train).of("1")
    assert ratios.min() < -50
    assert ratios.max() > 50
    for driver in ("1", "4"):
        found = efficiency(train, meshes, driver)
        truth = [by_network("AII", row, meshes, back=driver == "4") for row in teeth]
        assert found == pytest.approx(truth, rel=1e-9)
    assert np.any(efficiency(train, meshes, "4") <= 0)


def test_lossless_trains() -> None:
    for layout in LAYOUTS:
        assert efficiency(sets(layout, TEETH[layout]), MeshEfficiency(1.0, 1.0)) == pytest.approx([1, 1], rel=1e-12)


def test_worked_ratios() -> None:
    """GT-S11 by trains of these ratios: AIbar of i_1H = 7.29 and AA of 0.05 with eta0 = 0.9."""
    expected = CASES["GT-S11"]["expected"]["items"]
    root = 0.9**0.5
    single = sets("AIbar", [[100, 264, 629]])
    assert efficiency(single, MeshEfficiency(root, root))[0] == pytest.approx(
        expected[0]["eta_wheel1_driving"], abs=1e-6
    )
    double = sets("AA", [[40, 38, 20, 20]])
    assert efficiency(double, MeshEfficiency(root, root))[0] == pytest.approx(
        expected[3]["eta_wheel1_driving"], abs=1e-6
    )
    back = efficiency(double, MeshEfficiency(root, root), "H")
    assert back[0] == pytest.approx(expected[3]["eta_carrier_driving"], abs=1e-6)


def test_faults() -> None:
    with pytest.raises(UsageError, match="does not drive"):
        efficiency(sets("AI", TEETH["AI"]), None, "2")
    with pytest.raises(NoSolutionError):
        efficiency(sets("AA", [[20, 30, 30, 20]]), None, "1")
