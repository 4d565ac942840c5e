"""Circulating power of a closed differential, by hand; frequencies."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from gears.network.trains import EXAMPLES, trains
from tmmcalc.core.errors import TmmError
from tmmcalc.gears.network.builder import bevel_differential, network_of
from tmmcalc.gears.network.circulation import elements
from tmmcalc.gears.network.efficiency import efficiency
from tmmcalc.gears.network.frequencies import mesh_frequencies
from tmmcalc.gears.network.model import FRAME, INTERNAL, Body, Mesh, Network
from tmmcalc.gears.network.power import solve_power
from tmmcalc.gears.network.speeds import solve_speeds


def closed(sign: int) -> Network:
    """Sun 20, ring 60, carrier H out; shaft x drives ring (1 : 1) and sun (2 : 1) of a differential."""
    return Network(
        (
            Mesh("sun", 20, "planet", 20),
            Mesh("planet", 20, "ring", 60, INTERNAL),
            Mesh("x", 40, "ring", 40),
            Mesh("x", 40, "sun", 20, sign),
        ),
        (Body("planet", "H", 3),),
    )


class TestClosedDifferential:
    """wa + 3 wb = 4 wH, torques 1 : 3 : -4."""

    def test_circulating(self) -> None:
        """Sun against ring, wa = -2 wb: the ring brings 12, the sun takes 8 back, 4 go out."""
        flow = solve_power(closed(INTERNAL), {"x": 1.0}, {"H": -4.0 / 4.0})
        motion = flow.motion
        assert motion.speed("ring") == -1
        assert motion.speed("sun") == 2
        assert motion.speed("H") == -0.25
        # equal senses of the load and the speed: the load drives
        assert flow.power("H") == pytest.approx(0.25)
        (loop,) = flow.loops
        assert loop.power == pytest.approx(0.5)
        assert len(loop.path) == 6
        assert set(loop.path) == {
            "x",
            "ring",
            "sun",
            "x-ring (40/40)",
            "x-sun (40/20)",
            "sun-planet (20/20) + planet-ring (20/60)",
        }
        step = dict(zip(loop.path, (*loop.path[1:], loop.path[0]), strict=True))
        # driven at the carrier, the ring gives more to x than goes out there; the rest returns by the sun
        assert step["ring"] == "x-ring (40/40)"
        assert step["x"] == "x-sun (40/20)"

    def test_losses_of_circulation(self) -> None:
        """The rolling power of a circulating train exceeds what is put in, and so its losses."""
        lossy = [Mesh(m.first, m.first_teeth, m.second, m.second_teeth, m.sign, 0.98) for m in closed(1).meshes]
        circulating = efficiency(Network(tuple(lossy), closed(1).bodies), "x", "H")
        shared = efficiency(Network((*lossy[:3], Mesh("x", 40, "sun", 20, -1, 0.98)), closed(1).bodies), "x", "H")
        assert circulating.potential > 2 > shared.potential
        assert circulating.efficiency < shared.efficiency < 1

    def test_split(self) -> None:
        """Sun with the ring: both bring power, nothing circulates."""
        flow = solve_power(closed(-1), {"x": 1.0}, {"H": 1.0})
        assert flow.motion.speed("H") == -1.25
        assert flow.power("H") == pytest.approx(-1.25)
        assert not flow.loops

    def test_elements(self) -> None:
        assert elements(closed(1)) == ((0, 1), (2,), (3,))
        assert elements(network_of("2A-AA", (18, 27, 27, 72)).network) == ((0, 1, 2),)
        ravigneaux_like = Network(
            (Mesh("a", 20, "p", 20), Mesh("b", 20, "q", 20), Mesh("p", 20, "q", 20)), (Body("p", "H"), Body("q", "H"))
        )
        assert elements(ravigneaux_like) == ((0, 1, 2),)

    @EXAMPLES
    @given(trains(), st.data())
    def test_loops_close(self, network: Network, data: st.DataObject) -> None:
        """No loop carries more than the elements pass on."""
        held, driver, output = data.draw(st.permutations(network.members))[:3]
        try:
            flow = efficiency(network, driver, output, fixed=held).flow
        except TmmError:
            assume(False)
        for loop in flow.loops:
            assert 0 < loop.power <= np.abs(flow.mesh_powers).sum()
            assert len(set(loop.path)) == len(loop.path)
            assert FRAME not in loop.path


class TestFrequencies:
    def test_planetary(self) -> None:
        """Ring held: teeth meet z3 nH a second, planets pass the ring K nH and the sun K (n1 - nH)."""
        train = network_of("AIbar", (18, 48, 114), 3).network
        n_h = 2.5
        motion = solve_speeds(train, {"3": 0.0, "H": 2 * math.pi * n_h})
        found = mesh_frequencies(train, motion)
        assert found.mesh == pytest.approx([114 * n_h, 114 * n_h])
        assert found.passes[0] == pytest.approx([3 * (22 / 3 - 1) * n_h, 114 / 48 * n_h])
        assert found.passes[1] == pytest.approx([114 / 48 * n_h, 3 * n_h])
        assert found.common.tolist() == [6, 6]
        assert found.recurrence.tolist() == [[8, 3], [19, 8]]
        assert found.hunting == pytest.approx([114 * n_h / 144, 114 * n_h / 912])
        assert found.shafts == pytest.approx([22 / 3 * n_h, abs(1 - 114 / 48) * n_h, 0, n_h])

    def test_bevel(self) -> None:
        train = bevel_differential(16, 10, 16, planets=2)
        motion = solve_speeds(train, {"left": 2 * math.pi * 12.0, "right": 2 * math.pi * 10.0})
        found = mesh_frequencies(train, motion)
        assert found.mesh == pytest.approx([16.0, 16.0])
        assert found.turns == pytest.approx(np.array([[1.0, 1.6], [1.0, 1.6]]))
        assert found.passes[:, 0] == pytest.approx([2.0, 2.0])
        assert found.recurrence.tolist() == [[5, 8], [5, 8]]

    def test_fixed_axes(self) -> None:
        train = network_of("coaxial", (17, 64, 19, 37), planets=2).network
        found = mesh_frequencies(train, solve_speeds(train, {"1": 2 * math.pi * 25.0}))
        assert found.mesh == pytest.approx([17 * 25.0, 19 * 17 / 64 * 25.0])
        assert found.common.tolist() == [1, 1]
        assert found.passes[:, 0] == pytest.approx([50.0, 17 / 64 * 25.0])
