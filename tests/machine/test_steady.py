"""Steady motion with a motor: solutions made to measure, closed forms, worked cases, scipy, and what is refused."""

from __future__ import annotations

import cmath
import math
import subprocess
import sys
import warnings
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from properties import examples
from sparing import sparing

from machine.motion import (
    CASES,
    TURN,
    Constant,
    Kloss,
    Line,
    Lossy,
    Motor,
    Parabola,
    Series,
    cycle_of,
    of_pieces,
    reference,
    refined,
    shaper,
    upsetter,
    upsetter_functions,
    upsetter_motor,
)
from tmmcalc.core.errors import AccuracyError, NoSolutionError, UsageError
from tmmcalc.core.numerics.collocation import initial, solve
from tmmcalc.machine.cycle import Cycle
from tmmcalc.machine.motors.direct_current import series
from tmmcalc.machine.motors.gearing import reduced
from tmmcalc.machine.motors.table import table
from tmmcalc.machine.onemass import OneMass, onto
from tmmcalc.machine.regime import Regime
from tmmcalc.machine.steady import driven

SPEED = 10.0
MOTORS: dict[str, Any] = {
    "line": Line(10.5, 10.0, stiffness=200.0),
    "parabola": Parabola(math.sqrt(120.0), 10.0, a=600.0, b=5.0),
    "kloss": Kloss(10.7, 10.0, 10.7 * 0.75, pull_out=240.0, slip=0.25),
    "series": Series(None, 10.0, scale=12000.0),
    "steep line": Line(SPEED * (1 + 1e-5), SPEED, stiffness=100 / (SPEED * 1e-5)),
    "steep kloss": Kloss(SPEED * (1 + 1e-5), SPEED, SPEED * (1 - 3e-5), pull_out=250.0, slip=4e-5),
}


def made_to_measure(
    motor: Any, delta: float, constant: float, *, viscous: float = 0.0, quadratic: float = 0.0, waves: float = 1.0
) -> tuple[Cycle, Callable[[Any], Any]]:
    """A cycle whose exact regime is omega = 10 (1 + delta/2 sin(waves theta)), and that omega."""

    def omega(x: Any) -> Any:
        return SPEED * (1 + delta / 2 * np.sin(waves * x))

    def functions(x: Any) -> tuple[Any, Any, Any]:
        w, slope = omega(x), SPEED * delta / 2 * waves * np.cos(waves * x)
        inertia, bend = 1 + 0.5 * np.cos(2 * x), -np.sin(2 * x)
        load = (inertia + constant) * w * slope + bend * w * w / 2 - motor.moment(w) - viscous * w - quadratic * w * w
        return inertia, bend, load

    period = TURN / min(waves, 1.0)
    return cycle_of(functions, (), period, SPEED, viscous, quadratic), omega


def worst(regime: Regime, omega: Callable[[Any], Any]) -> float:
    """Largest relative error of the speed, at the points and between them."""
    x = np.linspace(0, regime.panels.edges[-1], 1001)
    at_points = np.max(np.abs(regime.omega / omega(regime.panels.x) - 1))
    return max(float(at_points), float(np.max(np.abs(regime.omega_at(x) / omega(x) - 1))))


def near(regime: Regime, off: float = 1e-7) -> tuple[float]:
    """A speed to start a reference from: not quite that of the regime, into which the motion has to settle."""
    return (float(regime.omega_at(np.zeros(1))[0]) * (1 + off),)


@pytest.mark.parametrize("constant", [1e-6, 1e-2, 1.0, 1e3, 1e6])
@pytest.mark.parametrize("delta", [1e-6, 1e-3, 0.1, 0.5])
@pytest.mark.parametrize("kind", ["line", "parabola", "series"])
def test_exact_solution(kind: str, delta: float, constant: float) -> None:
    """Inertia ratios over twelve decades, fluctuations over six."""
    cycle, omega = made_to_measure(MOTORS[kind], delta, constant)
    regime = driven(cycle, constant, MOTORS[kind])
    size = 2e-15 * max(1.0, delta * constant)  # the load itself is rounded: its work is that of the fluctuating energy
    assert worst(regime, omega) <= regime.error + 1e-15
    assert worst(regime, omega) <= 2e-14 + 20 * size
    assert regime.delta == pytest.approx(delta, rel=1e-8 if delta == 1e-6 else 1e-10)
    assert regime.omega_max == pytest.approx(SPEED * (1 + delta / 2), rel=regime.error)
    assert regime.omega_min == pytest.approx(SPEED * (1 - delta / 2), rel=regime.error)
    place = 1e-3 if delta == 1e-6 else 1e-7
    assert regime.theta_max == pytest.approx(math.pi / 2, abs=place)
    assert regime.theta_min == pytest.approx(3 * math.pi / 2, abs=place)
    assert regime.stable
    assert regime.panels.count <= 14


