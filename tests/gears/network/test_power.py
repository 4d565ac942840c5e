"""Torques, losses and power flow: balances, closed formulas, reversal, self-locking."""

from __future__ import annotations

import math
from itertools import product

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from gears.network.trains import ETA, EXAMPLES, TEETH, trains
from tmmcalc.core.errors import NoSolutionError, TmmError, UsageError
from tmmcalc.gears.network import types
from tmmcalc.gears.network.builder import (
    Train,
    bevel_differential,
    efficiency_of,
    flow_of,
    network_of,
    ratio_of,
)
from tmmcalc.gears.network.efficiency import efficiency
from tmmcalc.gears.network.model import FRAME, INTERNAL, Body, Mesh, Network
from tmmcalc.gears.network.power import PowerFlow, solve_power
from tmmcalc.gears.network.speeds import solve_speeds

TWO_MESHES = ("AIbar", "AI", "AA", "II")


def check_flow(network: Network, flow: PowerFlow) -> None:
    """Equilibrium of members, sum of torques and loss of every mesh, balance of power."""
    motion, place = flow.motion, network.place
    left, size = flow.torques.copy(), np.abs(flow.torques)
    speeds = dict(zip(motion.members, motion.speeds, strict=True)) | {FRAME: 0.0}
    lost = 0.0
    for k, (mesh, carrier) in enumerate(zip(network.meshes, network.carriers, strict=True)):
        names = (mesh.first, mesh.second, carrier)
        for name, torque in zip(names, flow.mesh_torques[k], strict=True):
            if name != FRAME:
                left[place[name]] += torque
                size[place[name]] += abs(torque)
        t1, t2, t_c = flow.mesh_torques[k]
        assert abs(t1 + t2 + t_c) <= 1e-12 * (abs(t1) + abs(t2))
        into = t1 * (speeds[mesh.first] - speeds[carrier]), t2 * (speeds[mesh.second] - speeds[carrier])
        scale = 1e-10 * sum(abs(t) * abs(speeds[n]) for n, t in zip(names, flow.mesh_torques[k], strict=True))
        loss = (1 - mesh.efficiency) * max(-into[0], -into[1])  # of the power of the wheel that drives
        assert flow.losses[k] == pytest.approx(loss, rel=1e-9, abs=scale)
        assert -sum(into) == pytest.approx(loss, rel=1e-9, abs=scale)
        assert abs(flow.rolling[k]) == pytest.approx(max(-into[0], -into[1]), rel=1e-9, abs=scale)
        assert (flow.losses >= 0).all()
        lost += loss
    assert (np.abs(left) <= 1e-11 * size.max()).all()
    assert flow.residual < 1e-12
    assert flow.powers.sum() == pytest.approx(lost, rel=1e-9, abs=1e-9 * np.abs(flow.powers).max())


class TestBalance:
    @EXAMPLES
    @given(trains(), st.data())
    def test_random(self, network: Network, data: st.DataObject) -> None:
        held, driver, output = data.draw(st.permutations(network.members))[:3]
        try:
            result = efficiency(network, driver, output, fixed=held)
        except TmmError:
            assume(False)
        check_flow(network, result.flow)
        assert result.efficiency <= 1 + 1e-12
        assert result.self_locking == (result.efficiency <= 0)

    @EXAMPLES
    @given(trains(), st.data())
    def test_torques_are_the_transpose_of_speeds(self, network: Network, data: st.DataObject) -> None:
        """Without losses the outside torques do no work on any motion that the meshes admit (virtual power)."""
        ideal = Network(
            tuple(Mesh(m.first, m.first_teeth, m.second, m.second_teeth, m.sign) for m in network.meshes),
            network.bodies,
        )
        a, b, c = data.draw(st.permutations(network.members))[:3]
        try:
            flow = solve_power(ideal, {a: 1.0, b: 3.0}, {c: 10.0})
        except TmmError:
            assume(False)
        assert flow.efficiency == pytest.approx(1.0, abs=1e-9) or flow.power_in == 0
        for w_a, w_b in ((1.0, 0.0), (0.0, 1.0), (-4.0, 7.0)):
            other = solve_speeds(ideal, {a: w_a, b: w_b})
            work = flow.torques * other.speeds
            assert abs(work.sum()) <= 1e-11 * np.abs(work).max()

    @EXAMPLES
    @given(trains(), st.data())
    def test_scale(self, network: Network, data: st.DataObject) -> None:
        """Torques scale with the load and are the same at any speed; powers are their product."""
        held, driver, output = data.draw(st.permutations(network.members))[:3]
        try:
            one = solve_power(network, {held: 0.0, driver: 1.0}, {output: -1.0})
            more = solve_power(network, {held: 0.0, driver: 8.0}, {output: -4.0})
        except TmmError:
            assume(False)
        np.testing.assert_allclose(more.torques, 4 * one.torques, rtol=1e-9, atol=1e-12)
        np.testing.assert_allclose(more.losses, 32 * one.losses, rtol=1e-9, atol=1e-12)

    @EXAMPLES
    @given(trains(), st.data())
    def test_reversed_motion(self, network: Network, data: st.DataObject) -> None:
        """Reversing all speeds and torques reverses nothing else: powers and losses stay."""
        held, driver, output = data.draw(st.permutations(network.members))[:3]
        try:
            one = solve_power(network, {held: 0.0, driver: 1.0}, {output: -1.0})
        except TmmError:
            assume(False)
        back = solve_power(network, {held: 0.0, driver: -1.0}, {output: 1.0})
        np.testing.assert_array_equal(back.powers, one.powers)
        np.testing.assert_array_equal(back.torques, -one.torques)


