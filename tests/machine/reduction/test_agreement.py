"""Reduction against kinetostatics, against the independent solver and against adaptive quadrature."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from linkage.forces.loadings import random_loading, reversed_input
from linkage.forces.newton_euler import motions
from linkage.forces.test_stage import carried, scaled_loading, shaper_loading, turned
from linkage.forces.worked import press, press_loading
from linkage.loads.test_indicator import AREA, BACK, FOUR, engine, expected_work, gas
from linkage.scenes import crank_slider, driven_rod, four_bar, full_turn, part, shaper, with_grid, with_input
from linkage.test_properties import regular
from properties import examples
from random_mechanisms import RandomMechanism, scenes
from reference import NoPositionError
from scipy.integrate import quad
from transforms import moved, scaled

import tmmcalc
from tmmcalc import NoSolutionError, solve_kinematics
from tmmcalc.core.numerics.simpson import simpson
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.loading import Body, GearDrive, Load, Loading, Pair, Spring, Window
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.polynomial import Polynomial
from tmmcalc.linkage.loadlaws.quadratic import Quadratic
from tmmcalc.linkage.loadlaws.tabulated import Tabulated
from tmmcalc.linkage.loadlaws.viscous import Viscous
from tmmcalc.linkage.loads.scene import compile_scene
from tmmcalc.linkage.model import Mechanism
from tmmcalc.machine.reduction.causes import causes_of
from tmmcalc.machine.reduction.inertia import reduced_inertia, rods_of
from tmmcalc.machine.reduction.results import Reduction
from tmmcalc.machine.reduction.solve import solve_reduction

EXAMPLES = examples(20, derandomize=True, database=None)
TURN = 2 * np.pi


def drive_of(result: Reduction, speed: float, acceleration: float) -> Any:
    """What the drive must do so that the machine moves as asked: J eps + dJ omega^2/2 less all reduced moments."""
    return result.inertia * acceleration + result.slope * speed**2 / 2 - result.total


def check_agreement(mechanism: Mechanism, loading: Loading) -> None:
    kinematics = solve_kinematics(mechanism)
    forces = solve_forces(mechanism, loading, kinematics)
    reduced = solve_reduction(mechanism, loading, kinematics)
    rows = [forces.labels.index(label) for label in reduced.labels]
    drive = drive_of(reduced, mechanism.input.speed, mechanism.input.acceleration)
    scale = np.max(np.abs(drive)) + np.max(np.abs(reduced.total))
    assert np.max(np.abs(forces.drive[rows] - drive)) <= 1e-11 * scale
    np.testing.assert_array_equal(reduced.phi, forces.phi[rows])


def integral(f: Callable[[float], float], low: float, high: float) -> float:
    return float(quad(f, low, high, epsabs=1e-13, epsrel=1e-13, limit=200)[0])


def locked(error: tmmcalc.NoSolutionError) -> bool:
    return "self-locking" in str(error)


@given(scenes(most=3), st.integers(0, 2**32 - 1), st.booleans())
@EXAMPLES
def test_reduced_moments_ask_for_the_drive_of_the_force_analysis(scene: RandomMechanism, seed: int, back: bool) -> None:
    found = regular(reversed_input(scene) if back else scene)
    if found is None:
        return
    loading = random_loading(np.random.default_rng(seed), found[0], 0.2 * (seed % 2))
    try:
        check_agreement(found[0], loading)
    except tmmcalc.NoSolutionError as error:
        if not locked(error):
            raise


EVERY_LOAD = (
    Load("a", 3, "force", Constant(300.0), window=Window(stroke="working")),
    Load("b", 3, "force", Polynomial((10.0, -200.0, 30.0)), window=Window(angles=(5.0, 2.0))),
    Load("c", 2, "moment", Tabulated("angle", (0.5, 2.0, 4.0), (1.0, 30.0, -20.0), period=TURN)),
    Load("d", 3, "force", Viscous(500.0)),
    Load("e", 2, "force", Quadratic(300.0), 0.1 + 0.05j, 1j),
    Load("f", 2, "moment", Viscous(2.0), against=1),
    Load("g", 3, "force", Tabulated("displacement", (0.01, 0.05), (-90.0, 70.0))),
)
SPRINGS = (
    Spring("s", "linear", (2, 0), (0.1 + 0.05j, 0.2 + 0.3j), 900.0, 0.2, 30.0),
    Spring("t", "torsion", (2, 3), stiffness=8.0, free=0.2, damping=1.0),
)


@pytest.mark.parametrize("speed", [7.0, -7.0])
@pytest.mark.parametrize("gear", [False, True])
def test_they_agree_under_everything_at_once(speed: float, gear: bool) -> None:
    mechanism = with_input(full_turn(crank_slider(0.1, 0.35, 0.02), 0.0, 24), speed=speed, acceleration=-3.0)
    loading = Loading(
        bodies=(Body(1, 2.0, 0.01, 0.03 + 0.01j), Body(2, 3.0, 0.05, 0.15 + 0.02j), Body(3, 5.0, 0.0, 0.01j)),
        gravity=-9.81j,
        loads=EVERY_LOAD,
        springs=SPRINGS,
        pairs=(Pair("O", 0.1, 0.02), Pair("A", 0.15, 0.02), Pair("B", 0.1, 0.015), Pair("B0", 0.12, length=0.08)),
        drive=GearDrive(0.15, 0.35, 1.0) if gear else Loading().drive,
    )
    check_agreement(mechanism, loading)


def test_they_agree_for_the_shaper_and_a_driven_slider() -> None:
    check_agreement(with_input(shaper(), speed=5.0), shaper_loading())
    loading = Loading(
        bodies=(Body(1, 2.0, 0.0, 0.01j), Body(2, 3.0, 0.05, 0.2 + 0j), Body(3, 1.0, 0.0, 0j)),
        gravity=-9.81j,
        loads=(Load("Q", 3, "force", Viscous(50.0), direction=1j),),
        pairs=(Pair("A0", 0.1), Pair("A", 0.1, 0.02), Pair("B0", 0.1, length=0.1)),
    )
    for speed, start in ((0.4, 0.0), (-0.4, 0.2)):
        check_agreement(with_input(driven_rod(0.5, 0.3, 0.2), speed=speed, acceleration=1.5, start=start), loading)


class TestInertia:
    @pytest.mark.parametrize("seed", range(4))
    def test_kinetic_energy_of_the_independent_solver(self, seed: int) -> None:
        from random_mechanisms import build

        scene = build(np.random.default_rng(seed))
        found = regular(scene)
        if found is None:
            pytest.skip("the scene leaves the positions that assemble")
        mechanism, kinematics = found
        loading = random_loading(np.random.default_rng(seed), mechanism)
        loading = replace(loading, loads=(), springs=())
        result = solve_reduction(mechanism, loading, kinematics)
        try:
            at = motions(mechanism, scene.start, kinematics.x)
        except NoPositionError:
            pytest.skip("the reference cannot follow")
        energy = np.zeros(len(kinematics.x))
        for body in loading.bodies:
            energy += body.mass * np.abs(at.point(body.link, body.center).v) ** 2 / 2
            energy += body.inertia * at.angle(body.link)[1] ** 2 / 2
        np.testing.assert_allclose(result.inertia * mechanism.input.speed**2 / 2, energy, rtol=1e-11)

    def causes(self, speed: float) -> Any:
        mechanism = with_input(shaper(), speed=speed)
        loading = replace(shaper_loading(0.0), loads=())
        return compile_scene(mechanism, loading, solve_kinematics(mechanism))

    @pytest.mark.parametrize("speed", [5.0, -5.0])
    def test_the_derivative_by_differences_of_high_order(self, speed: float) -> None:
        scene = self.causes(speed)
        x = np.linspace(0.05, 6.2, 41)

        def inertia(at: Any) -> Any:
            return reduced_inertia(scene.loading.bodies, scene.chain.evaluate(at), len(at))[0]

        weights = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}  # central, of the eighth order
        h = 0.01
        differences = sum(w * (inertia(x + k * h) - inertia(x - k * h)) for k, w in weights.items()) / h
        slope = reduced_inertia(scene.loading.bodies, scene.chain.evaluate(x), len(x))[1]
        np.testing.assert_allclose(slope, differences, rtol=0, atol=1e-9 * np.max(np.abs(slope)))

    def test_the_derivative_by_a_complex_step(self) -> None:
        """J of a crank-slider written out once more, in complex numbers: Im J(x + ih)/h."""
        mechanism = with_input(full_turn(crank_slider(0.1, 0.35, 0.03), 0.2, 24), speed=-4.0)
        body = Body(2, 3.0, 0.07, 0.15 + 0.04j)
        slider = Body(3, 5.0, 0.3, 0.02j)
        kinematics = solve_kinematics(mechanism)
        result = solve_reduction(mechanism, Loading(bodies=(body, slider)), kinematics)

        def inertia(x: Any) -> Any:
            sine = (0.03 - 0.1 * np.sin(x)) / 0.35
            cosine = np.sqrt(1 - sine * sine)
            turning = -0.1 * np.cos(x) / (0.35 * cosine)
            vx = -0.1 * np.sin(x) - turning * (0.15 * sine + 0.04 * cosine)
            vy = 0.1 * np.cos(x) + turning * (0.15 * cosine - 0.04 * sine)
            vb = -0.1 * np.sin(x) - turning * 0.35 * sine
            return 3.0 * (vx * vx + vy * vy) + 0.07 * turning**2 + 5.0 * vb * vb

        x = kinematics.x
        np.testing.assert_allclose(result.inertia, inertia(x), rtol=1e-12)
        np.testing.assert_allclose(result.slope, inertia(x + 1e-30j).imag / 1e-30, rtol=1e-11, atol=1e-14)

    def test_the_cycle_runs_along_the_motion(self) -> None:
        for speed in (5.0, -5.0):
            mechanism = with_input(shaper(), speed=speed)
            result = solve_reduction(mechanism, shaper_loading(), solve_kinematics(mechanism))
            on = result.cycle.panels
            np.testing.assert_allclose(on.slope(result.cycle.inertia), result.cycle.slope, atol=1e-7)
            theta = np.abs(result.phi)
            np.testing.assert_allclose(on.at(result.cycle.inertia, theta), result.inertia, rtol=1e-9, atol=1e-9)
            np.testing.assert_allclose(
                on.at(result.cycle.slope, theta) * np.sign(speed), result.slope, rtol=1e-9, atol=1e-7
            )

    def test_rods(self) -> None:
        mechanism, _ = press()
        assert rods_of(mechanism, press_loading()) == (2,)
        assert rods_of(mechanism, Loading()) == ()
        assert rods_of(four_bar(0.1, 0.4, 0.25, 0.4 + 0j), Loading((Body(3, 1.0, 0.0, 0j),))) == ()  # a rocker

    def test_lumping_keeps_the_mass_and_its_centre(self) -> None:
        """With the mass moved to the pins along the rod the weights do the same work at every position."""
        mechanism, kinematics = press()
        exact, static = (
            solve_reduction(mechanism, press_loading(0.0), kinematics, rods=x) for x in ("exact", "lumped")
        )
        for one, other in zip(exact.moment, static.moment, strict=True):
            np.testing.assert_allclose(one, other, atol=1e-12)
        assert np.max(np.abs(exact.inertia - static.inertia)) > 1e-4


def test_a_load_that_does_no_work_needs_no_panels() -> None:
    """Across the motion of its point its moment is rounding alone, which must not be resolved without end."""
    mechanism = with_input(driven_rod(0.5, 0.3, 0.2), speed=-0.5, start=0.2)
    loading = Loading(loads=(Load("Q", 3, "force", Constant(7.0), window=Window(angles=(0.05, 0.1))),))
    result = solve_reduction(mechanism, loading, solve_kinematics(mechanism))
    assert result.cycle.panels.count < 100
    assert abs(result.contributions[0].work) < 1e-14


class TestWork:
    def loaded(self, speed: float) -> tuple[Mechanism, Loading]:
        mechanism = with_input(full_turn(crank_slider(0.1, 0.35, 0.02), 0.3, 24), speed=speed)
        loading = Loading(
            bodies=(Body(2, 3.0, 0.05, 0.15 + 0.02j), Body(3, 5.0, 0.0, 0j)),
            gravity=-9.81j,
            loads=EVERY_LOAD,
            springs=SPRINGS,
            pairs=(Pair("A", 0.15, 0.02), Pair("B", 0.1, 0.015), Pair("B0", 0.12, length=0.05)),
        )
        return mechanism, loading

    @pytest.mark.parametrize("speed", [7.0, -7.0])
    def test_work_against_adaptive_quadrature(self, speed: float) -> None:
        """The crank-slider written out once more, its loads integrated piece by piece."""
        mechanism, loading = self.loaded(speed)
        result = solve_reduction(mechanism, loading, solve_kinematics(mechanism))
        sense = math.copysign(1.0, speed)

        def rates(theta: float) -> tuple[float, float, float]:
            """Along the motion: of the slider, of the rod's angle, of the height of the rod's point."""
            x = 0.3 + sense * theta
            sine = (0.02 - 0.1 * math.sin(x)) / 0.35
            cosine = math.sqrt(1 - sine * sine)
            turning = -0.1 * math.cos(x) / (0.35 * cosine)
            height = 0.1 * math.cos(x) + turning * (0.1 * cosine - 0.05 * sine)
            return sense * (-0.1 * math.sin(x) - turning * 0.35 * sine), sense * turning, sense * height

        def ramp(theta: float) -> float:
            d = (theta - 5.0) % TURN
            return (10.0 - 200.0 * d + 30.0 * d * d) * rates(theta)[0]

        def table(theta: float) -> float:
            x = np.array([0.5, 2.0, 4.0])
            return float(np.interp(theta, x, (1.0, 30.0, -20.0), period=TURN)) * rates(theta)[1]

        expected = {
            "b": integral(ramp, 5.0, TURN) + integral(ramp, 0.0, 2.0),
            "c": sum(integral(table, a, b) for a, b in pairwise((0.0, 0.5, 2.0, 4.0, TURN))),
            "d": -500.0 * 7.0 * integral(lambda t: rates(t)[0] ** 2, 0.0, TURN),
            "e": -300.0 * 49.0 * integral(lambda t: abs(rates(t)[2]) ** 3, 0.0, TURN),
            "f": -2.0 * 7.0 * integral(lambda t: (rates(t)[1] - sense) ** 2, 0.0, TURN),
        }
        works = {c.name: c.work for c in result.contributions}
        for name, value in expected.items():
            assert works[name] == pytest.approx(value, rel=1e-11), name
        stroke = math.sqrt(0.45**2 - 0.02**2) - math.sqrt(0.25**2 - 0.02**2)
        assert abs(works["a"]) == pytest.approx(300.0 * stroke, rel=1e-12)

    def test_conservative_forces_do_no_work(self) -> None:
        mechanism, loading = self.loaded(7.0)
        result = solve_reduction(mechanism, loading, solve_kinematics(mechanism))
        for contribution in result.contributions:
            size = max(abs(contribution.least.value), abs(contribution.largest.value)) * TURN
            if contribution.kind in ("weight", "spring") or contribution.name == "g":
                assert abs(contribution.work) < 1e-13 * size
            elif contribution.kind in ("damper", "friction") or contribution.order > 0:
                assert contribution.work < -1e-3 * size

    def test_closed_forms(self) -> None:
        """A constant force on one stroke: Q times the stroke; viscous: -c times the mean square of S'."""
        mechanism = with_input(full_turn(crank_slider(0.1, 0.3), 0.7, 24), speed=4.0)
        push = Load("Q", 3, "force", Constant(250.0), window=Window(stroke="working"))
        drag = Load("v", 3, "force", Viscous(30.0))
        result = solve_reduction(mechanism, Loading(loads=(push, drag)), solve_kinematics(mechanism))
        works = {c.name: c.work for c in result.contributions}
        assert works["Q"] == pytest.approx(-250.0 * 0.2, rel=1e-13)

        def rate(x: float) -> float:
            sine = 0.1 * np.sin(x) / 0.3
            return float(-0.1 * np.sin(x) - 0.1 * np.cos(x) * sine / np.sqrt(1 - sine**2))

        square = quad(lambda x: rate(x) ** 2, 0, TURN, epsrel=1e-13)[0]
        assert works["v"] == pytest.approx(-30.0 * 4.0 * square, rel=1e-12)

    def test_an_indicator_over_two_turns(self) -> None:
        mechanism = engine(0.3)
        result = solve_reduction(mechanism, Loading(loads=(gas(FOUR),)), solve_kinematics(mechanism))
        assert result.contributions[0].work == pytest.approx(expected_work(FOUR, 0.1), rel=1e-12)
        assert result.cycle.period == pytest.approx(2 * TURN)
        assert result.labels[-1] == "48"
        assert (AREA, BACK) == (0.01, 1e5)

    def test_friction_with_kinks_is_exact_too(self) -> None:
        """The ram changes the face of its guide that it lies on: work against ten thousand equal steps."""
        mechanism = with_input(shaper(), speed=5.0)
        kinematics = solve_kinematics(mechanism)
        result = solve_reduction(mechanism, shaper_loading(), kinematics)
        (friction,) = [c for c in result.contributions if c.kind == "friction"]
        causes = causes_of(compile_scene(mechanism, shaper_loading(), kinematics))
        theta = (np.arange(20000) + 0.5) * TURN / 20000
        sample = causes.along(theta)
        assert np.any(np.diff(np.sign(sample.faces), axis=1) != 0)
        assert friction.work == pytest.approx(np.mean(sample.moments[-1]) * TURN, rel=3e-5)
        narrow = np.min(result.cycle.panels.width)
        assert narrow > 1e-4  # the kinks are found, not chased
        fine = result.cycle.panels.split(np.ones(result.cycle.panels.count, bool))
        finer = fine.total(causes.along(fine.x.ravel()).moments[-1].reshape(fine.x.shape))
        assert friction.work == pytest.approx(float(finer), rel=1e-10)

    def test_simpson(self) -> None:
        x = np.linspace(0, 2, 5)
        assert simpson(x, x**3) == pytest.approx(4.0)
        assert simpson(x[:4], x[:4]) is None
        assert simpson(np.array([0.0, 1.0, 3.0]), x[:3]) is None


