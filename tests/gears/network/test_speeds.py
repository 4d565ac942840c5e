"""Speeds: Willis by hand, linear algebra in floats, invariance."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from gears.network.trains import EXAMPLES, TEETH, sets, trains
from tmmcalc.core.errors import NoSolutionError, TmmError, UsageError
from tmmcalc.gears.network.builder import bevel_differential, network_of, ratio_of
from tmmcalc.gears.network.model import FRAME, INTERNAL, Body, Mesh, Network
from tmmcalc.gears.network.speeds import mobility, ratio, solve_speeds

AIBAR = Network((Mesh("1", 18, "2", 48), Mesh("2", 48, "3", 114, INTERNAL)), (Body("2", "H", 3),))


def ravigneaux(s1: int, short: int, long: int, s2: int, ring: int) -> Network:
    meshes = (
        Mesh("s1", s1, "short", short),
        Mesh("short", short, "long", long),
        Mesh("s2", s2, "long", long),
        Mesh("long", long, "ring", ring, INTERNAL),
    )
    return Network(meshes, (Body("short", "H", 3), Body("long", "H", 3)))


class TestWillis:
    """Ratios against formulas derived by hand, exactly."""

    @EXAMPLES
    @given(st.lists(TEETH, min_size=6, max_size=6))
    def test_layouts(self, z: list[int]) -> None:
        z1, z2, z2b, z3, z3b, z4 = z
        u = Fraction(z2 * z3, z1 * z2b)
        assert ratio_of(network_of("unfolded2", (z1, z2, z2b, z3))) == u
        assert ratio_of(network_of("unfolded3", z)) == -u * Fraction(z4, z3b)
        assert ratio_of(network_of("coaxial", (z1, z2, z2b, z3), planets=3)) == u
        assert ratio_of(network_of("AI", (z1, z2, z2b, z3))) == 1 + u
        assert ratio_of(network_of("AIbar", (z1, z2, z3))) == 1 + Fraction(z3, z1)
        assert ratio_of(network_of("2A-AA", (z1, z2, z3, z4))) == 1 + Fraction(z4, z1)
        if u != 1:
            assert ratio_of(network_of("AA", (z1, z2, z2b, z3))) == 1 - u
            assert ratio_of(network_of("II", (z1, z2, z2b, z3))) == 1 - u
        if z3 * z2b != z2 * z4:
            three = (1 + Fraction(z3, z1)) / (1 - Fraction(z3 * z2b, z2 * z4))
            assert ratio_of(network_of("AII", (z1, z2, z2b, z3, z4))) == three

    @EXAMPLES
    @given(TEETH, TEETH, TEETH, TEETH)
    def test_inverted(self, z1: int, z2: int, z2b: int, z3: int) -> None:
        train = network_of("AI", (z1, z2, z2b, z3)).network
        assert ratio(train, "1", "3", fixed="H") == -Fraction(z2 * z3, z1 * z2b)
        assert ratio(train, "2", "H", fixed="3") == 1 - Fraction(z3, z2b)

    def test_ferguson(self) -> None:
        """The paradox of 1 : 10 000 with wheels of 99, 100 and 101 teeth."""
        assert 1 / ratio_of(network_of("AA", (100, 101, 100, 99))) == 10_000

    def test_ravigneaux(self) -> None:
        s1, s2, ring = 30, 36, 74
        train = ravigneaux(s1, 18, 19, s2, ring)
        assert mobility(train) == 2
        assert ratio(train, "s1", "ring", fixed="H") == Fraction(ring, s1)
        assert ratio(train, "s2", "ring", fixed="H") == -Fraction(ring, s2)
        assert ratio(train, "s1", "ring", fixed="s2") == Fraction(ring * (s1 + s2), s1 * (ring + s2))
        assert ratio(train, "H", "ring", fixed="s2") == Fraction(ring, ring + s2)

    def test_planet_on_a_planet(self) -> None:
        """H held, the block q of H bears p; s turns on the axis of q and is locked to H."""
        meshes = (Mesh("a", 24, "q", 16), Mesh("s", 30, "p", 12))
        train = Network(meshes, (Body("q", "H"), Body("s", "H"), Body("p", "q")))
        assert train.carriers == ("H", "q")
        assert mobility(train) == 3
        motion = solve_speeds(train, {"H": 0.0, "a": 1.0}, locked=(("s", "H"),))
        q = -24 / 16
        assert motion.speed("p") == pytest.approx(q * (1 + 30 / 12), rel=1e-15)

    def test_wheel_of_the_frame(self) -> None:
        held = Network((Mesh("1", 18, "2", 48), Mesh("2", 48, FRAME, 114, INTERNAL)), (Body("2", "H"),))
        assert mobility(held) == 1
        assert ratio(held, "1", "H") == ratio(AIBAR, "1", "H", fixed="3") == Fraction(22, 3)


class TestBevel:
    """A tilted planet: its speed is relative to the carrier."""

    @EXAMPLES
    @given(TEETH, TEETH, TEETH, st.integers(-50, 50), st.integers(-50, 50))
    def test_differential(self, z1: int, planet: int, z3: int, w1: int, w_h: int) -> None:
        motion = solve_speeds(bevel_differential(z1, planet, z3), {"left": float(w1), "H": float(w_h)})
        assert motion.speed("right") == float(w_h - Fraction(z1, z3) * (w1 - w_h))
        assert motion.speed("planet") == float(Fraction(z1, planet) * (w1 - w_h))
        assert motion.rolling[1].tolist() == [float(-Fraction(z1, z3) * (w1 - w_h)), motion.speed("planet")]

    def test_locked(self) -> None:
        motion = solve_speeds(bevel_differential(16, 10, 16), {"left": 7.0}, locked=(("planet", "H"),))
        assert dict(zip(motion.members, motion.speeds, strict=True)) == {"left": 7, "right": 7, "H": 7, "planet": 0}

    def test_lock_elsewhere(self) -> None:
        with pytest.raises(UsageError, match="cannot be locked to 'left'"):
            solve_speeds(bevel_differential(16, 10, 16), {"left": 7.0}, locked=(("planet", "left"),))


class TestRandom:
    @EXAMPLES
    @given(trains(), st.data())
    def test_against_floats(self, network: Network, data: st.DataObject) -> None:
        """The equations in floats, written anew, hold for the speeds and have no other solution."""
        assert mobility(network) == 2
        a, b = data.draw(st.permutations(network.members))[:2]
        try:
            motion = solve_speeds(network, {a: 3.0, b: -2.0})
        except TmmError:
            assume(False)
        n, w = len(network.members), motion.speeds
        place = {name: i for i, name in enumerate(network.members)}
        rows, right = np.zeros((n, n)), np.zeros(n)
        for k, (mesh, carrier) in enumerate(zip(network.meshes, network.carriers, strict=True)):
            rows[k, place[mesh.first]] += 1
            rows[k, place[mesh.second]] -= mesh.sign * mesh.second_teeth / mesh.first_teeth
            if carrier != FRAME:
                rows[k, place[carrier]] -= 1 - mesh.sign * mesh.second_teeth / mesh.first_teeth
        rows[-2, place[a]] = rows[-1, place[b]] = 1
        right[-2:] = 3.0, -2.0
        expected = np.linalg.solve(rows, right)
        np.testing.assert_allclose(w, expected, rtol=0, atol=1e-13 * np.linalg.cond(rows) * np.abs(w).max())
        np.testing.assert_array_equal(np.sign(w), np.sign(np.round(expected, 12)))

    @EXAMPLES
    @given(sets(), st.integers(-40, 40))
    def test_added_constant(self, network: Network, shift: int) -> None:
        """Turning the whole set adds the same speed to every member and leaves the rolling as it is."""
        try:
            still = solve_speeds(network, {"c0": 5.0, "H": 0.0})
        except TmmError:
            assume(False)
        turned = solve_speeds(network, {"c0": 5.0 + shift, "H": float(shift)})
        np.testing.assert_allclose(turned.speeds, still.speeds + shift, rtol=1e-14, atol=1e-12)
        np.testing.assert_array_equal(turned.rolling, still.rolling)

    @EXAMPLES
    @given(sets())
    def test_lock_up(self, network: Network) -> None:
        """Two central members locked together turn the set as one body."""
        motion = solve_speeds(network, {"H": 9.0}, locked=(("c0", "H"),))
        assert set(motion.speeds.tolist()) == {9.0}
        assert not motion.rolling.any()

    @EXAMPLES
    @given(trains(), st.data())
    def test_order_and_sides(self, network: Network, data: st.DataObject) -> None:
        turned = [Mesh(m.second, m.second_teeth, m.first, m.first_teeth, m.sign, m.efficiency) for m in network.meshes]
        other = Network(tuple(data.draw(st.permutations(turned))), network.bodies)
        a, b = data.draw(st.permutations(network.members))[:2]
        try:
            motion = solve_speeds(network, {a: 1.0, b: 0.25})
        except TmmError:
            assume(False)
        again = solve_speeds(other, {b: 0.25, a: 1.0})
        assert [again.speed(name) for name in network.members] == motion.speeds.tolist()

    @EXAMPLES
    @given(trains(), st.data())
    def test_ratio_is_the_quotient(self, network: Network, data: st.DataObject) -> None:
        a, b, held = data.draw(st.permutations(network.members))[:3]
        try:
            exact = ratio(network, a, b, fixed=held)
            assume(exact != 0)
            back = ratio(network, b, a, fixed=held)
        except TmmError:
            assume(False)
        motion = solve_speeds(network, {held: 0.0, b: 12.5})
        assert exact * back == 1
        assert motion.speed(a) == float(exact * Fraction(25, 2))


class TestFaults:
    def test_undetermined(self) -> None:
        with pytest.raises(UsageError, match=r"speeds of 2, 3, H are not determined: 1 more .*given: 1 = 4") as caught:
            solve_speeds(AIBAR, {"1": 4.0})
        assert (caught.value.value, caught.value.limit) == (1, 2)

    def test_too_many(self) -> None:
        with pytest.raises(UsageError, match=r"'H' is given 2 rad/s, but 3 = 0, 1 = 22 make it 3"):
            solve_speeds(AIBAR, {"3": 0.0, "1": 22.0, "H": 2.0})

    def test_too_many_that_agree(self) -> None:
        assert solve_speeds(AIBAR, {"3": 0.0, "1": 0.1, "H": 0.1 * 3 / 22}).speed("H") == pytest.approx(0.3 / 22)

    def test_held_fast(self) -> None:
        with pytest.raises(NoSolutionError, match=r"'1' is given 5 rad/s, but 3 = 0, H = 0 let it not turn"):
            solve_speeds(AIBAR, {"3": 0.0, "1": 5.0, "H": 0.0})

    def test_infinite_ratio(self) -> None:
        with pytest.raises(NoSolutionError, match="'1' is given 1 rad/s, but 3 = 0 let it not turn"):
            ratio(network_of("AA", (20, 40, 40, 20)).network, "H", "1", fixed="3")

    def test_loop_that_contradicts(self) -> None:
        good = (Mesh("a", 20, "b", 40), Mesh("a", 30, "b", 60), Mesh("b", 17, "c", 34))
        motion = solve_speeds(Network(good), {"a": 1.0})
        assert motion.redundant == ("a-b (30/60)",)
        assert motion.speed("c") == 0.25
        bad = (Mesh("b", 17, "c", 34), Mesh("a", 20, "b", 40), Mesh("a", 30, "b", 61))
        with pytest.raises(NoSolutionError, match=r"a-b \(20/40\), a-b \(30/61\).* hold one another"):
            solve_speeds(Network(bad), {"a": 1.0})

    def test_epicyclic_loop_that_contradicts(self) -> None:
        meshes = (Mesh("1", 18, "2", 48), Mesh("2", 48, "3", 114, INTERNAL), Mesh("1", 20, "2", 46))
        with pytest.raises(NoSolutionError, match=r"meshes 1-2 \(18/48\), 2-3 \(48/114\), 1-2 \(20/46\) hold"):
            solve_speeds(Network(meshes, (Body("2", "H"),)), {"1": 1.0, "3": 0.0})

    def test_members(self) -> None:
        with pytest.raises(UsageError, match="no member '7'") as caught:
            solve_speeds(AIBAR, {"7": 1.0})
        assert "1, 2, 3, H" in str(caught.value)
        with pytest.raises(UsageError, match="speed of '1' is nan"):
            solve_speeds(AIBAR, {"1": float("nan")})

    @pytest.mark.parametrize(
        ("build", "match"),
        [
            (lambda: Mesh("1", 0, "2", 5), "tooth numbers below 1"),
            (lambda: Mesh("1", 9, "1", 5), "in mesh with itself"),
            (lambda: Mesh("1", 9, "2", 5, 0), "sign of mesh"),
            (lambda: Mesh("1", 9, "2", 5, efficiency=1.2), "efficiency of mesh"),
            (lambda: Body("2", "H", 0), "at least 1"),
            (lambda: Body("2", "H", 3, sharing=0.5), "load-sharing"),
            (lambda: Body("H", "H"), "cannot be borne"),
            (lambda: Network((), (Body("2", "H"), Body("2", "H"))), "described twice"),
            (lambda: Network((), (Body("2", "H"), Body("H", "2"))), "in a ring"),
            (lambda: Network((), (Body("2", "H", tilted=True), Body("3", "2"))), "parallel axis"),
            (lambda: Network((Mesh("2", 9, "3", 9),), (Body("2", "H"), Body("3", "G"))), "keeps the axes"),
        ],
    )
    def test_model(self, build: object, match: str) -> None:
        with pytest.raises(UsageError, match=match):
            build()
