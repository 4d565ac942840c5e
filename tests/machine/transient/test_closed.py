"""One mass against closed forms: constant and linear moments, resistances, Kloss run-up, energy, parabola."""

from __future__ import annotations

import math

import numpy as np
import pytest
from sparing import sparing

from machine.transient.scenes import at, case, constant, cycle, event, kloss, line, parabola, run
from tmmcalc.machine.transient.model import Drive, Mass
from tmmcalc.machine.transient.results import Transient
from tmmcalc.machine.transient.scenario import Brake, Scenario

METHODS = ["auto", "merson", "collocation", "RK45", "DOP853", "LSODA", "Radau", "BDF"]
# errors that steps of 1e-9 add up to; BDF and LSODA spend the whole tolerance on many small steps
BOUND = {"BDF": 1e-6, "LSODA": 1e-7}


def check(result: Transient, omega: np.ndarray, theta: np.ndarray | None = None, scale: float = 1.0) -> None:
    bound = BOUND.get(result.method, 1e-8)
    error = float(np.max(np.abs(result.omega[0] - omega))) / scale
    assert error < bound
    assert error < 10 * result.error + 1e-14
    if theta is not None:
        np.testing.assert_allclose(result.theta[0], theta, atol=bound)


@pytest.mark.parametrize("method", METHODS)
def test_constant_moment(method: str) -> None:
    result = run(Drive((Mass(4.0),), characteristic=constant(10.0)), Scenario("start", 2.0), method)
    check(result, 2.5 * result.t, 1.25 * result.t**2)


@sparing("method", METHODS, every=4)
def test_linear_characteristic(method: str) -> None:
    """J w' = b (w_s - w) - M: w = w_0 + (w_inf - w_0)(1 - exp(-b t/J))."""
    drive = Drive((Mass(3.0),), characteristic=line(6.0, 20.0), cycle=cycle(-30.0, speed=10.0))
    result = run(drive, Scenario("start", 2.0, speed=2.0), method)
    fade = np.exp(-2 * result.t)
    check(result, 15 - 13 * fade, 15 * result.t - 6.5 * (1 - fade), 20.0)


@sparing("method", METHODS, every=4)
def test_quadratic_resistance(method: str) -> None:
    """J w' = -q w^2: w = w_0/(1 + q w_0 t/J), theta = (J/q) ln(1 + q w_0 t/J)."""
    drive = Drive((Mass(1.6),), cycle=cycle(0.0, 0.4, quadratic=-0.5))
    result = run(drive, Scenario("run-down", 5.0, speed=12.0), method)
    grown = 1 + 0.5 * 12 * result.t / 2
    check(result, 12 / grown, 4 * np.log(grown), 12.0)


@sparing("method", METHODS, every=4)
def test_constant_and_quadratic_resistance_to_standstill(method: str) -> None:
    """J w' = -c - q w^2 stops at t = J/sqrt(c q) arctan(w_0 sqrt(q/c)), theta = J/(2 q) ln(1 + q w_0^2/c)."""
    c, q, j = 3.0, 0.02, 2.0
    drive = Drive((Mass(j),), cycle=cycle(-c, quadratic=-q))
    result = run(drive, Scenario("run-down", 60.0, speed=30.0), method)
    assert result.end == "standstill"
    assert result.omega[0, -1] == 0.0
    bound = BOUND.get(result.method, 1e-8)
    assert result.t[-1] == pytest.approx(j / math.sqrt(c * q) * math.atan(30 * math.sqrt(q / c)), abs=20 * bound)
    assert result.theta[0, -1] == pytest.approx(j / (2 * q) * math.log(1 + q * 900 / c), abs=100 * bound)
    assert event(result, "standstill").time == result.t[-1]


def test_viscous_brake_and_constant_brake() -> None:
    """J w' = -F - b w: w = (w_0 + F/b) exp(-b t/J) - F/b, at rest at t = J/b ln(1 + b w_0/F)."""
    drive = Drive((Mass(2.0),))
    result = run(drive, Scenario("braking", 9.0, speed=8.0, brake=Brake(5.0, 1.5)))
    check(result, (8 + 5 / 1.5) * np.exp(-0.75 * result.t) - 5 / 1.5, scale=8.0)
    assert result.t[-1] == pytest.approx(math.log(1 + 1.5 * 8 / 5) / 0.75, abs=1e-9)
    assert result.brake_work[-1] == pytest.approx(-64.0, rel=1e-9)


@sparing("method", METHODS, every=4)
def test_kloss_run_up(method: str) -> None:
    given, expected = case("dyn-closed-kloss-startup")["inputs"], case("dyn-closed-kloss-startup")["expected"]
    motor = kloss(given["M_K"], given["s_K"], given["omega_sync"])
    drive = Drive((Mass(given["J"]),), characteristic=motor)
    result = run(drive, Scenario("start", 3.0, targets=tuple(expected["omega"])), method)
    times = np.array([e.time for e in result.events if e.kind == "target"])
    assert times == pytest.approx(expected["t"], rel=2e-7 if method == "BDF" else 1e-7)
    speeds = np.array(expected["omega"])
    s = 1 - speeds / given["omega_sync"]
    exact = (1 - s**2) / (2 * given["s_K"]) - given["s_K"] * np.log(s)
    exact *= given["J"] * given["omega_sync"] / (2 * given["M_K"])
    missed = (times - exact) * motor.moment(speeds) / given["J"]  # speed that the error in time is worth
    assert float(np.max(np.abs(missed))) < 10 * BOUND.get(method, 1e-8)
    assert float(np.max(np.abs(missed))) < 10 * result.error


