"""The survey: a dense sample of the asked range, from which extremes and dead points are refined.

What is refined is refined for V variants of a mechanism at once, whose rows stand one behind the other; one mechanism
by itself is such a stack of one. How rows are evaluated is the only thing that differs: `Evaluate`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tmmcalc.core.numerics.roots import Indices
from tmmcalc.core.plane import Real
from tmmcalc.linkage.assembly import TURN
from tmmcalc.linkage.chain import Chain, Configuration
from tmmcalc.linkage.trace import principal, unwrapped

STEPS = 360  # one a degree on a full turn
SWIFT = 1.0  # a link that turns more in one step [rad] gets that step halved
HALVINGS = 12
SAME = 1e-9  # angles nearer than this [rad] to a whole turn before position 0 are position 0

Quantity = Callable[[Chain, Configuration, Indices], Real]
"""(chain of some rows, their configuration, their numbers) -> values (..., rows)."""
Evaluate = Callable[[Real, Indices, Quantity, int], Real]
"""(input coordinates (m,), their variants (m,), a quantity, order of the derivatives it needs) -> values (..., m)."""


def alone(chain: Chain) -> Evaluate:
    """How the only variant of a stack of one is evaluated."""
    return lambda x, _, quantity, order: quantity(chain, chain.evaluate(x, order=order), np.arange(len(x)))


class Survey(NamedTuple):
    """Ascending input coordinates (m,), the configuration there, and continuous angles (L, m) of ``links``."""

    x: Real
    configuration: Configuration
    links: tuple[int, ...]
    angles: Real
    full: bool  # exactly one turn: the last sample repeats the first

    def angle(self, link: int) -> Real:
        """Continuous angle of a link (m,) [rad]."""
        return self.angles[self.links.index(link)]

    def link_angles(self) -> tuple[Real, Real]:
        """Input coordinates (k,) and continuous angles (L, k); a full turn with the turns before and after it."""
        return three_turns(self.x, self.angles) if self.full else (self.x, self.angles)


def three_turns(x: Real, angles: Real) -> tuple[Real, Real]:
    """Coordinates (k,) and continuous angles (L, k) over a full turn, given at x (m,), and those before and after."""
    turns = np.array([-1, 0, 1])[:, None]
    gain = (angles[:, -1] - angles[:, 0])[:, None, None] * turns
    return (x[:-1] + TURN * turns).ravel(), (angles[:, None, :-1] + gain).reshape(len(angles), -1)


def survey(chain: Chain, low: float, high: float, start: float | None = None) -> Survey:
    """Sample the range, which must assemble. Angles lie in (-pi, pi] at ``start``, by default ``low``.

    The samples of a full turn are shifted by half a step, so that a dead centre at position 0 falls between
    two of them and is found exactly once.
    """
    turns = (high - low) / TURN if chain.turns else 1.0
    full = chain.turns and abs(turns - 1) < 1e-9
    x = np.linspace(low, high, STEPS * max(1, math.ceil(turns - 1e-9)) + 1)
    if full:
        x -= TURN / STEPS / 2
    links = tuple(sorted(link.id for link in chain.mechanism.links))
    configuration = chain.evaluate(x)
    angles = _angles(configuration, links, x)
    for _ in range(HALVINGS):
        swift = np.flatnonzero(np.max(np.abs(np.diff(angles, axis=1)), axis=0) > SWIFT)
        if not swift.size:
            break
        x = np.sort(np.concatenate((x, (x[swift] + x[swift + 1]) / 2)))
        configuration = chain.evaluate(x)
        angles = _angles(configuration, links, x)
    return Survey(x, configuration, links, _counted(chain, links, angles, x, low if start is None else start), full)


def _angles(configuration: Configuration, links: tuple[int, ...], x: Real) -> Real:
    u = [np.broadcast_to(configuration.motions[k].u, x.shape) for k in links]
    return unwrapped(np.angle(u))


def _counted(chain: Chain, links: tuple[int, ...], angles: Real, x: Real, start: float) -> Real:
    """Continuous angles (L, m) moved by whole turns into (-pi, pi] at ``start``; that of a crank is its coordinate."""
    motions = chain.evaluate(np.array([start]), order=0).motions
    first = principal(np.array([np.angle(motions[k].u).item() for k in links]))
    near = np.array([np.interp(start, x, row) for row in angles])
    counted = angles + TURN * np.rint((first - near) / TURN)[:, None]
    if chain.turns:
        counted[links.index(chain.structure.input_link)] = x
    return counted


def along_motion(chain: Chain, x: Real, start: float | Real) -> Real:
    """The same crank angles (m,), counted from ``start``, one or (m,), along the motion within one turn."""
    return within_turn(x, start, math.copysign(1.0, chain.mechanism.input.speed))


def within_turn(x: Real, start: float | Real, sense: float) -> Real:
    """The same crank angles (m,) within one turn from ``start`` on, one or (m,), in the ``sense`` of 1 or -1."""
    along = np.mod((x - start) * sense, TURN)
    return start + sense * np.where(along > TURN - SAME, along - TURN, along)
