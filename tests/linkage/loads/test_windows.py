"""Where loads act: strokes, angles, positions; from which side; over position 0; turn by turn."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from linkage.loads.acting import Array, scene_of, value
from linkage.scenes import (
    crank_slider,
    driven_rod,
    four_bar,
    full_turn,
    part,
    slotted,
    with_grid,
    with_input,
    with_output,
)
from tmmcalc import NoSolutionError, solve_kinematics
from tmmcalc.core.numerics.panels import panels
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.loading import Load, Loading, Window
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.polynomial import Polynomial
from tmmcalc.linkage.loadlaws.tabulated import Tabulated
from tmmcalc.linkage.model import Mechanism
from tmmcalc.machine.reduction.solve import solve_reduction
from tmmcalc.pipeline.runner import run
from tmmcalc.project import load_spec, templates

TURN = 2 * np.pi
DEGREE = np.pi / 180
GRID = np.linspace(0.001, TURN - 0.001, 996)


def slider(start: float = 0.0, speed: float = 5.0, e: float = 0.0) -> Mechanism:
    return with_input(full_turn(crank_slider(0.1, 0.3, e), start), speed=speed)


def crank_angle(theta: Array, start: float, speed: float) -> Array:
    return start + math.copysign(1.0, speed) * theta


def push(window: Window | None, law: object = Constant(7.0), name: str = "Q") -> Load:
    return Load(name, 3, "force", law, window=window)


def angles(low: float, high: float) -> Window:
    return Window(angles=(low * DEGREE, high * DEGREE))


class TestStrokes:
    @pytest.mark.parametrize("start", [0.0, 0.7, -2.0])
    @pytest.mark.parametrize("speed", [5.0, -5.0])
    @pytest.mark.parametrize("stroke", ["working", "idle"])
    def test_the_strokes_of_an_in_line_slider(self, start: float, speed: float, stroke: str) -> None:
        """Of equal strokes the working one leaves the greater coordinate: there the slider moves inwards."""
        found = value(scene_of(slider(start, speed), push(Window(stroke=stroke))), GRID)
        inwards = np.sin(crank_angle(GRID, start, speed)) * np.sign(speed) > 0
        np.testing.assert_array_equal(found, np.where(inwards == (stroke == "working"), 7.0, 0.0))

    @pytest.mark.parametrize("e", [0.05, -0.05])
    def test_the_longer_stroke_of_an_offset_slider_is_the_working_one(self, e: float) -> None:
        far, near = math.asin(e / 0.4), math.pi + math.asin(e / 0.2)
        found = value(scene_of(slider(0.3, 5.0, e), push(Window(stroke="working"))), GRID)
        inwards = np.mod(0.3 + GRID - far, TURN) < near - far  # from the outer dead centre to the inner one
        np.testing.assert_array_equal(found != 0, inwards == (near - far > math.pi))

    def test_the_sense_of_the_resistance_decides(self) -> None:
        for resistance, inwards in (("positive", True), ("negative", False)):
            mechanism = with_output(slider(0.4), point="B", resistance=resistance)
            found = value(scene_of(mechanism, push(Window(stroke="working"))), GRID)
            np.testing.assert_array_equal(found != 0, (np.sin(0.4 + GRID) > 0) == inwards)

    def test_another_output_by_name(self) -> None:
        mechanism = with_output(slider(0.4), link=2, label="rod")
        found = value(scene_of(mechanism, push(Window(stroke="idle", output="rod"))), GRID)
        work = value(scene_of(mechanism, push(Window(stroke="working"))), GRID)
        up = np.cos(0.4 + GRID) > 0  # the rod's angle falls while the crank pin rises
        assert np.array_equal(found != 0, up) or np.array_equal(found != 0, ~up)
        np.testing.assert_array_equal(found + work, 7.0)

    @pytest.mark.parametrize("speed", [5.0, -5.0])
    def test_ends_of_the_cycle_at_a_dead_centre(self, speed: float) -> None:
        """Position 0 takes what holds just after it, the last position what holds just before; inside both count."""
        ends = np.array([0.0, np.pi, TURN])
        for stroke, expected in (("working", [7.0, 7.0, 0.0]), ("idle", [0.0, 7.0, 7.0])):
            found = value(scene_of(slider(0.0, speed), push(Window(stroke=stroke))), ends)
            np.testing.assert_array_equal(found, expected)

    def test_several_working_strokes_a_turn(self) -> None:
        """The height of the rod's end swings twice a turn: two working strokes, each with its own origin."""
        mechanism = slotted(0.3, 0.1)
        mechanism = with_output(full_turn(mechanism, 0.2), point="K", direction=np.pi / 2)
        load = Load("Q", 3, "moment", Polynomial((0.0, 1.0)), window=Window(stroke="working"))
        scene = scene_of(mechanism, load)
        y = scene.place(GRID).configuration.motions[3].point(0.8).r.imag
        falls = np.gradient(y) < 0
        found = value(scene, GRID)
        acts = found > 0
        assert np.mean(acts == falls) > 0.99 or np.mean(acts == ~falls) > 0.99
        begins = np.flatnonzero(acts[1:] & ~acts[:-1]) + 1
        assert begins.size == 2
        assert np.all(found[begins] < 0.02)
        np.testing.assert_allclose(np.diff(found)[acts[1:] & acts[:-1]], np.diff(GRID)[0], rtol=1e-6)

    def test_strokes_of_an_open_range(self) -> None:
        """The crank goes from 40 to 220 degrees: the slider's inner dead centre at 180, so one is too few."""
        mechanism = part(crank_slider(0.1, 0.3), 40 * DEGREE, 220 * DEGREE)
        with pytest.raises(NoSolutionError, match="has 1 dead centre in the analysed range") as raised:
            scene_of(mechanism, push(Window(stroke="working")))
        assert raised.value.where == "load Q"
        assert "between" in raised.value.remedy

    @pytest.mark.parametrize("speed", [5.0, -5.0])
    def test_three_strokes_of_an_open_range(self, speed: float) -> None:
        """From 100 degrees before one dead centre to 60 behind the next, whichever way."""
        start = -100 * DEGREE if speed > 0 else 240 * DEGREE
        mechanism = with_grid(with_input(crank_slider(0.1, 0.3), start=start, speed=speed), span=340 * DEGREE)
        theta = np.linspace(0.001, 340 * DEGREE - 0.001, 501)
        inwards = np.sin(crank_angle(theta, start, speed)) * np.sign(speed) > 0
        # without a sense of the resistance the first whole stroke is the working one
        expected = inwards if speed > 0 else inwards[:]
        first_whole = np.argmax(inwards != inwards[0])
        found = value(scene_of(mechanism, push(Window(stroke="working"))), theta)
        np.testing.assert_array_equal(found != 0, expected == inwards[first_whole])
        resisted = with_output(mechanism, point="B", resistance="positive")
        np.testing.assert_array_equal(value(scene_of(resisted, push(Window(stroke="working"))), theta) != 0, inwards)
        ramp = Polynomial((1.0, 1.0))
        found = value(scene_of(resisted, push(Window(stroke="working"), ramp)), theta)
        rises = (np.diff(found) > 0)[inwards[1:] & inwards[:-1]]
        assert rises.all()


