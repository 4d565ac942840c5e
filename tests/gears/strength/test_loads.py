"""Torques of the meshes against equilibrium of forces on the planets, in lengths and not in ratios."""

from __future__ import annotations

import numpy as np
import pytest

from gears.strength.scenes import TRAINS, sets_of
from tmmcalc.core.errors import UsageError
from tmmcalc.gears.layouts import LAYOUTS
from tmmcalc.gears.strength.loads import mesh_loads


@pytest.mark.parametrize("layout", LAYOUTS)
def test_pinions_are_the_smaller_wheels(layout: str) -> None:
    sets = sets_of(layout)
    loads = mesh_loads(sets)
    for k, mesh in enumerate(sets.scheme.meshes):
        pair = sorted((int(sets.of(mesh.first)[0]), int(sets.of(mesh.second)[0])))
        assert loads.teeth[0, k] == sets.teeth[0, loads.pinion[0, k]] == pair[0]
        assert sets.teeth[0, loads.wheel[0, k]] == pair[1]
        assert loads.u[0, k] == pair[1] / pair[0]
        sign = -1 if mesh.internal else 1
        assert loads.factor[0, k] == pytest.approx((pair[1] + sign * pair[0]) / pair[1], rel=1e-15)


def test_factors_of_the_textbook() -> None:
    """q = 1, U1, U1 U2."""
    z1, z2, z2b, z3, z3b, z4 = TRAINS["unfolded3"][0]
    loads = mesh_loads(sets_of("unfolded3"))
    np.testing.assert_allclose(loads.q[0], [1, z2 / z1, z2 / z1 * z3 / z2b], rtol=1e-15)
    np.testing.assert_allclose(loads.u[0], [z2 / z1, z3 / z2b, z4 / z3b], rtol=1e-15)


def forces_on_planet(lengths: list[float], a: float) -> np.ndarray:
    """Tangential forces at the meshes at ``lengths`` from the axis on a planet at ``a``, the first force being 1.

    Without torque on the carrier they sum to 0; their moments about the planet's own axis do in any case.
    """
    count = len(lengths) - 1
    rows = [[length - a for length in lengths[1:]]] + ([[1.0] * count] if count == 2 else [])
    right = [-(lengths[0] - a)] + ([-1.0] if count == 2 else [])
    return np.array([1.0, *np.linalg.solve(np.array(rows), np.array(right))])


def pinion_torque(layout: str, mesh: int, force: float, r1: float, module: float) -> float:
    """Torque on the smaller wheel of a mesh over that on wheel 1, from the force there over that at wheel 1."""
    sets = sets_of(layout)
    scheme = sets.scheme.meshes[mesh]
    small = min(int(sets.of(scheme.first)[0]), int(sets.of(scheme.second)[0]))
    return abs(force) * module * small / 2 / r1


@pytest.mark.parametrize("layout", ["AIbar", "AI", "AA", "II"])
def test_equilibrium_of_double_planets(layout: str) -> None:
    teeth, ratio = TRAINS[layout]
    m1, m2 = ratio[0], ratio[-1]
    r1, r3 = m1 * teeth[0] / 2, m2 * teeth[-1] / 2
    a = m1 * (teeth[0] + (-1 if layout == "II" else 1) * teeth[1]) / 2
    forces = forces_on_planet([r1, r3], a)
    expected = [pinion_torque(layout, k, forces[k], r1, m) for k, m in enumerate((m1, m2))]
    np.testing.assert_allclose(mesh_loads(sets_of(layout)).q[0], expected, rtol=1e-13)


def test_equilibrium_of_three_central_wheels() -> None:
    """AII: the carrier takes no torque, the ring of the frame and that of the output share the rest."""
    z1, z2, _, z3, z4 = TRAINS["AII"][0]
    a = (z1 + z2) / 2
    forces = forces_on_planet([z1 / 2, z3 / 2, z4 / 2], a)
    assert sum(forces) == pytest.approx(0.0, abs=1e-12)
    expected = [pinion_torque("AII", k, forces[k], z1 / 2, 1.0) for k in range(3)]
    np.testing.assert_allclose(mesh_loads(sets_of("AII")).q[0], expected, rtol=1e-13)


def test_idlers_pass_one_force_on() -> None:
    """2A-AA: sun, two planets one after another, sun: the same force in all meshes."""
    loads = mesh_loads(sets_of("2A-AA"))
    np.testing.assert_allclose(loads.q[0] / loads.teeth[0], loads.q[0, 0] / loads.teeth[0, 0], rtol=1e-15)
    assert loads.reference[0, 0] == min(TRAINS["2A-AA"][0])


def test_small_planets_are_the_pinions() -> None:
    loads = mesh_loads(sets_of("AIbar", [30, 20, 70]))
    assert list(loads.pinion[0]) == [1, 1]
    np.testing.assert_allclose(loads.q[0], [20 / 30, 20 / 30], rtol=1e-15)
    np.testing.assert_allclose(loads.u[0], [1.5, 3.5], rtol=1e-15)
    assert loads.reference[0, 0] == 20


def test_wheels_that_cannot_mesh() -> None:
    with pytest.raises(UsageError, match="set 2: the ring has 40 teeth, its planet 48"):
        mesh_loads(sets_of("AIbar", [[18, 48, 114], [18, 48, 40]]))
    with pytest.raises(UsageError, match="has 4 wheels"):
        mesh_loads(sets_of("AI", [18, 48, 114]))
    with pytest.raises(UsageError, match="not positive"):
        mesh_loads(sets_of("unfolded2", [18, 0, 18, 40]))
    with pytest.raises(UsageError, match="wheel 4 stands still"):
        mesh_loads(sets_of("AII", [20, 30, 30, 80, 80]))
