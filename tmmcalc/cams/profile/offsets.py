"""Offsets of the pitch curve: walls of the cam and paths of tools.

    w = z + d n,  n = i z'/|z'|        w' = (1 - kappa d) z'                          (5.26, 5.27)

d is counted inwards: the roller radius r2 gives the working profile, -r2 the second wall of a groove, r2 - r_t the
centre of a tool of radius r_t on the working profile. Under a flat face z is the profile itself, n = -i exp(i phi), and

    w' = -(rho - d) exp(i phi),  rho = S + S''                                         (5.95)
"""

from __future__ import annotations

import numpy as np

from tmmcalc.cams.follower import Complex, Follower, contact_path, curvature
from tmmcalc.cams.laws.law import Indices, Values
from tmmcalc.cams.program import TURN, Program
from tmmcalc.core.records import record


@record
class Frame:
    """The pitch curve (flat face: the profile) at n angles, canonical."""

    points: Complex  # (n,) [m]
    tangent: Complex  # (n,) unit, counter-clockwise
    speed: Values  # (n,) [m], |z'|; under a flat face rho, which may be negative
    bend: Values  # (n,) [1/m] curvature; under a flat face 1

    def offset(self, distance: float) -> Complex:
        """The points (n,) of an offset."""
        return self.points + distance * 1j * self.tangent

    def rate(self, distance: float, flat: bool) -> Complex:
        """The derivative (n,) of an offset by phi."""
        return self.factor(distance, flat) * self.tangent * (1.0 if flat else self.speed)

    def factor(self, distance: float, flat: bool) -> Values:
        """What turns negative where an offset runs backwards: 1 - kappa d, or rho - d [m]."""
        return self.speed - distance if flat else 1 - self.bend * distance


def frame(follower: Follower, phi: Values, motion: Values) -> Frame:
    """Points, tangents and curvature at phi (n,) with the motion (4, n)."""
    path = contact_path(follower, phi, motion)
    if follower.kind == "flat":
        return Frame(path[0], -np.exp(1j * phi), follower.start + motion[0] + motion[2], np.ones_like(phi))
    speed = np.abs(path[1])
    return Frame(path[0], path[1] / speed, speed, curvature(path))


def working_curvature(here: Frame, roller: float, flat: bool) -> Values:
    """kappa/(1 - kappa r2) or 1/rho; at the very point of a cusp the largest number that a float holds."""
    top, below = (np.ones_like(here.speed), here.speed) if flat else (here.bend, 1 - here.bend * roller)
    tiny = np.abs(top) / np.finfo(float).max + np.finfo(float).tiny
    return top / np.where(np.abs(below) > tiny, below, np.finfo(float).eps)


@record
class Rim:
    """The curve of a follower over the whole turn."""

    follower: Follower
    program: Program

    @property
    def flat(self) -> bool:
        """Under a flat face."""
        return self.follower.kind == "flat"

    def at(self, phi: Values, piece: Indices | None = None) -> Frame:
        """The frame at any angles (n,), taken into the turn; ``piece`` says which side of a jump is meant."""
        if piece is None:
            phi = np.mod(phi, TURN)
        return frame(self.follower, phi, self.program.at(phi, piece))

    def pieces(self, phi: Values) -> Indices:
        """Numbers (n,) of the pieces of the motion that hold phi, none of them on an edge."""
        edges = self.program.edges
        return np.clip(np.searchsorted(edges, phi) - 1, 0, len(edges) - 2)
