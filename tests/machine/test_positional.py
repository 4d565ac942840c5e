"""Steady motion under forces of position: the level of the speed, no inertia at all, and the limits."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from properties import examples
from scipy.optimize import brentq
from scipy.special import ellipe
from sparing import sparing

from machine.flywheel.scenes import press_cycle
from machine.motion import CASES, TURN, Constant, cycle_of, of_pieces, upsetter, upsetter_functions
from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.machine.positional import positional
from tmmcalc.machine.steady import driven


def conserved(x: Any) -> tuple[Any, Any, Any]:
    """No moment at all: case dyn-closed-energy."""
    return 0.5 + 0.3 * (1 - np.cos(2 * x)), 0.6 * np.sin(2 * x), 0 * x


def test_kinetic_energy_is_conserved_without_moments() -> None:
    case = CASES["dyn-closed-energy"]["expected"]
    low, high = 10 * math.sqrt(0.5 / 1.1), 10.0
    regime = positional(cycle_of(conserved), 0.0, (low + high) / 2)
    exact = 10 * np.sqrt(0.5 / (0.5 + 0.3 * (1 - np.cos(2 * regime.panels.x))))
    np.testing.assert_allclose(regime.omega, exact, rtol=1e-14)
    np.testing.assert_allclose(regime.omega_at(np.array(case["phi"])), case["omega"], rtol=1e-6)
    assert regime.delta == pytest.approx(case["delta"], rel=1e-8)
    assert regime.omega_min == pytest.approx(low, rel=1e-14)
    assert regime.omega_max == pytest.approx(high, rel=1e-14)
    assert regime.theta_min == pytest.approx(math.pi / 2, abs=1e-7) or regime.theta_min == pytest.approx(
        3 * math.pi / 2, abs=1e-7
    )
    assert np.max(np.abs(regime.driving)) == 0.0
    assert regime.stable is None
    assert regime.multipliers == (1 + 0j,)


@sparing("ratio", [1e-4, 1e-6, 1e-8], every=3)
def test_hardly_any_inertia_where_the_links_stand_still(ratio: float) -> None:
    """omega = c/sqrt(ratio + sin^2) peaks twice; panels that follow rounding alone would be thousands."""
    cycle = cycle_of(lambda x: (np.sin(x) ** 2, np.sin(2 * x), 0 * x))
    root = math.sqrt(1 + 1 / ratio)
    fastest = 10 * 2 * root / (root + 1)
    regime = positional(cycle, ratio, 10.0)
    assert regime.panels.count < 200
    assert regime.delta == pytest.approx(2 / ratio / (root + 1) ** 2, rel=1e-12)
    exact = fastest / np.sqrt(1 + np.sin(regime.panels.x) ** 2 / ratio)
    off = float(np.max(np.abs(regime.omega / exact - 1)))
    assert off <= regime.error
    assert off < 2e-16 / ratio
    assert regime.cycle_time == pytest.approx(4 * ellipe(-1 / ratio) / fastest, rel=2e-16 / ratio)


def test_the_place_of_a_stop_is_the_coordinate_of_the_input() -> None:
    cycle = cycle_of(lambda x: (0 * x, 0 * x, 200 * np.sin(x - 1)))
    for sense, told in ((1.0, f"stop at {math.degrees(1):.6g} deg"), (-1.0, f"stop at {-math.degrees(1):.6g} deg")):
        with pytest.raises(NoSolutionError, match=told):
            positional(cycle, 1.0, 5.0, sense=sense)


def test_energy_beside_a_huge_flywheel() -> None:
    """The fluctuation of a conserved energy is (J_max - J_min)/(2 J) to first order."""
    regime = positional(cycle_of(conserved), 1e6, 10.0)
    assert regime.delta == pytest.approx(0.6 / 2e6, rel=2e-6)


@pytest.mark.parametrize("inertia", [3.0, 5.0, 25.0, 1e5])
def test_sinusoidal_surplus(inertia: float) -> None:
    """Case dyn-flywheel-sine: w_max^2 - w_min^2 = 4 M1/J and w_max + w_min = 2 w."""
    given_ = CASES["dyn-flywheel-sine"]["inputs"]
    moment, mean = given_["M1"], given_["omega_mean"]
    cycle = cycle_of(lambda x: (0 * x, 0 * x, moment * np.sin(x) - 37.0))
    regime = positional(cycle, inertia, mean)
    assert regime.delta == pytest.approx(2 * moment / (inertia * mean**2), rel=1e-8)
    assert regime.mean == pytest.approx(mean, rel=1e-14)
    assert regime.theta_max == pytest.approx(math.pi, abs=1e-4)
    assert regime.mean_moment == pytest.approx(37.0, rel=1e-14)
    level = regime.omega_min**2 * inertia / 2
    exact = np.sqrt(2 * (level + moment * (1 - np.cos(regime.panels.x))) / inertia)
    np.testing.assert_allclose(regime.omega, exact, rtol=1e-14)
    if inertia == 25.0:
        assert regime.delta == pytest.approx(given_["delta"], rel=1e-12)


def test_press_case_with_its_exact_flywheel() -> None:
    case = CASES["dyn-flywheel-positional"]["expected"]["fine"]
    regime = positional(press_cycle(), case["J_F_exact"], 5.0)
    assert regime.delta == pytest.approx(0.04, rel=1e-4)
    assert regime.mean_moment == pytest.approx(case["M_drive_const"], rel=1e-5)
    assert regime.theta_max == pytest.approx(case["phi_max_tangent_rad"], abs=0.01)
    assert regime.theta_min == pytest.approx(case["phi_min_tangent_rad"], abs=0.01)


@sparing("constant", [1.8, 3.0, 30.0, 1e4], every=4)
def test_upsetter_against_quadrature_and_a_root(constant: float) -> None:
    """The level of the energy by scipy on a dense grid of the closed formulas."""
    regime = positional(upsetter(), constant, 10.0)
    functions = upsetter_functions(1.0)
    t, w = np.polynomial.legendre.leggauss(60)
    mean = 0.0
    for low, high in ((0.0, math.pi), (math.pi, TURN)):
        x = (low + high) / 2 + (high - low) / 2 * t
        mean += float(w @ functions(x)[2]) * (high - low) / 2 / TURN
    x = np.linspace(0, TURN, 4001)
    work = np.concatenate(
        (
            [0.0],
            np.cumsum(
                [float(w @ (functions((a + b) / 2 + (b - a) / 2 * t)[2] - mean)) * (b - a) / 2 for a, b in pairwise(x)]
            ),
        )
    )
    inertia = functions(x)[0] + constant

    def off(level: float) -> float:
        omega = np.sqrt(2 * (level + work) / inertia)
        return float(omega.max() + omega.min()) - 20.0

    level = brentq(off, -work.min() + 1e-9, 1e3 * constant + 1e4)
    omega = np.sqrt(2 * (level + work) / inertia)
    np.testing.assert_allclose(regime.omega_at(x), omega, rtol=3e-4 if constant < 2 else 5e-6)
    assert regime.mean == pytest.approx(10.0, rel=2e-15)
    assert regime.driving[0, 0] == pytest.approx(-mean, rel=1e-13)
    assert abs(regime.residual) < 1e-15


def test_without_any_constant_inertia() -> None:
    """The links alone: J = 0.2 + sin^2 and a small moment; exact by the energy equation."""
    cycle = cycle_of(lambda x: (0.2 + np.sin(x) ** 2, np.sin(2 * x), 3 * np.cos(x) - 1))
    regime = positional(cycle, 0.0, 10.0)
    inertia = 0.2 + np.sin(regime.panels.x) ** 2
    energy = inertia * regime.omega**2 / 2 - 3 * np.sin(regime.panels.x)
    np.testing.assert_allclose(energy, energy[0, 0], rtol=1e-13)
    assert regime.mean == pytest.approx(10.0, rel=1e-14)
    assert regime.delta > 0.8


@given(st.lists(st.floats(-50, 50), min_size=4, max_size=4), st.floats(0.0, 100.0), st.floats(5.0, 50.0))
@examples(40)
def test_any_load_is_balanced_or_refused_with_the_inertia_that_would_do(
    waves: list[float], constant: float, speed: float
) -> None:
    def functions(x: Any) -> tuple[Any, Any, Any]:
        load = sum(a * np.cos((k + 1) * x + k) for k, a in enumerate(waves)) - 20
        return 0.5 + 0.3 * np.cos(2 * x), -0.6 * np.sin(2 * x), load

    cycle = cycle_of(functions)
    try:
        regime = positional(cycle, constant, speed)
    except NoSolutionError as stop:
        need = stop.limit or 0.0
        regime = positional(cycle, need * 1.02 + 1e-6, speed)
        assert need >= constant
        assert regime.delta > 1.0
    # a rounding of the energy moves the least speed the more the nearer to a stop it is
    energy = (functions(regime.panels.x)[0] + regime.constant_inertia) * regime.omega**2 / 2
    slowest = functions(regime.theta_min)[0] + regime.constant_inertia
    rounding = 2.0**-52 * float(np.ptp(energy)) / (slowest * regime.omega_min * speed)
    assert regime.mean == pytest.approx(speed, rel=1e-15 + 4 * rounding)
    assert abs(regime.residual) < 1e-13
    x = np.linspace(0, TURN, 3000)
    assert regime.omega_max >= np.max(regime.omega_at(x)) * (1 - 1e-12)
    assert regime.omega_min <= np.min(regime.omega_at(x)) * (1 + 1e-12)


def test_the_limit_of_the_energy_is_exact() -> None:
    """M1 sin on a constant inertia: the speed touches zero when J w^2 = M1; it rises to twice the mean then."""
    cycle = cycle_of(lambda x: (0 * x, 0 * x, 100 * np.sin(x)))
    with pytest.raises(NoSolutionError, match=r"stop at (0|360) deg") as caught:
        positional(cycle, 0.9, 10.0)
    assert caught.value.limit == pytest.approx(1.0, rel=1e-12)
    assert caught.value.value == 0.9
    assert "flywheel" in caught.value.remedy
    assert positional(cycle, 1.01, 10.0).delta == pytest.approx(2 / 1.01, rel=1e-6)


def test_given_moments() -> None:
    """An engine's cycle: a driving moment known over the angle against a load that it has to balance."""
    cycle = of_pieces([-30.0, -10.0], [0.0, math.pi, TURN])
    constant = positional(cycle, 3.0, 10.0)
    assert constant.driving[0, 0] == pytest.approx(20.0, rel=1e-14)
    same = positional(cycle, 3.0, 10.0, given_moment=20.0)
    np.testing.assert_allclose(same.omega, constant.omega, rtol=1e-14)
    wave = 20 + 15 * np.sin(cycle.panels.x)
    varying = positional(cycle, 3.0, 10.0, given_moment=wave)
    assert varying.mean_moment == pytest.approx(20.0, rel=1e-14)
    np.testing.assert_allclose(varying.driving.ravel(), 20 + 15 * np.sin(varying.panels.x.ravel()), rtol=1e-13)
    with pytest.raises(NoSolutionError, match="grows without end") as caught:
        positional(cycle, 3.0, 10.0, given_moment=21.0)
    assert caught.value.value == pytest.approx(TURN, rel=1e-12)
    with pytest.raises(NoSolutionError, match="falls to a stand"):
        positional(cycle, 3.0, 10.0, given_moment=wave - 1)


