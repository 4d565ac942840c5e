"""Pictures of the flywheel and the motion stage: what is drawn, against closed forms and the geometry of the method."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from machines import MOTOR, TURN, positions, sine, spec_text, steps
from sparing import sparing

from tmmcalc.cli.plot import picture_of

pytest.importorskip("matplotlib")

from drawing import draw_stage
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tmmcalc.api import run
from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.panels import panels
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.driver import ConstantInertia, Driver, driver_of
from tmmcalc.machine.flywheel.results import Flywheel
from tmmcalc.machine.flywheel.solve import Machine, solve_flywheel
from tmmcalc.machine.model import FlywheelTask
from tmmcalc.machine.motion import solve_motion
from tmmcalc.machine.motors.model import CharacteristicKind, Motor
from tmmcalc.machine.pictures.flywheel import flywheel_figure
from tmmcalc.machine.pictures.motion import motion_figure
from tmmcalc.machine.power import WorkPart, duty_of, solve_power
from tmmcalc.project import load_spec
from tmmcalc.report.drawing.limits import places, with_limits

RPM = math.pi / 30
MINUS = "\N{MINUS SIGN}"


def axes_of(figure: Figure, label: str) -> Axes:
    (found,) = [axes for axes in figure.axes if label in (axes.get_xlabel(), axes.get_ylabel())]
    return found


def texts(axes: Axes) -> list[str]:
    return [text.get_text() for text in axes.texts]


def legend(axes: Axes) -> list[str]:
    found = axes.get_legend()
    return [text.get_text() for text in found.get_texts()] if found is not None else []


def swinging(links: float = 0.0) -> Cycle:
    """A load 100 sin(phi) N*m at 20 rad/s; ``links`` scales an inertia 1 + cos(2 phi)/2 of the links."""
    cycle = sine(100.0)
    x = cycle.panels.x
    inertia, slope = links * (1 + np.cos(2 * x) / 2), -links * np.sin(2 * x)
    return Cycle(cycle.panels, inertia, slope, cycle.moment, cycle.viscous, cycle.quadratic, cycle.speed)


def wheel(cycle: Cycle, driver: Driver | None = None, existing: float = 0.0, at_hand: float = 4.0) -> Flywheel:
    task = FlywheelTask(0.02, existing, "input", None, 0.6, None, None, "steel", None, None)
    return solve_flywheel(Machine(cycle, ConstantInertia(rotor=at_hand), task, driver, 20.0, 1.0))


class TestFlywheel:
    def curve(self, result: Flywheel, sense: float = 1.0) -> Axes:
        return axes_of(flywheel_figure(result, positions(24, sense)[1]), "$J$ of the links, kg·m²")

    def test_tangents_touch_the_curve_and_meet_in_the_origin(self) -> None:
        result = wheel(swinging(links=1.5))
        axes = self.curve(result)
        upper, lower, drawn = (line.get_xydata().T for line in axes.lines[:3])
        slopes = [float(np.diff(y)[0] / np.diff(x)[0]) for x, y in (upper, lower)]
        assert slopes == [pytest.approx((20 * 1.01) ** 2 / 2), pytest.approx((20 * 0.99) ** 2 / 2)]
        gaps = [
            y[0] + slope * (drawn[0] - x[0]) - drawn[1] for (x, y), slope in zip((upper, lower), slopes, strict=True)
        ]
        assert np.min(gaps[0]) == pytest.approx(0, abs=1e-9)
        assert np.max(gaps[1]) == pytest.approx(0, abs=1e-9)
        # where the two lines cross stand the whole inertia and the whole energy
        at = (upper[1][0] - lower[1][0] - slopes[0] * upper[0][0] + slopes[1] * lower[0][0]) / (slopes[1] - slopes[0])
        assert at == pytest.approx(-result.inertia)
        segment = result.inertia * 0.02 * 20**2
        assert f"$GH$ = {segment:.5g} J" in texts(axes)

    @pytest.mark.slow
    def test_a_sine_of_load(self) -> None:
        """A = 100 (1 - cos phi), no inertia of the links: G = 200 J, H = 0."""
        axes = self.curve(wheel(swinging()))
        assert {"G: 200 J", "$GH$ = 200 J"} <= set(texts(axes))
        assert f"$J$ = {MINUS}25 kg·m²" in axes.get_title(loc="left")

    @sparing("sense", [1.0, -1.0], every=2)
    def test_places_are_named_along_the_sense_of_the_input(self, sense: float) -> None:
        said = texts(self.curve(wheel(swinging(links=1.5)), sense))
        assert ("30" in said, f"{MINUS}30" in said) == (sense > 0, sense < 0)

    @pytest.mark.slow
    def test_work_over_the_cycle(self) -> None:
        result = wheel(swinging(links=1.5))
        axes = axes_of(flywheel_figure(result, positions(24)[1]), "$\\varphi$, °")
        theta = np.radians(axes.lines[0].get_xdata())
        work, own = (np.asarray(axes.lines[k].get_ydata()) for k in (0, 2))
        assert work == pytest.approx(100 * (1 - np.cos(theta)), abs=1e-9)
        assert own == pytest.approx(work - 1.5 * (1 + np.cos(2 * theta) / 2) * 200, abs=1e-9)

    @pytest.mark.slow
    def test_bars_are_the_inertias_of_the_methods(self) -> None:
        axes = axes_of(flywheel_figure(wheel(swinging()), positions(24)[1]), "$J_\\mathrm{F}$, kg·m²")
        assert [bar.get_width() for bar in axes.patches] == [pytest.approx(25)] * 5
        names = [label.get_text() for label in axes.get_yticklabels()]
        assert names[::-1] == ["exact", "textbook", "Mertsalov", "Artobolevsky", "excess work"]
        assert [line.get_xdata()[0] for line in axes.lines] == [pytest.approx(25), 4]

    @pytest.mark.slow
    def test_the_search_is_drawn_under_a_motor_alone(self) -> None:
        cycle = sine(100.0)
        motor = Motor("M", 4000.0, 20.0, 21.0)
        load = Cycle(
            cycle.panels, cycle.inertia + 1, cycle.slope, cycle.moment - 150, cycle.viscous, cycle.quadratic, 20.0
        )
        result = wheel(load, driver_of(motor, "linear", 1.0), existing=2.0)
        axes = axes_of(flywheel_figure(result, positions(24)[1]), "$\\delta$ under the motor")
        whole = np.asarray(axes.lines[0].get_xydata())
        assert np.all(np.diff(whole[:, 0]) >= 0)
        root = np.interp(-0.02, -whole[:, 1], whole[:, 0])
        assert root == pytest.approx(result.inertia, rel=1e-6)
        assert "with the one there" in legend(axes)
        alone = flywheel_figure(wheel(swinging()), positions(24)[1])
        assert len(alone.axes) == 3


class TestMotion:
    MOTOR = Motor("M", 600.0, 10.0, 10.5, overload=2.5)  # 60 N*m at 10 rad/s

    def positional(self, sense: float = 1.0) -> Figure:
        """omega^2 = 19.8^2 + 8 (1 - cos phi) rad^2/s^2, and half the load in place of the idle run."""
        inertia = ConstantInertia(flywheel=25.0)
        result = solve_motion(sine(100.0), sine(50.0), inertia, None, 20.0, positions(24, sense))
        return motion_figure(result, solve_power(sine(100.0), ()), sine(100.0))

    def driven(self, motor: Motor = MOTOR, kind: CharacteristicKind = "kloss", lag: float = 0.0) -> Figure:
        cycle = steps((-30.0, -10.0))
        driver = driver_of(motor, kind, 1.0, time_constant=lag)
        given = cycle, steps((0.0, 0.0)), ConstantInertia(rotor=5.0), driver, 10.0, positions(12)
        power = solve_power(cycle, (WorkPart("Q", "load", -40 * math.pi),))
        duty = duty_of(power, motor, 1.0, (), False)
        return motion_figure(solve_motion(*given), replace(power, duty=duty), cycle)

    def test_speeds(self) -> None:
        axes = axes_of(self.positional(), "$\\omega$, rad/s")
        x, loaded = np.asarray(axes.lines[0].get_xydata()).T
        assert loaded == pytest.approx(np.sqrt(19.8**2 + 8 * (1 - np.cos(np.radians(x)))))
        half = np.asarray(axes.lines[2].get_ydata())
        assert (half.min(), half.max()) == (pytest.approx(19.9), pytest.approx(20.1))
        assert texts(axes) == ["19.8", "20.2", "19.9", "20.1"]
        assert "mean $\\omega_\\mathrm{m}$ = 20" in legend(axes)
        low, high = axes.get_ylim()
        assert 19.5 < low < 19.8
        assert 20.2 < high < 20.5

    def test_the_sense_of_the_input(self) -> None:
        axes = axes_of(self.positional(-1.0), "$\\omega$, rad/s")
        x, loaded = np.asarray(axes.lines[0].get_xydata()).T
        assert (x[0], x[-1]) == (0, -360)
        assert x[np.argmax(loaded)] == pytest.approx(-180, abs=2)

    @pytest.mark.slow
    def test_moments_and_acceleration(self) -> None:
        figure = self.positional()
        axes = axes_of(figure, "$M$, N·m")
        x, driving = np.asarray(axes.lines[0].get_xydata()).T
        load = np.asarray(axes.lines[2].get_ydata())
        assert driving == pytest.approx(np.zeros_like(x), abs=1e-9)
        assert load == pytest.approx(100 * np.sin(np.radians(x)), abs=1e-9)
        eps = np.asarray(axes_of(figure, "$\\varepsilon$, rad/s²").lines[0].get_ydata())
        assert eps == pytest.approx(4 * np.sin(np.radians(x)), abs=1e-9)

    @pytest.mark.slow
    def test_a_jump_of_the_load_shows_both_limits(self) -> None:
        axes = axes_of(self.driven(), "$M$, N·m")
        x, load = np.asarray(axes.lines[2].get_xydata()).T
        assert load[x == 180].tolist() == [pytest.approx(-30), pytest.approx(-10)]

    @pytest.mark.slow
    def test_without_a_motor_there_is_no_characteristic(self) -> None:
        assert len(self.positional().axes) == 3
        assert len(self.driven().axes) == 5

    @pytest.mark.slow
    def test_all_forms_of_the_characteristic_go_through_both_points(self) -> None:
        near, whole = self.driven().axes[3:]
        assert legend(near)[:3] == ["Kloss, in use", "parabola", "line"]
        for line in near.lines[1:4]:
            x, y = np.asarray(line.get_xydata()).T
            assert np.interp([10.0, 10.5], x, y) == pytest.approx([60, 0], abs=0.05)
        assert {"H", "C"} <= set(texts(near))
        assert texts(whole) == ["H", "C", "K"]
        assert float(np.max(whole.lines[0].get_ydata())) == pytest.approx(2.5 * 60, rel=1e-4)
        assert whole.get_xlim()[0] == 0

    @sparing(("lag", "off"), [(0.0, 0.0), (0.2, 1.0)], every=2)
    def test_the_path_follows_the_curve_unless_the_motor_lags(self, lag: float, off: float) -> None:
        near = self.driven(lag=lag).axes[3]
        omega, moment = np.asarray(near.lines[0].get_xydata()).T
        form = driver_of(self.MOTOR, "kloss", 1.0).characteristic
        gap = float(np.max(np.abs(moment - form.moment(omega))))
        assert (gap > off) if off else gap < 1e-9

    @pytest.mark.slow
    def test_forms_that_lack_data_are_left_out(self) -> None:
        poor = Motor("M", 600.0, 10.0, 10.5)
        figure = self.driven(poor, "parabolic")
        assert legend(figure.axes[3])[:2] == ["parabola, in use", "line"]
        assert len(figure.axes) == 4
        assert "recurrence (3.57)" in legend(axes_of(figure, "$\\omega$, rad/s"))
        shunt = self.driven(Motor("D", 600.0, 10.0, 10.5, kind="shunt"), "shunt")
        assert legend(shunt.axes[3])[:2] == ["shunt, in use", "steady motion"]


@pytest.fixture(scope="module", params=[MOTOR, ""], ids=["motor", "positional"])
def solved(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[Any, Any, Path]:
    folder = tmp_path_factory.mktemp("machine")
    file = folder / "machine.toml"
    file.write_text(spec_text(request.param))
    spec = load_spec(file)
    return spec, run(spec).results, folder / "picture.svg"


@pytest.mark.slow
@pytest.mark.parametrize("stage", ["flywheel", "motion"])
def test_equal_results_give_equal_bytes(solved: tuple[Any, Any, Path], stage: str) -> None:
    *_, file = solved
    draw_stage(stage, *solved)
    first = file.read_bytes()
    assert first.startswith(b"<?xml")
    file.unlink()
    draw_stage(stage, *solved)
    assert file.read_bytes() == first


def test_power_has_no_picture() -> None:
    with pytest.raises(UsageError, match="flywheel, motion") as fault:
        picture_of("power", {})
    assert "there is no picture of 'power'" in str(fault.value)


def test_limits_stand_at_both_edges_of_every_panel() -> None:
    on = panels(0.0, TURN, (math.pi,))
    x = places(on)
    step = np.where(on.x < math.pi, on.x, on.x + 5)
    y = with_limits(on, np.stack((step, 2 * step)))
    assert y.shape == (2, len(x)) == (2, on.count * (on.order + 2))
    assert np.all(np.diff(x) >= 0)
    assert y[0][x == math.pi].tolist() == [pytest.approx(math.pi), pytest.approx(math.pi + 5)]
    assert y[1] == pytest.approx(2 * y[0])