def test_kloss_run_up_at_the_tightest_tolerance() -> None:
    motor = kloss(242.0, 0.2773061196, 10.71428571)
    result = run(
        Drive((Mass(30.6),), characteristic=motor), Scenario("start", 3.0, end_speed=10.0), "merson", tolerance=1e-13
    )
    s, k = 1 - 10.0 / 10.71428571, 0.2773061196
    exact = 30.6 * 10.71428571 / 484 * ((1 - s * s) / (2 * k) - k * math.log(s))
    assert result.end == "speed"
    assert result.t[-1] == pytest.approx(exact, rel=2e-13)
    assert result.omega[0, -1] == 10.0
    assert result.imbalance < 1e-12


def test_parabola_under_constant_load_by_angle() -> None:
    given, expected = case("dyn-closed-parabola-const")["inputs"], case("dyn-closed-parabola-const")["expected"]
    a, b, j, load = given["A"], given["B"], given["J"], given["M_c"]
    drive = Drive((Mass(j),), characteristic=parabola(a, b), cycle=cycle(load, speed=10.0))
    result = run(drive, Scenario("load change", 9.0, speed=given["omega0"], end_angle=4 * math.pi))
    assert result.end == "angle"
    assert result.theta[0, -1] == 4 * math.pi
    level = (a + load) / b
    exact = np.sqrt(level + (given["omega0"] ** 2 - level) * np.exp(-2 * b * result.theta[0] / j))
    check(result, exact, scale=10.0)
    assert result.omega[0, -1] == pytest.approx(expected["omega"][-1], rel=1e-7)


def test_parabola_under_harmonic_load_stays_periodic() -> None:
    """Begun on the closed periodic solution, the run has to stay on it for three turns."""
    given, expected = case("dyn-closed-parabola-harmonic")["inputs"], case("dyn-closed-parabola-harmonic")["expected"]
    a, b, j = given["A"], given["B"], given["J"]
    k, f = 2 * b / j, 2 * 60 / j

    def periodic(phi: np.ndarray) -> np.ndarray:
        return np.sqrt((a - 80) / b - f * (k * np.cos(phi) + np.sin(phi)) / (k * k + 1))

    drive = Drive((Mass(j),), characteristic=parabola(a, b), cycle=cycle(lambda p: -80 - 60 * np.cos(p), speed=10.0))
    result = run(drive, Scenario("regime", 9.0, speed=float(periodic(np.array(0.0))), end_angle=6 * math.pi))
    check(result, periodic(result.theta[0]), scale=10.0)
    assert result.omega[0, 0] == pytest.approx(expected["omega"][0], rel=1e-7)


@sparing("method", METHODS, every=4)
def test_energy_is_kept_where_no_moment_acts(method: str) -> None:
    given, expected = case("dyn-closed-energy")["inputs"], case("dyn-closed-energy")["expected"]
    drive = Drive((Mass(0.5),), cycle=cycle(0.0, lambda p: 0.3 * (1 - np.cos(2 * p)), speed=10.0))
    result = run(drive, Scenario("free", 0.8, speed=given["omega0"]), method)
    exact = given["omega0"] * np.sqrt(0.5 / (0.5 + 0.3 * (1 - np.cos(2 * result.theta[0]))))
    check(result, exact, scale=10.0)
    assert result.imbalance < BOUND.get(method, 1e-8)
    slowest = float(np.interp(math.pi / 2, result.theta[0], result.omega[0]))
    assert slowest == pytest.approx(expected["omega"][1], rel=1e-2)


@sparing("method", METHODS, every=4)
def test_lag_of_the_motor(method: str) -> None:
    given, expected = case("dyn-ext-motor-lag")["inputs"], case("dyn-ext-motor-lag")["expected"]
    drive = Drive(
        (Mass(given["J"]),),
        characteristic=line(given["b"], 157.0),
        cycle=cycle(-given["M_load"], speed=157.0),
        time_constant=given["tau_e"],
    )
    result = run(drive, Scenario("load", 0.1, speed=157.0), method, expected["t"])
    rows = at(result, expected["t"])
    np.testing.assert_allclose(result.omega[0, rows] - 157, expected["w_minus_ws"], rtol=1e-6, atol=1e-7)
    np.testing.assert_allclose(result.motor_moment[rows], expected["M"], rtol=1e-6, atol=1e-5)


@pytest.mark.parametrize("tau", [1e-2, 1e-3, 1e-4, 1e-5, 1e-6])
def test_lag_from_slow_to_stiff(tau: float) -> None:
    """x = w - w_inf: x'' + x'/tau + b/(J tau) x = 0; the stiff end goes to an implicit method by itself."""
    j, b, load = 2.0, 154.0, 100.0
    drive = Drive((Mass(j),), characteristic=line(b, 157.0), cycle=cycle(-load, speed=157.0), time_constant=tau)
    times = np.array([1e-3, 0.01, 0.05, 0.3])
    result = run(drive, Scenario("load", 0.3, speed=157.0), instants=times)
    roots = np.roots([1, 1 / tau, b / (j * tau)]).astype(complex)
    # x(0) = load/b, x'(0) = -load/j
    weights = np.linalg.solve(np.vstack((np.ones(2), roots)), np.array([load / b, -load / j]))
    exact = 157 - load / b + (weights @ np.exp(np.outer(roots, times))).real
    np.testing.assert_allclose(result.omega[0, at(result, times)], exact, atol=157 * 1e-9)
    assert result.method == ("collocation" if tau < 1e-3 else "merson")
