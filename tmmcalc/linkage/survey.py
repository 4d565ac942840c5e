"""The survey: a dense sample of the asked range, from which extremes and dead points are refined."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.plane import Real
from tmmcalc.linkage.trace import unwrapped

STEPS = 360  # one a degree on a full turn
SWIFT = 1.0  # a link that turns more in one step [rad] gets that step halved
HALVINGS = 12


class Survey(NamedTuple):
    """Ascending input coordinates (m,), the configuration there, and continuous angles (L, m) of ``links``."""

    x: Real
    configuration: Configuration
    links: tuple[int, ...]
    angles: Real
    full: bool  # a whole turn: the last sample repeats the first

    def angle(self, link: int) -> Real:
        """Continuous angle of a link (m,) [rad]."""
        return self.angles[self.links.index(link)]


def survey(chain: Chain, low: float, high: float) -> Survey:
    """Sample the range, which must assemble.

    The samples of a full turn are shifted by half a step, so that a dead centre at position 0 falls between
    two of them and is found exactly once.
    """
    full = chain.turns and high - low > TURN - 1e-9
    x = np.linspace(low, high, STEPS + 1)
    if full:
        x -= TURN / STEPS / 2
    links = tuple(sorted(link.id for link in chain.mechanism.links))
    for _ in range(HALVINGS):
        configuration = chain.evaluate(x)
        angles = _angles(configuration, links, x)
        swift = np.flatnonzero(np.max(np.abs(np.diff(angles, axis=1)), axis=0) > SWIFT)
        if not swift.size:
            break
        x = np.sort(np.concatenate((x, (x[swift] + x[swift + 1]) / 2)))
    return Survey(x, configuration, links, angles, full)


def _angles(configuration: Configuration, links: tuple[int, ...], x: Real) -> Real:
    u = [np.broadcast_to(configuration.motions[k].u, x.shape) for k in links]
    return unwrapped(np.angle(u))
