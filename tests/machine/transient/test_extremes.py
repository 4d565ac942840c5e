"""The largest moments are those of the motion between the steps too, within what is told; of closed solutions."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from sparing import sparing

from machine.transient.scenes import constant, cycle, kloss, line, run
from tmmcalc.machine.transient import extremes
from tmmcalc.machine.transient.extremes import Found
from tmmcalc.machine.transient.model import Drive, Mass, Shaft
from tmmcalc.machine.transient.results import Transient
from tmmcalc.machine.transient.scenario import Scenario
from tmmcalc.machine.transient.simulate import _gap
from tmmcalc.machine.transient.turning import Point, turnings

ROUNDING = 1e-14
WAYS = [
    *(("merson", {"tolerance": tolerance}) for tolerance in (1e-11, 1e-9, 1e-7, 1e-5)),
    *(("collocation", {"tolerance": tolerance}) for tolerance in (1e-10, 1e-8, 1e-6)),
    *(("DOP853", {"tolerance": tolerance}) for tolerance in (1e-12, 1e-10, 1e-7)),
    *((name, {}) for name in ("auto", "RK45", "LSODA", "Radau", "BDF")),
    *((name, {"step": step}) for name in ("merson", "rk4") for step in (0.02, 0.007, 0.002)),
]
KINDS = [f"{name}-{next(iter(more.values()), '')}" for name, more in WAYS]


def held(found: Transient, *moments: float) -> None:
    """The largest moments of shafts and motor miss the exact ones by no more than is told, and no row exceeds them."""
    missed = np.abs(np.abs(found.largest_moment[0]) / np.array(moments) - 1)
    assert missed.max() <= found.extremes_error + ROUNDING
    rows = np.vstack((found.shaft_moment, found.motor_moment))
    assert np.all(np.abs(rows).max(axis=1) <= np.abs(found.largest_moment[0]))


@sparing(("name", "more"), WAYS, ids=KINDS, every=7)
def test_a_step_of_the_moment_doubles_the_moment_of_the_shaft(name: str, more: dict[str, Any]) -> None:
    """T = M J_2/(J_1 + J_2) (1 - cos w t), w^2 = c (J_1 + J_2)/(J_1 J_2): at most twice the moment of rigid motion."""
    drive = Drive((Mass(2.0), Mass(3.0)), (Shaft(3000.0),), constant(75.0))
    found = run(drive, Scenario("step", 0.5), name, **more)
    held(found, 90.0, 75.0)
    turns = found.largest_moment[1, 0] * 50 / math.pi  # the peaks of w = 50 1/s are at odd multiples of pi
    assert turns % 2 == pytest.approx(1.0, abs=0.02)


@sparing(("name", "more"), WAYS, ids=KINDS, every=7)
def test_a_damped_shaft(name: str, more: dict[str, Any]) -> None:
    """T = T_0 (1 - e^(-d t) (cos v t - d/v sin v t)), T = c phi + k phi'; its first peak where tan v t tells."""
    c, k, m = 3000.0, 18.0, 1.2
    drive = Drive((Mass(2.0), Mass(3.0)), (Shaft(c, k),), constant(75.0))
    found = run(drive, Scenario("step", 0.4), name, **more)
    d = k / (2 * m)
    v = math.sqrt(c / m - d * d)
    # T' = 0 of T = T_0 (1 - e^(-d t) (cos v t - (d/v) sin v t)): (2 d v) cos v t + (v^2 - d^2) sin v t = 0
    t = (math.pi - math.atan2(2 * d * v, v * v - d * d)) / v
    held(found, 45 * (1 - math.exp(-d * t) * (math.cos(v * t) - d / v * math.sin(v * t))), 75.0)


@pytest.mark.parametrize(("name", "more"), WAYS, ids=KINDS)
def test_a_start_under_a_constant_moment(name: str, more: dict[str, Any]) -> None:
    held(run(Drive((Mass(4.0),), characteristic=constant(10.0)), Scenario("start", 2.0), name, **more), 10.0)


@sparing(("name", "more"), WAYS, ids=KINDS, every=7)
def test_the_pull_out_moment_is_met_between_the_steps(name: str, more: dict[str, Any]) -> None:
    drive = Drive((Mass(1.0),), characteristic=kloss(100.0, 0.2, 50.0, 45.0), cycle=cycle(-20.0, speed=45.0))
    held(run(drive, Scenario("start", 1.2), name, **more), 100.0)


