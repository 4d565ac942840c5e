"""The time-optimal law: worked numbers, integrals of the acceleration, and a brute-force optimum."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tmmcalc.core.errors import NoSolutionError, UsageError
from tmmcalc.core.timelaw import (
    TimeLaw,
    by_duration,
    by_travel,
    by_travel_and_duration,
    motion,
    phase_of,
    phase_times,
    time_at,
)

CASES = {case["id"]: case for case in json.loads((Path(__file__).parents[1] / "cases" / "kinematics.json").read_text())}
S10 = CASES["KIN-S10"]

positive = st.floats(1e-3, 1e3)
travels = st.floats(-1e3, 1e3).filter(lambda s: abs(s) > 1e-6)


@pytest.mark.parametrize("k", range(len(S10["inputs"]["cases"])))
def test_worked_numbers(k: int) -> None:
    asked, expected = S10["inputs"]["cases"][k], S10["expected"]["cases"][k]
    tolerance = S10["tolerance"]["abs"]
    law = by_travel(asked["S"], asked["v_max"], asked["a_max"])
    found = (law.ramp, law.uniform, law.duration, law.speed)
    assert found == pytest.approx([expected[key] for key in ("t1", "t2", "T", "v_peak")], abs=tolerance)
    rows = motion(law, np.array(asked["t"]))
    wanted = np.array([[r["s"], r["v"], r["a"]] for r in expected["rows"]])
    assert pytest.approx(wanted, abs=tolerance) == rows.T


def test_the_crane_of_the_textbook() -> None:
    law = by_duration(12.0, 0.2, 0.05)
    assert (law.ramp, law.uniform, law.ramp_travel, law.uniform_travel) == pytest.approx((4, 4, 0.4, 0.8), rel=1e-15)
    assert law.travel == pytest.approx(1.6, rel=1e-15)
    assert by_duration(12.0, 0.2, 0.05, -1).travel == -law.travel


@settings(max_examples=60, deadline=None)
@given(travels, positive, positive)
def test_speed_and_way_are_the_integrals_of_the_acceleration(travel: float, speed: float, acceleration: float) -> None:
    law = by_travel(travel, speed, acceleration)
    edges = np.array(law.instants)
    middle = (edges[1:] + edges[:-1]) / 2
    a = motion(law, middle)[2]
    v = np.concatenate(([0.0], np.cumsum(a * np.diff(edges))))
    s = np.concatenate(([0.0], np.cumsum((v[1:] + v[:-1]) / 2 * np.diff(edges))))
    found = motion(law, edges)
    rounding = 1e-15 * law.duration * acceleration  # of an instant, in speed
    assert found[1] == pytest.approx(v, abs=1e-12 * law.speed + rounding)
    assert found[0] == pytest.approx(s, abs=1e-12 * abs(travel) + rounding * law.duration)
    assert found[0, -1] == pytest.approx(travel, rel=1e-15)
    assert np.max(np.abs(v)) <= speed * (1 + 1e-12)


@settings(max_examples=60, deadline=None)
@given(travels, positive, positive)
def test_the_given_sets_agree(travel: float, speed: float, acceleration: float) -> None:
    law = by_travel(travel, speed, acceleration)
    back = by_duration(law.duration, speed, acceleration, 1 if travel > 0 else -1)
    assert back.travel == pytest.approx(travel, rel=1e-12)
    again = by_travel_and_duration(travel, law.duration * (1 + 1e-14), acceleration)
    assert again.duration == pytest.approx(law.duration, rel=1e-12)
    # at the least duration v_p is the double root of a quadratic: half of the digits are left
    assert again.speed == pytest.approx(law.speed, rel=1e-6)


@settings(max_examples=40, deadline=None)
@given(travels, positive, st.floats(1.001, 10.0))
def test_travel_and_duration_settle_the_speed(travel: float, acceleration: float, slack: float) -> None:
    duration = slack * 2 * math.sqrt(abs(travel) / acceleration)
    law = by_travel_and_duration(travel, duration, acceleration)
    assert law.duration == pytest.approx(duration, rel=1e-12)
    assert motion(law, np.array([law.duration]))[0, 0] == pytest.approx(travel, rel=1e-12)
    assert law.ramp_travel * 2 + law.uniform_travel == pytest.approx(abs(travel), rel=1e-11)
    # (2.65) solved for v_p in closed form
    root = acceleration * (duration - math.sqrt(duration**2 - 4 * abs(travel) / acceleration)) / 2
    assert law.speed == pytest.approx(root, rel=1e-9)


@pytest.mark.parametrize(("travel", "speed", "acceleration"), [(1.3, 0.4, 0.8), (0.1, 0.4, 0.8), (0.2, 0.4, 0.8)])
def test_no_motion_is_quicker(travel: float, speed: float, acceleration: float) -> None:
    """The farthest way within T, over all accelerations that are constant on equal steps: a linear programme."""
    from scipy.optimize import linprog

    law = by_travel(travel, speed, acceleration)
    steps = 240
    for duration, reaches in ((law.duration, True), (law.duration * 0.99, False)):
        h = duration / steps
        # v_k = h sum_{j<k} a_j; s = sum_j a_j h^2 (n - j - 1/2)
        weights = h * h * (steps - np.arange(steps) - 0.5)
        lower = np.tril(np.full((steps, steps), h))
        found = linprog(
            -weights,
            A_ub=lower,
            b_ub=np.full(steps, speed),
            A_eq=np.full((1, steps), h),
            b_eq=[0.0],
            bounds=(-acceleration, acceleration),
        )
        assert -found.fun <= by_duration(duration, speed, acceleration).travel * (1 + 1e-9)
        assert (-found.fun >= travel * (1 - 1e-3)) == reaches


@pytest.mark.parametrize("travel", [1.3, 0.1, -0.9])
def test_the_time_of_a_way_is_the_motion_read_back(travel: float) -> None:
    law = by_travel(travel, 0.4, 0.8)
    for part in np.linspace(0, 1, 41):
        t = time_at(law, float(part) * abs(travel))
        assert motion(law, np.array([t]))[0, 0] == pytest.approx(part * travel, abs=1e-14)


def test_one_sided_values_at_the_jumps() -> None:
    law = by_travel(-1.3, 0.4, 0.8)
    t = np.array(law.instants)
    assert motion(law, t, -1)[2].tolist() == [0.0, -0.8, 0.0, 0.8]
    assert motion(law, t, 1)[2].tolist() == [-0.8, 0.0, 0.8, 0.0]
    assert motion(law, t)[2].tolist() == [-0.8, 0.0, 0.8, 0.8]
    sides = np.array([1, -1, 1, -1])
    assert motion(law, t, sides)[2].tolist() == [-0.8, -0.8, 0.8, 0.8]
    assert phase_of(law, t, sides).tolist() == [1, 1, 3, 3]
    beside = np.array([-1.0, law.duration + 1])
    assert motion(law, beside).tolist() == [[0.0, -1.3], [0.0, 0.0], [0.0, 0.0]]


def test_instants_within_rounding_of_a_jump_are_the_jump() -> None:
    law = by_travel(1.0, 1 / 3, 0.7)
    t = np.array([law.ramp * (1 - 1e-15), law.ramp * (1 + 1e-15)])
    assert motion(law, t)[2].tolist() == [0.0, 0.0]
    assert motion(law, t, -1)[2].tolist() == [0.7, 0.7]


def test_no_travel_is_no_motion() -> None:
    law = by_travel(0.0, 0.4, 0.8)
    assert law.duration == 0
    assert law.instants == ()
    assert motion(law, np.zeros(2)).tolist() == [[0.0, 0.0]] * 3
    assert by_travel_and_duration(0.0, 3.0, 0.8).duration == 3.0


def test_a_travel_of_exactly_two_ramps_has_no_uniform_phase() -> None:
    law = by_travel(2 * 0.4**2 / 0.8 / 2, 0.4, 0.8)
    assert law.uniform == pytest.approx(0, abs=1e-15)
    assert len(law.instants) == 3


def test_many_travels_at_once() -> None:
    travel = np.array([[1.3, -0.1], [0.0, 20.0]])
    ramp, uniform, speed = phase_times(travel, np.array(0.4), np.array(0.8))
    for index in np.ndindex(travel.shape):
        law = by_travel(float(travel[index]), 0.4, 0.8)
        assert (ramp[index], uniform[index], speed[index]) == (law.ramp, law.uniform, law.speed)


@pytest.mark.parametrize("bad", [0.0, -1.0, math.inf, math.nan])
def test_limits_are_above_zero(bad: float) -> None:
    for wrong in (lambda: by_travel(1.0, bad, 1.0), lambda: by_travel(1.0, 1.0, bad), lambda: by_duration(bad, 1, 1)):
        with pytest.raises(UsageError, match="above zero"):
            wrong()


def test_a_travel_is_finite() -> None:
    with pytest.raises(UsageError, match="finite"):
        by_travel(math.nan, 1.0, 1.0)


def test_too_short_a_duration_names_the_least() -> None:
    with pytest.raises(NoSolutionError) as caught:
        by_travel_and_duration(1.6, 11.0, 0.05)
    assert caught.value.limit == pytest.approx(2 * math.sqrt(32), rel=1e-12)
    with pytest.raises(NoSolutionError, match=r"above the limit 0\.15"):
        by_travel_and_duration(1.6, 12.0, 0.05, 0.15)


def test_a_law_is_a_record() -> None:
    assert by_travel(1.3, 0.4, 0.8) == TimeLaw(1.3, 0.4, 0.8, 0.5, 2.75)
