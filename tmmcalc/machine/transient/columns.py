"""The columns of the table of motions in time; a single mass has no number."""

from __future__ import annotations

from functools import partial

import numpy as np

from tmmcalc.core.columns import Column, column, columns_of
from tmmcalc.core.quantity import Quantity
from tmmcalc.machine.transient.timed import TimedMotion, TimedMotions

ANGLE = Quantity("theta{mass}[deg]", "angle of a rotating mass; 1 is the motor's")
SPEED = Quantity("omega{mass}[rad/s]", "speed of a rotating mass")
ACCELERATION = Quantity("alpha{mass}[rad/s^2]", "acceleration of a rotating mass")
SHAFT = Quantity("M_{before}_{after}[N*m]", "moment of the shaft between masses {before} and {after} towards the crank")


def timed_columns(motion: TimedMotion) -> list[Column]:
    """All columns of a motion in time in their usual order."""
    rows = ((ANGLE, np.degrees(motion.theta)), (SPEED, motion.omega), (ACCELERATION, motion.alpha))
    masses = [
        column(told.of(mass=f"_{k + 1}" if len(motion.masses) > 1 else ""), partial(row.__getitem__, k))
        for k in range(len(motion.masses))
        for told, row in rows
    ]
    shafts = [
        column(SHAFT.of(before=k + 1, after=k + 2), partial(motion.shaft_moment.__getitem__, k))
        for k in range(len(motion.masses) - 1)
    ]
    time, *further = columns_of(motion)
    return [time, *masses, *shafts, *further]


def stacked_columns(result: TimedMotions) -> list[Column]:
    """The same of all motions, one after the other; the masses of the drive are the same in all."""
    every = zip(*map(timed_columns, result.motions), strict=True)
    return [same[0]._replace(make=partial(_joined, same)) for same in every]


def _joined(same: tuple[Column, ...]) -> np.ndarray:
    return np.concatenate([each.make() for each in same])
