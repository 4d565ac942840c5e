"""A force analysis compared with the independent one, reaction by reaction."""

from __future__ import annotations

import numpy as np
from reference import Placements

from linkage.forces.newton_euler import Array, Solved, Values, given_loads, law, motions, newton_euler
from tmmcalc.linkage.forces.results import Forces
from tmmcalc.linkage.loading import GearDrive, Loading
from tmmcalc.linkage.model import Mechanism

TOLERANCE = 1e-10  # of the largest reaction, couple, drive


def sides(result: Forces) -> Array:
    """From which side each row is taken: the left limits at jumps and at the end -1."""
    side = np.array([-1.0 if label.endswith("-") else 1.0 for label in result.labels])
    side[-1] = -1.0
    return side


def independent(
    mechanism: Mechanism, start: Placements, loading: Loading, result: Forces, values: Values | None = None
) -> tuple[Solved, dict[str, Array]]:
    """Newton's and Euler's equations under the friction of the result, and what that friction should be."""
    names = [joint.name for joint in mechanism.joints]
    first = mechanism.input.start or 0.0
    at = motions(mechanism, start, first + result.phi)
    friction = {pair.joint: result.friction[names.index(pair.joint)] for pair in loading.pairs}
    gear = loading.drive if isinstance(loading.drive, GearDrive) and result.turns else None
    given = given_loads(at, loading, result.theta, values)
    solved = newton_euler(at, given, friction, gear, np.sign(result.drive))
    return solved, law(at, loading.pairs, solved.reaction, solved.couple, sides(result))


def check(
    mechanism: Mechanism,
    start: Placements,
    loading: Loading,
    result: Forces,
    values: Values | None = None,
    tolerance: float = TOLERANCE,
) -> None:
    """Assert that reactions, couples, drive and friction are those of the independent analysis."""
    solved, friction = independent(mechanism, start, loading, result, values)
    size = float(np.max(np.abs(solved.reaction)))
    for what, found, expected in (
        ("reaction", result.reaction, solved.reaction),
        ("couple", result.couple, solved.couple),
        ("drive", result.drive, solved.drive),
        *((("mesh", result.mesh, solved.mesh),) if result.mesh is not None else ()),
    ):
        scale = max(float(np.max(np.abs(expected))), 1e-3 * size)
        assert np.max(np.abs(found - expected)) <= tolerance * scale, what
    names = [joint.name for joint in mechanism.joints]
    for joint, value in friction.items():
        assert np.max(np.abs(result.friction[names.index(joint)] - value)) <= tolerance * size, f"friction in {joint}"
    assert np.max(result.equilibrium) < 1e-12
    assert np.max(np.abs(result.virtual)) < 1e-10
    assert result.error < 1e-8
