"""Events: exact times, levels touched within a step, several at once, jumps landed on."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from sparing import sparing

from machine.transient.scenes import at, constant, cycle, event, run
from tmmcalc.machine.transient.events import Watch, extreme, hits, level
from tmmcalc.machine.transient.model import Drive, Mass
from tmmcalc.machine.transient.scenario import LoadStep, Scenario


class Path:
    """A stepper that has just gone from 0 to 1 along a known path."""

    def __init__(self, path: Any, slope: Any) -> None:
        self.to = lambda t: [path(t)]
        self.t0, self.t = 0.0, 1.0
        self.y0, self.y = [path(0.0)], [path(1.0)]
        self.rate0, self.rate = [slope(0.0)], [slope(1.0)]


PATHS = [
    ("straight", lambda t: 2 * t - 0.6, lambda t: 2.0, 1.0, [0.3]),
    ("falling", lambda t: 0.6 - 2 * t, lambda t: -2.0, -1.0, [0.3]),
    ("curved", lambda t: math.exp(5 * t) - 3, lambda t: 5 * math.exp(5 * t), 1.0, [math.log(3) / 5]),
    ("flat", lambda t: (t - 0.3) ** 5, lambda t: 5 * (t - 0.3) ** 4, 1.0, [0.3]),
    ("touch", lambda t: 0.01 - (t - 0.4) ** 2, lambda t: -2 * (t - 0.4), 1.0, [0.3]),
    ("miss", lambda t: -0.01 - (t - 0.4) ** 2, lambda t: -2 * (t - 0.4), 1.0, []),
    ("wrong way", lambda t: 0.6 - 2 * t, lambda t: -2.0, 1.0, []),
    ("at the start", lambda t: t, lambda t: 1.0, 1.0, []),
    ("there and back", lambda t: t * (t - 0.7), lambda t: 2 * t - 0.7, 1.0, [0.7]),
    ("at the end", lambda t: t - 1.0, lambda t: 1.0, 1.0, [1.0]),
]


@pytest.mark.parametrize(("name", "path", "slope", "way", "times"), PATHS, ids=[p[0] for p in PATHS])
def test_levels_on_known_paths(name: str, path: Any, slope: Any, way: float, times: list[float]) -> None:
    stepper: Any = Path(path, slope)
    found = hits([level("it", 0, 0.0, way)], stepper)
    tolerance = 1e-3 if name == "flat" else 1e-15 * 8
    assert [hit.t for hit in found] == pytest.approx(times, abs=tolerance)
    if name not in ("touch", "miss", "there and back"):
        other: Any = Path(path, slope)
        assert [h.t for h in hits([Watch("it", lambda y: way * y[0])], other)] == pytest.approx(times, abs=tolerance)


def test_events_of_one_step_in_order_up_to_the_first_that_halts() -> None:
    stepper: Any = Path(lambda t: 10 * t, lambda t: 10.0)
    watches = [
        level("late", 0, 9.0, 1.0),
        level("halt", 0, 5.0, 1.0),
        level("same", 0, 5.0, 1.0),
        level("after", 0, 6.0, 1.0, halts=False),
        level("early", 0, 2.0, 1.0, halts=False),
    ]
    assert [hit.watch.kind for hit in hits(watches, stepper)] == ["early", "halt", "same"]


def test_an_extreme_within_a_step() -> None:
    stepper: Any = Path(lambda t: t - 2 * t * t, lambda t: 1 - 4 * t)
    found = extreme(stepper, lambda t, _: (1 - 4 * t,), 0)
    assert found is not None
    assert found[0].t == pytest.approx(0.25, abs=1e-15)
    assert found[0].value == pytest.approx(0.125, abs=1e-15)
    straight: Any = Path(lambda t: t, lambda t: 1.0)
    assert extreme(straight, lambda _, y: (1.0,), 0) is None


def steps_of_load(p: np.ndarray) -> np.ndarray:
    return np.select([p < 1.0, p < 2.5, p < 4.0], [-5.0, -50.0, 20.0], -8.0)


@pytest.mark.parametrize("method", ["merson", "collocation", "RK45", "DOP853", "LSODA", "Radau", "BDF"])
def test_piecewise_constant_loads_are_followed_exactly(method: str) -> None:
    """Between its jumps the crank moves uniformly accelerated: w^2 = w_a^2 + 2 M (theta - a)/J."""
    drive = Drive((Mass(2.0),), cycle=cycle(steps_of_load, 0.0, (1.0, 2.5, 4.0)))
    result = run(drive, Scenario("jumps", 9.0, speed=9.0, end_angle=2 * math.pi), method)
    edges, moments = [0.0, 1.0, 2.5, 4.0, 2 * math.pi], [-5.0, -50.0, 20.0, -8.0]
    w, t = 9.0, 0.0
    for a, b, m in zip(edges, edges[1:], moments, strict=False):
        inside = (result.theta[0] > a) & (result.theta[0] < b)
        bound = 1e-6 if method == "BDF" else 1e-8
        exact = np.sqrt(w * w + m * (result.theta[0, inside] - a))
        np.testing.assert_allclose(result.omega[0, inside], exact, atol=bound)
        after = math.sqrt(w * w + m * (b - a))
        t += 2 * (b - a) / (w + after)
        w = after
        row = int(np.argmin(np.abs(result.theta[0] - b)))
        assert result.theta[0, row] == pytest.approx(b, abs=4e-16 * 8)
        assert result.t[row] == pytest.approx(t, abs=bound)
    assert result.imbalance < bound


def test_merson_is_exact_for_uniform_acceleration_between_jumps() -> None:
    """Every jump costs a landing of a few steps, no crawling up to it."""
    drive = Drive((Mass(2.0),), cycle=cycle(steps_of_load, 0.0, (1.0, 2.5, 4.0)))
    result = run(drive, Scenario("jumps", 90.0, speed=9.0, end_angle=2 * math.pi))
    assert result.counters["rejected"] < 4
    assert result.counters["steps"] < 40
    w2 = 81.0 - 5 * 1.0 - 50 * 1.5 + 20 * 1.5 - 8 * (2 * math.pi - 4)
    assert result.omega[0, -1] == pytest.approx(math.sqrt(w2), abs=1e-13)
    assert result.imbalance < 1e-14


def test_targets_up_and_down() -> None:
    drive = Drive((Mass(2.0),), characteristic=constant(8.0), cycle=cycle(-20.0))
    steps = (LoadStep(0.0), LoadStep(1.0, time=1.0))
    up = run(drive, Scenario("up", 3.0, load=steps, targets=(1.0, 3.5, 9.0)))
    seen = [(e.speed, e.time) for e in up.events if e.kind == "target"]
    np.testing.assert_allclose(seen, [(1.0, 0.25), (3.5, 0.875)], atol=1e-12)
    assert any("does not reach 9 rad/s" in str(verdict) for verdict in up.verdicts)
    down = run(Drive((Mass(2.0),), cycle=cycle(-20.0)), Scenario("down", 3.0, speed=6.0, targets=(4.0,), end_speed=1.0))
    assert event(down, "target").time == pytest.approx(0.2, abs=1e-12)
    assert down.end == "speed"
    assert (down.t[-1], down.omega[0, -1]) == pytest.approx((0.5, 1.0), abs=1e-12)
    assert down.verdicts == ()


def test_a_speed_that_is_only_just_touched() -> None:
    """w = 2 + 1.0 sin t peaks at 3 within long steps: 2.9999 is seen, 3.0001 is not."""
    drive = Drive((Mass(1.0),), cycle=cycle(lambda p: np.sin(p)))
    peak = float(run(drive, Scenario("turning", 3.0, speed=1.0), tolerance=1e-12).turning[2].max())
    seen = run(drive, Scenario("turning", 3.0, speed=1.0, targets=(peak - 1e-7, peak + 1e-7)))
    assert [e.speed for e in seen.events] == pytest.approx([peak - 1e-7], abs=1e-12)
    assert peak == pytest.approx(math.sqrt(5), abs=1e-10)  # w^2/2 - cos: from (0, 1) to the angle 180 degrees


def test_load_steps_follow_each_other() -> None:
    drive = Drive((Mass(2.0),), characteristic=constant(8.0), cycle=cycle(-1.0))
    steps = (LoadStep(0.0), LoadStep(2.0, speed=2.0), LoadStep(4.0, time=0.1), LoadStep(1.0, time=1.5))
    result = run(drive, Scenario("steps", 2.0, load=steps))
    loads = [(e.time, e.message) for e in result.events if e.kind == "load"]
    # the step of 0.1 s waits for the one before it
    assert [t for t, _ in loads] == pytest.approx([0.5, 0.5, 1.5], abs=1e-12)
    assert loads[1][1] == "load factor 4"
    w = 2.0 + (8 - 4) / 2 * 1.0 + (8 - 1) / 2 * 0.5
    assert result.omega[0, -1] == pytest.approx(w, abs=1e-12)


@sparing("method", ["merson", "collocation", "DOP853", "LSODA", "Radau"], every=3)
def test_instants_are_rows_of_their_own(method: str) -> None:
    drive = Drive((Mass(1.0),), cycle=cycle(lambda p: -6 * np.sin(p)))
    times = np.array([0.0, 0.1, 1 / 3, 0.7, 1.0])
    result = run(drive, Scenario("swing", 1.0, speed=5.0), method, times)
    assert np.all(np.diff(result.t) > 0)
    rows = at(result, times)
    energy = result.omega[0, rows] ** 2 / 2 - 6 * np.cos(result.theta[0, rows])
    np.testing.assert_allclose(energy, 12.5 - 6, atol=1e-6 if method == "LSODA" else 1e-8)
    free = run(drive, Scenario("swing", 1.0, speed=5.0), method)
    assert free.omega[0, -1] == result.omega[0, -1]


def test_motor_and_brake_are_switched_exactly() -> None:
    drive = Drive((Mass(2.0),), characteristic=constant(8.0))
    result = run(drive, Scenario("on and off", 3.0, motor=((0.25, 1.0), (1.5, 2.0))))
    assert [(e.kind, e.time) for e in result.events] == [
        ("motor on", 0.25),
        ("motor off", 1.0),
        ("motor on", 1.5),
        ("motor off", 2.0),
    ]
    assert result.omega[0, -1] == pytest.approx(4 * 1.25, abs=1e-12)
    assert result.motor_work[-1] == pytest.approx(25.0, abs=1e-11)
    row = int(np.searchsorted(result.t, 1.0))
    assert (result.motor_moment[row - 1], result.motor_moment[row]) == (8.0, 0.0)  # after the switching
