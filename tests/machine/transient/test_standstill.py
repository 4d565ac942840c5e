"""Standstill: braking to rest, being held and released, stalling, turning back, starting against a load."""

from __future__ import annotations

import math

import numpy as np
import pytest

from machine.transient.scenes import constant, cycle, event, kloss, line, run
from tmmcalc.core.errors import UsageError
from tmmcalc.machine.transient.model import Drive, Mass, Shaft
from tmmcalc.machine.transient.scenario import Brake, LoadStep, Scenario

METHODS = ["merson", "collocation", "DOP853", "LSODA", "Radau"]


@pytest.mark.parametrize("method", METHODS)
def test_a_constant_brake_stops_and_holds(method: str) -> None:
    """J w' = -F: at rest after J w_0/F, having turned by J w_0^2/(2 F)."""
    drive = Drive((Mass(2.0),))
    result = run(drive, Scenario("braking", 9.0, speed=10.0, brake=Brake(40.0)), method)
    assert result.end == "standstill"
    assert result.t[-1] == pytest.approx(0.5, abs=1e-9)
    assert result.theta[0, -1] == pytest.approx(2.5, abs=1e-8)
    assert result.omega[0, -1] == 0.0
    assert result.brake_work[-1] == pytest.approx(-100.0, rel=1e-8)


@pytest.mark.parametrize("method", METHODS)
def test_a_load_turns_the_crank_back(method: str) -> None:
    """A weight on a drum with the motor off: w = w_0 - M t/J through standstill."""
    drive = Drive((Mass(2.0),), cycle=cycle(-8.0))
    result = run(drive, Scenario("slip back", 3.0, speed=4.0, standstill="pass"), method)
    back = event(result, "reversal")
    assert back.time == pytest.approx(1.0, abs=1e-8)
    assert back.angle == pytest.approx(2.0, abs=1e-8)
    assert result.omega[0, -1] == pytest.approx(-8.0, abs=1e-7)
    assert result.theta[0, -1] == pytest.approx(-6.0, abs=1e-7)
    assert run(drive, Scenario("stop", 3.0, speed=4.0), method).t[-1] == pytest.approx(1.0, abs=1e-8)


def test_a_pendulum_turns_back_over_the_seam_of_the_period() -> None:
    """Started backwards below its own height it swings between two angles that its energy gives, for ever."""
    drive = Drive((Mass(0.8),), cycle=cycle(lambda p: -6 * np.sin(p), 0.2))
    result = run(drive, Scenario("swing", 9.0, speed=-3.0, angle=0.4, standstill="pass"), tolerance=1e-11)
    energy = 4.5 - 6 * math.cos(0.4)
    turn = math.acos(-energy / 6)
    angles = [e.angle for e in result.events if e.kind == "reversal"]
    assert len(angles) >= 5
    assert angles == pytest.approx([(-turn, turn)[k % 2] for k in range(len(angles))], abs=1e-8)
    assert result.imbalance < 1e-9


def test_a_load_with_jumps_is_crossed_both_ways() -> None:
    """A spring-like step: -12 N*m beyond 1 rad, nothing before: there and back with the same speed."""
    drive = Drive((Mass(1.5),), cycle=cycle(lambda p: np.where((p > 1.0) & (p < 3.0), -12.0, 0.0), 0.0, (1.0, 3.0)))
    result = run(drive, Scenario("bounce", 2.0, speed=4.0, standstill="pass"))
    back = event(result, "reversal")
    assert back.angle == pytest.approx(1 + 1.5 * 16 / 24, abs=1e-9)
    assert back.time == pytest.approx(0.25 + 1.5 * 4 / 12, abs=1e-9)
    assert result.omega[0, -1] == pytest.approx(-4.0, abs=1e-9)
    assert result.theta[0, -1] == pytest.approx(1 - 4 * (2.0 - 0.25 - 1.0), abs=1e-9)


def test_a_motor_that_cannot_start() -> None:
    motor = kloss(60.0, 0.25, 10.0, 9.5)
    drive = Drive((Mass(3.0),), characteristic=motor, cycle=cycle(-100.0))
    result = run(drive, Scenario("start", 5.0, end_speed=9.5))
    assert result.end == "stall"
    assert list(result.t) == [0.0]
    stall = event(result, "stall")
    assert (stall.time, stall.angle, stall.speed) == (0.0, 0.0, 0.0)
    first = result.verdicts[0]
    assert first.severity == "warning"
    assert "the motor cannot start" in first.message
    assert f"{motor.moment(0.0):.5g} N*m" in first.message
    assert "100 N*m" in first.message
    assert any("does not reach 9.5 rad/s" in verdict.message for verdict in result.verdicts)


