"""Methods for forces of position: worked numbers, closed forms, limits, scaling laws, the exact re-simulation."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from properties import examples

from machine.flywheel.scenes import CASES, TURN, brute_delta, press, press_cycle
from tmmcalc.core.errors import UsageError
from tmmcalc.core.numerics.panels import panels
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.diagram import from_harmonics, from_pieces
from tmmcalc.machine.flywheel.curve import energy_curve
from tmmcalc.machine.flywheel.methods import FlywheelMethod, nodal_flywheels, positional_flywheels
from tmmcalc.machine.flywheel.resimulation import motions
from tmmcalc.machine.flywheel.wittenbauer import METHODS, energy_mass
from tmmcalc.machine.nodes import nodal_work
from tmmcalc.machine.positional import positional


def by_name(methods: tuple[FlywheelMethod, ...]) -> dict[str, FlywheelMethod]:
    return {method.method: method for method in methods}


def printed(value: float, text: float) -> bool:
    """Whether a value agrees with a printed number in all its digits."""
    digits = 10.0 ** (np.floor(np.log10(abs(text))) - 5)
    return abs(value - text) <= 0.6 * digits


class TestPress:
    """Case dyn-flywheel-positional: the press of the textbook's appendix 3."""

    case = CASES["dyn-flywheel-positional"]["expected"]

    def test_fine(self) -> None:
        expected = self.case["fine"]
        cycle = press_cycle()
        found = by_name(positional_flywheels(cycle, 0.0, 0.04))
        assert printed(found["exact"].inertia, expected["J_F_exact"])
        assert printed(found["book"].inertia, expected["J_F_book_linearised_tangents"])
        assert printed(found["mertsalov"].inertia, expected["J_F_mertsalov"])
        assert found["excess work"].inertia * 0.04 * 25 == pytest.approx(expected["A_max_minus_A_min"], rel=2e-6)
        picture = energy_mass(cycle, 0.04)
        assert printed(picture.drive, expected["M_drive_const"])
        assert picture.intercepts == pytest.approx((expected["b_max"], expected["b_min"]), rel=2e-5)
        step = TURN / 7200
        assert abs(found["exact"].theta_max - expected["phi_max_tangent_rad"]) < step
        assert abs(found["exact"].theta_min - expected["phi_min_tangent_rad"]) < step

    def test_nodes(self) -> None:
        expected = self.case["nodes_12"]
        phi = np.arange(13) * np.pi / 6
        inertia, moment = press(phi)
        moment[-1] = moment[0]
        np.testing.assert_allclose(inertia, expected["J_var"], atol=6e-8)
        np.testing.assert_allclose(moment, expected["M_resist"], atol=6e-5)
        work, drive = nodal_work(moment)
        np.testing.assert_allclose(work, expected["A"], atol=6e-5)
        assert printed(drive, expected["M_drive_const"])
        found = by_name(nodal_flywheels(work, inertia, 0.0, 0.04, 5.0))
        assert printed(found["exact"].inertia, expected["J_F_exact"])
        assert printed(found["book"].inertia, expected["J_F_book_linearised_tangents"])
        assert printed(found["mertsalov"].inertia, expected["J_F_mertsalov"])
        assert abs(found["exact"].theta_max - expected["phi_max_tangent_rad"]) < 1e-3
        assert found["exact"].theta_min == expected["phi_min_tangent_rad"]
        assert found["exact"].delta == pytest.approx(expected["delta_check"], abs=1e-14)

    @pytest.mark.slow
    def test_reached_by_brute_force(self) -> None:
        """Every method re-simulated on 400 000 samples by bisection on the initial energy."""
        cycle = press_cycle()
        curve = energy_curve(cycle)
        x = np.linspace(0, TURN, 400001)
        work, inertia = cycle.panels.at(np.stack((curve.work, curve.inertia)), x)
        for method in positional_flywheels(cycle, 0.0, 0.04):
            assert method.delta == pytest.approx(brute_delta(work, inertia, method.inertia, 5.0), abs=1e-10)

    def test_reached_by_the_regime(self) -> None:
        """Against the steady motion as the other room finds it, from the speed itself."""
        for method in positional_flywheels(press_cycle(), 0.0, 0.04):
            regime = positional(press_cycle(), method.inertia)
            assert regime.delta == pytest.approx(method.delta, abs=1e-12)
            assert regime.mean == pytest.approx(5.0, rel=1e-13)

    @pytest.mark.parametrize("delta", [1e-4, 0.04, 0.3, 0.9])
    def test_reached_to_the_last_digit(self, delta: float) -> None:
        exact = positional_flywheels(press_cycle(), 0.0, delta)[0]
        assert exact.delta == pytest.approx(delta, abs=1e-12)

    def test_panels_do_not_matter(self) -> None:
        coarse, fine = (positional_flywheels(press_cycle(w), 0.0, 0.04) for w in (np.pi / 4, np.pi / 16))
        for a, b in zip(coarse, fine, strict=True):
            assert a.inertia == pytest.approx(b.inertia, rel=1e-13)
            assert a.theta_max == pytest.approx(b.theta_max, abs=1e-9)


