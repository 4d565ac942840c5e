"""The columns of the unsteady table: those of kinematics, over the time, with the input coordinate first.

t          time
x v a      input coordinate, its speed and acceleration
S_D vS_D aS_D   output D: its coordinate, not counted from a start
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tmmcalc.core.columns import Column
from tmmcalc.core.plane import Real
from tmmcalc.linkage.unsteady.results import Unsteady

LINEAR = ("m", "m/s", "m/s^2")
ANGULAR = ("deg", "rad/s", "rad/s^2")


def unsteady_columns(result: Unsteady) -> list[Column]:
    """All columns of a result in their usual order; angles in degrees, everything else in SI."""
    return list(_columns(result))


def _columns(result: Unsteady) -> Iterator[Column]:
    yield _column("t", "s", result.t)
    yield from _triple(("x", "v", "a"), result.turns, result.drive)
    for k, (name, angular) in enumerate(zip(result.outputs, result.angular, strict=True)):
        yield from _triple((f"S_{name}", f"vS_{name}", f"aS_{name}"), angular, result.coordinate[:, k])
    moved = result.trace
    for k, link in enumerate(moved.link_ids):
        rows = np.stack((moved.angle[k], moved.dangle[k], moved.ddangle[k]))
        yield from _triple((f"angle_{link}", f"omega_{link}", f"eps_{link}"), True, rows)
    for k, point in enumerate(moved.point_names):
        plane = np.stack((moved.r[k], moved.dr[k], moved.ddr[k]))
        for axis, rows in (("x", plane.real), ("y", plane.imag)):
            yield from _triple((f"{axis}_{point}", f"v{axis}_{point}", f"a{axis}_{point}"), False, rows)
    for k, joint in enumerate(moved.joint_names):
        rows = np.stack((moved.s[k], moved.ds[k], moved.dds[k]))
        yield from _triple((f"s_{joint}", f"v_{joint}", f"a_{joint}"), False, rows)


def _triple(names: tuple[str, str, str], angular: bool, rows: Real) -> Iterator[Column]:
    """A coordinate and its derivatives, rows (3, n)."""
    units = ANGULAR if angular else LINEAR
    for order, (name, unit) in enumerate(zip(names, units, strict=True)):
        yield _column(name, unit, np.degrees(rows[order]) if unit == "deg" else rows[order])


def _column(name: str, unit: str, values: Real) -> Column:
    return Column(name, unit, lambda: values)
