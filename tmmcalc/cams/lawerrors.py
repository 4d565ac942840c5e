"""What rounding leaves of the motion, its extremes and the constants of its laws."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from tmmcalc.cams.laws.constants import LawConstants
from tmmcalc.cams.laws.law import ORDERS, Law, Values
from tmmcalc.cams.program import Positions, Program
from tmmcalc.cams.rounding import Errors, again, chosen, law_joints, nearer, relative, sides, steep
from tmmcalc.cams.wide import wide
from tmmcalc.core.numerics.extended import EPS

NAMES = ("displacement", "velocity", "acceleration", "jerk")


def motion_errors(program: Program, rows: Positions, motion: Values, missed: Values) -> Errors:
    """Estimates of y, y', y'', y''' (4, n) at the rows; ``missed`` (4,) is what `joints` finds.

    A rounding of phi moves each by its own derivative times that: where this is steep in few rows none of those that
    are computed again may show it.
    """
    which = chosen(len(rows.phi), *motion, *steep(rows.phi, motion))
    _, exact = again(program, rows, which)
    size = np.max(np.abs(motion), axis=1)
    moved = EPS * np.max(np.abs(motion[1:] * rows.phi), axis=1, initial=0.0) / np.where(size[:-1] > 0, size[:-1], 1.0)
    return {
        name: max(relative(motion[k, which], exact[k], float(size[k])), shift) + float(missed[k])
        for k, (name, shift) in enumerate(zip(NAMES, [*moved.tolist(), 0.0], strict=True))
    }


def extreme_errors(
    program: Program, missed: Values, orders: Sequence[int], values: Sequence[float], phi: Sequence[float]
) -> float:
    """The largest estimate of extremes of derivatives of y, each by its order, value and angle."""
    rows = sides(program, np.array(phi))
    exact = program.wider.at(wide(rows.phi), rows.piece)
    found = np.array(values)
    worst = 0.0
    for order in range(ORDERS):
        own = np.flatnonzero(np.array(orders) == order)
        if own.size:
            true = exact[order][np.concatenate((own, own + len(found)))]
            worst = max(worst, nearer(found[own], true) + float(missed[order]))
    return worst


def constant_errors(law: Law, found: LawConstants) -> float:
    """The largest estimate of Cv, Ca, Cj, the braking with its lift, the power, each relative to itself.

    The law is a wide one.
    """
    return max(_constants(law, found))


def _constants(law: Law, found: LawConstants) -> Iterator[float]:
    at = wide(np.array([found.velocity_at, found.acceleration_at, found.braking_at, found.power_at]))
    near = np.longdouble(1e-12)
    exact = np.stack([law.at(at, law.piece(at + shift)) for shift in (-near, near)], axis=1)
    missed = law_joints(law).tolist()
    yield nearer([found.velocity], exact[1, :, 0]) + missed[1]
    yield nearer([found.acceleration], np.abs(exact[2, :, 1])) + missed[2]
    yield nearer([found.braking], exact[2, :, 2]) + missed[2]
    yield nearer([found.power], exact[1, :, 3] * exact[2, :, 3]) + missed[1] + missed[2]
