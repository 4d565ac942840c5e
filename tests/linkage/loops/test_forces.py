"""Reactions of higher groups, with and without friction, against Newton's and Euler's equations of all links."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import tmmcalc
from linkage.forces.checking import check
from linkage.forces.loadings import random_loading
from linkage.forces.newton_euler import placements
from linkage.loops.groups import CLASS_III, CLASS_IV, CLASS_VI, drawn, scene
from linkage.loops.test_tracking import inside
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.structure import solve_structure

pytestmark = pytest.mark.slow


@pytest.mark.parametrize("graph", [CLASS_III, CLASS_IV], ids=["III", "IV"])
@pytest.mark.parametrize("prismatic", [0, 1])
@pytest.mark.parametrize("friction", [0.0, 0.1])
def test_random_groups_under_random_loads(graph: tuple[str, ...], prismatic: int, friction: float) -> None:
    rng, compared = np.random.default_rng(11), 0
    for seed in range(2):
        mechanism, _ = scene(seed, graph, drawn(rng, graph, prismatic), crank=0.1)
        if len(solve_structure(mechanism).groups) != 1:
            continue
        mechanism = inside(mechanism)
        kinematics = tmmcalc.solve_kinematics(mechanism)
        loading = random_loading(rng, mechanism, friction)
        try:
            forces = solve_forces(mechanism, loading, kinematics)
        except tmmcalc.NoSolutionError as error:
            if "self-locking" not in str(error):
                raise
            continue
        check(mechanism, placements(mechanism, kinematics), loading, forces, tolerance=1e-9)
        compared += 1
    assert compared >= 1


def test_a_group_of_six_links() -> None:
    mechanism, _ = scene(3, CLASS_VI)
    mechanism = replace(mechanism, grid=replace(mechanism.grid, positions=6, span=0.02))
    kinematics = tmmcalc.solve_kinematics(mechanism)
    loading = random_loading(np.random.default_rng(2), mechanism)
    forces = solve_forces(mechanism, loading, kinematics)
    check(mechanism, placements(mechanism, kinematics), loading, forces, tolerance=1e-9)