@pytest.mark.parametrize(("viscous", "quadratic"), [(-0.5, -0.1), (-8.0, 0.0), (0.0, -0.5)])
@pytest.mark.parametrize("constant", [2.5, 30.0, 1e5])
def test_resistances_that_depend_on_speed(viscous: float, quadratic: float, constant: float) -> None:
    """The moment found, put in as that of a motor without slope, gives the same regime."""
    cycle = replace(
        upsetter(),
        viscous=np.full(upsetter().moment.shape, viscous),
        quadratic=np.full(upsetter().moment.shape, quadratic),
    )
    regime = positional(cycle, constant, 10.0)
    assert regime.mean == pytest.approx(10.0, rel=2e-14)
    assert np.ptp(regime.driving) <= 1e-13 * regime.mean_moment
    assert regime.stable
    other = driven(cycle, constant, Constant(value=float(regime.driving[0, 0]), nominal=10.0))
    np.testing.assert_allclose(other.omega_at(regime.panels.x.ravel()), regime.omega.ravel(), rtol=1e-11)
    assert other.multipliers[0] == pytest.approx(regime.multipliers[0], rel=1e-9)


def test_resistances_and_too_little_inertia() -> None:
    cycle = replace(upsetter(), viscous=np.full(upsetter().moment.shape, -1.0))
    with pytest.raises(NoSolutionError):
        positional(cycle, 1.0, 10.0)
    with pytest.raises(UsageError, match="sets the speed itself"):
        positional(cycle, 30.0, 10.0, given_moment=50.0)


def test_impossible_arguments() -> None:
    cycle = upsetter()
    for constant, speed in ((-1.0, 10.0), (1.0, 0.0), (1.0, -3.0), (math.inf, 10.0), (1.0, math.nan)):
        with pytest.raises(UsageError):
            positional(cycle, constant, speed)
    with pytest.raises(NoSolutionError, match="nothing bounds the speed"):
        positional(cycle, 0.0, 10.0)  # the slider alone stands still at its dead centres
