"""The error estimate of reactions and drive against their true error: everything again in extended precision."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from random_mechanisms import build

from linkage.forces.loadings import random_loading
from tmmcalc import TmmError, solve_kinematics
from tmmcalc.core.numerics.extended import WIDER
from tmmcalc.core.plane import Plane, Real
from tmmcalc.linkage.forces.kinetostatics import Statics, compile_statics
from tmmcalc.linkage.forces.solve import solve_forces
from tmmcalc.linkage.lastdigit import in_full
from tmmcalc.linkage.loads.scene import compile_scene

pytestmark = [pytest.mark.slow, pytest.mark.skipif(not WIDER, reason="no wider float here")]
SCENES = 240


def solved(statics: Statics, theta: Real) -> tuple[Plane, Real]:
    """Reactions (J, n) and drive (n,), in the precision of theta (n,)."""
    side = np.ones(len(theta))
    state = statics.solve(statics.scene.place(theta, side), side)
    reactions = [np.broadcast_to(state.reactions[joint.name].wrench.force, len(theta)) for joint in statics.joints]
    return np.array(reactions), np.asarray(state.drive)


def off(found: Plane | Real, exact: Plane | Real) -> float:
    """Largest difference over the largest value, at least half a rounding unit."""
    return max(float(np.max(np.abs(exact - found)) / np.max(np.abs(exact))), 2.0**-53)


@cache
def ratios() -> np.ndarray:
    """Estimate over true error of random scenes, half of them with friction: of reactions, of the drive (m, 2)."""
    rows = []
    for seed in range(SCENES):
        rng = np.random.default_rng(seed)
        scene = build(rng, positions=40, span=np.radians(12))
        try:
            kinematics = solve_kinematics(scene.mechanism)
            loading = random_loading(rng, scene.mechanism, 0.1 * (seed % 2))
            error = solve_forces(scene.mechanism, loading, kinematics).error
        except TmmError:
            continue
        statics = compile_statics(compile_scene(scene.mechanism, loading, kinematics))
        theta = statics.scene.travel.rows(kinematics)[0]
        reactions, drive = solved(statics, theta)
        exact, exact_drive = solved(statics.on(in_full(statics.scene.chain)), theta.astype(np.longdouble))
        assert exact.dtype == np.clongdouble
        rows.append((error / off(reactions, exact), error / off(drive, exact_drive)))
    assert len(rows) > 200
    return np.array(rows)


def test_the_estimate_bounds_the_true_error_in_99_of_100_scenes() -> None:
    assert np.mean(ratios() >= 1, axis=0).min() >= 0.99


def test_the_estimate_is_not_far_above_the_true_error() -> None:
    assert np.median(ratios(), axis=0).max() < 30