@sparing("constant", [1e-6, 1.0, 1e4], every=3)
@sparing(
    ("kind", "delta"),
    [("kloss", 1e-4), ("kloss", 0.06), ("steep line", 1e-6), ("steep line", 0.5), ("steep kloss", 4e-6)],
    every=3,
)
def test_exact_solution_of_steep_and_bent_characteristics(kind: str, delta: float, constant: float) -> None:
    cycle, omega = made_to_measure(MOTORS[kind], delta, constant)
    regime = driven(cycle, constant, MOTORS[kind])
    assert worst(regime, omega) <= regime.error + 1e-15
    assert worst(regime, omega) <= 1e-13
    assert regime.delta == pytest.approx(delta, rel=1e-7)


@pytest.mark.parametrize(("viscous", "quadratic"), [(-3.0, 0.0), (0.0, -0.4), (-2.0, -0.1), (1.0, 0.05)])
def test_resistances_that_depend_on_speed(viscous: float, quadratic: float) -> None:
    for constant in (0.1, 30.0):
        cycle, omega = made_to_measure(MOTORS["line"], 0.2, constant, viscous=viscous, quadratic=quadratic)
        regime = driven(cycle, constant, MOTORS["line"])
        assert worst(regime, omega) <= 1e-13
        x = np.linspace(0, TURN, 20001)
        w = omega(x)
        rate = (-200.0 + viscous + 2 * quadratic * w) / ((1 + 0.5 * np.cos(2 * x) + constant) * w)
        expected = math.exp(float(np.mean(rate[:-1])) * TURN)  # the trapezoid rule is exact over the period
        assert regime.multipliers[0].real == pytest.approx(expected, rel=1e-9)


def test_resistance_alone_regulates_a_constant_moment() -> None:
    motor = Constant(value=50.0)
    cycle, omega = made_to_measure(motor, 0.1, 20.0, quadratic=-0.2)
    regime = driven(cycle, 20.0, motor)
    assert worst(regime, omega) <= 1e-13
    assert 0 < regime.multipliers[0].real < 1


def test_a_cycle_of_two_turns() -> None:
    cycle, omega = made_to_measure(MOTORS["kloss"], 0.05, 5.0, waves=0.5)
    assert cycle.period == pytest.approx(2 * TURN)
    regime = driven(cycle, 5.0, MOTORS["kloss"])
    assert worst(regime, omega) <= 1e-13
    assert regime.theta_max == pytest.approx(math.pi, abs=1e-8)
    assert regime.theta_min == pytest.approx(3 * math.pi, abs=1e-8)
    assert regime.time_mean == pytest.approx(2 * TURN / regime.cycle_time, rel=1e-15)


def test_times_means_and_powers() -> None:
    motor, delta = MOTORS["line"], 0.3
    cycle, _ = made_to_measure(motor, delta, 4.0)
    regime = driven(cycle, 4.0, motor)
    time = TURN / (SPEED * math.sqrt(1 - delta**2 / 4))
    assert regime.cycle_time == pytest.approx(time, rel=1e-14)
    assert regime.time_mean == pytest.approx(TURN / time, rel=1e-14)
    assert regime.mean == pytest.approx(SPEED, rel=1e-14)
    assert regime.time[0] == 0.0
    assert regime.time[-1] == regime.cycle_time
    np.testing.assert_allclose(regime.time_at(regime.panels.edges), regime.time, rtol=1e-14, atol=1e-16)
    half = regime.time_at(np.array([math.pi / 2, 3 * math.pi / 2]))
    assert half[1] - half[0] == pytest.approx(time / 2, rel=1e-13)  # omega is even about pi/2
    quarter = 2 / math.sqrt(1 - delta**2 / 4) * math.atan((1 + delta / 2) / math.sqrt(1 - delta**2 / 4))
    start = 2 / math.sqrt(1 - delta**2 / 4) * math.atan(delta / 2 / math.sqrt(1 - delta**2 / 4))
    assert half[0] == pytest.approx((quarter - start) / SPEED, rel=1e-13)
    assert regime.mean_moment == pytest.approx(200 * 0.5, rel=1e-13)
    heat = 200.0**2 * (10.5**2 - 2 * 10.5 * TURN / time + TURN * SPEED / time)
    assert regime.rms_moment == pytest.approx(math.sqrt(heat), rel=1e-13)
    assert regime.mean_power == pytest.approx(100 * TURN / time, rel=1e-13)
    exact = SPEED * delta / 2 * np.cos(regime.panels.x) * SPEED * (1 + delta / 2 * np.sin(regime.panels.x))
    np.testing.assert_allclose(regime.acceleration, exact, atol=1e-12)
    assert abs(regime.residual) < 1e-14


