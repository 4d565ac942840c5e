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

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.columns import Column
from tmmcalc.core.numerics.panels import Values
from tmmcalc.core.quantity import Quantity
from tmmcalc.manipulators.results import Manipulator

AXES = "xyz"

TOLD = (
    Quantity("t[s]", "time"),
    Quantity("s[m]", "way along the path"),
    Quantity("v[m/s]", "speed along the path"),
    Quantity("a[m/s^2]", "tangential acceleration along the path"),
    Quantity("{along}[m]", "coordinate {along} of the gripper"),
    Quantity("v{along}[m/s]", "velocity of the gripper along {along}"),
    Quantity("a{along}[m/s^2]", "acceleration of the gripper along {along}"),
    Quantity("{along}_E[m]", "coordinate {along} of the elbow"),
    Quantity("psi[deg]", "angle of the base"),
    Quantity("omega_1[rad/s]", "angular velocity of the base"),
    Quantity("eps_1[rad/s^2]", "angular acceleration of the base"),
    Quantity("phi_2[deg]", "angle of the arm above the horizontal"),
    Quantity("omega_2[rad/s]", "angular velocity of the arm"),
    Quantity("eps_2[rad/s^2]", "angular acceleration of the arm"),
    Quantity("phi_3[deg]", "angle of the forearm above the horizontal"),
    Quantity("omega_3[rad/s]", "angular velocity of the forearm"),
    Quantity("eps_3[rad/s^2]", "angular acceleration of the forearm"),
    Quantity("elbow[deg]", "angle between upper arm and forearm"),
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
    yield _column("t", "s", result.t)
    if result.inverse:
        for name, unit, row in zip(("s", "v", "a"), ("m", "m/s", "m/s^2"), result.way, strict=True):
            yield _column(name, unit, row)
    for order, (prefix, unit) in enumerate((("", "m"), ("v", "m/s"), ("a", "m/s^2"))):
        for axis, row in zip(AXES, result.gripper[order], strict=False):
            yield _column(f"{prefix}{axis}", unit, row)
    for k, joint in enumerate(result.arm.joints):
        units = ("deg", "rad/s", "rad/s^2") if joint.turns else ("m", "m/s", "m/s^2")
        for order, (name, unit) in enumerate(zip(joint[:3], units, strict=True)):
            yield _column(name, unit, np.degrees(result.q[order, k]) if unit == "deg" else result.q[order, k])
    if result.elbow is not None and result.elbow_angle is not None:
        yield _column("elbow", "deg", np.degrees(result.elbow_angle[0]))
        for axis, row in zip(AXES, result.elbow, strict=False):
            yield _column(f"{axis}_E", "m", row)


def _column(name: str, unit: str, values: Values) -> Column:
    return Column(name, unit, lambda: values)
