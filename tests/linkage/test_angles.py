"""The turn in which angles are told: (-pi, pi] at position 0, then continuous; alike by every method."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from sparing import sparing
from transforms import moved, with_axes

import tmmcalc
from linkage.scenes import CONFIGS, crank_slider, drag_link, four_bar, shaper
from tmmcalc import Grid, Input, Mechanism, Method
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.outputs import coordinate_of

TURN = 2 * math.pi


def drawer() -> Mechanism:
    """The shaper with the axes of its slider laid so that its angle and the slotted link's may stand a turn apart."""
    return with_axes(shaper(), 2, 0j, 3.0)


SCENES = {
    "four-bar": lambda: four_bar(1, 6, 3, 7),
    "drag link": drag_link,
    "slider": lambda: crank_slider(0.1, 0.3),
    "shaper": shaper,
    "slider laid otherwise": drawer,
}


@sparing("name", SCENES, every=5)
@pytest.mark.parametrize("speed", [1.0, -1.0])
@pytest.mark.parametrize("start", [0.3, 3.1, 5.0, -7.0])
def test_at_position_0_angles_are_principal_and_the_crank_stands_at_its_coordinate(
    name: str, speed: float, start: float
) -> None:
    mechanism = replace(SCENES[name](), input=Input("O", speed, start=start))
    trace = tmmcalc.solve_kinematics(mechanism).trace
    crank = trace.link_ids.index(1)
    assert trace.angle[crank, 0] == start
    others = np.delete(trace.angle, crank, axis=0)
    assert np.all((others[:, 0] > -math.pi) & (others[:, 0] <= math.pi + 1e-9))
    assert np.max(np.abs(np.diff(trace.angle, axis=1))) < math.pi


@sparing("name", SCENES, every=3)
@sparing("method", [Method("projection"), Method("differences", 1e-4), Method("differences", 0.02, 2)], every=3)
def test_all_methods_tell_the_same_turn(name: str, method: Method) -> None:
    """Rounded to two decimals an angle of pi exceeds pi, and stays in the turn of the exact one."""
    for start in (0.0, 2.0, math.pi, -math.pi):
        mechanism = replace(SCENES[name](), input=Input("O", 1.0, start=start))
        exact = tmmcalc.solve_kinematics(mechanism).trace.angle
        assert tmmcalc.solve_kinematics(mechanism, method).trace.angle == pytest.approx(exact, abs=0.0051)


def test_the_splitting_tells_the_same_turn() -> None:
    spec = tmmcalc.load_spec(CONFIGS / "class-four.toml")
    exact = tmmcalc.solve_kinematics(spec).trace.angle
    assert tmmcalc.solve_kinematics(spec, Method("splitting")).trace.angle == pytest.approx(exact, abs=1e-9)


@pytest.mark.parametrize("name", ["four-bar", "drag link"])
@pytest.mark.parametrize("speed", [1.0, -1.0])
@pytest.mark.parametrize("start", [0.3, 2.0, 4.0, 5.5])
def test_dead_centres_stand_on_the_curve_of_the_positions(name: str, speed: float, start: float) -> None:
    """The angle of the table, followed from position 0 to each dead centre, is the one of the summary."""
    mechanism = replace(SCENES[name](), input=Input("O", speed, start=start), grid=Grid(positions=720))
    result = tmmcalc.solve_kinematics(mechanism)
    chain = chain_of(mechanism, result)
    for output, summary in zip(mechanism.outputs, result.summaries, strict=True):
        curve = result.trace.angle[result.trace.link_ids.index(output.link or 0)]
        for centre in summary.dead_centres:
            k = int(np.argmin(np.abs(result.x - centre.x)))
            assert centre.value == pytest.approx(curve[k], abs=0.05)
            there = chain.evaluate(np.array([centre.x]))
            expected = coordinate_of(chain, output, there)[0]
            assert np.exp(1j * centre.value) == pytest.approx(np.exp(1j * expected.item()), abs=1e-9)


@pytest.mark.parametrize("speed", [1.0, -1.0])
def test_a_rocker_that_swings_over_the_seam_keeps_one_turn(speed: float) -> None:
    """Turned in the plane so that the rocker passes pi: table and dead centres agree over a part of a turn, too."""
    for turn in np.linspace(0, TURN, 9):
        mechanism = moved(four_bar(1, 6, 3, 7), float(turn), 0j)
        start = 0.3 + float(turn)
        mechanism = replace(mechanism, input=Input("O", speed, start=start), grid=Grid(positions=400, span=5.0))
        result = tmmcalc.solve_kinematics(mechanism)
        curve = result.trace.angle[result.trace.link_ids.index(3)]
        (summary,) = result.summaries
        assert summary.dead_centres
        for centre in summary.dead_centres:
            assert min(abs(curve - centre.value)) < 1e-3
