"""Branches that do not close after one turn of the crank: those of two turns, and those that end in their second."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from sparing import sparing

import tmmcalc
from linkage.loops.worked import case, class_four, class_three
from linkage.scenes import bar, pin
from tmmcalc import Grid, Input, Mechanism
from tmmcalc.linkage.results import Branch

TURN = 2 * math.pi

TWO_TURNS: dict[str, Any] = {
    "leg_lengths": [0.71, 1.18, 1.2],
    "platform_local": {"P1": [0, 0], "P2": [1.26, -0.03], "P3": [0.59, 1.1]},
    "Q2": [0.17, 0.16],
    "Q3": [-0.51, 0.19],
}
SECOND_ENDS: dict[str, Any] = {
    "leg_lengths": [1.13, 0.96, 1.11],
    "platform_local": {"P1": [0, 0], "P2": [0.35, -1.38], "P3": [0.14, -0.29]},
    "Q2": [-0.9, -0.02],
    "Q3": [0.62, -0.72],
}


def plate(given: dict[str, Any], crank: float, start: float, at: complex, turned: float) -> Mechanism:
    """The plate on three legs, sketched with P1 at this place and turned so when the crank is at the start."""
    sketch = {name: at + complex(complex(*p) * np.exp(1j * turned)) for name, p in given["platform_local"].items()}
    return replace(class_three(given, crank, sketch=sketch, at=start), input=Input("O", 10.0, start=start))


def two_turns() -> Mechanism:
    return plate(TWO_TURNS, 0.67, -3.09, -0.03 - 0.34j, 0.01)


def second_ends() -> Mechanism:
    return plate(SECOND_ENDS, 1.02, -2.48, 0.17 - 0.05j, -2.59)


def walked(
    given: dict[str, Any], crank: float, at: complex, turned: float, x: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Angles of the plate along the near crank angles x (n,), by Newton on the lengths of its three legs."""
    own = np.array([complex(*p) for p in given["platform_local"].values()])
    place, angle, angles = at, turned, []
    for phi in x:
        feet = np.array([crank * np.exp(1j * phi), complex(*given["Q2"]), complex(*given["Q3"])])
        for _ in range(6):
            legs = place + own * np.exp(1j * angle) - feet
            turning = (np.conj(legs) * 1j * own * np.exp(1j * angle)).real
            missing = (np.array(given["leg_lengths"]) ** 2 - np.abs(legs) ** 2) / 2
            dx, dy, dtheta = np.linalg.solve(np.column_stack((legs.real, legs.imag, turning)), missing)
            place, angle = place + complex(dx, dy), angle + float(dtheta)
        angles.append(angle)
    return np.array(angles)


def over(mechanism: Mechanism, span: float, positions: int = 24) -> Mechanism:
    return replace(mechanism, grid=Grid(positions=positions, span=span))


def branch_of(mechanism: Mechanism) -> Branch:
    return tmmcalc.solve_kinematics(over(mechanism, 0.1)).branches["III(2,3,4,5)"]


@pytest.mark.slow
def test_a_branch_of_two_turns_against_a_walk_along_it() -> None:
    """After one turn the plate stands otherwise, after two it is back; the crank turns fully all the while."""
    mechanism = two_turns()
    result = tmmcalc.solve_kinematics(over(mechanism, 2 * TURN))
    assert branch_of(mechanism).period == pytest.approx(2 * TURN)
    assert result.domain.full
    angle = result.trace.angle[result.trace.link_ids.index(3)]
    fine = np.linspace(result.x[0], result.x[-1], 60 * 24 + 1)
    np.testing.assert_allclose(angle, walked(TWO_TURNS, 0.67, -0.03 - 0.34j, 0.01, fine)[::60], atol=1e-11)
    assert abs(np.exp(1j * angle[12]) - np.exp(1j * angle[0])) > 0.1
    assert np.exp(1j * angle[24]) == pytest.approx(np.exp(1j * angle[0]), abs=1e-12)


@sparing("speed", [10.0, -10.0], every=2)
def test_one_turn_of_a_branch_of_two_is_refused(speed: float) -> None:
    mechanism = replace(two_turns(), input=Input("O", speed, start=-3.09))
    with pytest.raises(tmmcalc.AssemblyError, match="it comes back after 2 turns") as error:
        tmmcalc.solve_kinematics(mechanism)
    assert "or to 720 deg" in str(error.value)
    with pytest.raises(tmmcalc.AssemblyError, match="it comes back after 2 turns"):
        tmmcalc.solve_kinematics(replace(mechanism, input=Input("O", speed)))


