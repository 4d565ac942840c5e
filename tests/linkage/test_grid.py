"""Positions and their labels: equal steps, two strokes, extra positions, either direction, any number."""

from __future__ import annotations

import math

import numpy as np
import pytest
from sparing import sparing

from linkage.scenes import (
    crank_slider,
    driven_rod,
    full_turn,
    part,
    shaper,
    slotted,
    with_grid,
    with_input,
    with_output,
)
from tmmcalc import Kinematics, NoSolutionError, solve_kinematics

TURN = 2 * math.pi


@sparing("positions", [4, 24, 360, 100_000], every=4)
@pytest.mark.parametrize("speed", [1e-6, 1.0, -1e6])
def test_equal_steps_close_the_turn(positions: int, speed: float) -> None:
    result = solve_kinematics(with_input(full_turn(crank_slider(0.1, 0.3), 0.4, positions), speed=speed))
    sense = math.copysign(1, speed)
    assert len(result.x) == positions + 1
    np.testing.assert_allclose(result.phi, sense * TURN * np.arange(positions + 1) / positions, rtol=1e-15)
    assert result.labels == tuple(map(str, range(positions + 1)))
    np.testing.assert_allclose(result.trace.r[:, -1], result.trace.r[:, 0], atol=1e-15)
    assert not np.signbit(result.phi[0])
    check_finite(result)


def check_finite(result: Kinematics) -> None:
    """No NaN and no infinity in any array of a result."""
    t = result.trace
    for values in (t.r, t.dr, t.ddr, t.angle, t.dangle, t.ddangle, t.s, t.ds, t.dds):
        assert np.all(np.isfinite(values))
        assert np.all(np.isfinite(result.in_time(values, values)))
    for values in (result.s, result.ds, result.dds, result.x, result.phi):
        assert np.all(np.isfinite(values))


def test_extra_positions_are_labelled_after_the_position_before_them() -> None:
    mechanism = with_grid(full_turn(crank_slider(0.1, 0.3), positions=4), extra=(2.0, 1.8, 0.1, 6.0))
    result = solve_kinematics(mechanism)
    assert result.labels == ("0", "0'", "1", "1'", "1''", "2", "3", "3'", "4")
    assert np.all(np.diff(result.phi) > 0)


def test_an_extra_position_on_a_position_is_not_repeated() -> None:
    step = TURN / 12
    nearly = (3 * step, 5 * step * (1 + 1e-12), 0.0, TURN, 0.7, 0.7 + 1e-9, 0.7)
    result = solve_kinematics(with_grid(full_turn(crank_slider(0.1, 0.3), positions=12), extra=nearly))
    assert result.labels == ("0", "1", "1'", *map(str, range(2, 13)))


@pytest.mark.parametrize("speed", [1.0, -1.0])
def test_extremes_are_added_once(speed: float) -> None:
    """Dead centres at 0 and 180 degrees are positions 0 and 12; of an offset slider both are added, or only one."""
    inline = with_grid(with_input(crank_slider(0.1, 0.3), speed=speed), extremes=True)
    assert len(solve_kinematics(inline).x) == 25
    offset = with_grid(with_input(crank_slider(0.1, 0.3, 0.04), speed=speed), extremes=True)
    result = solve_kinematics(offset)
    assert len(result.x) == 27
    assert np.count_nonzero(np.abs(result.ds[0]) < 1e-13) == 2
    started = solve_kinematics(with_input(offset, start=None))
    assert len(started.x) == 26
    again = solve_kinematics(with_grid(with_input(offset, start=None), extra=(round(abs(float(started.phi[13])), 9),)))
    assert len(again.x) == 26


@pytest.mark.parametrize("speed", [1.0, -1.0])
@pytest.mark.parametrize("start", [None, 0.3])
def test_working_and_idle_steps(speed: float, start: float | None) -> None:
    """The working stroke is divided by itself, the idle one likewise; position 0 may stand elsewhere."""
    mechanism = with_grid(with_input(shaper(), speed=speed, start=start), working=6, idle=4)
    result = solve_kinematics(mechanism)
    working = math.pi + 2 * math.asin(0.2 / 0.62)
    steps = np.abs(np.diff(result.phi))
    np.testing.assert_allclose(steps[:6], working / 6, rtol=1e-12)
    np.testing.assert_allclose(steps[6:], (TURN - working) / 4, rtol=1e-12)
    assert result.labels == tuple(map(str, range(11)))


def test_working_and_idle_steps_need_two_dead_centres() -> None:
    with pytest.raises(NoSolutionError, match="exactly two dead centres") as refused:
        solve_kinematics(with_grid(slotted(0.1, 0.25), working=6, idle=4))
    assert "use grid.positions" in str(refused.value)


