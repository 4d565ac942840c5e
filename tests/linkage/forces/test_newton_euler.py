"""Dyad by dyad against all links at once: random mechanisms under random loads, and whole turns of ready mechanisms."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from properties import examples
from random_mechanisms import KINDS, RandomMechanism, build, scenes
from reference import NoPositionError
from sparing import sparing

import tmmcalc
from linkage.forces.checking import check
from linkage.forces.loadings import random_loading, reversed_input
from linkage.forces.newton_euler import placements
from linkage.scenes import CONFIGS, full_turn
from linkage.test_properties import regular
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.loading import Loading
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.tables.tasks.mechanism import to_linkage

EXAMPLES = examples(20, derandomize=True, database=None)


def solved(scene: RandomMechanism, friction: float, seed: int) -> tuple[Mechanism, Loading, Forces] | None:
    """A scene under random loads; None where it does not assemble or locks itself."""
    found = regular(scene)
    if found is None:
        return None
    mechanism, kinematics = found
    loading = random_loading(np.random.default_rng(seed), mechanism, friction)
    try:
        return mechanism, loading, solve_forces(mechanism, loading, kinematics)
    except tmmcalc.NoSolutionError as error:
        if "self-locking" not in str(error):
            raise
        return None


def compared(scene: RandomMechanism, friction: float, seed: int) -> bool:
    """Whether the scene could be compared; it must agree then."""
    result = solved(scene, friction, seed)
    if result is None:
        return False
    mechanism, loading, forces = result
    try:
        check(mechanism, scene.start, loading, forces)
    except NoPositionError:
        return False
    return True


@given(scenes(), st.integers(0, 2**32 - 1), st.sampled_from([0.0, 0.25]), st.booleans())
@EXAMPLES
def test_random_chains(scene: RandomMechanism, seed: int, friction: float, back: bool) -> None:
    compared(reversed_input(scene) if back else scene, friction, seed)


@sparing("kind", KINDS, every=3)
@sparing("prismatic", [False, True], every=2, first=1)
def test_each_kind_under_each_input(kind: str, prismatic: bool) -> None:
    """Enough scenes of every kind are compared, with and without friction, whatever the random chains meet."""
    count = 0
    for seed in range(4):
        scene = build(np.random.default_rng(seed), [kind], prismatic_input=prismatic)
        count += compared(scene, 0.25 * (seed % 2), seed)
    assert count >= 2


TURNING = {
    "shaper": 3.0,
    "press": -3.0,
    "four-bar": 3.0,
    "slotted-link": -3.0,
    "scotch-yoke": 3.0,
    "v-engine": -3.0,
    "inertial-conveyor": 3.0,
    "four-dyads": -3.0,
}


@sparing(("name", "speed"), TURNING.items(), every=4)
def test_whole_turns(name: str, speed: float) -> None:
    """Every pair may rub; at dead points both limits are rows of their own."""
    mechanism = to_linkage(tmmcalc.load_spec(CONFIGS / f"{name}.toml").mechanism)
    mechanism = full_turn(mechanism, 0.1, 12)
    mechanism = replace(mechanism, input=replace(mechanism.input, speed=speed, acceleration=2.0))
    kinematics = tmmcalc.solve_kinematics(mechanism)
    for seed in range(3, 9):
        loading = replace(random_loading(np.random.default_rng(seed), mechanism, 0.1), springs=())
        try:
            forces = solve_forces(mechanism, loading, kinematics)
        except tmmcalc.NoSolutionError as error:
            if "self-locking" not in str(error):
                raise
            continue
        return check(mechanism, placements(mechanism, kinematics), loading, forces)
    return pytest.fail("all scenes lock themselves")
