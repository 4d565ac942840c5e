"""The motion as pictures need it: a dense cycle for smooth curves, and the places of links in chosen positions."""

from __future__ import annotations

import math

import numpy as np

from tmmcalc.core.plane import Plane, Real
from tmmcalc.core.records import record
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.results import Kinematics

SAMPLES = 721  # every half degree of a full turn
TURN = 2 * math.pi


@record
class LinkageMotion:
    """A mechanism at input coordinates ``x`` (n,)."""

    chain: Chain
    x: Real
    configuration: Configuration

    def place(self, link: int, p: complex) -> Plane:
        """Places (n,) of a point given in the axes of a link [m]."""
        return np.broadcast_to(self.configuration.motions[link].point(p).r, self.x.shape)

    def turn(self, link: int) -> Plane:
        """Unit vectors (n,) along the x axis of a link."""
        return np.broadcast_to(self.configuration.motions[link].u, self.x.shape)

    def slide(self, joint: str) -> Real:
        """Coordinates (n,) of a prismatic joint [m]."""
        return np.broadcast_to(self.configuration.slides[joint].s, self.x.shape)


def motion_at(chain: Chain, x: Real) -> LinkageMotion:
    """The motion at these input coordinates, with derivatives."""
    return LinkageMotion(chain, x, chain.evaluate(x))


def whole_cycle(chain: Chain, result: Kinematics) -> LinkageMotion:
    """The whole range of the input from position 0, densely."""
    span = chain.mechanism.grid.span or TURN
    along = np.linspace(0.0, math.copysign(1.0, result.speed) * span, SAMPLES)
    return motion_at(chain, result.x[0] + along)


def closed(chain: Chain) -> bool:
    """Whether the range is one full turn, so that its end is its beginning."""
    span = chain.mechanism.grid.span
    return chain.turns and (span is None or math.isclose(abs(span), TURN))


def along(result: Kinematics, x: float, full: bool) -> float:
    """Input coordinate counted from position 0; on a full turn within one turn along the motion."""
    sense = math.copysign(1.0, result.speed)
    distance = (x - float(result.x[0])) * sense
    if full:
        distance %= TURN
        distance = 0.0 if TURN - distance < 1e-9 else distance
    return sense * distance