class TestIdle:
    def test_the_idle_cycle_is_that_without_loads(self) -> None:
        """Friction is that of weights and inertia alone; the period is that of the loads."""
        mechanism, kinematics = press()
        loaded = solve_reduction(mechanism, press_loading(), kinematics)
        alone = solve_reduction(mechanism, replace(press_loading(), loads=()), kinematics)
        theta = np.linspace(0.01, TURN - 0.01, 200)
        idle, own = loaded.idle, alone.cycle
        assert idle is not None
        np.testing.assert_allclose(
            idle.panels.at(idle.moment, theta), own.panels.at(own.moment, theta), rtol=1e-9, atol=1e-9
        )
        assert alone.idle is None

    def test_without_friction(self) -> None:
        mechanism, kinematics = press()
        loading = replace(press_loading(0.0), loads=(*press_loading().loads, Load("v", 3, "force", Viscous(9.0))))
        result = solve_reduction(mechanism, loading, kinematics)
        weight = [c.name for c in result.contributions].index("weight")
        assert result.idle is not None
        np.testing.assert_allclose(result.idle.moment, result.parts[weight], atol=1e-12)
        assert not result.idle.viscous.any()
        assert result.cycle.viscous.any()

    def test_a_four_stroke_engine_idles_over_two_turns(self) -> None:
        mechanism = engine(0.3)
        loading = Loading((Body(3, 1.0, 0.0, 0j),), -9.81j, (gas(FOUR),), pairs=(Pair("B0", 0.1),))
        result = solve_reduction(mechanism, loading, solve_kinematics(mechanism))
        assert result.idle is not None
        assert result.idle.period == pytest.approx(2 * TURN)

    def test_massless_links_idle_without_friction(self) -> None:
        mechanism = engine(0.3)
        result = solve_reduction(
            mechanism, Loading(loads=(gas(FOUR),), pairs=(Pair("B0", 0.1),)), solve_kinematics(mechanism)
        )
        assert result.idle is not None
        assert not result.idle.moment.any()

    def test_a_linkage_that_sticks_without_its_load(self) -> None:
        """Its weight alone would lock the slider; a load that draws it down keeps it going."""
        mechanism = part(crank_slider(0.95, 1.0), -np.pi / 2 - 0.2, -np.pi / 2 + 0.2, 4)
        bodies, pairs = (Body(3, 1.0, 0.0, 0j),), (Pair("B0", 0.5),)
        load = Load("Q", 3, "force", Constant(500.0))
        quiet = Loading(bodies, -9.81 + 0j, pairs=pairs)
        with pytest.raises(NoSolutionError, match="self-locking"):
            solve_reduction(mechanism, quiet, solve_kinematics(mechanism))
        result = solve_reduction(mechanism, replace(quiet, loads=(load,)), solve_kinematics(mechanism))
        assert result.idle is None