class TestSine:
    """Case dyn-flywheel-sine and diagrams whose excess work is known by hand."""

    def test_case(self) -> None:
        case = CASES["dyn-flywheel-sine"]
        cycle = from_harmonics(0.0, [(1, 0.0, case["inputs"]["M1"])], case["inputs"]["omega_mean"])
        for method in positional_flywheels(cycle, 0.0, case["inputs"]["delta"]):
            assert method.inertia == pytest.approx(case["expected"]["J_F"], rel=1e-14)
            assert method.theta_max == pytest.approx(np.pi, abs=1e-7)
            assert method.theta_min == case["expected"]["phi_of_omega_min_rad"]
            assert method.delta == pytest.approx(case["inputs"]["delta"], abs=1e-15)

    @pytest.mark.parametrize(("a", "b"), [(100.0, 30.0), (100.0, 90.0), (-40.0, 100.0)])
    def test_two_harmonics(self, a: float, b: float) -> None:
        """M = a sin + b sin 2: A = a (1 - c) + b (1 - c^2) with c = cos theta, extreme at the ends or c = -a/2b."""
        cycle = from_harmonics(500.0, [(1, 0, a), (2, 0, b)], 10.0)
        c = np.array([-1.0, 1.0] + ([-a / (2 * b)] if abs(a) < abs(2 * b) else []))
        excess = np.ptp(a * (1 - c) + b * (1 - c * c))
        for method in positional_flywheels(cycle, 0.0, 0.05):
            assert method.inertia == pytest.approx(excess / (0.05 * 100), rel=1e-13)

    def test_rectangles(self) -> None:
        """A punch: 10 kN*m over a sixth of the turn, the motor steady; the excess is 5/6 of the work of the stroke."""
        cycle = from_pieces([(0, 0), (1.0, 0), (1.0, -1e4), (1 + np.pi / 3, -1e4), (1 + np.pi / 3, 0), (TURN, 0)], 8.0)
        exact = positional_flywheels(cycle, 0.0, 0.1)[0]
        assert exact.inertia == pytest.approx(1e4 * np.pi / 3 * 5 / 6 / (0.1 * 64), rel=1e-13)
        assert (exact.theta_max, exact.theta_min) == pytest.approx((1.0, 1 + np.pi / 3), abs=1e-12)

    def test_trapezoid(self) -> None:
        """Ramp up over 1 rad, level for 1 rad, ramp down over 1 rad: areas by hand."""
        top = 600.0
        cycle = from_pieces([(0, 0), (1, top), (2, top), (3, 0)], 10.0)
        mean = 2 * top / TURN
        share = mean / top  # where the ramps cross the mean, in radians from their feet
        above = (top - mean) * (1 + (3 - 2 * share)) / 2
        assert positional_flywheels(cycle, 0.0, 0.02)[0].inertia == pytest.approx(above / (0.02 * 100), rel=1e-13)

    def test_links_in_step_with_the_work(self) -> None:
        """A = a (1 - cos 2 theta), J = j (1 - cos 2 theta): the energy-mass curve is a straight stroke."""
        a, j, w, delta = 80.0, 0.5, 12.0, 0.06
        on = panels(0.0, TURN)
        s, c = np.sin(2 * on.x), np.cos(2 * on.x)
        nothing = np.zeros_like(s)
        cycle = Cycle(on, j * (1 - c), 2 * j * s, 2 * a * s, nothing, nothing, w)
        found = by_name(positional_flywheels(cycle, 0.0, delta))
        high, low = a - j * w**2 / 2 * (1 + delta / 2) ** 2, a - j * w**2 / 2 * (1 - delta / 2) ** 2
        assert found["exact"].inertia == pytest.approx((max(0, 2 * high) - min(0, 2 * low)) / (delta * w**2), rel=1e-13)
        assert found["mertsalov"].inertia == pytest.approx(2 * (a - j * w**2 / 2) / (delta * w**2), rel=1e-13)
        assert found["excess work"].inertia == pytest.approx(2 * a / (delta * w**2), rel=1e-13)


