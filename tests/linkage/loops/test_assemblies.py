"""Enumeration of assemblies against Newton from very many starts, by groups of every make-up."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from sparing import sparing

import tmmcalc
from linkage.loops.groups import CLASS_III, CLASS_IV, CLASS_VI, drawn, loops_of, scene
from linkage.loops.worked import case, class_four
from linkage.scenes import CONFIGS
from tmmcalc.core.plane import Real
from tmmcalc.linkage.loops.assemblies import assemblies
from tmmcalc.linkage.loops.closure import Loops
from tmmcalc.linkage.structure import solve_structure

STARTS = 600


def by_starts(loops: Loops) -> Real:
    """Distinct ends of Newton from starts all over, polished and sorted like the enumeration."""
    eq = loops.equations
    count = eq.classes.shape[1]
    start = np.random.default_rng(5).uniform(-1, 1, (eq.unknowns, STARTS)) * loops.size[:, None]
    start[:count] *= math.pi
    placed, done = loops.close(start, 60)
    fine = placed.q[:, done & (np.max(np.abs(placed.residual), axis=0) < 1e-11)]
    fine[:count] = math.pi - np.mod(math.pi - fine[:count], 2 * math.pi)
    kept: list[Real] = []
    for q in fine.T:
        if all(np.max(np.abs(q - other)) > 1e-6 for other in kept):
            kept.append(q)
    return np.array(kept).reshape(len(kept), eq.unknowns).T


@sparing("graph", [CLASS_III, CLASS_IV], ids=["III", "IV"], every=2)
@sparing("prismatic", [0, 1, 2, 3], every=2, first=1)
def test_none_is_missed_and_none_invented(graph: tuple[str, ...], prismatic: int) -> None:
    rng, compared = np.random.default_rng(prismatic), 0
    for seed in range(8):
        mechanism, _ = scene(seed, graph, drawn(rng, graph, prismatic))
        try:
            structure = solve_structure(mechanism)
        except tmmcalc.StructureError:
            continue
        if len(structure.groups) != 1:
            continue
        loops = loops_of(mechanism)
        found, expected = assemblies(loops), by_starts(loops)
        assert found.shape == expected.shape
        for q in expected.T:
            assert min(np.max(np.abs(q - other)) for other in found.T) < 1e-9
        compared += 1
    assert compared >= 4


def test_angles_ascend_and_every_assembly_is_closed() -> None:
    for seed in range(10):
        loops = loops_of(scene(seed)[0])
        found = assemblies(loops)
        assert np.all(np.diff(found[0]) > 0)
        assert np.all((found > -math.pi) & (found <= math.pi))
        assert np.max(np.abs(loops.place(found).residual)) < 1e-14


def test_two_assemblies_that_nearly_coincide_are_two() -> None:
    """At the end of the range of existence the unknowns differ by the root of the distance from it."""
    given, expected = case("A-C4-RANGE")
    gaps = []
    for hair in (1e-6, 4e-6):
        found = assemblies(loops_of(class_four(given, 0.1, 0.1 + expected["AF_max"] - hair)))
        assert found.shape == (4, 2)
        gaps.append(np.max(np.abs(found[:, 0] - found[:, 1])))
    assert gaps[1] / gaps[0] == pytest.approx(2.0, rel=1e-2)


def test_a_group_of_six_links_is_solved_from_starts() -> None:
    """The assembly from which the metric was read is among those that are found."""
    mechanism, placements = scene(3, CLASS_VI)
    (group,) = solve_structure(mechanism).groups
    assert (group.class_number, len(group.links)) == (6, 6)
    loops = loops_of(mechanism)
    assert len(loops.equations.classes) == 3
    told = np.array([placements[k][1] for k in loops.equations.turnings])
    order = [turning.of for turning in loops.equations.turnings.values()]
    gaps = [np.max(np.abs(np.exp(1j * q[order]) - np.exp(1j * told))) for q in assemblies(loops).T]
    assert min(gaps) < 1e-9


@pytest.mark.slow
def test_driven_length_inside_a_group_of_two_loops() -> None:
    """A plate on two legs and on a cylinder: five links, the drive inside them."""
    graph = ("01", "12", "25", "03", "35", "04", "45")
    compared = 0
    for seed in range(6):
        mechanism, placements = scene(seed, graph, ("12",))
        (joint,) = [joint for joint in mechanism.joints if joint.name == "12"]
        one, two = (
            placements[k][0] + p * np.exp(1j * placements[k][1]) for k, p in zip(joint.links, joint.points, strict=True)
        )
        along = joint.directions[1] * np.exp(1j * placements[joint.links[1]][1])
        drive = tmmcalc.Input("12", 1.0, start=float((np.conj(along) * (one - two)).real))
        driven = replace(mechanism, input=drive)
        found, expected = assemblies(loops_of(driven)), by_starts(loops_of(driven))
        assert found.shape == expected.shape
        assert found.shape[1] >= 1
        compared += 1
    assert compared == 6


def test_listing_of_a_ready_spec() -> None:
    """Six points of four links; the one that is taken is the one of the sketch; other assemblies close as well."""
    listing = tmmcalc.list_assemblies(tmmcalc.load_spec(CONFIGS / "class-three.toml"))
    taken = [one.variant for one in listing.assemblies if one.taken]
    assert taken == [tmmcalc.solve_kinematics(tmmcalc.load_spec(CONFIGS / "class-three.toml")).variants["III(2,3,4,5)"]]
    for one in listing.assemblies:
        p1, p2, p3 = (one.points[name] for name in ("P1", "P2", "P3"))
        assert abs(p1 - 0.06) == pytest.approx(0.39, abs=1e-12)
        assert abs(p2 - (0.62 + 0.18j)) == pytest.approx(0.34, abs=1e-12)
        assert abs(p3 - (0.36 + 0.66j)) == pytest.approx(0.51, abs=1e-12)
        assert abs(p2 - p1) == pytest.approx(abs(0.33 - 0.06j), abs=1e-12)