def test_a_start_without_load_and_the_load_later() -> None:
    """Unloaded it starts; when the load comes at 1 s it stalls, with the time of that."""
    drive = Drive((Mass(3.0),), characteristic=constant(30.0), cycle=cycle(-60.0))
    steps = (LoadStep(0.0), LoadStep(1.0, time=1.0))
    result = run(drive, Scenario("start", 9.0, load=steps))
    assert result.end == "stall"
    assert result.t[-1] == pytest.approx(2.0, abs=1e-9)
    assert [e.kind for e in result.events] == ["load", "standstill", "stall"]
    assert "the motor stalls" in result.verdicts[0].message


def test_a_machine_at_rest_waits_for_its_motor() -> None:
    """Off, on at 0.5 s, off at 1.5 s, and stopped by friction at 3.5 s."""
    drive = Drive((Mass(2.0),), characteristic=constant(9.0), cycle=cycle(-3.0))
    result = run(drive, Scenario("start and stop", 9.0, motor=((0.5, 1.5),)))
    assert result.end == "standstill"
    assert [e.kind for e in result.events] == ["motor on", "motor off", "standstill"]
    assert result.t[-1] == pytest.approx(1.5 + 2 * 3.0 / 3.0, abs=1e-9)
    assert np.all(result.omega[0, result.t <= 0.5] == 0.0)
    assert result.omega[0].max() == pytest.approx(3.0, rel=1e-9)


def test_a_motor_with_lag_starts_when_it_overcomes_the_load() -> None:
    """M = M_0 (1 - exp(-t/tau)) reaches the load at t = -tau ln(1 - load/M_0)."""
    drive = Drive((Mass(2.0),), characteristic=constant(50.0), cycle=cycle(-20.0), time_constant=0.1)
    result = run(drive, Scenario("start", 1.0))
    begin = -0.1 * math.log(1 - 20 / 50)
    assert np.all(result.omega[0, result.t < begin] == 0.0)
    t = result.t[result.t >= begin]
    # J w' = 30 - 50 exp(-t/tau)
    exact = (30 * (t - begin) + 5 * (np.exp(-t / 0.1) - math.exp(-begin / 0.1))) / 2
    np.testing.assert_allclose(result.omega[0, result.t >= begin], exact, atol=1e-8)
    stuck = Drive((Mass(2.0),), characteristic=constant(50.0), cycle=cycle(-60.0), time_constant=0.1)
    assert run(stuck, Scenario("start", 1.0)).end == "stall"


def test_a_brake_holds_until_the_motor_overcomes_it() -> None:
    drive = Drive((Mass(2.0),), characteristic=constant(50.0), time_constant=0.1)
    for standstill in ("stop", "pass"):
        scenario = Scenario("start", 0.3, brake=Brake(20.0), standstill=standstill)
        result = run(drive, scenario)
        begin = -0.1 * math.log(1 - 20 / 50)
        assert result.omega[0, np.searchsorted(result.t, begin) - 1] == 0.0
        exact = (30 * (0.3 - begin) + 5 * (math.exp(-3) - math.exp(-begin / 0.1))) / 2
        assert result.omega[0, -1] == pytest.approx(exact, abs=1e-8)


def test_a_brake_against_a_weight_that_drives_backwards() -> None:
    """Weight 8, brake 3: up with -11, down with -5; a brake of 9 holds the crank where it stops."""
    drive = Drive((Mass(2.0),), cycle=cycle(-8.0))
    scenario = Scenario("hoist", 3.0, speed=5.5, standstill="pass", brake=Brake(3.0))
    result = run(drive, scenario)
    assert event(result, "standstill").time == pytest.approx(1.0, abs=1e-9)
    assert result.omega[0, -1] == pytest.approx(-5.0 / 2 * 2, abs=1e-8)
    held = run(drive, Scenario("hoist", 3.0, speed=8.5, standstill="pass", brake=Brake(9.0)))
    assert held.end == "standstill"
    assert held.t[-1] == pytest.approx(1.0, abs=1e-9)
    let_go = run(drive, Scenario("hoist", 3.0, speed=8.5, standstill="pass", brake=Brake(9.0, end=2.0)))
    assert let_go.omega[0, -1] == pytest.approx(-4.0, abs=1e-8)


