"""What is said about the motor and the length of a run, against closed forms."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from machine.transient.scenes import Motor, constant, cycle, event, kloss, line, run, upsetter_drive
from tmmcalc.core.errors import AccuracyError
from tmmcalc.machine.motors.characteristics import parabolic, straight
from tmmcalc.machine.transient.model import Drive, Mass, Shaft
from tmmcalc.machine.transient.results import Transient
from tmmcalc.machine.transient.scenario import LoadStep, Scenario

MOTOR = kloss(60.0, 0.25, 10.0, 9.5)
START = MOTOR.moment(0.0)
STEPS = (LoadStep(0.0), LoadStep(1.0, speed=10.0, quiet=True))


def said(result: Transient, word: str) -> list[str]:
    return [str(verdict) for verdict in result.verdicts if word in verdict.message]


def test_a_load_above_the_starting_moment_and_below_the_largest() -> None:
    """From rest the motor cannot start; from its rated speed it carries the same load."""
    drive = Drive((Mass(3.0),), characteristic=MOTOR, cycle=cycle(-START - 1.0))
    result = run(drive, Scenario("start", 5.0))
    assert result.end == "stall"
    (text,) = said(result, "cannot start")
    assert f"gives {START:.5g} N*m" in text
    assert f"asks for {START + 1:.5g} N*m" in text
    running = run(drive, Scenario("run", 5.0, speed=9.9))
    assert running.end == "time"
    assert not said(running, "stall")
    assert not said(running, "break-down")


def test_a_load_just_below_the_starting_moment_is_started() -> None:
    drive = Drive((Mass(3.0),), characteristic=MOTOR, cycle=cycle(-START + 0.5))
    result = run(drive, Scenario("start", 60.0, end_speed=9.0))
    assert result.end == "speed"
    assert not said(result, "start")


def test_a_stall_in_the_run_is_no_failed_start() -> None:
    """70 N*m against the 60 of the motor: overload, pull-out, standstill, in this order."""
    drive = Drive((Mass(3.0),), characteristic=MOTOR, cycle=cycle(-70.0), idle=cycle(-5.0))
    result = run(drive, Scenario("run", 30.0, speed=9.9, load=(LoadStep(0.0), LoadStep(1.0, time=1.0))))
    assert result.end == "stall"
    kinds = [e.kind for e in result.events]
    assert kinds == ["load", "overload", "pull-out", "standstill", "stall"]
    assert said(result, "the motor stalls")
    assert not said(result, "cannot start")
    (text,) = said(result, "pull-out")
    assert "its lowest speed afterwards is 0 rad/s" in text
    assert event(result, "pull-out").speed == pytest.approx(7.5, abs=1e-12)


@pytest.mark.parametrize("form", [straight, parabolic])
def test_a_start_beyond_the_range_of_the_characteristic(form: Callable[..., Any]) -> None:
    """From rest a line gives M_N omega_c/(omega_c - omega_N), a parabola M_N omega_c^2/(omega_c^2 - omega_N^2)."""
    motor = form(20.0, 9.5, 10.0)
    standing = 20.0 / (1 - 0.95) if form is straight else 20.0 / (1 - 0.95**2)
    drive = Drive((Mass(3.0),), characteristic=motor, cycle=cycle(-5.0))
    result = run(drive, Scenario("start", 5.0))
    (text,) = said(result, "holds from")
    assert text.startswith(
        f"warning: the {motor.name} characteristic holds from 9.5 rad/s up, the speed is as low as 0"
    )
    assert f"extrapolated to {standing:.5g} N*m, {standing / 20:.3g} times the rated" in text
    if form is straight:  # J w' = b (w_e - w), w_e where the line gives the 5 N*m of the load
        stiffness, end = 20.0 / 0.5, 10.0 - 5.0 / 40.0
        assert f"for {-3.0 / stiffness * math.log((end - 9.5) / end):.1g}" in text
    assert not said(run(drive, Scenario("run", 5.0, speed=9.8)), "holds from")
    off = Scenario("stop", 5.0, speed=9.8, motor=((0.0, 1.0),))
    assert not said(run(drive, off), "holds from")


def test_a_quiet_load_without_a_quiet_part() -> None:
    """A load over the whole cycle comes when it is due, which is told with the place."""
    drive = Drive((Mass(3.0),), characteristic=MOTOR, cycle=cycle(-30.0), idle=cycle(-5.0))
    result = run(drive, Scenario("start", 5.0, load=(LoadStep(0.0), LoadStep(1.0, speed=9.0, quiet=True))))
    (text,) = said(result, "quiet")
    angle = math.degrees(event(result, "load").angle) % 360
    assert text.startswith("warning: the load factor 1 does not wait (quiet)")
    assert f"applied at {angle:.5g} deg" in text
    late = run(drive, Scenario("start", 5.0, load=(LoadStep(0.0), LoadStep(1.0, speed=90.0, quiet=True))))
    assert "as soon as it is due" in said(late, "quiet")[0]
    plain = run(drive, Scenario("start", 5.0, load=(LoadStep(0.0), LoadStep(1.0, speed=9.0))))
    assert not said(plain, "quiet")
    assert not said(run(upsetter_drive(MOTOR, 3.0), Scenario("start", 2.0, load=STEPS)), "quiet")


def test_a_motor_that_crawls_below_its_break_down_speed() -> None:
    """24 + 6 w crosses the motor's moment at low speed: it runs there and never gets to its working branch."""
    drive = Drive((Mass(1.0),), characteristic=MOTOR, cycle=cycle(-24.0, viscous=-6.0))
    result = run(drive, Scenario("start", 20.0))
    speed = float(result.omega[0, -1])
    assert MOTOR.moment(speed) == pytest.approx(24 + 6 * speed, rel=1e-9)
    assert speed < MOTOR.critical
    (text,) = said(result, "break-down speed")
    assert text.startswith(f"warning: the motor, at {speed:.6g} rad/s")
    early = run(Drive((Mass(50.0),), characteristic=MOTOR), Scenario("start", 1.0))
    assert said(early, "takes longer")


