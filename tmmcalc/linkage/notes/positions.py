"""The positions that the note works out."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmmcalc.linkage.chain import chain_of
from tmmcalc.linkage.model import Mechanism
from tmmcalc.linkage.pictures.cycle import along, closed
from tmmcalc.linkage.results import Kinematics


def by_default(mechanism: Mechanism, result: Kinematics) -> list[int]:
    """One position of the working stroke of the first output and one of the idle stroke, in the middle of each."""
    first: Any = result.summaries[0] if result.summaries else None
    last = float(result.phi[-1])
    if first is None or first.working_angle is None or first.idle_angle is None:
        places = np.array([last / 4, 3 * last / 4])
    else:
        sense = np.sign(result.speed)
        start = along(result, first.dead_centres[0].x, closed(chain_of(mechanism, result)))
        middle = start + sense * first.working_angle / 2
        places = np.array([middle, start + sense * (first.working_angle + first.idle_angle / 2)])
    apart = np.abs(result.phi - places[:, None])
    if result.turns:
        apart = np.abs(np.angle(np.exp(1j * apart)))
    return list(dict.fromkeys(np.argmin(apart, axis=1).tolist()))