class TestAngles:
    @pytest.mark.parametrize("speed", [5.0, -5.0])
    @pytest.mark.parametrize(("low", "high"), [(30, 200), (0, 90), (270, 360), (200, 30), (359.5, 0.5), (0, 360)])
    def test_windows_are_counted_along_the_motion(self, low: float, high: float, speed: float) -> None:
        found = value(scene_of(slider(1.1, speed), push(angles(low, high))), GRID)
        degrees = np.degrees(GRID)
        inside = (degrees > low) & (degrees < high) if low < high else (degrees > low) | (degrees < high)
        np.testing.assert_array_equal(found != 0, inside)

    @pytest.mark.parametrize(
        ("low", "high", "at_zero", "at_end"),
        [(30, 200, 0, 0), (0, 90, 1, 0), (270, 360, 0, 1), (200, 30, 1, 1), (0, 360, 1, 1)],
    )
    def test_ends_of_the_cycle(self, low: float, high: float, at_zero: int, at_end: int) -> None:
        found = value(scene_of(slider(), push(angles(low, high))), np.array([0.0, TURN]))
        np.testing.assert_array_equal(found, [7.0 * at_zero, 7.0 * at_end])

    def test_windows_are_closed(self) -> None:
        at = np.array([29.9, 30, 60, 200, 200.1]) * DEGREE
        np.testing.assert_array_equal(value(scene_of(slider(), push(angles(30, 200))), at), [0, 7, 7, 7, 0])

    @pytest.mark.parametrize("start", [0.0, 1.3])
    def test_a_polynomial_counts_from_the_beginning_of_its_window(self, start: float) -> None:
        ramp = Polynomial((2.0, 3.0, -0.5))
        for low, high in ((40, 300), (300, 40)):
            found = value(scene_of(slider(start), push(angles(low, high), ramp)), GRID)
            d = np.mod(GRID - low * DEGREE, TURN)
            inside = d < (high - low) % 360 * DEGREE
            np.testing.assert_allclose(found, np.where(inside, 2 + 3 * d - 0.5 * d * d, 0.0), rtol=1e-12, atol=1e-12)

    def test_a_polynomial_at_the_seam(self) -> None:
        """Always acting it counts from position 0; the last position has the value at the end, not at the beginning."""
        ramp = Polynomial((1.0, 1.0))
        found = value(scene_of(slider(), push(None, ramp)), np.array([0.0, 1.0, TURN]))
        np.testing.assert_allclose(found, [1.0, 2.0, 1 + TURN])
        found = value(scene_of(slider(), push(angles(300, 60), ramp)), np.array([0.0, TURN]))
        np.testing.assert_allclose(found, 1 + 60 * DEGREE)

    def test_a_polynomial_of_a_stroke(self) -> None:
        ramp = Polynomial((0.0, 1.0))
        found = value(scene_of(slider(1.0), push(Window(stroke="idle"), ramp)), GRID)
        d = np.mod(GRID + 1.0 - np.pi, TURN)
        np.testing.assert_allclose(found, np.where(d < np.pi, d, 0.0), atol=1e-9)

    def test_an_open_range(self) -> None:
        mechanism = part(crank_slider(0.1, 0.3), 0.5, 2.5)
        theta = np.linspace(0, 2.0, 201)
        found = value(scene_of(mechanism, push(Window(angles=(0.5, 5.0)), Polynomial((1.0, 2.0)))), theta)
        np.testing.assert_allclose(found, np.where(theta >= 0.5 - 1e-9, 1 + 2 * (theta - 0.5), 0.0), atol=1e-9)

    def test_a_driven_slider_counts_lengths(self) -> None:
        mechanism = with_input(driven_rod(0.5, 0.3, 0.2), speed=-0.5, start=0.2)
        theta = np.linspace(0, 0.2, 101)
        found = value(scene_of(mechanism, push(Window(angles=(0.05, 0.1)))), theta)
        np.testing.assert_array_equal(found != 0, (theta > 0.05 - 1e-9) & (theta < 0.1 + 1e-9))

    @pytest.mark.parametrize(
        ("window", "said"),
        [
            ((0.05, 0.3), "warning: load Q: has a window to 300 mm, but the motion ends at 200 mm"),
            ((0.25, 0.3), "warning: load Q: never acts: its window begins at 250 mm, but the motion ends at 200 mm"),
        ],
    )
    def test_a_window_beyond_the_way_of_a_slider_is_told(self, window: tuple[float, float], said: str) -> None:
        mechanism = with_input(driven_rod(0.5, 0.3, 0.2), speed=-0.5, start=0.2)
        kinematics, loading = solve_kinematics(mechanism), Loading(loads=(push(Window(angles=window)),))
        assert [str(grade) for grade in solve_forces(mechanism, loading, kinematics).grades] == [said]
        assert said in [str(grade) for grade in solve_reduction(mechanism, loading, kinematics).grades]
        assert not scene_of(mechanism, push(Window(angles=(0.05, 0.2)))).grades

    def test_of_a_part_of_a_turn_it_is_noted(self) -> None:
        (grade,) = scene_of(part(crank_slider(0.1, 0.3), 0.5, 2.5), push(Window(angles=(0.5, 5.0)))).grades
        assert str(grade) == "note: load Q: has a window to 286.48 deg, but the motion ends at 114.59 deg"


