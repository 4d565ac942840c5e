"""Criteria of quality of many six-bars at once, on the steps of their turns: what the optimisation weighs.

f1 = max |S|/h over the dwell, h the stroke (swing); f2 = 1/l_OA of a slider; f3 = max tan|delta| over the turn;
f4 = max f3^2 + max f4^2 of the bar forces for unit resistance over the working stroke, f5 over the idle stroke.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.linkage.plane import Real
from tmmcalc.linkage.synthesis.dwell.linkages import Flags
from tmmcalc.linkage.synthesis.dwell.task import DwellTask
from tmmcalc.linkage.synthesis.dwell.turn import Turn
from tmmcalc.linkage.synthesis.dwell.unitforces import unit_forces

NAMES = ("f1", "f2", "f3", "f4", "f5")


class Criteria(NamedTuple):
    """The criteria, each (k,)."""

    f1: Real
    f2: Real
    f3: Real
    f4: Real
    f5: Real

    def cost(self, weights: tuple[float, ...]) -> Real:
        """Weighted sum (k,)."""
        return np.asarray(sum(w * f for w, f in zip(weights, self, strict=True)))


class Strokes(NamedTuple):
    """Turns of the crank from position 1, counter-clockwise [rad]: begin and end of both strokes."""

    working: tuple[Real, Real]
    idle: tuple[Real, Real]


def strokes_of(asked: DwellTask, far: Real, turn: float) -> Strokes:
    """The strokes by the place (k,) of the far extreme; the dwell belongs to neither."""
    after, before = (np.broadcast_to(asked.dwell, np.shape(far)), far), (far, np.broadcast_to(turn, np.shape(far)))
    towards, away = (after, before) if asked.clockwise else (before, after)
    return Strokes(towards, away) if asked.working == "towards" else Strokes(away, towards)


def rated(turn: Turn, asked: DwellTask) -> Criteria:
    """The criteria of the linkages of a turn, extremes between two steps taken from parabolas."""
    state, phi = turn.state, turn.phi[:, None]
    step = turn.phi[1]
    with np.errstate(divide="ignore", invalid="ignore"):
        shift = -state.ds / state.dds
        near = np.isfinite(shift) & (np.abs(shift) <= step)
        s = np.where(near, state.s + state.ds * np.where(near, shift, 0) / 2, state.s)
    stroke = np.ptp(s, axis=0)
    far = turn.phi[np.argmax(np.abs(s), axis=0)]
    forces = unit_forces(turn.linkages, turn.linkages.phi0 + phi, state.theta, state.s)
    dwell = np.max(np.where(phi <= asked.dwell, np.abs(s), 0.0), axis=0)
    strokes = strokes_of(asked, far, float(turn.phi[-1]))

    def worst(window: tuple[Real, Real]) -> Real:
        inside: Flags = (phi >= window[0]) & (phi <= window[1])
        return np.asarray(sum(np.max(np.where(inside, force**2, 0.0), axis=0) for force in (forces.f3, forces.f4)))

    size = np.zeros_like(stroke) if turn.linkages.rocks else 1 / turn.linkages.crank
    tangent = np.max(np.abs(np.tan(forces.delta)), axis=0)
    return Criteria(dwell / stroke, size, tangent, worst(strokes.working), worst(strokes.idle))