@pytest.mark.parametrize("lag", [1e-5, 1e-4, 1e-3, 1e-2, 1e-1])
@pytest.mark.parametrize("constant", [0.01, 1.0, 1e4])
def test_exact_solution_with_a_lagging_motor(lag: float, constant: float) -> None:
    """From a driving moment M = 100 + 30 sin: tau omega M' = b (w_s - omega) - M gives omega in closed form."""
    stiffness, sync = 200.0, 10.5

    def speeds(x: Any) -> tuple[Any, Any, Any]:
        m, first, second = 100 + 30 * np.sin(x), 30 * np.cos(x), -30 * np.sin(x)
        bottom, top = stiffness + lag * first, stiffness * sync - m
        return m, top / bottom, (-first * bottom - top * lag * second) / bottom**2

    def functions(x: Any) -> tuple[Any, Any, Any]:
        m, w, slope = speeds(x)
        inertia, bend = 1 + 0.5 * np.cos(2 * x), -np.sin(2 * x)
        return inertia, bend, (inertia + constant) * w * slope + bend * w * w / 2 - m

    regime = driven(cycle_of(functions), constant, MOTORS["line"], time_constant=lag)
    assert worst(regime, lambda x: speeds(x)[1]) <= 1e-13 * max(1.0, constant / 100)
    np.testing.assert_allclose(regime.driving, speeds(regime.panels.x)[0], rtol=1e-11)
    assert regime.mean_moment == pytest.approx(100.0, rel=1e-11)
    assert regime.stable
    assert len(regime.multipliers) == 2


@pytest.mark.parametrize(
    ("inertia", "lag"), [(2.0, 0.0115), (2.0, 1e-5), (50.0, 0.3), (0.5, 1e-3), (200.0, 0.1), (2.0, 0.25)]
)
def test_multipliers_of_a_lagging_motor_under_a_constant_load(inertia: float, lag: float) -> None:
    """The linear motor of the case dyn-ext-motor-lag: the multipliers are exp(eigenvalue times cycle time)."""
    given = CASES["dyn-ext-motor-lag"]
    b, load = given["inputs"]["b"], given["inputs"]["M_load"]
    sync = 20.0
    regime = driven(of_pieces([-load], [0.0, TURN]), inertia, Line(sync, 19.0, stiffness=b), time_constant=lag)
    final = sync + given["expected"]["final_w_minus_ws"]
    np.testing.assert_allclose(regime.omega, final, rtol=1e-9)
    np.testing.assert_allclose(regime.omega, sync - load / b, rtol=1e-14)
    np.testing.assert_allclose(regime.driving, load, rtol=1e-12)
    root = cmath.sqrt(1 / lag**2 - 4 * b / (inertia * lag))
    for eigenvalue in ((-1 / lag + root) / 2, (-1 / lag - root) / 2):
        exact = cmath.exp(eigenvalue * regime.cycle_time)
        assert min(abs(mu - exact) for mu in regime.multipliers) < 1e-12
    oscillates = 4 * lag > inertia / b
    assert (abs(regime.multipliers[0].imag) > 0) == oscillates
    assert regime.stable
    assert regime.delta < 1e-13


def test_constant_load_and_harmonic_load_on_the_parabola() -> None:
    given = CASES["dyn-closed-parabola-harmonic"]
    a, b, inertia = (given["inputs"][name] for name in ("A", "B", "J"))
    motor = Parabola(math.sqrt(a / b), a=a, b=b)
    regime = driven(cycle_of(lambda x: (0 * x, 0 * x, -80 - 60 * np.cos(x))), inertia, motor)
    k, f = 2 * b / inertia, 120 / inertia

    def exact(x: Any) -> Any:
        return np.sqrt((a - 80) / b - f * (k * np.cos(x) + np.sin(x)) / (k * k + 1))

    assert worst(regime, exact) < 3e-15
    expected = given["expected"]
    np.testing.assert_allclose(regime.omega_at(np.array(expected["phi"])), expected["omega"], rtol=1e-6)
    assert regime.omega_max == pytest.approx(expected["omega_max"], rel=1e-7)
    assert regime.omega_min == pytest.approx(expected["omega_min"], rel=1e-7)
    assert regime.delta == pytest.approx(expected["delta"], rel=1e-7)
    assert regime.multipliers[0].real == pytest.approx(math.exp(-2 * b / inertia * TURN), rel=1e-12)


