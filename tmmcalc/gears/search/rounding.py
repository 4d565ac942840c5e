"""What rounding leaves of the operating angles of tooth sets; their ratios are exact fractions."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmmcalc.core.numerics.extended import apart, spread
from tmmcalc.gears.model import ToothSets, TrainTask
from tmmcalc.gears.search.blocks import Block
from tmmcalc.gears.search.constraints import stretches

CHOSEN = 12  # sets of each kind


def angle_error(task: TrainTask, sets: ToothSets) -> float:
    """Error of the operating pressure angles relative to the largest, of sets again in extended precision.

    The arc cosine loses digits where an angle is small; the sets of the smallest angles and an even choice of the
    others are taken. 0 where no mesh departs from the angle of the rack.
    """
    shifted = np.flatnonzero((sets.angles != task.pressure_angle).any(axis=1))
    if not len(shifted):
        return 0.0
    smallest = np.argsort(sets.angles[shifted].min(axis=1), kind="stable")[:CHOSEN]
    rows = shifted[sorted({*spread(len(shifted), CHOSEN).tolist(), *smallest.tolist()})]
    teeth, modules = sets.teeth[rows].astype(np.longdouble), sets.modules[rows]
    wheels: Any = {wheel: teeth[:, k] for k, wheel in enumerate(task.scheme.wheels)}
    block = Block(wheels, tuple(modules[:, k] for k in range(modules.shape[1])))
    cosine = np.cos(np.longdouble(task.pressure_angle))
    exact = np.stack([np.arccos(cosine / stretch) for stretch in stretches(task, block)], axis=1)
    return apart(sets.angles[rows], exact)
