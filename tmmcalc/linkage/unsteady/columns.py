"""The columns of the unsteady table: those of kinematics, over the time, with the input coordinate first."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmmcalc.core.columns import Column, column
from tmmcalc.core.plane import Real
from tmmcalc.core.quantity import Quantity
from tmmcalc.linkage.columns import LINK, POINT, SLIDE
from tmmcalc.linkage.unsteady.results import Unsteady

TIME = Quantity("t[s]", "time")
INPUT = (
    Quantity("x[{own}]", "input coordinate"),
    Quantity("v[{velocity}]", "speed of the input"),
    Quantity("a[{acceleration}]", "acceleration of the input"),
)
OUTPUT = (
    Quantity("S_{output}[{own}]", "coordinate of output {output}, not counted from a start"),
    Quantity("vS_{output}[{velocity}]", "velocity of output {output}"),
    Quantity("aS_{output}[{acceleration}]", "acceleration of output {output}"),
)
LINEAR = {"own": "m", "length": "m", "velocity": "m/s", "acceleration": "m/s^2"}
ANGULAR = {"own": "deg", "velocity": "rad/s", "omega": "rad/s", "acceleration": "rad/s^2", "eps": "rad/s^2"}


def unsteady_columns(result: Unsteady) -> list[Column]:
    """All columns of a result in their usual order; angles in degrees, everything else in SI."""
    return list(_columns(result))


def _columns(result: Unsteady) -> Iterator[Column]:
    yield _column(TIME, result.t)
    yield from _triple(INPUT, result.turns, result.drive)
    for k, (name, angular) in enumerate(zip(result.outputs, result.angular, strict=True)):
        yield from _triple(OUTPUT, angular, result.coordinate[:, k], output=name)
    moved = result.trace
    for k, link in enumerate(moved.link_ids):
        rows = np.stack((moved.angle[k], moved.dangle[k], moved.ddangle[k]))
        yield from _triple(LINK[:3], True, rows, link=link)
    for k, point in enumerate(moved.point_names):
        plane = np.stack((moved.r[k], moved.dr[k], moved.ddr[k]))
        for axis, rows in (("x", plane.real), ("y", plane.imag)):
            yield from _triple(POINT[:3], False, rows, axis=axis, point=point)
    for k, joint in enumerate(moved.joint_names):
        rows = np.stack((moved.s[k], moved.ds[k], moved.dds[k]))
        yield from _triple(SLIDE[:3], False, rows, slide=joint)


def _triple(told: Sequence[Quantity], angular: bool, rows: Real, **places: object) -> Iterator[Column]:
    """A coordinate and its derivatives, rows (3, n)."""
    units = ANGULAR if angular else LINEAR
    for each, row in zip(told, rows, strict=True):
        own = each.of(**places, **units)
        yield _column(own, np.degrees(row) if own.unit == "deg" else row)


def _column(told: Quantity, values: Real) -> Column:
    return column(told, lambda: values)
