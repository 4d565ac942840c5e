"""The columns of the manipulator table.

t, s v a                        time; way along the path, its speed and acceleration
x y z  vx vy vz  ax ay az       gripper; z only with a turning base
psi omega_1 eps_1               base
phi_2 omega_2 eps_2             elevation of the arm, or direction of the upper arm
phi_3 omega_3 eps_3, elbow      direction of the forearm; its angle with the upper arm
l_3 v_3 a_3,  h v_h a_h,  r v_r a_r
x_E y_E z_E                     elbow
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np

from tmmcalc.core.columns import Column, column
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import Quantity
from tmmcalc.manipulators.results import Manipulator

AXES = "xyz"

TIME = Quantity("t[s]", "time")
WAY = (
    Quantity("s[m]", "way along the path"),
    Quantity("v[m/s]", "speed along the path"),
    Quantity("a[m/s^2]", "tangential acceleration along the path"),
)
GRIPPER = (
    Quantity("{along}[m]", "coordinate {along} of the gripper"),
    Quantity("v{along}[m/s]", "velocity of the gripper along {along}"),
    Quantity("a{along}[m/s^2]", "acceleration of the gripper along {along}"),
)
ELBOW = Quantity("{along}_E[m]", "coordinate {along} of the elbow")
ELBOW_ANGLE = Quantity("elbow[deg]", "angle from the upper arm to the forearm")
JOINTS = (
    Quantity("psi[deg]", "angle of the base"),
    Quantity("omega_1[rad/s]", "angular velocity of the base"),
    Quantity("eps_1[rad/s^2]", "angular acceleration of the base"),
    Quantity("phi_2[deg]", "angle of the arm above the horizontal"),
    Quantity("omega_2[rad/s]", "angular velocity of the arm"),
    Quantity("eps_2[rad/s^2]", "angular acceleration of the arm"),
    Quantity("phi_3[deg]", "angle of the forearm above the horizontal"),
    Quantity("omega_3[rad/s]", "angular velocity of the forearm"),
    Quantity("eps_3[rad/s^2]", "angular acceleration of the forearm"),
    Quantity("l_3[m]", "extension of the arm"),
    Quantity("v_3[m/s]", "velocity of the extension"),
    Quantity("a_3[m/s^2]", "acceleration of the extension"),
    Quantity("h[m]", "height of the arm"),
    Quantity("v_h[m/s]", "velocity of the lift"),
    Quantity("a_h[m/s^2]", "acceleration of the lift"),
    Quantity("r[m]", "reach of the arm"),
    Quantity("v_r[m/s]", "velocity of the reach"),
    Quantity("a_r[m/s^2]", "acceleration of the reach"),
)


def manipulator_columns(result: Manipulator) -> list[Column]:
    """All columns of a result in their usual order; angles in degrees, everything else in SI."""
    return list(_columns(result))


def _columns(result: Manipulator) -> Iterator[Column]:
    yield column(TIME, lambda: result.t)
    if result.inverse:
        yield from _of_rows(WAY, result.way)
    for told, rows in zip(GRIPPER, result.gripper, strict=True):
        yield from _along(told, rows)
    joints = {each.name: each for each in JOINTS}
    for k, joint in enumerate(result.arm.joints):
        yield from _of_rows([joints[name] for name in joint[:3]], result.q[:, k])
    if result.elbow is not None and result.elbow_angle is not None:
        yield from _of_rows([ELBOW_ANGLE], result.elbow_angle[:1])
        yield from _along(ELBOW, result.elbow)


def _along(told: Quantity, rows: Values) -> Iterator[Column]:
    """The columns along the axes of the gripper's space."""
    return _of_rows([told.of(along=axis) for axis in AXES[: len(rows)]], rows)


def _of_rows(told: Sequence[Quantity], rows: Values) -> Iterator[Column]:
    """The columns of quantities; an angle [rad] is told in degrees."""
    for each, row in zip(told, rows, strict=True):
        yield column(each, partial(np.degrees, row) if each.unit == "deg" else partial(np.asarray, row))