def test_the_motion_towards_the_regime_is_that_of_the_closed_form() -> None:
    """The same equations as an initial value problem: case dyn-closed-parabola-const."""
    case = CASES["dyn-closed-parabola-const"]
    a, b, inertia, load, start = (case["inputs"][name] for name in ("A", "B", "J", "M_c", "omega0"))
    motor = Parabola(math.sqrt(a / b), a=a, b=b)
    cycle = of_pieces([load], [0.0, 2 * TURN])
    machine = OneMass(cycle, inertia, motor)
    energy = np.full((1, *cycle.inertia.shape), inertia * start**2 / 2)
    orbit = solve(machine.equations(), cycle.panels, energy, ends=initial(energy[:, 0, 0]), floor=machine.floor)
    omega = machine.speed(orbit.panels, orbit.y[0])
    phi = np.array(case["expected"]["phi"])
    exact = np.sqrt((a + load) / b + (start**2 - (a + load) / b) * np.exp(-2 * b * orbit.panels.x / inertia))
    np.testing.assert_allclose(omega, exact, rtol=1e-14)
    np.testing.assert_allclose(orbit.panels.at(omega, phi[:-1]), case["expected"]["omega"][:-1], rtol=1e-6)
    assert driven(cycle, inertia, motor).omega[0, 0] == pytest.approx(case["expected"]["omega_inf"], rel=1e-7)


def jumping_parabola(loads: list[float], breaks: list[float], motor: Parabola, inertia: float) -> Callable[[Any], Any]:
    """Exact regime under a piecewise constant load: omega^2 relaxes towards the balance of each piece."""
    rate = 2 * motor.b / inertia
    levels = [(motor.a + load) / motor.b for load in loads]
    factor, rise = 1.0, 0.0
    for level, width in zip(levels, np.diff(breaks), strict=True):
        decay = math.exp(-rate * width)
        factor, rise = factor * decay, level + (rise - level) * decay
    starts = [rise / (1 - factor)]
    for level, width in zip(levels, np.diff(breaks), strict=True):
        starts.append(level + (starts[-1] - level) * math.exp(-rate * width))

    def omega(x: Any) -> Any:
        k = np.clip(np.searchsorted(breaks, x, side="right") - 1, 0, len(loads) - 1)
        level, start = np.array(levels)[k], np.array(starts)[k]
        return np.sqrt(level + (start - level) * np.exp(-rate * (x - np.array(breaks)[k])))

    return omega


@pytest.mark.parametrize("slip", [0.07, 1e-3, 1e-5])
@pytest.mark.parametrize("inertia", [100.0, 1.0, 0.01])
def test_load_jumps_on_steep_characteristics(slip: float, inertia: float) -> None:
    """Layers of the relative width slip J after every jump; the speed at the jumps is that of the closed form."""
    breaks, loads = [0.0, 1.0, 2.5, 4.0, TURN], [-20.0, -180.0, -60.0, 0.0]
    sync = SPEED / (1 - slip)
    b = 110 / (sync**2 - SPEED**2)
    motor = Parabola(sync, SPEED, a=b * sync**2, b=b)
    regime = driven(of_pieces(loads, breaks), inertia, motor)
    exact = jumping_parabola(loads, breaks, motor, inertia)
    assert np.max(np.abs(regime.omega / exact(regime.panels.x) - 1)) <= min(3e-14, regime.error + 3e-14 * (inertia < 1))
    ends = np.array(breaks[1:]) * (1 - 1e-16)
    assert regime.omega_max == pytest.approx(float(np.max(exact(np.array(breaks)))), rel=1e-13)
    assert regime.omega_min == pytest.approx(float(np.min(exact(ends - 1e-15))), rel=1e-13)
    assert 1.0 < regime.theta_min <= 2.5
    assert set(breaks[1:-1]) <= set(regime.panels.edges.tolist())


@sparing("kind", ["kloss", "lin"], every=2)
def test_steep_nonlinear_characteristic_after_jumps_against_scipy(kind: str) -> None:
    breaks, loads = [0.0, 1.0, 2.5, 4.0, TURN], [-20.0, -180.0, -60.0, 0.0]
    slip, inertia = 1e-3, 3.0
    motor: Any = (
        Kloss(SPEED / (1 - slip), SPEED, pull_out=240.0, slip=4.2 * slip)
        if kind == "kloss"
        else Line(SPEED / (1 - slip), SPEED, stiffness=110 / (SPEED * slip))
    )
    regime = driven(of_pieces(loads, breaks), inertia, motor)

    def functions(x: Any) -> tuple[Any, Any, Any]:
        return 0.0 * x, 0.0 * x, loads[min(int(np.searchsorted(breaks, x)) - 1, 3)]

    omega = reference(functions, breaks, inertia, motor, near(regime, 1e-12), method="Radau")
    assert worst(regime, omega) < 2e-11
    assert regime.error < 1e-12


