"""The open pair of gears between the output shaft of a reducer and the crank: what it is to the drive.

The pinion a stands on the output shaft, the gear b on the crank:

    u = z_b/z_a,   J = J_a u^2 + J_b at the crank

with the inertias of solid pinions, webbed wheels and rings as a train has them (4.43, 4.44). Its efficiency is given,
or by the friction of the teeth, or the general value of a mesh.
"""

from __future__ import annotations

from functools import cache
from math import cos

import numpy as np

from tmmcalc.core.records import record
from tmmcalc.gears.criteria.wheels import wheels
from tmmcalc.gears.layouts.open_pair import OPEN, OPEN_RING
from tmmcalc.gears.meshing.task import PairTask
from tmmcalc.gears.model import ToothSets


@record
class OpenPair:
    """An open pair: its geometry, and what is given of its losses and its inertia."""

    pair: PairTask  # pinion a and gear b, with module and face width
    efficiency: float
    efficiency_of: str  # where that comes from
    inertia: float | None = None  # at the crank [kg*m^2], as given; None: by its sizes

    @property
    def name(self) -> str:
        """What it is called beside a train.

        >>> OpenPair(PairTask((17, 51), 0.006, face_width=0.06), 0.95, "given").name
        'open pair 17/51'
        """
        return f"open pair {self.pair.teeth[0]}/{self.pair.teeth[1]}"

    @property
    def ratio(self) -> float:
        """Speed of the pinion's shaft over that of the crank, u = z_b/z_a."""
        return self.pair.teeth[1] / self.pair.teeth[0]

    @property
    def on_crank(self) -> float:
        """Moment of inertia of both wheels reduced to the crank [kg*m^2]."""
        if self.inertia is not None:
            return self.inertia
        pinion, gear = wheel_inertias(self.pair)
        return pinion * self.ratio**2 + gear


def tooth_sets(pair: PairTask) -> ToothSets:
    """The pair as a train of one stage."""
    layout = OPEN_RING if pair.kind == "internal" else OPEN
    return ToothSets(layout.key, np.array([pair.teeth]), np.ones((1, 1), np.int64), np.full((1, 1), pair.rack.angle))


def wheel_inertias(pair: PairTask) -> tuple[float, float]:
    """Moments of inertia of pinion and gear about their own axes [kg*m^2], of their reference diameters m z/cos(beta).

    >>> [round(J, 6) for J in wheel_inertias(PairTask((17, 51), 0.006, face_width=0.06))]
    [0.004986, 0.212089]
    """
    assert pair.face_width is not None
    module = np.array([[pair.module / cos(pair.helix)]])
    pinion, gear = wheels(tooth_sets(pair), module, np.array([[pair.face_width]])).inertias[0].tolist()
    return pinion, gear


@cache
def pitch_of_gear(pair: PairTask) -> tuple[float, float]:
    """Operating pitch radius [m] of the gear on the crank and the operating pressure angle [rad], both transverse.

    Raises `NoSolutionError` for a pair that does not exist.
    """
    from tmmcalc.gears.meshing.solve import solve_pair

    found = solve_pair(pair)
    return found.sizes[1].operating, found.angle_w
