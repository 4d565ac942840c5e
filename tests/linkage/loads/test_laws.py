"""Laws by themselves: tables over angles, positions and displacements, their seams; resistances; springs."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator
from transforms import moved

from linkage.loads.acting import Array, dense, power, scene_of, value, work
from linkage.scenes import (
    bar,
    crank_slider,
    driven_rod,
    four_bar,
    full_turn,
    part,
    pin,
    slotted,
    with_grid,
    with_input,
    with_output,
)
from tmmcalc import NoSolutionError, solve_kinematics
from tmmcalc.linkage.loading import Load, Spring, Window
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.law import Law
from tmmcalc.linkage.loadlaws.polynomial import Polynomial
from tmmcalc.linkage.loadlaws.quadratic import Quadratic
from tmmcalc.linkage.loadlaws.tabulated import Tabulated
from tmmcalc.linkage.loadlaws.viscous import Viscous
from tmmcalc.linkage.loads.interpolation import interpolant
from tmmcalc.linkage.model import Assembly, Input, Link, Mechanism, Output

TURN = 2 * np.pi
GRID = np.linspace(0.001, TURN - 0.001, 996)


def slider(start: float = 0.0, speed: float = 5.0) -> Mechanism:
    return with_input(full_turn(crank_slider(0.1, 0.3), start), speed=speed)


def push(law: Law, **options: Any) -> Load:
    return Load("Q", 3, "force", law, **options)


class TestTablesOfTheAngle:
    x = (0.3, 1.0, 2.5, 4.0, 5.5)
    y = (1.0, -2.0, 4.0, 3.0, 3.0)

    def test_linear_and_periodic(self) -> None:
        found = value(scene_of(slider(), push(Tabulated("angle", self.x, self.y, period=TURN))), GRID)
        np.testing.assert_allclose(found, np.interp(GRID, self.x, self.y, period=TURN), atol=1e-12)

    @pytest.mark.parametrize("speed", [5.0, -5.0])
    def test_they_follow_the_motion(self, speed: float) -> None:
        found = value(scene_of(slider(1.0, speed), push(Tabulated("angle", self.x, self.y, period=TURN))), GRID)
        np.testing.assert_allclose(found, np.interp(GRID, self.x, self.y, period=TURN), atol=1e-12)

    def test_pchip_is_smooth_over_the_seam(self) -> None:
        """The same as pchip through the points of three turns."""
        long = np.concatenate([np.array(self.x) + TURN * k for k in (-1, 0, 1)])
        expected = PchipInterpolator(long, np.tile(self.y, 3))(GRID)
        table = Tabulated("angle", self.x, self.y, "pchip", period=TURN)
        np.testing.assert_allclose(value(scene_of(slider(), push(table)), GRID), expected, atol=1e-12)

    def test_pchip_that_closes_is_smooth_over_the_seam_as_well(self) -> None:
        """Points over the whole period whose ends agree are a periodic law."""
        x, y = (0.0, 1.0, 2.5, 4.0, TURN), (2.0, 5.0, 4.0, -1.0, 2.0)
        law = interpolant(x, y, "pchip", TURN)
        step = 1e-6
        before, after = (law(np.array([TURN - step])) - 2.0)[0] / -step, (law(np.array([TURN + step])) - 2.0)[0] / step
        assert before == pytest.approx(after, rel=1e-4)
        turn = np.array(x[:-1])
        long = np.concatenate([turn + TURN * k for k in (-1, 0, 1)])
        np.testing.assert_allclose(law(GRID), PchipInterpolator(long, np.tile(y[:-1], 3))(GRID), atol=1e-12)

    @pytest.mark.parametrize("kind", ["linear", "pchip"])
    def test_a_jump_at_the_seam(self, kind: Any) -> None:
        """Points over the whole period may jump: position 0 takes the value after, the end the value before."""
        table = Tabulated("angle", (0.0, 2.0, TURN), (1.0, 5.0, -3.0), kind, period=TURN)
        found = value(scene_of(slider(), push(table)), np.array([0.0, 2.0, TURN]))
        np.testing.assert_allclose(found, [1.0, 5.0, -3.0], atol=1e-14)

    @pytest.mark.parametrize("kind", ["linear", "pchip"])
    def test_a_jump_elsewhere_takes_the_value_before(self, kind: Any) -> None:
        table = Tabulated("angle", (1.0, 3.0, 1.0 + TURN), (2.0, 5.0, -4.0), kind, period=TURN)
        found = value(scene_of(slider(), push(table)), np.array([0.0, 1.0 - 1e-6, 1.0, 1.0 + 1e-6, TURN]))
        np.testing.assert_allclose(found[[1, 2]], -4.0, atol=1e-4)
        np.testing.assert_allclose(found[3], 2.0, atol=1e-4)
        assert found[0] == pytest.approx(found[-1])

    @pytest.mark.parametrize("turns", [2, 0.5, 1 / 3])
    def test_other_periods(self, turns: float) -> None:
        period = TURN * turns
        x = tuple(np.array([0.05, 0.3, 0.8]) * period)
        scene = scene_of(slider(), push(Tabulated("angle", x, (1.0, 4.0, -2.0), period=period)))
        theta = np.linspace(0.01, scene.travel.period - 0.01, 700)
        np.testing.assert_allclose(value(scene, theta), np.interp(theta, x, (1.0, 4.0, -2.0), period=period), atol=1e-9)
        assert scene.travel.period == pytest.approx(TURN * max(1, turns))
        assert len(scene.edges()) >= 3 * round(scene.travel.period / period)

    def test_an_open_range_holds_the_ends(self) -> None:
        mechanism = part(crank_slider(0.1, 0.3), 0.5, 3.5)
        theta = np.linspace(0, 3, 301)
        table = Tabulated("angle", (1.0, 2.0, 2.5), (1.0, 4.0, -2.0), period=TURN)
        np.testing.assert_allclose(
            value(scene_of(mechanism, push(table)), theta), np.interp(theta, *table_points(table)), atol=1e-12
        )


def table_points(table: Tabulated) -> tuple[Array, Array]:
    return np.array(table.x), np.array(table.values)


class TestTablesOfPositions:
    def test_values_at_the_positions(self) -> None:
        mechanism = with_grid(slider(0.4), positions=6)
        table = Tabulated("position", (0.0, 1.0, 2.0, 3.0, 4.0, 5.0), (0.0, 5.0, 1.0, -2.0, 3.0, 4.0))
        found = value(scene_of(mechanism, push(table)), np.arange(7) * TURN / 6)
        np.testing.assert_allclose(found, [0.0, 5.0, 1.0, -2.0, 3.0, 4.0, 0.0], atol=1e-12)

    def test_a_first_and_a_last_value(self) -> None:
        mechanism = with_grid(slider(), positions=4)
        table = Tabulated("position", (0.0, 1.0, 2.0, 3.0, 4.0), (0.0, 5.0, 1.0, -2.0, 9.0))
        found = value(scene_of(mechanism, push(table)), np.arange(5) * TURN / 4)
        np.testing.assert_allclose(found, [0.0, 5.0, 1.0, -2.0, 9.0], atol=1e-12)

    def test_positions_at_unequal_steps(self) -> None:
        mechanism = with_grid(with_input(crank_slider(0.1, 0.3, 0.06), start=None), working=2, idle=4)
        kinematics = solve_kinematics(mechanism)
        table = Tabulated("position", tuple(range(6)), (0.0, 5.0, 1.0, -2.0, 3.0, 4.0))
        np.testing.assert_allclose(value(scene_of(mechanism, push(table)), kinematics.phi[:6]), table.values, atol=1e-9)

    def test_a_position_that_is_not_there(self) -> None:
        mechanism = with_grid(slider(), positions=4)
        with pytest.raises(NoSolutionError, match="no position 5; the grid has 5 positions"):
            scene_of(mechanism, push(Tabulated("position", (0.0, 5.0), (1.0, 2.0))))


class TestTablesOfTheDisplacement:
    @pytest.mark.parametrize("speed", [5.0, -5.0])
    @pytest.mark.parametrize("kind", ["linear", "pchip"])
    def test_of_a_slider(self, kind: Any, speed: float) -> None:
        mechanism = slider(0.7, speed)
        x, y = (0.02, 0.05, 0.15), (-100.0, 40.0, 10.0)
        scene = scene_of(mechanism, push(Tabulated("displacement", x, y, kind)))
        s = scene.place(GRID).configuration.motions[3].r.real - 0.2  # the inner dead centre stands at l2 - l1
        law = PchipInterpolator(x, y) if kind == "pchip" else lambda v: np.interp(v, x, y)
        np.testing.assert_allclose(value(scene, GRID), law(np.clip(s, x[0], x[-1])), atol=1e-9)

    def test_of_the_stroke(self) -> None:
        one = push(Tabulated("stroke", (0.0, 0.25, 1.0), (0.0, 8.0, 2.0)))
        two = push(Tabulated("displacement", (0.0, 0.05, 0.2), (0.0, 8.0, 2.0)))
        np.testing.assert_allclose(
            value(scene_of(slider(), one), GRID), value(scene_of(slider(), two), GRID), atol=1e-9
        )

    @pytest.mark.parametrize(
        ("x", "said"),
        [
            ((0.0, 0.3), "its table goes to 300 mm, but the stroke of B is 200 mm"),
            ((0.25, 0.3), "the whole table lies beyond it, and its first value holds throughout"),
        ],
    )
    def test_a_table_beyond_the_stroke_is_told(self, x: tuple[float, float], said: str) -> None:
        (grade,) = scene_of(slider(), push(Tabulated("displacement", x, (0.0, 8.0)))).grades
        assert (grade.severity, grade.where) == ("warning", "load Q")
        assert said in grade.message
        assert not scene_of(slider(), push(Tabulated("displacement", (0.0, 0.2), (0.0, 8.0)))).grades

    @pytest.mark.parametrize(
        ("x", "y", "said"),
        [
            (
                (0.0, 0.15),
                (8.0, 5.0),
                "ends at 150 mm, but the stroke of B is 200 mm: beyond it the last value 5 N is held",
            ),
            (
                (0.03, 0.2),
                (8.0, 5.0),
                "begins at 30 mm, but the stroke of B is 200 mm: before it the first value 8 N is held",
            ),
            ((0.03, 0.15), (8.0, 5.0), "begins at 30 mm and ends at 150 mm, but the stroke of B is 200 mm"),
            ((0.03, 0.15), (0.0, 5.0), "its table ends at 150 mm"),
            ((0.03, 0.15), (0.0, 0.0), ""),  # no load beyond the ends is what anyone means
            ((0.0001, 0.1999), (8.0, 5.0), ""),  # rounded abscissae
        ],
    )
    def test_a_table_short_of_the_stroke_is_told(
        self, x: tuple[float, float], y: tuple[float, float], said: str
    ) -> None:
        for law in (Tabulated("displacement", x, y), Tabulated("stroke", (x[0] / 0.2, x[1] / 0.2), y)):
            grades = scene_of(slider(), push(law)).grades
            assert len(grades) == bool(said)
            if said:
                assert (grades[0].severity, grades[0].where) == ("warning", "load Q")
                assert said in grades[0].message

    def test_a_table_need_not_go_beyond_its_window(self) -> None:
        """Over the first quarter turn from the outer dead centre on, S falls from 200 mm to 82.84 mm."""
        law, window = Tabulated("displacement", (0.08, 0.2), (8.0, 5.0)), Window(angles=(0.0, np.pi / 2))
        assert np.sqrt(0.09 - 0.01) - 0.2 == pytest.approx(0.08284, abs=1e-5)
        assert not scene_of(slider(), push(law, window=window)).grades
        (grade,) = scene_of(slider(), push(law, window=Window(angles=(0.0, 2.0)))).grades
        assert "begins at 80 mm" in grade.message

    def test_a_table_short_of_an_open_range_is_told(self) -> None:
        """A motion that is no cycle does not come back to the first value."""
        mechanism = part(crank_slider(0.1, 0.3), 0.2, 1.2, 10)
        (grade,) = scene_of(mechanism, push(Tabulated("angle", (0.0, 0.5), (8.0, 5.0)))).grades
        assert (
            "ends at 28.648 deg, but the motion goes from 0 to 57.296 deg: beyond it the last value 5 N"
            in grade.message
        )
        window = Window(angles=(0.1, 0.5))
        assert not scene_of(mechanism, push(Tabulated("angle", (0.0, 0.5), (8.0, 5.0)), window=window)).grades
        (grade,) = scene_of(mechanism, push(Tabulated("position", (4.0, 10.0), (8.0, 5.0)))).grades
        assert "begins at 22.918 deg" in grade.message

    def test_a_force_of_the_place_alone_does_no_work(self) -> None:
        scene = scene_of(slider(0.3), push(Tabulated("displacement", (0.0, 0.03, 0.11, 0.2), (0.0, -80.0, 50.0, 7.0))))
        assert abs(work(scene)) < 1e-12 * 80 * 0.2

    def test_of_an_angle_over_the_branch_cut(self) -> None:
        """The rocker stands on the left: its angle passes 180 degrees."""
        mechanism = four_bar(0.1, 0.4, 0.25, 0.4 + 0j)
        mechanism = with_output(full_turn(mechanism, 0.2), link=3)
        turned = moved(mechanism, 1.3, 0j)
        kinematics = solve_kinematics(turned)
        k = kinematics.trace.link_ids.index(3)
        angle = kinematics.trace.angle[k]
        assert np.ptp(np.angle(np.exp(1j * angle))) > np.ptp(angle) + 1
        centres = [centre.value for centre in kinematics.summaries[0].dead_centres]
        reach = max(centres) - min(centres)
        load = Load("M", 3, "moment", Tabulated("displacement", (0.0, reach), (0.0, reach)))
        found = value(scene_of(turned, load), kinematics.phi)
        np.testing.assert_allclose(found, angle - min(centres), atol=1e-9)

    def test_an_open_range_counts_from_its_lesser_end(self) -> None:
        mechanism = driven_rod(0.5, 0.3, 0.2)
        kinematics = solve_kinematics(mechanism)
        scene = scene_of(mechanism, push(Tabulated("displacement", (0.0, 0.02, 0.05), (1.0, 3.0, -5.0))))
        s = kinematics.s[0] - kinematics.s[0].min()
        np.testing.assert_allclose(value(scene, kinematics.phi), np.interp(s, (0, 0.02, 0.05), (1, 3, -5)), atol=1e-9)

    def test_an_output_that_goes_round_has_none(self) -> None:
        mechanism = with_output(full_turn(slotted(0.1, 0.3), 0.2), link=3)  # the slot turns fully
        with pytest.raises(NoSolutionError, match="goes round") as raised:
            scene_of(mechanism, Load("M", 3, "moment", Tabulated("stroke", (0.0, 1.0), (0.0, 1.0))))
        assert "table of the angle" in raised.value.remedy

    def test_an_output_at_rest_has_none(self) -> None:
        mechanism = with_output(slider(), point="B", direction=np.pi / 2)
        with pytest.raises(NoSolutionError, match="does not reverse"):
            scene_of(mechanism, push(Tabulated("stroke", (0.0, 1.0), (0.0, 1.0))))


class TestResistances:
    @pytest.mark.parametrize("speed", [5.0, -5.0])
    @pytest.mark.parametrize(("law", "exponent"), [(Viscous(30.0), 1), (Quadratic(30.0), 2)])
    def test_against_the_velocity_of_a_slider(self, law: Law, exponent: int, speed: float) -> None:
        scene = scene_of(slider(0.3, speed), push(law, factor=0.5))
        (source,) = scene.sources
        place = scene.place(GRID)
        v = place.configuration.motions[3].v.real * speed
        force = source.factor(speed) * source.actions(place)[0].force.real
        np.testing.assert_allclose(force, -15.0 * v * np.abs(v) ** (exponent - 1), rtol=1e-12, atol=1e-12)
        assert source.order == exponent
        assert np.all(power(scene, GRID) <= 0)

    def test_a_window_makes_no_sense(self) -> None:
        with pytest.raises(NoSolutionError, match="acts all the time") as raised:
            scene_of(slider(), push(Viscous(1.0), window=Window(stroke="working")))
        assert raised.value.where == "load Q"

    @pytest.mark.parametrize("law", [Viscous(3.0), Quadratic(3.0)])
    def test_between_two_moving_links(self, law: Law) -> None:
        """Against the relative speed: coupler and rocker of a four-bar, and a sliding contact."""
        mechanism = with_input(full_turn(four_bar(0.1, 0.4, 0.25, 0.4 + 0j), 0.2), speed=7.0)
        scene = scene_of(mechanism, Load("M", 2, "moment", law, against=3))
        place = scene.place(GRID)
        relative = (place.configuration.motions[2].omega - place.configuration.motions[3].omega) * 7.0
        size = 3.0 * relative * (np.abs(relative) if isinstance(law, Quadratic) else 1.0)
        np.testing.assert_allclose(power(scene, GRID), -size * relative, rtol=1e-11, atol=1e-11)

    def test_a_force_between_two_moving_links(self) -> None:
        """The same force in the same line: their sum is nothing, their moments too, and the power is relative."""
        mechanism = with_input(full_turn(four_bar(0.1, 0.4, 0.25, 0.4 + 0j), 0.2), speed=7.0)
        for law in (Viscous(20.0), Quadratic(5.0), Constant(3.0)):
            load = Load("F", 2, "force", law, 0.1 + 0.05j, np.exp(0.4j), follows=3, against=3)
            scene = scene_of(mechanism, load)
            place = scene.place(GRID)
            one, other = scene.sources[0].actions(place)
            assert (one.link, other.link) == (2, 3)
            np.testing.assert_allclose(one.force + other.force, 0.0, atol=1e-12)
            np.testing.assert_array_equal(one.at.r, other.at.r)
            # velocity against link 3 from differences of the place in the axes of 3
            step = 1e-5

            def place_in_3(theta: Array, scene: Any = scene) -> Array:
                motions = scene.place(theta).configuration.motions
                return (motions[2].point(0.1 + 0.05j).r - motions[3].r) / motions[3].u

            relative = (place_in_3(GRID + step) - place_in_3(GRID - step)) / (2 * step) * 7.0
            v = (np.conj(np.exp(0.4j)) * relative).real
            size = {Viscous: -20.0 * v, Quadratic: -5.0 * v * np.abs(v), Constant: 3.0 + 0 * v}[type(law)]
            np.testing.assert_allclose(power(scene, GRID), size * v, rtol=1e-6, atol=1e-6)


class TestSprings:
    def turning(self) -> Mechanism:
        return with_input(full_turn(four_bar(0.1, 0.4, 0.25, 0.4 + 0j), 0.2), speed=7.0)

    def linear(self, **options: Any) -> Spring:
        given = {"stiffness": 900.0, "free": 0.15} | options
        return Spring("s", "linear", (3, 0), (0.1 + 0.05j, -0.1 + 0.3j), **given)

    def test_the_energy_of_a_linear_spring(self) -> None:
        """Power is minus the rate of k (l - l0)^2/2."""
        scene = scene_of(self.turning(), springs=(self.linear(),))

        def energy(theta: Array) -> Array:
            length = np.abs(scene.place(theta).configuration.motions[3].point(0.1 + 0.05j).r - (-0.1 + 0.3j))
            return 450.0 * (length - 0.15) ** 2

        rate = (energy(GRID + 1e-5) - energy(GRID - 1e-5)) / 2e-5 * 7.0
        np.testing.assert_allclose(power(scene, GRID), -rate, rtol=1e-6, atol=1e-5)

    @pytest.mark.parametrize("start", [0.2, 2.0])
    def test_springs_do_no_work_over_a_cycle(self, start: float) -> None:
        mechanism = with_input(self.turning(), start=start)
        springs = (self.linear(), Spring("t", "torsion", (2, 3), stiffness=40.0, free=0.7))
        for spring in (*springs, Spring("u", "torsion", (0, 3), stiffness=40.0, free=-2.0)):
            scene = scene_of(mechanism, springs=(spring,))
            on = dense(scene)
            stored = float(on.total(np.abs(power(scene, on.x.ravel())).reshape(on.x.shape)))
            assert stored > 0.1
            assert abs(work(scene)) < 1e-13 * stored

    def test_dampers_take_work(self) -> None:
        for spring in (
            self.linear(stiffness=0.0, damping=30.0),
            Spring("t", "torsion", (2, 3), damping=3.0),
        ):
            scene = scene_of(self.turning(), springs=(spring,))
            (source,) = scene.sources
            assert (source.kind, source.order) == ("damper", 1)
            assert np.all(power(scene, GRID) <= 0)
            assert work(scene) < 0

    def test_the_damping_force_is_that_of_the_rate_of_length(self) -> None:
        scene = scene_of(self.turning(), springs=(self.linear(stiffness=0.0, damping=30.0),))

        def length(theta: Array) -> Array:
            return np.abs(scene.place(theta).configuration.motions[3].point(0.1 + 0.05j).r - (-0.1 + 0.3j))

        rate = (length(GRID + 1e-5) - length(GRID - 1e-5)) / 2e-5 * 7.0
        np.testing.assert_allclose(power(scene, GRID), -30.0 * rate**2, rtol=1e-6, atol=1e-6)

    @pytest.mark.parametrize("free", [0.0, 2.9, -2.9, 3.5, -9.0])
    def test_a_torsion_spring_never_jumps(self, free: float) -> None:
        """Wherever the free angle lies, the moment is that of the angle from it, followed continuously."""
        scene = scene_of(self.turning(), springs=(Spring("t", "torsion", (0, 3), stiffness=10.0, free=free),))
        moment = scene.sources[0].actions(scene.place(GRID))[0].moment
        angle = np.unwrap(np.angle(scene.place(GRID).configuration.motions[3].u))
        winding = -moment / 10.0
        np.testing.assert_allclose(winding - winding[0], angle - angle[0], atol=1e-12)
        np.testing.assert_allclose(np.exp(1j * (winding + free)), np.exp(1j * angle), atol=1e-12)
        assert abs((winding.min() + winding.max()) / 2) <= np.pi + 1e-6

    def test_a_torsion_spring_on_a_crank_is_wound_up(self) -> None:
        with pytest.raises(NoSolutionError, match="links 0 and 1 turn by 360 deg") as raised:
            scene_of(self.turning(), springs=(Spring("t", "torsion", (0, 1), stiffness=1.0),))
        assert raised.value.where == "t"
        scene_of(self.turning(), springs=(Spring("t", "torsion", (0, 1), damping=1.0),))  # a damper may turn

    def test_ends_that_meet(self) -> None:
        mechanism = with_input(full_turn(crank_slider(0.1, 0.3), 0.0, 4), speed=5.0)
        scene = scene_of(mechanism, springs=(Spring("s", "linear", (3, 0), (0j, 0.4 + 0j), 1.0),))
        with pytest.raises(NoSolutionError, match="the ends of the spring meet") as raised:
            power(scene, np.array([0.0, 1.0]))
        assert raised.value.where == "s, theta 0"

    def test_between_moving_links_inner_forces_cancel(self) -> None:
        scene = scene_of(self.turning(), springs=(Spring("s", "linear", (1, 3), (0.03j, 0.1 + 0j), 50.0, 0.1),))
        one, other = scene.sources[0].actions(scene.place(GRID))
        np.testing.assert_allclose(one.force + other.force, 0.0, atol=1e-13)
        lever = np.conj(other.at.r - one.at.r) * one.force
        np.testing.assert_allclose(lever.imag, 0.0, atol=1e-13)  # along the line of the ends


EVERY = [
    push(Constant(5.0), window=Window(angles=(0.7, 2.2))),
    push(Constant(5.0), window=Window(stroke="working")),
    push(Constant(5.0), window=Window(positions=("20", "3"))),
    push(Polynomial((1.0, -2.0, 0.4)), window=Window(angles=(5.5, 1.2))),
    push(Polynomial((1.0, -2.0, 0.4)), window=Window(stroke="idle")),
    push(Polynomial((1.0, -2.0, 0.4))),
    push(Quadratic(4.0), direction=np.exp(0.3j)),
    push(Tabulated("angle", (0.3, 1.0, 2.5), (1.0, -2.0, 4.0), period=TURN)),
    push(Tabulated("angle", (0.3, 1.0, 2.5), (1.0, -2.0, 4.0), "pchip", period=TURN / 2)),
    push(Tabulated("angle", (1.0, 3.0, 1.0 + 2 * TURN), (2.0, 5.0, -4.0), period=2 * TURN)),
    push(Tabulated("position", (0.0, 5.0, 12.0, 20.0), (2.0, 5.0, -4.0, 0.0))),
    push(Tabulated("displacement", (0.02, 0.05, 0.15), (-100.0, 40.0, 10.0))),
    push(Tabulated("stroke", (0.0, 0.3, 0.9, 1.0), (-100.0, 40.0, 10.0, 60.0), "pchip")),
]


@pytest.mark.parametrize("load", EVERY, ids=lambda load: f"{type(load.law).__name__}-{load.window is not None}")
@pytest.mark.parametrize("speed", [5.0, -5.0])
def test_edges_finds_every_break(load: Load, speed: float) -> None:
    """Between the edges the power is a smooth function: five-degree panels of sixteen points hold it to rounding."""
    scene = scene_of(slider(0.37, speed), load)
    on = dense(scene)
    rate = power(scene, on.x.ravel()).reshape(1, *on.x.shape)
    assert np.max(on.tail(rate)) < 1e-12 * np.max(np.abs(rate))


def test_a_quadratic_resistance_reverses_with_its_point() -> None:
    """A load whose velocity changes sign more than twice a turn: the edges are the zeros of its velocity."""
    mechanism = Mechanism(
        Link(0, {"O": 0j, "C": 0.4 + 0j}),
        (bar(1, O=0, A=0.1), bar(2, A=0, B=0.4, K=0.2 + 0.3j), bar(3, C=0, B=0.25)),
        (pin("O", 0, 1), pin("A", 1, 2, 0.1), pin("B", 2, 3, 0.4, 0.25), pin("C", 0, 3, 0.4)),
        Input("O", 6.0, start=0.2),
        (Output(link=3),),
        assembly=Assembly(variants={(2, 3): 1}),
    )
    mechanism = full_turn(mechanism, 0.2)
    scene = scene_of(mechanism, Load("Q", 2, "force", Quadratic(3.0), 0.2 + 0.3j, np.exp(1.1j), follows=3))
    theta = np.linspace(0, TURN, 20001)
    place = scene.place(theta)
    motion = place.configuration.motions
    v = (np.conj(np.exp(1.1j) * motion[3].u) * motion[2].point(0.2 + 0.3j).v).real
    zeros = theta[np.flatnonzero(np.sign(v[1:]) != np.sign(v[:-1]))]
    edges = np.array(scene.edges())
    assert edges.size == zeros.size >= 2
    np.testing.assert_allclose(edges, zeros, atol=4e-4)