class TestPositions:
    def test_labels_of_the_grid(self) -> None:
        mechanism = with_grid(slider(0.3), positions=12, extra=(100 * DEGREE,))
        for low, high, window in (("2", "7", (60, 210)), ("3'", "12", (100, 360)), ("10", "2", (300, 60))):
            one = value(scene_of(mechanism, push(Window(positions=(low, high)))), GRID)
            two = value(scene_of(mechanism, push(angles(*window))), GRID)
            np.testing.assert_array_equal(one, two)

    def test_a_position_that_is_not_there(self) -> None:
        with pytest.raises(NoSolutionError, match="no position '25'; the positions are 0 to 24") as raised:
            scene_of(slider(), push(Window(positions=("3", "25"))))
        assert raised.value.where == "load Q, positions"

    def test_steps_of_two_strokes(self) -> None:
        """With working and idle steps the positions are not equally far."""
        mechanism = with_grid(with_input(crank_slider(0.1, 0.3, 0.06), start=None), working=4, idle=8)
        found = value(scene_of(mechanism, push(Window(positions=("0", "4")))), GRID)
        stroke = value(scene_of(mechanism, push(Window(stroke="working"))), GRID)
        np.testing.assert_array_equal(found, stroke)


class TestLongerCycles:
    """Beside a load of two turns the others go on as if they were alone."""

    long = Load("gas", 3, "force", Tabulated("angle", (0.0, 5.0, 4 * np.pi), (0.0, 1.0, 2.0), period=4 * np.pi))

    @pytest.mark.parametrize(
        "load",
        [
            push(angles(30, 200), Polynomial((1.0, 1.0))),
            push(angles(300, 60), Polynomial((1.0, 1.0))),
            push(None, Polynomial((1.0, 1.0))),
            push(Window(stroke="working"), Polynomial((1.0, 1.0))),
            push(Window(stroke="idle")),
            push(Window(positions=("20", "4"))),
            push(None, Tabulated("angle", (0.5, 2.0, 4.0), (1.0, 3.0, -2.0), period=TURN)),
            push(None, Tabulated("angle", (0.5, 1.0), (1.0, 3.0), period=TURN / 3)),
        ],
    )
    def test_what_repeats_every_turn(self, load: Load) -> None:
        alone, beside = scene_of(slider(0.4), load), scene_of(slider(0.4), load, self.long)
        assert beside.travel.period == pytest.approx(2 * TURN)
        first = value(alone, GRID)
        source = beside.sources[0]
        for turn in (0, 1):
            place = beside.place(GRID + TURN * turn)
            force = (np.conj(load.direction) * source.actions(place)[0].force).real
            np.testing.assert_allclose(np.broadcast_to(force, GRID.shape), first, rtol=1e-11, atol=1e-11)
        edges = np.array(alone.edges())
        for turn in (0, 1):
            for edge in edges:
                assert np.min(np.abs(np.array(beside.edges()) - (edge + TURN * turn) % (2 * TURN))) < 1e-9

    def test_a_window_in_the_second_turn(self) -> None:
        scene = scene_of(slider(), push(angles(400, 500), Polynomial((1.0, 1.0))), self.long)
        theta = np.linspace(0.001, 2 * TURN - 0.001, 999)
        place = scene.place(theta)
        found = np.broadcast_to(scene.sources[0].actions(place)[0].force.real, theta.shape)
        d = theta - 400 * DEGREE
        np.testing.assert_allclose(found, np.where((d >= 0) & (d <= 100 * DEGREE), 1 + d, 0.0), atol=1e-12)

    def test_the_window_of_a_long_law_is_as_long(self) -> None:
        law = Tabulated("angle", (0.0, 4 * np.pi), (5.0, 5.0), period=4 * np.pi)
        scene = scene_of(slider(), push(angles(0, 360), law))
        np.testing.assert_array_equal(value(scene, np.array([0.0, 3.0, TURN, 7.0, 12.0])), [5, 5, 5, 0, 0])

    def test_periods_of_two_and_three_turns_meet_after_six(self) -> None:
        three = Tabulated("angle", (0.0, 6 * np.pi), (1.0, 2.0), period=6 * np.pi)
        scene = scene_of(slider(), push(None, three), self.long)
        assert scene.travel.period == pytest.approx(6 * TURN)