@sparing(("name", "more"), WAYS, ids=KINDS, every=7)
def test_a_lagging_moment(name: str, more: dict[str, Any]) -> None:
    """J w' = M, tau M' = b (w_s - w) - M: M = b w_s/(tau v) e^(-t/2 tau) sin v t, v^2 = b/(J tau) - 1/(2 tau)^2."""
    b, tau, synchronous = 8.0, 0.1, 20.0
    found = run(Drive((Mass(1.0),), (), line(b, synchronous), None, None, tau), Scenario("on", 1.0), name, **more)
    d = 1 / (2 * tau)
    v = math.sqrt(b / tau - d * d)
    t = math.atan2(v, d) / v
    held(found, b * synchronous / (tau * v) * math.exp(-d * t) * math.sin(v * t))


@pytest.mark.slow
def test_the_largest_moment_of_a_motor_that_swings() -> None:
    """w = w_0 - e sin(theta) nearly, so that the moment is largest at the slowest place, between the rows."""
    drive = Drive((Mass(20.0),), characteristic=line(2.0, 20.0), cycle=cycle(lambda p: 40 * np.cos(p), speed=10.0))
    found = run(drive, Scenario("swings", 2.0, speed=19.0), "DOP853")
    slowest = min(float(found.omega.min()), float(found.turning[2].min()))
    fine = run(drive, Scenario("swings", 2.0, speed=19.0), "merson", np.linspace(0, 2, 4001)[1:], tolerance=1e-13)
    held(found, float(fine.largest_moment[0, 0]))
    assert found.largest_moment[0, 0] == pytest.approx(2 * (20 - slowest), rel=1e-9)
    assert float(fine.motor_moment.max()) == pytest.approx(float(found.largest_moment[0, 0]), rel=1e-6)


@pytest.mark.parametrize("asked", [0.0, 1e-3, 1e-6, 1e-9])
def test_a_rigid_shaft(asked: float) -> None:
    """M = M_d - J_1 alpha, 4 alpha = M_d - 20 cos theta, of a constant M_d: at theta = pi 2.5, at 2 pi 12.5 N*m."""
    drive = Drive(
        (Mass(1.0), Mass(3.0)), (Shaft(math.inf),), constant(10.0), cycle(lambda p: -20 * np.cos(p), speed=9.0)
    )
    found = run(drive, Scenario("turns", 2.0, speed=9.0, angle=1.0), error=asked)
    held(found, 12.5, 10.0)
    assert found.extremes_error <= (asked or 1e-7)


@pytest.mark.parametrize("off", [0.05, 0.12])
def test_steps_that_cannot_be_made_again(off: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a lagging moment b w_s (1 - e^(-t/tau)) nearly that is cut off as it rises: what may be missed is told."""
    drive = Drive((Mass(1e4),), (), line(8.0, 20.0), None, None, 0.1)
    scenario = Scenario("cut", 0.2, motor=((0.0, off),))
    exact = run(drive, scenario).largest_moment[0, 0]
    assert exact == pytest.approx(160 * (1 - math.exp(-off / 0.1)), rel=1e-3)
    monkeypatch.setattr(extremes, "_again", lambda *_: None)
    found = run(drive, scenario)
    assert 0 < found.largest_moment[0, 0] <= exact
    assert 1 - found.largest_moment[0, 0] / exact <= found.extremes_error < 1.5


def test_a_moment_that_is_not_found_is_missed_wholly() -> None:
    assert _gap([Found(0.0, 0.0, 1.0), Found(2.0, 0.0, 0.5), Found()]) == 1.0
    assert _gap([Found(-2.0, 0.0, 0.5), Found()]) == 0.25


def test_cubics_that_turn_back() -> None:
    """Of (s - 1/4)(s - 3/4) as a slope both roots, of s^3 + s none, of s^2 its vertex beyond the step none."""

    def cubic(s: float) -> Point:
        return Point(s, s**3 / 3 - s**2 / 2 + 3 * s / 16, s * s - s + 3 / 16)

    assert sorted(t for t, _ in turnings(cubic(0.0), cubic(1.0))) == pytest.approx([0.25, 0.75], abs=1e-14)
    for t, value in turnings(cubic(0.0), cubic(1.0)):
        assert value == pytest.approx(cubic(t).value, abs=1e-15)
    assert turnings(Point(0.0, 0.0, 1.0), Point(1.0, 2.0, 4.0)) == []
    assert turnings(Point(0.0, 0.0, 0.0), Point(1.0, 1.0, 2.0)) == []
