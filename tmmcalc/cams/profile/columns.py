"""Tables of the profile stage in SI: Cartesian and polar coordinates of every curve, normal, curvature.

The polar angle is counted from OY counter-clockwise and runs on with phi, beyond a turn where it has to.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

import numpy as np

from tmmcalc.cams.follower import Complex, Follower
from tmmcalc.cams.laws.law import Values
from tmmcalc.cams.profile.results import Profile
from tmmcalc.core.quantity import Quantity, headed

X = Quantity("x_{curve}[m]", "x of {curve}")
Y = Quantity("y_{curve}[m]", "y of {curve}")
RADIUS = Quantity("R_{curve}[m]", "distance of {curve} from the axis of the cam")
POLAR = Quantity("alpha_{curve}[deg]", "polar angle of {curve}, from OY counter-clockwise")
BEND = Quantity("rho_{curve}[m]", "radius of curvature of {curve}")
NAMES = {"inner": "w", "outer": "o", "tool": "t", "outer tool": "to"}


def curves_of(result: Profile) -> Iterator[tuple[str, Complex]]:
    """The points of all curves by the index of their columns: c pitch curve, w and o walls, t and to paths of tools."""
    if result.pitch is not None:
        yield "c", result.pitch
    for wall in result.walls:
        yield NAMES[wall.name], wall.points


def profile_columns(result: Profile) -> dict[str, np.ndarray]:
    """Columns of all rows by their headers."""
    phi = result.positions.phi
    found = {"i": np.array(result.positions.labels), **headed(result.positions, "degrees")}
    for index, points in curves_of(result):
        found |= {X.of(curve=index).key: points.real, Y.of(curve=index).key: points.imag}
    for index, points in curves_of(result):
        found[RADIUS.of(curve=index).key] = np.abs(points)
        found[POLAR.of(curve=index).key] = np.degrees(polar_angle(result.follower, phi, points))
    bends = ("curvature",) if result.pitch_curvature is None else ("pitch_curvature", "curvature")
    return found | headed(result, "normal_x", "normal_y", *bends)


def polar_angle(follower: Follower, phi: Values, points: Complex) -> Values:
    """The polar angle (n,) [rad] of points that belong to phi, continuous over the turn.

    In the axes that stay with the follower a point keeps near its lift, or near its rocker's side, whence no jump.
    """
    mirrored = follower.sense < 0
    rocker = follower.kind == "oscillating"
    canonical = (np.conj(points) if rocker else -np.conj(points)) if mirrored else points
    towards = 1j * follower.assembly if rocker else 1j
    found = np.angle(canonical * np.exp(-1j * phi) / towards) + np.angle(towards) + phi
    if mirrored:
        found = -found if rocker else pi - found
    return np.asarray(found - pi / 2)