class TestLaws:
    def test_all_methods_meet_as_delta_falls(self) -> None:
        """The book's form is off by delta^2, Mertsalov's by delta, against the exact one."""
        off = {rule.name: [] for rule in METHODS}
        for delta in (0.08, 0.04, 0.02, 0.01):
            for method in positional_flywheels(press_cycle(), 0.0, delta):
                off[method.method].append(abs(method.error))
        orders = {name: np.log2(np.array(e[:-1]) / e[1:]) for name, e in off.items() if name in ("book", "mertsalov")}
        np.testing.assert_allclose(orders["book"], 2, atol=0.05)
        np.testing.assert_allclose(orders["mertsalov"], 1, atol=0.05)

    @pytest.mark.parametrize("scale", [1e-3, 7.0, 1e4])
    def test_scale_of_forces_and_masses(self, scale: float) -> None:
        cycle = press_cycle()
        larger = replace(cycle, inertia=scale * cycle.inertia, moment=scale * cycle.moment)
        for a, b in zip(positional_flywheels(cycle, 0.0, 0.04), positional_flywheels(larger, 0.0, 0.04), strict=True):
            assert b.inertia == pytest.approx(scale * a.inertia, rel=1e-12)
            assert b.delta == pytest.approx(a.delta, abs=1e-12)

    def test_speed_and_masses(self) -> None:
        """Doubling the speed with a quarter of the masses changes no energy: J_F falls to a quarter."""
        cycle = press_cycle()
        lighter = replace(cycle, inertia=cycle.inertia / 4, speed=2 * cycle.speed)
        for a, b in zip(positional_flywheels(cycle, 0.0, 0.04), positional_flywheels(lighter, 0.0, 0.04), strict=True):
            assert b.inertia == pytest.approx(a.inertia / 4, rel=1e-12)

    def test_constant_inertia_moves_to_the_flywheel(self) -> None:
        """Constant inertia may be counted with the links or apart: the exact total stays."""
        cycle = press_cycle()
        within = replace(cycle, inertia=cycle.inertia + 5)
        assert positional_flywheels(within, 0.0, 0.04)[0].inertia + 5 == pytest.approx(
            positional_flywheels(cycle, 0.0, 0.04)[0].inertia, rel=1e-13
        )

    @examples(25)
    @given(
        st.lists(st.floats(-100, 100), min_size=6, max_size=6),
        st.floats(0.005, 0.5),
        st.floats(0, 5),
    )
    def test_any_cycle_reaches_delta(self, amplitudes: list[float], delta: float, light: float) -> None:
        on = panels(0.0, TURN)
        a1, b1, a2, b2, a3, b3 = amplitudes
        moment = sum(a * np.cos(k * on.x) + b * np.sin(k * on.x) for k, a, b in ((1, a1, b1), (2, a2, b2), (3, a3, b3)))
        inertia = light * (1.2 + np.cos(2 * on.x - 0.7))
        nothing = np.zeros_like(inertia)
        cycle = Cycle(on, inertia, on.slope(inertia), moment + nothing, nothing, nothing, 9.0)
        exact = positional_flywheels(cycle, 0.0, delta)[0]
        if exact.inertia > 1e-6:
            assert exact.delta == pytest.approx(delta, abs=1e-12)
            x = np.linspace(0, TURN, 20001)
            curve = energy_curve(cycle)
            work, links = on.at(np.stack((curve.work, curve.inertia)), x)
            assert brute_delta(work, links, exact.inertia, 9.0) == pytest.approx(delta, abs=1e-6)

    def test_forces_that_depend_on_speed_count_at_the_mean(self) -> None:
        cycle = press_cycle()
        bump = 1 + np.cos(cycle.panels.x)
        braked = replace(cycle, viscous=-2 * bump, quadratic=-0.1 * bump)
        plain = replace(cycle, moment=cycle.moment - (2 * 5 + 0.1 * 25) * bump)
        assert positional_flywheels(braked, 0.0, 0.04)[0].inertia == pytest.approx(
            positional_flywheels(plain, 0.0, 0.04)[0].inertia, rel=1e-13
        )