class TestGrades:
    def result(self, **options: Any) -> Reduction:
        mechanism = with_input(full_turn(crank_slider(0.1, 0.3), 0.7, 24), speed=4.0)
        load = Load("Q", 3, "force", options.pop("law", Constant(250.0)), **options)
        return solve_reduction(mechanism, Loading(loads=(load,)), solve_kinematics(mechanism))

    @pytest.mark.parametrize(
        ("force", "role", "wrong"),
        [(250.0, "resistance", False), (-250.0, "resistance", True), (250.0, "drive", True), (-250.0, "drive", False)]
        + [(force, "neutral", False) for force in (250.0, -250.0)],
    )
    def test_a_wrong_sign_is_told(self, force: float, role: Any, wrong: bool) -> None:
        """On the working stroke the slider moves against the axis: a positive force resists."""
        result = self.result(law=Constant(force), role=role, window=Window(stroke="working"))
        assert len(result.grades) == wrong
        if wrong:
            (grade,) = result.grades
            assert (grade.severity, grade.where) == ("warning", "load Q")
            does = "drives" if role == "resistance" else "resists"
            assert f"called a {role} but {does}: {-force * 0.2:+.6g} J" in grade.message

    def test_a_resistance_without_its_window(self) -> None:
        """A constant force drives the centric slider back over the half turn on which the axis points along it."""
        (grade,) = self.result().grades
        assert (grade.severity, grade.where) == ("warning", "load Q")
        # the crank begins at 0.7 rad, so that the dead centres lie at theta = pi - 0.7 and 2 pi - 0.7
        assert "drives from 139.89 deg to 319.89 deg: +50 J, 100 % of what it takes elsewhere" in grade.message
        assert "does no work in all" in grade.message

    def test_a_neutral_load_may_drive_and_resist(self) -> None:
        assert not self.result(role="neutral").grades

    def test_a_gas_may_drive_on_a_stroke(self) -> None:
        """The pressure of a compressor drives its piston back where it expands again."""
        mechanism = engine()
        expansion, compression = ((0.0, 0.2, 1.0), (6e5, 1e5, 1e5)), ((1.0, 0.4, 0.0), (1e5, 6e5, 6e5))
        loading = Loading(loads=(gas((expansion, compression)),))
        result = solve_reduction(mechanism, loading, solve_kinematics(mechanism))
        assert result.contributions[0].largest.value > 0 > result.contributions[0].work
        assert result.grades == ()

    @pytest.mark.parametrize(("peak", "severity"), [(40.0, "warning"), (20.0, "note"), (1.0, None)])
    def test_driving_a_little(self, peak: float, severity: str | None) -> None:
        """A moment of -100 N*m on the crank with a triangle up to +peak: areas and crossings in closed form."""
        mechanism = with_input(full_turn(crank_slider(0.1, 0.3), 0.7, 24), speed=4.0)
        law = Tabulated("angle", (0.0, 2.0, 4.0, 6.0), (-100.0, -100.0, peak, -100.0))
        load = Load("Q", 1, "moment", law)
        result = solve_reduction(mechanism, Loading(loads=(load,)), solve_kinematics(mechanism))
        gained, slant = 2 * peak**2 / (100 + peak), 2 * peak / (100 + peak)
        net = 2 * (peak - 100) - 200 - 100 * (TURN - 6)
        assert result.contributions[0].work == pytest.approx(net, rel=1e-12)
        assert [grade.severity for grade in result.grades] == ([severity] if severity else [])
        if severity:
            low, high = (f"{math.degrees(theta):.5g} deg" for theta in (4 - slant, 4 + slant))
            share = f"{100 * gained / (gained - net):.3g} %"
            text = f"drives from {low} to {high}: {gained:+.6g} J, {share} of what it takes elsewhere"
            assert text in result.grades[0].message
            assert f"does {net:+.6g} J in all" in result.grades[0].message