def test_one_turn_of_a_branch_that_ends_in_its_second_is_refused() -> None:
    """The limits are more than a turn apart, so every crank angle is reached, but no cycle closes."""
    mechanism = second_ends()
    branch = branch_of(mechanism)
    assert (branch.period, len(branch.limits)) == (None, 2)
    assert branch.high - branch.low > TURN
    with pytest.raises(tmmcalc.AssemblyError, match="stands otherwise: it comes to a limit position"):
        tmmcalc.solve_kinematics(mechanism)


@pytest.mark.slow
def test_on_a_branch_wider_than_a_turn_its_turns_differ() -> None:
    """At the ends, which are more than a turn apart, the same crank angles show two configurations."""
    mechanism = second_ends()
    branch = branch_of(mechanism)
    x = np.array([branch.low + 0.01, branch.low + 0.01 + TURN])
    found = [
        tmmcalc.solve_kinematics(over(replace(mechanism, input=Input("O", 1.0, start=float(at))), 1e-3)) for at in x
    ]
    angles = [result.trace.angle[result.trace.link_ids.index(3), 0] for result in found]
    for at, angle in zip(x, angles, strict=True):
        expected = walked(SECOND_ENDS, 1.02, 0.17 - 0.05j, -2.59, np.linspace(-2.48, at, 4000))[-1]
        assert np.exp(1j * angle) == pytest.approx(np.exp(1j * expected), abs=1e-9)
    assert abs(np.exp(1j * angles[0]) - np.exp(1j * angles[1])) > 0.1
    beyond = over(replace(mechanism, input=Input("O", 1.0, start=branch.high - 0.1)), 0.2)
    with pytest.raises(tmmcalc.AssemblyError, match="does not assemble throughout"):
        tmmcalc.solve_kinematics(beyond)


@sparing("turns", [-2, -1, 1, 3], every=4)
def test_position_0_may_stand_whole_turns_from_the_sketch(turns: int) -> None:
    """A branch between two limits less than a turn apart is meant modulo a turn."""
    given, expected = case("A-C4-RANGE")
    mechanism = class_four(given, 1.2 - expected["AF_min"], 1.15, variants={(2, 3, 4, 5): 1}, at=2.0)
    mechanism = over(replace(mechanism, input=Input("O", 1.0, start=2.0)), 0.1)
    branch = tmmcalc.solve_kinematics(mechanism).branches["IV(2,3,4,5)"]
    width = branch.high - branch.low
    assert branch.limits
    assert width < TURN
    near = over(replace(mechanism, input=Input("O", 1.0, start=branch.low + 0.2 * width)), 0.5 * width)
    away = replace(near, input=Input("O", 1.0, start=branch.low + 0.2 * width + turns * TURN))
    one, other = (tmmcalc.solve_kinematics(each).trace for each in (near, away))
    np.testing.assert_allclose(other.r, one.r, atol=1e-12)
    np.testing.assert_allclose(other.ddr, one.ddr, rtol=1e-8, atol=1e-9)


def test_a_dyad_behind_is_asked_about_both_turns() -> None:
    """Its links reach the plate during one of the two turns only; the limits are where |P3 G| is their sum."""
    mechanism = two_turns()
    fine = tmmcalc.solve_kinematics(over(mechanism, 2 * TURN, positions=720))
    ground = 3 + 1j
    reach = np.abs(fine.trace.r[fine.trace.point_names.index("P3")] - ground)
    first, second = reach[:361].max(), reach[360:].max()
    assert abs(first - second) > 0.01
    total = (first + second) / 2
    grown = replace(
        mechanism,
        links=(*mechanism.links, bar(6, P3=0, H=total / 2), bar(7, G=0, H=total / 2)),
        joints=(
            *mechanism.joints,
            pin("P3'", 3, 6, mechanism.link(3).points["P3"]),
            pin("H", 6, 7, total / 2, total / 2),
            pin("G", 0, 7, ground),
        ),
    )
    with pytest.raises(tmmcalc.AssemblyError, match=r"cannot make a full turn|does not assemble throughout"):
        tmmcalc.solve_kinematics(over(grown, 2 * TURN))
    bad = fine.x[np.flatnonzero(reach > total)]
    limits = sorted(
        limit.x for interval in tmmcalc.solve_kinematics(over(grown, 0.1)).domain.intervals for limit in interval.limits
    )
    step = fine.x[1] - fine.x[0]
    ends = sorted(np.mod([bad[0], bad[-1]], 2 * TURN))
    assert sorted(np.mod(limits, 2 * TURN)) == pytest.approx(ends, abs=2 * step)