def test_a_span_of_several_turns() -> None:
    result = solve_kinematics(with_grid(full_turn(slotted(0.1, 0.25)), span=3 * TURN, positions=6))
    angle = result.trace.angle[result.trace.link_ids.index(3)]
    assert angle[-1] - angle[0] == pytest.approx(3 * TURN, abs=1e-12)
    assert np.all(np.diff(angle) > 0)


def test_a_negative_span_goes_against_the_motion() -> None:
    forward = solve_kinematics(part(crank_slider(0.1, 0.3), 0.2, 1.2))
    back = solve_kinematics(with_grid(with_input(crank_slider(0.1, 0.3), start=1.2), span=-1.0))
    np.testing.assert_allclose(back.x[::-1], forward.x, rtol=1e-15)
    np.testing.assert_allclose(back.trace.ddr[:, ::-1], forward.trace.ddr, rtol=1e-12)
    assert back.labels == forward.labels
    driven = solve_kinematics(with_grid(driven_rod(1.0, 0.2, -0.5), extra=(-0.3,)))
    assert driven.phi[-1] == -0.5
    assert "7'" in driven.labels


def test_extra_positions_beyond_a_whole_turn_are_taken_within_it() -> None:
    result = solve_kinematics(with_grid(full_turn(slotted(0.1, 0.25), positions=4), extra=(-0.2, TURN + 0.2)))
    assert result.labels == ("0", "0'", "1", "2", "3", "3'", "4")
    assert result.phi[1] == pytest.approx(0.2)
    assert result.phi[-2] == pytest.approx(TURN - 0.2)


@pytest.mark.parametrize("d", [1e-2, 1e-3, 1e-4, 1e-5, 4e-6])
@pytest.mark.parametrize("positions", [4, 24, 1000])
@sparing("off", [0.0, 0.1, 0.25, 0.4999, -0.25, -0.499, 45.0, 100.0], every=5)
def test_a_link_that_turns_fast_between_two_positions(d: float, positions: int, off: float) -> None:
    """l1 just above l0: half a turn within d radians, wherever position 0 stands; in all exactly one turn."""
    mechanism = full_turn(slotted(0.1, 0.1 * (1 + d)), math.radians(270 + off), positions)
    result = solve_kinematics(mechanism)
    angle = result.trace.angle[result.trace.link_ids.index(3)]
    assert angle[-1] - angle[0] == pytest.approx(TURN, abs=1e-6)
    assert np.all(np.diff(angle) > 0)


@pytest.mark.parametrize("d", [1e-2, 1e-3, 1e-4, 1e-5])
@sparing("off", [0.0, 0.25, 0.4999, -0.25, 60.0], every=5)
def test_a_link_that_swings_back_fast_returns(d: float, off: float) -> None:
    """l1 just below l0: the link rocks, and comes back in one short sweep."""
    result = solve_kinematics(full_turn(slotted(0.1, 0.1 * (1 - d)), math.radians(270 + off), 5))
    angle = result.trace.angle[result.trace.link_ids.index(3)]
    assert angle[-1] == pytest.approx(angle[0], abs=1e-6)
    assert np.ptp(angle) < math.pi


@pytest.mark.parametrize("size", [1e-6, 1e3])
@pytest.mark.parametrize("speed", [1e-6, -1e6])
def test_extreme_sizes_and_speeds(size: float, speed: float) -> None:
    """Transfer functions per size are those of the plain scene; times only multiply."""
    from transforms import scaled

    plain = solve_kinematics(shaper(positions=36))
    result = solve_kinematics(with_input(scaled(shaper(positions=36), size), speed=math.copysign(1.0, speed)))
    fast = solve_kinematics(with_input(scaled(shaper(positions=36), size), speed=speed))
    assert fast.labels == plain.labels
    np.testing.assert_array_equal(fast.trace.ddr, result.trace.ddr)
    np.testing.assert_allclose(fast.summaries[0].stroke, plain.summaries[0].stroke * size, rtol=1e-12)
    v, _ = fast.in_time(fast.ds, fast.dds)
    assert np.max(np.abs(v)) <= max(abs(e.value) for e in fast.summaries[0].velocity) * (1 + 1e-12)
    check_finite(fast)


def test_the_output_counts_from_position_0() -> None:
    result = solve_kinematics(with_output(part(crank_slider(0.1, 0.3), 0.5, 1.5), point="B"))
    x_b = result.trace.r[result.trace.point_names.index("B")].real
    np.testing.assert_allclose(result.s[0], x_b - x_b[0], atol=1e-16)
