"""The cycle of a crank turned back against the reduction of the same linkage with the opposite input speed."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from linkage.scenes import crank_slider, full_turn, with_input

from tmmcalc import NoSolutionError, solve_kinematics
from tmmcalc.linkage.loading import Body, Load, Loading, Pair
from tmmcalc.linkage.loadlaws.constant import Constant
from tmmcalc.linkage.loadlaws.quadratic import Quadratic
from tmmcalc.linkage.loadlaws.viscous import Viscous
from tmmcalc.machine.reduction.solve import solve_back, solve_reduction

TURN = 2 * np.pi
SLIDER = Loading(
    (Body(2, 3.0, 0.02, 0.1 + 0j), Body(3, 5.0, 0.0, 0j)),
    -9.81j,
    (
        Load("v", 3, "force", Viscous(40.0)),
        Load("q", 3, "force", Quadratic(25.0)),
        Load("Q", 3, "force", Constant(-120.0)),
    ),
    pairs=(Pair("B0", 0.12), Pair("A", 0.1, 0.02), Pair("O", 0.1, 0.03)),
)


@pytest.mark.parametrize("without", [False, True])
def test_it_is_the_reduction_at_the_opposite_speed(without: bool) -> None:
    loading = replace(SLIDER, loads=()) if without else SLIDER
    mechanism = with_input(full_turn(crank_slider(0.1, 0.3), 0.7, 24), speed=4.0)
    other = with_input(mechanism, speed=-4.0)
    back, idle = solve_back(mechanism, loading, solve_kinematics(mechanism))
    forward = solve_reduction(mechanism, loading, solve_kinematics(mechanism)).cycle
    reverse = solve_reduction(other, loading, solve_kinematics(other))
    theta = np.linspace(0.01, TURN - 0.02, 150)
    for cycle, mirrored in ((back, reverse.cycle), (idle, reverse.idle)):
        assert (cycle is None) == (mirrored is None)
        if cycle is None or mirrored is None:
            continue
        for name, sign in (("inertia", 1.0), ("moment", -1.0), ("viscous", 1.0), ("quadratic", 1.0)):
            here = cycle.panels.at(getattr(cycle, name), theta)
            there = mirrored.panels.at(getattr(mirrored, name), TURN - theta)
            np.testing.assert_allclose(here, sign * there, atol=1e-8 * max(1.0, float(np.abs(there).max())))
    gap = back.panels.at(back.moment, theta) - forward.panels.at(forward.moment, theta)
    assert np.all(gap > 0)  # forwards it resists, backwards as well


def test_friction_is_not_the_mirror_image() -> None:
    """What the load presses on depends on the direction of the friction itself."""
    mechanism = with_input(full_turn(crank_slider(0.1, 0.3), 0.7, 24), speed=4.0)
    kinematics = solve_kinematics(mechanism)
    back, _ = solve_back(mechanism, SLIDER, kinematics)
    forward = solve_reduction(mechanism, SLIDER, kinematics)
    free = solve_reduction(mechanism, replace(SLIDER, pairs=()), kinematics).cycle
    theta = np.linspace(0.1, TURN - 0.1, 90)
    bare = free.panels.at(free.moment, theta)
    lost = bare - forward.cycle.panels.at(forward.cycle.moment, theta)
    gained = back.panels.at(back.moment, theta) - bare
    assert float(np.max(np.abs(gained - lost))) > 0.02 * float(np.max(np.abs(lost)))


def test_without_friction_both_ways_are_the_same() -> None:
    mechanism = with_input(full_turn(crank_slider(0.1, 0.3), 0.3, 24), speed=4.0)
    loading = Loading((Body(2, 3.0, 0.02, 0.1 + 0j),), -9.81j)
    kinematics = solve_kinematics(mechanism)
    back, _ = solve_back(mechanism, loading, kinematics)
    forward = solve_reduction(mechanism, loading, kinematics).cycle
    theta = np.linspace(0.0, TURN - 0.01, 50)
    np.testing.assert_allclose(back.panels.at(back.moment, theta), forward.panels.at(forward.moment, theta), atol=1e-10)


def test_a_linkage_that_locks_backwards_alone_says_so() -> None:
    """Forwards the rod pulls the slider; pushed at a friction of 0.95 it wedges it in the guide."""
    mechanism = with_input(full_turn(crank_slider(0.21, 0.3), 0.7, 24), speed=4.0)
    load = Load("Q", 3, "force", Constant(-100.0))
    loading = Loading(loads=(load,), pairs=(Pair("B0", 1.2),))
    with pytest.raises(NoSolutionError) as caught:
        solve_back(mechanism, loading, solve_kinematics(mechanism))
    assert "turned back, the input is held by friction" in str(caught.value)
    assert caught.value.remedy