def test_a_wound_shaft_at_rest_at_the_end_is_no_stall() -> None:
    """The crank is still held when the time is up, but the motor is strong enough: nothing is said of a stall."""
    chain = Drive((Mass(0.5), Mass(2.0)), (Shaft(2e4),), characteristic=constant(50.0), cycle=cycle(-30.0))
    result = run(chain, Scenario("start", 0.004))
    assert result.omega[1, -1] == 0.0
    assert result.verdicts == ()


@pytest.mark.slow
def test_heating_against_the_closed_form() -> None:
    """M = b w_0 exp(-b t/J): its mean square over T is (b w_0)^2 J/(2 b T) (1 - exp(-2 b T/J))."""
    b, w0, j, time = 2.0, 30.0, 4.0, 5.0
    motor = line(b, w0)
    motor.nominal = 26.0  # rated moment 8 N*m
    result = run(Drive((Mass(j),), characteristic=motor), Scenario("start", time), instants=np.linspace(0, time, 20001))
    square = (b * w0) ** 2 * j / (2 * b * time) * (1 - math.exp(-2 * b * time / j))
    (text,) = said(result, "heating")
    assert f"moment {math.sqrt(square):.5g} N*m over 5 s exceeds the rated 8 N*m" in text
    assert f"pauses of {time * (square / 64 - 1):.3g} s" in text
    motor.nominal = w0 - math.sqrt(square) / b - 0.01
    assert not said(run(Drive((Mass(j),), characteristic=motor), Scenario("start", time)), "heating")


def test_a_motor_without_a_rated_speed_has_no_verdict_on_heating() -> None:
    assert not said(run(Drive((Mass(1.0),), characteristic=constant(9.0)), Scenario("start", 1.0)), "heating")


@pytest.mark.slow
def test_a_run_ends_when_it_is_steady() -> None:
    """The same motion with ten times the duration: up to there it is the same, and it would go on as it is."""
    motor = kloss(242.0, 0.2773, 10.714, 10.0)
    drive = upsetter_drive(motor, 30.6)
    short = run(drive, Scenario("start", 600.0, load=STEPS, until_steady=True))
    assert short.end == "steady"
    assert event(short, "steady").time <= short.t[-1]
    long = run(drive, Scenario("start", 5 * float(short.t[-1]), load=STEPS))
    assert long.end == "time"
    last = short.t >= short.t[-1] - 0.5
    late = long.turning[2][long.turning[0] > long.t[-1] - 0.7]
    assert float(short.omega[0, last].max()) == pytest.approx(float(late.max()), rel=1e-4)
    (text,) = said(long, "repeats itself")
    assert f"from t = {event(long, 'steady').time:.4g} s on" in text
    assert not said(short, "repeats itself")


