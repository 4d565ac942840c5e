"""Trains that are written out: what is inferred, loads, the closed formulas, power that circulates by hand."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gears.network.trains import EXAMPLES, TEETH
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.gears.gearing import solve_gearing
from tmmcalc.gears.gearingtask import GearingTask, layout_task
from tmmcalc.gears.network.basic import basic_train
from tmmcalc.gears.network.builder import bevel_differential, network_of
from tmmcalc.gears.network.model import FRAME, INTERNAL, Body, Mesh, Network

SIMPLE = Network((Mesh("1", 18, "2", 48), Mesh("2", 48, "3", 114, INTERNAL)), (Body("2", "H", 3),))


def closed(eta: float = 1.0) -> Network:
    """Shaft x drives ring (1 : -1) and sun (1 : 2) of a differential whose carrier is the output."""
    meshes = (
        Mesh("sun", 20, "planet", 20, efficiency=eta),
        Mesh("planet", 20, "ring", 60, INTERNAL, eta),
        Mesh("x", 40, "ring", 40, efficiency=eta),
        Mesh("x", 40, "sun", 20, INTERNAL, eta),
    )
    return Network(meshes, (Body("planet", "H", 3),))


class TestEnds:
    """Which member drives and which is driven."""

    @pytest.mark.parametrize(
        ("task", "driver", "outputs"),
        [
            (GearingTask(SIMPLE, {"1": 10.0, "3": 0.0}), "1", ("H",)),
            (GearingTask(SIMPLE, {"H": 10.0, "3": 0.0}), "H", ("1",)),
            (GearingTask(SIMPLE, {"H": 10.0, "3": 0.0}, loads={"H": 5.0}), "1", ("H",)),
            (GearingTask(SIMPLE, {"H": 10.0, "3": 0.0}, powers={"H": -5.0}), "1", ("H",)),
            (GearingTask(SIMPLE, {"1": 10.0, "3": 0.0}, powers={"1": 5.0}), "1", ("H",)),
            (GearingTask(SIMPLE, {"1": 10.0, "3": 0.0}, torques={"H": 5.0}), "1", ("H",)),
            (GearingTask(SIMPLE, {"1": 10.0, "H": 0.0}, input="3"), "3", ()),
            (GearingTask(SIMPLE, {"1": 10.0, "3": 5.0}, outputs=("H",)), None, ("H",)),
        ],
    )
    def test_inferred(self, task: GearingTask, driver: str | None, outputs: tuple[str, ...]) -> None:
        found = solve_gearing(task)
        assert (found.input, found.outputs) == (driver, outputs)

    def test_layout(self) -> None:
        """Held wheel and driver are added as far as speeds leave room for them."""
        teeth = (18, 48, 114)
        assert layout_task("AIbar", teeth).speeds == {"3": 0.0, "1": 1.0}
        assert layout_task("AIbar", teeth, 3, {"H": 4.0}).speeds == {"3": 0.0, "H": 4.0}
        assert layout_task("AIbar", teeth, 3, {"3": 4.0, "1": 0.0}).speeds == {"3": 4.0, "1": 0.0}
        assert layout_task("coaxial", (17, 64, 17, 37), 3).speeds == {"1": 1.0}
        with pytest.raises(UsageError, match="4 wheels"):
            layout_task("AI", teeth)


class TestLoads:
    @pytest.mark.parametrize(
        "known", [{"loads": {"H": 220.0}}, {"torques": {"H": -220.0}}, {"powers": {"H": -220.0 * 3}}]
    )
    def test_three_ways(self, known: dict[str, dict[str, float]]) -> None:
        """Ideal train, i = 22/3: 220 N*m on the carrier are 30 N*m on the sun and 190 N*m on the ring."""
        flow = solve_gearing(GearingTask(SIMPLE, {"1": 22.0, "3": 0.0}, **known)).flow
        assert flow is not None
        assert [flow.torque(name) for name in ("1", "3", "H")] == pytest.approx([30.0, 190.0, -220.0], rel=1e-13)

    def test_load_follows_the_motion(self) -> None:
        for speed in (22.0, -22.0):
            flow = solve_gearing(GearingTask(SIMPLE, {"1": speed, "3": 0.0}, loads={"H": 220.0})).flow
            assert flow is not None
            assert flow.power("H") < 0
            assert flow.torque("1") == pytest.approx(math.copysign(30.0, speed))

    def test_load_of_what_stands(self) -> None:
        with pytest.raises(UsageError, match="a load is known of '3', which stands"):
            solve_gearing(GearingTask(SIMPLE, {"1": 22.0, "3": 0.0}, loads={"3": 1.0}))

    def test_without_any_a_unit_drives(self) -> None:
        found = solve_gearing(GearingTask(SIMPLE, {"1": -22.0, "3": 0.0}))
        assert found.assumed
        assert found.flow is not None
        assert found.flow.torque("1") == -1.0
        assert found.flow.power_in == pytest.approx(22.0)

    def test_two_speeds_and_no_load(self) -> None:
        """Nothing says which shaft drives."""
        found = solve_gearing(GearingTask(SIMPLE, {"1": 22.0, "3": 4.0}))
        assert found.flow is None
        assert found.ways == ()
        assert found.ratio_to("H") is None

    def test_bevel_differential(self) -> None:
        """Both half shafts take half the torque on the cage, whatever their speeds."""
        task = GearingTask(
            bevel_differential(16, 10, 16), {"H": 30.0, "left": 10.0}, torques={"H": 80.0}, outputs=("left", "right")
        )
        found = solve_gearing(task)
        assert found.motion.speed("right") == 50.0
        assert found.flow is not None
        assert [found.flow.torque(name) for name in ("left", "right")] == pytest.approx([-40.0, -40.0])
        place = task.network.place
        assert found.motion.transfer[place["right"]] == (Fraction(2), Fraction(-1))


class TestWays:
    @EXAMPLES
    @given(st.sampled_from(("AIbar", "AI", "AA", "II")), st.lists(TEETH, min_size=4, max_size=4), st.floats(0.9, 1.0))
    def test_closed_formula(self, layout: str, z: list[int], eta: float) -> None:
        """Table 4.6 beside the equilibrium of the network, both ways, self-locking included."""
        teeth = z[:3] if layout == "AIbar" else z
        if layout in ("AA", "II") and z[1] * z[3] == z[0] * z[2]:
            return
        found = solve_gearing(layout_task(layout, teeth, efficiency=eta))
        assert [(way.driver, way.output) for way in found.ways] == [("1", "H"), ("H", "1")]
        amplified = (1 + abs(float(found.ways[1].ratio))) ** 2
        for way in found.ways:
            assert way.formula is not None
            assert way.efficiency == pytest.approx(way.formula, rel=1e-11, abs=1e-14 * amplified)
        assert found.ways[0].ratio * found.ways[1].ratio == 1

    def test_self_locking_load(self) -> None:
        """Table 4.6: with i_1H = 0.05 wheel 1 cannot drive; the load is told to be held, the rest is there."""
        task = layout_task("AA", (20, 19, 20, 20), speeds={"1": 1.0}, efficiency=0.95)
        found = solve_gearing(GearingTask(task.network, task.speeds, loads={"H": 5.0}))
        assert found.ways[0].self_locking
        assert not found.ways[1].self_locking
        assert found.flow is None
        assert "self-locking" in found.locking
        assert found.motion.speed("H") == pytest.approx(20.0)

    def test_a_train_that_is_dead(self) -> None:
        with pytest.raises(NoSolutionError, match="let it not turn"):
            solve_gearing(layout_task("AA", (20, 40, 40, 20)))

    def test_standing_output(self) -> None:
        """The ring turns with a lock of the sun to the frame: no ratio to what stands."""
        found = solve_gearing(GearingTask(SIMPLE, {"3": 5.0}, locked=(("1", FRAME),), outputs=("1",)))
        assert found.ways == ()
        assert found.ratio_to("1") is None


class TestCirculating:
    """w_sun + 3 w_ring = 4 w_H, torques 1 : 3 : -4; w_sun = 2, w_ring = -1, w_H = -1/4 of x."""

    def test_by_hand(self) -> None:
        """Of 4 put in the ring takes 12, the sun brings 8 back."""
        found = solve_gearing(GearingTask(closed(), {"x": 1.0}, powers={"x": 4.0}, outputs=("H",)))
        assert (found.input, found.outputs) == ("x", ("H",))
        assert found.ratio_to("H") == -4
        assert found.flow is not None
        (loop,) = found.flow.loops
        assert loop.power == pytest.approx(8.0, rel=1e-13)
        assert found.flow.mesh_powers[2].tolist() == pytest.approx([-12.0, 12.0, 0.0])

    def test_losses_by_hand(self) -> None:
        """Torques step by step along the flow, eta each: rolling goes planet to sun and ring to planet."""
        eta = 0.98
        found = solve_gearing(GearingTask(closed(eta), {"x": 1.0}, powers={"x": 1.0}, outputs=("H",)))
        assert found.flow is not None
        # of unit torque on the sun: the ring has 3/eta^2; x gives 3/eta^3 to the ring and takes 2 eta from the sun
        sun = 1.0 / (3 / eta**3 - 2 * eta)
        expected = sun * (1 + 3 / eta**2) / 4
        assert found.flow.efficiency == pytest.approx(expected, rel=1e-12)
        assert found.ways[0].efficiency == pytest.approx(expected, rel=1e-12)
        (loop,) = found.flow.loops
        assert loop.power == pytest.approx(2 * eta * sun, rel=1e-12)


class TestBasic:
    def test_any_chain(self) -> None:
        """Pairs of planets and bevel planets are simple trains too; three central wheels are not."""
        pairs = basic_train(network_of("2A-AA", (18, 27, 27, 72), efficiency=0.98).network, ("4",))
        assert pairs is not None
        assert (pairs.first, pairs.carrier, pairs.last, pairs.ratio) == ("1", "H", "4", 5)
        assert pairs.efficiency == pytest.approx(0.98**3, rel=1e-15)
        bevel = basic_train(bevel_differential(16, 10, 16, efficiency=0.97), ("right",))
        assert bevel is not None
        assert (bevel.first, bevel.ratio) == ("left", 2)
        assert basic_train(network_of("AII", (20, 25, 28, 70, 73)).network, ("3",)) is None

    @pytest.mark.parametrize("held", [(), ("H",), ("1", "3")])
    def test_other_members_held(self, held: tuple[str, ...]) -> None:
        assert basic_train(SIMPLE, held) is None

    def test_ring_in_the_housing(self) -> None:
        found = basic_train(
            Network((Mesh("1", 18, "2", 48), Mesh("2", 48, FRAME, 114, INTERNAL)), (Body("2", "H"),)), ()
        )
        assert found is not None
        assert (found.ratio, found.last) == (Fraction(22, 3), FRAME)

    def test_ordinary_gears_and_more(self) -> None:
        assert basic_train(network_of("coaxial", (17, 64, 19, 37)).network, ()) is None
        more = Network((*SIMPLE.meshes, Mesh("1", 20, "shaft", 40)), SIMPLE.bodies)
        assert basic_train(more, ("3",)) is None


def test_assembly() -> None:
    """(Z1 + Z3)/K of the textbook."""
    assert solve_gearing(layout_task("AIbar", (18, 48, 114), 3)).assembly == 44
    assert solve_gearing(layout_task("AIbar", (18, 48, 115), 3)).assembly == Fraction(133, 3)
    assert solve_gearing(layout_task("AIbar", (18, 48, 114), 1)).assembly is None
    assert solve_gearing(layout_task("unfolded2", (17, 59, 17, 40))).assembly is None


def test_frequencies_are_those_of_the_motion() -> None:
    found = solve_gearing(layout_task("AIbar", (18, 48, 114), 3, {"H": 2 * math.pi}))
    np.testing.assert_allclose(found.frequencies.mesh, [114.0, 114.0], rtol=1e-14)