@sparing(
    ("load", "constant", "kind", "method"),
    [
        (1.0, 30.6, "kloss", "DOP853"),
        (1.0, 30.6, "par", "DOP853"),
        (1.0, 5.0, "kloss", "DOP853"),
        (1.0, 3.4, "kloss", "DOP853"),
        (0.3, 0.2, "kloss", "Radau"),
        (0.3, 1e-3, "lin", "Radau"),
    ],
    every=3,
)
def test_upsetter_against_scipy(load: float, constant: float, kind: str, method: str) -> None:
    motor = upsetter_motor(kind)
    regime = driven(upsetter(load), constant, motor)
    functions, breaks = upsetter_functions(load), [0.0, math.pi, TURN]
    turns, off = (1, 1e-12) if method == "Radau" else (4, 1e-7)
    omega = reference(functions, breaks, constant, motor, near(regime, off), method=method, turns=turns)
    assert worst(regime, omega) < 3e-11  # the reference's own error
    assert regime.error < 5e-12


@sparing("lag", [1e-3, 1e-2, 1e-1], every=3, first=2)
def test_lagging_upsetter_against_scipy(lag: float) -> None:
    motor = upsetter_motor("kloss")
    regime = driven(upsetter(), 30.6, motor, time_constant=lag)
    start = (*near(regime), float(regime.panels.ends(regime.driving)[0][0]))
    omega = reference(upsetter_functions(1.0), [0.0, math.pi, TURN], 30.6, motor, start, lag=lag, turns=4)
    assert worst(regime, omega) < 3e-11


@pytest.mark.slow
@pytest.mark.parametrize("seed", [3, 11])
def test_random_lagging_machines_run_to_periodicity(seed: int) -> None:
    """From the no-load speed turn by turn until the motion repeats; nothing of the regime is used on the way."""
    rng = np.random.default_rng(seed)
    swing, ahead, wave = rng.uniform(0.1, 0.6), rng.uniform(0, TURN, 3), rng.uniform(10, 30, 2)
    constant, lag, mean = rng.uniform(1.0, 2.5), rng.uniform(5e-3, 4e-2), rng.uniform(50, 80)

    def functions(x: Any) -> tuple[Any, Any, Any]:
        inertia, bend = 1 + swing * np.sin(2 * x + ahead[0]), 2 * swing * np.cos(2 * x + ahead[0])
        return inertia, bend, -mean + wave[0] * np.sin(x + ahead[1]) + wave[1] * np.sin(3 * x + ahead[2])

    motor = MOTORS["kloss"]
    regime = driven(cycle_of(functions), constant, motor, time_constant=lag)
    omega = reference(functions, [0.0, TURN], constant, motor, (motor.synchronous, 0.0), lag=lag, turns=40)
    first, last = omega(np.array([0.0, TURN]))
    assert last == pytest.approx(first, rel=1e-11)
    assert regime.delta > 0.01
    assert worst(regime, omega) < 3e-11


@sparing("interpolation", ["linear", "pchip"], every=2)
@sparing("efficiency", [1.0, 0.9], every=2, first=1)
def test_a_characteristic_by_points(interpolation: Any, efficiency: float) -> None:
    """The speed passes several points of the table; its bends are found, and not closed in upon by halving panels."""
    whole = upsetter_motor("kloss")
    speeds = np.linspace(0.0, 1.05 * whole.synchronous, 21)
    motor = reduced(table([(float(w), float(whole.moment(w))) for w in speeds], interpolation), 1.0, efficiency)
    regime = driven(upsetter(0.5), 5.0, motor)
    passed = (speeds > regime.omega_min) & (speeds < regime.omega_max)
    assert np.count_nonzero(passed) >= 2
    omega = reference(upsetter_functions(0.5), [0.0, math.pi, TURN], 5.0, motor, near(regime, 0.0), step=3e-3)
    assert worst(regime, omega) < 3e-11
    assert regime.error < 1e-12
    assert regime.counters["meshes"] <= 10
    assert regime.panels.count <= 40


