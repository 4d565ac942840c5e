"""From which inertia on a tied load slips, its ties slacken and yield, it tips: by the forces on both sides of it."""

from __future__ import annotations

from dataclasses import replace
from math import cos, radians, sin

import numpy as np
import pytest

from tmmcalc.core.errors import NoSolutionError
from tmmcalc.extras.tie_down import Support, TieDown, TieDownTask, solve_tie_down

TASK = TieDownTask(5e4, 0.5, radians(30), radians(10), 0.4, preload=8e3, section=1e-4, strength=240e6)
CASE = TieDownTask(  # of the source
    70_630.0, 1.0, radians(50), radians(15), 0.5, preload=8050.0,
    support=Support(3435.0, 0.2, 15.25, 3.1, 12.15, 3.0),
)  # fmt: skip
TASKS = [TASK, CASE, replace(TASK, preload=0.0), replace(TASK, preload=2e4), replace(CASE, section=1e-4, strength=1e8)]


def at(task: TieDownTask, k: float | None) -> TieDown:
    assert k is not None
    return solve_tie_down(replace(task, factor=k))


@pytest.mark.parametrize("task", TASKS)
def test_what_holds_the_load_changes_at_the_thresholds(task: TieDownTask) -> None:
    found = solve_tie_down(task).thresholds
    assert found.slip is not None
    assert found.slack is not None
    assert at(task, found.slip * (1 - 1e-9)).held == "friction"
    assert at(task, found.slip * (1 + 1e-9)).held == ("all ties" if task.preload else "two ties")
    assert at(task, found.slack * (1 + 1e-9)).held == "two ties"
    for k, multiple in ((found.slack, 2), (found.slip, 1)):
        assert at(task, k).balanced == pytest.approx(multiple * task.preload, abs=1e-6)


@pytest.mark.parametrize("task", TASKS)
def test_thresholds_of_the_source_are_those_of_its_forces(task: TieDownTask) -> None:
    found = solve_tie_down(task).thresholds
    assert found.source_slip is not None
    if task.preload:
        assert at(task, found.source_slip * (1 - 1e-6)).force == task.preload
        assert at(task, found.source_slip * (1 + 1e-6)).force > task.preload
        assert at(task, found.source_slack).force == pytest.approx(2 * task.preload)
    else:
        assert found.source_slip == found.source_slack == found.slip


def test_thresholds_by_hand() -> None:
    """F = k G2, G = G2 + 4 P0 sin alpha."""
    found = solve_tie_down(TASK).thresholds
    press, along = 5e4 + 4 * 8e3 * 0.5, cos(radians(30)) * cos(radians(10))
    assert found.slip == pytest.approx(0.4 * press / 5e4)
    assert found.slack == pytest.approx((0.4 * press + 4 * along * 8e3) / 5e4)
    assert found.yielding == pytest.approx((0.4 * (5e4 + 2 * 24e3 * 0.5) + 2 * 24e3 * along) / 5e4)  # two ties at 24 kN
    assert found.tipping is None


@pytest.mark.parametrize("strength", [90e6, 150e6, 400e6])  # P0 makes 80 MPa; all ties or two of them hold
def test_a_tie_yields_at_its_threshold(strength: float) -> None:
    task = replace(TASK, strength=strength)
    found = at(task, solve_tie_down(task).thresholds.yielding)
    assert found.stress == pytest.approx(strength)
    assert found.safety == pytest.approx(1)


def test_ties_that_yield_are_a_warning() -> None:
    found = solve_tie_down(replace(TASK, strength=70e6))
    assert found.thresholds.yielding == 0.0
    assert any(note.startswith("warning: the ties yield") for note in found.notes)


def test_the_load_of_the_source_leaves_its_cradle() -> None:
    tipping = solve_tie_down(CASE).thresholds.tipping
    assert tipping is not None
    # G2 a/L - k G2 D/(2 L) + 4 P0 sin alpha = 0
    hand = (70_630 * 12.15 + 4 * 8050 * sin(radians(50)) * 15.25) / (70_630 * 1.5)
    assert tipping == pytest.approx(hand)
    at(CASE, tipping * (1 - 1e-9))
    with pytest.raises(NoSolutionError, match="leaves its cradle"):
        at(CASE, tipping * (1 + 1e-9))


def test_the_table_is_that_of_single_loads() -> None:
    found = solve_tie_down(CASE)
    for k in (0, 30, 70, len(found.k) - 1):
        one = at(CASE, float(found.k[k]))
        assert (one.force, one.balanced) == pytest.approx((found.forces[k], found.balance[k]))
        low = {"friction": CASE.preload, "all ties": 2 * CASE.preload - one.balanced, "two ties": 0.0}[one.held]
        assert found.slackening[k] == pytest.approx(low, abs=1e-9)
    assert np.all(np.diff(found.k) > 0)
