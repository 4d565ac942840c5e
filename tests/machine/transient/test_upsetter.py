"""The cold-heading press of the textbook: run-up, loading, regime, stall, against an independent integration."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from sparing import sparing

from machine.transient.scenes import FORCE, L1, L2, SLIDER, WEIGHT, at, case, event, kloss, run, travel, upsetter_drive
from tmmcalc.machine.transient.model import Drive
from tmmcalc.machine.transient.scenario import LoadStep, Scenario

MOTOR = kloss(242.0, 0.2773061196151028, 10.714285714285714, 10.0)
IDLE = (LoadStep(0.0),)


def started(motor: Any = None, inertia: float = 30.6) -> Drive:
    return upsetter_drive(motor or kloss(242.0, 0.275, 10.714, 10.0), inertia)


def test_run_up_of_the_textbook() -> None:
    expected = case("dyn-upsetter-startup")["expected"]
    table = expected["omega_at_t"]
    scenario = Scenario("start", 4.0, load=IDLE, targets=(5.0, 10.0, 10.6, 10.714))
    result = run(started(), scenario, instants=table["t"])
    assert result.method == "merson"
    rows = at(result, table["t"])
    np.testing.assert_allclose(result.omega[0, rows], table["omega"], rtol=1e-5)
    np.testing.assert_allclose(result.theta[0, rows], table["phi"], rtol=1e-5)
    times = [e.time for e in result.events if e.kind == "target"]
    keys = ("t_first_reach_5", "t_first_reach_10", "t_first_reach_10_6", "t_first_reach_sync")
    assert times == pytest.approx([expected[key] for key in keys], rel=1e-5)
    time, _, speed = result.turning
    assert speed[time > 3.0].min() == pytest.approx(expected["omega_min_last_s"], rel=1e-5)
    assert speed[time > 3.0].max() == pytest.approx(expected["omega_max_last_s"], rel=1e-5)
    assert result.imbalance < 1e-9


def curvature(p: float) -> float:
    s, c = math.sin(p), math.cos(p)
    root = math.sqrt(L2**2 - (L1 * s) ** 2)
    return -L1 * c - L1**2 * ((c * c - s * s) / root + (L1 * s * c) ** 2 / root**3)


@cache
def reference(inertia: float, motor: Any, start: tuple[float, float], span: float, load: float = 0.0) -> Any:
    """The same motion written down directly, half a turn at a time, by DOP853 at 1e-13."""

    def f(_: float, y: np.ndarray) -> list[float]:
        p, w = y
        s1 = float(travel(p))
        force = (load * FORCE * (p % (2 * math.pi)) ** 2 if down else 0.0) - WEIGHT
        mass = inertia + SLIDER * s1 * s1
        return [w, (float(motor.moment(w)) + force * s1 - SLIDER * s1 * curvature(p) * w * w) / mass]

    t, y, half = 0.0, np.array(start), 0
    while t < span:
        down, half = half % 2 == 0, half + 1

        def edge(_: float, y: np.ndarray, half: int = half) -> float:
            return float(y[0] - half * math.pi)

        edge.terminal = True
        piece = solve_ivp(f, (t, span), y, method="DOP853", events=edge, rtol=2.3e-14, atol=1e-14)
        t, y = float(piece.t[-1]), piece.y[:, -1]
    return y


@sparing(
    ("method", "bound"),
    [("merson", 1e-8), ("collocation", 1e-8), ("DOP853", 1e-8), ("RK45", 1e-8), ("Radau", 1e-8), ("LSODA", 1e-7)],
    every=3,
)
def test_run_up_against_an_independent_integration(method: str, bound: float) -> None:
    result = run(started(MOTOR), Scenario("start", 3.0, load=IDLE), method)
    angle, speed = reference(30.6, MOTOR, (0.0, 0.0), 3.0)
    assert result.theta[0, -1] == pytest.approx(angle, abs=bound)
    assert result.omega[0, -1] == pytest.approx(speed, abs=bound)
    assert abs(result.omega[0, -1] - speed) / 10.7 < result.error
    assert result.imbalance < bound


def test_loaded_motion_against_an_independent_integration() -> None:
    """A load with a kink at 180 degrees in every turn, at full force from the first."""
    result = run(started(MOTOR), Scenario("loaded", 2.5, speed=10.7), tolerance=1e-11)
    angle, speed = reference(30.6, MOTOR, (0.0, 10.7), 2.5, load=1.0)
    assert result.theta[0, -1] == pytest.approx(angle, abs=1e-9)
    assert result.omega[0, -1] == pytest.approx(speed, abs=1e-9)
    assert result.imbalance < 1e-10


def test_the_order_with_fixed_steps() -> None:
    _, speed = reference(30.6, MOTOR, (0.0, 10.7), 1.0, load=1.0)
    for method in ("merson", "rk4"):
        errors = []
        for step in (0.02, 0.01, 0.005):
            result = run(started(MOTOR), Scenario("loaded", 1.0, speed=10.7), method, step=step)
            errors.append(abs(result.omega[0, -1] - speed))
        orders = np.log2(np.array(errors[:-1]) / errors[1:])
        assert np.all(np.abs(orders - 4) < 0.3), (method, errors)
        assert errors[-1] < 2e-8


def test_fixed_steps_print_the_error_of_each() -> None:
    result = run(started(), Scenario("start", 1.0, load=IDLE), "merson", step=0.02)
    assert result.step_error is not None
    assert np.count_nonzero(result.step_error) == len(result.t) - 1
    grid = result.t * 50
    assert np.count_nonzero(np.abs(grid - np.round(grid)) < 1e-9) >= 51
    assert run(started(), Scenario("start", 1.0, load=IDLE), "rk4", step=0.02).step_error is None


def test_load_is_switched_on_at_the_rated_speed() -> None:
    steps = (LoadStep(0.0), LoadStep(1.0, speed=10.0))
    result = run(started(MOTOR), Scenario("start", 4.0, load=steps))
    switched = event(result, "load")
    assert switched.speed == 10.0
    row = int(np.searchsorted(result.t, switched.time))
    assert result.load_factor[row - 1] == 0.0
    assert result.load_factor[row] == 1.0
    idle = run(started(MOTOR), Scenario("start", 4.0, load=IDLE, targets=(10.0,)))
    assert switched.time == pytest.approx(event(idle, "target").time, abs=1e-9)


def test_a_quiet_load_waits_for_the_idle_half() -> None:
    """The speed of 9.5 rad/s is first reached on the way down, where the full load would jump in."""
    scenario = Scenario("start", 4.0, load=(LoadStep(0.0), LoadStep(1.0, speed=9.5, quiet=True)))
    result = run(started(MOTOR), scenario)
    reached = event(run(started(MOTOR), Scenario("start", 4.0, load=IDLE, targets=(9.5,))), "target")
    assert reached.angle % (2 * math.pi) < math.pi
    switched = event(result, "load")
    assert switched.time > reached.time
    assert switched.angle == pytest.approx(3 * math.pi, abs=1e-12)


def test_the_run_up_ends_in_the_steady_regime() -> None:
    expected = case("dyn-upsetter-regime-30")["expected"]["kloss"]
    steps = (LoadStep(0.0), LoadStep(1.0, speed=10.0))
    result = run(started(MOTOR), Scenario("start", 15.0, load=steps, end_angle=30 * math.pi), tolerance=1e-11)
    assert result.end == "angle"
    assert result.omega[0, -1] == pytest.approx(expected["omega_at_phi0"], abs=1e-6)
    _, angle, speed = result.turning[:, result.turning[1] > 28 * math.pi]
    assert speed.min() == pytest.approx(expected["omega_min"], rel=2e-6)
    assert speed.max() == pytest.approx(expected["omega_max"], rel=2e-6)
    assert angle[np.argmin(speed)] - 28 * math.pi == pytest.approx(expected["phi_min_rad"], abs=0.02)
    first = event(result, "overload")
    assert first.speed == pytest.approx(10.0, abs=1e-12)
    assert any("overload" in verdict.message for verdict in result.verdicts)


@sparing("inertia", [10.0, 5.0, 4.0, 3.27, 3.26, 3.0, 2.0], every=4)
def test_stall_under_load(inertia: float) -> None:
    """The threshold is 3.2652 kg*m^2; the smallest speed of the regime is given for the three largest."""
    given = case("dyn-upsetter-stall")
    lowest = dict(zip(given["inputs"]["J_c_list"], given["expected"]["omega_min"], strict=True)).get(inertia)
    result = run(started(MOTOR, inertia), Scenario("loaded", 6.0, speed=MOTOR.synchronous))
    if inertia < given["expected"]["threshold_J_c"]:
        assert result.end == "stall"
        assert result.omega[0, -1] == 0.0
        stalled = event(result, "stall")
        assert 0.5 * math.pi < stalled.angle % (2 * math.pi) < math.pi
        assert "the motor stalls at the crank angle" in result.verdicts[0].message
        assert -result.load_moment[-1] > MOTOR.moment(0.0)
        assert event(result, "pull-out").time < stalled.time
    else:
        assert result.end == "time"
        if lowest:
            time, _, speed = result.turning
            assert speed[time > 4.0].min() == pytest.approx(lowest, rel=2e-4)


@pytest.mark.slow
def test_a_stiff_run() -> None:
    """Very small inertia (lambda of some 800 1/s): the speed follows the load at once."""
    given = case("dyn-stiff-regime-a")
    drive = started(MOTOR, 0.2)
    scenario = Scenario("loaded", 9.0, speed=10.7, load=(LoadStep(0.3),), end_angle=4 * math.pi)
    for method in ("auto", "LSODA", "Radau"):
        result = run(drive, scenario, method)
        assert result.end == "angle"
        assert result.omega[0, -1] == pytest.approx(given["expected"]["omega_every_45deg"][0], rel=1e-6)
        speed = result.turning[2, result.turning[1] > 2 * math.pi]
        assert speed.min() == pytest.approx(given["expected"]["omega_min"], rel=1e-6)
        assert speed.max() == pytest.approx(given["expected"]["omega_max"], rel=1e-6)