class TestEfficiency:
    """The losses of the meshes against closed formulas."""

    @EXAMPLES
    @given(st.sampled_from(TWO_MESHES), st.lists(TEETH, min_size=4, max_size=4), ETA, ETA, st.sampled_from("1H"))
    def test_table(self, layout: str, z: list[int], eta1: float, eta2: float, driver: types.Driver) -> None:
        """Table 4.6 for both drivers, self-locking included."""
        teeth = z[:3] if layout == "AIbar" else z
        train = network_of(layout, teeth, 3, (eta1, eta2))
        assume(layout in ("AI", "AIbar") or z[1] * z[3] != z[0] * z[2])
        i = ratio_of(train)
        expected = float(types.efficiency(float(i), eta1 * eta2, driver))
        found = efficiency_of(train if driver == "1" else train.reversed())
        amplified = 1 + 1 / abs(float(i))
        assert found.efficiency == pytest.approx(expected, rel=1e-12, abs=1e-14 * amplified**2)
        if abs(expected) > 1e-9:
            assert found.self_locking == bool(types.self_locking(float(i), eta1 * eta2, driver))

    @EXAMPLES
    @given(st.lists(TEETH, min_size=4, max_size=4), ETA, ETA, ETA)
    def test_pairs_of_planets(self, z: list[int], eta1: float, eta2: float, eta3: float) -> None:
        train = network_of("2A-AA", z, 3, (eta1, eta2, eta3))
        i, eta0 = 1 + z[3] / z[0], eta1 * eta2 * eta3
        assert efficiency_of(train).efficiency == pytest.approx(eta0 + (1 - eta0) / i, rel=1e-12)
        assert efficiency_of(train.reversed()).efficiency == pytest.approx(i / (1 - (1 - i) / eta0), rel=1e-12)

    @EXAMPLES
    @given(st.lists(TEETH, min_size=5, max_size=5), st.lists(st.floats(0.99, 1.0), min_size=3, max_size=3))
    def test_three_central_wheels(self, z: list[int], etas: list[float]) -> None:
        """AII: efficiency as ratio of torques, each tooth ratio weighted by the sense in which it acts (Kreines).

        i = (1 + a b)/(1 - b c) with a = z2/z1, b = z3/z2, c = z2'/z4; i* has a -> a eta^x, x = sign of d ln i/d ln a,
        and eta = i*/i, as long as the losses reverse no power.
        """
        z1, z2, z2b, z3, z4 = z
        ratios = np.array([z2 / z1, z3 / z2, z2b / z4])

        def ratio(a: float, b: float, c: float) -> float:
            return (1 + a * b) / (1 - b * c)

        a, b, c = ratios
        assume(abs(1 - b * c) > 0.2)
        slopes = np.array([a * b / (1 + a * b), a * b / (1 + a * b) + b * c / (1 - b * c), b * c / (1 - b * c)])
        assume((np.abs(slopes) > 0.05).all())
        expected = ratio(*(ratios * np.array(etas) ** np.sign(slopes))) / ratio(*ratios)
        train = network_of("AII", z, 3, etas)
        assert efficiency_of(train).efficiency == pytest.approx(expected, rel=1e-11)

    @EXAMPLES
    @given(st.lists(TEETH, min_size=4, max_size=4), ETA, ETA)
    def test_fixed_axes(self, z: list[int], eta1: float, eta2: float) -> None:
        for layout in ("unfolded2", "coaxial"):
            train = network_of(layout, z, 1, (eta1, eta2))
            for way in (train, train.reversed()):
                assert efficiency_of(way).efficiency == pytest.approx(eta1 * eta2, rel=1e-13)

    def test_bevel_differential(self) -> None:
        """Right wheel held: i = 2, power rolls with half the speed; one wheel to the other at eta of both meshes."""
        train = bevel_differential(16, 10, 16, efficiency=0.96)
        eta0 = 0.96**2
        assert efficiency(train, "left", "right", fixed="H").efficiency == pytest.approx(eta0)
        assert efficiency(train, "left", "H", fixed="right").efficiency == pytest.approx((1 + eta0) / 2)
        assert efficiency(train, "H", "left", fixed="right").efficiency == pytest.approx(2 / (1 + 1 / eta0))

    def test_locked_train_has_no_losses(self) -> None:
        train = network_of("AI", (22, 118, 17, 97), 3, 0.95).network
        assert efficiency(train, "1", "3", locked=(("1", "H"),)).efficiency == pytest.approx(1.0, abs=1e-14)

    def test_output_that_stands(self) -> None:
        with pytest.raises(NoSolutionError, match="output 'H' stands"):
            efficiency(Network((Mesh("1", 20, "2", 40), Mesh("a", 9, "H", 9))), "1", "H", fixed="a")


