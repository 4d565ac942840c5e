"""The optimum against the strength stage: a roller that is barely pressed, a cam whose speed varies."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from sparing import sparing

from cams.optimum_scene import roller_task
from tmmcalc.cams.follower import Follower
from tmmcalc.cams.optimum.margins import NUMBERS, judge
from tmmcalc.cams.optimum.options import with_law
from tmmcalc.cams.optimum.scene import scene_of
from tmmcalc.cams.optimum.slipbounds import may_roll
from tmmcalc.cams.optimum.solve import solve_optimum
from tmmcalc.cams.speed import Speed
from tmmcalc.cams.strength.solve import solve_strength
from tmmcalc.cams.task import CamTask, Spring
from tmmcalc.core.numerics.panels import panels

SIZES = Follower("translating", 0.14, 0.004, 0.014)


def uneven(task: CamTask, part: float = 0.2) -> CamTask:
    """The task at 100 rad/s on average, with a wave of this part on it."""
    on = panels(0.0, 2 * np.pi)
    omega = 100 * (1 + part * np.cos(on.x))
    return replace(task, turning=Speed(on, omega, -omega * 100 * part * np.sin(on.x)))


@sparing("law", ["const", "sine", "shun", "linear"], every=4)
@pytest.mark.parametrize("least", [1e-3, 0.1, 5.0])
def test_slip_of_a_roller_that_is_barely_pressed(law: str, least: float) -> None:
    """The spring leaves ``least`` of some hundred newtons where the follower brakes most."""
    task = with_law(roller_task(spring=Spring("preload", least=least), guide=0.24), law)
    judged = next(each for each in solve_strength(task, SIZES).margins if each.name == "no slip")
    found = judge(scene_of(task, SIZES), np.array([0.14]), np.array([0.014]), np.array([0.24]))
    assert judged.value is not None
    assert found.slip[0] == pytest.approx(judged.value, rel=1e-7)


@pytest.mark.slow
def test_all_margins_at_the_speed_of_the_machine() -> None:
    task = uneven(with_law(roller_task(spring=Spring("safety", safety=1.5), guide=0.24), "sine"))
    scene = scene_of(task, SIZES)
    found = judge(scene, np.array([0.14]), np.array([0.014]), np.array([0.24]))
    strength = {each.name: each for each in solve_strength(task, SIZES).margins}
    even = {each.name: each for each in solve_strength(replace(task, turning=None), SIZES).margins}
    names = {2: "no slip", 5: "roller unit", 6: "clearance of the shaft", 9: "contact stress"}
    for number, name in names.items():
        assert found.margin[NUMBERS.index(number), 0] == pytest.approx(strength[name].margin, abs=1e-8)
    assert strength["no slip"].value != pytest.approx(even["no slip"].value, rel=1e-2)
    assert any("turns with the crank" in note for note in solve_optimum(task, Follower("translating", 0.06)).notes)


def test_what_is_taken_out_for_slip_at_a_varying_speed_slips() -> None:
    """At every height between the two that are asked for, by the margins."""
    task = uneven(roller_task(spring=Spring("safety", safety=1.2)), 0.3)
    scene = scene_of(task, Follower("translating", 0.06))
    start, roller = (each.ravel() for each in np.meshgrid(np.linspace(0.04, 0.1, 13), np.linspace(0.004, 0.03, 14)))
    low, high = start + roller + 0.03, start + roller + 0.09
    rolls = may_roll(scene, start, roller, low, high)
    assert not rolls.all()
    for part in np.linspace(0, 1, 9):
        found = judge(scene, start, roller, low + part * (high - low))
        assert np.all(found.margin[0][~rolls] < 0)