@pytest.mark.parametrize("efficiency", [0.8, 0.95])
def test_losses_that_bend_the_characteristic_at_no_load(efficiency: float) -> None:
    """An idle run crosses the no-load speed twice; halving the panels finds the same as cutting them there."""
    base = upsetter_motor("kloss")
    motor = Lossy(base.synchronous, base.nominal, base=base, efficiency=efficiency)
    cycle = upsetter(0.02)
    regime = driven(cycle, 30.0, motor)
    assert regime.omega_min < base.synchronous < regime.omega_max
    omega = reference(upsetter_functions(0.02), [0.0, math.pi, TURN], 30.0, motor, near(regime), turns=4)
    assert worst(regime, omega) < 1e-10
    unmarked = driven(cycle, 30.0, replace(motor, synchronous=None))
    assert unmarked.counters["meshes"] > regime.counters["meshes"]
    np.testing.assert_allclose(regime.omega_at(unmarked.panels.x.ravel()), unmarked.omega.ravel(), rtol=1e-11)


@pytest.mark.parametrize("kind", ["kloss", "par", "lin"])
def test_upsetter_case(kind: str) -> None:
    expected = CASES["dyn-upsetter-regime-30"]["expected"][kind]
    regime = driven(upsetter(), 30.6, upsetter_motor(kind))
    nodes = regime.omega_at(np.linspace(0, TURN, 9))
    np.testing.assert_allclose(nodes, expected["omega_every_45deg"], rtol=2e-7)
    assert regime.omega_min == pytest.approx(expected["omega_min"], rel=1e-6)
    assert regime.omega_max == pytest.approx(expected["omega_max"], rel=1e-6)
    assert regime.delta == pytest.approx(expected["delta"], rel=1e-5)
    assert regime.cycle_time == pytest.approx(expected["T_s"], rel=2e-7)
    assert regime.theta_min == pytest.approx(expected["phi_min_rad"], abs=0.01)


def test_stiff_case() -> None:
    case = CASES["dyn-stiff-regime-a"]
    regime = driven(upsetter(case["inputs"]["load_factor"]), case["inputs"]["J_c"], upsetter_motor("kloss"))
    expected = case["expected"]
    np.testing.assert_allclose(regime.omega_at(np.linspace(0, TURN, 9)), expected["omega_every_45deg"], rtol=1e-7)
    assert regime.omega_min == pytest.approx(expected["omega_min"], rel=1e-6)
    assert regime.omega_max == pytest.approx(expected["omega_max"], rel=1e-6)
    assert regime.delta == pytest.approx(expected["delta"], rel=1e-5)


def test_idle_shaper_case() -> None:
    case = CASES["dyn-shaper-motion-idle"]
    expected = case["expected"]["continuous_reference"]
    a, b = case["expected"]["A"], case["expected"]["B"]
    motor = Parabola(math.sqrt(a / b), a=a, b=b)
    regime = driven(shaper(), case["inputs"]["J_const"], motor)
    np.testing.assert_allclose(regime.omega_at(np.linspace(0, TURN, 25)), expected["omega_at_nodes"], rtol=1e-6)
    assert regime.omega_min == pytest.approx(expected["omega_min"], rel=1e-6)
    assert regime.omega_max == pytest.approx(expected["omega_max"], rel=1e-6)
    assert regime.theta_min == pytest.approx(expected["phi_min_rad"], abs=0.01)
    assert regime.theta_max == pytest.approx(expected["phi_max_rad"], abs=0.01)
    assert regime.delta == pytest.approx(expected["delta"], rel=1e-5)
    assert regime.cycle_time == pytest.approx(expected["T_s"], rel=1e-6)


@pytest.mark.parametrize("constant", [3.4, 10.0, 1e3, 1e6])
def test_finer_panels_change_nothing(constant: float) -> None:
    cycle, motor = upsetter(), upsetter_motor("kloss")
    regime = driven(cycle, constant, motor)
    finer = driven(onto(cycle, refined(cycle)), constant, motor)
    difference = np.max(np.abs(finer.omega_at(regime.panels.x.ravel()) / regime.omega.ravel() - 1))
    assert difference <= regime.error
    assert difference < 3e-14
    assert finer.delta == pytest.approx(regime.delta, rel=1e-9)


def test_the_regime_above_the_no_load_speed() -> None:
    """Loads that drive: the motor brakes, and balances them above its no-load speed."""
    regime = driven(of_pieces([50.0], [0.0, TURN]), 3.0, MOTORS["line"])
    np.testing.assert_allclose(regime.omega, 10.75, rtol=1e-14)
    assert regime.mean_power < 0


