"""What rounding leaves of the motion, its extremes and the constants of its laws."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmmcalc.cams.laws.constants import LawConstants
from tmmcalc.cams.laws.law import ORDERS, Law, Values
from tmmcalc.cams.program import Positions, Program
from tmmcalc.cams.rounding import Errors, again, chosen, joints, nearer, relative, sides
from tmmcalc.cams.wide import wide

NAMES = ("displacement", "velocity", "acceleration", "jerk")


def motion_errors(program: Program, rows: Positions, motion: Values) -> Errors:
    """Estimates of y, y', y'', y''' (4, n) at the rows."""
    which = chosen(len(rows.phi), *motion)
    _, exact = again(program, rows, which)
    missed = joints(program)
    size = np.max(np.abs(motion), axis=1)
    return {
        name: relative(motion[k, which], exact[k], float(size[k])) + float(missed[k]) for k, name in enumerate(NAMES)
    }


def extreme_errors(program: Program, orders: Sequence[int], values: Sequence[float], phi: Sequence[float]) -> float:
    """The largest estimate of extremes of derivatives of y, each by its order, value and angle."""
    rows = sides(program, np.array(phi))
    exact = program.wider.at(wide(rows.phi), rows.piece)
    found = np.array(values)
    worst = 0.0
    for order in range(ORDERS):
        own = np.flatnonzero(np.array(orders) == order)
        if own.size:
            worst = max(worst, nearer(found[own], exact[order][np.concatenate((own, own + len(found)))]))
    return worst


def constant_errors(law: Law, found: LawConstants) -> float:
    """The largest estimate of Cv, Ca, the braking and the power, each relative to itself; the law is a wide one."""
    return max(_constants(law, found))


def _constants(law: Law, found: LawConstants) -> Iterator[float]:
    at = wide(np.array([found.velocity_at, found.acceleration_at, found.braking_at, found.power_at]))
    near = np.longdouble(1e-12)
    exact = np.stack([law.at(at, law.piece(at + shift)) for shift in (-near, near)], axis=1)
    yield nearer([found.velocity], exact[1, :, 0])
    yield nearer([found.acceleration], np.abs(exact[2, :, 1]))
    yield nearer([found.braking], exact[2, :, 2])
    yield nearer([found.power], exact[1, :, 3] * exact[2, :, 3])
