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
from tmmcalc.manipulators.results import Manipulator

AXES = "xyz"


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