def test_a_braked_rotor_and_a_swinging_crank() -> None:
    """The brake on the first mass holds it; the second swings on the shaft about it: w = w_0 cos(sqrt(c/J) t)."""
    chain = Drive((Mass(1.0), Mass(2.0)), (Shaft(800.0),))
    scenario = Scenario("braking", 2.0, speed=0.5, standstill="pass", brake=Brake(500.0, mass=0))
    result = run(chain, scenario, tolerance=1e-12)
    stop = int(np.flatnonzero(result.omega[0] == 0)[0])
    t, t0 = result.t[stop:], result.t[stop]
    assert np.all(result.omega[0, stop:] == 0.0)
    rate, twist, speed = 20.0, result.shaft_moment[0, stop] / 800, result.omega[1, stop]
    exact = speed * np.cos(rate * (t - t0)) + twist * rate * np.sin(rate * (t - t0))
    np.testing.assert_allclose(result.omega[1, stop:], exact, atol=1e-8)


def test_a_brake_that_slips_under_a_swinging_shaft() -> None:
    """Held, torn loose and held again: energy and works still balance, and it comes to rest in the end."""
    chain = Drive((Mass(0.05), Mass(2.0)), (Shaft(800.0, 1.0),))
    scenario = Scenario("braking", 2.0, speed=3.0, standstill="pass", brake=Brake(30.0, mass=0))
    result = run(chain, scenario)
    assert result.imbalance < 1e-9
    held = result.omega[0] == 0.0
    assert np.count_nonzero(np.diff(held.astype(int)) == 1) >= 1
    assert abs(result.omega[0, -1]) < 1e-6


def test_a_wound_shaft_starts_the_crank_when_it_is_strong_enough() -> None:
    """The rotor winds the shaft on the held crank: M (1 - cos w t) reaches the load of 30 N*m."""
    chain = Drive((Mass(0.5), Mass(2.0)), (Shaft(2e4),), characteristic=constant(50.0), cycle=cycle(-30.0))
    result = run(chain, Scenario("start", 0.05))
    begin = math.acos(1 - 30 / 50) / 200  # sqrt(c/J_1) = 200
    assert np.all(result.omega[1, result.t < begin] == 0.0)
    first = int(np.searchsorted(result.t, begin))
    assert result.t[first] == pytest.approx(begin, abs=1e-9)
    assert result.shaft_moment[0, first] == pytest.approx(30.0, abs=1e-6)
    assert result.omega[1, -1] > 0


def test_a_chain_runs_down_to_standstill() -> None:
    chain = Drive((Mass(0.5), Mass(2.0)), (Shaft(2e4, 20.0),), cycle=cycle(-20.0))
    result = run(chain, Scenario("run-down", 9.0, speed=10.0))
    assert result.end == "standstill"
    assert result.t[-1] == pytest.approx(2.5 * 10 / 20, rel=2e-2)
    assert result.omega[1, -1] == 0.0


def test_nothing_that_could_move() -> None:
    result = run(Drive((Mass(1.0),)), Scenario("rest", 5.0))
    assert (result.end, list(result.t)) == ("standstill", [0.0])


def test_plugging_turns_the_machine_round() -> None:
    """A motor switched to the other direction drives through standstill to its speed backwards."""
    drive = Drive((Mass(1.0),), characteristic=line(2.0, -10.0))
    result = run(drive, Scenario("plugging", 9.0, speed=10.0, standstill="pass"))
    assert event(result, "reversal").time == pytest.approx(math.log(2) / 2, abs=1e-9)
    assert result.omega[0, -1] == pytest.approx(-10.0, abs=1e-6)
    assert run(drive, Scenario("braking", 9.0, speed=10.0)).t[-1] == pytest.approx(math.log(2) / 2, abs=1e-9)


def test_a_negative_speed_needs_a_load_that_may_drive_back() -> None:
    with pytest.raises(UsageError, match="speed is -1"):
        Scenario("back", 1.0, speed=-1.0)
