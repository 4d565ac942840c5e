"""Branches of higher groups against the independent solver: positions, rates, limits, chains of several groups."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from reference import Placements, Reference, solve
from sparing import sparing

import tmmcalc
from linkage.loops.groups import CLASS_III, CLASS_IV, drawn, scene
from linkage.loops.worked import case, class_four
from linkage.scenes import bar, pin
from tmmcalc import Kinematics, Mechanism
from tmmcalc.linkage.chain import Chain
from tmmcalc.linkage.loops.step import LoopStep
from tmmcalc.linkage.placing import assembled
from tmmcalc.linkage.results import Branch
from tmmcalc.linkage.structure import solve_structure
from tmmcalc.linkage.variants import given_variants

TURN = 2 * math.pi


def branch_of(mechanism: Mechanism) -> tuple[Chain, LoopStep, Branch]:
    structure = solve_structure(mechanism)
    chain = assembled(mechanism, structure, given_variants(mechanism, structure))
    step = next(step for step in chain.steps if isinstance(step, LoopStep))
    return chain, step, step.branch


def inside(mechanism: Mechanism) -> Mechanism:
    """Over the whole turn, or from one limit nearly to the other."""
    start = mechanism.input.start
    assert start is not None
    _, _, branch = branch_of(mechanism)
    if branch.period is not None:
        return replace(mechanism, grid=replace(mechanism.grid, positions=16))
    low, width = branch.low, branch.high - branch.low
    return replace(
        mechanism,
        input=replace(mechanism.input, start=low + 0.02 * width),
        grid=replace(mechanism.grid, positions=16, span=0.96 * width),
        assembly=replace(mechanism.assembly, at=start),
    )


def followed(
    mechanism: Mechanism, placements: Placements, start: float, x: np.ndarray
) -> list[tuple[np.ndarray, Reference]]:
    """The independent solver from the placement at ``start`` both ways; which of the coordinates it gives."""
    ways = []
    for way in (np.flatnonzero(x >= start), np.flatnonzero(x < start)[::-1]):
        if len(way):
            ways.append((way, solve(mechanism, placements, np.concatenate(([start], x[way])))))
    return ways


def check(result: Kinematics, ways: list[tuple[np.ndarray, Reference]], tolerance: float = 1e-9) -> None:
    trace = result.trace
    for way, reference in ways:
        for row, k in enumerate(trace.link_ids):
            motion = reference.angles[k]
            assert np.exp(1j * trace.angle[row, way]) == pytest.approx(np.exp(1j * motion.value[1:]), abs=tolerance)
            for found, expected in ((trace.dangle, motion.first), (trace.ddangle, motion.second)):
                scale = 1 + np.max(np.abs(expected))
                assert found[row, way] == pytest.approx(expected[1:], abs=tolerance * scale)
        for row, name in enumerate(trace.joint_names):
            slide = reference.slides[name]
            for found, expected in ((trace.s, slide.value), (trace.ds, slide.first), (trace.dds, slide.second)):
                scale = 1 + np.max(np.abs(expected))
                assert found[row, way] == pytest.approx(expected[1:], abs=tolerance * scale)


@sparing("graph", [CLASS_III, CLASS_IV], ids=["III", "IV"], every=2)
@sparing("prismatic", [0, 1, 2], every=3, first=1)
@pytest.mark.parametrize("seed", [0])
def test_random_groups(graph: tuple[str, ...], prismatic: int, seed: int) -> None:
    names = drawn(np.random.default_rng(100 * seed + prismatic), graph, prismatic)
    mechanism, placements = scene(seed, graph, names)
    if len(solve_structure(mechanism).groups) != 1:
        pytest.skip("these joints make dyads of it")
    start = mechanism.input.start
    assert start is not None
    wanted = inside(mechanism)
    result = tmmcalc.solve_kinematics(wanted)
    check(result, followed(mechanism, placements, start, np.asarray(result.x)))
    assert result.error.position < 1e-11


@sparing("graph", [CLASS_III, CLASS_IV], ids=["III", "IV"], every=2)
def test_at_a_limit_the_regularity_falls_like_the_root_of_the_distance(graph: tuple[str, ...]) -> None:
    checked = 0
    for seed in range(3):
        chain, step, branch = branch_of(scene(seed, graph)[0])
        for limit in branch.limits:
            inwards = 1 if limit.x == branch.low else -1
            near = [
                float(step.regularity(chain.evaluate(np.array([limit.x + inwards * d])).placed[0])[0])
                for d in (1e-6, 1e-8)
            ]
            assert near[0] / near[1] == pytest.approx(10, rel=0.02)
            checked += 1
    assert checked >= 3


def crank_to_the_limit(hair: float) -> Mechanism:
    """The class IV linkage whose crank brings A so near to F as the group allows, and a hair farther or nearer."""
    given, expected = case("A-C4-RANGE")
    return replace(class_four(given, 1.15 - expected["AF_min"] + hair, 1.15), input=tmmcalc.Input("O", 10.0, start=2.0))


def test_a_crank_that_turns_fully_by_a_hair() -> None:
    mechanism = replace(crank_to_the_limit(-1e-6), assembly=tmmcalc.Assembly(variants={(2, 3, 4, 5): 1}))
    assert branch_of(mechanism)[2].period == pytest.approx(TURN)
    result = tmmcalc.solve_kinematics(mechanism)
    assert result.domain.full
    assert any("singular" in grade.message for grade in result.grades)


def test_a_crank_that_misses_a_full_turn_by_a_hair() -> None:
    """The limits are where |AF| is the least that the group allows."""
    _, expected = case("A-C4-RANGE")
    mechanism = replace(crank_to_the_limit(1e-6), assembly=tmmcalc.Assembly(variants={(2, 3, 4, 5): 1}))
    branch = branch_of(mechanism)[2]
    crank = 1.15 - expected["AF_min"] + 1e-6
    limit = math.acos((1.15**2 + crank**2 - expected["AF_min"] ** 2) / (2 * 1.15 * crank))
    assert branch.period is None
    assert branch.low == pytest.approx(limit, rel=1e-2)
    assert branch.high == pytest.approx(TURN - limit, abs=1e-2 * limit)
    with pytest.raises(tmmcalc.AssemblyError):
        tmmcalc.solve_kinematics(mechanism)


def tied(
    mechanism: Mechanism, placements: Placements, graph: tuple[str, ...], carrier: int, seed: int
) -> tuple[Mechanism, Placements]:
    """A random group of four links more, which hangs on the frame and on a point of ``carrier``."""
    rng = np.random.default_rng(seed)
    count = len(mechanism.links)
    moved = {k: k + count - 1 for k in range(2, 6)} | {0: 0, 1: carrier}
    where = dict(placements) | {0: (0j, 0.0)}
    for k in range(2, 6):
        where[moved[k]] = complex(*rng.uniform(-1, 1, 2)), float(rng.uniform(-3, 3))
    joints = []
    for name in graph[1:]:
        a, b = moved[int(name[0])], moved[int(name[1])]
        place = complex(*rng.uniform(-1, 1, 2))
        own = [complex((place - where[k][0]) * np.exp(-1j * where[k][1])) for k in (a, b)]
        joints.append(pin(f"{name}-{carrier}", a, b, *own))
    links = tuple(bar(moved[k], **{f"P{moved[k]}": 0.3 + 0.1j}) for k in range(2, 6))
    sketch = {
        f"P{k}": complex(where[k][0] + (0.3 + 0.1j) * np.exp(1j * where[k][1])) for k in (moved[q] for q in range(2, 6))
    }
    grown = replace(
        mechanism,
        links=(*mechanism.links, *links),
        joints=(*mechanism.joints, *joints),
        assembly=replace(mechanism.assembly, sketch={**mechanism.assembly.sketch, **sketch}),
    )
    return grown, {k: at for k, at in where.items() if k}


DYAD = ("01", "12", "23", "03")


@pytest.mark.slow
@sparing("seed", range(2), every=2)
def test_two_higher_groups_and_dyads_in_a_row(seed: int) -> None:
    """A dyad before them, one of each class, and a dyad behind them."""
    mechanism, placements = scene(seed, DYAD)
    mechanism = replace(mechanism, grid=replace(mechanism.grid, positions=8, span=0.02))
    mechanism, placements = tied(mechanism, placements, CLASS_III, 3, seed)
    mechanism, placements = tied(mechanism, placements, CLASS_IV, 5, seed + 50)
    last, n = mechanism.links[-1].id, len(mechanism.links)
    at, turned = placements[last]
    place, end = 0.9 + 0.8j, -0.7 + 0.6j
    local = complex((place - at) * np.exp(-1j * turned))
    middle = (place + end) / 2 + 0.3j
    mechanism = replace(
        mechanism,
        links=(*mechanism.links, bar(n + 1, P=0), bar(n + 2, P=0)),
        joints=(
            *mechanism.joints,
            pin("p", last, n + 1, local),
            pin("q", n + 1, n + 2, middle - place, middle - end),
            pin("r", n + 2, 0, 0, end),
        ),
    )
    placements = {**placements, n + 1: (place, 0.0), n + 2: (end, 0.0)}
    mechanism = replace(mechanism, assembly=replace(mechanism.assembly, variants=_dyad_signs(mechanism, placements)))
    structure = solve_structure(mechanism)
    assert [group.class_number for group in structure.groups] == [2, 3, 4, 2]
    result = tmmcalc.solve_kinematics(mechanism)
    start = mechanism.input.start
    assert start is not None
    check(result, followed(mechanism, placements, start, np.asarray(result.x)))


def _dyad_signs(mechanism: Mechanism, placements: Placements) -> dict[tuple[int, ...], int]:
    """The signs of the dyads as the placement has them: where the inner pin lies against the outer ones."""
    signs: dict[tuple[int, ...], int] = {}
    for group in solve_structure(mechanism).groups:
        if group.kind:
            one, inner, other = (
                _place(mechanism, placements, n) for n in (group.outer[0], group.inner[0], group.outer[1])
            )
            signs[group.links] = int(np.sign((np.conj(other - one) * (inner - one)).imag))
    return signs


def _place(mechanism: Mechanism, placements: Placements, name: str) -> complex:
    joint = mechanism.joint(name)
    side = 0 if joint.links[0] else 1
    at, angle = placements[joint.links[side]]
    return complex(at + joint.points[side] * np.exp(1j * angle))