def test_steady_counts_anew_when_something_is_switched() -> None:
    drive = Drive((Mass(2.0),), characteristic=line(5.0, 10.0), cycle=cycle(-4.0))
    scenario = Scenario("load", 600.0, load=(LoadStep(0.0), LoadStep(1.0, time=20.0)), until_steady=True)
    result = run(drive, scenario)
    assert result.end == "steady"
    assert [e.kind for e in result.events] == ["steady", "load", "steady"]
    assert result.omega[0, -1] == pytest.approx(10 - 4 / 5, rel=1e-6)


def test_a_motion_that_never_repeats_is_told() -> None:
    drive = Drive((Mass(2.0),), characteristic=constant(1.0))
    result = run(drive, Scenario("ever faster", 20.0, until_steady=True))
    assert result.end == "time"
    assert said(result, "does not repeat itself yet")


@pytest.mark.parametrize(("moment", "way"), [(2.0, 1), (-2.0, -1)])
def test_a_machine_that_drives_itself_runs_away(moment: float, way: int) -> None:
    """J w' = M from 1 rad/s on: five times the largest known speed, 1 rad/s, comes at (5 way - 1) J/M."""
    drive = Drive((Mass(2.0),), cycle=cycle(moment, speed=1.0))
    scenario = Scenario("loose", 600.0, speed=1.0, until_steady=True, standstill="pass")
    result = run(drive, scenario)
    assert result.end == "runaway"
    assert result.t[-1] == pytest.approx((5 * way - 1) * 2.0 / moment, rel=1e-12)
    assert result.omega[0, -1] == 5.0 * way
    (text,) = said(result, "runs away")
    assert text.startswith("warning: the machine runs away: without a motor its loads drive it")
    assert event(result, "runaway").time == result.t[-1]
    followed = run(drive, replace(scenario, duration=20.0, until_steady=False))
    assert followed.end == "time"
    assert not said(followed, "runs away")


def test_the_remedy_for_too_many_evaluations_fits() -> None:
    drive = Drive((Mass(2.0),), characteristic=MOTOR, cycle=cycle(lambda x: -3 - 2 * np.sin(x)))
    for free in (True, False):
        scenario = Scenario("long", 300.0, speed=9.0, until_steady=free)
        with pytest.raises(AccuracyError) as caught:
            run(drive, scenario, budget=50)
        assert caught.value.remedy.startswith("give the duration" if free else "a shorter duration")
        assert ("does not repeat itself yet" in str(caught.value)) == free
        assert ("of 300 s" in str(caught.value)) != free


def test_a_lagging_start_is_not_called_a_stall() -> None:
    drive = Drive((Mass(2.0),), characteristic=constant(50.0), cycle=cycle(-20.0), time_constant=0.1)
    result = run(drive, Scenario("start", 0.02))
    assert result.omega[0, -1] == 0.0
    assert result.end == "time"
    assert result.verdicts == ()


def test_speeds_are_those_of_the_motor_with_a_gear() -> None:
    """Break-down is judged on the motor's own shaft."""
    fast = Motor(lambda w: MOTOR.moment(w / 8) / 8, lambda w: MOTOR.slope(w / 8) / 64, 80.0, 76.0, 8 * MOTOR.critical)
    drive = Drive((Mass(1.0 / 64), Mass(1.0)), (Shaft(math.inf, ratio=8.0),), fast, cycle(-24.0, viscous=-6.0))
    (text,) = said(run(drive, Scenario("start", 20.0)), "break-down speed")
    assert f"{8 * MOTOR.critical:.6g} rad/s" in text
    assert not said(run(replace(drive, cycle=cycle(-5.0)), Scenario("start", 20.0)), "break-down speed")
