"""The picture of generation: positions of the rack and the path of S, seen from the wheel, in the axes of its tooth.

The rack's line rolls on the reference circle; at the roll angle phi a point x1 + i y1 of the rack lies in the wheel at
(x1 - r phi + i (y1 + r)) exp(-i phi) (4.75), turned by psi into the axes of the tooth.
"""

from __future__ import annotations

from math import pi, tan

import numpy as np

from tmmcalc.core.plane import Plane, Real
from tmmcalc.gears.involute.profile.flank import Flank


def rack_outline(flank: Flank, teeth: int = 1, points: int = 33) -> Plane:
    """Teeth of the rack (n,) in the rack's axes, from the right to the left [module]; the first cuts the flank.

    ``points`` are those of a rounding; the straight flanks reach the rack's addendum above the datum line.
    """
    tool, wheel = flank.rounding, flank.wheel
    top = float(wheel.shift) + wheel.rack.addendum
    right = np.concatenate([[top * complex(tan(tool.angle), 1)], tool.on_rack(np.linspace(tool.angle, pi / 2, points))])
    axis = float(tool.x) - tool.flat
    tooth = np.concatenate([right, 2 * axis - np.conj(right[::-1])])
    pitch = pi * wheel.section.module
    return (tooth - pitch * np.arange(teeth)[:, None]).ravel()


def in_wheel(flank: Flank, of_rack: Plane | complex, rolls: Real) -> Plane:
    """Points (n,) of the rack at roll angles (k,) in the axes of the tooth (k, n)."""
    roll = np.asarray(rolls, float)[:, None]
    centre = flank.wheel.reference
    turn = np.exp(1j * (float(flank.wheel.half_angle) - roll))
    return (np.atleast_1d(of_rack) - centre * roll + 1j * centre) * turn


def path_of_centre(flank: Flank, rolls: Real) -> Plane:
    """The path (k,) of S, the centre of the tip rounding, at roll angles (k,)."""
    tool = flank.rounding
    return in_wheel(flank, complex(float(tool.x), float(tool.y)), rolls)[:, 0]