class TestFlow:
    def test_torques_by_hand(self) -> None:
        """AI-bar, ring held: T3 = T1 U eta0, TH = -(T1 + T3); each of K planets takes its part."""
        train = network_of("AIbar", (18, 48, 114), 3, (0.97, 0.98), sharing=1.2)
        flow = solve_power(train.network, {"1": 100.0, "3": 0.0}, {"1": 22.0}, outputs=("H",))
        t3 = 22 * 114 / 18 * 0.97 * 0.98
        assert flow.torque("3") == pytest.approx(t3)
        assert flow.torque("H") == pytest.approx(-22 - t3)
        assert flow.branch_torques[0] == pytest.approx([22 * 1.2 / 3, 22 * 48 / 18 * 0.97 * 1.2 / 3])
        rolling = 22 * 100 * (1 - 3 / 22)
        assert flow.rolling == pytest.approx([rolling, rolling * 0.97])
        assert flow.losses == pytest.approx([rolling * 0.03, rolling * 0.97 * 0.02])
        assert flow.power_in == 2200
        assert not flow.loops

    def test_load_and_torque_agree(self) -> None:
        """The load found from the driving torque needs that torque."""
        train = network_of("AA", (30, 60, 25, 61), 1, 0.98)
        forward = solve_power(train.network, {"1": 5.0, "3": 0.0}, {"1": 3.0}, outputs=("H",))
        assert flow_of(train, 5.0, forward.torque("H")).torque("1") == pytest.approx(3.0, rel=1e-13)

    def test_two_inputs(self) -> None:
        """A differential with both wheels driven: both put power in, the carrier gives it out."""
        train = bevel_differential(20, 12, 40, efficiency=0.98)
        flow = solve_power(train, {"left": 30.0, "right": 10.0}, {"H": -9.0})
        check = {name: flow.power(name) for name in ("left", "right", "H")}
        assert check["left"] > 0 < check["right"]
        assert check["H"] == pytest.approx(-9 * (20 * 30 + 40 * 10) / 60)
        assert flow.torque("left") + flow.torque("right") == pytest.approx(9.0)
        # in the carrier's frame the left wheel drives the right one: T_right = eta^2 (40/20) T_left
        assert flow.torque("right") == pytest.approx(0.98**2 * 2 * flow.torque("left"))
        assert flow.losses.sum() == pytest.approx(flow.powers.sum())

    def test_clutch(self) -> None:
        """Carrier and wheel 1 locked: what is not taken at the wheel passes through the lock."""
        train = network_of("AIbar", (18, 48, 114), 3, 0.97).network
        flow = solve_power(train, {"1": 10.0}, {"3": -57.0}, locked=(("1", "H"),))
        assert flow.torque("1") == pytest.approx(57.0)
        # sun : ring = 18 : 114 in equilibrium, so the meshes load the sun with 9 and the lock with the rest
        assert flow.mesh_torques[0, 0] == pytest.approx(9.0)
        assert flow.lock_torques == pytest.approx([-(57.0 + 9.0)])
        assert flow.losses.tolist() == [0, 0]
        assert flow.efficiency == pytest.approx(1.0)

    def test_brake(self) -> None:
        """A ring locked to the frame is a held ring."""
        train = network_of("AIbar", (18, 48, 114), 3, 0.97).network
        held = solve_power(train, {"1": 10.0, "3": 0.0}, {"H": -50.0})
        braked = solve_power(train, {"1": 10.0}, {"H": -50.0}, locked=(("3", FRAME),))
        assert braked.torque("1") == pytest.approx(held.torque("1"), rel=1e-14)
        assert braked.lock_torques == pytest.approx([held.torque("3")], rel=1e-14)

    def test_no_load(self) -> None:
        flow = flow_of(network_of("AI", (22, 118, 17, 97), 3, 0.97), 10.0, 0.0)
        assert flow.efficiency is None
        assert not flow.torques.any()
        assert not flow.self_locking