def test_of_two_regimes_that_of_the_working_branch_is_found() -> None:
    """Kloss against a constant load: a stable regime, and an unstable one beyond the break-down point."""
    motor = MOTORS["kloss"]
    load, s_k = 150.0, 0.25
    ratio = 240.0 / load
    slip = s_k * (ratio - math.sqrt(ratio**2 - 1))
    cycle = of_pieces([-load], [0.0, TURN])
    regime = driven(cycle, 2.0, motor)
    np.testing.assert_allclose(regime.omega, 10.7 * (1 - slip), rtol=1e-13)
    other = 10.7 * (1 - s_k * (ratio + math.sqrt(ratio**2 - 1)))
    misled = replace(regime, omega=np.full(regime.omega.shape, other))
    np.testing.assert_allclose(driven(cycle, 2.0, motor, guess=misled).omega, regime.omega, rtol=1e-13)


def test_a_guess_saves_work_and_changes_nothing() -> None:
    cycle, motor = upsetter(0.3), upsetter_motor("kloss")
    near = driven(cycle, 0.21, motor)
    cold, warm = driven(cycle, 0.2, motor), driven(cycle, 0.2, motor, guess=near)
    assert warm.counters["newton"] <= cold.counters["newton"]
    assert warm.counters["meshes"] <= cold.counters["meshes"]
    np.testing.assert_allclose(warm.omega_at(cold.panels.x.ravel()), cold.omega.ravel(), rtol=1e-13)
    elsewhere = driven(of_pieces([-50.0, 0.0], [0.0, 1.0, TURN]), 5.0, motor)
    again = driven(cycle, 0.2, motor, guess=elsewhere)
    np.testing.assert_allclose(again.omega_at(cold.panels.x.ravel()), cold.omega.ravel(), rtol=1e-13)


@given(
    st.lists(st.floats(-100, 100), min_size=6, max_size=6),
    st.floats(0.01, 1e3),
    st.sampled_from(["line", "parabola", "kloss", "series"]),
)
@examples(25)
def test_energy_balance_and_change_of_units(waves: list[float], constant: float, kind: str) -> None:
    """Work over the cycle is zero; masses and forces in other units change nothing but the scale."""

    def load(x: Any) -> Any:
        return -60 + sum(waves[k] * np.cos((k % 3 + 1) * x + k) for k in range(6)) / 20

    def functions(x: Any) -> tuple[Any, Any, Any]:
        return 0.3 + 0.2 * np.cos(2 * x), -0.4 * np.sin(2 * x), load(x)

    motor = MOTORS[kind]
    regime = driven(cycle_of(functions), constant, motor)
    assert abs(regime.residual) < 1e-13
    assert 0 <= regime.multipliers[0].real < 1
    x = np.linspace(0, TURN, 2000)
    sample = regime.omega_at(x)
    assert regime.omega_min <= sample.min() * (1 + 1e-13)
    assert regime.omega_max >= sample.max() * (1 - 1e-13)
    scaled = driven(cycle_of(lambda x: tuple(7.0 * row for row in functions(x))), 7.0 * constant, _Scaled(motor, 7.0))
    assert scaled.delta == pytest.approx(regime.delta, rel=1e-8, abs=1e-12)
    assert scaled.mean_moment == pytest.approx(7 * regime.mean_moment, rel=1e-9)


class _Scaled:
    """A motor with its moment multiplied."""

    least = most = critical = None
    name = "scaled"

    def __init__(self, base: Any, factor: float) -> None:
        self.base, self.factor = base, factor
        self.synchronous, self.nominal = base.synchronous, base.nominal

    def moment(self, omega: Any) -> Any:
        return self.factor * self.base.moment(omega)

    def slope(self, omega: Any) -> Any:
        return self.factor * self.base.slope(omega)


def test_nothing_regulates_a_constant_moment() -> None:
    with pytest.raises(NoSolutionError, match="does not regulate itself") as caught:
        driven(upsetter(), 30.0, Constant(nominal=10.0, value=36.0))
    assert caught.value.value == 1.0
    assert "constant balancing moment" in caught.value.remedy


def test_a_load_too_large_on_the_average_is_told_at_once() -> None:
    with pytest.raises(NoSolutionError, match="whatever its inertia") as caught:
        driven(of_pieces([-300.0, -200.0], [0.0, 3.0, TURN]), 1e3, MOTORS["kloss"])
    assert caught.value.value == pytest.approx((300 * 3 + 200 * (TURN - 3)) / TURN)
    assert caught.value.limit == pytest.approx(240.0, rel=1e-3)


def test_a_machine_that_runs_away_is_told() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(NoSolutionError, match="runs away"):
            driven(of_pieces([300.0], [0.0, TURN]), 0.5, MOTORS["kloss"])