class TestPicture:
    def test_both_tangents_meet_in_the_origin(self) -> None:
        picture = energy_mass(press_cycle(), 0.04)
        for slope, intercept in zip(picture.slopes, picture.intercepts, strict=True):
            assert slope * -picture.inertia + intercept == pytest.approx(-picture.energy, rel=1e-13)
        assert (picture.intercepts[0] - picture.intercepts[1]) / (0.04 * 25) == pytest.approx(picture.inertia)

    def test_curve_lies_between_and_touches(self) -> None:
        picture = energy_mass(press_cycle(), 0.04)
        above = picture.work - picture.slopes[0] * picture.links - picture.intercepts[0]
        below = picture.work - picture.slopes[1] * picture.links - picture.intercepts[1]
        assert abs(above.max()) < 1e-12
        assert abs(below.min()) < 1e-12
        assert picture.theta[0] == 0
        assert picture.theta[-1] == TURN
        assert picture.work[-1] == pytest.approx(picture.work[0], abs=1e-12)

    def test_energy_gives_the_speed(self) -> None:
        picture = energy_mass(press_cycle(), 0.04)
        omega = np.sqrt(2 * (picture.energy + picture.work) / (picture.inertia + picture.links))
        assert (omega.max(), omega.min()) == pytest.approx((5 * 1.02, 5 * 0.98), rel=1e-13)

    def test_angles_in_a_drawing(self) -> None:
        """(3.50): with 1 mm for 0.001 kg*m^2 and for 0.5 J."""
        angles = energy_mass(press_cycle(), 0.04).angles(0.001 / 0.5)
        assert np.tan(angles) == pytest.approx([0.001 / 0.5 * 12.5 * 1.02**2, 0.001 / 0.5 * 12.5 * 0.98**2])


class TestVerdicts:
    def test_nothing_to_add(self) -> None:
        for method in positional_flywheels(press_cycle(), 60.0, 0.04):
            assert method.addition == 0
            assert method.delta is not None
            assert method.delta < 0.04

    def test_part_at_hand(self) -> None:
        for method in positional_flywheels(press_cycle(), 10.0, 0.04):
            assert method.addition == pytest.approx(method.inertia - 10)

    def test_too_light_to_pass_the_cycle(self) -> None:
        curve = energy_curve(press_cycle())
        run = motions(curve, np.array([0.2, 40.0]), 5.0)
        assert run.exists.tolist() == [False, True]

    def test_given_drive(self) -> None:
        """The engine's own view: half of the load carried by a given moment that follows the angle."""
        cycle = press_cycle()
        pulsing = -0.5 * cycle.moment
        rest = -float(cycle.panels.total(cycle.moment + pulsing)) / TURN
        given_all = positional_flywheels(cycle, 0.0, 0.04, moment=pulsing + rest)
        halved = replace(cycle, moment=0.5 * cycle.moment)
        assert given_all[0].inertia == pytest.approx(positional_flywheels(halved, 0.0, 0.04)[0].inertia, rel=1e-12)
        with pytest.raises(UsageError, match="over in each cycle"):
            positional_flywheels(cycle, 0.0, 0.04, moment=8.0)

    @pytest.mark.parametrize(
        ("constant", "delta", "speed"), [(0.0, 0.0, 5.0), (0.0, 1.0, 5.0), (0.0, 0.04, -5.0), (-1.0, 0.04, 5.0)]
    )
    def test_refused(self, constant: float, delta: float, speed: float) -> None:
        with pytest.raises(UsageError):
            positional_flywheels(press_cycle(), constant, delta, speed)

    def test_nodes_must_match(self) -> None:
        with pytest.raises(UsageError, match="same nodes"):
            nodal_flywheels(np.zeros(5), np.zeros(6), 0.0, 0.04, 5.0)

    def test_no_load_at_all(self) -> None:
        """Steady moment and constant inertia: nothing fluctuates, and nothing is asked for."""
        cycle = from_harmonics(5.0, [], 10.0)
        for method in positional_flywheels(cycle, 1.0, 0.04):
            assert (method.inertia, method.addition, method.delta) == pytest.approx((0.0, 0.0, 0.0), abs=1e-13)