class TestInvariance:
    @given(scenes(most=2), st.integers(0, 2**32 - 1), st.floats(-3, 3))
    @EXAMPLES
    def test_the_whole_plane_moved(self, scene: RandomMechanism, seed: int, turn: float) -> None:
        found = regular(scene)
        if found is None:
            return
        mechanism, _ = found
        loading = replace(random_loading(np.random.default_rng(seed), mechanism), drive=Loading().drive)
        e, shift = complex(np.exp(1j * turn)), 0.3 - 2j
        laid = replace(
            loading,
            gravity=loading.gravity * e,
            loads=tuple(turned(load, e) for load in loading.loads),
            springs=tuple(carried(spring, turn, shift) for spring in loading.springs),
        )
        self.same(mechanism, loading, moved(mechanism, turn, shift), laid, 1.0, 1.0)

    @given(scenes(most=2), st.integers(0, 2**32 - 1), st.floats(-3, 3))
    @EXAMPLES
    def test_another_unit_of_length(self, scene: RandomMechanism, seed: int, exponent: float) -> None:
        found = regular(scene)
        if found is None:
            return
        mechanism, _ = found
        loading = random_loading(np.random.default_rng(seed), mechanism)
        k = 10**exponent
        turns = mechanism.joint(mechanism.input.joint).kind == "revolute"
        self.same(
            mechanism,
            loading,
            scaled(mechanism, k),
            scaled_loading(loading, mechanism, k),
            k * k if turns else k,
            k * k if turns else 1.0,
        )

    def same(
        self, one: Mechanism, loading: Loading, two: Mechanism, other: Loading, moment: float, inertia: float
    ) -> None:
        a = solve_reduction(one, loading, solve_kinematics(one))
        b = solve_reduction(two, other, solve_kinematics(two))
        scale = np.max(np.abs(a.moment), initial=1e-9)
        np.testing.assert_allclose(b.moment / moment, a.moment, rtol=0, atol=1e-9 * scale)
        np.testing.assert_allclose(b.inertia / inertia, a.inertia, rtol=1e-9)
        assert [c.kind for c in a.contributions] == [c.kind for c in b.contributions]