@pytest.mark.parametrize("lag", [0.0, 1e-2])
@pytest.mark.parametrize("loads", [[0.0, 0.0], [40.0, 60.0], [-50.0, 50.0]])
def test_a_motor_without_a_no_load_speed_runs_away_unloaded(loads: list[float], lag: float) -> None:
    """M = M_N ((w_N + a)/(w + a))^2 is positive at every speed: with loads that do not resist no cycle balances."""
    motor = series(60.0, 10.0, 0.2)
    with pytest.raises(NoSolutionError, match=r"runs away.*no no-load speed, at 200 rad/s") as caught:
        driven(of_pieces(loads, [0.0, TURN / 2, TURN]), 2.0, motor, time_constant=lag)
    assert caught.value.value == pytest.approx(sum(loads) / 2, abs=1e-12)
    assert f"{60.0 * (12.5 / 202.5) ** 2:.6g} N*m" in caught.value.message


def test_a_small_load_holds_a_motor_without_a_no_load_speed() -> None:
    load = 60.0 * (12.5 / 102.5) ** 2  # at ten times the rated speed
    regime = driven(of_pieces([-load], [0.0, TURN]), 2.0, series(60.0, 10.0, 0.2))
    assert regime.mean == pytest.approx(100.0, rel=1e-9)


class _Rising(Motor):
    """A characteristic that rises with the speed: no regime is stable."""

    def moment(self, omega: Any) -> Any:
        return 10 * (omega - 5)

    def slope(self, omega: Any) -> Any:
        return 10 + 0 * omega


def test_an_unstable_regime_is_not_offered() -> None:
    with pytest.raises(NoSolutionError, match="runs away"):
        driven(of_pieces([-40.0], [0.0, TURN]), 1.0, _Rising(nominal=10.0))
    with pytest.raises(NoSolutionError, match="stalls"):
        driven(of_pieces([-60.0], [0.0, TURN]), 1.0, _Rising(nominal=10.0))


def test_impossible_arguments() -> None:
    for inertia, lag in ((-1.0, 0.0), (math.nan, 0.0), (math.inf, 0.0), (1.0, -1e-3)):
        with pytest.raises(UsageError):
            driven(upsetter(), inertia, MOTORS["line"], time_constant=lag)
    cycle = cycle_of(lambda x: (np.sin(x) ** 2, np.sin(2 * x), -10 + 0 * x))
    with pytest.raises(NoSolutionError, match="nothing bounds the speed"):
        driven(cycle, 0.0, MOTORS["line"])
    assert driven(cycle, 1e-3, MOTORS["line"]).stable


def test_an_idle_machine_with_a_lagging_motor() -> None:
    """No load, no moment, constant inertia: a state that is zero throughout is no reason to refine."""
    regime = driven(of_pieces([0.0], [0.0, TURN]), 2.0, MOTORS["line"], time_constant=1e-2)
    np.testing.assert_allclose(regime.omega, 10.5, rtol=1e-14)
    assert np.max(np.abs(regime.driving)) < 1e-9
    assert regime.panels.count <= 12
    assert driven(of_pieces([0.0], [0.0, TURN]), 2.0, MOTORS["line"]).delta < 1e-14


def test_noise_in_the_load_is_not_chased() -> None:
    rng = np.random.default_rng(3)
    cycle = upsetter()
    noisy = replace(cycle, moment=cycle.moment + rng.normal(size=cycle.moment.shape) * 1e-6, error=1e-8)
    regime = driven(noisy, 30.6, upsetter_motor("kloss"))
    assert regime.panels.count < 40
    exact = driven(cycle, 30.6, upsetter_motor("kloss"))
    assert regime.delta == pytest.approx(exact.delta, rel=1e-6)
    assert regime.error >= abs(regime.omega_min / exact.omega_min - 1)


def test_scipy_is_not_loaded_for_a_regime() -> None:
    code = "import sys; import tmmcalc.machine.steady, tmmcalc.machine.positional; print('scipy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout == "False\n"


@pytest.mark.slow
def test_swings_that_are_too_fast_to_be_followed() -> None:
    """A slip of 1e-7 with a lag of 0.01 s: after every jump of the load the shaft swings with sqrt(b/(J tau))."""
    motor = Line(10.0, 10.0 * (1 - 1e-7), stiffness=100.0 / 1e-6)
    cycle = of_pieces([-10.0, -190.0], [0.0, 3.0, TURN], inertia=5.0)
    with pytest.raises(AccuracyError, match="swing") as caught:
        driven(cycle, 5.0, motor, time_constant=0.01)
    swings = math.sqrt(1e8 / (10 * 0.01)) * 0.2 / TURN
    assert caught.value.value == pytest.approx(swings, rel=1e-9)
    assert "time_constant = 0" in str(caught.value.remedy)
    assert driven(cycle, 5.0, motor).delta < 1e-5
