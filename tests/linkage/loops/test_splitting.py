"""The splitting into dyads against the loops solved at once, and its trap: dyads that change their sign."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import tmmcalc
from linkage.loops.groups import CLASS_III, CLASS_IV, CLASS_VI, drawn, scene
from linkage.loops.test_tracking import inside
from linkage.scenes import CONFIGS, crank_slider, full_turn
from tmmcalc import Kinematics, Mechanism, Method
from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.loops.splitting import split_of
from tmmcalc.linkage.structure import solve_structure

pytestmark = pytest.mark.slow

SPLITTING = Method("splitting")


def compare(one: Kinematics, two: Kinematics, tolerance: float = 1e-10) -> None:
    assert np.exp(1j * two.trace.angle) == pytest.approx(np.exp(1j * one.trace.angle), abs=tolerance)
    for rows in ("r", "dr", "ddr", "dangle", "ddangle", "s", "ds", "dds"):
        exact = getattr(one.trace, rows)
        scale = 1 + np.max(np.abs(exact), initial=0.0)
        assert np.max(np.abs(getattr(two.trace, rows) - exact), initial=0.0) < tolerance * scale


def told(result: Kinematics, severity: str) -> list[str]:
    return [
        grade.message for grade in result.grades if grade.where.startswith("splitting") and grade.severity == severity
    ]


@pytest.mark.parametrize("name", ["class-four", "class-three", "class-three-slider"])
def test_ready_specs(name: str) -> None:
    spec = tmmcalc.load_spec(CONFIGS / f"{name}.toml")
    result = tmmcalc.solve_kinematics(spec, SPLITTING)
    compare(tmmcalc.solve_kinematics(spec), result, 1e-12)
    assert len(told(result, "note")) == 1
    assert result.error.position < 1e-12


def test_the_textbook_splits_class_four_by_bar_de() -> None:
    mechanism = tmmcalc.solve_kinematics(spec := tmmcalc.load_spec(CONFIGS / "class-four.toml"))
    (note,) = told(tmmcalc.solve_kinematics(spec, SPLITTING), "note")
    assert note == "link 4 is removed, the angle of link 2 is tried, dyads RRR(3,5)"
    assert mechanism.method.name == "closed"


@pytest.mark.parametrize("graph", [CLASS_III, CLASS_IV], ids=["III", "IV"])
@pytest.mark.parametrize("prismatic", [0, 1])
def test_random_groups(graph: tuple[str, ...], prismatic: int) -> None:
    compared, rng = 0, np.random.default_rng(7)
    for seed in range(2):
        mechanism, _ = scene(seed, graph, drawn(rng, graph, prismatic))
        if len(solve_structure(mechanism).groups) != 1:
            continue
        wanted = inside(mechanism)
        try:
            found = tmmcalc.solve_kinematics(wanted, SPLITTING)
        except tmmcalc.UsageError:
            continue
        compare(tmmcalc.solve_kinematics(wanted), found)
        compared += 1
    assert compared >= 2


def flipping() -> tuple[Mechanism, Kinematics]:
    """The first random group of class IV whose auxiliary dyad changes its sign over the motion."""
    for seed in range(20):
        wanted = inside(scene(seed, CLASS_IV)[0])
        result = tmmcalc.solve_kinematics(wanted, SPLITTING)
        if told(result, "warning"):
            return wanted, result
    raise AssertionError("none of the groups has such a dyad")


def test_a_dyad_that_changes_its_sign_while_the_group_is_regular() -> None:
    """The sine of the angle between the dyad's links passes zero where the warning says, the regularity does not."""
    mechanism, split = flipping()
    exact = tmmcalc.solve_kinematics(mechanism)
    compare(exact, split)
    chain = chain_of(mechanism, exact)
    (step,) = chain.steps
    dyad = split_of(mechanism, step.group).dyads[0]
    (outer, other), (inner,) = dyad.outer, dyad.inner
    (warning, *_) = told(split, "warning")
    at = np.radians(float(warning.split("angle_1 = ")[1].split(" deg")[0]))

    def sine(x: float) -> float:
        motions = chain.evaluate(np.array([x])).motions
        places = []
        for name in (outer, inner, other):
            joint = mechanism.joint(name)
            side = next(k for k in range(2) if joint.links[k] in dyad.links)
            places.append(np.ravel(motions[joint.links[side]].point(joint.points[side]).r)[0])
        a, b = places[1] - places[0], places[1] - places[2]
        return float((np.conj(a) * b).imag / abs(a * b))

    assert sine(at - 1e-4) * sine(at + 1e-4) < 0
    regularity = step.regularity(chain.evaluate(np.array([at])).placed[0])[0]
    assert regularity > 1e-3
    assert "with frozen signs" in warning


def test_what_cannot_be_split() -> None:
    """Dyads alone; a group of which every choice leaves more than dyads."""
    with pytest.raises(tmmcalc.UsageError, match="there is nothing to split"):
        tmmcalc.solve_kinematics(full_turn(crank_slider(0.1, 0.3)), SPLITTING)
    mechanism, _ = scene(3, CLASS_IV, ("23", "45"))
    small = replace(mechanism, grid=replace(mechanism.grid, span=1e-3))
    with pytest.raises(tmmcalc.UsageError, match="cannot be split"):
        tmmcalc.solve_kinematics(small, SPLITTING)


def test_a_group_of_six_links_is_split_into_two_dyads() -> None:
    mechanism, _ = scene(3, CLASS_VI)
    assert len(split_of(mechanism, solve_structure(mechanism).groups[0]).dyads) == 2
    small = replace(mechanism, grid=replace(mechanism.grid, positions=6, span=0.02))
    compare(tmmcalc.solve_kinematics(small), tmmcalc.solve_kinematics(small, SPLITTING))
