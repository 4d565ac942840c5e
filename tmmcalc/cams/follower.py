"""The cam and its follower: sizes, senses, and the one frame in which everything is computed.

Canonical frame: the cam turns clockwise; in the inverted motion it stands and the rest turns counter-clockwise by phi.
A cam that turns the other way is the mirror image: sigma = -1 mirrors what comes out.

    RT   OY is the direction of the lift at phi = 0; the follower's axis passes O at e on its right   S0, e
    PT   the same with a flat face across the axis                                                   S0
    RK   OX leads from O to the pivot A of the rocker at phi = 0; delta = +1: on the rise the rocker
         turns as the cam does; psi is the angle between the line of centres and the rocker           l0, l2, psi0
"""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from tmmcalc.cams.laws.law import Values
from tmmcalc.core.quantity import derived, quantity
from tmmcalc.core.records import record

FollowerKind = Literal["translating", "oscillating", "flat"]  # RT, RK, PT of the textbook
Closure = Literal["force", "groove"]
Complex = NDArray[np.complexfloating]


@record
class Follower:
    """A follower on its cam; lengths [m], angles [rad]."""

    kind: FollowerKind
    start: float  # S0 (RT, PT) [m] or psi0 (RK) [rad]: the position at phi = 0
    offset: float = 0.0  # e, canonical: positive where it steepens the rise; RT
    roller: float = quantity("r2[m]", "radius of the roller", default=0.0)  # 0: knife edge
    centres: float = 0.0  # l0 = OA; RK
    rocker: float = 0.0  # l2 = AC; RK
    assembly: int = 1  # delta; RK
    sense: int = 1  # sigma: +1 the cam turns clockwise, -1 counter-clockwise

    @derived("R0[m]", "radius of the base circle, with a roller of the pitch curve", symbol="R_0")
    def base(self) -> float:
        """Of the pitch curve, or of the profile under a flat face."""
        if self.kind == "flat":
            return self.start
        if self.kind == "translating":
            return float(np.hypot(self.start, self.offset))
        square = self.centres**2 + self.rocker**2 - 2 * self.centres * self.rocker * np.cos(self.start)
        return float(np.sqrt(max(square, 0.0)))

    @derived("rotation", "sense in which the cam turns")
    def rotation(self) -> str:
        """In words."""
        return "clockwise" if self.sense > 0 else "counter-clockwise"

    @derived("rocker_turn", "sense of the rocker on its rise: with the cam or against it")
    def rocker_turn(self) -> str:
        """In words."""
        return "with" if self.assembly > 0 else "against"

    def placed(self, points: Complex) -> Complex:
        """Canonical points in the user's axes: x mirrored for a translating follower, y for a rocker (sigma = -1)."""
        if self.sense > 0:
            return points
        return np.conj(points) if self.kind == "oscillating" else -np.conj(points)


def along(turns: bool) -> dict[str, str]:
    """What stands for the places in keys of quantities along the lift: a rocker turns, and has moments for forces."""
    if turns:
        own = {"coordinate": "psi", "size": "rad", "slope": "", "load": "M", "spring": "M", "given": "M_Q"}
        return own | {"force": "N*m", "rate": "N*m/rad"}
    own = {"coordinate": "S", "size": "m", "slope": "m", "load": "P", "spring": "Q", "given": "Q"}
    return own | {"force": "N", "rate": "N/m"}


def contact_path(follower: Follower, phi: Values, motion: Values) -> Complex:
    """The pitch curve, or under a flat face the profile itself, with its first and second derivatives, (3, n).

    ``motion`` (4, n) are the displacement and its derivatives at phi; the curve is canonical, run through
    counter-clockwise, its inside on the left (5.14 to 5.19, 5.28 to 5.34, 5.93).
    """
    y, y1, y2, y3 = motion
    turn = np.exp(1j * phi)
    if follower.kind == "oscillating":
        w, d = 1 - follower.assembly * y1, follower.assembly
        arm = follower.rocker * np.exp(1j * (phi - d * (follower.start + y)))
        axis = follower.centres * turn
        return np.stack((axis - arm, 1j * (axis - w * arm), -axis + (w * w + 1j * d * y2) * arm))
    s = follower.start + y
    if follower.kind == "flat":
        return np.stack(((1j * s - y1) * turn, -(s + y2) * turn, -(y1 + y3 + 1j * (s + y2)) * turn))
    e = follower.offset
    return np.stack(((e + 1j * s) * turn, (1j * (y1 + e) - s) * turn, (1j * (y2 - s) - (2 * y1 + e)) * turn))


def curvature(path: Complex) -> Values:
    """Curvature (n,) of a curve from its derivatives (3, n), positive where it bulges outwards (5.35)."""
    _, first, second = path
    speed = np.abs(first)
    return (np.conj(first) * second).imag / speed**3
