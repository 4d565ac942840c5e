"""Pictures of the flywheel and the motion stage: what is drawn, against closed forms and the geometry of the method."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from drawing import draw_stage
from machines import MOTOR, TURN, positions, sine, spec_text, steps
from paper import curves, diagram, written
from sparing import sparing

from tmmcalc.api import run
from tmmcalc.cli.plot import picture_of
from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.panels import panels
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.driver import ConstantInertia, Driver, driver_of
from tmmcalc.machine.flywheel.results import Flywheel
from tmmcalc.machine.flywheel.solve import Machine, solve_flywheel
from tmmcalc.machine.model import FlywheelTask
from tmmcalc.machine.motion import solve_motion
from tmmcalc.machine.motors.model import CharacteristicKind, Motor
from tmmcalc.machine.pictures.characteristic import PATH
from tmmcalc.machine.pictures.flywheel import BAR, flywheel_drawing
from tmmcalc.machine.pictures.motion import motion_drawing
from tmmcalc.machine.power import WorkPart, duty_of, solve_power
from tmmcalc.project import load_spec
from tmmcalc.report.drawing.box import Box
from tmmcalc.report.drawing.diagram import Diagram
from tmmcalc.report.drawing.limits import places, with_limits
from tmmcalc.report.drawing.pens import CURVES
from tmmcalc.report.drawing.shapes import Area, Drawing, Stroke

RPM = math.pi / 30
MINUS = "\N{MINUS SIGN}"


def texts(field: Diagram) -> list[str]:
    """What stands in the frame."""
    return written(field.drawing, field.box)


def around(field: Diagram) -> list[str]:
    """What stands in the frame and above it, its key included."""
    box = field.box
    return written(field.drawing, Box(box.left - 1, box.bottom, box.right + 1, box.top + 13))


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
    def curve(self, cycle: Cycle, sense: float = 1.0) -> Diagram:
        """The energy-mass curve of the first sheet."""
        drawing = flywheel_drawing(wheel(cycle), positions(24, sense)[1], cycle)
        fields = [each for each in drawing.fields if isinstance(each, Diagram)]
        return next(each for each in fields if each.x.name.startswith("$J$ of the links"))

    def test_tangents_touch_the_curve_and_meet_in_the_origin(self) -> None:
        result = wheel(swinging(links=1.5))
        field = self.curve(swinging(links=1.5))
        upper, lower, drawn = curves(field)[:3]
        slopes = [float(np.diff(line.imag)[0] / np.diff(line.real)[0]) for line in (upper, lower)]
        assert slopes == [pytest.approx((20 * 1.01) ** 2 / 2), pytest.approx((20 * 0.99) ** 2 / 2)]
        gaps = [
            line.imag[0] + slope * (drawn.real - line.real[0]) - drawn.imag
            for line, slope in zip((upper, lower), slopes, strict=True)
        ]
        assert np.min(gaps[0]) == pytest.approx(0, abs=1e-9)
        assert np.max(gaps[1]) == pytest.approx(0, abs=1e-9)
        # where the two lines cross stand the whole inertia and the whole energy
        at = (upper.imag[0] - lower.imag[0] - slopes[0] * upper.real[0] + slopes[1] * lower.real[0]) / (
            slopes[1] - slopes[0]
        )
        assert at == pytest.approx(-result.inertia)
        segment = result.inertia * 0.02 * 20**2
        mu = (field.y.high - field.y.low) / field.box.height
        assert f"$GH$ = {segment / mu:.4g} mm" in texts(field)

    @pytest.mark.slow
    def test_a_sine_of_load(self) -> None:
        """A = 100 (1 - cos phi), no inertia of the links: G = 200 J, H = 0."""
        field = self.curve(swinging())
        assert {"$G$", "$H$", "$GH$ = 100 mm"} <= set(texts(field))
        assert any("$G$: 200 J, $H$: 0 J" in text for text in around(field))
        assert "$μ_{A}$ = 2 J/mm" in field.y.name
        assert any(f"$J$ = {MINUS}25 kg·m²" in text for text in around(field))

    @sparing("sense", [1.0, -1.0], every=2)
    def test_places_are_named_along_the_sense_of_the_input(self, sense: float) -> None:
        said = texts(self.curve(swinging(links=1.5), sense))
        assert ("30" in said, f"{MINUS}30" in said) == (sense > 0, sense < 0)

    @pytest.mark.slow
    def test_work_over_the_cycle(self) -> None:
        result = wheel(swinging(links=1.5))
        field = diagram(flywheel_drawing(result, positions(24)[1], swinging(links=1.5)), "$φ$, °")
        work, own = (curves(field, pen)[0] for pen in CURVES[:2])
        theta = np.radians(work.real)
        assert work.imag == pytest.approx(100 * (1 - np.cos(theta)), abs=1e-9)
        assert own.imag == pytest.approx(work.imag - 1.5 * (1 + np.cos(2 * theta) / 2) * 200, abs=1e-9)

    @pytest.mark.slow
    def test_bars_are_the_inertias_of_the_methods(self) -> None:
        drawing = flywheel_drawing(wheel(swinging()), positions(24)[1], swinging())
        bars = [shape for shape in drawing.shapes if isinstance(shape, Area) and shape.fill == BAR]
        widths = [float(np.ptp(bar.points.real)) for bar in bars]
        # 25 is needed by every method, 4 at hand: where these lines stand tells the scale
        left = min(float(bar.points.real.min()) for bar in bars)
        lines = self.uprights(drawing, left)
        assert len(widths) == 5
        assert widths == [pytest.approx(lines["NEEDED"] - left)] * 5
        assert (lines["AT_HAND"] - left) / widths[0] == pytest.approx(4 / 25)
        names = ["exact", "textbook", "Mertsalov", "Artobolevsky", "excess work"]
        first = Box(0, drawing.height * 2 / 3, drawing.width, drawing.height)
        assert [text for text in written(drawing, first) if text in names] == names

    @staticmethod
    def uprights(drawing: Drawing, left: float) -> dict[str, float]:
        """Layers and places of the upright lines right of a place, the first of each layer."""
        found: dict[str, float] = {}
        for shape in drawing.shapes:
            if isinstance(shape, Stroke) and shape.pen.layer in ("NEEDED", "AT_HAND"):
                x = shape.points.real
                if abs(np.ptp(x)) < 1e-9 and x[0] > left:
                    found.setdefault(shape.pen.layer, float(x[0]))
        return found

    @pytest.mark.slow
    def test_the_search_is_drawn_under_a_motor_alone(self) -> None:
        cycle = sine(100.0)
        motor = Motor("M", 4000.0, 20.0, 21.0)
        load = Cycle(
            cycle.panels, cycle.inertia + 1, cycle.slope, cycle.moment - 150, cycle.viscous, cycle.quadratic, 20.0
        )
        result = wheel(load, driver_of(motor, "linear", 1.0), existing=2.0)
        field = diagram(flywheel_drawing(result, positions(24)[1], load), "$δ$ under the motor")
        whole = max(curves(field), key=len)
        assert np.all(np.diff(whole.real) >= 0)
        root = np.interp(-0.02, -whole.imag, whole.real)
        assert root == pytest.approx(result.inertia, rel=1e-6)
        assert "with the one there" in around(field)
        alone = flywheel_drawing(wheel(swinging()), positions(24)[1], swinging())
        first = [each for each in alone.fields if each.box.bottom > alone.height * 2 / 3]
        assert len(first) == 2  # and the bars


class TestMotion:
    MOTOR = Motor("M", 600.0, 10.0, 10.5, overload=2.5)  # 60 N*m at 10 rad/s
    NEAR = "$ω$ of the input shaft, rad/s"

    def positional(self, sense: float = 1.0) -> Drawing:
        """omega^2 = 19.8^2 + 8 (1 - cos phi) rad^2/s^2, and half the load in place of the idle run."""
        inertia = ConstantInertia(flywheel=25.0)
        result = solve_motion(sine(100.0), sine(50.0), inertia, None, 20.0, positions(24, sense))
        return motion_drawing(result, solve_power(sine(100.0), ()), sine(100.0))

    def driven(self, motor: Motor = MOTOR, kind: CharacteristicKind = "kloss", lag: float = 0.0) -> Drawing:
        cycle = steps((-30.0, -10.0))
        driver = driver_of(motor, kind, 1.0, time_constant=lag)
        given = cycle, steps((0.0, 0.0)), ConstantInertia(rotor=5.0), driver, 10.0, positions(12)
        power = solve_power(cycle, (WorkPart("Q", "load", -40 * math.pi),))
        duty = duty_of(power, motor, 1.0, (), False)
        return motion_drawing(solve_motion(*given), replace(power, duty=duty), cycle)

    def characteristics(self, drawing: Drawing) -> list[Diagram]:
        """Near view, and the whole curve where it is known."""
        return [each for each in drawing.fields if isinstance(each, Diagram) and each.x.name == self.NEAR]

    def test_speeds(self) -> None:
        field = diagram(self.positional(), "$ω$, rad/s")
        (loaded,), (half,) = (curves(field, pen) for pen in CURVES[:2])
        assert loaded.imag == pytest.approx(np.sqrt(19.8**2 + 8 * (1 - np.cos(np.radians(loaded.real)))))
        assert (half.imag.min(), half.imag.max()) == (pytest.approx(19.9), pytest.approx(20.1))
        assert texts(field) == ["19.8", "20.2", "19.9", "20.1"]
        assert "mean $ω_m$ = 20" in around(field)
        assert 19.5 < field.y.low < 19.8
        assert 20.2 < field.y.high < 20.5

    def test_the_sense_of_the_input(self) -> None:
        field = diagram(self.positional(-1.0), "$ω$, rad/s")
        (loaded,) = curves(field, CURVES[0])
        assert (field.x.low, field.x.high) == (0, -360)
        assert (loaded.real[0], loaded.real[-1]) == (pytest.approx(0, abs=1e-9), pytest.approx(-360))
        assert loaded.real[np.argmax(loaded.imag)] == pytest.approx(-180, abs=2)

    @pytest.mark.slow
    def test_moments_and_acceleration(self) -> None:
        drawing = self.positional()
        (driving,), (load,) = (curves(diagram(drawing, "$M$, N·m"), pen) for pen in CURVES[:2])
        assert driving.imag == pytest.approx(np.zeros_like(driving.imag), abs=1e-9)
        assert load.imag == pytest.approx(100 * np.sin(np.radians(load.real)), abs=1e-9)
        (eps,) = curves(diagram(drawing, "$ε$, rad/s²"), CURVES[0])
        assert eps.imag == pytest.approx(4 * np.sin(np.radians(eps.real)), abs=1e-9)

    @pytest.mark.slow
    def test_a_jump_of_the_load_shows_both_limits(self) -> None:
        (load,) = curves(diagram(self.driven(), "$M$, N·m"), CURVES[1])
        at = np.abs(load.real - 180) < 1e-9
        assert load.imag[at].tolist() == [pytest.approx(-30), pytest.approx(-10)]

    @pytest.mark.slow
    def test_without_a_motor_there_is_no_characteristic(self) -> None:
        assert len(self.positional().fields) == 3
        assert len(self.driven().fields) == 5

    @pytest.mark.slow
    def test_all_forms_of_the_characteristic_go_through_both_points(self) -> None:
        near, whole = self.characteristics(self.driven())
        assert {"Kloss, in use", "parabola", "line"} <= set(around(near))
        forms = [line for line in curves(near) if len(line) > 100 and line.real[-1] > line.real[0] + 0.1]
        for line in forms[-3:]:
            assert np.interp([10.0, 10.5], line.real, line.imag) == pytest.approx([60, 0], abs=0.05)
        assert {"$H$", "$C$"} <= set(texts(near))
        assert texts(whole) == ["$H$", "$C$", "$K$"]
        assert max(float(line.imag.max()) for line in curves(whole)) == pytest.approx(2.5 * 60, rel=1e-4)
        assert whole.x.low == 0

    @sparing(("lag", "off"), [(0.0, 0.0), (0.2, 1.0)], every=2)
    def test_the_path_follows_the_curve_unless_the_motor_lags(self, lag: float, off: float) -> None:
        near = self.characteristics(self.driven(lag=lag))[0]
        (path,) = curves(near, PATH)
        form = driver_of(self.MOTOR, "kloss", 1.0).characteristic
        gap = float(np.max(np.abs(path.imag - form.moment(path.real))))
        assert (gap > off) if off else gap < 1e-9

    @pytest.mark.slow
    def test_forms_that_lack_data_are_left_out(self) -> None:
        poor = Motor("M", 600.0, 10.0, 10.5)
        drawing = self.driven(poor, "parabolic")
        (near,) = self.characteristics(drawing)
        assert {"parabola, in use", "line"} <= set(around(near))
        assert "Kloss" not in around(near)
        assert "by the recurrence: circles" in around(diagram(drawing, "$ω$, rad/s"))
        (shunt,) = self.characteristics(self.driven(Motor("D", 600.0, 10.0, 10.5, kind="shunt"), "shunt"))
        assert {"shunt, in use", "steady motion"} <= set(around(shunt))


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