def test_a_load_on_a_stroke_of_nothing() -> None:
    """Without outputs and without a link on the frame but the crank there is no stroke."""
    mechanism = with_output(full_turn(four_bar(1, 6, 3, 7 + 0j)), link=3)
    with pytest.raises(NoSolutionError, match="no output 'ram'"):
        scene_of(mechanism, push(Window(stroke="working", output="ram")))
    round_and_round = with_output(slider(), link=1)
    with pytest.raises(NoSolutionError, match="output 1 has 0 dead centres"):
        scene_of(round_and_round, push(Window(stroke="working")))


class TestOnceInTwoTurns:
    """A window that comes back after two turns, in angles and in positions."""

    twice = np.arange(0.0, 2 * TURN, 0.01)  # keeps off the ends of windows

    def work(self, load: Load) -> float:
        """Integral over two turns of the size of a load, by the scene's own edges."""
        scene = scene_of(slider(0.4), load)
        assert scene.travel.period == pytest.approx(2 * TURN)
        edges = np.array([0.0, *scene.edges(), 2 * TURN])
        on = panels(0.0, 2 * TURN, edges)
        force = scene.sources[0].actions(scene.place(on.x.ravel()))[0].force
        values = np.broadcast_to((np.conj(load.direction) * force).real, on.x.size)
        return float(on.total(values.reshape(on.x.shape)))

    @pytest.mark.parametrize(
        ("window", "law", "expected"),
        [
            (angles(490, 540), Constant(2.0), 2 * math.radians(50)),
            (angles(30, 200), Constant(2.0), 2 * math.radians(170)),  # the first turn alone
            (angles(180, 540), Constant(2.0), 2 * math.pi * 2),
            (angles(700, 20), Constant(2.0), 2 * math.radians(40)),  # over the seam of the cycle
            (angles(400, 500), Polynomial((0.0, 3.0)), 1.5 * math.radians(100) ** 2),  # counts from its window
            (angles(700, 20), Polynomial((0.0, 3.0)), 1.5 * math.radians(40) ** 2),
            (None, Polynomial((0.0, 1.0)), (2 * TURN) ** 2 / 2),  # counts from position 0 of the first turn
            (Window(positions=("26", "32")), Constant(2.0), 2 * math.pi / 2),  # of 24 in a turn
            (Window(positions=("46", "2")), Constant(2.0), 2 * math.pi / 3),
            (Window(positions=("22", "26")), Constant(2.0), 2 * math.pi / 3),
        ],
    )
    def test_its_work(self, window: Window | None, law: object, expected: float) -> None:
        assert self.work(replace(push(window, law), repeats=2)) == pytest.approx(expected, rel=1e-12)

    def test_one_load_hands_over_to_the_next_in_its_own_turn_alone(self) -> None:
        """The first ends at 540 deg, where the second begins; at 180 deg, a turn before, the first one begins."""
        first = replace(push(angles(180, 540), Constant(2.0), "first"), repeats=2)
        second = replace(push(angles(540, 700), Constant(5.0), "second"), repeats=2)
        scene = scene_of(slider(0.4), first, second)
        at = np.radians([180.0, 180.0, 540.0, 540.0])
        side = np.array([-1.0, 1.0, -1.0, 1.0])
        place = scene.place(at, side)
        sizes = [abs(np.broadcast_to(source.actions(place)[0].force, 4)) for source in scene.sources]
        np.testing.assert_allclose(sizes[0][1:], [2.0, 2.0, 0.0])
        np.testing.assert_allclose(sizes[1], [0.0, 0.0, 0.0, 5.0])

    def test_a_table_of_positions_counts_on(self) -> None:
        values = tuple(float(k) for k in range(49))
        law = Tabulated("position", tuple(range(49)), values, period=2 * TURN)
        scene = scene_of(slider(0.4), push(None, law))
        place = scene.place(self.twice)
        force = (np.conj(push(None).direction) * scene.sources[0].actions(place)[0].force).real
        np.testing.assert_allclose(force, self.twice * 24 / TURN, rtol=1e-11, atol=1e-11)


def test_a_gas_force_by_angles_is_that_of_the_indicator_diagram() -> None:
    """The ready spec has the points of `four-stroke-engine` every 5 degrees: work and flywheel to their chords."""
    found = {}
    for name in ("four-stroke-engine", "four-stroke-angles"):
        found[name] = run(load_spec(templates.folder() / f"{name}.toml"), target="flywheel").results
    strokes, by_angle = (results["reduction"] for results in found.values())
    work = {part.name: part.work for part in by_angle.contributions}
    gas = next(part.work for part in strokes.contributions if part.name == "gas")
    assert by_angle.cycle.period == strokes.cycle.period == pytest.approx(2 * TURN)
    assert work["gas"] == pytest.approx(gas, rel=1e-3)
    assert work["exhaust"] == pytest.approx(-9 * math.radians(50), rel=1e-12)
    assert work["injection"] == pytest.approx(-4 * math.radians(30), rel=1e-12)
    one, other = (results["flywheel"].addition for results in found.values())
    assert other == pytest.approx(one, rel=5e-3)
