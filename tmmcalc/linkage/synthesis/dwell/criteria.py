"""Criteria of quality of many six-bars at once, on the steps of their turns: what the optimisation weighs.

f1 = max |S|/h over the dwell, h the stroke (swing); f2 = 1/l_OA of a slider; f3 = max tan|delta| over the turn;
f4 = max f3^2 + max f4^2 of the bar forces for unit resistance over the working stroke, f5 over the idle stroke.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tmmcalc.core.plane import Real
from tmmcalc.linkage.synthesis.dwell.linkages import Flags
from tmmcalc.linkage.synthesis.dwell.task import DwellTask
from tmmcalc.linkage.synthesis.dwell.turn import TURN, Turn
from tmmcalc.linkage.synthesis.dwell.unitforces import unit_forces

NAMES = ("f1", "f2", "f3", "f4", "f5")
Window = tuple[Real, Real]  # begin and end, turns of the crank from position 1 [rad]


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


class Traits(NamedTuple):
    """What the outputs of k linkages do, on the steps of their turns."""

    stroke: Real  # h in parts of l_OB, or swing [rad]
    far: Real  # turn of the crank from position 1 where the output is farthest from the dwell [rad]
    dwell: Real  # max |S| over the dwell
    criteria: Criteria

    def rows(self, which: Flags) -> Traits:
        """Those of some of the linkages."""
        criteria = Criteria(*(part[which] for part in self.criteria))
        return Traits(self.stroke[which], self.far[which], self.dwell[which], criteria)


class StrokeTurns(NamedTuple):
    """Turns of the crank from position 1, counter-clockwise [rad]: begin and end of both strokes."""

    working: Window
    idle: Window


def towards_and_away(asked: DwellTask, far: Real) -> tuple[Window, Window]:
    """The strokes towards the dwell and away from it by the place (k,) of the far extreme; the dwell is in neither."""
    after, before = (np.full_like(far, asked.dwell), far), (far, np.full_like(far, TURN))
    return (after, before) if asked.clockwise else (before, after)


def strokes_of(asked: DwellTask, far: Real) -> StrokeTurns:
    """The same two as the working and the idle stroke."""
    towards, away = towards_and_away(asked, far)
    return StrokeTurns(towards, away) if asked.working == "towards" else StrokeTurns(away, towards)


def achieved(asked: DwellTask, stroke: Real, dwell: Real, far: Real, length: Real) -> dict[str, tuple[Real, str]]:
    """What is checked by simulation, values (k,) with their unit; ``length`` makes SI of S."""
    name, unit = ("stroke h", "m") if asked.output == "slider" else ("swing", "rad")
    towards, away = (end - begin for begin, end in towards_and_away(asked, far))
    return {
        name: (length * stroke, unit),
        "dwell max |S|": (length * dwell, unit),
        "dwell max |S|/h": (dwell / stroke, "-"),
        "stroke towards the dwell": (towards, "rad"),
        "stroke away from the dwell": (away, "rad"),
    }


def rated(turn: Turn, asked: DwellTask) -> Traits:
    """Traits and criteria of the linkages of a turn, extremes between two steps taken from parabolas."""
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
    strokes = strokes_of(asked, far)

    def worst(window: Window) -> Real:
        inside: Flags = (phi >= window[0]) & (phi <= window[1])
        return np.asarray(sum(np.max(np.where(inside, force**2, 0.0), axis=0) for force in (forces.f3, forces.f4)))

    size = np.zeros_like(stroke) if turn.linkages.rocks else 1 / turn.linkages.crank
    tangent = np.max(np.abs(np.tan(forces.delta)), axis=0)
    criteria = Criteria(dwell / stroke, size, tangent, worst(strokes.working), worst(strokes.idle))
    return Traits(stroke, far, dwell, criteria)