def test_self_locking_is_refused() -> None:
    mechanism = part(crank_slider(0.95, 1.0), -np.pi / 2 - 0.2, -np.pi / 2 + 0.2, 4)
    loading = Loading(loads=(Load("Q", 3, "force", Constant(-100.0)),), pairs=(Pair("B0", 0.5),))
    with pytest.raises(NoSolutionError, match=r"self-locking at position 0, position 1") as raised:
        solve_reduction(mechanism, loading, solve_kinematics(mechanism))
    assert raised.value.where == "forces, group RRP(2,3)"


def test_an_open_range() -> None:
    """Over a part of a turn the work is that between its ends."""
    mechanism = with_grid(part(crank_slider(0.1, 0.3), 0.5, 2.5), positions=8)
    kinematics = solve_kinematics(mechanism)
    loading = Loading((Body(3, 2.0, 0.0, 0j),), -9.81 + 0j, (Load("Q", 3, "force", Constant(40.0)),))
    result = solve_reduction(mechanism, loading, kinematics)
    travelled = float(kinematics.s[0, -1] - kinematics.s[0, 0])
    works = {c.name: c.work for c in result.contributions}
    assert works["Q"] == pytest.approx(40.0 * travelled, rel=1e-12)
    assert works["weight"] == pytest.approx(-9.81 * 2.0 * travelled, rel=1e-12)
    assert not result.whole
    assert result.cycle.period == pytest.approx(2.0)