class TestSelfLocking:
    """AA of i_1H = 1/20: wheel 1 can lower a load but not raise it."""

    train = network_of("AA", (20, 19, 20, 20), 1, math.sqrt(0.9))

    def test_raise(self) -> None:
        with pytest.raises(
            NoSolutionError, match=r"self-locking: with torques H = -1 .*turns up to 0\.4934 times"
        ) as e:
            flow_of(self.train, 1.0, -1.0)
        # it locks from 1 - eta0 = i_1H = 0.05 on, both meshes alike
        assert e.value.limit == pytest.approx((1 - math.sqrt(0.95)) / (1 - math.sqrt(0.9)), rel=1e-5)

    def test_lower(self) -> None:
        """Its own weight cannot drive wheel 1 back; the flow is that of the driving carrier."""
        flow = flow_of(self.train, 1.0, 1.0)
        assert flow.power("H") > 0 > flow.power("1")
        assert flow.efficiency == pytest.approx(float(types.efficiency(0.05, 0.9, "H")))

    def test_driven(self) -> None:
        """With the torque of wheel 1 given all its power and that of the load is lost."""
        flow = solve_power(self.train.network, {"1": 1.0, "3": 0.0}, {"1": 1.0}, outputs=("H",))
        assert flow.self_locking
        assert flow.efficiency == 0
        assert flow.losses.sum() == pytest.approx(flow.power_in)
        result = efficiency_of(self.train)
        assert result.efficiency == pytest.approx(-1.1111111111)
        assert result.potential == pytest.approx(19 / 0.9)

    def test_all_directions_searched(self) -> None:
        """No agreement that a search by hand over all directions finds is missed, none is made up."""
        rng = np.random.default_rng(5)
        met = 0
        for _ in range(60):
            z = rng.integers(17, 60, 4)
            if z[1] * z[3] == z[0] * z[2]:
                continue
            eta = rng.uniform(0.85, 1.0, 2)
            train = network_of("AA", z.tolist(), 1, eta.tolist())
            possible = self._by_hand(z, eta)
            met += not possible
            try:
                torque = flow_of(train, 1.0, -float(np.sign(ratio_of(train)))).torque("1")
            except NoSolutionError:
                assert not possible
            else:
                assert any(torque == pytest.approx(t, rel=1e-9) for t in possible)
        assert met > 3

    @staticmethod
    def _by_hand(z: np.ndarray, eta: np.ndarray) -> list[float]:
        """Torques of wheel 1 that agree with their directions, load 1 against H: T3 = -T1 u e, TH = -T1 - T3."""
        u = z[1] * z[3] / (z[0] * z[2])
        w_h = 1 / (1 - u)
        found = []
        for e in product((1, -1), repeat=2):
            both = eta[0] ** e[0] * eta[1] ** e[1]
            t1 = np.sign(w_h) / (1 - u * both)  # TH = -T1 (1 - u e) = -sign(wH)
            driving = np.sign(t1 * (1 - w_h))
            if e == (driving, driving):
                found.append(float(t1))
        return found


class TestFaults:
    aibar = network_of("AIbar", (18, 48, 114), 3).network

    def test_nothing_balances(self) -> None:
        with pytest.raises(UsageError, match=r"nothing balances .*H.*: 1 more .*now: 3") as caught:
            solve_power(self.aibar, {"1": 1.0, "3": 0.0}, {"1": 5.0})
        assert (caught.value.value, caught.value.limit) == (1, 2)

    def test_indeterminate(self) -> None:
        with pytest.raises(UsageError, match=r"cannot tell the torques of .*torque on 3, torque on 1, torque on H"):
            solve_power(self.aibar, {"1": 1.0, "3": 0.0}, {}, outputs=("H",))

    def test_redundant_mesh(self) -> None:
        train = Network((Mesh("a", 20, "b", 40), Mesh("a", 30, "b", 60)))
        with pytest.raises(UsageError, match=r"torques of a-b \(20/40\), a-b \(30/60\) apart"):
            solve_power(train, {"a": 1.0}, {"b": -1.0})

    def test_torque(self) -> None:
        with pytest.raises(UsageError, match="torque on 'H' is inf"):
            solve_power(self.aibar, {"1": 1.0, "3": 0.0}, {"H": math.inf})


def test_names() -> None:
    train = network_of("AIbar", (18, 48, 114))
    assert train.reversed() == Train(train.network, "H", "1", ("3",))
    assert train.network == Network((Mesh("1", 18, "2", 48), Mesh("2", 48, "3", 114, INTERNAL)), (Body("2", "H"),))
    with pytest.raises(UsageError, match="has 3 wheels, 2 numbers"):
        network_of("AIbar", (18, 48))
    with pytest.raises(UsageError, match="has 2 meshes, 3 numbers"):
        network_of("AIbar", (18, 48, 114), 1, (0.9, 0.9, 0.9))
